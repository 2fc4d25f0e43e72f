//! Optimisation runs inside the compiler of whoever uses a kernel, so it has to be quick without optimisation.

use crate::counts::{BILINEAR, bilinear};
use std::time::Instant;

#[test]
fn the_bilinear_patch_is_optimised_in_no_time() {
    for (name, spelling) in BILINEAR {
        let program = bilinear(spelling);
        let start = Instant::now();
        let optimised = program.optimise();
        println!("TIME {name}: {} instructions in {:?}", program.instructions().len(), start.elapsed());
        assert!(optimised.instructions().len() < program.instructions().len());
    }
}
