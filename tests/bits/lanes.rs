//! One point, its lights in lanes.

use shading::{Exponent, Lanes, Light, Material, PointLight, Rgb, Shaded, shade};
use wide::{f32x4, f32x8, f32x16, f64x4, f64x8};

use functions::digest::Fnv;
use functions::places::places;
use functions::{Each, Float, Given};

const PINNED: &str = include_str!("lanes.txt");

#[test]
fn bits_of_lights_in_lanes_are_as_pinned() {
    let lines = [
        ("f32x4", digest::<f32x4>()),
        ("f32x8", digest::<f32x8>()),
        ("f32x16", digest::<f32x16>()),
        ("f64x4", digest::<f64x4>()),
        ("f64x8", digest::<f64x8>()),
    ];
    let lines = lines.map(|(name, digest)| format!("{digest:016x} {name}"));
    crate::assert_pinned("lanes.txt", PINNED, lines.into_iter());
}

fn digest<L: Lanes>() -> u64
where
    L::Lane: Float + Exponent<L>,
{
    let mut digest = Fnv::EMPTY;
    for given in places() {
        digest.absorb(Each(
            Light::packed(&given.lights).map(|pack| shaded::<L>(&given, [pack])),
        ));
        let lamps = lamps(&given);
        digest.absorb(shaded::<L>(
            &given,
            PointLight::packed(&lamps).map(Light::Point),
        ));
    }
    digest.0
}

/// Lamps in a row, the last pack not full.
fn lamps<T: Float>(given: &Given<T>) -> [PointLight<T>; 19] {
    let mut row = T::ZERO;
    [given.lamps[0]; 19].map(|lamp| {
        row = row + T::ONE;
        PointLight {
            position: given.a + given.b * row,
            intensity: Rgb::new(row, T::ONE, T::ONE / row),
            ..lamp
        }
    })
}

fn shaded<L: Lanes>(
    given: &Given<L::Lane>,
    packs: impl IntoIterator<Item = Light<L>>,
) -> Shaded<L::Lane>
where
    L::Lane: Float + Exponent<L>,
{
    let splat = |x| L::from_fn(|_| x);
    let (p, n, v) = (given.p.map(splat), given.n.cast(splat), given.v.cast(splat));
    let material = Material {
        m: L::Lane::from(32.5),
        ..given.real
    }
    .cast(splat);
    let lit = packs.into_iter().filter_map(|pack| pack.in_front(p, n));
    shade::blinn_phong(n, v, &material, given.rgb.map(splat), lit).sum_of_lanes()
}
