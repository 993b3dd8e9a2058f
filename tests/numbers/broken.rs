//! The properties find a number that computes wrongly, and print the simplest input as Rust that
//! can be pasted.

use std::ops::{Add, Div, Mul, Neg, Sub};

use properties::{
    NAMES, Number, Numbers, Outcome, Real, Rgb, Scene, UnitVec3, numbers, sun, try_property,
};
use proptest::prop_assert;

/// What a property says of a number with this fault.
fn found<const FAULT: u8>(
    property: fn(&Numbers<Broken<FAULT>>) -> properties::Outcome,
) -> Option<String> {
    try_property("numbers::some", "Broken", property).err()
}

#[test]
fn a_wrong_operation_is_found() {
    for message in [
        found::<1>(numbers::each_operation_rounds_once),
        found::<2>(numbers::each_operation_rounds_once),
        found::<3>(numbers::each_operation_rounds_once),
        found::<4>(numbers::a_comparison_decides),
        found::<5>(numbers::each_operation_rounds_once),
    ] {
        assert!(message.is_some());
    }
}

/// The property divides x by y + ¼. 0/¼ is right, and the next simplest x is 1.
#[test]
fn a_failure_is_printed_as_rust() {
    let message = found::<3>(numbers::each_operation_rounds_once).expect("a wrong quotient");
    let call = "properties::numbers::some(&Numbers { x: 1.0, ..Numbers::default() }.cast(Broken::of)).unwrap();";
    assert!(message.contains(call), "{message}");
    // the same, pasted
    let input = Numbers {
        x: 1.0,
        ..Numbers::default()
    };
    assert!(numbers::each_operation_rounds_once(&input.cast(Broken::<3>::of)).is_err());
}

/// Of a scene, what matters remains: two lights.
#[test]
fn a_scene_is_printed_on_few_lines() {
    fn has_one_light(scene: &Scene<f32>) -> Outcome {
        prop_assert!(scene.lights.len() < 2, "too many");
        Ok(())
    }
    let message = try_property("light::has_one", "f32", has_one_light).expect_err("two lights");
    let expected = "To reproduce it, with `use properties::*;`:

properties::light::has_one(&Scene { lights: vec![sun(UnitVec3::Z, Rgb::WHITE), sun(UnitVec3::Z, Rgb::WHITE)],
    ..Scene::default() }.cast(f32::of)).unwrap();
";
    let from = |text: &str| text[text.find("To reproduce").expect("a call")..].to_string();
    assert_eq!(from(&message), from(expected));
    // the same, pasted
    let input = Scene {
        lights: vec![sun(UnitVec3::Z, Rgb::WHITE), sun(UnitVec3::Z, Rgb::WHITE)],
        ..Scene::default()
    }
    .cast(f32::of);
    assert!(has_one_light(&input).is_err());
}

/// Each property of the library is in its table of contents, which makes the tests.
#[test]
fn every_property_is_listed() {
    let topics = [
        ("light", include_str!("../properties/src/light.rs")),
        (
            "directions",
            include_str!("../properties/src/directions.rs"),
        ),
        ("terms", include_str!("../properties/src/terms.rs")),
        ("falloff", include_str!("../properties/src/falloff.rs")),
        ("normals", include_str!("../properties/src/normals.rs")),
        ("numbers", include_str!("../properties/src/numbers.rs")),
        ("colors", include_str!("../properties/src/colors.rs")),
    ];
    let mut functions = Vec::new();
    for (topic, source) in topics {
        for line in source
            .lines()
            .filter_map(|line| line.strip_prefix("pub fn "))
        {
            let name = line.split(['<', '(']).next().expect("a name");
            functions.push(format!("{topic}::{name}"));
        }
    }
    functions.sort();
    let mut listed = NAMES.to_vec();
    listed.sort_unstable();
    assert_eq!(functions, listed);
}

/// `f32`, with a fault: a root, a product, a quotient, a selection or a sum that is wrong.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Broken<const FAULT: u8>(f32);

macro_rules! broken {
    ($($trait:ident $method:ident: $fault:literal),*) => {
        $(impl<const FAULT: u8> $trait for Broken<FAULT> {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                let wrong = if FAULT == $fault { 1.0 + 4.0 * f32::EPSILON } else { 1.0 };
                Self(self.0.$method(other.0) * wrong)
            }
        })*
    };
}

broken!(Add add: 5, Sub sub: 0, Mul mul: 2, Div div: 3);

impl<const FAULT: u8> Neg for Broken<FAULT> {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl<const FAULT: u8> Real for Broken<FAULT> {
    type Mask = bool;
    type Sum = Rgb<Self>;
    const ZERO: Self = Self(0.0);
    const ONE: Self = Self(1.0);
    const NEG_ONE: Self = Self(-1.0);
    const MAX: Self = Self(f32::MAX);
    const EXTREME: Self = Self(f32::EXTREME);

    fn of(literal: f64) -> Self {
        Self(f32::of(literal))
    }

    fn sqrt(self) -> Self {
        Self(
            self.0.sqrt()
                * if FAULT == 1 {
                    1.0 + 4.0 * f32::EPSILON
                } else {
                    1.0
                },
        )
    }

    fn above(self, other: Self) -> bool {
        self.0 > other.0 || FAULT == 4 && self.0 >= other.0
    }
}

impl<const FAULT: u8> Number for Broken<FAULT> {
    const U: f64 = f32::U;
    const SMALLEST: f64 = f32::SMALLEST;
    const LARGEST: f64 = f32::LARGEST;
    const LARGE: f64 = f32::LARGE;

    fn exact(self) -> f64 {
        self.0.into()
    }
}
