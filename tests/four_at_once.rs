//! Raising the highlights of four lights at a time changes no sum, not by a bit.

use proptest::collection::vec;
use proptest::prelude::*;
use shading::{Exponent, IncidentLight, Material, Rgb, UnitVec3, Vec3, shade};

/// A real shininess that leaves [`Exponent::FOUR_AT_ONCE`] as it is for all but the crate's own.
#[derive(Clone, Copy)]
struct OneByOne(f32);

impl Exponent<f32> for OneByOne {
    fn raise(self, cosine: f32) -> f32 {
        self.0.raise(cosine)
    }

    fn raise_root(self, square: f32) -> f32 {
        self.0.raise_root(square)
    }
}

fn direction() -> impl Strategy<Value = UnitVec3<f32>> {
    [-1.0_f32..1.0, -1.0..1.0, -1.0..1.0].prop_map(|v| Vec3::from(v).unit_or(UnitVec3::Z))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(5_000))]

    /// With every number of lights, of which about half are behind the surface.
    #[test]
    fn four_at_once(
        (n, v) in (direction(), direction()),
        lights in vec((direction(), [0.0_f32..2.0, 0.0..2.0, 0.0..2.0]), 0..20),
        m in prop_oneof![0.0_f32..4.0, 0.0_f32..500.0],
    ) {
        let [k_a, k_d, k_s] = [0.125, 0.5, 0.75].map(Rgb::gray);
        let four = Material { k_a, k_d, k_s, m };
        let one = Material { k_a, k_d, k_s, m: OneByOne(m) };
        let lights = lights
            .into_iter()
            .map(|(l, intensity)| IncidentLight {
                l,
                intensity: Rgb::from(intensity),
                distance: f32::MAX,
            });
        prop_assert_eq!(
            shade::blinn_phong(n, v, &four, Rgb::WHITE, lights.clone()),
            shade::blinn_phong(n, v, &one, Rgb::WHITE, lights.clone())
        );
        prop_assert_eq!(
            shade::phong(n, v, &four, Rgb::WHITE, lights.clone()),
            shade::phong(n, v, &one, Rgb::WHITE, lights)
        );
    }
}
