//! Visibility: faces become screens, the occluding polygons of the scene, in a BVH. Queries return
//! the part of a luminaire that a point sees, the screens that can occlude one outline from
//! another, and the first intersection of a ray.
//!
//! ```text
//! faces ─▶ screens in a BVH
//!     ├─ between: outlines of receivers and of a luminaire ─▶ potential occluders
//!     ├─ above_horizon: a point and a luminaire ─▶ the part above the horizon, without occlusion
//!     ├─ visible: a point, a luminaire and these screens ─▶ convex pieces that the point sees
//!     ├─ border: points, a luminaire and these screens ─▶ form factors of the visible parts
//!     └─ first, hides: a ray ─▶ its first intersection
//! ```
//! The visible part is exact up to rounding: the cone of directions of every screen is clipped out
//! of the luminaire's cone. A point that lies in the plane of a screen sees it edge-on, so a
//! surface does not occlude its own points.
//!
//! Rays that continue from surface to surface intersect the exact shapes, including disks and
//! spheres (`ray_walls`).

mod arrangement;
mod aspect;
mod beam;
mod body;
mod boxes;
mod branches;
mod cone;
mod horizon;
mod occluder_search;
mod ray;
mod ray_walls;
mod receiving_area;
mod shaft;
mod silhouette_columns;
mod silhouette_crossing;
mod tree;
mod visible;

pub(crate) use aspect::Looking;
pub(crate) use beam::{Beam, Lit};
pub(crate) use boxes::{Boxes, distance_of_boxes};
pub(crate) use horizon::Workspace;
pub(crate) use occluder_search::Between;
pub(crate) use ray_walls::{Met, Start, Wall, Walls};
pub(crate) use receiving_area::ReceivingArea;
pub(crate) use silhouette_columns::{Aspects, Borders};

use crate::geometry::bounds::Bounds;
use crate::geometry::plane::{ROUNDING, flatness};
use crate::geometry::{Outline, Plane, Polygon, Vector, edges};
use body::{Body, bodies};
use branches::Branches;
use tree::Tree;

/// A convex planar piece of one side of a surface; it emits or reflects light, or only blocks it.
#[derive(Clone, Debug)]
pub(crate) struct Face {
    /// The index of the surface.
    pub(crate) surface: usize,
    /// The index of the face of a mesh that it belongs to, where receivers measure these faces;
    /// otherwise 0.
    pub(crate) part: usize,
    /// Whether it is the surface's back.
    pub(crate) is_back: bool,
    /// The vertices, counter-clockwise seen from the side that the face shows.
    pub(crate) vertices: Outline,
    /// The unit normal to that side.
    pub(crate) normal: Vector,
    /// The area.
    pub(crate) area: f64,
}

impl Face {
    /// Returns the faces of a polygon: the front of each convex piece, followed by its back.
    pub(crate) fn of(surface: usize, polygon: &Polygon) -> impl Iterator<Item = Self> {
        let normal = polygon.normal();
        polygon.convex_pieces().iter().flat_map(move |piece| Self::sides(surface, piece, normal))
    }

    /// Returns front and back of a triangle or trapezoid; nothing if it is too narrow to have a
    /// normal.
    pub(crate) fn of_outline(surface: usize, vertices: &[Vector]) -> impl Iterator<Item = Self> + use<> {
        let (first, last) = (vertices[0], vertices.len() - 1);
        let normal = match *vertices {
            [a, b, c, d] => (c - a).cross(d - b).unit(),
            _ => (vertices[1] - first).cross(vertices[last] - first).unit(),
        };
        normal.map(|normal| Self::sides(surface, vertices, normal)).into_iter().flatten()
    }

    /// Returns front and back of a convex outline with this unit normal.
    pub(crate) fn sides(surface: usize, vertices: &[Vector], normal: Vector) -> [Self; 2] {
        let about = vertices[0];
        let twice = |pair: &[Vector]| normal.dot((pair[0] - about).cross(pair[1] - about));
        let area = 0.5 * vertices.windows(2).map(twice).sum::<f64>();
        let (front, back) = (Outline::from_slice(vertices), vertices.iter().rev().copied().collect());
        [
            Self { surface, part: 0, is_back: false, vertices: front, normal, area },
            Self { surface, part: 0, is_back: true, vertices: back, normal: -normal, area },
        ]
    }
}

