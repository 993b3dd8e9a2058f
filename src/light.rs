//! Lights, and the light that arrives at a point.

use core::ops::Mul;

use crate::attenuation::Attenuation;
use crate::cone::Cone;
use crate::real::Real;
use crate::rgb::Rgb;
use crate::unit::UnitVec3;
use crate::vector::Vec3;

/// The light that arrives at a point: a [`Light`], and the way to it.
///
/// The method `at` of every light returns it for a point. The direction, the distance and the
/// intensity are computed when you ask for them, so a light behind the surface costs a sum almost
/// nothing.
///
/// Multiply it to change what arrives. A falloff, a beam or a filter of your own is a `map`:
///
/// ```
/// use shading::f32::{IncidentLight, PointLight, Vec3};
///
/// /// A lamp in fog that dims the light to 1/e over each such length.
/// struct Foggy {
///     lamp: PointLight,
///     length: f32,
/// }
///
/// impl Foggy {
///     fn at(&self, p: Vec3) -> IncidentLight {
///         let incident = self.lamp.at(p);
///         incident * (-incident.distance() / self.length).exp()
///     }
/// }
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct IncidentLight<T = f32> {
    light: Light<T>,
    /// From the point to the light; for a light without a position, L.
    way: Vec3<T>,
}

/// What the sums need to know of an [`IncidentLight`].
pub(crate) struct Arriving<T> {
    /// A vector in the direction of L, and its length, which is 0 if there is no such direction.
    pub(crate) way: Vec3<T>,
    pub(crate) length: T,
    pub(crate) distance: T,
    pub(crate) intensity: Rgb<T>,
}

impl<T: Real> IncidentLight<T> {
    /// N·(the way to the light), which has the sign of N·L and needs no root.
    #[inline]
    pub(crate) fn in_front_by(&self, n: UnitVec3<T>) -> T {
        n.dot(self.way)
    }

    /// Whether the light comes from the front of a surface with the normal N. Otherwise it adds
    /// nothing to a sum. In lanes, whether it comes from the front in any lane.
    ///
    /// ```text
    /// N·L > 0
    /// ```
    ///
    /// The sums make this test themselves. Make it earlier to save a shadow ray.
    ///
    /// ```
    /// use shading::f32::{DirectionalLight, Rgb, UnitVec3, Vec3};
    ///
    /// let sun = DirectionalLight { l: UnitVec3::Z, intensity: Rgb::WHITE }.at(Vec3::ZERO);
    /// assert!(sun.is_in_front(UnitVec3::Z));
    /// assert!(!sun.is_in_front(UnitVec3::X)); // it only grazes the surface
    /// ```
    #[inline]
    #[must_use]
    pub fn is_in_front(&self, n: UnitVec3<T>) -> bool {
        self.in_front_by(n).any_positive()
    }

    /// This light as it arrives, if it is in front of a surface with the normal N and nothing blocks the
    /// way to it. `is_blocked` gets L and the distance to the light, at which a shadow ray ends.
    ///
    /// What remains has no position any more: its direction and intensity are known, and a sum need not
    /// compute them again. A shadow is one `filter_map`:
    ///
    /// ```
    /// use shading::f32::{Attenuation, PointLight, Rgb, UnitVec3, Vec3};
    ///
    /// let lamp = PointLight {
    ///     position: Vec3::new(0.0, 0.0, 5.0),
    ///     intensity: Rgb::WHITE,
    ///     attenuation: Attenuation::NONE,
    /// };
    /// let ceiling = |l: UnitVec3, distance: f32| 3.0 < distance * l.z;
    /// let lit = [lamp].into_iter().filter_map(|lamp| lamp.at(Vec3::ZERO).unless_blocked(UnitVec3::Z, ceiling));
    /// assert_eq!(lit.count(), 0);
    /// ```
    #[doc(alias = "shadow")]
    #[inline]
    #[must_use]
    pub fn unless_blocked(
        self,
        n: UnitVec3<T>,
        is_blocked: impl FnOnce(UnitVec3<T>, T) -> bool,
    ) -> Option<Self> {
        if !self.is_in_front(n) {
            return None;
        }
        let Arriving {
            way,
            length,
            distance,
            intensity,
        } = self.arriving();
        let l = UnitVec3::assume_unit(T::divided(way.into(), length).into());
        (!is_blocked(l, distance)).then(|| DirectionalLight { l, intensity }.into())
    }

    /// L, the direction from the surface **to** the light; the z axis if there is none.
    #[inline]
    #[must_use]
    pub fn l(&self) -> UnitVec3<T> {
        match &self.light {
            Light::Directional(light) => light.l,
            _ => self.way.unit_or(UnitVec3::Z),
        }
    }

