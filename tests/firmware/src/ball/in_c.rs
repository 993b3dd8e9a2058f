//! The ball by the headers for C, which the build script compiles.

unsafe extern "C" {
    safe fn fixed_in_c(right: i16, up: i16) -> u16;
}

pub fn fixed(right: i16, up: i16) -> u16 {
    fixed_in_c(right, up)
}
