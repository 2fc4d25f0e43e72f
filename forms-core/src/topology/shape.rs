//! The shape of a domain, recognised from its conditions: convex, or convex around one hole.
//!
//! Affine inequalities and c − Σ aᵢ(xᵢ − pᵢ)² > 0 with aᵢ > 0 define convex sets. Σ aᵢ(xᵢ − pᵢ)² >
//! c with aᵢ > 0 and c ≥ 0 removes a ball, which from far away is the point p, from the space of
//! some coordinates: the remaining set contracts onto a sphere.

use super::session::Session;
use crate::expression::{Condition, Expr, Node, Pool, Rational, Relation, Symbol, SymbolKind};
use crate::normal::{Generator, Tower, Trigonometry, normalise};
use crate::polynomial::Polynomial;
use crate::theory::Theory;
use num_rational::Ratio;
use num_traits::{Signed, Zero};
use std::collections::BTreeMap;

/// The shape of a domain, up to deformation.
pub(super) enum Shape {
    /// Contractible to a point.
    Contractible,
    /// Contractible to a sphere around a hole.
    Around(Hole),
    /// Not recognised, with the reason.
    Unknown(String),
}

/// The removed set Σ aᵢ(xᵢ − pᵢ)² ≤ c.
pub(super) struct Hole {
    /// The coordinates xᵢ with the numbers pᵢ.
    pub(super) coordinates: Vec<(Symbol, Rational)>,
    /// The removed points in words.
    pub(super) place: String,
    /// The radius of a sphere outside the hole, in the language's notation.
    pub(super) radius: String,
}

impl Hole {
    /// Whether only a point of the space of its coordinates is removed.
    fn is_point(&self) -> bool {
        self.radius == "1"
    }
}

/// Effect of one condition on the domain.
enum Cut {
    /// The condition holds everywhere.
    Nothing,
    /// The condition leaves a convex set.
    Convex,
    /// The condition removes a ball or a point.
    Hole(Hole),
}

/// Returns the shape of the set where some conditions hold.
pub(super) fn shape(session: &Session, conditions: &[Condition]) -> Shape {
    let mut theory = session.theory.clone();
    let (mut holes, mut convex): (Vec<Hole>, Vec<Condition>) = (Vec::new(), Vec::new());
    for &condition in conditions {
        match cut(&mut theory, &condition) {
            Some(Cut::Nothing) => {}
            Some(Cut::Convex) => convex.push(condition),
            Some(Cut::Hole(hole)) => holes.push(hole),
            None => {
                let text = condition.text(&theory.pool);
                return Shape::Unknown(format!("`{text}` is neither convex nor the outside of a ball"));
            }
        }
    }
    let mut distinct: Vec<Hole> = Vec::new();
    for hole in holes {
        match distinct.iter_mut().find(|known| known.coordinates == hole.coordinates) {
            Some(known) if known.is_point() => *known = hole,
            Some(known) if hole.is_point() || known.radius == hole.radius => {}
            Some(_) => return Shape::Unknown("the domain excludes two balls around one point".into()),
            None => distinct.push(hole),
        }
    }
    let Some(hole) = distinct.pop() else { return Shape::Contractible };
    if !distinct.is_empty() {
        return Shape::Unknown("the domain has more than one hole".into());
    }
    match centre_is_inside(&mut theory.pool, &convex, &hole) {
        Some(true) => Shape::Around(hole),
        Some(false) => Shape::Contractible,
        None => Shape::Unknown(format!(
            "it is undecided whether {} lies within the bounds of the domain",
            hole.place
        )),
    }
}

/// Whether the convex conditions do not involve the coordinates of the hole, or hold strictly at
/// its centre. If one of them fails there, the hole removes only points that were outside or on the
/// boundary, and the domain contracts to a point. A hole that is larger than its centre may reach
/// the bounds, so its coordinates have to be free of them.
fn centre_is_inside(pool: &mut Pool, convex: &[Condition], hole: &Hole) -> Option<bool> {
    let own: Vec<Symbol> = hole.coordinates.iter().map(|entry| entry.0).collect();
    for condition in convex {
        let symbols = pool.symbols_in(&[condition.left, condition.right]);
        if !symbols.iter().any(|symbol| own.contains(symbol)) {
            continue;
        }
        if !hole.is_point() {
            return None;
        }
        let at: crate::expression::Substitution =
            hole.coordinates.iter().map(|(symbol, value)| (*symbol, pool.number(value.clone()))).collect();
        // On the boundary of a closed condition the centre is not an interior point either.
        let strict = match condition.relation {
            Relation::LessEqual => Relation::Less,
            Relation::GreaterEqual => Relation::Greater,
            relation => relation,
        };
        let holds = Condition { relation: strict, ..*condition }.substitute(pool, &at).decided(pool)?;
        if !holds {
            return Some(false);
        }
    }
    Some(true)
}