    /// q, the distance to the light. A shadow ray ends there; geometry beyond the light does not block
    /// it.
    ///
    /// It is finite unless a coordinate is NaN. It is [`MAX`](Real::MAX) if the light has no position,
    /// like the sun, or if q overflows.
    #[inline]
    #[must_use]
    pub fn distance(&self) -> T {
        self.arriving().distance.at_most(T::MAX)
    }

    /// I as it arrives: attenuated, and 0 outside a spot's cone.
    #[inline]
    #[must_use]
    pub fn intensity(&self) -> Rgb<T> {
        let Arriving {
            length, intensity, ..
        } = self.arriving();
        intensity.map(|channel| length.if_positive(channel, T::ZERO))
    }

    #[inline(always)]
    pub(crate) fn arriving(&self) -> Arriving<T> {
        match &self.light {
            Light::Directional(light) => Arriving {
                way: *light.l,
                length: T::ONE,
                distance: T::MAX,
                intensity: light.intensity,
            },
            Light::Point(light) => light.along(self.way),
            Light::Spot(light) => light.along(self.way),
        }
    }

    /// The same light in another number type: `f` converts each number, and may do no more than round
    /// it, or take one of several lanes.
    #[inline]
    #[must_use]
    pub fn cast<U: Real>(self, mut f: impl FnMut(T) -> U) -> IncidentLight<U> {
        IncidentLight {
            light: self.light.cast(&mut f),
            way: self.way.map(f),
        }
    }
}

/// What arrives, dimmed or brightened.
impl<T: Real> Mul<T> for IncidentLight<T> {
    type Output = Self;
    #[inline]
    fn mul(self, factor: T) -> Self {
        self * Rgb::gray(factor)
    }
}

/// What arrives through a colored filter.
impl<T: Real> Mul<Rgb<T>> for IncidentLight<T> {
    type Output = Self;
    #[inline]
    fn mul(mut self, filter: Rgb<T>) -> Self {
        let intensity = match &mut self.light {
            Light::Directional(light) => &mut light.intensity,
            Light::Point(light) => &mut light.intensity,
            Light::Spot(light) => &mut light.point.intensity,
        };
        *intensity = *intensity * filter;
        self
    }
}

/// A light so far away, such as the sun, that its direction is the same everywhere. It is not
/// attenuated.
///
/// L points **to** the light. If your scene file gives the direction in which the light shines, as
/// glTF does, negate it.
///
/// Source: Foley, van Dam, Feiner, Hughes, *Computer Graphics: Principles and Practice*, 2nd ed.,
/// 1990, §16.1.2; *The OpenGL Graphics System: A Specification*, version 2.1, 2006, §2.14.1.
///
/// ```
/// use shading::f32::{DirectionalLight, Rgb, UnitVec3};
///
/// static SUN: DirectionalLight = DirectionalLight {
///     l: UnitVec3::const_normalized(1.0, 2.0, 3.0).unwrap(),
///     intensity: Rgb::new(1.0, 0.95, 0.9),
/// };
/// ```
#[doc(alias = "sun")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(
        deny_unknown_fields,
        bound(
            serialize = "T: Real + crate::Scalar + serde::Serialize",
            deserialize = "T: Real + crate::Scalar + serde::Deserialize<'de>"
        )
    )
)]
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
    #[must_use]
    pub fn at(&self, _p: impl Into<[T; 3]>) -> IncidentLight<T> {
        (*self).into()
    }

    /// The same light in another number type. `f` converts each number and may only round it.
    #[inline]
    #[must_use]
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
        Self {
            way: light.l.into(),
            light: light.into(),
        }
    }
}

