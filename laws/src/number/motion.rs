//! What happens when everything is turned, moved, or scaled.

use std::f64::consts::{FRAC_PI_2, TAU};

use proptest::prelude::*;
use shading::{
    Attenuation, DirectionalLight, IncidentLight, Light, PointLight, Rgb, SpotLight, UnitVec3,
    Vec3, term,
};

use super::Number;
use super::check::{
    at_least, by_spacing, check, is_short_of_range, near, nearly, same, same_or_near, to_f64,
    within,
};
use super::exact;
use super::generators::{
    Relation, coefficients_of, direction, dyadic_point, exponent, light, light_color, model, point,
    rounded, scene, unit,
};
use super::light::attenuation_error;

/// (14) Tilting L toward N never lowers the diffuse term. The two dot products are off by 2u each:
/// three products and two partial sums, none above 1. So pairs closer than 4u are left out. A dot
/// product that is rounded once, as in an evenly spaced type, never falls.
fn tilting_the_light_toward_the_normal_brightens<T: Number>() {
    let angles = [0.0..=FRAC_PI_2, 0.0..=FRAC_PI_2];
    check((direction(), 0.0..TAU, angles), |(n, azimuth, angles)| {
        let [a, b] = angles.map(|angle| rounded::<T>(Relation::Angle(angle, azimuth).to(n)));
        let n = rounded::<T>(n);
        let apart = exact::dot_difference([to_f64(n), to_f64(a)], [to_f64(n), to_f64(b)]);
        prop_assume!(apart.abs() >= T::U * by_spacing::<T>(4.0, 0.0));
        let (brighter, darker) = if apart > 0.0 { (a, b) } else { (b, a) };
        prop_assert!(term::lambert(n, brighter) >= term::lambert(n, darker));
        Ok(())
    });
}

/// (15) Turning everything together changes a cosine by at most 20u, and a highlight by m times as
/// much. Each turned direction is rounded again, by u; N·L moves by 2u and is computed to 2u,
/// twice: 8u. N·H and R·V have three to five such steps. H is ill-conditioned where L + V is short.
///
/// In an evenly spaced type, each direction turns by √3u: N·L moves by 2√3u and is computed to 1u,
/// twice: 6u. H moves by 11u where |L + V| is above ⅓, and is computed to √3u; R moves by 9u, and is
/// computed to 4u. With N or V, and with the dot product, both cosines differ by 20u at most. The
/// products of n lights and k add u each, on either side.
fn rotation_changes_nothing<T: Number>() {
    check(
        (model(), scene::<T>(), direction(), 0.0..TAU),
        |(model, scene, axis, angle)| {
            let m = scene.material.m.m;
            // the light jumps at the horizon, and for m < 1 the power is steep at a cosine of 0
            prop_assume!(m >= 1.0);
            let is_clear = |light: &IncidentLight<T>| {
                scene.n.dot(light.l).to_f64().abs() > 20.0 * T::U
                    && exact::square_excess(to_f64(*light.l + *scene.v)) > -0.9
            };
            let mut scene = scene.clone();
            scene.lights.retain(is_clear);

            let turned = scene.map_directions(|d| turn(d, axis, angle)).shade(model);
            let shaded = scene.shade(model);
            let lights = scene
                .lights
                .iter()
                .map(|light| light.intensity)
                .sum::<Rgb<T>>();
            let brightest = to_f64(lights).into_iter().fold(0.0, f64::max);
            same(turned.ambient, shaded.ambient)?;
            let products = by_spacing::<T>(0.0, 2.0 * (scene.lights.len() as f64 + 1.0)) * T::U;
            let k = by_spacing::<T>(20.0, 6.0);
            near(
                turned.diffuse,
                shaded.diffuse,
                k * T::U * brightest + products,
            )?;
            let k = 20.0 * m + 2.0 * scene.material.m.error::<T>() + by_spacing::<T>(20.0, 0.0);
            near(
                turned.specular,
                shaded.specular,
                k * T::U * brightest + products,
            )
        },
    );
}

/// (15) Turning everything by 180° about an axis only changes the signs of two coordinates, which
/// is exact.
fn half_a_turn_changes_nothing<T: Number>() {
    check((model(), scene::<T>(), 0..3), |(model, scene, axis)| {
        let turn = |d: UnitVec3<T>| {
            UnitVec3::assume_unit(match axis {
                0 => Vec3::new(d.x, -d.y, -d.z),
                1 => Vec3::new(-d.x, d.y, -d.z),
                _ => Vec3::new(-d.x, -d.y, d.z),
            })
        };
        let (turned, shaded) = (scene.map_directions(turn).shade(model), scene.shade(model));
        same(turned.diffuse, shaded.diffuse)?;
        same(turned.specular, shaded.specular)
    });
}

/// (16) Moving light and surface together on a dyadic grid changes nothing.
fn translation_on_a_grid_is_exact<T: Number>() {
    let inputs = (
        light::<T, _>(dyadic_point()),
        dyadic_point(),
        dyadic_point(),
    );
    check(inputs, |(light, p, offset)| {
        let moved = map_position(light, |position| position + offset).at(p + offset);
        let incident = light.at(p);
        same(moved.l, incident.l)?;
        same(moved.intensity, incident.intensity)
    });
}

