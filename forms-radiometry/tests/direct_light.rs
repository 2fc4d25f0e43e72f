//! The exact direct irradiance, compared with an integration that shares no code with it: the
//! integrand L cos θ cos θ′/r² V over the lamp's area, with visibility V by rays against triangles
//! (Möller and Trumbore 1997).

use forms_radiometry::CORNELL_BOX;
use forms_radiometry::geometry::{Polygon, Vector};
use forms_radiometry::scene::{
    self, Effect, Force, ForcedEffect, Place, Receiver, ReceiverKind, Scene, Shape, Surface,
};
use forms_radiometry::simulation::{Answer, ErrorKind, Unwatched, plan, simulate};
use forms_testing::SplitMix;
use std::f64::consts::PI;

/// Nodes and weights of the Gauss–Legendre rule of order five on [0, 1].
const GAUSS: [(f64, f64); 5] = [
    (0.046_910_077_030_668, 0.118_463_442_528_095),
    (0.230_765_344_947_158, 0.239_314_335_249_683),
    (0.5, 0.284_444_444_444_444),
    (0.769_234_655_052_842, 0.239_314_335_249_683),
    (0.953_089_922_969_332, 0.118_463_442_528_095),
];

/// Direct irradiance of a point receiver, in each band.
struct Direct {
    receiver: String,
    irradiance: Vec<f64>,
    /// Irradiance without occlusion of the luminaires.
    unoccluded: Vec<f64>,
}

/// Returns the direct irradiance of every point receiver of a scene, in the order of the file.
fn direct(scene: &Scene) -> Vec<Direct> {
    let [occluded, unoccluded] = [Force::On, Force::Off].map(|occlusion| irradiances(scene, occlusion));
    let both = occluded.into_iter().zip(unoccluded);
    both.map(|((receiver, irradiance), (_, unoccluded))| Direct { receiver, irradiance, unoccluded })
        .collect()
}

/// Simulates the point receivers of a scene in all bands without interreflection.
fn irradiances(scene: &Scene, occlusion: Force) -> Vec<(String, Vec<f64>)> {
    let mut scene = scene.clone();
    scene.receivers.retain(|receiver| matches!(receiver.kind, ReceiverKind::Point { .. }));
    let forced =
        [(Effect::Bands, Force::On), (Effect::Occlusion, occlusion), (Effect::Interreflection, Force::Off)];
    let place = Place::default;
    scene.solve.forced = forced.map(|(effect, force)| ForcedEffect { effect, force, place: place() }).into();
    let plan = plan(&scene).unwrap_or_else(|errors| panic!("{}", errors[0]));
    let found = simulate(&plan, &Unwatched);
    let is_exact = |value: f64, error: f64| error <= 1e-12 * value;
    for answer in &found.answers {
        let is_bound = answer.kind == ErrorKind::Bound && is_exact(answer.value, answer.error);
        assert!(is_bound, "closed forms have no error but rounding: {answer:?}");
    }
    let of_receiver = found.answers.chunk_by(|a, b| a.receiver == b.receiver);
    let values = |answers: &[_]| answers.iter().map(|answer: &Answer| answer.value).collect();
    of_receiver.map(|answers| (answers[0].receiver.clone(), values(answers))).collect()
}

/// The parallelogram lamp of a scene, the triangles of all its surfaces, and a receiver.
struct Integration<'s> {
    corner: Vector,
    u: Vector,
    v: Vector,
    triangles: &'s [[Vector; 3]],
    position: Vector,
    normal: Vector,
    /// Number of subdivisions before the probes of a square are trusted.
    least_depth: u32,
    /// Largest number of subdivisions of a square.
    depth: u32,
}

/// An integral over the lamp and a bound on its error.
struct Estimate {
    value: f64,
    error: f64,
}

