//! Skipping the lights behind a surface early does not change a single bit of any sum.

use proptest::collection::vec;
use proptest::prelude::*;
use shading::{
    Attenuation, Cone, DirectionalLight, IncidentLight, Light, Material, PointLight, Ranged, Rgb,
    SpotLight, UnitVec3, Vec3, shade,
};

fn vector() -> impl Strategy<Value = Vec3<f32>> {
    [-1.0_f32..1.0, -1.0..1.0, -1.0..1.0].prop_map(Vec3::from)
}

/// Powers of two, from those whose squares underflow to those whose squares overflow. Some are so
/// small that the components of a vector are a few units in the last place.
fn size() -> impl Strategy<Value = f32> {
    prop_oneof![4 => -10..10, 1 => -120..128, 1 => -149..-144]
        .prop_map(|power| libm::scalbnf(1.0, power))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(20_000))]

    /// The light is raised above the horizon, or lowered below it, by 2⁻³⁰ to 1 of its distance:
    /// both less and more than the rounding error.
    #[test]
    fn early_exit(
        (n, v, aside, p) in (vector(), vector(), vector(), vector()),
        (size, height, sign) in (size(), -30..0, prop_oneof![Just(-1.0_f32), Just(0.0), Just(1.0)]),
        axis in vector(),
    ) {
        let [n, v, axis] = [n, v, axis].map(|direction| direction.unit_or(UnitVec3::Z));
        let horizontal = n.cross(aside);
        let way = (horizontal + *n * (sign * 2.0_f32.powi(height))) * size;
        let point = PointLight {
            position: p * size + way,
            intensity: Rgb::new(1.0, 0.5, 2.0),
            attenuation: Attenuation::NONE,
        };
        let cone = Cone::<f32>::from_half_angle(1.0).unwrap();
        let lights = [Light::Point(point), Light::Spot(SpotLight { point, axis, cone })];
        let material = Material { k_a: Rgb::WHITE, k_d: Rgb::WHITE, k_s: Rgb::WHITE, m: 1 };

        let p = p * size;
        let all = lights.iter().map(|light| light.at(p));
        let lit = lights.iter().filter_map(|light| light.in_front(p, n));
        let incident_lit = all.clone().filter_map(|incident| incident.in_front(n));
        let shaded = shade::blinn_phong(n, v, &material, Rgb::BLACK, all);
        prop_assert_eq!(shaded, shade::blinn_phong(n, v, &material, Rgb::BLACK, lit));
        prop_assert_eq!(shaded, shade::blinn_phong(n, v, &material, Rgb::BLACK, incident_lit));
    }

    /// A light that passes the early exit is the light that arrives; one that does not is behind the
    /// surface or dark.
    #[test]
    fn in_front_leaves_out_only_what_adds_nothing(
        (n, p) in (vector(), vector()),
        lights in vec((vector(), vector(), 0..3), 0..20),
    ) {
        let n = n.unit_or(UnitVec3::Z);
        let point = |position| PointLight {
            position,
            intensity: Rgb::WHITE,
            attenuation: Attenuation::NONE,
        };
        let cone = Cone::<f32>::from_half_angle(1.0).unwrap();
        for (position, direction, kind) in lights {
            let (point, axis) = (point(position), direction.unit_or(UnitVec3::Z));
            let light: Light = match kind {
                0 => DirectionalLight { l: axis, intensity: Rgb::WHITE }.into(),
                1 => point.into(),
                _ => SpotLight { point, axis, cone }.into(),
            };
            let incident = light.at(p);
            match light.in_front(p, n) {
                Some(lit) => prop_assert_eq!(lit, incident),
                None => prop_assert!(
                    incident.in_front(n).is_none() || incident.intensity == Rgb::BLACK
                ),
            }
        }
    }

    /// The light stands within a few units in the last place of the end of its range. What would
    /// still arrive there, however faint, passes the early exit.
    #[test]
    fn end_of_a_range(
        (n, way) in (vector(), vector()),
        (size, share) in (size(), 1.0_f32..2.0),
        steps in prop::array::uniform3(-4..4_i32),
        is_squared: bool,
    ) {
        let [n, way] = [n, way].map(|direction| direction.unit_or(UnitVec3::Z));
        let range = size * share;
        let mut position: [f32; 3] = (*way * range).into();
        for (x, steps) in position.iter_mut().zip(steps) {
            *x = f32::from_bits(x.to_bits().saturating_add_signed(steps));
        }
        let attenuation = Ranged::of(Attenuation::NONE, range).unwrap();
        let light = PointLight {
            position: position.into(),
            intensity: Rgb::gray(f32::MAX),
            attenuation: if is_squared { attenuation } else { attenuation.unsquared() },
        };
        let adds = |light: &IncidentLight| light.intensity != Rgb::BLACK;
        let arriving = light.at(Vec3::ZERO).in_front(n);
        let lit = light.in_front(Vec3::ZERO, n).and_then(|light| light.in_front(n));
        prop_assert_eq!(lit.filter(adds), arriving.filter(adds));
    }
}
