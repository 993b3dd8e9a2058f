//! The page on this machine: its picture, and what it does with bad input.

use shading::f32::{Rgb, Vec3};
use web::page::{MOST_PIXELS, Page};
use web::scene::{Part, SETTINGS};
use web::surface::{Camera, EYE, Surface};

/// As the page opens: the teapot, Blinn–Phong, one white lamp.
const OPENING: [f32; SETTINGS] = [
    1.0, 2.0, 0.1, 0.65, 0.4, 40.0, 0.8, 1.2, 1.8, 0.8, 0.0, 0.02, 180.0,
    0.0, // material, lamp
    0.0, -0.8, 0.9, 1.6, // second lamp
    0.0, 1.0, 5.0, 1.0, 0.0, // the eye, and the turn of the object
    0.0, 0.6, 0.64, 0.48, // the sun
    224.0, 128.0, 60.0, 255.0, 255.0, 255.0, 77.0, 139.0, 255.0, 255.0, 241.0,
    208.0, // colors
];
const SURFACE: usize = 0;
const MODEL: usize = 1;
const K_A: usize = 2;
const X: usize = 6;
const A: usize = 9;
const ANGLE: usize = 12;
const EDGE: usize = 13;
const SECOND: usize = 14;
const EYE_AT: usize = 18;
const TURN: usize = 21;
const SUN: usize = 23;
const COLOR: usize = 27;
const LIGHT: usize = 30;
/// The ends of the page's sliders.
const ENDS: [[f32; 2]; SETTINGS] = [
    [0.0, 1.0],
    [0.0, 2.0],
    [0.0, 1.0],
    [0.0, 1.0],
    [0.0, 1.0],
    [0.0, 200.0],
    [-6.0, 6.0],
    [-6.0, 6.0],
    [-6.0, 6.0],
    [0.0, 2.0],
    [0.0, 1.0],
    [0.0, 1.0],
    [0.0, 180.0],
    [0.0, 90.0],
    [0.0, 1.0],
    [-6.0, 6.0],
    [-6.0, 6.0],
    [-6.0, 6.0],
    [-5.0, 5.0],
    [-4.0, 5.0],
    [-5.0, 5.0],
    [-1.0, 1.0],
    [-1.0, 1.0],
    [0.0, 1.0],
    [-1.0, 1.0],
    [-1.0, 1.0],
    [-1.0, 1.0],
    [0.0, 255.0],
    [0.0, 255.0],
    [0.0, 255.0],
    [0.0, 255.0],
    [0.0, 255.0],
    [0.0, 255.0],
    [0.0, 255.0],
    [0.0, 255.0],
    [0.0, 255.0],
    [0.0, 255.0],
    [0.0, 255.0],
    [0.0, 255.0],
];
const SIZE: usize = 60;

fn page(settings: [f32; SETTINGS]) -> Page {
    let mut page = Page::EMPTY;
    page.settings = settings;
    page
}

fn with(changes: &[(usize, f32)]) -> [f32; SETTINGS] {
    let mut settings = OPENING;
    for &(index, value) in changes {
        settings[index] = value;
    }
    settings
}

/// Every number of every pixel is finite, and no light is negative.
fn is_sound(page: &mut Page) {
    for pixel in 0..SIZE * SIZE {
        let numbers = page.probe(SIZE, SIZE, pixel % SIZE, pixel / SIZE);
        assert!(
            numbers.iter().all(|x| x.is_finite()),
            "pixel {pixel}: {numbers:?}"
        );
        // ambient, diffuse, specular, total
        assert!(
            numbers[10..22].iter().all(|&x| x >= 0.0),
            "pixel {pixel}: {numbers:?}"
        );
    }
}

/// What is seen, by area and light. The sphere of radius 1 at the distance √26 fills a disk with the
/// radius 1.75/√25 of the window (the tangent cone's): π 0.35² of its area.
#[test]
fn sphere_fills_its_disk() {
    let mut page = page(with(&[(SURFACE, 0.0)]));
    let pixels = page.draw(Part::Total, 400, 400);
    let seen = pixels.chunks(4).filter(|pixel| pixel[3] == 255).count();
    let expected = std::f64::consts::PI * 0.35 * 0.35;
    // the boundary of 2π 140 pixels, each in doubt by half a pixel at most, and of random sign
    assert!((seen as f64 / 160_000.0 - expected).abs() < 1e-3, "{seen}");
}

