//! Placement of names next to their markers: no name covers a marker or another name, and a leader
//! line connects a distant name with its marker.

use crate::{Anchor, Area};

/// Distances of a name from its marker that are tried.
const DISTANCES: [f64; 9] = [11.0, 20.0, 32.0, 46.0, 62.0, 80.0, 100.0, 122.0, 146.0];

/// Directions that are tried at each distance, in order of preference: right, left, then around.
const DIRECTIONS: [f64; 12] =
    [0.0, 180.0, -40.0, 40.0, -140.0, 140.0, -90.0, 90.0, -65.0, 65.0, -115.0, 115.0];

/// Distance beyond which a name has a leader line.
const NEAR: f64 = 12.0;

/// Half the side of the box of a marker.
const MARK: f64 = 7.5;

/// Half the height of a name.
const HALF_HEIGHT: f64 = 6.5;

/// Cost of a unit of overlapped area, in units of distance.
const OVERLAP: f64 = 4.0;

/// Costs of crossing a leader line, and of crossing a line of the panel.
const CROSSING: f64 = 70.0;
const OVER_A_LINE: f64 = 14.0;

/// Placement of a name.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    /// Point on the baseline of the text.
    pub text: [f64; 2],
    /// Part of the text that is at this point.
    pub anchor: Anchor,
    /// End of the leader line to its marker.
    pub thread: Option<[f64; 2]>,
}

/// Panel on which names are placed one after the other.
pub struct Names {
    bounds: Area,
    marks: Vec<[f64; 2]>,
    taken: Vec<Area>,
    lines: Vec<[[f64; 2]; 2]>,
    threads: Vec<[[f64; 2]; 2]>,
}

impl Names {
    /// Creates a panel with these markers, occupied boxes, and lines that should not be covered.
    pub fn new(bounds: Area, marks: &[[f64; 2]], taken: Vec<Area>, lines: Vec<[[f64; 2]; 2]>) -> Self {
        Names { bounds, marks: marks.to_vec(), taken, lines, threads: Vec::new() }
    }

    /// Finds the best placement of a name with this width.
    pub fn place(&mut self, mark: [f64; 2], width: f64) -> Place {
        let candidates = DISTANCES.iter().flat_map(|&distance| {
            DIRECTIONS.iter().enumerate().map(move |(rank, &direction)| {
                let cost = distance + 0.4 * rank as f64;
                (candidate(mark, distance, direction, width), cost)
            })
        });
        let scored =
            candidates.map(|((place, area), cost)| (cost + self.obstacles(mark, &place, &area), place, area));
        let best = scored.min_by(|a, b| a.0.total_cmp(&b.0));
        let (_, place, area) = best.expect("there are candidates");
        self.taken.push(area);
        self.threads.extend(place.thread.map(|end| [mark, end]));
        place
    }

    /// Returns the cost of all overlaps and crossings of a name and its leader line.
    fn obstacles(&self, mark: [f64; 2], place: &Place, area: &Area) -> f64 {
        let marks = || self.marks.iter().map(|&at| Area::around(at, MARK));
        let covered: f64 = marks().chain(self.taken.iter().copied()).map(|other| area.shared(&other)).sum();
        let mut cost = OVERLAP * (covered + 4.0 * area.outside(&self.bounds));
        let crossings = |lines: &[[[f64; 2]; 2]]| {
            lines.iter().filter(|[from, to]| area.is_crossed(*from, *to)).count() as f64
        };
        cost += CROSSING * crossings(&self.threads) + OVER_A_LINE * crossings(&self.lines);
        let Some(end) = place.thread else { return cost };
        let others = self.marks.iter().filter(|&&other| (other[0] - mark[0]).hypot(other[1] - mark[1]) > 2.0);
        let in_the_way = others
            .map(|&other| Area::around(other, MARK))
            .chain(self.taken.iter().copied())
            .filter(|other| other.is_crossed(mark, end));
        cost += CROSSING * in_the_way.count() as f64;
        cost + CROSSING * self.threads.iter().filter(|[from, to]| meet(*from, *to, mark, end)).count() as f64
    }
}

/// Places a name at a distance and in a direction, in degrees; returns the placement and its box.
fn candidate(mark: [f64; 2], distance: f64, direction: f64, width: f64) -> (Place, Area) {
    let (sine, cosine) = direction.to_radians().sin_cos();
    let end = [mark[0] + distance * cosine, mark[1] + distance * sine];
    let (anchor, left) = match cosine {
        c if c > 0.3 => (Anchor::Start, end[0]),
        c if c < -0.3 => (Anchor::End, end[0] - width),
        _ => (Anchor::Middle, end[0] - width / 2.0),
    };
    // Above and below the marker, the leader line ends at the edge of the name.
    let middle = if anchor == Anchor::Middle { end[1] + sine.signum() * HALF_HEIGHT } else { end[1] };
    let area = Area { left, top: middle - HALF_HEIGHT, right: left + width, bottom: middle + HALF_HEIGHT };
    let thread = (distance > NEAR).then_some(end);
    (Place { text: [end[0], middle + 4.0], anchor, thread }, area)
}

/// Whether two segments cross.
fn meet(a: [f64; 2], b: [f64; 2], c: [f64; 2], d: [f64; 2]) -> bool {
    let side =
        |p: [f64; 2], q: [f64; 2], r: [f64; 2]| (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
    side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_crowded_marks_are_inside_and_cover_no_more_than_a_rim_of_each_other() {
        let bounds = Area { left: 0.0, top: 0.0, right: 400.0, bottom: 300.0 };
        let marks: Vec<[f64; 2]> = (0..9).map(|n| [180.0 + 4.0 * f64::from(n), 150.0]).collect();
        let mut names = Names::new(bounds, &marks, Vec::new(), Vec::new());
        for &mark in &marks {
            names.place(mark, 90.0);
        }
        let rim = 0.02 * 90.0 * 2.0 * HALF_HEIGHT;
        for (place, area) in names.taken.iter().enumerate() {
            assert_eq!(area.outside(&bounds), 0.0, "{area:?}");
            assert!(marks.iter().all(|&mark| area.shared(&Area::around(mark, 2.0)) == 0.0), "{area:?}");
            assert!(names.taken[..place].iter().all(|other| area.shared(other) <= rim), "{area:?}");
        }
    }

    #[test]
    fn a_mark_alone_has_its_name_at_its_right_without_a_thread() {
        let bounds = Area { left: 0.0, top: 0.0, right: 400.0, bottom: 300.0 };
        let mark = [100.0, 100.0];
        let place = Names::new(bounds, &[mark], Vec::new(), Vec::new()).place(mark, 60.0);
        assert!(place.thread.is_none() && place.anchor == Anchor::Start && place.text == [111.0, 104.0]);
    }
}
