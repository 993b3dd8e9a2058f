//! What light does in a sum, and what arrives of it.

use proptest::prelude::*;
use shading::{
    Attenuation, DirectionalLight, IncidentLight, Light, Material, PointLight, Real, Rgb, Shaded,
    UnitVec3, Vec3, attenuation, shade, term,
};

use crate::book::{self, Model};
use crate::given::{Directions, Scene, Triangle};
use crate::tracked::{prop_assert_book, prop_assert_near};
use crate::{Number, Outcome, half_a_turn, has_digits, least_normal, quarter_turn};

fn parts<T: Real>(sum: Shaded<T>) -> [Rgb<T>; 3] {
    [sum.ambient, sum.diffuse, sum.specular]
}

fn channels<T: Real>(sum: Shaded<T>) -> [T; 9] {
    let [a, d, s] = parts(sum);
    [a.r, a.g, a.b, d.r, d.g, d.b, s.r, s.g, s.b]
}

fn adds_nothing<T: Number>(sum: Shaded<T>) -> bool {
    sum.diffuse == Rgb::BLACK && sum.specular == Rgb::BLACK
}

fn in_f64<T: Number>(rgb: Rgb<T>) -> [f64; 3] {
    [rgb.r, rgb.g, rgb.b].map(T::exact)
}

/// The error of a few roundings of a number of this size.
fn roundings<T: Number>(count: f64, size: f64) -> f64 {
    count * (T::U * size.abs() + T::STEP)
}

/// The numbers of two sums, side by side.
fn pairs<T: Number>(one: [Shaded<T>; 3], other: [Shaded<T>; 3]) -> Vec<(f64, f64)> {
    let numbers = |sums: [Shaded<T>; 3]| sums.into_iter().flat_map(channels).map(T::exact);
    numbers(one).zip(numbers(other)).collect()
}

/// Light is never negative and never NaN, from lights and materials that are not.
pub fn no_light_is_negative<T: Number>(scene: &Scene<T>) -> Outcome {
    for sum in scene.shaded(&scene.arriving()) {
        for light in channels(sum) {
            prop_assert!(light >= T::ZERO, "{light:?} in {sum:?}");
        }
    }
    Ok(())
}

/// Lights add up: the light of several is the sum of what each gives alone, but for the rounding of
/// each addition.
pub fn lights_add_up<T: Number>(scene: &Scene<T>) -> Outcome {
    let scene = scene.white();
    prop_assume!(scene.is_in_range());
    let lights = scene.arriving();
    let together = scene.shaded(&lights);
    let mut apart = [[0.0; 9]; 3];
    for light in &lights {
        for (sum, alone) in apart.iter_mut().zip(scene.shaded(&[*light])) {
            for (sum, alone) in sum.iter_mut().zip(channels(alone)) {
                *sum += alone.exact();
            }
        }
    }
    #[allow(clippy::cast_precision_loss)]
    let additions = lights.len() as f64 + 1.0;
    for (is, should) in together.into_iter().flat_map(channels).zip(apart.concat()) {
        prop_assert_near!(is.exact(), should, roundings::<T>(additions, should));
    }
    Ok(())
}

/// The sum goes from the first light to the last, to the bit.
pub fn lights_add_up_in_their_order<T: Number>(scene: &Scene<T>) -> Outcome {
    let scene = scene.white();
    prop_assume!(scene.is_in_range());
    let lights = scene.arriving();
    for (i, together) in scene.shaded(&lights).into_iter().enumerate() {
        let alone = lights.iter().map(|light| scene.shaded(&[*light])[i]);
        let sum: Shaded<T> = alone.sum();
        prop_assert_eq!(together.diffuse, sum.diffuse);
        prop_assert_eq!(together.specular, sum.specular);
    }
    Ok(())
}

