//! The cone of a spot light.

use crate::real::{Real, Scalar};
use crate::unit::UnitVec3;

/// The directions in which a [`SpotLight`](crate::SpotLight) shines: a hard [`Cone`], a cone with a
/// soft edge ([`SoftCone`](crate::SoftCone)), or a beam of your own.
///
/// ```
/// use shading::{Beam, Exponent, Real, UnitVec3};
///
/// /// OpenGL's spot exponent: the higher it is, the narrower the beam.
/// #[derive(Clone, Copy)]
/// struct Focused(u32);
///
/// impl<T: Real> Beam<T> for Focused {
///     type In<U> = Self;
///     fn factor(self, axis: UnitVec3<T>, l: UnitVec3<T>) -> T {
///         self.0.raise((-axis).dot(l))
///     }
///     fn cast<U>(self, _: impl FnMut(T) -> U) -> Self {
///         self
///     }
/// }
/// let l = UnitVec3::<f32>::new(0.6, 0.0, 0.8).unwrap();
/// assert!((Focused(2).factor(-UnitVec3::Z, l) - 0.64).abs() < 1e-6);
/// ```
pub trait Beam<T>: Copy {
    /// The type of the same beam in another number type.
    type In<U>;

    /// The share, from 0 to 1, of the light that travels along −L from a spot that shines along
    /// `axis`.
    #[must_use]
    fn factor(self, axis: UnitVec3<T>, l: UnitVec3<T>) -> T;

    /// The same beam in another number type. `f` converts each number and may only round it.
    #[must_use]
    fn cast<U: Real>(self, f: impl FnMut(T) -> U) -> Self::In<U>;
}

/// The hard cone of a spot light, given by its **half**-angle: the angle between the axis and the
/// edge, as in OpenGL, glTF and three.js. Unity and Blender give twice that angle.
///
/// ```
/// use shading::f32::{Cone, UnitVec3};
/// use std::f32::consts::FRAC_PI_6;
///
/// const CONE: Cone = Cone::from_half_angle(FRAC_PI_6).unwrap(); // 60° wide from edge to edge
///
/// let straight_down = UnitVec3::NEG_Z;
/// assert_eq!(CONE.factor(straight_down, UnitVec3::Z), 1.0); // right below: L points up
/// assert_eq!(CONE.factor(straight_down, UnitVec3::X), 0.0);
/// ```
///
/// An impossible constant fails the build:
///
/// ```compile_fail
/// use shading::f32::Cone;
/// const NONSENSE: Cone = Cone::from_half_angle(30.0).unwrap(); // degrees
/// ```
#[doc(alias = "cutoff")]
#[doc(alias = "spotlight")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cone<T = f32> {
    pub(crate) cosine: T,
}

impl<T: Real> Cone<T> {
    /// The share of the light that arrives: 1 inside the cone and on its edge, 0 outside.
    ///
    /// ```text
    /// 1 where −L·axis ≥ cos(half-angle), else 0
    /// ```
    ///
    /// `axis` is the direction in which the spot shines, away from the light, and L the direction
    /// from the surface to the light. On the axis, the factor is 1 for every cone. If a direction
    /// is NaN, the factor is 1.
    ///
    /// Source: *The OpenGL Graphics System: A Specification*, version 2.1, 2006, §2.14.1, with a
    /// spot exponent of 0.
    ///
    /// ```
    /// use shading::f32::{Cone, UnitVec3};
    ///
    /// let cone = Cone::from_cosine(0.8).unwrap();
    /// let on_the_edge = UnitVec3::new(0.6, 0.0, 0.8).unwrap();
    /// let outside = UnitVec3::new(0.8, 0.0, 0.6).unwrap();
    /// assert_eq!(cone.factor(UnitVec3::NEG_Z, on_the_edge), 1.0);
    /// assert_eq!(cone.factor(UnitVec3::NEG_Z, outside), 0.0);
    /// ```
    #[inline]
    #[must_use]
    pub fn factor(self, axis: UnitVec3<T>, l: UnitVec3<T>) -> T {
        (self.cosine - (-axis).dot(l)).if_positive(T::ZERO, T::ONE)
    }

    /// The cosine of the half-angle, within [−1, 1].
    ///
    /// ```
    /// use shading::f32::Cone;
    /// assert_eq!(Cone::from_half_angle(0.0).unwrap().cosine(), 1.0 - 4.0 * f32::EPSILON);
    /// assert_eq!(Cone::from_cosine(0.5).unwrap().cosine(), 0.5);
    /// ```
    #[inline]
    #[must_use]
    pub fn cosine(self) -> T {
        (self.cosine + T::ONE).if_positive(self.cosine, -T::ONE)
    }

    /// [`from_half_angle`](Cone#method.from_half_angle) for any number type, in generic code. It has
    /// the same bits.
    ///
    /// ```
    /// use shading::{Cone, Real};
    ///
    /// fn hemisphere<T: Real + PartialOrd>() -> Option<Cone<T>> {
    ///     Cone::of_half_angle(T::of(core::f64::consts::FRAC_PI_2))
    /// }
    /// assert!(hemisphere::<f32>().unwrap().cosine().abs() < 1e-7);
    /// assert_eq!(Cone::of_half_angle(60.0_f64), None); // degrees
    /// ```
    #[must_use]
    pub fn of_half_angle(radians: T) -> Option<Self>
    where
        T: Scalar,
    {
        radians.cosine_of_half_angle().map(Self::with_slack)
    }

