//! Light selection: chooses the light source that is sampled from a point, with a probability
//! proportional to the irradiance that it can contribute there.
//!
//! ```text
//! lights ─ halved across the longest axis ─▶ about √n groups
//! point ─▶ a group by S cos θ/max(d², r²) + E ─▶ a light of the group by the same weight
//! ```
//! S is the intensity, or the radiance times the area; d is the distance of the centre; r is the
//! radius of the bounding sphere; θ is the smallest angle to the surface normal of anything within
//! that sphere; E is the irradiance of distant lights. A flat emitter contributes nothing to points
//! behind it. A weak lamp nearby is therefore sampled even next to the sun, and a single sample is
//! hardly ever worth more than all lights together.
//!
//! Source: A. Conty Estevez, C. Kulla, Importance sampling of many lights with adaptive tree
//! splitting (2018), for weights of groups.

use crate::geometry::Plane;
use crate::geometry::Vector;

/// Up to this number of lights, each light is a group of its own.
const FEW: usize = 64;

/// Selection data of a light, or of a group of lights.
#[derive(Clone, Copy, Debug)]
pub(super) struct Weight {
    /// Intensity of point lights, or radiance times area of emitters.
    pub(super) strength: f64,
    pub(super) middle: Vector,
    pub(super) radius: f64,
    /// Irradiance of distant lights, and the direction to the light if there is only one.
    pub(super) far: f64,
    pub(super) direction: Option<Vector>,
    /// The plane in front of which the light shines, if it shines to one side.
    pub(super) before: Option<Plane>,
}

/// Point or segment for which lights are selected. The ends of the segment coincide for a point. If
/// there is a normal, light arrives only on its side.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sought {
    pub(super) from: Vector,
    to: Vector,
    normal: Option<Vector>,
}

impl Sought {
    pub(super) fn at(place: Vector, normal: Option<Vector>) -> Self {
        Self { from: place, to: place, normal }
    }

    pub(super) fn along(from: Vector, to: Vector) -> Self {
        Self { from, to, normal: None }
    }

    /// Returns the mirror image of the point or segment.
    pub(super) fn mirrored(self, plane: Plane) -> Self {
        let [from, to] = [self.from, self.to].map(|place| plane.mirrored(place));
        Self { from, to, normal: self.normal.map(|normal| normal.mirrored(plane.normal)) }
    }
}

/// Selection among lights.
pub(super) struct Choice {
    lights: Vec<Weight>,
    groups: Vec<Group>,
    /// The group of each light.
    of_lights: Vec<usize>,
}

struct Group {
    lights: Vec<usize>,
    all: Weight,
}

impl Choice {
    pub(super) fn among(lights: Vec<Weight>) -> Self {
        let groups = if lights.len() <= FEW { lights.len() } else { lights.len().isqrt() };
        let mut choice =
            Self { of_lights: vec![0; lights.len()], groups: Vec::with_capacity(groups), lights };
        let all = (0..choice.lights.len()).collect();
        choice.divide(all, groups);
        choice
    }

    /// Divides lights into this number of groups.
    fn divide(&mut self, mut lights: Vec<usize>, groups: usize) {
        if groups <= 1 {
            if !lights.is_empty() {
                lights.iter().for_each(|&light| self.of_lights[light] = self.groups.len());
                let all = Weight::together(lights.iter().map(|&light| &self.lights[light]));
                self.groups.push(Group { lights, all });
            }
            return;
        }
        let along = |axis: usize, light: usize| {
            let Vector { x, y, z } = self.lights[light].middle;
            [x, y, z][axis]
        };
        let extent = |axis: usize| {
            let places = || lights.iter().map(|&light| along(axis, light));
            places().fold(f64::NEG_INFINITY, f64::max) - places().fold(f64::INFINITY, f64::min)
        };
        let longest = (0..3).max_by(|&a, &b| extent(a).total_cmp(&extent(b))).unwrap_or(0);
        lights.sort_by(|&a, &b| along(longest, a).total_cmp(&along(longest, b)).then(a.cmp(&b)));
        let half = groups / 2;
        let rest = lights.split_off(lights.len() * half / groups);
        self.divide(lights, half);
        self.divide(rest, groups - half);
    }

    /// Selects a light by a number from 0 to 1 and returns its probability. `None` if there is no
    /// light, or none contributes.
    pub(super) fn choose(&self, sought: Sought, number: f64) -> Option<(usize, f64)> {
        if self.lights.len() == 1 {
            return Some((0, 1.0));
        }
        let groups = self.groups.iter().map(|group| group.all.at(sought));
        let (group, rest, of_group) = divided(groups, number)?;
        let lights = &self.groups[group].lights;
        let (place, _, of_light) = divided(lights.iter().map(|&light| self.lights[light].at(sought)), rest)?;
        Some((lights[place], of_group * of_light))
    }

    /// Returns the probability that a light is selected.
    pub(super) fn chance(&self, sought: Sought, light: usize) -> f64 {
        if self.lights.len() == 1 {
            return 1.0;
        }
        let group = &self.groups[self.of_lights[light]];
        let part = |own: f64, all: f64| if own > 0.0 { own / all } else { 0.0 };
        let groups = self.groups.iter().map(|group| group.all.at(sought)).sum();
        let lights = group.lights.iter().map(|&light| self.lights[light].at(sought)).sum();
        part(group.all.at(sought), groups) * part(self.lights[light].at(sought), lights)
    }
}

