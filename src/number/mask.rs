//! Where a comparison holds, and what it chooses.

/// Where a comparison of numbers holds: a `bool`, or one for each lane.
pub trait Mask<T>: Copy {
    /// Whether it holds in any lane. If not, a whole computation may be skipped.
    #[must_use]
    fn any(self) -> bool;

    /// Whether it holds in each lane.
    #[must_use]
    fn all(self) -> bool;

    /// `then` where the mask holds, and `otherwise` elsewhere. Maximum, clamp and all guards are built
    /// from it.
    ///
    /// ```
    /// use shading::Real;
    /// use shading::number::Mask;
    /// assert_eq!(0.0_f32.above(0.0).select(10, 20), 20);
    /// ```
    #[must_use]
    fn select(self, then: T, otherwise: T) -> T;
}

/// A `bool` chooses between values of every type.
impl<T> Mask<T> for bool {
    #[inline]
    fn any(self) -> bool {
        self
    }

    #[inline]
    fn all(self) -> bool {
        self
    }

    // The compiler can turn this into the processor's minimum or maximum. `f32::min` is a library call on Arm.
    #[inline]
    fn select(self, then: T, otherwise: T) -> T {
        if self { then } else { otherwise }
    }
}
