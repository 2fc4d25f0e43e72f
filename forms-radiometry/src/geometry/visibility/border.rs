//! The border of what a point sees of a luminaire from which one shadow takes a part: edges of the luminaire outside of the shadow,
//! and edges of the shadow in the luminaire, the other way round.
//!
//! ```text
//! signs of sₖ·aⱼ and lⱼ·pₖ ─▶ corners in the other outline, edges that cross ─▶ lines along the border
//! ```
//! aⱼ are the luminaire's corners and pₖ the shadow's, relative to the point; lⱼ and sₖ are the normals of the planes through the
//! point and each edge. Both edges that cross end in the same place, so the border is closed to the last bit. What is a sum over
//! edges needs no more than that, where convex pieces would have several times as many. Where a sign is not sure, an edge may
//! lie on another one: then the border is not given, and pieces have to be cut.

use super::horizon::Workspace;
use super::visible::{Cut, Cutting};
use super::{Screens, Vector};

/// Outlines with more edges are not looked at.
const MOST: usize = 8;

/// Products that are smaller than this part of what they may be have no sure sign: far above rounding, far below what is common.
const UNSURE: f64 = 1e-11;

/// Lists that are reused from receiver to receiver.
#[derive(Clone, Debug, Default)]
pub(super) struct Border {
    /// The normals to the inside of the luminaire's sides, each with the edge from the corner of the same place.
    sides: Vec<Vector>,
    /// The edges of the shadow that is looked at, with the shadow on their left, and their signs.
    edges: Vec<[Vector; 2]>,
    signs: Signs,
    /// The same of the shadow that takes a part of the luminaire.
    kept: (Vec<[Vector; 2]>, Signs),
    /// Where the edges of both outlines pass through the other one.
    passages: [[Passage; MOST]; 2],
    /// A line along the border.
    line: Vec<Vector>,
}

/// What is known of a shadow.
enum Shadow {
    /// It does not reach the luminaire.
    Beside,
    /// It may take a part of it, or all.
    Before,
    /// Edges do not say it all.
    Unknown,
}

/// Bits by corner for each side of an outline: whether the corner is inside of it.
type Bits = [u32; MOST];

/// On which sides of the luminaire the starts and the ends of a shadow's edges are.
#[derive(Clone, Copy, Debug, Default)]
struct Signs {
    starts: Bits,
    ends: Bits,
}

/// On which sides of a shadow the luminaire's corners are, and how far from them.
#[derive(Default)]
struct Corners {
    bits: Bits,
    distances: [[f64; MOST]; MOST],
}

/// Where an edge comes into the other outline, and where it leaves it.
type Passage = [Option<Vector>; 2];

impl Screens {
    /// Calls `each` with the lines along the border of what a receiver sees of a luminaire, relative to `position`: closed ones, or several
    /// that are closed together. Says whether it did: the luminaire has to be wholly above the horizon, at most one screen or body may hide
    /// a part of it, and nothing may be so close to an edge that it is not sure on which side it is.
    pub(crate) fn border(
        &self,
        position: Vector,
        horizon: Option<Vector>,
        (luminaire, normal): (&[Vector], Vector),
        screens: &[u32],
        work: &mut Workspace,
        mut each: impl FnMut(&[Vector]),
    ) -> bool {
        let height = normal.dot(position - luminaire[0]);
        if height <= self.resolution {
            return true;
        }
        work.luminaire.clear();
        work.luminaire.extend(luminaire.iter().map(|&v| v - position));
        let mut cut = work.cut();
        let corners = cut.luminaire;
        if corners.len() > MOST || horizon.is_some_and(|n| corners.iter().any(|&v| n.dot(v) < 0.0)) {
            return false;
        }
        let next = corners[1..].iter().chain(&corners[..1]);
        cut.lists.border.sides.clear();
        cut.lists.border.sides.extend(corners.iter().zip(next).map(|(a, b)| b.cross(*a)));
        let mut is_hidden = false;
        for &index in screens {
            match self.shadow(index as usize, position, (normal, height), &mut cut) {
                Shadow::Beside => {}
                Shadow::Before if !is_hidden => {
                    is_hidden = true;
                    cut.lists.border.keep();
                }
                Shadow::Before | Shadow::Unknown => return false,
            }
        }
        let Cut { luminaire, lists: Cutting { border, .. }, .. } = cut;
        if is_hidden {
            return border.draw(luminaire, each);
        }
        border.line.clear();
        border.line.extend(luminaire.iter().chain(luminaire.first()));
        each(&border.line);
        true
    }

