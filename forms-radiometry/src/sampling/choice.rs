//! Discrete choices: a number selects one of several items with probabilities given by a running
//! sum.

/// Returns the share of each weight in the sum of all, and the running sums of these shares. Where
/// all weights are zero, so are the shares.
pub(crate) fn shares(weights: &[f64]) -> [Vec<f64>; 2] {
    let whole = weights.iter().sum::<f64>().max(f64::MIN_POSITIVE);
    let shares: Vec<f64> = weights.iter().map(|weight| weight / whole).collect();
    let mut sum = 0.0;
    let running = shares.iter().map(|share| {
        sum += share;
        sum
    });
    let running = running.collect();
    [shares, running]
}

/// Returns the index of the first running sum above a number; the last index if rounding leaves no
/// such sum, and `None` if there are no sums.
pub(crate) fn chosen(sums: &[f64], number: f64) -> Option<usize> {
    Some(sums.partition_point(|&sum| sum <= number).min(sums.len().checked_sub(1)?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_running_sums_of_shares_end_at_one() {
        assert_eq!(shares(&[1.0, 0.0, 3.0]), [vec![0.25, 0.0, 0.75], vec![0.25, 0.25, 1.0]]);
        assert_eq!(shares(&[0.0, 0.0]), [vec![0.0, 0.0], vec![0.0, 0.0]]);
        assert_eq!(shares(&[]), [[0.0; 0]; 2]);
    }

    #[test]
    fn a_number_chooses_the_thing_in_whose_part_it_lies() {
        let sums = [0.25, 0.25, 1.0];
        let cases = [(0.0, 0), (0.2, 0), (0.25, 2), (0.9, 2), (1.0, 2)];
        cases.into_iter().for_each(|(number, place)| assert_eq!(chosen(&sums, number), Some(place)));
        assert_eq!(chosen(&[], 0.5), None);
    }
}
