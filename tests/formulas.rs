//! Every formula and every convention against a value derived by hand, for `f32` and `f64`. The
//! derivation stands over the row. The tolerance counts the roundings, in units u of 1 or of the largest
//! number of the row; 0 means to the bit.

#![allow(clippy::float_cmp)] // results without rounding are compared exactly

use std::f64::consts::{FRAC_1_PI, PI};

use kit::{Float, Number, Sink, Value, direction, rgb, vector};
use shading::{
    Attenuation, Cone, DirectionalLight, Dual, IncidentLight, Light, Lobe, Material, PointLight,
    Real, Rgb, Shaded, SpotLight, UnitVec3, Vec3, attenuation, half_vector, normal, reflection,
    shade, term,
};

/// Runs each row for `f32` and `f64`, and names those that fail.
macro_rules! table {
    ($($name:literal: $call:expr => $expected:expr, $units:literal;)*) => {
        fn rows<T: Float>() {
            let mut wrong = vec![];
            $({
                let (is, should) = (Numbers::of($call), Vec::from($expected));
                let size = should.iter().fold(1.0, |size: f64, x: &f64| size.max(x.abs()));
                let tolerance = $units * T::U * size;
                let is_near = |(a, b): (&f64, &f64)| a == b || (a - b).abs() <= tolerance;
                if is.len() != should.len() || !is.iter().zip(&should).all(is_near) {
                    wrong.push(format!("{}: {is:?} instead of {should:?}", $name));
                }
            })*
            assert!(wrong.is_empty(), "{}", wrong.join("\n"));
        }
    };
}

kit::for_f32_and_f64!(rows);

/// The numbers of a result; `None` has none, and a flag is 0 or 1.
#[derive(Default)]
struct Numbers(Vec<f64>);

impl Numbers {
    fn of(value: impl Value) -> Vec<f64> {
        let mut numbers = Self::default();
        value.give(&mut numbers);
        numbers.0
    }
}

impl Sink for Numbers {
    fn number(&mut self, number: impl Number) {
        self.0.push(number.double());
    }

    fn bytes<const N: usize>(&mut self, bytes: [u8; N]) {
        if &bytes[..] != b"none" {
            self.0.extend(bytes.map(f64::from));
        }
    }
}

/// L = (3, 0, 4)/5, at 36.87° from Z.
fn slanted<T: Float>() -> UnitVec3<T> {
    direction([3.0, 0.0, 4.0])
}

fn of<T: Real, const N: usize>(numbers: [f64; N]) -> [T; N] {
    numbers.map(T::of)
}

/// (x, y, z) as variables.
fn variables<T: Real>(p: [f64; 3]) -> [Dual<T>; 3] {
    Dual::point(vector(p)).into()
}

fn falloff<T: Float>(a: f64, b: f64, c: f64) -> Attenuation<T> {
    Attenuation::new(T::of(a), T::of(b), T::of(c)).expect("coefficients")
}

fn lamp<T: Real>(position: [f64; 3], attenuation: Attenuation<T>) -> PointLight<T> {
    let intensity = rgb([1.0, 0.5, 0.0]);
    PointLight {
        position: vector(position),
        intensity,
        attenuation,
    }
}

fn from<T: Real>(l: UnitVec3<T>) -> IncidentLight<T> {
    DirectionalLight {
        l,
        intensity: Rgb::WHITE,
    }
    .into()
}

fn material<T: Real, M>([k_a, k_d, k_s]: [f64; 3], m: M) -> Material<T, M> {
    let [k_a, k_d, k_s] = [k_a, k_d, k_s].map(|k| Rgb::gray(T::of(k)));
    Material { k_a, k_d, k_s, m }
}

/// A lamp two units above the origin, where ¼ of (1, ½, 0) arrives, and the slanted sun with
/// intensity ½. The eye is above. k_a I_a = 1/8 · 1/4.
fn two_lights<T: Float>() -> [IncidentLight<T>; 2] {
    let sun = DirectionalLight {
        l: slanted(),
        intensity: Rgb::gray(T::of(0.5)),
    };
    [
        lamp([0.0, 0.0, 2.0], falloff(0.0, 0.0, 1.0)).at(Vec3::ZERO),
        sun.at(Vec3::ZERO),
    ]
}

fn clay<T: Real>() -> (Material<T>, Rgb<T>) {
    (material([0.125, 0.5, 0.25], 2), Rgb::gray(T::of(0.25)))
}

/// The lamp shines down within 30°.
fn spot<T: Float>() -> SpotLight<T> {
    let point = lamp([0.0, 0.0, 2.0], falloff(0.0, 0.0, 1.0));
    let cone = Cone::from_half_angle(T::of(PI / 6.0)).expect("a half-angle");
    SpotLight {
        point,
        axis: UnitVec3::NEG_Z,
        cone,
    }
}

fn off_axis<T: Float>(degrees: f64) -> UnitVec3<T> {
    let (sine, cosine) = degrees.to_radians().sin_cos();
    direction([sine, 0.0, cosine])
}

/// (cos, sin, cosine) with exactly this z.
fn with_cosine<T: Real>(z: f64) -> UnitVec3<T> {
    UnitVec3::assume_unit(vector([(1.0 - z * z).sqrt(), 0.0, z]))
}

