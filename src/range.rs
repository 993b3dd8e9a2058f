//! Floor 3: attenuation that ends at a distance.

use crate::attenuation::{Attenuation, Falloff};
use crate::real::Real;
use crate::rgb::Rgb;

/// An [`Attenuation`] within a range r: smaller and smaller towards r, and exactly 0 from there on.
///
/// A light without a range lights everything a little, and none can be left out for being far away.
/// `in_front` leaves out a [`PointLight`](crate::PointLight) and a
/// [`SpotLight`](crate::SpotLight) out of whose range the point is.
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
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ranged<T = f32> {
    attenuation: Attenuation<T>,
    range: T,
}

impl<T: Real> Ranged<T> {
    /// The factor at the distance q ≥ 0.
    ///
    /// ```text
    /// w(q) / (a + bq + cq²),  w(q) = max(0, 1 − (q/r)⁴)²
    /// ```
    ///
    /// It never rises with q and is never more than the attenuation without a range, to the bit. The
    /// square lets it end smoothly at r. *KHR_lights_punctual*, a glTF 2.0 extension, recommends
    /// max(0, 1 − (q/r)⁴) without it.
    ///
    /// Source: Karis, *Real Shading in Unreal Engine 4*, SIGGRAPH course, 2013; Filament and three.js
    /// do the same. (A `distance` of 0 in three.js is no range; here it is refused, and ∞ is no range.)
    #[inline]
    #[must_use]
    pub fn at(self, q: T) -> T {
        self.attenuation.at(q) * self.window(q)
    }

    /// w(q)
    #[inline]
    fn window(self, q: T) -> T {
        let share = q / self.range;
        let square = share * share;
        let root = (T::ONE - square * square).at_least(T::ZERO);
        root * root
    }

    /// The attenuation without the range.
    #[inline]
    #[must_use]
    pub const fn attenuation(self) -> Attenuation<T>
    where
        T: Copy,
    {
        self.attenuation
    }

    /// The range r.
    #[inline]
    #[must_use]
    pub const fn range(self) -> T
    where
        T: Copy,
    {
        self.range
    }

    /// The same attenuation in another number type: `f` converts each number, and may do no more
    /// than round it.
    #[inline]
    #[must_use]
    pub fn cast<U>(self, mut f: impl FnMut(T) -> U) -> Ranged<U> {
        Ranged {
            attenuation: self.attenuation.cast(&mut f),
            range: f(self.range),
        }
    }
}

impl<T: Real> Falloff<T> for Ranged<T> {
    type In<U> = Ranged<U>;

    #[inline]
    fn dim(&self, intensity: &Rgb<T>, q: T) -> Rgb<T> {
        self.attenuation.dim(&(*intensity * self.window(q)), q)
    }

    #[inline]
    fn reaches(&self, square: T) -> bool {
        // A square above that of r has a root of at least r, for the root of r² is r; where r² may have
        // lost bits, it is in doubt.
        let reach = self.range * self.range + T::ONE / T::EXTREME;
        square.if_above(reach, T::ZERO, T::ONE).any_positive()
    }

    #[inline]
    fn cast<U>(self, f: impl FnMut(T) -> U) -> Ranged<U> {
        self.cast(f)
    }
}

macro_rules! checked {
    ($float:ident) => {
        impl Attenuation<$float> {
            /// The same attenuation within a range: 0 from the distance r on. `None` for an r of 0 or
            /// below, and for NaN. ∞ is no range.
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
                    Some(Ranged {
                        attenuation: self,
                        range: r,
                    })
                } else {
                    None
                }
            }
        }

        /// No range.
        impl From<Attenuation<$float>> for Ranged<$float> {
            #[inline]
            fn from(attenuation: Attenuation<$float>) -> Self {
                Self {
                    attenuation,
                    range: $float::INFINITY,
                }
            }
        }
    };
}

checked!(f32);
checked!(f64);
