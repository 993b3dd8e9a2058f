//! Floor 0: the shininess m, and the power of a cosine.

use crate::power::{four_powers, power, whole_power};
use crate::real::Real;

/// The shininess m of a highlight: a whole number (`u32`) or a real one (`f32`, `f64`).
///
/// A whole m takes the much faster path, by squaring. The type of the argument chooses:
///
/// ```
/// use shading::{Exponent, UnitVec3, term::blinn};
///
/// let n = UnitVec3::<f32>::Z;
/// let h = UnitVec3::<f32>::new(0.0, 0.6, 0.8).unwrap();
/// let whole = blinn(n, h, 32); // five multiplications
/// let real = blinn(n, h, 32.5);
/// assert!(real < whole);
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a shininess for numbers of type `{T}`",
    label = "expected `u32` or `{T}`",
    note = "an integer shininess is a `u32`, as in `m: 32`; a real one has the type of the scene, as in `m: 32.5`",
    note = "`term::phong` and `term::blinn` are factors; the models that take a material are in `shade`"
)]
pub trait Exponent<T>: Copy {
    /// Whether [`raise_four_roots`](Exponent::raise_four_roots) takes little longer than one root, in
    /// SIMD registers: then a sum over lights takes four highlights at a time. The bits are the same.
    const FOUR_AT_ONCE: bool = false;

    /// cosineᵐ for a cosine up to 1; 1 for m = 0. An m below 0, or not a number, counts as 0. Where
    /// the cosine is not above 0, or not a number, the power is 0 for **every** m, also for m = 0.
    ///
    /// A whole m is exact to a relative error of m·u, u the unit roundoff (2⁻²⁴ for `f32`), which
    /// is the power's own conditioning; a real m to an absolute error of 2⁻²² in `f32`. There a
    /// power that would be subnormal may be 0.
    #[must_use]
    fn raise(self, cosine: T) -> T;

    /// (√square)ᵐ for the square of a cosine, with the cosine's sign: what a highlight needs where
    /// the square is at hand and its root would cost more than the power. Otherwise as
    /// [`raise`](Exponent::raise).
    #[must_use]
    fn raise_root(self, square: T) -> T;

    /// [`raise_root`](Exponent::raise_root) of each of four squares.
    #[inline]
    #[must_use]
    fn raise_four_roots(self, squares: [T; 4]) -> [T; 4] {
        squares.map(|square| self.raise_root(square))
    }

    /// [`raise_root`](Exponent::raise_root) as a function of the square, for a sum over lights: what
    /// depends on m alone is computed once.
    #[inline]
    #[must_use]
    fn root_power(self) -> impl Fn(T) -> T {
        #[inline(always)]
        move |square| self.raise_root(square)
    }
}

#[diagnostic::do_not_recommend] // the trait's own message names the types
impl<T: Real> Exponent<T> for u32 {
    #[inline]
    fn raise(self, cosine: T) -> T {
        whole_power(self)(cosine)
    }

    #[inline]
    fn raise_root(self, square: T) -> T {
        self.root_power()(square)
    }

    #[inline]
    fn root_power(self) -> impl Fn(T) -> T {
        let is_even = self % 2 == 0;
        let power = whole_power(if is_even { self / 2 } else { self });
        #[inline(always)]
        move |square: T| power(if is_even { square } else { square.sqrt() })
    }
}

#[diagnostic::do_not_recommend] // the trait's own message names the types
impl Exponent<f32> for f32 {
    const FOUR_AT_ONCE: bool = cfg!(any(
        target_feature = "sse2",
        target_feature = "neon",
        target_feature = "simd128"
    ));

    #[inline(always)]
    fn raise(self, cosine: f32) -> f32 {
        power(cosine, self.positive_part())
    }

    #[inline(always)]
    fn raise_root(self, square: f32) -> f32 {
        (0.5 * self).raise(square)
    }

    #[inline]
    fn raise_four_roots(self, [a, b, c, d]: [f32; 4]) -> [f32; 4] {
        four_powers(a, b, c, d, (0.5 * self).positive_part())
    }
}

#[diagnostic::do_not_recommend] // the trait's own message names the types
impl Exponent<f64> for f64 {
    #[inline]
    fn raise(self, cosine: f64) -> f64 {
        // not `positive_part`, which may leave a signaling NaN as it is
        let power = if self > 0.0 {
            libm::pow(cosine.positive_part(), self)
        } else {
            1.0
        };
        cosine.if_positive(power, 0.0)
    }

    #[inline]
    fn raise_root(self, square: f64) -> f64 {
        (0.5 * self).raise(square)
    }
}
