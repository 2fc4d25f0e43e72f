//! What arrives: light of every kind that a scene has, in columns, becomes what each point of a group gathers.
//!
//! ```text
//! luminaires Σ F L │ surroundings: open, L∞ │ beams │ interreflection Σ ρ F E ─ gathered_light ─▶ π (Σ F L + open L∞) + beams + Σ ρ F E
//! ```
//! Each kind is an effect of the kernel. Which of them there are is known when a scene is loaded: then the member of the kernel that is
//! without the others is taken from its table, and nothing is computed for the columns of kinds that are off, which that member does
//! not read.

use crate::kernels::gathered_light::{Effects, With};
use forms::math::Formula;

/// A member of the kernel, of all rows.
type Member = fn(&Arriving, &mut [f64]);

/// The kinds of light that reach a receiver, and the kernel that is made for them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Kinds {
    effects: Effects,
    member: Member,
}

impl Kinds {
    /// The kinds that are on.
    pub(crate) fn of(effects: Effects) -> Self {
        Self { effects, member: member(effects) }
    }

    pub(crate) fn effects(self) -> Effects {
        self.effects
    }
}

/// Columns with a row for each point and, within it, each band; those of kinds that are off are empty.
#[derive(Default)]
pub(super) struct Arriving {
    pub(super) emitted: Vec<f64>,
    pub(super) open: Vec<f64>,
    pub(super) outside: Vec<f64>,
    pub(super) beams: Vec<f64>,
    pub(super) reflected: Vec<f64>,
}

impl Arriving {
    /// Nothing has arrived yet, of the kinds that are on, in this many rows.
    pub(super) fn begin(&mut self, kinds: Kinds, rows: usize) {
        let Effects { luminaires, surroundings, beams, interreflection } = kinds.effects;
        let columns = [
            (&mut self.emitted, luminaires),
            (&mut self.open, surroundings),
            (&mut self.outside, surroundings),
            (&mut self.beams, beams),
            (&mut self.reflected, interreflection),
        ];
        for (column, is_on) in columns {
            column.clear();
            column.resize(if is_on { rows } else { 0 }, 0.0);
        }
    }

    /// What is gathered of these kinds, for each row.
    pub(super) fn gather(&self, kinds: Kinds, gathered: &mut [f64]) {
        (kinds.member)(self, gathered);
    }
}

/// The member of the kernel with these effects.
fn member(effects: Effects) -> Member {
    macro_rules! table {
        ($($luminaires:literal $surroundings:literal $beams:literal $interreflection:literal),*) => {
            match (effects.luminaires, effects.surroundings, effects.beams, effects.interreflection) {
                $(($luminaires, $surroundings, $beams, $interreflection) =>
                    gathered::<$luminaires, $surroundings, $beams, $interreflection>,)*
            }
        };
    }
    table!(
        true true true true, true true true false, true true false true, true true false false,
        true false true true, true false true false, true false false true, true false false false,
        false true true true, false true true false, false true false true, false true false false,
        false false true true, false false true false, false false false true, false false false false
    )
}

/// What is gathered, row by row. A batch would fill hundreds of rows; groups have few, and one where a path ends.
fn gathered<const L: bool, const S: bool, const B: bool, const I: bool>(
    arriving: &Arriving,
    gathered: &mut [f64],
) where
    With<L, S, B, I>: Formula<5, 1>,
{
    let Arriving { emitted, open, outside, beams, reflected } = arriving;
    for (row, gathered) in gathered.iter_mut().enumerate() {
        let of = |column: &[f64], is_on: bool| if is_on { column[row] } else { 0.0 };
        let light = [of(emitted, L), of(open, S), of(outside, S), of(beams, B), of(reflected, I)];
        [*gathered] = With::<L, S, B, I>::value(light);
    }
}
