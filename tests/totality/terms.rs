//! Terms and normalizations.

use std::f64::consts::FRAC_1_PI;

use shading::{DirectionalLight, Rgb, UnitVec3, Vec3, shade, term};
use support::number::{Float, direction, for_f32_and_f64};

use crate::{at_x, mirror};

for_f32_and_f64!(
    lambert_of_nan_is_zero,
    highlight_of_a_nan_cosine_is_zero,
    highlight_with_m_zero_is_one_or_zero,
    huge_m_lights_only_the_mirror_direction,
    highlight_with_an_invalid_m_takes_zero,
    normalization_with_m_zero_is_one_over_pi,
    normalization_with_a_huge_m_is_finite,
    normalization_with_an_invalid_m_takes_zero,
);

fn lambert_of_nan_is_zero<T: Float>() {
    let nan = UnitVec3::assume_unit(at_x(T::NAN));
    assert_eq!(term::lambert(nan, UnitVec3::X), T::ZERO);
}

fn highlight_of_a_nan_cosine_is_zero<T: Float>() {
    let nan = UnitVec3::assume_unit(at_x(T::NAN));
    for m in [0, 1, 2, u32::MAX] {
        assert_eq!(term::phong(nan, UnitVec3::X, m), T::ZERO);
        assert_eq!(term::blinn(nan, UnitVec3::X, m), T::ZERO);
    }
    assert_eq!(term::phong(nan, UnitVec3::X, T::ZERO), T::ZERO);
}

fn highlight_with_m_zero_is_one_or_zero<T: Float>() {
    for cosine in [T::of(T::TINIEST), T::of(0.5), T::ONE] {
        let v = UnitVec3::assume_unit(at_x(cosine));
        assert_eq!(term::phong(UnitVec3::X, v, 0), T::ONE, "{cosine:e}");
        assert_eq!(term::phong(UnitVec3::X, v, T::ZERO), T::ONE, "{cosine:e}");
    }
    let horizon = UnitVec3::assume_unit(at_x(T::ZERO));
    assert_eq!(term::phong(UnitVec3::X, horizon, 0), T::ZERO);
    assert_eq!(term::phong(UnitVec3::X, horizon, T::ZERO), T::ZERO);
}

fn huge_m_lights_only_the_mirror_direction<T: Float>() {
    // (1 − 2⁻¹²)^(2³² − 1) < e^(−2²⁰), which is 0 in every float
    let beside = UnitVec3::assume_unit(at_x(T::of(1.0 - 2.0_f64.powi(-12))));
    assert_eq!(term::phong(UnitVec3::X, beside, u32::MAX), T::ZERO);
    assert_eq!(term::phong(UnitVec3::<T>::X, UnitVec3::X, u32::MAX), T::ONE);
    for m in [T::of(1e30), T::MAX, T::INFINITY] {
        assert_eq!(term::blinn(UnitVec3::X, beside, m), T::ZERO, "{m:e}");
    }
    // 1 to any power is 1, and a cosine that rounds to more than 1 counts as 1
    let above = UnitVec3::assume_unit(at_x(T::of(1.0 + 2.0 * T::U)));
    for m in [T::of(1e30), T::MAX, T::INFINITY] {
        assert_eq!(term::blinn(UnitVec3::X, UnitVec3::X, m), T::ONE, "{m:e}");
        assert_eq!(term::blinn(UnitVec3::X, above, m), T::ONE, "{m:e}");
    }
    assert_eq!(term::blinn(UnitVec3::X, above, u32::MAX), T::ONE);
}

fn highlight_with_an_invalid_m_takes_zero<T: Float>() {
    let n = UnitVec3::<T>::Z;
    let v = direction::<T>([3.0, 0.0, 4.0]);
    let light = [DirectionalLight {
        l: n,
        intensity: Rgb::WHITE,
    }
    .at(Vec3::ZERO)];
    for m in [-T::ONE, -T::of(1e30), -T::INFINITY, T::NAN] {
        assert_eq!(
            (term::phong(n, v, m), term::blinn(n, v, m)),
            (T::ONE, T::ONE),
            "{m:e}"
        );
        let shaded = shade::blinn_phong(n, v, &mirror(m), Rgb::BLACK, light);
        assert_eq!(shaded.specular, Rgb::WHITE, "{m:e}");
    }
}

fn normalization_with_m_zero_is_one_over_pi<T: Float>() {
    // a highlight that is 1 everywhere is Lambert's: 2/(2π) = 1/π and 2·4/(8π) = 1/π, with three
    // roundings
    for factor in [
        term::phong_normalization(T::ZERO),
        term::blinn_normalization(T::ZERO),
    ] {
        assert!((factor.to_f64() - FRAC_1_PI).abs() <= 3.0 * T::U * FRAC_1_PI);
    }
}

fn normalization_with_a_huge_m_is_finite<T: Float>() {
    // (m + 2)/(2π), and (m + 2)(m + 4)/(8πm) = (m + 6 + 8/m)/(8π), with seven roundings
    let near = |factor: T, expected: f64| (factor.to_f64() / expected - 1.0).abs() <= 7.0 * T::U;
    for m in [T::of(1e30), T::MAX] {
        let expected = m.to_f64() * FRAC_1_PI;
        assert!(near(term::phong_normalization(m), 0.5 * expected));
        assert!(near(term::blinn_normalization(m), 0.125 * expected));
    }
    // an infinite m counts as the largest number
    assert_eq!(
        term::phong_normalization(T::INFINITY),
        term::phong_normalization(T::MAX)
    );
    assert_eq!(
        term::blinn_normalization(T::INFINITY),
        term::blinn_normalization(T::MAX)
    );
}

fn normalization_with_an_invalid_m_takes_zero<T: Float>() {
    for m in [-T::ONE, -T::of(1e30), -T::INFINITY, T::NAN] {
        assert_eq!(
            term::phong_normalization(m),
            term::phong_normalization(T::ZERO),
            "{m:e}"
        );
        assert_eq!(
            term::blinn_normalization(m),
            term::blinn_normalization(T::ZERO),
            "{m:e}"
        );
    }
}
