//! Light from one point.

use super::in_front::{Filtered, is_in_front};
use super::incident::IncidentLight;
use crate::attenuation::{Attenuation, Falloff};
use crate::real::Real;
use crate::rescale::{extreme_difference, is_extreme};
use crate::rgb::Rgb;
use crate::unit::UnitVec3;
use crate::vector::Vec3;

/// A light that shines from one point in all directions, attenuated with distance.
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
/// The unit of length is yours: that of the positions and of the attenuation's q.
///
/// Source: Foley, van Dam et al., *Computer Graphics*, §16.1.2; OpenGL 2.1 specification, §2.14.1.
#[doc(alias = "lamp")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointLight<T = f32, A = Attenuation<T>> {
    /// Where the light is.
    pub position: Vec3<T>,
    /// I, before attenuation: linear, and not limited to 1.
    pub intensity: Rgb<T>,
    /// Falloff with distance: an [`Attenuation`], or one within a range, [`Ranged`](crate::Ranged).
    pub attenuation: A,
}

impl<T: Real, A: Falloff<T>> PointLight<T, A> {
    /// The light that arrives at the point p.
    ///
    /// ```text
    /// L = (P_light − p)/q,  q = |P_light − p|,  I / (a + bq + cq²)
    /// ```
    ///
    /// At the light itself (q = 0), and where a coordinate is infinite, it lights nothing. A distance
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

    /// [`at`](PointLight::at) a point of a surface with the normal N, or `None` where the light is
    /// behind it or the point out of its [range](crate::Ranged); in lanes, where that is so in all of
    /// them.
    ///
    /// A light behind the surface costs a dot product, and neither root nor division. A light next to
    /// the horizon may be given although N·L ≤ 0: it adds nothing, so that a sum over lights comes out
    /// the same, to the bit.
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
    #[cfg_attr(target_os = "none", inline(always))]
    #[cfg_attr(not(target_os = "none"), inline)]
    #[must_use]
    pub fn in_front(&self, p: Vec3<T>, n: UnitVec3<T>) -> Option<IncidentLight<T>> {
        let to_light = self.position - p;
        // most often the sign alone decides
        let in_front = n.dot(to_light).any_positive() || is_in_front(n, to_light);
        if in_front && self.reaches(to_light) {
            Some(self.along(p, to_light))
        } else {
            None
        }
    }

    /// [`in_front`](PointLight::in_front) for each of a scene's lights, in order, and without a branch
    /// for each: 32 are tested at a time.
    ///
    /// It is the fastest way where the processor cannot predict which lights are in front. Where all
    /// are, or on a microcontroller, `filter_map` with `in_front` is faster.
    ///
    /// ```
    /// use shading::f32::{Attenuation, PointLight, Rgb, UnitVec3, Vec3};
    ///
    /// let lamp = |z| PointLight {
    ///     position: Vec3::new(0.0, 0.0, z),
    ///     intensity: Rgb::WHITE,
    ///     attenuation: Attenuation::NONE,
    /// };
    /// let lamps = [lamp(2.0), lamp(-2.0), lamp(4.0)];
    /// let lit = PointLight::all_in_front(&lamps, Vec3::ZERO, UnitVec3::Z);
    /// assert!(lit.map(|light| light.distance).eq([2.0, 4.0]));
    /// ```
    #[inline]
    pub fn all_in_front(
        lights: &[Self],
        p: Vec3<T>,
        n: UnitVec3<T>,
    ) -> impl Iterator<Item = IncidentLight<T>> {
        Filtered::by(move |light: &Self| light.may_light(p, n), lights)
            .map(move |light| light.at(p))
    }

    /// Whether [`in_front`](PointLight::in_front) gives a light.
    #[inline]
    pub(super) fn may_light(&self, p: Vec3<T>, n: UnitVec3<T>) -> bool {
        let to_light = self.position - p;
        is_in_front(n, to_light) && self.reaches(to_light)
    }

    /// Whether the light may reach a point along P_light − p.
    #[inline]
    fn reaches(&self, to_light: Vec3<T>) -> bool {
        self.attenuation.reaches(to_light.dot(to_light))
    }

    /// The light at p along P_light − p.
    #[inline(always)]
    fn along(&self, p: Vec3<T>, to_light: Vec3<T>) -> IncidentLight<T> {
        let square = to_light.dot(to_light);
        let (l, q, distance) = if is_extreme(square) {
            self.extreme_way(p.into(), square)
        } else {
            let q = square.sqrt();
            (UnitVec3::assume_unit(to_light * (T::ONE / q)), q, q)
        };
        let intensity = self.attenuation.dim(&self.intensity, q);
        IncidentLight {
            l,
            intensity,
            distance,
        }
    }

    /// L, q and the distance where q² is out of range. A light without a direction counts as
    /// infinitely far away, which makes it black; its distance is the largest number all the same.
    ///
    /// The point comes as an array, which is made only here. A vector would be written to memory for
    /// every light, even where this is not called. For firmware it is inlined: the call would take
    /// more flash and more stack.
    #[cfg_attr(target_os = "none", inline(always))]
    #[cfg_attr(not(target_os = "none"), cold, inline(never))]
    fn extreme_way(&self, p: [T; 3], square: T) -> (UnitVec3<T>, T, T) {
        let p = Vec3::from(p);
        let (way, scale) = extreme_difference(self.position, p, square);
        let q = way.dot(way).sqrt();
        let reciprocal = T::ONE / q;
        // positive for a reciprocal that is neither zero nor infinite nor NaN
        let valid = reciprocal * (T::MAX - reciprocal);
        let component = |c, otherwise| valid.if_positive(c * reciprocal, otherwise);
        let l = UnitVec3::assume_unit(Vec3::new(
            component(way.x, T::ZERO),
            component(way.y, T::ZERO),
            component(way.z, T::ONE),
        ));
        let infinity = T::ONE / T::ZERO;
        let q_or = |otherwise| valid.if_positive((q / scale).at_most(T::MAX), otherwise);
        (l, q_or(infinity), q_or(T::MAX))
    }

    /// The same light in another number type: `f` converts each number, and may do no more
    /// than round it.
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
    pub fn cast<U>(self, mut f: impl FnMut(T) -> U) -> PointLight<U, A::In<U>> {
        PointLight {
            position: self.position.map(&mut f),
            intensity: self.intensity.map(&mut f),
            attenuation: self.attenuation.cast(f),
        }
    }
}