impl Integration<'_> {
    /// Returns cos θ cos θ′/r² dA/(du dv) at the point (u, v) of the lamp, zero below either
    /// horizon.
    fn integrand(&self, u: f64, v: f64) -> f64 {
        let to_lamp = self.lamp_point(u, v) - self.position;
        let r2 = to_lamp.dot(to_lamp);
        let area = self.u.cross(self.v);
        self.normal.dot(to_lamp).max(0.0) * (-area.dot(to_lamp)).max(0.0) / (r2 * r2)
    }

    fn lamp_point(&self, u: f64, v: f64) -> Vector {
        self.corner + u * self.u + v * self.v
    }

    fn visible(&self, u: f64, v: f64) -> bool {
        let ray = self.lamp_point(u, v) - self.position;
        self.normal.dot(ray) > 0.0
            && !self.triangles.iter().any(|triangle| blocks(triangle, self.position, ray))
    }

    /// Returns the integral without visibility over a square of the lamp.
    fn gauss(&self, u: f64, v: f64, side: f64) -> f64 {
        let points = GAUSS.iter().flat_map(|p| GAUSS.iter().map(move |q| (p, q)));
        let sum = points.map(|(p, q)| p.1 * q.1 * self.integrand(u + side * p.0, v + side * q.0));
        side * side * sum.sum::<f64>()
    }

    fn unoccluded(&self) -> f64 {
        let cells = (0..8).flat_map(|i| (0..8).map(move |j| (f64::from(i) / 8.0, f64::from(j) / 8.0)));
        cells.map(|(u, v)| self.gauss(u, v, 0.125)).sum()
    }

    /// Returns the integral with visibility. Squares are quartered until their corners and centre
    /// agree. A square that is undecided at the end counts one half, and one half is its error.
    fn occluded(&self, u: f64, v: f64, side: f64, depth: u32) -> Estimate {
        let probes = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0), (0.5, 0.5)];
        let seen = probes.iter().filter(|(s, t)| self.visible(u + side * s, v + side * t)).count();
        if depth >= self.least_depth && (seen == 0 || seen == probes.len()) {
            let value = if seen == 0 { 0.0 } else { self.gauss(u, v, side) };
            return Estimate { value, error: 0.0 };
        }
        if depth == self.depth {
            let half = 0.5 * self.gauss(u, v, side);
            return Estimate { value: half, error: half };
        }
        let mut sum = Estimate { value: 0.0, error: 0.0 };
        for (s, t) in [(0.0, 0.0), (0.5, 0.0), (0.0, 0.5), (0.5, 0.5)] {
            let part = self.occluded(u + side * s, v + side * t, 0.5 * side, depth + 1);
            sum = Estimate { value: sum.value + part.value, error: sum.error + part.error };
        }
        sum
    }
}

/// Whether a triangle meets the open segment from the origin to origin + ray.
fn blocks([a, b, c]: &[Vector; 3], origin: Vector, ray: Vector) -> bool {
    let (ab, ac) = (*b - *a, *c - *a);
    let p = ray.cross(ac);
    let determinant = ab.dot(p);
    if determinant == 0.0 {
        return false;
    }
    let from = origin - *a;
    let beta = from.dot(p) / determinant;
    let q = from.cross(ab);
    let gamma = ray.dot(q) / determinant;
    let along = ac.dot(q) / determinant;
    beta >= 0.0 && gamma >= 0.0 && beta + gamma <= 1.0 && along > 1e-9 && along < 1.0 - 1e-9
}

fn polygon_of(surface: &Surface) -> &Polygon {
    surface.shape.as_polygon().expect("the scene is made of polygons")
}

fn triangles(scene: &Scene) -> Vec<[Vector; 3]> {
    let fan = |vertices: &[Vector]| {
        let first = vertices[0];
        vertices[1..].windows(2).map(|edge| [first, edge[0], edge[1]]).collect::<Vec<_>>()
    };
    scene.surfaces.iter().flat_map(|surface| fan(polygon_of(surface).vertices())).collect()
}

