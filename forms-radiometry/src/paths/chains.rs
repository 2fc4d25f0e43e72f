//! Mirror chains: sequences of flat mirrors in which emitters are seen, so that next-event
//! estimation at a vertex can sample these images of the emitters, too.
//!
//! ```text
//! flat mirrors ─▶ planes ─ one after the other, the brightest first ─▶ chains
//! vertex x, planes 1 … k ─▶ x' = Mₖ … M₁ x ─▶ direction ω' from x' to an emitter
//!                                         ─▶ direction M₁ … Mₖ ω' from x
//! ```
//! Mᵢ is the reflection at plane i, x − 2 ((x − a)·n) n for points. It preserves angles: a
//! direction from x has the same density as its image from x', and a path that the planes reflected
//! gets the MIS weight of an unreflected path from x'. Only tracing the ray shows whether the
//! mirrors lie where the chain needs them and whether an occluder is in the way. Light that no
//! chain covers is found by path sampling alone.

use super::choice::Sought;
use super::interface::Interface;
use crate::geometry::Plane;
use crate::geometry::Vector;
use crate::sampling::{chosen, shares};
use crate::scene::{MaterialKind, Scene};
use crate::visibility::{Met, Wall};

/// Maximum number of chains with mirrors, and of planes.
const MOST: usize = 64;
/// Planes are merged if their normals differ by less than this, and their positions by less than
/// this relative to the extent of the walls.
const SAME: f64 = 1e-10;
/// Images and chains of mirrors that leave less of their light than this fraction of the tolerance
/// are omitted.
pub(super) const LEAST_LISTED: f64 = 1e-3;

/// The mirror chains of a world.
pub(super) struct Chains {
    planes: Vec<Mirrors>,
    /// For each wall its plane, if it is a flat mirror.
    of_walls: Vec<Option<usize>>,
    /// All chains; the first one has no mirror.
    all: Vec<Chain>,
    /// Cumulative selection probabilities of the chains.
    chances: Vec<f64>,
    /// Largest fraction of an emitter's light that arrives along a specular path that is not
    /// listed.
    left_out: f64,
}

/// The mirrors in one plane.
struct Mirrors {
    plane: Plane,
    /// Corners of all these mirrors.
    corners: Vec<Vector>,
    /// Largest reflectance of any of these mirrors in any band.
    reflectance: f64,
    two_sided: bool,
}

/// A plane, and the side at which a ray from a receiver arrives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Step {
    plane: usize,
    is_front: bool,
}

/// Sequence of mirror planes along a ray from a receiver.
#[derive(Clone, Debug)]
pub(super) struct Chain {
    pub(super) steps: Vec<Step>,
    /// Upper bound on the fraction of the light that remains after all mirrors.
    left: f64,
    /// Selection probability; 0 if no emitter can be seen in the chain.
    pub(super) chance: f64,
    /// The chains that are one step longer: the step, and the index of the chain.
    longer: Vec<(Step, usize)>,
}

/// Mirrors of a chain as they are seen in its last mirror: the corners of each image, and its
/// plane, whose normal points to the side on which a ray continues.
type Windows = Vec<(Vec<Vector>, Plane)>;

impl Chains {
    /// Returns the mirror chains of a scene, whose walls extend over this length.
    pub(super) fn of(scene: &Scene, (walls, extent): (&[Wall], f64), interfaces: &[Interface]) -> Self {
        let emitting = |interface: &Interface| scene.surfaces[interface.surface].emits();
        let luminaires: Vec<Vec<Vector>> = walls
            .iter()
            .zip(interfaces)
            .filter(|(_, interface)| emitting(interface))
            .map(|(wall, _)| wall.corners())
            .collect();
        let mut chains = Self {
            planes: Vec::new(),
            of_walls: vec![None; walls.len()],
            all: vec![Chain { steps: Vec::new(), left: 1.0, chance: 0.0, longer: Vec::new() }],
            chances: Vec::new(),
            left_out: 0.0,
        };
        if luminaires.is_empty() {
            return chains;
        }
        for (wall, (shape, interface)) in walls.iter().zip(interfaces).enumerate() {
            chains.of_walls[wall] = chains.plane(scene, shape, interface, extent);
        }
        chains.list(&luminaires, LEAST_LISTED * scene.solve.tolerance);
        let weights: Vec<f64> = chains.all.iter().map(|chain| chain.chance).collect();
        let [chances, running] = shares(&weights);
        chains.all.iter_mut().zip(chances).for_each(|(chain, chance)| chain.chance = chance);
        chains.chances = running;
        chains
    }

