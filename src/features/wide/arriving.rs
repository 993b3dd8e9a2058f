//! What the lights of a slice give at one point, several of them at a time.

use super::Lanes;
use super::gather::{Gather, choice, first};
use crate::attenuation::Falloff;
use crate::cone::Beam;
use crate::light::{DirectionalLight, IncidentLight, Light, Lights, PointLight, SpotLight};
use crate::real::Real;
use crate::rgb::Rgb;
use crate::unit::UnitVec3;
use crate::vector::Vec3;

/// A light, whatever its kind.
trait Kind<L: Lanes> {
    fn at(&self, p: Vec3<L::Lane>) -> IncidentLight<L::Lane>;

    /// What these lights give at p, or `None` if they differ in a way that lanes cannot have.
    fn together<'a>(light: impl Fn(usize) -> &'a Self, p: Vec3<L>) -> Option<IncidentLight<L>>
    where
        Self: 'a;
}

/// Lights at one point, several at a time: an iterator over [`IncidentLight`] in lanes.
///
/// The [sums](crate::shade) add the lanes up one after another, in order, so they have the bits of a
/// sum over the lights one by one, if the intensities are finite. The point, N, V and the material
/// are those of one point:
///
/// ```
/// use shading::f32::{Attenuation, Material, PointLight, Rgb, UnitVec3, Vec3};
/// use shading::{InLanes, shade};
/// use wide::f32x4;
///
/// let lamp = |x| PointLight {
///     position: Vec3::new(x, 0.0, 3.0),
///     intensity: Rgb::WHITE,
///     attenuation: Attenuation::NONE,
/// };
/// let lamps = [lamp(-1.0), lamp(0.0), lamp(2.0)];
/// let clay = Material { k_a: Rgb::gray(0.1), k_d: Rgb::gray(0.5), k_s: Rgb::gray(0.2), m: 32 };
/// let (p, n, v) = (Vec3::ZERO, UnitVec3::Z, UnitVec3::Z);
///
/// let p4 = p.map(f32x4::splat);
/// let packs = PointLight::packed::<f32x4>(&lamps).map(|pack| pack.at(p4));
/// let shaded = shade::phong(n, v, &clay, Rgb::WHITE, InLanes(packs));
/// assert_eq!(shaded, shade::phong(n, v, &clay, Rgb::WHITE, lamps.map(|lamp| lamp.at(p))));
/// ```
///
/// To leave a light out, such as one in shadow, make its lane black, as
/// [`Shaded::sum_of_lanes`](crate::Shaded::sum_of_lanes) shows.
#[derive(Clone, Copy, Debug)]
pub struct InLanes<I>(pub I);

impl<L: Lanes, I: Iterator<Item = IncidentLight<L>>> Lights<L::Lane> for InLanes<I> {
    type Number = L;

    #[inline(always)]
    fn arriving(self) -> impl Iterator<Item = IncidentLight<L>> {
        self.0
    }
}

/// Lanes of what the lights give, in their order. The last lanes may be black.
struct Arriving<'a, L: Lanes, K> {
    lights: &'a [K],
    p: Vec3<L::Lane>,
}

impl<L: Lanes, K: Kind<L>> Iterator for Arriving<'_, L, K> {
    type Item = IncidentLight<L>;

    #[inline(always)]
    fn next(&mut self) -> Option<IncidentLight<L>> {
        if let Some((lights, rest)) = self.lights.split_at_checked(L::COUNT) {
            self.lights = rest;
            let together = K::together(|i| &lights[i], self.p.map(L::in_each));
            Some(together.unwrap_or_else(|| one_by_one(lights, self.p)))
        } else if self.lights.is_empty() {
            None
        } else {
            let lights = core::mem::take(&mut self.lights);
            Some(last(lights, self.p))
        }
    }

    // the whole loop in one place, where the lanes stay in registers
    #[inline(always)]
    fn fold<B, F: FnMut(B, IncidentLight<L>) -> B>(self, mut sum: B, mut f: F) -> B {
        for lights in self {
            sum = f(sum, lights);
        }
        sum
    }
}

