//! The picture agrees with the formula as the books write it, in both precisions; and bad models are refused.

use std::fmt::Write;

use indicatif::ProgressBar;
use shading::Light;
use tracer::mesh::Mesh;
use tracer::picture::{EYE, draw, ray};
use tracer::scene::Scene;
use tracer::vector::Vector;

type Single = glam::Vec3;
type Double = nalgebra::Vector3<f64>;

const BUNNY: &str = include_str!("../../../examples/gallery/data/bunny.obj");
const SIZE: [usize; 2] = [96, 60];

fn bunny<V: Vector>() -> Scene<V> {
    Scene::new(Some(
        Mesh::read(BUNNY, 1.7, [-0.3, 0.0, 0.0]).expect("a bunny"),
    ))
}

fn drawn<V: Vector>(scene: &Scene<V>) -> Vec<u8> {
    draw(scene, SIZE[0], SIZE[1], &ProgressBar::hidden())
}

/// The sum of Foley, van Dam et al. §16.1 in doubles, red channel: the lamps one after another, H
/// normalized, the power by the standard library. The geometry is the tracer's.
fn red_by_hand(scene: &Scene<Double>, from: Double, along: Double) -> f64 {
    let hit = scene
        .nearest(from, along, f64::MAX)
        .expect("something is hit");
    let (n, p) = (hit.n, from + along * hit.t);
    let material = hit.material;
    let mut sum = material.k_a.r * f64::from(0.08_f32);
    for light in &scene.lights {
        let (l, intensity, q) = match light {
            Light::Directional(sun) => (
                Double::from(<[f64; 3]>::from(sun.l)),
                sun.intensity.r,
                f64::MAX,
            ),
            Light::Point(point) | Light::Spot(shading::SpotLight { point, .. }) => {
                let toward = Double::from(<[f64; 3]>::from(point.position)) - p;
                let (q, [a, b, c]) = (toward.norm(), point.attenuation.coefficients());
                (toward / q, point.intensity.r / (a + b * q + c * q * q), q)
            }
        };
        let in_cone = match light {
            Light::Spot(spot) => {
                -l.dot(<[f64; 3]>::from(spot.axis).into()) >= f64::from(0.4_f32).cos()
            }
            _ => true,
        };
        let n_dot_l = n.dot(l);
        if in_cone && n_dot_l > 0.0 && scene.nearest(p + n * f64::from(1e-3_f32), l, q).is_none() {
            let n_dot_h = n.dot((l - along).normalize()).max(0.0);
            sum += intensity
                * (material.k_d.r * n_dot_l + material.k_s.r * n_dot_h.powi(material.m as i32));
        }
    }
    sum
}

#[test]
fn every_pixel_is_the_formulas() {
    let scene = bunny::<Double>();
    let (mut hits, mut lit) = (0, 0);
    for (x, y) in (0..SIZE[0]).flat_map(|x| (0..SIZE[1]).map(move |y| (x, y))) {
        let along = ray(x, y, SIZE[0], SIZE[1]);
        let Some(shaded) = scene.seen(Double::of_f32(EYE), along) else {
            continue;
        };
        let expected = red_by_hand(&scene, Double::of_f32(EYE), along);
        let light = shaded.total().r;
        // about a hundred roundings, of which the power multiplies those of its cosine by up to 200
        assert!(
            (light - expected).abs() < 1e-12,
            "({x}, {y}): {light}, by hand {expected}"
        );
        hits += 1;
        lit += usize::from(shaded.diffuse.r > 0.0);
    }
    assert!(
        hits > 4000 && lit > 2000,
        "{hits} pixels of the scene, {lit} of them lit"
    );
}

/// Two precisions, two vector libraries, one picture. Where an edge of a shadow or of the model passes, a
/// pixel may fall to either side: of 5,760 pixels, at most one in a hundred.
#[test]
fn both_precisions_draw_one_picture() {
    let (single, double) = (drawn(&bunny::<Single>()), drawn(&bunny::<Double>()));
    let differ = single
        .iter()
        .zip(&double)
        .filter(|(a, b)| a.abs_diff(**b) > 1)
        .count();
    assert!(differ <= 3 * 58, "{differ} bytes differ");
}

/// A sphere above the lamp, and the floor below it: the shadow ray ends at the lamp.
#[test]
fn nothing_behind_a_lamp_casts_a_shadow() {
    let mut scene = bunny::<Single>();
    scene.mesh = None;
    scene.lights.truncate(2);
    scene.lights.remove(0);
    let down = Single::new(0.0, -1.0, 0.0);
    let below = |scene: &Scene<Single>| {
        scene
            .seen(Single::new(-3.0, 1.0, 1.0), down)
            .expect("the floor")
            .diffuse
    };
    let free = below(&scene);
    let (_, radius, material) = scene.spheres[0];
    scene.spheres = vec![(Single::new(-3.0, 5.0, 1.0), radius, material)];
    assert_eq!(below(&scene), free);
    assert!(free.r > 0.0);
    // now between the lamp and the floor, and the eye looks from the side
    scene.spheres = vec![(Single::new(-3.0, 2.0, 1.0), 0.2, material)];
    let eye = Single::new(-3.0, 1.0, 2.0);
    let along = (Single::new(-3.0, 0.0, 1.0) - eye).normalize();
    assert_eq!(
        scene.seen(eye, along).expect("the floor").diffuse,
        shading::Rgb::BLACK
    );
}

