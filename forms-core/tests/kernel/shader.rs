//! Interpreter of WGSL, as naga reads it: the part of the language that emission uses.
//!
//! *Enters*: a text and buffers. *Leaves*: values. Every number is computed twice: as a device that
//! rounds to the nearest number computes it, and in `f64` with a bound of the error of all devices,
//! whose operations have the errors that the specification of WGSL allows (§15.7.4).

mod number;

pub(crate) use number::Float;

use naga::{
    Arena, Block, Expression, Function, GlobalVariable, Handle, Literal, LocalVariable, MathFunction, Module,
    ScalarKind, Statement, TypeInner, UnaryOperator,
};
use std::collections::HashMap;
use std::sync::Arc;

/// Value of an expression.
#[derive(Clone, Debug)]
pub(crate) enum Value {
    Float(Float),
    Unsigned(u32),
    Signed(i32),
    Truth(bool),
    Several(Vec<Value>),
    Global(Handle<GlobalVariable>, Option<usize>),
    Local(Handle<LocalVariable>),
}

impl Value {
    pub(crate) fn float(&self) -> Float {
        match self {
            Value::Float(number) => *number,
            other => panic!("{other:?} is no f32"),
        }
    }

    fn index(&self) -> usize {
        match self {
            Value::Unsigned(number) => *number as usize,
            Value::Signed(number) => *number as usize,
            other => panic!("{other:?} is no index"),
        }
    }
}

/// Text in WGSL with its buffers, by their names.
pub(crate) struct Shader {
    module: Arc<Module>,
    pub(crate) buffers: HashMap<String, Vec<Value>>,
}

impl Shader {
    #[track_caller]
    pub(crate) fn new(text: &str) -> Shader {
        let module = naga::front::wgsl::parse_str(text);
        let module = module.unwrap_or_else(|error| panic!("{}", error.emit_to_string(text)));
        Shader { module: Arc::new(module), buffers: HashMap::new() }
    }

    /// Computes a function of the text.
    pub(crate) fn call(&mut self, name: &str, arguments: &[Value]) -> Value {
        let module = Arc::clone(&self.module);
        let found = module.functions.iter().find(|(_, function)| function.name.as_deref() == Some(name));
        let (_, function) = found.unwrap_or_else(|| panic!("there is no function {name}"));
        self.run(&module, function, arguments).expect("functions return a value")
    }

    /// Runs an entry point for this many invocations in one workgroup after the other along x.
    pub(crate) fn dispatch(&mut self, name: &str, invocations: u32) {
        let module = Arc::clone(&self.module);
        let entry = module.entry_points.iter().find(|entry| entry.name == name).expect("an entry point");
        let groups = invocations.div_ceil(entry.workgroup_size[0]);
        let vector = |x: u32| Value::Several([x, 0, 0].map(Value::Unsigned).to_vec());
        for x in 0..groups * entry.workgroup_size[0] {
            self.run(&module, &entry.function, &[vector(x), vector(groups)]);
        }
    }

    fn run(&mut self, module: &Module, function: &Function, arguments: &[Value]) -> Option<Value> {
        let mut frame = Frame { module, function, arguments, known: HashMap::new(), locals: HashMap::new() };
        for (handle, local) in function.local_variables.iter() {
            if let Some(initial) = local.init {
                let value = frame.value(self, initial);
                frame.locals.insert(handle, value);
            }
        }
        frame.block(self, &function.body).flatten()
    }

    fn name(&self, module: &Module, global: Handle<GlobalVariable>) -> String {
        module.global_variables[global].name.clone().unwrap_or_default()
    }
}

/// Call of a function.
struct Frame<'a> {
    module: &'a Module,
    function: &'a Function,
    arguments: &'a [Value],
    known: HashMap<Handle<Expression>, Value>,
    locals: HashMap<Handle<LocalVariable>, Value>,
}

