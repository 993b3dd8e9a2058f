//! What values a number can have: an interval, and whether NaN, −0 and finite numbers are among them.
//!
//! Rounding is monotone. So the rounded operation on the ends of two intervals gives the ends of the
//! result, and nothing is widened.

use super::format::Format;

/// The numbers from `low` to `high`, and whether a value may be NaN, −0 or finite. For the two ends, −0
/// counts as 0. There are no numbers if `low` > `high`.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Range {
    /// The least number.
    pub low: f64,
    /// The greatest number.
    pub high: f64,
    /// Whether NaN is possible.
    pub nan: bool,
    /// Whether −0 is possible.
    pub minus_zero: bool,
    /// Whether a finite number is possible. If not, the numbers are those of −∞ and ∞ that lie within.
    pub finite: bool,
}

const INF: f64 = f64::INFINITY;

impl Range {
    /// All bits.
    pub const ANY: Self = Self {
        low: -INF,
        high: INF,
        nan: true,
        minus_zero: true,
        finite: true,
    };
    /// Nothing.
    pub const NONE: Self = Self {
        low: INF,
        high: -INF,
        nan: false,
        minus_zero: false,
        finite: false,
    };
    /// NaN alone.
    pub const NAN: Self = Self {
        nan: true,
        ..Self::NONE
    };
    /// −∞, ∞ and NaN.
    pub const NOT_FINITE: Self = Self {
        finite: false,
        minus_zero: false,
        ..Self::ANY
    };

    /// The numbers from `low` to `high`, with −0 if 0 is among them.
    #[must_use]
    pub fn within(low: f64, high: f64) -> Self {
        Self {
            low,
            high,
            nan: false,
            ..Self::ANY
        }
        .tidy()
    }

    /// The same without −0.
    #[must_use]
    pub fn unsigned(low: f64, high: f64) -> Self {
        Self {
            minus_zero: false,
            ..Self::within(low, high)
        }
    }

    /// Whether a value is one of these.
    #[must_use]
    pub fn contains(self, x: f64) -> bool {
        if x.is_nan() {
            self.nan
        } else {
            self.has(x) && (self.minus_zero || x != 0.0 || x.is_sign_positive())
        }
    }

    /// Whether all values of the other range are among these.
    #[must_use]
    pub fn covers(self, other: Self) -> bool {
        self.tidy().meet(other) == other
    }

    /// Whether there are no values at all.
    #[must_use]
    pub fn is_empty(self) -> bool {
        !self.has_numbers() && !self.nan
    }

    /// The only value, if there is no more than one.
    #[must_use]
    pub fn only(self) -> Option<f64> {
        let has_two_zeros = self.low == 0.0 && self.minus_zero;
        (self.low == self.high && !self.nan && !has_two_zeros).then_some(self.low)
    }

    pub(super) fn has_numbers(self) -> bool {
        self.low <= self.high
    }

    fn has(self, x: f64) -> bool {
        self.low <= x && x <= self.high && (self.finite || x.is_infinite())
    }

    pub(super) fn is_infinite(self) -> bool {
        self.has(INF) || self.has(-INF)
    }

    fn has_minus(self) -> bool {
        self.low < 0.0 || self.minus_zero
    }

    fn has_plus(self) -> bool {
        self.high >= 0.0
    }

    /// The same values, written in the one way.
    fn tidy(mut self) -> Self {
        if !self.finite {
            self.low = if self.low == -INF { -INF } else { INF };
            self.high = if self.high == INF { INF } else { -INF };
        }
        // an end may be NaN
        if !self.has_numbers() {
            return Self {
                nan: self.nan,
                ..Self::NONE
            };
        }
        self.finite &= self.low < INF && self.high > -INF;
        self.minus_zero &= self.low <= 0.0 && self.high >= 0.0 && self.finite;
        self
    }

    #[doc(hidden)]
    #[must_use]
    pub fn of_format(self, f: Format) -> Self {
        let range = self.tidy();
        Self {
            low: -f.round_down(-range.low),
            high: f.round_down(range.high),
            ..range
        }
        .tidy()
    }

    /// The values in both.
    #[must_use]
    pub fn meet(self, other: Self) -> Self {
        Self {
            low: self.low.max(other.low),
            high: self.high.min(other.high),
            nan: self.nan && other.nan,
            minus_zero: self.minus_zero && other.minus_zero,
            finite: self.finite && other.finite,
        }
        .tidy()
    }

    /// The values in either, and whatever lies between them.
    pub(super) fn join(self, other: Self) -> Self {
        Self {
            low: self.low.min(other.low),
            high: self.high.max(other.high),
            nan: self.nan || other.nan,
            minus_zero: self.minus_zero || other.minus_zero,
            finite: self.finite || other.finite,
        }
    }

