//! The macros from a user's perspective: kernels are compared with formulas written by hand, claims
//! with the prover.

/// Bilinear patch, solid angle and phase function, all in one body.
mod radiometry {
    forms::forms! {
        chart UV(u, v) where 0 <= u <= 1, 0 <= v <= 1;
        chart R3(x, y, z) where x**2 + y**2 + z**2 > 0;
        let r = sqrt(x**2 + y**2 + z**2);
        form beta: 2 on R3 = (x*dy^dz + y*dz^dx + z*dx^dy)/r**3;
        map plane: UV -> R3 = (u, v, 1);

        prove closed: d(beta) == 0;
        refute zero: beta == 0;

        /// Solid angle per unit (u, v) of the plane z = 1 seen from the origin.
        pub kernel density(u, v) = pullback(plane, beta)[du^dv];
        pub kernel direction(x, y, z) = (x/r, y/r, z/r);
        pub kernel phase(g, mu) = (1 - g**2)/(4*pi*(1 + g**2 - 2*g*mu)**(3/2)) where -1 < g < 1;
        pub kernel ramp(t) = if t > 0 { t } else { 0 };
        kernel one_third() = 1/3;
        pub kernel versine_ratio(x) = (1 - cos(x))/x**2 within 2 where x > 0;
        pub kernel growth(x) = exp(x) - 1;
        pub kernel share(a, b, c) = (a*b + c)/(a*a + b*b) within 16 where a > 0;
        pub kernel decay(x) = exp(-x) for f32 { by 1 - x approx 1e-4 } where 0 <= x <= 1/100;
        pub kernel gap(a, b) = (a**2 - b**2)/(a + b) by a - b where a + b > 0;
    }

    #[test]
    fn a_private_kernel_is_seen_in_its_own_module() {
        assert_eq!(one_third(), 1.0 / 3.0);
    }
}

/// Arrays, definitions and calls.
mod bodies {
    forms::forms! {
        let ease(t) = t*t*(3 - 2*t);

        /// Where a point of a body is after a rotation about a centre.
        pub kernel turned(p[3], c[3], R[3, 3]) = c + R*(p - c);
        pub kernel distance(p[3], q[3]) = norm(p - q) within 2;
        pub kernel slopes = jacobian(distance; p, q);
        pub kernel distance_and_slopes = value_and_jacobian(distance; p);
        pub kernel rotation(a) = [[cos(a), -sin(a)], [sin(a), cos(a)]];
        pub kernel eased(t) = ease(t) where 0 <= t <= 1;
        pub kernel blend(a, b, t) = a + (b - a)*eased(t);
        pub kernel polynomial(c[4], x) = sum(c[k]*x**k, k = 0..3);
        pub kernel faded(p[2], sigma, s) = p*exp(-sigma*s) effects { absorption: sigma = 0; };
        pub kernel none(unused[2]) = 1;
    }
}

mod theorems {
    forms::include_forms!("tests/files/theorems.forms");
    forms::proof_tests!("tests/files/theorems.forms");
}

/// Returns points of a lattice that does not contain the origin.
fn points() -> impl Iterator<Item = (f64, f64, f64)> {
    let steps = [-2.0, -0.625, 0.125, 1.5];
    steps
        .into_iter()
        .flat_map(move |x| steps.into_iter().flat_map(move |y| steps.into_iter().map(move |z| (x, y, z))))
}

#[track_caller]
fn assert_close(a: f64, b: f64) {
    assert!((a - b).abs() <= 1e-14 * b.abs().max(1.0), "{a} against {b}");
}

#[test]
fn a_kernel_is_computed_by_its_stable_form() {
    assert_eq!(radiometry::growth(1e-17), 1e-17);
    let compiled = forms::core::compile::compile("kernel growth(x) = exp(x) - 1;", &Default::default());
    assert_eq!(compiled.kernel("growth").expect("compiled").values(&[1e-17]), [1e-17]);
}

#[test]
fn kernels_compute_what_the_hand_would_write() {
    for (x, y, z) in points() {
        let r = (x * x + y * y + z * z).sqrt();
        assert_close(radiometry::density(x, y), (1.0 + x * x + y * y).powf(-1.5));
        assert_close(theorems::cosine(x, y, z), z / r);
        for (computed, component) in radiometry::direction(x, y, z).into_iter().zip([x, y, z]) {
            assert_close(computed, component / r);
        }
        assert_eq!(radiometry::ramp(x), x.max(0.0));
    }
}

