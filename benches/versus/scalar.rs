//! One point at a time, in a default build.

use std::hint::black_box;

use shading::Vec3;

use crate::by_hand::Glam;
#[cfg(c_peers)]
use crate::c;
use crate::contest::{Contestant, Results, agree};
use crate::ours::Ours;
use crate::scene::{REAL_M, Scene, WHOLE_M};

pub fn contest() {
    let scene = &Scene::new();
    let gather = |all: &[[f32; 3]]| all.iter().copied().map(Vec3::from).collect();
    let mut real = Ours::new(scene, REAL_M, gather);
    let mut whole = Ours::new(scene, WHOLE_M, gather);
    let mut powf = Glam::new(scene, REAL_M);
    let mut powi = Glam::new(scene, WHOLE_M.cast_signed());
    #[cfg(c_peers)]
    let mut c = c::Scalar::new(scene);

    println!("one by one, in a default build:");
    let results = Results::of(vec![
        Contestant::new("ours, real m", || black_box(&mut real).shade()),
        Contestant::new("ours, whole m", || black_box(&mut whole).shade()),
        Contestant::new("glam, powf", || black_box(&mut powf).shade(f32::powf)),
        Contestant::new("glam, powi", || black_box(&mut powi).shade(f32::powi)),
        #[cfg(c_peers)]
        Contestant::new("C -O2, powf", || black_box(&mut c).shade()),
    ]);
    results.ratio("scalar-real/glam", "ours, real m", "glam, powf");
    results.ratio("scalar-whole/glam", "ours, whole m", "glam, powi");
    results.ratio("scalar-real/c", "ours, real m", "C -O2, powf");

    let image = |image: &[shading::Rgb<f32>]| image.iter().map(|&c| c.into()).collect::<Vec<_>>();
    agree(
        "glam",
        image(&real.image),
        powf.image.iter().map(glam::Vec3::to_array),
    );
    agree(
        "glam",
        image(&whole.image),
        powi.image.iter().map(glam::Vec3::to_array),
    );
    #[cfg(c_peers)]
    agree("C", image(&real.image), c.image);
}