/// The order of the lights matters by roundings only.
pub fn the_order_of_lights_does_not_matter<T: Number>(scene: &Scene<T>) -> Outcome {
    let scene = scene.white();
    prop_assume!(scene.is_in_range());
    let mut lights = scene.arriving();
    let forward = scene.shaded(&lights);
    lights.reverse();
    #[allow(clippy::cast_precision_loss)]
    let additions = 2.0 * (lights.len() as f64 + 1.0);
    for (x, y) in pairs(forward, scene.shaded(&lights)) {
        prop_assert_near!(x, y, roundings::<T>(additions, x));
    }
    Ok(())
}

/// A black light changes nothing, nor does a light that is dimmed to nothing.
pub fn a_black_light_changes_nothing<T: Number>(scene: &Scene<T>) -> Outcome {
    let lights = scene.arriving();
    let black = |&light: &IncidentLight<T>| [light, light * Rgb::BLACK, light * T::ZERO];
    let with_black: Vec<_> = lights.iter().flat_map(black).collect();
    prop_assert_eq!(scene.shaded(&with_black), scene.shaded(&lights));
    Ok(())
}

/// Half the light is half as bright, to the bit.
pub fn half_the_light_is_half_as_bright<T: Number>(scene: &Scene<T>) -> Outcome {
    let scene = scene.white();
    prop_assume!(scene.is_in_range());
    let is_normal = |x: f64| x == 0.0 || x > 2.0 * least_normal::<T>();
    for light in scene.arriving() {
        let half = scene.shaded(&[light * T::of(0.5)]);
        for (half, full) in pairs(half, scene.shaded(&[light])) {
            prop_assume!(is_normal(full));
            prop_assert_eq!(2.0 * half, full);
        }
    }
    Ok(())
}

/// A third of the light is a third as bright: the light and the result are rounded once more each.
pub fn any_fraction_of_the_light_is_that_fraction_as_bright<T: Number>(
    scene: &Scene<T>,
) -> Outcome {
    let scene = scene.white();
    prop_assume!(scene.is_in_range());
    let lights = scene.arriving();
    let third = T::of(1.0 / 3.0);
    let dim: Vec<_> = lights.iter().map(|&light| light * third).collect();
    // a falloff magnifies what is rounded before it
    let falloffs = scene.lamps().map(|lamp| {
        let q = scene.p.distance(lamp.position);
        lamp.attenuation.at(q).exact()
    });
    let falloff = falloffs.fold(1.0, f64::max);
    for (x, y) in pairs(scene.shaded(&lights), scene.shaded(&dim)) {
        let should = x * third.exact();
        prop_assert_near!(y, should, 12.0 * (T::U * x + T::STEP * falloff));
    }
    Ok(())
}

/// k_a scales the ambient term, k_d the diffuse one and k_s the specular one, and none scales
/// another.
pub fn each_reflectance_scales_its_term<T: Number>(scene: &Scene<T>) -> Outcome {
    prop_assume!(scene.is_in_range());
    let lights = scene.arriving();
    let white = Scene {
        material: crate::shiny(scene.material.m),
        ..scene.clone()
    };
    let Material { k_a, k_d, k_s, .. } = scene.material;
    for (is, full) in scene.shaded(&lights).into_iter().zip(white.shaded(&lights)) {
        for ((is, full), k) in parts(is).into_iter().zip(parts(full)).zip([k_a, k_d, k_s]) {
            prop_assert_eq!(is, full * k);
        }
    }
    Ok(())
}

/// Exchanged channels of all colors exchange those of the result, to the bit.
pub fn channels_are_apart<T: Number>(scene: &Scene<T>) -> Outcome {
    let cycled = |c: Rgb<T>| Rgb::new(c.g, c.b, c.r);
    let other = scene.map_colors(cycled);
    let sums = scene.shaded(&scene.arriving()).map(|sum| Shaded {
        ambient: cycled(sum.ambient),
        diffuse: cycled(sum.diffuse),
        specular: cycled(sum.specular),
    });
    prop_assert_eq!(other.shaded(&other.arriving()), sums);
    Ok(())
}

