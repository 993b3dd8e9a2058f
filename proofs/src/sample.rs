//! Runs of a formula with numbers: random ones, and those at which formulas break.

use super::format::Format;
use super::goal::Goal;
use super::graph::Test;
use super::range::Range;
use super::run::{Run, calculate};

/// A generator of random bits (xorshift), the same on every machine.
pub(super) struct Random(u64);

impl Random {
    pub(super) fn new(seed: u64) -> Self {
        Self(0x9E37_79B9_7F4A_7C15 ^ seed.wrapping_mul(0xD134_2543_DE82_EF95))
    }

    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    /// A number of a range, which is often one that another variable has, too.
    #[allow(clippy::cast_possible_truncation, clippy::cast_precision_loss)] // any bits will do
    fn sample(&mut self, range: Range, others: &[f64], format: Format) -> f64 {
        let pick = |list: &[f64], at: u64| list[at as usize % list.len()];
        loop {
            let at = self.next() >> 8;
            let share = (at % 4096) as f64 / 4096.0;
            let x = match self.next() % 10 {
                0 => pick(&[0.0, -0.0, 1.0, -1.0, 0.5, f64::NAN], at),
                1 => pick(&[f64::INFINITY, -f64::INFINITY, format.max()], at),
                2 => pick(&[range.low, range.high, format.tiny(), -format.tiny()], at),
                3 => pick(others, at),
                4 => -pick(others, at),
                5 => 2.0 * share - 1.0,
                6 if (range.high - range.low).is_finite() => {
                    range.low + (range.high - range.low) * share
                }
                6 | 7 => 2.0_f64.powi((at % 2100) as i32 - 1050),
                _ if format == Format::F64 => f64::from_bits(self.next()),
                _ => f64::from(f32::from_bits(at as u32)),
            };
            let x = format.round(x);
            if range.contains(x) {
                return x;
            }
        }
    }
}

/// Runs a formula with random numbers, in these cases or in any; `each` sees those runs for which the assumptions hold,
/// and says whether to go on.
pub(super) fn try_out(
    format: Format,
    cases: &[(Test, bool)],
    formula: &impl Fn() -> Vec<Goal>,
    runs: u64,
    mut each: impl FnMut(&Run, Vec<Goal>) -> bool,
) {
    for seed in 1..=runs {
        let mut random = Random::new(seed);
        let sampler = move |range: Range, others: &[f64]| random.sample(range, others, format);
        if calculate(format, Box::new(sampler), cases, formula, &mut each) == Some(false) {
            return;
        }
    }
}
