//! World: a scene becomes walls, the primitives that rays hit, with media on both sides, and light
//! sources.

use super::chains::Chains;
use super::environment_light::EnvironmentLight;
use super::first_hit::FirstHit;
use super::interface::Interface;
use super::luminaires::{Front, Luminaires};
use super::optics::{Optics, times};
use super::rough_lobes::rough_coat;
use super::shading_normals::ShadingNormals;
use super::wall_textures::WallTextures;
use crate::geometry::{Outline, Vector};
use crate::scene::{
    FilledInterface, Filling, MaterialKind, Piece, RoughTransmittance, Scene, Surface, filled,
};
use crate::visibility::{Met, ReceivingArea, Start, Wall, Walls};
use rustc_hash::FxHashMap;
use std::fmt;
use std::sync::{Arc, OnceLock};

/// Side of a wall at which a ray arrives.
pub(super) struct Side {
    /// Whether it is the front.
    pub(super) is_front: bool,
    /// The unit normal on that side, by which light is scattered.
    pub(super) normal: Vector,
    /// Whether the normal is interpolated.
    pub(super) is_smooth: bool,
}

/// A scene prepared for path tracing.
pub(crate) struct World {
    pub(crate) scene: Arc<Scene>,
    pub(super) walls: Walls,
    /// The interface that each wall belongs to.
    pub(super) interfaces: Vec<Interface>,
    /// Whether the medium around the scene is on both sides of all walls.
    is_of_one_medium: bool,
    /// Whether every wall ends all light that goes straight on.
    pub(super) is_opaque: bool,
    pub(super) luminaires: Luminaires,
    /// Light from outside, if it depends on the direction.
    pub(super) environment: Option<EnvironmentLight>,
    /// The chains of flat mirrors in which emitters are seen.
    pub(super) chains: Chains,
    /// The walls of each surface, and its front, once a receiver or a light source needs it.
    fronts: Vec<(Vec<u32>, OnceLock<Front>)>,
    /// The faces that receivers measure one by one, by the indices of surface and face.
    faces: FxHashMap<[usize; 2], Front>,
    /// The interpolated normals of the walls of smooth meshes.
    shading: ShadingNormals,
    /// The textures of the walls.
    pub(super) textures: WallTextures,
    /// The transmittance of the coat of each rough material that has one.
    pub(super) rough_coats: Vec<Option<Box<RoughTransmittance>>>,
}

impl World {
    pub(crate) fn new(scene: Arc<Scene>) -> Self {
        let (mut walls, mut interfaces) = (Vec::new(), Vec::new());
        let mut shading = ShadingNormals::of(&scene);
        for FilledInterface { interface, front, back } in filled(&scene) {
            let of_sheet = walls_of(interface.shape);
            let (surface, part) = (interface.surface, interface.part);
            let belongs = Interface { surface, part, fillings: [front, back] };
            shading.add_piece(&scene, surface, of_sheet.len());
            interfaces.extend(of_sheet.iter().map(|_| belongs));
            walls.extend(of_sheet);
        }
        let extent = extent(&walls);
        let luminaires = Luminaires::of(&scene, (&walls, extent), &interfaces);
        let chains = Chains::of(&scene, (&walls, extent), &interfaces);
        let mut of_surfaces = vec![Vec::new(); scene.surfaces.len()];
        for (wall, interface) in interfaces.iter().enumerate() {
            of_surfaces[interface.surface].push(wall as u32);
        }
        let fronts = of_surfaces.into_iter().map(|own| (own, OnceLock::new())).collect();
        let of_faces = measured_faces(&scene, &interfaces);
        let front = |own: &Vec<usize>| Front::of(own.iter().map(|&wall| (wall, &walls[wall])));
        let faces = of_faces.iter().map(|(&face, own)| (face, front(own))).collect();
        let environment = scene.ambient.map.as_ref().map(EnvironmentLight::of);
        let rough_coats = scene.materials.iter().map(rough_coat).collect();
        let textures = WallTextures::of(&scene, &walls, &interfaces);
        let walls = Walls::of(walls);
        let is_boundary = |surface: &Surface| {
            matches!(scene.materials[surface.material].kind, MaterialKind::Dielectric { .. })
        };
        let is_opaque = !scene.surfaces.iter().any(is_boundary);
        let is_of_one_medium = interfaces.iter().all(|one| one.fillings == [scene.ambient.medium; 2]);
        Self {
            scene,
            walls,
            interfaces,
            is_of_one_medium,
            is_opaque,
            luminaires,
            environment,
            chains,
            fronts,
            faces,
            shading,
            textures,
            rough_coats,
        }
    }

    /// Returns the walls of a receiving area, which has both sides of them.
    pub(super) fn walls_in(&self, area: ReceivingArea) -> Option<&Front> {
        match area.face {
            None => Some(self.front(area.surface)),
            Some(face) => self.faces.get(&[area.surface, face]),
        }
    }

    /// Returns the front of a surface.
    pub(super) fn front(&self, surface: usize) -> &Front {
        let (own, front) = &self.fronts[surface];
        let walls = own.iter().map(|&wall| (wall as usize, self.walls.get(wall as usize)));
        front.get_or_init(|| Front::of(walls))
    }

    /// Returns the largest fraction of an emitter's light that mirrors and boundaries turn along a
    /// specular path that is not sampled.
    pub(crate) fn turned_by_chance(&self) -> f64 {
        self.chains.left_out()
    }

