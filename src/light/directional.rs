//! A light from one direction.

use super::incident::IncidentLight;
use crate::real::Real;
use crate::rgb::Rgb;
use crate::unit::UnitVec3;
use crate::vector::Vec3;

/// A light so far away, such as the sun, that its direction is the same everywhere. It is not
/// attenuated.
///
/// ```
/// use shading::f32::{DirectionalLight, Rgb, UnitVec3};
///
/// static SUN: DirectionalLight = DirectionalLight {
///     l: UnitVec3::normalized(1.0, 2.0, 3.0).unwrap(),
///     intensity: Rgb::new(1.0, 0.95, 0.9),
/// };
/// ```
///
/// L points **to** the light. If your scene file gives the direction in which the light shines, as
/// glTF does, negate it.
///
/// Source: Foley, van Dam, Feiner, Hughes, *Computer Graphics: Principles and Practice*, 2nd ed.,
/// 1990, §16.1.2; *The OpenGL Graphics System: A Specification*, version 2.1, 2006, §2.14.1.
#[doc(alias = "sun")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DirectionalLight<T = f32> {
    /// L, the direction **to** the light, opposite to the direction in which it shines.
    pub l: UnitVec3<T>,
    /// I, the same everywhere, linear; it may exceed 1.
    pub intensity: Rgb<T>,
}

impl<T: Real> DirectionalLight<T> {
    /// The light that arrives at the point p. It is the same at every point, and its distance is
    /// the largest finite number.
    ///
    /// ```
    /// use shading::f32::{DirectionalLight, Rgb, UnitVec3, Vec3};
    ///
    /// let sun = DirectionalLight { l: UnitVec3::Z, intensity: Rgb::WHITE };
    /// let incident = sun.at(Vec3::new(5.0, 0.0, -2.0));
    /// assert_eq!((incident.l, incident.intensity), (sun.l, sun.intensity));
    /// assert_eq!(incident.distance, f32::MAX); // anything in between casts a shadow
    /// ```
    #[inline]
    #[must_use]
    pub fn at(&self, _p: Vec3<T>) -> IncidentLight<T> {
        IncidentLight {
            l: self.l,
            intensity: self.intensity,
            distance: T::MAX,
        }
    }

    /// The light that arrives [`at`](DirectionalLight::at) a surface point with the normal N, or
    /// `None` if the light is behind the surface (N·L ≤ 0).
    ///
    /// ```
    /// use shading::f32::{DirectionalLight, Rgb, UnitVec3, Vec3};
    ///
    /// let sun = DirectionalLight { l: UnitVec3::Z, intensity: Rgb::WHITE };
    /// let p = Vec3::ZERO;
    /// assert_eq!(sun.in_front(p, UnitVec3::Z), Some(sun.at(p)));
    /// assert_eq!(sun.in_front(p, UnitVec3::NEG_Z), None);
    /// ```
    #[inline]
    #[must_use]
    pub fn in_front(&self, p: Vec3<T>, n: UnitVec3<T>) -> Option<IncidentLight<T>> {
        self.at(p).in_front(n)
    }

    /// The same light in another number type. `f` converts each number and may only round it.
    ///
    /// ```
    /// use shading::f32::{DirectionalLight, Rgb, UnitVec3};
    ///
    /// let sun = DirectionalLight { l: UnitVec3::Z, intensity: Rgb::gray(0.5) };
    /// assert_eq!(sun.cast(f64::from).intensity, shading::f64::Rgb::gray(0.5));
    /// ```
    #[inline]
    #[must_use]
    pub fn cast<U>(self, mut f: impl FnMut(T) -> U) -> DirectionalLight<U> {
        DirectionalLight {
            l: self.l.cast(&mut f),
            intensity: self.intensity.map(f),
        }
    }
}

/// The light that arrives at every point, so that a scene lit by the sun alone needs none.
///
/// ```
/// use shading::f32::{DirectionalLight, IncidentLight, Rgb, UnitVec3, Vec3};
///
/// let sun = DirectionalLight { l: UnitVec3::Z, intensity: Rgb::WHITE };
/// assert_eq!(IncidentLight::from(sun), sun.at(Vec3::ZERO));
/// ```
impl<T: Real> From<DirectionalLight<T>> for IncidentLight<T> {
    #[inline]
    fn from(light: DirectionalLight<T>) -> Self {
        light.at(Vec3::ZERO)
    }
}
