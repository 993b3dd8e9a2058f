//! Prints how many instructions a point light costs in Blinn–Phong, with attenuation: with an
//! integer and with a real m, and in fixed point with an integer m. Four points, each lit by four
//! lamps.
#![no_std]
#![no_main]

use core::hint::black_box;

use firmware::{AMBIENT, CAP, LAMPS, board, brass};
use shading::fixed::Fixed;
use shading::{Lobe, Real, UnitVec3, shade};

firmware::program!(
    point_light::<f32, _>(32),
    point_light::<f32, _>(32.0),
    point_light::<Fixed, _>(32)
);

fn point_light<T: Real, M: Lobe<T>>(m: M) -> u32 {
    let (material, i_a) = (brass(m), AMBIENT.map(T::of_f32));
    let lamps = LAMPS.map(|lamp| lamp.cast(T::of_f32));
    let calls = CAP.map(|n| {
        let (n, v) = (n.cast(T::of_f32), UnitVec3::Z);
        let (n, v, material) = (black_box(&n), black_box(&v), black_box(&material));
        let (i_a, lamps) = (black_box(&i_a), black_box(&lamps));
        board::instructions(|| {
            let lights = lamps.iter().map(|lamp| lamp.at(**n));
            black_box(&shade::blinn_phong(*n, *v, material, *i_a, lights));
        })
    });
    let lights = (CAP.len() * LAMPS.len()) as u32;
    (calls.iter().sum::<u32>() + lights / 2) / lights
}
