//! The reflected light.

use shading::{IncidentLight, Light, Material, Real, Rgb, Shaded, UnitVec3, shade};
use shading_proofs::{Given, Goal, Node, Term, Test, with};

use super::given::*;

/// A surface, the eye and the ambient light.
struct Scene {
    n: UnitVec3<Term>,
    v: UnitVec3<Term>,
    material: Material<Term, Term>,
    i_a: Rgb<Term>,
}

fn scene(given: Given, direction: fn(Given, &str) -> UnitVec3<Term>) -> Scene {
    let [n, v] = ["n", "v"].map(|name| direction(given, name));
    Scene {
        n,
        v,
        material: material(given),
        i_a: given.rgb("I_a"),
    }
}

impl Scene {
    /// One of the three models, each of which is proved apart.
    fn shade(&self, model: u32, lights: &[IncidentLight<Term>]) -> Shaded<Term> {
        let (material, lights) = (&self.material, lights.iter().copied());
        match model {
            0 => shade::lambert(self.n, material, self.i_a, lights),
            1 => shade::phong(self.n, self.v, material, self.i_a, lights),
            _ => shade::blinn_phong(self.n, self.v, material, self.i_a, lights),
        }
    }
}

/// No channel is negative or NaN, nor one of the total.
fn is_light(s: Shaded<Term>) -> Vec<Goal> {
    let colors = [s.ambient, s.diffuse, s.specular, s.total()];
    colors.map(|color| components(color, light())).concat()
}

fn lights(given: Given) -> [IncidentLight<Term>; 2] {
    ["l1", "l2"].map(|name| sun(given, given.unit(name)))
}

pub fn lit_by_suns(given: Given) -> Vec<Goal> {
    is_light(scene(given, Given::unit).shade(given.one_of(3), &lights(given)))
}

pub fn lit_by_a_lamp(given: Given) -> Vec<Goal> {
    let lamp = lamp(given, any_vector(given, "position"));
    is_light(scene(given, Given::unit).shade(2, &[lamp.at(any_vector(given, "p"))]))
}

/// The terms of a sum that is limited to MAX and multiplied by a reflectance, the last first.
fn added(channel: Term) -> Vec<Term> {
    with(|g| {
        let limit_of = |id: u32| match g.nodes[id as usize] {
            Node::Select(Test::Above(sum, 3), 3, _) => Some(sum),
            _ => None,
        };
        let Node::Mul(a, b) = g.nodes[channel.0 as usize] else {
            panic!("no product")
        };
        let mut sum = limit_of(a).or(limit_of(b)).expect("a limit");
        let mut terms = Vec::new();
        while let Node::Add(a, b) = g.nodes[sum as usize] {
            // the sum so far was recorded before the term
            terms.push(Term(a.max(b)));
            sum = a.min(b);
        }
        assert_eq!(sum, Term::ZERO.0, "the sum begins at 0");
        terms
    })
}

pub fn any_number_of_lights(given: Given) -> Vec<Goal> {
    let scene = scene(given, Given::unit);
    let lit = scene.shade(given.one_of(3), &lights(given));
    let mut terms = Vec::new();
    for channel in [lit.diffuse.r, lit.specular.r] {
        if channel.0 != Term::ZERO.0 {
            terms.extend(added(channel));
        }
    }
    within(terms, light())
}

/// A light that adds nothing, to the bit, before or after another.
fn adds_nothing(given: Given, scene: &Scene, light: IncidentLight<Term>) -> Vec<Goal> {
    let other = sun(given, any_direction(given, "other"));
    let lights = [[light, other], [other, light]][given.one_of(2) as usize];
    let model = given.one_of(3);
    let [with, without] = [&lights[..], &[other]].map(|lights| scene.shade(model, lights));
    let colors = |s: Shaded<Term>| [s.ambient, s.diffuse, s.specular, s.total()];
    let pairs = colors(with).into_iter().zip(colors(without));
    pairs.flat_map(|(a, b)| same(a, b)).collect()
}

pub fn behind(given: Given) -> Vec<Goal> {
    let scene = scene(given, any_direction);
    let l = any_direction(given, "l");
    if scene.n.dot(l) > Term::ZERO {
        return vec![];
    }
    adds_nothing(given, &scene, sun(given, l))
}

pub fn lamp_behind(given: Given) -> Vec<Goal> {
    let scene = scene(given, any_direction);
    let Some(spot) = spot(given, any_vector(given, "position")) else {
        return vec![];
    };
    let light = [Light::from(spot), Light::from(spot.point)][given.one_of(2) as usize];
    let light = light.at(any_vector(given, "p"));
    if light.is_in_front(scene.n) {
        return vec![];
    }
    adds_nothing(given, &scene, light)
}

pub fn black_light(given: Given) -> Vec<Goal> {
    let light = sun(given, given.unit("l")) * Rgb::BLACK;
    adds_nothing(given, &scene(given, Given::unit), light)
}

pub fn broken_lamp(given: Given) -> Vec<Goal> {
    let lamp = lamp(given, broken(given, "position"));
    let light = lamp.at(finite_vector(given, "p"));
    adds_nothing(given, &scene(given, Given::unit), light)
}

pub fn opposite(given: Given) -> Vec<Goal> {
    let scene = scene(given, Given::unit);
    let light = sun(given, -scene.v);
    black(scene.shade(2, &[light]).specular)
}

pub fn black_surface(given: Given) -> Vec<Goal> {
    let mut scene = scene(given, Given::unit);
    (scene.material.k_d, scene.material.k_s) = (Rgb::BLACK, Rgb::BLACK);
    let lit = scene.shade(given.one_of(3), &lights(given));
    [black(lit.diffuse), black(lit.specular)].concat()
}

fn at_most(a: Rgb<Term>, b: Rgb<Term>) -> Vec<Goal> {
    let pairs = [(a.r, b.r), (a.g, b.g), (a.b, b.b)];
    pairs.map(|(a, b)| Goal::AtMost(a, b)).into()
}

pub fn reflected_at_most(given: Given) -> Vec<Goal> {
    let scene = scene(given, Given::unit);
    let lit = scene.shade(given.one_of(3), &lights(given));
    let most = |k: Rgb<Term>| k * Term::MAX;
    let (k_d, k_s) = (scene.material.k_d, scene.material.k_s);
    [
        at_most(lit.diffuse, most(k_d)),
        at_most(lit.specular, most(k_s)),
    ]
    .concat()
}

pub fn highlight_at_most(given: Given) -> Vec<Goal> {
    let scene = scene(given, Given::unit);
    let light = sun(given, given.unit("l"));
    let lit = scene.shade(given.one_of(3), &[light]);
    at_most(lit.specular, light.intensity() * scene.material.k_s)
}
