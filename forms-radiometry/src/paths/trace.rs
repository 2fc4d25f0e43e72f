//! Samples of paths: an estimand and the random numbers of one sample become the light of one path,
//! which is added to the sums of the estimand.

use super::choice::Sought;
use super::estimand::{Begin, Estimand};
use super::path_sampler::PathSampler;
use super::specialisation::Specialisation;
use super::sums::Sums;
use super::tracer::{Path, Tracer};
use super::vertex::{Law, Vertex};
use crate::geometry::Vector;
use crate::sampling::Draws;
use crate::visibility::Start;

impl<L: Specialisation, const N: usize> PathSampler for Tracer<'_, L, N> {
    fn bands(&self) -> [usize; 2] {
        self.optics.bands
    }

    fn expanded(&self, estimand: &Estimand) -> Option<Vec<[f64; 2]>> {
        let Estimand::Sight { origin, direction } = estimand else { return None };
        self.expansion(self.world.walls.start_at(*origin), *direction)
    }

    fn sample(&self, estimand: &Estimand, draws: &mut Draws, sums: &mut Sums) {
        let [first, count] = self.optics.bands;
        let mut add = |direction: Vector, value: &[f64; N], optical_path_length: f64| {
            let Some(bin) = sums.bin(optical_path_length) else { return };
            estimand.measure(direction, &mut |number, factor| {
                (0..count).for_each(|band| sums.add([number, first + band, bin], factor * value[band]));
            });
        };
        let is_same = estimand.is_of_one_place();
        match estimand.begin(self.world, &mut draws.path) {
            Some(Begin::Sight { start, direction }) => {
                let most = self.limits.reflections.map(|most| most.saturating_add(1));
                let path = Path { is_same, most, ..self.begin(start, direction) };
                self.follow(path, draws, &mut |value, optical_path_length| {
                    add(direction, value, optical_path_length);
                });
            }
            Some(Begin::Receiver { start, normal }) => {
                self.receive((start, normal, is_same), draws, &mut add);
            }
            None => {}
        }
        for (band, hidden) in (first..first + count).zip(draws.hidden) {
            sums.miss(band, estimand.largest(hidden));
        }
    }
}

impl<L: Specialisation, const N: usize> Tracer<'_, L, N> {
    /// Returns a new path with this start and direction.
    fn begin(&self, start: Start, direction: Vector) -> Path<N> {
        Path {
            start,
            direction,
            filling: self.world.medium_at(start, direction),
            throughput: [1.0; N],
            optical_path_length: 0.0,
            vertex: start.position,
            sought: Sought::at(start.position, None),
            density: f64::INFINITY,
            chain: 0,
            reflections: 0,
            most: self.limits.reflections,
            scatterings: 0,
            events: 0,
            specular_depth: 0,
            is_straight: true,
            is_same: false,
        }
    }

    /// Adds the light that a receiver gets: direct light, and the light of one path.
    fn receive(
        &self,
        (start, normal, is_same): (Start, Option<Vector>, bool),
        draws: &mut Draws,
        add: &mut impl FnMut(Vector, &[f64; N], f64),
    ) {
        let law = normal.map_or(Law::Sphere, Law::Plane);
        let mut path = Path { is_same, ..self.begin(start, normal.unwrap_or(Vector::new(0.0, 0.0, 1.0))) };
        let vertex = Vertex { start, law };
        self.by_images(&path, &vertex, draws, add);
        if self.limits.direct {
            self.sample_direct_light(&path, &vertex, draws, add);
        }
        self.scatter(&mut path, &vertex, &mut draws.path);
        path.is_straight = true;
        let direction = path.direction;
        self.follow(path, draws, &mut |value, optical_path_length| {
            add(direction, value, optical_path_length);
        });
    }
}
