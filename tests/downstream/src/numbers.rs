//! Numbers, powers, differentiation.

use core::ops::{Add, Div, Mul, Neg, Sub};

use shading::{Dual, Elementary, Exponent, Real, Vec3};

pub fn call() {
    real::<f32>();
    real::<f64>();
    real::<Dual<f32>>();
    elementary::<f32>();
    elementary::<f64>();
    elementary::<Dual<f64>>();
    exponents();
    duals();
    duals_with_numbers();
}

pub(crate) fn real<T: Real + PartialEq>() {
    let (zero, one) = (<T as Real>::ZERO, <T as Real>::ONE);
    let (two, four) = (<T as Real>::of(2.0), <T as Real>::of_f32(4.0));
    assert!(Real::sqrt(four) == two && Real::abs(-two) == two);
    assert!(Real::at_least(one, two) == two && Real::at_most(four, two) == two);
    assert!(Real::if_positive(zero, one, two) == two);
    assert!(Real::if_above(four, two, one, zero) == one);
    assert!(Real::any_positive(one) && !Real::any_positive(<T as Real>::NEG_ONE));
    let (extreme, max) = (<T as Real>::EXTREME, <T as Real>::MAX);
    assert!(Real::at_least(extreme, max) == max);
}

pub(crate) fn elementary<T: Elementary + PartialEq>() {
    assert!(Elementary::sin(T::ZERO) == T::ZERO && Elementary::cos(T::ZERO) == T::ONE);
    assert!(Elementary::exp(T::ZERO) == T::ONE && Elementary::ln(T::ONE) == T::ZERO);
    assert!(Elementary::powi(T::of(2.0), -2) == T::of(0.25));
}

fn exponents() {
    assert_eq!(<u32 as Exponent<f32>>::raise(3, 0.5), 0.125);
    assert_eq!(<f32 as Exponent<f32>>::raise(0.0, 0.5), 1.0);
    assert_eq!(<f64 as Exponent<f64>>::raise(2.0, 1.0), 1.0);
}

fn duals() {
    let x = Dual::point(Vec3::new(3.0_f32, 0.0, 0.0)).x;
    let Dual { value, gradient } = x;
    assert_eq!((value, gradient), (3.0, Vec3::new(1.0, 0.0, 0.0)));
    let two = Dual::constant(2.0);
    assert_eq!(Dual::chain(x, 9.0, 6.0).gradient.x, 6.0);
    assert!(<Dual as PartialOrd>::partial_cmp(&x, &two).is_some_and(|order| order.is_gt()));

    assert_eq!(<Dual as Add>::add(x, two).gradient.x, 1.0);
    assert_eq!(<Dual as Sub>::sub(two, x).gradient.x, -1.0);
    assert_eq!(<Dual as Mul>::mul(x, x).gradient.x, 6.0);
    assert_eq!(<Dual as Div>::div(x, two).gradient.x, 0.5);
    assert_eq!(<Dual as Neg>::neg(x).gradient.x, -1.0);
}

fn duals_with_numbers() {
    let x = Dual::point(Vec3::new(4.0_f32, 0.0, 0.0)).x;
    assert_eq!(<Dual as Add<f32>>::add(x, 2.0).value, 6.0);
    assert_eq!(<Dual as Sub<f32>>::sub(x, 2.0).value, 2.0);
    assert_eq!(<Dual as Mul<f32>>::mul(x, 2.0).value, 8.0);
    assert_eq!(<Dual as Div<f32>>::div(x, 2.0).value, 2.0);
    assert_eq!(<f32 as Add<Dual>>::add(2.0, x).value, 6.0);
    assert_eq!(<f32 as Sub<Dual>>::sub(2.0, x).value, -2.0);
    assert_eq!(<f32 as Mul<Dual>>::mul(2.0, x).value, 8.0);
    assert_eq!(<f32 as Div<Dual>>::div(2.0, x).value, 0.5);

    let x = Dual::constant(4.0_f64);
    assert_eq!(<f64 as Add<Dual<f64>>>::add(2.0, x).value, 6.0);
    assert_eq!(<f64 as Sub<Dual<f64>>>::sub(2.0, x).value, -2.0);
    assert_eq!(<f64 as Mul<Dual<f64>>>::mul(2.0, x).value, 8.0);
    assert_eq!(<f64 as Div<Dual<f64>>>::div(2.0, x).value, 0.5);
}
