//! Values as text, with the precedence that decides on brackets.

use crate::kernel::Constant;

/// Precedence of the outermost operator of a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Binding {
    Choice,
    Sum,
    Product,
    Sign,
    Atom,
}

/// Text of a value.
#[derive(Clone, Debug)]
pub(super) struct Written {
    pub(super) text: String,
    pub(super) binding: Binding,
    /// The number, if the value is one.
    pub(super) constant: Option<Constant>,
    /// Whether the text is the name of a variable.
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

    /// Returns the text, in brackets if the context needs a higher precedence.
    pub(super) fn within(&self, needed: Binding) -> String {
        if self.binding >= needed { self.text.clone() } else { format!("({})", self.text) }
    }

    /// Returns the text as an element of a list separated by commas.
    pub(super) fn argument(&self) -> String {
        self.within(Binding::Sum)
    }
}

/// Writes `left operator right` with the brackets that preserve this grouping.
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
