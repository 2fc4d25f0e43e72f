//! Workloads of the bench `symbolic` and of the example `scaling`. Each asserts its result, so that
//! the timed work is correct.

pub mod built;
mod patch;
mod random;
pub mod text;

/// Workload to be timed.
pub struct Work {
    /// Its name.
    pub name: String,
    /// Its target time, if one was set.
    pub goal: &'static str,
    /// Runs it once.
    pub run: Box<dyn FnMut()>,
}

impl Work {
    fn new(name: impl Into<String>, goal: &'static str, run: impl FnMut() + 'static) -> Self {
        Work { name: name.into(), goal, run: Box::new(run) }
    }
}

/// Returns every workload, in the order of the table.
pub fn all() -> Vec<Work> {
    let mut works: Vec<Work> = (3..=8).map(built::closed).collect();
    works.extend((3..=8).map(text::closed));
    works.push(built::derivative_twice(4));
    works.push(built::stereographic_pullback());
    works.extend((3..=6).map(built::power_of_two_form));
    works.push(built::product(15));
    works.extend([(3, 1), (3, 2), (4, 1), (4, 2)].map(|(n, k)| text::two_stars(n, k)));
    works.extend([
        text::spherical_laplacian(),
        text::lie_derivative(6),
        text::polynomial_pullback(),
        text::box_integral(),
        text::sphere_integral(),
        text::harmonicity(),
        text::harmonicity_of_arc_tangent(),
        text::triangle_gradient(),
    ]);
    works
}
