//! The light that arrives at a point.

use core::ops::Mul;

use crate::attenuation::Attenuation;
use crate::cone::Cone;
use crate::real::{Mask, Measured, Real, Select, Toward};
use crate::rgb::Rgb;
use crate::unit::UnitVec3;
use crate::vector::Vec3;

/// The kind of a light. Shaders have no enums with data, and integers of 32 bits alone.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(u32)]
pub(super) enum Kind {
    Directional,
    Point,
    Spot,
}

/// The light that arrives at a point: a [`Light`](crate::Light), and the way to it.
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
/// fn in_fog(lamp: PointLight, length: f32, p: Vec3) -> IncidentLight {
///     let incident = lamp.at(p);
///     incident * (-incident.distance() / length).exp()
/// }
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[must_use]
pub struct IncidentLight<T = f32> {
    /// From the point to the light, of any length.
    way: Vec3<T>,
    /// Before attenuation.
    intensity: Rgb<T>,
    attenuation: Attenuation<T>,
    pub(super) axis: UnitVec3<T>,
    pub(super) cone: Cone<T>,
    pub(super) kind: Kind,
}

/// What the sums need to know of an [`IncidentLight`].
pub(crate) struct Arriving<T> {
    /// A vector in the direction of L.
    pub(crate) way: Measured<T>,
    pub(crate) n_dot_l: T,
    /// Before attenuation.
    pub(crate) color: Rgb<T>,
    /// What attenuates it.
    pub(crate) factor: T,
}

impl<T: Real> IncidentLight<T> {
    /// Of a lamp: it has a cone that nobody looks at.
    #[inline(always)]
    pub(super) fn new(way: Vec3<T>, intensity: Rgb<T>, attenuation: Attenuation<T>) -> Self {
        Self {
            way,
            intensity,
            attenuation,
            axis: UnitVec3::Z,
            cone: Cone::EVERYWHERE,
            kind: Kind::Point,
        }
    }

    /// Where N·L > 0. N·(the way to the light) has the sign of N·L and needs no root.
    #[inline]
    pub(crate) fn in_front(&self, n: UnitVec3<T>) -> T::Mask {
        T::faces(*n, self.way)
    }

    /// Whether the light comes from the front of a surface with the normal N. Otherwise it adds
    /// nothing to a sum. In lanes, whether it comes from the front in any lane.
    ///
    /// ```text
    /// N·L > 0
    /// ```
    ///
    /// The sums make this test themselves. Make it earlier to save a shadow ray.
    #[inline]
    #[must_use]
    pub fn is_in_front(&self, n: UnitVec3<T>) -> bool {
        self.in_front(n).any()
    }

    /// L, the direction from the surface **to** the light; the z axis if there is none.
    #[inline]
    pub fn l(&self) -> UnitVec3<T> {
        match self.kind {
            Kind::Directional => UnitVec3::assume_unit(self.way),
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
        match self.kind {
            Kind::Directional => T::MAX,
            _ => self.way.length().at_most(T::MAX),
        }
    }

    /// I as it arrives: attenuated, and 0 outside a spot's cone.
    #[inline]
    pub fn intensity(&self) -> Rgb<T> {
        if self.kind == Kind::Directional {
            return self.intensity;
        }
        let measured = T::measured(self.way);
        let is_somewhere = measured.w_length.above(T::ZERO);
        let (color, factor) = self.dimmed(&measured);
        let factor = is_somewhere.select(factor, T::ZERO);
        (color * factor).finite()
    }

    #[inline(always)]
    pub(crate) fn arriving(&self, n: UnitVec3<T>) -> Arriving<T> {
        if self.kind == Kind::Directional {
            let way = Measured {
                w: self.way,
                w_length: T::ONE,
                length: T::MAX,
            };
            let n_dot_v = n.dot(self.way);
            return Arriving {
                way,
                n_dot_l: T::cosine(*n, &Toward { way, n_dot_v }),
                color: self.intensity,
                factor: T::ONE,
            };
        }
        let toward = T::toward(*n, self.way);
        let (color, factor) = self.dimmed(&toward.way);
        Arriving {
            way: toward.way,
            n_dot_l: T::cosine(*n, &toward),
            color,
            factor,
        }
    }

    /// I after the distance and the cone.
    #[inline(always)]
    fn dimmed(&self, to_light: &Measured<T>) -> (Rgb<T>, T) {
        let (color, factor) = self.attenuation.dimmed(self.intensity, to_light.length);
        if self.kind == Kind::Spot {
            let cosine = (-self.axis).dot(to_light.w) / to_light.w_length;
            T::within((color, factor), self.cone.share(cosine))
        } else {
            (color, factor)
        }
    }

    /// The same light in another number type: `f` converts each number, and may do no more than round
    /// it, or take one of several lanes.
    #[inline]
    pub fn cast<U: Real>(self, mut f: impl FnMut(T) -> U) -> IncidentLight<U> {
        let (way, intensity) = (self.way.map(&mut f), self.intensity.map(&mut f));
        let mut light = IncidentLight::new(way, intensity, self.attenuation.cast(&mut f));
        (light.axis, light.cone) = (self.axis.cast(&mut f), self.cone.cast(f));
        light.kind = self.kind;
        light
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

/// What arrives through a colored filter. A channel that overflows is the largest finite number.
impl<T: Real> Mul<Rgb<T>> for IncidentLight<T> {
    type Output = Self;
    #[inline]
    fn mul(mut self, filter: Rgb<T>) -> Self {
        self.intensity = (self.intensity * filter).finite();
        self
    }
}
