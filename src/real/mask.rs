//! Where a comparison holds, and what it chooses.

/// Where a comparison of numbers holds: a `bool`, or one for each lane.
pub trait Mask: Copy {
    /// Whether it holds in any lane. If not, a whole computation may be skipped.
    #[must_use]
    fn any(self) -> bool;
    /// Whether it holds in each lane.
    #[must_use]
    fn all(self) -> bool;
}

/// What a mask chooses between: every type for a `bool`, and lanes for a mask of lanes.
pub trait Select<T> {
    /// `then` where the mask holds, and `otherwise` elsewhere. Maximum, clamp and all guards are built
    /// from it.
    ///
    /// ```
    /// use shading::{Real, Select};
    /// assert_eq!(0.0_f32.above(0.0).select(10, 20), 20);
    /// ```
    #[must_use]
    fn select(self, then: T, otherwise: T) -> T;
}

// The compiler can turn this into the processor's minimum or maximum. `f32::min` is a library call on Arm.
impl<T> Select<T> for bool {
    #[inline]
    fn select(self, then: T, otherwise: T) -> T {
        if self { then } else { otherwise }
    }
}

impl Mask for bool {
    #[inline]
    fn any(self) -> bool {
        self
    }

    #[inline]
    fn all(self) -> bool {
        self
    }
}

/// A number that can be compared as a whole. Every [`PartialOrd`] type is a scalar. SIMD lanes are
/// not, because one lane may be greater where another is less.
///
/// A function that decides whether to return `Some` or `None` asks for a scalar. In generic code,
/// write `T: Real + PartialOrd`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be compared as a whole, and this function must decide whether there is a result",
    label = "expected `f32`, `f64` or `Dual<_>`",
    note = "with SIMD lanes, call it for each lane, or call a function that returns no `Option`: `Vec3::unit_or` or `cast`",
    note = "in generic code, write `T: Real + PartialOrd`"
)]
pub trait Scalar: PartialOrd {}

#[diagnostic::do_not_recommend] // the trait's own message says what to do
impl<T: PartialOrd> Scalar for T {}
