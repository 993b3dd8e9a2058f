//! Lights in lanes.

use shading::{DirectionalLight, Lanes, Light, PointLight, Rgb, Shaded, SpotLight};
use wide::{f32x4, f32x8, f32x16, f64x4, f64x8};

#[test]
fn lanes() {
    type Lane = <f32x4 as Lanes>::Lane;
    let counts = [
        <f32x4 as Lanes>::COUNT,
        <f32x8 as Lanes>::COUNT,
        <f32x16 as Lanes>::COUNT,
        <f64x4 as Lanes>::COUNT,
        <f64x8 as Lanes>::COUNT,
    ];
    assert_eq!(counts, [4, 8, 16, 4, 8]);
    let twos = <f32x4 as Lanes>::from_fn(|_| 2.0);
    let first: Lane = <f32x4 as Lanes>::first(twos);
    assert_eq!((first, <f32x4 as Lanes>::sum(twos)), (2.0, 8.0));

    assert_eq!(
        DirectionalLight::packed::<f32x4>(&[] as &[DirectionalLight]).count(),
        0
    );
    assert_eq!(PointLight::packed::<f32x4>(&[] as &[PointLight]).count(), 0);
    assert_eq!(SpotLight::packed::<f32x4>(&[] as &[SpotLight]).count(), 0);
    assert_eq!(Light::packed::<f32x4>(&[] as &[Light]).count(), 0);
    let shaded = Shaded {
        diffuse: Rgb::gray(twos),
        ..Shaded::default()
    };
    assert_eq!(Shaded::sum_of_lanes(shaded).diffuse, Rgb::gray(8.0));
}
