//! Each pixel in which the two pictures differ is explained.

use port::{after, before, seen, teapot};

/// The frames of the example's animation that are compared.
const FRAMES: [u16; 4] = [0, 150, 400, 777];

/// A highlight where R·V < 0 is the example's bug: `powf` of a negative cosine is positive for an even
/// exponent. Anywhere else, the last bits of the light may differ, and truncating it to a byte makes at
/// most one level of that.
#[test]
fn a_pixel_differs_by_the_highlight_behind_the_teapot_or_by_rounding() {
    let model = teapot().expect("the teapot");
    let (mut behind, mut rounded, mut drawn) = (0, 0, 0);
    for frame in FRAMES {
        let pictures = before(&model, frame).into_iter().zip(after(&model, frame));
        for ((before, after), cosine) in pictures.zip(seen(&model, frame)) {
            let Some(cosine) = cosine else {
                assert_eq!(before, after, "the background");
                continue;
            };
            drawn += 1;
            let levels = |pixel: u32| pixel.to_le_bytes().map(i32::from);
            let differences = [0, 1, 2, 3].map(|i| levels(before)[i] - levels(after)[i]);
            if cosine < 0.0 {
                // the highlight that is gone: up to 1 for a cosine of −1
                assert!(
                    differences.iter().all(|d| *d >= -1),
                    "{differences:?} at {cosine}"
                );
                behind += u32::from(before != after);
            } else {
                assert!(
                    differences.iter().all(|d| d.abs() <= 1),
                    "{differences:?} at {cosine}"
                );
                rounded += u32::from(before != after);
            }
        }
    }
    println!(
        "{drawn} pixels drawn: {behind} lost a highlight that R·V < 0 forbids, {rounded} differ by one level"
    );
    assert!(behind > 1000, "the bug is not seen");
    assert!(
        100 * rounded < drawn,
        "{rounded} of {drawn} differ by rounding"
    );
}

#[test]
fn the_page_shows_the_port() {
    let page = include_str!("../../../docs/porting.md");
    let ported = include_str!("../frag.rs").lines().skip(1);
    for line in ported.map(str::trim) {
        assert!(page.contains(line), "docs/porting.md lacks: {line}");
    }
}
