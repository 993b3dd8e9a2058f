//! The sum over lights.

use proptest::prelude::*;
use proptest::sample::Index;
use shading::{IncidentLight, Material, Rgb, Shaded, term};

use super::Number;
use super::check::{
    at_least, by_spacing, check, is_short_of_range, nearly, same, same_or_near, to_f64,
};
use super::generators::{
    MODELS, Model, Scene, adversarial_scene, exponent, light_color, model, pair, reflectance,
    scene, unit,
};

/// (1) No light is negative.
fn no_light_is_negative<T: Number>() {
    check((model(), adversarial_scene::<T>()), |(model, scene)| {
        let shaded = scene.shade(model);
        for part in [
            shaded.ambient,
            shaded.diffuse,
            shaded.specular,
            shaded.total(),
        ] {
            let [r, g, b] = part.into();
            prop_assert!(r >= T::ZERO && g >= T::ZERO && b >= T::ZERO, "{part:?}");
        }
        Ok(())
    });
}

/// (3) The light of several lamps is the sum of the light of each:
///
/// ```text
/// shade(A ∪ B) − ambient = (shade(A) − ambient) + (shade(B) − ambient)
/// ```
///
/// within (n + 2)u of the sum, for n lights. A comes first on both sides, with the same roundings.
/// After that, the left side has |B| additions and the product with k; the right side has |B| − 1
/// additions, the product, and the addition of the two: 2|B| + 2 roundings, and B is the shorter
/// half. In an evenly spaced type, sums are exact, and only the three products with k round.
fn light_is_additive<T: Number>() {
    check(
        (model(), scene::<T>(), any::<Index>()),
        |(model, scene, length_of_b)| {
            let n = scene.lights.len();
            let (a, b) = scene.lights.split_at(n - length_of_b.index(n / 2 + 1));

            let (both, a, b) = (
                scene.shade(model),
                scene.lit_by(model, a),
                scene.lit_by(model, b),
            );

            same(both.ambient, a.ambient)?;
            let k = by_spacing::<T>(n as f64 + 2.0, 3.0);
            nearly(both.diffuse, a.diffuse + b.diffuse, k)?;
            nearly(both.specular, a.specular + b.specular, k)
        },
    );
}

/// (2) There is no NaN, and no infinity unless the result overflows by the bound of (10). Without an
/// infinity, an evenly spaced type is not at its largest number either.
fn nothing_is_nan_or_overflows_early<T: Number>() {
    check((model(), adversarial_scene::<T>()), |(model, scene)| {
        let total = to_f64(scene.shade(model).total());
        // each factor times 2⁻⁵⁰⁰, so that f64 does not overflow where T does
        let tame = |rgb: Rgb<T>| to_f64(rgb).map(|c| c * 2_f64.powi(-500));
        let [k_a, k_d, k_s] =
            [scene.material.k_a, scene.material.k_d, scene.material.k_s].map(tame);
        for i in 0..3 {
            let lights: f64 = scene
                .lights
                .iter()
                .map(|light| tame(light.intensity)[i])
                .sum();
            let bound = k_a[i] * tame(scene.i_a)[i] + lights * (k_d[i] + k_s[i]);
            let largest = T::MAX.to_f64() * 2_f64.powi(-1000) * (1.0 - 20.0 * T::U);
            prop_assert!(!total[i].is_nan());
            if bound <= largest {
                let is_below_the_end = !T::EVENLY_SPACED || total[i] < T::MAX.to_f64();
                prop_assert!(total[i].is_finite() && is_below_the_end);
            }
        }
        Ok(())
    });
}

