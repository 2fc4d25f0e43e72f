//! The table: every function of kernels with its hard arguments, and kernels of every kind of
//! instruction with random ones.

use crate::emitted::{Inputs, choices, kernels};
use crate::formula::Formulas;
use forms_core::expression::{Operation, Relation, Seam, TABLE};
use forms_core::kernel::{Instruction, Program};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, PI, TAU};

/// Function of kernels: an operation of the language, or an instruction of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Function {
    Operation(Operation),
    Sqrt,
    /// xʳ, r as numerator and denominator
    Power(i64, i64),
    Negate,
    Add,
    Subtract,
    Multiply,
    Divide,
    MultiplyAdd,
    DifferenceOfProducts,
    SumOfProducts,
    /// `if x < y { x } else { -y }`, and so on
    Choice(Relation),
}

/// Entry of the table.
pub(crate) struct Entry {
    /// The function; `None` for a kernel, whose reference is the interpreter.
    pub(crate) function: Option<Function>,
    pub(crate) program: Program,
    pub(crate) rows: Vec<Vec<f64>>,
}

/// Powers by multiplication, by roots, and by both.
const POWERS: [(i64, i64); 12] =
    [(2, 1), (3, 1), (5, 1), (7, 1), (-2, 1), (1, 3), (2, 3), (3, 2), (-5, 2), (-1, 2), (3, 7), (-2, 3)];

/// Arguments at which any function can be hard: signed zeros, the ends of the range, the
/// neighbours of 1, infinities and NaN.
const COMMON: [f64; 48] = [
    0.0,
    -0.0,
    5e-324,
    -5e-324,
    1e-310,
    -1e-310,
    f64::MIN_POSITIVE,
    1e-200,
    -1e-200,
    1e-45,
    1e-38,
    -1e-20,
    1e-8,
    2.44e-4,
    0.1,
    0.3,
    0.5,
    -0.5,
    0.75,
    1.0 - f64::EPSILON / 2.0,
    1.0,
    1.0 + f64::EPSILON,
    -1.0,
    -1.0 + f64::EPSILON / 2.0,
    -1.0 - f64::EPSILON,
    1.0 + f32::EPSILON as f64,
    1.5,
    2.0,
    -2.0,
    3.7,
    10.0,
    -10.0,
    37.0,
    100.0,
    710.0,
    -750.0,
    1e5,
    -1e6,
    1e9,
    1e22,
    1e38,
    1e300,
    -1e300,
    f64::MAX,
    f64::MIN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
];

/// Arguments of functions of several numbers.
const PLACES: [f64; 22] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.5,
    -0.5,
    2.0,
    -2.0,
    5e-324,
    -5e-324,
    1e-310,
    -1e-310,
    1e-200,
    -1e-200,
    710.0,
    -750.0,
    1e300,
    -1e300,
    f64::MAX,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
];

/// Returns a number and its neighbours.
fn around(place: f64) -> [f64; 3] {
    [place.next_down(), place, place.next_up()]
}

/// Returns multiples of π/2, small and large, and the two doubles that are nearest to such a
/// multiple for their size.
fn angles() -> Vec<f64> {
    let multiples = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 100.0, 1e3, 123_457.0, 1e6, 1e9, 1e15];
    let mut angles: Vec<f64> = multiples.iter().flat_map(|multiple| around(multiple * FRAC_PI_2)).collect();
    angles.extend([FRAC_PI_3, PI / 4.0, -PI, -FRAC_PI_2, 5.319_372_648_326_541e255]);
    angles.push(6_381_956_970_095_103.0 * 2f64.powi(797));
    angles
}

