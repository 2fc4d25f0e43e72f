//! Lowering: a structured expression becomes instructions, one for one, with its sharing preserved.
//! Minima and maxima, which are written with an absolute value, become comparisons.

use super::constant::Constant;
use super::program::{Comparison, Instruction, Program, Value};
use crate::expression::{
    Condition, Expr, Extremum, FunctionId, Node, Pool, Rational, Relation, Signature, Symbol,
};
use num_rational::Ratio;
use num_traits::Zero;
use rustc_hash::{FxHashMap, FxHashSet};
use std::fmt;

/// Largest number of nodes of a kernel. A larger one is an accident, most likely an expanded normal
/// form.
const LARGEST: usize = 200_000;

/// Expressions and signature that a kernel is lowered from.
#[derive(Clone, Debug, Default)]
pub struct KernelSource {
    /// Name of the kernel.
    pub name: String,
    /// Lines of its documentation.
    pub docs: Vec<String>,
    /// Whether it is visible outside its module.
    pub public: bool,
    /// Arguments and results as declared; `None` for a kernel of numbers only.
    pub signature: Option<Signature>,
    /// Variables that it is a function of, in order, arrays by their entries.
    pub arguments: Vec<Symbol>,
    /// Expressions that it computes.
    pub outputs: Vec<Expr>,
    /// Conditions under which it is defined; its value is NaN elsewhere.
    pub domain: Vec<Condition>,
}

/// Reason why an expression cannot be lowered to a kernel.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum LowerError {
    /// It contains a variable that is not an argument.
    FreeSymbol(String),
    /// It contains an unknown function, which has no value.
    UnknownFunction(String),
    /// It contains a non-zero number that is infinite or zero as an `f64`.
    Unrepresentable(Constant),
    /// It has more nodes than the limit.
    TooLarge {
        /// Number of its nodes.
        nodes: usize,
        /// Largest number of nodes allowed.
        limit: usize,
    },
}

impl fmt::Display for LowerError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            LowerError::FreeSymbol(name) => write!(f, "`{name}` is not an argument of the kernel"),
            LowerError::UnknownFunction(name) => {
                write!(f, "`{name}` is an unknown function, which a kernel cannot compute")
            }
            LowerError::Unrepresentable(constant) => {
                let size = if constant.to_f64() == 0.0 { "small" } else { "large" };
                write!(f, "the number {constant} is too {size} for `f64`")
            }
            LowerError::TooLarge { nodes, limit } => {
                write!(f, "the kernel has {nodes} operations, more than the limit of {limit}")
            }
        }
    }
}

impl std::error::Error for LowerError {}

/// Lowers a kernel to instructions, as it was written.
pub fn lower(pool: &Pool, source: &KernelSource) -> Result<Program, LowerError> {
    let roots: Vec<Expr> = source
        .domain
        .iter()
        .flat_map(|condition| [condition.left, condition.right])
        .chain(source.outputs.iter().copied())
        .collect();
    let order = computed(pool, &roots);
    if order.len() > LARGEST {
        return Err(LowerError::TooLarge { nodes: order.len(), limit: LARGEST });
    }
    let mut values: FxHashMap<Expr, Value> = FxHashMap::default();
    let mut instructions = Vec::with_capacity(order.len());
    for expression in order {
        if let Some((which, operands)) = pool.as_extremum(expression) {
            let [a, b] = operands
                .map(|operand| operand.map_or_else(|| zero(&mut instructions), |operand| values[&operand]));
            values.insert(expression, Value(instructions.len() as u32));
            instructions.push(comparison(which, a, b));
            continue;
        }
        let instruction = instruction(pool, source, expression, |operand| values[&operand])?;
        if let Instruction::Constant(constant) = &instruction
            && !constant.is_representable()
        {
            return Err(LowerError::Unrepresentable(constant.clone()));
        }
        values.insert(expression, Value(instructions.len() as u32));
        instructions.push(instruction);
    }
    let domain = source.domain.iter().map(|condition| Comparison {
        left: values[&condition.left],
        relation: condition.relation,
        right: values[&condition.right],
    });
    let arguments: Vec<String> =
        source.arguments.iter().map(|&symbol| pool.symbol_name(symbol).to_string()).collect();
    let of_numbers = || Signature::of_numbers(&arguments, source.outputs.len());
    Ok(Program {
        name: source.name.clone(),
        public: source.public,
        signature: source.signature.clone().unwrap_or_else(of_numbers),
        arguments,
        outputs: source.outputs.iter().map(|output| values[output]).collect(),
        domain: domain.collect(),
        instructions,
    })
}

