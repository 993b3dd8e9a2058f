//! The light that arrives at a point.

use core::fmt;
use core::ops::Mul;

use super::{Attenuation, Cone};
use crate::color::Rgb;
use crate::number::triple::assign;
use crate::number::{Dimmed, Mask, Measured, Real, Toward, cold};
use crate::vector::{UnitVec3, Vec3};

/// The kind of a light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Kind {
    Directional,
    Point,
    Spot,
}

/// The light that arrives at a point: a [`Light`](crate::Light), and the vector to it.
///
/// Each light's `at` returns one for a given point. The direction, the distance and the
/// intensity are computed when you ask for them, so a light behind the surface costs a sum almost
/// nothing. [`arrival`](IncidentLight::arrival) computes all three with a single root.
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
#[derive(Clone, Copy, PartialEq)]
#[must_use]
#[repr(C)] // a vector in one piece waits for its stores, in an array of lights: 1.6 times the time
pub struct IncidentLight<T = f32> {
    /// From the point to the light, of any length.
    to_x: T,
    /// Before attenuation.
    intensity: Rgb<T>,
    to_y: T,
    attenuation: Attenuation<T>,
    to_z: T,
    pub(super) axis: UnitVec3<T>,
    pub(super) cone: Cone<T>,
    pub(super) kind: Kind,
}

#[allow(clippy::missing_fields_in_debug)] // three are printed as one vector
impl<T: Real + fmt::Debug> fmt::Debug for IncidentLight<T> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.debug_struct("IncidentLight")
            .field("to_light", &self.vector())
            .field("intensity", &self.intensity)
            .field("attenuation", &self.attenuation)
            .field("axis", &self.axis)
            .field("cone", &self.cone)
            .field("kind", &self.kind)
            .finish()
    }
}

/// What arrives at a point from one light: L, I and q, for a reflection of your own.
///
/// ```
/// use shading::f32::{Attenuation, IncidentLight, PointLight, Rgb, UnitVec3, Vec3};
///
/// /// A surface that is lit from behind, too: half of I (1 + N·L).
/// fn wrapped(n: UnitVec3, light: IncidentLight) -> Rgb {
///     let arrival = light.arrival();
///     arrival.intensity * (0.5 + 0.5 * n.dot(arrival.l))
/// }
///
/// let position = Vec3::new(0.0, 0.0, 2.0);
/// let lamp = PointLight { position, intensity: Rgb::WHITE, attenuation: Attenuation::NONE };
/// assert_eq!(wrapped(UnitVec3::Z, lamp.at(Vec3::ZERO)), Rgb::WHITE);
/// assert_eq!(lamp.at(Vec3::ZERO).arrival().distance, 2.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[must_use]
pub struct Arrival<T = f32> {
    /// L, as [`IncidentLight::l`].
    pub l: UnitVec3<T>,
    /// I, as [`IncidentLight::intensity`].
    pub intensity: Rgb<T>,
    /// q, as [`IncidentLight::distance`].
    pub distance: T,
}

impl<T: Real> IncidentLight<T> {
    /// For a point light. Its cone is never read.
    #[inline(always)]
    pub(super) fn new(to_light: Vec3<T>, intensity: Rgb<T>, attenuation: Attenuation<T>) -> Self {
        Self {
            to_x: to_light.x,
            intensity,
            to_y: to_light.y,
            attenuation,
            to_z: to_light.z,
            axis: UnitVec3::Z,
            cone: Cone::EVERYWHERE,
            kind: Kind::Point,
        }
    }

    #[inline]
    fn vector(&self) -> Vec3<T> {
        Vec3::new(self.to_x, self.to_y, self.to_z)
    }

