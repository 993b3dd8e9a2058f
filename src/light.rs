//! Floor 4: lights, and what arrives of them at a point.
//!
//! For firmware `at` and `in_front` are always in line. A function of their own would keep numbers on
//! the stack beside those of the sum over lights that calls it, and small chips have little of that:
//! `tests/firmware/run.sh` measures how much is taken.

use crate::attenuation::Attenuation;
use crate::cone::Cone;
use crate::filter::Filtered;
use crate::real::Real;
use crate::rescale::{extreme_difference, is_extreme};
use crate::rgb::Rgb;
use crate::unit::UnitVec3;
use crate::vector::Vec3;

/// The light that arrives at a point from one direction: what every light source comes down to,
/// and what the [sums over lights](crate::shade) take.
///
/// Make it yourself for a light of your own kind, and change it on its way to the sum: a shadow is
/// an intensity of zero.
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

/// A light so far away that its direction is the same everywhere, and not attenuated: the sun.
///
/// ```
/// use shading::{DirectionalLight, Rgb, UnitVec3, Vec3};
///
/// static SUN: DirectionalLight<f32> =
///     DirectionalLight { l: UnitVec3::Z, intensity: Rgb::new(1.0, 0.95, 0.9) };
/// assert_eq!(SUN.at(Vec3::new(5.0, 0.0, -2.0)).intensity, SUN.intensity);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DirectionalLight<T = f32> {
    /// L, the direction **to** the light, against the way it shines.
    pub l: UnitVec3<T>,
    /// I, the same everywhere.
    pub intensity: Rgb<T>,
}

/// A light that shines from one point in all directions, attenuated with distance.
///
/// ```
/// use shading::{Attenuation, PointLight, Rgb, UnitVec3, Vec3};
///
/// static LAMP: PointLight<f32> = PointLight {
///     position: Vec3::new(0.0, 0.0, 3.0),
///     intensity: Rgb::WHITE,
///     attenuation: Attenuation::<f32>::new(1.0, 0.0, 0.25).unwrap(),
/// };
/// let incident = LAMP.at(Vec3::new(0.0, 0.0, 1.0));
/// assert_eq!(incident.l, UnitVec3::Z);
/// assert_eq!(incident.intensity, Rgb::gray(0.5));
///
/// // at the light itself there is no direction, and it lights nothing
/// assert_eq!(LAMP.at(LAMP.position).intensity, Rgb::BLACK);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointLight<T = f32> {
    /// Where the light is.
    pub position: Vec3<T>,
    /// I, before attenuation.
    pub intensity: Rgb<T>,
    /// What distance leaves of it.
    pub attenuation: Attenuation<T>,
}

/// A point light that shines within a cone.
///
/// ```
/// use shading::{Attenuation, Cone, PointLight, Rgb, SpotLight, UnitVec3, Vec3};
///
/// static SPOT: SpotLight<f32> = SpotLight {
///     point: PointLight {
///         position: Vec3::new(0.0, 3.0, 0.0),
///         intensity: Rgb::WHITE,
///         attenuation: Attenuation::NONE,
///     },
///     axis: UnitVec3::<f32>::new(0.0, -1.0, 0.0).unwrap(),
///     cone: Cone::<f32>::from_half_angle(0.5).unwrap(),
/// };
/// assert_eq!(SPOT.at(Vec3::ZERO).intensity, Rgb::WHITE);
/// assert_eq!(SPOT.at(Vec3::new(3.0, 0.0, 0.0)).intensity, Rgb::BLACK);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)] // begins with its point light, as `Light::Point` does: `Light` finds both at one place
pub struct SpotLight<T = f32> {
    /// The light at the tip of the cone.
    pub point: PointLight<T>,
    /// The direction in which the spot shines.
    pub axis: UnitVec3<T>,
    /// How wide.
    pub cone: Cone<T>,
}

/// Any of the three, for scenes that mix them.
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
/// A `static` names the kind: `static LIGHTS: [Light; 1] = [Light::Directional(SUN)];`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Light<T = f32> {
    /// From one direction.
    Directional(DirectionalLight<T>),
    /// From one point.
    Point(PointLight<T>),
    /// From one point, within a cone.
    Spot(SpotLight<T>),
}

impl<T: Real> DirectionalLight<T> {
    /// The light that arrives at the point p: the same at every point.
    #[inline]
    #[must_use]
    pub fn at(&self, _p: Vec3<T>) -> IncidentLight<T> {
        IncidentLight {
            l: self.l,
            intensity: self.intensity,
            distance: T::MAX,
        }
    }

    /// [`at`](DirectionalLight::at) a point of a surface with the normal N, or `None` where the light
    /// is behind it.
    #[inline]
    #[must_use]
    pub fn in_front(&self, p: Vec3<T>, n: UnitVec3<T>) -> Option<IncidentLight<T>> {
        n.dot(self.l).any_positive().then(|| self.at(p))
    }

