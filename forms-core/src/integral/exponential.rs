//! Products of powers, exponentials and sines or cosines: ∫ xᵏ e^(λx) cos(ωx) and ∫ xᵏ e^(λx)
//! sin(ωx).
//!
//! With μ = λ + iω: ∫ xᵏ e^(μx) = e^(μx) Σⱼ (−1)ʲ k!/(k−j)! xᵏ⁻ʲ/μʲ⁺¹, and 1/μ = (λ − iω)/(λ² +
//! ω²).

use super::Failure;
use super::moments::HIGHEST_POWER;
use super::search::{Integrand, Search};
use crate::expression::{Expr, Operation};
use crate::normal::{Fraction, Generator, Tower};
use crate::polynomial::Polynomial;

/// Limit on the number of waves into which a product of sines and cosines is expanded.
const MOST_WAVES: usize = 256;

/// coefficient · cos(ωx) or sin(ωx)
#[derive(Clone)]
struct Wave {
    coefficient: Fraction,
    frequency: Fraction,
    is_sine: bool,
}

/// xᵏ e^(λx) times a wave
struct Moment {
    power: u32,
    growth: Fraction,
    wave: Wave,
}

type Computed<T> = Result<T, Failure>;

impl Search<'_> {
    /// Returns an antiderivative of a sum of such products, if the integrand is one.
    pub(super) fn exponential(&mut self, integrand: &mut Integrand) -> Computed<Option<Expr>> {
        let generators = integrand.generators.clone();
        let x = integrand.tower.variable_number(integrand.symbol);
        let mut slopes = Vec::new();
        for &generator in &generators {
            let Some(slope) = slope(integrand.tower, generator, x) else { return Ok(None) };
            slopes.push(slope);
        }
        let Some(terms) = integrand.tower.laurent_terms(&integrand.normal, &generators) else {
            return Ok(None);
        };
        let mut moments: Vec<Moment> = Vec::new();
        for (exponents, coefficient) in terms {
            let Some(found) = product(integrand.tower, &generators, &slopes, &exponents, coefficient)? else {
                return Ok(None);
            };
            for moment in found {
                gather(integrand.tower, &mut moments, moment)?;
            }
        }
        let mut sum = self.pool.integer(0);
        for moment in moments.iter().filter(|moment| !moment.wave.coefficient.is_zero()) {
            let term = self.moment(integrand, moment)?;
            sum = self.pool.add(sum, term);
        }
        Ok(Some(sum))
    }

    /// coefficient · ∫ xᵏ e^(λx) cos(ωx), or sin(ωx)
    fn moment(&mut self, integrand: &mut Integrand, moment: &Moment) -> Computed<Expr> {
        let Moment { power, growth, wave } = moment;
        let power = *power;
        let tower = &mut *integrand.tower;
        let x = self.pool.symbol(integrand.symbol);
        if growth.is_zero() && wave.frequency.is_zero() {
            let raised = self.pool.power(x, (i64::from(power) + 1).into());
            let share = self.pool.ratio(1, i64::from(power) + 1);
            let coefficient = tower.raise(self.pool, &wave.coefficient);
            let scaled = self.pool.multiply(share, raised);
            return Ok(self.pool.multiply(coefficient, scaled));
        }
        let (cosine, sine) = self.amplitudes(tower, power, growth, &wave.frequency, x)?;
        let rate = tower.raise(self.pool, growth);
        let exponent = self.pool.multiply(rate, x);
        let exponential = self.pool.apply(Operation::Exp, &[exponent]);
        let frequency = tower.raise(self.pool, &wave.frequency);
        let angle = self.pool.multiply(frequency, x);
        let (c, s) = (self.pool.apply(Operation::Cos, &[angle]), self.pool.apply(Operation::Sin, &[angle]));
        // Re and Im of (p + iq)(cos + i sin)
        let value = if wave.is_sine {
            let (a, b) = (self.pool.multiply(cosine, s), self.pool.multiply(sine, c));
            self.pool.add(a, b)
        } else {
            let (a, b) = (self.pool.multiply(cosine, c), self.pool.multiply(sine, s));
            self.pool.subtract(a, b)
        };
        let value = if growth.is_zero() { value } else { self.pool.multiply(exponential, value) };
        let coefficient = tower.raise(self.pool, &wave.coefficient);
        Ok(self.pool.multiply(coefficient, value))
    }

    /// Real and imaginary part of Σⱼ (−1)ʲ k!/(k−j)! xᵏ⁻ʲ/μʲ⁺¹.
    fn amplitudes(
        &mut self,
        tower: &mut Tower,
        power: u32,
        growth: &Fraction,
        frequency: &Fraction,
        x: Expr,
    ) -> Computed<(Expr, Expr)> {
        let (re, im) = inverse(tower, growth, frequency)?;
        let (mut p, mut q) = (re.clone(), im.clone());
        let (mut real, mut imaginary) = (self.pool.integer(0), self.pool.integer(0));
        for j in 0..=power {
            let raised = self.pool.power(x, i64::from(power - j).into());
            for (part, sum) in [(&p, &mut real), (&q, &mut imaginary)] {
                let coefficient = tower.raise(self.pool, part);
                let term = self.pool.multiply(coefficient, raised);
                *sum = self.pool.add(*sum, term);
            }
            let step = Fraction::from(Polynomial::integer(-i64::from(power - j)));
            let (pr, qi) = (tower.multiply(&p, &re)?, tower.multiply(&q, &im)?);
            let (pi, qr) = (tower.multiply(&p, &im)?, tower.multiply(&q, &re)?);
            let (next_p, next_q) = (tower.subtract(&pr, &qi)?, tower.add(&pi, &qr)?);
            (p, q) = (tower.multiply(&next_p, &step)?, tower.multiply(&next_q, &step)?);
        }
        Ok((real, imaginary))
    }
}