/// Returns the Cornell box with more point receivers: a grid on the floor, some on the green wall,
/// and the centre of every face of the blocks.
fn box_with_more_points() -> Scene {
    let mut scene = scene::read(CORNELL_BOX, "cornell_box.toml").unwrap();
    let mut points = Vec::new();
    for x in [60.0, 280.0, 500.0] {
        for z in [70.0, 290.0, 520.0] {
            points.push((format!("floor {x} {z}"), Vector::new(x, 0.0, z), Vector::new(0.0, 1.0, 0.0)));
        }
    }
    for y in [60.0, 300.0] {
        for z in [120.0, 300.0, 500.0] {
            points.push((format!("green {y} {z}"), Vector::new(0.0, y, z), Vector::new(1.0, 0.0, 0.0)));
        }
    }
    for surface in scene.surfaces.iter().filter(|s| s.name.starts_with("short") || s.name.starts_with("tall"))
    {
        let [a, b, c, d] = polygon_of(surface).vertices() else { panic!("a face has four corners") };
        points.push((surface.name.clone(), 0.25 * ((*a + *b) + (*c + *d)), polygon_of(surface).normal()));
    }
    let receiver = |(name, position, normal)| Receiver {
        name,
        kind: ReceiverKind::Point { position, normal },
        time: None,
        place: Place::default(),
    };
    scene.receivers.extend(points.into_iter().map(receiver));
    scene
}

/// Calls `check` with every point receiver's name, its irradiance and unoccluded irradiance in the
/// sixth band, both divided by the lamp's radiance there, and the integration for it.
fn for_every_point(mut check: impl FnMut(&str, f64, f64, &Integration)) {
    let scene = box_with_more_points();
    let lamp = &scene.surfaces[0];
    let [a, b, _, d] = polygon_of(lamp).vertices() else { panic!("the lamp has four corners") };
    let triangles = triangles(&scene);
    let points = scene.receivers.iter().filter_map(|receiver| match receiver.kind {
        ReceiverKind::Point { position, normal } => Some((&receiver.name, position, normal)),
        _ => None,
    });
    let results = direct(&scene);
    assert_eq!(results.len(), 30);
    for ((name, position, normal), result) in points.zip(&results) {
        let integration = Integration {
            corner: *a,
            u: *b - *a,
            v: *d - *a,
            triangles: &triangles,
            position,
            normal,
            least_depth: 5,
            depth: 12,
        };
        let per_radiance = |irradiance: &[f64]| irradiance[5] / lamp.radiance[5];
        check(name, per_radiance(&result.irradiance), per_radiance(&result.unoccluded), &integration);
    }
}

#[test]
fn without_occlusion_the_irradiance_is_the_integral_over_the_lamp() {
    for_every_point(|name, _, unoccluded, integration| {
        let expected = integration.unoccluded();
        // Below the horizon the integrand has a kink, which a Gauss rule resolves only to second
        // order.
        let corners = [(0.0, 0.0), (0.0, 1.0), (1.0, 0.0), (1.0, 1.0)];
        let above =
            corners.map(|(u, v)| integration.normal.dot(integration.lamp_point(u, v) - integration.position));
        let straddles = above.iter().any(|&h| h > 0.0) && above.iter().any(|&h| h < 0.0);
        let tolerance = if straddles { 1e-3 } else { 1e-9 };
        assert!((unoccluded - expected).abs() <= tolerance * expected, "{name}: {unoccluded} and {expected}");
    });
}

#[test]
fn with_occlusion_the_irradiance_is_the_integral_over_what_is_visible() {
    let mut in_penumbra = 0;
    for_every_point(|name, irradiance, unoccluded, integration| {
        let Estimate { value, error } = integration.occluded(0.0, 0.0, 1.0, 0);
        assert!(error <= 1e-3 * unoccluded, "{name}: the integration is within {error} of {value} only");
        let difference = (irradiance - value).abs();
        assert!(difference <= error + 1e-9 * unoccluded, "{name}: {irradiance} and {value} ± {error}");
        in_penumbra += usize::from(irradiance > 0.01 * unoccluded && irradiance < 0.99 * unoccluded);
    });
    assert!(in_penumbra >= 5, "only {in_penumbra} of the points are in half-shadow");
}

