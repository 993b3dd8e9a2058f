//! Packs lights into lanes: a pack is a light over lanes, and every formula takes it as such.

use core::iter;

use super::{Lanes, MOST};
use crate::attenuation::Falloff;
use crate::cone::Beam;
use crate::light::{DirectionalLight, Light, PointLight, SpotLight};
use crate::real::Real;
use crate::rgb::Rgb;

/// A light, whatever its kind.
trait Pack<T: Real>: Copy {
    type In<U>;

    fn cast<U: Real>(self, f: impl FnMut(T) -> U) -> Self::In<U>;

    /// The same light, black: it adds nothing to a sum.
    fn black(self) -> Self;

    /// The k-th of its numbers, in the order of `cast`.
    #[inline]
    fn number(self, k: usize) -> T {
        let (mut i, mut number) = (0, T::ZERO);
        self.cast(|x| {
            if i == k {
                number = x;
            }
            i += 1;
            x
        });
        number
    }
}

/// Packs of lights that are alike: of one kind, and equal in everything but their numbers.
#[inline]
fn packs<T: Real, L: Lanes<Lane = T>, K: Pack<T>>(lights: &[K]) -> impl Iterator<Item = K::In<L>>
where
    K::In<T>: PartialEq,
{
    let alike = |a: &K, b: &K| a.cast(|_| T::ZERO) == b.cast(|_| T::ZERO);
    let kinds = lights.iter().enumerate().filter(move |(place, light)| {
        let mut before = lights.iter().take(*place);
        !before.any(|other| alike(other, light))
    });
    kinds.flat_map(move |(place, kind)| {
        let others = lights.iter().skip(place + 1);
        let others = others.filter(move |light| alike(light, kind));
        let mut of_this_kind = iter::once(kind).chain(others);
        iter::from_fn(move || pack(&mut of_this_kind))
    })
}

/// The next lights, one in each lane. The remaining lanes hold black copies of the first light, which
/// are in front of a surface only if it is.
#[inline]
fn pack<'a, T: Real, L: Lanes<Lane = T>, K: Pack<T> + 'a>(
    lights: &mut impl Iterator<Item = &'a K>,
) -> Option<K::In<L>> {
    const { assert!(L::COUNT <= MOST) };
    let first = lights.next()?;
    let mut lanes = [first.black(); MOST];
    let some = iter::once(first).chain(lights);
    for (lane, light) in lanes.iter_mut().zip(some.take(L::COUNT)) {
        *lane = *light;
    }
    let mut numbers = 0..;
    Some(first.cast(|_| {
        let k = numbers.next().unwrap_or_default();
        L::from_fn(|i| lanes[i % MOST].number(k))
    }))
}

impl<T: Real> Pack<T> for DirectionalLight<T> {
    type In<U> = DirectionalLight<U>;

    #[inline]
    fn cast<U: Real>(self, f: impl FnMut(T) -> U) -> DirectionalLight<U> {
        self.cast(f)
    }

    #[inline]
    fn black(self) -> Self {
        let intensity = Rgb::BLACK;
        Self { intensity, ..self }
    }
}

impl<T: Real, A: Falloff<T>> Pack<T> for PointLight<T, A> {
    type In<U> = PointLight<U, A::In<U>>;

    #[inline]
    fn cast<U: Real>(self, f: impl FnMut(T) -> U) -> PointLight<U, A::In<U>> {
        self.cast(f)
    }

    #[inline]
    fn black(self) -> Self {
        let intensity = Rgb::BLACK;
        Self { intensity, ..self }
    }
}

impl<T: Real, C: Beam<T>, A: Falloff<T>> Pack<T> for SpotLight<T, C, A> {
    type In<U> = SpotLight<U, C::In<U>, A::In<U>>;

    #[inline]
    fn cast<U: Real>(self, f: impl FnMut(T) -> U) -> SpotLight<U, C::In<U>, A::In<U>> {
        self.cast(f)
    }

    #[inline]
    fn black(self) -> Self {
        let point = self.point.black();
        Self { point, ..self }
    }
}

impl<T: Real, C: Beam<T>, A: Falloff<T>> Pack<T> for Light<T, C, A> {
    type In<U> = Light<U, C::In<U>, A::In<U>>;

    #[inline]
    fn cast<U: Real>(self, f: impl FnMut(T) -> U) -> Light<U, C::In<U>, A::In<U>> {
        self.cast(f)
    }

    #[inline]
    fn black(self) -> Self {
        match self {
            Self::Directional(light) => light.black().into(),
            Self::Point(light) => light.black().into(),
            Self::Spot(light) => light.black().into(),
        }
    }
}

impl<T: Real + PartialEq> DirectionalLight<T> {
    /// These lights in lanes, to shade one point with several at once. See [`PointLight::packed`].
    ///
    /// ```
    /// use shading::f32::{DirectionalLight, Rgb, UnitVec3};
    /// use wide::f32x4;
    ///
    /// let sun = DirectionalLight { l: UnitVec3::Z, intensity: Rgb::WHITE };
    /// let pack = DirectionalLight::packed::<f32x4>(&[sun, sun, sun]).next().unwrap();
    /// assert_eq!(pack.intensity.r.to_array(), [1.0, 1.0, 1.0, 0.0]);
    /// ```
    #[inline]
    pub fn packed<L: Lanes<Lane = T>>(
        lights: &[Self],
    ) -> impl Iterator<Item = DirectionalLight<L>> {
        packs(lights)
    }
}

