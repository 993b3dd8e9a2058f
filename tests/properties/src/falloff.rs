//! Light that fades with distance, and at the edge of a cone.

use proptest::prelude::*;
use shading::{Attenuation, Cone, Elementary, Real, UnitVec3, attenuation};

use crate::book;
use crate::given::{Beam, Falloff};
use crate::tracked::prop_assert_book;
use crate::{Number, Outcome, quarter_turn};

/// The falloff within its range, by both windows, and limited to 1.
fn ranged<T: Real + PartialOrd>(f: &Falloff<T>) -> [Attenuation<T>; 3] {
    let ranged = f.falloff.within(f.r).expect("above 0");
    let gltf = f.falloff.within_gltf(f.r).expect("above 0");
    [ranged, gltf, ranged.clamped()]
}

/// The cone with both kinds of edges.
fn cones<T: Real + PartialOrd>(b: &Beam<T>) -> [Cone<T>; 2] {
    let [inner, outer] = b.cone.cosines();
    let cone = Cone::from_cosines(inner, outer).expect("in order");
    [cone, cone.smoothstep()]
}

/// The next number above, or a larger one.
fn above<T: Number>(x: T) -> T {
    (x * T::of(1.0 + 2.0 * T::U)).at_least(x + T::of(T::SMALLEST))
}

/// 1/(a + bq + cq²), written out, by the function and by the type.
pub fn attenuation_is_its_formula<T: Number>(f: &Falloff<T>) -> Outcome {
    let is_here = f.q == T::ZERO;
    prop_assume!(!is_here || f.falloff.coefficients()[0] > T::ZERO);
    prop_assert_book!(
        f,
        vec![f.falloff.at(f.q)],
        book::attenuation(f.falloff.coefficients(), f.q)
    );
    let [a, b, c] = f.falloff.coefficients();
    prop_assert_eq!(attenuation(a, b, c, f.q), f.falloff.at(f.q));
    Ok(())
}

/// The window of a range is (1 − (q/r)⁴)², or not squared as glTF has it, written out.
pub fn a_range_is_its_formula<T: Number>(f: &Falloff<T>) -> Outcome {
    prop_assume!(f.falloff.coefficients()[0] > T::ZERO || f.q > T::ZERO);
    prop_assert_book!(f, ranged(f).map(|f_r| f_r.at(f.q)).to_vec(), {
        let free = book::attenuation(f.falloff.coefficients(), f.q);
        let window = book::window(f.q, f.r);
        let squared = free * window * window;
        [squared, free * window, free.min(1.0) * window * window]
    });
    Ok(())
}

/// The further a light is, the less of it arrives, or as much: also at the next distance that the
/// number has.
pub fn light_never_rises_with_distance<T: Number>(f: &Falloff<T>) -> Outcome {
    let far = [f.q, above(f.q), above(f.q) + f.further];
    for falloff in [f.falloff].into_iter().chain(ranged(f)) {
        let values = far.map(|q| falloff.at(q));
        prop_assert!(values.is_sorted_by(|a, b| a >= b), "{values:?}");
    }
    Ok(())
}

/// The larger a coefficient is, the less light arrives, or as much.
pub fn light_never_rises_with_a_coefficient<T: Number>(f: &Falloff<T>) -> Outcome {
    let (q, [a, b, c]) = (f.q, f.falloff.coefficients());
    let before = attenuation(a, b, c, q);
    for more in [above as fn(T) -> T, |x| above(x) + T::of(0.25)] {
        let after = [(more(a), b, c), (a, more(b), c), (a, b, more(c))];
        let after = after.map(|(a, b, c)| attenuation(a, b, c, q));
        prop_assert!(
            after.iter().all(|x| *x <= before),
            "{before:?}, then {after:?}"
        );
    }
    Ok(())
}

/// Light is never amplified beyond 1/a, and never negative.
pub fn a_falloff_is_at_most_1_over_a<T: Number>(f: &Falloff<T>) -> Outcome {
    let ([a, ..], is) = (f.falloff.coefficients(), f.falloff.at(f.q));
    prop_assert!(is >= T::ZERO && is <= T::MAX, "{is:?}");
    if a > T::ZERO {
        prop_assert!(is <= T::ONE / a, "{is:?} instead of at most 1/{a:?}");
    }
    Ok(())
}

/// min(1, 1/(a + bq + cq²)), to the bit, and the same with another limit; never more than a limit.
pub fn a_clamped_falloff_is_at_most_its_limit<T: Number>(f: &Falloff<T>) -> Outcome {
    let free = f.falloff.at(f.q);
    for limit in [T::ONE, T::ONE + f.r, T::of(100.0)] {
        let clamped = f.falloff.clamped_to(limit).expect("above 0");
        let least = if free < limit { free } else { limit };
        prop_assert_eq!(clamped.at(f.q), least);
    }
    prop_assert_eq!(f.falloff.clamped_to(T::ONE), Some(f.falloff.clamped()));
    let quarter = T::of(0.25);
    let dim = f.falloff.clamped_to(quarter).expect("above 0");
    prop_assert!(dim.at(f.q) <= quarter, "{:?}", dim.at(f.q));
    Ok(())
}

