//! Error bound on one box: ranges forward, sensitivities backward, their weighted sum.

use super::arithmetic::Arithmetic;
use super::interval::Interval;
use crate::expression::{Operation, Pool, SymbolKind};
use crate::kernel::{Instruction, KernelSource, Program, Value, lower};
use forms_math::Guardable;
use rustc_hash::FxHashMap;

/// Program with the partial derivatives of the functions it calls.
///
/// What no box changes is computed once. A number is an exact quotient times a power of π: rounding
/// it takes longer than all other work on a box.
pub(super) struct Analysis<'a> {
    program: &'a Program,
    arithmetic: Arithmetic,
    numbers: Numbers,
    /// Relative and absolute perturbation of each instruction's value.
    roundings: Vec<(f64, f64)>,
    partials: FxHashMap<Operation, (Program, Numbers)>,
}

/// Ranges of the numbers of a program, by their places; `None` at all other instructions.
type Numbers = Vec<Option<Interval>>;

/// Error bounds of one output on a box.
#[derive(Clone, Copy, Debug)]
pub(super) struct OutputError {
    pub(super) absolute: f64,
    pub(super) relative: f64,
}

/// Error bounds of all outputs on a box, and the influence of each argument.
pub(super) struct BoxError {
    pub(super) outputs: Vec<OutputError>,
    /// Bound on the change of any output along the box's edge of each argument.
    pub(super) influence: Vec<f64>,
}

impl<'a> Analysis<'a> {
    pub(super) fn new(program: &'a Program, arithmetic: Arithmetic) -> Self {
        let mut partials = FxHashMap::default();
        for instruction in program.instructions() {
            if let Instruction::Call(operation, _) = instruction {
                partials.entry(*operation).or_insert_with(|| {
                    let partials = partials_of(*operation);
                    let numbers = numbers(&partials);
                    (partials, numbers)
                });
            }
        }
        let places = 0..program.instructions().len();
        let roundings = places.map(|place| arithmetic.rounding(program, place)).collect();
        Analysis { program, numbers: numbers(program), roundings, arithmetic, partials }
    }

    /// Bounds the errors on a box; `None` if no point of the box is in the kernel's domain.
    pub(super) fn error(&self, arguments: &[Interval]) -> Option<BoxError> {
        let rounding = |place: usize| self.roundings[place];
        let ranges = ranges(self.program, &self.numbers, arguments, self.arithmetic.largest, rounding);
        let of = |value: Value| ranges[value.place()];
        let fails = |condition: &crate::kernel::Comparison| {
            of(condition.left).decide(condition.relation, of(condition.right)) == Some(false)
        };
        if self.program.domain().iter().any(fails) {
            return None;
        }
        let mut influence = vec![0.0_f64; arguments.len()];
        let outputs = self.program.outputs().iter().map(|&output| {
            let sensitivities = self.sensitivities(output, &ranges);
            for (instruction, sensitivity) in self.program.instructions().iter().zip(&sensitivities) {
                if let (Instruction::Argument(place), Some(sensitivity)) = (instruction, sensitivity) {
                    let range = arguments[*place as usize];
                    let change = sensitivity.magnitude() * (range.upper - range.lower);
                    let known = &mut influence[*place as usize];
                    *known = if change.is_nan() { f64::INFINITY } else { known.max(change) };
                }
            }
            self.output_error(output, &sensitivities, &ranges)
        });
        Some(BoxError { outputs: outputs.collect(), influence })
    }