/// Whether the wall z = `height` stands between p and the light.
fn is_blocked<T: Float>(p: Vec3<T>, height: f64, light: IncidentLight<T>) -> bool {
    let t = (T::of(height) - p.z) / light.l().z;
    t > T::ZERO && t < light.distance()
}

fn shaded<T: Real>(x: f64) -> Shaded<T> {
    let [ambient, diffuse, specular] = [x, 2.0 * x, 4.0 * x].map(|x| Rgb::gray(T::of(x)));
    Shaded {
        ambient,
        diffuse,
        specular,
    }
}

/// 1 + u + u is 1, and u + u + 1 is 1 + 2u: the result shows the order.
fn in_order<V, T: Float>(value: impl Fn(f64) -> V, sum: impl Fn(Vec<V>) -> V) -> [V; 2] {
    [[1.0, T::U, T::U], [T::U, T::U, 1.0]].map(|terms| sum(terms.into_iter().map(&value).collect()))
}

fn gray<T: Real>(x: f64) -> Rgb<T> {
    Rgb::gray(T::of(x))
}

fn triangle<T: Real>() -> [Vec3<T>; 3] {
    [[1.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 3.0]].map(vector)
}

/// A triangle with the edges (2, 0, 0) and (0, 4, 3), and a map with the differences (1, 1) and (−1, 1).
fn mapped<T: Real>() -> ([Vec3<T>; 3], [[T; 2]; 3]) {
    let vertices = [[1.0, 0.0, 0.0], [3.0, 0.0, 0.0], [1.0, 4.0, 3.0]].map(vector);
    (vertices, [[2.0, 3.0], [3.0, 4.0], [1.0, 4.0]].map(of))
}

