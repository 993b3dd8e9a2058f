//! Dual numbers.

use shading::{Dual, Elementary, Real, Vec3, normal};
use support::number::{Float, for_f32_and_f64};

use crate::at_x;

for_f32_and_f64!(
    dual_root_at_zero_has_no_finite_gradient,
    dual_logarithm_at_zero_has_no_finite_gradient,
    dual_quotient_by_zero_has_no_finite_gradient,
    dual_absolute_value_at_zero_is_flat,
    dual_absolute_value_of_nan_is_nan,
    dual_root_and_logarithm_below_zero_have_no_gradient,
    dual_power_of_zero_is_one_and_flat,
);

/// The first variable, with this value.
fn variable<T: Float>(value: f64) -> Dual<T> {
    Dual::point(at_x(T::of(value))).x
}

/// The value is the result for the plain number, and the derivative does not exist.
fn assert_no_derivative<T: Float>(dual: Dual<T>, value: T) {
    assert_eq!(dual.value, value);
    assert!(!dual.gradient.x.is_finite(), "{dual:?}");
}

fn dual_root_at_zero_has_no_finite_gradient<T: Float>() {
    assert_no_derivative(variable::<T>(0.0).sqrt(), T::ZERO);
}

fn dual_logarithm_at_zero_has_no_finite_gradient<T: Float>() {
    assert_no_derivative(variable::<T>(0.0).ln(), -T::INFINITY);
}

fn dual_quotient_by_zero_has_no_finite_gradient<T: Float>() {
    let x = variable::<T>(0.0);
    assert_no_derivative(Dual::constant(T::ONE) / x, T::INFINITY);
    assert_no_derivative(x.powi(-1), T::INFINITY);
    assert_no_derivative(variable::<T>(1.0) / T::ZERO, T::INFINITY);
}

fn dual_absolute_value_at_zero_is_flat<T: Float>() {
    let zero = variable::<T>(0.0).abs();
    assert_eq!((zero.value, zero.gradient), (T::ZERO, Vec3::ZERO));
}

fn dual_absolute_value_of_nan_is_nan<T: Float>() {
    let nan = (-variable::<T>(1.0)).sqrt().abs();
    assert!(nan.value.to_f64().is_nan());
    assert!(!nan.gradient.x.is_finite(), "{nan:?}");
    assert!(Dual::constant(T::NAN).abs().value.to_f64().is_nan());
}

fn dual_root_and_logarithm_below_zero_have_no_gradient<T: Float>() {
    for below in [T::TINIEST, 1.0, T::MAX.to_f64()].map(|x| -variable::<T>(x)) {
        for dual in [below.sqrt(), below.ln()] {
            assert!(dual.value.to_f64().is_nan());
            assert!(!dual.gradient.x.is_finite(), "{dual:?}");
        }
    }
    // a function has no normal where it is undefined
    let f = |p: Vec3<Dual<T>>| p.x.ln() + p.z;
    assert_eq!(normal::implicit(f, at_x(-T::ONE)), None);
    let f = |p: Vec3<Dual<T>>| p.x.ln().abs() + p.z;
    assert_eq!(normal::implicit(f, at_x(-T::ONE)), None);
}

fn dual_power_of_zero_is_one_and_flat<T: Float>() {
    let x = variable::<T>(0.0).powi(0);
    assert_eq!((x.value, x.gradient), (T::ONE, Vec3::ZERO));
}
