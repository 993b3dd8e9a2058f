//! The loops over colors, triangles and cosines by hand, with other crates and with the standard library.

use crate::race::{Pass, pass};
use crate::scene::List;
use glam::Vec3;

fn encoded(linear: f32) -> f32 {
    match linear.clamp(0.0, 1.0) {
        x if x <= 0.003_130_8 => 12.92 * x,
        x => 1.055 * x.powf(1.0 / 2.4) - 0.055,
    }
}

/// By `fast-srgb8`, and by the standard library's power.
pub fn encodings<const CALL: bool>(colors: &[List<f32>]) -> [Pass<'_>; 2] {
    let level = |channel: f32, highest: f32| (encoded(channel) * highest + 0.5) as u16;
    [
        pass::<CALL, _, _>(colors, 1, |c| c.map(fast_srgb8::f32_to_srgb8)),
        pass::<CALL, _, _>(colors, 1, move |&[r, g, b]| {
            level(r, 31.0) << 11 | level(g, 63.0) << 5 | level(b, 31.0)
        }),
    ]
}

/// On `glam`.
pub fn normals<const CALL: bool>(triangles: &[List<List<f32>>]) -> [Pass<'_>; 5] {
    macro_rules! normal {
        (|$a:ident, $b:ident, $c:ident| $normal:expr) => {
            pass::<CALL, _, _>(triangles, 1, |triangle| {
                let [$a, $b, $c] = triangle.map(Vec3::from);
                $normal.try_normalize().map(<[f32; 3]>::from)
            })
        };
    }
    let corner = pass::<CALL, _, _>(triangles, 1, |triangle| {
        let [a, b, c] = triangle.map(Vec3::from);
        let (e1, e2) = (b - a, c - a);
        let angle = (e1.dot(e2) / (e1.length() * e2.length())).acos();
        <[f32; 3]>::from(
            e1.cross(e2)
                .try_normalize()
                .map_or(Vec3::ZERO, |n| n * angle),
        )
    });
    [
        normal!(|a, _b, _c| a),
        normal!(|a, b, c| (b - a).cross(c - a)),
        corner,
        normal!(|a, _b, _c| {
            let from_axis = a.truncate().length();
            let ring = 2.0 * (from_axis - 2.0) / from_axis;
            Vec3::new(ring * a.x, ring * a.y, 2.0 * a.z)
        }),
        normal!(|a, _b, _c| Vec3::new(1.0, 0.0, 2.0 * a.x).cross(Vec3::new(0.0, 1.0, -2.0 * a.y))),
    ]
}