/// (4) The order of the lights does not matter, within 2nu of the sum: n − 1 additions and the
/// product with k, twice. The result is not exact, since floating-point addition is not
/// associative. In an evenly spaced type, it is exact.
fn order_of_lights_does_not_matter<T: Number>() {
    let shuffled = scene::<T>().prop_flat_map(|scene| {
        let lights = Just(scene.lights.clone()).prop_shuffle();
        (Just(scene), lights)
    });
    check((model(), shuffled), |(model, (scene, lights))| {
        let (a, b) = (scene.shade(model), scene.lit_by(model, &lights));
        let k = by_spacing::<T>(2.0 * lights.len() as f64, 0.0);
        same(a.ambient, b.ambient)?;
        nearly(a.diffuse, b.diffuse, k)?;
        nearly(a.specular, b.specular, k)
    });
}

/// (5) A black light changes nothing.
fn black_light_changes_nothing<T: Number>() {
    let inputs = (model(), scene::<T>(), unit(), any::<Index>());
    check(inputs, |(model, scene, l, place)| {
        let mut lights = scene.lights.clone();
        let black = IncidentLight {
            l,
            intensity: Rgb::BLACK,
            distance: T::MAX,
        };
        lights.insert(place.index(lights.len() + 1), black);
        identical(scene.shade(model), scene.lit_by(model, &lights))
    });
}

/// The error that a factor s makes in an evenly spaced type: u for each scaled light, u for each product
/// with it, s times u for each product of the light that is scaled afterward, and u for that scaling.
/// There are n + 1 products, one of which is with k or `k_a`.
fn scaling_error<T: Number>(scene: &Scene<T>, s: f64) -> f64 {
    (scene.lights.len() as f64 + 1.0) * (2.0 + s) + 1.0
}

/// (6) Twice the light gives twice the result, exactly for powers of two.
fn scaling_light_by_a_power_of_two_is_exact<T: Number>() {
    let inputs = (model(), scene::<T>(), exponent::<T>(8, 8));
    check(inputs, |(model, scene, k)| {
        prop_assume!(is_far_from_underflow(&scene, model));
        let s = T::of(f64::from(k).exp2());
        let same = |a, b| same_or_near(a, b, scaling_error(&scene, s.to_f64()));
        let scaled = scene.map_intensities(|i| i * s).shade(model);
        let shaded = scene.shade(model);
        same(scaled.ambient, shaded.ambient * s)?;
        same(scaled.diffuse, shaded.diffuse * s)?;
        same(scaled.specular, shaded.specular * s)?;
        // if the ambient light is not scaled, the result is affine: the ambient part stays
        let lights = scene.map_intensities(|i| i * s).lights;
        let affine = scene.lit_by(model, &lights);
        same(affine.ambient, shaded.ambient)?;
        same(affine.diffuse, shaded.diffuse * s)?;
        same(affine.specular, shaded.specular * s)
    });
}

/// (6) For any s, within (2n + 4)u. Either side has n − 1 additions, and the products with the
/// factor, with k, and with s.
fn scaling_light_scales_the_result<T: Number>() {
    let factors = if T::EVENLY_SPACED || !is_short_of_range::<T>() {
        0.01..f64::min(T::MAX.to_f64() / 80.0, 100.0) // up to nine lights of 4
    } else {
        0.5..2.0
    };
    check((model(), scene::<T>(), factors), |(model, scene, s)| {
        prop_assume!(is_far_from_underflow(&scene, model));
        let n = scene.lights.len() as f64;
        let error = scaling_error(&scene, s);
        let (s, k) = (T::of(s), by_spacing::<T>(2.0 * n + 4.0, error));
        let scaled = scene.map_intensities(|i| i * s).shade(model);
        let shaded = scene.shade(model);
        nearly(
            scaled.ambient,
            shaded.ambient * s,
            by_spacing::<T>(4.0, error),
        )?;
        nearly(scaled.diffuse, shaded.diffuse * s, k)?;
        nearly(scaled.specular, shaded.specular * s, k)
    });
}

