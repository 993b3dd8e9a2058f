//! (54) Dual numbers against symbolic derivatives.

use proptest::prelude::*;
use shading::{Dual, Elementary, Real, Vec3};

use super::Number;
use super::check::{
    by_spacing, check, equal, is_short_of_range, near, nearly, same, same_or_near, to_f64,
};
use super::generators::point;

/// A dual number with any gradient and with a value in [½, 2), of either sign.
fn dual<T: Number>() -> impl Strategy<Value = Dual<T>> {
    (0.5..2.0, any::<bool>(), point()).prop_map(|(value, negative, gradient): (f64, _, _)| Dual {
        value: T::of(if negative { -value } else { value }),
        gradient,
    })
}

/// A positive dual number.
fn positive<T: Number>() -> impl Strategy<Value = Dual<T>> {
    dual().prop_map(|x: Dual<T>| if x.value < T::ZERO { -x } else { x })
}

fn value<T: Number>(x: Dual<T>, expected: T) -> Result<(), TestCaseError> {
    same([x.value; 3], [expected; 3])
}

/// (f + g)′ = f′ + g′, (f − g)′ = f′ − g′, (−f)′ = −f′
fn sum_rule<T: Number>() {
    check((dual::<T>(), dual::<T>()), |(f, g)| {
        value(f + g, f.value + g.value)?;
        value(f - g, f.value - g.value)?;
        value(-f, -f.value)?;
        same((f + g).gradient, f.gradient + g.gradient)?;
        same((f - g).gradient, f.gradient - g.gradient)?;
        same((-f).gradient, -f.gradient)
    });
}

/// (fg)′ = f′g + g′f
fn product_rule<T: Number>() {
    check((dual::<T>(), dual::<T>()), |(f, g)| {
        value(f * g, f.value * g.value)?;
        let expected = |i: usize| {
            let [f_i, g_i] = [f, g].map(|x| <[T; 3]>::from(x.gradient)[i]);
            f_i * g.value + g_i * f.value
        };
        same(
            (f * g).gradient,
            Vec3::from([expected(0), expected(1), expected(2)]),
        )
    });
}

/// (f/g)′ = (f′g − g′f)/g², within 8u of the magnitudes of the two products: three roundings here
/// and four there. |f|, |g|, and 1/|g| are at most 2, and the slopes at most 1.
fn quotient_rule<T: Number>() {
    check((dual::<T>(), dual::<T>()), |(f, g)| {
        value(f / g, f.value / g.value)?;
        let expected = f.gradient * g.value - g.gradient * f.value;
        let expected = expected.map(|slope| slope / (g.value * g.value));
        near((f / g).gradient, expected, 8.0 * T::U * 16.0)
    });
}

/// A plain number is a constant: it acts like a dual number with a gradient of zero.
fn plain_numbers_are_constants<T: Number>() {
    check((dual::<T>(), dual::<T>()), |(f, c)| {
        let c = c.value;
        let constant = Dual::constant(c);
        let pairs = [
            (f + c, f + constant),
            (f - c, f - constant),
            (f * c, f * constant),
            (f / c, f / constant),
        ];
        for (mixed, dual) in pairs {
            value(mixed, dual.value)?;
            equal(mixed.gradient, dual.gradient)?;
        }
        same(Dual::<T>::of(0.5).gradient, Vec3::ZERO)?;
        value(Dual::<T>::of(0.5), T::of(0.5))
    });
}

/// g(f)′ = g′(f) f′. For √ that is f′/(2√f), within 4u.
fn chain_rule<T: Number>() {
    check((positive::<T>(), dual::<T>()), |(f, slope)| {
        let chained = f.chain(slope.value, slope.value);
        value(chained, slope.value)?;
        same(chained.gradient, f.gradient * slope.value)?;

        let root = f.sqrt();
        value(root, f.value.sqrt())?;
        let slope = T::of(0.5) / f.value.sqrt();
        nearly(root.gradient, f.gradient * slope, 4.0)
    });
}

/// The derivatives of sine, cosine, exponential, logarithm, and absolute value. On either side,
/// each function is off by at most one unit in the last place, 2u, and the product by 1u: 6u in
/// all.
fn elementary_derivatives<T: Number>() {
    check(dual::<T>(), |f| {
        let x = f.value.to_f64();
        let positive = if x < 0.0 { -f } else { f };
        let table = [
            (f.sin(), f, x.sin(), x.cos()),
            (f.cos(), f, x.cos(), -x.sin()),
            (f.exp(), f, x.exp(), x.exp()),
            (positive.ln(), positive, x.abs().ln(), 1.0 / x.abs()),
            (f.abs(), f, x.abs(), x.signum()),
        ];
        for (result, f, y, slope) in table {
            near(
                [result.value; 3],
                [T::of(y); 3],
                3.0 * T::U * y.abs() + T::TINY.to_f64(),
            )?;
            nearly(result.gradient, f.gradient * T::of(slope), 6.0)?;
        }
        Ok(())
    });
}