#[test]
fn a_kernel_is_nan_outside_its_domain() {
    assert_close(radiometry::phase(0.0, 0.3), 0.25 / std::f64::consts::PI);
    assert!(radiometry::phase(1.0, 0.3).is_nan() && radiometry::phase(-1.5, 0.3).is_nan());
}

#[test]
fn every_tier_of_a_kernel_has_its_value() {
    use forms::math::{DoubleDouble, Real};
    let (u, v) = (0.5_f64, -0.25_f64);
    let expected = (1.0 + u * u + v * v).powf(-1.5);
    assert_close(radiometry::density::plain(u, v), expected);
    assert!((radiometry::density::f32(0.5, -0.25) - expected as f32).abs() < 1e-7);
    let precise = radiometry::density::dd(DoubleDouble::from_f64(u), DoubleDouble::from_f64(v));
    assert_close(precise.to_f64(), expected);
    let mut values = [0.0; 3];
    radiometry::density::batch(&[0.5, 0.0, 2.0], &[-0.25, 0.0, 1.0], &mut values).expect("equal lengths");
    for (value, (u, v)) in values.into_iter().zip([(0.5, -0.25), (0.0, 0.0), (2.0, 1.0)]) {
        assert_close(value, radiometry::density(u, v));
    }
    let mut single = [0.0_f32];
    radiometry::density::batch_f32(&[0.5], &[-0.25], &mut single).expect("equal lengths");
    assert!((single[0] - expected as f32).abs() < 1e-7);
    assert!(radiometry::density::batch(&[0.5], &[], &mut [0.0]).is_err());
    let three = DoubleDouble::from_f64(3.0);
    assert_eq!((one_third_times_three(three) - DoubleDouble::from_f64(1.0)).to_f64(), 0.0);
}

/// Uses the tiers of a private kernel without arguments, through its module.
fn one_third_times_three(three: forms::math::DoubleDouble) -> forms::math::DoubleDouble {
    forms::kernel! { third() = 1/3; }
    let mut column = [0.0; 2];
    third::batch(&mut column).expect("one column has one length");
    assert_eq!(column, [third(); 2]);
    third::dd() * three
}

#[test]
fn batches_on_all_processors_and_over_rows_are_the_same_and_keep_what_is_promised() {
    let columns =
        [0.0, 1.0].map(|shift| (0..9000).map(|i| shift + f64::from(i) / 4096.0).collect::<Vec<_>>());
    let [u, v] = columns.each_ref().map(|column| &column[..]);
    let [mut serial, mut parallel] = [vec![0.0; u.len()], vec![0.0; u.len()]];
    radiometry::density::batch(u, v, &mut serial).expect("equal lengths");
    radiometry::density::batch_parallel(u, v, &mut parallel).expect("equal lengths");
    assert_eq!(serial, parallel);

    let arguments =
        forms::rows::ndarray::Array2::from_shape_fn((u.len(), 2), |(row, column)| columns[column][row]);
    let mut rows = forms::rows::ndarray::Array2::zeros((u.len(), 1));
    radiometry::density::batch_rows(arguments.view(), rows.view_mut()).expect("as many rows");
    assert_eq!(rows.column(0).to_vec(), serial);
    let narrow = arguments.slice(forms::rows::ndarray::s![.., ..1]);
    assert!(radiometry::density::batch_rows(narrow, rows.view_mut()).is_err());

    let small: Vec<f64> = (1..9000).map(|i| f64::from(i) * 1e-12).collect();
    let mut halves = vec![0.0; small.len()];
    radiometry::versine_ratio::batch_parallel(&small, &mut halves).expect("equal lengths");
    assert_eq!(halves, vec![0.5; small.len()]);
    let mut halves = forms::rows::ndarray::Array2::zeros((small.len(), 1));
    let small = forms::rows::ndarray::Array2::from_shape_vec((small.len(), 1), small).expect("one column");
    radiometry::versine_ratio::batch_rows(small.view(), halves.view_mut()).expect("as many rows");
    assert!(halves.iter().all(|&half: &f64| half == 0.5));
}

