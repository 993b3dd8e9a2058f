//! Falloff of light with distance.

use crate::flag::{Flag, NO, YES};
use crate::real::{Real, Scalar};
use crate::rgb::Rgb;

/// The falloff of a [`PointLight`](crate::PointLight) with distance: an [`Attenuation`], an
/// attenuation that ends at a range ([`Ranged`](crate::Ranged)), or a falloff of your own.
///
/// ```
/// use shading::f32::{PointLight, Vec3};
/// use shading::{Elementary, Falloff, Rgb};
///
/// /// Fog that dims the light to 1/e over each such length.
/// #[derive(Clone, Copy)]
/// struct Fog<T>(T);
///
/// impl<T: Elementary> Falloff<T> for Fog<T> {
///     type In<U> = Fog<U>;
///     fn dim(&self, intensity: &Rgb<T>, q: T) -> Rgb<T> {
///         *intensity * (-q / self.0).exp()
///     }
///     fn cast<U>(self, mut f: impl FnMut(T) -> U) -> Fog<U> {
///         Fog(f(self.0))
///     }
/// }
/// let position = Vec3::new(0.0, 0.0, 2.0);
/// let lamp = PointLight { position, intensity: Rgb::WHITE, attenuation: Fog(2.0) };
/// assert!((lamp.at(Vec3::ZERO).intensity.r - 0.3679).abs() < 1e-4);
/// ```
pub trait Falloff<T>: Copy {
    /// The type of the same falloff in another number type.
    type In<U>;

    /// The intensity that remains at the distance q ≥ 0. If `intensity` is finite, the result must
    /// be finite and not NaN.
    #[must_use]
    fn dim(&self, intensity: &Rgb<T>, q: T) -> Rgb<T>;

    /// The same, given q and a finer q, as by
    /// [`direction_and_distance`](Real::direction_and_distance), and the way to the light.
    #[doc(hidden)]
    #[inline(always)]
    #[must_use]
    fn dim_along(
        &self,
        intensity: &Rgb<T>,
        [q, _]: [T; 2],
        _to_light: impl FnOnce() -> [T; 3],
    ) -> Rgb<T> {
        self.dim(intensity, q)
    }

    /// Whether light may remain at the distance whose square is given, in at least one lane. The
    /// default is `true`.
    #[inline]
    #[must_use]
    fn reaches(&self, square: T) -> bool {
        let _ = square;
        true
    }

    /// The same falloff in another number type. `f` converts each number and may only round it.
    #[must_use]
    fn cast<U: Real>(self, f: impl FnMut(T) -> U) -> Self::In<U>;
}

/// The factor by which distance attenuates a light.
///
/// ```text
/// 1 / (a + bq + cq²)
/// ```
///
/// q ≥ 0 is the **distance**, not its square, in the unit of length of the scene. a, b, c ≥ 0 are
/// the constant, linear and quadratic coefficients. The factor may exceed 1. It is evaluated as
/// 1/(a + q(b + cq)), so it never rises, to the bit, as q, a, b or c rises.
///
/// If the denominator is 0, the factor is infinite: −∞ for a denominator of −0, which only a = −0
/// produces, and ∞ otherwise. The checked [`Attenuation`] is never infinite.
///
/// Source: Foley, van Dam, Feiner, Hughes, *Computer Graphics: Principles and Practice*, 2nd ed.,
/// 1990, §16.1.2; *The OpenGL Graphics System: A Specification*, version 2.1, 2006, §2.14.1.
///
/// ```
/// use shading::attenuation;
/// assert_eq!(attenuation(1.0_f32, 0.0, 0.0, 5.0), 1.0);
/// assert_eq!(attenuation(0.0_f32, 0.0, 1.0, 4.0), 1.0 / 16.0);
/// ```
#[doc(alias = "falloff")]
#[doc(alias = "inverse square")]
#[inline]
#[must_use]
pub fn attenuation<T: Real>(a: T, b: T, c: T, q: T) -> T {
    T::ONE / (a + q * (b + c * q))
}

