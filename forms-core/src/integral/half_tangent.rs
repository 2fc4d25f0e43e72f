//! Rational functions of one sine and cosine: the substitution t = tan(u/2), and the way back
//! without the poles of the tangent.

use super::Failure;
use super::rational::{Part, Rational};
use super::search::{Integrand, Search};
use crate::expression::{Expr, Operation, Pool, Substitution, Symbol, SymbolKind};
use crate::normal::{Fraction, Generator};
use crate::polynomial::Polynomial;

impl Search<'_> {
    /// Substitutes t = tan(u/2): cos u = (1 − t²)/(1 + t²), sin u = 2t/(1 + t²), for rational
    /// functions of one sine and cosine.
    pub(super) fn by_half_tangent(&mut self, integrand: &mut Integrand) -> Result<Option<Expr>, Failure> {
        let tower = &mut *integrand.tower;
        let x = tower.variable_number(integrand.symbol);
        let mut angle: Option<Fraction> = None;
        let y = self.pool.declare_symbol("y", SymbolKind::Local);
        let t: Fraction = Polynomial::variable(tower.variable_number(y)).into();
        let square = tower.multiply(&t, &t)?;
        let norm = tower.add(&Fraction::one(), &square)?;
        let inverse = tower.inverse(&norm)?;
        let mut values = Vec::new();
        for generator in integrand.generators.clone() {
            let above = match tower.generator(generator) {
                Generator::Cosine(_) => tower.subtract(&Fraction::one(), &square)?,
                Generator::Sine(_) => tower.add(&t, &t)?,
                _ => return Ok(None),
            };
            let Some(argument) = tower.argument(generator) else { return Ok(None) };
            if angle.as_ref().is_some_and(|known| *known != argument) {
                return Ok(None);
            }
            angle = Some(argument);
            values.push((generator, tower.multiply(&above, &inverse)?));
        }
        let Some(angle) = angle else { return Ok(None) };
        let function = tower.rational_function(&angle, x)?;
        if !function.denominator.is_empty() || function.numerator.degree() != 1 {
            return Ok(None);
        }
        // dx = 2/(κ(1 + t²)) dt
        let composed = tower.replaced(&integrand.normal, &values)?;
        let slope = tower.inverse(&function.numerator.coefficient(1))?;
        let twice = tower.add(&inverse, &inverse)?;
        let jacobian = tower.multiply(&twice, &slope)?;
        let rational = tower.multiply(&composed, &jacobian)?;
        let angle = integrand.tower.raise(self.pool, &angle);
        let half = self.pool.ratio(1, 2);
        let halved = self.pool.multiply(half, angle);
        let tangent = self.pool.apply(Operation::Tan, &[halved]);
        let values: Substitution = [(y, tangent)].into_iter().collect();
        let region = self.region;
        let mut over = Rational { pool: self.pool, tower: integrand.tower, region, symbol: y };
        let parts = over.antiderivative(&rational)?;
        let mut sum = self.pool.integer(0);
        for part in parts {
            let term = match self.as_turning(&part, y, halved) {
                Some(turning) => turning,
                None => {
                    let term = part.expression(self.pool);
                    self.pool.substitute(term, &values)
                }
            };
            sum = self.pool.add(sum, term);
        }
        Ok(Some(sum))
    }

    /// Rewrites atan((k t + m)/b) with t = tan u, without the poles of the tangent. It is the sum
    /// of three angles, where w = sin u + (m/k) cos u: u, the angle from (cos u, sin u) to (cos u,
    /// w), and the angle from there to (b cos u, k w):
    ///
    /// ```text
    /// u + atan((w − sin u) cos u/(cos²u + w sin u)) + atan((k − b) w cos u/(b cos²u + k w²)),   k b > 0
    /// ```
    /// The first denominator has no zero where |m| < 2|k|, the second none at all. Continuity and
    /// the right derivative are verified for the antiderivative as a whole.
    fn as_turning(&mut self, part: &Part, y: Symbol, u: Expr) -> Option<Expr> {
        let &Part::ArcTangent(coefficient, above, b) = part else { return None };
        let pool = &mut *self.pool;
        let [m, sum] = [0, 1].map(|place| {
            let place = pool.integer(place);
            pool.substitute(above, &[(y, place)].into_iter().collect())
        });
        let k = pool.subtract(sum, m);
        let product = pool.multiply(k, b);
        // the angle turns with u, or against it
        let turns_with = self.region.sign(pool, product)?.0;
        let (k, m, coefficient) =
            if turns_with { (k, m, coefficient) } else { [k, m, coefficient].map(|x| pool.negate(x)).into() };
        let (cosine, sine) = (pool.apply(Operation::Cos, &[u]), pool.apply(Operation::Sin, &[u]));
        let slope = pool.divide(m, k);
        let sheared = pool.multiply(slope, cosine);
        let w = pool.add(sine, sheared);
        let (b_cosine, k_w) = (pool.multiply(b, cosine), pool.multiply(k, w));
        let shear = angle_between(pool, (cosine, sine), (cosine, w));
        let scaling = angle_between(pool, (cosine, w), (b_cosine, k_w));
        let turned = pool.add(u, shear);
        let turned = pool.add(turned, scaling);
        Some(pool.multiply(coefficient, turned))
    }
}

/// Returns the angle from one point of the plane to another, less than a quarter turn.
fn angle_between(pool: &mut Pool, (x, y): (Expr, Expr), (x_to, y_to): (Expr, Expr)) -> Expr {
    let [xx, yy, xy, yx] = [(x, x_to), (y, y_to), (x, y_to), (y, x_to)].map(|(a, b)| pool.multiply(a, b));
    let (dot, cross) = (pool.add(xx, yy), pool.subtract(xy, yx));
    let tangent = pool.divide(cross, dot);
    pool.apply(Operation::Atan, &[tangent])
}
