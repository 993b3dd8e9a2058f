//! One point, its lights in lanes.

use kit::digest::{Each, Fnv};
use kit::places::places;
use kit::{Float, Given};
use shading::{
    IncidentLight, Lanes, Lobe, Material, PointLight, Real, Rgb, Shaded, SpotLight, shade,
};
use wide::{f32x4, f32x8, f32x16, f64x2, f64x4, f64x8};

#[test]
fn bits_of_lights_in_lanes_are_as_pinned() {
    let lines = [
        ("f32x4", digest::<f32x4>()),
        ("f32x8", digest::<f32x8>()),
        ("f32x16", digest::<f32x16>()),
        ("f64x2", digest::<f64x2>()),
        ("f64x4", digest::<f64x4>()),
        ("f64x8", digest::<f64x8>()),
    ];
    let lines = lines.map(|(name, digest)| format!("{digest:016x} {name}"));
    crate::assert_pinned("lanes.txt", include_str!("lanes.txt"), lines.into_iter());
}

fn digest<L: Lanes<Lane: Float + Lobe<L>>>() -> u64 {
    let mut digest = Fnv::EMPTY;
    for given in places::<L::Lane>() {
        // lamps in a row, the last pack not full, and spots that differ in kind
        let mut row = L::Lane::ZERO;
        let lamps = [given.lamps[0]; 19].map(|lamp| {
            row = row + L::Lane::ONE;
            let intensity = Rgb::new(row, L::Lane::ONE, L::Lane::ONE / row);
            PointLight {
                position: given.a + given.b * row,
                intensity,
                ..lamp
            }
        });
        let spots = [
            given.spot,
            given.soft_spot,
            SpotLight {
                point: given.lamps[1],
                ..given.spot
            },
        ];
        let p = given.p.map(splat::<L>);
        let lamps = PointLight::packed::<L>(&lamps).map(|pack| pack.at(p));
        let spots = SpotLight::packed::<L>(&spots).map(|pack| pack.at(p));
        digest.absorb(Each([shaded(&given, lamps), shaded(&given, spots)]));
    }
    digest.0
}

fn splat<L: Lanes>(x: L::Lane) -> L {
    L::from_fn(|_| x)
}

fn shaded<L: Lanes<Lane: Float + Lobe<L>>>(
    given: &Given<L::Lane>,
    lights: impl Iterator<Item = IncidentLight<L>>,
) -> Shaded<L::Lane> {
    let (n, v) = (given.n.cast(splat::<L>), given.v.cast(splat));
    let material = Material {
        m: L::Lane::from(32.5),
        ..given.real
    }
    .cast(splat);
    let lit = lights.filter(|light| light.is_in_front(n));
    shade::blinn_phong(n, v, &material, given.rgb.map(splat), lit).sum_of_lanes()
}
