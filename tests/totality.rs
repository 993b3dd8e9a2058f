//! What every function returns where its formula has no answer, and at the ends of the number types:
//! one row for each case, run for `f32` and `f64`. Beside the rows stand the sweeps that no row
//! holds, and the promise of every function whatever the bits of its arguments.

#![allow(clippy::float_cmp)] // results are compared exactly

#[path = "totality/any_bits.rs"]
mod any_bits;
#[path = "totality/sweeps.rs"]
mod sweeps;

use std::f64::consts::{FRAC_1_PI, PI};
use std::fmt::Debug;

use kit::{Float, direction, rgb, vector};
use shading::term::{blinn, blinn_normalization, phong, phong_normalization};
use shading::{
    Attenuation, Cone, DirectionalLight, Dual, Elementary, IncidentLight, Light, Lobe, Mask,
    Material, PointLight, Real, Rgb, Select, Shaded, SpotLight, UnitVec3, Vec3, attenuation,
    half_vector, normal, reflection, shade, term,
};

/// Runs each row for `f32` and `f64`, and names those that fail.
macro_rules! table {
    ($($name:literal: $call:expr => $expected:expr;)*) => {
        fn rows<T: Float>() {
            let mut wrong = vec![];
            $({
                let [is, should] = texts([$call, $expected]);
                if is != should {
                    wrong.push(format!("{}: {is} instead of {should}", $name));
                }
            })*
            assert!(wrong.is_empty(), "{}", wrong.join("\n"));
        }
    };
}

kit::for_f32_and_f64!(rows);

/// As text, NaN equals itself, and all parts of a dual number count. The sign of a zero does not.
fn texts<V: Debug>(values: [V; 2]) -> [String; 2] {
    let signs = ["-0.0,", "-0.0 ", "-0.0]", "-0.0)"];
    let text = |value| {
        signs.iter().fold(format!("{value:?}"), |text, zero| {
            text.replace(zero, &zero[1..])
        })
    };
    values.map(|value| text([value]))
}

fn x<T: Real>(x: T) -> Vec3<T> {
    Vec3::new(x, T::ZERO, T::ZERO)
}

fn trusted<T: Real>(v: Vec3<T>) -> UnitVec3<T> {
    UnitVec3::assume_unit(v)
}

fn of<T: Real, const N: usize>(numbers: [f64; N]) -> [T; N] {
    numbers.map(T::of)
}

fn tiniest<T: Float>() -> T {
    T::of(T::TINIEST)
}

fn not_finite<T: Float>() -> [T; 3] {
    [T::INFINITY, -T::INFINITY, T::NAN]
}

/// From the smallest number to the largest.
fn sizes<T: Float>() -> [T; 5] {
    [
        tiniest(),
        T::of(T::MIN_POSITIVE),
        T::of(1e-20),
        T::ONE,
        T::MAX,
    ]
}

/// Whether a number is right to some u of itself.
fn near<T: Float>(x: T, expected: f64, units: f64) -> bool {
    x.to_f64() == expected || (x.to_f64() / expected - 1.0).abs() <= units * T::U
}

trait ToF64 {
    fn to_f64(self) -> f64;
}

impl<T: Float> ToF64 for T {
    fn to_f64(self) -> f64 {
        self.into()
    }
}

fn mirror<T: Real, M>(m: M) -> Material<T, M> {
    let [k_a, k_d, k_s] = [Rgb::WHITE; 3];
    Material { k_a, k_d, k_s, m }
}

fn falloff<T: Float>(a: f64, b: f64, c: f64) -> Attenuation<T> {
    Attenuation::new(T::of(a), T::of(b), T::of(c)).expect("coefficients")
}

fn inverse_square<T: Float>() -> Attenuation<T> {
    falloff(0.0, 0.0, 1.0)
}

fn lamp<T: Real>(position: Vec3<T>, attenuation: Attenuation<T>) -> PointLight<T> {
    PointLight {
        position,
        intensity: Rgb::WHITE,
        attenuation,
    }
}

fn spot<T: Float>(point: PointLight<T>, half_angle: f64) -> SpotLight<T> {
    let cone = Cone::from_half_angle(T::of(half_angle)).expect("a half-angle");
    SpotLight {
        point,
        axis: UnitVec3::NEG_X,
        cone,
    }
}

fn sun<T: Real>(l: UnitVec3<T>) -> IncidentLight<T> {
    DirectionalLight {
        l,
        intensity: Rgb::WHITE,
    }
    .at(Vec3::ZERO)
}

/// The sums of everything that comes from such lights onto mirrors, which face the eye.
fn shine<T: Real, const N: usize>(lights: [IncidentLight<T>; N]) -> [[Rgb<T>; 3]; 2] {
    [UnitVec3::Z, UnitVec3::X].map(|n| {
        [
            shade::lambert(n, &mirror(1), Rgb::BLACK, lights).total(),
            shade::phong(n, n, &mirror(1), Rgb::BLACK, lights).total(),
            shade::blinn_phong(n, n, &mirror(1), Rgb::BLACK, lights).total(),
        ]
    })
}

/// As many lights from above.
fn bright<T: Real, const N: usize>(intensity: T) -> [IncidentLight<T>; N] {
    [DirectionalLight {
        l: UnitVec3::Z,
        intensity: Rgb::gray(intensity),
    }
    .at(Vec3::ZERO); N]
}

fn invalid<T: Float>() -> [T; 4] {
    [-T::ONE, -T::of(1e30), -T::INFINITY, T::NAN]
}

/// A right angle at the origin, whose map is the plane it lies in.
fn corner<T: Float>(size: T, map: T) -> ([Vec3<T>; 3], [[T; 2]; 3]) {
    let o = T::ZERO;
    (
        [Vec3::ZERO, x(size), Vec3::new(o, size, o)],
        [[o, o], [map, o], [o, map]],
    )
}

