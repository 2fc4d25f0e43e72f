//! Chains: sequences of flat mirrors in which luminaires are seen, so that a vertex can look for these images of them, too.
//!
//! ```text
//! flat mirrors ─▶ planes ─ one after the other, the brightest first ─▶ chains
//! vertex x, planes 1 … k ─▶ x' = Mₖ … M₁ x ─▶ a direction ω' from x' to a luminaire ─▶ M₁ … Mₖ ω', the direction from x
//! ```
//! Mᵢ is the reflection at plane i, x − 2 ((x − a)·n) n of points. It keeps angles: a direction from x has the density that its image has from
//! x', and a path that was reflected by the planes is weighed as if it came straight from x'. Whether mirrors are where they are needed, and
//! whether anything else is in the way, only the ray tells. What no chain finds is found by chance.

use super::choice::Sought;
use super::luminaires::extent;
use super::world::Sheet;
use crate::geometry::{Met, Plane, Vector, Wall};
use crate::sampling::chosen;
use crate::scene::{MaterialKind, Scene};

/// The most chains.
const MOST: usize = 64;
/// Chains that leave less than this part of the tolerance of the light are not listed.
const FAINT: f64 = 1e-3;
/// Planes whose normals and places differ by less than this, beside the extent of the mirrors, are one.
const SAME: f64 = 1e-10;

/// The chains of a world.
pub(super) struct Chains {
    planes: Vec<Mirrors>,
    /// By wall its plane, if it is a flat mirror.
    of_walls: Vec<Option<usize>>,
    /// The first is that without a mirror.
    all: Vec<Chain>,
    /// The chance of each chain and of all before it.
    chances: Vec<f64>,
    /// The largest part of the light of a luminaire that comes in a way which is not listed.
    left_out: f64,
}

/// The mirrors of a plane.
struct Mirrors {
    plane: Plane,
    /// The corners of all of them.
    corners: Vec<Vector>,
    /// The largest part of the light that one of them reflects in any band.
    reflectance: f64,
    two_sided: bool,
}

/// A plane, and the side at which a ray from a receiver arrives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Step {
    plane: usize,
    is_front: bool,
}

/// The steps of a ray from a receiver.
#[derive(Clone, Debug)]
pub(super) struct Chain {
    pub(super) steps: Vec<Step>,
    /// The part of the light that is left in the end, at most.
    left: f64,
    /// How likely it is chosen; not at all where no luminaire can be seen in it.
    pub(super) chance: f64,
    /// What it becomes by one step more.
    longer: Vec<(Step, usize)>,
}

/// The corners of mirrors as they are seen from behind the last one of a chain, and their planes, whose normals point to where a ray goes on.
type Windows = Vec<(Vec<Vector>, Plane)>;

impl Chains {
    pub(super) fn of(scene: &Scene, walls: &[Wall], sheets: &[Sheet]) -> Self {
        let emitting = |sheet: &Sheet| scene.surfaces[sheet.surface].emits();
        let luminaires: Vec<Vec<Vector>> = walls
            .iter()
            .zip(sheets)
            .filter(|(_, sheet)| emitting(sheet))
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
        let extent = extent(walls);
        for (wall, (shape, sheet)) in walls.iter().zip(sheets).enumerate() {
            chains.of_walls[wall] = chains.plane(scene, shape, sheet, extent);
        }
        chains.list(&luminaires, FAINT * scene.solve.tolerance);
        let whole: f64 = chains.all.iter().map(|chain| chain.chance).sum();
        let mut sum = 0.0;
        for chain in &mut chains.all {
            chain.chance /= whole.max(f64::MIN_POSITIVE);
            sum += chain.chance;
            chains.chances.push(sum);
        }
        chains
    }

