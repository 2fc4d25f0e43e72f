//! Values as text, with what is needed to put brackets around them.

use crate::kernel::constant::Constant;

/// How tightly the outermost operator of a text binds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Binding {
    Choice,
    Sum,
    Product,
    Sign,
    Atom,
}

/// A value's text.
#[derive(Clone, Debug)]
pub(super) struct Written {
    pub(super) text: String,
    pub(super) binding: Binding,
    /// The number it is, if it is one.
    pub(super) constant: Option<Constant>,
    /// Whether it is the name of a variable.
    pub(super) is_name: bool,
}

impl Written {
    pub(super) fn new(text: impl Into<String>, binding: Binding) -> Self {
        Written { text: text.into(), binding, constant: None, is_name: false }
    }

    pub(super) fn atom(text: impl Into<String>) -> Self {
        Self::new(text, Binding::Atom)
    }

    pub(super) fn name(text: impl Into<String>) -> Self {
        Written { is_name: true, ..Self::atom(text) }
    }

    /// The text, in brackets if it binds less tightly than its place needs.
    pub(super) fn within(&self, needed: Binding) -> String {
        if self.binding >= needed { self.text.clone() } else { format!("({})", self.text) }
    }

    /// The text as one of several between commas.
    pub(super) fn argument(&self) -> String {
        self.within(Binding::Sum)
    }
}

/// `left operator right`, bracketed so that it is read in this order.
pub(super) fn infix(left: &Written, operator: &str, right: &Written) -> Written {
    let (binding, of_right) = match operator {
        "+" | "-" => (Binding::Sum, Binding::Product),
        _ => (Binding::Product, Binding::Sign),
    };
    Written::new(format!("{} {operator} {}", left.within(binding), right.within(of_right)), binding)
}

/// −a
pub(super) fn negated(value: &Written) -> Written {
    Written::new(format!("-{}", value.within(Binding::Atom)), Binding::Sign)
}

/// `name(a, b)`
pub(super) fn function(name: &str, operands: &[&Written]) -> Written {
    let operands: Vec<String> = operands.iter().map(|operand| operand.argument()).collect();
    Written::atom(format!("{name}({})", operands.join(", ")))
}