/// Without attenuation, all light arrives, however far.
pub fn without_attenuation_everything_arrives<T: Number>(f: &Falloff<T>) -> Outcome {
    let none = Attenuation::NONE;
    let endless = none.within(T::MAX).expect("above 0");
    for falloff in [none, Attenuation::default(), endless, none.clamped()] {
        prop_assert_eq!([T::ZERO, f.q, T::MAX].map(|q| falloff.at(q)), [T::ONE; 3]);
    }
    Ok(())
}

/// From the range on, nothing arrives.
pub fn nothing_arrives_from_the_range_on<T: Number>(f: &Falloff<T>) -> Outcome {
    let beyond = [f.r, above(f.r), f.r + f.further, T::MAX];
    for falloff in ranged(f) {
        prop_assert_eq!(beyond.map(|q| falloff.at(q)), [T::ZERO; 4]);
    }
    Ok(())
}

/// A range never makes a light brighter, and the squared window is no brighter than glTF's.
pub fn a_range_never_brightens<T: Number>(f: &Falloff<T>) -> Outcome {
    let free = f.falloff.at(f.q);
    let [squared, gltf, clamped] = ranged(f).map(|falloff| falloff.at(f.q));
    prop_assert!(
        squared <= gltf && gltf <= free,
        "{squared:?}, {gltf:?}, {free:?}"
    );
    prop_assert!(clamped <= squared && clamped <= T::ONE, "{clamped:?}");
    Ok(())
}

/// The factor of a cone is 1 within the inner edge, 0 beyond the outer one, and t² or, for a
/// smoothstep, t²(3 − 2t) between them.
pub fn a_cone_is_its_formula<T: Number>(b: &Beam<T>) -> Outcome {
    let factors = |b: &Beam<f64>, error: f64| {
        let cosine = error - book::dot(book::xyz(b.axis), book::xyz(b.l));
        cones(b).map(|cone| book::cone(cone, cosine))
    };
    prop_assert_book!(
        b,
        cones(b).map(|cone| cone.factor(b.axis, b.l)).to_vec(),
        factors(b, 0.0),
        {
            let [dark, bright] = [-T::COSINE, T::COSINE].map(|error| factors(b, error));
            [bright[0] - dark[0], bright[1] - dark[1]]
        }
    );
    Ok(())
}

/// The factor of a cone is within [0, 1], and a hard one knows nothing between the two.
pub fn a_cone_never_amplifies<T: Number>(b: &Beam<T>) -> Outcome {
    let factor = b.cone.factor(b.axis, b.l);
    prop_assert!(factor >= T::ZERO && factor <= T::ONE, "{factor:?}");
    for cosine in b.cone.cosines() {
        let hard = Cone::from_cosine(cosine).expect("a cosine");
        let factor = hard.factor(b.axis, b.l);
        prop_assert!(factor == T::ZERO || factor == T::ONE, "{factor:?}");
    }
    Ok(())
}

/// On its axis, a cone lets everything through, also one of half-angle 0.
pub fn a_cone_lights_its_axis<T: Number>(b: &Beam<T>) -> Outcome {
    let narrow = Cone::from_cosine(T::ONE).expect("0");
    let wide = Cone::from_cosine(T::NEG_ONE).expect("π");
    for cone in [b.cone, b.cone.smoothstep(), narrow, wide] {
        prop_assert_eq!(cone.factor(b.axis, -b.axis), T::ONE);
    }
    Ok(())
}

/// A cone of half-angle π lights every direction.
pub fn a_cone_of_pi_lights_everything<T: Number>(b: &Beam<T>) -> Outcome {
    let everywhere = Cone::from_cosine(T::NEG_ONE).expect("π");
    for l in [b.l, b.other, b.axis] {
        prop_assert_eq!(everywhere.factor(b.axis, l), T::ONE);
    }
    Ok(())
}

/// A cone lights no less than one within it, and no more than one around it.
pub fn a_wider_cone_never_darkens<T: Number>(b: &Beam<T>) -> Outcome {
    let hard = |cosine| Cone::from_cosine(cosine).expect("a cosine");
    let [narrow, wide] = b.cone.cosines().map(hard);
    let factors = [narrow, b.cone, wide].map(|cone| cone.factor(b.axis, b.l));
    prop_assert!(factors.is_sorted(), "{factors:?}");
    Ok(())
}

