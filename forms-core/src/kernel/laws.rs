//! Invariant of every pass, as a function of the pass: the kernel's value stays the same.
//!
//! It is tested exactly, in a finite field, on hand-written and on random kernels; deliberately
//! wrong passes have to violate it.

mod modular;
mod random;

use super::expand::{Limits, expand};
use super::factor::{Order, factor};
use super::formula::program;
use super::fuse::fuse;
use super::graph::Graph;
use super::graph::collect::collect;
use super::linearise::linearise;
use super::numbering::number_values;
use super::products::share_products;
use super::program::{Instruction, ProductSum, Program};
use super::quotients::share_reciprocals;
use super::schedule::schedule;
use super::signs::absorb_signs;
use super::sums::share_sums;
use modular::{PRIME, modular_values};
use proptest::prelude::*;

/// Number of points at which two kernels are compared.
const POINTS: usize = 4;
/// Number of points that are tried to find [`POINTS`] at which the kernel is defined.
const TRIED: u64 = 200;

/// A pass over programs.
type Pass = Box<dyn Fn(&Program) -> Program>;

/// A change to one instruction, if it applies.
type Fault = fn(&Instruction) -> Option<Instruction>;

/// Whether the pass preserves the value of the kernel wherever the kernel has one.
fn keeps_the_value(pass: &dyn Fn(&Program) -> Program, program: &Program) -> bool {
    let changed = pass(program);
    let point = |seed: u64| -> Vec<u64> {
        (0..program.arguments.len() as u64).map(|place| scattered(seed * 31 + place)).collect()
    };
    (0..TRIED)
        .map(point)
        .filter_map(|point| Some((modular_values(program, &point)?, point)))
        .take(POINTS)
        .all(|(expected, point)| modular_values(&changed, &point) == Some(expected))
}

fn scattered(seed: u64) -> u64 {
    let mut bits = seed.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    (bits ^ (bits >> 27)) % PRIME
}

/// Turns a pass over sums and products into a pass over programs.
fn on_graph(pass: impl Fn(&Graph) -> Graph + 'static) -> Pass {
    Box::new(move |program| linearise(&pass(&collect(program)), program))
}

/// Returns every pass alone and all of them together.
fn passes() -> Vec<(&'static str, Pass)> {
    let limits = Limits { product: 12, sum: 40, shared: 40 };
    vec![
        ("number_values", Box::new(number_values)),
        ("collect, linearise", on_graph(Graph::clone)),
        ("expand", on_graph(move |graph| expand(graph, limits))),
        ("factor, first", on_graph(|graph| factor(graph, Order::First))),
        ("factor, last", on_graph(|graph| factor(graph, Order::Last))),
        ("expand, factor", on_graph(move |graph| factor(&expand(graph, limits), Order::First))),
        ("share_sums", on_graph(share_sums)),
        ("expand, share_sums", on_graph(move |graph| share_sums(&expand(graph, limits)))),
        ("share_reciprocals", on_graph(share_reciprocals)),
        ("share_products", on_graph(share_products)),
        ("absorb_signs", Box::new(|program| absorb_signs(&number_values(program)))),
        ("fuse", Box::new(|program| fuse(&number_values(program)))),
        ("fuse, unfused", Box::new(|program| fuse(&number_values(program)).unfused())),
        ("compensate", Box::new(|program| number_values(program).compensate())),
        ("schedule", Box::new(schedule)),
        ("optimise", Box::new(Program::optimise)),
        ("optimise, twice", Box::new(|program| program.optimise().optimise())),
    ]
}

/// Kernels to which every pass applies: variables, outputs.
const WRITTEN: &[(&str, &[&str])] = &[
    ("x y z", &["x/sqrt(x**2+y**2+z**2)**3", "y/sqrt(x**2+y**2+z**2)", "z/(x**2+y**2+z**2)"]),
    ("u v a b", &["(1-u)*(1-v)*a + u*(1-v)*b - (a-b)*u*v", "b - a", "a - b - u + v"]),
    ("x y", &["x/x - y/x/y", "x**3/x**5", "x**-2*x", "(x*y)**4/(x*y)**2"]),
    ("x", &["x**(1/3) + x**(2/3) - x**(-5/6)", "sqrt(sqrt(x))*x**(3/4)", "x**7 - 2*x**15"]),
    ("x y", &["-(2*pi*x - 2*pi*y)", "pi**2*(x+y)/pi", "-(x*(y - x))", "-3*x", "1/3*x + y/6"]),
    ("x y", &["sin(x-y) + sin(y-x)", "if x < y { x*y } else { -(x*y) } - x*y", "-atan2(-x, y)"]),
    ("a b c d", &["a/d + b/d - c", "a*b*c + a*b*d", "a*c + b*c", "1/(a*b) + 1/(a*b*c) + d/(a*b)"]),
    ("x y", &["(x+y)**2 - (x-y)**2", "(2*x+2*y)**(1/2)", "2*x + 2*y + x*y", "x**2*y**2"]),
];

/// Fails at the first pass that changes one of these kernels: variables, outputs.
fn every_pass_keeps_the_values_of(kernels: &[(&str, &[&str])]) {
    for (name, pass) in passes() {
        for (variables, outputs) in kernels {
            assert!(keeps_the_value(&pass, &program(variables, outputs)), "{name} changes {outputs:?}");
        }
    }
}