/// Whether a tangent is (3, −1, 0)/√10, to 8 roundings.
fn slants<T: Float>(tangent: Option<(UnitVec3<T>, T)>) -> bool {
    let root = 10.0_f64.sqrt();
    tangent.is_some_and(|(t, h)| {
        near(t.x, 3.0 / root, 8.0) && near(t.y, -1.0 / root, 8.0) && h == T::ONE
    })
}

/// A variable with this value.
fn variable<T: Real>(value: T) -> Dual<T> {
    Dual::point(x(value)).x
}

/// The value, and whether the slope is a finite number.
fn slope<T: Float>(dual: Dual<T>) -> (T, bool) {
    (dual.value, dual.gradient.x.to_f64().is_finite())
}

fn globe<T: Elementary>(u: T, v: T) -> Vec3<T> {
    Vec3::new(u.cos() * v.sin(), u.sin() * v.sin(), v.cos())
}

/// The normal of (k u, v, 0), whose tangents are in the ratio k, and that with u and v exchanged.
fn thin<T: Float>(k: f64, size: f64) -> [Option<UnitVec3<T>>; 2] {
    let [k, size]: [T; 2] = of([k * size, size]);
    let s = |u: Dual<T>, v: Dual<T>| Vec3::new(u * k, v * size, Dual::ZERO);
    [
        normal::parametric(s, T::ONE, T::ONE),
        normal::parametric(|v, u| s(u, v), T::ONE, T::ONE),
    ]
}

const WHOLE: [u32; 5] = [0, 1, 2, 1000, u32::MAX];

