//! Soft cones and attenuation with a range: where light ends.

use proptest::prelude::*;
use shading::{Light, PointLight, Ranged, Rgb, SoftCone, SpotLight, UnitVec3, shade, term};

use super::Number;
use super::check::{by_spacing, check, same, to_f64, within};
use super::exact;
use super::generators::{
    adversarial, adversarial_color, adversarial_vector, coefficients, cone, light_color, pair,
    point, triple, unit,
};

/// A soft cone from its cosines, as `cone` makes a hard one.
fn soft_cone<T: Number>(inner: f64, outer: f64) -> SoftCone<T> {
    SoftCone::of_cosines(T::of(inner), T::of(outer))
        .expect("the property expects cosines, and there is none")
}

/// Two cosines, the larger first; often equal.
fn cosines() -> impl Strategy<Value = [f64; 2]> {
    let cosine = || prop_oneof![4 => -1.0..=1.0, 1 => Just(1.0), 1 => Just(-1.0), 1 => Just(0.0)];
    let one = cosine().prop_map(|c: f64| [c, c]);
    prop_oneof![1 => one, 4 => [cosine(), cosine()].prop_map(|[a, b]: [f64; 2]| [a.max(b), a.min(b)])]
}

/// Soft cones with both kinds of edge: a square and a smoothstep.
fn both<T: Number>([inner, outer]: [f64; 2]) -> [SoftCone<T>; 2] {
    let squared = soft_cone(inner, outer);
    [squared, squared.smoothstep()]
}

/// (55) The factor is 1 inside the inner edge and on it, 0 on the outer edge and outside, and in
/// between it is between 0 and 1.
fn soft_cone_is_full_inside_and_dark_outside<T: Number>() {
    check((pair::<T>(), cosines()), |([axis, l], cosines)| {
        let cosine = (-axis).dot(l);
        for cone in both::<T>(cosines) {
            let [inner, outer] = cone.cosines();
            let factor = cone.factor(axis, l);
            prop_assert!(factor >= T::ZERO && factor <= T::ONE);
            if cosine >= inner {
                same([factor; 3], [T::ONE; 3])?;
            } else if cosine <= outer && outer > -T::ONE {
                same([factor; 3], [T::ZERO; 3])?;
            }
            same([cone.factor(axis, -axis); 3], [T::ONE; 3])?;
        }
        Ok(())
    });
}

/// (55) Toward the axis, the square does not fall. The smoothstep has three roundings of 1u, which
/// may hide a rise. In an evenly spaced type, the square is off by u, three times as much after the
/// product, and that by u: 8u for two smoothsteps.
fn soft_cone_does_not_fall_toward_the_axis<T: Number>() {
    check((triple::<T>(), cosines()), |([axis, a, b], cosines)| {
        let (near, far) = if (-axis).dot(a) >= (-axis).dot(b) {
            (a, b)
        } else {
            (b, a)
        };
        let [squared, smooth] =
            both::<T>(cosines).map(|cone| [near, far].map(|l| cone.factor(axis, l)));
        prop_assert!(squared[0] >= squared[1]);
        let [near, far] = smooth.map(T::to_f64);
        prop_assert!(near >= by_spacing::<T>(far * (1.0 - 6.0 * T::U), far - 8.0 * T::U));
        Ok(())
    });
}

/// (55) If both edges are the same, it is the hard cone.
fn soft_cone_with_one_edge_is_the_hard_cone<T: Number>() {
    check(
        (pair::<T>(), -1.0..=1.0_f64, any::<bool>()),
        |([axis, l], cosine, on_the_edge)| {
            let cosine = if on_the_edge {
                (-axis).dot(l).to_f64().clamp(-1.0, 1.0)
            } else {
                cosine
            };
            let hard = cone::<T>(cosine);
            for soft in both::<T>([cosine, cosine]).into_iter().chain([hard.into()]) {
                same([soft.factor(axis, l); 3], [hard.factor(axis, l); 3])?;
                same([soft.cosines()[0]; 3], [hard.cosine(); 3])?;
            }
            Ok(())
        },
    );
}

