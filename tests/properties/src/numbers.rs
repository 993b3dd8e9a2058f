//! What the formulas expect of a number, and what dual numbers make of it.

use proptest::prelude::*;
use shading::number::Mask;
use shading::{Dual, Elementary, Rgb, UnitVec3, Vec3, term};

use crate::book;
use crate::given::{Directions, Numbers, Scene};
use crate::tracked::{prop_assert_book, prop_assert_near};
use crate::{Number, Outcome};

/// x + 0 = x · 1 = x, x − x = x · 0 = 0 and √1 = 1.
pub fn zero_and_one_are_neutral<T: Number>(n: &Numbers<T>) -> Outcome {
    let x = n.z;
    prop_assert_eq!([x + T::ZERO, x - T::ZERO, x * T::ONE, x / T::ONE], [x; 4]);
    prop_assert_eq!([x + -x, x * T::ZERO, T::ZERO.sqrt()], [T::ZERO; 3]);
    prop_assert_eq!([x * T::NEG_ONE, T::ONE.sqrt()], [-x, T::ONE]);
    Ok(())
}

/// + − × ÷ √ are off by one rounding.
pub fn each_operation_rounds_once<T: Number>(n: &Numbers<T>) -> Outcome {
    prop_assert_book!(
        n,
        vec![n.x + n.y, n.x - n.y, n.x * n.y],
        [n.x + n.y, n.x - n.y, n.x * n.y]
    );
    prop_assert_book!(
        n,
        vec![n.z + n.x, n.z - n.y, n.z * n.y],
        [n.z + n.x, n.z - n.y, n.z * n.y]
    );
    let divisor = n.y + T::of(0.25);
    let quotient = (n.x / divisor).exact();
    let should = n.x.exact() / divisor.exact();
    prop_assert_near!(quotient, should, T::U * should + T::STEP);
    let root = n.x.exact().sqrt();
    prop_assert_near!(n.x.sqrt().exact(), root, T::U * root + T::STEP);
    Ok(())
}

/// A product with a power of two is exact.
pub fn doubling_is_exact<T: Number>(n: &Numbers<T>) -> Outcome {
    let is_normal = |x: f64| x == 0.0 || x.abs() > 4.0 * T::SMALLEST / T::U;
    let z = n.z.exact();
    prop_assume!(is_normal(z) && z.abs() < T::LARGEST / 4.0);
    for k in [0.25, 0.5, 2.0] {
        prop_assert_eq!((n.z * T::of(k)).exact(), z * k);
        prop_assert_eq!((n.z / T::of(k)).exact(), z / k);
    }
    Ok(())
}

/// A comparison is that of the numbers, and `select` takes the one or the other; 0 is not above −0.
pub fn a_comparison_decides<T: Number>(n: &Numbers<T>) -> Outcome {
    let least = T::of(T::SMALLEST);
    for (a, b) in [
        (n.x, n.y),
        (n.z, n.x),
        (least, T::ZERO),
        (T::ZERO, -least),
        (n.z, n.z),
        (T::ZERO, -T::ZERO),
    ] {
        let above = a.above(b);
        let is = a.exact() > b.exact();
        prop_assert_eq!((above.any(), above.all(), a > b), (is, is, is));
        prop_assert_eq!(above.select(n.x, n.y), if is { n.x } else { n.y });
        prop_assert_eq!(a.at_least(b), if is { a } else { b });
        prop_assert_eq!(a.at_most(b), if is { b } else { a });
    }
    prop_assert!(T::MAX >= n.z && -T::MAX <= n.z);
    prop_assert_eq!(n.z.finite(), n.z);
    Ok(())
}

/// The constants are what they are called, and `of` and `of_f32` give the nearest number.
pub fn constants_are_themselves<T: Number>(n: &Numbers<T>) -> Outcome {
    let is = [T::ZERO, T::ONE, T::NEG_ONE, T::MAX, T::EXTREME].map(T::exact);
    prop_assert_eq!(is, [0.0, 1.0, -1.0, T::LARGEST, T::LARGE]);
    prop_assert_eq!(T::of_f32(0.375), T::of(0.375));
    let x = n.x.exact() / 3.0;
    prop_assert_near!(T::of(x).exact(), x, T::U * x + T::STEP);
    prop_assert_eq!(T::of(n.z.exact()), n.z);
    Ok(())
}

