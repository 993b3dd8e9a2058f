//! Lights, and the light that arrives at a point.

mod attenuation;
mod cone;
mod incident;

use crate::color::Rgb;
use crate::number::Real;
#[cfg(feature = "serde")]
use crate::number::{Read, Written};
use crate::vector::{UnitVec3, Vec3};
pub use attenuation::{Attenuation, attenuation};
pub use cone::Cone;
use incident::Kind;
pub use incident::{Arrival, IncidentLight};

/// A light so far away, such as the sun, that its direction is the same everywhere. It is not
/// attenuated.
///
/// L points **to** the light. If your scene file gives the direction in which the light shines, as
/// glTF does, negate it.
///
/// Source: Foley, van Dam et al. 1990, §16.1.2; OpenGL 2.1, §2.14.1.
///
/// ```
/// use shading::f32::{DirectionalLight, Rgb, UnitVec3};
///
/// let sun = DirectionalLight { l: UnitVec3::Z, intensity: Rgb::new(1.0, 0.95, 0.9) };
/// ```
#[doc(alias = "sun")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(
        deny_unknown_fields,
        bound(serialize = "T: Written", deserialize = "T: Read<'de>")
    )
)]
#[must_use]
pub struct DirectionalLight<T = f32> {
    /// L, the direction **to** the light, opposite to the direction in which it shines.
    pub l: UnitVec3<T>,
    /// I, the same everywhere, linear; it may exceed 1.
    pub intensity: Rgb<T>,
}

impl<T: Real> DirectionalLight<T> {
    /// The light that arrives at the point p. It is the same at every point, and its distance is
    /// the largest finite number.
    #[inline]
    pub fn at(&self, _p: impl Into<[T; 3]>) -> IncidentLight<T> {
        let mut light = IncidentLight::new(*self.l, self.intensity, Attenuation::NONE);
        light.kind = Kind::Directional;
        light
    }

    /// The same light in another number type. `f` converts each number and may only round it.
    #[inline]
    pub fn cast<U>(self, mut f: impl FnMut(T) -> U) -> DirectionalLight<U> {
        DirectionalLight {
            l: self.l.cast(&mut f),
            intensity: self.intensity.map(f),
        }
    }
}

/// The light that arrives at every point.
impl<T: Real> From<DirectionalLight<T>> for IncidentLight<T> {
    #[inline]
    fn from(light: DirectionalLight<T>) -> Self {
        light.at(Vec3::ZERO)
    }
}

/// A light that shines from one point in all directions and is attenuated with distance.
///
/// You choose the unit of length. Positions and the q of the attenuation share it.
///
/// Source: Foley, van Dam et al. 1990, §16.1.2; OpenGL 2.1, §2.14.1.
#[doc(alias = "lamp")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(
        deny_unknown_fields,
        bound(serialize = "T: Written", deserialize = "T: Read<'de>")
    )
)]
#[must_use]
pub struct PointLight<T = f32> {
    /// P_light, the position of the light.
    pub position: Vec3<T>,
    /// I before attenuation, linear; it may exceed 1.
    pub intensity: Rgb<T>,
    /// The falloff with distance.
    pub attenuation: Attenuation<T>,
}

impl<T: Real> PointLight<T> {
    /// The light that arrives at the point p.
    ///
    /// ```text
    /// L = (P_light − p)/q,  q = |P_light − p|,  intensity I / (a + bq + cq²)
    /// ```
    ///
    /// The light is black at its own position (q = 0), and where a coordinate of P_light − p is NaN or
    /// overflows. A distance or an intensity that overflows is the largest finite number.
    ///
    /// ```
    /// use shading::f32::{Attenuation, PointLight, Rgb, UnitVec3, Vec3};
    ///
    /// let attenuation = Attenuation::new(1.0, 0.0, 0.25).unwrap();
    /// let position = Vec3::new(0.0, 0.0, 3.0);
    /// let lamp = PointLight { position, intensity: Rgb::WHITE, attenuation };
    /// let incident = lamp.at(Vec3::new(0.0, 0.0, 1.0));
    /// assert_eq!((incident.l(), incident.distance()), (UnitVec3::Z, 2.0));
    /// assert_eq!(incident.intensity(), Rgb::gray(0.5)); // 1/(1 + 2²/4)
    /// assert_eq!(lamp.at(lamp.position).intensity(), Rgb::BLACK);
    /// ```
    #[inline]
    pub fn at(&self, p: impl Into<[T; 3]>) -> IncidentLight<T> {
        let to_light = self.position - Vec3::from(p.into());
        IncidentLight::new(to_light, self.intensity, self.attenuation)
    }

