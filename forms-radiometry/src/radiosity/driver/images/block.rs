//! Pixels of a block: the visible parts in each pixel become its mean radiance, with the error by
//! rules of integration.
//!
//! ```text
//! a polygon of the film in a pixel
//!   ─▶ triangles with 3 points each, exact to the second degree ─▶ ∫ L
//!      ├ difference from the centre of the polygon alone ─▶ error ─ too large ─▶ its quarters
//!      └ without reflections: deviation of corners from a plane through these points
//! ```
//! L = Lₑ + ρ E/π at the point that a film point sees. The boundaries of visible parts are exact;
//! the rule finds shadows within them. Reflected light is taken from polynomials where these agree
//! with the light that receivers gather, and corrected where they do not.

use super::film::{Block, Polygon, area, area_of_triangle, middle, quarters, triangles};
use crate::camera::Camera;
use crate::geometry::Vector;
use crate::radiosity::{Radiosity, Reflected, Scratch, SeenPiece};

/// Largest number of times that parts of a pixel are quartered.
const QUARTERED: usize = 7;
/// A part is not divided if its error is within the first part of the allowed error of its pixel,
/// and within the second part of the average error of all parts of the pixel.
const SMALL: f64 = 1.0 / 16.0;
const OF_AVERAGE: f64 = 0.5;
/// One in this many parts is checked for agreement between polynomials and the light that receivers
/// gather, and the difference is allowed this part of the error of a pixel.
const CHECKED: usize = 8;
const POLYNOMIALS: f64 = 0.5;
/// Rounding of the visible part of a pixel.
const OF_BORDERS: f64 = 64.0 * f64::EPSILON;
/// Distance inside a part at which its corners are evaluated, and the part of a triangle that one
/// of them represents.
const INSIDE: f64 = 0.02;
const OF_CORNER: f64 = 0.25;
/// Parts of a pixel smaller than this are only rounding.
const ROUNDING: f64 = 1e-9;

/// View of a camera.
pub(super) struct View<'v> {
    pub(super) camera: &'v Camera,
    pub(super) radiosity: &'v Radiosity<'v>,
    pub(super) pieces: &'v [SeenPiece],
    /// Radiance of the surroundings, for each band.
    pub(super) outside: &'v [f64],
    /// Allowed error by rules and polynomials in a pixel, relative to the larger of its value and
    /// the scale.
    pub(super) tolerance: f64,
    /// Scale for each band.
    pub(super) scales: &'v [f64],
}

/// Radiance of a pixel in one band.
#[derive(Clone, Copy, Default)]
pub(super) struct Pixel {
    /// Mean radiance.
    pub(super) value: f64,
    /// Error by rules, by polynomials, and by rounding of the parts of the pixel that emitters
    /// cover.
    pub(super) error: f64,
    /// Part of the value that is emitted directly into the pixel.
    pub(super) emitted: f64,
}

/// Part of a pixel in which one piece is seen.
struct Part {
    pixel: usize,
    polygon: Polygon,
    /// ∫ L over it for each band, and its error.
    found: Vec<[f64; 2]>,
}

/// A visible piece: its number, its points that film points see, and its parts in pixels.
type Seen = (usize, Vec<Vector>, Vec<Part>);

