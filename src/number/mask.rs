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
