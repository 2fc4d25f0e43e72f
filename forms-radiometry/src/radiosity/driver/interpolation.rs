//! Interpolation: computed values at some cells of a grid become the values of all cells. Cells
//! where the interpolation is not accurate are computed too.
//!
//! ```text
//! every 8th cell ─▶ every 4th ─▶ every 2nd ─▶ every cell           along both sides
//!      each new cell: interpolated from earlier cells by cubic polynomials;
//!                     computed where the interpolation was off nearby before
//! ```
//! The detail of a computed cell is its difference from the value interpolated from the earlier
//! cells. From spacing to spacing, details shrink sixteenfold where values are smooth, and by half
//! across a kink. So a cell whose neighbours had details within the allowed error is within it as
//! well, except at steps that are hardly higher than the allowed error. Some of the interpolated
//! cells are checked, and the cells around them are computed where one is off. Otherwise, a shadow
//! that falls between the cells of the second spacing would be missed.
//!
//! Source: D. L. Donoho, Interpolating wavelet transforms (1992).

use std::ops::RangeInclusive;

/// Spacing of the first cells.
const COARSEST: usize = 8;
/// Number of cells that a polynomial passes through.
const THROUGH: usize = 4;
/// One in this many interpolated cells is checked. Where the check fails, the cells up to this
/// distance are computed.
const CHECKED: usize = 16;
const AROUND: usize = 4;
/// Spreads the checked cells over the grid: 2⁶⁴ over the golden ratio.
const GOLDEN: u64 = 0x9e37_79b9_7f4a_7c15;

/// Function that computes some cells together, each in all bands; `gap` is the distance between
/// neighbours.
pub(crate) trait Compute: FnMut(&[usize], usize) -> Vec<f64> {}

impl<F: FnMut(&[usize], usize) -> Vec<f64>> Compute for F {}

/// Returns the values of all cells of a grid of `size` columns and rows, cell by cell and band by
/// band, each within the allowed error of its band; NaN in cells that are not requested.
pub(crate) fn interpolated(
    size: [usize; 2],
    is_asked: &[bool],
    allowed: &[f64],
    compute: impl Compute,
) -> Vec<f64> {
    let cells = size[0] * size[1];
    let state =
        is_asked.iter().map(|&is_asked| if is_asked { State::Open } else { State::Outside }).collect();
    let values = vec![f64::NAN; cells * allowed.len()];
    let mut field = Field { size, allowed, state, values, is_rough: vec![false; cells], compute };
    let [columns, rows] = size.map(spacings);
    let levels = columns.len().max(rows.len());
    let of = |axis: &[Vec<usize>], level: usize| axis[level.min(axis.len() - 1)].clone();
    let first = field.open(&of(&columns, 0), &of(&rows, 0));
    field.compute(&first, COARSEST);
    for level in 1..levels {
        let before = [of(&columns, level - 1), of(&rows, level - 1)];
        field.refine(before, [of(&columns, level), of(&rows, level)], level == 1);
    }
    field.check();
    field.values
}

/// State of a cell.
#[derive(Clone, Copy, PartialEq, Eq)]
enum State {
    Outside,
    Open,
    Computed,
    Interpolated,
}

/// Grid that is filled in step by step.
struct Field<'f, C> {
    size: [usize; 2],
    allowed: &'f [f64],
    state: Vec<State>,
    values: Vec<f64>,
    /// Whether a cell is near a cell where the interpolation was off.
    is_rough: Vec<bool>,
    compute: C,
}

/// Returns positions along a side, from coarse to fine. Each list contains the positions of the
/// list before and the midpoints of its gaps.
fn spacings(count: usize) -> Vec<Vec<usize>> {
    let last = count - 1;
    let gaps = last.div_ceil(COARSEST).max(1);
    let mut places: Vec<usize> = (0..=gaps).map(|gap| gap * last / gaps).collect();
    places.dedup();
    let mut spacings = vec![places];
    loop {
        let before = &spacings[spacings.len() - 1];
        let mut next: Vec<usize> =
            before.windows(2).flat_map(|pair| [pair[0], pair[0].midpoint(pair[1])]).collect();
        next.push(last);
        next.dedup();
        if next.len() == before.len() {
            return spacings;
        }
        spacings.push(next);
    }
}

/// Returns the positions, out of a sorted list, that the polynomial around a position passes
/// through, each with its weight.
fn told(places: &[usize], at: usize) -> impl Iterator<Item = (usize, f64)> {
    let beyond = places.partition_point(|&place| place < at);
    let first = beyond.saturating_sub(THROUGH / 2).min(places.len().saturating_sub(THROUGH));
    let nearest = &places[first..(first + THROUGH).min(places.len())];
    // Lagrange: ∏ (x − xⱼ)/(xᵢ − xⱼ) over j ≠ i
    nearest.iter().map(move |&own| {
        let others = nearest.iter().filter(move |&&other| other != own);
        let factor = |&other: &usize| (at as f64 - other as f64) / (own as f64 - other as f64);
        (own, others.map(factor).product())
    })
}