/// Returns the hard arguments of a function of one number, in addition to those of all functions.
fn hard(operation: Operation) -> Vec<f64> {
    use Operation as O;
    match operation {
        O::Sin | O::Cos | O::Tan => angles(),
        O::Clausen => [&angles()[..], &around(TAU), &around(-TAU)].concat(),
        O::Asin | O::Acos => [around(0.5), around(-0.5), [0.99, 0.707_106_781_186_547_5, -0.99]].concat(),
        O::Atan => [around(0.4375), around(2.4375), [1e16, -1e16, 0.01]].concat(),
        // overflow and underflow in both precisions
        O::Exp | O::Expm1 | O::Sinh | O::Cosh => {
            let ends = [709.7, 709.782_712_893_384, 709.79, 710.47, -708.4, -745.1, -745.2];
            let single = [88.7, 88.8, -87.4, -103.9, -104.1, 89.4];
            [&ends[..], &single, &[0.34, -0.34, 0.35, 1e-17, -37.5]].concat()
        }
        O::Log => [&around(1.0)[..], &around(2.0), &[0.99, 1.01, 0.707, 1.414, 1e-320]].concat(),
        O::Log1p => vec![-0.5, -0.99, 1e-17, -1e-17, 1e-5, 0.41, -0.29],
        O::Tanh => vec![0.55, 9.0, 9.1, 19.0, 19.1, 22.0, -22.1, 1e-9],
        O::Abs => Vec::new(),
        O::Erf => [&around(0.5)[..], &[0.84, 1.25, 2.857, 3.9, 4.0, 5.86, 5.93, -6.0, 27.0]].concat(),
        O::Expint1 | O::Expint2 | O::Expint3 => {
            [&around(1.0)[..], &[0.01, 1.9, 5.0, 30.0, 87.0, 700.0, 739.0, 745.0]].concat()
        }
        O::Dilog => [&around(1.0)[..], &around(0.5), &around(-1.0), &[-10.0, 0.99, 1e-5, -1e5]].concat(),
        O::Erfc => {
            [&around(0.5)[..], &[0.84, 1.25, 2.857, 5.1, 9.19, 10.05, -6.0, 26.5, 26.6, 27.3]].concat()
        }
        O::Cbrt => [&around(8.0)[..], &around(-27.0), &[1e-3, 0.125, 3.0, -2e-310]].concat(),
        O::Atan2 | O::Hypot => Vec::new(),
    }
}

/// Whether the table has a function for an instruction: arguments, constants and integrals are in
/// the kernels.
fn function_of(instruction: &Instruction) -> Option<Function> {
    Some(match instruction {
        Instruction::Add(..) => Function::Add,
        Instruction::Subtract(..) => Function::Subtract,
        Instruction::Multiply(..) => Function::Multiply,
        Instruction::Divide(..) => Function::Divide,
        Instruction::MultiplyAdd(..) => Function::MultiplyAdd,
        Instruction::DifferenceOfProducts(_) => Function::DifferenceOfProducts,
        Instruction::SumOfProducts(_) => Function::SumOfProducts,
        Instruction::Negate(_) => Function::Negate,
        Instruction::Sqrt(_) => Function::Sqrt,
        Instruction::Power(_, exponent) => Function::Power(*exponent.numer(), *exponent.denom()),
        Instruction::Call(operation, _) => Function::Operation(*operation),
        Instruction::Select { relation, .. } => Function::Choice(*relation),
        Instruction::Constant(_) | Instruction::Argument(_) | Instruction::Quadrature { .. } => return None,
    })
}

impl Function {
    /// Returns every function: a new operation is one of them.
    fn all() -> Vec<Self> {
        let instructions = [
            Self::Sqrt,
            Self::Negate,
            Self::Add,
            Self::Subtract,
            Self::Multiply,
            Self::Divide,
            Self::MultiplyAdd,
            Self::DifferenceOfProducts,
            Self::SumOfProducts,
            Self::Choice(Relation::Less),
            Self::Choice(Relation::LessEqual),
            Self::Choice(Relation::Greater),
            Self::Choice(Relation::GreaterEqual),
            Self::Choice(Relation::NotEqual),
        ];
        let powers = POWERS.map(|(numerator, denominator)| Self::Power(numerator, denominator));
        let operations = TABLE.iter().map(|row| Self::Operation(row.operation));
        operations.chain(powers).chain(instructions).collect()
    }

    fn arity(self) -> usize {
        match self {
            Self::Operation(operation) => operation.arity(),
            Self::Sqrt | Self::Power(..) | Self::Negate => 1,
            Self::Add | Self::Subtract | Self::Multiply | Self::Divide | Self::Choice(_) => 2,
            Self::MultiplyAdd => 3,
            Self::DifferenceOfProducts | Self::SumOfProducts => 4,
        }
    }

