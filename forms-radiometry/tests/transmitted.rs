//! Light through a medium that only absorbs: its amount at points is computed, and no reported
//! error is less than the true one.

use forms_kernels::slab_transmittance;
use forms_radiometry::geometry::Vector;
use forms_radiometry::scene::{Scene, read};
use forms_radiometry::simulation::{Answer, ErrorKind, Simulation, Unwatched, plan, simulate};
use forms_testing::scene_text::{Point, material, point_receiver, polygon, surface, tolerance};
use std::f64::consts::PI;

/// Rounding error of the second method, relative to the fluence rate.
const ROUNDING: f64 = 1e-11;

/// Sequence of a linear congruential generator, with numbers from 0 to 1.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }

    /// Returns a number whose logarithm is uniformly distributed.
    fn of_any_size(&mut self, low: f64, high: f64) -> f64 {
        low * (high / low).powf(self.next())
    }
}

/// Rectangle in a plane of constant z: its ends in x, and its ends in y.
type Rectangle = [[f64; 2]; 2];

fn corners([[left, right], [front, back]]: Rectangle, height: f64) -> [Point; 4] {
    [[left, front, height], [right, front, height], [right, back, height], [left, back, height]]
}

fn common(a: Rectangle, b: Rectangle) -> Option<Rectangle> {
    let both = |axis: usize| [a[axis][0].max(b[axis][0]), a[axis][1].min(b[axis][1])];
    let found = [both(0), both(1)];
    found.iter().all(|[low, high]| low < high).then_some(found)
}

/// Returns ∫ e^(−σ r) dω and ∫ ω e^(−σ r) dω over the directions from the origin to a rectangle, as
/// integrals along its boundary: with the distance ρ from the foot of the height h, r² = h² + ρ²
/// and the angle φ around the foot
///
/// ```text
/// ∫ e^(−σ r) dω    = ∮ (E₂(σ h) − h/r E₂(σ r)) dφ
/// ∫ ω e^(−σ r) dω  = ∮ (E₃(σ h) − h²/r² E₃(σ r)) dφ across the plane,
///                    and −∮ h/r² E₃(σ r) n ds in it, n outwards
/// ```
/// These follow from d(E₂(σ r)/r)/dr = −e^(−σ r)/r² and d(E₃(σ r)/r²)/dr = −e^(−σ r)/r³ by Gauss's
/// theorem.
fn by_border(rectangle: Rectangle, height: f64, extinction: f64) -> [f64; 4] {
    const PIECES: usize = 500;
    let third = |x: f64| 0.5 * slab_transmittance(x);
    let second = |x: f64| ((-x).exp() - 2.0 * third(x)) / x;
    let rule = [(0.5 - 0.15_f64.sqrt(), 5.0 / 18.0), (0.5, 8.0 / 18.0), (0.5 + 0.15_f64.sqrt(), 5.0 / 18.0)];
    let outline = corners(rectangle, height);
    let mut sums = [0.0; 4];
    for (place, &[ax, ay, _]) in outline.iter().enumerate() {
        let [bx, by, _] = outline[(place + 1) % 4];
        let [dx, dy] = [bx - ax, by - ay].map(|d| d / PIECES as f64);
        for piece in 0..PIECES {
            for (at, weight) in rule {
                let [x, y] = [ax + (piece as f64 + at) * dx, ay + (piece as f64 + at) * dy];
                let aside = x * x + y * y;
                let distance = (aside + height * height).sqrt();
                let ratio = height / distance;
                let angle = weight * (x * dy - y * dx) / aside;
                let [here, below] = [extinction * distance, extinction * height];
                sums[0] += angle * (second(below) - ratio * second(here));
                let across = weight * third(here) * height / (distance * distance);
                sums[1] -= across * dy;
                sums[2] += across * dx;
                sums[3] += angle * (third(below) - ratio * ratio * third(here));
            }
        }
    }
    sums
}

/// A lamp, a screen in a parallel plane between it and the origin, and axes that rotate the scene.
struct Random {
    lamp: Rectangle,
    height: f64,
    screen: Rectangle,
    screen_height: f64,
    extinction: f64,
    axes: [Vector; 3],
}

