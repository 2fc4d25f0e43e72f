//! Optimisation runs inside the compiler of whoever uses a kernel, so it has to be quick without optimisation.

use crate::counts::{BILINEAR, bilinear};
use crate::formula::Formulas;
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

/// Newton's iteration written out many times: every step uses the one before it several times.
#[test]
fn a_long_chain_of_steps_takes_time_in_proportion() {
    let measured = [50, 400].map(|steps| {
        let mut formulas = Formulas::over("x y");
        let mut value = formulas.parse("x");
        for place in 1..=steps {
            formulas.name("value", value);
            value =
                formulas.parse(&format!("value - (sin(value)*y - {place})/(cos(value)*y + value*{place})"));
        }
        let program = formulas.program(&[value]);
        let start = Instant::now();
        assert!(program.optimise().cost() <= program.cost());
        start.elapsed()
    });
    println!("50 steps optimised in {:?}, 400 in {:?}", measured[0], measured[1]);
    assert!(measured[1] < 60 * measured[0], "eight times the steps: {measured:?}");
}