/// A light that shines from one point in all directions and is attenuated with distance.
///
/// You choose the unit of length. Positions and the q of the attenuation share it.
///
/// Source: Foley, van Dam, Feiner, Hughes, *Computer Graphics: Principles and Practice*, 2nd ed.,
/// 1990, §16.1.2; *The OpenGL Graphics System: A Specification*, version 2.1, 2006, §2.14.1.
///
/// ```
/// use shading::f32::{Attenuation, PointLight, Rgb, Vec3};
///
/// static LAMP: PointLight = PointLight {
///     position: Vec3::new(0.0, 0.0, 3.0),
///     intensity: Rgb::WHITE,
///     attenuation: Attenuation::const_new(1.0, 0.0, 0.25).unwrap(),
/// };
/// ```
#[doc(alias = "lamp")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(
        deny_unknown_fields,
        bound(
            serialize = "T: Real + crate::Scalar + serde::Serialize",
            deserialize = "T: Real + crate::Scalar + serde::Deserialize<'de>"
        )
    )
)]
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
    /// let lamp = PointLight {
    ///     position: Vec3::new(0.0, 0.0, 3.0),
    ///     intensity: Rgb::WHITE,
    ///     attenuation: Attenuation::new(1.0, 0.0, 0.25).unwrap(),
    /// };
    /// let incident = lamp.at(Vec3::new(0.0, 0.0, 1.0));
    /// assert_eq!((incident.l(), incident.distance()), (UnitVec3::Z, 2.0));
    /// assert_eq!(incident.intensity(), Rgb::gray(0.5)); // 1/(1 + 2²/4)
    ///
    /// assert_eq!(lamp.at(lamp.position).intensity(), Rgb::BLACK);
    /// ```
    #[inline]
    #[must_use]
    pub fn at(&self, p: impl Into<[T; 3]>) -> IncidentLight<T> {
        IncidentLight {
            light: Light::Point(*self),
            way: self.position - Vec3::from(p.into()),
        }
    }

    #[inline(always)]
    fn along(&self, way: Vec3<T>) -> Arriving<T> {
        let (way, length, distance) = T::direction(way.into());
        Arriving {
            way: way.into(),
            length,
            distance,
            intensity: self.attenuation.dimmed(self.intensity, distance),
        }
    }

    /// The same light in another number type. `f` converts each number and may only round it.
    #[inline]
    #[must_use]
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
/// static SPOT: SpotLight = SpotLight {
///     point: PointLight {
///         position: Vec3::new(0.0, 3.0, 0.0),
///         intensity: Rgb::WHITE,
///         attenuation: Attenuation::NONE,
///     },
///     axis: UnitVec3::NEG_Y,                      // the spot shines straight down
///     cone: Cone::const_from_half_angle(0.5).unwrap(),  // 1 radian from edge to edge
/// };
/// assert_eq!(SPOT.at(Vec3::ZERO).intensity(), Rgb::WHITE); // right below
/// assert_eq!(SPOT.at(Vec3::new(3.0, 0.0, 0.0)).intensity(), Rgb::BLACK);
/// ```
#[doc(alias = "spotlight")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(
        deny_unknown_fields,
        bound(
            serialize = "T: Real + crate::Scalar + serde::Serialize",
            deserialize = "T: crate::Elementary + crate::Scalar + serde::Deserialize<'de>"
        )
    )
)]
#[repr(C)] // begins with its point light, as `Light::Point` does, so `Light` finds both at one offset
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
    #[must_use]
    pub fn at(&self, p: impl Into<[T; 3]>) -> IncidentLight<T> {
        IncidentLight {
            light: Light::Spot(*self),
            way: self.point.position - Vec3::from(p.into()),
        }
    }

    #[inline(always)]
    fn along(&self, way: Vec3<T>) -> Arriving<T> {
        let light = self.point.along(way);
        let cosine = (-self.axis).dot(light.way) / light.length;
        let intensity = light.intensity * self.cone.share(cosine);
        Arriving { intensity, ..light }
    }

    /// The same light in another number type. `f` converts each number and may only round it.
    #[inline]
    #[must_use]
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
/// let sun = DirectionalLight { l: UnitVec3::Z, intensity: Rgb::WHITE };
/// let lamp = PointLight {
///     position: Vec3::new(2.0, 0.0, 2.0),
///     intensity: Rgb::new(1.0, 0.8, 0.6),
///     attenuation: Attenuation::NONE,
/// };
/// let lights: [Light; 2] = [sun.into(), lamp.into()];
///
/// let arriving: Rgb = lights.iter().map(|light| light.at(Vec3::ZERO).intensity()).sum();
/// assert_eq!(arriving, sun.intensity + lamp.intensity);
/// ```
///
/// In a `static`, write the kind: `static LIGHTS: [Light; 1] = [Light::Directional(SUN)];`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(
        rename_all = "snake_case",
        bound(
            serialize = "T: Real + crate::Scalar + serde::Serialize",
            deserialize = "T: crate::Elementary + crate::Scalar + serde::Deserialize<'de>"
        )
    )
)]
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
    #[must_use]
    pub fn at(&self, p: impl Into<[T; 3]>) -> IncidentLight<T> {
        IncidentLight {
            light: *self,
            way: match self {
                Self::Directional(light) => *light.l,
                Self::Point(point) | Self::Spot(SpotLight { point, .. }) => {
                    point.position - Vec3::from(p.into())
                }
            },
        }
    }

    /// The same light in another number type. `f` converts each number and may only round it.
    #[inline]
    #[must_use]
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
