//! Openings: uniform light from outside falls through a narrow shaft onto the floor of a black
//! room, between nodes that are far apart.
//!
//! Through the shaft, only the floor is visible. Light that enters at the upper end and leaves at
//! the lower end therefore falls on the floor: π L times the exchange area of the two ends, which
//! are opposed squares. If a lamp closes the upper end and the floor reflects, the room gets the
//! light that the floor reflects. `FORMS_OPENINGS` is the number of rooms.

use forms_kernels::view_factor_parallel_rectangles;
use forms_radiometry::scene::read;
use forms_radiometry::simulation::{Answer, Quantity, Unwatched, plan, simulate};
use forms_testing::SplitMix;
use forms_testing::scene_text::{Point, material, polygon, surface, surface_receiver, tolerance};
use std::f64::consts::PI;
use std::ops::Range;

/// Indices of the walls of the room among its faces; those of the shaft follow, and then the
/// ceiling.
const WALLS: Range<usize> = 0..4;
const CEILING: Range<usize> = 8..12;
/// The sides of the room, and its height.
const ROOM: [f64; 3] = [4.0, 3.0, 3.0];
const RADIANCE: f64 = 1000.0;

fn count() -> usize {
    std::env::var("FORMS_OPENINGS").map_or(10, |count| count.parse().expect("a number"))
}

fn between(random: &mut SplitMix, low: f64, high: f64) -> f64 {
    low + (high - low) * random.unit()
}

/// Square shaft: its lower corner, its side and its length.
struct Shaft {
    corner: [f64; 2],
    side: f64,
    length: f64,
}

impl Shaft {
    /// Returns a random shaft through which a part of the floor is visible, and no part of the
    /// walls.
    fn random(random: &mut SplitMix) -> Self {
        let side = 0.3_f64.powf(between(random, 1.0, 2.5));
        let length = side * between(random, 2.5, 8.0);
        let beside = ROOM[2] * side / length;
        let corner = [0, 1].map(|i| between(random, beside, ROOM[i] - beside - side));
        Self { corner, side, length }
    }

    /// Returns the walls of the room and of the shaft.
    fn faces(&self) -> Vec<[Point; 4]> {
        let [x, y, z] = ROOM;
        let top = z + self.length;
        let ([a, b], [c, d]) = (self.corner, self.corner.map(|corner| corner + self.side));
        let ceiling = |[a, b]: [f64; 2], [c, d]: [f64; 2]| [[a, b, z], [a, d, z], [c, d, z], [c, b, z]];
        let wall = |[a, b]: [f64; 2], [c, d]: [f64; 2], low: f64, high: f64| {
            [[a, b, low], [a, b, high], [c, d, high], [c, d, low]]
        };
        let around = |[a, b]: [f64; 2], [c, d]: [f64; 2], low: f64, high: f64| {
            [
                wall([a, b], [c, b], low, high),
                wall([c, b], [c, d], low, high),
                wall([c, d], [a, d], low, high),
                wall([a, d], [a, b], low, high),
            ]
        };
        let ceilings = [
            ceiling([0.0, 0.0], [a, y]),
            ceiling([c, 0.0], [x, y]),
            ceiling([a, 0.0], [c, b]),
            ceiling([a, d], [c, y]),
        ];
        let walls = [around([0.0, 0.0], [x, y], 0.0, z), around([a, b], [c, d], z, top)];
        walls.concat().into_iter().chain(ceilings).collect()
    }

    /// Returns a room without a source, whose floor reflects this part of light.
    fn room(&self, reflectance: f64) -> String {
        let [x, y, _] = ROOM;
        let floor = [[0.0, 0.0, 0.0], [x, 0.0, 0.0], [x, y, 0.0], [0.0, y, 0.0]];
        let walls = self.faces().into_iter().enumerate();
        let walls = walls.map(|(index, face)| surface(&format!("wall {index}"), "black", &polygon(&face)));
        material("black", 0)
            + &material("floor", reflectance)
            + &surface("floor", "floor", &polygon(&floor))
            + &walls.collect::<String>()
            + &surface_receiver("floor")
    }

