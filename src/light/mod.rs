//! Lights, and the light that arrives at a point.
//!
//! Every kind of light has two methods. `at(p)` returns the light that arrives at a point.
//! `in_front(p, n)` returns the light that arrives at the front of a surface there. It may return
//! `None` before the costly part of the computation, and a sum over lights is the same, to the bit.
//!
//! For firmware, both are always inlined. As separate functions, they would keep numbers on the
//! stack in addition to those of the sum that calls them, and a small chip has little stack.
//! `tests/firmware/run.sh` measures the stack in use.

mod directional;
mod in_front;
mod incident;
mod lights;
mod point;
mod spot;
mod wider;

pub use directional::DirectionalLight;
pub use incident::IncidentLight;
pub use lights::Lights;
pub use point::PointLight;
pub use spot::SpotLight;

use crate::attenuation::{Attenuation, Falloff};
use crate::cone::{Beam, Cone};
use crate::real::Real;
use crate::unit::UnitVec3;
use crate::vector::Vec3;

/// A light of any of the three kinds, for scenes that mix kinds.
///
/// ```
/// use shading::f32::{Attenuation, DirectionalLight, Light, PointLight, Rgb, UnitVec3, Vec3};
///
/// let sun = DirectionalLight { l: UnitVec3::Z, intensity: Rgb::WHITE };
/// let lamp = PointLight {
///     position: Vec3::new(2.0, 0.0, 2.0),
///     intensity: Rgb::new(1.0, 0.8, 0.6),
///     attenuation: Attenuation::NONE,
/// };
/// let lights: [Light; 2] = [sun.into(), lamp.into()];
///
/// let arriving: Rgb = lights.iter().map(|light| light.at(Vec3::ZERO).intensity).sum();
/// assert_eq!(arriving, sun.intensity + lamp.intensity);
/// ```
///
/// In a `static`, write the kind: `static LIGHTS: [Light; 1] = [Light::Directional(SUN)];`.
///
/// A scene with soft edges and ranges declares them in the type of its lights. Every light fits into
/// that type, also one with a hard cone or without a range:
///
/// ```
/// use shading::f32::{Attenuation, Cone, Light, PointLight, Ranged, Rgb};
/// use shading::f32::{SoftCone, SpotLight, UnitVec3, Vec3};
///
/// let point = PointLight {
///     position: Vec3::new(0.0, 0.0, 2.0),
///     intensity: Rgb::WHITE,
///     attenuation: Attenuation::NONE,
/// };
/// let cone = Cone::from_half_angle(0.5).unwrap();
/// let spot = SpotLight { point, axis: UnitVec3::NEG_Z, cone };
/// let soft = SoftCone::from_half_angles(0.25, 0.5).unwrap();
/// let soft_spot = SpotLight { point, axis: UnitVec3::NEG_Z, cone: soft };
///
/// let lights: [Light<SoftCone, Ranged>; 3] = [point.into(), spot.into(), soft_spot.into()];
/// assert_eq!(lights[1].at(Vec3::ZERO), lights[0].at(Vec3::ZERO));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Light<T = f32, C = Cone<T>, A = Attenuation<T>> {
    /// A light from one direction.
    Directional(DirectionalLight<T>),
    /// A light from one point.
    Point(PointLight<T, A>),
    /// A light from one point, within a cone.
    Spot(SpotLight<T, C, A>),
}

impl<T: Real, C: Beam<T>, A: Falloff<T>> Light<T, C, A> {
    /// The light that arrives at the point p, as in [`DirectionalLight::at`], [`PointLight::at`]
    /// and [`SpotLight::at`].
    ///
    /// ```
    /// use shading::f32::{DirectionalLight, Light, Rgb, UnitVec3, Vec3};
    ///
    /// let sun = DirectionalLight { l: UnitVec3::Z, intensity: Rgb::WHITE };
    /// let p = Vec3::new(5.0, 0.0, -2.0);
    /// let light: Light = sun.into();
    /// assert_eq!(light.at(p), sun.at(p));
    /// ```
    #[inline(always)]
    #[must_use]
    pub fn at(&self, p: Vec3<T>) -> IncidentLight<T> {
        let point = match self {
            Self::Directional(light) => return light.at(p),
            Self::Point(point) | Self::Spot(SpotLight { point, .. }) => point,
        };
        let incident = point.at(p);
        match self {
            Self::Spot(spot) => spot.narrowed(incident),
            _ => incident,
        }
    }

    /// The light that arrives [`at`](Light::at) a surface point with the normal N, or `None` if it
    /// adds nothing. This is faster, and a sum over lights is the same. See
    /// [`PointLight::in_front`].
    ///
    /// ```
    /// use shading::f32::{DirectionalLight, Light, Rgb, UnitVec3, Vec3};
    ///
    /// let light: Light = DirectionalLight { l: UnitVec3::Z, intensity: Rgb::WHITE }.into();
    /// let p = Vec3::ZERO;
    /// assert_eq!(light.in_front(p, UnitVec3::Z), Some(light.at(p)));
    /// assert_eq!(light.in_front(p, UnitVec3::NEG_Z), None);
    /// ```
    #[inline(always)]
    #[must_use]
    pub fn in_front(&self, p: Vec3<T>, n: UnitVec3<T>) -> Option<IncidentLight<T>> {
        let point = match self {
            Self::Directional(light) => return light.in_front(p, n),
            Self::Point(point) | Self::Spot(SpotLight { point, .. }) => point,
        };
        let incident = point.in_front(p, n)?;
        match self {
            Self::Spot(spot) => spot.narrowed_in_front(incident),
            _ => Some(incident),
        }
    }

    /// The same light in another number type. `f` converts each number and may only round it.
    ///
    /// ```
    /// use shading::f32::{DirectionalLight, Light, Rgb, UnitVec3};
    ///
    /// let light: Light = DirectionalLight { l: UnitVec3::Z, intensity: Rgb::gray(0.5) }.into();
    /// assert_eq!(light.cast(f64::from).cast(|x| x as f32), light);
    /// ```
    #[inline]
    #[must_use]
    pub fn cast<U: Real>(self, f: impl FnMut(T) -> U) -> Light<U, C::In<U>, A::In<U>> {
        match self {
            Self::Directional(light) => Light::Directional(light.cast(f)),
            Self::Point(light) => Light::Point(light.cast(f)),
            Self::Spot(light) => Light::Spot(light.cast(f)),
        }
    }
}