/// max(0, N·H)ᵐ of a vector to a light of any length, written out; 0 where there is no vector
/// halfway.
pub fn the_power_of_a_halfway_cosine_is_its_formula<T: Number>(d: &Directions<T>) -> Outcome {
    let [n, l, v] = [d.n, d.l, d.v].map(|u| book::xyz(u.cast(T::exact)));
    let size = book::length(book::plus(l, v));
    let cosine = book::halfway(l, v).map_or(0.0, |h| book::dot(n, h));
    prop_assume!(size > 0.1 && cosine.abs() > 64.0 * (T::U + T::STEP));
    for scale in [0.25, 1.0, 3.0] {
        let to_light = T::measured(*d.l * T::of(scale));
        let is = T::halfway_power(*d.n, to_light, *d.v, d.m).exact();
        // the square of n·h is rounded, too, and its root magnifies that where n·h is small
        let steps = T::STEP * (1.0 + 1.0 / (scale * scale * size * cosine.abs()));
        let roundings = (f64::from(d.m) + 1.0) * 16.0 / size;
        let should = book::highlight(cosine, d.m);
        prop_assert_near!(is, should, roundings * (T::U + steps));
    }
    let opposite = T::measured(*UnitVec3::NEG_X);
    prop_assert_eq!(T::halfway_power(*d.n, opposite, *UnitVec3::X, d.m), T::ZERO);
    Ok(())
}

/// A scene cast to `f64` and back is the same scene.
pub fn a_cast_to_f64_and_back_is_the_same<T: Number>(scene: &Scene<T>) -> Outcome {
    let back = scene.cast(T::exact).cast(T::of);
    prop_assert_eq!(back.arriving(), scene.arriving());
    prop_assert_eq!(back.material, scene.material);
    Ok(())
}

/// In dual numbers, directions, distances and highlights have the values that they have in the number
/// itself, to the bit.
pub fn a_dual_number_has_the_value_of_its_number<T: Number>(scene: &Scene<T>) -> Outcome {
    let dual = scene.cast(Dual::constant);
    for (dual_light, light) in dual.arriving().iter().zip(scene.arriving()) {
        prop_assert_eq!(dual_light.l().cast(|x| x.value), light.l());
        prop_assert_eq!(dual_light.distance().value, light.distance());
        prop_assert_eq!(dual_light.is_in_front(dual.n), light.is_in_front(scene.n));
        let m = scene.material.m;
        let highlight = term::blinn(dual.n, dual_light.l(), m);
        prop_assert_eq!(highlight.value, term::blinn(scene.n, light.l(), m));
    }
    Ok(())
}

/// In dual numbers, every light has the value that it has in the number itself, to the bit, if the number
/// dims it by the formulas.
pub fn a_dual_number_has_the_light_of_its_number<T: Number>(scene: &Scene<T>) -> Outcome {
    let dual = scene.cast(Dual::constant);
    let sums = dual.shaded(&dual.arriving());
    for (dual, plain) in sums.into_iter().zip(scene.shaded(&scene.arriving())) {
        let value = |c: Rgb<Dual<T>>| c.map(|x| x.value);
        prop_assert_eq!(value(dual.diffuse), plain.diffuse);
        prop_assert_eq!(value(dual.specular), plain.specular);
        prop_assert_eq!(value(dual.ambient), plain.ambient);
        for x in [dual.diffuse.r, dual.specular.r] {
            prop_assert_eq!(x.gradient, Vec3::ZERO);
        }
    }
    Ok(())
}

/// x = 1 + the first number as a variable, and the second as another.
fn variables<T: Number>(n: &Numbers<T>) -> [Dual<T>; 2] {
    let p = Dual::point(Vec3::new(n.x + T::ONE, n.y, T::ZERO));
    [p.x, p.y]
}

