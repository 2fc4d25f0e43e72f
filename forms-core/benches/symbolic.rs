//! Benchmarks of the symbolic core: closed forms, d², stars, Lie derivatives, pullbacks, integrals,
//! powers of a 2-form, one large product. Each time covers the named work only. Workloads called
//! "built" use forms built beforehand; all others except powers, products and d² start from text.

use criterion::{Criterion, criterion_group, criterion_main};
use forms_core_testing::workload;
use forms_testing::page;

fn workloads(criterion: &mut Criterion) {
    for mut work in workload::all() {
        let goal = if work.goal.is_empty() { String::new() } else { format!(" (goal {})", work.goal) };
        criterion.bench_function(&format!("{}{goal}", work.name), |bencher| bencher.iter(|| (work.run)()));
    }
}

fn processor(_: &mut Criterion) {
    println!("processor: {}", page::processor());
}

criterion_group! {
    name = symbolic;
    config = Criterion::default()
        .sample_size(20)
        .measurement_time(std::time::Duration::from_secs(1))
        .warm_up_time(std::time::Duration::from_millis(300));
    targets = processor, workloads
}
criterion_main!(symbolic);