    /// The same light in another number type. `f` converts each number and may only round it.
    #[inline]
    pub fn cast<U: Real>(self, mut f: impl FnMut(T) -> U) -> PointLight<U> {
        PointLight {
            position: self.position.map(&mut f),
            intensity: self.intensity.map(&mut f),
            attenuation: self.attenuation.cast(f),
        }
    }
}

/// A point light that shines within a cone.
///
/// ```
/// use shading::f32::{Attenuation, Cone, PointLight, Rgb, SpotLight, UnitVec3, Vec3};
///
/// let (position, attenuation) = (Vec3::new(0.0, 3.0, 0.0), Attenuation::NONE);
/// let point = PointLight { position, intensity: Rgb::WHITE, attenuation };
/// let cone = Cone::from_half_angle(0.5).unwrap(); // 1 radian from edge to edge
/// let spot = SpotLight { point, axis: UnitVec3::NEG_Y, cone }; // it shines straight down
/// assert_eq!(spot.at(Vec3::ZERO).intensity(), Rgb::WHITE); // right below
/// assert_eq!(spot.at(Vec3::new(3.0, 0.0, 0.0)).intensity(), Rgb::BLACK);
/// ```
#[doc(alias = "spotlight")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(
        deny_unknown_fields,
        bound(serialize = "T: Written", deserialize = "T: Read<'de>")
    )
)]
#[must_use]
pub struct SpotLight<T = f32> {
    /// The light at the tip of the cone.
    pub point: PointLight<T>,
    /// The direction in which the spot shines, **away** from the light.
    pub axis: UnitVec3<T>,
    /// The width of the beam.
    pub cone: Cone<T>,
}

impl<T: Real> SpotLight<T> {
    /// The light that arrives at the point p: that of the [`PointLight`] times the
    /// [factor](Cone::factor) of the cone.
    #[inline]
    pub fn at(&self, p: impl Into<[T; 3]>) -> IncidentLight<T> {
        let mut light = self.point.at(p);
        (light.kind, light.axis, light.cone) = (Kind::Spot, self.axis, self.cone);
        light
    }

    /// The same light in another number type. `f` converts each number and may only round it.
    #[inline]
    pub fn cast<U: Real>(self, mut f: impl FnMut(T) -> U) -> SpotLight<U> {
        SpotLight {
            point: self.point.cast(&mut f),
            axis: self.axis.cast(&mut f),
            cone: self.cone.cast(f),
        }
    }
}

/// A light of any of the three kinds, for scenes that mix kinds.
///
/// ```
/// use shading::f32::{Attenuation, DirectionalLight, Light, PointLight, Rgb, UnitVec3, Vec3};
///
/// let (position, intensity) = (Vec3::new(2.0, 0.0, 2.0), Rgb::new(1.0, 0.8, 0.6));
/// let sun = DirectionalLight { l: UnitVec3::Z, intensity };
/// let lamp = PointLight { position, intensity, attenuation: Attenuation::NONE };
/// let lights: [Light; 2] = [sun.into(), lamp.into()];
///
/// let arriving: Rgb = lights.iter().map(|light| light.at(Vec3::ZERO).intensity()).sum();
/// assert_eq!(arriving, 2.0 * intensity);
/// ```
///
/// In a `static`, write the kind: `static LIGHTS: [Light; 1] = [Light::Directional(SUN)];`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(
        rename_all = "snake_case",
        bound(serialize = "T: Written", deserialize = "T: Read<'de>")
    )
)]
#[must_use]
pub enum Light<T = f32> {
    /// A light from one direction.
    Directional(DirectionalLight<T>),
    /// A light from one point.
    Point(PointLight<T>),
    /// A light from one point, within a cone.
    Spot(SpotLight<T>),
}

impl<T: Real> Light<T> {
    /// The light that arrives at the point p, as in [`DirectionalLight::at`], [`PointLight::at`]
    /// and [`SpotLight::at`].
    #[inline(always)]
    pub fn at(&self, p: impl Into<[T; 3]>) -> IncidentLight<T> {
        match self {
            Self::Directional(light) => light.at(p),
            Self::Point(light) => light.at(p),
            Self::Spot(light) => light.at(p),
        }
    }

    /// The same light in another number type. `f` converts each number and may only round it.
    #[inline]
    pub fn cast<U: Real>(self, f: impl FnMut(T) -> U) -> Light<U> {
        match self {
            Self::Directional(light) => Light::Directional(light.cast(f)),
            Self::Point(light) => Light::Point(light.cast(f)),
            Self::Spot(light) => Light::Spot(light.cast(f)),
        }
    }
}

macro_rules! kinds {
    ($($kind:ident: $light:ident),*) => {$(
        impl<T> From<$light<T>> for Light<T> {
            #[inline]
            fn from(light: $light<T>) -> Self {
                Self::$kind(light)
            }
        }
    )*};
}

kinds!(Directional: DirectionalLight, Point: PointLight, Spot: SpotLight);
