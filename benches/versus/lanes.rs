//! Many points at a time, in a build for the processor of this machine.

use std::hint::black_box;

use shading::{Real, Vec3};
use wide::f32x8;

#[cfg(c_peers)]
use crate::c;
use crate::contest::{Contestant, Results, agree};
use crate::ours::Ours;
use crate::scene::{LIGHTS, POINTS, REAL_M, Scene, WHOLE_M};
use crate::wide::Wide;

/// As many lanes as this processor has; a C compiler uses as many.
#[cfg(target_feature = "avx512f")]
pub type Lanes = wide::f32x16;
#[cfg(not(target_feature = "avx512f"))]
pub type Lanes = f32x8;
pub const COUNT: usize = size_of::<Lanes>() / size_of::<f32>();

/// Packs `N` points at a time into lanes.
fn gather<T: Real + From<[f32; N]>, const N: usize>(all: &[[f32; 3]]) -> Vec<Vec3<T>> {
    let lanes = |points: &[[f32; 3]], k: usize| std::array::from_fn(|i| points[i][k]).into();
    all.chunks_exact(N)
        .map(|points| Vec3::new(lanes(points, 0), lanes(points, 1), lanes(points, 2)))
        .collect()
}

pub fn contest() {
    let scene = &Scene::new(1975);
    let mut eight = Ours::new(scene, REAL_M, gather::<f32x8, 8>);
    let mut real = Ours::new(scene, REAL_M, gather::<Lanes, COUNT>);
    let mut whole = Ours::new(scene, WHOLE_M, gather::<Lanes, COUNT>);
    let mut by_hand = Wide::new(scene);
    #[cfg(c_peers)]
    let mut c = c::Lanes::new(scene);

    println!("\nin SIMD lanes, {COUNT} unless stated otherwise, with -C target-cpu=native:");
    let results = Results::of(
        "point and light",
        POINTS * LIGHTS,
        vec![
            Contestant::new("ours, real m, 8 lanes", || {
                black_box(&mut eight).shade_lanes();
            }),
            Contestant::new("ours, real m", || black_box(&mut real).shade_lanes()),
            Contestant::new("ours, integer m", || black_box(&mut whole).shade_lanes()),
            Contestant::new("wide by hand, powf", || black_box(&mut by_hand).shade()),
            #[cfg(c_peers)]
            Contestant::new("C -Ofast -march=native", || black_box(&mut c).shade()),
        ],
    );
    results.ratio(
        "lanes-real/c-native",
        "ours, real m",
        "C -Ofast -march=native",
    );
    results.ratio(
        "lanes-whole/c-native",
        "ours, integer m",
        "C -Ofast -march=native",
    );
    results.ratio("lanes-real/wide", "ours, real m", "wide by hand, powf");

    let points = |[r, g, b]: [Lanes; 3]| {
        let [r, g, b] = [r, g, b].map(Lanes::to_array);
        (0..COUNT).map(move |i| [r[i], g[i], b[i]])
    };
    let ours = || real.image.iter().flat_map(|&color| points(color.into()));
    agree(
        "wide by hand",
        LIGHTS,
        ours(),
        by_hand.image.iter().copied().flat_map(points),
    );
    #[cfg(c_peers)]
    agree(
        "C",
        LIGHTS,
        ours(),
        (0..POINTS).map(|i| c.image.each_ref().map(|channel| channel[i])),
    );
}
