//! Arguments over all binades, uniformly distributed, and near points where a function is hard or
//! changes its method.

/// Pseudorandom number generator (SplitMix64).
pub(crate) struct Draw(pub(crate) u64);

impl Draw {
    pub(crate) fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }
    pub(crate) fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / 9_007_199_254_740_992.0
    }
    /// Returns a number with uniformly distributed value.
    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        (low / 2.0 + (high / 2.0 - low / 2.0) * self.unit()) * 2.0
    }
    /// Returns a number with uniformly distributed bit pattern: all binades are equally likely.
    pub(crate) fn of_any_binade(&mut self, low: f64, high: f64) -> f64 {
        let (from, to) = (i128::from(position(low)), i128::from(position(high)));
        at_position((from + (self.unit() * (to - from) as f64) as i128) as i64)
    }
    /// Returns a number a few representable numbers away.
    pub(crate) fn near(&mut self, place: f64) -> f64 {
        at_position(position(place) + (self.bits() % 2000) as i64 - 1000)
    }
}

/// Returns the index of a number among all numbers.
fn position(x: f64) -> i64 {
    let bits = x.to_bits() as i64;
    if bits < 0 { i64::MIN - bits } else { bits }
}

fn at_position(position: i64) -> f64 {
    let bits = if position < 0 { i64::MIN - position } else { position };
    f64::from_bits(bits as u64)
}

/// Returns points near which functions are hard: multiples of π/4 and of (ln 2)/2, and points where
/// methods change.
fn places() -> Vec<f64> {
    let multiples = (1..200_i32).chain([1000, 65_537, 600_001]).map(f64::from);
    let of = |unit: f64| multiples.clone().map(move |count| count * unit);
    let ends = [0.5, 1.0, 2.0, 3.0, 6.0, std::f64::consts::SQRT_2, std::f64::consts::FRAC_1_SQRT_2];
    let angles = [std::f64::consts::SQRT_2 - 1.0, std::f64::consts::SQRT_2 + 1.0];
    let mut all: Vec<f64> = of(std::f64::consts::FRAC_PI_4).collect();
    all.extend(of(std::f64::consts::LN_2 / 2.0));
    all.extend(ends.into_iter().chain(angles));
    all.iter().flat_map(|&x| [x, -x]).collect()
}

/// Returns `count` arguments from `low` to `high`.
pub(crate) fn arguments(low: f64, high: f64, count: usize, seed: u64) -> Vec<f64> {
    let mut draw = Draw(seed);
    let places: Vec<f64> = places().into_iter().filter(|&x| low < x && x < high).collect();
    let (inner_low, inner_high) = (low.max(-30.0), high.min(30.0));
    let mut out = vec![low, high];
    for index in 0..count {
        let x = match index % 4 {
            0 => draw.of_any_binade(low, high),
            1 => draw.between(low, high),
            2 => draw.between(inner_low, inner_high),
            _ => {
                let choice = draw.bits() as usize % places.len();
                draw.near(places[choice])
            }
        };
        out.push(x.clamp(low, high));
    }
    out
}