/// Whatever red is, green and blue keep their bits.
pub fn red_stays_out_of_green_and_blue<T: Number>(scene: &Scene<T>) -> Outcome {
    let other = scene.map_colors(|c| Rgb::new(T::of(0.7), c.g, c.b));
    let green_and_blue = |scene: &Scene<T>| {
        let sums = scene.shaded(&scene.arriving());
        sums.map(|sum| parts(sum).map(|c| [c.g, c.b]))
    };
    prop_assert_eq!(green_and_blue(scene), green_and_blue(&other));
    Ok(())
}

/// Without lights, k_a I_a remains; with lights, it is still there once.
pub fn the_ambient_term_counts_once<T: Number>(scene: &Scene<T>) -> Outcome {
    let (k, i) = (in_f64(scene.material.k_a), in_f64(scene.ambient));
    for sum in scene.shaded(&[]) {
        prop_assert!(adds_nothing(sum), "{sum:?}");
    }
    for sum in scene.shaded(&scene.arriving()) {
        for ((is, k), i) in in_f64(sum.ambient).into_iter().zip(k).zip(i) {
            prop_assert_near!(is, k * i, roundings::<T>(1.0, k * i));
        }
    }
    prop_assert_eq!(
        scene.shaded(&[])[0].ambient,
        term::ambient(scene.material.k_a, scene.ambient)
    );
    Ok(())
}

/// A surface gives back at most what arrives, in each of its two terms.
pub fn a_surface_returns_at_most_what_arrives<T: Number>(scene: &Scene<T>) -> Outcome {
    prop_assume!(scene.has_distances());
    let scene = scene.white();
    for light in scene.arriving() {
        let most = light.intensity();
        for term in scene
            .shaded(&[light])
            .map(|s| [s.diffuse, s.specular])
            .concat()
        {
            let is_less = term.r <= most.r && term.g <= most.g && term.b <= most.b;
            prop_assert!(is_less, "{term:?} of {most:?}");
        }
    }
    Ok(())
}

/// The diffuse term does not see the eye, and without k_s nothing does.
pub fn diffuse_does_not_see_the_eye<T: Number>(scene: &Scene<T>) -> Outcome {
    let from = |v| {
        let scene = Scene { v, ..scene.clone() };
        scene.shaded(&scene.arriving()).map(|s| s.diffuse)
    };
    let [lambert, phong, blinn] = from(scene.v);
    prop_assert_eq!([phong, blinn], [lambert; 2]);
    prop_assert_eq!(from(UnitVec3::X), [lambert; 3]);
    prop_assert_eq!(from(-scene.v), [lambert; 3]);
    let mut dull = scene.clone();
    dull.material.k_s = Rgb::BLACK;
    let [lambert, phong, blinn] = dull.shaded(&dull.arriving());
    prop_assert_eq!([phong, blinn], [lambert; 2]);
    Ok(())
}

/// A light behind the surface adds nothing, not even a highlight, and can be left out.
pub fn nothing_comes_from_behind<T: Number>(scene: &Scene<T>) -> Outcome {
    let lights = scene.arriving();
    let is_in_front = |light: &IncidentLight<T>| light.is_in_front(scene.n);
    for light in lights.iter().filter(|light| !is_in_front(light)) {
        let sums = scene.shaded(&[*light]);
        prop_assert!(sums.into_iter().all(adds_nothing), "{sums:?}");
    }
    let in_front: Vec<_> = lights.iter().copied().filter(is_in_front).collect();
    prop_assert_eq!(scene.shaded(&lights), scene.shaded(&in_front));
    Ok(())
}

