//! Unoccluded spheres and disks: form factor and solid angle at a point, in double-double.
//!
//! ```text
//! sphere ─ distance of the centre, cos θ of its direction
//!        ─▶ form_factor_point_sphere, solid_angle_sphere
//! disk ─ height over it, vector from its axis ─▶ form_factor_point_disk, form_factor_beside_disk
//!      ─▶ vector irradiance
//! ```
//! The result is `None` where there is no such closed form: for a disk that the horizon cuts, for
//! the solid angle of a disk from a point off its axis, and for a point so near to a plane or a
//! border that its side is not known.

use super::{Precise, Rounded, TERM, cross, dot, length, unit, way};
use crate::geometry::round::across;
use crate::geometry::{Disk, Sphere, Vector};
use forms::math::{DoubleDouble, Real};
use forms_kernels::{
    form_factor_beside_disk, form_factor_point_disk, form_factor_point_sphere, solid_angle_disk,
    solid_angle_sphere,
};

/// Rounding error of a kernel in this module, in units of the error of a term.
const OF_KERNEL: f64 = 2.0;

/// A shape that a point sees completely, without occlusion.
pub(crate) trait SeenWhole {
    /// Whether a point sees its front rather than its back.
    fn shows_front(&self, point: Vector) -> bool;

    /// Returns ∫ cos θ dω/π over the shape; θ is measured from `direction`. With a horizon, only
    /// the part above the plane with the normal `direction` counts.
    fn form_factor(&self, point: Vector, direction: Vector, has_horizon: bool) -> Option<Rounded>;

    /// Returns the solid angle over π.
    fn solid_angle_over_pi(&self, point: Vector) -> Option<Rounded>;

    /// Returns a rectangle that hides the shape from the point, and its unit normal towards the
    /// point. The rectangle lies in front of the whole visible part, and hides no part of the shape
    /// that the point does not see.
    fn outline(&self, point: Vector) -> Option<([Vector; 4], Vector)>;
}

/// Returns the square with this centre, half side and normal, counter-clockwise seen from the side
/// to which the normal points.
fn square(center: Vector, half: f64, normal: Vector) -> Option<([Vector; 4], Vector)> {
    let [u, v] = across(normal).map(|along| half * along);
    let corners = [center - u - v, center + u - v, center + u + v, center - u + v];
    (half.is_finite() && half > 0.0).then_some((corners, normal))
}

fn number(x: f64) -> DoubleDouble {
    DoubleDouble::from_f64(x)
}

/// A sphere seen from outside.
struct Outside {
    /// The unit vector to the centre, and the distance of the centre.
    towards: Precise,
    distance: DoubleDouble,
    /// The solid angle over π, and the cosine of the angular radius.
    solid_angle: f64,
    cosine: f64,
}

impl Sphere {
    /// Classifies a point: `Some(Some(_))` outside, `Some(None)` inside, `None` if it is on the
    /// sphere.
    fn seen_from(&self, point: Vector) -> Option<Option<Outside>> {
        let ahead = way(point, self.center);
        let distance = length(ahead);
        let beyond = (distance - number(self.radius)).to_f64();
        let [far, radius] = [distance.to_f64(), self.radius];
        if beyond.abs() <= TERM * far {
            return None;
        }
        let outside = || {
            let cosine = (beyond / far * ((far + radius) / far)).sqrt();
            Outside {
                towards: ahead.map(|x| x / distance),
                distance,
                solid_angle: 2.0 * (radius / far).powi(2) / (1.0 + cosine),
                cosine,
            }
        };
        Some((beyond > 0.0).then(outside))
    }
}

impl SeenWhole for Sphere {
    fn shows_front(&self, point: Vector) -> bool {
        self.inward == matches!(self.seen_from(point), Some(None))
    }

    /// From inside, the sphere covers all directions. When the normal turns by an angle δ, F
    /// changes by no more than δ Ω/π, and Ω/π = 2 (1 − cos α) for the angular radius α, sin α =
    /// R/d.
    fn form_factor(&self, point: Vector, direction: Vector, has_horizon: bool) -> Option<Rounded> {
        let Some(outside) = self.seen_from(point)? else {
            return Some(Rounded::exactly(if has_horizon { 1.0 } else { 0.0 }));
        };
        let (axis, turned) = unit(direction);
        let cosine = dot(axis, outside.towards);
        // rounding can put it beyond ±1
        let near = cosine.to_f64();
        let cosine = if near.abs() < 1.0 { cosine } else { number(near.signum()) };
        let (distance, radius) = (outside.distance, number(self.radius));
        let value = if has_horizon {
            form_factor_point_sphere::dd(distance, radius, cosine)
        } else {
            let sine = radius / distance;
            cosine * sine * sine
        };
        let of_terms = OF_KERNEL * TERM * (1.0 + 1.0 / outside.cosine);
        Some(Rounded { value, error: (turned + of_terms) * outside.solid_angle })
    }

    fn solid_angle_over_pi(&self, point: Vector) -> Option<Rounded> {
        let Some(outside) = self.seen_from(point)? else { return Some(Rounded::exactly(4.0)) };
        let value = solid_angle_sphere::dd(number(self.radius), outside.distance);
        let error = OF_KERNEL * TERM * (1.0 + 1.0 / outside.cosine) * value.to_f64();
        Some(Rounded { value, error }.over_pi())
    }

    /// Returns the square around the circle where lines from the point are tangent to the sphere:
    /// the circle has the distance d cos²α and the radius R cos α.
    fn outline(&self, point: Vector) -> Option<([Vector; 4], Vector)> {
        let Outside { towards, distance, cosine, .. } = self.seen_from(point)??;
        let [x, y, z] = towards.map(DoubleDouble::to_f64);
        let towards = Vector::new(x, y, z);
        square(point + (distance.to_f64() * cosine * cosine) * towards, self.radius * cosine, -towards)
    }
}

