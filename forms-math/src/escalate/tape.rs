//! Recording of a formula as it runs, so that one compiled version of it runs in every precision.
//!
//! ```text
//! formula ─ Recorded ─▶ steps ─▶ values of one kind of number, of another, …
//! ```
//! Both branches of a choice are steps, as [`Real`] states, and an integrand consists of the steps
//! after its integral. Thus a kernel is compiled once for all precisions beyond double-double.

use alloc::vec::Vec;
use core::cell::RefCell;
use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::{Computation, Number, Real};

/// Value of a formula, identified by the index of its step.
#[derive(Clone, Copy)]
pub(crate) struct Recorded(u32);

#[derive(Debug)]
enum Step {
    Argument(usize),
    Double(f64),
    Words(Vec<f64>),
    Number {
        words: [f64; 2],
        numerator: Vec<u64>,
        denominator: Vec<u64>,
        pi_exponent: i32,
    },
    Function(Function, u32),
    Binary(Binary, [u32; 2]),
    Power(u32, i64, i64),
    DifferenceOfProducts([u32; 4]),
    Choice(Choice, [u32; 4]),
    /// Integral: the steps after it up to `end` are its integrand. The first step is the variable,
    /// and one step gives the value.
    Integral {
        from: u32,
        to: u32,
        end: u32,
        value: u32,
    },
    /// Variable of integration.
    Variable,
}

/// Functions of one number, with their methods.
macro_rules! functions {
    ($($variant:ident $method:ident)*) => {
        #[derive(Clone, Copy, Debug)]
        enum Function { Negate, $($variant),* }

        impl Function {
            fn of<T: Real>(self, value: T) -> T {
                match self {
                    Self::Negate => -value,
                    $(Self::$variant => value.$method()),*
                }
            }
        }

        macro_rules! recorded_functions {
            () => { $(
                fn $method(self) -> Self {
                    push(Step::Function(Function::$variant, self.0))
                }
            )* };
        }
    };
}

functions! {
    Sqrt sqrt Abs abs Sin sin Cos cos Tan tan Asin asin Acos acos Atan atan Exp exp ExpM1 exp_m1 Ln ln Ln1p ln_1p
    Sinh sinh Cosh cosh Tanh tanh Erf erf Erfc erfc Expint1 expint1 Expint2 expint2 Expint3 expint3
    Dilog dilog Clausen clausen
}

#[derive(Clone, Copy, Debug)]
enum Binary {
    Add,
    Subtract,
    Multiply,
    Divide,
    Angle,
}

#[derive(Clone, Copy, Debug)]
enum Choice {
    Less,
    LessEqual,
    Equal,
}

std::thread_local! {
    static STEPS: RefCell<Vec<Step>> = const { RefCell::new(Vec::new()) };
}

fn push(step: Step) -> Recorded {
    STEPS.with_borrow_mut(|steps| {
        steps.push(step);
        Recorded(steps.len() as u32 - 1)
    })
}

macro_rules! binary {
    ($($operator:ident $method:ident $variant:ident)*) => { $(
        impl $operator for Recorded {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                push(Step::Binary(Binary::$variant, [self.0, other.0]))
            }
        }
    )* };
}
binary! { Add add Add Sub sub Subtract Mul mul Multiply Div div Divide }

impl Neg for Recorded {
    type Output = Self;
    fn neg(self) -> Self {
        push(Step::Function(Function::Negate, self.0))
    }
}

fn choice(kind: Choice, operands: [Recorded; 4]) -> Recorded {
    push(Step::Choice(kind, operands.map(|operand| operand.0)))
}

impl Real for Recorded {
    fn constant(words: &[f64]) -> Self {
        push(Step::Words(words.to_vec()))
    }
    fn number(number: Number<'_>) -> Self {
        push(Step::Number {
            words: *number.words(),
            numerator: number.numerator().to_vec(),
            denominator: number.denominator().to_vec(),
            pi_exponent: number.pi_exponent(),
        })
    }
    fn from_f64(value: f64) -> Self {
        push(Step::Double(value))
    }
    /// Returns NaN: the value is not known before the steps are run.
    fn to_f64(self) -> f64 {
        f64::NAN
    }
    fn difference_of_products(a: Self, b: Self, c: Self, d: Self) -> Self {
        push(Step::DifferenceOfProducts([a.0, b.0, c.0, d.0]))
    }
    fn power(self, numerator: i64, denominator: i64) -> Self {
        push(Step::Power(self.0, numerator, denominator))
    }
    fn if_less(left: Self, right: Self, then: Self, otherwise: Self) -> Self {
        choice(Choice::Less, [left, right, then, otherwise])
    }
    fn if_less_equal(left: Self, right: Self, then: Self, otherwise: Self) -> Self {
        choice(Choice::LessEqual, [left, right, then, otherwise])
    }
    fn if_equal(left: Self, right: Self, then: Self, otherwise: Self) -> Self {
        choice(Choice::Equal, [left, right, then, otherwise])
    }
    fn atan2(self, x: Self) -> Self {
        push(Step::Binary(Binary::Angle, [self.0, x.0]))
    }
    recorded_functions!();
    fn quadrature(from: Self, to: Self, integrand: impl Fn(Self) -> Self) -> Self {
        let integral = push(Step::Integral { from: from.0, to: to.0, end: 0, value: 0 });
        let variable = push(Step::Variable);
        let value = integrand(variable).0;
        STEPS.with_borrow_mut(|steps| {
            let end = steps.len() as u32;
            steps[integral.0 as usize] = Step::Integral { from: from.0, to: to.0, end, value };
        });
        integral
    }
}

