//! Anchors. A function of the crate that stands in the assumption of another claim, or on both of its
//! sides, could be wrong there without being noticed. So each is compared, to the bit, with its formula,
//! which is written out here in + − × ÷ √ and comparisons of numbers.

use shading::{
    Attenuation, Cone, DirectionalLight, IncidentLight, Lobe, PointLight, SpotLight, UnitVec3, Vec3,
};
use shading::{Real, Rgb, attenuation, half_vector, normal, reflection, term};
use shading_proofs::{Given, Goal, Range, Term};

use super::given::*;

/// max(x, 0), at most 1.
fn share_of(x: Term) -> Term {
    smaller(larger(x, Term::ZERO), Term::ONE)
}

fn finite_light(x: Term) -> Term {
    choose(Term::MAX, x, x, Term::MAX)
}

fn times(color: [Term; 3], factor: Term) -> [Term; 3] {
    color.map(|channel| channel * factor)
}

fn one(term: Term, formula: Term) -> Vec<Goal> {
    vec![Goal::Same(term, formula)]
}

/// What a claim compares to decide: a difference cannot be reached.
fn agrees(decided: bool, formula: bool) -> Vec<Goal> {
    none((decided != formula).then_some(()))
}

pub fn vectors_by_components(given: Given) -> Vec<Goal> {
    let (a, b, k) = (
        any_vector(given, "a"),
        any_vector(given, "b"),
        given.any("k"),
    );
    let ([ax, ay, az], [bx, by, bz]): ([Term; 3], [Term; 3]) = (a.into(), b.into());
    let cross = [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx];
    let unit = UnitVec3::assume_unit(a);
    [
        same(a + b, [ax + bx, ay + by, az + bz]),
        same(a - b, [ax - bx, ay - by, az - bz]),
        same(-a, [-ax, -ay, -az]),
        same(a * k, [ax * k, ay * k, az * k]),
        same(a / k, [ax / k, ay / k, az / k]),
        same(a.cross(b), cross),
        one(a.dot(b), dot(a, b)),
        one(unit.dot(b), dot(a, b)),
        same(-unit, [-ax, -ay, -az]),
        same(unit * k, [ax * k, ay * k, az * k]),
    ]
    .concat()
}

pub fn directions_by_formula(given: Given) -> Vec<Goal> {
    let [l, v] = ["l", "v"].map(|name| any_direction(given, name));
    let sum = [l.x + v.x, l.y + v.y, l.z + v.z];
    let length = assume_tame(given, sum).sqrt();
    let unit = sum.map(|x| x / length);
    let (sum, none) = (Vec3::from(sum), given.any("none"));
    let made = [
        sum.unit(),
        half_vector(l, v),
        normal::plane(sum.x, sum.y, sum.z),
    ];
    let made = made.map(|made| made.map_or(vec![Goal::Never], |made| same(made, unit)));
    let other = sum.unit_or(UnitVec3::assume_unit(Vec3::new(none, none, none)));
    [made.concat(), same(other, unit), one(sum.length(), length)].concat()
}

/// Whether a light of each kind, and a surface, is in front: n·v > 0 decides, v the vector to the light.
pub fn in_front_by_formula(given: Given) -> Vec<Goal> {
    let n = any_direction(given, "n");
    any_light_and_way(given).map_or(vec![], |(light, to_light)| {
        agrees(light.is_in_front(n), dot(n, to_light) > Term::ZERO)
    })
}

pub fn facing_by_formula(given: Given) -> Vec<Goal> {
    let [n, v, face] = ["n", "v", "face"].map(|name| any_direction(given, name));
    let turned = dot([-face.x, -face.y, -face.z], v) > Term::ZERO;
    let formula = if turned {
        [-n.x, -n.y, -n.z]
    } else {
        [n.x, n.y, n.z]
    };
    same(normal::facing(n, v, face), formula)
}

pub fn terms_by_formula(given: Given) -> Vec<Goal> {
    let [n, l] = ["n", "l"].map(|name| any_direction(given, name));
    let (cosine, m) = (dot(n, l), given.any("m"));
    let highlight = highlight(cosine, m);
    let mirrored = [(n.x, l.x), (n.y, l.y), (n.z, l.z)].map(|(n, l)| n * (cosine + cosine) - l);
    [
        one(term::lambert(n, l), larger(cosine, Term::ZERO)),
        one(term::phong(n, l, m), highlight),
        one(term::blinn(n, l, m), highlight),
        same(reflection(n, l), mirrored),
    ]
    .concat()
}

fn highlight(cosine: Term, m: Term) -> Term {
    choose(cosine, Term::ZERO, m.raise(share_of(cosine)), Term::ZERO)
}

