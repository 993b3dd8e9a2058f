//! (63) A dual number over any number: its value and its gradient, against other ways to the same.

#![allow(clippy::float_cmp)] // bits are compared, on purpose

mod formulas;
mod plain;
mod roundoff;

use formulas::{COUNT, Numbers, everywhere, in_order};
use plain::Plain;
use shading::{Dual, Exponent, Real, Vec3};

/// Steele, Lea, Flood, *Fast Splittable Pseudorandom Number Generators*, 2014.
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = (self.0 ^ self.0 >> 30).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ z >> 27).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ z >> 31
    }

    /// A number of 11 bits in (−1, 1), which every number type has.
    fn short(&mut self) -> f64 {
        f64::from(i16::try_from(self.bits() % 2047).expect("11 bits") - 1023) / 1024.0
    }

    /// Numbers of up to 4 and gradients of up to 1. In some cases, two neighboring vectors are equal or
    /// opposite, or one is zero. In half of the cases, the first three vectors are so small or so large that
    /// their squares are out of range in single precision.
    fn scene(&mut self, case: u64) -> Scene {
        let mut scene = [(); COUNT].map(|()| [4.0, 1.0, 1.0, 1.0].map(|size| size * self.short()));
        let vector = usize::try_from(self.bits() % 96).expect("small");
        if vector < 10 {
            let factor = [1.0, -1.0, 0.0][vector % 3];
            for i in 3 * vector..3 * vector + 3 {
                scene[i + 3] = scene[i].map(|x| factor * x);
            }
        }
        let size =
            [1.0, 2_f64.powi(-70), 1.0, 2_f64.powi(70)][usize::try_from(case % 4).expect("small")];
        for number in scene.iter_mut().take(9) {
            number[0] *= size;
        }
        scene
    }
}

/// The value and the gradient of each number.
type Scene = [[f64; 4]; COUNT];

/// Multiplies the first three vectors by a power of two.
fn resize(scene: &mut Scene, exponent: i32) {
    for number in scene.iter_mut().take(9) {
        number[0] *= 2_f64.powi(exponent);
    }
}

const SCENES: u64 = 400;

fn dual<T: Real>([value, x, y, z]: [f64; 4]) -> Dual<T> {
    Dual {
        value: T::of(value),
        gradient: Vec3::new(T::of(x), T::of(y), T::of(z)),
    }
}

fn scenes() -> impl Iterator<Item = Scene> {
    let mut random = Random(66);
    (0..SCENES).map(move |case| random.scene(case))
}

fn all<T: Real + PartialOrd>(numbers: &Numbers<T>) -> Vec<T> {
    let mut results = everywhere(numbers);
    results.extend(in_order(numbers));
    results
}

/// The numbers of a dual number: its value and its gradient.
fn four<T: Real>(x: Dual<T>) -> [T; 4] {
    let [dx, dy, dz] = x.gradient.into();
    [x.value, dx, dy, dz]
}

/// Equal bits, or both NaN.
fn is_same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan()
}

fn assert_same(at: usize, a: impl Into<f64>, b: impl Into<f64>) {
    let (a, b) = (a.into(), b.into());
    assert!(is_same(a, b), "result {at}: {a:e} and {b:e}");
}

fn values_are_those_of<T: Real + PartialOrd + Into<f64>>() {
    for scene in scenes() {
        let duals = all(&scene.map(dual::<T>));
        let numbers = all(&scene.map(|[value, ..]| T::of(value)));
        for (at, (dual, number)) in duals.iter().zip(numbers).enumerate() {
            assert_same(at, dual.value, number);
        }
    }
}

#[test]
fn values_are_those_of_the_number() {
    values_are_those_of::<f32>();
    values_are_those_of::<f64>();
    values_are_those_of::<Plain<f32>>();
    #[cfg(feature = "fixed")]
    values_are_those_of::<shading::fixed::Fixed>();
}

/// A number of a user's own, whose operations are those of `f64`, makes the same dual numbers as `f64`.
#[test]
fn users_numbers_differentiate_as_the_crates() {
    for scene in scenes() {
        let users = all(&scene.map(dual::<Plain<f64>>));
        let ours = all(&scene.map(dual::<f64>));
        for (at, (users, ours)) in users.into_iter().zip(ours).enumerate() {
            for (a, b) in four(users).into_iter().zip(four(ours)) {
                assert_same(at, a, b);
            }
        }
    }
}

/// The same three variables at both levels: the value and both gradients are those of one level, and the
/// second derivatives do not depend on the order.
#[test]
fn duals_of_duals_differentiate_twice() {
    let twice = |[value, x, y, z]: [f64; 4]| Dual {
        value: dual::<f64>([value, x, y, z]),
        gradient: Vec3::new(x, y, z).map(Dual::constant),
    };
    for scene in scenes() {
        let twice = all(&scene.map(twice));
        let once = all(&scene.map(dual::<f64>));
        for (at, (twice, once)) in twice.into_iter().zip(once).enumerate() {
            let [value, dx, dy, dz] = four(twice);
            let outer = [value.value, dx.value, dy.value, dz.value];
            for ((inner, outer), once) in four(value).into_iter().zip(outer).zip(four(once)) {
                assert_same(at, inner, once);
                assert_same(at, outer, once);
            }
        }
    }
}

#[cfg(feature = "wide")]
#[test]
fn lanes_differentiate_as_scalars() {
    use shading::Lanes;
    use wide::{f32x4, f32x8, f64x4};

    fn check<L: Lanes<Lane: Into<f64>>>(lane_of: impl Fn(L, usize) -> L::Lane) {
        let mut random = Random(53);
        for _ in 0..SCENES / 8 {
            let scene = |lane| random.scene(lane as u64);
            let scenes: Vec<Scene> = (0..L::COUNT).map(scene).collect();
            let dual_of_lanes = |i: usize| {
                let part = |k: usize| L::from_fn(|lane| L::Lane::of(scenes[lane][i][k]));
                let [value, x, y, z] = [0, 1, 2, 3].map(part);
                let gradient = Vec3::new(x, y, z);
                Dual { value, gradient }
            };
            let lanes = everywhere(&std::array::from_fn(dual_of_lanes));
            for (lane, scene) in scenes.iter().enumerate() {
                let scalars = everywhere(&scene.map(dual::<L::Lane>));
                for (at, (lanes, scalar)) in lanes.iter().zip(scalars).enumerate() {
                    for (lanes, scalar) in four(*lanes).into_iter().zip(four(scalar)) {
                        assert_same(at, lane_of(lanes, lane), scalar);
                    }
                }
            }
        }
    }
    check::<f32x4>(|lanes, i| lanes.to_array()[i]);
    check::<f32x8>(|lanes, i| lanes.to_array()[i]);
    check::<f64x4>(|lanes, i| lanes.to_array()[i]);
}

/// Rounding lifts a cosine above 1, where the power stays 1.
#[test]
fn power_of_a_cosine_above_1_is_constant() {
    let power = 7.raise(dual::<f32>([1.0 + 2_f64.powi(-20), 1.0, 0.0, 0.0]));
    assert_eq!(four(power), [1.0, 0.0, 0.0, 0.0]);
    let power = 7.raise(dual::<f32>([1.0, 1.0, 0.0, 0.0]));
    assert_eq!(four(power), [1.0, 7.0, 0.0, 0.0]);
}
