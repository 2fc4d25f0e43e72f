//! Simulations of whole scenes: known answers, laws, and bounds on the change by omitted effects.

use forms_radiometry::scene::{Effect, Scene, read, read_with_files};
use forms_radiometry::simulation::{Answer, Quantity, Unwatched, Watch, plan, simulate};
use std::f64::consts::PI;
use std::sync::atomic::{AtomicUsize, Ordering};

use forms_testing::scene_text::{
    self, cube, point_receiver, surface_of_its_own as surface, surface_receiver,
};

fn receivers(surfaces: &[&str]) -> String {
    surfaces.iter().map(|name| surface_receiver(name)).collect()
}

fn scene(text: &str) -> Scene {
    read(text, "test.toml").unwrap_or_else(|errors| panic!("{}", errors[0]))
}

fn answers(text: &str) -> Vec<Answer> {
    let scene = scene(text);
    let plan = plan(&scene).unwrap_or_else(|errors| panic!("{}", errors[0]));
    simulate(&plan, &Unwatched).answers
}

/// Returns the answer of a receiver for a quantity, in the first band.
fn answer(answers: &[Answer], receiver: &str, quantity: Quantity) -> (f64, f64) {
    let is_meant = |answer: &&Answer| answer.receiver == receiver && answer.quantity == quantity;
    let found = answers.iter().find(is_meant).unwrap_or_else(|| panic!("{receiver} {quantity:?}"));
    (found.value, found.error)
}

fn assert_within(name: &str, (found, error): (f64, f64), expected: f64, tolerance: f64) {
    // the expected value is rounded too
    let off = (found - expected).abs() - 4.0 * f64::EPSILON * expected.abs();
    assert!(off <= error, "{name}: {found} is off by {off:e}, said {error:e}");
    assert!(error <= tolerance * expected.abs(), "{name}: {error:e} is not what was asked for");
}

#[test]
fn opposed_squares_have_the_radiosity_of_the_continuous_equation() {
    // mean radiosity of the square that emits nothing, by tensor Gauss–Legendre in f64
    const EXPECTED: f64 = 0.896_047_679_666_9;
    let text = surface("a", "polygon = [[0,0,0], [1,0,0], [1,1,0], [0,1,0]]", "0.9", "0")
        + &surface("b", "polygon = [[0,0,0.25], [0,1,0.25], [1,1,0.25], [1,0,0.25]]", "0.9", "1")
        + &receivers(&["a"]);
    for tolerance in [1e-2, 1e-3] {
        let asked = format!("{text}[solve]\ntolerance = {tolerance}\n");
        let (irradiance, error) = answer(&answers(&asked), "a", Quantity::Irradiance);
        assert_within("squares", (0.9 * irradiance, 0.9 * error), EXPECTED, tolerance);
    }
}

#[test]
fn in_a_furnace_every_radiance_is_that_of_the_walls() {
    // L = Lₑ/(1 − ρ), whatever the shape
    for rho in [0.0, 0.5, 0.9, 0.999_999_f64] {
        let expected = 1.0 / (1.0 - rho);
        let text = cube([rho; 6], [PI; 6])
            + "[[receiver]]\nname = \"point\"\nkind = \"point\"\nposition = [0.1, 0.7, 0]\nnormal = [0, 0, 1]\n"
            + "[[receiver]]\nname = \"ray\"\nkind = \"ray\"\norigin = [0.5, 0.4, 0.3]\ndirection = [3, 1, 2]\n"
            + "[[receiver]]\nname = \"sphere\"\nkind = \"sphere\"\nposition = [0.9, 0.4, 0.3]\n";
        let found = answers(&text);
        assert_within("point", answer(&found, "point", Quantity::Irradiance), PI * expected, 1e-3);
        assert_within("ray", answer(&found, "ray", Quantity::Radiance), expected, 1e-3);
        assert_within("sphere", answer(&found, "sphere", Quantity::FluenceRate), 4.0 * PI * expected, 1e-3);
        for axis in 0..3 {
            let (flow, error) = answer(&found, "sphere", Quantity::VectorIrradiance(axis));
            assert!(flow.abs() <= error && error <= 1e-2 * expected, "{rho}: {flow} ± {error}");
        }
    }
}

