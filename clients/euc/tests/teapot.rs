//! The picture agrees with the formula as the books write it, and bad triangles are harmless.

use rasterizer::{BRASS, EYE, LAMPS, Vertex, draw, vertices};
use vek::Vec3;

type Triple = [f64; 3];

fn dot(a: Triple, b: Triple) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn unit(a: Triple) -> Triple {
    let length = dot(a, a).sqrt();
    a.map(|c| c / length)
}

fn from(a: impl Into<Triple>, b: impl Into<Triple>) -> Triple {
    let (a, b) = (a.into(), b.into());
    std::array::from_fn(|i| b[i] - a[i])
}

/// The sum of Foley, van Dam et al. §16.1 in doubles, channel by channel.
fn by_hand(p: Triple, n: Triple) -> Triple {
    let v = unit(from(p, EYE.map(f64::from)));
    std::array::from_fn(|i| {
        let channel = |color: shading::Rgb<f32>| f64::from(<[f32; 3]>::from(color)[i]);
        let mut sum = channel(BRASS.k_a) * 0.15;
        for (lamp, [a, c]) in LAMPS.iter().zip([[0.6, 0.008], [1.0, 0.0]]) {
            let toward = from(p, <[f32; 3]>::from(lamp.position).map(f64::from));
            let (l, square) = (unit(toward), dot(toward, toward));
            let n_dot_l = dot(n, l);
            if n_dot_l > 0.0 {
                let h = unit(std::array::from_fn(|i| l[i] + v[i]));
                let highlight = dot(n, h).max(0.0).powi(28);
                let reflected = channel(BRASS.k_d) * n_dot_l + channel(BRASS.k_s) * highlight;
                sum += channel(lamp.intensity) / (a + c * square) * reflected;
            }
        }
        sum
    })
}

fn srgb(light: f64) -> f64 {
    let c = light.clamp(0.0, 1.0);
    255.0
        * if c <= 0.003_130_8 {
            12.92 * c
        } else {
            1.055 * c.powf(1.0 / 2.4) - 0.055
        }
}

/// One triangle fills the picture and faces the eye: its middle pixel shows the point that the camera looks at.
#[test]
fn a_fragment_has_the_formulas_color() {
    // around the point at which the camera looks, facing the eye
    let center = [0.2, 0.0, 1.4];
    let n = unit(from(center, EYE.map(f64::from)));
    let toward = n.map(|c| c as f32);
    let (n_vek, middle) = (Vec3::from(toward), Vec3::new(0.2_f32, 0.0, 1.4));
    let right = n_vek.cross(Vec3::unit_z()).normalized();
    let up = right.cross(n_vek);
    let corner = |x: f32, y: f32| (middle + right * x + up * y, n_vek);
    let triangle = [corner(-9.0, -9.0), corner(9.0, -9.0), corner(0.0, 9.0)];
    let turned = [triangle[0], triangle[2], triangle[1]];
    let both: Vec<Vertex> = triangle.into_iter().chain(turned).collect();
    let pixels = draw(&both, 101, 101);
    let middle = 3 * (50 * 101 + 50);
    for (byte, light) in pixels[middle..middle + 3].iter().zip(by_hand(center, n)) {
        // half a level of rounding, and half a pixel of offset
        assert!(
            (f64::from(*byte) - srgb(light)).abs() < 1.0,
            "{byte}, by hand {}",
            srgb(light)
        );
    }
}

/// The share of the picture that the teapot covers, and its mean color: brass, lit from the right by a warm
/// lamp and from the left by a blue one. Without the highlight, or with twice the ambient part, the mean of red
/// moves by 7: both were tried.
#[test]
fn the_picture_has_its_statistics() {
    let pixels = draw(&vertices(), 320, 240);
    let seen: Vec<&[u8]> = pixels
        .chunks(3)
        .filter(|pixel| *pixel != [0x20, 0x24, 0x28])
        .collect();
    // computed by hand at the vertices that face the eye, each weighted by the visible area of its triangles
    let (mut area, mut sum) = (0.0, [0.0; 3]);
    for corners in vertices().chunks(3) {
        let [a, b, c] = [0, 1, 2].map(|i| corners[i].0.map(f64::from));
        let p = (a + b + c) / 3.0;
        let cross = (b - a).cross(c - a) * 0.5;
        let to_eye = Vec3::from(EYE.map(f64::from)) - p;
        let n = corners
            .iter()
            .fold(Vec3::zero(), |sum, corner| sum + corner.1.map(f64::from));
        // over the square of the distance: as large as the eye sees it
        let share = cross.dot(to_eye).abs() / to_eye.magnitude().powi(3);
        if n.dot(to_eye) > 0.0 && share > 0.0 {
            let light = by_hand(p.into_array(), unit(n.into_array()));
            area += share;
            (0..3).for_each(|i| sum[i] += share * srgb(light[i]));
        }
    }
    // the sum by hand includes what the pot hides of its handle, spout and rim; the picture does not
    for i in 0..3 {
        let mean = seen.iter().map(|pixel| f64::from(pixel[i])).sum::<f64>() / seen.len() as f64;
        assert!(
            (mean - sum[i] / area).abs() < 4.0,
            "channel {i}: {mean}, by hand {}",
            sum[i] / area
        );
    }
}

#[test]
fn bad_triangles_and_windows_are_harmless() {
    assert!(draw(&vertices(), 0, 40).is_empty() && draw(&vertices(), 40, 0).is_empty());
    let background = draw(&[], 40, 30);
    assert_eq!(background.len(), 3 * 40 * 30);
    let point = (Vec3::new(0.2, 0.0, 1.4), Vec3::zero());
    assert_eq!(
        draw(&[point; 3], 40, 30),
        background,
        "a triangle without an area"
    );
    // without normals
    let bare: Vec<Vertex> = vertices()
        .into_iter()
        .map(|(p, _)| (p, Vec3::zero()))
        .collect();
    assert_ne!(draw(&bare, 40, 30), background);
}
