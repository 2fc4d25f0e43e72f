//! Random metrics as texts: entries are small polynomials and unknown functions, some off the diagonal.

/// SplitMix64
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn below(&mut self, bound: u64) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) % bound) as usize
    }

    fn pick<'a>(&mut self, from: &[&'a str]) -> &'a str {
        from[self.below(from.len() as u64)]
    }
}

pub(crate) const COORDINATES: [&str; 4] = ["x", "y", "z", "w"];

/// A symmetric matrix of texts.
pub(crate) struct Metric {
    pub(crate) entries: Vec<Vec<String>>,
}

impl Metric {
    /// A metric of some dimension and signature.
    pub(crate) fn draw(random: &mut Random, dimension: usize) -> Self {
        let mut entries = vec![vec!["0".to_string(); dimension]; dimension];
        for i in 0..dimension {
            let sign = random.pick(&["", "", "-"]);
            let size = random.pick(&["1", "2", "(1 + x**2)", "(3 + x*x)", "f"]);
            entries[i][i] = format!("{sign}{size}");
            for j in 0..i {
                let entry = random.pick(&["0", "0", "1", "x", "y", "f"]).to_string();
                entries[i][j].clone_from(&entry);
                entries[j][i] = entry;
            }
        }
        Metric { entries }
    }

    pub(crate) fn dimension(&self) -> usize {
        self.entries.len()
    }

    /// The declarations: chart, an unknown function, the metric g.
    pub(crate) fn preamble(&self) -> String {
        let n = self.dimension();
        let names = COORDINATES[..n].join(", ");
        let mut terms = Vec::new();
        for i in 0..n {
            terms.push(format!("{}*d{}**2", self.entries[i][i], COORDINATES[i]));
            for j in 0..i {
                terms.push(format!("2*({})*d{}*d{}", self.entries[i][j], COORDINATES[i], COORDINATES[j]));
            }
        }
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

/// Metrics that are not degenerate, of dimension 2 and 3, the same in every run.
pub(crate) fn metrics(count: usize) -> Vec<Metric> {
    let mut random = Random(7);
    let drawn = (0..).map(|number| Metric::draw(&mut random, 2 + number % 2));
    drawn.filter(|metric| !metric.is_degenerate()).take(count).collect()
}

/// Every ordered choice of k of n places in ascending order.
pub(crate) fn subsets(n: usize, k: usize) -> Vec<Vec<usize>> {
    (0..1_u32 << n)
        .filter(|set| set.count_ones() as usize == k)
        .map(|set| (0..n).filter(|place| set >> place & 1 == 1).collect())
        .collect()
}

/// dx∧dy as text; 1 for no factor.
pub(crate) fn blade(places: &[usize]) -> String {
    if places.is_empty() {
        return "1".into();
    }
    places.iter().map(|&place| format!("d{}", COORDINATES[place])).collect::<Vec<_>>().join("^")
}
