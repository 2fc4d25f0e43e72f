//! Basis forms dx₁∧…∧dxₖ as sets of coordinates, with the sign of the permutation that sorts a
//! product.

/// Largest number of coordinates that one file can declare.
pub const MAXIMUM_COORDINATES: usize = 128;

/// A coordinate by its number in the file, below `MAXIMUM_COORDINATES`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Coordinate(pub u8);

/// A basis form: the wedge of the differentials of a set of coordinates in ascending order.
///
/// ```
/// use forms_core::calculus::{Blade, Coordinate};
/// let (dx, dy) = (Blade::of(Coordinate(0)), Blade::of(Coordinate(1)));
/// let (dx_dy, forward) = dx.wedge(dy).unwrap();
/// let (dy_dx, backward) = dy.wedge(dx).unwrap();
/// assert_eq!((dx_dy, forward), (dy_dx, -backward)); // dx∧dy = −dy∧dx
/// assert!(dx.wedge(dx).is_none()); // dx∧dx = 0
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Blade(u128);

impl Blade {
    /// The empty product, 1.
    pub const SCALAR: Blade = Blade(0);

    /// Returns the differential dx of a coordinate.
    pub fn of(coordinate: Coordinate) -> Self {
        Blade(1 << coordinate.0)
    }

    /// Returns the number of differentials in the product.
    pub fn degree(self) -> u32 {
        self.0.count_ones()
    }

    /// Whether dx is one of its factors.
    pub fn contains(self, coordinate: Coordinate) -> bool {
        self.0 >> coordinate.0 & 1 == 1
    }

    /// Returns its coordinates in ascending order.
    pub fn coordinates(self) -> impl Iterator<Item = Coordinate> {
        let mut rest = self.0;
        std::iter::from_fn(move || {
            (rest != 0).then(|| {
                let lowest = rest.trailing_zeros() as u8;
                rest &= rest - 1;
                Coordinate(lowest)
            })
        })
    }

    /// Returns the product in ascending order and its sign; `None` if a differential occurs twice.
    pub fn wedge(self, other: Blade) -> Option<(Blade, i8)> {
        if self.0 & other.0 != 0 {
            return None;
        }
        Some((Blade(self.0 | other.0), self.sign_before(other)))
    }

    /// Contracts dx ⌟ in the first slot: returns the blade without dx, and (−1)^(number of factors
    /// before it).
    pub fn without(self, coordinate: Coordinate) -> Option<(Blade, i8)> {
        if !self.contains(coordinate) {
            return None;
        }
        let before = self.0 & ((1u128 << coordinate.0) - 1);
        let sign = if before.count_ones().is_multiple_of(2) { 1 } else { -1 };
        Some((Blade(self.0 & !(1 << coordinate.0)), sign))
    }

    /// Returns the differentials of `whole` that are not its factors.
    pub fn complement_in(self, whole: Blade) -> Blade {
        Blade(whole.0 & !self.0)
    }

    /// (−1)^(number of pairs i in self, j in other with i > j)
    fn sign_before(self, other: Blade) -> i8 {
        let mut swaps = 0;
        let mut shifted = self.0 >> 1;
        while shifted != 0 {
            swaps += (shifted & other.0).count_ones();
            shifted >>= 1;
        }
        if swaps % 2 == 0 { 1 } else { -1 }
    }
}
