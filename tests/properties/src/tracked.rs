//! A number that carries a bound of its error. The crate's own functions, run with it, say how far
//! a result may be from the formula in the book: a tolerance follows from the operations, and not
//! from a guess.

use core::cell::Cell;
use core::cmp::Ordering;
use core::marker::PhantomData;
use core::ops::{Add, Div, Mul, Neg, Sub};

use proptest::prelude::*;
use shading::number::Mask;
use shading::{Real, Rgb, Shaded, UnitVec3, Vec3};

use crate::{Number, Outcome};

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

/// A number in `f64`, and a bound of the error of the same number in T.
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

impl<T: Number> Tracked<T> {
    /// Whether T has fewer digits than `f64`.
    const IS_COARSER: bool = T::U == 0.0 || T::U > f64::EPSILON;

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

    /// After one rounding, which does nothing to a number that T has; an `f64` does not show
    /// whether T has it if T is as precise. Nothing is known of a number out of range.
    fn rounded(exact: f64, error: f64) -> Self {
        if error == 0.0 && Self::IS_COARSER && T::of(exact).exact() == exact {
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

    /// Without a fraction beside the leading bit.
    fn is_power_of_two(self) -> bool {
        self.error == 0.0 && self.exact.to_bits() << 12 == 0
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

impl<T: Number> Neg for Tracked<T> {
    type Output = Self;
    fn neg(self) -> Self {
        Self::given(-self.exact, self.error)
    }
}

impl<T: Number> Add for Tracked<T> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let exact = self.exact + other.exact;
        if self.is_zero() || other.is_zero() {
            return Self::given(exact, self.error + other.error);
        }
        Self::rounded(exact, self.error + other.error)
    }
}

impl<T: Number> Sub for Tracked<T> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<T: Number> Mul for Tracked<T> {
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
        let is_normal = exact.abs() > T::STEP / T::U && exact.abs() + error <= T::LARGEST;
        if is_scaled && T::DOUBLES_EXACTLY && is_normal {
            return Self::given(exact, error);
        }
        Self::rounded(exact, error)
    }
}

impl<T: Number> Div for Tracked<T> {
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

impl<T: Number> Mask<Tracked<T>> for Above {
    fn any(self) -> bool {
        self.decided()
    }

    fn all(self) -> bool {
        self.decided()
    }

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
        let error = if error.is_nan() { f64::INFINITY } else { error };
        Tracked::given(taken.exact, error)
    }
}

impl Above {
    /// The answer on which a path depends.
    fn decided(self) -> bool {
        UNDECIDED.set(UNDECIDED.get() || !self.is_sure);
        self.holds
    }
}

impl<T: Number> Real for Tracked<T> {
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