    /// The same, or NaN.
    #[must_use]
    pub fn or_nan(self) -> Self {
        Self { nan: true, ..self }
    }

    /// The hull of some numbers, each as likely NaN as not.
    fn of(candidates: &[f64], nan: bool, minus_zero: bool, finite: bool) -> Self {
        let numbers = candidates.iter().filter(|x| !x.is_nan());
        let (low, high) = numbers.fold((INF, -INF), |(low, high), x| (low.min(*x), high.max(*x)));
        Self {
            low,
            high,
            nan,
            minus_zero,
            finite,
        }
        .tidy()
    }
}

#[doc(hidden)]
#[allow(clippy::must_use_candidate, clippy::return_self_not_must_use)]
impl Range {
    pub fn opposite(self) -> Self {
        Self {
            low: -self.high,
            high: -self.low,
            minus_zero: self.has(0.0),
            ..self
        }
        .tidy()
    }

    pub fn add(self, b: Self, f: Format) -> Self {
        if !self.has_numbers() || !b.has_numbers() {
            return Self::NAN;
        }
        let opposite = |a: Self, b: Self| a.has(INF) && b.has(-INF);
        Self {
            low: or(self.low + b.low, -INF, f),
            high: or(self.high + b.high, INF, f),
            nan: self.nan || b.nan || opposite(self, b) || opposite(b, self),
            minus_zero: self.minus_zero && b.minus_zero,
            finite: self.finite && b.finite,
        }
        .tidy()
    }

    pub fn sub(self, b: Self, f: Format) -> Self {
        // x − y = 0 has no sign, except −0 − 0
        let minus_zero = self.minus_zero && b.has(0.0);
        Self {
            minus_zero,
            ..self.add(b.opposite(), f)
        }
        .tidy()
    }

    pub fn mul(self, b: Self, f: Format) -> Self {
        if !self.has_numbers() || !b.has_numbers() {
            return Self::NAN;
        }
        let lost = self.has(0.0) && b.is_infinite() || b.has(0.0) && self.is_infinite();
        let minus = self.has_minus() && b.has_plus() || self.has_plus() && b.has_minus();
        // 0 · ∞, if both are ends, stands for the 0 that a finite factor gives
        let candidates = [
            or(self.low * b.low, 0.0, f),
            or(self.low * b.high, 0.0, f),
            or(self.high * b.low, 0.0, f),
            or(self.high * b.high, 0.0, f),
        ];
        let nan = self.nan || b.nan || lost;
        Self::of(&candidates, nan, minus, self.finite && b.finite)
    }

    pub fn square(self, f: Format) -> Self {
        let product = self.mul(self, f);
        let nan = self.nan;
        Self { nan, ..product }.meet(Self::unsigned(0.0, INF).or_nan())
    }

    pub fn div(self, b: Self, f: Format) -> Self {
        if !self.has_numbers() || !b.has_numbers() {
            return Self::NAN;
        }
        let nan = self.has(0.0) && b.has(0.0) || self.is_infinite() && b.is_infinite();
        let minus = self.has_minus() && b.has_plus() || self.has_plus() && b.has_minus();
        let mut candidates = Vec::new();
        let mut by = |low: f64, high: f64, sign: f64| {
            for x in [self.low, self.high] {
                candidates.extend([sign * f.round(x / low), sign * f.round(x / high)]);
            }
        };
        if b.high > 0.0 {
            by(b.low.max(f.tiny()), b.high, 1.0);
        }
        if b.low < 0.0 {
            by((-b.high).max(f.tiny()), -b.low, -1.0);
        }
        if b.is_infinite() && self.finite {
            candidates.push(0.0);
        }
        if b.has(0.0) {
            let signs: &[f64] = if b.minus_zero { &[1.0, -1.0] } else { &[1.0] };
            for sign in signs {
                if self.high > 0.0 {
                    candidates.push(sign * INF);
                }
                if self.low < 0.0 {
                    candidates.push(-sign * INF);
                }
            }
        }
        let is_by_zero = b.low == 0.0 && b.high == 0.0;
        let finite = self.finite && !is_by_zero;
        Self::of(&candidates, self.nan || b.nan || nan, minus, finite)
    }

    pub fn sqrt(self, f: Format) -> Self {
        let nan = self.nan || self.low < 0.0;
        if !self.has_numbers() || self.high < 0.0 {
            return Self { nan, ..Self::NONE };
        }
        Self {
            low: f.round(self.low.max(0.0).sqrt()),
            high: f.round(self.high.sqrt()),
            nan,
            ..self
        }
        .tidy()
    }
}

/// A rounded number, or the limit if it is NaN.
fn or(x: f64, limit: f64, f: Format) -> f64 {
    if x.is_nan() { limit } else { f.round(x) }
}
