//! Runs a property by proptest, and prints the simplest input that breaks it as Rust.

use proptest::test_runner::{Config, RngSeed, TestError, TestRunner};

use crate::given::{Given, Of, Sizes};
use crate::source::wrapped;
use crate::{Number, Outcome};

/// Tries a property of a number, and panics with the simplest input that breaks it.
pub fn run<T: Number, I: Of<T>>(name: &str, number: &str, property: fn(&I) -> Outcome) {
    if let Err(message) = try_property(name, number, property) {
        panic!("{message}");
    }
}

/// Tries a property of a number. The error is a message for a reader, with the call that reproduces
/// it.
pub fn try_property<T: Number, I: Of<T>>(
    name: &str,
    number: &str,
    property: fn(&I) -> Outcome,
) -> Result<(), String> {
    // boxed by the type of the input, so that proptest is compiled once for each and not for each
    // property
    search::<I::Plain>(name, number, Sizes::of::<T>(), &|plain| {
        property(&I::of(plain))
    })
}

/// The same cases at each run, unless `PROPTEST_RNG_SEED` says otherwise; as many as
/// `PROPTEST_CASES` says.
fn config() -> Config {
    let mut config = Config {
        failure_persistence: None, // what failed is pasted into a test
        ..Config::default()
    };
    if config.rng_seed == RngSeed::Random {
        config.rng_seed = RngSeed::Fixed(0);
    }
    // of a number with few digits, rounding decides many cases, which are drawn again
    config.max_global_rejects = 100 * config.cases;
    config.max_shrink_iters = 20_000;
    config
}

fn search<G: Given>(
    name: &str,
    number: &str,
    sizes: Sizes,
    property: &dyn Fn(&G) -> Outcome,
) -> Result<(), String> {
    let result = TestRunner::new(config()).run(&G::any(sizes), |given| property(&given));
    match result {
        Ok(()) => Ok(()),
        Err(TestError::Abort(why)) => Err(format!("{name}: {why}")),
        Err(TestError::Fail(why, given)) => {
            let of = if number.contains('<') {
                format!("<{number}>::of")
            } else {
                format!("{number}::of")
            };
            let call = format!(
                "properties::{name}(&{}.cast({of})).unwrap();",
                given.source()
            );
            Err(format!(
                "{why}\n\nTo reproduce it, with `use properties::*;`:\n\n{}\n",
                wrapped(&call)
            ))
        }
    }
}
