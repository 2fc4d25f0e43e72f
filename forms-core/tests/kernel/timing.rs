//! Optimisation runs inside the compiler of whoever uses a kernel, so it has to be quick without optimisation.

use crate::counts::{BILINEAR, bilinear};
use std::time::{Duration, Instant};

/// Far above what it takes, so that a busy machine does not fail the test but a search that explodes does.
const LONGEST: Duration = Duration::from_millis(400);

#[test]
fn the_bilinear_patch_is_optimised_in_milliseconds() {
    for (name, spelling) in BILINEAR {
        let program = bilinear(spelling);
        let measured = (0..5).map(|_| {
            let start = Instant::now();
            assert!(program.optimise().cost() < program.cost());
            start.elapsed()
        });
        let best = measured.min().expect("five measurements");
        println!("{name}: {} instructions optimised in {best:?}", program.instructions().len());
        assert!(best < LONGEST, "{name}: {best:?}");
    }
}
