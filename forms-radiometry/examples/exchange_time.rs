use forms_radiometry::geometry::{Polygon, Vector, view_factor};
fn main() {
    let mut state = 88172645463325252u64;
    let mut number = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    };
    for distance in [0.5, 1.0, 1.5, 2.0, 3.0, 5.0, 10.0, 30.0, 100.0, 1e4] {
        let mut pairs = Vec::new();
        while pairs.len() < 400 {
            let mut square = |away: f64| {
                let mut vector = || Vector::new(number(), number(), number());
                let (u, w) = (vector().unit().unwrap(), vector());
                let v = u.cross(w).unit().unwrap();
                let o = vector() + Vector::new(0.0, 0.0, away);
                Polygon::new(vec![o, o + u, o + u + v, o + v]).unwrap()
            };
            let (a, b) = (square(0.0), square(distance));
            let va = view_factor(&a, &b, 1e-12);
            if va.area > 0.0 {
                pairs.push((a, b));
            }
        }
        let mut best = f64::INFINITY;
        let mut times: Vec<f64> = pairs
            .iter()
            .map(|(a, b)| {
                let mut t = f64::INFINITY;
                for _ in 0..20 {
                    let s = std::time::Instant::now();
                    std::hint::black_box(view_factor(a, b, 1e-12));
                    t = t.min(s.elapsed().as_secs_f64());
                }
                t
            })
            .collect();
        times.sort_by(f64::total_cmp);
        let worst = pairs
            .iter()
            .map(|(a, b)| {
                let f = view_factor(a, b, 1e-12);
                f.error / f.area
            })
            .fold(0.0, f64::max);
        best = times[times.len() / 2].min(best);
        println!(
            "distance {distance}: median {:.2} µs, 90% {:.2} µs, worst {:.1} µs, error said {:.1e}",
            best * 1e6,
            times[360] * 1e6,
            times[399] * 1e6,
            worst
        );
    }
}
