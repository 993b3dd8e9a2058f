//! The sum, and its encodings.

use shading::{IncidentLight, Material, Rgb, UnitVec3, shade};
use support::number::{Float, for_f32_and_f64};

use crate::mirror;

for_f32_and_f64!(
    no_lights_give_the_ambient,
    overflowing_sum_on_black_is_black,
    overflowing_sum_is_the_largest_number,
    clamped_nan_is_zero,
);

fn no_lights_give_the_ambient<T: Float>() {
    let n = UnitVec3::<T>::Z;
    let shaded = shade::phong(n, n, &mirror(1), Rgb::gray(T::of(0.5)), []);
    let expected = [0.5, 0.0, 0.0].map(|part| Rgb::gray(T::of(part)));
    assert_eq!([shaded.ambient, shaded.diffuse, shaded.specular], expected);
}

/// Two lights from above, each with the largest number as its intensity.
fn overflowing<T: Float>() -> [IncidentLight<T>; 2] {
    [IncidentLight {
        l: UnitVec3::Z,
        intensity: Rgb::gray(T::MAX),
        distance: T::MAX,
    }; 2]
}

fn overflowing_sum_on_black_is_black<T: Float>() {
    let n = UnitVec3::<T>::Z;
    let black = Material {
        k_a: Rgb::BLACK,
        k_d: Rgb::BLACK,
        k_s: Rgb::BLACK,
        m: 1,
    };
    let shaded = shade::phong(n, n, &black, Rgb::gray(T::MAX), overflowing());
    assert_eq!(shaded.total(), Rgb::BLACK);
}

fn overflowing_sum_is_the_largest_number<T: Float>() {
    let n = UnitVec3::<T>::Z;
    let shaded = shade::phong(n, n, &mirror(1), Rgb::BLACK, overflowing());
    assert_eq!([shaded.diffuse, shaded.specular], [Rgb::gray(T::MAX); 2]);
    assert_eq!(shaded.total().clamped(), Rgb::WHITE);
}

fn clamped_nan_is_zero<T: Float>() {
    let color = Rgb::new(T::NAN, T::INFINITY, -T::INFINITY).clamped();
    assert_eq!(color, Rgb::new(T::ZERO, T::ONE, T::ZERO));
}

// encodings, which exist for `f32` only

#[test]
fn dark_and_invalid_channels_get_the_lowest_level() {
    let least = f32::from_bits(1);
    let negative_nan = f32::from_bits(u32::MAX);
    for dark in [
        -0.0,
        least,
        -least,
        -1.0,
        f32::MIN,
        f32::NEG_INFINITY,
        f32::NAN,
        negative_nan,
    ] {
        assert_eq!(Rgb::gray(dark).to_srgb8(), [0; 3], "{dark:e}");
        assert_eq!(Rgb::gray(dark).to_rgb565(), 0, "{dark:e}");
        assert_eq!(Rgb::gray(dark).to_linear8(), [0; 3], "{dark:e}");
        assert_eq!(Rgb::gray(dark).to_linear565(), 0, "{dark:e}");
    }
}

#[test]
fn channels_above_one_get_the_highest_level() {
    for bright in [1.0 + f32::EPSILON, 1e30, f32::MAX, f32::INFINITY] {
        assert_eq!(Rgb::gray(bright).to_srgb8(), [255; 3], "{bright:e}");
        assert_eq!(Rgb::gray(bright).to_rgb565(), u16::MAX, "{bright:e}");
        assert_eq!(Rgb::gray(bright).to_linear8(), [255; 3], "{bright:e}");
        assert_eq!(Rgb::gray(bright).to_linear565(), u16::MAX, "{bright:e}");
    }
}
