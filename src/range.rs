//! Attenuation that ends at a range.

use crate::attenuation::{Attenuation, Falloff};
use crate::flag::{Flag, NO, YES};
use crate::real::{Real, Scalar};
use crate::rgb::Rgb;

/// An [`Attenuation`] that ends at a range r: the light falls off toward r and is exactly 0 from r
/// on. [`within`](Attenuation#method.within) makes one.
///
/// A light without a range lights every point a little, so no light may be skipped for being far
/// away. With a range, `in_front` of a [`PointLight`](crate::PointLight) or a
/// [`SpotLight`](crate::SpotLight) returns `None` if the point is out of range.
///
/// ```
/// use shading::{Attenuation, PointLight, Ranged, Rgb, UnitVec3, Vec3};
///
/// static LAMP: PointLight<f32, Ranged<f32>> = PointLight {
///     position: Vec3::new(0.0, 0.0, 2.0),
///     intensity: Rgb::WHITE,
///     attenuation: Attenuation::<f32>::new(0.0, 0.0, 1.0).unwrap().within(4.0).unwrap(),
/// };
/// let at = |x| LAMP.in_front(Vec3::new(x, 0.0, 0.0), UnitVec3::Z);
/// assert!(at(2.0).unwrap().intensity.r > 0.0);
/// assert_eq!(at(5.0), None); // more than 4 away
/// ```
#[doc(alias = "cutoff")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ranged<T = f32> {
    pub(crate) attenuation: Attenuation<T>,
    range: T,
    /// Whether the window is glTF's.
    unsquared: Flag,
}

impl<T: Real> Ranged<T> {
    /// A range that has been checked.
    #[inline]
    pub(crate) const fn unchecked(attenuation: Attenuation<T>, range: T) -> Self {
        Self {
            attenuation,
            range,
            unsquared: NO,
        }
    }

    /// [`Attenuation::within`](Attenuation#method.within) for any number type, in generic code: the
    /// attenuation, ended by a range r, or `None` if r is 0, negative or NaN.
    ///
    /// ```
    /// use shading::{Attenuation, Ranged, Real};
    ///
    /// fn nearby<T: Real + PartialOrd>(r: T) -> Option<Ranged<T>> {
    ///     Ranged::of(Attenuation::NONE, r)
    /// }
    /// assert_eq!(nearby(8.0_f32), Attenuation::<f32>::NONE.within(8.0));
    /// assert_eq!(nearby(0.0_f64), None);
    /// ```
    #[inline]
    #[must_use]
    pub fn of(attenuation: Attenuation<T>, r: T) -> Option<Self>
    where
        T: Scalar,
    {
        (r > T::ZERO).then_some(Self::unchecked(attenuation, r))
    }

    /// The factor at the distance q ≥ 0.
    ///
    /// ```text
    /// w(q) / (a + bq + cq²),  w(q) = max(0, 1 − (q/r)⁴)²
    /// ```
    ///
    /// q is the distance, not its square, and r > 0 the range, in the same unit. The factor never
    /// rises as q rises, and it never exceeds the attenuation without a range, to the bit. The
    /// outer square lets it end smoothly at r; [`unsquared`](Ranged::unsquared) leaves it out.
    ///
    /// The factor is 0 for q ≥ r and for NaN.
    ///
    /// Source: Brian Karis, *Real Shading in Unreal Engine 4*, SIGGRAPH course, 2013; Babylon.js,
    /// Bevy, Filament and three.js use the same formula. In three.js, a `distance` of 0 means no
    /// range. This crate refuses 0; ∞ means no range.
    ///
    /// ```
    /// use shading::f32::Attenuation;
    ///
    /// let lamp = Attenuation::NONE.within(2.0).unwrap();
    /// assert_eq!(lamp.at(1.0), 0.9375 * 0.9375); // (1 − (1/2)⁴)²
    /// assert_eq!(lamp.at(2.0), 0.0);
    /// ```
    #[inline]
    #[must_use]
    pub fn at(self, q: T) -> T {
        self.attenuation.at(q) * T::window(q, self.range, self.unsquared == NO)
    }

    /// The same attenuation and range, with the window that the specification of glTF recommends:
    /// max(0, 1 − (q/r)⁴) in place of its square. The light is brighter toward r and ends there with
    /// an edge.
    ///
    /// Source: Khronos, *KHR_lights_punctual*, a glTF 2.0 extension, “Range Property”, and its
    /// sample viewer. Of the programs that read glTF, Babylon.js, Bevy, Filament and three.js square
    /// the window.
    ///
    /// ```
    /// use shading::f32::Attenuation;
    ///
    /// let inverse_square = Attenuation::new(0.0, 0.0, 1.0).unwrap();
    /// let lamp = inverse_square.within(8.0).unwrap().unsquared();
    /// assert_eq!(lamp.at(4.0), 0.0625 * 0.9375); // 1/4² (1 − (4/8)⁴)
    /// assert_eq!(lamp.at(8.0), 0.0);
    /// ```
    #[doc(alias = "gltf")]
    #[inline]
    #[must_use]
    pub const fn unsquared(self) -> Self
    where
        T: Copy,
    {
        Self {
            unsquared: YES,
            ..self
        }
    }