#[test]
fn a_bound_is_kept_by_more_digits_and_a_stable_form_is_what_is_computed() {
    assert_eq!(radiometry::versine_ratio(1e-10), 0.5);
    assert_eq!(radiometry::versine_ratio::plain(1e-10), 0.0);
    let (a, b) = (1.0 + f64::EPSILON, 1.0);
    assert_eq!(radiometry::gap(a, b), f64::EPSILON);
    assert!(radiometry::gap::plain(1e200, 1e199).is_nan());
    assert_close(radiometry::gap(1e200, 1e199), 9e199);
}

#[test]
fn several_outputs_are_several_columns() {
    let (mut x, mut y, mut z) = ([0.0; 2], [0.0; 2], [0.0; 2]);
    radiometry::direction::batch(&[3.0, 0.0], &[4.0, 0.0], &[0.0, -2.0], [&mut x, &mut y, &mut z])
        .expect("equal lengths");
    for (value, expected) in [x, y, z].concat().into_iter().zip([0.6, 0.0, 0.8, 0.0, 0.0, -1.0]) {
        assert_close(value, expected);
    }
    assert_eq!(radiometry::direction::f32(0.0, 0.0, 5.0), [0.0, 0.0, 1.0]);
}

#[test]
fn tiers_are_nan_outside_the_domain_and_choose_by_lanes() {
    assert!(radiometry::phase::f32(1.0, 0.3).is_nan() && radiometry::phase::plain(-1.5, 0.3).is_nan());
    let mut values = [0.0; 3];
    radiometry::phase::batch(&[0.0, 1.0, f64::NAN], &[0.3; 3], &mut values).expect("equal lengths");
    assert!(values[0] > 0.0 && values[1].is_nan() && values[2].is_nan());
    let mut ramp = [7.0; 3];
    radiometry::ramp::batch(&[-1.0, 0.0, 2.5], &mut ramp).expect("equal lengths");
    assert_eq!(ramp, [0.0, 0.0, 2.5]);
}

#[test]
fn one_kernel_may_stand_among_statements() {
    forms::kernel! {
        param n where n > 0;
        let ratio = (n - 1)/(n + 1);
        reflectance(n) = ratio**2
    }
    assert_close(reflectance(1.5), 0.04);
}

#[test]
fn equations_are_proved_where_they_stand() {
    forms::prove! { chart Line(t); sin(t)**2 + cos(t)**2 == 1 }
    forms::prove! {
        chart R4(p, q, r, s);
        let omega = p*dq + r*ds;
        let both = 2*dp^dq^dr^ds;
        d(omega) ^ d(omega) == both
    }
}

#[test]
fn forms_are_evaluated_and_simplified() {
    const AREA: forms::Form = forms::form! {
        chart Polar(r, t);
        chart Plane(x, y);
        map F: Polar -> Plane = (r*cos(t), r*sin(t));
        pullback(F, dx^dy)
    };
    assert_eq!((AREA.degree, AREA.terms), (2, [("dr^dt", "r")].as_slice()));
    let scalar = forms::form! { chart Line(x); diff((x**2 - 1)/(x - 1), x) };
    assert_eq!((scalar.degree, scalar.to_string().as_str()), (0, "1"));
    let zero = forms::form! { chart Plane(x, y); d(x*dx + y*dy) };
    assert_eq!((zero.degree, zero.terms.len(), zero.text), (2, 0, "0"));
    let signs = forms::form! { chart Plane(x, y); (x + y)*dx - dy };
    assert_eq!(signs.text, "(x + y)*dx - dy");
}

mod effects {
    forms::forms! {
        /// Radiance of a beam after a path through a medium that absorbs, scatters and emits.
        pub kernel beam(radiance, emitted, sigma_a, sigma_s, length) =
            radiance*exp(-(sigma_a + sigma_s)*length)
            + emitted*(1 - exp(-(sigma_a + sigma_s)*length))/(sigma_a + sigma_s)
            effects { absorption: sigma_a = 0; scattering: sigma_s = 0; emission: emitted = 0; }
            where sigma_a >= 0, sigma_s >= 0, length >= 0;

        /// Reflectance at normal incidence.
        pub kernel normal_reflectance(n1, n2) = (n1 - n2)**2/(n1 + n2)**2
            effects { index: n2 = n1; } where n1 > 0, n2 > 0;
    }
}

