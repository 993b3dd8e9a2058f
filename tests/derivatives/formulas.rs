//! Formulas of the crate, in any number.

use shading::{
    Attenuation, Cone, DirectionalLight, Material, PointLight, Real, Rgb, SpotLight, UnitVec3,
    Vec3, normal, reflection, shade,
};

/// As many numbers as [`everywhere`] takes.
pub const COUNT: usize = 34;

pub type Numbers<T> = [T; COUNT];

fn vector<T: Real>(numbers: &Numbers<T>, i: usize) -> Vec3<T> {
    Vec3::new(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2])
}

fn color<T: Real>(numbers: &Numbers<T>, i: usize) -> Rgb<T> {
    let v = vector(numbers, i);
    Rgb::new(v.x.abs(), v.y.abs(), v.z.abs())
}

/// What also computes in lanes.
pub fn everywhere<T: Real>(numbers: &Numbers<T>) -> Vec<T> {
    let [a, b, c] = [0, 1, 2].map(|i| vector(numbers, i));
    let [n, v] = [3, 4].map(|i| vector(numbers, i).unit_or(UnitVec3::Z));
    let axis = (b - a).unit_or(UnitVec3::X);
    let [first, second, k_a, k_d, k_s] = [5, 6, 7, 8, 9].map(|i| color(numbers, i));
    let l = vector(numbers, 10).unit_or(v);

    let attenuation = Attenuation::<f64>::new(0.5, 0.25, 0.125).expect("valid");
    let ranged = attenuation.within(16.0).expect("a range");
    let endless = Attenuation::<f64>::new(0.0, 0.0, 1.0).expect("valid");
    let cone = Cone::<f64>::from_cosines(0.9375, -0.5).expect("cosines");
    let change = numbers[33].abs();
    let number = |literal| T::of(literal) + change; // the coefficients have derivatives, too
    let lamp = |attenuation: Attenuation<f64>| PointLight {
        position: a,
        intensity: first,
        attenuation: attenuation.cast(number),
    };
    let far = |attenuation: Attenuation<f64>| PointLight {
        position: a,
        intensity: second,
        attenuation: attenuation.cast(number),
    };
    let spot = |cone: Cone<f64>| SpotLight {
        point: far(ranged),
        axis,
        cone: cone.cast(T::of),
    };
    let lights = [
        lamp(attenuation).at(b),
        lamp(attenuation.clamped()).at(c),
        far(ranged).at(b),
        far(ranged.unsquared()).at(b),
        far(endless).at(c),
        spot(cone).at(b),
        spot(cone.smoothstep()).at(c),
        DirectionalLight {
            l,
            intensity: first,
        }
        .at(a),
    ];

    let mut results = vec![a.length(), a.dot(b), (a / b.x).z, (a * b.y).x];
    let mut push = |v: Vec3<T>| results.extend(<[T; 3]>::from(v));
    push(*axis);
    push(normal::corner(a, b, c));
    push(*reflection(n, l));
    for light in lights {
        push(*light.l);
        push(Vec3::from(<[T; 3]>::from(light.intensity)));
        push(Vec3::new(light.distance, T::ZERO, T::ZERO));
    }
    for m in [0, 1, 7, 8, 70] {
        let material = Material { k_a, k_d, k_s, m };
        for shaded in [
            shade::phong(n, v, &material, second, lights),
            shade::blinn_phong(n, v, &material, second, lights),
        ] {
            push(Vec3::from(<[T; 3]>::from(shaded.diffuse)));
            push(Vec3::from(<[T; 3]>::from(shaded.specular)));
        }
    }
    results
}

/// What needs an order.
pub fn in_order<T: Real + PartialOrd>(numbers: &Numbers<T>) -> Vec<T> {
    let [a, b, c] = [0, 1, 2].map(|i| vector(numbers, i));
    let [n, v] = [3, 4].map(|i| vector(numbers, i).unit_or(UnitVec3::Z));
    let normals = [
        normal::triangle(a, b, c),
        normal::sphere(a, b),
        normal::from_tangents(a, b),
        normal::transformed(n, [a, b, c]),
        normal::mapped(n, a, b.x, c),
        shading::half_vector(n, v),
    ];
    let none = UnitVec3::assume_unit(Vec3::ZERO);
    let normals = normals.map(|n| n.unwrap_or(none));
    normals.into_iter().flat_map(<[T; 3]>::from).collect()
}
