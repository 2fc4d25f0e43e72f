//! Polynomial arithmetic at three sizes: one large product, tiny everyday operations, and powers of
//! the generic 2-form ω = Σ aᵢⱼ dxᵢ∧dxⱼ, whose top power is m! times the Pfaffian.

use criterion::{Criterion, criterion_group, criterion_main};
use forms_core::polynomial::Polynomial;
use std::collections::BTreeMap;
use std::hint::black_box;

/// Form, as a map from a basis form, given by the set of its factors dxᵢ, to its coefficient.
type Form = BTreeMap<u128, Polynomial>;

fn large_products(criterion: &mut Criterion) {
    let mut sum = Polynomial::one();
    for index in 0..4 {
        sum = sum.add(&Polynomial::variable(index));
    }
    let f = sum.pow(15);
    let g = f.add(&Polynomial::one());
    criterion.bench_function("f(f+1), f = (1+x+y+z+t)^15", |bencher| bencher.iter(|| black_box(&f).mul(&g)));
    let product = f.mul(&g);
    criterion.bench_function("f(f+1) / f", |bencher| bencher.iter(|| black_box(&product).divide_exact(&f)));
}

fn tiny_operations(criterion: &mut Criterion) {
    let x = Polynomial::variable;
    let f = x(0).mul(&x(1)).add(&x(2).pow(2)).sub(&Polynomial::integer(3));
    let g = x(1).pow(3).sub(&x(0).scale(&2.into())).add(&x(5)).add(&Polynomial::one());
    let ten = f.mul(&g).sub(&x(4).pow(2));
    let far = x(70).mul(&x(1)).add(&x(63)).sub(&x(8));
    criterion.bench_function("tiny: 3 terms + 4 terms", |bencher| bencher.iter(|| black_box(&f).add(&g)));
    criterion.bench_function("tiny: 3 terms * 4 terms", |bencher| bencher.iter(|| black_box(&f).mul(&g)));
    criterion.bench_function("tiny: 13 terms * 3 terms", |bencher| bencher.iter(|| black_box(&ten).mul(&f)));
    criterion.bench_function("tiny: far variables", |bencher| bencher.iter(|| black_box(&far).mul(&f)));
    criterion.bench_function("tiny: x * y", |bencher| {
        let (x, y) = (x(0), x(1));
        bencher.iter(|| black_box(&x).mul(&y));
    });
    criterion.bench_function("tiny: derivative", |bencher| bencher.iter(|| black_box(&ten).derivative(1)));
    let copy = ten.clone();
    criterion.bench_function("tiny: equality", |bencher| bencher.iter(|| black_box(&ten) == &copy));
    criterion.bench_function("tiny: clone", |bencher| bencher.iter(|| black_box(&ten).clone()));
    criterion.bench_function("tiny: gcd of coprimes", |bencher| bencher.iter(|| black_box(&f).gcd(&g)));
    let (fg, fx) = (f.mul(&g), f.mul(&x(0).add(&x(5))));
    criterion
        .bench_function("tiny: gcd with a common factor", |bencher| bencher.iter(|| black_box(&fg).gcd(&fx)));
    criterion
        .bench_function("tiny: exact division", |bencher| bencher.iter(|| black_box(&fg).divide_exact(&f)));
    criterion.bench_function("tiny: refused division", |bencher| {
        bencher.iter(|| black_box(&ten).divide_exact(&f));
    });
}

/// Returns the generic 2-form on R²ᵐ, with a variable for each pair of axes.
fn generic_two_form(axes: u32) -> Form {
    let mut form = Form::new();
    for i in 0..axes {
        for j in i + 1..axes {
            form.insert(1 << i | 1 << j, Polynomial::variable(form.len() as u32));
        }
    }
    form
}

/// Returns the sign that sorts the factors of two basis forms: −1 for each pair out of order.
fn sign(left: u128, right: u128) -> i64 {
    let mut inversions = 0;
    let mut rest = left >> 1;
    while rest != 0 {
        inversions += (rest & right).count_ones();
        rest >>= 1;
    }
    if inversions % 2 == 0 { 1 } else { -1 }
}

/// Returns α∧β, with the products grouped by output blade.
fn wedge(left: &Form, right: &Form) -> Form {
    let mut groups: BTreeMap<u128, Vec<(i64, &Polynomial, &Polynomial)>> = BTreeMap::new();
    for (&a, f) in left {
        for (&b, g) in right {
            if a & b == 0 {
                groups.entry(a | b).or_default().push((sign(a, b), f, g));
            }
        }
    }
    collect(groups)
}

/// Returns α∧α for α of even degree: its components commute, so each unordered pair counts twice.
fn square(form: &Form) -> Form {
    let blades: Vec<_> = form.iter().collect();
    let mut groups: BTreeMap<u128, Vec<(i64, &Polynomial, &Polynomial)>> = BTreeMap::new();
    for (index, &(&a, f)) in blades.iter().enumerate() {
        for &(&b, g) in &blades[index + 1..] {
            if a & b == 0 {
                groups.entry(a | b).or_default().push((2 * sign(a, b), f, g));
            }
        }
    }
    collect(groups)
}

fn collect(groups: BTreeMap<u128, Vec<(i64, &Polynomial, &Polynomial)>>) -> Form {
    groups.into_iter().map(|(blade, terms)| (blade, Polynomial::sum_of_products(&terms))).collect()
}

fn form_powers(criterion: &mut Criterion) {
    let five = generic_two_form(10);
    let fifth = |form: &Form| wedge(&square(&square(form)), form);
    assert_eq!(fifth(&five).values().map(Polynomial::term_count).sum::<usize>(), 945);
    criterion.bench_function("ω⁵ in R¹⁰", |bencher| bencher.iter(|| fifth(black_box(&five))));
    let six = generic_two_form(12);
    let sixth = |form: &Form| {
        let second = square(form);
        wedge(&square(&second), &second)
    };
    assert_eq!(sixth(&six).values().map(Polynomial::term_count).sum::<usize>(), 10_395);
    criterion.bench_function("ω⁶ in R¹²", |bencher| bencher.iter(|| sixth(black_box(&six))));
}

criterion_group! {
    name = polynomial;
    config = Criterion::default()
        .sample_size(20)
        .measurement_time(std::time::Duration::from_secs(2))
        .warm_up_time(std::time::Duration::from_millis(500));
    targets = tiny_operations, form_powers, large_products
}
criterion_main!(polynomial);