impl Weight {
    /// Returns the combined data of several lights; the data of a single light is kept as it is.
    pub(super) fn together<'w>(lights: impl Iterator<Item = &'w Self> + Clone) -> Self {
        let mut all = lights.clone();
        if let (Some(one), None) = (all.next(), all.next()) {
            return *one;
        }
        let near = lights.clone().filter(|light| light.strength > 0.0);
        let middles: Vec<Vector> = near.clone().map(|light| light.middle).collect();
        let middle = if middles.is_empty() { Vector::default() } else { Vector::mean(&middles) };
        let reach = |light: &Self| (light.middle - middle).length() + light.radius;
        Self {
            strength: near.clone().map(|light| light.strength).sum(),
            middle,
            radius: near.map(reach).fold(0.0, f64::max),
            far: lights.map(|light| light.far).sum(),
            direction: None,
            before: None,
        }
    }

    /// Returns the irradiance that the light or group can contribute.
    fn at(&self, Sought { from, to, normal }: Sought) -> f64 {
        let far = match (self.direction, normal) {
            (Some(direction), Some(normal)) => normal.dot(direction).max(0.0) * self.far,
            _ => self.far,
        };
        if self.before.is_some_and(|plane| plane.distance(from) <= 0.0 && plane.distance(to) <= 0.0) {
            return far;
        }
        let along = to - from;
        let squared = along.dot(along);
        let part =
            if squared > 0.0 { ((self.middle - from).dot(along) / squared).clamp(0.0, 1.0) } else { 0.0 };
        let offset = self.middle - (from + part * along);
        let least = offset.dot(offset).max(self.radius * self.radius).max(f64::MIN_POSITIVE);
        // the largest cosine of anything within the bounding sphere
        let cosine =
            normal.map_or(1.0, |normal| ((normal.dot(offset) + self.radius) / least.sqrt()).clamp(0.0, 1.0));
        far + cosine * self.strength / least
    }
}

/// Selects an entry by a number from 0 to 1, in proportion to the weights. Returns its index, the
/// position of the number within the entry, and its probability.
fn divided(weights: impl Iterator<Item = f64> + Clone, number: f64) -> Option<(usize, f64, f64)> {
    let all: f64 = weights.clone().sum();
    let along = number * all;
    let (mut before, mut found) = (0.0, None);
    for (place, own) in weights.enumerate().filter(|(_, own)| *own > 0.0) {
        found = Some((place, ((along - before) / own).clamp(0.0, 1.0), own / all));
        before += own;
        if along < before {
            break;
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    const fn lamp(strength: f64, [x, y, z]: [f64; 3]) -> Weight {
        Weight {
            strength,
            middle: Vector::new(x, y, z),
            radius: 0.1,
            far: 0.0,
            direction: None,
            before: None,
        }
    }

    const SUN: Weight = Weight { far: 500.0, ..lamp(0.0, [0.0; 3]) };

    /// Many lamps of all strengths along a helix, and the sun.
    fn many(count: usize) -> Choice {
        let lamp = |i: usize| {
            let turn = i as f64;
            lamp(10_f64.powi(i as i32 % 7), [turn.cos(), turn.sin(), 0.01 * turn])
        };
        Choice::among((1..count).map(lamp).chain([SUN]).collect())
    }

    #[test]
    fn chances_sum_to_one_and_are_those_of_the_parts_of_numbers() {
        for count in [1, 2, 5, 64, 65, 1000] {
            let choice = many(count);
            let sought = Sought::along(Vector::new(0.3, 0.1, 0.2), Vector::new(0.5, 2.0, 0.2));
            let sum: f64 = (0..count).map(|light| choice.chance(sought, light)).sum();
            assert!((sum - 1.0).abs() < 1e-12, "{count}: {sum}");
            const NUMBERS: usize = 100_000;
            let mut found = vec![0; count];
            for number in 0..NUMBERS {
                let number = (number as f64 + 0.5) / NUMBERS as f64;
                let (light, chance) = choice.choose(sought, number).expect("a light");
                assert!((chance - choice.chance(sought, light)).abs() <= 1e-12);
                found[light] += 1;
            }
            for (light, &times) in found.iter().enumerate() {
                let expected = NUMBERS as f64 * choice.chance(sought, light);
                assert!((f64::from(times) - expected).abs() < 3.0, "{count}, {light}: {times}, {expected}");
            }
        }
    }

    #[test]
    fn a_weak_lamp_that_is_near_is_chosen_beside_the_sun() {
        let choice = Choice::among(vec![SUN, lamp(5.0, [0.0, 0.0, 0.4])]);
        let place = |normal| Sought::at(Vector::default(), normal);
        assert!((choice.chance(place(None), 1) - 31.25 / 531.25).abs() < 1e-12);
        let down = Some(Vector::new(0.0, 0.0, -1.0));
        assert_eq!(choice.chance(place(down), 1), 0.0);
    }

    #[test]
    fn what_shines_to_the_other_side_is_not_chosen() {
        let plane = Plane { point: Vector::new(0.0, 0.0, 1.0), normal: Vector::new(0.0, 0.0, 1.0) };
        let ceiling = Weight { before: Some(plane), ..lamp(1e6, [0.0, 0.0, 1.0]) };
        let choice = Choice::among(vec![ceiling, lamp(1.0, [3.0, 0.0, 0.0])]);
        let chances = [0.0, 2.0].map(|z| choice.chance(Sought::at(Vector::new(0.0, 0.0, z), None), 0));
        assert!(chances[0] == 0.0 && chances[1] > 0.99, "{chances:?}");
    }
}