#[test]
fn what_is_emitted_in_a_closed_room_is_absorbed() {
    let reflectances = [0.3, 0.7, 0.5, 0.0, 0.6, 0.8];
    let furniture = surface(
        "screen",
        "two_sided = false\npolygon = [[0.3,0.3,0], [0.3,0.3,0.5], [0.3,0.8,0.5], [0.3,0.8,0]]",
        "0.4",
        "0",
    ) + &surface(
        "back of it",
        "polygon = [[0.3,0.3,0], [0.3,0.8,0], [0.3,0.8,0.5], [0.3,0.3,0.5]]",
        "0.9",
        "0",
    );
    let names = ["floor", "ceiling", "left", "right", "front", "back", "screen", "back of it"];
    let text = cube(reflectances, [0.0, 1.0, 0.0, 0.0, 0.0, 0.0])
        + &furniture
        + &receivers(&names)
        + "[solve]\ntolerance = 3e-2\n";
    let found = answers(&text);
    let mut absorbed = (0.0, 0.0);
    for (name, rho) in names.iter().zip(reflectances.into_iter().chain([0.4, 0.9])) {
        let (flux, error) = answer(&found, name, Quantity::Flux);
        absorbed = (absorbed.0 + (1.0 - rho) * flux, absorbed.1 + (1.0 - rho) * error);
    }
    assert_within("absorbed", absorbed, 1.0, 6e-2);
}

#[test]
fn in_a_groove_the_apex_has_its_closed_form() {
    // B = E/(1 − ρ (1 + cos a)/2) at the apex of an infinite groove: its sides see each other with
    // (1 + cos a)/2
    let text = surface("a", "polygon = [[0,-300,0], [1,-300,0], [1,300,0], [0,300,0]]", "0.5", "1")
        + &surface("b", "polygon = [[0,-300,0], [0,300,0], [0,300,1], [0,-300,1]]", "0.5", "1")
        + "[[receiver]]\nname = \"apex\"\nkind = \"point\"\nposition = [1e-6, 0, 0]\nnormal = [0, 0, 1]\n"
        + "[solve]\ntolerance = 1e-2\n";
    let (irradiance, error) = answer(&answers(&text), "apex", Quantity::Irradiance);
    // the receiver is next to the apex, and the groove is finite
    assert_within("apex", (1.0 + 0.5 * irradiance, error + 1e-3), 4.0 / 3.0, 2e-2);
}

#[test]
fn what_the_plan_drops_changes_less_than_its_bound() {
    let lamp = surface("lamp", "polygon = [[-1,-1,2], [-1,1,2], [1,1,2], [1,-1,2]]", "0", "1");
    let at = "[[receiver]]\nname = \"here\"\nkind = \"point\"\nposition = [0, 0, 0.01]\nnormal = [0, 0, 1]\n";
    let dark_floor = surface("floor", "polygon = [[-1,-1,0], [1,-1,0], [1,1,0], [-1,1,0]]", "1e-4", "0");
    let text = lamp + &dark_floor + at;
    let planned = plan(&scene(&text)).expect("it is simulated");
    let dropped: Vec<&str> =
        planned.effects().iter().filter(|planned| !planned.on).map(|planned| planned.why.as_str()).collect();
    assert!(dropped.iter().any(|why| why.contains("its bound is within the tolerance")), "{dropped:?}");
    let bound: f64 =
        planned.effects().iter().filter(|planned| !planned.on).filter_map(|planned| planned.bound).sum();
    let (with_plan, _) = answer(&answers(&text), "here", Quantity::Irradiance);
    let text_of_plan = text.clone();
    let all = text + "[solve]\neffects = { occlusion = \"on\", interreflection = \"on\", bands = \"on\" }\n";
    let (with_all, error) = answer(&answers(&all), "here", Quantity::Irradiance);
    assert!((with_plan - with_all).abs() <= bound + error, "{with_plan} and {with_all}, bound {bound:e}");
    assert!(bound > 0.0 && bound < 1e-3 * with_all);
    // the bound is part of the error, which stays within the tolerance
    let found = &answers(&text_of_plan)[0];
    assert!(found.parts.effects > 0.0 && found.parts.effects <= bound, "{found:?}");
    assert!(
        (with_plan - with_all).abs() <= found.error + error,
        "{with_plan} and {with_all}, said {found:?}"
    );
    assert!(found.error <= 1e-3 * found.value, "{found:?}");
}

