//! Computing the highlights of four lights at a time does not change a single bit of any sum.

use proptest::collection::vec;
use proptest::prelude::*;
use shading::{Exponent, IncidentLight, Material, Rgb, UnitVec3, Vec3, reflection, shade, term};

/// A user's own shininess that implements only what it must: its powers are computed one by one.
#[derive(Clone, Copy)]
struct Own(f32);

impl Exponent<f32> for Own {
    fn raise(self, cosine: f32) -> f32 {
        self.0.raise(cosine)
    }
}

fn direction() -> impl Strategy<Value = UnitVec3<f32>> {
    [-1.0_f32..1.0, -1.0..1.0, -1.0..1.0].prop_map(|v| Vec3::from(v).unit_or(UnitVec3::Z))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(5_000))]

    /// Any number of lights, about half of them behind the surface.
    #[test]
    fn four_at_once(
        (n, v) in (direction(), direction()),
        lights in vec((direction(), [0.0_f32..2.0, 0.0..2.0, 0.0..2.0]), 0..20),
        m in prop_oneof![0.0_f32..4.0, 0.0_f32..500.0],
    ) {
        let [k_a, k_d, k_s] = [0.125, 0.5, 1.0].map(Rgb::gray);
        let four = Material { k_a, k_d, k_s, m };
        let own = Material { k_a, k_d, k_s, m: Own(m) };
        let lights = lights.into_iter().map(|(l, intensity)| IncidentLight {
            l,
            intensity: Rgb::from(intensity),
            distance: f32::MAX,
        });

        let phong = shade::phong(n, v, &four, Rgb::WHITE, lights.clone());
        prop_assert_eq!(phong, shade::phong(n, v, &own, Rgb::WHITE, lights.clone()));
        let mut by_hand = Rgb::BLACK;
        for IncidentLight { l, intensity, .. } in lights.clone() {
            if term::lambert(n, l) > 0.0 {
                by_hand += intensity * term::phong(reflection(n, l), v, m);
            }
        }
        prop_assert_eq!(phong.specular, by_hand);

        // each light on its own, added in order
        let blinn = shade::blinn_phong(n, v, &four, Rgb::WHITE, lights.clone());
        let mut one_by_one = Rgb::BLACK;
        for light in lights.clone() {
            one_by_one += shade::blinn_phong(n, v, &four, Rgb::BLACK, [light]).specular;
        }
        prop_assert_eq!(blinn.specular, one_by_one);

        // 2⁻²² for each of the two powers; the root for the user's exponent rounds by 2⁻²⁴, m times
        let own = shade::blinn_phong(n, v, &own, Rgb::WHITE, lights.clone());
        let light: f32 = lights.map(|light| light.intensity.r).sum();
        let tolerance = (8.0 + m) * light * f32::EPSILON + f32::MIN_POSITIVE;
        prop_assert!((blinn.specular.r - own.specular.r).abs() <= tolerance);
    }
}
