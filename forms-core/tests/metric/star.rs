//! Hodge star against its slow definition by sums over permutations, and the effect of an error in
//! either: (⋆dx_I)_J = √|det g| Σ_K ε(K, J) det(gⁱʲ; i ∈ K, j ∈ I), with gⁱʲ the cofactor over the
//! determinant.

use super::random::{Metric, blade, metrics, subsets};
use super::theory::{assert_proved, is_refuted};

/// Errors in the definition.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Slip {
    None,
    /// ε(K, J) = 1
    SignLost,
    /// det g instead of √|det g|
    RootMissing,
    /// gᵢⱼ instead of gⁱʲ
    IndicesNotRaised,
    /// √|det g| omitted
    DensityMissing,
    /// ε(J, K) instead of ε(K, J)
    OrderExchanged,
}

/// Returns every permutation of 0..n with its sign.
fn permutations(n: usize) -> Vec<(Vec<usize>, i8)> {
    if n == 0 {
        return vec![(vec![], 1)];
    }
    let mut all = Vec::new();
    for (shorter, sign) in permutations(n - 1) {
        for place in 0..n {
            let mut longer = shorter.clone();
            longer.insert(place, n - 1);
            let moved = if (n - 1 - place).is_multiple_of(2) { sign } else { -sign };
            all.push((longer, moved));
        }
    }
    all
}

/// Returns Σ_σ sgn σ ∏ m(rowᵢ, column_σ(i)).
fn determinant(rows: &[usize], columns: &[usize], entry: &impl Fn(usize, usize) -> String) -> String {
    let terms = permutations(rows.len()).into_iter().map(|(order, sign)| {
        let factors: Vec<String> =
            rows.iter().zip(order).map(|(&row, place)| format!("({})", entry(row, columns[place]))).collect();
        let product = if factors.is_empty() { "1".into() } else { factors.join("*") };
        format!("{}{product}", if sign < 0 { "- " } else { "+ " })
    });
    format!("(0 {})", terms.collect::<Vec<_>>().join(" "))
}

/// Returns ε of a sequence of distinct numbers.
fn epsilon(sequence: &[usize]) -> i8 {
    let inversions = (0..sequence.len())
        .flat_map(|i| (i + 1..sequence.len()).map(move |j| (i, j)))
        .filter(|&(i, j)| sequence[i] > sequence[j])
        .count();
    if inversions % 2 == 0 { 1 } else { -1 }
}

/// Returns ⋆dx_I by the definition.
fn slow_star(metric: &Metric, blade_places: &[usize], slip: Slip) -> String {
    let n = metric.dimension();
    let all: Vec<usize> = (0..n).collect();
    let entry = |i: usize, j: usize| metric.entries[i][j].clone();
    let whole = determinant(&all, &all, &entry);
    let inverse = |i: usize, j: usize| {
        let without = |skipped: usize| all.iter().copied().filter(|&k| k != skipped).collect::<Vec<_>>();
        let cofactor = determinant(&without(j), &without(i), &entry);
        format!("{}{cofactor}/{whole}", if (i + j).is_multiple_of(2) { "" } else { "-" })
    };
    let density = match slip {
        Slip::RootMissing => whole.clone(),
        Slip::DensityMissing => "1".into(),
        _ => format!("sqrt(abs({whole}))"),
    };
    let mut terms = Vec::new();
    for rest in subsets(n, n - blade_places.len()) {
        for raised in subsets(n, blade_places.len()) {
            let sequence: Vec<usize> = match slip {
                Slip::OrderExchanged => rest.iter().chain(&raised).copied().collect(),
                _ => raised.iter().chain(&rest).copied().collect(),
            };
            let distinct = all.iter().all(|place| sequence.contains(place));
            if !distinct {
                continue;
            }
            let sign = if slip == Slip::SignLost { 1 } else { epsilon(&sequence) };
            let minor = match slip {
                Slip::IndicesNotRaised => determinant(&raised, blade_places, &entry),
                _ => determinant(&raised, blade_places, &inverse),
            };
            let sign = if sign < 0 { "-" } else { "" };
            terms.push(format!("{sign}{density}*{minor}*{}", blade(&rest)));
        }
    }
    terms.join(" + ")
}

#[test]
fn the_star_is_the_sum_over_permutations() {
    for metric in metrics(10) {
        for degree in 0..=metric.dimension() {
            for places in subsets(metric.dimension(), degree) {
                let star = format!("hodge[g]({})", blade(&places));
                assert_proved(&metric.preamble(), &star, &slow_star(&metric, &places, Slip::None));
            }
        }
    }
}

/// Whether some star of some metric differs from the wrong definition.
fn is_seen(slip: Slip) -> bool {
    metrics(10).iter().any(|metric| {
        (1..=metric.dimension()).any(|degree| {
            subsets(metric.dimension(), degree).iter().any(|places| {
                let star = format!("hodge[g]({})", blade(places));
                is_refuted(&metric.preamble(), &star, &slow_star(metric, places, slip))
            })
        })
    })
}

#[test]
fn a_lost_sign_in_the_star_is_seen() {
    assert!(is_seen(Slip::SignLost));
}

#[test]
fn a_determinant_without_its_root_is_seen() {
    assert!(is_seen(Slip::RootMissing));
}

#[test]
fn indices_that_are_not_raised_are_seen() {
    assert!(is_seen(Slip::IndicesNotRaised));
}

#[test]
fn a_missing_density_is_seen() {
    assert!(is_seen(Slip::DensityMissing));
}

#[test]
fn an_exchanged_order_is_seen() {
    assert!(is_seen(Slip::OrderExchanged));
}