/// (16) Off the grid, the direction changes by the rounding of the moved points, √3·u of the
/// largest coordinate each, divided by the distance, and by 4u for each of the two directions. An evenly
/// spaced type has no such rounding, and nothing changes.
fn translation_changes_little<T: Number>() {
    let inputs = (point::<T>(), point::<T>(), point::<T>(), 1.0..100.0);
    check(inputs, |(position, p, offset, size)| {
        let lamp = |position| PointLight {
            position,
            intensity: Rgb::WHITE,
            attenuation: Attenuation::NONE,
        };
        let offset = offset * T::of(size);
        let q = exact::length(to_f64(position - p));
        prop_assume!(q > 0.01);
        let (moved, incident) = (lamp(position + offset).at(p + offset), lamp(position).at(p));
        let rounding = 2.0 * 3_f64.sqrt() * T::U * (1.0 + size);
        let tolerance = by_spacing::<T>(rounding / q + 8.0 * T::U, 0.0);
        near(moved.l, incident.l, tolerance)
    });
}

/// (17) The unit of length does not matter: a scene 2^k times as large, with b/2^k and c/4^k, looks
/// the same. In an evenly spaced type, where b and c are multiples of 2⁻⁸ and k is from 0 to 4, so that
/// the scaled ones are exact, the light has the error of either attenuation, and L of either direction.
fn scaling_the_scene_by_a_power_of_two_is_exact<T: Number>() {
    let coefficients = [0.01..2.0, 0.0..2.0, 0.0..2.0];
    let inputs = (
        point::<T>(),
        point::<T>(),
        light_color(),
        coefficients,
        exponent::<T>(10, 4),
    );
    check(inputs, |(position, p, intensity, abc, k)| {
        let coarse = |x: f64| by_spacing::<T>(x, (x * 256.0).ceil() / 256.0);
        let [a, b, c] = abc.map(coarse);
        let scaled = |k: i32| {
            let s = f64::from(k).exp2();
            let attenuation = coefficients_of([a, b / s, c / (s * s)])
                .expect("the property expects that a is not 0");
            PointLight {
                position: position * T::of(s),
                intensity,
                attenuation,
            }
            .at(p * T::of(s))
        };
        same_or_near(scaled(k).l, scaled(0).l, 2.0 * 1.02)?;
        if !T::EVENLY_SPACED {
            let [large, small] = [scaled(k), scaled(0)].map(|light| light.intensity);
            return if is_short_of_range::<T>() {
                nearly(large, small, 40.0)
            } else {
                same(large, small)
            };
        }
        let q = exact::length(exact::subtract(to_f64(position), to_f64(p)));
        let error = |i: f64, k: i32| {
            let s = f64::from(k).exp2();
            attenuation_error::<T>(i, [a, b / s, c / (s * s)], q * s)
        };
        let [large, small] = [scaled(k), scaled(0)].map(|light| to_f64(light.intensity));
        for (i, (large, small)) in to_f64(intensity)
            .into_iter()
            .zip(large.into_iter().zip(small))
        {
            within(large - small, error(i, k) + error(i, 0))?;
        }
        Ok(())
    });
}

/// (18) A lamp at a large distance D without attenuation is a sun: within a unit of length, its
/// direction changes by at most 1/D, and by 6u in addition: 2u for its position, and 4u for the
/// direction.
fn distant_lamp_is_a_sun<T: Number>() {
    let exponents = 0.0..by_spacing::<T>(40.0, 12.0).min(T::MAX.to_f64().log2() - 2.5);
    let inputs = (unit::<T>(), point::<T>(), light_color::<T>(), exponents);
    check(inputs, |(l, p, intensity, exponent)| {
        let p = p * T::of(0.5); // within the unit ball
        let distance = f64::exp2(exponent + 2.0);
        let position = *l * T::of(distance);
        let lamp = PointLight {
            position,
            intensity,
            attenuation: Attenuation::NONE,
        }
        .at(p);
        let sun = DirectionalLight { l, intensity }.at(p);
        same(lamp.intensity, sun.intensity)?;
        let angle = exact::length(exact::cross(to_f64(lamp.l), to_f64(sun.l)));
        at_least(1.0 / distance, angle, 6.0 * T::U)
    });
}

/// A direction turned about an axis (Rodrigues' formula) and rounded.
fn turn<T: Number>(d: UnitVec3<T>, axis: [f64; 3], angle: f64) -> UnitVec3<T> {
    let d = to_f64(d);
    let (sin, cos) = angle.sin_cos();
    let aside = exact::cross(axis, d);
    let along = exact::dot(axis, d) * (1.0 - cos);
    rounded([0, 1, 2].map(|i| d[i] * cos + aside[i] * sin + axis[i] * along))
}

fn map_position<T: Number>(light: Light<T>, f: impl Fn(Vec3<T>) -> Vec3<T>) -> Light<T> {
    let moved = |point: PointLight<T>| PointLight {
        position: f(point.position),
        ..point
    };
    match light {
        Light::Directional(_) => light,
        Light::Point(point) => Light::Point(moved(point)),
        Light::Spot(spot) => Light::Spot(SpotLight {
            point: moved(spot.point),
            ..spot
        }),
    }
}

properties! { motion:
    tilting_the_light_toward_the_normal_brightens,
    rotation_changes_nothing,
    half_a_turn_changes_nothing,
    translation_on_a_grid_is_exact,
    translation_changes_little,
    scaling_the_scene_by_a_power_of_two_is_exact,
    distant_lamp_is_a_sun,
}