impl Frame<'_> {
    /// Runs a block; `Some` if it returns.
    fn block(&mut self, shader: &mut Shader, block: &Block) -> Option<Option<Value>> {
        for statement in block.iter() {
            match statement {
                Statement::Emit(range) => {
                    for handle in range.clone() {
                        let value = self.value(shader, handle);
                        self.known.insert(handle, value);
                    }
                }
                Statement::Block(inner) => {
                    if let Some(returned) = self.block(shader, inner) {
                        return Some(returned);
                    }
                }
                Statement::If { condition, accept, reject } => {
                    let Value::Truth(holds) = self.value(shader, *condition) else { panic!("a condition") };
                    if let Some(returned) = self.block(shader, if holds { accept } else { reject }) {
                        return Some(returned);
                    }
                }
                Statement::Return { value } => return Some(value.map(|value| self.value(shader, value))),
                Statement::Store { pointer, value } => self.store(shader, *pointer, *value),
                Statement::Call { function, arguments, result } => {
                    let arguments: Vec<Value> =
                        arguments.iter().map(|&argument| self.value(shader, argument)).collect();
                    let value = shader.run(self.module, &self.module.functions[*function], &arguments);
                    if let (Some(result), Some(value)) = (result, value) {
                        self.known.insert(*result, value);
                    }
                }
                other => panic!("emission writes no {other:?}"),
            }
        }
        None
    }

    fn store(&mut self, shader: &mut Shader, pointer: Handle<Expression>, value: Handle<Expression>) {
        let value = self.value(shader, value);
        match self.value(shader, pointer) {
            Value::Local(local) => {
                self.locals.insert(local, value);
            }
            Value::Global(global, Some(index)) => {
                let name = shader.name(self.module, global);
                shader.buffers.get_mut(&name).expect("a buffer")[index] = value;
            }
            other => panic!("{other:?} is no place"),
        }
    }

    fn value(&mut self, shader: &mut Shader, handle: Handle<Expression>) -> Value {
        if let Some(value) = self.known.get(&handle) {
            return value.clone();
        }
        let function = self.function;
        match &function.expressions[handle] {
            Expression::FunctionArgument(place) => self.arguments[*place as usize].clone(),
            Expression::GlobalVariable(global) => Value::Global(*global, None),
            Expression::LocalVariable(local) => Value::Local(*local),
            Expression::Constant(constant) => {
                constant_value(&self.module.global_expressions, self.module.constants[*constant].init)
            }
            Expression::Literal(literal) => literal_value(*literal),
            Expression::ZeroValue(ty) => self.zero(*ty),
            Expression::Compose { components, .. } => {
                Value::Several(components.iter().map(|&part| self.value(shader, part)).collect())
            }
            Expression::Access { base, index } => {
                let (base, index) = (self.value(shader, *base), self.value(shader, *index).index());
                element(base, index)
            }
            Expression::AccessIndex { base, index } => element(self.value(shader, *base), *index as usize),
            Expression::Load { pointer } => self.load(shader, *pointer),
            Expression::Unary { op, expr } => match (op, self.value(shader, *expr)) {
                (UnaryOperator::Negate, Value::Float(number)) => Value::Float(number.negate()),
                (UnaryOperator::LogicalNot, Value::Truth(truth)) => Value::Truth(!truth),
                (op, value) => panic!("emission writes no {op:?} of {value:?}"),
            },
            Expression::Binary { op, left, right } => {
                number::binary(*op, self.value(shader, *left), self.value(shader, *right))
            }
            Expression::Select { condition, accept, reject } => {
                let [accept, reject] = [accept, reject].map(|&branch| self.value(shader, branch));
                if matches!(self.value(shader, *condition), Value::Truth(true)) { accept } else { reject }
            }
            Expression::Math { fun, arg, arg1, arg2, .. } => {
                let others = [arg1, arg2].into_iter().flatten();
                let operands = std::iter::once(arg).chain(others);
                let operands: Vec<Float> =
                    operands.map(|&operand| self.value(shader, operand).float()).collect();
                Value::Float(math(*fun, &operands))
            }
            Expression::As { expr, kind, convert } => {
                converted(self.value(shader, *expr), *kind, convert.is_some())
            }
            other => panic!("emission writes no {other:?}"),
        }
    }

    fn load(&mut self, shader: &mut Shader, pointer: Handle<Expression>) -> Value {
        match self.value(shader, pointer) {
            Value::Local(local) => self.locals[&local].clone(),
            Value::Global(global, index) => {
                let name = shader.name(self.module, global);
                shader.buffers[&name][index.unwrap_or(0)].clone()
            }
            other => other,
        }
    }

    fn zero(&self, ty: Handle<naga::Type>) -> Value {
        match &self.module.types[ty].inner {
            TypeInner::Scalar(scalar) if scalar.kind == ScalarKind::Float => {
                Value::Float(Float::exactly(0.0))
            }
            TypeInner::Scalar(_) => Value::Unsigned(0),
            other => panic!("emission writes no zero of {other:?}"),
        }
    }
}

