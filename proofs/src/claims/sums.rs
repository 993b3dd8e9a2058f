//! The reflected light.

use shading::{IncidentLight, Light, Real, Rgb, Shaded};
use shading_proofs::{Given, Goal, Node, Term, Test, with};

use super::given::*;

/// No channel is negative or NaN, nor one of the total.
fn is_light(s: Shaded<Term>) -> Vec<Goal> {
    let colors = [s.ambient, s.diffuse, s.specular, s.total()];
    colors.map(|color| components(color, light())).concat()
}

pub fn lit_by_any(given: Given) -> Vec<Goal> {
    let (scene, model) = (any_scene(given), given.one_of(3));
    any_arrival(given).map_or(vec![], |light| is_light(scene.shade(model, &[light])))
}

/// The terms of a sum that is limited to MAX and multiplied by a reflectance, the last first.
fn added(channel: Term) -> Vec<Term> {
    with(|g| {
        let Node::Mul(a, b) = g.nodes[channel.0 as usize] else {
            panic!("no product")
        };
        let limit_of = |id: u32| match g.nodes[id as usize] {
            Node::Select(Test::Above(3, sum), then, 3) if then == sum => Some(sum),
            _ => (id == Term::ZERO.0).then_some(id), // the sum over no light
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
    let (scene, model) = (any_scene(given), given.one_of(3));
    let first = sun(given, "first").into();
    let Some(second) = any_arrival(given) else {
        return vec![];
    };
    let lit = scene.shade(model, &[first, second]);
    let channels = [lit.diffuse.r, lit.specular.r].into_iter();
    let channels = channels.filter(|channel| channel.0 != Term::ZERO.0);
    within(channels.flat_map(added), light())
}

pub fn one_more_light(given: Given) -> Vec<Goal> {
    let (scene, model) = (any_scene(given), given.one_of(3));
    let first = sun(given, "first").into();
    let Some(light) = any_arrival(given) else {
        return vec![];
    };
    let [one, two] = [&[first][..], &[first, light]].map(|lights| scene.shade(model, lights));
    let parts = |s: Shaded<Term>| [s.diffuse, s.specular, s.total()];
    let pairs = parts(one).into_iter().zip(parts(two));
    pairs.flat_map(|(one, two)| at_most(one, two)).collect()
}

/// A light that adds nothing, to the bit, before or after another.
fn adds_nothing(given: Given, scene: &Scene, light: IncidentLight<Term>) -> Vec<Goal> {
    let other = sun(given, "other").into();
    let lights = [[light, other], [other, light]][given.one_of(2) as usize];
    let model = given.one_of(3);
    let [with, without] = [&lights[..], &[other]].map(|lights| scene.shade(model, lights));
    let colors = |s: Shaded<Term>| [s.ambient, s.diffuse, s.specular, s.total()];
    let pairs = colors(with).into_iter().zip(colors(without));
    pairs.flat_map(|(a, b)| same(a, b)).collect()
}

pub fn light_behind(given: Given) -> Vec<Goal> {
    let scene = any_scene(given);
    any_light_and_way(given).map_or(vec![], |(light, way)| {
        if dot(scene.n, way) > Term::ZERO {
            return vec![];
        }
        adds_nothing(given, &scene, light)
    })
}

pub fn light_that_is_black(given: Given) -> Vec<Goal> {
    let scene = any_scene(given);
    any_arrival(given).map_or(vec![], |light| {
        adds_nothing(given, &scene, light * Rgb::BLACK)
    })
}

pub fn broken_lamp(given: Given) -> Vec<Goal> {
    let (scene, p) = (any_scene(given), any_vector(given, "p"));
    let lamp = any_lamp(given, broken(given, "position"));
    lamp.map_or(vec![], |lamp| adds_nothing(given, &scene, lamp.at(p)))
}

pub fn opposite(given: Given) -> Vec<Goal> {
    let (scene, mut sun) = (any_scene(given), sun(given, "l"));
    sun.l = -scene.v;
    black(scene.shade(2, &[sun.into()]).specular)
}

pub fn reflected_at_most(given: Given) -> Vec<Goal> {
    let (mut scene, model) = (any_scene(given), given.one_of(3));
    scene.i_a = Rgb::BLACK;
    let Some(light) = any_arrival(given) else {
        return vec![];
    };
    let lit = scene.shade(model, &[light, sun(given, "other").into()]);
    let (k_d, k_s) = (scene.material.k_d, scene.material.k_s);
    [
        at_most(lit.diffuse, k_d * Term::MAX),
        at_most(lit.specular, k_s * Term::MAX),
    ]
    .concat()
}

/// No more than arrives of one light, whose distance needs no scaling.
pub fn reflected_of_one(given: Given) -> Vec<Goal> {
    let (scene, model, p) = (any_scene(given), given.one_of(3), any_vector(given, "p"));
    let position = any_vector(given, "position");
    let Some(light) = light_at(given, position) else {
        return vec![];
    };
    if !matches!(light, Light::Directional(_)) {
        assume_tame(given, way(position, p));
    }
    let light = light.at(p);
    let (lit, arriving) = (scene.shade(model, &[light]), light.intensity());
    let (k_d, k_s) = (scene.material.k_d, scene.material.k_s);
    [
        at_most(lit.diffuse, arriving * k_d),
        at_most(lit.specular, arriving * k_s),
    ]
    .concat()
}

pub fn black_surface(given: Given) -> Vec<Goal> {
    let (mut scene, model) = (any_scene(given), given.one_of(3));
    (scene.material.k_d, scene.material.k_s) = (Rgb::BLACK, Rgb::BLACK);
    any_arrival(given).map_or(vec![], |light| {
        let lit = scene.shade(model, &[light, sun(given, "other").into()]);
        [black(lit.diffuse), black(lit.specular)].concat()
    })
}

/// Results that are added and scaled are light.
pub fn added_results(given: Given) -> Vec<Goal> {
    let part = |name: &str| Shaded {
        ambient: given.rgb(&format!("{name}.ambient")),
        diffuse: given.rgb(&format!("{name}.diffuse")),
        specular: given.rgb(&format!("{name}.specular")),
    };
    let (x, y, weight) = (part("x"), part("y"), given.not_negative("weight"));
    is_light(x * weight + y)
}
