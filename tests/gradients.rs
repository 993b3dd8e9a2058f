//! The gradients of the sums and of what they are made of, against differences in `f64`.

use approx::{assert_abs_diff_eq, assert_relative_eq};
use kit::{direction, rgb, vector};
use properties::{Scene, coefficients, cone, lamp, material, spot, sun};
use shading::{Dual, Elementary, Light, UnitVec3, Vec3, half_vector, normal, shade};

/// What moves with p: the direction to an eye, a bent normal, and all lights.
fn everything<T: Elementary + PartialOrd>(scene: &Scene<T>, p: Vec3<T>) -> Vec<T> {
    let v = (vector::<T>([3.0, -5.0, 9.0]) - p).unit_or(UnitVec3::Z);
    let n = (vector::<T>([0.0, 0.0, 4.0]) + p * T::of(0.25)).unit_or(UnitVec3::Z);
    let lights = || scene.lights.iter().map(|light| light.at(p));
    let sums = [
        shade::lambert(n, &scene.material, scene.ambient, lights()),
        shade::phong(n, v, &scene.material, scene.ambient, lights()),
        shade::blinn_phong(n, v, &scene.material, scene.ambient, lights()),
    ];
    let sums = sums
        .map(|s| [s.diffuse.r, s.diffuse.g, s.specular.b])
        .concat();
    let h = half_vector(n, v).map_or(Vec3::ZERO, |h| *h);
    let [b, c] = [[1.0, -2.0, 3.0], [3.0, 1.25, -0.75]].map(vector);
    let normals = [
        normal::sphere(p, Vec3::ZERO).map_or(Vec3::ZERO, |n| *n),
        normal::triangle(p, b, c).map_or(Vec3::ZERO, |n| *n),
        normal::corner(b, p, c),
        normal::transformed(n, [b, p, c]).map_or(Vec3::ZERO, |n| *n),
        h,
    ];
    let functions = [
        p.x.sin(),
        p.y.cos(),
        p.z.exp(),
        (p.x * p.x + T::ONE).ln(),
        p.y.powi(-3),
        p.x.tan(),
        p.y.atan2(p.x),
        p.x.powf(T::of(2.0)),
        (p.y * p.y).powf(p.x),
    ];
    let [_, lamp, spot, _] = [0, 1, 2, 3].map(|i| scene.lights[i].at(p));
    let falloff = [
        lamp.distance(),
        lamp.intensity().r,
        spot.intensity().g,
        p.length(),
    ];
    let vectors = normals.map(<[T; 3]>::from).concat();
    [sums, vectors, functions.to_vec(), falloff.to_vec()].concat()
}

/// Two lamps, a spot whose soft edge the points are within, and a sun, all in front.
fn scene() -> Scene {
    let fading = coefficients(0.375, 0.5, 0.75);
    let near = lamp(vector([-2.0, 1.0, 5.0]), rgb([1.0, 0.5, 0.25]), fading);
    let far = lamp(
        vector([2.0, -3.0, 4.0]),
        rgb([0.5, 1.0, 0.75]),
        fading.clamped(),
    );
    let above = lamp(
        vector([0.5, 0.25, 6.0]),
        rgb([1.0, 0.75, 0.5]),
        fading.within(12.0).expect("a range"),
    );
    let [k_a, k_d, k_s] = [[0.1, 0.2, 0.3], [0.5, 0.75, 1.0], [1.0, 0.5, 0.25]].map(rgb);
    Scene {
        material: material(k_a, k_d, k_s, 9),
        ambient: rgb([1.0, 0.5, 0.25]),
        lights: vec![
            sun(direction([1.0, 2.0, 4.0]), rgb([1.0, 0.5, 0.25])),
            near.into(),
            spot(above, direction([0.3, 0.1, -1.0]), cone(0.9999, 0.25)),
            Light::from(far),
        ],
        ..Scene::default()
    }
}

/// A central difference of step h is off by h² times the third derivative: 10⁻⁶ here, at most.
#[test]
fn gradients_are_the_differences() {
    let c = scene();
    let dual = c.cast(Dual::constant);
    for p in [[1.0, -0.5, 0.25], [-0.75, 1.5, 0.5], [0.4, 0.6, -1.0]] {
        let gradients = everything(&dual, Dual::point(vector(p)));
        let values = everything(&c, vector(p));
        for axis in 0..3 {
            let moved = |by: f64| {
                let mut p = p;
                p[axis] += by;
                everything(&c, vector(p))
            };
            let (below, above) = (moved(-1e-4), moved(1e-4));
            for (i, gradient) in gradients.iter().enumerate() {
                assert_eq!(gradient.value.to_bits(), values[i].to_bits(), "{i}");
                let slope = (above[i] - below[i]) / 2e-4;
                let is = <[f64; 3]>::from(gradient.gradient)[axis];
                println!("number {i} along {axis} at {p:?}");
                assert_relative_eq!(is, slope, epsilon = 2e-6, max_relative = 2e-6);
            }
        }
    }
    let values = everything(&c, vector([1.0, -0.5, 0.25]));
    let dark: Vec<_> = (0..values.len()).filter(|&i| values[i] == 0.0).collect();
    assert_eq!(
        dark,
        [2],
        "Lambert has no highlight, and everything else shines"
    );
}

/// The same three variables at both levels: both gradients are those of one level.
#[test]
fn duals_of_duals_differentiate_twice() {
    let c = scene();
    let p = vector([1.0, -0.5, 0.25]);
    let once = everything(&c.cast(Dual::constant), Dual::point(p));
    let twice = everything(
        &c.cast(Dual::constant).cast(Dual::constant),
        Dual::point(Dual::point(p)),
    );
    for (once, twice) in once.iter().zip(twice) {
        assert_eq!(format!("{:?}", twice.value), format!("{once:?}"));
        assert_eq!(twice.gradient.map(|x| x.value), once.gradient);
        let [x, y, z]: [Dual<f64>; 3] = twice.gradient.into();
        let scale = 1e-9 * (1.0 + x.gradient.length() + y.gradient.length() + z.gradient.length());
        assert_abs_diff_eq!(x.gradient.y, y.gradient.x, epsilon = scale);
        assert_abs_diff_eq!(y.gradient.z, z.gradient.y, epsilon = scale);
    }
}

/// What does not vary adds nothing to the gradient, even where a factor is infinite; plain numbers
/// need no type.
#[test]
fn powers_at_zero_and_of_plain_exponents() {
    let x = Dual::point(Vec3::new(0.0_f32, 1.0, 2.0)).x;
    assert_eq!(x.powf(1.5).gradient, Vec3::ZERO); // 1.5 · 0^½
    assert_eq!(x.powf(0.0).gradient, Vec3::ZERO); // 1
    assert_eq!((x - 2.0).powf(3.0).gradient, *UnitVec3::X * 12.0); // 3 · (−2)²
    assert!(!x.powf(x).gradient.x.is_finite());
    assert_eq!(x.max(0.5).gradient, Vec3::ZERO);
    assert_eq!(x.min(0.5).gradient, *UnitVec3::X);
    assert_eq!(x.atan2(2.0).gradient, *UnitVec3::X * 0.5); // 1/(1 + 0²/2²) · ½
}
