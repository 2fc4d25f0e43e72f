//! Agreement of two units, and advice where they do not agree.
//!
//! Angles: the radian can be read as 1, as in calculus, where the derivative of sin θ is cos θ and
//! an arc r dθ is a length. The steradian is not dropped, so that radiance, W/(m² sr), differs from
//! irradiance, W/m². The square of the radian is a steradian: the solid angle sin θ dθ dφ of a
//! sphere in radians turns a radiance into W/m².

use super::table::{self, Base};
use super::unit::{self, Meaning, Unit};
use num_rational::BigRational;
use num_traits::Zero;

/// Difference between two units.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Difference {
    /// No difference; radians are read as 1 if their exponents differ.
    None,
    /// Radians on one side that correspond to steradians on the other.
    Exchange,
    /// A power of the steradian.
    SolidAngle,
    /// A numeric factor.
    Size,
    /// A dimension.
    Dimension,
}

fn difference(quotient: &Meaning) -> Difference {
    let [radians, steradians] = [Base::Radian, Base::Steradian].map(|base| unit::exponent(quotient, base));
    let is_angle = |base: &Base| matches!(base, Base::Radian | Base::Steradian);
    let mut rest = quotient.keys().filter(|base| !is_angle(base)).peekable();
    if rest.peek().is_some() {
        let sizes_only = rest.all(|base| matches!(base, Base::Prime(_)));
        return if sizes_only && steradians.is_zero() { Difference::Size } else { Difference::Dimension };
    }
    if steradians.is_zero() {
        Difference::None
    } else if (&steradians * BigRational::from_integer(2.into()) + radians).is_zero() {
        Difference::Exchange
    } else {
        Difference::SolidAngle
    }
}

/// Returns the unit of a sum of quantities in these units, equal in either order; `None` if they do
/// not agree.
pub(super) fn common(left: &Unit, right: &Unit) -> Option<Unit> {
    let quotient = left.clone().quotient(right).meaning();
    match difference(&quotient) {
        Difference::None if quotient.is_empty() => Some(left.clone()),
        Difference::None => Some(left.clone().without_radians()),
        Difference::Exchange => Some(left.clone().with_steradians()),
        _ => None,
    }
}

/// Whether a quantity whose inferred unit is `found` can be declared in another unit: if the two
/// agree, or if the declaration makes a solid angle of a quantity without steradians, such as a
/// ratio of areas.
pub(super) fn admits(declared: &Unit, found: &Unit) -> bool {
    let quotient = declared.clone().quotient(found).meaning();
    match difference(&quotient) {
        Difference::None | Difference::Exchange => true,
        Difference::SolidAngle => unit::exponent(&found.meaning(), Base::Steradian).is_zero(),
        Difference::Size | Difference::Dimension => false,
    }
}

/// Advises how to fix two units that do not agree; `left_name` and `right_name` name the two
/// quantities.
pub(super) fn advice(left: &Unit, right: &Unit, (left_name, right_name): (&str, &str)) -> String {
    let quotient = left.clone().quotient(right).without_radians();
    let meaning = quotient.meaning();
    match difference(&meaning) {
        Difference::SolidAngle => {
            let steradians = unit::exponent(&meaning, Base::Steradian);
            let (lacking, power) = if steradians < BigRational::zero() {
                (left_name, -steradians)
            } else {
                (right_name, steradians)
            };
            let unit = Unit::named(table::STERADIAN).unwrap_or_default().power(&power);
            format!("{lacking} lacks a solid angle: multiply it by a quantity in {unit}")
        }
        Difference::Size => match unit::size(&meaning) {
            Some(size) => {
                let factor = right.clone().quotient(left);
                format!(
                    "1 {left} is {size} {right}: state both in one unit, or multiply by `let factor: {factor} = {size};`"
                )
            }
            None => format!("{left} and {right} differ in size: state both in one unit"),
        },
        _ => format!("{left_name} divided by {right_name} is in {quotient}, but must be a pure number"),
    }
}
