//! Falloff of light with distance.

use crate::real::{Mask, Real, Scalar, Select};
use crate::rgb::Rgb;

/// The factor by which distance attenuates a light.
///
/// ```text
/// 1 / (a + bq + cq²)
/// ```
///
/// q ≥ 0 is the **distance**, not its square, in the unit of length of the scene. a, b, c ≥ 0 are
/// the constant, linear and quadratic coefficients. The factor may exceed 1. It is evaluated as
/// 1/(a + q(b + cq)), by [`Real::attenuated`], so it never rises, to the bit, as q, a, b or c rises.
///
/// If the denominator is 0, the factor is the largest finite number; if it is negative or NaN, 0.
///
/// Source: Foley, van Dam et al. 1990, §16.1.2; OpenGL 2.1, §2.14.1.
///
/// ```
/// use shading::attenuation;
/// assert_eq!(attenuation(0.0_f32, 0.0, 1.0, 4.0), 1.0 / 16.0);
/// ```
#[doc(alias("falloff", "inverse square"))]
#[inline]
#[must_use]
pub fn attenuation<T: Real>(a: T, b: T, c: T, q: T) -> T {
    let (white, factor) = T::attenuated(Rgb::WHITE, [a, b, c], q, T::MAX);
    white.r * factor
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
// choices are numbers, as the rest: lanes may choose differently
#[doc(alias = "inverse square")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[must_use]
pub struct Attenuation<T = f32> {
    pub(crate) a: T,
    pub(crate) b: T,
    pub(crate) c: T,
    /// The largest factor: 1 if it is clamped, else `MAX`.
    pub(crate) limit: T,
    /// The distance at which the light ends, or `MAX`.
    pub(crate) range: T,
    /// 1 if the window is squared, 0 if it is glTF's.
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

    /// The same attenuation, ended by a range: the factor is 0 from the distance r on. Returns `None`
    /// if r is 0, negative or NaN. The largest number and ∞ mean no range. In three.js, a `distance`
    /// of 0 means no range.
    #[doc(alias = "cutoff")]
    #[inline]
    #[must_use]
    pub fn within(self, r: T) -> Option<Self>
    where
        T: Scalar,
    {
        (r > T::ZERO).then(|| Self {
            range: r.at_most(T::MAX),
            ..self
        })
    }

    /// The same attenuation, limited to 1 as in Foley, van Dam et al., §16.1.2. OpenGL does not
    /// limit it.
    ///
    /// ```text
    /// min(1, 1/(a + bq + cq²))
    /// ```
    #[inline]
    pub const fn clamped(self) -> Self {
        Self {
            limit: T::ONE,
            ..self
        }
    }

    /// The same attenuation, with the window that the specification of glTF recommends:
    /// max(0, 1 − (q/r)⁴) in place of its square. The light is brighter toward r and ends there with
    /// an edge.
    ///
    /// Source: KHR_lights_punctual (glTF 2.0), “Range Property”, and its sample viewer. Of the
    /// programs that read glTF, Babylon.js, Bevy, Filament and three.js square the window.
    ///
    /// ```
    /// let lamp = shading::f32::Attenuation::NONE.within(2.0).unwrap().unsquared();
    /// assert_eq!(lamp.at(1.0), 0.9375); // 1 − (1/2)⁴
    /// ```
    #[doc(alias = "gltf")]
    #[inline]
    pub const fn unsquared(self) -> Self {
        Self {
            squared: T::ZERO,
            ..self
        }
    }

    /// The coefficients a, b and c.
    #[inline]
    #[must_use]
    pub const fn coefficients(self) -> [T; 3] {
        [self.a, self.b, self.c]
    }

    /// The range r, or [`MAX`](Real::MAX) if there is none.
    #[inline]
    #[must_use]
    pub const fn range(self) -> T {
        self.range
    }

    /// Whether the factor is limited to 1.
    #[inline]
    #[must_use]
    pub fn is_clamped(self) -> bool {
        T::MAX.above(self.limit).any()
    }

    /// Whether the window is glTF's.
    #[inline]
    #[must_use]
    pub fn is_unsquared(self) -> bool {
        !self.squared.above(T::ZERO).any()
    }

    /// The factor at the distance q ≥ 0.
    ///
    /// ```text
    /// w(q) / (a + bq + cq²),  w(q) = max(0, 1 − (q/r)⁴)²
    /// ```
    ///
    /// Without a range r, w is 1; from r on, the factor is exactly 0. It never rises as q rises, and
    /// it never exceeds that without a range, to the bit. If the [`attenuation`] is infinite, the
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
        let (white, factor) = self.dimmed(Rgb::WHITE, q);
        white.r * factor
    }

    /// A color and the factor at q.
    #[inline(always)]
    pub(crate) fn dimmed(&self, color: Rgb<T>, q: T) -> (Rgb<T>, T) {
        let light = T::attenuated(color, self.coefficients(), q, self.limit);
        if T::MAX.above(self.range).any() {
            T::windowed(light, q, self.range, self.squared)
        } else {
            light
        }
    }

    /// The same attenuation in another number type. `f` converts each number and may only round it.
    /// A light without a range has none in the new type. A number that the new type cannot hold is the
    /// least or the largest that it can, so that a coefficient above 0 stays above 0.
    #[inline]
    pub fn cast<U: Real>(self, mut f: impl FnMut(T) -> U) -> Attenuation<U> {
        // what is above 0 or finite stays so, and MAX of one type is not MAX in another
        let mut number = |x: T| {
            let mut holds = |mask: T::Mask| f(mask.select(T::ONE, T::ZERO)).above(U::ZERO);
            let (is_positive, is_below) = (holds(x.above(T::ZERO)), holds(T::MAX.above(x)));
            let number = f(x);
            let stays = number.above(U::ZERO);
            let positive = stays.select(number.at_most(U::MAX), U::ONE / U::MAX);
            let number = is_positive.select(positive, U::ZERO);
            is_below.select(number, U::MAX)
        };
        Attenuation {
            a: number(self.a),
            b: number(self.b),
            c: number(self.c),
            limit: number(self.limit),
            range: number(self.range),
            squared: number(self.squared),
        }
    }
}

/// The default is [`Attenuation::NONE`].
impl<T: Real> Default for Attenuation<T> {
    #[inline]
    fn default() -> Self {
        Self::NONE
    }
}

macro_rules! checked {
    ($float:ident) => {
        impl Attenuation<$float> {
            /// [`new`](Attenuation#method.new) for constants.
            #[inline]
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
            #[inline]
            #[must_use]
            pub const fn const_within(self, r: $float) -> Option<Self> {
                let range = if r > $float::MAX { $float::MAX } else { r };
                if r > 0.0 {
                    Some(Self { range, ..self })
                } else {
                    None
                }
            }
        }
    };
}

checked!(f32);
checked!(f64);