/// A light is in front where N·L > 0, as far as rounding tells.
pub fn a_light_is_in_front_where_n_dot_l_is_above_0<T: Number>(scene: &Scene<T>) -> Outcome {
    let n = book::xyz(scene.n.cast(T::exact));
    for (light, of) in scene.arriving().into_iter().zip(&scene.lights) {
        let way = book::arriving(&of.cast(T::exact), book::xyz(scene.p.map(T::exact)));
        let cosine = way.map_or(0.0, |(l, _)| book::dot(n, l));
        let p = book::length(book::xyz(scene.p.map(T::exact)));
        let q = light.distance().exact();
        prop_assume!(
            cosine == 0.0
                || cosine.abs() > 8.0 * (T::U * (1.0 + p / q) + T::STEP * (1.0 + 1.0 / q))
        );
        if cosine != 0.0 {
            prop_assert_eq!(light.is_in_front(scene.n), cosine > 0.0);
        }
    }
    Ok(())
}

/// A light on the horizon adds nothing: (−y, x, 0) is perpendicular to (x, y, z), to the bit.
pub fn a_light_on_the_horizon_adds_nothing<T: Number>(d: &Directions<T>) -> Outcome {
    let way = Vec3::new(-d.n.y, d.n.x, T::ZERO);
    let sun = DirectionalLight {
        l: UnitVec3::assume_unit(way),
        intensity: Rgb::WHITE,
    };
    let lamp = PointLight {
        position: way,
        intensity: Rgb::WHITE,
        attenuation: Attenuation::NONE,
    };
    let material = crate::shiny(d.m);
    for light in [sun.at(Vec3::ZERO), lamp.at(Vec3::ZERO)] {
        prop_assert!(!light.is_in_front(d.n));
        let sum = shade::blinn_phong(d.n, d.n, &material, Rgb::BLACK, [light]);
        prop_assert!(adds_nothing(sum), "{sum:?}");
    }
    Ok(())
}

/// The light of a diffuse surface is k_a I_a + Σ k_d I max(0, N·L), written out.
pub fn the_sum_of_lambert_is_its_formula<T: Number>(scene: &Scene<T>) -> Outcome {
    prop_assert_book!(
        scene,
        scene.shaded(&scene.arriving())[0],
        book::shaded(scene, Model::Lambert)
    );
    Ok(())
}

/// Phong's light is k_a I_a + Σ I (k_d max(0, N·L) + k_s max(0, R·V)ᵐ), written out.
pub fn the_sum_of_phong_is_its_formula<T: Number>(scene: &Scene<T>) -> Outcome {
    prop_assert_book!(
        scene,
        scene.shaded(&scene.arriving())[1],
        book::shaded(scene, Model::Phong)
    );
    Ok(())
}

/// Blinn's light is k_a I_a + Σ I (k_d max(0, N·L) + k_s max(0, N·H)ᵐ), written out.
pub fn the_sum_of_blinn_is_its_formula<T: Number>(scene: &Scene<T>) -> Outcome {
    prop_assert_book!(
        scene,
        scene.shaded(&scene.arriving())[2],
        book::shaded(scene, Model::Blinn)
    );
    Ok(())
}

/// A light at the point itself adds nothing.
pub fn a_light_at_the_point_adds_nothing<T: Number>(scene: &Scene<T>) -> Outcome {
    for light in &scene.lights {
        let light = match light {
            Light::Directional(_) => continue,
            Light::Point(lamp) => lamp.at(lamp.position),
            Light::Spot(spot) => spot.at(spot.point.position),
        };
        prop_assert_eq!(light.intensity(), Rgb::BLACK);
        prop_assert!(scene.shaded(&[light]).into_iter().all(adds_nothing));
    }
    Ok(())
}

/// What arrives of a sun is its color, everywhere; what arrives of a light of any kind is that
/// light.
pub fn a_sun_is_as_bright_everywhere<T: Number>(scene: &Scene<T>) -> Outcome {
    for light in &scene.lights {
        let arriving = light.at(scene.p);
        match light {
            Light::Directional(sun) => {
                prop_assert_eq!(arriving.l(), sun.l);
                prop_assert_eq!(arriving.intensity(), sun.intensity);
                prop_assert_eq!(arriving.distance(), T::MAX);
            }
            Light::Point(lamp) => prop_assert_eq!(arriving, lamp.at(scene.p)),
            Light::Spot(spot) => prop_assert_eq!(arriving, spot.at(scene.p)),
        }
    }
    Ok(())
}