impl<C: Compute> Field<'_, C> {
    fn bands(&self) -> usize {
        self.allowed.len()
    }

    fn of(&self, cell: usize) -> &[f64] {
        &self.values[cell * self.bands()..][..self.bands()]
    }

    /// Returns the cells in these columns and rows that are not known yet.
    fn open(&self, columns: &[usize], rows: &[usize]) -> Vec<usize> {
        let cells = rows.iter().flat_map(|row| columns.iter().map(move |column| row * self.size[0] + column));
        cells.filter(|&cell| self.state[cell] == State::Open).collect()
    }

    fn compute(&mut self, cells: &[usize], gap: usize) {
        if cells.is_empty() {
            return;
        }
        let found = (self.compute)(cells, gap);
        let bands = self.bands();
        for (&cell, found) in cells.iter().zip(found.chunks_exact(bands)) {
            self.values[cell * bands..][..bands].copy_from_slice(found);
            self.state[cell] = State::Computed;
        }
    }

    /// Refines some columns and rows to more of them: first along columns, then along all rows.
    fn refine(
        &mut self,
        [columns, rows]: [Vec<usize>; 2],
        [all_columns, all_rows]: [Vec<usize>; 2],
        is_first: bool,
    ) {
        let width = self.size[0];
        let gap = |places: &[usize]| places.windows(2).map(|pair| pair[1] - pair[0]).max().unwrap_or(1);
        let gaps = [gap(&columns).div_ceil(2), gap(&rows).div_ceil(2)];
        let finer = gap(&all_columns).max(gap(&all_rows));
        let up = self.open(&columns, &all_rows).into_iter();
        let up: Vec<_> = up
            .map(|cell| {
                (cell, self.tell(told(&rows, cell / width).map(|(row, w)| (row * width + cell % width, w))))
            })
            .collect();
        self.settle(up, gaps, finer, is_first);
        let across = self.open(&all_columns, &all_rows).into_iter();
        let across: Vec<_> = across
            .map(|cell| {
                let row = cell - cell % width;
                (cell, self.tell(told(&columns, cell % width).map(|(column, w)| (row + column, w))))
            })
            .collect();
        self.settle(across, gaps, finer, is_first);
    }

    /// Returns the value interpolated from cells with these weights; NaN if a cell is outside.
    fn tell(&self, others: impl Iterator<Item = (usize, f64)>) -> Vec<f64> {
        let mut sums = vec![0.0; self.bands()];
        for (other, weight) in others {
            sums.iter_mut().zip(self.of(other)).for_each(|(sum, value)| *sum += weight * value);
        }
        sums
    }

    /// Accepts interpolated cells, or computes them where the interpolation may be off, gives no
    /// value, or where all details are requested.
    fn settle(&mut self, told: Vec<(usize, Vec<f64>)>, gaps: [usize; 2], finer: usize, are_all: bool) {
        let is_known = |values: &[f64]| values.iter().all(|value| !value.is_nan());
        let (taken, open): (Vec<_>, Vec<_>) = told
            .into_iter()
            .partition(|(cell, values)| !are_all && !self.is_rough[*cell] && is_known(values));
        let bands = self.bands();
        for (cell, values) in taken {
            self.values[cell * bands..][..bands].copy_from_slice(&values);
            self.state[cell] = State::Interpolated;
        }
        let cells: Vec<usize> = open.iter().map(|(cell, _)| *cell).collect();
        self.compute(&cells, finer);
        for (cell, values) in open {
            if is_known(&values) && self.is_off(cell, &values) {
                self.roughen(cell, gaps);
            }
        }
    }

    /// Whether a cell differs from some values by more than the allowed error.
    fn is_off(&self, cell: usize, values: &[f64]) -> bool {
        let pairs = self.of(cell).iter().zip(values).zip(self.allowed);
        pairs.into_iter().any(|((own, told), allowed)| (own - told).abs() > *allowed)
    }

    fn roughen(&mut self, cell: usize, [across, up]: [usize; 2]) {
        let [width, height] = self.size;
        let near = |place: usize, gap: usize, count: usize| -> RangeInclusive<usize> {
            place.saturating_sub(gap)..=(place + gap).min(count - 1)
        };
        for row in near(cell / width, up, height) {
            near(cell % width, across, width).for_each(|column| self.is_rough[row * width + column] = true);
        }
    }

    /// Computes some of the interpolated cells, and the cells around those that are off.
    fn check(&mut self) {
        let open = |field: &Self| -> Vec<usize> {
            (0..field.state.len()).filter(|&cell| field.state[cell] == State::Interpolated).collect()
        };
        let is_checked =
            |cell: &usize| ((*cell as u64).wrapping_mul(GOLDEN) >> 32).is_multiple_of(CHECKED as u64);
        let checked: Vec<usize> = open(self).into_iter().filter(is_checked).collect();
        let told: Vec<Vec<f64>> = checked.iter().map(|&cell| self.of(cell).to_vec()).collect();
        self.compute(&checked, CHECKED);
        self.is_rough.fill(false);
        for (&cell, told) in checked.iter().zip(&told) {
            if self.is_off(cell, told) {
                self.roughen(cell, [AROUND; 2]);
            }
        }
        let off: Vec<usize> = open(self).into_iter().filter(|&cell| self.is_rough[cell]).collect();
        self.compute(&off, 1);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: [usize; 2] = [67, 45];

    /// Returns the largest error over all cells for a function on the unit square, and the computed
    /// part of the cells.
    fn measured(allowed: f64, f: impl Fn(f64, f64) -> f64) -> [f64; 2] {
        let at = |cell: usize| {
            f((cell % SIZE[0]) as f64 / SIZE[0] as f64, (cell / SIZE[0]) as f64 / SIZE[1] as f64)
        };
        let cells = SIZE[0] * SIZE[1];
        let mut computed = 0;
        let found = interpolated(SIZE, &vec![true; cells], &[allowed], |cells: &[usize], _| {
            computed += cells.len();
            cells.iter().map(|&cell| at(cell)).collect()
        });
        let off = found.iter().enumerate().map(|(cell, value)| (value - at(cell)).abs());
        [off.fold(0.0, f64::max), computed as f64 / cells as f64]
    }

    #[test]
    fn cubic_polynomials_are_exact_from_one_cell_in_eight() {
        let [off, computed] = measured(1e-12, |x, y| (1.0 + x - 3.0 * x * x + x * x * x) * (2.0 - y * y * y));
        assert!(off < 1e-13 && computed < 0.16, "{off:e} {computed}");
    }

    #[test]
    fn cells_are_within_what_is_allowed_and_fewer_are_computed_where_more_is() {
        type Function = fn(f64, f64) -> f64;
        let functions: [(&str, Function); 4] = [
            ("waves", |x, y| (9.0 * x).sin() * (7.0 * y).cos()),
            ("a bend", |x, y| (x + 0.4 * y - 0.6).abs()),
            ("a step", |x, y| f64::from(u8::from(x * x + y * y < 0.5))),
            ("a corner", |x, y| (x * x + y * y + 1e-4).ln()),
        ];
        for (name, f) in functions {
            let mut before = 1.0;
            for allowed in [1e-5, 1e-4, 1e-3, 1e-2, 1e-1] {
                let [off, computed] = measured(allowed, f);
                assert!(off <= allowed, "{name} {allowed:e}: off by {off:e}");
                assert!(
                    computed <= before,
                    "{name} {allowed:e}: {computed} of all computed, {before} before"
                );
                before = computed;
            }
            assert!(before < 0.6, "{name}: {before} of all computed");
        }
    }

    #[test]
    fn every_cell_is_computed_where_nothing_is_allowed_or_the_grid_is_small() {
        let [off, computed] = measured(0.0, |x, y| (9.0 * x).sin() * (7.0 * y).cos());
        assert_eq!([off, computed], [0.0, 1.0]);
        for size in [[1, 1], [1, 7], [2, 3]] {
            let cells = size[0] * size[1];
            let each = |cells: &[usize], _| cells.iter().map(|&cell| (cell * cell) as f64).collect();
            let found = interpolated(size, &vec![true; cells], &[1e-3], each);
            let expected: Vec<f64> = (0..cells).map(|cell| (cell * cell) as f64).collect();
            assert!(found.iter().zip(&expected).all(|(a, b)| (a - b).abs() <= 1e-3), "{size:?}: {found:?}");
        }
    }

    #[test]
    fn cells_that_are_not_asked_for_are_not_computed_and_tell_nothing() {
        let is_asked: Vec<bool> = (0..SIZE[0] * SIZE[1]).map(|cell| cell % SIZE[0] < 40).collect();
        let found = interpolated(SIZE, &is_asked, &[1e-6], |cells: &[usize], _| {
            assert!(cells.iter().all(|&cell| is_asked[cell]));
            cells.iter().map(|&cell| (cell as f64).sin()).collect()
        });
        for (cell, value) in found.iter().enumerate() {
            let expected = (cell as f64).sin();
            let is_right = if is_asked[cell] { (value - expected).abs() <= 1e-6 } else { value.is_nan() };
            assert!(is_right, "{cell}: {value}");
        }
    }
}