    /// Returns the absolute bound Σ |∂output/∂vᵢ| (|vᵢ| εᵢ + ηᵢ) and the relative bound
    /// Σ |κᵢ| εᵢ + Σ |∂output/∂vᵢ| ηᵢ/|output|.
    fn output_error(
        &self,
        output: Value,
        sensitivities: &[Option<Interval>],
        ranges: &[Interval],
    ) -> OutputError {
        let conditions = self.condition_numbers(output, ranges);
        let range = ranges[output.place()];
        let [mut rounded, mut underflown, mut relative] = [0.0_f64; 3];
        for place in 0..ranges.len() {
            // what is not on the branch that is taken has no influence, however large it is
            if sensitivities[place].is_none() && conditions[place].is_none() {
                continue;
            }
            let (rounding, underflow) = self.roundings[place];
            let sensitivity = sensitivities[place].map_or(0.0, Interval::magnitude);
            let condition = conditions[place].map_or(0.0, Interval::magnitude);
            if rounding > 0.0 {
                let change = (ranges[place].magnitude() * rounding).next_up();
                rounded = sum_upward(rounded, product_upward(sensitivity, change));
                relative = sum_upward(relative, product_upward(condition, rounding));
            }
            let absolute = sum_upward(underflow, self.reduction(place, ranges));
            underflown = sum_upward(underflown, product_upward(sensitivity, absolute));
        }
        let absolute = sum_upward(rounded, underflown);
        let absolute = if range.is_finite() { absolute } else { f64::INFINITY };
        let by_condition = sum_upward(relative, quotient_upward(underflown, range.least_magnitude()));
        let by_size = quotient_upward(absolute, range.least_magnitude());
        OutputError { absolute, relative: by_condition.min(by_size) }
    }

    /// Returns the absolute error of a sine or cosine from the reduction of a large angle. The range
    /// of a tangent is unbounded there.
    fn reduction(&self, place: usize, ranges: &[Interval]) -> f64 {
        match &self.program.instructions()[place] {
            Instruction::Call(Operation::Sin | Operation::Cos, operands) => {
                ranges[operands[0].place()].magnitude().min(f64::MAX).reduction()
            }
            _ => 0.0,
        }
    }

    /// Returns the condition numbers κᵢ = (vᵢ/output) ∂output/∂vᵢ, the amplification of a relative
    /// change of vᵢ. Products pass a relative change on unchanged, so that the bound for them does
    /// not depend on the width of the box.
    fn condition_numbers(&self, output: Value, ranges: &[Interval]) -> Vec<Option<Interval>> {
        backward(output, ranges.len(), |place| self.amplifications(place, ranges))
    }

    /// Returns the amplification (a/v) ∂v/∂a of an instruction's value v by each operand a.
    fn amplifications(&self, place: usize, ranges: &[Interval]) -> Vec<(Value, Interval)> {
        let of = |value: Value| ranges[value.place()];
        let one = Interval::point(1.0);
        match &self.program.instructions()[place] {
            Instruction::Multiply(a, b) => vec![(*a, one), (*b, one)],
            Instruction::Divide(a, b) => vec![(*a, one), (*b, one.negate())],
            Instruction::Negate(a) => vec![(*a, one)],
            Instruction::Sqrt(a) => vec![(*a, Interval::point(0.5))],
            Instruction::Power(a, exponent) => vec![(*a, quotient(*exponent.numer(), *exponent.denom()))],
            Instruction::Add(a, b) => vec![(*a, of(*a).share(of(*b))), (*b, of(*b).share(of(*a)))],
            // the derivatives, 0 or 1, are also the shares
            Instruction::Select { left, right, .. } if self.is_exact(*left) && self.is_exact(*right) => {
                self.derivatives(place, ranges)
            }
            Instruction::Subtract(a, b) => {
                let (a_range, b_range) = (of(*a), of(*b).negate());
                vec![(*a, a_range.share(b_range)), (*b, b_range.share(a_range))]
            }
            _ => {
                let derivatives = self.derivatives(place, ranges).into_iter();
                derivatives.map(|(a, by)| (a, by.multiply(of(a)).divide(ranges[place]))).collect()
            }
        }
    }

    /// Whether a value is computed without rounding from arguments and numbers.
    fn is_exact(&self, value: Value) -> bool {
        match &self.program.instructions()[value.place()] {
            Instruction::Argument(_) | Instruction::Constant(_) => {
                self.roundings[value.place()] == (0.0, 0.0)
            }
            Instruction::Negate(operand) => self.is_exact(*operand),
            Instruction::Call(Operation::Abs, operands) => self.is_exact(operands[0]),
            _ => false,
        }
    }

    /// Returns the derivatives of a value that is one of two others.
    fn either(&self, one: Value, other: Value) -> Vec<(Value, Interval)> {
        let share = Interval { lower: 0.0, upper: 1.0 };
        vec![(one, share), (other, share)]
    }