#[test]
fn a_kernel_without_an_effect_is_the_full_kernel_where_the_effect_vanishes() {
    use effects::beam::{Effects, batch_with, with};
    let point = [2.0, 0.5, 0.25, 0.125, 3.0];
    for bits in 0..8 {
        let on = |bit: usize| bits >> bit & 1 == 1;
        let [radiance, mut emitted, mut sigma_a, mut sigma_s, length] = point;
        let effects = Effects { absorption: on(0), scattering: on(1), emission: on(2) };
        (sigma_a, sigma_s) = (if on(0) { sigma_a } else { 0.0 }, if on(1) { sigma_s } else { 0.0 });
        emitted = if on(2) { emitted } else { 0.0 };
        assert_eq!(Effects::of(radiance, emitted, sigma_a, sigma_s, length), effects);
        let sigma = sigma_a + sigma_s;
        let path = if sigma > 0.0 { (1.0 - (-sigma * length).exp()) / sigma } else { length };
        let expected = radiance * (-sigma * length).exp() + emitted * path;
        assert_close(with(effects)(radiance, emitted, sigma_a, sigma_s, length), expected);
        let mut value = [0.0; 2];
        let columns = [radiance, emitted, sigma_a, sigma_s, length].map(|argument| [argument; 2]);
        let [radiance, emitted, sigma_a, sigma_s, length] = columns;
        batch_with(effects)(&radiance, &emitted, &sigma_a, &sigma_s, &length, &mut value)
            .expect("one length");
        assert_close(value[1], expected);
    }
    // In the limit without extinction, the emission along the path adds up.
    assert_eq!(
        with(Effects { absorption: false, scattering: false, emission: true })(2.0, 0.5, 0.0, 0.0, 3.0),
        3.5
    );
}

#[test]
fn what_an_effect_takes_is_not_in_the_code_of_a_kernel_without_it() {
    use effects::beam::Effects;
    let counts =
        [Effects::NONE, Effects { emission: true, ..Effects::NONE }, Effects::ALL].map(Effects::operations);
    assert_eq!(counts[0], 0);
    assert_eq!(counts[1], 2, "a product and a sum");
    assert!(counts[2] >= 8, "{counts:?}");
    assert_eq!(effects::normal_reflectance::Effects::NONE.operations(), 0);
    assert_eq!(effects::normal_reflectance::with(effects::normal_reflectance::Effects::NONE)(1.5, 1.5), 0.0);
}

#[test]
fn a_promise_is_kept_at_every_size_or_an_error() {
    for x in [1e-320, 1e-300, 1e-155, 1e-150, 1e-8, 0.5] {
        let value = radiometry::versine_ratio(x);
        let expected = 0.5 - x * x / 24.0 + x.powi(4) / 720.0 - x.powi(6) / 40320.0;
        assert!((value - expected).abs() < 1e-8, "{x:e}: {value:e}");
        assert_eq!(radiometry::versine_ratio::checked(x), Ok(value));
    }
    assert!(radiometry::versine_ratio::checked(-1.0).expect("no error outside the domain").is_nan());
}

#[test]
fn without_escalation_a_value_is_within_the_promise_or_nan() {
    // a quotient of sums is within 16 units, but for sums that cancel
    let columns = [[3.0, 1.0, 0.5], [1.0, 0.1 + 0.2, 0.25], [-3.0, -0.3 * 1.1, 7.0]];
    let [mut values, mut decided] = [[0.0; 3]; 2];
    let [a, b, c] = &columns;
    radiometry::share::batch(a, b, c, &mut values).expect("columns of one length");
    radiometry::share::batch_no_escalation(a, b, c, &mut decided).expect("columns of one length");
    let alone = [0, 1, 2].map(|row| radiometry::share::no_escalation(a[row], b[row], c[row]));
    for (row, value) in values.into_iter().enumerate() {
        assert!(!value.is_nan());
        assert!(
            decided[row].is_nan() == alone[row].is_nan() && (decided[row].is_nan() || decided[row] == value)
        );
    }
    assert!(!decided[2].is_nan() && radiometry::versine_ratio::no_escalation(0.5).is_nan());
}

