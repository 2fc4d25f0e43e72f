//! Silhouette crossings: combines the outlines of a luminaire and of a shadow, as a point sees
//! them, into the contour of the part that the shadow leaves visible.
//!
//! ```text
//! which corners are inside of which sides ─▶ edges that cross
//! edges that cross ─▶ edges of the luminaire outside the shadow,
//!                     edges of the shadow in the luminaire, in the opposite direction
//! ```
//! Both outlines are convex. The result is purely combinatorial: it depends only on the side of
//! each corner relative to each plane through the point and an edge of the other outline.

/// The largest number of edges of an outline.
pub(crate) const MOST: usize = 8;

/// For each side of an outline, one bit for each corner: whether the corner is inside that side.
pub(crate) type Bits = [u32; MOST];

/// Two outlines as a point sees them.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Signs {
    /// The numbers of corners of the luminaire and of the shadow.
    pub(crate) counts: [usize; 2],
    /// For each corner of the shadow, the corner at the end of its edge. The luminaire's corners
    /// are in order.
    pub(crate) next: [usize; MOST],
    /// For each edge of the shadow, bits for the luminaire's corners; for each edge of the
    /// luminaire, bits for the shadow's corners.
    pub(crate) inside: [Bits; 2],
}

/// An end point of a contour edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum End {
    /// A corner of the luminaire.
    Luminaire(usize),
    /// A corner of the shadow.
    Shadow(usize),
    /// The crossing of these edges of the luminaire and of the shadow.
    Crossing([usize; 2]),
}

/// The crossings at which an edge enters the other outline and leaves it.
type Passage = [Option<[usize; 2]>; 2];

impl Signs {
    /// Computes the edges of the contour; `None` where signs contradict each other.
    pub(crate) fn border(&self, border: &mut Vec<[End; 2]>) -> Option<()> {
        border.clear();
        let [corners, edges] = self.counts;
        let hidden = inside(&self.inside[0][..edges]);
        let lit = inside(&self.inside[1][..corners]);
        if (0..corners).all(|corner| is_in(hidden, corner)) {
            return Some(());
        }
        let [of_luminaire, of_shadow] = self.passages([hidden, lit])?;
        for (j, [enter, leave]) in of_luminaire[..corners].iter().enumerate() {
            let end = End::Luminaire(self.after(j));
            if !is_in(hidden, j) {
                border.push([End::Luminaire(j), enter.map_or(end, End::Crossing)]);
            }
            border.extend(leave.map(|at| [End::Crossing(at), end]));
        }
        for (k, [enter, leave]) in of_shadow[..edges].iter().enumerate() {
            if is_in(lit, k) || enter.is_some() {
                let [start, end] = [k, self.next[k]].map(End::Shadow);
                border.push([leave.map_or(end, End::Crossing), enter.map_or(start, End::Crossing)]);
            }
        }
        Some(())
    }

    /// Returns the next corner of the luminaire.
    fn after(&self, corner: usize) -> usize {
        (corner + 1) % self.counts[0]
    }

    /// Returns the crossings of the luminaire's edges with the shadow, and of the shadow's edges
    /// with the luminaire. Returns `None` where they contradict which corners are inside: the
    /// hidden corners of the luminaire, and the lit corners of the shadow.
    fn passages(&self, [hidden, lit]: [u32; 2]) -> Option<[[Passage; MOST]; 2]> {
        let mut passages = [[[None; 2]; MOST]; 2];
        let [corners, edges] = self.counts;
        for j in 0..corners {
            for k in 0..edges {
                let of_edge = self.inside[1][j];
                let is_through = is_in(of_edge, k) != is_in(of_edge, self.next[k]);
                let of_side = self.inside[0][k];
                if !is_through || is_in(of_side, j) == is_in(of_side, self.after(j)) {
                    continue;
                }
                for (outline, edge, is_leaving) in [(0, j, is_in(of_side, j)), (1, k, is_in(of_edge, k))] {
                    let place: &mut Option<[usize; 2]> =
                        &mut passages[outline][edge][usize::from(is_leaving)];
                    if place.replace([j, k]).is_some() {
                        return None;
                    }
                }
            }
        }
        self.agree(&passages, [hidden, lit]).then_some(passages)
    }

    /// Whether the crossings of all edges are consistent with which of their ends are inside. If no
    /// edge crosses, one outline must lie in the other: disjoint outlines are separated by a side
    /// of one of them.
    fn agree(&self, [of_luminaire, of_shadow]: &[[Passage; MOST]; 2], [hidden, lit]: [u32; 2]) -> bool {
        let [corners, edges] = self.counts;
        let fits_luminaire =
            |j: usize| fits(&of_luminaire[j], [is_in(hidden, j), is_in(hidden, self.after(j))]);
        let fits_shadow = |k: usize| fits(&of_shadow[k], [is_in(lit, k), is_in(lit, self.next[k])]);
        let meets = lit != 0 || of_luminaire[..corners].iter().flatten().any(Option::is_some);
        meets && (0..corners).all(fits_luminaire) && (0..edges).all(fits_shadow)
    }
}

/// Whether the crossings of an edge are consistent with whether its start and its end are inside.
fn fits([enter, leave]: &Passage, [starts_inside, ends_inside]: [bool; 2]) -> bool {
    match (starts_inside, ends_inside) {
        (false, false) => enter.is_some() == leave.is_some(),
        (false, true) => enter.is_some() && leave.is_none(),
        (true, false) => enter.is_none() && leave.is_some(),
        (true, true) => enter.is_none() && leave.is_none(),
    }
}

/// Returns the corners that are inside all sides.
fn inside(bits: &[u32]) -> u32 {
    bits.iter().fold(u32::MAX, |all, bits| all & bits)
}

/// Whether the bit of a corner is set.
fn is_in(bits: u32, place: usize) -> bool {
    bits >> place & 1 == 1
}
