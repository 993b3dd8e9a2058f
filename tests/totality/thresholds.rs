//! What holds for every size, tried where it could end: at the squared length from which vectors are
//! scaled, at the least numbers, and at the largest. Each test climbs, or goes from number to number.

use kit::Float;
use kit::random::Random;
use shading::{Attenuation, Lobe, PointLight, Rgb, UnitVec3, Vec3, normal};

kit::for_f32_and_f64!(
    a_constant_direction_has_the_bits_of_the_vectors_at_the_threshold,
    a_light_is_in_front_at_every_distance_that_the_page_names,
    tangents_have_a_normal_unless_they_are_parallel,
    columns_of_any_size_give_the_normal,
    a_map_of_any_size_gives_the_tangent,
    a_whole_power_has_its_digits_down_to_the_least_normal_number,
);

/// The exponent of the least size for which everything holds.
fn least<T: Float>() -> i32 {
    if T::NAME == "f32" { -120 } else { -1000 }
}

/// The exponent of the largest number.
fn largest<T: Float>() -> i32 {
    if T::NAME == "f32" { 127 } else { 1023 }
}

fn power<T: Float>(exponent: i32) -> T {
    T::of(f64::from(exponent).exp2())
}

/// A square of exactly p or 1/p is scaled by both or by neither.
fn a_constant_direction_has_the_bits_of_the_vectors_at_the_threshold<T: Float>() {
    #[allow(clippy::cast_possible_truncation)] // 50 or 360
    let root = (Into::<f64>::into(T::EXTREME).log2() / 2.0) as i32;
    for threshold in [root, -root] {
        for steps in -4..=4 {
            let x = power::<T>(threshold) * T::of(1.0 + 2.0 * f64::from(steps) * T::U);
            for exponent in threshold - 2 * root..=threshold {
                for y in [1.0, 1.5, 1.25, -1.75].map(|y| T::of(y) * power(exponent)) {
                    let v = Vec3::new(x, y, T::ZERO);
                    let [constant, unit] = [T::const_unit(v), v.unit()];
                    assert_eq!(format!("{constant:?}"), format!("{unit:?}"), "{v:?}");
                }
            }
        }
    }
}

/// N·L is off by 3u. What is in front by more than that is in front however near the light is.
fn a_light_is_in_front_at_every_distance_that_the_page_names<T: Float>() {
    let mut random = Random(1);
    for _ in 0..300 {
        let n = direction::<T>(&mut random);
        let aside = n.cross(direction::<T>(&mut random));
        // from grazing to overhead, on both sides
        let cosine = (random.within(0.0, 1.0) * (8.0 * T::U).log2()).exp2();
        for side in [T::ONE, T::NEG_ONE] {
            let l = aside + *n * (side * T::of(cosine));
            for exponent in (least::<T>()..largest::<T>() - 1).step_by(7) {
                let (position, intensity) = (l * power::<T>(exponent), Rgb::WHITE);
                let attenuation = Attenuation::NONE;
                let lamp = PointLight {
                    position,
                    intensity,
                    attenuation,
                };
                let is_in_front = lamp.at(Vec3::ZERO).is_in_front(n);
                assert_eq!(is_in_front, side > T::ZERO, "{n:?}, {position:?}");
            }
        }
    }
}

/// (1, s, 0) and (1, 0, 0), turned to each axis, with a sine s from u² on and of every length.
fn tangents_have_a_normal_unless_they_are_parallel<T: Float>() {
    #[allow(clippy::cast_possible_truncation)] // a power of two
    let [least_sine, tiniest] = [2.0 * T::U.log2(), T::TINIEST.log2()].map(|x| x as i32);
    let step = if T::NAME == "f32" { 3 } else { 29 };
    let sizes = || (tiniest..=largest::<T>()).step_by(step);
    for (a, b) in sizes().flat_map(|a| sizes().map(move |b| (a, b))) {
        for sine in (least_sine.max(tiniest - a)..0)
            .step_by(5)
            .chain([least_sine.max(tiniest - a)])
        {
            let (long, short, along) = (power::<T>(a), power::<T>(a + sine), power::<T>(b));
            let [s_u, s_v] = [[long, short, T::ZERO], [along, T::ZERO, T::ZERO]].map(Vec3::from);
            assert_eq!(
                normal::from_tangents(s_u, s_v),
                Some(UnitVec3::NEG_Z),
                "{s_u:?}, {s_v:?}"
            );
            let turned = |v: Vec3<T>| Vec3::new(v.z, v.x, v.y);
            let triangle = normal::triangle(Vec3::ZERO, turned(s_v), turned(s_u));
            assert_eq!(triangle, Some(UnitVec3::X), "{s_u:?}, {s_v:?}");
        }
    }
}

