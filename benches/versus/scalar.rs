//! One point at a time, in a default build.

use shading::Vec3;

use crate::by_hand::Glam;
#[cfg(c_peers)]
use crate::c;
use crate::contest::{Contestant, Results, agree};
use crate::ours::Ours;
use crate::scene::{LIGHTS, POINTS, REAL_M, Scene, WHOLE_M};

const SCENES: u64 = 16;

pub fn contest() {
    let scenes: Vec<_> = (1..=SCENES).map(Scene::new).collect();
    let gather = |all: &[[f32; 3]]| all.iter().copied().map(Vec3::from).collect();
    let mut real: Vec<_> = scenes
        .iter()
        .map(|s| Ours::new(s, REAL_M, gather))
        .collect();
    let mut whole: Vec<_> = scenes
        .iter()
        .map(|s| Ours::new(s, WHOLE_M, gather))
        .collect();
    let mut powf: Vec<_> = scenes.iter().map(|s| Glam::new(s, REAL_M)).collect();
    let mut powi: Vec<_> = scenes
        .iter()
        .map(|s| Glam::new(s, WHOLE_M.cast_signed()))
        .collect();
    #[cfg(c_peers)]
    let mut c: Vec<_> = scenes.iter().map(c::Scalar::new).collect();

    println!("one by one, in a default build:");
    let results = Results::of(
        "point and light",
        POINTS * LIGHTS,
        vec![
            Contestant::in_turn("ours, real m", &mut real, Ours::shade),
            Contestant::in_turn("ours, integer m", &mut whole, Ours::shade),
            Contestant::in_turn("glam, powf", &mut powf, |scene| scene.shade(f32::powf)),
            Contestant::in_turn("glam, powi", &mut powi, |scene| scene.shade(f32::powi)),
            #[cfg(c_peers)]
            Contestant::in_turn("C -O2, powf", &mut c, c::Scalar::shade),
        ],
    );
    results.ratio("scalar-real/glam", "ours, real m", "glam, powf");
    results.ratio("scalar-whole/glam", "ours, integer m", "glam, powi");
    results.ratio("scalar-real/c", "ours, real m", "C -O2, powf");

    for i in 0..scenes.len() {
        let rgb = |image: &[shading::Rgb<f32>]| image.iter().map(|&c| c.into()).collect::<Vec<_>>();
        let glam =
            |image: &[glam::Vec3]| image.iter().map(glam::Vec3::to_array).collect::<Vec<_>>();
        agree("glam", LIGHTS, rgb(&real[i].image), glam(&powf[i].image));
        agree("glam", LIGHTS, rgb(&whole[i].image), glam(&powi[i].image));
        #[cfg(c_peers)]
        agree("C", LIGHTS, rgb(&real[i].image), c[i].image.iter().copied());
    }
}
