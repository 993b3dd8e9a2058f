//! Each point has the bits that the crate gives it alone, whatever the lanes and the threads.

use shading::{Rgb, Vec3, shade};

use crate::kernel::{Out, shade_all, span_for_any};
use crate::light::Light;
use crate::number::Number;
use crate::scene::{Model, Scene};

/// Numbers between −1 and 1, and some that are extreme.
struct Random(u64);

impl Random {
    fn next<T: Number>(&mut self) -> T {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        let x = f64::from((self.0 >> 33) as u32) / f64::from(1_u32 << 30) - 1.0;
        T::of(match self.0 >> 27 & 63 {
            0 => 0.0,
            1 => x * 1e-30,
            2 => x * 1e30,
            _ => x,
        })
    }

    fn rows<T: Number>(&mut self, count: usize) -> Vec<[T; 3]> {
        (0..count)
            .map(|_| [self.next(), self.next(), self.next()])
            .collect()
    }

    /// Light or reflectances.
    fn colors<T: Number>(&mut self, count: usize) -> Vec<[T; 3]> {
        self.rows(count)
            .into_iter()
            .map(|row: [T; 3]| row.map(|x| if x < T::ZERO { -x } else { x }))
            .collect()
    }
}

/// As the README of the crate shows it.
fn alone<T: Number>(scene: &Scene<T>, lights: &[shading::Light<T>], i: usize) -> [T; 3] {
    let row = |rows: &[[T; 3]]| rows[if rows.len() == 1 { 0 } else { i }];
    let p = Vec3::from(row(scene.points));
    let v = Vec3::from(row(scene.eye)) - p;
    let (Some(n), Some(v)) = (Vec3::from(row(scene.normals)).unit(), v.unit()) else {
        return [T::ZERO; 3];
    };
    let arriving = lights.iter().enumerate().filter_map(|(k, light)| {
        let Some(visible) = scene.visible else {
            return Some(light.at(p));
        };
        let columns = visible.len() / lights.len();
        let fraction = visible[k * columns + if columns == 1 { 0 } else { i }];
        (fraction > T::ZERO).then(|| light.at(p) * fraction)
    });
    let (k_a, k_d, k_s) = (
        row(scene.k_a).into(),
        row(scene.k_d).into(),
        row(scene.k_s).into(),
    );
    let (i_a, m): (Rgb<T>, T) = (
        row(scene.ambient).into(),
        scene.m[if scene.m.len() == 1 { 0 } else { i }],
    );
    let shaded = match (scene.model, m.whole()) {
        (Model::Lambert, _) => shade::lambert(
            n,
            &shading::Material {
                k_a,
                k_d,
                k_s,
                m: 1,
            },
            i_a,
            arriving,
        ),
        (Model::Phong, Some(m)) => {
            shade::phong(n, v, &shading::Material { k_a, k_d, k_s, m }, i_a, arriving)
        }
        (Model::Phong, None) => {
            shade::phong(n, v, &shading::Material { k_a, k_d, k_s, m }, i_a, arriving)
        }
        (Model::BlinnPhong, Some(m)) => {
            shade::blinn_phong(n, v, &shading::Material { k_a, k_d, k_s, m }, i_a, arriving)
        }
        (Model::BlinnPhong, None) => {
            shade::blinn_phong(n, v, &shading::Material { k_a, k_d, k_s, m }, i_a, arriving)
        }
    };
    shaded.total().into()
}

fn lights<T: Number>() -> Vec<Light<T>> {
    let of = |v: [f64; 3]| v.map(T::of);
    let sun = Light {
        toward: of([1.0, -2.0, 2.0]),
        intensity: of([0.5, 0.25, 1.0]),
        ..Light::default_of(0)
    };
    let lamp = Light {
        position: of([0.5, 0.25, 1.0]),
        attenuation: of([1.0, 0.5, 0.25]),
        ..Light::default_of(1)
    };
    let ending = Light {
        range: T::of(2.0),
        gltf: 1,
        ..lamp
    };
    let spot = Light {
        kind: 2,
        axis: of([-1.0, 0.0, -2.0]),
        inner: T::of(0.25),
        range: T::of(3.0),
        gltf: 0,
        ..lamp
    };
    vec![sun, lamp, ending, spot]
}

fn has_every_bit<T: Number>(count: usize) {
    let mut random = Random(7);
    let (points, normals) = (random.rows(count), random.rows(count));
    let textures: [Vec<[T; 3]>; 4] = std::array::from_fn(|_| random.colors(count));
    let [k_a, k_d, k_s, ambient] = &textures;
    let eye = [[T::ZERO, T::ZERO, T::of(5.0)]];
    let lights = lights::<T>();
    // runs of the same shininess, whole and not, some as short as one point
    let ms: Vec<T> = (0..count)
        .map(|i| T::of([32.0, 32.5, 0.0, 7.0][(i / 5 + i / 13) % 4]))
        .collect();
    let fractions: Vec<T> = (0..count * lights.len())
        .map(|i| T::of([1.0, 0.0, 0.5][(i / 3) % 3]))
        .collect();
    for model in [Model::Lambert, Model::Phong, Model::BlinnPhong] {
        for (m, visible, each) in [
            (&[T::of(32.0)][..], None, false),
            (&[T::of(32.5)], None, true),
            (&ms, Some(&fractions[..]), true),
            (&ms, Some(&fractions[..lights.len()]), false),
        ] {
            let rows = |rows| if each { rows } else { &textures[0][..1] };
            let scene = Scene {
                model,
                count,
                points: &points,
                normals: &normals,
                eye: &eye,
                k_a: rows(k_a),
                k_d: rows(k_d),
                k_s: rows(k_s),
                ambient: rows(ambient),
                m,
                lights: &lights,
                visible,
            };
            let lights = scene.checked().expect("valid");
            let expected: Vec<[T; 3]> = (0..count).map(|i| alone(&scene, &lights, i)).collect();
            let mut out = vec![[T::ZERO; 3]; count];
            shade_all(&scene, &lights, Out::Total(&mut out));
            is_equal(&out, &expected, "as here");
            span_for_any(&scene, &lights, &mut out);
            is_equal(&out, &expected, "without AVX2");
        }
    }
}

fn is_equal<T: Number>(out: &[[T; 3]], expected: &[[T; 3]], what: &str) {
    for (i, (out, expected)) in out.iter().zip(expected).enumerate() {
        // no NaN, and no −0: the sums begin at +0
        let is_equal = out.iter().zip(expected).all(|(a, b)| a == b);
        assert!(is_equal, "point {i}, {what}: {out:?} for {expected:?}");
    }
}

#[test]
fn f32_has_every_bit() {
    for count in [1, 7, 8, 9, 20_011] {
        has_every_bit::<f32>(count);
    }
}

#[test]
fn f64_has_every_bit() {
    for count in [1, 3, 4, 5, 20_011] {
        has_every_bit::<f64>(count);
    }
}
