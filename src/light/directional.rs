//! Light from one direction.

use super::incident::IncidentLight;
use crate::real::Real;
use crate::rgb::Rgb;
use crate::unit::UnitVec3;
use crate::vector::Vec3;

/// A light so far away that its direction is the same everywhere, and not attenuated: the sun.
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
/// L points **to** the light. Where a scene file has the direction in which the light shines, as
/// glTF has, negate it.
///
/// Source: Foley, van Dam et al., *Computer Graphics*, §16.1.2; OpenGL 2.1 specification, §2.14.1.
#[doc(alias = "sun")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DirectionalLight<T = f32> {
    /// L, the direction **to** the light, against the way it shines.
    pub l: UnitVec3<T>,
    /// I, the same everywhere: linear, and not limited to 1.
    pub intensity: Rgb<T>,
}

impl<T: Real> DirectionalLight<T> {
    /// The light that arrives at the point p: the same at every point, from as far as can be.
    ///
    /// ```
    /// use shading::f32::{DirectionalLight, Rgb, UnitVec3, Vec3};
    ///
    /// let sun = DirectionalLight { l: UnitVec3::Z, intensity: Rgb::WHITE };
    /// let incident = sun.at(Vec3::new(5.0, 0.0, -2.0));
    /// assert_eq!((incident.l, incident.intensity), (sun.l, sun.intensity));
    /// assert_eq!(incident.distance, f32::MAX); // anything on the way casts a shadow
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

    /// [`at`](DirectionalLight::at) a point of a surface with the normal N, or `None` where the light
    /// is behind it.
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

    /// The same light in another number type: `f` converts each number, and may do no more
    /// than round it.
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
