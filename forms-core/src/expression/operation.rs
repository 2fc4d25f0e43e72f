//! The operation table: every real function of the language, one row each.
//!
//! A row holds the function's name, its arguments, its evaluation in any precision, its spelling in
//! each target and its cost relative to an addition; [`partials`](super::partials) has its derivatives. Code that needs
//! one of these reads it from the table.

use forms_math::Real;

/// Name of a function in each target; `None` where the target lacks the function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Spelling {
    /// Method of `f64` in the standard library of Rust.
    pub rust: Option<&'static str>,
    /// Function for `double` in the `math.h` of C; the function for `float` has the suffix `f`.
    pub c: Option<&'static str>,
    /// The builtin function of WGSL.
    pub wgsl: Option<&'static str>,
    /// Function for `double` in CUDA; the function for `float` has the suffix `f`.
    pub cuda: Option<&'static str>,
}

/// Returns the spelling of a function that every target has under this name.
const fn everywhere(name: &'static str) -> Spelling {
    Spelling { rust: Some(name), c: Some(name), wgsl: Some(name), cuda: Some(name) }
}

/// Returns the spelling of a function that only C and CUDA have, and Rust as the given method, if
/// any.
const fn of_math_h(name: &'static str, rust: Option<&'static str>) -> Spelling {
    Spelling { rust, c: Some(name), wgsl: None, cuda: Some(name) }
}

/// Spelling of a function that no target has.
const NOWHERE: Spelling = Spelling { rust: None, c: None, wgsl: None, cuda: None };

/// One row of the table.
pub struct Row {
    /// The operation the row describes.
    pub operation: Operation,
    /// The name in the language.
    pub name: &'static str,
    /// Number of arguments.
    pub arity: usize,
    /// The method of [`Real`] that computes it.
    pub real: &'static str,
    /// Its name in each target.
    pub spelling: Spelling,
    /// LaTeX.
    pub latex: &'static str,
    /// Cost in units of one addition.
    pub cost: u32,
}