/// Checked coefficients of the [`attenuation`]. A light with them is never negative or infinite.
///
/// q has the scene's unit of length. b is per unit of length, and c per square of it.
///
/// ```
/// use shading::f32::Attenuation;
///
/// const LAMP: Attenuation = Attenuation::new(1.0, 0.0, 0.25).unwrap();
/// assert_eq!(LAMP.at(2.0), 0.5); // 1/(1 + 2²/4)
/// ```
///
/// An impossible constant fails the build:
///
/// ```compile_fail
/// use shading::f32::Attenuation;
/// const NONSENSE: Attenuation = Attenuation::new(1.0, -0.5, 0.0).unwrap();
/// ```
#[doc(alias = "inverse square")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Attenuation<T = f32> {
    a: T,
    b: T,
    c: T,
    /// Whether the factor is limited to 1.
    clamped: Flag,
}

impl<T: Real> Attenuation<T> {
    /// An attenuation whose coefficients have been checked.
    #[cfg(any(feature = "fixed", feature = "wide"))]
    pub(crate) const fn unchecked(a: T, b: T, c: T) -> Self {
        Self {
            a,
            b,
            c,
            clamped: NO,
        }
    }

    /// [`new`](Attenuation#method.new) for any number type, in generic code: an attenuation, or `None`
    /// if a coefficient is negative or not finite, or if all are 0.
    ///
    /// ```
    /// use shading::{Attenuation, Real};
    ///
    /// fn inverse_square<T: Real + PartialOrd>() -> Option<Attenuation<T>> {
    ///     Attenuation::of(T::ZERO, T::ZERO, T::ONE)
    /// }
    /// assert_eq!(inverse_square(), Attenuation::<f32>::new(0.0, 0.0, 1.0));
    /// assert_eq!(Attenuation::of(1.0_f64, -0.5, 0.0), None);
    /// ```
    #[inline]
    #[must_use]
    pub fn of(a: T, b: T, c: T) -> Option<Self>
    where
        T: Scalar,
    {
        let is_finite = |x: T| x >= T::ZERO && x <= T::MAX;
        let is_positive = a > T::ZERO || b > T::ZERO || c > T::ZERO;
        (is_finite(a) && is_finite(b) && is_finite(c) && is_positive).then(|| Self {
            a: a + T::ZERO, // the reciprocal of −0 would be −∞
            b,
            c,
            clamped: NO,
        })
    }

    /// No attenuation: the factor is exactly 1 at every finite distance.
    ///
    /// ```
    /// use shading::f32::Attenuation;
    /// assert_eq!(Attenuation::NONE.at(1e30), 1.0);
    /// ```
    pub const NONE: Self = Self {
        a: T::ONE,
        b: T::ZERO,
        c: T::ZERO,
        clamped: NO,
    };

