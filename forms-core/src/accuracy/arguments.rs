//! Arguments of each regime, drawn before the test whether they lie in the domain.

use super::edges::Edges;
use super::ordinal::Width;
use super::regime::Regime;
use crate::random::SplitMix;

/// Typical sizes lie between 2⁻ⁿ and 2ⁿ.
const TYPICAL_EXPONENT: i32 = 6;

/// Exponents of the powers of two between which zeros of the formula's parts are searched for.
const GRID_EXPONENTS: std::ops::RangeInclusive<i32> = -24..=24;

/// Numbers up to 2ⁿ times the typical ones are drawn for exponentials.
const EXPONENTIAL_REACH: f64 = 5.0;

/// A deterministic sequence of arguments of one kernel: the same seed gives the same arguments.
pub(super) struct Arguments<'a> {
    pub(super) edges: &'a Edges,
    pub(super) width: Width,
    pub(super) random: SplitMix,
}

impl Arguments<'_> {
    /// Returns the next arguments of a regime; `None` if the kernel has no such regime.
    pub(super) fn next(&mut self, regime: Regime) -> Option<Vec<f64>> {
        let drawn = match regime {
            Regime::Typical => self.typical(),
            Regime::Everywhere => self.everywhere(),
            Regime::LowerEdge => self.at_an_end(|range| range.0, 1.0)?,
            Regime::UpperEdge => self.at_an_end(|range| range.1, -1.0)?,
            Regime::Coincident => self.coincident()?,
            Regime::Singular => self.singular()?,
            Regime::Large => self.scaled(1)?,
            Regime::Small => self.scaled(-1)?,
        };
        Some(drawn.into_iter().map(|value| self.width.round(value)).collect())
    }

    /// Returns a random number in [0, 1).
    fn unit(&mut self) -> f64 {
        (self.random.next() >> 11) as f64 * 2f64.powi(-53)
    }

    fn below(&mut self, count: usize) -> usize {
        (self.random.next() % count.max(1) as u64) as usize
    }

    fn coin(&mut self) -> bool {
        self.random.next() & 1 == 0
    }

    fn sign(&mut self) -> f64 {
        if self.coin() { 1.0 } else { -1.0 }
    }

    /// Returns 2ˣ with a random x between two numbers.
    fn power_of_two(&mut self, from: f64, to: f64) -> f64 {
        (from + (to - from) * self.unit()).exp2()
    }

    fn typical(&mut self) -> Vec<f64> {
        (0..self.edges.ranges.len()).map(|argument| self.typical_value(argument)).collect()
    }

    /// Draws a value uniformly over a short range; otherwise of moderate size, measured from an end
    /// of the range if the range does not contain zero.
    fn typical_value(&mut self, argument: usize) -> f64 {
        let size = self.power_of_two(-f64::from(TYPICAL_EXPONENT), f64::from(TYPICAL_EXPONENT));
        let (lower, upper) = self.edges.ranges[argument];
        let is_inside = |x: f64| lower.is_none_or(|lower| lower < x) && upper.is_none_or(|upper| x < upper);
        match (lower, upper) {
            (Some(lower), Some(upper)) if upper - lower <= f64::from(1 << TYPICAL_EXPONENT) => {
                lower + (upper - lower) * self.unit()
            }
            _ if is_inside(size) || is_inside(-size) => {
                let signed = self.sign() * size;
                if is_inside(signed) { signed } else { -signed }
            }
            (Some(lower), _) => lower + size,
            (None, Some(upper)) => upper - size,
            (None, None) => size,
        }
    }

    fn everywhere(&mut self) -> Vec<f64> {
        let width = self.width;
        let largest = width.largest();
        let ranges = self.edges.ranges.clone();
        let draw = |(lower, upper): (Option<f64>, Option<f64>)| {
            let from = width.ordinal(width.round(lower.unwrap_or(-largest)));
            let to = width.ordinal(width.round(upper.unwrap_or(largest)));
            let count = to.abs_diff(from) + 1;
            width.at(from.min(to).wrapping_add_unsigned(self.random.next() % count))
        };
        ranges.into_iter().map(draw).collect()
    }

    /// Returns a distance from a hard place: from half its size to below one unit in its last
    /// place.
    fn distance(&mut self, size: f64) -> f64 {
        let places = f64::from(self.width.mantissa() + 4);
        size * self.power_of_two(-places, -1.0)
    }

    /// Draws a point with one or several arguments close to an end of their range.
    fn at_an_end(
        &mut self,
        end: impl Fn(&(Option<f64>, Option<f64>)) -> Option<f64>,
        inward: f64,
    ) -> Option<Vec<f64>> {
        let ends: Vec<(usize, f64)> =
            self.edges.ranges.iter().enumerate().filter_map(|(at, range)| Some((at, end(range)?))).collect();
        if ends.is_empty() {
            return None;
        }
        let mut point = self.typical();
        let first = self.below(ends.len());
        for (place, &(argument, end)) in ends.iter().enumerate() {
            if place == first || self.below(4) == 0 {
                let size = if end == 0.0 { 1.0 } else { end.abs() };
                point[argument] = end + inward * self.distance(size);
            }
        }
        Some(point)
    }

    /// Draws a point where two vectors are nearly parallel.
    fn parallel(&mut self) -> Vec<f64> {
        let mut point = self.typical();
        let vectors = &self.edges.vectors[self.below(self.edges.vectors.len())];
        let ratio = self.sign() * self.power_of_two(-3.0, 3.0);
        let nearness = self.distance(1.0);
        for &(a, b) in vectors {
            point[b] = ratio * point[a] * (1.0 + self.sign() * nearness * (0.5 + self.unit()));
        }
        point
    }

    /// Draws a point where the arguments of groups are close to each other, or are moved away from
    /// zero together, or where two vectors are nearly parallel.
    fn coincident(&mut self) -> Option<Vec<f64>> {
        let (groups, vectors) = (!self.edges.groups.is_empty(), !self.edges.vectors.is_empty());
        if vectors && (!groups || self.coin()) {
            return Some(self.parallel());
        }
        if !groups {
            return None;
        }
        let groups = self.edges.groups.clone();
        let mut point = self.typical();
        let moves = self.below(3) == 0;
        let (all, chosen) = (self.coin(), self.below(groups.len()));
        let nearness = self.distance(1.0);
        for (place, group) in groups.iter().enumerate().filter(|&(place, _)| all || place == chosen) {
            if moves {
                let offset = self.sign() * self.power_of_two(4.0, f64::from(self.width.mantissa() - 4));
                group.iter().for_each(|&argument| point[argument] += offset);
                continue;
            }
            let target = groups[place][self.below(group.len())];
            let base = point[target];
            for &argument in group.iter().filter(|&&argument| argument != target) {
                if all || self.coin() {
                    point[argument] = base * (1.0 + self.sign() * nearness * (0.5 + self.unit()));
                }
            }
        }
        Some(point)
    }

    /// Draws a point with one argument close to a zero of a part of the formula.
    fn singular(&mut self) -> Option<Vec<f64>> {
        if self.edges.parts() == 0 || self.edges.ranges.is_empty() {
            return None;
        }
        let mut point = self.typical();
        let (part, argument) = (self.below(self.edges.parts()), self.below(point.len()));
        let grid = self.grid(argument);
        if grid.is_empty() {
            return None;
        }
        let zero =
            self.edges.zero(part, argument, &point, &grid).unwrap_or_else(|| grid[self.below(grid.len())]);
        let size = if zero == 0.0 { 1.0 } else { zero.abs() };
        point[argument] = zero + self.sign() * self.distance(size);
        Some(point)
    }

    /// Returns powers of two of both signs and zero, within the argument's range, in ascending
    /// order.
    fn grid(&mut self, argument: usize) -> Vec<f64> {
        let (lower, upper) = self.edges.ranges[argument];
        let shift = self.power_of_two(0.0, 1.0);
        let sizes = GRID_EXPONENTS.map(|exponent| shift * 2f64.powi(exponent));
        let mut grid: Vec<f64> = sizes.flat_map(|size| [-size, size]).chain([0.0]).collect();
        if let (Some(lower), Some(upper)) = (lower, upper) {
            grid.extend((1..32).map(|step| lower + (upper - lower) * f64::from(step) / 32.0));
        }
        grid.extend(lower.into_iter().chain(upper));
        grid.retain(|&x| lower.is_none_or(|lower| lower <= x) && upper.is_none_or(|upper| x <= upper));
        grid.sort_by(f64::total_cmp);
        grid.dedup();
        grid
    }

    /// Draws a point with some arguments multiplied by a large or a small number, if their range
    /// allows it.
    fn scaled(&mut self, direction: i32) -> Option<Vec<f64>> {
        let can_grow = |range: &(Option<f64>, Option<f64>)| match direction {
            1 => range.0.is_none() || range.1.is_none(),
            _ => range.0.is_none_or(|lower| lower <= 0.0) && range.1.is_none_or(|upper| upper >= 0.0),
        };
        let free: Vec<usize> =
            (0..self.edges.ranges.len()).filter(|&place| can_grow(&self.edges.ranges[place])).collect();
        if free.is_empty() {
            return None;
        }
        let mut point = self.typical();
        let reach = f64::from(self.width.largest_exponent() - TYPICAL_EXPONENT);
        let from = f64::from(TYPICAL_EXPONENT);
        // in half of the draws only up to the fourth root of the range, where squares and products
        // stay in range, and in some of these only up to where exponentials leave it
        let reach = match (self.coin(), self.below(3)) {
            (true, 0) => from + EXPONENTIAL_REACH,
            (true, _) => reach / 4.0,
            (false, _) => reach,
        };
        let factor = self.power_of_two(from, reach);
        let factor = if direction > 0 { factor } else { factor.recip() };
        let (all, first) = (self.coin(), self.below(free.len()));
        for (place, &argument) in free.iter().enumerate() {
            if all || place == first || self.below(3) == 0 {
                point[argument] *= factor;
            }
        }
        Some(point)
    }
}
