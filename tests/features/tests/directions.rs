//! A file may hold a direction as a vector of any length. What is read is as good as what the
//! constructors make: a spot lights its own axis, and a cone of half-angle π has no dark spot.

#![allow(
    clippy::cast_lossless,
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_precision_loss
)] // of numbers that fit, or that are to be rounded

use std::fmt::Debug;

use kit::random::Random;
use proptest::prelude::*;
use serde::Serialize;
use serde::de::DeserializeOwned;
use shading::{Cone, Elementary, UnitVec3, Vec3};

/// `f32` and `f64`, as a file holds them.
trait Number: Elementary + PartialOrd + Serialize + DeserializeOwned + Debug {
    /// u, the unit roundoff.
    const U: f64;
    const LEAST: Self;
    const INFINITY: Self;
    const NAN: Self;
    fn bits(self) -> u64;
    fn from_bits(bits: u64) -> Self;
}

macro_rules! number {
    ($($float:ident $unsigned:ident)*) => {$(
        impl Number for $float {
            const U: f64 = $float::EPSILON as f64 / 2.0;
            const LEAST: Self = $float::from_bits(1);
            const INFINITY: Self = $float::INFINITY;
            const NAN: Self = $float::NAN;
            fn bits(self) -> u64 {
                self.to_bits().into()
            }
            fn from_bits(bits: u64) -> Self {
                $float::from_bits(bits as $unsigned)
            }
        }
    )*};
}
number!(f32 u32 f64 u64);

macro_rules! for_f32_and_f64 {
    ($($test:ident)*) => {
        mod f32 {
            $(#[test]
            fn $test() {
                super::$test::<f32>();
            })*
        }
        mod f64 {
            $(#[test]
            fn $test() {
                super::$test::<f64>();
            })*
        }
    };
}

for_f32_and_f64! {
    a_vector_of_any_length_is_read_as_its_direction
    a_vector_of_length_1_keeps_its_bits
    what_is_read_is_what_the_constructor_takes
    a_vector_without_a_direction_is_refused_with_the_reason
    an_axis_of_few_decimals_is_lit_by_its_own_spot
    a_cone_of_every_direction_has_no_dark_spot
}

fn json<T: Number>(v: [T; 3]) -> serde_json::Result<UnitVec3<T>> {
    serde_json::from_str(&serde_json::to_string(&v)?)
}

/// The direction that is read from a list of numbers in three formats, one of them without names.
fn read<T: Number>(v: [T; 3]) -> UnitVec3<T> {
    let direction = json(v).unwrap_or_else(|error| panic!("{v:?}: {error}"));
    let ron: UnitVec3<T> = ron::from_str(&ron::to_string(&v).unwrap()).unwrap();
    let bytes = postcard::to_allocvec(&v).unwrap();
    assert_eq!([ron, postcard::from_bytes(&bytes).unwrap()], [direction; 2]);
    direction
}

fn bits<T: Number>(v: impl Into<[T; 3]>) -> [u64; 3] {
    v.into().map(T::bits)
}

fn a_vector_of_any_length_is_read_as_its_direction<T: Number>() {
    // a triangle of 2, 3, 6 has an integer length
    for size in [
        T::LEAST,
        T::of(1e-30),
        T::of(0.001),
        T::ONE,
        T::of(1e30),
        T::MAX / T::of(8.0),
    ] {
        let v = Vec3::new(T::of(2.0), T::of(-3.0), T::of(6.0)) * size;
        let [x, y, z] = read(v.into()).into();
        for (component, sevenths) in [(x, 2.0), (y, -3.0), (z, 6.0)] {
            // 3.5u for the unit vector, and 1u each for the two roundings of what is expected
            let expected = T::of(sevenths) / T::of(7.0);
            let tolerance = T::of(5.5 * T::U) * expected.abs();
            assert!(
                (component - expected).abs() <= tolerance,
                "{size:?}: {component:?}"
            );
        }
    }
    // three decimals, which is what a newcomer writes
    assert_eq!(
        Some(read([T::of(0.577); 3])),
        Vec3::splat(T::of(0.577)).unit()
    );
}

fn a_vector_of_length_1_keeps_its_bits<T: Number>() {
    // also where a component is subnormal, or almost 1
    let number = || {
        let near_1 = any::<u8>().prop_map(|steps| T::from_bits(T::ONE.bits() - u64::from(steps)));
        let any = (any::<u32>(), -1.0..1.0);
        let any = any.prop_map(|(bits, x)| T::of_f32(f32::from_bits(bits)) * T::of(x));
        let finite = any.prop_filter("finite", |x| x.abs() <= T::MAX);
        prop_oneof![near_1, finite, (-1.0..1.0).prop_map(T::of)]
    };
    proptest!(ProptestConfig::with_cases(2000), |(v in proptest::array::uniform3(number()))| {
        let [x, y, z] = v;
        let made = [UnitVec3::new(x, y, z), Vec3::from(v).unit()];
        for direction in made.into_iter().flatten() {
            prop_assert_eq!(bits(read(direction.into())), bits(direction));
        }
    });
}

