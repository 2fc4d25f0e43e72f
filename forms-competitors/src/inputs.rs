//! Arguments at which the kernels are compared: random, from a fixed seed, over ranges that occur
//! in scenes.

use forms_testing::SplitMix;

/// Random points and directions.
struct Random(SplitMix);

impl Random {
    /// Returns a uniform point of the cube from −size to size.
    fn point(&mut self, size: f64) -> [f64; 3] {
        [(); 3].map(|()| self.0.between([-size, size]))
    }

    /// Returns a uniform direction by Archimedes' theorem: its height is uniform.
    fn direction(&mut self) -> [f64; 3] {
        let (height, azimuth) = (self.0.between([-1.0, 1.0]), self.0.between([0.0, std::f64::consts::TAU]));
        let radius = (1.0 - height * height).sqrt();
        [radius * azimuth.cos(), radius * azimuth.sin(), height]
    }
}

/// Domain of a kernel's arguments.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Domain {
    /// u, v in the unit square and four corners around (0, 0, 3).
    Patch,
    /// Four points.
    Triangle,
    /// A point, a unit normal, a corner and two edges at right angles. The horizon can cut the
    /// rectangle.
    Rectangle,
    /// As above, seen from below with the normal up: the horizon does not cut.
    RectangleAbove,
    /// −0.95 < g < 0.95 and a cosine.
    Phase,
    /// −0.95 < g < 0.95 and 0 < u < 1.
    PhaseSample,
    /// 0.05 < α < 1, a direction and a normal of the upper hemisphere.
    Microfacets,
    /// A radiance, an extinction coefficient, a distance and an emission.
    Medium,
    /// Two points, each with a unit normal.
    TwoPoints,
}

impl Domain {
    fn arguments(self, random: &mut Random) -> Vec<f64> {
        let upper = |[x, y, z]: [f64; 3]| [x, y, z.abs()];
        match self {
            Domain::Patch => {
                let corners = [[-1.0, -1.0], [1.0, -1.0], [-1.0, 1.0], [1.0, 1.0]];
                let square = [random.0.between([0.0, 1.0]), random.0.between([0.0, 1.0])];
                let moved = corners.map(|[x, y]| {
                    let [dx, dy, dz] = random.point(0.5);
                    [x + dx, y + dy, 3.0 + dz]
                });
                [&square[..], moved.as_flattened()].concat()
            }
            Domain::Triangle => [(); 4].map(|()| random.point(2.0)).concat(),
            Domain::Rectangle => rectangle(random, random_point_and_normal),
            Domain::RectangleAbove => rectangle(random, |random| {
                ([0.0, 0.0, -8.0], {
                    let [x, y, z] = random.direction();
                    [0.2 * x, 0.2 * y, 1.0 + 0.2 * z]
                })
            }),
            Domain::Phase => vec![random.0.between([-0.95, 0.95]), random.0.between([-1.0, 1.0])],
            Domain::PhaseSample => vec![random.0.between([-0.95, 0.95]), random.0.between([0.0, 1.0])],
            Domain::Microfacets => {
                let (way, normal) = (upper(random.direction()), upper(random.direction()));
                [&[random.0.between([0.05, 1.0])][..], &way, &normal].concat()
            }
            Domain::Medium => [10.0, 2.0, 10.0, 5.0].map(|limit| random.0.between([0.01, limit])).to_vec(),
            Domain::TwoPoints => {
                [random.point(2.0), random.direction(), random.point(2.0), random.direction()].concat()
            }
        }
    }
}

fn random_point_and_normal(random: &mut Random) -> ([f64; 3], [f64; 3]) {
    (random.point(2.0), random.direction())
}

/// Returns an observer's point and normal, then a rectangle about the origin.
fn rectangle(random: &mut Random, observer: impl Fn(&mut Random) -> ([f64; 3], [f64; 3])) -> Vec<f64> {
    let (point, normal) = observer(random);
    let (a, b) = (random.direction(), random.direction());
    let across = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    let sides = [random.0.between([0.5, 2.0]), random.0.between([0.5, 2.0])];
    [point, normal, random.point(1.0), a.map(|x| sides[0] * x), across.map(|x| sides[1] * x)].concat()
}

/// Returns `count` random arguments, one column per argument.
pub fn columns(domain: Domain, count: usize) -> Vec<Vec<f64>> {
    let mut random = Random(SplitMix(0x5eed));
    let rows: Vec<Vec<f64>> = (0..count).map(|_| domain.arguments(&mut random)).collect();
    (0..rows[0].len()).map(|column| rows.iter().map(|row| row[column]).collect()).collect()
}
