//! What arrives of a light at a point.

use crate::real::Real;
use crate::rgb::Rgb;
use crate::unit::UnitVec3;

/// The light that arrives at a point from one direction: all that the
/// [sums over lights](crate::shade) know of a light.
///
/// Every [`Light`](crate::Light) gives it at a point. Change it on its way to the sum, or make it
/// yourself: a light of your own is a function from a point to what arrives there.
///
/// ```
/// use shading::f32::{Attenuation, IncidentLight, PointLight, Rgb, UnitVec3, Vec3};
///
/// /// A lamp that fades out toward its range.
/// struct Lantern {
///     lamp: PointLight,
///     range: f32,
/// }
///
/// impl Lantern {
///     fn at(&self, p: Vec3) -> IncidentLight {
///         let incident = self.lamp.at(p);
///         let share = (1.0 - incident.distance / self.range).max(0.0);
///         IncidentLight { intensity: incident.intensity * share, ..incident }
///     }
/// }
///
/// let lamp = PointLight {
///     position: Vec3::new(0.0, 0.0, 2.0),
///     intensity: Rgb::WHITE,
///     attenuation: Attenuation::NONE,
/// };
/// let lanterns = [Lantern { lamp, range: 8.0 }, Lantern { lamp, range: 1.0 }];
///
/// let (p, n) = (Vec3::ZERO, UnitVec3::Z);
/// let lit = lanterns.iter().filter_map(|lantern| lantern.at(p).in_front(n));
/// assert!(lit.map(|light| light.intensity).eq([Rgb::gray(0.75), Rgb::BLACK]));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct IncidentLight<T = f32> {
    /// L, the direction from the surface **to** the light.
    pub l: UnitVec3<T>,
    /// I, as it arrives: attenuated, and zero outside a spot's cone.
    pub intensity: Rgb<T>,
    /// q, the distance to the light, at which a shadow ray ends: what is farther away casts no
    /// shadow.
    ///
    /// Always finite: [`MAX`](Real::MAX) where the light has no place, as the sun; where q
    /// overflows; and where there is no direction to the light and it is black.
    pub distance: T,
}

impl<T: Real> IncidentLight<T> {
    /// This light, or `None` if it comes from behind a surface with the normal N and so adds nothing
    /// to a sum; in lanes, if it does in all of them.
    ///
    /// ```text
    /// N·L > 0
    /// ```
    ///
    /// `None` if N·L is not a number.
    ///
    /// The sums test it themselves. Test it earlier to save what you do with each light before: a
    /// shadow ray, for example. A [`PointLight`](crate::PointLight) has an
    /// [`in_front`](crate::PointLight::in_front) of its own that saves the square root too.
    ///
    /// ```
    /// use shading::f32::{IncidentLight, Rgb, UnitVec3};
    ///
    /// let light = IncidentLight { l: UnitVec3::Z, intensity: Rgb::WHITE, distance: f32::MAX };
    /// assert_eq!(light.in_front(UnitVec3::Z), Some(light));
    /// assert_eq!(light.in_front(UnitVec3::X), None); // it only grazes the surface
    /// ```
    #[inline]
    #[must_use]
    pub fn in_front(self, n: UnitVec3<T>) -> Option<Self> {
        n.dot(self.l).any_positive().then_some(self)
    }
}