impl Random {
    fn new(numbers: &mut Numbers) -> Self {
        let height = numbers.of_any_size(0.05, 5.0);
        let screen_height = height * numbers.between(0.2, 0.9);
        let rectangle = |numbers: &mut Numbers, scale: f64| -> Rectangle {
            [(); 2].map(|()| {
                let low = scale * numbers.between(-1.5, 0.6);
                [low, low + scale * numbers.of_any_size(0.01, 1.5)]
            })
        };
        let lamp = rectangle(numbers, 1.0);
        let screen = rectangle(numbers, screen_height / height);
        let extinction = numbers.of_any_size(0.1, 60.0);
        let mut direction = || Vector::new(1.0, 0.0, 0.0) + numbers.next() * Vector::new(-2.0, 1.0, 0.5);
        let along = direction().unit().expect("a direction");
        let up = along.cross(Vector::new(0.3, direction().x, 0.7)).unit().expect("another direction");
        Self { lamp, height, screen, screen_height, extinction, axes: [along, up.cross(along), up] }
    }

    fn place(&self, [x, y, z]: Point) -> Point {
        let [u, v, w] = self.axes;
        let place = x * u + y * v + z * w;
        [place.x, place.y, place.z]
    }

    fn text(&self, more: &str, tolerance: f64) -> String {
        let mut down = corners(self.lamp, self.height).map(|corner| self.place(corner));
        down.reverse();
        let screen = corners(self.screen, self.screen_height).map(|corner| self.place(corner));
        let receiver = |name: &str, normal: Point| point_receiver(name, [0.0; 3], self.place(normal));
        [
            format!(
                "[[medium]]\nname = \"smoke\"\nsigma_a = {:?}\n[ambient]\nmedium = \"smoke\"\n",
                self.extinction
            ),
            material("black", 0.0),
            surface("lamp", "black", &format!("{}\nradiance = 2", polygon(&down))),
            surface("screen", "black", &polygon(&screen)),
            receiver("up", [0.0, 0.0, 1.0]),
            receiver("aside", [1.0, 0.0, 0.0]),
            "[[receiver]]\nname = \"ball\"\nkind = \"sphere\"\nposition = [0, 0, 0]\n".to_owned(),
            more.to_owned(),
            self::tolerance(tolerance),
        ]
        .concat()
    }

    /// Returns the exact answers in their order: upwards, aside, the fluence rate and vector
    /// irradiance.
    fn truth(&self) -> [f64; 6] {
        let moved = self.screen.map(|side| side.map(|end| end * self.height / self.screen_height));
        let of_part = |part: Rectangle| {
            let shadow = common(part, moved)
                .map_or([0.0; 4], |shadow| by_border(shadow, self.height, self.extinction));
            let whole = by_border(part, self.height, self.extinction);
            [0, 1, 2, 3].map(|place| 2.0 * (whole[place] - shadow[place]))
        };
        let [fluence, x, y, z] = of_part(self.lamp);
        let right = common(self.lamp, [[0.0, f64::INFINITY], [f64::NEG_INFINITY, f64::INFINITY]]);
        let aside = right.map_or(0.0, |part| of_part(part)[1]);
        let [vx, vy, vz] = self.place([-x, -y, -z]);
        [z, aside, fluence, vx, vy, vz]
    }
}

fn scene(text: &str) -> Scene {
    read(text, "transmitted.toml").unwrap_or_else(|errors| panic!("{}\n{text}", errors[0]))
}

fn simulated(text: &str) -> Simulation {
    let scene = scene(text);
    simulate(&plan(&scene).unwrap_or_else(|errors| panic!("{}", errors[0])), &Unwatched)
}

/// A mirror that is not visible from anywhere: with it, the scene is path traced.
const MIRROR: &str = "[[material]]\nname = \"silver\"\nkind = \"mirror\"\nreflectance = 0.5\n\
                      [[surface]]\nname = \"mirror\"\nmaterial = \"silver\"\n\
                      polygon = [[90, 0, 0], [90, 1, 0], [91, 1, 0], [91, 0, 0]]\n";

