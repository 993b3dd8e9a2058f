//! (62) What a constructor proved holds in another number type, too.

use std::f64::consts::PI;

use proptest::prelude::*;
use shading::{
    Attenuation, Cone, Light, PointLight, Ranged, Rgb, SoftCone, SpotLight, UnitVec3, Vec3,
};

use super::Number;
use super::check::{check, same};
use super::exact;
use super::generators::{adversarial, coefficients, direction, rounded};

/// A direction in `f64` and the same in `T`. Of many nearby ones it is the one whose rounding to `T`
/// changes the length the most, so that it becomes the shortest or the longest.
fn worst_direction<T: Number>(longest: bool) -> impl Strategy<Value = [UnitVec3<f64>; 2]> {
    let way = [(); 3].map(|()| -1.0..1.0);
    (direction(), way, 0..40).prop_map(move |(near, way, octave): (_, [f64; 3], i32)| {
        let size = f64::exp2(f64::from(-octave));
        let candidate = |i: i32| {
            let share = f64::from(i) / 64.0 * size;
            let moved = Vec3::from([0, 1, 2].map(|k| near[k] + share * way[k]));
            let wide = moved.unit_or(rounded(near));
            (wide, wide.cast(T::of).cast(T::to_f64))
        };
        let excess = |narrow: UnitVec3<f64>| {
            let excess = exact::square_excess((*narrow).into());
            if longest { excess } else { -excess }
        };
        let worst = (0..64).map(candidate);
        let worst = worst.max_by(|(_, a), (_, b)| excess(*a).total_cmp(&excess(*b)));
        let (wide, narrow) = worst.expect("64 candidates");
        [wide, narrow]
    })
}

/// The narrowest cones: a hard one, and soft ones with a hard and with a soft edge.
fn narrow<T: Number>() -> (Cone<T>, [SoftCone<T>; 2]) {
    let [zero, angle] = [T::ZERO, T::of(0.01)];
    let hard = Cone::of_half_angle(zero).expect("the property expects an angle, and there is none");
    let soft = [zero, angle].map(|outer| {
        SoftCone::of_half_angles(zero, outer)
            .expect("the property expects angles, and there is none")
    });
    (hard, soft)
}

/// A cone of half-angle 0, cast from `f64` or to it, contains its axis, which is cast with it.
fn cast_cone_contains_its_axis<T: Number>() {
    check(worst_direction::<T>(false), |[wide, narrow_axis]| {
        let axis = wide.cast(T::of);
        let (hard, soft) = narrow::<f64>();
        same([hard.cast(T::of).factor(axis, -axis); 3], [T::ONE; 3])?;
        for cone in soft {
            same([cone.cast(T::of).factor(axis, -axis); 3], [T::ONE; 3])?;
        }
        let (hard, soft) = narrow::<T>();
        let axis = narrow_axis;
        prop_assert_eq!(hard.cast(T::to_f64).factor(axis, -axis), 1.0);
        for cone in soft {
            prop_assert_eq!(cone.cast(T::to_f64).factor(axis, -axis), 1.0);
        }
        Ok(())
    });
}

/// A cone of half-angle π, cast from `f64` or to it, lights every direction: often the one opposite to
/// the middle of its beam.
fn cast_cone_of_every_direction_lights_every_direction<T: Number>() {
    let direction = || worst_direction::<T>(true);
    check(
        (direction(), direction(), any::<bool>()),
        |(axis, l, is_opposite)| {
            let l = if is_opposite { axis } else { l };
            let hard = Cone::<f64>::from_half_angle(PI)
                .expect("the property expects an angle, and there is none");
            let soft = SoftCone::<f64>::from_half_angles(PI, PI)
                .expect("the property expects angles, and there is none");
            let [axis_in_t, l_in_t] = [axis, l].map(|[wide, _]| wide.cast(T::of));
            same([hard.cast(T::of).factor(axis_in_t, l_in_t); 3], [T::ONE; 3])?;
            same([soft.cast(T::of).factor(axis_in_t, l_in_t); 3], [T::ONE; 3])?;

            let hard = Cone::of_cosine(T::NEG_ONE)
                .expect("the property expects a cosine, and there is none");
            let soft = SoftCone::from(hard);
            let [[_, axis], [_, l]] = [axis, l];
            prop_assert_eq!(hard.cast(T::to_f64).factor(axis, l), 1.0);
            prop_assert_eq!(soft.cast(T::to_f64).factor(axis, l), 1.0);
            Ok(())
        },
    );
}

/// A light without a range has none after any cast, nor after a cast back.
fn cast_keeps_that_there_is_no_range<T: Number>() {
    check((coefficients::<T>(), adversarial::<T>()), |(free, q)| {
        let endless = Ranged::from(free);
        let wide = endless.cast(T::to_f64);
        prop_assert_eq!(wide, Ranged::from(free.cast(T::to_f64)));
        prop_assert_eq!(wide.range(), f64::INFINITY);
        prop_assert_eq!(wide.cast(T::of), endless);
        same([wide.cast(T::of).at(q); 3], [free.at(q); 3])
    });
}

/// Lights carry their cones and ranges through a cast.
fn cast_light_keeps_what_its_parts_keep<T: Number>() {
    check(worst_direction::<T>(false), |[axis, _]| {
        let (hard, [_, soft]) = narrow::<f64>();
        let (position, intensity) = (Vec3::ZERO, Rgb::WHITE);
        let attenuation = Ranged::from(Attenuation::NONE);
        let point = PointLight {
            position,
            intensity,
            attenuation,
        };
        prop_assert_eq!(
            point.cast(T::of).attenuation,
            Ranged::from(Attenuation::NONE)
        );
        let spot = SpotLight {
            point,
            axis,
            cone: hard,
        }
        .cast(T::of);
        prop_assert_eq!(spot.point.attenuation, Ranged::from(Attenuation::NONE));
        same([spot.cone.factor(spot.axis, -spot.axis); 3], [T::ONE; 3])?;
        let cone = soft;
        if let Light::Spot(spot) = Light::from(SpotLight { point, axis, cone }).cast(T::of) {
            prop_assert_eq!(spot.point.attenuation, Ranged::from(Attenuation::NONE));
            same([spot.cone.factor(spot.axis, -spot.axis); 3], [T::ONE; 3])?;
        }
        Ok(())
    });
}

properties! { cast:
    cast_cone_contains_its_axis,
    cast_cone_of_every_direction_lights_every_direction,
    cast_keeps_that_there_is_no_range,
    cast_light_keeps_what_its_parts_keep,
}