    /// Whether the window is that of [`unsquared`](Ranged::unsquared).
    ///
    /// ```
    /// use shading::f32::Attenuation;
    ///
    /// let lamp = Attenuation::NONE.within(8.0).unwrap();
    /// assert!(!lamp.is_unsquared() && lamp.unsquared().is_unsquared());
    /// ```
    #[inline]
    #[must_use]
    pub const fn is_unsquared(self) -> bool
    where
        T: Copy,
    {
        self.unsquared == YES
    }

    /// The attenuation without the range.
    ///
    /// ```
    /// use shading::f32::Attenuation;
    ///
    /// let attenuation = Attenuation::new(1.0, 0.0, 0.25).unwrap();
    /// assert_eq!(attenuation.within(8.0).unwrap().attenuation(), attenuation);
    /// ```
    #[inline]
    #[must_use]
    pub const fn attenuation(self) -> Attenuation<T>
    where
        T: Copy,
    {
        self.attenuation
    }

    /// The range r. For a light without a range it is ∞, or the largest number of a type without
    /// infinities.
    ///
    /// ```
    /// use shading::f32::{Attenuation, Ranged};
    ///
    /// assert_eq!(Attenuation::NONE.within(8.0).unwrap().range(), 8.0);
    /// assert_eq!(Ranged::from(Attenuation::NONE).range(), f32::INFINITY);
    /// ```
    #[inline]
    #[must_use]
    pub const fn range(self) -> T
    where
        T: Copy,
    {
        self.range
    }

    /// The same attenuation and range in another number type. `f` converts each number and may only
    /// round it. A light without a range has none in the new type.
    ///
    /// ```
    /// use shading::f32::Attenuation;
    ///
    /// let lamp = Attenuation::NONE.within(8.0).unwrap();
    /// assert_eq!(lamp.cast(f64::from).range(), 8.0_f64);
    /// ```
    #[inline]
    #[must_use]
    pub fn cast<U: Real>(self, mut f: impl FnMut(T) -> U) -> Ranged<U> {
        let attenuation = self.attenuation.cast(&mut f);
        let range = f(self.range);
        // `f` keeps an infinity, but the largest number of a type without one is a number to it
        let has_infinity = (endless::<T>() - T::MAX).any_positive();
        let is_endless = !has_infinity && !(T::MAX - self.range).any_positive();
        Ranged {
            attenuation,
            range: if is_endless { endless() } else { range },
            unsquared: self.unsquared,
        }
    }
}

/// The range that means no range: ∞, or the largest number of a type without infinities.
#[inline]
fn endless<T: Real>() -> T {
    (T::MAX + T::MAX).at_least(T::MAX)
}

/// The attenuation without a range.
impl<T: Real> From<Attenuation<T>> for Ranged<T> {
    #[inline]
    fn from(attenuation: Attenuation<T>) -> Self {
        Self::unchecked(attenuation, endless())
    }
}

impl<T: Real> Falloff<T> for Ranged<T> {
    type In<U> = Ranged<U>;

    #[inline]
    fn dim(&self, intensity: &Rgb<T>, q: T) -> Rgb<T> {
        self.dim_along(intensity, [q, q], || [q, T::ZERO, T::ZERO])
    }

    #[inline]
    fn dim_along(
        &self,
        intensity: &Rgb<T>,
        q: [T; 2],
        to_light: impl FnOnce() -> [T; 3],
    ) -> Rgb<T> {
        let (i, coefficients) = ((*intensity).into(), self.attenuation.coefficients());
        let limit = || self.attenuation.limit();
        let window = (self.range, self.unsquared == NO);
        T::attenuated_within(window, i, coefficients, q, to_light, limit).into()
    }

    #[inline]
    fn reaches(&self, square: T) -> bool {
        // A square above r² has a root of at least r, because the rounded root of the rounded r² is
        // r. If r² may have lost bits, the light is kept.
        let reach = self.range * self.range + T::ONE / T::EXTREME;
        square.if_above(reach, T::ZERO, T::ONE).any_positive()
    }

    #[inline]
    fn cast<U: Real>(self, f: impl FnMut(T) -> U) -> Ranged<U> {
        self.cast(f)
    }
}

macro_rules! checked {
    ($float:ident) => {
        impl Attenuation<$float> {
            /// The same attenuation, ended by a range: the factor is 0 from the distance r on.
            /// Returns `None` if r is 0, negative or NaN. ∞ means no range. [`Ranged::at`] gives
            /// the formula.
            ///
            /// ```
            #[doc = concat!("use shading::", stringify!($float), "::Attenuation;")]
            ///
            /// let lamp = Attenuation::new(0.0, 0.0, 1.0).unwrap().within(8.0).unwrap();
            /// assert_eq!(lamp.at(4.0), 0.0625 * 0.9375 * 0.9375); // 1/4² (1 − (4/8)⁴)²
            /// assert_eq!(lamp.at(8.0), 0.0);
            /// ```
            #[doc(alias = "range")]
            #[doc(alias = "window")]
            #[doc(alias = "cutoff")]
            #[inline]
            #[must_use]
            pub const fn within(self, r: $float) -> Option<Ranged<$float>> {
                if r > 0.0 {
                    Some(Ranged::unchecked(self, r))
                } else {
                    None
                }
            }
        }
    };
}

checked!(f32);
checked!(f64);
