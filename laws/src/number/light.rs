//! Attenuation, the cone, and the light that arrives.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use proptest::prelude::*;
use shading::{
    Attenuation, DirectionalLight, Light, PointLight, Rgb, SpotLight, Vec3, attenuation, term,
};

use super::Number;
use super::check::{by_spacing, check, near, same, same_or_near, to_f64, within};
use super::exact;
use super::generators::{
    Relation, adversarial, adversarial_color, adversarial_vector, coefficients, coefficients_of,
    cone, direction, exponent, light, light_color, pair, point, rounded, two_directions, unit,
};

/// (36) Attenuation does not rise with q, a, b or c: each operation of Horner's scheme is monotone.
fn attenuation_does_not_rise<T: Number>() {
    // −0 becomes 0: the reciprocal of −0 is −∞
    let number = || adversarial().prop_map(|x: T| x + T::ZERO);
    let inputs = (
        [number(), number(), number(), number()],
        number(),
        0..4_usize,
    );
    check(inputs, |(near, other, which)| {
        let mut far = near;
        far[which] = other;
        let (near, far) = if near[which] <= other {
            (near, far)
        } else {
            (far, near)
        };
        let at = |[a, b, c, q]: [T; 4]| attenuation(a, b, c, q);
        prop_assert!(at(near) >= at(far), "{:?} < {:?}", at(near), at(far));
        Ok(())
    });
}

/// (36) (1, 0, 0) gives exactly 1, and so does `Attenuation::NONE`.
fn constant_one_does_not_attenuate<T: Number>() {
    check(adversarial::<T>(), |q| {
        same([attenuation(T::ONE, T::ZERO, T::ZERO, q); 3], [T::ONE; 3])?;
        same([Attenuation::NONE.at(q); 3], [T::ONE; 3])
    });
}

/// (37) The attenuation is at most 1/a; clamped, it is the smaller of 1 and itself. With checked
/// coefficients it is always finite.
fn attenuation_is_bounded<T: Number>() {
    check(
        (coefficients::<T>(), adversarial::<T>(), adversarial::<T>()),
        |(checked, a, q)| {
            let a = a + T::ZERO; // −0 becomes 0
            prop_assert!(attenuation(a, T::ONE, T::ONE, q) <= T::ONE / a);
            let factor = checked.at(q);
            prop_assert!(factor <= T::MAX && factor >= T::ZERO);
            let smaller = if factor > T::ONE { T::ONE } else { factor };
            same([checked.clamped().at(q); 3], [smaller; 3])
        },
    );
}

/// (39) The factor of the cone is 0 or 1. It is 1 on the axis, even in the narrowest cone, and on
/// the edge; it is 0 just outside the edge.
fn cone_contains_its_axis_and_its_edge<T: Number>() {
    check((pair::<T>(), -1.0..=1.0_f64), |([axis, l], cosine)| {
        same([cone::<T>(cosine).factor(axis, -axis); 3], [T::ONE; 3])?;
        same([cone::<T>(1.0).factor(axis, -axis); 3], [T::ONE; 3])?;

        let edge = (-axis).dot(l).to_f64();
        prop_assume!(edge.abs() < 1.0 - 8.0 * T::U);
        same([cone::<T>(edge).factor(axis, l); 3], [T::ONE; 3])?;
        let narrower = cone::<T>(edge + 2.0 * T::U);
        same([narrower.factor(axis, l); 3], [T::ZERO; 3])?;
        within(narrower.cosine().to_f64() - edge, 4.0 * T::U)
    });
}

/// (39) A wider cone never darkens.
fn wider_cone_never_darkens<T: Number>() {
    check(
        (pair::<T>(), [-1.0..=1.0, -1.0..=1.0]),
        |([axis, l], [a, b])| {
            let (wide, narrow) = (cone::<T>(f64::min(a, b)), cone::<T>(f64::max(a, b)));
            let (wide, narrow) = (wide.factor(axis, l), narrow.factor(axis, l));
            prop_assert!(wide >= narrow);
            prop_assert!(
                [wide, narrow]
                    .into_iter()
                    .all(|f| f == T::ZERO || f == T::ONE)
            );
            Ok(())
        },
    );
}

