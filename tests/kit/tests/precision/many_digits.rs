//! Vectors and the formulas of the books, with many digits.

use std::array::from_fn;

use dashu_float::FBig;
use dashu_float::ops::Abs;
use dashu_float::round::mode::HalfEven;

use kit::Float;

/// A number of 150 bits; the result of each operation is rounded.
pub type Number = FBig<HalfEven, 2>;
pub type Vector = [Number; 3];

pub fn number(x: f64) -> Number {
    Number::try_from(x)
        .expect("finite")
        .with_precision(150)
        .value()
}

/// π, by Machin's formula: 16 arctan ⅕ − 4 arctan 1/239.
pub fn pi() -> Number {
    let arctan_of_inverse = |x: f64| {
        let term = |k: i32| {
            let power = number(x).powi((2 * k + 1).into());
            number(if k % 2 == 0 { 1.0 } else { -1.0 }) / (power * number((2 * k + 1).into()))
        };
        (0..40).map(term).fold(number(0.0), |sum, term| sum + term)
    };
    number(16.0) * arctan_of_inverse(5.0) - number(4.0) * arctan_of_inverse(239.0)
}

/// The numbers of a vector, exactly.
pub fn vector<T: Float>(v: impl Into<[T; 3]>) -> Vector {
    v.into().map(|c| number(c.double()))
}

pub fn add(a: &Vector, b: &Vector) -> Vector {
    from_fn(|i| &a[i] + &b[i])
}

pub fn subtract(a: &Vector, b: &Vector) -> Vector {
    from_fn(|i| &a[i] - &b[i])
}

pub fn scale(a: &Vector, factor: &Number) -> Vector {
    from_fn(|i| &a[i] * factor)
}

pub fn dot(a: &Vector, b: &Vector) -> Number {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

pub fn cross(a: &Vector, b: &Vector) -> Vector {
    from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        &a[j] * &b[k] - &a[k] * &b[j]
    })
}

pub fn length(a: &Vector) -> Number {
    dot(a, a).sqrt()
}

pub fn unit(a: &Vector) -> Vector {
    let length = length(a);
    from_fn(|i| &a[i] / &length)
}

/// R = 2(N·L)N − L
pub fn reflection(n: &Vector, l: &Vector) -> Vector {
    subtract(&scale(n, &(number(2.0) * dot(n, l))), l)
}

/// H = (L + V)/|L + V|
pub fn half_vector(l: &Vector, v: &Vector) -> Vector {
    unit(&add(l, v))
}

pub fn positive_part(x: Number) -> Number {
    if x > Number::ZERO { x } else { number(0.0) }
}

/// max(0, min(1, x))
pub fn clamped(x: Number) -> Number {
    let one = number(1.0);
    positive_part(if x > one { one } else { x })
}

/// max(0, min(1, cosine))ᵐ
pub fn highlight(cosine: Number, m: f64) -> Number {
    let one = number(1.0);
    power(&positive_part(if cosine > one { one } else { cosine }), m)
}

/// baseᵐ for an integer 2m, as (√base)²ᵐ, which is quicker than by logarithms.
pub fn power(base: &Number, m: f64) -> Number {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // an integer
    let twice_m = (2.0 * m) as u32;
    base.sqrt().powi(twice_m.into())
}

/// 1/(a + bq + cq²)
pub fn attenuation([a, b, c]: &[Number; 3], q: &Number) -> Number {
    number(1.0) / (a + b * q + c * q * q)
}

/// cof(M) N, for the columns of M: n_x (b × c) + n_y (c × a) + n_z (a × b).
pub fn cofactors([a, b, c]: &[Vector; 3], n: &Vector) -> Vector {
    let products = [cross(b, c), cross(c, a), cross(a, b)];
    from_fn(|i| (0..3).fold(number(0.0), |sum, j| sum + &n[j] * &products[j][i]))
}

/// The factor by which cof(M) N magnifies rounding: the lengths of the factors of its terms, over
/// its own length.
pub fn conditioning(columns: &[Vector; 3], n: &Vector) -> f64 {
    let [a, b, c] = columns.each_ref().map(length);
    let sizes = [&b * &c, &c * &a, &a * &b];
    let all = dot(&n.clone().map(Number::abs), &sizes);
    (all / length(&cofactors(columns, n))).to_f64().value()
}

/// The angle between two vectors, halved until a short series of its tangent is enough.
pub fn angle(a: &Vector, b: &Vector) -> Number {
    const HALVINGS: i32 = 30;
    let one = number(1.0);
    let mut tangent = length(&cross(a, b)) / (length(a) * length(b) + dot(a, b));
    for _ in 0..HALVINGS {
        tangent = &tangent / (&one + (&one + &tangent * &tangent).sqrt());
    }
    let square = &tangent * &tangent;
    let series = &one - &square / number(3.0) + &square * &square / number(5.0);
    tangent * series * number(f64::from(HALVINGS + 1).exp2())
}

/// The sample (x, y, z) in the frame of a normal and a tangent, x t + y b + z N.
pub fn mapped(n: &Vector, tangent: &Vector, handedness: &Number, sample: &Vector) -> Vector {
    let along = scale(n, &(dot(n, tangent) / dot(n, n)));
    let t = unit(&subtract(tangent, &along));
    let b = scale(&cross(&unit(n), &t), handedness);
    let [x, y, z] = sample;
    add(&add(&scale(&t, x), &scale(&b, y)), &scale(&unit(n), z))
}
