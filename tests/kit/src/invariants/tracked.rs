//! A number that carries a bound of its error, so that a tolerance follows from the formula itself: run
//! the crate's own functions with it.

use core::cell::Cell;
use core::cmp::Ordering;
use core::marker::PhantomData;
use core::ops::{Add, Div, Mul, Neg, Sub};
use std::thread_local;

use shading::{Mask, Real, Rgb, Select};

use super::Tried;

thread_local! {
    /// Whether rounding may have decided which way a computation went.
    static UNDECIDED: Cell<bool> = const { Cell::new(false) };
}

/// Runs a computation, and says whether rounding may have decided its way.
pub fn decided<R>(compute: impl FnOnce() -> R) -> (R, bool) {
    UNDECIDED.set(false);
    let result = compute();
    (result, !UNDECIDED.get())
}

/// The exact number, in `f64`, and a bound of the error of the same number in T.
#[derive(Debug)]
pub struct Tracked<T> {
    pub exact: f64,
    pub error: f64,
    number: PhantomData<T>,
}

impl<T> Clone for Tracked<T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T> Copy for Tracked<T> {}

impl<T: Tried> Tracked<T> {
    const fn given(exact: f64, error: f64) -> Self {
        Self {
            exact,
            error,
            number: PhantomData,
        }
    }

    /// A number of T, which has no error yet.
    pub fn input(x: T) -> Self {
        Self::given(x.exact(), 0.0)
    }

    /// After one rounding, which does nothing to a number that T has. Nothing is known of a number out of
    /// range.
    fn rounded(exact: f64, error: f64) -> Self {
        if error == 0.0 && T::of(exact).exact() == exact {
            return Self::given(exact, 0.0);
        }
        if exact.abs() + error <= T::LARGEST {
            Self::given(exact, error + T::U * (exact.abs() + error) + T::STEP)
        } else {
            Self::given(exact, f64::INFINITY)
        }
    }

    /// The sign is known, or it does not matter.
    fn has_sign(self) -> bool {
        self.exact.abs() > self.error || self.error == 0.0
    }

    fn is_zero(self) -> bool {
        self.exact == 0.0 && self.error == 0.0
    }

    fn is_power_of_two(self) -> bool {
        self.error == 0.0 && self.exact.abs().log2().fract() == 0.0
    }
}

impl<T> PartialEq for Tracked<T> {
    fn eq(&self, other: &Self) -> bool {
        self.partial_cmp(other) == Some(Ordering::Equal)
    }
}

/// A comparison decides where a computation goes.
impl<T> PartialOrd for Tracked<T> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        let errors = self.error + other.error;
        let is_sure = errors == 0.0 || (self.exact - other.exact).abs() > errors;
        UNDECIDED.set(UNDECIDED.get() || !is_sure);
        self.exact.partial_cmp(&other.exact)
    }
}

impl<T: Tried> Neg for Tracked<T> {
    type Output = Self;
    fn neg(self) -> Self {
        Self::given(-self.exact, self.error)
    }
}

impl<T: Tried> Add for Tracked<T> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let exact = self.exact + other.exact;
        if self.is_zero() || other.is_zero() {
            return Self::given(exact, self.error + other.error);
        }
        Self::rounded(exact, self.error + other.error)
    }
}

impl<T: Tried> Sub for Tracked<T> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<T: Tried> Mul for Tracked<T> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let exact = self.exact * other.exact;
        let is_finite = self.exact.is_finite() && other.exact.is_finite();
        if (self.is_zero() || other.is_zero()) && is_finite {
            return Self::ZERO;
        }
        let error = self.error * other.exact.abs() + other.error * self.exact.abs();
        let error = error + self.error * other.error;
        let error = if error.is_nan() { f64::INFINITY } else { error };
        let is_scaled = self.is_power_of_two() || other.is_power_of_two();
        if is_scaled
            && T::IS_FLOAT
            && exact.abs() > T::STEP / T::U
            && exact.abs() + error <= T::LARGEST
        {
            return Self::given(exact, error);
        }
        Self::rounded(exact, error)
    }
}

impl<T: Tried> Div for Tracked<T> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let exact = self.exact / other.exact;
        let least = other.exact.abs() - other.error;
        if least <= 0.0 {
            return Self::given(exact, f64::INFINITY);
        }
        if other.is_power_of_two() {
            return self * Self::given(1.0 / other.exact, 0.0);
        }
        let of_divisor = if other.error == 0.0 {
            0.0
        } else {
            exact.abs() * other.error
        };
        Self::rounded(exact, (self.error + of_divisor) / least)
    }
}

/// A comparison, and whether rounding cannot have decided it.
#[derive(Clone, Copy, Debug)]
pub struct Above {
    holds: bool,
    is_sure: bool,
}

impl<T: Tried> Select<Tracked<T>> for Above {
    fn select(self, then: Tracked<T>, otherwise: Tracked<T>) -> Tracked<T> {
        let (taken, other) = if self.holds {
            (then, otherwise)
        } else {
            (otherwise, then)
        };
        if self.is_sure {
            return taken;
        }
        // either may be taken
        let error = ((taken.exact - other.exact).abs() + other.error).max(taken.error);
        Tracked::given(
            taken.exact,
            if error.is_nan() { f64::INFINITY } else { error },
        )
    }
}

impl Mask for Above {
    fn any(self) -> bool {
        UNDECIDED.set(UNDECIDED.get() || !self.is_sure);
        self.holds
    }

    fn all(self) -> bool {
        self.any()
    }
}

impl<T: Tried> Real for Tracked<T> {
    type Mask = Above;
    type Sum = Rgb<Self>;

    const ZERO: Self = Self::given(0.0, 0.0);
    const ONE: Self = Self::given(1.0, 0.0);
    const NEG_ONE: Self = Self::given(-1.0, 0.0);
    const MAX: Self = Self::given(T::LARGEST, 0.0);
    const EXTREME: Self = Self::given(T::LARGE, 0.0);

    fn of(literal: f64) -> Self {
        Self::given(literal, (T::of(literal).exact() - literal).abs())
    }

    fn sqrt(self) -> Self {
        if self.exact < 0.0 {
            return Self::given(f64::NAN, f64::INFINITY);
        }
        let root = self.exact.sqrt();
        let least = (self.exact - self.error).max(0.0).sqrt();
        let error = if self.error == 0.0 {
            0.0
        } else {
            self.error / (root + least)
        };
        Self::rounded(root, error)
    }

    /// The sign of a rounded difference is that of the difference.
    fn above(self, other: Self) -> Above {
        let difference = Self::given(self.exact - other.exact, self.error + other.error);
        Above {
            holds: difference.exact > 0.0,
            is_sure: difference.has_sign(),
        }
    }
}
