//! The workloads of the summary one by one, with what criterion knows of them: distributions, changes since the last run, plots.
//!
//! ```console
//! $ cargo bench --bench workloads -- compose
//! ```

mod support;

use std::time::Duration;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};

fn workloads(criterion: &mut Criterion) {
    for workload in support::all() {
        let mut group = criterion.benchmark_group(workload.name);
        group.throughput(Throughput::Elements(workload.items as u64));
        for mut contender in workload.contenders() {
            group.bench_function(contender.name, |bencher| bencher.iter(&mut contender.run));
        }
        group.finish();
    }
}

criterion_group! {
    name = benches;
    config = Criterion::default().warm_up_time(Duration::from_millis(300)).measurement_time(Duration::from_secs(1));
    targets = workloads
}
criterion_main!(benches);
