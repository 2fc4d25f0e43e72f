//! Removable singularities: points of a kernel's domain at which the computed form of the kernel
//! has no value, but has a limit.
//!
//! They are searched for in the usual places: one argument at 0, 1, −1 or an end of its range, or
//! equal to another argument from which it is subtracted, with the others anywhere. Findings are
//! reported to the kernel's author; the absence of findings proves nothing. Kernels with
//! quadratures are skipped.

use super::arguments::Arguments;
use super::edges::Edges;
use super::format::Format;
use super::ordinal::Width;
use super::regime::Regime;
use super::truth::{Truth, Value};
use crate::expression::{Expr, Node, Pool, Rational, Symbol};
use crate::kernel::{KernelSource, Program, lower};
use crate::random::SplitMix;
use crate::theory::Kernel;
use forms_math::{Real, Wide};

/// Number of points that have to agree.
const POINTS: usize = 3;

/// Number of candidates tried for these points.
const CANDIDATES: usize = 24;

/// Distances from the singularity at which values are compared, as powers of two.
const NEARNESS: [i32; 2] = [-60, -120];

/// Largest difference between agreeing values, relative to their size.
const AGREEMENT: f64 = 1e-12;

/// Returns the places in a kernel's declared domain where its computed form has a removable
/// singularity: `g = 0`, `a = b`.
pub fn removable_singularities(pool: &Pool, kernel: &Kernel) -> Vec<String> {
    let form = if kernel.computed.is_empty() { &kernel.outputs } else { &kernel.computed };
    let source = KernelSource {
        arguments: kernel.arguments.clone(),
        outputs: form.clone(),
        ..KernelSource::default()
    };
    let Ok(program) = lower(pool, &source) else { return Vec::new() };
    // an integral to hundreds of bits takes seconds, and hundreds of them would be needed
    let is_quadrature = |part: &Expr| matches!(pool.node(*part), Node::Jet { .. });
    if pool.reachable(form).iter().any(is_quadrature) {
        return Vec::new();
    }
    let edges = Edges::of(&mut pool.clone(), kernel);
    let points = points(&edges);
    let looking = Looking { pool, kernel, form, program, points };
    let mut found = Vec::new();
    for argument in 0..kernel.arguments.len() {
        for place in places(&edges, argument) {
            if looking.is_removable(argument, place) {
                found.push(looking.text(argument, place));
            }
        }
    }
    found
}

/// Returns typical arguments, inside or outside the domain.
fn points(edges: &Edges) -> Vec<Vec<f64>> {
    let mut arguments = Arguments { edges, width: Width::Single, random: SplitMix(0) };
    (0..CANDIDATES).filter_map(|_| arguments.next(Regime::Typical)).collect()
}

/// A value at which an argument is placed.
#[derive(Clone, Copy)]
enum Place {
    Number(f64),
    Argument(usize),
}

fn places(edges: &Edges, argument: usize) -> Vec<Place> {
    let (lower, upper) = edges.ranges[argument];
    let mut numbers: Vec<f64> = [0.0, 1.0, -1.0].into_iter().chain(lower).chain(upper).collect();
    numbers.sort_by(f64::total_cmp);
    numbers.dedup();
    let partners = edges.groups.iter().filter(|group| group.contains(&argument)).flatten();
    let partners = partners.filter(|&&other| other < argument).map(|&other| Place::Argument(other));
    numbers.into_iter().map(Place::Number).chain(partners).collect()
}

struct Looking<'a> {
    pool: &'a Pool,
    kernel: &'a Kernel,
    form: &'a [Expr],
    program: Program,
    points: Vec<Vec<f64>>,
}

