//! Many independent sums of products: one for each basis form of a wedge product.

use super::super::Polynomial;
#[cfg(feature = "rayon")]
use rayon::prelude::*;

/// Number of products of terms from which several processors share the sums: it is some hundred
/// microseconds of work, compared with some ten to wake a thread.
#[cfg(feature = "rayon")]
const SHARED: usize = 1 << 15;

impl Polynomial {
    /// Returns Σ sₖ aₖ bₖ of each group, the same whether or not processors share the work.
    ///
    /// # Panics
    /// If an exponent of a product is beyond 2³¹ − 1.
    pub fn sums_of_products(groups: &[Vec<(i64, &Polynomial, &Polynomial)>]) -> Vec<Self> {
        let sum = |group: &Vec<_>| Self::sum_of_products(group);
        #[cfg(feature = "rayon")]
        if groups.len() > 1
            && groups.iter().map(|group| super::count_products(group)).sum::<usize>() >= SHARED
        {
            return groups.par_iter().map(sum).collect();
        }
        groups.iter().map(sum).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sums_of_groups_are_the_sums_of_each_whatever_the_work() {
        let sum = (0..4).fold(Polynomial::one(), |sum, index| sum.add(&Polynomial::variable(index)));
        for exponent in [0, 2, 5] {
            let factors: Vec<Polynomial> =
                (0..6).map(|index| sum.pow(exponent).add(&Polynomial::variable(index))).collect();
            let groups: Vec<Vec<_>> = (0..6)
                .map(|group| {
                    (0..4).map(|k| (k as i64 - 2, &factors[group], &factors[(group + k) % 6])).collect()
                })
                .collect();
            let sums = Polynomial::sums_of_products(&groups);
            let expected: Vec<Polynomial> = groups
                .iter()
                .map(|group| {
                    group
                        .iter()
                        .fold(Polynomial::zero(), |sum, &(sign, a, b)| sum.add(&a.mul(b).scale(&sign.into())))
                })
                .collect();
            assert_eq!(sums, expected);
        }
    }
}
