//! Turns a form into a function, and evaluates it for single points, in batches, and with more
//! digits.
//!
//! ```text
//! forms! { … kernel … } ─ proved while this program is compiled ─▶ a function and a module of its name: batch, f32, dd, …
//! ```
//! `cargo run --release --example kernel`. With a wrong power in the statement the program does not
//! compile.

use forms::math::{DoubleDouble, LengthMismatch};

forms::forms! {
    chart R3(x, y, z) where x**2 + y**2 + z**2 > 0;
    chart UV(u, v);
    param h where h > 0;
    let r = sqrt(x**2 + y**2 + z**2);
    form beta: 2 on R3 = (x*dy^dz + y*dz^dx + z*dx^dy)/r**3;
    map ceiling: UV -> R3 = (u, v, h);

    prove fourth_power: pullback(ceiling, z/r*beta) == h**2/(u**2 + v**2 + h**2)**2*du^dv;

    /// Projected solid angle per unit area of a ceiling at the height h, at the offset (u, v) from
    /// the point straight above.
    kernel received(u, v, h) = pullback(ceiling, z/r*beta)[du^dv];
}

fn main() -> Result<(), LengthMismatch> {
    println!("straight above, at height 2: {}", received(0.0, 0.0, 2.0));

    let along: Vec<f64> = (0..5).map(f64::from).collect();
    let (across, height) = (vec![0.0; along.len()], vec![2.0; along.len()]);
    let mut values = vec![0.0; along.len()];
    received::batch(&along, &across, &height, &mut values)?;
    for (u, value) in along.iter().zip(&values) {
        println!("u = {u}: {value:.6}");
    }

    let [u, v, h] = [1.0, 2.0, 3.0].map(|x| DoubleDouble::new(x, 0.0));
    println!("with 31 digits at (1, 2, 3): {}", received::dd(u, v, h));
    println!("as written, in f64: {}; operations: {}", received::plain(1.0, 2.0, 3.0), received::OPERATIONS);
    Ok(())
}