    /// A power below the least normal `f32` may count as 0, in numbers that are no wider.
    fn whole_power(self, m: u32) -> Self {
        let (mut base, mut power, mut rest) = (self, Self::ONE, m);
        while rest > 0 {
            if rest & 1 == 1 {
                power = power * base;
            }
            base = base * base;
            rest >>= 1;
        }
        let least = f64::from(f32::MIN_POSITIVE);
        let is_wider = T::LARGEST > f64::from(f32::MAX);
        if is_wider || T::SMALLEST > least {
            power
        } else {
            Self::given(power.exact, power.error + least)
        }
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

/// A result, taken apart into numbers; `None` has none.
pub trait Parts<T> {
    fn parts(self) -> Vec<T>;
}

impl<T> Parts<T> for Vec<T> {
    fn parts(self) -> Vec<T> {
        self
    }
}

impl<T: Real> Parts<T> for Vec3<T> {
    fn parts(self) -> Vec<T> {
        <[T; 3]>::from(self).into()
    }
}

impl<T: Real> Parts<T> for UnitVec3<T> {
    fn parts(self) -> Vec<T> {
        (*self).parts()
    }
}

impl<T: Real> Parts<T> for Rgb<T> {
    fn parts(self) -> Vec<T> {
        <[T; 3]>::from(self).into()
    }
}

impl<T: Real> Parts<T> for Shaded<T> {
    fn parts(self) -> Vec<T> {
        let parts = [self.ambient, self.diffuse, self.specular];
        parts.into_iter().flat_map(Rgb::parts).collect()
    }
}

impl<T, P: Parts<T>> Parts<T> for Option<P> {
    fn parts(self) -> Vec<T> {
        self.into_iter().flat_map(P::parts).collect()
    }
}

/// A result of the book's, taken apart into numbers.
pub trait Printed {
    fn numbers(self) -> Vec<f64>;
}

impl Printed for f64 {
    fn numbers(self) -> Vec<f64> {
        vec![self]
    }
}

impl<P: Printed> Printed for Option<P> {
    fn numbers(self) -> Vec<f64> {
        self.into_iter().flat_map(P::numbers).collect()
    }
}

impl<P: Printed, const N: usize> Printed for [P; N] {
    fn numbers(self) -> Vec<f64> {
        self.into_iter().flat_map(P::numbers).collect()
    }
}

/// Fails unless each computed number is as near to the book's as the tracked errors allow. A case
/// that rounding decides is drawn again.
pub fn is_near<T: Number>(
    computed: &[T],
    (tracked, is_decided): (Vec<Tracked<T>>, bool),
    book: &[f64],
    beyond: &[f64],
) -> Outcome {
    prop_assume!(is_decided && tracked.iter().all(|t| t.error.is_finite()));
    prop_assume!(book.iter().all(|b| b.is_finite()));
    prop_assert_eq!(
        computed.len(),
        book.len(),
        "{:?} instead of {:?}",
        computed,
        book
    );
    // the book's formula rounds in `f64`, in another order: that counts if T is no coarser
    let roundings = if Tracked::<T>::IS_COARSER { 1.0 } else { 3.0 };
    let beyond = beyond.iter().chain(core::iter::repeat(&0.0));
    for (((x, t), b), beyond) in computed.iter().zip(&tracked).zip(book).zip(beyond) {
        let own = T::HOOK + 8.0 * f64::EPSILON;
        let tolerance = roundings * t.error + own * b.abs() + T::STEP + beyond;
        prop_assert!(
            (x.exact() - b).abs() <= tolerance,
            "{:?} is not {b:?} ± {tolerance:.1e}",
            x.exact()
        );
    }
    Ok(())
}

/// `prop_assert_book!(scene, call, formula)` computes the call with the input in T, and the
/// formula with the input in `f64`. The tolerance is the error of the call in the number that
/// tracks the errors of T, and what the number may be off beyond that, if it is given.
macro_rules! prop_assert_book {
    ($given:ident, $call:expr, $formula:expr) => {
        prop_assert_book!($given, $call, $formula, [0.0; 0])
    };
    ($given:ident, $call:expr, $formula:expr, $beyond:expr) => {{
        use $crate::tracked::{Parts, Printed, Tracked, decided, is_near};
        let computed: Vec<_> = Parts::<T>::parts($call);
        let tracked = {
            let $given = &$given.cast(Tracked::<T>::input);
            decided(|| Parts::<Tracked<T>>::parts($call))
        };
        let (book, beyond): (Vec<f64>, Vec<f64>) = {
            let $given = &$given.cast(T::exact);
            ($formula.numbers(), $beyond.numbers())
        };
        is_near(&computed, tracked, &book, &beyond)?;
    }};
}
pub(crate) use prop_assert_book;

/// Fails unless two numbers are within a tolerance.
macro_rules! prop_assert_near {
    ($left:expr, $right:expr, $tolerance:expr) => {{
        let (left, right, tolerance): (f64, f64, f64) = ($left, $right, $tolerance);
        proptest::prop_assert!(
            left == right || (left - right).abs() <= tolerance,
            "{left:?} is not {right:?} ± {tolerance:.1e}"
        );
    }};
}
pub(crate) use prop_assert_near;
