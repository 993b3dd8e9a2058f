//! The light that arrives at a point.

use crate::real::Real;
use crate::rgb::Rgb;
use crate::unit::UnitVec3;

/// The light that arrives at a point from one direction. The [sums over lights](crate::shade) need
/// nothing else of a light.
///
/// The method `at` of every [`Light`](crate::Light) returns it for a point. You can change it
/// before you pass it to the sum, or make it yourself: a light of your own is a function from a
/// point to an `IncidentLight`.
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
    /// I as it arrives: attenuated, and 0 outside a spot's cone.
    pub intensity: Rgb<T>,
    /// q, the distance to the light. A shadow ray ends there; anything farther away casts no
    /// shadow.
    ///
    /// It is always finite. It is [`MAX`](Real::MAX) if the light has no position, like the sun, if
    /// q overflows, or if there is no direction to the light, which is then black.
    pub distance: T,
}

impl<T: Real> IncidentLight<T> {
    /// This light, or `None` if it comes from behind a surface with the normal N and therefore adds
    /// nothing to a sum. In lanes, it is `None` if the light adds nothing in any lane.
    ///
    /// ```text
    /// N·L > 0
    /// ```
    ///
    /// A NaN N·L also gives `None`.
    ///
    /// The sums make this test themselves. Make it earlier to save work on each light, such as a
    /// shadow ray. For a [`PointLight`](crate::PointLight), use its own
    /// [`in_front`](crate::PointLight::in_front), which also saves the square root.
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

    /// The same light in another number type: `f` converts each number, and may do no more than round
    /// it, or take one of several lanes.
    ///
    /// ```
    /// use shading::f32::{IncidentLight, Rgb, UnitVec3};
    ///
    /// let light = IncidentLight { l: UnitVec3::Z, intensity: Rgb::gray(0.5), distance: 2.0 };
    /// assert_eq!(light.cast(f64::from).distance, 2.0_f64);
    /// ```
    #[inline]
    #[must_use]
    pub fn cast<U>(self, mut f: impl FnMut(T) -> U) -> IncidentLight<U> {
        IncidentLight {
            l: self.l.cast(&mut f),
            intensity: self.intensity.map(&mut f),
            distance: f(self.distance),
        }
    }
}