    /// [`from_cosine`](Cone#method.from_cosine) for any number type, in generic code. It has the same
    /// bits.
    ///
    /// ```
    /// use shading::{Cone, Real};
    ///
    /// fn cone<T: Real + PartialOrd>(cosine: T) -> Option<Cone<T>> {
    ///     Cone::of_cosine(cosine)
    /// }
    /// assert_eq!(cone(0.5_f32), Cone::<f32>::from_cosine(0.5));
    /// assert_eq!(cone(1.5_f64), None);
    /// ```
    #[must_use]
    pub fn of_cosine(cosine: T) -> Option<Self>
    where
        T: Scalar,
    {
        // −0 would turn the sign of the width of an edge
        (cosine >= T::NEG_ONE && cosine <= T::ONE).then(|| Self::with_slack(cosine + T::ZERO))
    }

    /// The cone of a cosine within [−1, 1], or of another cone's: it contains its axis, and a cone of
    /// half-angle π every direction, even if both directions are as long as they may be. The slack of
    /// another number type stays where it is larger, because directions bring the roundoff of that
    /// type along.
    #[inline]
    pub(crate) fn with_slack(cosine: T) -> Self {
        let two = T::ONE + T::ONE;
        let slack = two * two * T::epsilon();
        let cosine = cosine.at_most(T::ONE - slack);
        let everywhere = slack - T::ONE;
        Self {
            cosine: everywhere.if_above(cosine, cosine.at_most(T::NEG_ONE - two * slack), cosine),
        }
    }

    /// The same cone in another number type. `f` converts the cosine and may only round it.
    ///
    /// The new cone, too, contains its axis, and every direction if its half-angle is π: a cosine
    /// close to 1 or −1 is treated as in [`from_cosine`](Cone#method.from_cosine), with the larger ε of
    /// the two types.
    ///
    /// ```
    /// use shading::{Cone, UnitVec3};
    ///
    /// assert_eq!(Cone::<f32>::from_cosine(0.5).unwrap().cast(f64::from).cosine(), 0.5_f64);
    ///
    /// let narrow = Cone::<f64>::from_half_angle(0.0).unwrap().cast(|x| x as f32);
    /// let axis = UnitVec3::<f64>::normalized(1.0, 2.0, 3.0).unwrap().cast(|x| x as f32);
    /// assert_eq!(narrow.factor(axis, -axis), 1.0);
    /// ```
    #[inline]
    #[must_use]
    pub fn cast<U: Real>(self, mut f: impl FnMut(T) -> U) -> Cone<U> {
        Cone::with_slack(f(self.cosine))
    }
}

impl<T: Real> Beam<T> for Cone<T> {
    type In<U> = Cone<U>;

    #[inline]
    fn factor(self, axis: UnitVec3<T>, l: UnitVec3<T>) -> T {
        self.factor(axis, l)
    }

    #[inline]
    fn cast<U: Real>(self, f: impl FnMut(T) -> U) -> Cone<U> {
        self.cast(f)
    }
}

macro_rules! checked {
    ($float:ident, $half_pi_rounding:literal) => {
        impl Cone<$float> {
            /// The cone of a half-angle in radians, within [0, π]. Returns `None` for other angles
            /// and for NaN.
            ///
            /// The cosine is computed only with + − × ÷, so the constructor works in constants and
            /// gives the same bits on every machine.
            ///
            /// ```
            #[doc = concat!("use shading::", stringify!($float), "::Cone;")]
            #[doc = concat!("use std::", stringify!($float), "::consts::FRAC_PI_3;")]
            ///
            /// let cone = Cone::from_half_angle(FRAC_PI_3).unwrap(); // 60° on each side of the axis
            #[doc = concat!("assert!((cone.cosine() - 0.5).abs() <= ", stringify!($float), "::EPSILON);")]
            /// assert_eq!(Cone::from_half_angle(60.0), None); // degrees
            /// ```
            #[must_use]
            pub const fn from_half_angle(radians: $float) -> Option<Self> {
                use core::$float::consts::{FRAC_PI_2, FRAC_PI_4, PI};
                if radians >= 0.0 && radians <= PI {
                    // each case needs only the sine of an angle of at most π/4
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

            /// the Taylor series, for |x| ≤ π/4
            const fn sine_of_small(x: $float) -> $float {
                let (mut sum, mut term, mut k) = (0.0, x, 1.0);
                while k < 20.0 {
                    sum += term;
                    term = -term * x * x / ((k + 1.0) * (k + 2.0));
                    k += 2.0;
                }
                sum
            }

            /// The cone whose half-angle has the given cosine, within [−1, 1]. Returns `None` for
            /// other cosines and for NaN.
            ///
            /// A cosine close to 1 is stored as 1 − 4ε (a half-angle of 0.06° in `f32`), and a
            /// cosine close to −1 as a cone of every direction. Otherwise the rounding of
            /// directions could put the axis outside its own cone, or a direction outside the cone
            /// of half-angle π.
            ///
            /// ```
            #[doc = concat!("use shading::", stringify!($float), "::{Cone, UnitVec3};")]
            ///
            /// let hemisphere = Cone::from_cosine(0.0).unwrap();
            /// assert_eq!(hemisphere.factor(UnitVec3::Z, UnitVec3::X), 1.0); // on its edge
            /// assert_eq!(hemisphere.factor(UnitVec3::Z, UnitVec3::Z), 0.0);
            /// assert_eq!(Cone::from_cosine(1.5), None);
            /// ```
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
                        -1.0 - 2.0 * SLACK // two directions may both be too long
                    } else {
                        cosine + 0.0 // −0 would turn the sign of the width of an edge
                    },
                })
            }
        }
    };
}

// the amount by which π/2 exceeds the float nearest to it
checked!(f32, -4.371_139e-8);
checked!(f64, 6.123_233_995_736_766e-17);