/// An attenuation that the constructors must accept, and its formula: 1/(a + bq + cq²), with a limit and a
/// window.
fn falloff(given: Given) -> Option<(Attenuation<Term>, impl Fn(Term) -> Term)> {
    let abc = ["a", "b", "c"].map(|name| checked(given, name));
    given.assume_above(abc[given.one_of(3) as usize], Term::ZERO);
    let [a, b, c] = abc;
    let above_0 = |name, most| given.number(name, Range::within(given.format().tiny(), most));
    let (limit, range) = (
        above_0("limit", INF),
        above_0("r", given.format().next_down(given.format().max())),
    );
    let (limited, window) = (given.one_of(3), given.one_of(3));
    let made = Attenuation::new(a, b, c).and_then(|made| LIMITS[limited as usize].1(made, limit));
    let made = made.and_then(|made| WINDOWS[window as usize].1(made, range))?;
    let limit = [Term::MAX, Term::ONE, smaller(limit, Term::MAX)][limited as usize];
    let formula = move |q| {
        let factor = smaller(larger(Term::ONE / (a + q * (b + c * q)), Term::ZERO), limit);
        let square = (q / range) * (q / range);
        let end = larger(Term::ONE - square * square, Term::ZERO);
        match window {
            0 => factor,
            1 => factor * (end * end),
            _ => factor * end,
        }
    };
    Some((made, formula))
}

pub fn attenuation_by_formula(given: Given) -> Vec<Goal> {
    let [a, b, c, q] = ["a'", "b'", "c'", "q"].map(|name| given.any(name));
    let plain = smaller(
        larger(Term::ONE / (a + q * (b + c * q)), Term::ZERO),
        Term::MAX,
    );
    falloff(given).map_or(vec![Goal::Never], |(made, formula)| {
        let plain = Goal::Same(attenuation(a, b, c, q), plain);
        vec![plain, Goal::Same(made.at(q), formula(q))]
    })
}

/// A cone that the constructors must accept, and its formula: t² or t²(3 − 2t) between the edges, which are
/// stored with a slack of 8 units of roundoff.
fn beam(given: Given) -> Option<(Cone<Term>, impl Fn(Term) -> Term)> {
    let [inner, outer] =
        ["inner", "outer"].map(|name| given.number(name, Range::unsigned(-1.0, 1.0)));
    given.assume_at_most(outer, inner);
    let made = Cone::from_cosines(inner, outer)?;
    let edge = given.one_of(2);
    let made = EDGES[edge as usize].1(made);
    let (inner, outer) = (inner + Term::ZERO, outer + Term::ZERO); // not −0
    // four times the distance from 1 to the next number, which is |3 (4/3 − 1) − 1|, rounded
    let (two, three) = (Term::ONE + Term::ONE, Term::ONE + Term::ONE + Term::ONE);
    let x = three * ((Term::ONE + three) / three - Term::ONE) - Term::ONE;
    let slack = two * two * larger(x, -x);
    let is_everywhere = |then, less| choose(slack - Term::ONE, inner, then, less);
    let stored = |cosine| is_everywhere(-two, smaller(cosine, Term::ONE - slack));
    let (inner, outer) = (stored(inner), stored(outer));
    let formula = move |cosine: Term| {
        let t = share_of((cosine - outer) / (inner - outer));
        let smooth = smaller(t * t * (Term::of(3.0) - (t + t)), Term::ONE);
        let soft = [t * t, smooth][edge as usize];
        let outside = if inner > outer { soft } else { Term::ZERO };
        choose(inner, cosine, outside, Term::ONE)
    };
    Some((made, formula))
}

pub fn cone_by_formula(given: Given) -> Vec<Goal> {
    let (axis, l) = (any_direction(given, "axis"), any_direction(given, "l"));
    let cosine = dot([-axis.x, -axis.y, -axis.z], l);
    beam(given).map_or(vec![Goal::Never], |(made, formula)| {
        one(made.factor(axis, l), formula(cosine))
    })
}

/// What arrives by its formula: a vector to the light, its length, and the light with a factor.
struct Arriving {
    light: IncidentLight<Term>,
    w: [Term; 3],
    length: Term,
    color: [Term; 3],
    factor: Term,
}

impl Arriving {
    fn from_sun(sun: DirectionalLight<Term>) -> Self {
        Self {
            light: sun.into(),
            w: sun.l.into(),
            length: Term::ONE,
            color: sun.intensity.into(),
            factor: Term::ONE,
        }
    }
}