impl<T: Real + PartialEq, A: Falloff<T, In<T>: PartialEq>> PointLight<T, A> {
    /// These lights in lanes, to shade one point with several lights at once. Pack them once, then shade
    /// every point with the packs.
    ///
    /// The lights keep their order, and black lights fill the last pack. Lights that differ in more than
    /// numbers do not share a pack: one with a [clamped](crate::Attenuation::clamped) attenuation and one
    /// without, for example.
    ///
    /// The point is the same in each lane, and [`Shaded::sum_of_lanes`](crate::Shaded::sum_of_lanes) adds the lanes up:
    ///
    /// ```
    /// use shading::f32::{Attenuation, Material, PointLight, Rgb, UnitVec3, Vec3};
    /// use shading::shade;
    /// use wide::f32x8;
    ///
    /// let lamp = |i: u8| PointLight {
    ///     position: Vec3::new(f32::from(i) - 4.0, 0.0, 3.0),
    ///     intensity: Rgb::WHITE,
    ///     attenuation: Attenuation::NONE,
    /// };
    /// let lamps: Vec<_> = (0..10).map(lamp).collect();
    /// let clay = Material { k_a: Rgb::gray(0.1), k_d: Rgb::gray(0.5), k_s: Rgb::gray(0.2), m: 32 };
    /// let i_a = Rgb::WHITE;
    ///
    /// // once a scene
    /// let packs: Vec<_> = PointLight::packed::<f32x8>(&lamps).collect();
    /// assert_eq!(packs.len(), 2); // of eight and of two
    /// let clay8 = clay.cast(f32x8::splat);
    ///
    /// // at each point
    /// let (p, n, v) = (Vec3::ZERO, UnitVec3::Z, UnitVec3::Z);
    /// let (p8, n8, v8) = (p.map(f32x8::splat), n.cast(f32x8::splat), v.cast(f32x8::splat));
    /// let lit = packs.iter().filter_map(|pack| pack.in_front(p8, n8));
    /// let shaded = shade::blinn_phong(n8, v8, &clay8, i_a.map(f32x8::splat), lit).sum_of_lanes();
    ///
    /// let alone = shade::blinn_phong(n, v, &clay, i_a, lamps.iter().map(|lamp| lamp.at(p)));
    /// assert_eq!(shaded.ambient, alone.ambient);
    /// assert!((shaded.diffuse.g - alone.diffuse.g).abs() < 1e-6);
    /// ```
    ///
    /// Without allocation, keep the packs in an array:
    ///
    /// ```
    /// use shading::f32::{Attenuation, PointLight, Rgb, Vec3};
    /// use wide::f32x4;
    ///
    /// const LAMP: PointLight =
    ///     PointLight { position: Vec3::ZERO, intensity: Rgb::WHITE, attenuation: Attenuation::NONE };
    /// const LAMPS: [PointLight; 6] = [LAMP; 6];
    ///
    /// let mut packs = PointLight::packed::<f32x4>(&LAMPS);
    /// let packs: [_; LAMPS.len().div_ceil(4)] = std::array::from_fn(|_| packs.next().unwrap());
    /// assert_eq!(packs[1].intensity.r.to_array(), [1.0, 1.0, 0.0, 0.0]);
    /// ```
    #[inline]
    pub fn packed<L: Lanes<Lane = T>>(
        lights: &[Self],
    ) -> impl Iterator<Item = PointLight<L, A::In<L>>> {
        packs(lights)
    }
}

impl<T: Real + PartialEq, C: Beam<T, In<T>: PartialEq>, A: Falloff<T, In<T>: PartialEq>>
    SpotLight<T, C, A>
{
    /// These lights in lanes, to shade one point with several at once. See [`PointLight::packed`].
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
    /// let pack = SpotLight::packed::<f32x4>(&[spot; 3]).next().unwrap();
    /// assert_eq!(pack.point.intensity.r.to_array(), [1.0, 1.0, 1.0, 0.0]);
    /// ```
    #[inline]
    pub fn packed<L: Lanes<Lane = T>>(
        lights: &[Self],
    ) -> impl Iterator<Item = SpotLight<L, C::In<L>, A::In<L>>> {
        packs(lights)
    }
}

impl<T: Real + PartialEq, C: Beam<T, In<T>: PartialEq>, A: Falloff<T, In<T>: PartialEq>>
    Light<T, C, A>
{
    /// These lights in lanes, to shade one point with several at once. See [`PointLight::packed`].
    ///
    /// A pack holds lights of one kind, so each kind may have a pack that is not full:
    ///
    /// ```
    /// use shading::Light;
    /// use shading::f32::{Attenuation, DirectionalLight, PointLight, Rgb, UnitVec3, Vec3};
    /// use wide::f32x4;
    ///
    /// let sun: Light = DirectionalLight { l: UnitVec3::Z, intensity: Rgb::WHITE }.into();
    /// let position = Vec3::new(0.0, 0.0, 2.0);
    /// let lamp = PointLight { position, intensity: Rgb::WHITE, attenuation: Attenuation::NONE }.into();
    ///
    /// let lights = [lamp, sun, lamp];
    /// let mut packs = Light::packed::<f32x4>(&lights);
    /// assert!(matches!(packs.next(), Some(Light::Point(_)))); // two lamps
    /// assert!(matches!(packs.next(), Some(Light::Directional(_)))); // the sun
    /// assert!(packs.next().is_none());
    /// ```
    #[inline]
    pub fn packed<L: Lanes<Lane = T>>(
        lights: &[Self],
    ) -> impl Iterator<Item = Light<L, C::In<L>, A::In<L>>> {
        packs(lights)
    }
}