    /// Takes the edges of the shadow of a screen or a body.
    fn shadow(
        &self,
        index: usize,
        position: Vector,
        (normal, height): (Vector, f64),
        cut: &mut Cut,
    ) -> Shadow {
        let Cut { luminaire, lists: Cutting { seen, border, .. }, .. } = cut;
        border.edges.clear();
        let Some(screen) = self.screens.get(index) else {
            let body = &self.bodies[index - self.screens.len()];
            let Some(edges) = body.shadow(position, self.resolution, seen) else { return Shadow::Unknown };
            border.edges.extend(edges.take(MOST + 1));
            return border.reached();
        };
        let distance = screen.plane.distance(position);
        if !self.parts(screen, distance, luminaire) {
            return Shadow::Beside;
        }
        let is_behind = |v: &Vector| height + normal.dot(*v - position) < 0.0;
        if screen.vertices.iter().any(is_behind) {
            return Shadow::Unknown;
        }
        let turned = |[a, b]: [Vector; 2]| if distance > 0.0 { [a, b] } else { [b, a] };
        border.edges.extend(screen.edges().map(|edge| turned(edge.map(|v| v - position))));
        border.reached()
    }
}

impl Border {
    /// Whether the shadow reaches the luminaire, as far as the luminaire's sides say.
    fn reached(&mut self) -> Shadow {
        if self.edges.len() > MOST {
            return Shadow::Unknown;
        }
        let Self { sides, edges, signs, .. } = self;
        let reach = edges.iter().fold(0.0, |reach: f64, [a, _]| reach.max(a.largest()));
        let mut is_sure = true;
        for (j, side) in sides.iter().enumerate() {
            let unsure = UNSURE * side.largest() * reach;
            let (mut highest, mut starts, mut ends) = (f64::NEG_INFINITY, 0, 0);
            for (k, edge) in edges.iter().enumerate() {
                let [start, end] = edge.map(|v| side.dot(v));
                highest = highest.max(start);
                is_sure &= start.abs() > unsure;
                starts |= u32::from(start > 0.0) << k;
                ends |= u32::from(end > 0.0) << k;
            }
            if highest < -unsure {
                return Shadow::Beside;
            }
            (signs.starts[j], signs.ends[j]) = (starts, ends);
        }
        if is_sure { Shadow::Before } else { Shadow::Unknown }
    }

    /// Keeps the shadow that was looked at.
    fn keep(&mut self) {
        std::mem::swap(&mut self.kept.0, &mut self.edges);
        self.kept.1 = self.signs;
    }

    /// Calls `each` with the lines of the border that the shadow kept leaves. Says whether it did: signs may not be sure, or contradict
    /// each other.
    fn draw(&mut self, luminaire: &[Vector], each: impl FnMut(&[Vector])) -> bool {
        let Self { kept: (edges, signs), passages, line, .. } = self;
        let reach = luminaire.iter().fold(0.0, |reach: f64, v| reach.max(v.largest()));
        let mut corners = Corners::default();
        for (k, [a, b]) in edges.iter().enumerate() {
            let side = b.cross(*a);
            let unsure = UNSURE * side.largest() * reach;
            for (j, corner) in luminaire.iter().enumerate() {
                let distance = side.dot(*corner);
                if distance.abs() <= unsure {
                    return false;
                }
                corners.distances[k][j] = distance;
                corners.bits[k] |= u32::from(distance > 0.0) << j;
            }
        }
        lines(luminaire, edges, (&corners, signs), (passages, line), each)
    }
}