/// Expands one product of powers of the generators into a sum of moments.
fn product(
    tower: &mut Tower,
    generators: &[u32],
    slopes: &[Fraction],
    exponents: &[i32],
    coefficient: Fraction,
) -> Computed<Option<Vec<Moment>>> {
    let (mut power, mut growth) = (0_u32, Fraction::zero());
    let mut waves = vec![Wave { coefficient, frequency: Fraction::zero(), is_sine: false }];
    for ((&generator, slope), &exponent) in generators.iter().zip(slopes).zip(exponents) {
        match tower.generator(generator).clone() {
            Generator::Exponential(_) => {
                let times = Polynomial::integer(exponent.into()).into();
                let share = tower.multiply(slope, &times)?;
                growth = tower.add(&growth, &share)?;
            }
            _ if exponent < 0 => return Ok(None),
            Generator::Variable(_) => power = exponent.unsigned_abs(),
            wave => {
                let is_sine = matches!(wave, Generator::Sine(_));
                for _ in 0..exponent {
                    waves = multiplied(tower, waves, slope, is_sine)?;
                }
            }
        }
        if waves.len() > MOST_WAVES {
            return Err(
                format!("a product that expands into more than {MOST_WAVES} sines and cosines").into()
            );
        }
    }
    if power > HIGHEST_POWER {
        return Err(format!("a power above the limit of {HIGHEST_POWER}").into());
    }
    Ok(Some(waves.into_iter().map(|wave| Moment { power, growth: growth.clone(), wave }).collect()))
}

/// Adds a moment to the moments of its kind, so that cancelled terms leave no frequency to divide
/// by.
fn gather(tower: &mut Tower, moments: &mut Vec<Moment>, moment: Moment) -> Computed<()> {
    let alike = |known: &&mut Moment| {
        known.power == moment.power
            && known.growth == moment.growth
            && known.wave.is_sine == moment.wave.is_sine
            && known.wave.frequency == moment.wave.frequency
    };
    match moments.iter_mut().find(alike) {
        Some(known) => {
            known.wave.coefficient = tower.add(&known.wave.coefficient, &moment.wave.coefficient)?;
        }
        None => moments.push(moment),
    }
    Ok(())
}

/// Returns the slope κ of an exponential, sine or cosine of κx; 1 for x itself.
fn slope(tower: &mut Tower, generator: u32, x: u32) -> Option<Fraction> {
    if generator == x {
        return Some(Fraction::one());
    }
    let argument = tower.argument(generator)?;
    let function = tower.rational_function(&argument, x).ok()?;
    let linear = function.denominator.is_empty()
        && function.numerator.degree() == 1
        && function.numerator.coefficient(0).is_zero();
    linear.then(|| function.numerator.coefficient(1))
}

/// 1/(λ + iω)
fn inverse(tower: &mut Tower, growth: &Fraction, frequency: &Fraction) -> Computed<(Fraction, Fraction)> {
    if growth.is_zero() {
        let inverse = tower.inverse(frequency)?;
        return Ok((Fraction::zero(), tower.negate(&inverse)));
    }
    if frequency.is_zero() {
        return Ok((tower.inverse(growth)?, Fraction::zero()));
    }
    let (g, f) = (tower.multiply(growth, growth)?, tower.multiply(frequency, frequency)?);
    let norm = tower.add(&g, &f)?;
    let inverse = tower.inverse(&norm)?;
    let re = tower.multiply(growth, &inverse)?;
    let im = tower.multiply(&tower.negate(frequency), &inverse)?;
    Ok((re, im))
}

/// Multiplies waves by a sine or cosine: 2 cos a cos b = cos(a−b) + cos(a+b) and similar
/// identities.
fn multiplied(
    tower: &mut Tower,
    waves: Vec<Wave>,
    frequency: &Fraction,
    by_sine: bool,
) -> Computed<Vec<Wave>> {
    let mut products: Vec<Wave> = Vec::new();
    let half = Fraction::number(&crate::expression::Rational::new(1.into(), 2.into()));
    for wave in waves {
        let halved = tower.multiply(&wave.coefficient, &half)?;
        let negated = tower.negate(&halved);
        let up = tower.add(&wave.frequency, frequency)?;
        let down = tower.subtract(&wave.frequency, frequency)?;
        // cos cos, sin cos, cos sin, sin sin
        let (first, second, is_sine) = match (wave.is_sine, by_sine) {
            (false, false) => (halved.clone(), halved, false),
            (true, false) => (halved.clone(), halved, true),
            (false, true) => (halved, negated, true),
            (true, true) => (negated, halved, false),
        };
        for (mut coefficient, mut frequency) in [(first, up), (second, down)] {
            if is_sine && frequency.is_zero() {
                continue;
            }
            if frequency.numerator().is_negative() {
                frequency = tower.negate(&frequency);
                coefficient = if is_sine { tower.negate(&coefficient) } else { coefficient };
            }
            let same = products.iter_mut().find(|w| w.is_sine == is_sine && w.frequency == frequency);
            match same {
                Some(known) => known.coefficient = tower.add(&known.coefficient, &coefficient)?,
                None => products.push(Wave { coefficient, frequency, is_sine }),
            }
        }
    }
    Ok(products)
}