/// Records a computation of this number of arguments, to be repeated in several precisions; returns
/// whether it has an integral, whose error is only estimated.
pub(super) fn in_any_precision(computation: &impl Computation, arguments: usize) -> (Tape, bool) {
    let tape = Tape::of(arguments, |arguments| computation.values(arguments));
    let has_integral = tape.has_integral();
    (tape, has_integral)
}

/// Formula as a list of steps.
#[derive(Debug)]
pub(super) struct Tape {
    steps: Vec<Step>,
    outputs: Vec<u32>,
}

impl Computation for Tape {
    fn values<T: Real>(&self, arguments: &[T]) -> Vec<T> {
        let mut values = Vec::with_capacity(self.steps.len());
        self.run(arguments, &mut values, self.steps.len());
        self.outputs.iter().map(|&output| values[output as usize]).collect()
    }
}

impl Tape {
    /// Records the steps of a formula with this number of arguments.
    fn of(arguments: usize, formula: impl FnOnce(&[Recorded]) -> Vec<Recorded>) -> Self {
        let others = STEPS.take();
        let arguments: Vec<Recorded> = (0..arguments).map(|place| push(Step::Argument(place))).collect();
        let outputs = formula(&arguments).into_iter().map(|output| output.0).collect();
        Self { outputs, steps: STEPS.replace(others) }
    }

    /// Whether the tape has an integral.
    fn has_integral(&self) -> bool {
        self.steps.iter().any(|step| matches!(step, Step::Integral { .. }))
    }

    /// Appends the values of the steps from the first one without a value up to `end`.
    fn run<T: Real>(&self, arguments: &[T], values: &mut Vec<T>, end: usize) {
        while values.len() < end {
            let place = values.len();
            let value = match self.steps[place] {
                Step::Integral { from, to, end, value } => {
                    let end = end as usize;
                    let within = RefCell::new(values.clone());
                    let integrand = |variable: T| {
                        let values = &mut *within.borrow_mut();
                        values.truncate(place);
                        values.extend([variable, variable]);
                        self.run(arguments, values, end);
                        values[value as usize]
                    };
                    let integral = T::quadrature(values[from as usize], values[to as usize], integrand);
                    values.resize(end, integral);
                    continue;
                }
                _ => self.step(place, arguments, values),
            };
            values.push(value);
        }
    }

    fn step<T: Real>(&self, place: usize, arguments: &[T], values: &[T]) -> T {
        let of = |place: u32| values[place as usize];
        match &self.steps[place] {
            Step::Argument(place) => arguments[*place],
            Step::Double(value) => T::from_f64(*value),
            Step::Words(words) => T::constant(words),
            Step::Number { words, numerator, denominator, pi_exponent } => {
                T::number(Number::new(*words, numerator, denominator, *pi_exponent))
            }
            Step::Function(function, a) => function.of(of(*a)),
            Step::Binary(operation, [a, b]) => match operation {
                Binary::Add => of(*a) + of(*b),
                Binary::Subtract => of(*a) - of(*b),
                Binary::Multiply => of(*a) * of(*b),
                Binary::Divide => of(*a) / of(*b),
                Binary::Angle => of(*a).atan2(of(*b)),
            },
            Step::Power(a, numerator, denominator) => of(*a).power(*numerator, *denominator),
            Step::DifferenceOfProducts([a, b, c, d]) => {
                T::difference_of_products(of(*a), of(*b), of(*c), of(*d))
            }
            Step::Choice(kind, operands) => {
                let [left, right, then, otherwise] = operands.map(of);
                match kind {
                    Choice::Less => T::if_less(left, right, then, otherwise),
                    Choice::LessEqual => T::if_less_equal(left, right, then, otherwise),
                    Choice::Equal => T::if_equal(left, right, then, otherwise),
                }
            }
            // `run` computes an integral and also assigns the value of its variable.
            Step::Integral { .. } | Step::Variable => T::nan(),
        }
    }
}