/// (55) Between the edges, the factor is t² or t²(3 − 2t) of the cosine. The cosine is off by 3u,
/// which counts more the narrower the edge is, and 3 times in the slope; there are eight more
/// roundings. In an evenly spaced type, the cosine is off by 1u and t by u more, which count twice at
/// most; the square adds up to 3u, and the last product 1u. A cone of half-angle π is stored 16u wider:
/// of that, up to 6t(1 − t)² ≤ 8/9, divided by the width, is left in the factor.
fn soft_cone_follows_its_formula<T: Number>() {
    check((pair::<T>(), cosines()), |([axis, l], cosines)| {
        let cones = both::<T>(cosines);
        let [inner, outer] = cones[0].cosines().map(T::to_f64);
        let width = inner - outer;
        prop_assume!(width > 1e-3);
        let cosine = -exact::dot(to_f64(axis), to_f64(l));
        let t = ((cosine - outer) / width).clamp(0.0, 1.0);
        let wider = if outer > -1.0 {
            0.0
        } else {
            128.0 / 9.0 / width
        };
        let k = wider + by_spacing::<T>(3.0 * (3.0 / width + 2.0) + 8.0, 2.0 / width + 6.0);
        let tolerance = k * (T::U + f64::EPSILON);
        within(cones[0].factor(axis, l).to_f64() - t * t, tolerance)?;
        within(
            cones[1].factor(axis, l).to_f64() - t * t * (3.0 - 2.0 * t),
            tolerance,
        )
    });
}

/// An attenuation with a range: an ordinary range, or any that the type can hold.
fn ranged<T: Number>() -> impl Strategy<Value = Ranged<T>> {
    let octaves = 0.9 * T::MAX.to_f64().log2();
    let range = prop_oneof![
        Just(1.0),
        0.1..10.0,
        (-octaves..octaves).prop_map(f64::exp2),
        Just(f64::INFINITY)
    ];
    (coefficients::<T>(), range, any::<bool>()).prop_map(|(attenuation, range, is_squared)| {
        let range = range.max(T::TINY.to_f64());
        let ranged = Ranged::of(attenuation, T::of(range))
            .expect("the property expects a number above 0, and there is none");
        if is_squared {
            ranged
        } else {
            ranged.unsquared()
        }
    })
}

/// (56) It is exactly 0 from r on, never above the attenuation without the range, and never rises
/// with q. glTF's window leaves no less than its square.
fn ranged_attenuation_ends_at_its_range<T: Number>() {
    let inputs = (
        ranged::<T>(),
        adversarial::<T>(),
        adversarial::<T>(),
        0.0..2.0,
    );
    check(inputs, |(ranged, p, q, share)| {
        let (r, free) = (ranged.range(), ranged.attenuation());
        // without an infinity, the largest number means no range
        let is_endless = T::EVENLY_SPACED && r == T::MAX;
        if !is_endless {
            same([ranged.at(r); 3], [T::ZERO; 3])?;
        }
        for q in [p, q, r * T::of(share)] {
            let factor = ranged.at(q);
            prop_assert!(factor >= T::ZERO && factor <= free.at(q));
            prop_assert!(factor <= ranged.unsquared().at(q));
            if q >= r && !is_endless {
                same([factor; 3], [T::ZERO; 3])?;
            }
            for other in [p, q, r * T::of(share)] {
                prop_assert!(q < other || ranged.at(q) <= ranged.at(other));
            }
        }
        Ok(())
    });
}

/// (56) It is the attenuation times (1 − (q/r)⁴)², or 0; for glTF, without the square. The quotient
/// is off by 1u and its fourth power by 7u, which the square counts twice; the attenuation is off by
/// 6u; there are three more roundings. Where numbers are tiny, the denominator is off by 2 of the
/// smallest, and the product by 2 more.
///
/// In an evenly spaced type, the window is off by 15u. The denominator of the attenuation is off by
/// (q + 1)u, and its reciprocal by 1u. An attenuation above 256 is not a scene's. In no type is one
/// compared that is above half of the largest number.
fn ranged_attenuation_follows_its_formula<T: Number>() {
    let inputs = (coefficients::<T>(), 0.1..10.0, 0.0..1.5);
    check(inputs, |(attenuation, range, share)| {
        let range = T::of(range);
        let ranged = attenuation.cast(T::to_f64).within(range.to_f64());
        let ranged = ranged
            .expect("the property expects a number above 0, and there is none")
            .cast(T::of);
        let q = range * T::of(share);
        let share = q.to_f64() / range.to_f64();
        let root = f64::max(0.0, 1.0 - share.powi(4));
        let free = attenuation.cast(T::to_f64).at(q.to_f64());
        let (most, tiny) = (T::MAX.to_f64(), T::TINY.to_f64());
        prop_assume!(free <= most / 2.0);
        prop_assume!(!T::EVENLY_SPACED || free <= 256.0 && free * most > 1.0);
        let denominator = (q.to_f64() + 1.0) * T::U * free;
        let reciprocal = free * denominator / (1.0 - denominator) + T::U;
        let tolerance = by_spacing::<T>(
            (24.0 * T::U + 3.0 * tiny * free) * free + 2.0 * tiny,
            15.0 * T::U * (free + reciprocal) + reciprocal + T::U,
        );
        within(ranged.at(q).to_f64() - free * root * root, tolerance)?;
        within(ranged.unsquared().at(q).to_f64() - free * root, tolerance)
    });
}

