//! How long a definition block takes to expand: what a build of `pga-motor` waits for.

use criterion::{Criterion, criterion_group, criterion_main};
use std::hint::black_box;

fn expansion(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("expansion");
    group.sample_size(10);
    for name in ga_codegen::preset::NAMES {
        let text = ga_codegen::preset::text(name).expect("a preset of that name");
        group.bench_function(name, |bencher| {
            bencher.iter(|| {
                let block = black_box(text).parse().expect("a preset is made of tokens");
                ga_codegen::expand(block).expect("a preset expands")
            });
        });
    }
    group.finish();
}

criterion_group!(benches, expansion);
criterion_main!(benches);