/// Returns the expressions that have to be computed, operands before results: a minimum or maximum
/// is computed from its operands, without their sum and difference.
fn computed(pool: &Pool, roots: &[Expr]) -> Vec<Expr> {
    let mut wanted: FxHashSet<Expr> = roots.iter().copied().collect();
    let mut order = pool.reachable(roots);
    order.reverse();
    order.retain(|&expression| {
        let is_wanted = wanted.contains(&expression);
        match pool.as_extremum(expression).filter(|_| is_wanted) {
            Some((_, operands)) => wanted.extend(operands.into_iter().flatten()),
            None if is_wanted => pool.node(expression).for_each_operand(|operand| {
                wanted.insert(operand);
            }),
            None => {}
        }
        is_wanted
    });
    order.reverse();
    order
}

/// Appends the number 0.
fn zero(instructions: &mut Vec<Instruction>) -> Value {
    instructions.push(Instruction::Constant(Constant::rational(Rational::zero())));
    Value(instructions.len() as u32 - 1)
}

/// Selects the smaller or the larger of two values. Of equal values, which can be zeros of
/// different signs, it is b for the smaller and a for the larger. If one is NaN, so is the result.
fn comparison(which: Extremum, a: Value, b: Value) -> Instruction {
    let (then, otherwise) = if which == Extremum::Least { (a, b) } else { (b, a) };
    Instruction::Select { left: a, relation: Relation::Less, right: b, then, otherwise }
}

fn instruction(
    pool: &Pool,
    source: &KernelSource,
    expression: Expr,
    of: impl Fn(Expr) -> Value,
) -> Result<Instruction, LowerError> {
    Ok(match pool.node(expression) {
        Node::Number(value) => Instruction::Constant(Constant::rational(value.clone())),
        Node::Pi => Instruction::Constant(Constant::pi()),
        Node::Symbol(symbol) => {
            let place = source.arguments.iter().position(|argument| argument == symbol);
            let free = || LowerError::FreeSymbol(pool.symbol_name(*symbol).to_string());
            Instruction::Argument(place.ok_or_else(free)? as u32)
        }
        Node::Add(a, b) => Instruction::Add(of(*a), of(*b)),
        Node::Negate(a) => Instruction::Negate(of(*a)),
        Node::Multiply(a, b) => Instruction::Multiply(of(*a), of(*b)),
        Node::Divide(a, b) => Instruction::Divide(of(*a), of(*b)),
        Node::Power(a, exponent) if *exponent == Ratio::new(1, 2) => Instruction::Sqrt(of(*a)),
        Node::Power(a, exponent) => Instruction::Power(of(*a), *exponent),
        Node::Apply(operation, arguments) => {
            Instruction::Call(*operation, arguments.iter().map(|&argument| of(argument)).collect())
        }
        Node::Jet { function, arguments, .. } if pool.quadrature_of(*function).is_some() => {
            Instruction::Quadrature {
                integrand: Box::new(integrand(pool, *function)?),
                operands: arguments.iter().map(|&argument| of(argument)).collect(),
            }
        }
        Node::Jet { function, .. } => {
            return Err(LowerError::UnknownFunction(pool.function(*function).name.clone()));
        }
        Node::Select { left, relation, right, then, otherwise, .. } => Instruction::Select {
            left: of(*left),
            relation: *relation,
            right: of(*right),
            then: of(*then),
            otherwise: of(*otherwise),
        },
    })
}

/// Lowers the integrand of a quadrature to a kernel of its integration variable and its other
/// variables.
fn integrand(pool: &Pool, function: FunctionId) -> Result<Program, LowerError> {
    let unknown = || LowerError::UnknownFunction(pool.function(function).name.clone());
    let quadrature = pool.quadrature_of(function).ok_or_else(unknown)?;
    let arguments = std::iter::once(quadrature.variable).chain(quadrature.parameters.iter().copied());
    let source = KernelSource {
        name: "integrand".to_owned(),
        arguments: arguments.collect(),
        outputs: vec![quadrature.integrand],
        ..KernelSource::default()
    };
    lower(pool, &source)
}