/// The corners that are on the inner side of so many sides.
fn inside(bits: &Bits, sides: usize) -> u32 {
    bits[..sides].iter().fold(u32::MAX, |all, bits| all & bits)
}

/// Calls `each` with the lines of the border, where signs do not contradict each other.
fn lines(
    luminaire: &[Vector],
    edges: &[[Vector; 2]],
    signs: (&Corners, &Signs),
    (passages, line): (&mut [[Passage; MOST]; 2], &mut Vec<Vector>),
    mut each: impl FnMut(&[Vector]),
) -> bool {
    let hidden = inside(&signs.0.bits, edges.len());
    let starts = inside(&signs.1.starts, luminaire.len());
    if (0..luminaire.len()).all(|corner| is_in(hidden, corner)) {
        return true;
    }
    if !find_passages(luminaire, edges.len(), signs, passages) {
        return false;
    }
    let [of_luminaire, of_shadow] = passages;
    let next = |corner: usize| (corner + 1) % luminaire.len();
    line.clear();
    line.extend((!is_in(hidden, 0)).then_some(luminaire[0]));
    for (j, [enter, leave]) in of_luminaire[..luminaire.len()].iter().enumerate() {
        if let Some(at) = enter {
            line.push(*at);
            each(line);
            line.clear();
        }
        line.extend(*leave);
        if !is_in(hidden, next(j)) {
            line.push(luminaire[next(j)]);
        }
    }
    if line.len() > 1 {
        each(line);
    }
    for (k, ([start, end], [enter, leave])) in edges.iter().zip(of_shadow).enumerate() {
        if is_in(starts, k) || enter.is_some() {
            each(&[leave.unwrap_or(*end), enter.unwrap_or(*start)]);
        }
    }
    true
}

/// Whether a place is among these bits.
fn is_in(bits: u32, place: usize) -> bool {
    bits >> place & 1 == 1
}

/// Finds where the luminaire's edges pass through the shadow, and where the shadow's pass through the luminaire; says whether that agrees
/// with which corners are inside.
fn find_passages(
    luminaire: &[Vector],
    edges: usize,
    (corners, signs): (&Corners, &Signs),
    passages: &mut [[Passage; MOST]; 2],
) -> bool {
    let [of_luminaire, of_shadow] = passages;
    of_luminaire[..luminaire.len()].fill([None; 2]);
    of_shadow[..edges].fill([None; 2]);
    for (j, &a) in luminaire.iter().enumerate() {
        let next = (j + 1) % luminaire.len();
        let through_plane = signs.starts[j] ^ signs.ends[j];
        for k in (0..edges).filter(|&k| is_in(through_plane, k)) {
            let bits = corners.bits[k];
            if is_in(bits, j) == is_in(bits, next) {
                continue;
            }
            let [from, to] = [j, next].map(|corner| corners.distances[k][corner]);
            let at = a + (from / (from - to)) * (luminaire[next] - a);
            let ways = [(0, j, from > 0.0), (1, k, is_in(signs.starts[j], k))];
            for (outline, edge, is_leaving) in ways {
                if passages[outline][edge][usize::from(is_leaving)].replace(at).is_some() {
                    return false;
                }
            }
        }
    }
    agree(passages, [luminaire.len(), edges], (corners, signs))
}

/// Whether edges pass as they have to by which of their ends are inside. If none passes, one outline lies in the other or beside it.
fn agree(
    [of_luminaire, of_shadow]: &[[Passage; MOST]; 2],
    [corners, edges]: [usize; 2],
    (hidden, signs): (&Corners, &Signs),
) -> bool {
    let is_apart = hidden.bits[..edges].contains(&0);
    let hidden = inside(&hidden.bits, edges);
    let [starts, ends] = [&signs.starts, &signs.ends].map(|bits| inside(bits, corners));
    let fits_luminaire =
        |j: usize| fits(&of_luminaire[j], [is_in(hidden, j), is_in(hidden, (j + 1) % corners)]);
    let fits_shadow = |k: usize| fits(&of_shadow[k], [is_in(starts, k), is_in(ends, k)]);
    let meets = starts != 0 || of_luminaire[..corners].iter().flatten().any(Option::is_some);
    (is_apart || meets) && (0..corners).all(fits_luminaire) && (0..edges).all(fits_shadow)
}