#[test]
fn a_form_for_f32_is_computed_in_f32_alone() {
    let mut values = [0.0_f32; 2];
    radiometry::decay::batch_f32(&[0.0, 0.01], &mut values).expect("columns of one length");
    assert_eq!(values, [1.0, 0.99]);
    assert_eq!(radiometry::decay::f32(0.01), 0.99);
    assert_close(radiometry::decay(0.01), (-0.01_f64).exp());
}

#[test]
fn arrays_are_arrays_of_rust() {
    let quarter = [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
    let moved: [f64; 3] = bodies::turned([2.0, 1.0, 5.0], [1.0, 1.0, 1.0], quarter);
    assert_eq!(moved, [1.0, 2.0, 5.0]);
    let distance = bodies::distance([1.0, 2.0, 2.0], [0.0; 3]);
    assert_eq!(distance, 3.0);
    let (value, slopes): (f64, [f64; 3]) = bodies::distance_and_slopes([1.0, 2.0, 2.0], [0.0; 3]);
    assert_eq!(value, 3.0);
    let both: [f64; 6] = bodies::slopes([1.0, 2.0, 2.0], [0.0; 3]);
    for (place, wanted) in [1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0].into_iter().enumerate() {
        assert_close(slopes[place], wanted);
        assert_close(both[place], wanted);
        assert_close(both[place + 3], -wanted);
    }
    let turn: [[f64; 2]; 2] = bodies::rotation(0.5);
    assert_eq!(turn, [[0.5_f64.cos(), -0.5_f64.sin()], [0.5_f64.sin(), 0.5_f64.cos()]]);
    assert_eq!(bodies::polynomial([1.0, 2.0, 3.0, 4.0], 2.0), 1.0 + 4.0 + 12.0 + 32.0);
    assert_eq!(bodies::none([0.0; 2]), 1.0);
}

#[test]
fn calls_compute_the_formulas_that_they_name() {
    for t in [0.0, 0.25, 0.5, 1.0] {
        let eased = t * t * (3.0 - 2.0 * t);
        assert_close(bodies::eased(t), eased);
        assert_close(bodies::blend(2.0, 5.0, t), 2.0 + 3.0 * eased);
    }
    assert!(bodies::eased(1.5).is_nan(), "outside its domain");
}

#[test]
fn every_tier_takes_arrays() {
    use forms::math::{DoubleDouble, Real};
    let (p, q) = ([1.0, 2.0, 2.0], [0.0, 0.0, 0.0]);
    assert_eq!(bodies::distance::plain(p, q), 3.0);
    assert_eq!(bodies::distance::f32([1.0, 2.0, 2.0], [0.0; 3]), 3.0);
    assert_eq!(bodies::distance::checked(p, q), Ok(3.0));
    let of = |point: [f64; 3]| point.map(DoubleDouble::from_f64);
    assert_eq!(bodies::distance::dd(of(p), of(q)).to_f64(), 3.0);
    let (value, slopes) = bodies::distance_and_slopes::plain(p, q);
    assert!(value == 3.0 && (slopes[0] - 1.0 / 3.0).abs() < 1e-15);

    let columns = [[1.0, 2.0], [2.0, 3.0], [2.0, 6.0]];
    let [x, y, z] = [&columns[0][..], &columns[1][..], &columns[2][..]];
    let zero = &[0.0, 0.0][..];
    let mut lengths = [0.0; 2];
    bodies::distance::batch([x, y, z], [zero; 3], &mut lengths).expect("columns of one length");
    assert_eq!(lengths, [3.0, 7.0]);
    let (mut lengths, mut slopes) = ([0.0; 2], [[0.0; 2]; 3]);
    let [a, b, c] = &mut slopes;
    bodies::distance_and_slopes::batch([x, y, z], [zero; 3], (&mut lengths, [a, b, c]))
        .expect("columns of one length");
    assert!(lengths == [3.0, 7.0] && (slopes[2][1] - 6.0 / 7.0).abs() < 1e-15);

    let effects = bodies::faded::Effects::of([1.0, 2.0], 0.0, 3.0);
    assert_eq!(effects, bodies::faded::Effects::NONE);
    assert_eq!(bodies::faded::with(effects)([1.0, 2.0], 0.0, 3.0), [1.0, 2.0]);
}