/// Any sun, and any lamp or spot at a distance whose square needs no scaling.
fn arriving(given: Given) -> Option<Arriving> {
    let (kind, intensity) = (given.one_of(3), given.rgb("I"));
    let color = intensity.into();
    if kind == 0 {
        let l = any_direction(given, "l");
        return Some(Arriving::from_sun(DirectionalLight { l, intensity }));
    }
    let (position, p) = (any_vector(given, "position"), any_vector(given, "p"));
    let w = way(position, p);
    let length = assume_tame(given, w).sqrt();
    let (attenuation, falloff) = falloff(given)?;
    let point = PointLight {
        position,
        intensity,
        attenuation,
    };
    let (mut light, mut factor) = (point.at(p), falloff(length));
    if kind == 2 {
        let (axis, (cone, beam)) = (any_direction(given, "axis"), beam(given)?);
        light = SpotLight { point, axis, cone }.at(p);
        factor = factor * beam(dot([-axis.x, -axis.y, -axis.z], w) / length);
    }
    Some(Arriving {
        light,
        w,
        length,
        color,
        factor,
    })
}

pub fn arrival_by_formula(given: Given) -> Vec<Goal> {
    let Some(arriving) = arriving(given) else {
        return vec![Goal::Never];
    };
    let (light, length, factor) = (arriving.light, arriving.length, arriving.factor);
    let filter = given.rgb("filter");
    let through: [Term; 3] = filter.into();
    let filtered = [0, 1, 2].map(|i| finite_light(arriving.color[i] * finite_light(through[i])));
    // of a sun, all of its light arrives
    let (l, is_sun) = (arriving.w.map(|x| x / length), length.0 == Term::ONE.0);
    let (distance, limited): (Term, fn(Term) -> Term) = if is_sun {
        (Term::MAX, |x| x)
    } else {
        (length, finite_light)
    };
    [
        same(light.l(), l),
        same(light.arrival().l, l),
        one(light.distance(), distance),
        one(light.arrival().distance, distance),
        same(
            light.intensity(),
            times(arriving.color, factor).map(limited),
        ),
        same(
            (light * filter).intensity(),
            times(filtered, factor).map(limited),
        ),
    ]
    .concat()
}

/// The sum of two lights in front, the first of any kind.
pub fn sum_by_formula(given: Given) -> Vec<Goal> {
    let (scene, model) = (any_scene(given), given.one_of(3));
    let Some(first) = arriving(given) else {
        return vec![Goal::Never];
    };
    let lights = [first, Arriving::from_sun(sun(given, "other"))];
    for light in &lights {
        given.assume_above(dot(scene.n, light.w), Term::ZERO);
    }
    let lit = scene.shade(model, &[lights[0].light, lights[1].light]);
    let sum = |k: Rgb<Term>, share: &dyn Fn(&Arriving) -> Term| {
        let [k, mut sum]: [[Term; 3]; 2] = [k.into(), [Term::ZERO; 3]];
        for light in &lights {
            let added = times(light.color, light.factor * share(light));
            sum = [0, 1, 2].map(|i| sum[i] + added[i]);
        }
        [0, 1, 2].map(|i| finite_light(sum[i]) * k[i])
    };
    let (n, v, material) = (scene.n, scene.v, scene.material);
    let [k_a, i_a]: [[Term; 3]; 2] = [material.k_a.into(), scene.i_a.into()];
    let ambient = [0, 1, 2].map(|i| k_a[i] * i_a[i]);
    let diffuse = sum(material.k_d, &|light| {
        share_of(dot(n, light.w) / light.length)
    });
    let specular = match MODELS[model as usize] {
        "lambert" => [Term::ZERO; 3],
        "phong" => sum(material.k_s, &|light| {
            let cosine = dot(n, light.w);
            let n: [Term; 3] = n.into();
            let mirrored = [0, 1, 2].map(|i| n[i] * (cosine + cosine) - light.w[i]);
            highlight(dot(mirrored, v) / light.length, material.m)
        }),
        _ => sum(material.k_s, &|light| {
            let v: [Term; 3] = v.into();
            let h = [0, 1, 2].map(|i| light.w[i] + v[i] * light.length);
            let (cosine, square) = (dot(n, h), dot(h, h));
            let share = cosine * cosine / square;
            let share = choose(Term::ONE, share, share, Term::ONE);
            let power = material.m.raise(share.sqrt());
            choose(cosine, Term::ZERO, power, Term::ZERO)
        }),
    };
    let total = [0, 1, 2].map(|i| ambient[i] + diffuse[i] + specular[i]);
    [
        same(lit.ambient, ambient),
        same(lit.diffuse, diffuse),
        same(lit.specular, specular),
        same(lit.total(), total),
    ]
    .concat()
}