    /// Where N·L > 0. N·(the vector to the light) has the sign of N·L and needs no root.
    #[inline]
    pub(crate) fn in_front(&self, n: UnitVec3<T>) -> T::Mask {
        T::faces(*n, self.vector())
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

    /// L, I and q by one root. Each has the bits of [`l`](IncidentLight::l),
    /// [`intensity`](IncidentLight::intensity) and [`distance`](IncidentLight::distance), which are
    /// shorter to write where you need only one.
    #[doc(alias("incoming", "irradiance"))]
    #[inline]
    pub fn arrival(&self) -> Arrival<T> {
        if self.kind == Kind::Directional {
            return Arrival {
                l: UnitVec3::assume_unit(self.vector()),
                intensity: self.intensity,
                distance: T::MAX,
            };
        }
        let measured = T::measured(self.vector());
        let Measured { w, w_length, .. } = measured;
        let (mut l, mut light) = (w / w_length, self.dimmed(&measured));
        let is_somewhere = w_length.above(T::ZERO);
        if !is_somewhere.all() {
            cold();
            l = Vec3::select(is_somewhere, l, *UnitVec3::Z);
            light.factor = is_somewhere.select(light.factor, T::ZERO);
        }
        Arrival {
            l: UnitVec3::assume_unit(l),
            intensity: light.multiplied().finite(),
            distance: measured.length.at_most(T::MAX),
        }
    }

    /// L, the direction from the surface **to** the light; the z axis if there is none.
    #[inline]
    pub fn l(&self) -> UnitVec3<T> {
        match self.kind {
            Kind::Directional => UnitVec3::assume_unit(self.vector()),
            _ => self.vector().unit_or(UnitVec3::Z),
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
            _ => self.vector().length().at_most(T::MAX),
        }
    }

    /// I as it arrives: attenuated, and 0 outside a spot's cone.
    #[inline]
    pub fn intensity(&self) -> Rgb<T> {
        self.arrival().intensity
    }

    /// What a sum needs: the vector to the light, and the light before N·L.
    #[inline(always)]
    pub(crate) fn toward(&self, n: UnitVec3<T>) -> (Toward<T>, Dimmed<T>) {
        if self.kind == Kind::Directional {
            let measured = Measured::along(self.vector(), T::MAX);
            let n_dot_w = n.dot(measured.w);
            return (Toward { measured, n_dot_w }, Dimmed::full(self.intensity));
        }
        let toward = T::toward(*n, self.vector());
        let light = self.dimmed(&toward.measured);
        (toward, light)
    }

    /// The light after the distance and the cone.
    #[inline(always)]
    fn dimmed(&self, measured: &Measured<T>) -> Dimmed<T> {
        let (v, q) = (self.vector(), measured.length);
        let light = self.attenuation.dimmed(self.intensity, v, q);
        if self.kind == Kind::Spot {
            self.cone.dimmed(light, self.axis, v, measured)
        } else {
            light
        }
    }

    /// The same light in another number type: `f` converts each number, and may do no more than round
    /// it, or take one of several lanes.
    #[inline]
    pub fn cast<U: Real>(self, mut f: impl FnMut(T) -> U) -> IncidentLight<U> {
        let (to_light, intensity) = (self.vector().map(&mut f), self.intensity.map(&mut f));
        let mut light = IncidentLight::new(to_light, intensity, self.attenuation.cast(&mut f));
        light.kind = self.kind;
        if self.kind == Kind::Spot {
            (light.axis, light.cone) = (self.axis.cast(&mut f), self.cone.cast(f));
        }
        light
    }
}

/// Scales the light that arrives.
impl<T: Real> Mul<T> for IncidentLight<T> {
    type Output = Self;
    #[inline]
    fn mul(self, factor: T) -> Self {
        self * Rgb::gray(factor)
    }
}

/// What arrives through a colored filter. A black channel stays black whatever the filter is. A channel
/// that overflows is the largest finite number, or its negative; one that is not black is the largest
/// finite number where the filter is NaN.
///
/// ```
/// use shading::f32::{DirectionalLight, Rgb, UnitVec3, Vec3};
///
/// let sun = DirectionalLight { l: UnitVec3::Z, intensity: Rgb::new(0.0, 1.0, 2.0) };
/// let filtered = sun.at(Vec3::ZERO) * Rgb::new(f32::INFINITY, f32::INFINITY, 0.5);
/// assert_eq!(filtered.intensity(), Rgb::new(0.0, f32::MAX, 1.0));
/// ```
impl<T: Real> Mul<Rgb<T>> for IncidentLight<T> {
    type Output = Self;
    #[inline]
    fn mul(mut self, filter: Rgb<T>) -> Self {
        let finite = |color: Rgb<T>| color.finite().map(|channel| channel.at_least(-T::MAX));
        // a filter of ±∞ times 0 would be NaN
        self.intensity = finite(self.intensity * finite(filter));
        self
    }
}

assign!([T] IncidentLight<T>, T: Mul);
assign!([T] IncidentLight<T>, Rgb<T>: Mul);