/// Returns the scene with every point p moved to scale·p + shift.
fn moved(scene: &Scene, scale: f64, shift: Vector) -> Scene {
    let mut scene = scene.clone();
    for surface in &mut scene.surfaces {
        let vertices = polygon_of(surface).vertices().iter().map(|&v| scale * v + shift).collect();
        surface.shape = Shape::Polygon(Polygon::new(vertices).unwrap());
    }
    for receiver in &mut scene.receivers {
        if let ReceiverKind::Point { position, .. } = &mut receiver.kind {
            *position = scale * *position + shift;
        }
    }
    scene
}

#[test]
fn the_irradiance_depends_neither_on_the_unit_of_length_nor_on_the_origin() {
    let scene = box_with_more_points();
    let expected = direct(&scene);
    let cases = [
        ("metres", 1e-3, Vector::default(), 1e-13),
        ("very small", 1e-30, Vector::default(), 1e-13),
        ("very large", 1e30, Vector::default(), 1e-13),
        ("elsewhere", 1.0, Vector::new(1e4, -3e4, 2e4), 1e-9),
        ("far away", 1.0, Vector::new(1e7, -3e7, 2e7), 1e-6),
    ];
    for (name, scale, shift, tolerance) in cases {
        for (found, expected) in direct(&moved(&scene, scale, shift)).iter().zip(&expected) {
            let difference = (found.irradiance[5] - expected.irradiance[5]).abs();
            assert!(
                difference <= tolerance * expected.unoccluded[5],
                "{name}, {}: {difference}",
                found.receiver
            );
        }
    }
}

#[test]
fn lamps_add_up_and_the_back_of_a_one_sided_lamp_is_dark() {
    let scene = |lamps: &str| {
        let text = format!(
            "[[material]]\nname = \"black\"\nkind = \"diffuse\"\nreflectance = 0\n{lamps}\
             [[receiver]]\nname = \"up\"\nkind = \"point\"\nposition = [0.2, 0.3, 0]\nnormal = [0, 0, 1]\n"
        );
        let scene = scene::read(&text, "lamps.toml").unwrap_or_else(|errors| panic!("{}", errors[0]));
        direct(&scene)[0].irradiance[0]
    };
    let lamp = |name: &str, polygon: &str, two_sided: bool| {
        format!(
            "[[surface]]\nname = \"{name}\"\nmaterial = \"black\"\nradiance = 2\n\
             two_sided = {two_sided}\npolygon = {polygon}\n"
        )
    };
    let (down, up) = ("[[0,0,1], [0,1,1], [1,1,1], [1,0,1]]", "[[0,0,1], [1,0,1], [1,1,1], [0,1,1]]");
    let beside = "[[2,0,1], [2,1,1], [3,1,1], [3,0,1]]";
    let one = scene(&lamp("a", down, false));
    assert!(one > 0.5);
    assert_eq!(scene(&lamp("a", up, false)), 0.0, "turned away");
    assert!((scene(&lamp("a", up, true)) - one).abs() < 1e-15, "turned away, but two-sided");
    let other = scene(&lamp("b", beside, false));
    let both = scene(&(lamp("a", down, false) + &lamp("b", beside, false)));
    assert!(other > 0.01 && (both - one - other).abs() < 1e-15, "two lamps");
}

