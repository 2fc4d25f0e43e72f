//! The counted work: one call of the batch of every kernel of the library, and of the functions
//! that the bench compares.

use super::callgrind;
use crate::catalogue::{self, Author};
use crate::inputs;
use forms_competitors::expert::batch::InstructionSet;
use forms_kernels as kernels;

/// Number of values of a call: some blocks of a batch.
const VALUES: usize = 512;

/// Function that fills the outputs with the values at these columns.
type FillAll = dyn Fn(&[&[f64]], &mut [&mut [f64]]);

/// Function over columns, and its columns.
pub(crate) struct Work {
    pub(crate) name: String,
    columns: Vec<Vec<f64>>,
    outputs: usize,
    fill: Box<FillAll>,
}

impl Work {
    /// Calls the function twice, and counts the second call, so that one-time initialisation is
    /// excluded.
    pub(crate) fn run(&self) {
        let columns: Vec<&[f64]> = self.columns.iter().map(Vec::as_slice).collect();
        let mut outputs = vec![vec![0.0; VALUES]; self.outputs];
        let mut outputs: Vec<&mut [f64]> = outputs.iter_mut().map(Vec::as_mut_slice).collect();
        (self.fill)(&columns, &mut outputs);
        callgrind::call(&mut || (self.fill)(&columns, &mut outputs));
    }
}

/// Returns all work, in a fixed order.
pub(crate) fn all() -> Vec<Work> {
    // Callgrind emulates no instruction set beyond AVX2.
    let set = InstructionSet::detected();
    let compared = catalogue::all(set).into_iter().flat_map(|entry| {
        entry.functions.into_iter().filter_map(move |(author, fill)| {
            let whose = match author {
                Author::Generated => "generated",
                Author::Expert => "expert",
                _ => return None,
            };
            Some(Work {
                name: format!("{} ({whose})", entry.name.replace(',', "")),
                columns: inputs::columns(entry.domain, VALUES),
                outputs: 1,
                fill: Box::new(move |columns, outputs| fill(columns, outputs[0])),
            })
        })
    });
    compared.chain(library()).collect()
}

/// Returns arguments that increase from one to the next, all between 0 and 1: in the domain of
/// every kernel counted here.
fn growing(arguments: usize) -> Vec<Vec<f64>> {
    let step = 0.8 / arguments as f64;
    let value = |argument: usize, row: usize| step * (argument as f64 + row as f64 / VALUES as f64) + 0.1;
    (0..arguments).map(|argument| (0..VALUES).map(|row| value(argument, row)).collect()).collect()
}

/// Lists batches of the library with one output, or with several.
macro_rules! library {
    ([$($name:ident($($argument:ident)*);)*] [$($several:ident($($of_several:ident)*) $outputs:literal;)*]) => {
        vec![
            $(Work {
                name: stringify!($name).to_string(),
                columns: growing([$(stringify!($argument)),*].len()),
                outputs: 1,
                fill: Box::new(|columns, outputs| {
                    let [$($argument),*] = std::array::from_fn(|column| columns[column]);
                    kernels::$name::batch($($argument,)* outputs[0]).expect("the columns have one length");
                }),
            },)*
            $(Work {
                name: stringify!($several).to_string(),
                columns: growing([$(stringify!($of_several)),*].len()),
                outputs: $outputs,
                fill: Box::new(|columns, outputs| {
                    let [$($of_several),*] = std::array::from_fn(|column| columns[column]);
                    let outputs: &mut [&mut [f64]; $outputs] = outputs.try_into().expect("that many outputs");
                    kernels::$several::batch($($of_several,)* outputs.each_mut().map(|output| &mut **output))
                        .expect("the columns have one length");
                }),
            },)*
        ]
    };
}

fn library() -> Vec<Work> {
    library! {
        [
            basic_radiance(radiance n1 n2);
            edge_form_factor(ax ay az bx by bz nx ny nz);
            emission_integral(sigma t);
            fresnel_dielectric(n cos_i);
            half_vector_jacobian(cos_oh);
            henyey_greenstein(g cos_theta);
            henyey_greenstein_sample(g u);
            irradiance(form_factor radiance);
            measure_area_to_solid_angle(r2 cos_theta);
            optical_depth_exponential(z0 z1 height s0);
            reconnection_jacobian(r2_old cos_old r2_new cos_new);
            solid_angle_density_patch(px py pz qx qy qz rx ry rz sx sy sz u v);
            solid_angle_density_plane(u v);
            transmittance(sigma t);
            uniform_sphere_pdf(x y z);
            cosine_hemisphere_pdf(x y z);
        ]
        [
            uniform_sphere_sample(u v) 3;
            cosine_hemisphere_sample(u v) 3;
            uniform_triangle_sample(u v) 2;
        ]
    }
}