table! {
    // vectors and colors; (2·6 + 3·5, 3·4 − 1·6, −1·5 − 2·4)
    "vectors": { let [a, b] = [vector::<T>([1.0, 2.0, 3.0]), vector([4.0, -5.0, 6.0])]; [a + b, a - b, a * T::of(2.0), b / T::of(2.0),
        -a, a.cross(b), a.cross(a), a.lerp(b, T::of(0.25))] }

            => [5.0, -3.0, 9.0, -3.0, 7.0, -3.0, 2.0, 4.0, 6.0, 2.0, -2.5, 3.0, -1.0, -2.0, -3.0, 27.0, 6.0, -13.0, 0.0, 0.0, 0.0, 1.75,
                0.25, 3.75], 0.0;
    "dot product": vector::<T>([1.0, 2.0, 3.0]).dot(vector([4.0, -5.0, 6.0])) => [12.0], 0.0;
    // 2² + 3² + 6² = 7²
    "length, distance": [vector::<T>([2.0, -3.0, 6.0]).length(), vector::<T>([3.0, 1.0, 5.0]).distance(vector([1.0, 4.0, -1.0]))]
        => [7.0, 7.0], 0.0;
    "colors": { let [a, b] = [rgb::<T>([0.5, 1.0, 2.0]), rgb([0.25, 0.5, -4.0])]; [a + b, a - b, a * b, a * T::of(2.0), a / T::of(2.0),
        (a + b).clamped()] }
        => [0.75, 1.5, -2.0, 0.25, 0.5, 6.0, 0.125, 0.5, -8.0, 1.0, 2.0, 4.0, 0.25, 0.5, 1.0, 0.75, 1.0, 0.0], 0.0;
    // a quotient is that of a division, not of a multiplication by a rounded reciprocal
    "quotients": [(vector::<T>([7.0; 3]) / T::of(10.0)).y, (gray::<T>(7.0) / T::of(10.0)).g] => [T::of(0.7).into(); 2], 0.0;
    "assigned": { let (mut v, mut c, mut s) = (vector::<T>([1.0, 2.0, 3.0]), rgb::<T>([1.0, 2.0, 3.0]), shaded::<T>(1.0)); v += v;
        c += c; s += s; let all: [[T; 3]; 5] = [v.into(),
        c.into(), s.ambient.into(), s.diffuse.into(), s.specular.into()]; all }
        => [2.0, 4.0, 6.0, 2.0, 4.0, 6.0, 2.0, 2.0, 2.0, 4.0, 4.0, 4.0, 8.0, 8.0, 8.0], 0.0;
    "number first": { let both: [[T; 3]; 2] = [T::of(0.5).times_vector(vector([1.0, -2.0, 6.0])).into(),
        T::of(0.5).times_rgb(rgb([1.0, 0.0, 6.0])).into()]; both }
        => [0.5, -1.0, 3.0, 0.5, 0.0, 3.0], 0.0;
    "sums of vectors": in_order::<_, T>(|x| vector::<T>([x; 3]), |v| v.into_iter().sum()).map(|v| [v.x, v.z])
        => [1.0, 1.0, 1.0 + 2.0 * T::U, 1.0 + 2.0 * T::U], 0.0;
    "sums of colors": in_order::<_, T>(gray::<T>, |c| c.into_iter().sum()).map(|c| [c.r, c.b])
        => [1.0, 1.0, 1.0 + 2.0 * T::U, 1.0 + 2.0 * T::U], 0.0;
    "sums of results": in_order::<_, T>(shaded::<T>, |s| s.into_iter().sum()).map(|s: Shaded<T>| [s.ambient.r, s.specular.b])
        => [1.0, 4.0, 1.0 + 2.0 * T::U, 4.0 + 8.0 * T::U], 0.0;
    "sums of nothing": [[].into_iter().sum::<Vec3<T>>().x, [].into_iter().sum::<Rgb<T>>().g, [].into_iter().sum::<Shaded<T>>().total().b]
        => [0.0; 3], 0.0;
    "axes": [UnitVec3::<T>::X, UnitVec3::Y, UnitVec3::Z, UnitVec3::NEG_X, UnitVec3::NEG_Y, UnitVec3::NEG_Z, -UnitVec3::X]
        => [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, -1.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, -1.0, -1.0, 0.0, 0.0], 0.0;
    "directions as vectors": [UnitVec3::X * T::of(2.0), Vec3::ZERO + UnitVec3::Y, Vec3::ZERO - UnitVec3::<T>::Z, Vec3::splat(T::ONE)]
        => [2.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, -1.0, 1.0, 1.0, 1.0], 0.0;
    "results": { let s = shaded::<T>(1.0) + shaded(10.0) * T::of(0.5); [s.ambient, s.diffuse, s.specular, s.total()].map(|c| c.g) }
        => [6.0, 12.0, 24.0, 42.0], 0.0;

    // directions: N = (3, 0, 4)/5, L = Z: N·L = 4/5, R = 8/5 (3, 0, 4)/5 − (0, 0, 1) = (24, 0, 7)/25
    "R in a tilted normal": reflection(slanted::<T>(), UnitVec3::Z) => [0.96, 0.0, 0.28], 11.0;
    "R of either side": [reflection(UnitVec3::<T>::Z, slanted()), reflection(-UnitVec3::Z, slanted())]
        .map(|r| *r - Vec3::new(-slanted::<T>().x, T::ZERO, slanted().z))
        => [0.0; 6], 0.0;
    // GLSL: reflect(I, N) = I − 2(N·I)N
    "GLSL's reflect takes −L": { let (n, i) = (UnitVec3::<T>::Z, -slanted::<T>()); *i - *n * (T::of(2.0) * n.dot(i)) - *reflection(n,
        slanted()) }
        => [0.0; 3], 0.0;
    // (2, 1, 2)/3 + (1, 2, 2)/3 = (3, 3, 4)/3, of length √34/3
    "H of two directions": half_vector(direction::<T>([2.0, 1.0, 2.0]), direction([1.0, 2.0, 2.0]))
        => [3.0, 3.0, 4.0].map(|c| c / 34.0_f64.sqrt()), 8.0;
    "H of two axes": half_vector(UnitVec3::<T>::X, UnitVec3::Z) => [0.5_f64.sqrt(), 0.0, 0.5_f64.sqrt()], 2.0;

    // terms; L = (√3/2, 0, ½): normalizing adds an error of 3.5u of ½
    "lambert at 60°": [term::lambert(UnitVec3::Z, direction::<T>([3.0_f64.sqrt(), 0.0, 1.0])), term::lambert(UnitVec3::Z,
        -slanted::<T>()), term::lambert(UnitVec3::Z, UnitVec3::Z)]
        => [0.5, 0.0, 1.0], 2.0;
    "ambient": term::ambient(rgb::<T>([0.5, 0.25, 0.0]), rgb([0.5, 2.0, 3.0])) => [0.25, 0.5, 0.0], 0.0;
    // R·V = 4/5: its square is 16/25 and its cube 64/125
    "phong, 3-4-5": [term::phong(slanted::<T>(), UnitVec3::Z, 2), term::phong(slanted(), UnitVec3::Z, 3), term::phong(slanted(),
        UnitVec3::Z, 1)]
        => [0.64, 0.512, 0.8], 12.0;
    "phong, 3-4-5, real m": [2.0, 3.0, 0.5].map(|m| term::phong(slanted::<T>(), UnitVec3::Z, T::of(m)))
        => [0.64, 0.512, 0.8_f64.sqrt()], 16.0;
    // L·V = 4/5, |L + V|² = 2 + 8/5 = 18/5, N·H = (4/5 + 1)/√(18/5) = √(9/10)
    "blinn, 3-4-5": { let h = half_vector(slanted::<T>(), UnitVec3::Z).expect("halfway"); [term::blinn(UnitVec3::Z, h, 2),
        term::blinn(UnitVec3::Z, h, 4), term::blinn(UnitVec3::Z, h, T::of(4.0))] }
        => [0.9, 0.81, 0.81], 36.0;
    // the light is behind the surface: the factor alone does not know
    "factors are not gated": { let (n, l) = (UnitVec3::<T>::Z, -UnitVec3::Z); let r = reflection(n, l); [term::phong(r, r, 3),
        term::blinn(n, n, 3), term::lambert(n, l)] }
        => [1.0, 1.0, 0.0], 0.0;
    "powers of a half": [0_u32, 1, 2, 3, 10, 25, 99, 100].map(|m| m.raise(T::of(0.5)))
        => [0, 1, 2, 3, 10, 25, 99, 100].map(|m| 0.5_f64.powi(m)), 0.0;
    "powers of the root of a quarter": [0_u32, 1, 2, 5, 64, 65, 100].map(|m| m.raise_root(T::of(0.25)))
        => [0, 1, 2, 5, 64, 65, 100].map(|m| 0.5_f64.powi(m)), 0.0;
    // (2 + 2)/(2π) = 2/π; (6 + 2)/(2π) = 4/π; 3.5/(2π)
    "normalization of phong": [2.0, 6.0, 1.5].map(|m| term::phong_normalization(T::of(m))) => [2.0, 4.0, 1.75].map(|k| k * FRAC_1_PI), 6.0;
    // 4·6/(8π(½ + 2)) = 1.2/π; 8·10/(8π(⅛ + 6)) = 80/(49π); 3.5·5.5/(8π(2^(−¾) + 1.5))
    "normalization of blinn": [2.0, 6.0, 1.5].map(|m| term::blinn_normalization(T::of(m)))
        => [1.2, 80.0 / 49.0, 3.5 * 5.5 / 8.0 / (0.5_f64.powf(0.75) + 1.5)].map(|k| k * FRAC_1_PI), 8.0;

    // falloff: 1 + ½·2 + ¼·2² = 3; 1 + 2·4 + ½·16 = 17; q is the distance, and the factor is not clamped
    "attenuation": [attenuation(T::ONE, T::of(0.5), T::of(0.25), T::of(2.0)), falloff(1.0, 0.5, 0.25).at(T::of(2.0)), falloff(1.0, 2.0,
        0.5).at(T::of(4.0)), falloff(0.0, 0.0, 1.0).at(T::of(0.25))]
        => [1.0 / 3.0, 1.0 / 3.0, 1.0 / 17.0, 16.0], 0.1;
    "clamped": [0.25, 2.0].map(|q| falloff::<T>(0.0, 0.0, 1.0).clamped().at(T::of(q))) => [1.0, 0.25], 0.0;
    "coefficients": falloff::<T>(0.25, 0.0, 3.0).clamped().coefficients() => [0.25, 0.0, 3.0], 0.0;
    "kinds of falloff": { let free = falloff::<T>(1.0, 0.0, 0.0); let ranged = free.within(T::of(4.0)).expect("a range");
        [free.limit() == T::MAX, free.clamped().limit() == T::ONE, ranged.clamped().is_gltf(), free.within_gltf(T::of(4.0)).expect("a range").is_gltf(),
        Attenuation::<T>::default() == free, ranged.range() == T::of(4.0), free.range() == T::MAX] }
        => [1.0, 1.0, 0.0, 1.0, 1.0, 1.0, 1.0], 0.0;
    // 1/(1 + 4/4) (1 − (2/4)⁴)² = ½ (15/16)²; as glTF has it, ½ 15/16
    "halfway to the range": { let free = falloff::<T>(1.0, 0.0, 0.25); let ranged = free.within(T::of(4.0)).expect("a range"); [ranged.at(T::of(2.0)),
        free.within_gltf(T::of(4.0)).expect("a range").at(T::of(2.0)), ranged.at(T::of(4.0))] }
        => [225.0 / 512.0, 15.0 / 32.0, 0.0], 0.0;
    // one range after another replaces it; the order of the steps does not matter
    "steps of a falloff": { let free = falloff::<T>(0.0, 0.0, 1.0); let r = T::of(4.0);
        [free.within_gltf(r).expect("a range").clamped() == free.clamped().within_gltf(r).expect("a range"),
        free.within(T::ONE).expect("a range").within(r) == free.within(r)] }
        => [1.0, 1.0], 0.0;

    // cones: with a half-angle of 45°, a direction 44° off the axis is inside, and one 46° off is not
    "half-angle": { let cone = Cone::from_half_angle(T::of(PI / 4.0)).expect("a half-angle"); [44.0, 46.0]
        .map(|degrees| cone.factor(UnitVec3::NEG_Z, off_axis(degrees))) }
        => [1.0, 0.0], 0.0;
    "the edge is lit": { let cone = Cone::from_cosine(T::of(0.5)).expect("a cosine"); [0.5, 0.5 - T::U]
        .map(|cosine| cone.factor(UnitVec3::NEG_Z, with_cosine(cosine))) }
        => [1.0, 0.0], 0.0;
    "cosines": [Cone::from_half_angles(T::ZERO, T::of(PI / 2.0)), Cone::from_cosine(T::of(0.5)), Cone::from_cosines(T::of(0.75),
        T::of(0.25))].map(|cone| cone.expect("a cone").cosines())
        => [1.0 - 8.0 * T::U, 0.0, 0.5, 0.5, 0.75, 0.25], 1.0;
    // the cosines go from 1 (less 4ε) down to 0.6, and L is at 0.8: t = ½, t² = ¼, t²(3 − 2t) = ½; at 0.7, t = ¼ and t²(3 − 2t) = 5/32
    "soft edge": { let cone = Cone::from_cosines(T::ONE, T::of(0.6)).expect("cosines"); [(cone, 0.8), (cone.smoothstep(), 0.8),
        (cone, 0.7), (cone.smoothstep(), 0.7)].map(|(cone, z)| cone.factor(UnitVec3::NEG_Z, with_cosine(z))) }
        => [0.25, 0.5, 0.0625, 5.0 / 32.0], 40.0;
    "kinds of cones": { let hard = Cone::from_cosine(T::of(0.5)).expect("a cosine"); let soft = Cone::from_cosines(T::of(0.5),
        T::ZERO).expect("cosines"); [soft.is_smoothstep(), soft.smoothstep().is_smoothstep(), hard.smoothstep() != hard] }
        => [0.0, 1.0, 0.0], 0.0;

    // lights
    "a light gives the way to it": lamp::<T>([0.0, 0.0, 2.0], Attenuation::NONE).at(Vec3::ZERO) => [0.0, 0.0, 1.0, 1.0, 0.5, 0.0, 2.0], 0.0;
    "a sun is the same everywhere": DirectionalLight::<T> { l: UnitVec3::Z,
        intensity: rgb([2.0, 1.0, 0.5]) }.at(vector([1e30, -1e30, 1e30]))
        => [0.0, 0.0, 1.0, 2.0, 1.0, 0.5, T::MAX.into()], 0.0;
    "a lamp with a range": lamp::<T>([0.0, 0.0, 2.0], falloff(1.0, 0.0,
        0.25).within(T::of(4.0)).expect("a range")).at(Vec3::ZERO).intensity()
        => [225.0 / 512.0, 225.0 / 1024.0, 0.0], 0.0;
    // (1, 0, 0) and (1.2, 0, 0) are 2 below the lamp: arctan ½ = 26.6°, arctan 0.6 = 31.0°; 1/(4 + 1) = 0.2
    "a spot": [spot::<T>().at(vector([1.0, 0.0, 0.0])).intensity(), spot().at(vector([1.2, 0.0, 0.0])).intensity()]
        => [0.2, 0.1, 0.0, 0.0, 0.0, 0.0], 4.0;
    "a spot is a lamp": { let p = vector::<T>([1.0, 0.0, 0.0]); let (spot, lamp) = (spot::<T>().at(p), spot().point.at(p));
        [*spot.l() - *lamp.l(), Vec3::from(<[T; 3]>::from(spot.intensity() - lamp.intensity()))] }
        => [0.0; 6], 0.0;
    "any kind": { let (p, l) = (vector::<T>([1.0, 0.0, 0.0]), slanted()); let sun = DirectionalLight { l, intensity: Rgb::WHITE };
        [Light::from(sun).at(p) == sun.at(p), Light::from(spot()).at(p) == spot().at(p),
        Light::from(spot().point).at(p) == spot().point.at(p)] }
        => [1.0; 3], 0.0;
    "in front": [UnitVec3::<T>::Z, UnitVec3::X, UnitVec3::NEG_Z].map(|n| from(UnitVec3::Z).is_in_front(n)) => [1.0, 0.0, 0.0], 0.0;
    // the lamp is two units to the side and two up: a wall at height 1 is before it, one at 3 behind
    "shadows end at the lamp": { let p = vector::<T>([1.0, 0.0, 0.0]); let lamp = lamp([3.0, 0.0, 2.0], Attenuation::NONE);
        [is_blocked(p, 1.0, lamp.at(p)), is_blocked(p, 3.0, lamp.at(p))] }
        => [1.0, 0.0], 0.0;
    "any wall hides the sun": [1e30, -1.0].map(|height| is_blocked::<T>(Vec3::ZERO, height, from(UnitVec3::Z))) => [1.0, 0.0], 0.0;
    "a scene in another number": { let plain = spot::<T>().at(vector([1.0, 0.0, 0.5]));
        let dual = spot::<T>().cast(Dual::constant).at(vector([1.0, 0.0, 0.5])); let cast = plain.cast(Dual::constant);
        [dual.intensity() == plain.intensity().map(Dual::constant), dual.l() == cast.l(), dual.distance() == cast.distance(),
        cast.intensity() == dual.intensity()] }
        => [1.0; 4], 0.0;

    // the sum: N·L = 1 and 4/5: ½ (¼ + ½ · ⅘) = 0.325, ½ (⅛ + ⅖) = 0.2625, ½ · ⅖ = 0.2
    "two lights, lambert": { let (clay, i_a) = clay(); shade::lambert(UnitVec3::Z, &clay, i_a, two_lights::<T>()) }
        => [0.03125, 0.03125, 0.03125, 0.325, 0.2625, 0.2, 0.0, 0.0, 0.0], 4.0;
    // (R·V)² = 1 and 16/25: ¼ (¼ + ½ · 0.64) = 0.1425, ¼ (⅛ + 0.32) = 0.11125, ¼ · 0.32
    "two lights, phong": { let (clay, i_a) = clay(); let s = shade::phong(UnitVec3::Z, UnitVec3::Z, &clay, i_a, two_lights::<T>());
        [s.specular, s.total()] }
        => [0.1425, 0.11125, 0.08, 0.498_75, 0.405, 0.311_25], 16.0;
    // (N·H)² = 1 and 9/10: ¼ (¼ + ½ · 0.9) = 0.175, ¼ (⅛ + 0.45) = 0.14375, ¼ · 0.45
    "two lights, blinn": { let (clay, i_a) = clay(); let s = shade::blinn_phong(UnitVec3::Z, UnitVec3::Z, &clay, i_a,
        two_lights::<T>()); [s.ambient, s.diffuse, s.specular] }
        => [0.03125, 0.03125, 0.03125, 0.325, 0.2625, 0.2, 0.175, 0.143_75, 0.1125], 8.0;
    "directions point away": [UnitVec3::<T>::Z, -UnitVec3::Z].map(|l| {
        let s = shade::phong(UnitVec3::Z, UnitVec3::Z, &material([1.0; 3], 5), Rgb::BLACK, [from(l)]); [s.diffuse.r, s.specular.r] })
        => [1.0, 1.0, 0.0, 0.0], 0.0;
    "colors are clamped by the caller": { let s = shade::lambert(UnitVec3::Z, &material([1.0; 3], 1), Rgb::WHITE,
        [from(UnitVec3::<T>::Z); 3]); [s.total().r, s.total().clamped().r] }
        => [4.0, 1.0], 0.0;
    "ambient counts once": [0, 1, 3].map(|count| shade::lambert(UnitVec3::Z, &material([0.5; 3], 1), gray(0.5),
        std::iter::repeat_n(from(UnitVec3::<T>::Z), count)).ambient.r)
        => [0.25; 3], 0.0;
    "parts are apart": [shade::phong(UnitVec3::Z, UnitVec3::Z, &material([0.25, 0.5, 0.125], 3), Rgb::WHITE, [from(UnitVec3::<T>::Z)]),
        shade::blinn_phong(UnitVec3::Z, UnitVec3::Z, &material([0.25, 0.5, 0.125], 3), Rgb::WHITE, [from(UnitVec3::Z)])]
        .map(|s| [s.ambient.r, s.diffuse.g, s.specular.b, s.total().r])
        => [0.25, 0.5, 0.125, 0.875, 0.25, 0.5, 0.125, 0.875], 0.0;
    "a shadow is a filter": { let lights = [from(UnitVec3::<T>::Z), from(slanted())]; shade::lambert(UnitVec3::Z,
        &material([1.0; 3], 1), Rgb::BLACK, lights.into_iter().filter(|light| light.l() == UnitVec3::Z)).diffuse.r }
        => [1.0], 0.0;
    "a falloff of one's own is a map": { let sun = lamp::<T>([0.0, 0.0, 4.0], Attenuation::NONE).at(Vec3::ZERO);
        shade::lambert(UnitVec3::Z, &material([1.0; 3], 1), Rgb::BLACK, [sun]
        .map(|light| light * (T::ONE / light.distance()))).diffuse }
        => [0.25, 0.125, 0.0], 0.0;

    // normals: 6² + 3² + 2² = 7²; (−1, 2, 0) × (−1, 0, 3) = (6, 3, 2); ∇(xyz) = (yz, xz, xy), at (1, 2, 3)
    "normals of a box with the diagonal 7": { let [a, b, c] = triangle::<T>(); let product = |p: Vec3<Dual<T>>| p.x * p.y * p.z;
        [normal::plane(T::of(6.0), T::of(3.0), T::of(2.0)), normal::triangle(a, b, c), normal::sphere(vector([1.0; 3]),
        vector([7.0, 4.0, 3.0])), normal::implicit(product, vector([1.0, 2.0, 3.0])), normal::from_gradient(vector([6.0, 3.0, 2.0])),
        normal::from_tangents(b - a, c - a)] }
        => [[6.0 / 7.0, 3.0 / 7.0, 2.0 / 7.0]; 6].concat(), 3.5;
    // (1, 0, 0) × (0, 1, 0) = (0, 0, 1)
    "counter-clockwise": { let [a, b, c] = [[0.0, 0.0, 5.0], [1.0, 0.0, 5.0], [0.0, 1.0, 5.0]].map(vector::<T>);
        [normal::triangle(a, b, c), normal::triangle(b, c, a), normal::triangle(a, c, b)].map(|n| n.map(|n| n.z)) }
        => [1.0, 1.0, -1.0], 0.0;
    // s = (u, v, uv): S_u × S_v = (1, 0, v) × (0, 1, u) = (−v, −u, 1), at (2, 2); exchanged, the opposite
    "normal of a saddle": { let two = T::of(2.0); [normal::parametric(|u, v| Vec3::new(u, v, u * v), two, two), normal::parametric(|v,
        u| Vec3::new(u, v, u * v), two, two)] }
        => [-2.0 / 3.0, -2.0 / 3.0, 1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0, -1.0 / 3.0], 3.5;
    // GLSL: faceforward(N, I, N_ref) = N where N_ref·I < 0, else −N; edge-on, the two differ
    "facing": [slanted::<T>(), -slanted(), UnitVec3::X].map(|n| { let (v, f) = (UnitVec3::Z, normal::facing(n, UnitVec3::Z));
        let glsl = if n.dot(-v) < T::ZERO { n } else { -n }; [f == slanted(), f == n, f == glsl] })
        => [1.0, 1.0, 1.0, 1.0, 0.0, 1.0, 0.0, 1.0, 0.0], 0.0;
    // the cofactors of diag(½, 1, 1) are diag(1, ½, ½), which turn (3, 0, 4)/5 into (3, 0, 2)/√13
    "roof half as wide": normal::transformed(slanted::<T>(), [[0.5, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(vector))
        => [3.0 / 13.0_f64.sqrt(), 0.0, 2.0 / 13.0_f64.sqrt()], 12.0;
    // as columns: (x, y) ↦ (x + 2y, y) leaves a wall x = 0 … and its normal (1, −2, 0)/√5
    "sheared": normal::transformed(UnitVec3::<T>::X, [[1.0, 0.0, 0.0], [2.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(vector))
        => [1.0 / 5.0_f64.sqrt(), -2.0 / 5.0_f64.sqrt(), 0.0], 4.0;
    // mirrored in x = 0: a triangle in that plane stays, where the inverse transpose reverses its normal; a roof slopes the other way
    "mirrored": [UnitVec3::<T>::X, slanted()].map(|n| normal::transformed(n, [[-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
        .map(vector)))
        => [1.0, 0.0, 0.0, 0.6, 0.0, -0.8], 8.0;
    // 90°, 60° and 30°, seen from above; each angle is off by 8 roundings
    "corners of half an equilateral triangle": { let [a, b, c] = [[0.0, 0.0, 0.0], [3.0_f64.sqrt(), 0.0, 0.0], [0.0, 1.0, 0.0]]
        .map(vector::<T>); [normal::corner(a, b, c), normal::corner(c, a, b), normal::corner(b, c, a)] }
        => [0.0, 0.0, PI / 2.0, 0.0, 0.0, PI / 3.0, 0.0, 0.0, PI / 6.0], 16.0;
    // d = 2, T = (e₁ − e₂)/2 = (2, −4, −3)/2, of length √29/2; with the last two exchanged, d = −2
    "tangent of a slanted map": { let (vertices, [a, b, c]) = mapped::<T>(); [normal::tangent(vertices, [a, b, c]),
        normal::tangent(vertices, [a, c, b])].map(|t| t.map(|(t, h)| [t.x, t.y, t.z, h])) }
        => [[2.0, -4.0, -3.0, 29.0_f64.sqrt()], [-2.0, 4.0, 3.0, -29.0_f64.sqrt()]].concat().iter()
            .map(|c| c / 29.0_f64.sqrt()).collect::<Vec<_>>(), 8.0;
    // T = (2, 0, 1), whose component along N is 2N: t = (4, 0, −3)/5, N × t = (0, 1, 0); (t ± 2(0, 1, 0) + 2N)/3
    "sample of a normal map": [T::ONE, -T::ONE].map(|h| normal::mapped(slanted(), vector([2.0, 0.0, 1.0]), h, vector([1.0, 2.0, 2.0])))
        => [2.0, 2.0, 1.0, 2.0, -2.0, 1.0].map(|c| c / 3.0), 24.0;
    // T need not be perpendicular to N, and a sample below the surface is used as it is
    "any tangent, any sample": [normal::mapped(UnitVec3::<T>::Z, vector([1.0, 0.0, 5.0]), T::ONE, vector([3.0, 0.0, 4.0])),
        normal::mapped(UnitVec3::Z, *UnitVec3::X, T::ONE, vector([0.0, -3.0, -4.0]))]
        => [0.6, 0.0, 0.8, 0.0, -0.6, -0.8], 8.0;

    // dual numbers: x = 2, y = 3, z = −1; ∂/∂x x²y/(x + y) = (2xy(x + y) − x²y)/(x + y)² = 48/25, ∂/∂y = x³/(x + y)² = 8/25
    "dual sums and products": { let [x, y, z] = variables::<T>([2.0, 3.0, -1.0]); [x + y - z, x * y * z, -x] }
        => [6.0, 1.0, 1.0, -1.0, -6.0, -3.0, -2.0, 6.0, -2.0, -1.0, 0.0, 0.0], 0.0;
    "dual quotient": { let [x, y, _] = variables::<T>([2.0, 3.0, -1.0]); x * x * y / (x + y) } => [2.4, 1.92, 0.32, 0.0], 16.0;
    "dual and plain": { let [x, y, _] = variables::<T>([2.0, 3.0, -1.0]); let two = T::of(2.0); [x + two, y - two, y * two, y / two,
        (x * y).chain(T::ONE, T::of(5.0)), Dual::constant(two)] }
        => [4.0, 1.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 6.0, 0.0, 2.0, 0.0, 1.5, 0.0, 0.5, 0.0, 1.0, 15.0, 10.0, 0.0, 2.0, 0.0, 0.0, 0.0], 0.0;
    // 3 + x, 3 − x, 3x and 3/x, whose slope is −3/x²
    "plain before dual": T::of(3.0).before(variables::<T>([2.0, 3.0, -1.0])[0]).map(|d| [d.value, d.gradient.x])
        => [5.0, 1.0, 1.0, -1.0, 6.0, 3.0, 1.5, -0.75], 0.0;
    "dual points and plain vectors": { let p = Dual::point(vector::<T>([2.0, 3.0, -1.0])); let o = vector::<T>([1.0, 1.0, 1.0]);
        [(p + o).x, (p - o).y] }
        => [3.0, 1.0, 0.0, 0.0, 2.0, 0.0, 1.0, 0.0], 0.0;
    "duals are compared by value": { let [x, y, _] = variables::<T>([2.0, 3.0, -1.0]); [x < y, x == Dual::constant(T::of(2.0)),
        x == y] }
        => [1.0, 1.0, 0.0], 0.0;
    // libm is right to 1 ulp, which is 2u of a value less than 8
    "dual functions": { let [x, ..] = variables::<T>([2.0, 3.0, -1.0]); [x.sin(), x.cos(), x.exp(), x.ln()]
        .map(|d| [d.value, d.gradient.x]) }
        => { let (sine, cosine) = 2.0_f64.sin_cos(); [sine, cosine, cosine, -sine, 2.0_f64.exp(), 2.0_f64.exp(), 2.0_f64.ln(), 0.5] },
            2.0;
    // √(xy + z + 11) = 4: ∇ = (y, x, 1)/8
    "dual root and absolute value": { let [x, y, z] = variables::<T>([2.0, 3.0, -1.0]); [(x * y + z + T::of(11.0)).sqrt(), z.abs(),
        y.abs()] }
        => [4.0, 0.375, 0.25, 0.125, 1.0, 0.0, 0.0, -1.0, 3.0, 0.0, 1.0, 0.0], 0.0;
    // xⁿ and n xⁿ⁻¹ at 2, where every power is a power of two
    "dual powers": [-10, -1, 0, 1, 2, 7, 10].map(|n| { let d = variables::<T>([2.0, 3.0, -1.0])[0].powi(n); [d.value, d.gradient.x] })
        => [-10, -1, 0, 1, 2, 7, 10].map(|n| [2.0_f64.powi(n), f64::from(n) * 2.0_f64.powi(n - 1)]).concat(), 0.0;
    // (cᵐ)′ = m cᵐ⁻¹, which is m at c = 1, also for an m of more than 16 bits
    "slope of a large power": [65_535_u32, 65_536, 100_001].map(|m| m.raise(variables::<T>([1.0, 0.0, 0.0])[0]).gradient.x)
        => [65_535.0, 65_536.0, 100_001.0], 0.0;
    // 1/q² changes by −2/q³; where Foley's limit holds, the light is constant
    "slope of a lamp": [0.5, 2.0].map(|q| [falloff::<T>(0.0, 0.0, 1.0), falloff(0.0, 0.0, 1.0).clamped()]
        .map(|falloff| lamp([0.0; 3], falloff).cast(Dual::constant).at(Dual::point(vector([0.0, 0.0, q]))).intensity().r.gradient.z))
        => [-16.0, 0.0, -0.25, -0.25], 0.0;
    "of dual duals": { let x = Dual::point(variables::<T>([2.0, 0.0, 0.0]).into()).x; (x * x * x).gradient.x }
        => [12.0, 12.0, 0.0, 0.0], 0.0;
}

/// The cosine of L is c = ½ + kε, exactly, and both differences in t = (c − ½)/(inner − ½) are exact. The
/// quotient is off by 1u of itself, its square by 3u.
#[test]
fn a_faint_edge_keeps_its_digits() {
    for inner in [0.7_f32, 0.8, 0.9, 0.95] {
        let cone = Cone::from_cosines(inner, 0.5).expect("cosines");
        for k in (0..20).map(|i| f64::exp2(f64::from(i)) + 1.0) {
            let t = k * f64::from(f32::EPSILON) / (f64::from(inner) - 0.5);
            let l = with_cosine(0.5 + k * f64::from(f32::EPSILON));
            let factor = f64::from(cone.factor(UnitVec3::NEG_Z, l));
            assert!(
                (factor / (t * t) - 1.0).abs() <= 4.0 * f32::U,
                "{inner} {k}"
            );
        }
    }
}

/// Each short name is the type for that number, and needs no other parameter.
macro_rules! short_names {
    ($($float:ident: $($name:ident)*;)*) => {$($(
        const _: fn(shading::$float::$name) -> shading::$name<$float> = |value| value;
    )*)*};
}

short_names! {
    f32: Vec3 UnitVec3 Rgb Dual Attenuation Cone IncidentLight DirectionalLight PointLight SpotLight Light Material Shaded;
    f64: Vec3 UnitVec3 Rgb Dual Attenuation Cone IncidentLight DirectionalLight PointLight SpotLight Light Material Shaded;
}
const _: fn(shading::f32::Material<f32>) -> Material<f32, f32> = |material| material;

/// `approx` looks at every number, and its defaults mean the same as for floats.
#[cfg(feature = "approx")]
#[test]
fn approximate_comparison_looks_at_every_number() {
    use approx::{AbsDiffEq, RelativeEq, UlpsEq};

    fn looks<V, const N: usize>(value: impl Fn([f64; N]) -> V)
    where
        V: AbsDiffEq<Epsilon = f64> + RelativeEq + UlpsEq,
    {
        let one = value([1.0; N]);
        for i in 0..N {
            let with = |component: f64| {
                value(std::array::from_fn(
                    |j| if i == j { component } else { 1.0 },
                ))
            };
            let [more, double, three_up] = [1.5, 2.0, 1.0 + 3.0 * f64::EPSILON].map(with);
            assert!(one.abs_diff_eq(&more, 0.5) && !one.abs_diff_eq(&more, 0.25));
            // they differ by 1, which is half of 2
            assert!(one.relative_eq(&double, 0.0, 0.5) && !one.relative_eq(&double, 0.0, 0.25));
            assert!(one.ulps_eq(&three_up, 0.0, 3) && !one.ulps_eq(&three_up, 0.0, 2));
        }
        assert!(V::default_epsilon() <= f64::EPSILON && V::default_epsilon() >= f64::EPSILON);
        assert!(V::default_max_ulps() == f64::default_max_ulps());
        let relative = V::default_max_relative() - f64::default_max_relative();
        assert!(relative.abs() <= 0.0);
    }

    looks(Vec3::from);
    looks(|xyz| UnitVec3::assume_unit(Vec3::from(xyz)));
    looks(Rgb::from);
    looks(|[a, b, c, d, e, f, g, h, i]| Shaded {
        ambient: Rgb::new(a, b, c),
        diffuse: Rgb::new(d, e, f),
        specular: Rgb::new(g, h, i),
    });
}