    /// The same light in another number type: `f` converts each number, and may do no more
    /// than round it.
    #[inline]
    #[must_use]
    pub fn cast<U>(self, mut f: impl FnMut(T) -> U) -> DirectionalLight<U> {
        DirectionalLight {
            l: self.l.cast(&mut f),
            intensity: self.intensity.map(f),
        }
    }
}

impl<T: Real> PointLight<T> {
    /// The light that arrives at the point p.
    ///
    /// ```text
    /// L = (P_light − p)/q,  q = |P_light − p|,  I / (a + bq + cq²)
    /// ```
    ///
    /// At the light itself (q = 0), and where a coordinate is infinite, it lights nothing. A distance
    /// or an intensity that overflows is the largest finite number.
    #[inline(always)]
    #[must_use]
    pub fn at(&self, p: Vec3<T>) -> IncidentLight<T> {
        self.along(p, self.position - p)
    }

    /// [`at`](PointLight::at) a point of a surface with the normal N, or `None` where the light is
    /// behind it; in lanes, behind it in all of them.
    ///
    /// A sum over lights comes out the same, to the bit, and sooner: a light behind the surface
    /// costs a dot product, and neither root nor division.
    ///
    /// ```
    /// use shading::*;
    /// # let (n, v) = (UnitVec3::<f32>::Z, UnitVec3::<f32>::Z);
    /// # let p = Vec3::ZERO;
    /// # let material = Material { k_a: Rgb::WHITE, k_d: Rgb::WHITE, k_s: Rgb::WHITE, m: 8 };
    /// # let lamp = |z| PointLight {
    /// #     position: Vec3::new(1.0, 0.0, z), intensity: Rgb::WHITE, attenuation: Attenuation::NONE };
    /// # let lights = [lamp(2.0), lamp(-2.0), lamp(-1.0)];
    /// let all = lights.iter().map(|light| light.at(p));
    /// let lit = lights.iter().filter_map(|light| light.in_front(p, n));
    /// assert_eq!(lit.clone().count(), 1);
    ///
    /// let [all, lit] = [
    ///     shade::blinn_phong(n, v, &material, Rgb::BLACK, all),
    ///     shade::blinn_phong(n, v, &material, Rgb::BLACK, lit),
    /// ];
    /// assert_eq!(all, lit);
    /// ```
    #[doc(alias = "cull")]
    #[cfg_attr(target_os = "none", inline(always))]
    #[cfg_attr(not(target_os = "none"), inline)]
    #[must_use]
    pub fn in_front(&self, p: Vec3<T>, n: UnitVec3<T>) -> Option<IncidentLight<T>> {
        let to_light = self.position - p;
        // most often the sign alone decides
        if n.dot(to_light).any_positive() || Self::is_in_front(n, to_light) {
            Some(self.along(p, to_light))
        } else {
            None
        }
    }

    /// [`in_front`](PointLight::in_front) for each of a scene's lights: those in front of a point, as
    /// they arrive.
    ///
    /// Where it cannot be foretold which they are, this is the quickest way: all are tried without a
    /// branch, 32 at a time, so the processor has only their number to guess.
    ///
    /// ```
    /// use shading::*;
    /// # let (n, v) = (UnitVec3::<f32>::Z, UnitVec3::<f32>::Z);
    /// # let p = Vec3::ZERO;
    /// # let material = Material { k_a: Rgb::WHITE, k_d: Rgb::WHITE, k_s: Rgb::WHITE, m: 8 };
    /// # let lamp = |z| PointLight {
    /// #     position: Vec3::new(1.0, 0.0, z), intensity: Rgb::WHITE, attenuation: Attenuation::NONE };
    /// # let lights = [lamp(2.0), lamp(-2.0), lamp(-1.0)];
    /// let lit = PointLight::all_in_front(&lights, p, n);
    /// let shaded = shade::blinn_phong(n, v, &material, Rgb::BLACK, lit);
    /// # let all = lights.iter().map(|light| light.at(p));
    /// # assert_eq!(shaded, shade::blinn_phong(n, v, &material, Rgb::BLACK, all));
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
    fn may_light(&self, p: Vec3<T>, n: UnitVec3<T>) -> bool {
        Self::is_in_front(n, self.position - p)
    }

    /// Whether a light along P_light − p may light a surface: `false` where N·L would not be positive
    /// in any lane.
    #[inline]
    fn is_in_front(n: UnitVec3<T>, to_light: Vec3<T>) -> bool {
        // Below zero by more than 2⁻⁹ of |x| + |y| + |z|, which is not less than the distance: the
        // rounding of this dot product and of N·L is less in any number type of 12 bits or more, so N·L
        // is not positive either. Where the product may have lost bits below its range, it is in doubt.
        let size = to_light.x.abs() + to_light.y.abs() + to_light.z.abs();
        let beyond_doubt = size * T::of(-1.0 / 512.0) - T::ONE / T::RESCALE;
        let in_front = beyond_doubt.if_above(n.dot(to_light), T::ZERO, T::ONE);
        in_front.any_positive()
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
        let factor = self.attenuation.unlimited(q);
        // neither the limit nor an overflow is in reach of a factor up to 1
        let intensity = if factor.any_outside(T::ZERO, T::ONE) {
            let intensity = self.intensity * self.attenuation.limited(factor);
            intensity.map(|channel| channel.at_most(T::MAX))
        } else {
            self.intensity * factor
        };
        IncidentLight {
            l,
            intensity,
            distance,
        }
    }

