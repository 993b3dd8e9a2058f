//! Falloff of light with distance.

use crate::color::Rgb;
use crate::number::cast::{end, nearest, positive};
use crate::number::{Dimmed, Mask, Real, Scalar};
use crate::vector::Vec3;

/// The factor by which distance attenuates a light.
///
/// ```text
/// 1 / (a + bq + cq²)
/// ```
///
/// q ≥ 0 is the **distance**, not its square, in the unit of length of the scene. a, b, c ≥ 0 are
/// the constant, linear and quadratic coefficients. The factor may exceed 1. It is evaluated as
/// 1/(a + q(b + cq)) by [`Real::attenuated`], so it never increases as q, a, b or c increases, not even
/// by rounding.
///
/// If the denominator is 0, the factor is the largest finite number; if it is negative or NaN, 0.
///
/// Source: Foley, van Dam et al. 1990, §16.1.2; OpenGL 2.1, §2.14.1.
///
/// ```
/// use shading::attenuation;
/// assert_eq!(attenuation(0.0_f32, 0.0, 1.0, 4.0), 1.0 / 16.0);
/// ```
#[doc(alias("falloff", "inverse_square", "inverse square"))]
#[inline]
#[must_use]
pub fn attenuation<T: Real>(a: T, b: T, c: T, q: T) -> T {
    T::attenuated(Rgb::WHITE, [a, b, c], q, T::MAX)
        .multiplied()
        .r
}

/// Checked coefficients of the [`attenuation`], and a range at which the light may end. A light with
/// them is never negative or infinite.
///
/// q has the scene's unit of length. b is per unit of length, and c per square of it.
///
/// ```
/// use shading::f32::Attenuation;
///
/// const LAMP: Attenuation = Attenuation::const_new(1.0, 0.0, 0.25).unwrap();
/// assert_eq!(LAMP.at(2.0), 0.5); // 1/(1 + 2²/4)
/// assert_eq!(LAMP.within(8.0).unwrap().at(8.0), 0.0);
/// ```
///
/// An impossible constant fails the build:
///
/// ```compile_fail
/// use shading::f32::Attenuation;
/// const NONSENSE: Attenuation = Attenuation::const_new(1.0, -0.5, 0.0).unwrap();
/// ```
///
/// For a falloff of your own, such as fog, multiply the
/// [`intensity`](crate::IncidentLight::intensity) that arrives.
// Choices are numbers, as the rest: lanes may choose differently. Each falloff has one form, so that equal
// ones are equal: without a range, `squared` is 1.
#[doc(alias("falloff", "inverse_square", "inverse square"))]
#[derive(Clone, Copy, Debug, PartialEq)]
#[must_use]
pub struct Attenuation<T = f32> {
    pub(crate) a: T,
    pub(crate) b: T,
    pub(crate) c: T,
    /// The largest factor, or `MAX`.
    pub(crate) limit: T,
    /// The distance at which the light ends, or `MAX`.
    pub(crate) range: T,
    /// 1 if the window of the range is squared, 0 if it is glTF's.
    pub(crate) squared: T,
}

impl<T: Real> Attenuation<T> {
    /// No attenuation: the factor is exactly 1 at every finite distance.
    pub const NONE: Self = Self::unchecked(T::ONE, T::ZERO, T::ZERO);

    pub(crate) const fn unchecked(a: T, b: T, c: T) -> Self {
        Self {
            a,
            b,
            c,
            limit: T::MAX,
            range: T::MAX,
            squared: T::ONE,
        }
    }

    /// The attenuation 1/(a + bq + cq²). Returns `None` if a coefficient is negative or not finite, or
    /// if all are 0. In a constant, use [`const_new`](Attenuation#method.const_new).
    ///
    /// ```
    /// use shading::Attenuation;
    ///
    /// let inverse_square = Attenuation::new(0.0, 0.0, 1.0).unwrap();
    /// assert_eq!(inverse_square.at(2.0), 0.25);
    /// assert_eq!(Attenuation::new(1.0, -0.5, 0.0), None);
    /// assert_eq!(Attenuation::new(0.0, 0.0, 0.0), None); // infinite everywhere
    /// ```
    #[inline]
    #[must_use]
    pub fn new(a: T, b: T, c: T) -> Option<Self>
    where
        T: Scalar,
    {
        let is_finite = |x: T| x >= T::ZERO && x <= T::MAX;
        let is_positive = a > T::ZERO || b > T::ZERO || c > T::ZERO;
        (is_finite(a) && is_finite(b) && is_finite(c) && is_positive)
            .then(|| Self::unchecked(a + T::ZERO, b + T::ZERO, c + T::ZERO)) // the reciprocal of −0 would be −∞
    }