/// A vector times a power of two: the columns of a matrix and the edges of a triangle, of which the
/// formulas are computed without the power.
#[derive(Clone, Copy, Debug)]
struct Scaled<T> {
    v: Vec3<T>,
    exponent: i32,
}

impl<T: Float> Scaled<T> {
    /// From three numbers within [−1, 1], rounded as the product is.
    fn new(xyz: [f64; 3], exponent: i32) -> Self {
        let [x, y, z] = xyz;
        // a length of at least ½
        let largest = x.abs().max(y.abs()).max(z.abs()).max(1e-3);
        let v = Vec3::from([x, y, z].map(|x| T::of(x / largest))) * power::<T>(exponent);
        Self { v, exponent }
    }

    /// Without the power, in double precision.
    fn without(self) -> Vec3<f64> {
        self.v
            .map(|x| x.into() * f64::from(-self.exponent / 2).exp2())
            * f64::from(-self.exponent - -self.exponent / 2).exp2()
    }
}

/// A term of a sum: a vector, the product of the lengths that it is made from, and a power of two.
struct Term {
    v: Vec3<f64>,
    length: f64,
    exponent: i32,
}

/// The sum of some terms and the sum of their lengths, both without the largest of the powers.
fn sum(terms: &[Term]) -> (Vec3<f64>, f64) {
    let counts = terms.iter().filter(|term| term.length > 0.0);
    let largest = counts.map(|term| term.exponent).max().unwrap_or(0);
    let power = |term: &Term| f64::from(term.exponent - largest).exp2();
    let v = terms.iter().map(|term| term.v * power(term)).sum();
    (v, terms.iter().map(|term| term.length * power(term)).sum())
}

/// |computed − exact| over u times the conditioning.
fn error<T: Float>(computed: UnitVec3<T>, exact: Vec3<f64>, lengths: f64) -> f64 {
    let length = exact.length();
    let expected = exact * (1.0 / length);
    let off = computed.map(Into::into) - expected;
    off.length() / T::U / (lengths / length)
}

/// A number from the least exponent to `end`, for one from −1 to 1.
#[allow(clippy::cast_possible_truncation)]
fn exponent<T: Float>(number: f64, end: i32) -> i32 {
    let fraction = 0.5 + 0.5 * number;
    (f64::from(least::<T>()) * (1.0 - fraction) + f64::from(end) * fraction).round() as i32
}

/// Each column has its own size. The lengths are off by 2.5u and the directions by 3.5u, so that a
/// component of N times a quotient of lengths is off by 7u, and a product of two directions by
/// (2 · 3.5 + 1)(2/√3)u + 1u. With the product of both and two sums, the error is at most 20.3κu, and
/// 3.5u for `unit`.
fn columns_of_any_size_give_the_normal<T: Float>() {
    let (place, worst) = climb(0, |numbers: [f64; 15]| {
        let [n, a, b, c] = [0, 3, 6, 9].map(|first| [0, 1, 2].map(|k| numbers[first + k]));
        let n = Vec3::from(n.map(T::of)).unit_or(UnitVec3::Z);
        let column = |v, k: usize| Scaled::<T>::new(v, exponent::<T>(numbers[k], largest::<T>()));
        let (a, b, c) = (column(a, 12), column(b, 13), column(c, 14));
        let term = |n: T, a: Scaled<T>, b: Scaled<T>| {
            let (n, exponent) = (n.into(), a.exponent + b.exponent);
            let (a, b) = (a.without(), b.without());
            Term {
                v: a.cross(b) * n,
                length: n.abs() * a.length() * b.length(),
                exponent,
            }
        };
        let (exact, lengths) = sum(&[term(n.x, b, c), term(n.y, c, a), term(n.z, a, b)]);
        if exact.length() < lengths / 1e4 {
            return 0.0; // up to rounding, the surface is flattened
        }
        let computed = normal::transformed(n, [a.v, b.v, c.v]);
        computed.map_or(f64::INFINITY, |n| error(n, exact, lengths))
    });
    assert!(worst <= 21.0, "{worst} at {place:?}");
}