#[test]
fn no_error_that_is_told_is_less_than_the_true_one() {
    let mut numbers = Numbers(6);
    let mut lit = 0;
    for number in 0..64 {
        let random = Random::new(&mut numbers);
        let truth = random.truth();
        let rounding = ROUNDING * 4.0 * PI * (-random.extinction * random.height).exp();
        for tolerance in [1e-1, 1e-3, 1e-8] {
            let answers = simulated(&random.text("", tolerance)).answers;
            assert_eq!(answers.len(), truth.len());
            for (answer, truth) in answers.iter().zip(truth) {
                let off = (answer.value - truth).abs();
                assert!(off <= answer.error + rounding, "{number}, {tolerance}: {answer:?} is {truth:e}");
                assert_ne!(answer.kind, ErrorKind::Sigma);
                assert_eq!(answer.parts.sampling, 0.0);
            }
            let scale = answers[2].value;
            assert!(answers[2].error <= 1e-2 * tolerance * scale, "{number}, {tolerance}: {:?}", answers[2]);
            lit += usize::from(truth[0] > 1e-3 * truth[2] && scale > 0.0);
        }
    }
    assert!(lit > 100, "{lit}");
}

#[test]
fn paths_find_the_same() {
    let mut numbers = Numbers(11);
    for number in 0..12 {
        let random = Random::new(&mut numbers);
        let computed = simulated(&random.text("", 1e-3)).answers;
        let sampled = simulated(&random.text(MIRROR, 2e-2)).answers;
        for (computed, sampled) in computed.iter().zip(&sampled) {
            assert_eq!([computed.kind, sampled.kind].map(|kind| kind == ErrorKind::Sigma), [false, true]);
            let off = (computed.value - sampled.value).abs();
            assert!(off <= 4.0 * sampled.error + computed.error, "{number}: {computed:?}, {sampled:?}");
        }
    }
}

/// Returns a point below a wide plate of radiance 1 at the height 1, in a medium of this optical
/// thickness.
fn below_a_plate(thickness: f64, half: f64, more: &str) -> String {
    let mut plate = corners([[-half, half]; 2], 1.0);
    plate.reverse();
    [
        format!("[[medium]]\nname = \"smoke\"\nsigma_a = {thickness:?}\n[ambient]\nmedium = \"smoke\"\n"),
        material("black", 0.0),
        surface("plate", "black", &format!("{}\nradiance = 1", polygon(&plate))),
        point_receiver("below", [0.0; 3], [0.0, 0.0, 1.0]),
        more.to_owned(),
    ]
    .concat()
}

#[test]
fn a_wide_slab_transmits_two_exponential_integrals() {
    for thickness in [1e-3, 1e-2, 0.1, 1.0, 3.0, 10.0, 100.0, 600.0] {
        // beyond an optical thickness of 60 there is nothing
        let text = below_a_plate(thickness, 60.0 / thickness + 1.0, &tolerance(1e-7));
        let Answer { value, error, .. } = simulated(&text).answers[0];
        let truth = PI * slab_transmittance(thickness);
        assert!(
            (value - truth).abs() <= error + 1e-13 * truth,
            "{thickness}: {value:e} ± {error:e}, {truth:e}"
        );
        assert!(error <= 1e-9 * truth, "{thickness}: {value:e} ± {error:e}");
    }
}

#[test]
fn what_underflows_is_told_and_nothing_is_not_a_number() {
    let dark = simulated(&below_a_plate(1000.0, 5.0, "")).answers[0].clone();
    assert!(dark.value == 0.0 && dark.error > 0.0 && dark.error < 1e-300, "{dark:?}");
    let faint = simulated(&below_a_plate(740.0, 5.0, "")).answers[0].clone();
    let truth = PI * slab_transmittance(740.0);
    assert!((faint.value - truth).abs() <= faint.error && faint.error < 1e-300, "{faint:?}, {truth:e}");
    let beside = point_receiver("beside", [9.0, 0.0, 1.0], [0.0, 0.0, 1.0]);
    let inside = point_receiver("inside", [0.5, 0.0, 1.0], [0.0, 0.0, 1.0]);
    let near = point_receiver("near", [0.5, 0.2, 1.0 - 1e-7], [0.0, 0.0, 1.0]);
    let answers = simulated(&below_a_plate(0.5, 5.0, &(beside + &inside + &near))).answers;
    assert!(answers[1..3].iter().all(|answer| [answer.value, answer.error] == [0.0; 2]), "{answers:?}");
    assert!((answers[3].value - PI).abs() <= 1e-6 && answers[3].error <= 1e-5, "{answers:?}");
}

