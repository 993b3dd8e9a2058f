//! Vectors, directions, colors.

use core::iter::Sum;
use core::ops::{Add, AddAssign, Deref, Div, Mul, MulAssign, Neg, Sub, SubAssign};

use shading::{Rgb, UnitVec3, Vec3};

pub fn call() {
    vectors();
    directions();
    colors();
    encodings();
}

fn vectors() {
    let (mut a, b) = (Vec3::new(1.0_f32, 2.0, 3.0), Vec3::new(4.0, 5.0, 6.0));
    let Vec3 { x, y, z } = a;
    assert_eq!(<Vec3 as From<[f32; 3]>>::from([x, y, z]), a);
    assert_eq!(<[f32; 3] as From<Vec3>>::from(a), [1.0, 2.0, 3.0]);
    assert_eq!(<Vec3 as Default>::default(), Vec3::ZERO);

    assert_eq!(Vec3::dot(a, b), 32.0); // 4 + 10 + 18
    assert_eq!(Vec3::cross(a, b), Vec3::new(-3.0, 6.0, -3.0));
    assert_eq!(Vec3::length(Vec3::new(2.0, 3.0, 6.0)), 7.0);
    assert_eq!(Vec3::map(a, f64::from).z, 3.0);
    assert_eq!(Vec3::unit(Vec3::new(0.0, 0.0, 2.0)), Some(UnitVec3::Z));
    assert_eq!(Vec3::unit_or(a * 0.0, UnitVec3::X), UnitVec3::X);

    assert_eq!(<Vec3 as Add>::add(a, b), Vec3::new(5.0, 7.0, 9.0));
    assert_eq!(<Vec3 as Sub>::sub(b, a), Vec3::new(3.0, 3.0, 3.0));
    assert_eq!(<Vec3 as Mul<f32>>::mul(a, 2.0), Vec3::new(2.0, 4.0, 6.0));
    assert_eq!(<Vec3 as Div<f32>>::div(b, 2.0), Vec3::new(2.0, 2.5, 3.0));
    assert_eq!(<Vec3 as Neg>::neg(a), Vec3::new(-1.0, -2.0, -3.0));
    assert_eq!(<f32 as Mul<Vec3>>::mul(2.0, b), b + b);
    let double = Vec3::new(1.0_f64, 0.0, 0.0);
    assert_eq!(<f64 as Mul<Vec3<f64>>>::mul(2.0, double).x, 2.0);
    assert_eq!(<Vec3 as Sum>::sum([a, b].into_iter()), a + b);
    assert_eq!(<Vec3 as Sum<&Vec3>>::sum([a, b].iter()), a + b);

    <Vec3 as AddAssign>::add_assign(&mut a, b);
    <Vec3 as SubAssign>::sub_assign(&mut a, Vec3::new(1.0, 1.0, 1.0));
    <Vec3 as MulAssign<f32>>::mul_assign(&mut a, 0.5);
    assert_eq!(a, Vec3::new(2.0, 3.0, 4.0));
}

const UP: UnitVec3 = UnitVec3::<f32>::normalized(0.0, 3.0, 0.0).unwrap();
const TILTED: UnitVec3<f64> = UnitVec3::<f64>::new(0.0, 0.6, 0.8).unwrap();

