//! Runs of a formula with numbers: random ones, and those at which formulas break.

use kit::random::Random;

use super::format::Format;
use super::goal::Goal;
use super::graph::Test;
use super::range::Range;
use super::run::{Run, calculate};

/// A number of a range, which is often one that another variable has, too.
#[allow(clippy::cast_possible_truncation)] // any bits will do
fn sample(random: &mut Random, range: Range, others: &[f64], format: Format) -> f64 {
    let pick = |random: &mut Random, list: &[f64]| list[random.below(list.len())];
    loop {
        let x = match random.below(10) {
            0 => pick(random, &[0.0, -0.0, 1.0, -1.0, 0.5, f64::NAN]),
            1 => pick(random, &[f64::INFINITY, -f64::INFINITY, format.max()]),
            2 => {
                let tiny = format.tiny();
                pick(random, &[range.low, range.high, tiny, -tiny])
            }
            3 => pick(random, others),
            4 => -pick(random, others),
            // few digits, so that sums and products of them are often exact
            5 => f64::from(random.bits() as u8) / 128.0 - 1.0,
            6 if (range.high - range.low).is_finite() => random.within(range.low, range.high),
            6 | 7 => random.within(-1050.0, 1050.0).floor().exp2(),
            _ if format == Format::F64 => f64::from_bits(random.bits()),
            _ => f64::from(f32::from_bits(random.bits() as u32)),
        };
        let x = format.round(x);
        if range.contains(x) {
            return x;
        }
    }
}

/// Runs a formula with random numbers, in these cases or in any; `each` sees those runs for which
/// the assumptions hold, and says whether to go on.
pub(super) fn try_out(
    format: Format,
    cases: &[(Test, bool)],
    formula: &impl Fn() -> Vec<Goal>,
    runs: u64,
    mut each: impl FnMut(&Run, Vec<Goal>) -> bool,
) {
    for seed in 1..=runs {
        let mut random = Random(seed);
        let sampler =
            move |range: Range, others: &[f64]| sample(&mut random, range, others, format);
        if calculate(format, Box::new(sampler), cases, formula, &mut each) == Some(false) {
            return;
        }
    }
}