#[test]
fn what_faces_send_on_to_others_behind_them_is_within_the_bound_of_leaving_it_out() {
    // from outside, plates also get the light that they hide from each other
    let plate = |index: u32| {
        let z = 0.5 * f64::from(index);
        let shape = format!("polygon = [[-1,-1,{z}], [1,-1,{z}], [1,1,{z}], [-1,1,{z}]]\ntwo_sided = true");
        surface(&format!("plate {index}"), &shape, "0.6", "0")
    };
    let plates: String = (0..4).map(plate).collect();
    let at = point_receiver("here", [0.1, 0.2, 0.25], [0.0, 0.0, 1.0]);
    let text = plates + &at + "[ambient]\nradiance = 2\n[solve]\ntolerance = 3e-2\n";
    let off = text.clone() + "effects = { interreflection = \"off\" }\n";
    let planned = plan(&scene(&off)).expect("it is simulated");
    let bounds = planned.effects().iter().filter(|planned| !planned.on).filter_map(|planned| planned.bound);
    let bound: f64 = bounds.sum();
    let (without, _) = answer(&answers(&off), "here", Quantity::Irradiance);
    let (with, error) = answer(&answers(&text), "here", Quantity::Irradiance);
    assert!(with - without > 0.1 * with, "{with} and {without}");
    assert!(with - without <= bound + error, "{with} and {without}, bound {bound}");
}

#[test]
fn lights_without_extent_shine_where_nothing_stands_before_them() {
    let screen = surface("screen", "polygon = [[-1,-1,1], [1,-1,1], [1,1,1], [-1,1,1]]", "0", "0");
    let lights = "[[light]]\nkind = \"point\"\nposition = [0, 0, 2]\nintensity = 3\n\
                  [[light]]\nkind = \"distant\"\ndirection = [0, 1, -1]\nirradiance = 5\n";
    let at = |name: &str, position: &str| {
        format!(
            "[[receiver]]\nname = \"{name}\"\nkind = \"point\"\nposition = {position}\nnormal = [0, 0, 1]\n"
        )
    };
    let found = answers(&(screen + lights + &at("below", "[0, 0, 0]") + &at("aside", "[6, 0, 0]")));
    // E cos 45° of the distant light passes next to the screen at [0, 0, 0]: it comes from y = −1
    // at the screen's height, its very edge
    let distant = 5.0 / 2.0_f64.sqrt();
    let aside = distant + 3.0 * 2.0 / (40.0 * 40.0_f64.sqrt());
    assert_within("aside", answer(&found, "aside", Quantity::Irradiance), aside, 1e-12);
    assert!(
        answer(&found, "below", Quantity::Irradiance).0 <= distant * (1.0 + 1e-12),
        "the point is hidden"
    );
}

#[test]
fn in_a_convex_room_nothing_hides_a_light_that_is_in_it() {
    let room = cube([0.5; 6], [0.0; 6]) + &receivers(&["floor"]);
    let point = |height: f64| {
        format!("[[light]]\nkind = \"point\"\nposition = [0.5, 0.4, {height}]\nintensity = 3\n")
    };
    let distant = "[[light]]\nkind = \"distant\"\ndirection = [0, 1, -1]\nirradiance = 5\n";
    let screen =
        surface("screen", "polygon = [[0.2,0.2,0.4], [0.6,0.2,0.4], [0.6,0.6,0.4], [0.2,0.6,0.4]]", "0", "0");
    for (name, more, is_hidden) in [
        ("a light in the room", point(0.9), false),
        ("a light above the ceiling", point(1.1), true),
        ("a light far away", distant.to_owned(), true),
        ("a screen", point(0.9) + &screen, true),
        ("a sky", "[ambient]\nradiance = 1\n".to_owned(), true),
    ] {
        let plan = plan(&scene(&format!("{room}{more}"))).expect("the scene is right");
        let occlusion = plan.effects().iter().find(|planned| planned.effect == Effect::Occlusion);
        assert_eq!(occlusion.map(|planned| planned.on), Some(is_hidden), "{name}");
    }
}