table! {
    // numbers
    "selection": [tiniest(), T::ONE, T::INFINITY, T::ZERO, -T::ZERO, -tiniest::<T>(), T::NAN]
        .map(|x| x.above(T::ZERO)).map(|is| (is.any(), is.select(T::ONE, T::ZERO)))
        => [true, true, true, false, false, false, false].map(|above| (above, if above { T::ONE } else { T::ZERO }));
    "literals": [T::of_f32(0.1), T::of_f32(f32::MAX)] => of::<T, 2>([0.1_f32.into(), f32::MAX.into()]);
    "root and logarithm below zero": [-tiniest::<T>(), -T::ONE, -T::INFINITY]
        .map(|x| (x.sqrt().to_f64().is_nan(), x.ln().to_f64().is_nan()))
        => [(true, true); 3];

    // vectors
    "products that overflow": { let r = T::MAX.sqrt() * T::of(2.0); let [a, b] = [vector::<T>([1.0, 1.0, 0.0]) * r,
        vector::<T>([1.0, -1.0, 0.0]) * r]; (a.dot(a), a.dot(b).to_f64().is_nan(), a.cross(a).z.to_f64().is_nan(), a.cross(b).z) }
        => (T::INFINITY, true, true, -T::INFINITY);
    "a × a": { let c = vector::<T>([1.0, 2.0, 3.0]) * T::of(0.1) * T::MAX.sqrt(); c.cross(c) } => Vec3::<T>::ZERO;
    "length": [Vec3::new(T::MAX, T::ZERO, T::MAX), Vec3::new(T::ZERO, -T::INFINITY, T::ONE), Vec3::new(T::ONE, T::NAN, T::ONE),
        Vec3::ZERO].map(Vec3::length)
        => [T::MAX, T::INFINITY, T::NAN, T::ZERO];
    // (1, 2, 2)/3; the squares, sums and root are off by 2.5u, and the division by 1u
    "unit at any size": [tiniest(), T::of(T::MIN_POSITIVE), T::ONE, T::MAX * T::of(0.5)]
        .map(|size| { let n = (vector::<T>([1.0, 2.0, 2.0]) * size).unit().expect("finite"); near(n.x, 1.0 / 3.0, 3.5) && near(n.y,
        2.0 / 3.0, 3.5) && n.z == n.y })
        => [true; 4];
    "no direction": [T::ZERO, -T::ZERO, T::INFINITY, -T::INFINITY, T::NAN]
        .map(|c| Vec3::new(if c == T::ZERO { c } else { T::ONE }, c, c)).map(|v| (v.unit(), v.unit_or(UnitVec3::Y)))
        => [(None, UnitVec3::<T>::Y); 5];
    "unit_or of a direction": vector::<T>([3.0, 0.0, 4.0]).unit_or(UnitVec3::Y) => direction::<T>([3.0, 0.0, 4.0]);
    "UnitVec3::new": [[0.0, 0.0, 1.0], [0.6, 0.0, -0.8], [-0.48, 0.6, 0.64], [1.0 / 3.0_f64.sqrt(); 3]]
        .map(|v| { let [x, y, z] = of(v); UnitVec3::new(x, y, z).map(|u| *u) == Some(vector::<T>(v)) })
        => [true; 4];
    // the square of the length is off by 16ε, that of a rounded unit vector by 4ε at most
    "UnitVec3::new of another length": [[0.0; 3], [1.0, 0.0, 1.0], [f64::NAN, 0.0, 1.0], [f64::INFINITY, 0.0, 0.0], [0.0,
        f64::NEG_INFINITY, 0.0], [0.6, 0.0, 0.8].map(|c| c * (1.0 - 16.0 * T::U)), [0.6, 0.8, 0.0].map(|c| c * (1.0 + 16.0 * T::U))]
        .map(|v| { let [x, y, z] = of::<T, 3>(v); UnitVec3::new(x, y, z) })
        => [None; 7];
    "assume_unit": *trusted(vector::<T>([1.0, 2.0, 3.0])) => vector::<T>([1.0, 2.0, 3.0]);
    "half vector of opposites": [[0.0, 0.0, 1.0], [1.0, 2.0, 3.0], [-5.0, 0.1, 7.0]].map(direction::<T>).map(|l| half_vector(l, -l))
        => [None; 3];
    // both are of length 1 up to rounding, and their sum is (0, 0, tiny)
    "half vector of nearly opposites": [tiniest(), T::of(T::MIN_POSITIVE), T::of(T::U)]
        .map(|tiny| half_vector(trusted(Vec3::new(T::ONE, T::ZERO, tiny)), UnitVec3::NEG_X))
        => [Some(UnitVec3::<T>::Z); 3];
    "half vector of NaN": half_vector(trusted(x(T::NAN)), UnitVec3::X) => None;
    // 2(N·L)N − L for |N| = 2: 2·4·2 − 1
    "reflection of any vector": (reflection(trusted(x(T::of(2.0))), UnitVec3::X).x, reflection(trusted(x(T::NAN)), UnitVec3::X).x)
        => (T::of(7.0), T::NAN);

    // normals
    "plane": [T::ZERO, T::INFINITY, -T::INFINITY, T::NAN].map(|a| normal::plane(a, if a == T::ZERO { a } else { T::ONE }, T::ZERO))
        => [None; 4];
    "degenerate triangle": { let [a, b, m] = [[1.0, 2.0, 3.0], [4.0, 6.0, 8.0], [2.5, 4.0, 5.5]].map(vector::<T>); [[a, a, a],
        [a, a, b], [a, b, a], [a, b, b], [a, m, b], [m, a, b]].map(|[a, b, c]| (normal::triangle(a, b, c), normal::corner(a, b, c))) }
        => [(None, Vec3::<T>::ZERO); 6];
    "triangle to infinity": not_finite::<T>().map(x).map(|bad| { let [a, b] = [x(T::ONE), *UnitVec3::Y];
        [[bad, a, b], [a, bad, b], [a, b, bad], [bad; 3]].map(|[a, b, c]| (normal::triangle(a, b, c), normal::corner(a, b, c))) })
        => [[(None, Vec3::<T>::ZERO); 4]; 3];
    // both edges overflow: they are (2, 0, 0) and (1, 1, 0) times the largest number; then one coordinate alone
    "triangle whose edges overflow": { let [a, b, c] = [[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]
        .map(|v| vector::<T>(v) * T::MAX); [normal::triangle(a, b, c), normal::triangle(a, c, b), normal::triangle(a, b,
        Vec3::new(-T::MAX, T::ONE, T::ZERO))] }
        => [Some(UnitVec3::<T>::Z), Some(-UnitVec3::Z), Some(UnitVec3::Z)];
    "tiny triangle far out": normal::triangle(x(T::MAX), Vec3::new(T::MAX, tiniest(), T::ZERO), Vec3::new(T::MAX, T::ZERO, tiniest()))
        => Some(UnitVec3::<T>::X);
    "sphere": [[T::ONE, T::ONE], [-T::MAX, T::MAX], [T::MAX, -T::MAX], [T::INFINITY, T::ONE], [T::ONE, T::NAN]]
        .map(|[c, p]| normal::sphere(x(c), x(p)))
        => [None, Some(UnitVec3::<T>::X), Some(-UnitVec3::X), None, None];
    "gradient and tangents": [T::ZERO, T::INFINITY, -T::INFINITY, T::NAN].map(x)
        .map(|v| [normal::from_gradient(v), normal::from_tangents(v, *UnitVec3::Y), normal::from_tangents(*UnitVec3::Y, v)])
        => [[None; 3]; 4];
    "tangents of any length": sizes::<T>().map(|a| sizes().map(|b| (normal::from_tangents(x(a), *UnitVec3::Y * b),
        normal::from_tangents(x(a), x(b)))))
        => [[(Some(UnitVec3::<T>::Z), None); 5]; 5];
    // the apex of a cone, ∇(x² + y² − z²) = 0, and √x at 0, which has no gradient
    "implicit": { let cone = |p: Vec3<Dual<T>>| p.x * p.x + p.y * p.y - p.z * p.z; (normal::implicit(cone, Vec3::ZERO),
        normal::implicit(|p: Vec3<Dual<T>>| p.x.sqrt(), Vec3::ZERO), normal::implicit(cone, vector([3.0, 4.0, 5.0])).is_some()) }
        => (None, None, true);
    "implicit where undefined": [normal::implicit(|p: Vec3<Dual<T>>| p.x.ln() + p.z, x(-T::ONE)),
        normal::implicit(|p| p.x.ln().abs() + p.z, x(-T::ONE))]
        => [None; 2];
    // sin π is not 0 but the rounding of π, at most 2u
    "poles, parallel tangents": [normal::parametric(globe, T::ONE, T::ZERO), normal::parametric(globe, T::ONE, T::of(PI)),
        normal::parametric(|u, v| Vec3::new(u + v, u + v, u + v), T::ONE, T::ONE)]
        => [None; 3];
    "tangents of noise": [1e-30, 1.0, 1e30].map(|size| [thin::<T>(32.0 * T::U, size), thin(0.0, size)]) => [[[None; 2]; 2]; 3];
    "tangents above noise": [1e-30, 1.0, 1e30].map(|size| [32.0 * T::U * (1.0 + 2.0 * T::U), 64.0 * T::U, 0.5, 1.0]
        .map(|k| thin::<T>(k, size)))
        => [[[Some(UnitVec3::<T>::Z), Some(-UnitVec3::Z)]; 4]; 3];
    "facing edge-on, NaN": [UnitVec3::<T>::X, -UnitVec3::X].map(|n| [normal::facing(n, UnitVec3::Z),
        normal::facing(n, trusted(x(T::NAN)))])
        => [[UnitVec3::<T>::X; 2], [-UnitVec3::X; 2]];
    // projected onto the plane z = 0, that plane keeps its normal, and a wall becomes a line; then onto a line, a point
    "flattened": { let [i, j, k] = [*UnitVec3::<T>::X, *UnitVec3::Y, *UnitVec3::Z]; let two = T::of(2.0); [[i, j, Vec3::ZERO],
        [i, i * two, -i], [Vec3::ZERO; 3]].map(|columns| [i, j, k].map(|n| normal::transformed(trusted(n), columns))) }
        => [[None, None, Some(UnitVec3::<T>::Z)], [None; 3], [None; 3]];
    "columns that are not finite": not_finite::<T>().map(|bad| [tiniest(), T::ONE, T::MAX].map(|size| [0, 1, 2]
        .map(|i| { let mut columns = [UnitVec3::X, UnitVec3::Y, UnitVec3::Z].map(|axis| *axis * size); columns[i] = columns[i] / size;
        columns[i].y = bad; [UnitVec3::X, UnitVec3::Y, UnitVec3::Z].map(|n| normal::transformed(n, columns)) })))
        => [[[[None; 3]; 3]; 3]; 3];
    "columns of any size": sizes::<T>().map(|a| sizes().map(|b| sizes()
        .map(|c| { let columns = [x(a), *UnitVec3::Y * b, *UnitVec3::Z * c]; [UnitVec3::X, UnitVec3::Y, UnitVec3::Z]
        .map(|n| normal::transformed(n, columns) == Some(n)) })))
        => [[[[true; 3]; 5]; 5]; 5];
    // (1, 1, 0) stretched by a along x and y, and by any size along z; the unit vectors round
    "slanted, columns of any size": sizes::<T>().map(|a| sizes()
        .map(|c| { let d = direction::<T>([1.0, 1.0, 0.0]); let n = normal::transformed(d, [x(a), *UnitVec3::Y * a,
        *UnitVec3::Z * c]).expect("a normal"); (n.x - d.x).to_f64().abs() <= 4.0 * T::U && n.y == n.x }))
        => [[true; 5]; 5];
    // 90° and 45°; the edges of the largest triangle overflow
    "corners of any size": [T::TINIEST, T::MIN_POSITIVE, 1e-20, 1.0, 1e20, T::MAX.into()]
        .map(|size| { let [a, b, c] = [[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [-1.0, 1.0, 0.0]].map(|v| vector::<T>(v) * T::of(size));
        [([a, b, c], 2.0), ([b, c, a], 4.0), ([c, a, b], 4.0)].map(|([a, b, c], part)| near(normal::corner(a, b, c).z, PI / part, 8.0)
        && normal::corner(a, c, b) == -normal::corner(a, b, c)) })
        => [[true; 3]; 6];
    "no map": { let (vertices, [a, b, c]) = corner::<T>(T::ONE, T::ONE); [[a, a, a], [a, b, b], [a, b, a], [b, b, c],
        [a, [T::of(2.0), T::ZERO], b]].map(|map| normal::tangent(vertices, map)) }
        => [None; 5];
    "no triangle under the map": { let ([o, a, _], map) = corner::<T>(T::ONE, T::ONE); [normal::tangent([o, o, o], map),
        normal::tangent([o, o, a], map)] }
        => [None; 2];
    "map to infinity": not_finite::<T>().map(|bad| { let (vertices, [a, b, c]) = corner::<T>(T::ONE, T::ONE);
        [normal::tangent([Vec3::ZERO, x(bad), x(T::ONE)], [a, b, c]), normal::tangent(vertices, [a, [bad, T::ZERO], c]),
        normal::tangent(vertices, [a, b, [T::ZERO, bad]])] })
        => [[None; 3]; 3];
    // half of the smallest number is 0; with the second and third coordinates exchanged, x and y are
    "maps of any size": [T::of(2.0 * T::TINIEST), T::ONE, T::MAX].map(|size| [T::of(2.0 * T::TINIEST), T::ONE, T::MAX]
        .map(|map| { let (vertices, [a, b, c]) = corner(size, map); [normal::tangent(vertices, [a, b, c]),
        normal::tangent(vertices, [a, c, b])] }))
        => [[[Some((UnitVec3::<T>::X, T::ONE)), Some((UnitVec3::Y, -T::ONE))]; 3]; 3];
    "map whose differences overflow": { let max = T::MAX; let map = [[-max, -max], [max, -max], [-max, max]]; normal::tangent(map
        .map(|[x, y]| Vec3::new(x, y, T::ZERO)), map) }
        => Some((UnitVec3::<T>::X, T::ONE));
    // T = e₂y₃ − e₃y₂ = 3e₂ − e₃, however x and y are scaled
    "map scaled unevenly": [[0.0, 0.0], [-73.0, 73.0], [73.0, -73.0], [-120.0, 120.0], [120.0, -120.0]]
        .map(|[a, b]: [f64; 2]| { let (vertices, _) = corner::<T>(T::ONE, T::ONE); let map = [[0.0, 0.0], [3.0, 1.0], [-1.0, 3.0]]
        .map(|[x, y]| of([x * a.exp2(), y * b.exp2()])); slants(normal::tangent(vertices, map)) })
        => [true; 5];
    "triangle and map scaled": [-73.0, 73.0, -120.0, 120.0].map(|a: f64| [-73.0, 73.0, -120.0, 120.0]
        .map(|b: f64| { let (vertices, _) = corner::<T>(T::of(a.exp2()), T::ONE); let map = [[0.0, 0.0], [3.0, 1.0], [-1.0, 3.0]]
        .map(|xy| of(xy.map(|x| x * b.exp2()))); slants(normal::tangent(vertices, map)) }))
        => [[true; 4]; 4];
    "no frame for a map": [*UnitVec3::<T>::Z, *UnitVec3::NEG_Z, *UnitVec3::Z * T::MAX, *UnitVec3::Z * tiniest(), Vec3::ZERO]
        .map(|t| normal::mapped(UnitVec3::Z, t, T::ONE, *UnitVec3::X))
        => [None; 5];
    "no sample, no tangent": [T::ZERO, T::INFINITY, -T::INFINITY, T::NAN].map(x)
        .map(|v| [normal::mapped(UnitVec3::Z, v, T::ONE, *UnitVec3::Z), normal::mapped(UnitVec3::Z, *UnitVec3::X, T::ONE, v)])
        => [[None; 2]; 4];
    "samples of any length": [tiniest(), T::ONE, T::MAX].map(x)
        .map(|v| [normal::mapped(UnitVec3::Z, v, T::ONE, v), normal::mapped(UnitVec3::Z, v, T::ONE, Vec3::new(T::ZERO, T::ZERO, v.x))])
        => [[Some(UnitVec3::<T>::X), Some(UnitVec3::Z)]; 3];
    // ⅛ is the last bit of the sample, and the largest size a power of two
    "slanted samples of any length": [8.0 * T::TINIEST, T::MIN_POSITIVE, 0.5 * T::MAX.to_f64() * (1.0 + 2.0 * T::U)].map(|size| {
        let mapped = |size| normal::mapped(direction([2.0, -1.0, 3.0]), vector([1.0, 4.0, -2.0]), T::ONE,
        vector([-1.0, 0.75, 0.875]) * T::of(size)); mapped(size) == mapped(1.0) && mapped(size).is_some() })
        => [true; 3];
    // only the sign of the handedness counts, and a number without a sign counts as negative
    "handedness": [T::ONE, T::of(0.1), T::ZERO, -T::ONE, T::NAN].map(|h| normal::mapped(UnitVec3::Z, *UnitVec3::X, h, *UnitVec3::Y))
        => [Some(UnitVec3::<T>::Y), Some(UnitVec3::Y), Some(-UnitVec3::Y), Some(-UnitVec3::Y), Some(-UnitVec3::Y)];

    // terms
    "lambert behind, of NaN": [-T::ONE, T::ZERO, T::NAN].map(|c| term::lambert(trusted(x(c)), UnitVec3::X)) => [T::ZERO; 3];
    "highlight in the dark": [T::NAN, -T::ONE, -tiniest::<T>(), -T::ZERO, T::ZERO].map(|c| WHOLE
        .map(|m| [phong(trusted(x(c)), UnitVec3::X, m), blinn(trusted(x(c)), UnitVec3::X, m)]))
        => [[[T::ZERO; 2]; 5]; 5];
    "highlight in the dark, real m": [T::NAN, -T::ONE, -tiniest::<T>(), -T::ZERO, T::ZERO].map(|c| of::<T, 4>([0.0, 0.5, 1.0, 1e30])
        .map(|m| [phong(trusted(x(c)), UnitVec3::X, m), blinn(trusted(x(c)), UnitVec3::X, m)]))
        => [[[T::ZERO; 2]; 4]; 5];
    "m = 0": [tiniest(), T::of(0.5), T::ONE].map(|c| [phong(trusted(x(c)), UnitVec3::X, 0), phong(trusted(x(c)), UnitVec3::X, T::ZERO)])
        => [[T::ONE; 2]; 3];
    // N·N exceeds 1 by two units in the last place: 1.0000002^1000000 would be 1.27
    "cosine above one": [1.0, 1.0 + 2.0 * T::U, 2.0].map(|c| { let v = trusted(x(T::of(c)));
        (WHOLE.map(|m| phong(v, UnitVec3::X, m)), of::<T, 3>([0.5, 1e6, 1e30]).map(|m| blinn(v, UnitVec3::X, m))) })
        => [([T::ONE; 5], [T::ONE; 3]); 3];
    "highlight above one in a sum": { let n = trusted(x(T::of(1.0 + 2.0 * T::U)));
        [shade::blinn_phong(n, n, &mirror(T::of(1e6)), Rgb::BLACK, [sun(n)]), shade::phong(n, n, &mirror(T::of(1e6)), Rgb::BLACK,
        [sun(n)])].map(|s| s.specular) }
        => [Rgb::<T>::WHITE; 2];
    // (1 − 2⁻¹²)^(2³² − 1) < e^(−2²⁰), which is 0 in every float
    "huge m": [T::of(1e30), T::MAX, T::INFINITY].map(|m| { let v = trusted(x(T::of(1.0 - 2.0_f64.powi(-12))));
        [blinn(v, UnitVec3::X, m), blinn(v, UnitVec3::X, u32::MAX), blinn(UnitVec3::X, UnitVec3::X, m)] })
        => [[T::ZERO, T::ZERO, T::ONE]; 3];
    "invalid m": invalid::<T>().map(|m| { let v = direction::<T>([3.0, 0.0, 4.0]); [phong(UnitVec3::Z, v, m), blinn(UnitVec3::Z, v, m),
        shade::blinn_phong(UnitVec3::Z, v, &mirror(m), Rgb::BLACK, [sun(UnitVec3::Z)]).specular.r] })
        => [[T::ONE; 3]; 4];
    // a highlight that is 1 everywhere is Lambert's: 2/(2π) = 2·4/(8π) = 1/π, with three roundings
    "normalization, m = 0": [phong_normalization(T::ZERO), blinn_normalization(T::ZERO)].map(|k| near(k, FRAC_1_PI, 3.0)) => [true; 2];
    // (m + 2)/(2π), and (m + 6 + 8/m)/(8π), with seven roundings
    "normalization, huge m": [T::of(1e30), T::MAX].map(|m| [near(phong_normalization(m), m.to_f64() * FRAC_1_PI * 0.5, 7.0),
        near(blinn_normalization(m), m.to_f64() * FRAC_1_PI * 0.125, 7.0)])
        => [[true; 2]; 2];
    "normalization, infinite m": [phong_normalization(T::INFINITY), blinn_normalization(T::INFINITY)]
        => [phong_normalization(T::MAX), blinn_normalization(T::MAX)];
    "normalization, invalid m": invalid::<T>().map(|m| [phong_normalization(m), blinn_normalization(m)])
        => [[phong_normalization(T::ZERO), blinn_normalization(T::ZERO)]; 4];

    // attenuation and cones
    "attenuation without a denominator": [[0.0, 0.0, 0.0, 1.0], [0.0, 1.0, 1.0, 0.0], [0.0, 0.0, 1.0, -0.0], [-0.0, 0.0, 1.0, 0.0]]
        .map(of::<T, 4>).map(|[a, b, c, q]| attenuation(a, b, c, q))
        => [T::MAX; 4];
    "attenuation below zero, of NaN": [[-1.0, 0.0, 0.0, 1.0], [-0.0, 0.0, 1.0, -0.0], [f64::NAN, 0.0, 0.0, 1.0], [1.0, 0.0, 0.0,
        f64::NAN]].map(of::<T, 4>).map(|[a, b, c, q]| attenuation(a, b, c, q))
        => [T::ZERO; 4];
    "attenuation over an overflow": [attenuation(T::ZERO, T::ZERO, T::ONE, T::MAX), attenuation(T::MAX, T::MAX, T::MAX, T::MAX)]
        => [T::ZERO; 2];
    "bad coefficients": [-T::ONE, -tiniest::<T>(), T::INFINITY, -T::INFINITY, T::NAN]
        .map(|bad| [Attenuation::new(bad, T::ONE, T::ONE), Attenuation::new(T::ONE, bad, T::ONE), Attenuation::new(T::ONE, T::ONE,
        bad)])
        => [[None; 3]; 5];
    "no coefficients": [Attenuation::new(T::ZERO, T::ZERO, T::ZERO), Attenuation::new(-T::ZERO, T::ZERO, T::ZERO)] => [None; 2];
    "good coefficients": [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [-0.0, 0.0, T::MAX.into()]].map(of::<T, 3>)
        .map(|[a, b, c]| Attenuation::new(a, b, c).is_some())
        => [true; 4];
    "checked attenuation at zero": [[0.0, 1.0, 0.0], [-0.0, 1.0, 0.0], [-0.0, 0.0, 1.0], [T::TINIEST, 0.0, 0.0]]
        .map(|[a, b, c]| [T::ZERO, -T::ZERO].map(|q| [falloff(a, b, c).at(q), falloff(a, b, c).clamped().at(q)]))
        => [[[T::MAX, T::ONE]; 2]; 4];
    "no attenuation": [T::ZERO, tiniest(), T::of(15_000.0), T::MAX]
        .map(|q| [Attenuation::NONE.at(q), Attenuation::<T>::default().at(q)])
        => [[T::ONE; 2]; 4];
    "bad range": [T::ZERO, -T::ZERO, -T::ONE, -T::INFINITY, T::NAN].map(|r| Attenuation::NONE.within(r)) => [None; 5];
    "range without an end": [T::INFINITY, T::MAX].map(|r| falloff::<T>(1.0, 0.0, 0.25).within(r) == Some(falloff(1.0, 0.0, 0.25)))
        => [true; 2];
    "range without an end, far out": [T::ZERO, tiniest(), T::of(2.0), T::MAX, T::INFINITY]
        .map(|q| { let free = falloff::<T>(1.0, 0.0, 0.25); free.within_gltf(T::INFINITY).expect("none").at(q) == free.at(q) })
        => [true; 5];
    // also where the attenuation has no denominator, at the smallest range, and for NaN
    "out of range": [tiniest(), T::ONE, T::MAX / T::of(2.0)].map(|r| { let ranged = inverse_square().within(r).expect("above 0");
        [ranged, inverse_square().within_gltf(r).expect("above 0")].map(|lamp| [r, r + r, T::INFINITY, T::NAN].map(|q| lamp.at(q))) })
        => [[[T::ZERO; 4]; 2]; 3];
    "at the lamp, with a range": [tiniest(), T::ONE, T::MAX / T::of(2.0)]
        .map(|r| inverse_square().within(r).expect("above 0").at(T::ZERO))
        => [T::MAX; 3];
    "bad angles": [-tiniest::<T>(), T::of(3.2), T::INFINITY, -T::INFINITY, T::NAN]
        .map(|a| [Cone::from_half_angle(a), Cone::from_half_angles(a, T::ONE), Cone::from_half_angles(T::ONE, a)])
        => [[None; 3]; 5];
    "bad cosines": [T::of(1.0 + 2.0 * T::U), -T::of(1.0 + 2.0 * T::U), T::INFINITY, -T::INFINITY, T::NAN]
        .map(|c| [Cone::from_cosine(c), Cone::from_cosines(c, T::ZERO), Cone::from_cosines(T::ZERO, c)])
        => [[None; 3]; 5];
    "edges out of order": [Cone::from_half_angles(T::of(0.5), T::of(0.4)), Cone::from_cosines(T::of(0.4), T::of(0.5))] => [None; 2];
    "edges in order": [Cone::from_half_angles(T::ZERO, T::of(0.5)), Cone::from_half_angles(T::ZERO, T::of(PI)),
        Cone::from_cosines(T::ONE, T::of(0.5)), Cone::from_cosines(T::ONE, -T::ONE)].map(|cone: Option<Cone<T>>| cone.is_some())
        => [true; 4];
    "cone of NaN": { let nan = trusted(x(T::NAN)); let cone = Cone::from_cosine(T::of(0.5)).expect("a cone");
        let soft = Cone::from_cosines(T::of(0.9), T::of(0.5)).expect("a cone"); [cone.factor(nan, UnitVec3::X),
        soft.factor(UnitVec3::X, nan), soft.smoothstep().factor(nan, nan)] }
        => [T::ONE; 3];
    // −0 is not below 0, so it may be the inner cosine; the width of such an edge is −0
    "edge between two zeros": [[0.0, 0.0], [0.0, -0.0], [-0.0, 0.0], [-0.0, -0.0]].map(of::<T, 2>)
        .map(|[inner, outer]| { let cone = Cone::from_cosines(inner, outer).expect("an edge"); [cone, cone.smoothstep()]
        .map(|cone| [-tiniest::<T>(), T::ZERO, tiniest()].map(|c| cone.factor(UnitVec3::NEG_X,
        trusted(Vec3::new(c, T::ZERO, T::ONE))))) })
        => [[[T::ZERO, T::ONE, T::ONE]; 2]; 4];
    "cones of 0 and π": [Cone::from_half_angle(T::ZERO), Cone::from_cosine(T::ONE), Cone::from_half_angle(T::of(PI)),
        Cone::from_cosine(-T::ONE)].map(|cone| cone.expect("a cone").cosines()[1].into())
        => [1.0 - 8.0 * T::U, 1.0 - 8.0 * T::U, -1.0, -1.0];
    // a cone of NaN, which no constructor makes
    "cone cast to NaN": Cone::from_cosine(T::of(0.5)).expect("a cone").cast(|_| T::NAN).factor(UnitVec3::X, UnitVec3::X) => T::ONE;

    // lights
    "lamp at the point": [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]]
        .map(|[a, b, c]| { let lamp = lamp(vector::<T>([1.0, 2.0, 3.0]), falloff(a, b, c)); [lamp.at(lamp.position).intensity(),
        spot(lamp, PI).at(lamp.position).intensity(), shine([lamp.at(lamp.position)])[1][1]] })
        => [[Rgb::<T>::BLACK; 3]; 3];
    "lamp at infinity": [T::INFINITY, -T::INFINITY, T::NAN].map(x)
        .map(|far| [lamp(far, Attenuation::NONE).at(Vec3::ZERO), lamp(Vec3::ZERO, Attenuation::NONE).at(far), lamp(far,
        Attenuation::NONE).at(far)].map(|light| (light.intensity(), shine([light]))))
        => [[(Rgb::<T>::BLACK, [[Rgb::<T>::BLACK; 3]; 2]); 3]; 3];
    "direction at any distance": sizes::<T>().map(|q| { let light = lamp(x(q), Attenuation::NONE).at(Vec3::ZERO); (light.l(),
        light.distance() == q, light.intensity()) })
        => [(UnitVec3::<T>::X, true, Rgb::<T>::WHITE); 5];
    // the square, root, reciprocal and product are off by 2.5u; the reciprocal of the distance adds 1u
    "attenuation at any distance": of::<T, 7>([T::TINIEST, T::MIN_POSITIVE, 1e-30, 1e-15, 1e15, 1e30, T::MAX.into()])
        .map(|q| near(lamp(x(q), falloff(0.0, 1.0, 0.0)).at(Vec3::ZERO).intensity().r, (T::ONE / q).at_most(T::MAX).into(), 4.0))
        => [true; 7];
    // √2 times the largest number counts as the largest: 1/q² is 0; the difference of two points may not overflow
    "distance that overflows": { let light = |falloff| lamp(Vec3::new(T::MAX, T::MAX, T::ZERO), falloff).at(Vec3::ZERO);
        (near(light(Attenuation::NONE).l().x, 0.5_f64.sqrt(), 3.0), light(Attenuation::NONE).distance(),
        light(Attenuation::NONE).intensity(), light(inverse_square()).intensity()) }
        => (true, T::MAX, Rgb::<T>::WHITE, Rgb::<T>::BLACK);
    "difference that overflows": { let light = lamp(x(T::MAX), Attenuation::NONE).at(x(-T::MAX)); (light.distance(), light.intensity(),
        shine([light])) }
        => (T::MAX, Rgb::<T>::BLACK, [[Rgb::<T>::BLACK; 3]; 2]);
    "distance of a sun": (sun(UnitVec3::<T>::Z).distance(), Light::from(DirectionalLight { l: UnitVec3::<T>::Z,
        intensity: Rgb::WHITE }).at(x(T::NAN)).distance())
        => (T::MAX, T::MAX);
    // q overflows, p is at the lamp, and a coordinate is not a number
    "distance at the ends": [[T::MAX, T::MAX, T::ZERO], [T::ZERO; 3], [T::ZERO, T::INFINITY, T::ZERO], [T::ZERO, T::NAN, T::ONE]]
        .map(|p| lamp(Vec3::ZERO, Attenuation::NONE).at(Vec3::from(p)).distance())
        => [T::MAX, T::ZERO, T::MAX, T::NAN];
    "intensity that overflows": { let bright = PointLight { intensity: Rgb::gray(T::MAX), ..lamp(x(T::of(0.5)), inverse_square()) };
        [bright.at(Vec3::ZERO).intensity(), spot(bright, 0.1).at(Vec3::ZERO).intensity()] }
        => [Rgb::gray(T::MAX); 2];
    "black lamp": [T::ZERO, tiniest(), T::of(T::MIN_POSITIVE)]
        .map(|q| PointLight { intensity: Rgb::BLACK, ..lamp(x(q), inverse_square()) }.at(Vec3::ZERO).intensity())
        => [Rgb::<T>::BLACK; 3];
    "lamp out of range": [T::MIN_POSITIVE.sqrt() / 16.0, 1.0, T::MAX.to_f64().sqrt() * 16.0].map(|r| [0.5, 1.0, 2.0]
        .map(|share| lamp(Vec3::new(T::ZERO, T::ZERO, T::of(share * r)),
        Attenuation::NONE.within(T::of(r)).expect("above 0")).at(Vec3::ZERO))
        .map(|light| (light.intensity().r > T::ZERO, shine([light])[0][0].r > T::ZERO)))
        => [[(true, true), (false, false), (false, false)]; 3];
    "direction of NaN": { let light = sun(trusted(x(T::NAN))); (light.is_in_front(UnitVec3::X), shine([light])) }
        => (false, [[Rgb::<T>::BLACK; 3]; 2]);
    "dimmed": [lamp(Vec3::ZERO, Attenuation::NONE).at(x(T::ONE)), sun(UnitVec3::X), spot(lamp(x(T::ONE), Attenuation::NONE),
        0.5).at(Vec3::ZERO)].map(|light| [(light * T::of(0.5)).intensity(), (light * rgb([0.0, 1.0, 2.0])).intensity()])
        => [[Rgb::gray(T::of(0.5)), rgb([0.0, 1.0, 2.0])]; 3];

    // the sum
    "no lights": [shade::lambert(UnitVec3::Z, &mirror(1), Rgb::gray(T::of(0.5)), []), shade::phong(UnitVec3::Z, UnitVec3::Z, &mirror(1),
        Rgb::gray(T::of(0.5)), []), shade::blinn_phong(UnitVec3::Z, UnitVec3::Z, &mirror(1), Rgb::gray(T::of(0.5)), [])]
        .map(|s| (s.ambient, s.total()))
        => [(Rgb::gray(T::of(0.5)), Rgb::gray(T::of(0.5))); 3];
    // the light is above, at 45°, and the eye is opposite it, below
    "opposite the eye": { let l = direction::<T>([1.0, 0.0, 1.0]); let s = shade::blinn_phong(UnitVec3::Z, -l, &mirror(0), Rgb::BLACK,
        [sun(l)]); (s.specular, s.diffuse == Rgb::gray(l.z)) }
        => (Rgb::<T>::BLACK, true);
    // H is Z, so N·H is 1, or 4/5 with two roundings for each factor, or below 0
    "nearly opposite the eye": [1.0, 3.0, 1e9].map(|c: f64| c * 2.0_f64.powi(-50))
        .map(|c| { let shine = |n, m, z: f64| shade::blinn_phong(n, -UnitVec3::X, &mirror(m), Rgb::BLACK,
        [sun(trusted(Vec3::new(T::ONE, T::ZERO, T::of(z * c))))]).specular.r; let n = direction::<T>([3.0, 0.0, 4.0]);
        (shine(UnitVec3::Z, 8, 1.0), shine(UnitVec3::Z, 9, 1.0), near(shine(n, 8, 1.0), 0.8_f64.powi(8), 32.0), shine(n, 8, -1.0)) })
        => [(T::ONE, T::ONE, true, T::ZERO); 3];
    // V is the mirror direction, and H is close to N
    "behind the surface": [[1.0, 0.0, -0.125], [1.0, 0.0, 0.0]].map(direction::<T>)
        .map(|l| { let n = UnitVec3::Z; [shade::phong(n, reflection(n, l), &mirror(1), Rgb::BLACK, [sun(l)]), shade::blinn_phong(n,
        direction([-1.0, 0.0, 0.5]), &mirror(0), Rgb::BLACK, [sun(l)])].map(Shaded::total) })
        => [[Rgb::<T>::BLACK; 2]; 2];
    "overflow on black": { let [k_a, k_d, k_s] = [Rgb::BLACK; 3]; shade::phong(UnitVec3::Z, UnitVec3::Z,
        &Material { k_a, k_d, k_s, m: 1 }, Rgb::gray(T::MAX), bright::<_, 2>(T::MAX)).total() }
        => Rgb::<T>::BLACK;
    "overflow": { let s = shade::phong(UnitVec3::Z, UnitVec3::Z, &mirror(1), Rgb::BLACK, bright::<_, 2>(T::MAX)); [s.diffuse,
        s.specular, s.total().clamped()] }
        => [Rgb::gray(T::MAX), Rgb::gray(T::MAX), Rgb::WHITE];
    "clamped": Rgb::new(T::NAN, T::INFINITY, -T::INFINITY).clamped() => rgb::<T>([0.0, 1.0, 0.0]);
    "dark and bright levels": [-0.0, 1e-45, -1e-45, -1.0, f32::MIN, f32::NEG_INFINITY, f32::NAN, f32::from_bits(u32::MAX),
        1.0 + f32::EPSILON, 1e30, f32::MAX, f32::INFINITY].map(|c| (Rgb::gray(c).to_srgb8(), Rgb::gray(c).to_rgb565(),
        Rgb::gray(c).to_linear8())).to_vec()
        => [[([0; 3], 0, [0; 3]); 8].as_slice(), &[([255; 3], u16::MAX, [255; 3]); 4]].concat();

    // dual numbers: the value is that of the plain number
    "dual root, logarithm, quotients at 0": [variable(T::ZERO).sqrt(), variable(T::ZERO).ln(), Dual::<T>::ONE / variable(T::ZERO),
        variable(T::ZERO).powi(-1), variable(T::ONE) / T::ZERO].map(slope)
        => [(T::ZERO, false), (-T::INFINITY, false), (T::INFINITY, false), (T::INFINITY, false), (T::INFINITY, false)];
    "dual root and logarithm below 0": [tiniest(), T::ONE, T::MAX].map(|x| [slope((-variable(x)).sqrt()), slope((-variable(x)).ln())])
        => [[(T::NAN, false); 2]; 3];
    "dual absolute value": [slope(variable(T::ZERO).abs()), slope((-variable(T::ONE)).sqrt().abs()),
        slope(Dual::constant(T::NAN).abs())].map(|(x, _)| x)
        => [T::ZERO, T::NAN, T::NAN];
    "dual absolute value is flat at 0": [variable(T::ZERO).abs().gradient, variable(T::ZERO).powi(0).gradient] => [Vec3::<T>::ZERO; 2];
    "dual absolute value of NaN": slope((-variable(T::ONE)).sqrt().abs()) => (T::NAN, false);
    "powers of 0": [variable(T::ZERO).powi(0).value, T::ZERO.powi(0), 1.raise(T::ZERO)] => [T::ONE, T::ONE, T::ZERO];
}
