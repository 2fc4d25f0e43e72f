//! An expansion adds no warning, even with all lints denied.

#![deny(warnings, missing_docs, unused, clippy::all, clippy::pedantic)]
#![forbid(unsafe_code)]

/// Radiometry.
pub mod radiometry {
    forms::forms! {
        /// Coordinates of a *plane* at unit distance.
        chart Plane(u, v);
        chart Space(x, y, z) where x**2 + y**2 + z**2 > 0;
        form beta = (x*dy^dz + y*dz^dx + z*dx^dy)/(x**2 + y**2 + z**2)**(3/2);
        map patch: Plane -> Space = (u, v, 1);
        prove closed: d(beta) == 0;
        refute Trivial: beta == 0;
        /// Solid angle per unit area.
        pub kernel density(u, v) = pullback(patch, beta)[du^dv];
        /// A frame; the argument `E` is capital.
        pub kernel Frame(u, v, E) = (u*E, v*E, 1/E) where E > 0;
    }
}

fn main() {
    assert!(radiometry::density(0.0, 0.0) == 1.0 && radiometry::Frame(1.0, 2.0, 1.0)[1] == 2.0);
}
