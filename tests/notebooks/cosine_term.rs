//! The code cells of `docs/notebooks/01-cosine-term.ipynb`, written by
//! `FORMS_WRITE=1 cargo test --test notebooks`.

/// Runs the cells and gives what each of them prints.
pub(crate) fn run() -> Vec<String> {
    let mut printed: Vec<String> = Vec::new();
    macro_rules! println {
        ($($part:tt)*) => { *printed.last_mut().unwrap() += &(format!($($part)*) + "\n") };
    }

    printed.push(String::new());
    use forms::core::check::{decide_all, read_theory};
    use forms::core::decide::Verdict;

    printed.push(String::new());
    let text = "
        chart R3(x, y, z) where x**2 + y**2 + z**2 > 0;
        chart UV(u, v);
        chart Dir(theta, phi) where 0 < theta < pi;
        fn S3(u, v);
        map S: UV -> R3 = (u, v, S3);
        let p1 = sin(theta)*cos(phi);
        let p2 = sin(theta)*sin(phi);
        let p3 = cos(theta);
        form dA_perp: 2 = p1*dy^dz + p2*dz^dx + p3*dx^dy;
        let n1 = -diff(S3, u);
        let n2 = -diff(S3, v);
        let N = sqrt(1 + n1**2 + n2**2);
        let cosine = (p1*n1 + p2*n2 + p3)/N;
        form dA: 2 on UV = N*du^dv;
        prove with_the_cosine: pullback(S, dA_perp) == cosine*dA;
        prove without_the_cosine: pullback(S, dA_perp) == dA;
    ";
    let (mut theory, errors) = read_theory(text);
    println!("{} errors, {} statements", errors.len(), theory.statements.len());

    printed.push(String::new());
    let verdicts = decide_all(&mut theory);
    for (statement, verdict) in theory.statements.iter().zip(&verdicts) {
        println!("{}: {}", statement.name, verdict.name());
    }

    printed.push(String::new());
    for verdict in &verdicts {
        if let Verdict::Refuted(witness) = verdict {
            println!("{witness}");
            println!("left - right = {}", witness.difference);
        }
    }

    printed.push(String::new());
    mod light {
        forms::forms! {
            chart R3(x, y, z) where x**2 + y**2 + z**2 > 0;
            chart UV(u, v);
            param h where h > 0;
            let r = sqrt(x**2 + y**2 + z**2);
            form beta: 2 on R3 = (x*dy^dz + y*dz^dx + z*dx^dy)/r**3;
            map ceiling: UV -> R3 = (u, v, h);
            prove closed: d(beta) == 0;
            prove fourth_power: pullback(ceiling, z/r*beta) == h**2/(u**2 + v**2 + h**2)**2*du^dv;
            /// Solid angle for a unit of area of the ceiling, weighted by the cosine at the floor.
            pub kernel received(u, v, h) = pullback(ceiling, z/r*beta)[du^dv];
        }
    }

    printed.push(String::new());
    for step in 0..5 {
        let u = 0.5 * f64::from(step);
        println!("{u:.1}  {:.6}", light::received(u, 0.0, 1.0));
    }

    printed
}
