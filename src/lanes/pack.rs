//! Packs lights into lanes: a pack is a light over lanes, and every formula takes it as such.

use super::Lanes;
use crate::color::Rgb;
use crate::light::{Attenuation, Cone, DirectionalLight, PointLight, SpotLight};
use crate::number::Real;
use crate::vector::{UnitVec3, Vec3};

/// What is made of numbers, over lanes: gathered from that of each lane.
trait Gather<Lane> {
    fn gather(lane: &impl Fn(usize) -> Lane) -> Self;
}

impl<L: Lanes> Gather<L::Lane> for L {
    #[inline]
    fn gather(lane: &impl Fn(usize) -> L::Lane) -> Self {
        L::from_fn(lane)
    }
}

impl<L: Lanes> Gather<UnitVec3<L::Lane>> for UnitVec3<L> {
    #[inline]
    fn gather(lane: &impl Fn(usize) -> UnitVec3<L::Lane>) -> Self {
        Self::assume_unit(Gather::gather(&|i| *lane(i)))
    }
}

macro_rules! gather {
    ($($type:ident { $($field:ident),+ })*) => {$(
        impl<L: Lanes> Gather<$type<L::Lane>> for $type<L> {
            #[inline]
            fn gather(lane: &impl Fn(usize) -> $type<L::Lane>) -> Self {
                Self { $($field: Gather::gather(&|i| lane(i).$field)),+ }
            }
        }
    )*};
}

gather! {
    Vec3 { x, y, z }
    Rgb { r, g, b }
    Attenuation { a, b, c, limit, range, squared }
    Cone { inner, outer, smooth }
    DirectionalLight { l, intensity }
    PointLight { position, intensity, attenuation }
    SpotLight { point, axis, cone }
}

macro_rules! packed {
    ($($(#[$doc:meta])* $light:ident: $($intensity:ident).+;)*) => {$(
        impl<T: Real> $light<T> {
            $(#[$doc])*
            #[inline]
            pub fn packed<L: Lanes<Lane = T>>(lights: &[Self]) -> impl Iterator<Item = $light<L>> {
                lights.chunks(L::COUNT).filter_map(|lights| {
                    // black copies of the first are in front of a surface only if it is
                    let mut black = *lights.first()?;
                    black.$($intensity).+ = Rgb::BLACK;
                    Some(Gather::gather(&|i| *lights.get(i).unwrap_or(&black)))
                })
            }
        }
    )*};
}

packed! {
    /// These lights in lanes, to shade one point with several at once. See [`PointLight::packed`].
    DirectionalLight: intensity;

    /// These lights in lanes, to shade one point with several at once. Pack them once, then shade
    /// every point with the packs. The lights keep their order, and black lights fill the last pack.
    ///
    /// The point is the same in each lane, and [`Shaded::sum_of_lanes`](crate::Shaded::sum_of_lanes)
    /// adds the lanes up:
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
    /// let lit = packs.iter().map(|pack| pack.at(p8));
    /// let shaded = shade::blinn_phong(n8, v8, &clay8, i_a.map(f32x8::splat), lit).sum_of_lanes();
    ///
    /// let alone = shade::blinn_phong(n, v, &clay, i_a, lamps.iter().map(|lamp| lamp.at(p)));
    /// assert_eq!(shaded.ambient, alone.ambient);
    /// assert!((shaded.diffuse.g - alone.diffuse.g).abs() < 1e-6);
    /// ```
    PointLight: intensity;

    /// These lights in lanes, to shade one point with several at once. See [`PointLight::packed`].
    SpotLight: point.intensity;
}
