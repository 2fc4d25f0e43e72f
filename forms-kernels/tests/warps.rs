//! Warps compared with their densities: Pearson's chi-square test of samples in bins, and round
//! trips through the inverses.
//!
//! A warp maps the unit square to a domain. The domain is divided into bins; the integral of the
//! density over a bin, by the midpoint rule, gives the expected number of samples in it.

use forms_kernels as k;
use forms_testing::SplitMix;
use std::f64::consts::{PI, TAU};

/// Number of samples of each warp, from a sequence with a fixed seed.
const SAMPLES: usize = 20_000;
/// Number of bins along each coordinate, and of midpoints of the density in each bin along each
/// coordinate.
const BINS: usize = 16;
const MIDPOINTS: usize = 12;
/// Bins with fewer expected samples are counted together.
const FEWEST: f64 = 10.0;
/// Significance level: the probability that a test refuses a right density.
const SIGNIFICANCE: f64 = 1e-5;

/// Domain as the image of the unit square with a constant measure: the map from a point to the
/// square, and back.
struct Domain<const N: usize> {
    measure: f64,
    place: fn([f64; N]) -> [f64; 2],
    point: fn([f64; 2]) -> [f64; N],
}

/// Directions of the whole sphere, by the cosine and the azimuth.
const SPHERE: Domain<3> = Domain {
    measure: 4.0 * PI,
    place: |[x, y, z]| [(z + 1.0) / 2.0, (y.atan2(x) / TAU).rem_euclid(1.0)],
    point: |[a, b]| {
        let z = 2.0 * a - 1.0;
        let r = (1.0 - z * z).sqrt();
        [r * (TAU * b).cos(), r * (TAU * b).sin(), z]
    },
};

/// The square from (−1.15, −1.15) to (1.15, 1.15), so that no diagonal of bins is an edge of the
/// triangle.
const PLANE: Domain<2> =
    Domain { measure: 2.3 * 2.3, place: |p| p.map(|x| x / 2.3 + 0.5), point: |p| p.map(|x| 2.3 * (x - 0.5)) };

/// Distances from −2 to 6, and in addition a number from 0 to 1.
const LINE: Domain<2> = Domain {
    measure: 8.0,
    place: |[t, v]| [((t + 2.0) / 8.0).min(1.0), v],
    point: |[a, b]| [8.0 * a - 2.0, b],
};

impl<const N: usize> Domain<N> {
    /// Returns the p-value of samples: the probability of such a deviation from the density, or a
    /// larger one, for samples that have this density.
    fn p_value(&self, sample: impl Fn(f64, f64) -> [f64; N], pdf: impl Fn([f64; N]) -> f64) -> f64 {
        let mut counts = vec![0.0; BINS * BINS];
        let mut uniform = SplitMix(7);
        for _ in 0..SAMPLES {
            let place = (self.place)(sample(uniform.unit(), uniform.unit()));
            let [row, column] = place.map(|x| ((x * BINS as f64) as usize).min(BINS - 1));
            counts[row * BINS + column] += 1.0;
        }
        let fine = (BINS * MIDPOINTS) as f64;
        let expected = |bin: usize| -> f64 {
            let (row, column) = (bin / BINS * MIDPOINTS, bin % BINS * MIDPOINTS);
            let at = |i: usize| {
                let place = [row + i / MIDPOINTS, column + i % MIDPOINTS].map(|x| (x as f64 + 0.5) / fine);
                pdf((self.point)(place))
            };
            let sum: f64 = (0..MIDPOINTS * MIDPOINTS).map(at).sum();
            sum * self.measure / (fine * fine) * SAMPLES as f64
        };
        let bins: Vec<[f64; 2]> =
            counts.iter().enumerate().map(|(bin, &count)| [count, expected(bin)]).collect();
        chi_square(&bins)
    }

    fn agrees(&self, name: &str, sample: impl Fn(f64, f64) -> [f64; N], pdf: impl Fn([f64; N]) -> f64) {
        let p = self.p_value(sample, pdf);
        assert!(p > SIGNIFICANCE, "{name}: p = {p:e}");
    }
}

