//! The frame agrees with the formula as the books write it, and bad models are harmless.

use std::collections::BTreeSet;

use bunny::{FACES, HEIGHT, Panel, Turn, VERTICES, WIDTH, draw, draw_bunny};
use embedded_graphics::prelude::{DrawTarget, OriginDimensions, Size};
use embedded_graphics::primitives::Rectangle;
use shading::f32::Vec3;

const TURN: Turn = Turn(0.96, 0.28);

/// The pixels, and all colors sent.
fn frame(draw: impl Fn(&mut Panel<&mut dyn FnMut(Rectangle, u16)>)) -> (Vec<u16>, BTreeSet<u16>) {
    let (mut pixels, mut colors) = (vec![0; (WIDTH * HEIGHT) as usize], BTreeSet::new());
    let mut take = |area: Rectangle, color: u16| {
        colors.insert(color);
        for y in area.rows() {
            for x in area.columns() {
                pixels[y as usize * WIDTH as usize + x as usize] = color;
            }
        }
    };
    draw(&mut Panel(&mut take));
    (pixels, colors)
}

fn model(vertices: &[Vec3], faces: &[[u16; 3]]) -> Vec<u16> {
    let (pixels, _) = frame(|panel| {
        let Ok(()) = draw(panel, vertices, faces);
    });
    pixels
}

/// Bits of RGB565 for linear light, in doubles.
fn rgb565(light: [f64; 3]) -> u16 {
    let level = |c: f64, most: f64| {
        let c = c.clamp(0.0, 1.0);
        let encoded = if c <= 0.003_130_8 {
            12.92 * c
        } else {
            1.055 * c.powf(1.0 / 2.4) - 0.055
        };
        (encoded * most).round() as u16
    };
    level(light[0], 31.0) << 11 | level(light[1], 63.0) << 5 | level(light[2], 31.0)
}

/// The sum of Foley, van Dam et al. §16.1 in doubles for the triangle of three points, seen along z.
fn by_hand(corners: [[f64; 3]; 3]) -> [f64; 3] {
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let sub = |a: [f64; 3], b: [f64; 3]| [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
    let unit = |a: [f64; 3]| a.map(|c| c / dot(a, a).sqrt());
    let [a, b, c] = corners;
    let (e, f) = (sub(b, a), sub(c, a));
    let n = unit([
        e[1] * f[2] - e[2] * f[1],
        e[2] * f[0] - e[0] * f[2],
        e[0] * f[1] - e[1] * f[0],
    ]);
    let center = [0, 1, 2].map(|i| (a[i] + b[i] + c[i]) / 3.0);
    let to_lamp = sub([-2.0, 0.5, 1.0], center);
    let lamp = 1.0 / (0.3 + 0.2 * dot(to_lamp, to_lamp));
    let lights = [
        ([0.48, 0.64, 0.6], [1.0, 0.95, 0.9]),
        (unit(to_lamp), [0.2, 0.35, 0.7].map(|i| i * lamp)),
    ];
    let mut sum = [0.06; 3];
    for (l, intensity) in lights {
        let n_dot_l = dot(n, l);
        if n_dot_l > 0.0 {
            let highlight = dot(n, unit([l[0], l[1], l[2] + 1.0])).max(0.0).powi(8);
            for (i, k_d) in [0.7, 0.6, 0.5].into_iter().enumerate() {
                sum[i] += intensity[i] * (k_d * n_dot_l + 0.15 * highlight);
            }
        }
    }
    sum
}

/// Each color that is sent is that of a triangle, computed by hand, to one level in each channel.
#[test]
fn each_triangle_has_the_formulas_color() {
    let (pixels, colors) = frame(|panel| {
        let Ok(()) = draw_bunny(panel, TURN);
    });
    let turned = VERTICES.map(|p| {
        let [x, y, z] = <[f32; 3]>::from(p).map(f64::from);
        [0.96 * x + 0.28 * z, y, 0.96 * z - 0.28 * x]
    });
    let mut expected: BTreeSet<u16> = FACES
        .iter()
        .map(|face| rgb565(by_hand(face.map(|i| turned[usize::from(i)]))))
        .collect();
    expected.insert(rgb565([0.01; 3]));
    let channels = |color: u16| [color >> 11, color >> 5 & 63, color & 31];
    let is_near = |a: u16, b: &u16| {
        channels(a)
            .iter()
            .zip(channels(*b))
            .all(|(a, b)| a.abs_diff(b) <= 1)
    };
    for color in colors {
        assert!(
            expected.iter().any(|other| is_near(color, other)),
            "{color:04x}"
        );
    }
    // the model fits into 122 × 122 pixels and covers between a third and two thirds of them
    let seen = pixels
        .iter()
        .filter(|&&color| color != rgb565([0.01; 3]))
        .count();
    assert!((5_000..10_000).contains(&seen), "{seen} pixels");
}

#[test]
fn one_triangle_is_where_it_should_be() {
    let corners = [[-0.5_f32, -0.5, 0.0], [0.5, -0.5, 0.0], [0.0, 0.5, 0.0]];
    let pixels = model(&corners.map(Vec3::from), &[[0, 1, 2]]);
    let color = rgb565(by_hand(corners.map(|corner| corner.map(f64::from))));
    assert_eq!(pixels[(64 * WIDTH + 80) as usize], color);
    // half of 61 × 61 pixels, give or take its boundary of about 200
    let seen = pixels.iter().filter(|&&pixel| pixel == color).count() as i32;
    assert!((seen - 61 * 61 / 2).abs() < 200, "{seen}");
}

#[test]
fn bad_models_are_harmless() {
    let nothing = model(&[], &[]);
    let corners = [[0.0, 0.0, 0.0], [0.5, 0.0, 0.0], [0.0, 0.5, 0.0]].map(Vec3::from);
    assert_eq!(
        model(&corners, &[[0, 1, 3], [7, 8, 9]]),
        nothing,
        "vertices that are not there"
    );
    assert_eq!(
        model(&corners, &[[0, 1, 1], [2, 2, 2]]),
        nothing,
        "triangles without an area"
    );
    assert_eq!(model(&corners, &[[0, 2, 1]]), nothing, "turned away");
    let wild = [f32::NAN, f32::INFINITY, f32::MAX].map(|x| Vec3::new(x, -x, x));
    let _ = model(&wild, &[[0, 1, 2], [2, 1, 0]]);
    // of a million triangles, those that fit in the memory are drawn
    let million = vec![[0, 1, 2]; 1_000_000];
    assert_eq!(model(&corners, &million), model(&corners, &[[0, 1, 2]]));
}

/// A display without pixels.
struct Nowhere;

impl OriginDimensions for Nowhere {
    fn size(&self) -> Size {
        Size::zero()
    }
}

impl DrawTarget for Nowhere {
    type Color = embedded_graphics::pixelcolor::Rgb565;
    type Error = core::convert::Infallible;
    fn draw_iter<I: IntoIterator<Item = embedded_graphics::Pixel<Self::Color>>>(
        &mut self,
        pixels: I,
    ) -> Result<(), Self::Error> {
        pixels.into_iter().for_each(drop);
        Ok(())
    }
}

#[test]
fn a_display_of_zero_size_is_harmless() {
    let Ok(()) = draw_bunny(&mut Nowhere, TURN);
}
