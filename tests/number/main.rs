//! What holds of every number type: of the crate's own, and of some that are written from the page of
//! [`Real`](shading::Real) alone.

mod gradients;
mod naive;

use kit::invariants::{Tried, check};
use naive::{Bf16, Broken, Half, Q16};
use shading::{Attenuation, Cone, Dual, UnitVec3, Vec3};

#[test]
fn single() {
    check::<f32>(300);
}

#[test]
fn double() {
    check::<f64>(200);
}

#[test]
fn dual() {
    check::<Dual<f64>>(150);
}

/// A half: 11 bits, and a short range with subnormal numbers.
#[test]
fn half() {
    check::<Half>(300);
}

#[test]
fn bf16() {
    check::<Bf16>(300);
}

#[test]
fn q16() {
    check::<Q16>(300);
}

#[cfg(feature = "fixed")]
#[test]
fn fixed() {
    check::<shading::fixed::Fixed>(300);
}

/// The laws find a number that computes wrongly.
#[test]
fn a_broken_number_is_found() {
    let is_found = |check: fn(u32)| std::panic::catch_unwind(|| check(100)).is_err();
    let found = [
        is_found(check::<Broken<1>>),
        is_found(check::<Broken<2>>),
        is_found(check::<Broken<3>>),
        is_found(check::<Broken<4>>),
        is_found(check::<Broken<5>>),
    ];
    assert_eq!(found, [true; 5]);
}

/// What a constructor refuses, a cast does not make: coefficients that all round to 0 would light
/// everything; a cone keeps its axis, and no range stays none.
#[test]
fn a_cast_proves_again() {
    fn proves<T: Tried>() {
        for [a, b, c] in [
            [0.0, 0.0, 1e-60],
            [0.0, 1e-60, 0.0],
            [1e-60, 0.0, 0.0],
            [1.0, 0.5, 1e300],
        ] {
            let falloff = Attenuation::new(a, b, c).expect("coefficients").cast(T::of);
            let [x, y, z] = falloff.coefficients();
            assert!(
                Attenuation::new(x, y, z).is_some(),
                "{} {falloff:?}",
                T::NAME
            );
            assert_eq!(falloff.range(), T::MAX);
        }
        for cosine in [1.0, 1.0 - 1e-9, -1.0, -1.0 + 1e-9] {
            let cone = Cone::from_cosine(cosine).expect("a cosine").cast(T::of);
            let l = UnitVec3::assume_unit(Vec3::new(T::of(0.6), T::ZERO, T::of(0.8)));
            assert_eq!(cone.factor(l, -l), T::ONE, "{} {cosine}", T::NAME);
            assert_eq!(
                cone.factor(l, l) > T::ZERO,
                cosine < 0.0,
                "{} {cosine}",
                T::NAME
            );
        }
        let clamped = Attenuation::<f64>::NONE.clamped().cast(T::of);
        assert!(clamped.limit() == T::ONE);
        assert!(Attenuation::<f64>::NONE.cast(T::of).limit() == T::MAX);
        let ranged = Attenuation::NONE
            .within_gltf(4.0)
            .expect("a range")
            .cast(T::of);
        assert!(ranged.range() == T::of(4.0) && ranged.is_gltf());
    }
    proves::<f32>();
    proves::<Half>();
    proves::<Bf16>();
    proves::<Q16>();
}