/// (39) Turning L about the axis changes nothing, except next to the edge: each cosine is off by 2u
/// for its directions and by 2u for the dot product. In an evenly spaced type, these are √3u for each
/// direction and 1u; the cosine of the cone is off by 1u.
fn cone_is_round<T: Number>() {
    let azimuths = [0.0..TAU, 0.0..TAU];
    let inputs = (direction(), 0.0..3.0, azimuths, -1.0..=1.0_f64);
    check(inputs, |(axis, angle, azimuths, cosine)| {
        let next_to_the_edge = T::U * by_spacing::<T>(4.0, 5.5);
        prop_assume!((f64::cos(angle) - cosine).abs() > next_to_the_edge);
        let ls = azimuths.map(|azimuth| rounded::<T>(Relation::Angle(angle, azimuth).to(axis)));
        let [a, b] = ls.map(|l| cone::<T>(cosine).factor(-rounded(axis), l));
        same([a; 3], [b; 3])
    });
}

/// (40) An axis of twice the length is the same axis. In an evenly spaced type, each is off by 1.02u.
fn length_of_the_axis_does_not_matter<T: Number>() {
    check((point::<T>(), exponent::<T>(20, 14)), |(axis, k)| {
        let scaled = axis * T::of(f64::from(k).exp2());
        match (axis.unit(), scaled.unit()) {
            (Some(axis), Some(scaled)) => same_or_near(axis, scaled, 2.0 * 1.02),
            (axis, scaled) => {
                prop_assert!(axis.is_none() && scaled.is_none());
                Ok(())
            }
        }
    });
}

/// L = (P − p)/|P − p|, and the intensity is I/(a + bq + cq²) inside the cone. For the direction,
/// the difference is off by 1u, the length by 3u, and its reciprocal and the product by 1u each:
/// 6u. In the worst case the distance counts twice in the attenuation, which has six more
/// operations: 14u. Clamping to 1 does not increase any error.
///
/// In an evenly spaced type, the direction and the distance are right to half a step or little more.
fn lamp_follows_its_formula<T: Number>() {
    let inputs = (
        point::<T>(),
        point::<T>(),
        light_color::<T>(),
        ([0.0..2.0, 0.0..2.0, 0.0..2.0], any::<bool>()),
    );
    check(inputs, |(position, p, intensity, (abc, clamped))| {
        let [a, b, c] = abc.map(|k: f64| T::of(k).to_f64());
        let Some(unlimited) = coefficients_of(abc) else {
            return Ok(());
        };
        let (attenuation, limit) = if clamped {
            (unlimited.clamped(), 1.0)
        } else {
            (unlimited, f64::INFINITY)
        };
        let to_light = exact::subtract(to_f64(position), to_f64(p));
        let q = exact::length(to_light);
        prop_assume!(q > 0.0);
        let incident = PointLight {
            position,
            intensity,
            attenuation,
        }
        .at(p);
        let own_error = 6.0 * f64::U; // the error of the expected values
        for (l, expected) in to_f64(incident.l).into_iter().zip(to_light) {
            within(
                l - expected / q,
                T::U * by_spacing::<T>(6.0, 1.02) + own_error,
            )?;
        }
        let tolerance = by_spacing::<T>((4.0 * T::U + own_error) * q, 1.01 * T::U);
        within(incident.distance.to_f64() - q, tolerance)?;
        let factor = f64::min(1.0 / (a + b * q + c * q * q), limit);
        for (arriving, i) in to_f64(incident.intensity)
            .into_iter()
            .zip(to_f64(intensity))
        {
            let tolerance = by_spacing::<T>(
                (14.0 * T::U + 2.0 * own_error) * i * factor,
                attenuation_error::<T>(i, [a, b, c], q),
            );
            within(arriving - i * factor, tolerance)?;
        }
        Ok(())
    });
}