/// Returns the text of a scene with a lamp [−1, 1]² at height 1 that faces down, a receiver at the
/// origin with a random normal, and random triangles around both: in front of the lamp and through
/// its plane, below the horizon, and in front of each other.
fn random_scene(random: &mut impl FnMut() -> f64) -> String {
    let mut text = "[[material]]\nname = \"m\"\nkind = \"diffuse\"\nreflectance = 0\n".to_owned();
    let mut surface = |name: &str, radiance: f64, vertices: &[Vector]| {
        let vertices: Vec<[f64; 3]> = vertices.iter().map(|v| [v.x, v.y, v.z]).collect();
        text += &format!(
            "[[surface]]\nname = \"{name}\"\nmaterial = \"m\"\nradiance = {radiance}\npolygon = {vertices:?}\n"
        );
    };
    let lamp = [(-1.0, -1.0), (-1.0, 1.0), (1.0, 1.0), (1.0, -1.0)].map(|(x, y)| Vector::new(x, y, 1.0));
    surface("lamp", 1.0, &lamp);
    for i in 0..5 {
        let centre = Vector::new(random(), random(), 0.5 + random());
        let vertices = [0, 1, 2].map(|_| centre + Vector::new(random(), random(), random()));
        surface(&format!("triangle {i}"), 0.0, &vertices);
    }
    text + &format!(
        "[[receiver]]\nname = \"here\"\nkind = \"point\"\nposition = [0, 0, 0]\nnormal = [{}, {}, 1]\n",
        random(),
        random()
    )
}

#[test]
fn behind_random_triangles_the_irradiance_is_the_integral_over_what_is_visible() {
    let mut state = 88_172_645_463_325_252_u64;
    let mut random = move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    };
    let mut partly = 0;
    for i in 0..40 {
        let scene = scene::read(&random_scene(&mut random), "random.toml").unwrap();
        let ReceiverKind::Point { position, normal } = scene.receivers[0].kind else {
            panic!("a point is asked for")
        };
        let [a, b, _, d] = polygon_of(&scene.surfaces[0]).vertices() else {
            panic!("the lamp has four corners")
        };
        let triangles = triangles(&scene);
        let (u, v) = (*b - *a, *d - *a);
        let integration = Integration {
            corner: *a,
            u,
            v,
            triangles: &triangles,
            position,
            normal,
            least_depth: 6,
            depth: 10,
        };
        let Estimate { value, error } = integration.occluded(0.0, 0.0, 1.0, 0);
        let result = &direct(&scene)[0];
        let (found, whole) = (result.irradiance[0], result.unoccluded[0]);
        assert!((found - value).abs() <= error + 2e-3 * whole, "scene {i}: {found} and {value} ± {error}");
        partly += usize::from(found > 0.01 * whole && found < 0.99 * whole);
    }
    assert!(partly >= 20, "only {partly} lamps are partly hidden");
}

#[test]
fn a_point_of_a_surface_sees_the_whole_sky_and_nothing_of_the_surface() {
    let mut random = SplitMix(29);
    for index in 0..360 {
        let reflectance = [0.0, 0.5][index % 2];
        let sides = ["two_sided = false", "two_sided = true", "two_sided = true\nexitance = 50"][index % 3];
        // decimals, so that neither the point nor the normal is exact
        let mut tenths = || (random.between([-5.0, 5.0]) * 10.0).round() / 10.0;
        let [a, b, c]: [Vector; 3] = std::array::from_fn(|_| Vector::new(tenths(), tenths(), tenths()));
        let shown = |v: Vector| format!("[{:?}, {:?}, {:?}]", v.x, v.y, v.z);
        let (normal, point) = (shown((b - a).cross(c - a)), shown((1.0 / 3.0) * (a + b + c)));
        let polygon = [a, b, c].map(shown).join(", ");
        let text = format!(
            "[[material]]\nname = \"m\"\nkind = \"diffuse\"\nreflectance = {reflectance:?}\n[[surface]]\nname = \"s\"\n\
             material = \"m\"\npolygon = [{polygon}]\n{sides}\n[ambient]\nradiance = 100\n[[receiver]]\nname = \"p\"\n\
             kind = \"point\"\nposition = {point}\nnormal = {normal}\n",
        );
        let scene = scene::read(&text, "sky.toml").unwrap_or_else(|errors| panic!("{}", errors[0]));
        let plan = plan(&scene).unwrap_or_else(|errors| panic!("{}", errors[0]));
        let found = &simulate(&plan, &Unwatched).answers[0];
        let off = (found.value - 100.0 * PI).abs();
        assert!(off <= 1e-7 && found.error <= 0.1, "{index}, {reflectance}, {sides}: {found:?}");
    }
}
