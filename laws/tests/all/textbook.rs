//! The formulas that bound a renderer's error.

use shading_laws::{Profile, compared};

/// `shading` and the textbook agree, and the bounds are tight: all but 6 % are below 10⁻¹²
/// of the color in `f64`. The others are of faint highlights, of lights on an edge and of lamps close by.
#[test]
fn the_textbook_gives_the_color_of_shading() {
    let precise = Profile {
        roundoff: f64::EPSILON / 2.0,
        ..Profile::default()
    };
    let of_its_own = Profile {
        attenuated_ambient: true,
        unattenuated_highlight: true,
        highlight_on_the_dark_side: true,
        normal_faces_eye: true,
        spot_exponent: 2.5,
        ambient_times_diffuse: true,
        ..precise.clone()
    };
    let unlit = Profile {
        unlit_without_lights: true,
        ..precise.clone()
    };
    for profile in [precise, of_its_own, unlit] {
        let mut loose = 0;
        for seed in 0..2000 {
            let (scene, textbook, shading) = compared(&profile, seed);
            for ([value, error], right) in textbook.into_iter().zip(shading) {
                let off = (value - right).abs();
                assert!(off <= error, "{value} ± {error} is not {right} in\n{scene}");
                loose += u32::from(error > 1e-12 * right);
            }
        }
        assert!(loose < 360, "{loose} of 6000 bounds are loose");
    }
}
