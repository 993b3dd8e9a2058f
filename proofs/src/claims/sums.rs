//! The reflected light.

use shading::{
    DirectionalLight, IncidentLight, Light, Material, Ranged, Real, Rgb, Shaded, SoftCone,
    SpotLight, shade,
};
use shading_proofs::{Goal, Node, Range, Test, with};

use super::*;

fn of_sum(s: Shaded<Term>) -> Vec<Goal> {
    [s.ambient, s.diffuse, s.specular, s.total()]
        .into_iter()
        .flat_map(|color| channels(color, light()))
        .collect()
}
/// A surface, the eye and the ambient light.
struct Scene {
    n: UnitVec3<Term>,
    v: UnitVec3<Term>,
    material: Material<Term, u32>,
    i_a: Rgb<Term>,
}
fn scene(given: Given, m: u32) -> Scene {
    Scene {
        n: given.unit("n"),
        v: given.unit("v"),
        material: material(given, m),
        i_a: given.rgb("I_a"),
    }
}
fn of_any_directions(given: Given, m: u32) -> Scene {
    Scene {
        n: any_direction(given, "n"),
        v: any_direction(given, "v"),
        ..scene(given, m)
    }
}
impl Scene {
    fn lambert<const N: usize>(&self, lights: [IncidentLight<Term>; N]) -> Shaded<Term> {
        shade::lambert(self.n, &self.material, self.i_a, lights)
    }
    fn phong<const N: usize>(&self, lights: [IncidentLight<Term>; N]) -> Shaded<Term> {
        shade::phong(self.n, self.v, &self.material, self.i_a, lights)
    }
    fn blinn_phong<const N: usize>(&self, lights: [IncidentLight<Term>; N]) -> Shaded<Term> {
        shade::blinn_phong(self.n, self.v, &self.material, self.i_a, lights)
    }
    fn all<const N: usize>(&self, lights: [IncidentLight<Term>; N]) -> [Shaded<Term>; 3] {
        [
            self.lambert(lights),
            self.phong(lights),
            self.blinn_phong(lights),
        ]
    }
}
/// A light that adds nothing, to the bit, in each of the three models.
fn adds_nothing(scene: &Scene, light: IncidentLight<Term>) -> Vec<Goal> {
    let (with, without) = (scene.all([light]), scene.all([]));
    with.into_iter()
        .zip(without)
        .flat_map(|(a, b)| [same(a.diffuse, b.diffuse), same(a.specular, b.specular)].concat())
        .collect()
}
/// The terms of a sum that is limited to MAX and multiplied by a reflectance.
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
            // the earlier node is the sum so far
            let (rest, term) = if matches!(g.nodes[a as usize], Node::Add(..)) || a == Term::ZERO.0
            {
                (a, b)
            } else {
                (b, a)
            };
            terms.push(Term(term));
            sum = rest;
        }
        assert_eq!(sum, Term::ZERO.0, "the sum begins at 0");
        terms
    })
}

/// A spot with a soft edge and a range.
fn any_spot(given: Given) -> SpotLight<Term, SoftCone<Term>, Ranged<Term>> {
    let position = any_vector(given, "position");
    let point = PointLight {
        position,
        intensity: given.rgb("I"),
        attenuation: any_ranged(given),
    };
    SpotLight {
        point,
        axis: any_direction(given, "axis"),
        cone: soft_cone(given),
    }
}

