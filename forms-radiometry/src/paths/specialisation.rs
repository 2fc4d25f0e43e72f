//! Specialisations by effects: the path tracer of a scene contains no code for effects that the
//! scene lacks.
//!
//! A specialisation is a type, a member of the lattice, and its effects are constants of that type.
//! Every member is compiled ahead of time, and a scene takes its own from a table when it is
//! loaded.

/// Effects that a specialisation contains.
pub(crate) trait Specialisation: Sync + Send {
    const ABSORPTION: bool;
    const SCATTERING: bool;
    const MIRROR: bool;
    const REFRACTION: bool;
    const TIME: bool;
}

/// A member of the lattice.
pub(super) struct Member<
    const ABSORPTION: bool,
    const SCATTERING: bool,
    const MIRROR: bool,
    const REFRACTION: bool,
    const TIME: bool,
>;

impl<const A: bool, const S: bool, const M: bool, const R: bool, const T: bool> Specialisation
    for Member<A, S, M, R, T>
{
    const ABSORPTION: bool = A;
    const SCATTERING: bool = S;
    const MIRROR: bool = M;
    const REFRACTION: bool = R;
    const TIME: bool = T;
}
