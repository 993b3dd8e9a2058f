//! Floor 3: what distance and the cone of a spot leave of a light.

use crate::real::Real;
use crate::vector::UnitVec3;

/// The attenuation of a light with distance.
///
/// ```text
/// 1 / (a + bq + cq²)
/// ```
///
/// q ≥ 0 is the **distance**, not its square; a, b, c ≥ 0 are the constant, linear and quadratic
/// coefficients. Not limited to 1. Evaluated as a + q(b + cq), so that it never rises with q, a,
/// b or c, to the bit. Infinite where the denominator is 0 (−∞ where that is −0, which takes an a of
/// −0); [`Attenuation`] is never.
///
/// Source: Foley, van Dam et al. §16.1.2; OpenGL 2.1 §2.14.1.
///
/// ```
/// use shading::attenuation;
/// assert_eq!(attenuation(1.0_f32, 0.0, 0.0, 5.0), 1.0);
/// assert_eq!(attenuation(0.0_f32, 0.0, 1.0, 4.0), 1.0 / 16.0);
/// ```
#[doc(alias = "falloff")]
#[inline]
#[must_use]
pub fn attenuation<T: Real>(a: T, b: T, c: T, q: T) -> T {
    T::ONE / (a + q * (b + c * q))
}

/// Checked coefficients of the [`attenuation`].
///
/// ```
/// use shading::Attenuation;
///
/// const LAMP: Attenuation<f32> = Attenuation::<f32>::new(1.0, 0.0, 0.25).unwrap();
/// assert_eq!(LAMP.at(2.0), 0.5);
///
/// assert_eq!(Attenuation::<f32>::new(0.0_f32, 0.0, 0.0), None);
/// assert_eq!(Attenuation::<f32>::new(1.0_f32, -0.5, 0.0), None);
/// ```
///
/// An impossible constant fails the build:
///
/// ```compile_fail
/// # use shading::Attenuation;
/// const NONSENSE: Attenuation<f32> = Attenuation::<f32>::new(1.0, -0.5, 0.0).unwrap();
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Attenuation<T> {
    a: T,
    b: T,
    c: T,
    /// Whether the factor is limited to 1.
    clamped: bool,
}

impl<T: Real> Attenuation<T> {
    /// No attenuation: the factor is exactly 1 at every distance.
    pub const NONE: Self = Self {
        a: T::ONE,
        b: T::ZERO,
        c: T::ZERO,
        clamped: false,
    };

    /// The same attenuation limited to 1: min(1, 1/(a + bq + cq²)), as Foley, van Dam et al. have
    /// it in §16.1.2. OpenGL does not limit it.
    ///
    /// ```
    /// use shading::Attenuation;
    ///
    /// let inverse_square = Attenuation::<f32>::new(0.0_f32, 0.0, 1.0).unwrap();
    /// assert_eq!(inverse_square.at(0.5), 4.0);
    /// assert_eq!(inverse_square.clamped().at(0.5), 1.0);
    /// ```
    #[inline]
    #[must_use]
    pub const fn clamped(self) -> Self
    where
        T: Copy,
    {
        Self {
            clamped: true,
            ..self
        }
    }

    /// The factor at the distance q ≥ 0. Where the [`attenuation`] is infinite, the largest finite
    /// number.
    #[inline]
    #[must_use]
    pub fn at(self, q: T) -> T {
        self.limited(self.unlimited(q))
    }

    /// The factor before it is limited.
    #[inline]
    pub(crate) fn unlimited(self, q: T) -> T {
        attenuation(self.a, self.b, self.c, q)
    }

    /// The factor up to its limit, which is not below 1. At an infinite distance it is 0, also
    /// where the formula gives no number.
    #[inline]
    pub(crate) fn limited(self, factor: T) -> T {
        // no field holds the limit: MAX of one type is not MAX in another
        let limit = if self.clamped { T::ONE } else { T::MAX };
        factor.positive_part().at_most(limit)
    }

    /// The same attenuation over another number type; `f` gives the same number in that type.
    #[inline]
    #[must_use]
    pub fn map<U>(self, mut f: impl FnMut(T) -> U) -> Attenuation<U> {
        Attenuation {
            a: f(self.a),
            b: f(self.b),
            c: f(self.c),
            clamped: self.clamped,
        }
    }
}

/// The hard cone of a spot light, by its **half**-angle: the angle between axis and edge. What is
/// commonly given as the spot's opening is twice as much.
///
/// ```
/// use shading::{Cone, UnitVec3};
///
/// // a spot that shines straight down, 60° wide from edge to edge
/// const CONE: Cone<f32> = Cone::<f32>::from_half_angle(core::f32::consts::FRAC_PI_6).unwrap();
/// let axis = -UnitVec3::Z;
///
/// assert_eq!(CONE.factor(axis, UnitVec3::Z), 1.0); // right below: L points up
/// assert_eq!(CONE.factor(axis, UnitVec3::X), 0.0);
/// assert_eq!(Cone::<f32>::from_half_angle(4.0_f32), None); // over π
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cone<T> {
    cosine: T,
}