#[test]
fn a_uniform_sky_gives_what_is_not_hidden() {
    // Nusselt: a parallel square above hides light by its form factor
    let screen = surface("screen", "polygon = [[-1,-1,1], [1,-1,1], [1,1,1], [-1,1,1]]", "0", "0");
    let at = "[[receiver]]\nname = \"here\"\nkind = \"point\"\nposition = [0, 0, 0]\nnormal = [0, 0, 1]\n\
              [[receiver]]\nname = \"round\"\nkind = \"sphere\"\nposition = [0, 0, 0]\n\
              [ambient]\nradiance = 2\n";
    let found = answers(&(screen + at));
    let hidden = 4.0 / (PI * 2.0_f64.sqrt()) * (1.0 / 2.0_f64.sqrt()).atan();
    let solid_angle = 4.0 * (1.0 / 3.0_f64.sqrt()).atan();
    assert_within("here", answer(&found, "here", Quantity::Irradiance), 2.0 * PI * (1.0 - hidden), 1e-12);
    let fluence = 2.0 * (4.0 * PI - solid_angle);
    assert_within("round", answer(&found, "round", Quantity::FluenceRate), fluence, 1e-12);
    // equal light from all sides has no net flow; the light missing from above leaves a flow
    // upwards
    let (flow, error) = answer(&found, "round", Quantity::VectorIrradiance(2));
    assert!((flow - 2.0 * PI * hidden).abs() <= error + 1e-12, "{flow}");
}

#[test]
fn a_closed_white_box_with_a_light_is_refused_with_its_place() {
    let text = cube([1.0; 6], [0.0, 1.0, 0.0, 0.0, 0.0, 0.0]) + &receivers(&["floor"]);
    let errors = plan(&scene(&text)).expect_err("light never leaves");
    assert!(errors[0].to_string().contains("never leaves and is never absorbed"), "{}", errors[0]);
}

#[test]
fn bands_share_geometry_and_are_answered_each() {
    let text = "bands = [[400, 500], [500, 600]]\n".to_string()
        + &surface("lamp", "polygon = [[-1,-1,2], [-1,1,2], [1,1,2], [1,-1,2]]", "0", "[1, 3]")
        + "[[receiver]]\nname = \"here\"\nkind = \"point\"\nposition = [0, 0, 0]\nnormal = [0, 0, 1]\n";
    let found = answers(&text);
    assert_eq!(found.iter().map(|answer| answer.band).collect::<Vec<_>>(), [Some(0), Some(1)]);
    assert!((found[1].value - 3.0 * found[0].value).abs() <= 1e-14 * found[1].value);
}

/// Observer that stops the work after this many reports of progress.
struct StopsAfter {
    most: usize,
    told: AtomicUsize,
}

impl Watch for StopsAfter {
    fn progress(&self, _stage: &str, _fraction: f64) {
        self.told.fetch_add(1, Ordering::SeqCst);
    }

    fn is_stopped(&self) -> bool {
        self.told.load(Ordering::SeqCst) >= self.most
    }
}

