//! The power of a cosine with a real m, on its own, in a default build.

use std::cell::RefCell;
use std::hint::black_box;

use shading::Exponent;

use crate::contest::{Contestant, Results};
use crate::scene::REAL_M;

/// Too many for the processor to memorize which branch a `powf` takes for each.
const COSINES: usize = 1 << 14;

pub fn contest() {
    let mut random = fastrand::Rng::with_seed(1977);
    let cosines: &Vec<f32> = &(0..COSINES).map(|_| random.f32()).collect();
    let ours = |cosine, m: f32| m.raise(cosine);

    println!("\nthe power alone, one by one:");
    let single = Results::of(
        "power",
        COSINES,
        vec![
            Contestant::new("ours", || one_by_one(cosines, ours)),
            Contestant::new("the C library's powf", || one_by_one(cosines, f32::powf)),
            Contestant::new("libm's powf", || one_by_one(cosines, libm::powf)),
        ],
    );
    single.ratio("power/c", "ours", "the C library's powf");
    single.ratio("power/libm", "ours", "libm's powf");

    println!("\nthe power alone, of a whole array:");
    let powers = RefCell::new(vec![0.0; COSINES]);
    let array = Results::of(
        "power",
        COSINES,
        vec![
            Contestant::new("ours", || all(cosines, &mut powers.borrow_mut(), ours)),
            Contestant::new("the C library's powf", || {
                all(cosines, &mut powers.borrow_mut(), f32::powf);
            }),
            Contestant::new("libm's powf", || {
                all(cosines, &mut powers.borrow_mut(), libm::powf);
            }),
        ],
    );
    array.ratio("powers/c", "ours", "the C library's powf");
    array.ratio("powers/libm", "ours", "libm's powf");
}

/// Each power is observed before the next is computed, so two are never computed in one
/// instruction.
#[inline]
fn one_by_one(cosines: &[f32], power: impl Fn(f32, f32) -> f32) {
    let m = black_box(REAL_M);
    for &cosine in black_box(cosines) {
        black_box(power(cosine, m));
    }
}

#[inline]
fn all(cosines: &[f32], powers: &mut [f32], power: impl Fn(f32, f32) -> f32) {
    let m = black_box(REAL_M);
    for (power_of_one, &cosine) in powers.iter_mut().zip(black_box(cosines)) {
        *power_of_one = power(cosine, m);
    }
    black_box(powers);
}