    /// Returns the plane of a wall that is a flat mirror. The light of other specular walls is
    /// found by path sampling alone.
    fn plane(&mut self, scene: &Scene, wall: &Wall, interface: &Interface, extent: f64) -> Option<usize> {
        let surface = &scene.surfaces[interface.surface];
        let reflectance = match &scene.materials[surface.material].kind {
            MaterialKind::Diffuse { .. } | MaterialKind::Rough(_) => return None,
            MaterialKind::Dielectric { .. } => {
                self.left_out = if bends(scene, interface) { 1.0 } else { self.left_out };
                return None;
            }
            MaterialKind::Mirror { reflectance } => reflectance.iter().copied().fold(0.0, f64::max),
            MaterialKind::Plastic { specular, .. } => {
                self.left_out = specular.iter().copied().fold(self.left_out, f64::max);
                return None;
            }
            // the reflectance of a metal is largest at grazing incidence: 1
            MaterialKind::Conductor { .. } => 1.0,
        };
        let plane = wall.plane().filter(|_| !surface.shape.is_smooth());
        let place = plane.and_then(|plane| self.place(plane, extent));
        let Some(place) = place else {
            self.left_out = self.left_out.max(reflectance);
            return None;
        };
        let mirrors = &mut self.planes[place];
        mirrors.corners.extend(wall.corners());
        mirrors.reflectance = mirrors.reflectance.max(reflectance);
        mirrors.two_sided |= surface.two_sided;
        Some(place)
    }

    /// Returns the index of a plane. A new plane is added unless there are too many.
    fn place(&mut self, plane: Plane, extent: f64) -> Option<usize> {
        let is_same = |mirrors: &Mirrors| {
            (mirrors.plane.normal - plane.normal).length() < SAME
                && mirrors.plane.distance(plane.point).abs() < SAME * extent
        };
        let known = self.planes.iter().position(is_same);
        if known.is_none() && self.planes.len() < MOST {
            self.planes.push(Mirrors { plane, corners: Vec::new(), reflectance: 0.0, two_sided: false });
            return Some(self.planes.len() - 1);
        }
        known
    }

    /// Lists the chains that a ray can pass through, the brightest first.
    fn list(&mut self, luminaires: &[Vec<Vector>], least: f64) {
        let mut open: Vec<(usize, Windows)> = vec![(0, Vec::new())];
        while let Some(brightest) = self.brightest(&open) {
            let (index, windows) = open.swap_remove(brightest);
            for step in self.steps() {
                let Some(windows) = self.through(&windows, step) else { continue };
                let left = self.all[index].left * self.planes[step.plane].reflectance;
                if left <= least || self.all.len() > MOST {
                    self.left_out = self.left_out.max(left);
                    continue;
                }
                let is_seen =
                    |corners: &Vec<Vector>| windows.iter().all(|(_, plane)| reaches(*plane, corners));
                let chance = if luminaires.iter().any(is_seen) { left } else { 0.0 };
                let steps = [&self.all[index].steps[..], &[step]].concat();
                let longer = self.all.len();
                self.all[index].longer.push((step, longer));
                self.all.push(Chain { steps, left, chance, longer: Vec::new() });
                open.push((longer, windows));
            }
        }
    }

    /// Returns the position of the chain that leaves most light.
    fn brightest(&self, open: &[(usize, Windows)]) -> Option<usize> {
        let left = |place: &usize| self.all[open[*place].0].left;
        (0..open.len()).max_by(|a, b| left(a).total_cmp(&left(b)).then(b.cmp(a)))
    }

    /// Returns a step for each reflecting side of each plane.
    fn steps(&self) -> Vec<Step> {
        let sides = |plane: usize| [true, false].map(|is_front| Step { plane, is_front });
        let reflects = |step: &Step| step.is_front || self.planes[step.plane].two_sided;
        (0..self.planes.len()).flat_map(sides).filter(reflects).collect()
    }

    /// Returns the windows of a chain extended by one step, or `None` if no ray can pass through
    /// it: part of the new mirror has to lie beyond every earlier window, and part of every earlier
    /// window in front of the new mirror.
    fn through(&self, windows: &Windows, step: Step) -> Option<Windows> {
        let mirrors = &self.planes[step.plane];
        let own = self.facing(step);
        let is_free = |(corners, plane): &(Vec<Vector>, Plane)| {
            reaches(*plane, &mirrors.corners) && reaches(own, corners)
        };
        if !windows.iter().all(is_free) {
            return None;
        }
        let mirrored = |(corners, plane): &(Vec<Vector>, Plane)| {
            let corners = corners.iter().map(|&corner| own.mirrored(corner)).collect();
            (corners, Plane { point: own.mirrored(plane.point), normal: plane.normal.mirrored(own.normal) })
        };
        Some(windows.iter().map(mirrored).chain([(mirrors.corners.clone(), own)]).collect())
    }

