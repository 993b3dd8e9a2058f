//! A light from one point.

use super::in_front::is_in_front;
use super::incident::IncidentLight;
use crate::attenuation::{Attenuation, Falloff};
use crate::real::Real;
use crate::rgb::Rgb;
use crate::unit::UnitVec3;
use crate::vector::Vec3;

/// A light that shines from one point in all directions and is attenuated with distance.
///
/// ```
/// use shading::f32::{Attenuation, PointLight, Rgb, Vec3};
///
/// static LAMP: PointLight = PointLight {
///     position: Vec3::new(0.0, 0.0, 3.0),
///     intensity: Rgb::WHITE,
///     attenuation: Attenuation::new(1.0, 0.0, 0.25).unwrap(),
/// };
/// ```
///
/// You choose the unit of length. Positions and the q of the attenuation share it.
///
/// Source: Foley, van Dam, Feiner, Hughes, *Computer Graphics: Principles and Practice*, 2nd ed.,
/// 1990, §16.1.2; *The OpenGL Graphics System: A Specification*, version 2.1, 2006, §2.14.1.
#[doc(alias = "lamp")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointLight<T = f32, A = Attenuation<T>> {
    /// P_light, the position of the light.
    pub position: Vec3<T>,
    /// I before attenuation, linear; it may exceed 1.
    pub intensity: Rgb<T>,
    /// The falloff with distance: an [`Attenuation`], or a [`Ranged`](crate::Ranged) attenuation.
    pub attenuation: A,
}

impl<T: Real, A: Falloff<T>> PointLight<T, A> {
    /// The light that arrives at the point p.
    ///
    /// ```text
    /// L = (P_light − p)/q,  q = |P_light − p|,  intensity I / (a + bq + cq²)
    /// ```
    ///
    /// The light is black at its own position (q = 0) and if a coordinate is infinite. A distance
    /// or an intensity that overflows is the largest finite number.
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
    /// assert_eq!(incident.l, UnitVec3::Z);
    /// assert_eq!(incident.distance, 2.0);
    /// assert_eq!(incident.intensity, Rgb::gray(0.5)); // 1/(1 + 2²/4)
    ///
    /// assert_eq!(lamp.at(lamp.position).intensity, Rgb::BLACK);
    /// ```
    #[inline(always)]
    #[must_use]
    pub fn at(&self, p: Vec3<T>) -> IncidentLight<T> {
        self.along(p, self.position - p)
    }

    /// The light that arrives [`at`](PointLight::at) a surface point with the normal N, or `None`
    /// if the light is behind the surface or the point is out of [range](crate::Ranged). In lanes,
    /// it is `None` if no lane gets light.
    ///
    /// A light behind the surface costs a dot product, but no root and no division. A light close
    /// to the horizon may be returned although N·L ≤ 0. It adds nothing, so a sum over lights is
    /// the same, to the bit. Of dual numbers, the values are; a light that adds nothing may add a
    /// gradient that is not finite where the scene is so large or so small that squares leave the
    /// range.
    ///
    /// ```
    /// use shading::f32::{Attenuation, Material, PointLight, Rgb, UnitVec3, Vec3};
    /// use shading::shade;
    ///
    /// let lamp = |z| PointLight {
    ///     position: Vec3::new(1.0, 0.0, z),
    ///     intensity: Rgb::WHITE,
    ///     attenuation: Attenuation::NONE,
    /// };
    /// let lamps = [lamp(2.0), lamp(-2.0), lamp(-1.0)]; // one above the surface, two below
    /// let wax = Material { k_a: Rgb::WHITE, k_d: Rgb::WHITE, k_s: Rgb::WHITE, m: 8 };
    ///
    /// let (p, n, v) = (Vec3::ZERO, UnitVec3::Z, UnitVec3::Z);
    /// let all = lamps.iter().map(|lamp| lamp.at(p));
    /// let lit = lamps.iter().filter_map(|lamp| lamp.in_front(p, n));
    /// assert_eq!(lit.clone().count(), 1);
    /// assert_eq!(
    ///     shade::blinn_phong(n, v, &wax, Rgb::BLACK, lit),
    ///     shade::blinn_phong(n, v, &wax, Rgb::BLACK, all),
    /// );
    /// ```
    #[doc(alias = "cull")]
    #[inline(always)]
    #[must_use]
    pub fn in_front(&self, p: Vec3<T>, n: UnitVec3<T>) -> Option<IncidentLight<T>> {
        let to_light = self.position - p;
        // the sign alone usually decides
        let in_front = n.dot(to_light).any_positive() || is_in_front(n, to_light);
        if in_front && self.reaches(to_light) {
            Some(self.along(p, to_light))
        } else {
            None
        }
    }

    /// Whether the light may reach a point from which P_light − p leads to it.
    #[inline]
    fn reaches(&self, to_light: Vec3<T>) -> bool {
        self.attenuation.reaches(to_light.dot(to_light))
    }

    /// The light at p, given P_light − p.
    #[inline(always)]
    fn along(&self, p: Vec3<T>, to_light: Vec3<T>) -> IncidentLight<T> {
        let (l, q, distance) =
            T::direction_and_distance(|| [self.position.into(), p.into()], to_light.into());
        self.along_way(p, l, q, distance)
    }

    /// The light at p, given the direction, q and the distance of
    /// [`direction_and_distance`](Real::direction_and_distance).
    #[inline(always)]
    pub(crate) fn along_way(
        &self,
        p: Vec3<T>,
        l: [T; 3],
        q: [T; 2],
        distance: T,
    ) -> IncidentLight<T> {
        let intensity = if T::is_lit(q[1]) {
            let to_light = || (self.position - p).into();
            self.attenuation.dim_along(&self.intensity, q, to_light)
        } else {
            Rgb::BLACK
        };
        IncidentLight {
            l: UnitVec3::assume_unit(l.into()),
            intensity,
            distance,
        }
    }

    /// The same light in another number type. `f` converts each number and may only round it.
    ///
    /// ```
    /// use shading::f32::{Attenuation, PointLight, Rgb, Vec3};
    ///
    /// let lamp = PointLight {
    ///     position: Vec3::new(0.0, 0.0, 3.0),
    ///     intensity: Rgb::WHITE,
    ///     attenuation: Attenuation::NONE,
    /// };
    /// let precise: shading::f64::PointLight = lamp.cast(f64::from);
    /// assert_eq!(precise.position.z, 3.0_f64);
    /// ```
    #[inline]
    #[must_use]
    pub fn cast<U: Real>(self, mut f: impl FnMut(T) -> U) -> PointLight<U, A::In<U>> {
        PointLight {
            position: self.position.map(&mut f),
            intensity: self.intensity.map(&mut f),
            attenuation: self.attenuation.cast(f),
        }
    }
}
