//! Gathered light: combines the light of all kinds in a scene, given in columns, into the light
//! that each point of a group gathers.
//!
//! ```text
//! emitters Σ F L │ surroundings: open, L∞ │ beams │ interreflection Σ ρ F E
//!     ─ gathered_light ─▶ π (Σ F L + open L∞) + beams + Σ ρ F E
//! ```
//! Each kind is an effect of the kernel. The kinds of a scene are known when it is loaded: the
//! specialisation of the kernel without the other kinds is then taken from its table. Nothing is
//! computed for the columns of absent kinds, which that specialisation does not read.

use forms::math::Formula;
use forms_kernels::gathered_light::{Effects as LightKinds, With};

/// Specialisation of the kernel, applied to all rows.
type Member = fn(&Arriving, &mut [f64]);

/// The kinds of light that reach a receiver, and the kernel that is specialised for them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Kinds {
    effects: LightKinds,
    member: Member,
}

impl Kinds {
    /// Returns these kinds with their kernel.
    pub(crate) fn of(effects: LightKinds) -> Self {
        Self { effects, member: member(effects) }
    }

    pub(crate) fn effects(self) -> LightKinds {
        self.effects
    }
}

/// Columns with a row for each point and, within it, each band. The columns of absent kinds are
/// empty.
#[derive(Default)]
pub(crate) struct Arriving {
    pub(crate) emitted: Vec<f64>,
    pub(crate) open: Vec<f64>,
    pub(crate) outside: Vec<f64>,
    pub(crate) beams: Vec<f64>,
    pub(crate) reflected: Vec<f64>,
}

impl Arriving {
    /// Resets the columns of the present kinds to zero, with this number of rows.
    pub(crate) fn begin(&mut self, kinds: Kinds, rows: usize) {
        let LightKinds { luminaires, surroundings, beams, interreflection } = kinds.effects;
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

    /// Computes the gathered light of these kinds for each row.
    pub(crate) fn gather(&self, kinds: Kinds, gathered: &mut [f64]) {
        (kinds.member)(self, gathered);
    }
}

/// Returns the specialisation of the kernel for these effects.
fn member(effects: LightKinds) -> Member {
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

/// Gathers light row by row. A batch would fill hundreds of rows; groups have few, and only one
/// where a path ends.
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
