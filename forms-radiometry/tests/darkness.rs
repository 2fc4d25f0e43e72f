//! Darkness: receivers that nothing illuminates get exactly nothing, those that see little do not,
//! and a light at a receiver makes no number.

use forms_radiometry::scene::{Scene, read};
use forms_radiometry::simulation::{ErrorKind, Plan, Simulation, Unwatched, Watch, plan, simulate};
use forms_testing::SplitMix;
use forms_testing::scene_text::{Point, material, point_receiver, polygon, surface, tolerance};

fn scene(text: &str) -> Scene {
    read(text, "dark.toml").unwrap_or_else(|errors| panic!("{}\n{text}", errors[0]))
}

/// Returns the answers as a whole, and by paths under this watch.
fn both(text: &str, watch: &dyn Watch) -> [Simulation; 2] {
    let scene = scene(text);
    let plan = plan(&scene).unwrap_or_else(|errors| panic!("{}", errors[0]));
    let with = |by_paths| Plan::with_effects(&scene, plan.effects().to_vec(), by_paths);
    [simulate(&with(false), &Unwatched), simulate(&with(true), watch)]
}

fn unit(random: &mut SplitMix) -> Point {
    loop {
        let v: Point = std::array::from_fn(|_| random.between([-1.0, 1.0]));
        let length = v.map(|x| x * x).iter().sum::<f64>().sqrt();
        if length > 0.1 && length <= 1.0 {
            return v.map(|x| x / length);
        }
    }
}

fn along(point: Point, by: f64, direction: Point) -> Point {
    std::array::from_fn(|axis| point[axis] + by * direction[axis])
}

/// Returns a lamp, a grey body and a point light within the unit ball.
fn contents(random: &mut SplitMix) -> String {
    let mut point = |size: f64| along([0.0; 3], random.between([0.0, size]), unit(random));
    let corners = [0; 3].map(|_| point(1.0));
    let (sphere, disk, light) = (point(0.6), point(0.6), point(1.0));
    let normal = unit(random);
    let lamp = polygon(&corners) + "\ntwo_sided = true\nradiance = 3";
    [
        material("grey", 0.5),
        surface("lamp", "grey", &lamp),
        surface("ball", "grey", &format!("sphere = {{ center = {sphere:?}, radius = 0.4 }}")),
        surface(
            "disk",
            "grey",
            &format!("disk = {{ center = {disk:?}, normal = {normal:?}, radius = 0.4 }}"),
        ),
        format!("[[light]]\nkind = \"point\"\nposition = {light:?}\nintensity = 2\n"),
    ]
    .concat()
}

#[test]
fn a_place_above_all_surfaces_and_lights_gets_exactly_nothing() {
    let mut random = SplitMix(41);
    for _ in 0..40 {
        let normal = unit(&mut random);
        let above = along([0.0; 3], random.between([1.0, 3.0]), normal);
        let text = contents(&mut random) + &point_receiver("here", above, normal) + &tolerance(1e-2);
        for (found, method) in both(&text, &Unwatched).iter().zip(["whole", "paths"]) {
            let answer = &found.answers[0];
            assert_eq!(answer.value, 0.0, "{method}: {text}");
            assert_eq!(found.accuracy().missed(1e-2), [false], "{method}: {answer:?}\n{text}");
            assert!(answer.error <= 1e-12 * found.brightest, "{method}: {answer:?}\n{text}");
        }
    }
}

#[test]
fn a_place_that_sees_a_sliver_of_a_lamp_is_not_dark() {
    let mut random = SplitMix(43);
    let lamps = [
        "sphere = { center = CENTRE, radius = 0.5 }",
        "disk = { center = CENTRE, normal = NORMAL, radius = 0.5 }",
    ];
    for (index, depth) in (0..20).flat_map(|index| [0.4, 0.499].map(|depth| (index, depth))) {
        let normal = unit(&mut random);
        let aside = unit(&mut random);
        // a unit vector across the normal, along which the rim of the disk is
        let part: f64 = (0..3).map(|axis| normal[axis] * aside[axis]).sum();
        let across = along(aside, -part, normal);
        let length = across.map(|x| x * x).iter().sum::<f64>().sqrt();
        let across = across.map(|x| x / length);
        let centre = along(along([0.0; 3], -depth, normal), -2.0, across);
        let lamp = lamps[index % 2]
            .replace("CENTRE", &format!("{centre:?}"))
            .replace("NORMAL", &format!("{across:?}"));
        let text = [
            material("black", 0),
            surface("lamp", "black", &(lamp + "\nradiance = 3")),
            point_receiver("here", [0.0; 3], normal),
            tolerance(3e-1),
        ];
        let [whole, paths] = both(&text.concat(), &Stopped).map(|found| found.answers[0].clone());
        assert!(
            whole.value > 0.0 && paths.kind == ErrorKind::Sigma,
            "{whole:?}, {paths:?}\n{}",
            text.concat()
        );
    }
}

#[test]
fn a_receiver_at_a_point_light_is_refused() {
    let text = contents(&mut SplitMix(5));
    let light = "[[light]]\nname = \"bulb\"\nkind = \"point\"\nposition = [2, 0.1, 0]\nintensity = 1\n";
    for receiver in [
        point_receiver("here", [2.0, 0.1, 0.0], [0.0, 0.0, 1.0]),
        "[[receiver]]\nname = \"here\"\nkind = \"sphere\"\nposition = [2, 0.1, 0]\n".to_owned(),
    ] {
        let errors = plan(&scene(&format!("{text}{light}{receiver}"))).expect_err("infinite");
        let message = "the receiver `here` is at the point light `bulb`, whose irradiance is infinite there";
        assert_eq!(errors[0].message, message);
        assert!(errors[0].line > 20);
    }
}

/// Asks for a stop at once.
struct Stopped;

impl Watch for Stopped {
    fn progress(&self, _stage: &str, _fraction: f64) {}

    fn is_stopped(&self) -> bool {
        true
    }
}
