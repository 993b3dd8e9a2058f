//! The ball without the crate.

use super::scene::{AMBIENT, FALLOFF, INTENSITY, K_A, K_D, K_S, LAMP};

/// The sRGB encoding of k/64, in 32768ths.
static ENCODED: [u16; 65] = {
    let (mut table, mut k) = ([0; 65], 1);
    while k <= 64 {
        // Newton's method for x¹² = light⁵
        let light = k as f64 / 64.0;
        let (mut x, mut i) = (1.0, 0);
        while i < 20 {
            let x_5 = x * x * x * x * x;
            x = (11.0 * x + light * light * light * light * light / (x_5 * x_5 * x)) / 12.0;
            i += 1;
        }
        table[k] = (32768.0 * (1.055 * x - 0.055) + 0.5) as u16;
        k += 1;
    }
    table
};

/// The encoding of a channel with 16 bits after the point, rounded to a number of levels, by straight lines.
#[inline(always)]
fn level(light: u32, highest: u32) -> u16 {
    let light = light.min(65535);
    let (k, part) = ((light >> 10) as usize, light & 1023);
    let (below, above) = (u32::from(ENCODED[k]), u32::from(ENCODED[k + 1]));
    let encoded = (below << 10) + (above - below) * part; // 25 bits after the point
    ((((encoded >> 10) * highest) + (1 << 14)) >> 15) as u16
}

pub fn with_libm(right: i16, up: i16) -> u16 {
    single(right, up, libm::sqrtf, |v| {
        let length = libm::sqrtf(dot(v, v));
        (scaled(v, 1.0 / length), length)
    })
}

pub fn with_micromath(right: i16, up: i16) -> u16 {
    use micromath::F32Ext;
    single(right, up, F32Ext::sqrt, |v| {
        let square = dot(v, v);
        let reciprocal = F32Ext::invsqrt(square);
        (scaled(v, reciprocal), square * reciprocal)
    })
}

fn dot([a, b, c]: [f32; 3], [x, y, z]: [f32; 3]) -> f32 {
    a * x + b * y + c * z
}

fn scaled([x, y, z]: [f32; 3], factor: f32) -> [f32; 3] {
    [x * factor, y * factor, z * factor]
}

/// `unit` gives the direction and the length of a vector.
#[inline(always)]
fn single(
    right: i16,
    up: i16,
    root: impl Fn(f32) -> f32,
    unit: impl Fn([f32; 3]) -> ([f32; 3], f32),
) -> u16 {
    let (x, y) = (
        f32::from(right) * (1.0 / 120.0),
        f32::from(up) * (1.0 / 120.0),
    );
    let z = root(1.0 - x * x - y * y);
    let (n, _) = unit([x, y, z]);
    let [lamp_x, lamp_y, lamp_z] = LAMP.map(|x| x as f32);
    let (l, q) = unit([lamp_x - x, lamp_y - y, lamp_z - z]);
    let n_dot_l = dot(n, l);
    let (mut diffuse, mut highlight) = (0.0, 0.0);
    if n_dot_l > 0.0 {
        let [a, _, c] = FALLOFF.map(|x| x as f32);
        let factor = 1.0 / (a + c * q * q);
        let (h, _) = unit([l[0], l[1], l[2] + 1.0]);
        let n_dot_h = dot(n, h);
        if n_dot_h > 0.0 {
            let to_4 = n_dot_h * n_dot_h * n_dot_h * n_dot_h;
            let to_8 = to_4 * to_4;
            highlight = factor * (to_8 * to_8 * to_8 * to_4);
        }
        diffuse = factor * n_dot_l;
    }
    let channel = |i: usize| {
        let [k_d, k_s, intensity] = [K_D[i] as f32, K_S[i] as f32, INTENSITY[i] as f32];
        let light = (K_A * AMBIENT) as f32 + intensity * (k_d * diffuse + k_s * highlight);
        (light * 65536.0) as u32
    };
    level(channel(0), 31) << 11 | level(channel(1), 63) << 5 | level(channel(2), 31)
}

pub mod fixed {
    use fixed::types::I16F16;

    use super::super::scene::{AMBIENT, FALLOFF, INTENSITY, K_A, K_D, K_S, LAMP};
    use super::level;

    const fn x(literal: f64) -> I16F16 {
        I16F16::from_bits((literal * 65536.0 + 0.5) as i32)
    }

    const ONE: I16F16 = I16F16::ONE;

    fn dot([a, b, c]: [I16F16; 3], [x, y, z]: [I16F16; 3]) -> I16F16 {
        a * x + b * y + c * z
    }

    fn unit(v: [I16F16; 3]) -> ([I16F16; 3], I16F16) {
        let length = dot(v, v).sqrt();
        let reciprocal = ONE / length;
        (v.map(|x| x * reciprocal), length)
    }

    pub fn pixel(right: i16, up: i16) -> u16 {
        let coordinate = |pixels: i16| I16F16::from_bits((i32::from(pixels) * 69_905) >> 7);
        let (px, py) = (coordinate(right), coordinate(up));
        let z_squared = ONE - px * px - py * py;
        let pz = if z_squared > 0 {
            z_squared.sqrt()
        } else {
            I16F16::ZERO
        };
        let (n, _) = unit([px, py, pz]);
        let (l, q) = unit([x(LAMP[0]) - px, x(LAMP[1]) - py, x(LAMP[2]) - pz]);
        let n_dot_l = dot(n, l);
        let (mut diffuse, mut highlight) = (I16F16::ZERO, I16F16::ZERO);
        if n_dot_l > 0 {
            let factor = ONE / (x(FALLOFF[0]) + x(FALLOFF[2]) * q * q);
            let (h, _) = unit([l[0], l[1], l[2] + ONE]);
            let n_dot_h = dot(n, h);
            if n_dot_h > 0 {
                let to_2 = n_dot_h * n_dot_h;
                let to_4 = to_2 * to_2;
                let to_8 = to_4 * to_4;
                highlight = factor * (to_8 * to_8 * to_8 * to_4);
            }
            diffuse = factor * n_dot_l;
        }
        let channel = |i: usize| {
            let [k_d, k_s, intensity] = [x(K_D[i]), x(K_S[i]), x(INTENSITY[i])];
            let light = x(K_A * AMBIENT) + intensity * (k_d * diffuse + k_s * highlight);
            light.to_bits() as u32
        };
        level(channel(0), 31) << 11 | level(channel(1), 63) << 5 | level(channel(2), 31)
    }
}