    /// The same attenuation, ended by a range: the factor is 0 from the distance r on, and the window
    /// w(q) of [`at`](Attenuation::at) takes it there.
    ///
    /// ```text
    /// w(q) = max(0, 1 − (q/r)⁴)²
    /// ```
    ///
    /// Returns `None` if r is 0, negative or NaN. The largest number and ∞ mean no range. In three.js, a
    /// `distance` of 0 means no range. In a constant, use
    /// [`const_within`](Attenuation#method.const_within).
    ///
    /// Source: Brian Karis, *Real Shading in Unreal Engine 4*, SIGGRAPH course, 2013; Babylon.js, Bevy,
    /// Filament and three.js use the same formula.
    #[doc(alias("cutoff", "radius"))]
    #[inline]
    #[must_use]
    pub fn within(self, r: T) -> Option<Self>
    where
        T: Scalar,
    {
        (r > T::ZERO).then(|| self.ended(r.at_most(T::MAX), T::ONE))
    }

    pub(crate) const fn ended(self, range: T, squared: T) -> Self {
        Self {
            range,
            squared,
            ..self
        }
    }

    /// The same attenuation, ended by a range as the specification of glTF recommends: as
    /// [`within`](Attenuation::within), with a window that is not squared. The light stays brighter
    /// toward r and stops there abruptly.
    ///
    /// ```text
    /// w(q) = max(0, 1 − (q/r)⁴)
    /// ```
    ///
    /// Source: KHR_lights_punctual (glTF 2.0), “Range Property”, and its sample viewer. Of the
    /// programs that read glTF, Babylon.js, Bevy, Filament and three.js square the window.
    ///
    /// ```
    /// let lamp = shading::f32::Attenuation::NONE.within_gltf(2.0).unwrap();
    /// assert_eq!(lamp.at(1.0), 0.9375); // 1 − (1/2)⁴
    /// ```
    #[doc(alias("gltf", "cutoff", "radius"))]
    #[inline]
    #[must_use]
    pub fn within_gltf(self, r: T) -> Option<Self>
    where
        T: Scalar,
    {
        let squared = if r < T::MAX { T::ZERO } else { T::ONE };
        (r > T::ZERO).then(|| self.ended(r.at_most(T::MAX), squared))
    }

    /// The same attenuation, limited to 1 as in Foley, van Dam et al., §16.1.2. OpenGL does not
    /// limit it.
    ///
    /// ```text
    /// min(1, 1/(a + bq + cq²))
    /// ```
    #[doc(alias("clamp", "limit"))]
    #[inline]
    pub const fn clamped(self) -> Self {
        Self {
            limit: T::ONE,
            ..self
        }
    }

    /// The same attenuation, limited to another factor than 1. Returns `None` if the limit is 0,
    /// negative or NaN. The largest number and ∞ mean no limit.
    ///
    /// ```text
    /// min(limit, 1/(a + bq + cq²))
    /// ```
    ///
    /// three.js limits its inverse square to 100, and Filament and Bevy to 10,000, which they write as
    /// the least denominator, 0.01 and 0.0001:
    ///
    /// ```
    /// use shading::f32::Attenuation;
    ///
    /// let three_js = Attenuation::new(0.0, 0.0, 1.0).unwrap().clamped_to(100.0).unwrap();
    /// assert_eq!((three_js.at(0.01), three_js.at(2.0)), (100.0, 0.25));
    /// ```
    #[inline]
    #[must_use]
    pub fn clamped_to(self, limit: T) -> Option<Self>
    where
        T: Scalar,
    {
        let limit = limit.at_most(T::MAX);
        (limit > T::ZERO).then_some(Self { limit, ..self })
    }

    /// The coefficients a, b and c.
    #[inline]
    #[must_use]
    pub const fn coefficients(self) -> [T; 3] {
        [self.a, self.b, self.c]
    }