impl<T: Real> Cone<T> {
    /// 1 inside the cone and on its edge, 0 outside.
    ///
    /// ```text
    /// 1 where −L·axis ≥ cos(half-angle), else 0
    /// ```
    ///
    /// `axis` is the direction in which the spot shines, L points from the surface to the light.
    /// On the axis the factor is 1 for every cone.
    ///
    /// Source: OpenGL 2.1 §2.14.1, with a spot exponent of 0.
    #[inline]
    #[must_use]
    pub fn factor(self, axis: UnitVec3<T>, l: UnitVec3<T>) -> T {
        (self.cosine - (-axis).dot(l)).if_positive(T::ZERO, T::ONE)
    }

    /// The cosine of the half-angle.
    #[inline]
    #[must_use]
    pub fn cosine(self) -> T {
        (self.cosine + T::ONE).if_positive(self.cosine, -T::ONE)
    }

    /// The same cone over another number type; `f` gives the same number in that type.
    #[inline]
    #[must_use]
    pub fn map<U>(self, mut f: impl FnMut(T) -> U) -> Cone<U> {
        Cone {
            cosine: f(self.cosine),
        }
    }
}

macro_rules! checked {
    ($float:ident, $half_pi_rounding:literal) => {
        impl Attenuation<$float> {
            /// Takes the coefficients of 1/(a + bq + cq²). `None` where one is negative or not
            /// finite, or where all are zero.
            #[inline]
            #[must_use]
            pub const fn new(a: $float, b: $float, c: $float) -> Option<Self> {
                const MAX: $float = $float::MAX;
                if a >= 0.0
                    && b >= 0.0
                    && c >= 0.0
                    && a <= MAX
                    && b <= MAX
                    && c <= MAX
                    && (a > 0.0 || b > 0.0 || c > 0.0)
                {
                    Some(Self {
                        a: a + 0.0, // the reciprocal of −0 would be −∞
                        b,
                        c,
                        clamped: false,
                    })
                } else {
                    None
                }
            }
        }

        impl Cone<$float> {
            /// The cone of a half-angle in radians, within [0, π]. `None` outside, and for NaN.
            ///
            /// The cosine is computed with + − × ÷ alone: in a constant, and with the same bits on
            /// every machine.
            #[must_use]
            pub const fn from_half_angle(radians: $float) -> Option<Self> {
                use core::$float::consts::{FRAC_PI_2, FRAC_PI_4, PI};
                if radians >= 0.0 && radians <= PI {
                    // the sine of at most π/4, wherever the angle is
                    Self::from_cosine(if radians < FRAC_PI_4 {
                        Self::cosine_of_small(radians)
                    } else if radians < 3.0 * FRAC_PI_4 {
                        Self::sine_of_small((FRAC_PI_2 - radians) + $half_pi_rounding)
                    } else {
                        -Self::cosine_of_small((PI - radians) + 2.0 * $half_pi_rounding)
                    })
                } else {
                    None
                }
            }

            /// cos x = 1 − 2 sin²(x/2)
            const fn cosine_of_small(x: $float) -> $float {
                let sine = Self::sine_of_small(x / 2.0);
                1.0 - 2.0 * sine * sine
            }

            /// Taylor's series, for |x| ≤ π/4
            const fn sine_of_small(x: $float) -> $float {
                let (mut sum, mut term, mut k) = (0.0, x, 1.0);
                while k < 20.0 {
                    sum += term;
                    term = -term * x * x / ((k + 1.0) * (k + 2.0));
                    k += 2.0;
                }
                sum
            }

            /// The cone of a half-angle given by its cosine, within [−1, 1]. `None` outside, and
            /// for NaN.
            ///
            /// A cosine next to 1 is taken as 1 − 4ε (an angle of 0.06° in `f32`), and one next to
            /// −1 as every direction, so that the rounding of directions can neither put the axis
            /// outside its own cone nor anything outside the cone of π.
            #[must_use]
            pub const fn from_cosine(cosine: $float) -> Option<Self> {
                const SLACK: $float = 4.0 * $float::EPSILON;
                if !(cosine >= -1.0 && cosine <= 1.0) {
                    return None;
                }
                Some(Self {
                    cosine: if cosine > 1.0 - SLACK {
                        1.0 - SLACK
                    } else if cosine < SLACK - 1.0 {
                        -1.0 - SLACK
                    } else {
                        cosine
                    },
                })
            }
        }
    };
}

// with what π/2 is more than the float nearest to it
checked!(f32, -4.371_139e-8);
checked!(f64, 6.123_233_995_736_766e-17);