#[test]
fn bands_that_nothing_absorbs_are_as_in_a_vacuum() {
    let bands = "bands = [[400, 500], [500, 600], [600, 700]]\n";
    let text = below_a_plate(1.0, 2.0, &tolerance(1e-6)).replace("sigma_a = 1.0", "sigma_a = [0, 1e-9, 2]");
    let found = simulated(&format!("{bands}{text}")).answers;
    let side = 2.0 / 5.0_f64.sqrt();
    let vacuum = 4.0 * side * side.atan();
    let thick = by_border([[-2.0, 2.0]; 2], 1.0, 2.0)[3];
    for (answer, [truth, least]) in found.iter().zip([[vacuum, 0.0], [vacuum, 2e-9 * vacuum], [thick, 0.0]]) {
        assert!((answer.value - truth).abs() <= answer.error + least + 1e-12, "{answer:?}, {truth}");
        assert!(answer.error <= 1e-8 * truth && answer.kind != ErrorKind::Sigma, "{answer:?}");
    }
}

#[test]
fn lights_without_extent_are_attenuated_and_hidden() {
    let lights = "[[light]]\nkind = \"point\"\nposition = [0, 0, 0.5]\nintensity = 3\n\
                  [[light]]\nkind = \"point\"\nposition = [0, 0, 1.5]\nintensity = 3\n\
                  [[light]]\nkind = \"distant\"\ndirection = [0, 1, -1]\nirradiance = 3\n";
    let text = below_a_plate(2.0, 0.1, lights).replace("radiance = 1", "radiance = 0");
    let answer = simulated(&text).answers[0].clone();
    let truth = 12.0 * (-1.0_f64).exp();
    assert!((answer.value - truth).abs() <= answer.error && answer.error <= 1e-12, "{answer:?}, {truth}");
}

#[test]
fn the_cells_of_a_map_are_computed_and_its_mean_is_sampled() {
    let floor = surface("floor", "black", &polygon(&corners([[-1.0, 1.0]; 2], 0.0)));
    let map = "[[receiver]]\nname = \"map\"\nkind = \"surface\"\nsurface = \"floor\"\ngrid = [6, 6]\n";
    let found = simulated(&below_a_plate(0.7, 1.0, &format!("{floor}{map}{}", tolerance(1e-2))));
    let (mean, map) = (&found.answers[1], &found.maps[0]);
    assert_eq!(mean.kind, ErrorKind::Sigma);
    assert!(map.errors[0].iter().all(|&error| error > 0.0 && error < 1e-4), "{map:?}");
    let of_cells = map.values[0].iter().sum::<f64>() / 36.0;
    assert!((of_cells / mean.value - 1.0).abs() < 5e-2, "{of_cells}, {mean:?}");
}

#[test]
fn no_seed_and_no_kernel_of_samples_takes_part() {
    let text = |seed: u32| below_a_plate(0.5, 3.0, &format!("[solve]\nseed = {seed}\n"));
    let found = |seed| simulated(&text(seed)).answers.iter().map(|a| [a.value, a.error]).collect::<Vec<_>>();
    assert_eq!(found(1), found(2));
    let plan = plan(&scene(&text(1))).unwrap_or_else(|errors| panic!("{}", errors[0]));
    assert!(plan.effects().iter().any(|planned| planned.why.contains("without samples")));
    let names: Vec<&str> = plan.kernels().iter().map(|kernel| kernel.name).collect();
    assert_eq!(names, ["measure_area_to_solid_angle", "transmittance"]);
}

