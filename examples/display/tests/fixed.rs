//! The picture in fixed point is the picture in floating point, but for a few colors by one level.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::duplicate_mod,
    reason = "the pixels are few, and one file draws in both number types"
)]

use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use embedded_graphics::prelude::{Point, PointsIter, Size};
use embedded_graphics::primitives::Rectangle;
use embedded_graphics_simulator::SimulatorDisplay;

#[path = "../src"]
mod float {
    pub mod ball;
    #[path = "float.rs"]
    mod number;
}

#[path = "../src"]
mod fixed {
    pub mod ball;
    #[path = "fixed.rs"]
    mod number;
}

/// Of 245,760 pixels, so many differ: fewer than one in a thousand, as docs/embedded.md says. The count is
/// exact, because the bits are those of every machine.
const DIFFERENT: usize = 153;

#[test]
fn pixels_differ_by_one_level() {
    let size = Size::new(160, 128);
    let mut turns = (float::ball::Turn::NONE, fixed::ball::Turn::NONE);
    let mut different = 0;
    for frame in 0..12 {
        let mut displays = [size; 2].map(SimulatorDisplay::<Rgb565>::new);
        let Ok(()) = float::ball::draw(&mut displays[0], turns.0);
        let Ok(()) = fixed::ball::draw(&mut displays[1], turns.1);
        turns = (turns.0.next(), turns.1.next());

        for at in Rectangle::new(Point::zero(), size).points() {
            let [a, b] = displays.each_ref().map(|display| display.get_pixel(at));
            let levels = |color: Rgb565| [color.r(), color.g(), color.b()];
            let is_near = |(a, b): (u8, u8)| a.abs_diff(b) <= 1;
            assert!(
                levels(a).into_iter().zip(levels(b)).all(is_near),
                "frame {frame}, {at}: {a:?}, {b:?}"
            );
            different += usize::from(a != b);
        }
    }
    assert_eq!(different, DIFFERENT);
}