/// (xy)′ = x′y + xy′, (x/y)′ = (x′y − xy′)/y², (√x)′ = 1/(2√x), (x + y)′ = x′ + y′ and the like.
pub fn derivatives_follow_their_rules<T: Number>(n: &Numbers<T>) -> Outcome {
    let [x, y] = variables(n);
    let [a, b] = [x, y].map(|x| x.value.exact());
    let rules = [
        (x + y, [1.0, 1.0]),
        (x - y, [1.0, -1.0]),
        (x * y, [b, a]),
        (y / x, [-b / (a * a), 1.0 / a]),
        (x.sqrt(), [0.5 / a.sqrt(), 0.0]),
        (-x, [-1.0, 0.0]),
        (x * x * x, [3.0 * a * a, 0.0]),
        (x.chain(x.value, T::of(5.0)), [5.0, 0.0]),
        (x.max(y), if a > b { [1.0, 0.0] } else { [0.0, 1.0] }),
        (x.min(y), if a > b { [0.0, 1.0] } else { [1.0, 0.0] }),
        (Dual::constant(n.z), [0.0, 0.0]),
    ];
    for (i, (is, should)) in rules.into_iter().enumerate() {
        let slope = [is.gradient.x, is.gradient.y].map(T::exact);
        for (is, should) in slope.into_iter().zip(should) {
            let tolerance = 8.0 * (T::U * (1.0 + should.abs()) + T::STEP * 4.0);
            prop_assert!(
                (is - should).abs() <= tolerance,
                "rule {i}: {is} is not {should}"
            );
        }
        prop_assert_eq!(is.gradient.z, T::ZERO);
    }
    Ok(())
}

/// A slope is linear in the tangent: four times as steep, four times the slope, to the bit.
pub fn a_slope_is_linear_in_the_tangent<T: Number>(n: &Numbers<T>) -> Outcome {
    let slope = |k: f64| {
        let x = Dual {
            value: n.x + T::ONE,
            gradient: Vec3::new(T::of(k), T::ZERO, T::ZERO),
        };
        ((x * x + Dual::constant(n.y)) / x).sqrt().gradient.x
    };
    prop_assert_eq!(slope(4.0), slope(1.0) * T::of(4.0));
    prop_assert_eq!(slope(-1.0), -slope(1.0));
    Ok(())
}

/// (sin x)′ = cos x and the like: each elementary function has its value and its slope.
pub fn elementary_functions_have_their_slopes<T: Number + Elementary>(n: &Numbers<T>) -> Outcome {
    let [x, y] = variables(n);
    let [a, b] = [x, y].map(|x| x.value.exact());
    let square = a * a + b * b;
    let functions = [
        (x.sin(), a.sin(), [a.cos(), 0.0]),
        (x.cos(), a.cos(), [-a.sin(), 0.0]),
        (y.tan(), b.tan(), [0.0, 1.0 / b.cos().powi(2)]),
        (y.atan2(x), b.atan2(a), [-b / square, a / square]),
        (x.exp(), a.exp(), [a.exp(), 0.0]),
        (x.ln(), a.ln(), [1.0 / a, 0.0]),
        (
            x.powf(y),
            a.powf(b),
            [b * a.powf(b - 1.0), a.powf(b) * a.ln()],
        ),
        (x.powi(-3), a.powi(-3), [-3.0 * a.powi(-4), 0.0]),
        ((y - x).abs(), (b - a).abs(), [1.0, -1.0]),
    ];
    for (i, (is, value, slope)) in functions.into_iter().enumerate() {
        prop_assume!(i != 8 || a > b);
        let numbers = [is.value, is.gradient.x, is.gradient.y].map(T::exact);
        for (is, should) in numbers.into_iter().zip([value, slope[0], slope[1]]) {
            // of numbers within [−e², e²], after few roundings
            prop_assert!(
                (is - should).abs() <= 64.0 * T::U * (1.0 + should.abs()),
                "function {i}: {is} is not {should}"
            );
        }
    }
    Ok(())
}
