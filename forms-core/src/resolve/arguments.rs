//! Arguments of a call: their number and kind, and the errors about them.

use super::evaluation::Evaluated;
use crate::diagnostic::{Diagnostic, Span, counted};
use crate::syntax::ast::{self, Argument, Name};

/// Items that declare something that is called.
pub(super) const CALLED: &str = "`let` or `fn`";

/// Returns the error for a call of an argument of a definition.
pub(super) fn called_argument(function: &Name) -> Diagnostic {
    let message = format!("`{}` is an argument of the definition and takes no arguments", function.text);
    Diagnostic::new(function.span, message).with_help("write `*` for a product")
}

pub(super) fn plain_arguments(arguments: &[Argument]) -> Evaluated<Vec<&ast::Expr>> {
    arguments
        .iter()
        .map(|argument| match argument {
            Argument::Value(value) => Ok(value),
            Argument::Range { variable, .. } => Err(Diagnostic::new(
                variable.span,
                "a range `u = a..b` belongs to integrals, `sum` and `product` only",
            )),
        })
        .collect()
}

pub(super) fn exactly<'e, const N: usize>(
    arguments: &[&'e ast::Expr],
    name: &str,
    span: Span,
) -> Evaluated<[&'e ast::Expr; N]> {
    <[&ast::Expr; N]>::try_from(arguments).map_err(|_| wrong_count(name, N, arguments.len(), span))
}

pub(super) fn wrong_count(name: &str, wanted: usize, found: usize, span: Span) -> Diagnostic {
    Diagnostic::new(span, format!("`{name}` takes {}, found {found}", counted(wanted, "argument")))
}
