//! Random statements under conditions that vanish on strata.

use crate::tree::{Angle, Fold, Point, Tree};
use Tree::{Cos, Excess, Folded, Mean, Number, Plain, Sin, Turns};
use forms_testing::SplitMix;
use num_rational::Ratio;

/// left ≤ right
pub(crate) struct Condition(pub(crate) Tree, pub(crate) Tree);

/// Equation under conditions.
pub(crate) struct Statement {
    pub(crate) left: Tree,
    pub(crate) right: Tree,
    pub(crate) conditions: Vec<Condition>,
}

/// Pseudorandom numbers that depend only on the case.
pub(crate) struct Dice(SplitMix);

impl Dice {
    pub(crate) fn of(case: u64) -> Self {
        Dice(SplitMix(case.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ 0x1234_5678_9abc_def1))
    }

    /// Returns a number from 0 up to a bound.
    pub(crate) fn below(&mut self, bound: u64) -> u64 {
        self.0.next() % bound
    }

    fn among<T: Clone>(&mut self, choices: &[T]) -> T {
        choices[self.below(choices.len() as u64) as usize].clone()
    }

    fn angle(&mut self) -> Angle {
        let (of_x, of_z) = self.among(&[(1, 0), (1, 0), (0, 1), (1, 1), (1, -1), (2, 0), (2, 1)]);
        Angle { of_x, of_z, over: self.among(&[1, 1, 1, 2, 3]) }
    }

    /// Returns y, w, or a sum of small multiples of both and a number.
    fn linear(&mut self) -> Tree {
        match self.below(4) {
            0 => Plain(0),
            1 => Plain(1),
            2 => Plain(0).minus(Number(self.among(&[1, 2, -1]))),
            _ => Plain(0).plus(Number(self.among(&[1, -1, 2])).times(Plain(1))),
        }
    }

    /// Returns an expression that is never negative, and zero on a stratum.
    fn distance(&mut self) -> Tree {
        let angle = self.angle();
        let wave = if self.below(2) == 0 { Cos(angle) } else { Sin(angle) };
        match self.below(14) {
            12 => self.folded().squared(),
            13 => self.folded().abs(),
            0..3 => Number(1).plus(wave),
            3..5 => Number(1).minus(wave),
            5 => Number(1).minus(wave.squared()),
            6 => wave.abs(),
            7 => Number(1).plus(wave).sqrt(),
            8 => self.linear().squared(),
            9 => self.linear().abs(),
            10 => self.linear().squared().plus(self.linear().squared()),
            _ => {
                let linear = self.linear();
                linear.clone().exp().plus(linear.negated().exp()).minus(Number(2))
            }
        }
    }

    /// Returns a folded angle, or the multiple of π that folding removes.
    fn folded(&mut self) -> Tree {
        let fold = self.among(&[Fold::Acos, Fold::Asin, Fold::Atan, Fold::Atan2]);
        let angle = self.angle();
        if self.below(3) == 0 { Excess(fold, angle) } else { Folded(fold, angle) }
    }

    /// Returns an expression that is zero on a stratum, or on half of the space.
    fn parameter(&mut self) -> Tree {
        match self.below(4) {
            0 => self.distance(),
            1 => self.folded(),
            2 => self.linear(),
            _ => {
                let e = self.signed();
                e.clone().abs().minus(e)
            }
        }
    }

    /// Returns an expression that is always positive.
    fn positive(&mut self) -> Tree {
        let angle = self.angle();
        match self.below(5) {
            0 => Number(2).plus(Cos(angle)),
            1 => Number(3).minus(Sin(angle)),
            2 => Number(1).plus(self.linear().squared()),
            3 => Number(2).plus(Cos(angle)).sqrt(),
            _ => Number(2),
        }
    }

    /// Returns an expression whose sign matters.
    fn signed(&mut self) -> Tree {
        let angle = self.angle();
        match self.below(7) {
            0..3 => self.linear(),
            3 => Cos(angle),
            4 => Sin(angle),
            5 => Turns(angle),
            _ => self.linear().times(Cos(angle)),
        }
    }