    fn program(self, number: usize) -> Program {
        let variables = ["x", "y", "z", "w"][..self.arity()].join(" ");
        let mut formulas = Formulas::over(&variables);
        let formula = match self {
            Self::Operation(operation) => {
                format!("{}({})", operation.row().name, variables.replace(' ', ", "))
            }
            Self::Sqrt => "sqrt(x)".to_owned(),
            Self::Power(numerator, denominator) => format!("x**({numerator}/{denominator})"),
            Self::Negate => "-x".to_owned(),
            Self::Add => "x + y".to_owned(),
            Self::Subtract => "x - y".to_owned(),
            Self::Multiply => "x*y".to_owned(),
            Self::Divide => "x/y".to_owned(),
            Self::MultiplyAdd => "x*y + z".to_owned(),
            Self::DifferenceOfProducts => "x*y - z*w".to_owned(),
            Self::SumOfProducts => "x*y + z*w".to_owned(),
            Self::Choice(_) => "-y".to_owned(),
        };
        let mut value = formulas.parse(&formula);
        if let Self::Choice(relation) = self {
            let (x, y) = (formulas.parse("x"), formulas.parse("y"));
            value = formulas.pool.select((x, relation, y), x, value, Seam::Agrees);
        }
        let program = formulas.named(&format!("function_{number}")).program(&[value]);
        match self {
            Self::MultiplyAdd | Self::Subtract | Self::Negate => program.optimise(),
            Self::DifferenceOfProducts | Self::SumOfProducts => program.optimise().compensate(),
            _ => program,
        }
    }

    /// Whether a row is not compared: a fractional power is defined from 0 on, and neither −0 nor
    /// −∞ is distinguished from the numbers on the other side.
    pub(crate) fn skips(self, row: &[f64]) -> bool {
        let is_negative_end = row[0].is_sign_negative() && (row[0] == 0.0 || row[0].is_infinite());
        matches!(self, Self::Power(_, denominator) if denominator > 1) && is_negative_end
    }

    fn rows(self) -> Vec<Vec<f64>> {
        match self {
            Self::Operation(operation) if operation.arity() == 1 => {
                COMMON.into_iter().chain(hard(operation)).map(|x| vec![x]).collect()
            }
            Self::Sqrt | Self::Power(..) | Self::Negate => COMMON.map(|x| vec![x]).to_vec(),
            // without cancellation, which a fused instruction and two roundings treat differently
            Self::MultiplyAdd => {
                let same_sign = |row: &Vec<f64>| row[0] * row[1] * row[2] >= 0.0;
                pairs().map(|[x, y]| vec![x, y, x * 0.5]).filter(same_sign).collect()
            }
            Self::DifferenceOfProducts => products(-1.0),
            Self::SumOfProducts => products(1.0),
            _ => pairs().map(Vec::from).collect(),
        }
    }
}

fn pairs() -> impl Iterator<Item = [f64; 2]> {
    PLACES.into_iter().flat_map(|x| PLACES.map(|y| [x, y]))
}

/// Returns rows of four numbers whose two products cancel, completely or up to a rounding.
fn products(sign: f64) -> Vec<Vec<f64>> {
    let third = 1.0 / 3.0;
    let mut rows = Vec::new();
    for exponent in [0, -20, 20, -50, 50] {
        let scale = 2f64.powi(exponent);
        let (a, b) = (third * scale, (1.0 + f64::EPSILON) * scale);
        rows.push(vec![a, b, -sign * scale, a]);
        rows.push(vec![a, b, -sign * b, a]);
        rows.push(vec![a, scale, sign * b, b]);
    }
    rows
}

/// Returns the table.
pub(crate) fn entries() -> Vec<Entry> {
    let of_function = |(number, function): (usize, Function)| {
        let program = function.program(number);
        Entry { function: Some(function), program, rows: function.rows() }
    };
    let mut entries: Vec<Entry> = Function::all().into_iter().enumerate().map(of_function).collect();
    let mut inputs = Inputs(1);
    let rows: Vec<Vec<f64>> = (0..30).map(|_| (0..8).map(|_| inputs.next()).collect()).collect();
    for program in [kernels(), choices()].concat() {
        let count = program.arguments().len();
        let rows = rows.iter().map(|row| row[..count].to_vec()).collect();
        entries.push(Entry { function: None, program, rows });
    }
    entries
}

#[test]
fn every_instruction_of_a_kernel_is_a_function_of_the_table() {
    let all = Function::all();
    for entry in entries() {
        for instruction in entry.program.instructions() {
            let Some(function) = function_of(instruction) else { continue };
            let is_power = matches!(function, Function::Power(..));
            assert!(is_power || all.contains(&function), "{function:?} has no entry");
        }
        let Some(function) = entry.function else { continue };
        let is_computed = |instruction| function_of(instruction) == Some(function);
        let is_root = matches!(function, Function::Power(..) | Function::Choice(_));
        assert!(
            is_root || entry.program.instructions().iter().any(is_computed),
            "{function:?} is another one"
        );
    }
}
