//! (52) A number type agrees with rounded `f64`, and decides as [`Real`](shading::Real) promises.
//! (Another test checks that lanes agree with their scalar bit for bit.)

use proptest::prelude::*;
use shading::{IncidentLight, Material, UnitVec3, half_vector, reflection, term};

use super::Number;
use super::check::{by_spacing, check, near, same, to_f64, within};
use super::exact::square_excess;
use super::generators::{Scene, adversarial_signed, model, pair, scene};

fn wide<T: Number>(n: UnitVec3<T>) -> UnitVec3<f64> {
    n.cast(T::to_f64)
}

/// R is off by 7u, H by 3u, and a cosine by 2.5u: one of its products may be above ½, the sum of
/// two is below 1, and the sum of all three may reach it. In an evenly spaced type, R is off by 2u for N·L
/// and 1u in a component, and the others are rounded once.
fn directions_agree_with_double<T: Number>() {
    check(pair::<T>(), |[n, l]| {
        let [wide_n, wide_l] = [n, l].map(wide);
        let own = f64::U; // the f64 results are off by as many units of their own
        near(
            wide(reflection(n, l)),
            reflection(wide_n, wide_l),
            by_spacing::<T>(7.0, 3.01) * (T::U + own),
        )?;
        within(
            term::lambert(n, l).to_f64() - term::lambert(wide_n, wide_l),
            by_spacing::<T>(2.5, 1.001) * (T::U + own),
        )?;
        if let (Some(h), Some(wide_h)) = (half_vector(n, l), half_vector(wide_n, wide_l)) {
            // the sum itself is off by 1u for components up to 2
            let sum = 2.0 + square_excess(to_f64(*wide_n + *wide_l)) - 1.0;
            near(
                wide(h),
                wide_h,
                by_spacing::<T>(3.0 + 2.0 / sum.max(0.0).sqrt(), 1.02) * (T::U + own),
            )?;
        }
        Ok(())
    });
}

/// The sum over lights. A cosine is off by 2u; its product with I, the n − 1 additions, and the
/// product with k add n + 1. In a highlight, the cosine is off by 11u, which counts m times.
///
/// In an evenly spaced type, each cosine is rounded once, except that N·H has few digits where L + V is
/// short; the products with I and k add n + 1 of any brightness.
fn shading_agrees_with_double<T: Number>() {
    check((model(), scene::<T>()), |(model, mut scene)| {
        let m = scene.material.m;
        // below m = 1 the power is steep at 0, and a type with integer powers has another m
        prop_assume!(m.m >= 1.0 && m.m.fract() == 0.0);
        // the light jumps at the horizon
        scene
            .lights
            .retain(|light| scene.n.dot(light.l).to_f64().abs() > 4.0 * T::U);
        let is_long = |sum| !T::EVENLY_SPACED || square_excess(to_f64(sum)) > -0.99;
        scene.lights.retain(|light| is_long(*light.l + *scene.v));
        let (narrow, double) = (scene.shade(model), widened(&scene).shade(model));
        let lights = scene.lights.iter().map(|light| light.intensity);
        let lights: shading::Rgb<T> = lights.sum();
        let brightest = to_f64(lights).into_iter().fold(0.0, f64::max);
        let unit = (T::U + f64::U) * brightest;
        let n = scene.lights.len() as f64;
        let products = by_spacing::<T>(0.0, n + 1.0) * (T::U + f64::U);
        near(
            narrow.ambient.map(T::to_f64),
            double.ambient,
            T::U * by_spacing::<T>(8.0, 1.001),
        )?;
        near(
            narrow.diffuse.map(T::to_f64),
            double.diffuse,
            by_spacing::<T>(n + 3.0, 1.0) * unit + products,
        )?;
        let k = by_spacing::<T>(n + 1.0 + 11.0 * m.m, 2.0 * m.m) + m.error::<T>();
        near(
            narrow.specular.map(T::to_f64),
            double.specular,
            k * unit + products,
        )
    });
}

/// Every decision, also between equal numbers and for NaN.
fn decisions_are_as_promised<T: Number>() {
    let numbers = (
        adversarial_signed::<T>(),
        adversarial_signed(),
        any::<bool>(),
    );
    check(numbers, |(x, other, equal)| {
        let y = if equal { x } else { other };
        let (then, otherwise) = (T::ONE, T::of(2.0));
        let pick = |condition| if condition { then } else { otherwise };
        let value = |x: T, expected: T| same([x; 3], [expected; 3]);

        value(x.if_positive(then, otherwise), pick(x > T::ZERO))?;
        value(x.if_above(y, then, otherwise), pick(x > y))?;
        prop_assert_eq!(x.any_positive(), x > T::ZERO);
        prop_assert!(x.abs() >= T::ZERO && (x.abs() == x || x.abs() == -x));
        value(x.at_least(y), if x > y { x } else { y })?;
        value(x.at_most(y), if x > y { y } else { x })?;
        value(x.at_least(T::ZERO), if x > T::ZERO { x } else { T::ZERO })?;

        let (low, high) = if x.abs() < y.abs() { (x, y) } else { (y, x) };
        let (low, high) = (low.abs(), high.abs());
        if low < T::ONE && T::ONE < high {
            prop_assert!(!T::ONE.any_outside(low, high));
        }
        if T::ONE < low || T::ONE > high {
            prop_assert!(T::ONE.any_outside(low, high));
        }

        let nan = T::of(f64::NAN);
        // a type need not have NaN
        if nan.partial_cmp(&nan).is_none() {
            value(nan.if_positive(then, otherwise), otherwise)?;
            value(nan.if_above(y, then, otherwise), otherwise)?;
            value(nan.at_least(y), y)?;
            prop_assert!(!nan.any_positive() && nan.any_outside(low, high));
        }
        Ok(())
    });
}

fn widened<T: Number>(scene: &Scene<T>) -> Scene<f64> {
    let lights = scene.lights.iter();
    let lights = lights.map(|light| IncidentLight {
        l: wide(light.l),
        intensity: light.intensity.map(T::to_f64),
        distance: light.distance.to_f64(),
    });
    Scene {
        n: wide(scene.n),
        v: wide(scene.v),
        material: Material {
            ..scene.material.cast(T::to_f64)
        },
        i_a: scene.i_a.map(T::to_f64),
        lights: lights.collect(),
    }
}

properties! { width:
    directions_agree_with_double,
    shading_agrees_with_double,
    decisions_are_as_promised,
}
