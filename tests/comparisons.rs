//! Approximate comparison with the crate `approx` checks every component, and its defaults mean the
//! same as for floats.

use approx::{AbsDiffEq, RelativeEq, UlpsEq};
use shading::{IncidentLight, Rgb, Shaded, UnitVec3, Vec3};

#[test]
fn vectors_are_compared_in_every_coordinate() {
    looks_at_every_component(Vec3::from);
}

#[test]
fn directions_are_compared_in_every_coordinate() {
    looks_at_every_component(|xyz| UnitVec3::assume_unit(Vec3::from(xyz)));
}

#[test]
fn colors_are_compared_in_every_channel() {
    looks_at_every_component(Rgb::from);
}

#[test]
fn incident_lights_are_compared_in_every_number() {
    looks_at_every_component(|[x, y, z, r, g, b, distance]| IncidentLight {
        l: UnitVec3::assume_unit(Vec3::new(x, y, z)),
        intensity: Rgb::new(r, g, b),
        distance,
    });
}

#[test]
fn results_are_compared_in_every_part() {
    looks_at_every_component(|[a, b, c, d, e, f, g, h, i]| Shaded {
        ambient: Rgb::new(a, b, c),
        diffuse: Rgb::new(d, e, f),
        specular: Rgb::new(g, h, i),
    });
}

fn looks_at_every_component<V, const N: usize>(value: impl Fn([f64; N]) -> V)
where
    V: AbsDiffEq<Epsilon = f64> + RelativeEq + UlpsEq,
{
    let one = value([1.0; N]);
    for i in 0..N {
        let with = |component: f64| {
            let mut components = [1.0; N];
            components[i] = component;
            value(components)
        };
        assert!(one.abs_diff_eq(&with(1.5), 0.5));
        assert!(!one.abs_diff_eq(&with(1.5), 0.25));
        // they differ by 1, which is half of 2
        assert!(one.relative_eq(&with(2.0), 0.0, 0.5));
        assert!(!one.relative_eq(&with(2.0), 0.0, 0.25));
        let three_up = with(1.0 + 3.0 * f64::EPSILON);
        assert!(one.ulps_eq(&three_up, 0.0, 3));
        assert!(!one.ulps_eq(&three_up, 0.0, 2));
    }
    assert!(V::default_epsilon().eq(&f64::default_epsilon()));
    assert!(V::default_max_relative().eq(&f64::default_max_relative()));
    assert_eq!(V::default_max_ulps(), f64::default_max_ulps());
}
