//! A light from one point, within a cone.

use super::incident::IncidentLight;
use super::point::PointLight;
use crate::attenuation::{Attenuation, Falloff};
use crate::cone::{Beam, Cone};
use crate::real::Real;
use crate::unit::UnitVec3;
use crate::vector::Vec3;

/// A point light that shines within a cone.
///
/// ```
/// use shading::f32::{Attenuation, Cone, PointLight, Rgb, SpotLight, UnitVec3, Vec3};
///
/// static SPOT: SpotLight = SpotLight {
///     point: PointLight {
///         position: Vec3::new(0.0, 3.0, 0.0),
///         intensity: Rgb::WHITE,
///         attenuation: Attenuation::NONE,
///     },
///     axis: UnitVec3::NEG_Y,                      // the spot shines straight down
///     cone: Cone::from_half_angle(0.5).unwrap(),  // 1 radian from edge to edge
/// };
/// ```
///
/// Source: *The OpenGL Graphics System: A Specification*, version 2.1, 2006, §2.14.1, with a spot
/// exponent of 0.
#[doc(alias = "spotlight")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)] // begins with its point light, as `Light::Point` does, so `Light` finds both at one offset
pub struct SpotLight<T = f32, C = Cone<T>, A = Attenuation<T>> {
    /// The light at the tip of the cone.
    pub point: PointLight<T, A>,
    /// The direction in which the spot shines, **away** from the light.
    pub axis: UnitVec3<T>,
    /// The width of the beam: a [`Cone`], or a [`SoftCone`](crate::SoftCone), which has a soft
    /// edge.
    pub cone: C,
}

impl<T: Real, C: Beam<T>, A: Falloff<T>> SpotLight<T, C, A> {
    /// The light that arrives at the point p: that of the [`PointLight`] times the
    /// [factor](Cone::factor) of the cone. For a hard cone, this is all of it inside the cone and
    /// on its edge, and none outside.
    ///
    /// ```text
    /// I / (a + bq + cq²) where −L·axis ≥ cos(half-angle), else 0
    /// ```
    ///
    /// ```
    /// use shading::f32::{Attenuation, Cone, PointLight, Rgb, SpotLight, UnitVec3, Vec3};
    ///
    /// let lamp = PointLight {
    ///     position: Vec3::new(0.0, 3.0, 0.0),
    ///     intensity: Rgb::WHITE,
    ///     attenuation: Attenuation::NONE,
    /// };
    /// let cone = Cone::from_half_angle(0.5).unwrap();
    /// let spot = SpotLight { point: lamp, axis: UnitVec3::NEG_Y, cone };
    ///
    /// assert_eq!(spot.at(Vec3::ZERO), lamp.at(Vec3::ZERO)); // right below
    /// assert_eq!(spot.at(Vec3::new(3.0, 0.0, 0.0)).intensity, Rgb::BLACK);
    /// ```
    #[inline(always)]
    #[must_use]
    pub fn at(&self, p: Vec3<T>) -> IncidentLight<T> {
        self.narrowed(self.point.at(p))
    }

    /// The light that arrives [`at`](SpotLight::at) a surface point with the normal N, or `None` if
    /// the light is behind the surface or the point is outside the cone. In lanes, it is `None` if
    /// no lane gets light. See [`PointLight::in_front`].
    ///
    /// ```
    /// use shading::f32::{Attenuation, Cone, PointLight, Rgb, SpotLight, UnitVec3, Vec3};
    ///
    /// let spot = SpotLight {
    ///     point: PointLight {
    ///         position: Vec3::new(0.0, 3.0, 0.0),
    ///         intensity: Rgb::WHITE,
    ///         attenuation: Attenuation::NONE,
    ///     },
    ///     axis: UnitVec3::NEG_Y,
    ///     cone: Cone::from_half_angle(0.5).unwrap(),
    /// };
    /// let (below, aside) = (Vec3::ZERO, Vec3::new(3.0, 0.0, 0.0));
    /// assert_eq!(spot.in_front(below, UnitVec3::Y), Some(spot.at(below)));
    /// assert_eq!(spot.in_front(below, UnitVec3::NEG_Y), None); // behind the surface
    /// assert_eq!(spot.in_front(aside, UnitVec3::Y), None); // outside the cone
    /// ```
    #[inline(always)]
    #[must_use]
    pub fn in_front(&self, p: Vec3<T>, n: UnitVec3<T>) -> Option<IncidentLight<T>> {
        self.narrowed_in_front(self.point.in_front(p, n)?)
    }

    /// The light of the point light, reduced by the cone.
    #[inline]
    pub(super) fn narrowed(&self, incident: IncidentLight<T>) -> IncidentLight<T> {
        IncidentLight {
            intensity: incident.intensity * self.cone.factor(self.axis, incident.l),
            ..incident
        }
    }

    /// The light of the point light, reduced by the cone, or `None` if nothing is left.
    #[inline(always)]
    pub(super) fn narrowed_in_front(&self, incident: IncidentLight<T>) -> Option<IncidentLight<T>> {
        let is_inside = self.cone.factor(self.axis, incident.l).any_positive();
        is_inside.then(|| self.narrowed(incident))
    }

    /// The same light in another number type. `f` converts each number and may only round it.
    ///
    /// ```
    /// use shading::f32::{Attenuation, Cone, PointLight, Rgb, SpotLight, UnitVec3, Vec3};
    ///
    /// let spot = SpotLight {
    ///     point: PointLight {
    ///         position: Vec3::ZERO,
    ///         intensity: Rgb::WHITE,
    ///         attenuation: Attenuation::NONE,
    ///     },
    ///     axis: UnitVec3::NEG_Y,
    ///     cone: Cone::from_cosine(0.5).unwrap(),
    /// };
    /// assert_eq!(spot.cast(f64::from).cone.cosine(), 0.5_f64);
    /// ```
    #[inline]
    #[must_use]
    pub fn cast<U: Real>(self, mut f: impl FnMut(T) -> U) -> SpotLight<U, C::In<U>, A::In<U>> {
        SpotLight {
            point: self.point.cast(&mut f),
            axis: self.axis.cast(&mut f),
            cone: self.cone.cast(f),
        }
    }
}