    /// Returns the range of ∂output/∂vᵢ for each instruction's value; `None` where the output does
    /// not depend on it.
    fn sensitivities(&self, output: Value, ranges: &[Interval]) -> Vec<Option<Interval>> {
        backward(output, ranges.len(), |place| self.derivatives(place, ranges))
    }

    /// Returns the partial derivatives of an instruction by its operands.
    fn derivatives(&self, place: usize, ranges: &[Interval]) -> Vec<(Value, Interval)> {
        let of = |value: Value| ranges[value.place()];
        let (one, here) = (Interval::point(1.0), ranges[place]);
        match &self.program.instructions()[place] {
            Instruction::Constant(_) | Instruction::Argument(_) => vec![],
            Instruction::Add(a, b) => vec![(*a, one), (*b, one)],
            Instruction::Subtract(a, b) => vec![(*a, one), (*b, one.negate())],
            Instruction::Multiply(a, b) => vec![(*a, of(*b)), (*b, of(*a))],
            Instruction::Divide(a, b) => {
                let reciprocal = of(*b).reciprocal();
                vec![(*a, reciprocal), (*b, here.multiply(reciprocal).negate())]
            }
            Instruction::MultiplyAdd(..) => unreachable!("roundings were separated"),
            Instruction::DifferenceOfProducts([a, b, c, d]) => {
                vec![(*a, of(*b)), (*b, of(*a)), (*c, of(*d).negate()), (*d, of(*c).negate())]
            }
            Instruction::SumOfProducts([a, b, c, d]) => {
                vec![(*a, of(*b)), (*b, of(*a)), (*c, of(*d)), (*d, of(*c))]
            }
            Instruction::Negate(a) => vec![(*a, one.negate())],
            Instruction::Sqrt(a) => vec![(*a, Interval::point(0.5).divide(here))],
            // (xʳ)′ = r xʳ⁻¹
            Instruction::Power(a, exponent) => {
                let (p, q) = (*exponent.numer(), *exponent.denom());
                vec![(*a, quotient(p, q).multiply(of(*a).power(p - q, q)))]
            }
            Instruction::Call(operation, operands) => {
                let arguments: Vec<Interval> = operands.iter().map(|&operand| of(operand)).collect();
                let (program, numbers) = &self.partials[operation];
                let values = ranges_of_exact(program, numbers, &arguments);
                let derivatives = program.outputs().iter().map(|output| values[output.place()]);
                operands.iter().copied().zip(derivatives).collect()
            }
            Instruction::Quadrature { operands, .. } => {
                operands.iter().map(|&operand| (operand, Interval::EVERYTHING)).collect()
            }
            Instruction::Select { left, relation, right, then, otherwise } => {
                match of(*left).decide(*relation, of(*right)) {
                    Some(true) => vec![(*then, one)],
                    Some(false) => vec![(*otherwise, one)],
                    // the branch is the one of exact arithmetic, whichever it is
                    None if self.is_exact(*left) && self.is_exact(*right) => self.either(*then, *otherwise),
                    None => vec![(*left, Interval::EVERYTHING)],
                }
            }
        }
    }
}

/// Accumulates factors in reverse mode: for each value, the sum over all paths from the output of
/// the products of the factors.
fn backward(
    output: Value,
    length: usize,
    factors: impl Fn(usize) -> Vec<(Value, Interval)>,
) -> Vec<Option<Interval>> {
    let mut known: Vec<Option<Interval>> = vec![None; length];
    known[output.place()] = Some(Interval::point(1.0));
    for place in (0..=output.place()).rev() {
        let Some(outer) = known[place] else { continue };
        for (operand, factor) in factors(place) {
            let part = outer.multiply(factor);
            let known = &mut known[operand.place()];
            *known = Some(known.map_or(part, |sum| sum.add(part)));
        }
    }
    known
}

/// Returns an interval that contains p/q.
fn quotient(p: i64, q: i64) -> Interval {
    Interval::point(p as f64).divide(Interval::point(q as f64))
}

fn sum_upward(a: f64, b: f64) -> f64 {
    (a + b).next_up()
}

/// Returns an upper bound of a product of bounds; infinite where one is 0 and the other infinite.
fn product_upward(a: f64, b: f64) -> f64 {
    let product = (a * b).next_up();
    if product.is_nan() { f64::INFINITY } else { product }
}

