//! Random kernels: each step applies an operation to results of earlier steps.

use crate::expression::{Expr, Operation, Relation, Seam};
use crate::kernel::Program;
use crate::kernel::formula::Formulas;
use num_rational::Ratio;
use proptest::prelude::*;

/// An operation and the indices of the earlier results that it is applied to, counted back from the
/// last.
type Step = (u8, usize, usize);

/// Steps of a random kernel of three variables.
#[derive(Clone, Debug)]
pub(super) struct RandomFormulas {
    steps: Vec<Step>,
    outputs: usize,
}

/// Generates kernels of up to thirty operations and three outputs.
pub(super) fn formulas() -> impl Strategy<Value = RandomFormulas> {
    let step = (0u8..24, 0usize..8, 0usize..12);
    (prop::collection::vec(step, 1..30), 1usize..4)
        .prop_map(|(steps, outputs)| RandomFormulas { steps, outputs })
}

const EXPONENTS: [(i64, i64); 8] = [(2, 1), (3, 1), (-1, 1), (5, 1), (1, 2), (-3, 2), (1, 3), (-2, 1)];

impl RandomFormulas {
    fn build(&self) -> (Formulas, Vec<Expr>) {
        let mut formulas = Formulas::over("x y z");
        let mut results: Vec<Expr> =
            ["1", "2/3", "pi", "x", "y", "z"].map(|text| formulas.parse(text)).to_vec();
        for &(operation, left, right) in &self.steps {
            let back = |count: usize| results[results.len() - 1 - count % results.len()];
            let (a, b) = (back(left), back(right));
            let pool = &mut formulas.pool;
            let result = match operation {
                0..6 => pool.add(a, b),
                6..10 => pool.subtract(a, b),
                10..16 => pool.multiply(a, b),
                16..18 if !pool.is_zero(b) => pool.divide(a, b),
                18 => pool.negate(a),
                19..22 if pool.as_number(a).is_none() => {
                    let (numerator, denominator) = EXPONENTS[right % EXPONENTS.len()];
                    pool.power(a, Ratio::new(numerator, denominator))
                }
                22 => pool.apply(Operation::Sin, &[a]),
                _ => pool.select((a, Relation::Less, b), b, a, Seam::Agrees),
            };
            results.push(result);
        }
        let outputs = results.split_off(results.len() - self.outputs);
        (formulas, outputs)
    }

    /// Returns the kernel as lowered.
    pub(super) fn program(&self) -> Program {
        let (formulas, outputs) = self.build();
        formulas.program(&outputs)
    }

    /// Raises a kernel of the same variables and lowers it again.
    pub(super) fn raised(&self, program: &Program) -> Program {
        let (mut formulas, _) = self.build();
        let arguments = formulas.arguments.clone();
        let outputs = program.raise(&mut formulas.pool, &arguments).outputs;
        formulas.program(&outputs)
    }

    /// Returns the outputs in the language's notation.
    pub(super) fn text(&self) -> String {
        let (formulas, outputs) = self.build();
        formulas.pool.texts(&outputs).join("; ")
    }
}