/// The error of I/(a + bq + cq²) in an evenly spaced type, infinite where the denominator may be 0. The
/// distance is off by 1.01u, each of the two products by 1u, and the quotient by 1.02u and u/2 of itself.
pub(super) fn attenuation_error<T: Number>(i: f64, [a, b, c]: [f64; 3], q: f64) -> f64 {
    let denominator = a + q * (b + c * q);
    let error = T::U * (1.01 * (b + 2.0 * c * q) + q + 1.0);
    if error < denominator {
        i * error / (denominator * (denominator - error)) + (1.02 + 0.5 * i / denominator) * T::U
    } else {
        f64::INFINITY
    }
}

/// For any place and any light, the direction has length 1, and the light is finite and not
/// negative.
fn lamp_is_finite_everywhere<T: Number>() {
    let inputs = (
        adversarial_vector::<T>(),
        adversarial_vector::<T>(),
        any::<bool>(),
    );
    let light = (
        adversarial_color::<T>(),
        coefficients::<T>(),
        unit::<T>(),
        -1.0..=1.0,
    );
    check(
        (inputs, light),
        |((position, p, touching), (intensity, attenuation, axis, cosine))| {
            let position = if touching { p } else { position };
            let point = PointLight {
                position,
                intensity,
                attenuation,
            };
            for incident in [
                point.at(p),
                SpotLight {
                    point,
                    axis,
                    cone: cone(cosine),
                }
                .at(p),
            ] {
                within(exact::square_excess(to_f64(incident.l)), 16.0 * T::U)?;
                for channel in to_f64(incident.intensity) {
                    prop_assert!(channel >= 0.0 && channel <= T::MAX.to_f64(), "{channel}");
                }
                if touching {
                    prop_assert!(incident.intensity == Rgb::BLACK);
                }
            }
            Ok(())
        },
    );
}

/// A spotlight is its point light inside the cone and dark outside, and a `Light` of any kind is
/// the light of that kind.
fn spot_is_a_point_light_or_dark<T: Number>() {
    check((light::<T, _>(point()), point()), |(light, p)| {
        let (expected, incident) = match light {
            Light::Directional(DirectionalLight { l, intensity }) => ((l, intensity), light.at(p)),
            Light::Point(point) => ((point.at(p).l, point.at(p).intensity), light.at(p)),
            Light::Spot(SpotLight { point, axis, cone }) => {
                let incident = point.at(p);
                let is_lit = cone.cosine() <= (-axis).dot(incident.l);
                let intensity = if is_lit {
                    incident.intensity
                } else {
                    Rgb::BLACK
                };
                ((incident.l, intensity), light.at(p))
            }
        };
        same(incident.l, expected.0)?;
        same(incident.intensity, expected.1)
    });
}

/// A distance: an ordinary one, or any that the type can hold.
fn distance<T: Number>() -> impl Strategy<Value = f64> {
    let octaves = 0.9 * T::MAX.to_f64().log2();
    prop_oneof![
        Just(1.0),
        0.01..100.0,
        (-octaves..octaves).prop_map(f64::exp2)
    ]
}

/// Leaving out what is not in front changes nothing: a light that is left out is behind the surface
/// or dark, and any other light keeps all its bits. On the horizon, rounding decides on which side
/// a light is, so many of the lights are there.
fn only_lights_that_add_nothing_are_left_out<T: Number>() {
    let grazing = (direction(), 0.0..TAU)
        .prop_map(|(n, azimuth)| [n, Relation::Angle(FRAC_PI_2, azimuth).to(n)]);
    let directions = prop_oneof![two_directions(), grazing];
    let p = prop_oneof![point::<T>(), Just(Vec3::ZERO)];
    let inputs = (directions, distance::<T>(), p, light::<T, _>(point()));
    check(inputs, |([n, l], q, p, light)| {
        let (n, position) = (rounded(n), p + *rounded::<T>(l) * T::of(q));
        let light = match light {
            Light::Directional(light) => Light::Directional(DirectionalLight {
                l: rounded(l),
                ..light
            }),
            Light::Point(light) => Light::Point(PointLight { position, ..light }),
            Light::Spot(light) => {
                let point = PointLight {
                    position,
                    ..light.point
                };
                Light::Spot(SpotLight { point, ..light })
            }
        };
        let all = light.at(p);
        if let Some(lit) = light.in_front(p, n) {
            same(lit.l, all.l)?;
            prop_assert_eq!(lit.distance, all.distance);
            same(lit.intensity, all.intensity)
        } else {
            let is_behind = term::lambert(n, all.l) == T::ZERO;
            prop_assert!(is_behind || all.intensity == Rgb::BLACK);
            Ok(())
        }
    });
}