impl View<'_> {
    /// Returns the pixels of a block, band by band.
    pub(super) fn pixels(&self, block: &Block, scratch: &mut Scratch) -> Vec<Pixel> {
        let bands = self.outside.len();
        let count = (block.to[0] - block.from[0]) * (block.to[1] - block.from[1]);
        let mut sums = vec![[0.0; 2]; count * bands];
        let of_piece = |(piece, polygon): &(usize, Polygon)| {
            let parts = block.pixels(polygon).into_iter();
            let parts = parts.map(|(pixel, polygon)| Part { pixel, polygon, found: Vec::new() }).collect();
            (*piece, self.outline(*piece, polygon), parts)
        };
        let mut seen: Vec<Seen> = block.seen.iter().map(of_piece).collect();
        let mut pixels = self.emission(&seen, count);
        for quartered in 0..=QUARTERED {
            sums.fill([0.0; 2]);
            for (piece, outline, parts) in &mut seen {
                self.integrate(*piece, outline, parts, scratch);
                parts.iter().for_each(|part| add(&mut sums[part.pixel * bands..][..bands], &part.found));
            }
            if quartered == QUARTERED || !self.divide(&mut seen, &sums) {
                break;
            }
        }
        for (pixel, [value, error]) in pixels.iter_mut().zip(sums) {
            pixel.value += value;
            pixel.error += error;
        }
        pixels
    }

    /// Divides the parts that have too much of the error of their pixels. Returns whether there are
    /// any. `sums` holds ∫ L over each pixel and its error, band by band.
    fn divide(&self, seen: &mut [Seen], sums: &[[f64; 2]]) -> bool {
        let bands = self.outside.len();
        let allowed = self.allowed(sums);
        let errors: Vec<f64> = sums.iter().map(|[_, error]| *error).collect();
        let [allowed, errors] =
            [&allowed, &errors].map(|all| move |pixel: usize| &all[pixel * bands..][..bands]);
        let mut counts = vec![0.0; sums.len() / bands];
        seen.iter().flat_map(|(_, _, parts)| parts).for_each(|part| counts[part.pixel] += 1.0);
        let is_large = |Part { pixel, found, .. }: &Part| {
            is_beyond(&sums[pixel * bands..][..bands], allowed(*pixel), 1.0)
                && (is_beyond(found, allowed(*pixel), SMALL)
                    || is_beyond(found, errors(*pixel), OF_AVERAGE / counts[*pixel]))
        };
        let mut is_any = false;
        for (_, _, parts) in seen {
            let all = std::mem::take(parts).into_iter();
            let divided = |part: Part| {
                let is_large = is_large(&part);
                is_any |= is_large;
                if is_large { part.quarters() } else { vec![part] }
            };
            *parts = all.flat_map(divided).collect();
        }
        is_any
    }

    /// Returns the pixels of a block, band by band, with the light emitted directly into them.
    /// Their values contain only the light from outside so far.
    fn emission(&self, seen: &[Seen], count: usize) -> Vec<Pixel> {
        let bands = self.outside.len();
        let mut pixels = vec![Pixel::default(); count * bands];
        let mut open = vec![1.0; count];
        for (piece, _, parts) in seen {
            let emitted = self.radiosity.emitted(&self.pieces[*piece]);
            for part in parts {
                let covered = area(&part.polygon);
                open[part.pixel] -= covered;
                let of_pixel = &mut pixels[part.pixel * bands..][..bands];
                of_pixel.iter_mut().zip(emitted).for_each(|(pixel, radiance)| pixel.emit(covered, *radiance));
            }
        }
        for (of_pixel, open) in pixels.chunks_exact_mut(bands).zip(open).filter(|(_, open)| *open > ROUNDING)
        {
            for (pixel, radiance) in of_pixel.iter_mut().zip(self.outside) {
                pixel.value = open * radiance;
                pixel.emit(open, *radiance);
            }
        }
        pixels
    }

    /// Returns the allowed error by rules and polynomials in each pixel, band by band.
    fn allowed(&self, sums: &[[f64; 2]]) -> Vec<f64> {
        let scales = self.scales.iter().cycle();
        sums.iter().zip(scales).map(|([value, _], scale)| self.tolerance * scale.max(value.abs())).collect()
    }

    /// Returns the points of a piece that film points see.
    fn outline(&self, piece: usize, polygon: &[Vector]) -> Vec<Vector> {
        let SeenPiece { normal, outline, .. } = &self.pieces[piece];
        let height = normal.dot(outline[0]);
        let point = |film: &Vector| {
            let direction = self.camera.direction(film.x, film.y);
            self.camera.origin + (height / normal.dot(direction)) * direction
        };
        polygon.iter().map(point).collect()
    }

    /// Integrates over the parts that have no integral yet.
    fn integrate(&self, piece: usize, outline: &[Vector], parts: &mut [Part], scratch: &mut Scratch) {
        let mut open: Vec<&mut Part> = parts.iter_mut().filter(|part| part.found.is_empty()).collect();
        if open.is_empty() {
            return;
        }
        // elements resolve the boundaries of light themselves
        let has_corners = !self.pieces[piece].has_polynomials();
        let points = |part: &&mut Part| {
            let corners = if has_corners { part.corners() } else { Vec::new() };
            [part.points(), corners].concat()
        };
        let film: Vec<Vec<Vector>> = open.iter().map(points).collect();
        let radiance = self.radiance(piece, outline, &film.concat(), Reflected::Interpolated, scratch);
        let bands = self.outside.len();
        let mut of_points = radiance.chunks_exact(bands);
        for (part, points) in open.iter_mut().zip(&film) {
            part.integrate(of_points.by_ref().take(points.len()));
        }
        if self.pieces[piece].has_polynomials() {
            let firsts = film.iter().scan(0, |end, points| Some(std::mem::replace(end, *end + points.len())));
            let polynomials: Vec<&[f64]> =
                firsts.map(|first| &radiance[first * bands..][..2 * bands]).collect();
            self.correct(piece, outline, &mut open, (&film, &polynomials), scratch);
        }
    }

    /// Corrects the reflected light from polynomials by the light that receivers gather: at some
    /// centres, which tell the error; at all of them where the error is too large. `polynomials`
    /// holds the radiance at the centre of each part and at the node after it.
    fn correct(
        &self,
        piece: usize,
        outline: &[Vector],
        open: &mut [&mut Part],
        (film, polynomials): (&[Vec<Vector>], &[&[f64]]),
        scratch: &mut Scratch,
    ) {
        let bands = self.outside.len();
        let checked: Vec<usize> = (0..open.len()).step_by(CHECKED).chain([open.len() - 1]).collect();
        let middles: Vec<Vector> = checked.iter().map(|&part| film[part][0]).collect();
        let gathered = self.radiance(piece, outline, &middles, Reflected::Gathered, scratch);
        let mut largest = vec![0.0_f64; bands];
        for (&part, gathered) in checked.iter().zip(gathered.chunks_exact(bands)) {
            for ((largest, gathered), polynomial) in largest.iter_mut().zip(gathered).zip(polynomials[part]) {
                *largest = largest.max((gathered - polynomial).abs());
            }
        }
        let allowed = self.scales.iter().map(|scale| POLYNOMIALS * self.tolerance * scale);
        if largest.iter().zip(allowed).all(|(largest, allowed)| *largest <= allowed) {
            for part in open {
                let whole = area(&part.polygon);
                part.found
                    .iter_mut()
                    .zip(&largest)
                    .for_each(|([_, error], largest)| *error += whole * largest);
            }
            return;
        }
        let points: Vec<Vector> = film.iter().flat_map(|points| &points[..2]).copied().collect();
        let gathered = self.radiance(piece, outline, &points, Reflected::Gathered, scratch);
        for ((part, gathered), polynomials) in
            open.iter_mut().zip(gathered.chunks_exact(2 * bands)).zip(polynomials)
        {
            let whole = area(&part.polygon);
            for (band, [value, error]) in part.found.iter_mut().enumerate() {
                let [in_middle, beside] =
                    [band, bands + band].map(|place| gathered[place] - polynomials[place]);
                *value += whole * in_middle;
                *error += whole * (beside - in_middle).abs();
            }
        }
    }

    /// Returns the radiance of a piece at film points, point by point and band by band.
    fn radiance(
        &self,
        piece: usize,
        outline: &[Vector],
        film: &[Vector],
        reflected: Reflected,
        scratch: &mut Scratch,
    ) -> Vec<f64> {
        let points = self.outline(piece, film);
        let mut radiance = vec![0.0; points.len() * self.outside.len()];
        self.radiosity.radiance(&self.pieces[piece], [&points, outline], reflected, scratch, &mut radiance);
        radiance
    }
}