/// A lamp inside a sphere lights nothing outside; one at the eye, and one on the floor, light as they should.
#[test]
fn lamps_in_bad_places_are_harmless() {
    for place in [[1.4, 0.8, -0.6], EYE, [0.0, 0.0, 2.0], [-1.9, 1.2, 0.7]] {
        let mut scene = bunny::<Single>();
        for light in &mut scene.lights {
            if let Light::Point(point) = light {
                point.position = place.into();
            }
        }
        for (x, y) in (0..SIZE[0]).flat_map(|x| (0..SIZE[1]).map(move |y| (x, y))) {
            if let Some(shaded) = scene.seen(Single::of_f32(EYE), ray(x, y, SIZE[0], SIZE[1])) {
                let light = <[f32; 3]>::from(shaded.total());
                assert!(
                    light.iter().all(|c| c.is_finite() && *c >= 0.0),
                    "{place:?} ({x}, {y}): {light:?}"
                );
            }
        }
    }
}

fn message(obj: &str) -> String {
    Mesh::<Single>::read(obj, 1.0, [0.0; 3])
        .err()
        .unwrap_or_default()
}

#[test]
fn bad_models_are_refused_with_a_reason() {
    const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    for empty in [
        "",
        "# nothing\n",
        SQUARE,
        &format!("{SQUARE}f 1 2 2\nf 3 3 3\nf 1 2"),
    ] {
        assert_eq!(message(empty), "it has no triangle with an area");
    }
    for face in [
        "f 1 2 5",
        "f 0 1 2",
        "f -5 1 2",
        "f 1 2 three",
        "f 1 2 99999999999999999999",
    ] {
        assert_eq!(
            message(&format!("{SQUARE}{face}")),
            "line 5: a face has a vertex that is not there"
        );
    }
    for vertex in ["v 0 nan 0", "v 0 1e999 0", "v 0 0", "v a b c"] {
        assert_eq!(
            message(&format!("{vertex}\nf 1 1 1")),
            "line 1: a vertex takes three finite numbers"
        );
    }
}

#[test]
fn a_model_may_lack_normals_and_have_degenerate_triangles() {
    let obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nf 1/7 2//9 2\nf -4 -3 -1\n";
    let mesh = Mesh::<Single>::read(obj, 1.0, [0.0; 3]).expect("a square");
    assert_eq!(mesh.without_area, 1);
    let (t, n) = mesh
        .nearest(
            Single::new(0.1, 0.5, 3.0),
            Single::new(0.0, 0.0, -1.0),
            f32::MAX,
        )
        .expect("a hit");
    // a square in the plane z = 0
    assert!((t - 3.0).abs() < 1e-6 && n == Single::Z, "{t} {n}");
    let flat = "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 3 2";
    assert!(
        Mesh::<Single>::read(flat, 1.0, [0.0; 3]).is_ok(),
        "on the floor, without height"
    );
}

/// 708 × 708 squares of two triangles: z = (x² + y²)/2.
#[test]
fn a_million_triangles_are_drawn() {
    const N: usize = 708;
    let mut obj = String::new();
    for (i, j) in (0..=N).flat_map(|i| (0..=N).map(move |j| (i, j))) {
        let [x, y] = [i, j].map(|k| 2.0 * k as f32 / N as f32 - 1.0);
        writeln!(obj, "v {x} {} {y}", 0.5 * (x * x + y * y)).expect("a string");
    }
    for (i, j) in (0..N).flat_map(|i| (1..=N).map(move |j| (i, j))) {
        let [a, b] = [i * (N + 1) + j, (i + 1) * (N + 1) + j];
        writeln!(obj, "f {a} {} {} {b}", a + 1, b + 1).expect("a string");
    }
    let mesh = Mesh::<Single>::read(&obj, 1.0, [0.0; 3]).expect("a bowl");
    assert_eq!(mesh.without_area, 0);
    // the normal of z = (x² + y²)/2 at (1/2, 0) is (−1/2, 1, 0)/√(5/4)
    let (_, n) = mesh
        .nearest(
            Single::new(0.5, 9.0, 0.0),
            Single::new(0.0, -1.0, 0.0),
            f32::MAX,
        )
        .expect("a hit");
    let expected = Single::new(-0.5, 1.0, 0.0) / f32::sqrt(1.25);
    // a vertex is off by a side of a square, 2/708, at most
    assert!(n.distance(expected) < 3e-3, "{n}, not {expected}");
    let lit = drawn(&Scene::new(Some(mesh)))
        .iter()
        .map(|&byte| usize::from(byte))
        .sum::<usize>();
    assert!(lit > 0);
}

#[test]
fn a_picture_without_pixels_is_empty() {
    assert!(draw(&bunny::<Single>(), 0, 9, &ProgressBar::hidden()).is_empty());
    assert!(draw(&bunny::<Single>(), 9, 0, &ProgressBar::hidden()).is_empty());
}