    /// The plane of a wall that is a flat mirror. What other smooth walls do is found by chance.
    fn plane(&mut self, scene: &Scene, wall: &Wall, sheet: &Sheet, extent: f64) -> Option<usize> {
        let surface = &scene.surfaces[sheet.surface];
        let reflectance = match &scene.materials[surface.material].kind {
            MaterialKind::Diffuse { .. } => return None,
            MaterialKind::Dielectric { .. } => {
                self.left_out = if bends(scene, sheet) { 1.0 } else { self.left_out };
                return None;
            }
            MaterialKind::Mirror { reflectance } => reflectance.iter().copied().fold(0.0, f64::max),
            // a metal reflects most at a grazing angle: all
            MaterialKind::Conductor { .. } => 1.0,
        };
        let place = wall.plane().and_then(|plane| self.place(plane, extent));
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

    /// The place of a plane among all, to which it is added if it is new and they are not too many.
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

    /// Lists the chains that a ray can go through, the brightest first.
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

    /// Which of these chains leaves most light.
    fn brightest(&self, open: &[(usize, Windows)]) -> Option<usize> {
        let left = |place: &usize| self.all[open[*place].0].left;
        (0..open.len()).max_by(|a, b| left(a).total_cmp(&left(b)).then(b.cmp(a)))
    }

    /// All planes, and the sides of them that reflect.
    fn steps(&self) -> Vec<Step> {
        let sides = |plane: usize| [true, false].map(|is_front| Step { plane, is_front });
        let reflects = |step: &Step| step.is_front || self.planes[step.plane].two_sided;
        (0..self.planes.len()).flat_map(sides).filter(reflects).collect()
    }

    /// What a ray passes through with a step more; nothing if none can: of the new mirror something has to be beyond all others, and of these
    /// something before it.
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

    /// The plane of a step, with its normal to the side at which a ray arrives, and goes on.
    fn facing(&self, step: Step) -> Plane {
        self.planes[step.plane].plane.facing(step.is_front)
    }

    /// The largest part of the light of a luminaire that comes in a way which is not listed.
    pub(super) fn left_out(&self) -> f64 {
        self.left_out
    }

    /// A chain by a number from 0 to 1; none if there is none.
    pub(super) fn choose(&self, number: f64) -> Option<&Chain> {
        chosen(&self.chances, number).map(|place| &self.all[place]).filter(|chain| chain.chance > 0.0)
    }

    /// Whether a ray from a point can begin a chain.
    pub(super) fn is_before(&self, chain: &Chain, point: Vector) -> bool {
        chain.steps.first().is_some_and(|&step| self.facing(step).distance(point) > 0.0)
    }

    /// Where a point seems to be for what it sees in a chain.
    pub(super) fn image(&self, chain: &Chain, point: Vector) -> Vector {
        chain.steps.iter().fold(point, |point, step| self.planes[step.plane].plane.mirrored(point))
    }

    /// Where luminaires are looked for, as a chain shows it.
    pub(super) fn sought(&self, chain: &Chain, sought: Sought) -> Sought {
        chain.steps.iter().fold(sought, |sought, step| sought.mirrored(self.planes[step.plane].plane))
    }

    /// Where a point seems to be that is seen in a chain.
    pub(super) fn seen(&self, chain: &Chain, point: Vector) -> Vector {
        chain.steps.iter().rev().fold(point, |point, step| self.planes[step.plane].plane.mirrored(point))
    }

    /// The direction in which something is seen in a chain that is in this direction from the image of the point.
    pub(super) fn seen_along(&self, chain: &Chain, direction: Vector) -> Vector {
        let turned = |way: Vector, step: &Step| way.mirrored(self.planes[step.plane].plane.normal);
        let along = chain.steps.iter().rev().fold(direction, turned);
        along.unit().unwrap_or(along)
    }

    /// Whether a wall is where this step has to be.
    pub(super) fn is_at(&self, step: Step, met: &Met) -> bool {
        self.of_walls[met.wall] == Some(step.plane) && met.is_front == step.is_front
    }

    /// The chain that a path has gone through after one more mirror, and the plane of that.
    pub(super) fn after(&self, chain: usize, met: &Met) -> Option<(usize, Plane)> {
        let step = Step { plane: self.of_walls[met.wall]?, is_front: met.is_front };
        let (_, longer) = self.all[chain].longer.iter().find(|(next, _)| *next == step)?;
        Some((*longer, self.planes[step.plane].plane))
    }

    /// How likely it is that a chain is chosen; luminaires straight ahead are looked for in any case.
    pub(super) fn chance(&self, chain: usize) -> f64 {
        if chain == 0 { 1.0 } else { self.all[chain].chance }
    }

    /// Whether no luminaire can be seen in any.
    pub(super) fn are_none(&self) -> bool {
        self.chances.last().is_none_or(|&sum| sum == 0.0)
    }
}

/// Whether any of these corners is beyond a plane, by more than rounding.
fn reaches(plane: Plane, corners: &[Vector]) -> bool {
    let farthest = corners.iter().map(|&corner| (corner - plane.point).length()).fold(0.0, f64::max);
    corners.iter().any(|&corner| plane.distance(corner) > SAME * farthest)
}

/// Whether light is bent or reflected at the boundary of two media, in any band.
fn bends(scene: &Scene, sheet: &Sheet) -> bool {
    let index = |is_front: bool, band: usize| {
        sheet.filling(is_front).map_or(1.0, |medium| scene.media[medium].index[band])
    };
    (0..scene.band_count()).any(|band| index(true, band) != index(false, band))
}