    /// The factor at the distance q ≥ 0.
    ///
    /// ```text
    /// w(q) / (a + bq + cq²),  w(q) = max(0, 1 − (q/r)⁴)²
    /// ```
    ///
    /// Without a range r, w is 1; from r on, the factor is exactly 0. It never increases as q increases,
    /// and a range never makes it larger, not even by rounding. If the [`attenuation`] is infinite, the
    /// result is the largest finite number. At an infinite distance, the result is 0.
    ///
    /// Source: Brian Karis, *Real Shading in Unreal Engine 4*, SIGGRAPH course, 2013, for w; Bevy,
    /// Filament, three.js and Babylon.js (with `FALLOFF_GLTF`) use the same formula.
    ///
    /// ```
    /// let lamp = shading::f32::Attenuation::NONE.within(2.0).unwrap();
    /// assert_eq!(lamp.at(1.0), 0.9375 * 0.9375); // (1 − (1/2)⁴)²
    /// assert_eq!(lamp.at(2.0), 0.0);
    /// ```
    #[inline(always)]
    #[must_use]
    pub fn at(self, q: T) -> T {
        self.dimmed(Rgb::WHITE, Vec3::new(q, T::ZERO, T::ZERO), q)
            .multiplied()
            .r
    }

    /// A color of light after the distance q.
    #[inline(always)]
    pub(crate) fn dimmed(&self, color: Rgb<T>, v: Vec3<T>, q: T) -> Dimmed<T> {
        let light = T::attenuated(color, self.coefficients(), q, self.limit);
        let has_range = T::MAX.above(self.range);
        if !has_range.any() {
            return light;
        }
        let windowed = T::windowed(light, v, q, self.range, self.squared.above(T::ZERO));
        // in lanes, some may have no range
        Dimmed {
            color: Rgb::select(has_range, windowed.color, light.color),
            factor: has_range.select(windowed.factor, light.factor),
        }
    }

    /// The same attenuation in another number type. `f` converts each number and may only round it.
    ///
    /// A light without a range or a limit has none in the new type. A number too large for the new type
    /// becomes its largest. Coefficients may round to 0, unless all would: then those above 0 become the
    /// least number of the new type, as do a range and a limit that would be 0.
    #[inline]
    pub fn cast<U: Real>(self, mut f: impl FnMut(T) -> U) -> Attenuation<U> {
        let [mut a, mut b, mut c] = self.coefficients().map(|x| nearest(x, &mut f));
        let is_left = (a + b + c).above(U::ZERO);
        if !is_left.all() {
            a = is_left.select(a, positive(self.a, &mut f));
            b = is_left.select(b, positive(self.b, &mut f));
            c = is_left.select(c, positive(self.c, &mut f));
        }
        let range = end(self.range, &mut f);
        Attenuation {
            a,
            b,
            c,
            limit: end(self.limit, &mut f),
            range,
            squared: U::MAX.above(range).select(f(self.squared), U::ONE),
        }
    }
}

/// The default is [`Attenuation::NONE`].
impl<T: Real + Scalar> Attenuation<T> {
    /// The largest factor, if it is limited.
    ///
    /// ```
    /// use shading::f32::Attenuation;
    ///
    /// assert_eq!(Attenuation::NONE.limit(), None);
    /// assert_eq!(Attenuation::NONE.clamped().limit(), Some(1.0));
    /// ```
    #[inline]
    #[must_use]
    pub fn limit(self) -> Option<T> {
        (self.limit < T::MAX).then_some(self.limit)
    }

    /// The range r, if there is one.
    #[inline]
    #[must_use]
    pub fn range(self) -> Option<T> {
        (self.range < T::MAX).then_some(self.range)
    }

    /// Whether the window of the range is glTF's.
    #[inline]
    #[must_use]
    pub fn is_gltf(self) -> bool {
        self.squared <= T::ZERO
    }
}

impl<T: Real> Default for Attenuation<T> {
    #[inline]
    fn default() -> Self {
        Self::NONE
    }
}

macro_rules! constants {
    ($float:ident) => {
        impl Attenuation<$float> {
            /// [`new`](Attenuation#method.new) for constants.
            #[must_use]
            pub const fn const_new(a: $float, b: $float, c: $float) -> Option<Self> {
                let is_valid = a >= 0.0 && b >= 0.0 && c >= 0.0 && (a > 0.0 || b > 0.0 || c > 0.0);
                if is_valid && a <= $float::MAX && b <= $float::MAX && c <= $float::MAX {
                    Some(Self::unchecked(a + 0.0, b + 0.0, c + 0.0)) // the reciprocal of −0 would be −∞
                } else {
                    None
                }
            }

            /// [`within`](Attenuation#method.within) for constants.
            #[must_use]
            pub const fn const_within(self, r: $float) -> Option<Self> {
                let range = if r > $float::MAX { $float::MAX } else { r };
                if r > 0.0 {
                    Some(self.ended(range, 1.0))
                } else {
                    None
                }
            }
        }
    };
}

constants!(f32);
constants!(f64);
