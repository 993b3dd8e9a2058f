//! The `f32` functions that a shader would call. The unoptimized code is searched for doubles, even
//! in constants.
//!
//! This does not use the library of this package, which already contains generic functions compiled
//! for `f32`: the compiler would not compile them here again.
#![no_std]

use shading::f32::{Dual, Light, Material, Rgb, Shaded, UnitVec3, Vec3};
use shading::{Exponent, Real, normal, shade, term};

#[unsafe(no_mangle)]
pub fn pixel(
    p: Vec3,
    v: UnitVec3,
    [integer, real]: [&Material<u32>; 2],
    m: f32,
    lights: &[Light],
) -> Shaded {
    let n = normal::implicit(torus, p).unwrap_or(UnitVec3::Z);
    let corner = normal::corner(p, *n, *v);
    let at = || lights.iter().map(|light| light.at(p));
    let in_front = || lights.iter().filter_map(|light| light.in_front(p, n));
    let shininess = Material {
        k_a: real.k_a,
        k_d: real.k_d,
        k_s: real.k_s * (term::phong_normalization(m) + term::blinn_normalization(m)),
        m,
    };
    shade::lambert(corner.unit_or(n), integer, Rgb::WHITE, at())
        + shade::phong(n, v, integer, Rgb::WHITE, at())
        + shade::phong(n, v, &shininess, Rgb::WHITE, in_front())
        + shade::blinn_phong(n, v, integer, Rgb::WHITE, at())
        + shade::blinn_phong(n, v, &shininess, Rgb::WHITE, in_front())
            * (integer.m.raise(m) + m.raise(m) + promise(0.0))
}

fn torus(p: shading::Vec3<Dual>) -> Dual {
    let ring = (p.x * p.x + p.y * p.y).sqrt() - 2.0;
    ring * ring + p.z * p.z - Dual::of_f32(0.25)
}

/// See `broken.rs`.
fn promise(zero: f32) -> f32 {
    if cfg!(feature = "broken-doubles") {
        return (f64::from(zero) * 1.5) as f32;
    }
    zero
}