fn quotient_upward(a: f64, b: f64) -> f64 {
    let quotient = (a / b).next_up();
    if quotient.is_nan() { f64::INFINITY } else { quotient }
}

/// Returns the partial derivatives of a function, as stated in the op table, as a program of its
/// arguments.
fn partials_of(operation: Operation) -> Program {
    let mut pool = Pool::new();
    let arguments: Vec<_> = (0..operation.arity())
        .map(|place| pool.declare_symbol(format!("x{place}"), SymbolKind::Local))
        .collect();
    let values: Vec<_> = arguments.iter().map(|&argument| pool.symbol(argument)).collect();
    let outputs = operation.partials(&mut pool, &values);
    let source = KernelSource { arguments, outputs, ..KernelSource::default() };
    lower(&pool, &source).expect("the derivatives of a function are functions of its arguments")
}

/// Returns the ranges of the numbers of a program.
fn numbers(program: &Program) -> Numbers {
    let number = |instruction: &Instruction| match instruction {
        Instruction::Constant(constant) => Some(constant_range(constant)),
        _ => None,
    };
    program.instructions().iter().map(number).collect()
}

/// Returns the range of each value, widened by its rounding.
fn ranges(
    program: &Program,
    numbers: &[Option<Interval>],
    arguments: &[Interval],
    largest: f64,
    rounding: impl Fn(usize) -> (f64, f64),
) -> Vec<Interval> {
    let mut ranges: Vec<Interval> = Vec::with_capacity(program.instructions().len());
    for (place, instruction) in program.instructions().iter().enumerate() {
        let of = |value: &Value| ranges[value.place()];
        let exact = match instruction {
            Instruction::Constant(_) => numbers[place].unwrap_or(Interval::EVERYTHING),
            Instruction::Argument(place) => arguments[*place as usize],
            Instruction::Add(a, b) => of(a).add(of(b)),
            Instruction::Subtract(a, b) => of(a).subtract(of(b)),
            Instruction::Multiply(a, b) if a == b => of(a).power(2, 1),
            Instruction::Multiply(a, b) => of(a).multiply(of(b)),
            Instruction::Divide(a, b) => of(a).divide(of(b)),
            Instruction::MultiplyAdd(..) => unreachable!("roundings were separated"),
            Instruction::DifferenceOfProducts([a, b, c, d]) => {
                of(a).multiply(of(b)).subtract(of(c).multiply(of(d)))
            }
            Instruction::SumOfProducts([a, b, c, d]) => of(a).multiply(of(b)).add(of(c).multiply(of(d))),
            Instruction::Negate(a) => of(a).negate(),
            Instruction::Sqrt(a) => of(a).sqrt(),
            Instruction::Power(a, exponent) => of(a).power(*exponent.numer(), *exponent.denom()),
            Instruction::Call(operation, operands) => {
                let operands: Vec<Interval> = operands.iter().map(of).collect();
                Interval::apply(*operation, &operands)
            }
            Instruction::Quadrature { .. } => Interval::EVERYTHING,
            Instruction::Select { left, relation, right, then, otherwise } => {
                match of(left).decide(*relation, of(right)) {
                    Some(true) => of(then),
                    Some(false) => of(otherwise),
                    None => of(then).hull(of(otherwise)),
                }
            }
        };
        let (relative, absolute) = rounding(place);
        let is_kept = relative == 0.0 && absolute == 0.0;
        let range = if is_kept { exact } else { exact.perturbed(relative, absolute) };
        // a value that overflows can be anything
        ranges.push(if range.magnitude() <= largest { range } else { range.hull(Interval::EVERYTHING) });
    }
    ranges
}

/// Returns the ranges without rounding, for derivatives, which are bounded but never computed in
/// floating point.
fn ranges_of_exact(program: &Program, numbers: &[Option<Interval>], arguments: &[Interval]) -> Vec<Interval> {
    ranges(program, numbers, arguments, f64::INFINITY, |_| (0.0, 0.0))
}

fn constant_range(constant: &crate::kernel::Constant) -> Interval {
    let number = constant.to_f64();
    if Arithmetic::DOUBLE.holds(constant) {
        Interval::point(number)
    } else {
        Interval::between(number.next_down(), number.next_up())
    }
}