/// Fewer lights than there are lanes: the rest are black copies of the first.
#[inline(never)]
fn last<L: Lanes, K: Kind<L>>(lights: &[K], p: Vec3<L::Lane>) -> IncidentLight<L> {
    let in_lanes = p.map(L::in_each);
    let together = lights
        .first()
        .and_then(|first| K::together(|i| lights.get(i).unwrap_or(first), in_lanes));
    let Some(arriving) = together else {
        return one_by_one(lights, p);
    };
    let is_light = choice::<L>(|i| i < lights.len());
    let intensity = arriving.intensity.map(|c| is_light.if_positive(c, L::ZERO));
    IncidentLight {
        intensity,
        ..arriving
    }
}

/// Lights of which some are clamped and some are not, for example.
#[cold]
#[inline(never)]
fn one_by_one<L: Lanes, K: Kind<L>>(lights: &[K], p: Vec3<L::Lane>) -> IncidentLight<L> {
    let sun = DirectionalLight {
        l: UnitVec3::X,
        intensity: Rgb::BLACK,
    };
    let mut arriving = [sun.at(p); super::MOST];
    for (arriving, light) in arriving.iter_mut().zip(lights) {
        *arriving = light.at(p);
    }
    let lanes =
        |x: fn(&IncidentLight<L::Lane>) -> L::Lane| L::from_fn(|i| x(&arriving[i % super::MOST]));
    IncidentLight {
        l: UnitVec3::assume_unit(Vec3::new(
            lanes(|light| light.l.x),
            lanes(|light| light.l.y),
            lanes(|light| light.l.z),
        )),
        intensity: Rgb::new(
            lanes(|light| light.intensity.r),
            lanes(|light| light.intensity.g),
            lanes(|light| light.intensity.b),
        ),
        distance: lanes(|light| light.distance),
    }
}

impl<L: Lanes, A> Kind<L> for PointLight<L::Lane, A>
where
    A: Falloff<L::Lane> + Gather<L, Gathered: Falloff<L>>,
{
    #[inline(always)]
    fn at(&self, p: Vec3<L::Lane>) -> IncidentLight<L::Lane> {
        self.at(p)
    }

    #[inline(always)]
    fn together<'a>(light: impl Fn(usize) -> &'a Self, p: Vec3<L>) -> Option<IncidentLight<L>>
    where
        Self: 'a,
    {
        // the position first, because lanes with the other numbers would have to wait in memory
        let [x, y, z, r] = L::columns(|i| {
            let (at, color) = (light(i).position, light(i).intensity);
            [at.x, at.y, at.z, color.r]
        });
        let position = Vec3::new(x, y, z);
        let to_light = (position - p).into();
        let (l, q, distance) = L::direction_and_distance(|| [position.into(), p.into()], to_light);
        let [g, b, _, _] = L::columns(|i| {
            let color = light(i).intensity;
            [color.g, color.b, color.g, color.b]
        });
        let light = PointLight {
            position,
            intensity: Rgb::new(r, g, b),
            attenuation: A::gather(|i| &light(i).attenuation)?,
        };
        Some(light.along_way(p, l, q, distance))
    }
}

impl<L: Lanes, C, A> Kind<L> for SpotLight<L::Lane, C, A>
where
    C: Beam<L::Lane> + Gather<L, Gathered: Beam<L>>,
    A: Falloff<L::Lane> + Gather<L, Gathered: Falloff<L>>,
{
    #[inline(always)]
    fn at(&self, p: Vec3<L::Lane>) -> IncidentLight<L::Lane> {
        self.at(p)
    }

    #[inline(always)]
    fn together<'a>(light: impl Fn(usize) -> &'a Self, p: Vec3<L>) -> Option<IncidentLight<L>>
    where
        Self: 'a,
    {
        let mut arriving = PointLight::together(|i| &light(i).point, p)?;
        let axis = UnitVec3::gather(|i| &light(i).axis)?;
        let cone = C::gather(|i| &light(i).cone)?;
        arriving.intensity *= cone.factor(axis, arriving.l);
        Some(arriving)
    }
}