/// Returns a ray along x from the origin to a black wall, in fog that scatters the light of two
/// points once. The second light is behind a screen of this length.
fn in_fog(
    [scattering, absorption, asymmetry]: [f64; 3],
    [first, second]: [Point; 2],
    end: f64,
    screen: f64,
) -> String {
    let wall = [[end, -99.0, -99.0], [end, -99.0, 99.0], [end, 99.0, 99.0], [end, 99.0, -99.0]];
    // half as high as the second light, from its abscissa on
    let [x, _, height] = second;
    let low = 0.5 * height;
    let screen = [[x, -99.0, low], [x + screen, -99.0, low], [x + screen, 99.0, low], [x, 99.0, low]];
    let light =
        |position: Point| format!("[[light]]\nkind = \"point\"\nposition = {position:?}\nintensity = 3\n");
    [
        format!("[[medium]]\nname = \"fog\"\nsigma_a = {absorption:?}\nsigma_s = {scattering:?}\ng = {asymmetry:?}\n"),
        "[ambient]\nmedium = \"fog\"\n".to_owned(),
        material("black", 0.0),
        surface("wall", "black", &polygon(&wall)),
        surface("screen", "black", &polygon(&screen)),
        light(first),
        light(second),
        "[[receiver]]\nname = \"ray\"\nkind = \"ray\"\norigin = [0, 0, 0]\ndirection = [1, 0, 0]\n".to_owned(),
    ]
    .concat()
}

/// Returns the light of a point light that a segment of the ray scatters, by a plain rule in the
/// angle at the light.
fn scattered_by_angle(
    [scattering, absorption, asymmetry]: [f64; 3],
    [s, y, z]: Point,
    [from, to]: [f64; 2],
) -> f64 {
    const STEPS: usize = 20_000;
    let height = y.hypot(z);
    let [low, high] = [from, to].map(|along| ((along - s) / height).atan());
    let value = |angle: f64| {
        let (along, distance) = (s + height * angle.tan(), height / angle.cos());
        let g = asymmetry;
        let phase = (1.0 - g * g) / (4.0 * PI * (1.0 + g * g + 2.0 * g * angle.sin()).powf(1.5));
        3.0 * scattering * phase * (-(scattering + absorption) * (along + distance)).exp() / height
    };
    let step = (high - low) / STEPS as f64;
    let one = |place: usize| {
        let middle = low + (place as f64 + 0.5) * step;
        let aside = 0.5 * step * (3.0_f64 / 5.0).sqrt();
        step / 18.0 * (5.0 * value(middle - aside) + 8.0 * value(middle) + 5.0 * value(middle + aside))
    };
    (0..STEPS).map(one).sum()
}

#[test]
fn airlight_is_computed_and_no_error_is_less_than_the_true_one() {
    let mut numbers = Numbers(3);
    for number in 0..48 {
        let scattering = numbers.of_any_size(0.01, 20.0);
        let fog = [scattering, scattering * numbers.next(), numbers.between(-0.95, 0.95)];
        let end = numbers.of_any_size(0.3, 10.0);
        let mut light = || [end * numbers.between(-0.5, 0.95), 0.0, numbers.of_any_size(0.02, 3.0)];
        let [first, second] = [light(), light()];
        let first = [first[0], -first[2], 0.0];
        let screen = end * numbers.of_any_size(0.01, 2.0);
        let shadow = [second[0], second[0] + 2.0 * screen].map(|along| along.clamp(0.0, end));
        // the first light is below the screen, which hides no part of the ray from it
        let truth: f64 = [(first, [0.0, end]), (second, [0.0, shadow[0]]), (second, [shadow[1], end])]
            .into_iter()
            .map(|(light, ends)| scattered_by_angle(fog, light, ends))
            .sum();
        let text = in_fog(fog, [first, second], end, screen);
        for tolerance in [1e-2, 1e-8] {
            let forced = format!("[solve]\ntolerance = {tolerance:?}\neffects = {{ scattering = 1 }}\n");
            let Answer { value, error, kind, .. } = simulated(&(text.clone() + &forced)).answers[0];
            assert!(
                (value - truth).abs() <= error + 1e-12 * truth,
                "{number}: {value:e} ± {error:e}, {truth:e}\n{text}"
            );
            assert!(
                error <= 1e-2 * tolerance * value && kind != ErrorKind::Sigma,
                "{number}: {value:e} ± {error:e}"
            );
        }
        if number < 6 {
            let forced = "[solve]\ntolerance = 1e-2\neffects = { scattering = 1 }\n";
            let sampled = simulated(&(text + MIRROR + forced)).answers[0].clone();
            assert_eq!(sampled.kind, ErrorKind::Sigma);
            assert!((sampled.value - truth).abs() <= 4.0 * sampled.error, "{number}: {sampled:?}, {truth:e}");
        }
    }
}