claims! {
    lambert: "`shade::lambert`, two lights: no channel is negative or NaN, nor of `Shaded::total`" |given| {
        of_sum(scene(given, 1).lambert([incident(given, "l1"), incident(given, "l2")]))
    }
    phong: "`shade::phong`, two lights, m = 32: no channel is negative or NaN" |given| {
        of_sum(scene(given, 32).phong([incident(given, "l1"), incident(given, "l2")]))
    }
    blinn_phong_even: "`shade::blinn_phong`, two lights, m = 32: no channel is negative or NaN" |given| {
        of_sum(scene(given, 32).blinn_phong([incident(given, "l1"), incident(given, "l2")]))
    }
    blinn_phong_odd: "`shade::blinn_phong`, two lights, m = 5: no channel is negative or NaN" |given| {
        of_sum(scene(given, 5).blinn_phong([incident(given, "l1"), incident(given, "l2")]))
    }
    any_number_of_lights: "each light adds a term in [0, ∞] to sums that begin at 0, and so does any number of lights" |given| {
        let scene = scene(given, 32);
        let lights = [incident(given, "l1"), incident(given, "l2")];
        let sums = [scene.phong(lights), scene.blinn_phong(lights)];
        within(sums.into_iter().flat_map(|s| [added(s.diffuse.r), added(s.specular.r)].concat()), light())
    }
    long_directions: "`shade::phong` and `shade::blinn_phong`, directions of any length up to 2²⁰: no channel is negative or NaN" |given| {
        let long = |name| UnitVec3::assume_unit(given.vector(name, Range::within(-2.0_f64.powi(20), 2.0_f64.powi(20))));
        let scene = Scene { n: long("n"), v: long("v"), ..scene(given, 32) };
        let light = IncidentLight { l: long("l"), ..incident(given, "light") };
        [of_sum(scene.phong([light])), of_sum(scene.blinn_phong([light]))].concat()
    }
    lit_by_a_lamp: "a lamp anywhere (any bits) and p anywhere, then `shade::blinn_phong`: no channel is negative or NaN" |given| {
        let light = lamp(given, any_vector(given, "position")).at(any_vector(given, "p"));
        of_sum(scene(given, 32).blinn_phong([light]))
    }
    no_lights: "without lights, diffuse and specular are 0" |given| {
        let scene = of_any_directions(given, 32);
        scene.all([]).into_iter().flat_map(|s| [channels(s.diffuse, Range::within(0.0, 0.0)), channels(s.specular, Range::within(0.0, 0.0))].concat()).collect()
    }
    behind: "a light with N·L ≤ 0, or NaN, adds nothing, to the bit; directions of any bits" |given| {
        let scene = of_any_directions(given, 32);
        let light = IncidentLight { l: any_direction(given, "l"), ..incident(given, "light") };
        if scene.n.dot(light.l) > Term::ZERO { vec![] } else { adds_nothing(&scene, light) }
    }
    black: "a black light adds nothing, to the bit" |given| {
        adds_nothing(&scene(given, 32), IncidentLight { intensity: Rgb::BLACK, ..incident(given, "light") })
    }
    nan_direction: "a light whose L is NaN adds nothing, to the bit; the other directions of any bits" |given| {
        let l = nan_direction(given, "l");
        let light = IncidentLight { l, ..incident(given, "light") };
        adds_nothing(&of_any_directions(given, 32), light)
    }
    nan_lamp: "a lamp with a coordinate that is NaN adds nothing, to the bit; the other coordinates of any bits" |given| {
        let position = with_one(given, "position", Range::NAN);
        adds_nothing(&scene(given, 32), lamp(given, position).at(any_vector(given, "p")))
    }
    opposite: "`shade::blinn_phong` has no highlight for L = −V" |given| {
        let scene = scene(given, 32);
        let light = IncidentLight { l: -scene.v, ..incident(given, "light") };
        channels(scene.blinn_phong([light]).specular, Range::within(0.0, 0.0))
    }
    black_surface: "a reflectance of 0 gives 0, even if the sum of two lights overflows" |given| {
        let mut scene = scene(given, 32);
        (scene.material.k_d, scene.material.k_s) = (Rgb::BLACK, Rgb::BLACK);
        let lights = [incident(given, "l1"), incident(given, "l2")];
        scene.all(lights).into_iter().flat_map(|s| [channels(s.diffuse, Range::within(0.0, 0.0)), channels(s.specular, Range::within(0.0, 0.0))].concat()).collect()
    }
    reflected_at_most: "diffuse and specular are at most the largest number times k, to the bit" |given| {
        let scene = scene(given, 32);
        let sums = scene.all([incident(given, "l1"), incident(given, "l2")]);
        let limit = |k: Rgb<Term>| k * Term::MAX;
        let at_most = |a: Rgb<Term>, b: Rgb<Term>| vec![Goal::AtMost(a.r, b.r), Goal::AtMost(a.g, b.g), Goal::AtMost(a.b, b.b)];
        let (d, s) = (limit(scene.material.k_d), limit(scene.material.k_s));
        sums.into_iter().flat_map(|sum| [at_most(sum.diffuse, d), at_most(sum.specular, s)].concat()).collect()
    }
    sun_in_front: "a light that `DirectionalLight::in_front` leaves out adds nothing, to the bit; directions of any bits" |given| {
        let sun = DirectionalLight { l: any_direction(given, "l"), intensity: given.rgb("I") };
        let (scene, p) = (of_any_directions(given, 32), any_vector(given, "p"));
        if sun.in_front(p, scene.n).is_some() {
            return vec![];
        }
        adds_nothing(&scene, sun.at(p))
    }
    sun_kept_in_front: "a light that `DirectionalLight::in_front` keeps is that of `at`, to the bit" |given| {
        let sun = DirectionalLight { l: any_direction(given, "l"), intensity: given.rgb("I") };
        let (n, p) = (any_direction(given, "n"), any_vector(given, "p"));
        let (kept, at) = (sun.in_front(p, n), sun.at(p));
        kept.map_or(vec![], |kept| [same(*kept.l, *at.l), same(kept.intensity, at.intensity)].concat())
    }
    lamp_kept_in_front: "a light that `PointLight::in_front` keeps is that of `at`, to the bit; positions of any bits" |given| {
        let (lamp, n, p) = (lamp(given, any_vector(given, "position")), any_direction(given, "n"), any_vector(given, "p"));
        let (kept, at) = (lamp.in_front(p, n), lamp.at(p));
        kept.map_or(vec![], |kept| [same(*kept.l, *at.l), same(kept.intensity, at.intensity)].concat())
    }
    spot_kept_in_front: "what `SpotLight::in_front` keeps is that of `at`, to the bit; positions, axis and N of any bits" |given| {
        let (spot, n, p) = (any_spot(given), any_direction(given, "n"), any_vector(given, "p"));
        let (kept, at) = (spot.in_front(p, n), spot.at(p));
        kept.map_or(vec![], |kept| [same(*kept.l, *at.l), same(kept.intensity, at.intensity)].concat())
    }
    light_in_front: "`Light::in_front` is `in_front` of its kind, to the bit; positions, axis and N of any bits" |given| {
        let (spot, n, p) = (any_spot(given), any_direction(given, "n"), any_vector(given, "p"));
        let kind = Light::<Term, SoftCone<Term>, Ranged<Term>>::from(spot);
        match (kind.in_front(p, n), spot.in_front(p, n)) {
            (Some(a), Some(b)) => [same(*a.l, *b.l), same(a.intensity, b.intensity)].concat(),
            (None, None) => vec![],
            _ => vec![Goal::Never],
        }
    }
    lamp_behind: "a light that `PointLight::in_front` leaves out as behind the surface is black or has an N·L that is not above 0; positions of any bits" |given| {
        let (lamp, n, p) = (lamp(given, any_vector(given, "position")), given.unit("n"), any_vector(given, "p"));
        if lamp.in_front(p, n).is_some() {
            return vec![];
        }
        decide_scale(p, lamp.position);
        let light = lamp.at(p);
        if n.dot(light.l) > Term::ZERO { channels(light.intensity, Range::within(0.0, 0.0)) } else { vec![] }
    }
    lamp_out_of_range: "a light whose squared distance `Falloff::reaches` of `Ranged` leaves out, as `PointLight::in_front` does, adds nothing at the root of that, to the bit" |given| {
        let falloff = any_ranged(given);
        let (scene, square) = (scene(given, 32), given.number("square", light()));
        if shading::Falloff::reaches(&falloff, square) {
            return vec![];
        }
        let dark = falloff.at(square.sqrt());
        within([dark], Range::within(0.0, 0.0)).into_iter()
            .chain(adds_nothing(&scene, IncidentLight { intensity: Rgb::gray(dark), ..incident(given, "light") })).collect()
    }
    spot_out_of_its_cone: "a light that `SpotLight::in_front` leaves out, and its point light does not, is black; positions, axis and N of any bits" |given| {
        let (spot, n, p) = (any_spot(given), any_direction(given, "n"), any_vector(given, "p"));
        if spot.point.in_front(p, n).is_none() || spot.in_front(p, n).is_some() {
            return vec![];
        }
        channels(spot.at(p).intensity, Range::within(0.0, 0.0))
    }
}