/// Returns the p-value of counts compared with the expected ones; small bins are taken together.
fn chi_square(bins: &[[f64; 2]]) -> f64 {
    let (small, large): (Vec<[f64; 2]>, Vec<[f64; 2]>) = bins.iter().partition(|bin| bin[1] < FEWEST);
    let together = small.iter().fold([0.0; 2], |sum, bin| [sum[0] + bin[0], sum[1] + bin[1]]);
    let bins: Vec<[f64; 2]> = large.into_iter().chain((together[1] >= FEWEST).then_some(together)).collect();
    let square = |[count, expected]: &[f64; 2]| (count - expected) * (count - expected) / expected;
    let statistic: f64 = bins.iter().map(square).sum();
    let freedom = (bins.len() - 1) as f64;
    // Wilson and Hilferty: the cube root of chi-square over the degrees of freedom is nearly
    // normal.
    let spread = 2.0 / (9.0 * freedom);
    let deviation = ((statistic / freedom).cbrt() - (1.0 - spread)) / spread.sqrt();
    upper_tail(deviation)
}

/// Returns the normal distribution's probability above x, by Simpson's rule up to where the density
/// vanishes.
fn upper_tail(x: f64) -> f64 {
    let (steps, end) = (4000, x.max(0.0) + 12.0);
    let width = (end - x) / steps as f64;
    let density = |i: usize| (-(x + i as f64 * width).powi(2) / 2.0).exp();
    let weight = |i: usize| if i == 0 || i == steps { 1.0 } else { 2.0 + 2.0 * (i % 2) as f64 };
    (0..=steps).map(|i| weight(i) * density(i)).sum::<f64>() * width / 3.0 / TAU.sqrt()
}

/// Asserts that the inverse maps samples back to their points in the square, within the rounding of
/// the sample.
fn comes_back<const N: usize>(
    name: &str,
    sample: impl Fn(f64, f64) -> [f64; N],
    inverse: impl Fn([f64; N]) -> [f64; 2],
) {
    let mut uniform = SplitMix(11);
    for _ in 0..1000 {
        let place = [uniform.unit(), uniform.unit()];
        let back = inverse(sample(place[0], place[1]));
        for (there, back) in place.iter().zip(back) {
            assert!((there - back).abs() < 1e-9, "{name}: {place:?} came back as {back}");
        }
    }
}

#[test]
fn directions_have_their_densities() {
    SPHERE.agrees("uniform_sphere", k::uniform_sphere_sample, |[x, y, z]| k::uniform_sphere_pdf(x, y, z));
    SPHERE.agrees("uniform_hemisphere", k::uniform_hemisphere_sample, |[x, y, z]| {
        k::uniform_hemisphere_pdf(x, y, z)
    });
    SPHERE.agrees("cosine_hemisphere", k::cosine_hemisphere_sample, |[x, y, z]| {
        k::cosine_hemisphere_pdf(x, y, z)
    });
    for g in [-0.6, 1e-9, 0.5] {
        let sample = |u, v| k::henyey_greenstein_direction_sample(g, u, v);
        let pdf = |[x, y, z]: [f64; 3]| k::henyey_greenstein_direction_pdf(g, x, y, z);
        SPHERE.agrees("henyey_greenstein_direction", sample, pdf);
    }
    for kappa in [1e-6, 3.0] {
        let sample = |u, v| k::von_mises_fisher_sample(kappa, u, v);
        let pdf = |[x, y, z]: [f64; 3]| k::von_mises_fisher_pdf(kappa, x, y, z);
        SPHERE.agrees("von_mises_fisher", sample, pdf);
    }
}

#[test]
fn normals_have_their_densities() {
    for alpha in [0.4, 1.0] {
        SPHERE.agrees("ggx", |u, v| k::ggx_sample(alpha, u, v), |[x, y, z]| k::ggx_pdf(alpha, x, y, z));
        SPHERE.agrees(
            "beckmann",
            |u, v| k::beckmann_sample(alpha, u, v),
            |[x, y, z]| k::beckmann_pdf(alpha, x, y, z),
        );
        let (wx, wy, wz) = (0.64, -0.48, 0.6);
        SPHERE.agrees(
            "ggx_visible",
            |u, v| k::ggx_visible_sample(alpha, wx, wy, wz, u, v),
            |[x, y, z]| k::ggx_visible_pdf(alpha, wx, wy, wz, x, y, z),
        );
    }
}