fn literal_value(literal: Literal) -> Value {
    match literal {
        Literal::F32(number) => Value::Float(Float::exactly(number)),
        Literal::U32(number) => Value::Unsigned(number),
        Literal::I32(number) => Value::Signed(number),
        Literal::Bool(truth) => Value::Truth(truth),
        other => panic!("emission writes no {other:?}"),
    }
}

fn constant_value(expressions: &Arena<Expression>, handle: Handle<Expression>) -> Value {
    match &expressions[handle] {
        Expression::Literal(literal) => literal_value(*literal),
        other => panic!("emission writes no constant {other:?}"),
    }
}

/// Returns an element of an array, or a pointer to it.
fn element(base: Value, index: usize) -> Value {
    match base {
        Value::Several(mut values) => values.swap_remove(index),
        Value::Global(global, None) => Value::Global(global, Some(index)),
        other => panic!("{other:?} has no elements"),
    }
}

/// Converts a scalar, or reads its bits as another type.
fn converted(value: Value, kind: ScalarKind, is_conversion: bool) -> Value {
    match (value, kind, is_conversion) {
        (Value::Float(number), ScalarKind::Sint, true) => Value::Signed(number.nearest as i32),
        (Value::Signed(number), ScalarKind::Uint, true) => Value::Unsigned(number as u32),
        (Value::Unsigned(bits), ScalarKind::Float, false) => {
            Value::Float(Float::exactly(f32::from_bits(bits)))
        }
        (value, kind, _) => panic!("emission does not convert {value:?} to {kind:?}"),
    }
}

/// Computes a built-in function.
fn math(function: MathFunction, operands: &[Float]) -> Float {
    use MathFunction as M;
    match (function, operands) {
        (M::Abs, [x]) => {
            if x.nearest.is_sign_negative() {
                x.negate()
            } else {
                *x
            }
        }
        (M::Min, [x, y]) => {
            if y.nearest < x.nearest {
                *y
            } else {
                *x
            }
        }
        (M::Floor, [x]) => Float::exactly(x.nearest.floor()),
        (M::Sign, [x]) if x.nearest == 0.0 || x.nearest.is_nan() => *x,
        (M::Sign, [x]) => Float::exactly(x.nearest.signum()),
        (M::Fma, [x, y, z]) => x.fused(*y, *z),
        (M::Sqrt, [x]) => x.sqrt(),
        (M::Exp, [x]) => x.exp(),
        (M::Log, [x]) => x.log(),
        (M::Pow, [x, y]) => Float::unbounded(x.exact.powf(y.exact)),
        (M::Atan2, [y, x]) => Float::unbounded(y.exact.atan2(x.exact)),
        (M::Sin, [x]) => Float::unbounded(x.exact.sin()),
        (M::Cos, [x]) => Float::unbounded(x.exact.cos()),
        (M::Tanh, [x]) => Float::unbounded(x.exact.tanh()),
        (other, _) => panic!("the interpreter does not have {other:?}"),
    }
}
