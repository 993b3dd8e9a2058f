//! Fixed-point numbers, which have no literals.

use shading::fixed::Fixed;
use shading::{Attenuation, Cone, Rgb, SoftCone, UnitVec3};

#[test]
fn conversions() {
    assert_eq!(Fixed::from_bits(Fixed::to_bits(Fixed::MIN)), Fixed::MIN);
    assert_eq!(Fixed::to_f32(Fixed::from_f32(0.5)), 0.5);
    assert!(Fixed::new(0.5) < Fixed::MAX && Fixed::STEP > Fixed::new(0.0));
    assert_eq!(Rgb::<Fixed>::to_srgb8(Rgb::WHITE), [255; 3]);
    assert_eq!(Rgb::<Fixed>::to_rgb565(Rgb::WHITE), u16::MAX);
    assert_eq!(Rgb::<Fixed>::to_linear8(Rgb::WHITE), [255; 3]);
    assert_eq!(Rgb::<Fixed>::to_linear565(Rgb::WHITE), u16::MAX);
}

#[test]
fn constructors() {
    const ZERO: Fixed = Fixed::new(0.0);
    const HALF: Fixed = Fixed::new(0.5);
    const ONE: Fixed = Fixed::new(1.0);
    const NONE: Attenuation<Fixed> = Attenuation::<Fixed>::new(ONE, ZERO, ZERO).unwrap();
    const CONE: Cone<Fixed> = Cone::<Fixed>::from_cosine(HALF).unwrap();
    const UP: UnitVec3<Fixed> = UnitVec3::<Fixed>::new(ZERO, ZERO, ONE).unwrap();
    assert_eq!(UnitVec3::<Fixed>::normalized(ZERO, ZERO, HALF), Some(UP));
    assert!(Attenuation::<Fixed>::within(NONE, ONE).is_some_and(|ranged| ranged.range() == ONE));
    assert_eq!(Cone::<Fixed>::from_half_angle(Fixed::new(4.0)), None);
    assert_eq!(
        SoftCone::<Fixed>::from_cosines(HALF, HALF),
        Some(CONE.into())
    );
    assert_eq!(SoftCone::<Fixed>::from_half_angles(ONE, HALF), None);
}