#[test]
fn every_pass_keeps_the_value_of_every_written_kernel() {
    every_pass_keeps_the_values_of(WRITTEN);
}

#[test]
fn a_factor_that_a_product_has_twice_is_shared_once() {
    // √p √p is the factor p = x y, and so is the common pair x y; x⁸¹⁹² is twice the highest power
    let kernels: [(&str, &[&str]); 3] = [
        ("x y z", &["sqrt(x*y)*z*sqrt(x*y)*x*y"]),
        ("x y z", &["1/(sqrt(x*y)*z*sqrt(x*y)*x*y)"]),
        ("x y z w", &["x**4096*x**4096*y", "x**4096*x**4096*z", "x**4096*w"]),
    ];
    every_pass_keeps_the_values_of(&kernels);
}

#[test]
fn a_term_that_a_sum_has_twice_is_shared_once() {
    // √s √s is the term s = x + y, and so is the common pair x + y
    let kernels: [(&str, &[&str]); 2] = [
        ("x y", &["sqrt(x + y)*(sqrt(x + y) + 1) + x + y"]),
        (
            "x y z w",
            &[
                "sqrt(x + y)*(sqrt(x + y) + z) + x + y",
                "sqrt(x + y)*(sqrt(x + y) + w) + x + y",
                "sqrt(x + y)*(sqrt(x + y) + z*w)",
            ],
        ),
    ];
    every_pass_keeps_the_values_of(&kernels);
}

#[test]
fn every_written_kernel_has_a_value_to_keep() {
    for (variables, outputs) in WRITTEN {
        let program = program(variables, outputs);
        let wrong = |program: &Program| {
            let last = program.outputs[0];
            let mut changed = program.clone();
            changed.instructions.push(Instruction::Add(last, last));
            changed.outputs[0] = super::Value(changed.instructions.len() as u32 - 1);
            changed
        };
        assert!(!keeps_the_value(&wrong, &program), "{outputs:?} is nowhere defined");
    }
}

/// Returns the optimised program, with products compensated.
fn finished(program: &Program) -> Program {
    program.optimise().compensate()
}

/// Returns the finished program, in which the first instruction that `change` applies to is
/// changed.
fn mutated(program: &Program, change: Fault) -> Program {
    let mut mutant = finished(program);
    if let Some((place, changed)) =
        mutant.instructions.iter().enumerate().find_map(|(place, i)| Some((place, change(i)?)))
    {
        mutant.instructions[place] = changed;
    }
    mutant
}

#[test]
fn a_wrong_pass_breaks_the_law() {
    use Instruction::{
        Add, DifferenceOfProducts, Divide, Multiply, MultiplyAdd, Sqrt, Subtract, SumOfProducts,
    };
    let wrong: [(&str, Fault); 9] = [
        ("drops a sign", |i| if let Subtract(a, b) = i { Some(Add(*a, *b)) } else { None }),
        ("swaps a difference", |i| if let Subtract(a, b) = i { Some(Subtract(*b, *a)) } else { None }),
        ("swaps a quotient", |i| if let Divide(a, b) = i { Some(Divide(*b, *a)) } else { None }),
        ("multiplies for adding", |i| if let Add(a, b) = i { Some(Multiply(*a, *b)) } else { None }),
        ("squares for multiplying", |i| match i {
            Multiply(a, b) if a != b => Some(Multiply(*a, *a)),
            _ => None,
        }),
        ("turns a fused difference", |i| match i {
            MultiplyAdd(ProductSum::MinusProduct, values) => {
                Some(MultiplyAdd(ProductSum::ProductMinus, *values))
            }
            _ => None,
        }),
        ("adds a fused difference", |i| match i {
            MultiplyAdd(ProductSum::MinusProduct, values) => {
                Some(MultiplyAdd(ProductSum::PlusProduct, *values))
            }
            _ => None,
        }),
        ("adds compensated products", |i| match i {
            DifferenceOfProducts(factors) => Some(SumOfProducts(*factors)),
            _ => None,
        }),
        ("drops a root", |i| if let Sqrt(a) = i { Some(Add(*a, *a)) } else { None }),
    ];
    let program = program("x y z", &["(x - y*z)/(sqrt(x + y)*z)", "(x - y)*z", "x*y - sin(z)*z"]);
    assert!(keeps_the_value(&finished, &program));
    for (fault, change) in wrong {
        assert_ne!(mutated(&program, change), finished(&program), "{fault}: nothing to change");
        assert!(!keeps_the_value(&|program| mutated(program, change), &program), "{fault} unseen");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    #[test]
    fn every_pass_keeps_the_value_of_random_kernels(formulas in random::formulas()) {
        let program = formulas.program();
        for (name, pass) in passes() {
            prop_assert!(keeps_the_value(&pass, &program), "{name} changes {}", formulas.text());
        }
    }

    #[test]
    fn raising_what_was_lowered_gives_the_same_value(formulas in random::formulas()) {
        let program = formulas.program();
        let raised = |program: &Program| formulas.raised(&program.optimise());
        prop_assert!(keeps_the_value(&raised, &program), "{}", formulas.text());
    }
}