/// Lambert's sphere with the lamp at the eye: the mean of N·L over the disk. From far away it is 2/3; from
/// here it is the integral below.
#[test]
fn mean_of_lambert_is_the_integral() {
    let settings = with(&[
        (SURFACE, 0.0),
        (MODEL, 0.0),
        (K_A, 0.0),
        (3, 1.0),
        (4, 0.0),
        (X, EYE.x),
        (X + 1, EYE.y),
        (X + 2, EYE.z),
        (A, 1.0),
        (A + 2, 0.0),
        (COLOR, 255.0),
        (COLOR + 1, 255.0),
        (COLOR + 2, 255.0),
    ]);
    let mut page = page(settings);
    let (mut sum, mut count) = (0.0, 0.0);
    for pixel in 0..160_000 {
        let numbers = page.probe(400, 400, pixel % 400, pixel / 400);
        if numbers[0] > 0.0 {
            sum += f64::from(numbers[19]);
            count += 1.0;
        }
    }
    // a ray at the angle β from the axis meets the sphere where N·V = √(1 − d² sin²β), d = √26; the
    // pixels are uniform in the disk of radius tan β: the mean is ∫ N·V d(tan²β) / (1/25)
    let (steps, mut integral) = (100_000, 0.0);
    for step in 0..steps {
        let tangent = (f64::from(step) + 0.5) / f64::from(steps) / 25.0;
        integral += (1.0 - 26.0 * tangent / (1.0 + tangent)).max(0.0).sqrt() / f64::from(steps);
    }
    let mean = sum / count;
    // the pixels of the edge, 1 % of all, are in doubt, and dark
    assert!(
        (mean - integral).abs() < 2e-3,
        "{mean}, by the integral {integral}"
    );
}

#[test]
fn sliders_at_both_ends_are_sound() {
    for (index, ends) in ENDS.into_iter().enumerate() {
        for end in ends {
            for surface in [0.0, 1.0] {
                is_sound(&mut page(with(&[(SURFACE, surface), (index, end)])));
            }
        }
    }
    for end in [0, 1] {
        is_sound(&mut page(ENDS.map(|ends| ends[end])));
    }
}

#[test]
fn any_bits_are_sound() {
    for value in [
        f32::NAN,
        f32::INFINITY,
        f32::NEG_INFINITY,
        f32::MAX,
        f32::MIN,
        f32::MIN_POSITIVE,
        -0.0,
        -1.0,
    ] {
        is_sound(&mut page([value; SETTINGS]));
        for index in 0..SETTINGS {
            is_sound(&mut page(with(&[(index, value)])));
        }
    }
}

#[test]
fn a_lamp_on_the_surface_and_at_the_eye_is_sound() {
    let points = Surface::Teapot.seen_by(&Camera::new(EYE, SIZE, SIZE), [1.0, 0.0]);
    let places = points.iter().step_by(97).map(|point| point.p).chain([EYE]);
    for place in places {
        for a in [0.0, 1.0] {
            let at = [(X, place.x), (X + 1, place.y), (X + 2, place.z), (A, a)];
            is_sound(&mut page(with(&at)));
        }
    }
}