#[test]
fn work_that_is_stopped_ends_at_once_with_what_was_found_before() {
    let room = cube([0.5, 0.7, 0.3, 0.5, 0.5, 0.2], [0.0, 1.0, 0.0, 0.0, 0.0, 0.0]);
    let screen =
        surface("screen", "polygon = [[0.2,0.2,0.4], [0.6,0.2,0.4], [0.6,0.6,0.4], [0.2,0.6,0.4]]", "0", "0");
    let disk = |name: &str, z: &str, up: &str, exitance: &str| {
        let shape = format!("disk = {{ center = [0.4, 0.4, {z}], normal = [0, 0, {up}], radius = 0.5 }}");
        surface(name, &shape, "0.5", exitance)
    };
    let disks = disk("below", "0", "1", "0") + &disk("above", "0.5", "-1", "1");
    let at = point_receiver("here", [0.3, 0.3, 0.1], [0.0, 0.0, 1.0]);
    let map = receivers(&["floor"]) + "grid = [5, 4]\n";
    for (name, text, tolerance) in [
        ("free", format!("{room}{map}{at}"), 1e-3),
        ("with a screen", format!("{room}{screen}{map}{at}"), 0.2),
        ("round", format!("{disks}{at}"), 5e-3),
    ] {
        let scene = scene(&(text + &scene_text::tolerance(tolerance)));
        let plan = plan(&scene).expect("the scene is right");
        let run = |most: usize| {
            let watch = StopsAfter { most, told: AtomicUsize::new(0) };
            let found = simulate(&plan, &watch);
            (found, watch.told.into_inner())
        };
        let (whole, all) = run(usize::MAX);
        assert!(!whole.stopped && all > 4, "{name}: {all}");
        for most in [0, 1, all / 4, all / 2, all - 1] {
            let (found, told) = run(most);
            // each thread may be about to report its progress
            let threads = std::thread::available_parallelism().map_or(1, usize::from);
            assert!(found.stopped && told <= most + threads, "{name}: {told} of {all} after {most}");
            for answer in &found.answers {
                let is_meant =
                    |other: &&Answer| other.receiver == answer.receiver && other.quantity == answer.quantity;
                let exact = whole.answers.iter().find(is_meant).expect("the same receivers");
                let off = (answer.value - exact.value).abs();
                assert!(off <= answer.error + exact.error, "{name} after {most}: {answer:?}, {exact:?}");
            }
        }
        let (found, _) = run(all - 1);
        assert_eq!(found.answers.len(), whole.answers.len(), "{name}");
    }
}

#[test]
fn a_body_that_stands_open_on_another_one_is_seen_as_its_faces() {
    // three of its sides are above sides of the body below, so that three and four faces share an
    // edge
    let solid = |low: [f64; 3], high: [f64; 3], first: usize| {
        let corner = |i: usize, axis: usize| {
            if [0b0110, 0b1100, 0][axis] >> (i % 4) & 1 == 1 { high[axis] } else { low[axis] }
        };
        let corners = (0..8).fold(String::new(), |text, i| {
            text + &format!("v {} {} {}\n", corner(i, 0), corner(i, 1), if i < 4 { low[2] } else { high[2] })
        });
        let side = |indices: [usize; 4]| indices.map(|i| (first + i).to_string()).join(" ");
        let sides = [[0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7], [4, 5, 6, 7]];
        sides.iter().fold(corners, |text, &indices| text + "f " + &side(indices) + "\n")
    };
    let mesh = solid([0.0, 0.0, 0.42], [0.44, 0.42, 0.45], 1)
        + "f 1 4 3 2\n"
        + &solid([0.0, 0.0, 0.45], [0.44, 0.03, 0.9], 9);
    let text = surface("seat", "mesh = \"seat.obj\"", "0", "0")
        + "[[receiver]]\nname = \"below\"\nkind = \"sphere\"\nposition = [0.2, 0.2, -1]\n[ambient]\nradiance = 1\n";
    let files = |_: &str| Ok(mesh.clone().into_bytes());
    let scene = read_with_files(&text, "seat.toml", &files).unwrap_or_else(|errors| panic!("{}", errors[0]));
    let plan = plan(&scene).unwrap_or_else(|errors| panic!("{}", errors[0]));
    let found = simulate(&plan, &Unwatched).answers;
    let (fluence, _) = answer(&found, "below", Quantity::FluenceRate);
    // only the lower body is visible from below, and it hides the upper one
    let seen = |x: f64, y: f64| (x * y / (1.42 * (x * x + y * y + 1.42 * 1.42).sqrt())).atan();
    let hidden = seen(0.2, 0.2) + seen(0.24, 0.2) + seen(0.2, 0.22) + seen(0.24, 0.22);
    assert!((fluence - (4.0 * PI - hidden)).abs() < 1e-12, "{fluence} and {}", 4.0 * PI - hidden);
}
