//! Dual numbers.

use shading::{Dual, Elementary, Real, normal};
use shading_proofs::{Goal, Range};

use super::*;

fn dual(given: Given, name: &str, value: Range, gradient: Range) -> Dual<Term> {
    let (value, gradient) = (
        given.number(name, value),
        given.vector(&format!("∇{name}"), gradient),
    );
    Dual { value, gradient }
}
fn any_dual(given: Given, name: &str) -> Dual<Term> {
    dual(given, name, Range::ANY, Range::ANY)
}
/// Numbers of either sign up to a power of two.
fn up_to(exponent: i32) -> Range {
    Range::within(-2.0_f64.powi(exponent), 2.0_f64.powi(exponent))
}
fn zero() -> Range {
    Range::within(0.0, 0.0)
}
fn below() -> Range {
    Range {
        minus_zero: false,
        ..Range::within(-INF, -f64::MIN_POSITIVE)
    }
}
fn not_finite(x: Dual<Term>) -> Vec<Goal> {
    components(x.gradient, Range::NOT_FINITE)
}
fn is_finite(given: Given, x: Dual<Term>) -> Vec<Goal> {
    [
        within([x.value], finite(given)),
        components(x.gradient, finite(given)),
    ]
    .concat()
}

claims! {
    dual_values: "+ − × ÷ √ and `Elementary::powi` of `Dual` have the value of the same number without a gradient, to the bit, any bits" |given| {
        let (f, g) = (any_dual(given, "f"), any_dual(given, "g"));
        let (x, y) = (f.value, g.value);
        let both = [(f + g, x + y), (f - g, x - y), (f * g, x * y), (f / g, x / y), (f.sqrt(), x.sqrt()), (-f, -x), (f + y, x + y), (f * y, x * y)];
        let powers = [-3, -1, 0, 1, 2, 7].map(|m| (f.powi(m), x.powi(m)));
        both.into_iter().chain(powers).map(|(dual, number)| Goal::Same(dual.value, number)).collect()
    }
    dual_sums_and_products: "+ − × of `Dual` are finite, for values and gradients up to 2⁶²; so is `Dual::chain`" |given| {
        let (f, g) = (dual(given, "f", up_to(62), up_to(62)), dual(given, "g", up_to(62), up_to(62)));
        let chained = f.chain(g.value, given.number("slope", up_to(62)));
        [f + g, f - g, f * g, chained].map(|x| is_finite(given, x)).concat()
    }
    dual_quotient: "÷ of `Dual` is finite, for values and gradients up to 2³⁰ and a divisor of 2⁻³⁰ or above" |given| {
        let f = dual(given, "f", up_to(30), up_to(30));
        let g = dual(given, "g", Range::within(2.0_f64.powi(-30), 2.0_f64.powi(30)), up_to(30));
        [is_finite(given, f / g), is_finite(given, f / -g)].concat()
    }
    dual_root: "√ of `Dual` is finite, for a value of 2⁻¹²⁶ or above and a gradient up to 2⁶²" |given| {
        is_finite(given, dual(given, "f", Range::within(2.0_f64.powi(-126), given.format().max()), up_to(62)).sqrt())
    }
    dual_root_at_zero: "√ of `Dual` at 0 is 0, and no component of its gradient is finite" |given| {
        let root = dual(given, "f", zero(), Range::ANY).sqrt();
        [within([root.value], zero()), not_finite(root)].concat()
    }
    dual_logarithm_at_zero: "`Elementary::ln` of `Dual` at 0 is −∞, and no component of its gradient is finite, given that `libm::log` of 0 is −∞" |given| {
        let ln = dual(given, "f", zero(), Range::ANY).ln();
        [within([ln.value], Range::within(-INF, -INF)), not_finite(ln)].concat()
    }
    dual_below_zero: "√ and `Elementary::ln` of `Dual` below 0 are NaN, and so is their gradient, given that `libm::log` is NaN there" |given| {
        let f = dual(given, "f", below(), Range::ANY);
        [f.sqrt(), f.ln()].map(|x| [within([x.value], Range::NAN), components(x.gradient, Range::NAN)].concat()).concat()
    }
    dual_quotient_by_zero: "÷ of `Dual` by 0 and `Elementary::powi` of −1 at 0 are not finite, and neither is any component of their gradient" |given| {
        let (f, g) = (any_dual(given, "f"), dual(given, "g", zero(), Range::ANY));
        [f / g, g.powi(-1)].map(|x| [within([x.value], Range::NOT_FINITE), not_finite(x)].concat()).concat()
    }
    dual_absolute_at_zero: "`Real::abs` of `Dual` at 0 is 0, and its gradient 0 if that of the argument is finite" |given| {
        let f = dual(given, "f", zero(), finite(given)).abs();
        [within([f.value], zero()), components(f.gradient, zero())].concat()
    }
    dual_absolute_of_nan: "`Real::abs` of `Dual` is NaN for NaN, and each component of its gradient NaN if it was" |given| {
        let f = dual(given, "f", Range::NAN, Range::NAN).abs();
        [within([f.value], Range::NAN), components(f.gradient, Range::NAN)].concat()
    }
    dual_power_zero: "`Elementary::powi` of 0 of `Dual` is 1, and its gradient 0, any bits" |given| {
        let f = any_dual(given, "f").powi(0);
        [within([f.value], Range::within(1.0, 1.0)), components(f.gradient, zero())].concat()
    }
    dual_waves: "`Elementary::sin` and `Elementary::cos` of `Dual` are finite, for a finite value and gradient, given that those of `libm` are in [−1, 1]" |given| {
        let f = dual(given, "f", finite(given), finite(given));
        [f.sin(), f.cos()].map(|x| is_finite(given, x)).concat()
    }
    dual_exponential: "`Elementary::exp` of `Dual` is never negative, any bits, given that `libm::exp` is not" |given| {
        within([any_dual(given, "f").exp().value], light().or_nan())
    }
    constants_and_points: "`Dual::constant` has a gradient of 0, and `Dual::point` those of the coordinates, to the bit" |given| {
        let p = any_vector(given, "p");
        let (point, constant) = (Dual::point(p), Dual::constant(p.x));
        let (one, zero) = (Term::ONE, Term::ZERO);
        let gradients = [[one, zero, zero], [zero, one, zero], [zero, zero, one]];
        let axes = [point.x, point.y, point.z].into_iter().zip(gradients).flat_map(|(x, gradient)| same(x.gradient, gradient));
        axes.chain(same([point.x.value, point.y.value, point.z.value], p)).chain(same(constant.gradient, [zero; 3])).collect()
    }
    implicit_of_a_cone: "`normal::implicit` of x² + y² − z² is `None` at the tip, and finite or `None` at any other point" |given| {
        let f = |p: Vec3<Dual<Term>>| p.x * p.x + p.y * p.y - p.z * p.z;
        let tip = none(normal::implicit(f, given.vector("tip", zero())));
        [tip, none_or_finite(given, normal::implicit(f, any_vector(given, "p")))].concat()
    }
}