/// Whether an edge whose start and end are inside or not passes as it has to.
fn fits([enter, leave]: &Passage, [starts_inside, ends_inside]: [bool; 2]) -> bool {
    match (starts_inside, ends_inside) {
        (false, false) => enter.is_some() == leave.is_some(),
        (false, true) => enter.is_some() && leave.is_none(),
        (true, false) => enter.is_none() && leave.is_some(),
        (true, true) => enter.is_none() && leave.is_none(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Face, form_factor_of_pieces, line_sum};

    /// The rectangle at this height that looks down.
    fn face(surface: usize, x: [f64; 2], y: [f64; 2], height: f64) -> Face {
        let corner = |x, y| Vector::new(x, y, height);
        let corners = vec![corner(x[0], y[0]), corner(x[0], y[1]), corner(x[1], y[1]), corner(x[1], y[0])];
        let [front, _] = Face::sides(surface, corners, Vector::new(0.0, 0.0, -1.0));
        front
    }

    /// The sum over the lines of the border, if it is given, and the one over pieces.
    fn both(screens: &Screens, lamp: &Face, position: Vector, normal: Vector) -> (Option<f64>, f64) {
        let (mut between, mut work) = (Vec::new(), Workspace::default());
        let _ = screens.between(&[position], Some(normal), &lamp.vertices, lamp.normal, &mut between);
        let mut sum = 0.0;
        let luminaire = (lamp.vertices.as_slice(), lamp.normal);
        let is_given = screens.border(position, Some(normal), luminaire, &between, &mut work, |line| {
            sum += line_sum(line, normal);
        });
        let pieces =
            screens.visible(position, Some(normal), &lamp.vertices, lamp.normal, &between, &mut work);
        (is_given.then_some(sum), form_factor_of_pieces(pieces, normal))
    }

    const UP: Vector = Vector::new(0.0, 0.0, 1.0);

    #[test]
    fn the_border_of_what_is_seen_sums_to_what_its_pieces_do() {
        let lamp = face(0, [-1.0, 1.0], [-1.0, 1.0], 2.0);
        for (name, plate) in [
            ("a plate that takes a corner", face(1, [0.0, 2.0], [0.1, 1.7], 1.1)),
            ("a plate inside", face(1, [-0.2, 0.3], [-0.1, 0.2], 0.9)),
            ("a strip across", face(1, [-3.0, 3.0], [-0.1, 0.2], 1.3)),
            ("a plate larger than the lamp", face(1, [-2.0, 1.9], [-3.0, 2.8], 1.5)),
        ] {
            let screens = Screens::of(&[lamp.clone(), plate]);
            let mut given = 0;
            for i in 0..41 {
                for j in 0..41 {
                    let position = Vector::new(0.117 * f64::from(i) - 2.3, 0.113 * f64::from(j) - 2.4, 0.0);
                    let (border, pieces) = both(&screens, &lamp, position, UP);
                    if let Some(border) = border {
                        given += 1;
                        assert!(
                            (border - pieces).abs() < 1e-14,
                            "{name}, {position:?}: {border} and {pieces}"
                        );
                    }
                }
            }
            assert!(given > 41 * 41 * 9 / 10, "{name}: {given}");
        }
    }

    #[test]
    fn where_a_shadow_has_an_edge_on_one_of_the_lamp_no_border_is_given() {
        let lamp = face(0, [-1.0, 1.0], [-1.0, 1.0], 2.0);
        let screens = Screens::of(&[lamp.clone(), face(1, [-0.5, 0.1], [-0.5, 0.5], 1.0)]);
        let (border, pieces) = both(&screens, &lamp, Vector::default(), UP);
        assert!(border.is_none() && pieces > 0.05, "{pieces}");
    }
}
