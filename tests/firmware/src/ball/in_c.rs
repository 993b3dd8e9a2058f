//! The ball by the headers for C, which the build script compiles. The picture in single precision is
//! encoded by the crate.

use shading::f32::Rgb;

unsafe extern "C" {
    safe fn fixed_in_c(right: i16, up: i16) -> u16;
    safe fn f32_in_c(right: i16, up: i16, color: &mut [f32; 3]);
}

pub fn fixed(right: i16, up: i16) -> u16 {
    fixed_in_c(right, up)
}

pub fn f32(right: i16, up: i16) -> u16 {
    let mut color = [0.0; 3];
    f32_in_c(right, up, &mut color);
    let [r, g, b] = color;
    Rgb::new(r, g, b).to_rgb565()
}