/// A climb to the vector whose direction is farthest from length 1: `new` still takes it.
fn what_is_read_is_what_the_constructor_takes<T: Number>() {
    let off = |v: [T; 3]| {
        let unit = Vec3::from(v).unit().expect("not 0");
        (unit.dot(unit) - T::ONE).abs()
    };
    let (mut random, mut worst) = (Random(1), T::ZERO);
    for _ in 0..8 {
        let mut place = [(); 3].map(|()| random.signed());
        let mut height = T::ZERO;
        for _ in 0..2000 {
            let mut next = place;
            let exponent = i32::try_from(random.below(54)).expect("small");
            next[random.below(3)] += 2.0_f64.powi(-exponent) * random.signed();
            let v = next.map(|x| T::of(x));
            let found = off(v);
            if found >= height {
                (place, height) = (next, found);
            }
        }
        let [x, y, z] = read(place.map(|x| T::of(x))).into();
        assert!(UnitVec3::new(x, y, z).is_some(), "{place:?}");
        worst = worst.at_least(height);
    }
    assert!(worst >= T::of(4.0 * T::U), "it did not climb: {worst:?}");
}

fn a_vector_without_a_direction_is_refused_with_the_reason<T: Number>() {
    let reason = |v: [T; 3]| {
        let bytes = ron::to_string(&v).unwrap();
        ron::from_str::<UnitVec3<T>>(&bytes)
            .unwrap_err()
            .code
            .to_string()
    };
    let zero = "direction: the zero vector has none; a vector of any other length will do";
    assert_eq!(reason([T::ZERO; 3]), zero);
    assert_eq!(reason([-T::ZERO; 3]), zero);
    let broken = "direction: a coordinate is not finite";
    for x in [T::INFINITY, -T::INFINITY, T::NAN] {
        assert_eq!(reason([T::ONE, x, T::ZERO]), broken);
        // nor is it written
        let written = UnitVec3::assume_unit(Vec3::new(T::ONE, T::ZERO, x));
        assert_eq!(
            serde_json::to_string(&written).unwrap_err().to_string(),
            broken
        );
    }
    let nothing = UnitVec3::assume_unit(Vec3::<T>::ZERO);
    assert_eq!(
        serde_json::to_string(&nothing).unwrap_err().to_string(),
        zero
    );
}

/// Axes as people write them: with so many decimals, and with all of them.
fn axes<T: Number>() -> impl Iterator<Item = UnitVec3<T>> {
    let mut random = Random(2);
    let vector = move |_| {
        let v = Vec3::from([(); 3].map(|()| random.signed()));
        v.unit().expect("not 0")
    };
    (0..2000).map(vector).flat_map(|axis| {
        [2, 3, 6, 15].map(|decimals| {
            let power = 10_f64.powi(decimals);
            let rounded = axis.map(|c| T::of((c * power).round() / power));
            json(rounded.into()).expect("a direction")
        })
    })
}

fn an_axis_of_few_decimals_is_lit_by_its_own_spot<T: Number>() {
    let narrow = [0.0, 1e-9, 1e-4, 9e-4, 0.01].map(|angle| {
        let json = serde_json::json!({ "half_angle": angle });
        serde_json::from_value::<Cone<T>>(json).unwrap()
    });
    for axis in axes::<T>() {
        for cone in narrow {
            assert_eq!(cone.factor(axis, -axis), T::ONE, "{axis:?}, {cone:?}");
        }
    }
}

fn a_cone_of_every_direction_has_no_dark_spot<T: Number>() {
    let all: Cone<T> = serde_json::from_str(r#"{"cosine": -1}"#).unwrap();
    for axis in axes::<T>() {
        assert_eq!(all.factor(axis, axis), T::ONE, "{axis:?}");
    }
}

/// A direction that was cast is not a unit vector to the roundoff of the new type, and is made one.
#[test]
fn a_direction_of_another_number_type_is_normalized() {
    for axis in axes::<f32>() {
        let cast = axis.cast(f64::from);
        let read = json(cast.into()).unwrap();
        assert_eq!(
            Some(read),
            UnitVec3::new(cast.x, cast.y, cast.z).or(cast.unit())
        );
        assert!(UnitVec3::new(read.x, read.y, read.z).is_some());
    }
}

/// Cosines at the ends, and the neighbors of the ends of the range that counts as everything, in
/// every type: what was written is read with its bits.
#[test]
fn a_cone_keeps_its_bits_after_each_pair_of_casts() {
    fn survives<T: Number>(cone: Cone<T>) {
        let text = serde_json::to_string(&cone).unwrap();
        let read: Cone<T> = serde_json::from_str(&text).unwrap();
        // which shows all bits
        assert_eq!(format!("{read:?}"), format!("{cone:?}"), "{text}");
        let bytes = postcard::to_allocvec(&cone).unwrap();
        assert_eq!(postcard::from_bytes::<Cone<T>>(&bytes).unwrap(), read);
    }
    let narrow = |x: f64| x as f32;
    let ends = [-1.0, -0.0, 0.0, 1.0];
    let near = |end: f64| {
        (-12..=12).map(move |step| end + f64::from(step) * f64::from(f32::EPSILON) / 8.0)
    };
    let nearer = |end: f64| (-12..=12).map(move |step| end + f64::from(step) * f64::EPSILON / 8.0);
    let cosines = ends
        .into_iter()
        .flat_map(|end| near(end).chain(nearer(end)));
    let cosines: Vec<_> = cosines.filter(|x| x.abs() <= 1.0).collect();
    let pairs = cosines
        .iter()
        .flat_map(|&inner| cosines.iter().map(move |&outer| (inner, outer)));
    for (inner, outer) in pairs.filter(|(inner, outer)| inner >= outer) {
        let double = Cone::from_cosines(inner, outer).unwrap();
        let single = Cone::from_cosines(narrow(inner), narrow(outer)).unwrap();
        survives(double);
        survives(single);
        survives(double.cast(narrow));
        survives(single.cast(f64::from));
        survives(double.cast(narrow).cast(f64::from));
        assert_eq!(single.cast(f64::from).cast(narrow), single);
    }
}
