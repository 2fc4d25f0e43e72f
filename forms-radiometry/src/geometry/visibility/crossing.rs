//! Crossings: of two convex outlines as a point sees them, a luminaire's and a shadow's, the edges of the border of what the shadow leaves.
//!
//! ```text
//! which corners are inside of which sides ─▶ edges that cross ─▶ edges of the luminaire outside of the shadow,
//!                                                               edges of the shadow in the luminaire, the other way round
//! ```
//! No number is looked at: only on which side each corner is of each plane through the point and an edge of the other outline.

/// Outlines with more edges are not looked at.
pub(super) const MOST: usize = 8;

/// Bits by corner for each side of an outline: whether the corner is inside of it.
pub(super) type Bits = [u32; MOST];

/// Two outlines as a point sees them.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Signs {
    /// How many corners the luminaire and the shadow have.
    pub(super) counts: [usize; 2],
    /// Of each corner of the shadow the one at the other end of its edge. The luminaire's are in order.
    pub(super) next: [usize; MOST],
    /// For each edge of the shadow the luminaire's corners, and for each of the luminaire's the shadow's.
    pub(super) inside: [Bits; 2],
}

/// An end of an edge of a border.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum End {
    /// A corner of the luminaire.
    Luminaire(usize),
    /// A corner of the shadow.
    Shadow(usize),
    /// Where these edges of the luminaire and of the shadow cross.
    Crossing([usize; 2]),
}

/// Where an edge comes into the other outline, and where it leaves it.
type Passage = [Option<[usize; 2]>; 2];

impl Signs {
    /// The edges of the border; nothing where signs contradict each other.
    pub(super) fn border(&self, border: &mut Vec<[End; 2]>) -> Option<()> {
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

    /// The luminaire's corner after one.
    fn after(&self, corner: usize) -> usize {
        (corner + 1) % self.counts[0]
    }

    /// Where the luminaire's edges pass through the shadow, and where the shadow's pass through the luminaire; nothing where that does not agree
    /// with which corners are inside: hidden ones of the luminaire, and lit ones of the shadow.
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

    /// Whether edges pass as they have to by which of their ends are inside. If none passes, one outline lies in the other: those that lie beside
    /// each other are parted by a side of one.
    fn agree(&self, [of_luminaire, of_shadow]: &[[Passage; MOST]; 2], [hidden, lit]: [u32; 2]) -> bool {
        let [corners, edges] = self.counts;
        let fits_luminaire =
            |j: usize| fits(&of_luminaire[j], [is_in(hidden, j), is_in(hidden, self.after(j))]);
        let fits_shadow = |k: usize| fits(&of_shadow[k], [is_in(lit, k), is_in(lit, self.next[k])]);
        let meets = lit != 0 || of_luminaire[..corners].iter().flatten().any(Option::is_some);
        meets && (0..corners).all(fits_luminaire) && (0..edges).all(fits_shadow)
    }
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

/// The corners that are on the inner side of all sides.
fn inside(bits: &[u32]) -> u32 {
    bits.iter().fold(u32::MAX, |all, bits| all & bits)
}

/// Whether a place is among these bits.
fn is_in(bits: u32, place: usize) -> bool {
    bits >> place & 1 == 1
}
