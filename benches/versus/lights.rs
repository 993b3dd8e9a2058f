//! One point at a time, and its lights in lanes.

use shading::{Exponent, Lanes, Material, PointLight, Vec3, shade};
use wide::{f32x4, f32x8};

use crate::by_hand::Glam;
use crate::contest::{Contestant, Results, agree};
use crate::ours::Ours;
use crate::scene::{LIGHTS, POINTS, REAL_M, Scene, WHOLE_M};

const SCENES: u64 = 16;

pub fn contest() {
    race::<f32x4>(4);
    race::<f32x8>(8);
    race::<f32x8>(32);
}

/// With `L` for the lanes.
fn race<L: Lanes<Lane = f32>>(lights: usize)
where
    f32: Exponent<L>,
{
    let scenes = (1..=SCENES).map(|seed| Scene::lit_by(lights, seed));
    let scenes: Vec<_> = scenes.collect();
    let scalar = |scene| Ours::<f32, _>::new(scene, REAL_M, gather);
    let mut scalar: Vec<_> = scenes.iter().map(scalar).collect();
    let real = |scene| Packed::<L, _>::new(scene, REAL_M);
    let mut real: Vec<_> = scenes.iter().map(real).collect();
    let whole = |scene| Packed::<L, _>::new(scene, WHOLE_M);
    let mut whole: Vec<_> = scenes.iter().map(whole).collect();
    let powf = |scene| Glam::new(scene, REAL_M);
    let mut powf: Vec<_> = scenes.iter().map(powf).collect();
    let powi = |scene| Glam::new(scene, WHOLE_M.cast_signed());
    let mut powi: Vec<_> = scenes.iter().map(powi).collect();

    let (build, suffix) = if cfg!(feature = "native") {
        ("with -C target-cpu=native", "-native")
    } else {
        ("in a default build", "")
    };
    println!("\n{lights} lights in {} lanes, {build}:", L::COUNT);
    let results = Results::of(
        "point and light",
        POINTS * LIGHTS,
        vec![
            Contestant::in_turn("ours in lanes, real m", &mut real, Packed::shade),
            Contestant::in_turn("ours in lanes, integer m", &mut whole, Packed::shade),
            Contestant::in_turn("ours one by one, real m", &mut scalar, Ours::shade),
            Contestant::in_turn("glam, powf", &mut powf, |scene| scene.shade(f32::powf)),
            Contestant::in_turn("glam, powi", &mut powi, |scene| scene.shade(f32::powi)),
        ],
    );
    let ratio = |case, ours, theirs| {
        let case = format!("{lights}-lights-{case}{suffix}");
        results.ratio(&case, ours, theirs);
    };
    let (real_m, integer_m) = ("ours in lanes, real m", "ours in lanes, integer m");
    ratio("real/glam", real_m, "glam, powf");
    ratio("whole/glam", integer_m, "glam, powi");
    ratio("real/one-by-one", real_m, "ours one by one, real m");

    for i in 0..scenes.len() {
        let rgb = |image: &[shading::Rgb<f32>]| image.iter().map(|&c| c.into()).collect::<Vec<_>>();
        let glam =
            |image: &[glam::Vec3]| image.iter().map(glam::Vec3::to_array).collect::<Vec<_>>();
        let [real, whole] = [&real[i].scalar.image, &whole[i].scalar.image].map(|image| rgb(image));
        agree("glam", lights, real, glam(&powf[i].image));
        agree("glam", lights, whole, glam(&powi[i].image));
    }
}

fn gather(all: &[[f32; 3]]) -> Vec<Vec3<f32>> {
    all.iter().copied().map(Vec3::from).collect()
}

fn splat<L: Lanes<Lane = f32>>(x: f32) -> L {
    L::from_fn(|_| x)
}

/// A scene with the lights and the material in lanes too.
struct Packed<L, M> {
    scalar: Ours<f32, M>,
    packs: Vec<PointLight<L>>,
    material: Material<L, M>,
}

impl<L: Lanes<Lane = f32>, M: Exponent<L> + Exponent<f32>> Packed<L, M> {
    fn new(scene: &Scene, m: M) -> Self {
        let scalar = Ours::new(scene, m, gather);
        Self {
            packs: PointLight::packed(&scalar.lights).collect(),
            material: scalar.material.cast(splat),
            scalar,
        }
    }

    #[inline(never)]
    fn shade(&mut self) {
        let (packs, material) = (&self.packs, &self.material);
        self.scalar.each(|scene, p, n, v| {
            let (p, n, v) = (p.map(splat), n.cast(splat), v.cast(splat));
            let lit = packs.iter().filter_map(|pack| pack.in_front(p, n));
            let i_a = scene.ambient.map(splat);
            shade::blinn_phong(n, v, material, i_a, lit).sum_of_lanes()
        });
    }
}