/// Each edge and each difference of texture coordinates has its own size, up to the ratio that the
/// page names. Of T, each of the two products is off by 5u and the difference by 1u.
fn a_map_of_any_size_gives_the_tangent<T: Float>() {
    let ratio = if T::NAME == "f32" { 100.0 } else { 900.0 };
    let (place, worst) = climb(0, |numbers: [f64; 16]| {
        let end = largest::<T>() - 2;
        #[allow(clippy::cast_possible_truncation)]
        let pair = |k: usize| {
            let first = exponent::<T>(numbers[k], end);
            let second = first + (ratio * numbers[k + 1]).round() as i32;
            [first, second.clamp(least::<T>(), end)]
        };
        let [edges, across, down] = [0, 2, 4].map(pair);
        let edge =
            |k: usize, exponent| Scaled::<T>::new([k, k + 1, k + 2].map(|k| numbers[k]), exponent);
        let (e2, e3) = (edge(6, edges[0]), edge(9, edges[1]));
        // from ½ to 1
        let number = |k: usize| T::of(numbers[k].signum() * (0.5 + numbers[k].abs() / 2.0));
        let [x2, x3, y2, y3] = [12, 13, 14, 15].map(number);
        let term = |e: Scaled<T>, y: T, exponent: i32| {
            let (v, exponent) = (e.without() * y.into(), e.exponent + exponent);
            let length = v.length();
            Term {
                v,
                length,
                exponent,
            }
        };
        let (exact, lengths) = sum(&[term(e2, y3, down[1]), term(e3, -y2, down[0])]);
        let product = |x: T, y: T, exponent| {
            let v = Vec3::new(x.into() * y.into(), 0.0, 0.0);
            let length = v.length();
            Term {
                v,
                length,
                exponent,
            }
        };
        let d = [
            product(x2, y3, across[0] + down[1]),
            product(-x3, y2, across[1] + down[0]),
        ];
        let (d, products) = sum(&d);
        if exact.length() < lengths / 1e4 || d.x.abs() < products / 1e4 {
            return 0.0; // up to rounding, the map is a line
        }
        let [x2, x3] = [x2 * power(across[0]), x3 * power(across[1])];
        let [y2, y3] = [y2 * power(down[0]), y3 * power(down[1])];
        let map = [[T::ZERO; 2], [x2, y2], [x3, y3]];
        let computed = normal::tangent([Vec3::ZERO, e2.v, e3.v], map);
        computed.map_or(f64::INFINITY, |(t, h)| {
            if h.into() * d.x < 0.0 {
                return f64::INFINITY;
            }
            error(t, exact * d.x.signum(), lengths)
        })
    });
    assert!(worst <= 7.0, "{worst} at {place:?}");
}

/// The relative error of cᵐ is at most mu, and that of the expected power in double precision 2⁻⁵². A
/// power that would be subnormal is subnormal or 0, or the least normal number.
fn a_whole_power_has_its_digits_down_to_the_least_normal_number<T: Float>() {
    let mut random = Random(5);
    for _ in 0..20_000 {
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let m = random.within(0.0, 20.0).exp2() as u32;
        // a power from 2¹⁰ times the least normal number to 2⁻³⁰ times
        let exponent = T::MIN_POSITIVE.log2() + random.within(-30.0, 10.0);
        let cosine = T::of((exponent / f64::from(m)).exp2());
        let power: f64 = m.raise(cosine).into();
        let expected = cosine.into().powf(m.into());
        if expected < T::MIN_POSITIVE {
            assert!(
                (0.0..=T::MIN_POSITIVE).contains(&power),
                "{cosine:?}^{m}: {power:e}"
            );
        } else {
            let error = (power / expected - 1.0).abs();
            let tolerance = f64::from(m) * T::U + f64::EPSILON;
            assert!(
                error <= tolerance,
                "{cosine:?}^{m}: {power:e} for {expected:e}"
            );
        }
    }
}

/// The highest place found, and its height: random places, and steps from the best of them that change
/// one or two numbers, by anything down to the last digit.
fn climb<const N: usize>(seed: u64, height: impl Fn([f64; N]) -> f64) -> ([f64; N], f64) {
    let mut random = Random(seed);
    let mut best = ([0.0; N], 0.0);
    for _ in 0..10 {
        let mut top = ([0.0; N], 0.0);
        for step in 0..3000 {
            let mut place = top.0;
            if step < 200 {
                place = std::array::from_fn(|_| random.signed());
            } else {
                for _ in 0..=random.below(2) {
                    let size = -f64::from(u32::try_from(random.below(55)).expect("small"));
                    let number = &mut place[random.below(N)];
                    *number = (*number + 2.0 * size.exp2() * random.signed()).clamp(-1.0, 1.0);
                }
            }
            let found = height(place);
            if found >= top.1 {
                top = (place, found);
            }
        }
        if top.1 > best.1 {
            best = top;
        }
    }
    best
}

fn direction<T: Float>(random: &mut Random) -> UnitVec3<T> {
    let v = [(); 3].map(|()| T::of(random.signed()));
    Vec3::from(v).unit_or(UnitVec3::Z)
}
