//! Slabs: a rectangle that convex polygons partly cover becomes the trapezoids of its uncovered
//! part, so every integral over that part can be evaluated.
//!
//! Between neighbouring values of x, at corners and crossings of edges, the edges keep their order:
//! the uncovered part of a slab there consists of trapezoids between two edges. The method does not
//! clip polygons, so it checks polygon clipping independently.

/// Point of the plane.
pub(crate) type Point = [f64; 2];

/// Corners of a trapezoid, counter-clockwise.
pub(crate) type Trapezoid = [Point; 4];

/// Returns the part of the rectangle between two corners that some convex polygons do not cover.
pub(crate) fn uncovered([low, high]: [Point; 2], covers: &[Vec<Point>]) -> Vec<Trapezoid> {
    let places = places([low, high], covers);
    let mut left = Vec::new();
    for slab in places.windows(2).filter(|slab| slab[1] - slab[0] > 0.0) {
        let middle = 0.5 * (slab[0] + slab[1]);
        let level = |y: f64| [[low[0], y], [high[0], y]];
        let mut spans: Vec<[[Point; 2]; 2]> = covers.iter().filter_map(|cover| span(cover, middle)).collect();
        spans.sort_by(|[a, _], [b, _]| at(*a, middle).total_cmp(&at(*b, middle)));
        spans.push([level(high[1]); 2]);
        let mut bottom = level(low[1]);
        for [below, above] in spans {
            if at(bottom, middle) >= high[1] {
                break;
            }
            let top = if at(below, middle) < high[1] { below } else { level(high[1]) };
            if at(top, middle) > at(bottom, middle) {
                let corner = |side: [Point; 2], x: f64| [x, at(side, x)];
                left.push([
                    corner(bottom, slab[0]),
                    corner(bottom, slab[1]),
                    corner(top, slab[1]),
                    corner(top, slab[0]),
                ]);
            }
            if at(above, middle) > at(bottom, middle) {
                bottom = above;
            }
        }
    }
    left
}

/// Returns the area of trapezoids.
pub(crate) fn area(trapezoids: &[Trapezoid]) -> f64 {
    trapezoids.iter().map(|[a, b, c, d]| 0.5 * (b[0] - a[0]) * ((d[1] - a[1]) + (c[1] - b[1]))).sum()
}

/// Returns the values of x at corners and crossings of edges, in order, within the rectangle.
fn places([low, high]: [Point; 2], covers: &[Vec<Point>]) -> Vec<f64> {
    let rectangle = vec![low, [high[0], low[1]], high, [low[0], high[1]]];
    let all: Vec<[Point; 2]> = covers.iter().chain([&rectangle]).flat_map(|cover| edges(cover)).collect();
    let mut places: Vec<f64> = all.iter().flat_map(|edge| edge.map(|point| point[0])).collect();
    for (index, &one) in all.iter().enumerate() {
        places.extend(all[..index].iter().filter_map(|&other| crossing(one, other)));
    }
    places.retain(|x| (low[0]..=high[0]).contains(x));
    places.sort_by(f64::total_cmp);
    places
}

fn edges(polygon: &[Point]) -> Vec<[Point; 2]> {
    (0..polygon.len()).map(|i| [polygon[i], polygon[(i + 1) % polygon.len()]]).collect()
}

/// Returns the value of x at which the lines through two edges cross.
fn crossing([a, b]: [Point; 2], [c, d]: [Point; 2]) -> Option<f64> {
    let (u, v) = ([b[0] - a[0], b[1] - a[1]], [d[0] - c[0], d[1] - c[1]]);
    let turn = u[0] * v[1] - u[1] * v[0];
    let along = ((c[0] - a[0]) * v[1] - (c[1] - a[1]) * v[0]) / turn;
    (turn != 0.0).then(|| a[0] + along * u[0]).filter(|x| x.is_finite())
}

/// Returns the height of an edge at a value of x.
fn at([a, b]: [Point; 2], x: f64) -> f64 {
    a[1] + (x - a[0]) / (b[0] - a[0]) * (b[1] - a[1])
}

/// Returns the lower and the upper edge of a convex polygon at a value of x, if the polygon extends
/// there.
fn span(polygon: &[Point], x: f64) -> Option<[[Point; 2]; 2]> {
    let is_there = |[a, b]: &[Point; 2]| (a[0] < x) != (b[0] < x);
    let found: Vec<[Point; 2]> = edges(polygon).into_iter().filter(is_there).collect();
    let &[one, other] = found.as_slice() else { return None };
    Some(if at(one, x) <= at(other, x) { [one, other] } else { [other, one] })
}
