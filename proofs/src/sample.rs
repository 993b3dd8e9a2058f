//! Runs of a formula with numbers: random ones, and those at which formulas break.

use kit::random::Random;

use super::run::{Run, calculate};
use super::{Format, Given, Goal, Input, Range, Test};

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

/// Runs a claim with random numbers, in these cases or in any, until a run for which the assumptions hold is
/// wanted; returns its input.
pub(super) fn find(
    format: Format,
    cases: &[(Test, bool)],
    claim: &impl Fn(Given) -> Vec<Goal>,
    runs: u64,
    is_wanted: impl Fn(&Run, &[Goal]) -> bool,
) -> Option<Input> {
    (1..=runs).find_map(|seed| {
        let mut random = Random(seed);
        let sampler =
            move |range: Range, others: &[f64]| sample(&mut random, range, others, format);
        let formula = || claim(Given(format));
        calculate(format, Box::new(sampler), cases, &formula, |run, goals| {
            is_wanted(run, &goals).then(|| run.graph.input())
        })?
    })
}
