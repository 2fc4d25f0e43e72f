//! Exterior calculus that proves identities about differential forms exactly and turns them into
//! numeric code.
//!
//! A map and a form are written down once. Every claim about them is proved while the crate is
//! compiled, or the crate does not compile. Every kernel becomes a plain function.
//!
//! ```
//! forms::forms! {
//!     chart UV(u, v);
//!     chart R3(x, y, z) where x**2 + y**2 + z**2 > 0;
//!     let r = sqrt(x**2 + y**2 + z**2);
//!     form beta: 2 on R3 = (x*dy^dz + y*dz^dx + z*dx^dy) / r**3;
//!     map plane: UV -> R3 = (u, v, 1);
//!
//!     prove closed: d(beta) == 0;
//!
//!     /// Solid angle per unit (u, v) of the plane z = 1, seen from the origin.
//!     pub kernel density(u, v) = pullback(plane, beta)[du^dv];
//! }
//!
//! // The formula in the books: 1/(1 + u² + v²)^(3/2).
//! let (u, v) = (0.5_f64, -0.25_f64);
//! assert!((density(u, v) - (1.0 + u * u + v * v).powf(-1.5)).abs() < 1e-15);
//! ```
//!
//! | macro | takes | gives |
//! |---|---|---|
//! | [`forms!`] | a whole file of the language | its kernels as functions; a false claim is a compile error |
//! | [`include_forms!`] | the path of a `.forms` file | the same |
//! | [`proof_tests!`] | the path of a `.forms` file | one `#[test]` for each statement and each claim of a kernel |
//! | [`prove!`] | declarations and an equation | nothing; a compile error if it is not proved |
//! | [`kernel!`] | declarations and one kernel | its function |
//! | [`form!`] | declarations and an expression | a [`Form`]: degree and simplified coefficients |
//!
//! [`core`] is the library below the macros, for programs that read the language at run time:
//! [`core::compile`] accepts the same input. [`math`] is the arithmetic of generated kernels.

pub mod arrays;
mod form;
#[cfg(feature = "ndarray")]
pub mod rows;

pub use form::Form;
pub use forms_core as core;
pub use forms_math as math;

/// ```
/// forms::forms! {
///     chart Plane(x, y) where x**2 + y**2 > 0;
///     form angle = (x*dy - y*dx)/(x**2 + y**2);
///     prove closed: d(angle) == 0;
///     refute trivial: angle == 0;
/// }
/// ```
///
/// A claim that does not hold does not compile:
///
/// ```compile_fail
/// forms::forms! {
///     chart Plane(x, y);
///     prove wrong: d(x*dy) == 0;
/// }
/// ```
pub use forms_macros::forms;
pub use forms_macros::{include_forms, proof_tests};

/// ```
/// forms::prove! { chart Line(x); sqrt(x**2) == abs(x) }
/// ```
///
/// ```compile_fail
/// forms::prove! { chart Line(x); sqrt(x**2) == x }
/// ```
pub use forms_macros::prove;

/// ```
/// forms::kernel! {
///     /// Fresnel reflectance at normal incidence.
///     reflectance(n) = ((n - 1)/(n + 1))**2 where n > 0
/// }
/// assert!((reflectance(1.5) - 0.04).abs() < 1e-15);
/// assert!(reflectance(-1.0).is_nan());
/// ```
///
/// A module with the same name as the function contains the formula as written, other precisions,
/// and batches of columns:
///
/// ```
/// use forms::math::DoubleDouble;
///
/// forms::kernel! {
///     /// The mean of e⁻ˢ for s from 0 to t.
///     mean_transmittance(t) = (1 - exp(-t))/t by -expm1(-t)/t where t > 0
/// }
/// // as it is written it has lost everything to cancellation
/// assert_eq!(mean_transmittance(1e-17), 1.0);
/// assert_eq!(mean_transmittance::plain(1e-17), 0.0);
///
/// assert!((mean_transmittance::f32(0.5) - 0.78693868).abs() < 1e-7);
/// let precise = mean_transmittance::dd(DoubleDouble::new(0.5, 0.0));
/// assert!((precise - DoubleDouble::new(0.7869386805747332, -1.2e-17)).high().abs() < 1e-16);
///
/// let mut means = [0.0; 3];
/// mean_transmittance::batch(&[1e-17, 0.5, 2.0], &mut means)?;
/// assert!((means[2] - mean_transmittance(2.0)).abs() < 1e-15);
/// assert!(mean_transmittance::batch(&[0.5, 2.0], &mut means).is_err(), "columns of different lengths");
/// # Ok::<(), forms::math::LengthMismatch>(())
/// ```
pub use forms_macros::kernel;

/// ```
/// let form = forms::form! { chart Space(x, y, z); d(x*dy + x*y*dz) };
/// assert_eq!(form.degree, 2);
/// assert_eq!(form.terms, [("dx^dy", "1"), ("dx^dz", "y"), ("dy^dz", "x")]);
/// assert_eq!(form.to_string(), "dx^dy + y*dx^dz + x*dy^dz");
/// ```
pub use forms_macros::form;

/// Rust blocks of the documents, run as doctests.
#[cfg(doctest)]
mod documents {
    #[doc = include_str!("../README.md")]
    struct Readme;
    #[doc = include_str!("../docs/language.md")]
    struct Language;
    #[doc = include_str!("../docs/kernels.md")]
    struct Kernels;
    #[doc = include_str!("../docs/book/src/04-solid-angle.md")]
    struct SolidAngle;
}
