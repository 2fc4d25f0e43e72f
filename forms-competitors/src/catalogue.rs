//! The kernels of this bench, each with the functions that are compared.

use crate::expert;
use crate::expert::batch::InstructionSet;
use crate::generated;
use crate::inputs::Domain;
#[cfg(has_sympy)]
use crate::other_generators::by_sympy;
#[cfg(has_wrenfold)]
use crate::other_generators::by_wrenfold;
use std::hint::black_box;

/// Author of a function, and the form of its arguments.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Author {
    /// This project's generator, over columns.
    Generated,
    /// This project's generator, one value at a time.
    GeneratedScalar,
    /// By hand, over columns.
    Expert,
    /// By hand, over columns, with the instructions that every processor has.
    ExpertBaseline,
    /// wrenfold's optimiser and generator, one value at a time.
    Wrenfold,
    /// SymPy's common subexpressions and printer, one value at a time.
    SymPy,
}

impl Author {
    /// All authors, in the order of the table.
    pub const ALL: [Self; 6] = [
        Self::Generated,
        Self::Expert,
        Self::GeneratedScalar,
        Self::ExpertBaseline,
        Self::Wrenfold,
        Self::SymPy,
    ];

    /// Returns the header of its column.
    pub fn name(self) -> &'static str {
        match self {
            Self::Generated => "generated, batch",
            Self::GeneratedScalar => "generated, scalar",
            Self::Expert => "expert, batch",
            Self::ExpertBaseline => "expert, baseline",
            Self::Wrenfold => "wrenfold, scalar",
            Self::SymPy => "SymPy, scalar",
        }
    }
}

/// Function that fills the last slice with the values at these columns.
pub type Fill = Box<dyn Fn(&[&[f64]], &mut [f64])>;

/// Kernel with its functions.
pub struct Entry {
    /// Name of the kernel.
    pub name: &'static str,
    /// Arguments at which it is compared.
    pub domain: Domain,
    /// Its functions, each with its author.
    pub functions: Vec<(Author, Fill)>,
}

/// Returns the columns as an array.
fn array<'a, const N: usize>(columns: &[&'a [f64]]) -> [&'a [f64]; N] {
    std::array::from_fn(|i| columns[i])
}

/// Wraps a function over columns.
fn batch<const N: usize>(function: impl Fn(&[&[f64]; N], &mut [f64]) + 'static) -> Fill {
    Box::new(move |columns, out| function(&array(columns), out))
}

/// Wraps a function of one value with these arguments, in a loop that the compiler cannot
/// vectorise.
macro_rules! scalar {
    ($function:path, $($argument:ident)*) => {
        Box::new(|columns: &[&[f64]], out: &mut [f64]| {
            let [$($argument),*] = array(columns).map(|column: &[f64]| &column[..out.len()]);
            for i in 0..out.len() {
                out[i] = black_box($function($($argument[i]),*));
            }
        })
    };
}

/// Lists the functions of that name with these arguments that generators emit. The code of other
/// generators is there if `generate.py` has written it.
macro_rules! emitted {
    ($name:ident, $($argument:ident)*) => {
        vec![
            (Author::Generated, Box::new(|columns: &[&[f64]], out: &mut [f64]| {
                let [$($argument),*] = array(columns);
                generated::$name::batch($($argument,)* out).expect("the columns have one length");
            }) as Fill),
            (Author::GeneratedScalar, scalar!(generated::$name, $($argument)*) as Fill),
            #[cfg(has_sympy)]
            (Author::SymPy, scalar!(by_sympy::$name, $($argument)*) as Fill),
            #[cfg(has_wrenfold)]
            (Author::Wrenfold, scalar!(by_wrenfold::$name, $($argument)*) as Fill),
        ]
    };
}

/// Lists the functions of an expert's module, with that instruction set.
macro_rules! by_hand {
    ($set:ident, $($module:ident)::*) => {
        [
            (Author::Expert, batch(move |columns, out| expert::$($module)::*::with($set, columns, out))),
            (Author::ExpertBaseline, batch(|columns, out| expert::$($module)::*::with(InstructionSet::Baseline, columns, out))),
        ]
    };
}

fn entry(name: &'static str, domain: Domain, functions: impl IntoIterator<Item = (Author, Fill)>) -> Entry {
    Entry { name, domain, functions: functions.into_iter().collect() }
}

/// Returns every kernel; the hand-written functions over columns use that instruction set.
pub fn all(set: InstructionSet) -> Vec<Entry> {
    let entries =
        [patch, triangle, rectangle, rectangle_above, phase, phase_sample, microfacets, medium, two_points];
    entries.iter().map(|entry| entry(set)).collect()
}

fn patch(set: InstructionSet) -> Entry {
    let functions = emitted!(solid_angle_density_patch, u v ax ay az bx by bz cx cy cz dx dy dz);
    let by_hand = expert::patch(set).map(|function| (Author::Expert, batch(function)));
    entry("solid_angle_density_patch", Domain::Patch, by_hand.into_iter().chain(functions))
}

fn triangle(set: InstructionSet) -> Entry {
    let functions = emitted!(solid_angle_triangle, px py pz ax ay az bx by bz cx cy cz);
    entry(
        "solid_angle_triangle",
        Domain::Triangle,
        by_hand!(set, solid_angle_triangle::triangle).into_iter().chain(functions),
    )
}

fn rectangle(set: InstructionSet) -> Entry {
    let functions = emitted!(form_factor_point_rectangle, px py pz nx ny nz ox oy oz ux uy uz vx vy vz);
    let by_hand = by_hand!(set, form_factor_point_rectangle::rectangle);
    entry("form_factor_point_rectangle", Domain::Rectangle, by_hand.into_iter().chain(functions))
}

fn rectangle_above(set: InstructionSet) -> Entry {
    let by_hand = by_hand!(set, form_factor_point_rectangle::unclipped);
    entry("form_factor_point_rectangle, above the horizon", Domain::RectangleAbove, by_hand)
}

fn phase(set: InstructionSet) -> Entry {
    let functions = emitted!(henyey_greenstein, g cos_theta);
    entry(
        "henyey_greenstein",
        Domain::Phase,
        by_hand!(set, henyey_greenstein::pdf).into_iter().chain(functions),
    )
}

fn phase_sample(set: InstructionSet) -> Entry {
    let functions = emitted!(henyey_greenstein_sample, g u);
    let by_hand = by_hand!(set, henyey_greenstein::sample);
    entry("henyey_greenstein_sample", Domain::PhaseSample, by_hand.into_iter().chain(functions))
}

fn microfacets(set: InstructionSet) -> Entry {
    let functions = emitted!(ggx_visible_pdf, alpha wx wy wz x y z);
    entry(
        "ggx_visible_pdf",
        Domain::Microfacets,
        by_hand!(set, ggx_visible_pdf::pdf).into_iter().chain(functions),
    )
}

fn medium(set: InstructionSet) -> Entry {
    let functions = emitted!(transmittance_with_emission, radiance sigma t emission);
    let by_hand = by_hand!(set, transmittance_with_emission::radiance);
    entry("transmittance_with_emission", Domain::Medium, by_hand.into_iter().chain(functions))
}

fn two_points(set: InstructionSet) -> Entry {
    let functions = emitted!(form_factor_integrand, x0 x1 x2 n0 n1 n2 y0 y1 y2 m0 m1 m2);
    entry(
        "form_factor_integrand",
        Domain::TwoPoints,
        by_hand!(set, double_area::integrand).into_iter().chain(functions),
    )
}