impl<L: Lanes, C, A> Kind<L> for Light<L::Lane, C, A>
where
    C: Beam<L::Lane> + Gather<L, Gathered: Beam<L>>,
    A: Falloff<L::Lane> + Gather<L, Gathered: Falloff<L>>,
{
    #[inline(always)]
    fn at(&self, p: Vec3<L::Lane>) -> IncidentLight<L::Lane> {
        self.at(p)
    }

    /// What is computed of one kind is computed of every light, and used where the light is of that kind. The
    /// others take the numbers of the first light of that kind meanwhile.
    #[inline(always)]
    fn together<'a>(light: impl Fn(usize) -> &'a Self, p: Vec3<L>) -> Option<IncidentLight<L>>
    where
        Self: 'a,
    {
        let point = |i| match light(i) {
            Self::Point(point) | Self::Spot(SpotLight { point, .. }) => Some(point),
            Self::Directional(_) => None,
        };
        let spot = |i| match light(i) {
            Self::Spot(spot) => Some(spot),
            _ => None,
        };
        let sun = |i| match light(i) {
            Self::Directional(sun) => Some(sun),
            _ => None,
        };
        let suns = match first::<L, _>(sun) {
            Some(first) => Some(DirectionalLight::gather(|i| sun(i).unwrap_or(first))?.at(p)),
            None => None,
        };
        let Some(first_point) = first::<L, _>(point) else {
            return suns;
        };
        let mut arriving = PointLight::gather(|i| point(i).unwrap_or(first_point))?.at(p);
        if let Some(first) = first::<L, _>(spot) {
            let axis = UnitVec3::gather(|i| &spot(i).unwrap_or(first).axis)?;
            let cone = C::gather(|i| &spot(i).unwrap_or(first).cone)?;
            let factor = cone.factor(axis, arriving.l);
            let is_spot = choice::<L>(|i| spot(i).is_some());
            arriving.intensity *= is_spot.if_positive(factor, L::ONE);
        }
        let Some(suns) = suns else {
            return Some(arriving);
        };
        let is_sun = choice::<L>(|i| sun(i).is_some());
        let or = |a: L, b: L| is_sun.if_positive(a, b);
        let ([a, b], [i, j]) = ([suns.l, arriving.l], [suns.intensity, arriving.intensity]);
        Some(IncidentLight {
            l: UnitVec3::assume_unit(Vec3::new(or(a.x, b.x), or(a.y, b.y), or(a.z, b.z))),
            intensity: Rgb::new(or(i.r, j.r), or(i.g, j.g), or(i.b, j.b)),
            distance: or(suns.distance, arriving.distance),
        })
    }
}

impl<T: Real, A> PointLight<T, A> {
    /// What these lights give at the point p, several lights at a time, for a [sum](crate::shade) over many
    /// lights at one point.
    ///
    /// The sum adds the lights up in their order. Its bits are those of a sum over the lights one by one, if
    /// their intensities are finite. Nothing is packed in advance, so the lights may change at every point.
    ///
    /// ```
    /// use shading::f32::{Attenuation, Material, PointLight, Rgb, UnitVec3, Vec3};
    /// use shading::shade;
    /// use wide::f32x4;
    ///
    /// let lamp = |i: u8| PointLight {
    ///     position: Vec3::new(f32::from(i) - 4.0, 0.0, 3.0),
    ///     intensity: Rgb::WHITE,
    ///     attenuation: Attenuation::NONE,
    /// };
    /// let lamps: Vec<_> = (0..7).map(lamp).collect();
    /// let clay = Material { k_a: Rgb::gray(0.1), k_d: Rgb::gray(0.5), k_s: Rgb::gray(0.2), m: 32 };
    ///
    /// let (p, n, v) = (Vec3::ZERO, UnitVec3::Z, UnitVec3::Z);
    /// let lit = PointLight::all_at::<f32x4>(&lamps, p);
    /// let shaded = shade::blinn_phong(n, v, &clay, Rgb::WHITE, lit);
    ///
    /// let one_by_one = lamps.iter().map(|lamp| lamp.at(p));
    /// assert_eq!(shaded, shade::blinn_phong(n, v, &clay, Rgb::WHITE, one_by_one));
    /// ```
    ///
    /// Black copies of a light fill the last lanes.
    #[inline(always)]
    pub fn all_at<L: Lanes<Lane = T>>(
        lights: &[Self],
        p: Vec3<T>,
    ) -> InLanes<impl Iterator<Item = IncidentLight<L>>>
    where
        A: Falloff<T> + Gather<L, Gathered: Falloff<L>>,
    {
        InLanes(Arriving { lights, p })
    }
}