    fn magnitude(&mut self, of: &Tree) -> Tree {
        if self.below(3) == 0 { of.clone().squared().sqrt() } else { of.clone().abs() }
    }

    /// Returns |e| p = ±e |p|, or an identity of half angles with one sign, or with terms that
    /// vanish on strata.
    fn sides(&mut self, e: &Tree) -> (Tree, Tree) {
        let p = self.positive();
        let signed = if self.below(3) == 0 { e.clone() } else { e.clone().negated() };
        match self.below(7) {
            0 => (self.magnitude(e), signed),
            6 => {
                let mean = Mean(Box::new(self.parameter()));
                match self.below(2) {
                    0 => (mean.clone().times(self.magnitude(e)), mean.times(signed)),
                    _ => (mean.clone().plus(self.magnitude(e)), mean.plus(signed)),
                }
            }
            1 | 2 => (self.magnitude(e).times(p.clone()), signed.times(p.abs())),
            3 => {
                let distance = self.distance();
                (self.magnitude(e).plus(distance.clone()), signed.plus(self.magnitude(&distance)))
            }
            4 => {
                let angle = self.angle();
                let half = Angle { over: angle.over * 2, ..angle };
                let root = Number(1).plus(Cos(angle)).sqrt();
                (
                    root.plus(self.magnitude(e)),
                    Number(2).sqrt().times(self.magnitude(&Cos(half))).plus(signed),
                )
            }
            _ => {
                let other = self.signed();
                let (a, b) = (self.magnitude(e).times(self.magnitude(&other)), signed.times(other));
                (a, if self.below(2) == 0 { b } else { b.negated() })
            }
        }
    }

    pub(crate) fn statement(&mut self) -> Statement {
        let e = self.signed();
        let (left, right) = self.sides(&e);
        let zero = Number(0);
        let mut conditions = Vec::new();
        for _ in 0..1 + self.below(3) {
            let distance = self.distance();
            conditions.push(match self.below(8) {
                0..3 => Condition(distance.times(e.clone()), zero.clone()),
                3 => Condition(distance.times(self.distance()).times(e.clone()), zero.clone()),
                4 => Condition(zero.clone(), distance.abs()),
                5 => Condition(distance, zero.clone()),
                6 => Condition(distance.times(self.signed()), zero.clone()),
                _ => Condition(self.signed(), Number(self.below(2) as i64)),
            });
        }
        if self.below(3) == 0 {
            conditions.push(Condition(e, zero));
        }
        Statement { left, right, conditions }
    }

    /// Returns a point, mostly at quarters and thirds of a turn and at small numbers.
    pub(crate) fn point(&mut self) -> Point {
        let turns = [
            (0, 1),
            (1, 1),
            (1, 1),
            (-1, 1),
            (1, 2),
            (-1, 2),
            (2, 1),
            (3, 1),
            (6, 1),
            (1, 3),
            (3, 2),
            (1, 4),
        ];
        let numbers = [(0, 1), (1, 1), (-1, 1), (2, 1), (-2, 1), (1, 2), (-1, 2), (3, 1)];
        let mut one = |of: &[(i64, i64)]| {
            let (p, q) = self.among(of);
            Ratio::new(p, q)
        };
        [one(&turns), one(&turns), one(&numbers), one(&numbers)]
    }
}

impl Statement {
    pub(crate) fn source(&self) -> String {
        format!("chart C(x, z, y, w); chart S(s); prove it: {self};")
    }

    /// Whether the sides differ at a point; `None` where this is not certain, or where the
    /// conditions do not certainly hold.
    pub(crate) fn differs_at(&self, point: &Point) -> Option<bool> {
        for Condition(left, right) in &self.conditions {
            if left.at(point)?.at_most(right.at(point)?) != Some(true) {
                return None;
            }
        }
        Some(self.left.at(point)?.differs(self.right.at(point)?))
    }
}

impl std::fmt::Display for Statement {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} == {}", self.left, self.right)?;
        for (place, Condition(left, right)) in self.conditions.iter().enumerate() {
            write!(f, "{} {left} <= {right}", if place == 0 { " where" } else { "," })?;
        }
        Ok(())
    }
}
