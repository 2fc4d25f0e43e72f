//! Clipping: splits a convex polygon by a plane into two parts, or by several planes into the part
//! in front of all of them and the parts beyond each.

use super::Vector;

/// Distances below this fraction of the polygon's largest distance from the plane count as zero, so
/// that an edge that already lies in the plane is not cut into slivers.
const ROUNDING: f64 = 1e-14;

/// Splits a convex polygon by the sign of `side`, an affine function: the part where it is positive
/// goes to `inside`, the part where it is negative to `outside`. A part without area comes out
/// empty.
///
/// An edge from a to b with distances α, β of opposite signs is cut at a + α/(α − β) (b − a).
pub(crate) fn split(
    polygon: &[Vector],
    side: impl Fn(Vector) -> f64,
    inside: &mut Vec<Vector>,
    outside: &mut Vec<Vector>,
) {
    split_beyond(polygon, side, 0.0, inside, outside);
}

/// Splits a convex polygon like [`split`], but distances below `least` count as zero too.
pub(crate) fn split_beyond(
    polygon: &[Vector],
    side: impl Fn(Vector) -> f64,
    least: f64,
    inside: &mut Vec<Vector>,
    outside: &mut Vec<Vector>,
) {
    inside.clear();
    outside.clear();
    let (low, high) = polygon.iter().fold((0.0, 0.0), |(low, high): (f64, f64), &v| {
        let distance = side(v);
        (low.min(distance), high.max(distance))
    });
    let rounding = least.max(ROUNDING * high.max(-low));
    if low >= -rounding || high <= rounding {
        let whole = if high > rounding { inside } else { outside };
        if high > rounding || low < -rounding {
            whole.extend_from_slice(polygon);
        }
        return;
    }
    let mut a = *polygon.last().expect("distances of both signs come from vertices");
    let mut alpha = side(a);
    for &b in polygon {
        let beta = side(b);
        if (alpha > rounding && beta < -rounding) || (alpha < -rounding && beta > rounding) {
            let cut = a + (alpha / (alpha - beta)) * (b - a);
            inside.push(cut);
            outside.push(cut);
        }
        if beta >= -rounding {
            inside.push(b);
        }
        if beta <= rounding {
            outside.push(b);
        }
        (a, alpha) = (b, beta);
    }
}

/// Splits a convex polygon along planes, each given by an affine function that is positive in front
/// of it, and by the least distance that does not count as zero. Returns the convex parts beyond
/// each plane, and the part in front of all planes, which has no vertices if it has no area.
pub(crate) fn split_along<F: Fn(Vector) -> f64>(
    polygon: &[Vector],
    sides: impl IntoIterator<Item = (F, f64)>,
) -> (Vec<Vec<Vector>>, Vec<Vector>) {
    let (mut rest, mut inside, mut outside) = (polygon.to_vec(), Vec::new(), Vec::new());
    let mut beyond = Vec::new();
    for (side, least) in sides {
        split_beyond(&rest, side, least, &mut inside, &mut outside);
        if !outside.is_empty() {
            beyond.push(std::mem::take(&mut outside));
        }
        std::mem::swap(&mut rest, &mut inside);
        if rest.is_empty() {
            break;
        }
    }
    (beyond, rest)
}

/// A sequence of convex polygons, stored in one list of points.
#[derive(Clone, Debug, Default)]
pub(crate) struct Pieces {
    points: Vec<Vector>,
    ends: Vec<usize>,
}

impl Pieces {
    pub(crate) fn clear(&mut self) {
        self.points.clear();
        self.ends.clear();
    }

    pub(crate) fn push(&mut self, polygon: &[Vector]) {
        self.points.extend_from_slice(polygon);
        self.ends.push(self.points.len());
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }

    /// Returns the polygon that was pushed last; an empty slice if there is none.
    pub(crate) fn last(&self) -> &[Vector] {
        let [.., end] = self.ends[..] else { return &[] };
        let start = if let [.., start, _] = self.ends[..] { start } else { 0 };
        &self.points[start..end]
    }

    pub(crate) fn iter(&self) -> impl Iterator<Item = &[Vector]> {
        let starts = std::iter::once(0).chain(self.ends.iter().copied());
        starts.zip(&self.ends).map(|(start, &end)| &self.points[start..end])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square() -> Vec<Vector> {
        [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(|(x, y)| Vector::new(x, y, 1.0)).to_vec()
    }

    #[test]
    fn the_two_parts_have_the_area_of_the_whole() {
        let area =
            |p: &[Vector]| (1..p.len()).map(|i| 0.5 * (p[i - 1] - p[0]).cross(p[i] - p[0]).z).sum::<f64>();
        for (name, normal, offset, expected) in [
            ("through the middle", Vector::new(1.0, 0.0, 0.0), 0.5, 0.5),
            ("along the diagonal", Vector::new(1.0, -1.0, 0.0), 0.0, 0.5),
            ("along an edge", Vector::new(0.0, 1.0, 0.0), 0.0, 1.0),
            ("along the opposite edge", Vector::new(0.0, 1.0, 0.0), 1.0, 0.0),
            ("a corner", Vector::new(1.0, 1.0, 0.0), 0.5, 0.875),
            ("in the polygon's plane", Vector::new(0.0, 0.0, 1.0), 1.0, f64::NAN),
        ] {
            let (mut inside, mut outside) = (Vec::new(), Vec::new());
            split(&square(), |v| normal.dot(v) - offset, &mut inside, &mut outside);
            if expected.is_nan() {
                assert!(inside.is_empty() && outside.is_empty(), "{name}");
            } else {
                assert!((area(&inside) - expected).abs() < 1e-15, "{name}");
                assert!((area(&outside) - (1.0 - expected)).abs() < 1e-15, "{name}");
            }
        }
    }

    #[test]
    fn the_part_in_front_of_all_planes_and_the_parts_beyond_each_make_up_the_whole() {
        let area =
            |p: &[Vector]| (1..p.len()).map(|i| 0.5 * (p[i - 1] - p[0]).cross(p[i] - p[0]).z).sum::<f64>();
        let planes = [(1.0, 0.25), (-1.0, -0.75)].map(|(sign, at)| (move |v: Vector| sign * v.x - at, 0.0));
        let (beyond, inside) = split_along(&square(), planes);
        assert_eq!(beyond.iter().map(|part| area(part)).collect::<Vec<_>>(), [0.25, 0.25]);
        assert!((area(&inside) - 0.5).abs() < 1e-15);
        let (beyond, inside) = split_along(&square(), [(|v: Vector| v.x - 2.0, 0.0)]);
        assert_eq!((beyond.len(), inside.len()), (1, 0));
    }
}