/// Whether an error exceeds this part of the allowed error.
fn is_beyond(found: &[[f64; 2]], allowed: &[f64], part: f64) -> bool {
    found.iter().zip(allowed).any(|([_, error], allowed)| *error > part * allowed)
}

impl Pixel {
    /// Adds the light emitted directly into this part of the pixel. The boundary of the part is
    /// rounded.
    fn emit(&mut self, part: f64, radiance: f64) {
        self.emitted += part * radiance;
        self.error += OF_BORDERS * radiance;
    }
}

impl Part {
    /// Returns its centre, and the points of the rule.
    fn points(&self) -> Vec<Vector> {
        std::iter::once(middle(&self.polygon)).chain(triangles(&self.polygon).flat_map(nodes)).collect()
    }

    /// Returns points close to its corners, triangle by triangle. Where light ends along a line in
    /// the part, there is a corner on each side.
    fn corners(&self) -> Vec<Vector> {
        let inside = |[a, b, c]: [Vector; 3]| {
            let middle = (1.0 / 3.0) * (a + b + c);
            [a, b, c].map(|corner| corner + INSIDE * (middle - corner))
        };
        triangles(&self.polygon).flat_map(inside).collect()
    }

    /// Computes the integral from the radiance at these points. Its error is the difference from
    /// the integral by the centre alone; or, if that is more, the deviation of corners from the
    /// plane through the points of their triangles.
    fn integrate<'r>(&mut self, mut radiance: impl Iterator<Item = &'r [f64]>) {
        let whole = area(&self.polygon);
        let in_middle = radiance.next().expect("the middle is the first");
        let bands = in_middle.len();
        self.found = vec![[0.0; 2]; bands];
        let mut of_triangles = Vec::new();
        for triangle in triangles(&self.polygon) {
            let area = area_of_triangle(triangle);
            let nodes: Vec<&[f64]> = radiance.by_ref().take(3).collect();
            for (band, [sum, _]) in self.found.iter_mut().enumerate() {
                nodes.iter().for_each(|of_node| *sum += area / 3.0 * of_node[band]);
            }
            of_triangles.push((area, nodes));
        }
        let mut of_corners = vec![0.0; bands];
        for (area, nodes) in of_triangles {
            for (near, of_corner) in radiance.by_ref().take(nodes.len()).enumerate() {
                for (band, error) in of_corners.iter_mut().enumerate() {
                    let [own, mean] =
                        [nodes[near][band], nodes.iter().map(|node| node[band]).sum::<f64>() / 3.0];
                    // a node is half as far from the centre as its corner
                    let expected = mean + (1.0 - INSIDE) * 2.0 * (own - mean);
                    *error += OF_CORNER * area * (of_corner[band] - expected).abs();
                }
            }
        }
        for ((found, in_middle), of_corners) in self.found.iter_mut().zip(in_middle).zip(of_corners) {
            found[1] = (found[0] - whole * in_middle).abs().max(of_corners);
        }
    }

    fn quarters(self) -> Vec<Self> {
        let part = |polygon| Self { pixel: self.pixel, polygon, found: Vec::new() };
        quarters(&self.polygon).into_iter().map(part).collect()
    }
}

fn add(sums: &mut [[f64; 2]], found: &[[f64; 2]]) {
    for ([sum, errors], [value, error]) in sums.iter_mut().zip(found) {
        *sum += value;
        *errors += error;
    }
}

/// Returns the points of a triangle whose mean is exact for polynomials of the second degree.
///
/// Source: A. H. Stroud, Approximate calculation of multiple integrals (1971), T₂: 2-1.
fn nodes([a, b, c]: [Vector; 3]) -> [Vector; 3] {
    let node = |near: Vector, one: Vector, other: Vector| (1.0 / 6.0) * (4.0 * near + one + other);
    [node(a, b, c), node(b, c, a), node(c, a, b)]
}