#[test]
fn trouble_is_told() {
    let told = |changes: &[(usize, f32)], width: usize, height: usize| {
        let mut page = page(with(changes));
        let pixels = page.draw(Part::Total, width, height).len();
        (page.message(), pixels)
    };
    assert_eq!(told(&[], SIZE, SIZE), ("", 4 * SIZE * SIZE));
    let cases: [(&[(usize, f32)], &str); 4] = [
        (
            &[(LIGHT, 0.0), (LIGHT + 1, 0.0), (LIGHT + 2, 0.0)],
            "it is black",
        ),
        (&[(A, 0.0), (A + 1, 0.0), (A + 2, 0.0)], "has no value"),
        (
            &[(SURFACE, 0.0), (X, 0.1), (X + 1, 0.2), (X + 2, 0.3)],
            "inside",
        ),
        (
            &[
                (X, EYE.x),
                (X + 1, EYE.y),
                (X + 2, EYE.z),
                (ANGLE, 0.0),
                (SURFACE, 0.0),
                (EDGE, 0.0),
            ],
            "at the eye",
        ),
    ];
    for (changes, words) in cases {
        let (message, pixels) = told(changes, SIZE, SIZE);
        assert!(message.contains(words), "{message:?}");
        assert_eq!(
            pixels,
            4 * SIZE * SIZE,
            "the ambient part is drawn all the same"
        );
    }
    for (width, height, words) in [
        (0, 0, "no room"),
        (0, 9, "no room"),
        (usize::MAX, 2, "larger"),
        (MOST_PIXELS + 1, 1, "larger"),
    ] {
        let (message, pixels) = told(&[], width, height);
        assert!(message.contains(words) && pixels == 0, "{message:?}");
    }
    for (width, height, x, y) in [(0, 0, 0, 0), (usize::MAX, 2, 5, 1), (9, 9, 9, 0)] {
        let mut page = page(OPENING);
        let numbers = page.probe(width, height, x, y);
        assert!(numbers.iter().all(|&x| x == 0.0), "{numbers:?}");
    }
}

/// The total that the page shows is the sum of the parts that it shows.
#[test]
fn parts_add_up() {
    let mut page = page(OPENING);
    for pixel in 0..SIZE * SIZE {
        let numbers = page.probe(SIZE, SIZE, pixel % SIZE, pixel / SIZE);
        let [ambient, diffuse, specular, total] =
            [10, 13, 16, 19].map(|i| Rgb::new(numbers[i], numbers[i + 1], numbers[i + 2]));
        assert_eq!(ambient + diffuse + specular, total);
    }
}

/// Light adds up: what two lamps send is what each sends alone, and the surroundings once.
#[test]
fn a_second_lamp_adds_its_light() {
    let parts = |changes: &[(usize, f32)], pixel: usize| {
        let numbers = *page(with(changes)).probe(SIZE, SIZE, pixel % SIZE, pixel / SIZE);
        [13, 16].map(|i| Rgb::new(numbers[i], numbers[i + 1], numbers[i + 2]))
    };
    let black = [(LIGHT, 0.0), (LIGHT + 1, 0.0), (LIGHT + 2, 0.0)];
    for pixel in (0..SIZE * SIZE).step_by(7) {
        let [first, both] = [0.0, 1.0].map(|second| parts(&[(SECOND, second)], pixel));
        let second = parts(&[(SECOND, 1.0), black[0], black[1], black[2]], pixel);
        for part in 0..2 {
            let [sum, both] = [first[part] + second[part], both[part]].map(<[f32; 3]>::from);
            for (sum, both) in sum.into_iter().zip(both) {
                assert!(
                    (sum - both).abs() <= 4.0 * f32::EPSILON * both,
                    "{sum}, {both}"
                );
            }
        }
    }
}

/// A dragged lamp appears where the pointer is, and keeps its distance from the plane of the picture.
#[test]
fn a_dragged_lamp_is_under_the_pointer() {
    for (lamp, first) in [(0, X), (1, SECOND + 1)] {
        let mut page = page(with(&[(SECOND, 1.0)]));
        let camera = Camera::new(EYE, 400, 400);
        let depth = |page: &Page| {
            let [x, y, z] = [0, 1, 2].map(|i| page.settings[first + i]);
            1.0 / camera.project(Vec3::new(x, y, z)).expect("in sight").w
        };
        let before = depth(&page);
        for to in [[10.5, 20.5], [399.5, 200.5], [200.0, 0.0]] {
            let moved = page.moved(lamp, 400, 400, to);
            page.settings[first..first + 3].copy_from_slice(&moved);
            let at = page.lamp(lamp, 400, 400);
            assert!(
                (at[0] - to[0]).hypot(at[1] - to[1]) < 1e-2,
                "{at:?} is not {to:?}"
            );
            assert!((depth(&page) - before).abs() < 1e-5);
        }
    }
    let off = page(OPENING);
    let stays = Vec3::from(off.moved(1, 400, 400, [1.0, 1.0]));
    assert_eq!(stays, Vec3::ZERO, "it is off");
    assert!(off.lamp(1, 400, 400)[0] < 0.0, "and not in the picture");
}