/// A disk seen from a point that is not in its plane.
struct Above {
    /// Whether the point is in front of the disk.
    is_before: bool,
    /// The unit normal on the side of the point.
    normal: Precise,
    height: DoubleDouble,
    /// The vector from the axis to the point, perpendicular to the axis, and its length.
    aside: Precise,
    away: DoubleDouble,
    /// The distance of the nearest point of the disk.
    nearest: f64,
    /// Change of a form factor per displacement of the point relative to its distance from the
    /// centre.
    moved: f64,
    /// Change of a form factor by the rounding of the normal.
    tilted: f64,
}

impl Disk {
    /// Classifies a point relative to the disk: `Some(None)` if it lies in the disk's plane, `None`
    /// where the rounding of the normal decides that.
    ///
    /// The form factor is the contour integral ∮ (r × dr)/2π|r|². If the point moves by δ, each
    /// element changes by at most 3 δ |dr|/2π|r|², and the whole integral by at most 3 δ R/d d′
    /// with the distances d and d′ of the nearest and the farthest point of the rim.
    fn seen_from(&self, point: Vector) -> Option<Option<Above>> {
        let (normal, tilt) = unit(self.normal);
        let from_center = way(self.center, point);
        let height = dot(normal, from_center);
        let (far, radius) = (length(from_center).to_f64(), self.radius);
        if tilt == 0.0 && height.to_f64() == 0.0 {
            return Some(None);
        }
        let aside = std::array::from_fn(|axis| from_center[axis] - height * normal[axis]);
        let away = length(aside);
        let across = (away - number(radius)).to_f64();
        let rim = across.hypot(height.to_f64());
        // beyond these limits a tilt is small compared with all distances
        if height.to_f64().abs() <= tilt * far || rim <= 1e3 * tilt * far || rim == 0.0 {
            return None;
        }
        let moved = 3.0 * (radius / rim) * (far / (away.to_f64() + radius).hypot(height.to_f64()));
        let is_before = height.to_f64() > 0.0;
        let side = |x: DoubleDouble| if is_before { x } else { -x };
        Some(Some(Above {
            is_before,
            normal: normal.map(side),
            height: side(height),
            aside,
            away,
            nearest: if across < 0.0 { height.to_f64().abs() } else { rim },
            moved,
            // from afar, no factor of cos θ cos θ′/πρ² per area changes by more than the turn and 4
            // r/ρ of it
            tilted: tilt * if far > 2.0 * radius { 6.0 * (radius / (far - radius)).powi(2) } else { moved },
        }))
    }
}

impl Disk {
    /// Returns a measure of an annulus: that of the whole disk less that of the hole.
    fn without_hole(&self, of: impl Fn(&Self) -> Option<Rounded>) -> Option<Rounded> {
        let [whole, hole] = self.whole_and_hole();
        Some(of(&whole)? + of(&hole)?.times(-1.0))
    }
}

impl SeenWhole for Disk {
    fn shows_front(&self, point: Vector) -> bool {
        matches!(self.seen_from(point), Some(Some(Above { is_before: true, .. })))
    }

    /// Vector irradiance has a component along the normal and a component towards the axis. Where
    /// the horizon of a plane does not cut the disk, the irradiance of the plane is the component
    /// of the vector irradiance along the plane's normal.
    fn form_factor(&self, point: Vector, direction: Vector, has_horizon: bool) -> Option<Rounded> {
        if self.is_annulus() {
            return self.without_hole(|disk| disk.form_factor(point, direction, has_horizon));
        }
        let Some(above) = self.seen_from(point)? else { return Some(Rounded::exactly(0.0)) };
        let (axis, turned) = unit(direction);
        let radius = number(self.radius);
        if has_horizon {
            let middle = dot(axis, way(point, self.center)).to_f64();
            let reach = (radius * length(cross(axis, above.normal))).to_f64();
            if middle <= -reach {
                return Some(Rounded::exactly(0.0));
            }
            if middle < reach {
                return None;
            }
        }
        let Above { height, away, nearest, moved, tilted, .. } = above;
        let along = form_factor_point_disk::dd(radius, height, away);
        let mut value = -(dot(axis, above.normal) * along);
        if away.to_f64() > 0.0 {
            let beside = form_factor_beside_disk::dd(radius, height, away);
            value = value - dot(axis, above.aside) / away * beside;
        }
        // the solid angle of the disk over π
        let most = (self.radius / nearest).powi(2).min(2.0);
        Some(Rounded { value, error: tilted + turned * most + OF_KERNEL * TERM * (most + moved) })
    }

    fn solid_angle_over_pi(&self, point: Vector) -> Option<Rounded> {
        if self.is_annulus() {
            return self.without_hole(|disk| disk.solid_angle_over_pi(point));
        }
        let Some(above) = self.seen_from(point)? else { return Some(Rounded::exactly(0.0)) };
        let is_on_axis = above.tilted == 0.0 && above.away.to_f64() == 0.0;
        is_on_axis.then(|| {
            let value = solid_angle_disk::dd(number(self.radius), above.height);
            Rounded { value, error: OF_KERNEL * TERM * value.to_f64() }.over_pi()
        })
    }

    fn outline(&self, point: Vector) -> Option<([Vector; 4], Vector)> {
        let above = self.seen_from(point)??;
        square(self.center, self.radius, if above.is_before { self.normal } else { -self.normal })
    }
}

#[cfg(test)]
mod tests;