/// (56) An infinite range has no effect: the light has the bits of one without a range.
fn infinite_range_is_no_range<T: Number>() {
    let inputs = (
        coefficients::<T>(),
        light_color::<T>(),
        adversarial_vector::<T>(),
        adversarial_vector(),
    );
    check(inputs, |(attenuation, intensity, position, p)| {
        let ranged = attenuation
            .cast(T::to_f64)
            .within(f64::INFINITY)
            .expect("the property expects a number above 0, and there is none");
        let free = PointLight {
            position,
            intensity,
            attenuation,
        }
        .at(p);
        let ranged = PointLight {
            position,
            intensity,
            attenuation: ranged.cast(T::of),
        }
        .at(p);
        same(ranged.l, free.l)?;
        same(ranged.intensity, free.intensity)?;
        same([ranged.distance; 3], [free.distance; 3])
    });
}

/// A light with a soft edge and a range.
fn soft_light<T: Number>() -> impl Strategy<Value = Light<T, SoftCone<T>, Ranged<T>>> {
    let parts = (
        point(),
        adversarial_color(),
        ranged(),
        unit(),
        cosines(),
        any::<[bool; 2]>(),
    );
    parts.prop_map(
        |(position, intensity, attenuation, axis, cosines, [spot, smooth])| {
            let point = PointLight {
                position,
                intensity,
                attenuation,
            };
            if spot {
                let cone = both(cosines)[usize::from(smooth)];
                SpotLight { point, axis, cone }.into()
            } else {
                point.into()
            }
        },
    )
}

/// (13, 56) A light that `in_front` leaves out, because it is behind the surface, out of range, or
/// pointed elsewhere, adds nothing, and any other light is unchanged. The same holds for many
/// lights at once.
fn lights_out_of_range_are_left_out<T: Number>() {
    let inputs = (
        unit::<T>(),
        point::<T>(),
        proptest::collection::vec(soft_light::<T>(), 0..5),
    );
    check(inputs, |(n, p, lights)| {
        for light in &lights {
            let all = light.at(p);
            for channel in to_f64(all.intensity) {
                prop_assert!(channel >= 0.0 && channel <= T::MAX.to_f64());
            }
            match light.in_front(p, n) {
                Some(lit) => {
                    same(lit.l, all.l)?;
                    same(lit.intensity, all.intensity)?;
                }
                None => {
                    prop_assert!(term::lambert(n, all.l) == T::ZERO || all.intensity == Rgb::BLACK);
                }
            }
            let range = match light {
                Light::Point(point) | Light::Spot(SpotLight { point, .. }) => {
                    point.attenuation.range()
                }
                Light::Directional(_) => T::MAX,
            };
            // out of range by more than the rounding of a distance, or, in an evenly spaced type, by more
            // than 1/EXTREME and the rounding of the two squares
            let r = range.to_f64();
            let squares = r * r + 1.0 / T::EXTREME.to_f64() + 2.0 * T::U;
            let reach = by_spacing::<T>(
                r * (1.0 + 16.0 * T::U) + 1e-10,
                squares.sqrt() + 1.01 * T::U,
            );
            let is_far = all.distance.to_f64() > reach;
            prop_assert!(!is_far || light.in_front(p, n).is_none());
        }
        let sum = |lights: &mut dyn Iterator<Item = shading::IncidentLight<T>>| {
            let material = shading::Material {
                k_a: Rgb::WHITE,
                k_d: Rgb::WHITE,
                k_s: Rgb::WHITE,
                m: 3_u32,
            };
            shade::blinn_phong(n, UnitVec3::Z, &material, Rgb::BLACK, lights).total()
        };
        let all = sum(&mut lights.iter().map(|light| light.at(p)));
        same(
            sum(&mut lights.iter().filter_map(|light| light.in_front(p, n))),
            all,
        )
    });
}

properties! { edge:
    soft_cone_is_full_inside_and_dark_outside,
    soft_cone_does_not_fall_toward_the_axis,
    soft_cone_with_one_edge_is_the_hard_cone,
    soft_cone_follows_its_formula,
    ranged_attenuation_ends_at_its_range,
    ranged_attenuation_follows_its_formula,
    infinite_range_is_no_range,
    lights_out_of_range_are_left_out,
}
