//! The example that loads a scene, shades a point in it and fills a uniform buffer.

#[allow(dead_code)] // its `main`
#[path = "../examples/scene_file.rs"]
mod client;

use client::{Scene, shaded, uniform_buffer};
use shading::f32::{UnitVec3, Vec3};

fn scene() -> Scene {
    serde_json::from_str(include_str!("../scenes/lamps.json")).unwrap()
}

#[test]
fn glue_takes_less_than_15_lines() {
    let source = include_str!("../examples/scene_file.rs");
    let pieces = source.split("// glue:").skip(1);
    let glue = pieces.map(|piece| piece.split_once("// end of glue").unwrap().0);
    let lines = glue
        .flat_map(str::lines)
        .filter(|line| !line.trim().is_empty());
    let count = lines.count();
    assert!((1..15).contains(&count), "{count} lines");
}

/// From above, N = V = Y at the origin:
///
/// ```text
/// sun    N·L = 0.6, (N·H)² = (1 + 0.6)/2 = 0.8, (N·H)³² = 0.8¹⁶ = 0.02814750
/// lamp   in the plane of the floor: nothing
/// spot   right above, q = 3: 4 min(1, 1/9) = 0.4444444; N·L = N·H = 1
/// red    0.1·0.1 + 0.6 (0.6 + 0.4444444) + 0.3 (0.02814750 + 0.4444444) = 0.7784442
/// green  the sun has 0.95: 0.1·0.1 + 0.6 (0.57 + 0.4444444) + 0.3 (0.02674012 + 0.4444444) = 0.7600220
/// blue   the sun has 0.9, I_a 0.12: 0.012 + 0.6 (0.54 + 0.4444444) + 0.3 (0.02533275 + 0.4444444) = 0.7435998
/// ```
#[test]
fn scene_is_shaded() {
    let light: [f32; 3] = shaded(&scene(), Vec3::ZERO, UnitVec3::Y, UnitVec3::Y).into();
    for (channel, expected) in light.into_iter().zip([0.778_444_2, 0.760_022, 0.743_599_8]) {
        // about ten roundings of numbers below 1, and those of the values above
        assert!((channel - expected).abs() < 1e-6, "{light:?}");
    }
}

#[test]
fn buffer_holds_the_rows_that_the_shader_reads() {
    let expected: [[f32; 4]; 15] = [
        [0.1, 0.1, 0.1, 32.0],
        [0.6, 0.6, 0.6, 32.0],
        [0.3, 0.3, 0.3, 32.0],
        // the sun
        [0.0, 0.6, 0.8, 0.0],
        [1.0, 0.95, 0.9, 0.0],
        [0.0; 4],
        [0.0; 4],
        // the lamp
        [2.0, 0.0, 2.0, 1.0],
        [1.0, 0.8, 0.6, 0.0],
        [1.0, 0.0, 0.25, 0.0],
        [0.0; 4],
        // the spot
        [0.0, 3.0, 0.0, 1.0],
        [4.0, 4.0, 4.0, 0.0],
        [0.0, 0.0, 1.0, 1.0],
        [0.0, -1.0, 0.0, 0.877_582_56], // cos 0.5
    ];
    let bytes = uniform_buffer(&scene());
    let numbers = bytes.as_chunks().0.iter().copied().map(f32::from_ne_bytes);
    assert!(numbers.eq(expected.into_iter().flatten()), "{bytes:?}");
}