/// (7) The result is linear in each of `k_a`, `k_d`, and `k_s`, and each has its own part. The
/// tolerance is 4u: a sum and a product on the left, and two products and a sum in a row on the
/// right. In an evenly spaced type, only the three products round.
fn linear_in_each_reflectance<T: Number>() {
    let inputs = (model(), scene::<T>(), reflectance(), 0..3_usize);
    check(inputs, |(model, scene, more, which)| {
        let with = |k: Rgb<T>| {
            let mut scene = scene.clone();
            *reflectance_of(&mut scene, which) = k;
            scene.shade(model)
        };
        let k = *reflectance_of(&mut scene.clone(), which);
        let (sum, a, b) = (with(k + more), with(k), with(more));
        let [sum, a, b] =
            [sum, a, b].map(|shaded| [shaded.ambient, shaded.diffuse, shaded.specular]);
        for part in 0..3 {
            if part == which {
                nearly(sum[part], a[part] + b[part], by_spacing::<T>(4.0, 3.0))?;
            } else {
                same(sum[part], a[part])?;
            }
        }
        Ok(())
    });
}

/// (8) Channels are independent: permuting them permutes those of the result.
fn permuting_channels_permutes_the_result<T: Number>() {
    let turn = |rgb: Rgb<T>| Rgb::new(rgb.g, rgb.b, rgb.r);
    check((model(), scene::<T>()), |(model, scene)| {
        let mut turned = scene.map_intensities(turn);
        for which in 0..3 {
            let k = reflectance_of(&mut turned, which);
            *k = turn(*k);
        }
        let (turned, shaded) = (turned.shade(model), scene.shade(model));
        same(turned.ambient, turn(shaded.ambient))?;
        same(turned.diffuse, turn(shaded.diffuse))?;
        same(turned.specular, turn(shaded.specular))
    });
}

/// (8) Changing red leaves green and blue unchanged.
fn red_does_not_bleed<T: Number>() {
    let inputs = (
        model(),
        scene::<T>(),
        reflectance::<T>(),
        light_color::<T>(),
    );
    check(inputs, |(model, scene, k, i)| {
        let mut redder = scene.map_intensities(|old| Rgb { r: i.r, ..old });
        for which in 0..3 {
            reflectance_of(&mut redder, which).r = k.r;
        }
        let black_red = |rgb: Rgb<T>| Rgb { r: T::ZERO, ..rgb };
        let (redder, shaded) = (redder.shade(model), scene.shade(model));
        same(black_red(redder.ambient), black_red(shaded.ambient))?;
        same(black_red(redder.diffuse), black_red(shaded.diffuse))?;
        same(black_red(redder.specular), black_red(shaded.specular))
    });
}

/// (9) Without lights, the result is `k_a I_a`.
fn no_lights_give_the_ambient_light<T: Number>() {
    check((model(), scene::<T>()), |(model, scene)| {
        let (k_a, i_a) = (scene.material.k_a, scene.i_a);
        let ambient = Rgb::new(k_a.r * i_a.r, k_a.g * i_a.g, k_a.b * i_a.b);
        same(scene.lit_by(model, &[]).total(), ambient)
    });
}

/// (10) No more light leaves than a mirror and a white wall would send: `k_a I_a + Σ I (k_d +
/// k_s)`, within (n + 8)u. The cosine of two rounded unit vectors exceeds 1 by 2u, and its three
/// products and two additions add 2u. After that come the product with I, n − 1 additions, the
/// product with k, and two additions in the total. Each of the 2n + 3 products may be off by half of
/// the smallest number.
///
/// In an evenly spaced type, the directions are longer by √3u each, and N·L is off by 1u; then come the
/// products with I, diffuse and specular, and three with k.
fn no_more_light_than_falls_on_the_surface<T: Number>() {
    check((model(), scene::<T>()), |(model, scene)| {
        let total = to_f64(scene.shade(model).total());
        let [k_a, k_d, k_s] =
            [scene.material.k_a, scene.material.k_d, scene.material.k_s].map(to_f64);
        let n = scene.lights.len() as f64;
        for i in 0..3 {
            let lights: f64 = scene
                .lights
                .iter()
                .map(|light| to_f64(light.intensity)[i])
                .sum();
            let bound = k_a[i] * to_f64(scene.i_a)[i] + lights * (k_d[i] + k_s[i]);
            let slack = by_spacing::<T>(
                (n + 8.0) * T::U * bound + (n + 1.5) * T::TINY.to_f64(),
                (4.5 * lights * k_d[i] + n * (k_d[i] + k_s[i]) + 3.0) * T::U,
            );
            at_least(bound, total[i], slack)?;
        }
        Ok(())
    });
}