fn directions() {
    assert_eq!(UP, UnitVec3::Y);
    assert_eq!(UnitVec3::<f32>::new(1.0, 1.0, 1.0), None);
    assert_eq!(UnitVec3::<f64>::normalized(0.0, 0.0, 0.0), None);
    assert_eq!(UnitVec3::of(0.0, 1.0, 0.0), Some(UP));
    assert_eq!(UnitVec3::cast(TILTED, |x| x as f32).y, 0.6);
    assert_eq!(UnitVec3::assume_unit(Vec3::new(0.0, 1.0, 0.0)), UP);

    let axes = [
        (UnitVec3::X, UnitVec3::NEG_X),
        (UnitVec3::Y, UnitVec3::NEG_Y),
        (UnitVec3::Z, UnitVec3::NEG_Z),
    ];
    for (axis, opposite) in axes {
        assert_eq!(<UnitVec3 as Neg>::neg(axis), opposite);
    }
    assert_eq!(<UnitVec3 as Deref>::deref(&UP).y, 1.0);
    assert_eq!(<Vec3 as From<UnitVec3>>::from(UP), *UP);
    assert_eq!(<[f32; 3] as From<UnitVec3>>::from(UP), [0.0, 1.0, 0.0]);
}

fn colors() {
    let (mut a, b) = (Rgb::new(0.5_f32, 1.0, 2.0), Rgb::gray(2.0));
    let Rgb { r, g, b: blue } = a;
    assert_eq!(<Rgb as From<[f32; 3]>>::from([r, g, blue]), a);
    assert_eq!(<[f32; 3] as From<Rgb>>::from(a), [0.5, 1.0, 2.0]);
    assert_eq!(<Rgb as Default>::default(), Rgb::BLACK);
    assert_eq!(Rgb::clamped(a), Rgb::new(0.5, 1.0, 1.0));
    assert_eq!(Rgb::map(a, f64::from).r, 0.5);

    assert_eq!(<Rgb as Add>::add(a, b), Rgb::new(2.5, 3.0, 4.0));
    assert_eq!(<Rgb as Sub>::sub(b, a), Rgb::new(1.5, 1.0, 0.0));
    assert_eq!(<Rgb as Mul>::mul(a, b), Rgb::new(1.0, 2.0, 4.0));
    assert_eq!(<Rgb as Mul<f32>>::mul(a, 2.0), a * b);
    assert_eq!(<Rgb as Div<f32>>::div(b, 2.0), Rgb::WHITE);
    assert_eq!(<f32 as Mul<Rgb>>::mul(2.0, a), a * b);
    let double = Rgb::gray(0.5_f64);
    assert_eq!(<f64 as Mul<Rgb<f64>>>::mul(2.0, double), Rgb::WHITE);
    assert_eq!(<Rgb as Sum>::sum([a, b].into_iter()), a + b);
    assert_eq!(<Rgb as Sum<&Rgb>>::sum([a, b].iter()), a + b);

    <Rgb as AddAssign>::add_assign(&mut a, b);
    <Rgb as SubAssign>::sub_assign(&mut a, Rgb::WHITE);
    <Rgb as MulAssign<f32>>::mul_assign(&mut a, 2.0);
    assert_eq!(a, Rgb::new(3.0, 4.0, 6.0));
}

fn encodings() {
    const SKY: Rgb = Rgb::<f32>::from_srgb8([0, 128, 255]);
    assert_eq!(Rgb::<f32>::to_srgb8(SKY), [0, 128, 255]);
    assert_eq!(Rgb::<f32>::to_rgb565(Rgb::new(1.0, 0.0, 1.0)), 0xf81f);
    assert_eq!(Rgb::<f32>::from_rgb565(0xf81f), Rgb::new(1.0, 0.0, 1.0));
    assert_eq!(Rgb::<f32>::to_linear8(Rgb::new(1.0, 0.0, 0.5)), [255, 0, 128]);
    assert_eq!(Rgb::<f32>::to_linear565(Rgb::new(1.0, 0.0, 1.0)), 0xf81f);
    let color = Rgb::<f64>::new(1.0, 0.0, 1.0);
    assert_eq!(Rgb::<f64>::to_srgb8(color), [255, 0, 255]);
    assert_eq!(Rgb::<f64>::to_rgb565(color), 0xf81f);
    assert_eq!(Rgb::<f64>::to_linear8(color), [255, 0, 255]);
    assert_eq!(Rgb::<f64>::to_linear565(color), 0xf81f);
}