/// Turning eye, lamps and object together about y leaves the picture as it is, but for rounding: nothing but their
/// places to each other counts.
#[test]
fn turning_all_together_changes_nothing() {
    let (cosine, sine) = (0.6_f32, 0.8_f32); // of a right triangle, exact but for rounding
    let turned = |[x, y, z]: [f32; 3]| [cosine * x + sine * z, y, cosine * z - sine * x];
    for surface in [0.0, 1.0] {
        let before = with(&[(SURFACE, surface), (SECOND, 1.0), (SUN, 1.0)]);
        let mut after = before;
        for first in [X, SECOND + 1, EYE_AT, SUN + 1] {
            let place = turned([before[first], before[first + 1], before[first + 2]]);
            after[first..first + 3].copy_from_slice(&place);
        }
        (after[TURN], after[TURN + 1]) = (cosine, sine);
        let [a, b] = [before, after].map(|it| page(it).draw(Part::Total, SIZE, SIZE).to_vec());
        assert!(a.iter().any(|&byte| byte > 100), "something is seen");
        let pairs = a.iter().zip(&b);
        let others = pairs.filter(|(a, b)| a.abs_diff(**b) > 1).count();
        // pixels at an edge may see what is beside it: fewer than 1 % of the numbers
        assert!(others < a.len() / 100, "{others} of {} differ", a.len());
    }
}

/// The sun's diffuse light by Lambert's law, at each pixel, in doubles; and a sun of any bits is sound.
#[test]
fn the_sun_shines_by_lambert() {
    let black = [(LIGHT, 0.0), (LIGHT + 1, 0.0), (LIGHT + 2, 0.0)];
    let white = [(COLOR, 255.0), (COLOR + 1, 255.0), (COLOR + 2, 255.0)];
    let sunny = [(SUN, 1.0), (COLOR + 9, 255.0), (SURFACE, 0.0)];
    let changes = [&black[..], &white[..], &sunny[..]].concat();
    let mut page = page(with(&changes));
    for pixel in 0..SIZE * SIZE {
        let numbers = page.probe(SIZE, SIZE, pixel % SIZE, pixel / SIZE);
        let [x, y, z] = [4, 5, 6].map(|i| f64::from(numbers[i]));
        let expected = 0.65 * (0.6 * x + 0.64 * y + 0.48 * z).max(0.0);
        let red = f64::from(numbers[13]);
        assert!((red - expected).abs() < 1e-6, "{red}, not {expected}");
    }
}

/// A coarse mesh covers nearly the pixels of the surface, by either way; a flat triangle has one color, so
/// there are fewer colors than by Gouraud.
#[test]
fn meshes_are_flat_or_smooth() {
    for surface in [0.0, 1.0] {
        let mut page = page(with(&[(SURFACE, surface)]));
        let exact = page.draw(Part::Total, 200, 200).to_vec();
        let [flat, smooth] = [false, true].map(|smooth| page.draw_mesh(smooth, 200, 200).to_vec());
        let seen = |pixels: &[u8]| pixels.chunks(4).filter(|pixel| pixel[3] == 255).count();
        let colors = |pixels: &[u8]| {
            pixels
                .chunks(4)
                .collect::<std::collections::HashSet<_>>()
                .len()
        };
        for mesh in [&flat, &smooth] {
            let (of, is) = (seen(&exact) as f64, seen(mesh) as f64);
            // the chords of a circle of 16 corners leave out 1 − sin(π/8)/(π/8) = 2.6 % of it
            assert!(is > 0.95 * of && is < 1.02 * of, "{is} pixels, not {of}");
        }
        assert!(colors(&flat) < 600 && colors(&smooth) > 2 * colors(&flat));
    }
    assert!(page(OPENING).draw_mesh(true, usize::MAX, 2).is_empty());
}