/// A shadow ray from p along L ends at the lamp, after the distance q: p + qL is the lamp's
/// position.
pub fn a_shadow_ray_ends_at_the_lamp<T: Number>(scene: &Scene<T>) -> Outcome {
    prop_assume!(scene.has_distances());
    let p = book::xyz(scene.p.map(T::exact));
    for lamp in scene.lamps() {
        let light = lamp.at(scene.p);
        let (l, q) = (
            book::xyz(light.l().cast(T::exact)),
            light.distance().exact(),
        );
        let position = book::xyz(lamp.position.map(T::exact));
        prop_assert!((q == 0.0) == (p == position), "{q}");
        prop_assume!(q < T::LARGEST && (q == 0.0 || has_digits::<T>(q * q)));
        let end = book::plus(p, book::times(q, l));
        let far = book::length(p) + q;
        for (end, position) in end.into_iter().zip(position) {
            prop_assert_near!(
                end,
                position,
                if q == 0.0 {
                    0.0
                } else {
                    roundings::<T>(8.0, far) + 8.0 * T::STEP * q
                }
            );
        }
    }
    Ok(())
}

/// L, I and q by one root are those that are asked for one by one, to the bit.
pub fn arrival_is_l_intensity_and_distance<T: Number>(scene: &Scene<T>) -> Outcome {
    for light in scene.arriving() {
        let arrival = light.arrival();
        prop_assert_eq!(arrival.l, light.l());
        prop_assert_eq!(arrival.intensity, light.intensity());
        prop_assert_eq!(arrival.distance, light.distance());
    }
    Ok(())
}

/// What arrives of a lamp is its intensity times the falloff at its distance.
pub fn a_lamp_fades_with_its_distance<T: Number>(scene: &Scene<T>) -> Outcome {
    for lamp in scene.lamps() {
        let q = scene.p.distance(lamp.position);
        let (falloff, is) = (lamp.attenuation.at(q), lamp.at(scene.p).intensity());
        let [a, b, c] = lamp.attenuation.coefficients();
        prop_assume!(q > T::ZERO && attenuation(a, b, c, q).exact() < T::LARGEST / 4.0);
        for (is, i) in in_f64(is).into_iter().zip(in_f64(lamp.intensity)) {
            let should = i * falloff.exact();
            prop_assume!(should < T::LARGEST);
            // the distance is rounded as well where a number holds it with more digits
            prop_assert_near!(
                is,
                should,
                16.0 * T::U * should + (2.0 + i + 8.0 * should) * 2.0 * T::STEP
            );
        }
    }
    Ok(())
}

/// A spot is a lamp within its cone: the same direction and distance, and the light times the
/// factor of the cone.
pub fn a_spot_is_a_lamp_within_its_cone<T: Number>(scene: &Scene<T>) -> Outcome {
    for light in &scene.lights {
        let Light::Spot(spot) = light else { continue };
        let (is, lamp) = (spot.at(scene.p), spot.point.at(scene.p));
        prop_assert_eq!((is.l(), is.distance()), (lamp.l(), lamp.distance()));
        let q = lamp.distance().exact();
        prop_assume!(has_digits::<T>(q * q));
        let cosine = -book::dot(
            book::xyz(spot.axis.cast(T::exact)),
            book::xyz(lamp.l().cast(T::exact)),
        );
        let [inner, outer] = spot.cone.cosines().map(T::exact);
        // the factor is as steep as the edge is narrow
        let error = 16.0 * (T::U + T::STEP);
        let is_on_an_edge = (cosine - inner).abs() <= error || (cosine - outer).abs() <= error;
        prop_assume!(!is_on_an_edge);
        let steep = if inner > outer {
            3.0 / (inner - outer)
        } else {
            0.0
        };
        let factor = spot.cone.factor(spot.axis, lamp.l()).exact();
        for (is, i) in in_f64(is.intensity())
            .into_iter()
            .zip(in_f64(lamp.intensity()))
        {
            prop_assume!(i < T::LARGEST);
            prop_assert_near!(is, i * factor, i * error * (1.0 + steep) + 4.0 * T::STEP);
        }
    }
    Ok(())
}