fn cut(theory: &mut Theory, condition: &Condition) -> Option<Cut> {
    let positive = !matches!(condition.relation, Relation::Less | Relation::LessEqual);
    let pool = &mut theory.pool;
    let mut side = if positive {
        pool.subtract(condition.left, condition.right)
    } else {
        pool.subtract(condition.right, condition.left)
    };
    // A power is zero exactly where its base is.
    while let (Relation::NotEqual, Node::Power(base, _)) = (condition.relation, pool.node(side)) {
        side = *base;
    }
    let quadratic = Quadratic::of(pool, side)?;
    let pure_affine = quadratic.squares.is_empty();
    if pure_affine {
        let touches = !quadratic.linear.is_empty();
        return (condition.relation != Relation::NotEqual || !touches).then_some(Cut::Convex);
    }
    if quadratic.squares.values().all(Signed::is_negative) && condition.relation != Relation::NotEqual {
        return Some(Cut::Convex);
    }
    let hole = quadratic.hole(theory, condition.relation)?;
    let holds_everywhere = matches!(condition.relation, Relation::GreaterEqual | Relation::LessEqual);
    Some(if hole.is_point() && holds_everywhere { Cut::Nothing } else { Cut::Hole(hole) })
}

/// A quadratic polynomial Σ aᵢxᵢ² + Σ bᵢxᵢ + constant in the coordinates, with numbers aᵢ and bᵢ;
/// the constant may contain parameters.
struct Quadratic {
    squares: BTreeMap<Symbol, Rational>,
    linear: BTreeMap<Symbol, Rational>,
    constant: Constant,
}

/// The terms without coordinates.
struct Constant {
    number: Rational,
    /// −constant − number as a sum of squares of parameters, if there are terms other than the
    /// number.
    negated_squares: Option<Expr>,
}

impl Quadratic {
    fn of(pool: &mut Pool, side: Expr) -> Option<Self> {
        let mut tower = Tower::new(Trigonometry::Circle);
        let prepared = normalise(&mut tower, pool, &[side]).ok()?;
        let fraction = prepared.exact(&mut tower, pool).ok()?.remove(0);
        let polynomial = fraction.as_polynomial()?.clone();
        let divisor = fraction.divisor();
        let mut found = Quadratic {
            squares: BTreeMap::new(),
            linear: BTreeMap::new(),
            constant: Constant { number: Rational::zero(), negated_squares: None },
        };
        let mut parameters = Polynomial::zero();
        let mut is_sum_of_squares = true;
        for (monomial, coefficient) in polynomial.terms() {
            let value = Rational::new(coefficient.clone(), divisor.clone());
            let mut symbols = Vec::new();
            for &(variable, exponent) in &monomial {
                let Generator::Variable(symbol) = tower.generator(variable) else { return None };
                symbols.push((*symbol, exponent));
            }
            match symbols.as_slice() {
                [] => found.constant.number = value,
                [(x, 1)] if pool.symbol_kind(*x) == SymbolKind::Coordinate => {
                    drop(found.linear.insert(*x, value));
                }
                [(x, 2)] if pool.symbol_kind(*x) == SymbolKind::Coordinate => {
                    drop(found.squares.insert(*x, value));
                }
                several if several.iter().any(|(x, _)| pool.symbol_kind(*x) == SymbolKind::Coordinate) => {
                    return None;
                }
                several => {
                    is_sum_of_squares &=
                        value.is_negative() && several.iter().all(|(_, exponent)| exponent % 2 == 0);
                    let term = Polynomial::constant(-coefficient).multiply_by_monomial(&monomial);
                    parameters = parameters.add(&term);
                }
            }
        }
        if !parameters.is_zero() && is_sum_of_squares {
            found.constant.negated_squares = Some(tower.raise(pool, &parameters.into()));
        }
        let concave = found.squares.values().all(Signed::is_negative);
        (concave || is_sum_of_squares).then_some(found)
    }

    /// Returns the hole of Σ aᵢ(xᵢ − pᵢ)² > c with aᵢ > 0 and c ≥ 0.
    fn hole(&self, theory: &Theory, relation: Relation) -> Option<Hole> {
        let positive = self.squares.values().all(Signed::is_positive);
        if !positive || self.linear.keys().any(|x| !self.squares.contains_key(x)) {
            return None;
        }
        let two = Rational::from_integer(2.into());
        let centre = |x: &Symbol| {
            let b = self.linear.get(x).cloned().unwrap_or_else(Rational::zero);
            -b / (&self.squares[x] * &two)
        };
        let coordinates: Vec<(Symbol, Rational)> = self.squares.keys().map(|x| (*x, centre(x))).collect();
        let at_centre: Rational = coordinates.iter().map(|(x, p)| &self.squares[x] * p * p).sum();
        let size = at_centre - &self.constant.number;
        if size.is_negative() || (relation == Relation::NotEqual && !size.is_zero()) {
            return None;
        }
        let smallest = self.squares.values().min()?;
        let number =
            (!size.is_zero()).then(|| format!("{}", Ratio::new(size.numer().clone(), size.denom().clone())));
        let squares = self.constant.negated_squares.map(|squares| theory.pool.text(squares));
        if relation == Relation::NotEqual && squares.is_some() {
            return None;
        }
        let point = number.is_none() && squares.is_none();
        let radius = if point {
            "1".to_owned()
        } else {
            let parts: Vec<String> = number.into_iter().chain(squares).collect();
            format!("sqrt(1 + ({})/({smallest}))", parts.join(" + "))
        };
        let equations: Vec<String> =
            coordinates.iter().map(|(x, p)| format!("{} = {p}", theory.pool.symbol_name(*x))).collect();
        let what = if point { "" } else { "a ball around " };
        Some(Hole { place: format!("{what}{}", equations.join(", ")), coordinates, radius })
    }
}
