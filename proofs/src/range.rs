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

    /// This value alone.
    pub(super) fn exactly(x: f64) -> Self {
        if x.is_nan() {
            return Self::NAN;
        }
        let minus_zero = x == 0.0 && x.is_sign_negative();
        Self {
            minus_zero,
            ..Self::within(x, x)
        }
    }

    /// The ends, and 0 if it is among the numbers, for an infinite end may give NaN where 0 gives a number.
    fn ends(self) -> impl Iterator<Item = f64> + Clone {
        let ends = [self.low, self.high, 0.0].into_iter();
        ends.filter(move |x| self.has(*x))
    }

    /// The range of a rounded operation, from what it gives for the ends, and for those of the other operand,
    /// between which it rises or falls. Where it can give NaN, it gives that for some of these, and where it can
    /// give a finite number, likewise.
    fn combined(
        self,
        other: Self,
        ends: &(impl Iterator<Item = f64> + Clone),
        f: Format,
        operation: fn(f64, f64) -> f64,
        minus_zero: bool,
    ) -> Self {
        let nan = self.nan || other.nan;
        let pairs = self.ends().flat_map(|x| ends.clone().map(move |y| (x, y)));
        let results = pairs.map(|(x, y)| Self::exactly(f.round(operation(x, y))));
        let range = results.fold(Self { nan, ..Self::NONE }, Self::join);
        Self {
            minus_zero,
            ..range
        }
        .tidy()
    }

    /// Whether a value may have the other sign than one of the other range.
    fn has_other_sign(self, b: Self) -> bool {
        self.has_minus() && b.has_plus() || self.has_plus() && b.has_minus()
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
        let minus_zero = self.minus_zero && b.minus_zero;
        self.combined(b, &b.ends(), f, |x, y| x + y, minus_zero)
    }

    pub fn sub(self, b: Self, f: Format) -> Self {
        // x − y = 0 has no sign, except −0 − 0
        let minus_zero = self.minus_zero && b.has(0.0);
        self.combined(b, &b.ends(), f, |x, y| x - y, minus_zero)
    }

    pub fn mul(self, b: Self, f: Format) -> Self {
        let minus_zero = self.has_other_sign(b);
        self.combined(b, &b.ends(), f, |x, y| x * y, minus_zero)
    }

    pub fn square(self, f: Format) -> Self {
        let product = self.mul(self, f);
        let nan = self.nan;
        Self { nan, ..product }.meet(Self::unsigned(0.0, INF).or_nan())
    }

    pub fn div(self, b: Self, f: Format) -> Self {
        // 0 is one of the ends; those below it end at −0, or without that at the nearest number
        let below = [-f.tiny(), -0.0];
        let divisors = b.ends().chain(below).filter(|y| b.contains(*y));
        let minus_zero = self.has_other_sign(b);
        self.combined(b, &divisors, f, |x, y| x / y, minus_zero)
    }

    pub fn sqrt(self, f: Format) -> Self {
        self.combined(
            Self::exactly(0.0),
            &[0.0].into_iter(),
            f,
            |x, _| x.sqrt(),
            self.minus_zero,
        )
    }
}
