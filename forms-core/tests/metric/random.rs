//! Random metrics as texts: the entries, some of them off the diagonal, are small polynomials and
//! unknown functions.

use forms_testing::SplitMix;

pub(crate) const COORDINATES: [&str; 4] = ["x", "y", "z", "w"];

/// Symmetric matrix of texts.
pub(crate) struct Metric {
    pub(crate) entries: Vec<Vec<String>>,
}

impl Metric {
    /// Draws a metric of some dimension and signature.
    pub(crate) fn draw(random: &mut SplitMix, dimension: usize) -> Self {
        let mut lower: Vec<Vec<String>> = Vec::new();
        for size in 0..dimension {
            let mut row: Vec<String> =
                (0..size).map(|_| random.of(&["0", "0", "1", "x", "y", "f"]).to_string()).collect();
            let sign = random.of(&["", "", "-"]);
            row.push(format!("{sign}{}", random.of(&["1", "2", "(1 + x**2)", "(3 + x*x)", "f"])));
            lower.push(row);
        }
        let entry = |i: usize, j: usize| lower[i.max(j)][i.min(j)].clone();
        let entries = (0..dimension).map(|i| (0..dimension).map(|j| entry(i, j)).collect()).collect();
        Metric { entries }
    }

    pub(crate) fn dimension(&self) -> usize {
        self.entries.len()
    }

    /// Returns the declarations: chart, an unknown function, the metric g.
    pub(crate) fn preamble(&self) -> String {
        let n = self.dimension();
        let names = COORDINATES[..n].join(", ");
        let pairs = (0..n).flat_map(|i| (0..n).map(move |j| (i, j)));
        let term = |(i, j): (usize, usize)| {
            format!("({})*d{}*d{}", self.entries[i][j], COORDINATES[i], COORDINATES[j])
        };
        let terms: Vec<String> = pairs.map(term).collect();
        format!(
            "chart C({names}); fn f(x, y); fn p({names}); fn q({names}); metric g on C = {};",
            terms.join(" + ")
        )
    }

    /// Whether the determinant is zero everywhere.
    pub(crate) fn is_degenerate(&self) -> bool {
        !super::theory::errors(&self.preamble()).is_empty()
    }
}

/// Returns nondegenerate metrics of dimension 2 and 3, the same in every run.
pub(crate) fn metrics(count: usize) -> Vec<Metric> {
    let mut random = SplitMix(7);
    let drawn = (0..).map(|number| Metric::draw(&mut random, 2 + number % 2));
    drawn.filter(|metric| !metric.is_degenerate()).take(count).collect()
}

/// Returns every subset of k of n places, in ascending order.
pub(crate) fn subsets(n: usize, k: usize) -> Vec<Vec<usize>> {
    (0..1_u32 << n)
        .filter(|set| set.count_ones() as usize == k)
        .map(|set| (0..n).filter(|place| set >> place & 1 == 1).collect())
        .collect()
}

/// Returns dx∧dy as text; 1 for no factor.
pub(crate) fn blade(places: &[usize]) -> String {
    if places.is_empty() {
        return "1".into();
    }
    places.iter().map(|&place| format!("d{}", COORDINATES[place])).collect::<Vec<_>>().join("^")
}