    /// Returns the room in uniform light from outside.
    fn open(&self, accuracy: f64) -> String {
        self.room(0.0) + &format!("[ambient]\nradiance = {RADIANCE:?}\n") + &tolerance(accuracy)
    }

    /// Returns the room with a lamp that closes the shaft, and with a floor that reflects half of
    /// its light onto walls and ceiling.
    fn lit(&self, accuracy: f64) -> String {
        let ([a, b], [c, d]) = (self.corner, self.corner.map(|corner| corner + self.side));
        let top = ROOM[2] + self.length;
        let lamp = polygon(&[[a, b, top], [a, d, top], [c, d, top], [c, b, top]]);
        let receivers = WALLS.chain(CEILING).map(|index| surface_receiver(&format!("wall {index}")));
        self.room(0.5)
            + &surface("lamp", "black", &format!("{lamp}\nradiance = {RADIANCE:?}"))
            + &receivers.collect::<String>()
            + &tolerance(accuracy)
    }

    /// Returns the exact mean irradiance of the floor.
    fn right(&self) -> f64 {
        let part = self.side * self.side / (ROOM[0] * ROOM[1]);
        PI * RADIANCE * part * view_factor_parallel_rectangles(self.side, self.side, self.length)
    }
}

fn answers(text: &str) -> Vec<Answer> {
    let scene = read(text, "room.toml").unwrap_or_else(|errors| panic!("{}\n{text}", errors[0]));
    simulate(&plan(&scene).expect("a plan"), &Unwatched).answers
}

#[test]
fn light_through_a_shaft_is_found_between_nodes() {
    let mut random = SplitMix(30);
    let (mut outside, mut settled) = (Vec::new(), 0);
    for _ in 0..count() {
        let shaft = Shaft::random(&mut random);
        let accuracy = 10.0_f64.powf(between(&mut random, -3.0, -2.0));
        let text = shaft.open(accuracy);
        let answers = answers(&text);
        let mean = answers.iter().find(|answer| answer.quantity == Quantity::Irradiance).expect("a mean");
        let right = shaft.right();
        settled += usize::from(mean.error <= accuracy * mean.value);
        if (mean.value - right).abs() > mean.error {
            outside.push(format!(
                "{} ± {} where {right} is right at {accuracy}:\n{text}",
                mean.value, mean.error
            ));
        }
    }
    // an estimate is allowed to be off in one case of fifty
    assert!(outside.len() * 50 <= count().max(49), "{outside:#?}");
    assert!(3 * settled >= count(), "{settled} of {} rooms within their tolerance", count());
}

#[test]
fn a_room_gets_what_its_floor_reflects_of_a_lamp_in_a_shaft() {
    let mut random = SplitMix(31);
    for _ in 0..count().div_ceil(5) {
        let shaft = Shaft::random(&mut random);
        let text = shaft.lit(0.05);
        let answers = answers(&text);
        let fluxes: Vec<&Answer> =
            answers.iter().filter(|answer| answer.quantity == Quantity::Flux).collect();
        let [floor, room @ ..] = fluxes.as_slice() else { panic!("no floor") };
        let received: f64 = room.iter().map(|answer| answer.value).sum();
        let error = 0.5 * floor.error + room.iter().map(|answer| answer.error).sum::<f64>();
        let sent = 0.5 * floor.value;
        // the rest returns into the shaft, which fills no more than this part of the hemisphere of
        // any point of the floor
        let lost = (shaft.side / ROOM[2]).powi(2) / PI;
        assert!(
            received <= sent + error && received >= sent * (1.0 - lost) - error && error <= 0.2 * sent,
            "{received} ± {error} of {sent}:\n{text}"
        );
    }
}