#[test]
fn polygons_have_their_densities() {
    SPHERE.agrees(
        "spherical_triangle",
        |u, v| k::spherical_triangle_sample(1.0, -2.0, 0.5, -0.5, 2.0, 1.0, -2.0, -1.0, 2.0, u, v),
        |[x, y, z]| k::spherical_triangle_pdf(1.0, -2.0, 0.5, -0.5, 2.0, 1.0, -2.0, -1.0, 2.0, x, y, z),
    );
    SPHERE.agrees(
        "spherical_rectangle",
        |u, v| k::spherical_rectangle_sample(-1.0, 2.0, 0.3, 3.0, 0.7, u, v),
        |[x, y, z]| k::spherical_rectangle_pdf(-1.0, 2.0, 0.3, 3.0, 0.7, x, y, z),
    );
}

#[test]
fn points_and_distances_have_their_densities() {
    PLANE.agrees("uniform_disk", k::uniform_disk_sample, |[p, q]| k::uniform_disk_pdf(p, q));
    PLANE.agrees("uniform_triangle", k::uniform_triangle_sample, |[p, q]| k::uniform_triangle_pdf(p, q));
    LINE.agrees(
        "equiangular",
        |u, v| [k::equiangular_sample(0.7, -1.0, 5.0, u), v],
        |[t, _]| k::equiangular_pdf(0.7, -1.0, 5.0, t),
    );
    LINE.agrees(
        "free_flight",
        |u, v| [k::free_flight_sample(2.0, u), v],
        |[t, _]| k::free_flight_pdf(2.0, t),
    );
}

#[test]
fn a_wrong_density_is_refused() {
    let hemisphere =
        SPHERE.p_value(k::cosine_hemisphere_sample, |[x, y, z]| k::uniform_hemisphere_pdf(x, y, z));
    assert!(hemisphere < SIGNIFICANCE);
    let forward = |u, v| k::henyey_greenstein_direction_sample(0.5, u, v);
    let other_way = SPHERE.p_value(forward, |[x, y, z]| k::henyey_greenstein_direction_pdf(-0.5, x, y, z));
    let nearly = SPHERE.p_value(forward, |[x, y, z]| k::henyey_greenstein_direction_pdf(0.6, x, y, z));
    assert!(other_way < SIGNIFICANCE && nearly < SIGNIFICANCE, "{other_way:e} {nearly:e}");
}

#[test]
fn warps_and_inverses_undo_each_other() {
    comes_back("uniform_sphere", k::uniform_sphere_sample, |[x, y, z]| k::uniform_sphere_inverse(x, y, z));
    comes_back("uniform_hemisphere", k::uniform_hemisphere_sample, |[x, y, z]| {
        k::uniform_hemisphere_inverse(x, y, z)
    });
    comes_back("cosine_hemisphere", k::cosine_hemisphere_sample, |[x, y, z]| {
        k::cosine_hemisphere_inverse(x, y, z)
    });
    comes_back("uniform_disk", k::uniform_disk_sample, |[p, q]| k::uniform_disk_inverse(p, q));
    comes_back("uniform_triangle", k::uniform_triangle_sample, |[p, q]| k::uniform_triangle_inverse(p, q));
    comes_back("ggx", |u, v| k::ggx_sample(0.3, u, v), |[x, y, z]| k::ggx_inverse(0.3, x, y, z));
    comes_back(
        "beckmann",
        |u, v| k::beckmann_sample(0.3, u, v),
        |[x, y, z]| k::beckmann_inverse(0.3, x, y, z),
    );
    comes_back(
        "ggx_visible",
        |u, v| k::ggx_visible_sample(0.3, 0.6, 0.0, 0.8, u, v),
        |[x, y, z]| k::ggx_visible_inverse(0.3, 0.6, 0.0, 0.8, x, y, z),
    );
    comes_back(
        "henyey_greenstein_direction",
        |u, v| k::henyey_greenstein_direction_sample(-0.7, u, v),
        |[x, y, z]| k::henyey_greenstein_direction_inverse(-0.7, x, y, z),
    );
    comes_back(
        "von_mises_fisher",
        |u, v| k::von_mises_fisher_sample(5.0, u, v),
        |[x, y, z]| k::von_mises_fisher_inverse(5.0, x, y, z),
    );
    comes_back(
        "free_flight",
        |u, v| [k::free_flight_sample(0.3, u), v],
        |[t, v]| [k::free_flight_inverse(0.3, t), v],
    );
}