impl<T: Real, C, A> SpotLight<T, C, A> {
    /// What these lights give at the point p, several lights at a time. See [`PointLight::all_at`].
    ///
    /// ```
    /// use shading::f32::{Attenuation, Cone, PointLight, Rgb, SpotLight, UnitVec3, Vec3};
    /// use wide::f32x4;
    ///
    /// let spot = SpotLight {
    ///     point: PointLight { position: Vec3::ZERO, intensity: Rgb::WHITE, attenuation: Attenuation::NONE },
    ///     axis: UnitVec3::NEG_Z,
    ///     cone: Cone::from_cosine(0.5).unwrap(),
    /// };
    /// let spots = [spot, SpotLight { axis: UnitVec3::Z, ..spot }];
    /// let arriving = SpotLight::all_at::<f32x4>(&spots, Vec3::new(0.0, 0.0, -2.0)).0.next().unwrap();
    /// assert_eq!(arriving.intensity.r.to_array(), [1.0, 0.0, 0.0, 0.0]);
    /// ```
    #[inline(always)]
    pub fn all_at<L: Lanes<Lane = T>>(
        lights: &[Self],
        p: Vec3<T>,
    ) -> InLanes<impl Iterator<Item = IncidentLight<L>>>
    where
        C: Beam<T> + Gather<L, Gathered: Beam<L>>,
        A: Falloff<T> + Gather<L, Gathered: Falloff<L>>,
    {
        InLanes(Arriving { lights, p })
    }
}

impl<T: Real, C, A> Light<T, C, A> {
    /// What these lights give at the point p, several lights at a time. See [`PointLight::all_at`].
    ///
    /// Lights of different kinds share lanes. It is fastest if lights of a kind stand together.
    ///
    /// ```
    /// use shading::Light;
    /// use shading::f32::{Attenuation, DirectionalLight, PointLight, Rgb, UnitVec3, Vec3};
    /// use wide::f32x4;
    ///
    /// let sun: Light = DirectionalLight { l: UnitVec3::Z, intensity: Rgb::gray(0.5) }.into();
    /// let position = Vec3::new(0.0, 0.0, 2.0);
    /// let lamp = PointLight { position, intensity: Rgb::WHITE, attenuation: Attenuation::NONE }.into();
    ///
    /// let arriving = Light::all_at::<f32x4>(&[lamp, sun, lamp], Vec3::ZERO).0.next().unwrap();
    /// assert_eq!(arriving.intensity.g.to_array(), [1.0, 0.5, 1.0, 0.0]);
    /// assert_eq!(arriving.distance.to_array()[1], f32::MAX);
    /// ```
    #[inline(always)]
    pub fn all_at<L: Lanes<Lane = T>>(
        lights: &[Self],
        p: Vec3<T>,
    ) -> InLanes<impl Iterator<Item = IncidentLight<L>>>
    where
        C: Beam<T> + Gather<L, Gathered: Beam<L>>,
        A: Falloff<T> + Gather<L, Gathered: Falloff<L>>,
    {
        InLanes(Arriving { lights, p })
    }
}