/// Light times a filter arrives as the product of the two, channel by channel.
pub fn a_filter_multiplies_what_arrives<T: Number>(scene: &Scene<T>) -> Outcome {
    let filter = scene.material.k_d;
    for light in &scene.lights {
        if let Light::Directional(sun) = light {
            let arriving = light.at(scene.p);
            prop_assert_eq!((arriving * filter).intensity(), sun.intensity * filter);
            prop_assert_eq!((arriving * filter.r).intensity(), sun.intensity * filter.r);
            prop_assert_eq!((arriving * filter).l(), sun.l);
        }
    }
    Ok(())
}

/// The further a lamp is, the less of it arrives, or as much: as far as the distance tells.
pub fn a_lamp_never_brightens_as_it_recedes<T: Number>(scene: &Scene<T>) -> Outcome {
    for lamp in scene.lamps() {
        let far = PointLight {
            position: lamp.position + (lamp.position - scene.p),
            ..lamp
        };
        let [near, far] = [lamp.at(scene.p), far.at(scene.p)];
        prop_assume!(near.distance() > T::ZERO && far.distance() >= near.distance());
        for (near, far) in in_f64(near.intensity())
            .into_iter()
            .zip(in_f64(far.intensity()))
        {
            prop_assert!(far <= near, "{near} and then {far}");
        }
    }
    Ok(())
}

/// A scene of twice the size, with half of b and a quarter of c, is as bright, to the bit.
pub fn a_scene_of_twice_the_size_is_as_bright<T: Number>(scene: &Scene<T>) -> Outcome {
    let [two, half] = [2.0, 0.5].map(T::of);
    for lamp in scene.lamps() {
        let [a, b, c] = lamp.attenuation.coefficients();
        let of = |b, c| Attenuation::new(a, b, c).expect("coefficients");
        let small = PointLight {
            attenuation: of(b, c),
            ..lamp
        };
        let large = PointLight {
            position: lamp.position * two,
            attenuation: of(b * half, c * half * half),
            ..lamp
        };
        let [small, large] = [small.at(scene.p), large.at(scene.p * two)];
        let [i, q] = [small.intensity().g.exact(), small.distance().exact()];
        let is_normal = |x: f64| x > 2.0 * T::SMALLEST / T::U && x < T::LARGEST / 4.0;
        prop_assume!((is_normal(i) || i == 0.0) && (is_normal(q) || q == 0.0));
        // nor may b/2 and c/4 vanish, nor a square on the way
        prop_assume!(q == 0.0 || is_normal(q * q) && is_normal(1.0 / (q * q)));
        prop_assert_eq!(large.intensity(), small.intensity());
        prop_assert_eq!(large.distance(), small.distance() * two);
        prop_assert_eq!(large.l(), small.l());
    }
    Ok(())
}

/// Half a turn of everything about z changes no light, to the bit.
pub fn half_a_turn_of_the_scene_changes_nothing<T: Number>(scene: &Scene<T>) -> Outcome {
    let turned = scene.moved(half_a_turn, Vec3::ZERO);
    prop_assert_eq!(
        turned.shaded(&turned.arriving()),
        scene.shaded(&scene.arriving())
    );
    Ok(())
}