/// (11) Diffuse light depends neither on where the eye is nor on the model; without `k_s`, nothing
/// does.
fn diffuse_light_does_not_depend_on_the_eye<T: Number>() {
    check((model(), scene::<T>(), unit()), |(model, scene, v)| {
        let moved = Scene { v, ..scene.clone() };
        let diffuse = scene.shade(Model::Lambert).diffuse;
        for model in MODELS {
            same(moved.shade(model).diffuse, diffuse)?;
        }
        let [mut matte, mut matte_moved] = [scene, moved];
        for scene in [&mut matte, &mut matte_moved] {
            scene.material.k_s = Rgb::BLACK;
        }
        same(matte.shade(model).total(), matte_moved.shade(model).total())
    });
}

/// (12) Reversing both N and L changes nothing.
fn lambert_of_both_reversed_is_the_same<T: Number>() {
    check(pair::<T>(), |[n, l]| {
        same([term::lambert(-n, -l); 3], [term::lambert(n, l); 3])
    });
}

/// (13) A light on or below the horizon adds nothing, not even a highlight.
fn light_from_behind_adds_nothing<T: Number>() {
    check((model(), scene::<T>()), |(model, mut scene)| {
        scene.lights.retain(|light| scene.n.dot(light.l) <= T::ZERO);
        identical(scene.shade(model), scene.lit_by(model, &[]))
    });
}

fn identical<T: Number>(a: Shaded<T>, b: Shaded<T>) -> Result<(), TestCaseError> {
    same(a.ambient, b.ambient)?;
    same(a.diffuse, b.diffuse)?;
    same(a.specular, b.specular)
}

fn reflectance_of<T: Number>(scene: &mut Scene<T>, which: usize) -> &mut Rgb<T> {
    let Material { k_a, k_d, k_s, .. } = &mut scene.material;
    [k_a, k_d, k_s]
        .into_iter()
        .nth(which)
        .expect("the property expects one of three, and there is none")
}

/// Whether no highlight is so faint that its products with I and k lose bits. A highlight that has
/// vanished is exactly 0, and stays 0. In an evenly spaced type, every number loses bits alike.
fn is_far_from_underflow<T: Number>(scene: &Scene<T>, model: Model) -> bool {
    let faint = by_spacing::<T>((T::TINY.to_f64() / T::U).sqrt(), 0.0);
    let mut white = scene.map_intensities(|_| Rgb::WHITE);
    white.material.k_s = Rgb::WHITE;
    white.lights.iter().all(|&light| {
        let factor = white.lit_by(model, &[light]).specular.r.to_f64();
        factor == 0.0 || factor > faint
    })
}

properties! { shade:
    no_light_is_negative,
    light_is_additive,
    nothing_is_nan_or_overflows_early,
    order_of_lights_does_not_matter,
    black_light_changes_nothing,
    scaling_light_by_a_power_of_two_is_exact,
    scaling_light_scales_the_result,
    linear_in_each_reflectance,
    permuting_channels_permutes_the_result,
    red_does_not_bleed,
    no_lights_give_the_ambient_light,
    no_more_light_than_falls_on_the_surface,
    diffuse_light_does_not_depend_on_the_eye,
    lambert_of_both_reversed_is_the_same,
    light_from_behind_adds_nothing,
}