/// (fⁿ)′ = n fⁿ⁻¹ f′, also for negative n: |n| roundings for the power and for its product rules,
/// twice.
///
/// In an evenly spaced type, with X the larger of 1 and |f|ⁿ: a power is off by nX u, and its gradient by
/// 2n²X u, because a product adds 2u to what its factors are off by. The reciprocal multiplies both by
/// f⁻²ⁿ and those of the value by f⁻ⁿ more, so the exponents are few: (4n² + 4)u of |f|³ⁿ.
fn power_rule<T: Number>() {
    let exponents = if T::EVENLY_SPACED { -3..=9 } else { -9..=9 };
    check((dual::<T>(), exponents), |(f, n)| {
        let power = f.powi(n);
        let slope = f64::from(n) * f.value.to_f64().powi(n - 1);
        let size = f.value.to_f64().powi(n).abs().max(1.0);
        let size = if n < 0 { size.powi(3) } else { size };
        prop_assume!(!T::EVENLY_SPACED || 4.0 * f64::from(n.abs()) * size < T::MAX.to_f64());
        let n_squared = f64::from(n * n);
        let k = by_spacing::<T>(
            4.0 * f64::from(n.abs()) + 4.0,
            (4.0 * n_squared + 4.0) * size,
        );
        nearly([power.value; 3], [T::of(f.value.to_f64().powi(n)); 3], k)?;
        nearly(power.gradient, f.gradient * T::of(slope), k)
    });
}

/// The result is linear in the tangent: doubling the gradients of the inputs doubles its gradient
/// exactly.
///
/// An evenly spaced type rounds the gradient, but not the value, differently. The products of f g round
/// twice; √f/g five times, since 1/g is at most 2; sin g · ln f less than four times; and the
/// exponential multiplies these 11u by the result and adds 1u. The gradient is already large.
fn linear_in_the_tangent<T: Number>() {
    let octaves = if is_short_of_range::<T>() {
        -8..=0
    } else {
        -8..=8
    };
    check((positive::<T>(), dual::<T>(), octaves), |(f, g, k)| {
        let size = f64::from(k).exp2();
        let scale = T::of(size);
        let scaled = |x: Dual<T>| Dual {
            gradient: x.gradient * scale,
            ..x
        };
        let function = |f: Dual<T>, g: Dual<T>| (f * g + f.sqrt() / g - g.sin() * f.ln()).exp();
        let (result, of_scaled) = (function(f, g), function(scaled(f), scaled(g)));
        let sizes = [
            result.value,
            result.gradient.x,
            result.gradient.y,
            result.gradient.z,
        ];
        let half = T::MAX.to_f64() / 2.0;
        prop_assume!(!T::EVENLY_SPACED || sizes.iter().all(|c| c.to_f64().abs() < half));
        value(of_scaled, result.value)?;
        // either side, and the product with the scale
        let roundings = (11.0 * result.value.to_f64() + 1.0) * (1.0 + size) + 1.0;
        same_or_near(of_scaled.gradient, result.gradient * scale, roundings)
    });
}

/// Comparisons and selections depend on the value alone, and a selection keeps its gradient.
fn decisions_depend_on_the_value<T: Number>() {
    check((dual::<T>(), dual::<T>()), |(f, g)| {
        prop_assert_eq!(f < g, f.value < g.value);
        prop_assert_eq!(f == g, f.value == g.value);
        let elsewhere = Dual {
            gradient: g.gradient,
            ..f
        };
        prop_assert!(f == elsewhere);
        prop_assert_eq!(f.any_positive(), f.value > T::ZERO);
        let (selected, expected) = (f.if_positive(f, g), if f.value > T::ZERO { f } else { g });
        value(selected, expected.value)?;
        same(selected.gradient, expected.gradient)?;
        value(f.at_most(g), if f > g { g.value } else { f.value })?;
        value(
            f.at_least(Dual::ZERO),
            if f.value > T::ZERO { f.value } else { T::ZERO },
        )
    });
}

/// The three coordinates of a point are the variables: ∇x, ∇y, and ∇z are the axes.
fn variables_have_the_axes_as_gradients<T: Number>() {
    check(point::<T>(), |p| {
        let variables = Dual::point(p);
        same(variables.map(|c| c.value), p)?;
        let gradients = <[Dual<T>; 3]>::from(variables).map(|c| to_f64(c.gradient));
        prop_assert_eq!(
            gradients,
            [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
        );
        Ok(())
    });
}

properties! { dual:
    sum_rule,
    product_rule,
    quotient_rule,
    plain_numbers_are_constants,
    chain_rule,
    elementary_derivatives,
    power_rule,
    linear_in_the_tangent,
    decisions_depend_on_the_value,
    variables_have_the_axes_as_gradients,
}