/// Nearer to the axis, a cone is as bright or brighter, as far as the cosines tell; a smoothstep
/// but for its rounding.
pub fn a_cone_never_darkens_toward_its_axis<T: Number>(b: &Beam<T>) -> Outcome {
    let cosine = |l: UnitVec3<T>| (-b.axis).dot(l);
    let is_nearer = cosine(b.other) > cosine(b.l);
    let difference = cosine(b.other).exact() - cosine(b.l).exact();
    prop_assume!(T::COSINE == 0.0 || difference.abs() > 2.0 * T::COSINE + T::SMALLEST);
    let (outside, inside) = if is_nearer {
        (b.l, b.other)
    } else {
        (b.other, b.l)
    };
    let [dark, bright] = [outside, inside].map(|l| b.cone.factor(b.axis, l).exact());
    // fixed point may be off by a step
    let roundings = if b.cone.is_smoothstep() { 4.0 } else { 0.0 };
    let slack = roundings * T::U + 4.0 * T::STEP;
    prop_assert!(bright >= dark - slack, "{dark} and then {bright}");
    Ok(())
}

/// Inner and outer edge the same: a hard cone, to the bit, with or without smoothstep.
pub fn a_cone_without_an_edge_is_hard<T: Number>(b: &Beam<T>) -> Outcome {
    for cosine in b.cone.cosines() {
        let hard = Cone::from_cosine(cosine).expect("a cosine");
        let soft = Cone::from_cosines(cosine, cosine).expect("in order");
        let factors = [hard, soft, soft.smoothstep()].map(|cone| cone.factor(b.axis, b.l));
        prop_assert_eq!(factors, [factors[0]; 3]);
    }
    Ok(())
}

/// L turned about the axis of a cone sees the same factor, to the bit.
pub fn a_cone_is_round<T: Number>(b: &Beam<T>) -> Outcome {
    let turned = UnitVec3::assume_unit(quarter_turn(*b.l));
    prop_assert_eq!(
        b.cone.factor(UnitVec3::NEG_Z, turned),
        b.cone.factor(UnitVec3::NEG_Z, b.l)
    );
    Ok(())
}

/// A half-angle is measured from the axis: what is nearer is lit, and what is further off is dark.
pub fn a_half_angle_is_measured_from_the_axis<T: Number + Elementary>(b: &Beam<T>) -> Outcome {
    let [axis, l] = [b.axis, b.l].map(|u| book::xyz(u.cast(T::exact)));
    let off_axis = book::length(book::cross(axis, l)).atan2(-book::dot(axis, l));
    let [inner, outer] = b.cone.cosines().map(|cosine| cosine.exact().acos());
    let near_the_axis = (32.0 * T::U).sqrt();
    let soft = Cone::from_half_angles(T::of(inner), T::of(outer)).expect("in order");
    let hard = Cone::from_half_angle(T::of(outer)).expect("within π");
    for (cone, lit_to) in [(soft, inner), (hard, outer)] {
        let factor = cone.factor(b.axis, b.l);
        prop_assert!(
            off_axis > lit_to - near_the_axis || factor == T::ONE,
            "{factor:?}"
        );
        prop_assert!(
            off_axis < outer + near_the_axis || factor == T::ZERO,
            "{factor:?}"
        );
    }
    Ok(())
}

/// What a constructor refuses, a cast does not make: coefficients that all round to 0 would light
/// everything, a cone keeps its axis, and no range stays none.
pub fn a_cast_proves_again<T: Number>(b: &Beam<T>) -> Outcome {
    for [x, y, z] in [
        [0.0, 0.0, 1e-60],
        [0.0, 1e-60, 0.0],
        [1e-60, 0.0, 0.0],
        [1.0, 0.5, 1e300],
    ] {
        let falloff = Attenuation::new(x, y, z).expect("coefficients").cast(T::of);
        let [x, y, z] = falloff.coefficients();
        prop_assert!(Attenuation::new(x, y, z).is_some(), "{falloff:?}");
        prop_assert_eq!(falloff.range(), None);
        prop_assert_eq!(
            [falloff.limit(), falloff.clamped().limit()],
            [None, Some(T::ONE)]
        );
    }
    let ranged = Attenuation::NONE.within(4.0).expect("a range");
    let gltf = Attenuation::NONE.within_gltf(4.0).expect("a range");
    for (ranged, is_gltf) in [(ranged, false), (gltf, true)] {
        let ranged = ranged.clamped_to(2.0).expect("a limit").cast(T::of);
        prop_assert_eq!(
            (ranged.range(), ranged.limit()),
            (Some(T::of(4.0)), Some(T::of(2.0)))
        );
        prop_assert_eq!(ranged.is_gltf(), is_gltf);
    }
    for cosine in [1.0, 1.0 - 1e-9, -1.0, -1.0 + 1e-9] {
        let cone = Cone::from_cosine(cosine).expect("a cosine").cast(T::of);
        prop_assert_eq!(cone.factor(b.axis, -b.axis), T::ONE);
        prop_assert!(cone.factor(b.axis, b.axis) == T::ZERO || cosine < 0.0);
    }
    Ok(())
}