    /// The same attenuation, limited to 1 as in Foley, van Dam et al., §16.1.2. OpenGL does not
    /// limit it.
    ///
    /// ```text
    /// min(1, 1/(a + bq + cq²))
    /// ```
    ///
    /// ```
    /// use shading::f32::Attenuation;
    ///
    /// let inverse_square = Attenuation::new(0.0, 0.0, 1.0).unwrap();
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
            clamped: YES,
            ..self
        }
    }

    /// The coefficients a, b and c.
    ///
    /// ```
    /// use shading::f32::Attenuation;
    /// assert_eq!(Attenuation::new(1.0, 0.0, 0.25).unwrap().coefficients(), [1.0, 0.0, 0.25]);
    /// ```
    #[inline]
    #[must_use]
    pub const fn coefficients(self) -> [T; 3]
    where
        T: Copy,
    {
        [self.a, self.b, self.c]
    }

    /// Whether the factor is limited to 1, as by [`clamped`](Attenuation::clamped).
    ///
    /// ```
    /// use shading::f32::Attenuation;
    ///
    /// let inverse_square = Attenuation::new(0.0, 0.0, 1.0).unwrap();
    /// assert!(!inverse_square.is_clamped() && inverse_square.clamped().is_clamped());
    /// ```
    #[inline]
    #[must_use]
    pub const fn is_clamped(self) -> bool
    where
        T: Copy,
    {
        self.clamped == YES
    }

    /// The factor at the distance q ≥ 0.
    ///
    /// ```text
    /// 1 / (a + bq + cq²)
    /// ```
    ///
    /// If the [`attenuation`] is infinite, the result is the largest finite number. At an infinite
    /// distance, the result is 0.
    ///
    /// ```
    /// use shading::f32::Attenuation;
    ///
    /// let inverse_square = Attenuation::new(0.0, 0.0, 1.0).unwrap();
    /// assert_eq!(inverse_square.at(4.0), 1.0 / 16.0);
    /// assert_eq!(inverse_square.at(0.0), f32::MAX);
    /// ```
    #[inline]
    #[must_use]
    pub fn at(self, q: T) -> T {
        // at an infinite distance the factor is 0, even if the formula gives NaN
        let factor = attenuation(self.a, self.b, self.c, q);
        factor.at_least(T::ZERO).at_most(self.limit())
    }

    /// The limit of the factor, which is at least 1.
    #[inline]
    pub(crate) fn limit(&self) -> T {
        // it is not stored in a field, because MAX of one type is not MAX in another
        if self.clamped == YES { T::ONE } else { T::MAX }
    }

    /// The same attenuation in another number type. `f` converts each coefficient and may only
    /// round it.
    ///
    /// ```
    /// use shading::f32::Attenuation;
    ///
    /// let precise = Attenuation::new(1.0, 0.5, 0.25).unwrap().cast(f64::from);
    /// assert_eq!(precise.coefficients(), [1.0_f64, 0.5, 0.25]);
    /// ```
    #[inline]
    #[must_use]
    pub fn cast<U>(self, mut f: impl FnMut(T) -> U) -> Attenuation<U> {
        Attenuation {
            a: f(self.a),
            b: f(self.b),
            c: f(self.c),
            clamped: self.clamped,
        }
    }
}

impl<T: Real> Falloff<T> for Attenuation<T> {
    type In<U> = Attenuation<U>;

    // The parameters are references, because passing them by value gives different, larger code on
    // small chips.
    #[inline(always)]
    fn dim(&self, intensity: &Rgb<T>, q: T) -> Rgb<T> {
        self.dim_along(intensity, [q, q], || [q, T::ZERO, T::ZERO])
    }

    #[inline(always)]
    fn dim_along(&self, intensity: &Rgb<T>, q: [T; 2], _: impl FnOnce() -> [T; 3]) -> Rgb<T> {
        let coefficients = [self.a, self.b, self.c];
        T::attenuated((*intensity).into(), coefficients, q, || self.limit()).into()
    }

    #[inline]
    fn cast<U: Real>(self, f: impl FnMut(T) -> U) -> Attenuation<U> {
        self.cast(f)
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
            /// The attenuation 1/(a + bq + cq²). Returns `None` if a coefficient is negative or not
            /// finite, or if all are 0.
            ///
            /// ```
            #[doc = concat!("use shading::", stringify!($float), "::Attenuation;")]
            ///
            /// let inverse_square = Attenuation::new(0.0, 0.0, 1.0).unwrap();
            /// assert_eq!(inverse_square.at(2.0), 0.25);
            /// assert_eq!(Attenuation::new(1.0, -0.5, 0.0), None);
            /// assert_eq!(Attenuation::new(0.0, 0.0, 0.0), None); // infinite everywhere
            /// ```
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
                        clamped: NO,
                    })
                } else {
                    None
                }
            }
        }
    };
}

checked!(f32);
checked!(f64);