/// A light is left out if it is behind the surface, or if the point is outside its cone. A lamp is
/// kept if its height is above −(|x| + |y| + |z|)/512 − 1/`EXTREME`, where the sum is √3q at most; the
/// height is off by 6u of q, and in an evenly spaced type by 6u more.
fn lights_behind_are_left_out<T: Number>() {
    let angle = FRAC_PI_2..PI;
    let inputs = (
        direction(),
        angle,
        0.0..TAU,
        0.01..100.0,
        light_color::<T>(),
    );
    check(inputs, |(n, angle, azimuth, q, intensity)| {
        let (l, n) = (
            rounded(Relation::Angle(angle, azimuth).to(n)),
            rounded::<T>(n),
        );
        let (p, attenuation) = (Vec3::ZERO, Attenuation::NONE);
        let lamp = |position| PointLight {
            position,
            intensity,
            attenuation,
        };
        let least = 1.0 / T::EXTREME.to_f64() + by_spacing::<T>(0.0, 6.0 * T::U);
        let kept: f64 = 3.0_f64.sqrt() / 512.0 + 6.0 * T::U + least / q;
        prop_assume!(angle.cos() < -kept);
        prop_assert!(lamp(*l * T::of(q)).in_front(p, n).is_none());
        let sun = DirectionalLight { l, intensity };
        prop_assert!(sun.in_front(p, n).is_none());
        let spot = |axis| SpotLight {
            point: lamp(*n * T::of(q)),
            axis,
            cone: cone(0.9),
        };
        prop_assert!(spot(-n).in_front(p, n).is_some());
        prop_assert!(spot(n).in_front(p, n).is_none());
        Ok(())
    });
}

/// At any distance, L points to the light, within 10u for the two unit vectors. Where the vector to
/// the light overflows, a quarter of it does not.
fn lamp_is_seen_where_it_is<T: Number>() {
    let any = adversarial_vector::<T>;
    check((any(), any()), |(position, p)| {
        let (intensity, attenuation) = (Rgb::WHITE, Attenuation::NONE);
        let incident = PointLight {
            position,
            intensity,
            attenuation,
        }
        .at(p);
        let quarter = T::of(0.25);
        let way = (position - p)
            .unit()
            .or((position * quarter - p * quarter).unit());
        if let Some(way) = way {
            near(incident.l, way, 10.0 * T::U)?;
            same(incident.intensity, Rgb::WHITE)?;
        } else {
            prop_assert!(position == p);
        }
        Ok(())
    });
}

/// A light with `f32` numbers is the same light in `f64`.
fn lights_keep_their_numbers_in_another_type<T: Number>() {
    check((light::<T, _>(point()), point()), |(light, p)| {
        let (wide, narrow) = (light.cast(T::to_f64).cast(T::of).at(p), light.at(p));
        same(wide.l, narrow.l)?;
        same(wide.intensity, narrow.intensity)
    });
}

properties! { light:
    attenuation_does_not_rise,
    constant_one_does_not_attenuate,
    attenuation_is_bounded,
    cone_contains_its_axis_and_its_edge,
    wider_cone_never_darkens,
    cone_is_round,
    length_of_the_axis_does_not_matter,
    lamp_follows_its_formula,
    lamp_is_finite_everywhere,
    spot_is_a_point_light_or_dark,
    only_lights_that_add_nothing_are_left_out,
    lights_behind_are_left_out,
    lamp_is_seen_where_it_is,
    lights_keep_their_numbers_in_another_type,
}