    /// L, q and the distance where q² is out of range. A light without a direction counts as infinitely
    /// far away, which makes it black; its distance is the largest number all the same.
    ///
    /// It takes the point as an array: that is made only here, where a vector at hand would be written
    /// to memory for every light, also where this is not called. For firmware it is in line: the call
    /// would take more flash and more stack.
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
    #[inline]
    #[must_use]
    pub fn cast<U>(self, mut f: impl FnMut(T) -> U) -> PointLight<U> {
        PointLight {
            position: self.position.map(&mut f),
            intensity: self.intensity.map(&mut f),
            attenuation: self.attenuation.cast(f),
        }
    }
}

impl<T: Real> SpotLight<T> {
    /// The light that arrives at the point p: that of the [`PointLight`] inside the cone and on
    /// its edge, none outside.
    #[inline(always)]
    #[must_use]
    pub fn at(&self, p: Vec3<T>) -> IncidentLight<T> {
        self.narrowed(self.point.at(p))
    }

    /// [`at`](SpotLight::at) a point of a surface with the normal N, or `None` where the light is
    /// behind it or the point outside the cone; in lanes, where nothing arrives in any. See
    /// [`PointLight::in_front`].
    #[cfg_attr(target_os = "none", inline(always))]
    #[cfg_attr(not(target_os = "none"), inline)]
    #[must_use]
    pub fn in_front(&self, p: Vec3<T>, n: UnitVec3<T>) -> Option<IncidentLight<T>> {
        self.narrowed_in_front(self.point.in_front(p, n)?)
    }

    /// What the cone leaves of the light at its tip.
    #[inline]
    fn narrowed(&self, incident: IncidentLight<T>) -> IncidentLight<T> {
        IncidentLight {
            intensity: incident.intensity * self.cone.factor(self.axis, incident.l),
            ..incident
        }
    }

    /// What the cone leaves of the light at its tip, or `None` where that is nothing.
    #[inline]
    fn narrowed_in_front(&self, incident: IncidentLight<T>) -> Option<IncidentLight<T>> {
        let is_inside = self.cone.factor(self.axis, incident.l).any_positive();
        is_inside.then(|| self.narrowed(incident))
    }

    /// The same light in another number type: `f` converts each number, and may do no more
    /// than round it.
    #[inline]
    #[must_use]
    pub fn cast<U>(self, mut f: impl FnMut(T) -> U) -> SpotLight<U> {
        SpotLight {
            point: self.point.cast(&mut f),
            axis: self.axis.cast(&mut f),
            cone: self.cone.cast(f),
        }
    }
}

impl<T: Real> Light<T> {
    /// The light that arrives at the point p.
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

    /// [`at`](Light::at) a point of a surface with the normal N, or `None` where nothing arrives at
    /// its front: sooner than `at`, and with the same sum. See [`PointLight::in_front`].
    #[cfg_attr(target_os = "none", inline(always))]
    #[cfg_attr(not(target_os = "none"), inline)]
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

    /// [`in_front`](Light::in_front) for each of a scene's lights. See [`PointLight::all_in_front`].
    #[inline]
    pub fn all_in_front(
        lights: &[Self],
        p: Vec3<T>,
        n: UnitVec3<T>,
    ) -> impl Iterator<Item = IncidentLight<T>> {
        let is_in_front = move |light: &Self| match light {
            Self::Directional(light) => n.dot(light.l).any_positive(),
            Self::Point(light) | Self::Spot(SpotLight { point: light, .. }) => {
                light.may_light(p, n)
            }
        };
        Filtered::by(is_in_front, lights).filter_map(move |light| light.in_front(p, n))
    }

    /// The same light in another number type: `f` converts each number, and may do no more
    /// than round it.
    #[inline]
    #[must_use]
    pub fn cast<U>(self, f: impl FnMut(T) -> U) -> Light<U> {
        match self {
            Self::Directional(light) => Light::Directional(light.cast(f)),
            Self::Point(light) => Light::Point(light.cast(f)),
            Self::Spot(light) => Light::Spot(light.cast(f)),
        }
    }
}

impl<T> From<DirectionalLight<T>> for Light<T> {
    #[inline]
    fn from(light: DirectionalLight<T>) -> Self {
        Self::Directional(light)
    }
}

impl<T> From<PointLight<T>> for Light<T> {
    #[inline]
    fn from(light: PointLight<T>) -> Self {
        Self::Point(light)
    }
}

impl<T> From<SpotLight<T>> for Light<T> {
    #[inline]
    fn from(light: SpotLight<T>) -> Self {
        Self::Spot(light)
    }
}
