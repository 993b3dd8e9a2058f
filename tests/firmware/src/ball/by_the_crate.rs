//! The ball as the guide for embedded use draws it.

use shading::fixed::Fixed;

/// The program in a number type: `$of` makes its constants of literals, `$coordinate` divides whole
/// pixels by the radius, and `$encode` makes RGB565 of light.
macro_rules! ball {
    ($name:ident, $types:ident, $number:ty, $of:expr, $coordinate:expr, $encode:expr) => {
        pub mod $name {
            use shading::$types::{Attenuation, Material, PointLight, Rgb, UnitVec3, Vec3};
            use shading::{Real, shade};

            use super::*;
            use crate::ball::scene::{AMBIENT, FALLOFF, INTENSITY, K_A, K_D, K_S, LAMP, M};

            const fn color([r, g, b]: [f64; 3]) -> Rgb {
                Rgb::new($of(r), $of(g), $of(b))
            }

            const A_B_C: [$number; 3] = [$of(FALLOFF[0]), $of(FALLOFF[1]), $of(FALLOFF[2])];

            static LIGHT: PointLight = PointLight {
                position: Vec3::new($of(LAMP[0]), $of(LAMP[1]), $of(LAMP[2])),
                intensity: color(INTENSITY),
                attenuation: Attenuation::const_new(A_B_C[0], A_B_C[1], A_B_C[2]).unwrap(),
            };

            static BRASS: Material = Material {
                k_a: color([K_A; 3]),
                k_d: color(K_D),
                k_s: color(K_S),
                m: M,
            };

            pub fn pixel(right: i16, up: i16) -> u16 {
                let (x, y): ($number, $number) = ($coordinate(right), $coordinate(up));
                let z = Real::sqrt(<$number>::ONE - x * x - y * y);
                let p = Vec3::new(x, y, z);
                let Some(n) = p.unit() else { return 0 };
                const I_A: Rgb = color([AMBIENT; 3]);
                let shaded = shade::blinn_phong(n, UnitVec3::Z, &BRASS, I_A, [LIGHT.at(p)]);
                $encode(shaded.total())
            }
        }
    };
}

const fn single(literal: f64) -> f32 {
    literal as f32
}

const fn double(literal: f64) -> f64 {
    literal
}

fn single_coordinate(pixels: i16) -> f32 {
    f32::from(pixels) * (1.0 / 120.0)
}

fn double_coordinate(pixels: i16) -> f64 {
    f64::from(pixels) / 120.0
}

fn fixed_coordinate(pixels: i16) -> Fixed {
    Fixed::from_bits((i32::from(pixels) * 69_905) >> 7)
}

fn rounded(light: shading::Rgb<f64>) -> u16 {
    light.map(|x| x as f32).to_rgb565()
}

ball!(in_f32, f32, f32, single, single_coordinate, Rgb::to_rgb565);
ball!(in_f64, f64, f64, double, double_coordinate, rounded);
ball!(
    in_fixed,
    fixed,
    Fixed,
    Fixed::new,
    fixed_coordinate,
    Rgb::to_rgb565
);