impl Looking<'_> {
    /// Whether the form has no value at this place but the same limit from both sides, at several
    /// points.
    fn is_removable(&self, argument: usize, place: Place) -> bool {
        let mut agreeing = 0;
        for point in &self.points {
            let value = match place {
                Place::Number(value) => value,
                Place::Argument(other) => point[other],
            };
            let mut at = point.clone();
            at[argument] = value;
            // a finite value in floating point means that this place is no problem
            if self.program.interpret(&at).iter().all(|value| value.is_finite()) {
                return false;
            }
            match self.has_value(&at) {
                None => continue,
                Some(true) => return false,
                Some(false) => {}
            }
            if !self.limits_agree(&at, argument) {
                return false;
            }
            agreeing += 1;
            if agreeing == POINTS {
                break;
            }
        }
        agreeing > 0
    }

    /// Whether every output has a value; `None` outside the domain.
    fn has_value(&self, at: &[f64]) -> Option<bool> {
        let numbers: Option<Vec<Rational>> = at.iter().map(|&value| Rational::from_float(value)).collect();
        let point: Vec<(Symbol, Rational)> = self.kernel.arguments.iter().copied().zip(numbers?).collect();
        let domain = Truth::new(self.pool, &[], &self.kernel.domain);
        if domain.admits(&point) != Some(true) {
            return None;
        }
        let values = Truth::new(self.pool, self.form, &[]).at(&point, Format::Double);
        Some(!values.contains(&Value::Undefined))
    }

    /// Whether the values next to the place, at two distances on each existing side, are the same.
    fn limits_agree(&self, at: &[f64], argument: usize) -> bool {
        let interpreter = self.program.interpreter::<Wide<16>>();
        let beside = NEARNESS.iter().flat_map(|&nearness| [1.0, -1.0].map(|sign| sign * 2f64.powi(nearness)));
        let values: Vec<Vec<f64>> = beside
            .map(|step| {
                let mut arguments: Vec<Wide<16>> = at.iter().map(|&value| Wide::from_f64(value)).collect();
                arguments[argument] =
                    arguments[argument] + Wide::from_f64(step * at[argument].abs().max(1.0));
                interpreter.values(&arguments).into_iter().map(Real::to_f64).collect()
            })
            .collect();
        (0..self.form.len()).all(|output| {
            let known: Vec<f64> =
                values.iter().map(|value| value[output]).filter(|v| v.is_finite()).collect();
            let size = known.iter().fold(0.0_f64, |size, value| size.max(value.abs()));
            // at an end of the domain only one side exists
            known.len() >= NEARNESS.len() && known.iter().all(|v| (v - known[0]).abs() <= AGREEMENT * size)
        })
    }

    fn text(&self, argument: usize, place: Place) -> String {
        let name = |argument: usize| self.pool.symbol_name(self.kernel.arguments[argument]);
        match place {
            Place::Number(value) => format!("{} = {value}", name(argument)),
            Place::Argument(other) => format!("{} = {}", name(argument), name(other)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::read_theory;

    fn found(source: &str) -> Vec<String> {
        let (theory, errors) = read_theory(source);
        assert!(errors.is_empty(), "{errors:?}");
        removable_singularities(&theory.pool, &theory.kernels[0])
    }

    #[test]
    fn a_removable_singularity_in_the_domain_is_named() {
        assert_eq!(found("kernel k(s, t) = (1 - exp(-s*t))/s where s >= 0, t > 0;"), ["s = 0"]);
        assert_eq!(found("kernel k(a, b) = (exp(a) - exp(b))/(a - b) where a > 0, b > 0;"), ["b = a"]);
        assert_eq!(found("kernel k(n) = log(n)/(n - 1) where n > 0;"), ["n = 1"]);
    }

    #[test]
    fn what_is_outside_the_domain_filled_in_or_a_pole_is_not() {
        for source in [
            "kernel k(s, t) = (1 - exp(-s*t))/s where s > 0, t > 0;",
            "kernel k(x) = 1/x;",
            "kernel k(x) = 1/x**2;",
            "kernel k(x) = if x != 0 { sin(x)/x } else { 1 };",
            "kernel k(x) = x**2 + 1;",
            "kernel k(x) = (x**2 - 1)/(x - 1) by x + 1;",
        ] {
            assert!(found(source).is_empty(), "{source}: {:?}", found(source));
        }
    }
}