/// A quarter of a turn about z changes light by roundings only: x and y are added in the other
/// order.
pub fn a_quarter_turn_of_the_scene_changes_little<T: Number>(scene: &Scene<T>) -> Outcome {
    let scene = scene.white();
    let turned = scene.moved(quarter_turn, Vec3::ZERO);
    let m = f64::from(scene.material.m);
    for (i, light) in scene.arriving().into_iter().enumerate() {
        // a light on the horizon or on the edge of a cone may fall on either side of it
        let [one, other] = [light, turned.arriving()[i]];
        let [i, k] = [one, other].map(|light| in_f64(light.intensity()));
        prop_assume!(one.is_in_front(scene.n) == other.is_in_front(turned.n));
        for (i, k) in i.into_iter().zip(k) {
            prop_assume!((i - k).abs() <= roundings::<T>(32.0, i));
        }
        let most = i.into_iter().fold(0.0, f64::max);
        let [one, other] = [scene.shaded(&[one]), turned.shaded(&[other])];
        for (x, y) in pairs(one, other) {
            // L + V has few digits where it is short, and a power multiplies the error of its base
            let tolerance = (m + 4.0) * roundings::<T>(32.0, most);
            prop_assume!(!(x == 0.0) || y == 0.0 || (x - y).abs() <= tolerance);
            prop_assert_near!(x, y, tolerance * 4.0);
        }
    }
    Ok(())
}

/// A lamp and a point that move together see each other as before, to the bit where their
/// differences are exact.
pub fn a_lamp_moves_with_its_point<T: Number>(t: &Triangle<T>) -> Outcome {
    let ([position, p, _], offset) = (t.corners, t.offset);
    let lamp = |position| PointLight {
        position,
        intensity: Rgb::WHITE,
        attenuation: Attenuation::new(T::ONE, T::ONE, T::ONE).expect("coefficients"),
    };
    let [here, there] = [lamp(position).at(p), lamp(position + offset).at(p + offset)];
    prop_assert_eq!(here.l(), there.l());
    prop_assert_eq!(here.distance(), there.distance());
    prop_assert_eq!(here.intensity(), there.intensity());
    Ok(())
}

/// A lamp that is far along L lights as a sun from L: the directions differ by at most |p|/D.
pub fn a_far_lamp_is_a_sun<T: Number>(d: &Directions<T>) -> Outcome {
    let far = f64::min(256.0, T::LARGEST / 4.0);
    let lamp = PointLight {
        position: *d.l * T::of(far),
        intensity: Rgb::WHITE,
        attenuation: Attenuation::NONE,
    };
    let p = Vec3::new(T::of(0.5), T::of(-0.5), T::of(0.25)); // |p| = ¾
    let light = lamp.at(p);
    let [is, l] = [light.l(), d.l].map(|v| book::xyz(v.cast(T::exact)));
    let angle = book::length(book::minus(is, l));
    prop_assert!(
        angle <= 0.75 / (far - 0.75) + 8.0 * (T::U + T::STEP),
        "{is:?}"
    );
    prop_assert_eq!(light.intensity(), Rgb::WHITE);
    Ok(())
}

/// The total is the sum of the three parts; passes are added and scaled part by part.
pub fn results_add_up_part_by_part<T: Number>(scene: &Scene<T>) -> Outcome {
    prop_assume!(scene.is_in_range() && scene.has_distances());
    let [_, one, other] = scene.shaded(&scene.arriving());
    let half = T::of(0.5);
    let sum = one + other * half;
    let parts = parts(one).into_iter().zip(parts(other)).zip(parts(sum));
    for ((one, other), sum) in parts {
        let all = in_f64(one).into_iter().zip(in_f64(other)).zip(in_f64(sum));
        for ((one, other), sum) in all {
            let should = one + 0.5 * other;
            prop_assert_near!(sum, should, roundings::<T>(2.0, should));
        }
    }
    let channels = channels(one).map(T::exact);
    for (i, total) in in_f64(one.total()).into_iter().enumerate() {
        let should = channels[i] + channels[i + 3] + channels[i + 6];
        prop_assert_near!(total, should, roundings::<T>(2.0, should));
    }
    Ok(())
}