/// An occluding polygon: a convex piece of an opaque surface.
#[derive(Clone, Debug)]
struct Screen {
    vertices: Outline,
    plane: Plane,
    /// The indices of its front and its back among the faces.
    sides: [usize; 2],
}

impl Screen {
    /// Returns the edges, from each vertex to the next.
    fn edges(&self) -> impl Iterator<Item = [Vector; 2]> {
        edges(&self.vertices)
    }
}

/// The occluders of a scene.
#[derive(Clone, Debug)]
pub(crate) struct Screens {
    screens: Vec<Screen>,
    /// The convex bodies that some of the screens bound. Lists of occluders between a point and a
    /// luminaire contain indices of screens and, from the number of screens on, of bodies.
    bodies: Vec<Body>,
    /// The body of each screen, if any.
    body_of: Vec<Option<u32>>,
    tree: Tree,
    /// The same tree laid out for rays; `None` where there are no screens.
    branches: Option<Branches>,
    /// A point that is nearer to a plane than this counts as lying in it: no face deviates more
    /// from its own plane.
    resolution: f64,
    /// Rounding error of a distance in the scene.
    rounding: f64,
}

impl Screens {
    /// Returns the distance below which a point counts as lying in a plane.
    pub(crate) fn resolution(&self) -> f64 {
        self.resolution
    }

    /// Returns the rounding error of a distance in the scene.
    pub(crate) fn rounding(&self) -> f64 {
        self.rounding
    }

    /// Returns the number of screens.
    pub(crate) fn count(&self) -> usize {
        self.screens.len()
    }

    /// Returns the indices of the front faces of the screens or bodies with these indices.
    pub(crate) fn fronts<'f>(&'f self, found: &'f [u32]) -> impl Iterator<Item = usize> + 'f {
        found
            .iter()
            .flat_map(|index| self.screens_of(index))
            .map(|&index| self.screens[index as usize].sides[0])
    }

    /// Returns the indices of the screens that an index denotes: itself, or the screens of a body.
    fn screens_of<'i>(&'i self, index: &'i u32) -> &'i [u32] {
        let body = (*index as usize).checked_sub(self.screens.len());
        body.map_or(std::slice::from_ref(index), |body| &self.bodies[body].screens)
    }

    /// Builds the screens of faces, with their convex bodies. Each front is followed by its back,
    /// if the back is among the faces at all.
    pub(crate) fn of(faces: &[Face]) -> Self {
        let mut screens = Self::met_by_rays(faces);
        (screens.bodies, screens.body_of) = bodies(&screens.screens, screens.resolution, screens.rounding);
        screens
    }

    /// Builds the screens of faces for ray queries only. They do not support the queries for the
    /// visible part of a luminaire.
    pub(crate) fn met_by_rays(faces: &[Face]) -> Self {
        let screen = |(index, face): (usize, &Face)| {
            let back = faces.get(index + 1).filter(|next| next.is_back);
            let plane = Plane { point: face.vertices[0], normal: face.normal };
            let sides = [index, if back.is_some() { index + 1 } else { index }];
            (!face.is_back).then(|| Screen { vertices: face.vertices.clone(), plane, sides })
        };
        let screens: Vec<Screen> = faces.iter().enumerate().filter_map(screen).collect();
        let none = Self::none(faces);
        let boxes: Vec<Bounds> = screens
            .iter()
            .map(|screen| Bounds::of(screen.vertices.iter().copied()).wider(none.resolution))
            .collect();
        let tree = Tree::of(&boxes);
        let branches = Some(Branches::of(&tree));
        Self { screens, tree, branches, ..none }
    }

    /// Returns an empty set of screens for a scene of these faces in which occlusion is neglected.
    pub(crate) fn none(faces: &[Face]) -> Self {
        let corners = || faces.iter().flat_map(|face| &face.vertices).copied();
        let all = Bounds::of(corners());
        let rounding = ROUNDING * if faces.is_empty() { 0.0 } else { all.extent().max(all.largest()) };
        Self {
            screens: Vec::new(),
            bodies: Vec::new(),
            body_of: Vec::new(),
            tree: Tree::default(),
            branches: None,
            resolution: rounding
                + faces.iter().map(|face| flatness(&face.vertices, face.normal)).fold(0.0, f64::max),
            rounding,
        }
    }
}

#[cfg(test)]
mod tests;