    /// Returns the plane of a step, with its normal on the side at which a ray arrives and
    /// continues.
    fn facing(&self, step: Step) -> Plane {
        self.planes[step.plane].plane.facing(step.is_front)
    }

    /// Returns the largest fraction of an emitter's light that arrives along a specular path that
    /// is not listed.
    pub(super) fn left_out(&self) -> f64 {
        self.left_out
    }

    /// Selects a chain by a number from 0 to 1; `None` if no chain can be selected.
    pub(super) fn choose(&self, number: f64) -> Option<&Chain> {
        chosen(&self.chances, number).map(|place| &self.all[place]).filter(|chain| chain.chance > 0.0)
    }

    /// Whether a ray from a point can start a chain: the point lies in front of the first mirror.
    pub(super) fn is_before(&self, chain: &Chain, point: Vector) -> bool {
        chain.steps.first().is_some_and(|&step| self.facing(step).distance(point) > 0.0)
    }

    /// Returns the image of a point, from which the emitters in a chain are seen without mirrors:
    /// x' = Mₖ … M₁ x.
    pub(super) fn image(&self, chain: &Chain, point: Vector) -> Vector {
        chain.steps.iter().fold(point, |point, step| self.planes[step.plane].plane.mirrored(point))
    }

    /// Returns the mirror image, by a chain, of the point or segment for which emitters are
    /// selected.
    pub(super) fn sought(&self, chain: &Chain, sought: Sought) -> Sought {
        chain.steps.iter().fold(sought, |sought, step| sought.mirrored(self.planes[step.plane].plane))
    }

    /// Returns the virtual position of a point that is seen in a chain.
    pub(super) fn seen(&self, chain: &Chain, point: Vector) -> Vector {
        chain.steps.iter().rev().fold(point, |point, step| self.planes[step.plane].plane.mirrored(point))
    }

    /// Returns the direction in which a chain shows an object that lies in `direction` from the
    /// image of the receiver point.
    pub(super) fn seen_along(&self, chain: &Chain, direction: Vector) -> Vector {
        let turned = |offset: Vector, step: &Step| offset.mirrored(self.planes[step.plane].plane.normal);
        let along = chain.steps.iter().rev().fold(direction, turned);
        along.unit().unwrap_or(along)
    }

    /// Whether the wall that a ray hit lies in the plane and on the side of this step.
    pub(super) fn is_at(&self, step: Step, met: &Met) -> bool {
        self.of_walls[met.wall] == Some(step.plane) && met.is_front == step.is_front
    }

    /// Returns the chain of a path after one more mirror, and the plane of this mirror.
    pub(super) fn after(&self, chain: usize, met: &Met) -> Option<(usize, Plane)> {
        let step = Step { plane: self.of_walls[met.wall]?, is_front: met.is_front };
        let (_, longer) = self.all[chain].longer.iter().find(|(next, _)| *next == step)?;
        Some((*longer, self.planes[step.plane].plane))
    }

    /// Returns the selection probability of a chain. It is 1 without mirrors, since directly
    /// visible emitters are always sampled.
    pub(super) fn chance(&self, chain: usize) -> f64 {
        if chain == 0 { 1.0 } else { self.all[chain].chance }
    }

    /// Whether no emitter can be seen in any chain.
    pub(super) fn are_none(&self) -> bool {
        self.chances.last().is_none_or(|&sum| sum == 0.0)
    }
}

/// Whether any of these corners lies beyond a plane by more than rounding.
fn reaches(plane: Plane, corners: &[Vector]) -> bool {
    let farthest = corners.iter().map(|&corner| (corner - plane.point).length()).fold(0.0, f64::max);
    corners.iter().any(|&corner| plane.distance(corner) > SAME * farthest)
}

/// Whether the boundary of two media refracts or reflects light in any band.
fn bends(scene: &Scene, interface: &Interface) -> bool {
    let index = |is_front: bool, band: usize| {
        interface.filling(is_front).map_or(1.0, |medium| scene.media[medium].index[band])
    };
    (0..scene.band_count()).any(|band| index(true, band) != index(false, band))
}
