//! Random expressions over two angles x, z, which are multiples of π at the points under test, and
//! two fractions y, w.

use crate::value::Value;
use num_rational::Ratio;
use num_traits::Signed;

/// Point, as x/π, z/π, y and w.
pub(crate) type Point = [Ratio<i64>; 4];

/// Sum of multiples of the angles, divided by a small number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Angle {
    pub(crate) of_x: i64,
    pub(crate) of_z: i64,
    pub(crate) over: i64,
}

/// Inverse function applied to its function of an angle, which folds the angle into the principal
/// range.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Fold {
    Acos,
    Asin,
    Atan,
    Atan2,
}

impl Fold {
    /// Folds an angle of `turns` half turns; `None` where the tangent is undefined, and on the
    /// branch cut of `atan2`, which statements exclude.
    fn of(self, turns: Ratio<i64>) -> Option<Ratio<i64>> {
        let two = Ratio::from_integer(2);
        let within = turns - ((turns + 1) / two).ceil() * two + two;
        let quarter = Ratio::new(1, 2);
        let to_quarter = |turns: Ratio<i64>| turns - (turns + quarter).floor();
        Some(match self {
            Fold::Atan2 if within == Ratio::from_integer(1) => return None,
            Fold::Atan2 => within,
            Fold::Acos => within.abs(),
            Fold::Asin if within > quarter => Ratio::from_integer(1) - within,
            Fold::Asin if within < -quarter => -Ratio::from_integer(1) - within,
            Fold::Asin => within,
            Fold::Atan if to_quarter(turns) == -quarter => return None,
            Fold::Atan => to_quarter(turns),
        })
    }
}

#[derive(Clone, Debug)]
pub(crate) enum Tree {
    Number(i64),
    /// y or w
    Plain(usize),
    Cos(Angle),
    Sin(Angle),
    /// The angle itself.
    Turns(Angle),
    Folded(Fold, Angle),
    /// Folded angle minus the angle.
    Excess(Fold, Angle),
    /// ∫₀¹ cos(n s) ds
    Mean(Box<Tree>),
    Add(Box<Tree>, Box<Tree>),
    Multiply(Box<Tree>, Box<Tree>),
    Negate(Box<Tree>),
    Abs(Box<Tree>),
    Sqrt(Box<Tree>),
    Exp(Box<Tree>),
}

use Tree::{Abs, Add, Cos, Excess, Exp, Folded, Mean, Multiply, Negate, Number, Plain, Sin, Sqrt, Turns};

impl Tree {
    pub(crate) fn plus(self, other: Tree) -> Tree {
        Add(Box::new(self), Box::new(other))
    }

    pub(crate) fn minus(self, other: Tree) -> Tree {
        self.plus(other.negated())
    }

    pub(crate) fn times(self, other: Tree) -> Tree {
        Multiply(Box::new(self), Box::new(other))
    }

    pub(crate) fn negated(self) -> Tree {
        Negate(Box::new(self))
    }

    pub(crate) fn squared(self) -> Tree {
        self.clone().times(self)
    }

    pub(crate) fn abs(self) -> Tree {
        Abs(Box::new(self))
    }

    pub(crate) fn sqrt(self) -> Tree {
        Sqrt(Box::new(self))
    }

    pub(crate) fn exp(self) -> Tree {
        Exp(Box::new(self))
    }

    /// Returns the value at a point; `None` where it is not certainly defined.
    pub(crate) fn at(&self, point: &Point) -> Option<Value> {
        Some(match self {
            Number(n) => Value::fraction(*n, 1),
            Plain(place) => Value::fraction(*point[2 + place].numer(), *point[2 + place].denom()),
            Cos(angle) => Value::cosine_of_turns(angle.turns(point)),
            Sin(angle) => Value::sine_of_turns(angle.turns(point)),
            Turns(angle) => Value::turns(angle.turns(point)),
            Folded(fold, angle) => Value::turns(fold.of(angle.turns(point))?),
            Excess(fold, angle) => Value::turns(fold.of(angle.turns(point))? - angle.turns(point)),
            Mean(n) => n.at(point)?.mean_of_wave()?,
            Add(a, b) => a.at(point)?.add(b.at(point)?),
            Multiply(a, b) => a.at(point)?.multiply(b.at(point)?),
            Negate(a) => a.at(point)?.negate(),
            Abs(a) => a.at(point)?.abs(),
            Sqrt(a) => a.at(point)?.sqrt()?,
            Exp(a) => a.at(point)?.exp(),
        })
    }
}

impl Angle {
    fn turns(self, [x, z, ..]: &Point) -> Ratio<i64> {
        (x * Ratio::from_integer(self.of_x) + z * Ratio::from_integer(self.of_z))
            / Ratio::from_integer(self.over)
    }
}

impl Fold {
    fn write(self, f: &mut std::fmt::Formatter<'_>, angle: &Angle) -> std::fmt::Result {
        match self {
            Fold::Acos => write!(f, "acos(cos({angle}))"),
            Fold::Asin => write!(f, "asin(sin({angle}))"),
            Fold::Atan => write!(f, "atan(tan({angle}))"),
            Fold::Atan2 => write!(f, "atan2(sin({angle}), cos({angle}))"),
        }
    }
}

impl std::fmt::Display for Angle {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "({}*x + {}*z)/{}", self.of_x, self.of_z, self.over)
    }
}

impl std::fmt::Display for Tree {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Number(n) if *n < 0 => write!(f, "({n})"),
            Number(n) => write!(f, "{n}"),
            Plain(place) => write!(f, "{}", ["y", "w"][*place]),
            Cos(angle) => write!(f, "cos({angle})"),
            Sin(angle) => write!(f, "sin({angle})"),
            Turns(angle) => write!(f, "({angle})"),
            Folded(fold, angle) => fold.write(f, angle),
            Excess(fold, angle) => {
                write!(f, "(")?;
                fold.write(f, angle)?;
                write!(f, " - ({angle}))")
            }
            Mean(n) => write!(f, "integral(cos({n}*s), s = 0..1)"),
            Add(a, b) => write!(f, "({a} + {b})"),
            Multiply(a, b) => write!(f, "{a}*{b}"),
            Negate(a) => write!(f, "(-{a})"),
            Abs(a) => write!(f, "abs({a})"),
            Sqrt(a) => write!(f, "sqrt({a})"),
            Exp(a) => write!(f, "exp({a})"),
        }
    }
}