    /// Whether next-event estimation samples light that rays can also find by chance.
    pub(super) fn samples_lights(&self) -> bool {
        self.luminaires.are_met() || self.environment.is_some()
    }

    /// Whether light from outside is found only by chance, at least via mirrors or boundaries.
    pub(crate) fn finds_outside_by_chance(&self) -> bool {
        let is_specular = |surface: &Surface| {
            !matches!(
                self.scene.materials[surface.material].kind,
                MaterialKind::Diffuse { .. } | MaterialKind::Rough(_)
            )
        };
        self.environment.is_none() || self.scene.surfaces.iter().any(is_specular)
    }

    /// Returns the number of rays that are traced from a vertex.
    pub(super) fn rays_of_a_vertex(&self) -> f64 {
        (1 + self.luminaires.sampled() + usize::from(self.environment.is_some())) as f64
    }

    /// Returns the medium that a ray starts in.
    pub(super) fn medium_at(&self, start: Start, direction: Vector) -> Filling {
        if self.is_of_one_medium {
            return self.scene.ambient.medium;
        }
        match self.walls.first(start, direction, f64::INFINITY) {
            Some(Met { wall, is_front, .. }) => self.interfaces[wall].filling(is_front),
            None => self.scene.ambient.medium,
        }
    }

    /// Returns the first hit of a ray. If the ray misses, the surroundings can be the emitter.
    pub(super) fn seen(&self, start: Start, direction: Vector) -> FirstHit {
        match self.walls.first(start, direction, f64::INFINITY) {
            Some(Met { wall, is_front, .. }) => {
                let surface = self.interfaces[wall].surface;
                let is_emitter = self.scene.surfaces[surface].emits() && self.is_bright(wall, is_front);
                FirstHit { is_emitter, surface: Ok(Some(surface)) }
            }
            None => {
                let is_emitter = self.scene.ambient.radiance.iter().any(|&radiance| radiance > 0.0);
                FirstHit { is_emitter, surface: Ok(None) }
            }
        }
    }

    /// Whether light leaves a side of a wall: the side is a front, or belongs to a two-sided
    /// surface.
    pub(super) fn is_bright(&self, wall: usize, is_front: bool) -> bool {
        is_front || self.scene.surfaces[self.interfaces[wall].surface].two_sided
    }

    /// Returns the side of a wall at which a ray arrives. Interpolated normals decide about it where
    /// there are any.
    pub(super) fn side(&self, met: &Met, direction: Vector) -> Side {
        let normal = self.shading.normal(met.wall, met.position);
        let is_front = normal.map_or(met.is_front, |normal| normal.dot(direction) < 0.0);
        let front = normal.unwrap_or(met.normal);
        Side { is_front, normal: if is_front { front } else { -front }, is_smooth: normal.is_some() }
    }

    /// Returns the reflectance at a place on a wall: that of its material times the factor of its
    /// texture.
    pub(super) fn reflectance<const N: usize>(&self, optics: &Optics<N>, met: &Met) -> [f64; N] {
        self.textured(optics, met, &optics.reflectances[self.interfaces[met.wall].surface])
    }

    /// Returns a reflectance times the factor of the texture at a place on a wall.
    pub(super) fn textured<const N: usize>(
        &self,
        optics: &Optics<N>,
        met: &Met,
        reflectance: &[f64; N],
    ) -> [f64; N] {
        let factor = self.textures.factor(met, optics.bands);
        factor.map_or(*reflectance, |factor| times(reflectance, &factor))
    }

    /// Returns the reflection law of a wall.
    pub(super) fn material(&self, wall: usize) -> &MaterialKind {
        &self.scene.materials[self.scene.surfaces[self.interfaces[wall].surface].material].kind
    }
}

impl fmt::Debug for World {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("World").field("walls", &self.interfaces.len()).finish_non_exhaustive()
    }
}

/// Returns the walls of each face that receivers measure, by the indices of surface and face.
fn measured_faces(scene: &Scene, interfaces: &[Interface]) -> FxHashMap<[usize; 2], Vec<usize>> {
    let are_measured = scene.are_faces_measured();
    let mut of_faces: FxHashMap<[usize; 2], Vec<usize>> = FxHashMap::default();
    for (wall, interface) in interfaces.iter().enumerate().filter(|(_, i)| are_measured[i.surface]) {
        of_faces.entry([interface.surface, interface.part]).or_default().push(wall);
    }
    of_faces
}

/// Returns the convex walls of a sheet.
pub(crate) fn walls_of(piece: Piece) -> Vec<Wall> {
    match piece {
        Piece::Face(polygon, _) => {
            let normal = polygon.normal();
            let pieces = polygon.convex_pieces().iter();
            pieces.map(|piece| Wall::Polygon { vertices: Outline::from_slice(piece), normal }).collect()
        }
        Piece::Sphere(sphere) => vec![Wall::Sphere(sphere)],
        Piece::Disk(disk) => vec![Wall::Disk(disk)],
        Piece::Quadric(quadric) => vec![Wall::Quadric(quadric)],
    }
}

/// Returns a length over which the scene extends.
fn extent(walls: &[Wall]) -> f64 {
    let corners: Vec<Vector> = walls.iter().flat_map(Wall::corners).collect();
    let Some(&first) = corners.first() else { return 1.0 };
    corners.iter().map(|&corner| (corner - first).length()).fold(0.0, f64::max)
}
