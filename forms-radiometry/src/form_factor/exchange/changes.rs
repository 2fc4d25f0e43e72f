//! Changes: the error of a sum of integrals, from the changes of its terms by their last refinement.
//!
//! ```text
//! error = min(Σ dᵢ, |Σ cᵢ| + 3 √Σ dᵢ²)
//! ```
//! cᵢ is a change, and dᵢ ≥ |cᵢ| the doubt about it: where parts of an integral change in different
//! directions, their sum can be small by chance.
//! Where the integrand is smooth, the changes have one sign, and the error is their sum. Where borders
//! of shadows pass through the patches, the changes are independent of each other and of both signs,
//! and most of them cancel: the error is then three standard deviations of their sum.

use super::Exchange;

/// Number of standard deviations.
const SPREAD: f64 = 3.0;

/// A sum of areas with their changes.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Changes {
    pub(crate) area: f64,
    /// Sum of the changes.
    signed: f64,
    /// Sum of the doubts, and of their squares.
    doubts: f64,
    squares: f64,
    /// Error of terms that do not change.
    certain: f64,
}

impl Changes {
    /// Adds a term with its change and doubt, parts of an independent change: the square of its
    /// doubt is divided equally among these parts.
    pub(crate) fn add(&mut self, area: f64, [change, doubt]: [f64; 2], parts: f64) {
        self.area += area;
        self.signed += change;
        self.doubts += doubt;
        self.squares += parts * doubt * doubt;
    }

    /// Takes back a term that was added.
    pub(crate) fn remove(&mut self, area: f64, [change, doubt]: [f64; 2], parts: f64) {
        self.area -= area;
        self.signed -= change;
        self.doubts -= doubt;
        self.squares -= parts * doubt * doubt;
    }

    /// Adds a term that is as accurate as it says.
    pub(crate) fn add_certain(&mut self, exchange: Exchange) {
        self.area += exchange.area;
        self.certain += exchange.error;
    }

    /// Returns the error of the sum.
    pub(crate) fn error(&self) -> f64 {
        let statistical = self.signed.abs() + SPREAD * self.squares.max(0.0).sqrt();
        self.certain + self.doubts.max(0.0).min(statistical)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use forms_testing::SplitMix;

    fn error(changes: impl Iterator<Item = f64>) -> f64 {
        let mut sum = Changes::default();
        changes.for_each(|change| sum.add(1.0, [change, change.abs()], 1.0));
        sum.error()
    }

    #[test]
    fn changes_of_one_sign_add_up() {
        assert!((error((0..100).map(|_| 1e-3)) - 0.1).abs() < 1e-12);
        assert!((error((0..100).map(|_| -1e-3)) - 0.1).abs() < 1e-12);
    }

    #[test]
    fn independent_changes_of_both_signs_are_within_the_error_of_their_sum() {
        let mut random = SplitMix(3);
        let mut exceeded = 0;
        for _ in 0..1000 {
            // the true value differs from the sum by the next changes, which are like these
            let mut changes: Vec<f64> = (0..400).map(|_| random.between([-1.0, 1.0])).collect();
            let next: f64 = changes.split_off(200).iter().sum();
            let found = error(changes.into_iter());
            exceeded += usize::from(next.abs() > found);
            assert!(found < 100.0, "{found}");
        }
        assert!(exceeded <= 5, "{exceeded}");
    }

    #[test]
    fn what_is_taken_back_leaves_nothing() {
        let mut sum = Changes::default();
        sum.add(2.0, [-0.5, 0.75], 4.0);
        sum.add_certain(Exchange { area: 1.0, error: 0.25 });
        sum.remove(2.0, [-0.5, 0.75], 4.0);
        assert_eq!((sum.area, sum.error()), (1.0, 0.25));
    }
}