/// Passes the list of all functions to a macro. A line reads: documentation, operation, name in the
/// language (and of the function that gives its partial derivatives), arguments, method of [`Real`],
/// spelling in the targets, LaTeX, cost.
macro_rules! for_each_operation {
    ($with:ident) => {
        $with! {
            /// sine
            Sin = sin(q) by sin, everywhere("sin"), "\\sin", 20;
            /// cosine
            Cos = cos(q) by cos, everywhere("cos"), "\\cos", 20;
            /// tangent
            Tan = tan(q) by tan, everywhere("tan"), "\\tan", 25;
            /// arc sine, in [−π/2, π/2]
            Asin = asin(q) by asin, everywhere("asin"), "\\arcsin", 20;
            /// arc cosine, in [0, π]
            Acos = acos(q) by acos, everywhere("acos"), "\\arccos", 20;
            /// arc tangent, in (−π/2, π/2)
            Atan = atan(q) by atan, everywhere("atan"), "\\arctan", 25;
            /// atan2(y, x): the angle of the point (x, y), in (−π, π]
            Atan2 = atan2(y, x) by atan2, everywhere("atan2"), "\\operatorname{atan2}", 30;
            /// exponential
            Exp = exp(q) by exp, everywhere("exp"), "\\exp", 15;
            /// eᵠ − 1, accurate to the last places near 0
            Expm1 = expm1(q) by exp_m1, of_math_h("expm1", Some("exp_m1")), "\\operatorname{expm1}", 20;
            /// natural logarithm
            Log = log(q) by ln, Spelling { rust: Some("ln"), ..everywhere("log") }, "\\ln", 15;
            /// log(1 + q), accurate to the last places near 0
            Log1p = log1p(q) by ln_1p, of_math_h("log1p", Some("ln_1p")), "\\operatorname{log1p}", 20;
            /// hyperbolic sine
            Sinh = sinh(q) by sinh, everywhere("sinh"), "\\sinh", 25;
            /// hyperbolic cosine
            Cosh = cosh(q) by cosh, everywhere("cosh"), "\\cosh", 25;
            /// hyperbolic tangent
            Tanh = tanh(q) by tanh, everywhere("tanh"), "\\tanh", 25;
            /// absolute value
            Abs = abs(q) by abs, Spelling { c: Some("fabs"), cuda: Some("fabs"), ..everywhere("abs") }, "\\operatorname{abs}", 1;
            /// the error function 2/√π ∫₀ᵠ e^(−t²) dt
            Erf = erf(q) by erf, of_math_h("erf", None), "\\operatorname{erf}", 30;
            /// the exponential integral E₁(q) = ∫₁^∞ e^(−qt)/t dt, for q > 0
            Expint1 = expint1(q) by expint1, NOWHERE, "\\operatorname{E}_{1}", 60;
            /// the exponential integral E₂(q) = ∫₁^∞ e^(−qt)/t² dt, for q ≥ 0
            Expint2 = expint2(q) by expint2, NOWHERE, "\\operatorname{E}_{2}", 60;
            /// the exponential integral E₃(q) = ∫₁^∞ e^(−qt)/t³ dt, for q ≥ 0
            Expint3 = expint3(q) by expint3, NOWHERE, "\\operatorname{E}_{3}", 60;
            /// the dilogarithm Li₂(q) = −∫₀ᵠ log(1 − t)/t dt, for q ≤ 1
            Dilog = dilog(q) by dilog, NOWHERE, "\\operatorname{Li}_{2}", 60;
            /// Clausen's function Cl₂(q) = −∫₀ᵠ log|2 sin(t/2)| dt
            Clausen = clausen(q) by clausen, NOWHERE, "\\operatorname{Cl}_{2}", 60;
            /// the complementary error function 1 − erf(q), accurate to the last places for large q
            Erfc = erfc(q) by erfc, of_math_h("erfc", None), "\\operatorname{erfc}", 40;
            /// √(x² + y²), without overflow of a square
            Hypot = hypot(x, y) by hypot, of_math_h("forms_hypot", None), "\\operatorname{hypot}", 10;
            /// the real cube root, ∛(−q) = −∛q
            Cbrt = cbrt(q) by cbrt, of_math_h("cbrt", Some("cbrt")), "\\operatorname{cbrt}", 25;
        }
    };
}
pub(super) use for_each_operation;

/// Generates the enumeration, the table and the evaluation of each function.
macro_rules! operations {
    ($(
        $(#[$docs:meta])*
        $operation:ident = $name:ident($first:ident $(, $rest:ident)*) by $real:ident, $spelling:expr, $latex:literal, $cost:literal;
    )*) => {
        /// A real function of one or two arguments.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub enum Operation {
            $($(#[$docs])* $operation,)*
        }

        /// The table itself, in the order of [`Operation`].
        pub const TABLE: &[Row] = &[$(Row {
            operation: Operation::$operation,
            name: stringify!($name),
            arity: [stringify!($first) $(, stringify!($rest))*].len(),
            real: stringify!($real),
            spelling: $spelling,
            latex: $latex,
            cost: $cost,
        },)*];

        impl Operation {
            /// Evaluates the function in any precision; NaN if the number of arguments is wrong.
            pub fn apply<T: Real>(self, arguments: &[T]) -> T {
                match (self, arguments) {
                    $((Operation::$operation, &[$first $(, $rest)*]) => T::$real($first $(, $rest)*),)*
                    _ => T::nan(),
                }
            }
        }
    };
}

for_each_operation!(operations);

impl Operation {
    /// Returns the operation's row in the table.
    pub fn row(self) -> &'static Row {
        &TABLE[self as usize]
    }

    /// Returns the number of arguments.
    pub fn arity(self) -> usize {
        self.row().arity
    }

    /// Returns the operation with this name.
    pub fn named(name: &str) -> Option<Operation> {
        TABLE.iter().find(|row| row.name == name).map(|row| row.operation)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_is_in_the_order_of_the_operations() {
        for (place, row) in TABLE.iter().enumerate() {
            assert_eq!(row.operation as usize, place, "{}", row.name);
            assert_eq!(Operation::named(row.name), Some(row.operation));
        }
    }
}
