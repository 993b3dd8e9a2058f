//! Times every public function over 4,096 random arguments.

#[path = "support/functions.rs"]
mod functions;

use std::hint::black_box;
use std::time::Duration;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use functions::{CALLS, FUNCTIONS, places};

fn functions(criterion: &mut Criterion) {
    let places = places();
    let mut group = criterion.benchmark_group("function");
    group.throughput(Throughput::Elements(CALLS.into()));
    for (name, function) in FUNCTIONS {
        group.bench_function(*name, |bencher| {
            bencher.iter(|| {
                for place in black_box(&places) {
                    function(place);
                }
            });
        });
    }
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .warm_up_time(Duration::from_millis(200))
        .measurement_time(Duration::from_millis(800));
    targets = functions
}
criterion_main!(benches);
