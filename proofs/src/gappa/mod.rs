//! The error bounds of `docs/precision.md`, where "Gappa" stands beside them, as scripts for Gappa, which proves them from the recorded formulas.
//!
//! A number below 2⁻⁴⁰ is left out, because what underflow takes from it is no share of the result.

mod script;

use std::fs;
use std::path::Path;

use shading::{
    Attenuation, Cone, DirectionalLight, IncidentLight, Lobe, Material, Measured, PointLight,
};
use shading::{
    Real, Rgb, UnitVec3, Vec3, attenuation, half_vector, normal, reflection, shade, term,
};
use shading_proofs::{Format, Given, Graph, Node, Range, Term, Test, paths, with};

use script::Script;

/// 2⁻⁴⁰
const TINY: f64 = 1.0 / 1_099_511_627_776.0;

/// What a formula records.
#[derive(Default)]
struct Formula {
    results: Vec<Term>,
    /// Numbers that are taken as they are: by how many units of roundoff they are off, and the range without that error.
    /// Another row proves it, or the page derives it.
    taken: Vec<(Term, f64, [f64; 2])>,
    /// What is known of a number without rounding; the page says why.
    exact: Vec<(Term, [f64; 2])>,
    /// Rules that rewrite what is to be proved, by names for some numbers. Gappa checks that the two sides are equal.
    names: Vec<(char, Term)>,
    rules: &'static str,
}

impl From<Vec<Term>> for Formula {
    fn from(results: Vec<Term>) -> Self {
        Self {
            results,
            ..Self::default()
        }
    }
}

fn number(given: Given, name: &str, low: f64, high: f64) -> Term {
    given.number(name, Range::unsigned(low, high))
}
/// Numbers of any sign, of which Gappa gets the magnitude.
fn vector(given: Given, name: &str) -> Vec3<Term> {
    given.vector(name, Range::within(-1.0 / TINY, 1.0 / TINY))
}
fn direction(given: Given, name: &str) -> UnitVec3<Term> {
    UnitVec3::assume_unit(vector(given, name))
}
fn attenuation_of(given: Given) -> Attenuation<Term> {
    let [a, b, c] = coefficients(given);
    Attenuation::new(a, b, c).expect("valid coefficients")
}
fn coefficients(given: Given) -> [Term; 3] {
    ["a", "b", "c"].map(|name| number(given, name, 0.01, 2.0))
}
fn lamp(given: Given) -> IncidentLight<Term> {
    let lamp = PointLight {
        position: vector(given, "s"),
        intensity: Rgb::gray(number(given, "I", 0.1, 1.0)),
        attenuation: attenuation_of(given),
    };
    lamp.at(vector(given, "p"))
}
fn first(v: Option<UnitVec3<Term>>) -> Formula {
    v.map_or(vec![], |v| vec![v.x]).into()
}

/// The power of a cosine that is off by so many u.
fn power(given: Given, m: u32, off: f64, low: f64) -> Formula {
    let cosine = number(given, "cosine", low, 1.0);
    Formula {
        results: vec![m.raise(cosine)],
        taken: vec![(cosine, off, [low / 1.2, 1.0])],
        ..Formula::default()
    }
}

fn ranged(given: Given, is_squared: bool) -> Formula {
    let [q, r] = ["q", "r"].map(|name| number(given, name, (-30.0_f64).exp2(), 4.0));
    let free = attenuation_of(given);
    let ranged = if is_squared {
        free.within(r)
    } else {
        free.within_gltf(r)
    };
    let ranged = ranged.expect("a range");
    let share = q / ranged.range();
    given.assume_at_most(share, Term::ONE);
    let fourth = (share * share) * (share * share);
    let [a, b, c] = free.coefficients();
    let root = (Term::ONE - fourth).at_least(Term::ZERO);
    let window = if is_squared { root * root } else { root };
    Formula {
        results: vec![ranged.at(q)],
        exact: vec![(share, [(-30.0_f64).exp2(), 1.0]), (fourth, [0.0, 1.0])],
        names: vec![
            ('f', free.at(q)),
            ('w', window),
            ('l', a + q * (b + c * q)),
            ('s', share),
            ('v', fourth),
        ],
        rules: RANGED,
        ..Formula::default()
    }
}
/// A product f·w, where f = 1/l.
const RANGED: &str = "$ S in 16;
(x - X) / F -> (x - f*w) / F + ((f - F) / F) * w + (w - W) { F <> 0 };
(x - f*w) / F -> (x - f*w) * L { F <> 0, L <> 0 };
";

/// What a limit is put to.
fn unlimited(limited: Term) -> Term {
    with(|g| match g.nodes[limited.0 as usize] {
        Node::Select(_, then, _) => Term(then),
        node => panic!("{node:?} is no limit"),
    })
}

/// The factor of a soft cone, given the cosine between its axis and L.
fn soft_cone(given: Given, is_smooth: bool) -> Formula {
    let [axis, l] = ["axis", "l"].map(|name| direction(given, name));
    let edge = 2.0 * TINY.sqrt();
    let [inner, outer] = ["inner", "outer"].map(|name| number(given, name, edge - 1.0, 1.0 - edge));
    given.assume_above(inner, outer);
    let cone = Cone::from_cosines(inner, outer).expect("a cone");
    let cone = if is_smooth { cone.smoothstep() } else { cone };
    let [inner, outer] = cone.cosines().map(unlimited);

    // between the edges; beyond them a limit takes t no farther from what it should be
    let cosine = (-axis).dot(l);
    let (over, width) = (cosine - outer, inner - outer);
    let t = over / width;
    for above in [width, inner - cosine, t] {
        given.assume_above(above, Term::ZERO);
    }
    given.assume_at_most(t.at_least(Term::ZERO), Term::ONE);
    let limited = t.at_least(Term::ZERO).at_most(Term::ONE);
    let three = Term::ONE + Term::ONE + Term::ONE;
    let (square, rest) = (limited * limited, three - (limited + limited));
    given.assume_at_most(square * rest, Term::ONE);

    let names = [('o', over), ('w', width), ('t', t)];
    let of_smooth = [('f', square), ('s', rest)];
    Formula {
        results: vec![cone.factor(axis, l)],
        taken: vec![(cosine, COSINE, [-1.0, 1.0])],
        exact: vec![
            (width, [0.01, 1.0]),
            (t, [-0.001, 1.001]),
            (over, [-0.001, 1.001]),
        ],
        names: names
            .into_iter()
            .chain(of_smooth.into_iter().filter(|_| is_smooth))
            .collect(),
        rules: if is_smooth { SMOOTHSTEP } else { SQUARE },
    }
}
/// t = o/w, in shares of 1/w.
const SQUARE: &str = "(x - X) * W -> (x - t*t) * W + ((t - T) * W) * (t + T) { W <> 0 };
(t - T) * W -> (t - o/w) * W + ((o - O) / w) * W + O * ((W - w) / w) { w <> 0, W <> 0 };
((o - O) / w) * W -> (o - O) * (W / w) { w <> 0, W <> 0 };
W / w -> 1 + (W - w) / w { w <> 0, W <> 0 };
(W - w) / w -> 1 / (w/W) - 1 { w <> 0, W <> 0 };
w / W -> 1 + (w - W) / W { W <> 0 };
$ W in 4;
";
/// The slope of t²(3 − 2t) between two points is 3/2 less two squares.
const SMOOTHSTEP: &str = "(x - X) * W -> (x - f*s) * W + ((f - t*t) * s) * W + ((t*t) * (s - (3 - (t + t)))) * W
    + ((t - T) * W) * (3 * (t + T) - 2 * (t*t + t*T + T*T)) { W <> 0 };
3 * (t + T) - 2 * (t*t + t*T + T*T) -> 1.5 - 1.5 * ((1 - t - T) * (1 - t - T)) - 0.5 * ((t - T) * (t - T)) { W <> 0 };
(t - T) * W -> (t - o/w) * W + ((o - O) / w) * W + O * ((W - w) / w) { w <> 0, W <> 0 };
((o - O) / w) * W -> (o - O) * (W / w) { w <> 0, W <> 0 };
W / w -> 1 + (W - w) / w { w <> 0, W <> 0 };
(W - w) / w -> 1 / (w/W) - 1 { w <> 0, W <> 0 };
w / W -> 1 + (w - W) / W { W <> 0 };
$ W in 4, T in 16;
";

/// A reflection, given the cosine N·L.
fn mirrored(given: Given) -> Formula {
    let [n, l] = ["n", "l"].map(|name| direction(given, name));
    let (r, cosine) = (reflection(n, l).x, n.dot(l));
    let one = 1.0 + 8.0 * given.format().u();
    Formula {
        results: vec![r],
        taken: vec![(cosine, COSINE, [-one, one])],
        exact: vec![(n.x, [-one, one]), (l.x, [-one, one]), (r, [-one, one])],
        names: vec![('p', n.x * (cosine + cosine)), ('l', l.x)],
        rules: "p - l -> X + (p - P);\n",
    }
}

/// A channel of the total under four lights, given the cosines N·L and what the highlights are off by.
fn shaded(given: Given, model: Model) -> Formula {
    let [n, v] = ["n", "v"].map(|name| direction(given, name));
    let share = |name: &str| number(given, name, TINY, 1.0);
    let [k_a, k_d, k_s, i_a] = ["k_a", "k_d", "k_s", "I_a"].map(|name| Rgb::gray(share(name)));
    let lights = [1, 2, 3, 4].map(|i| DirectionalLight {
        l: direction(given, &format!("l{i}")),
        intensity: Rgb::gray(share(&format!("I{i}"))),
    });
    let mut taken = Vec::new();
    for DirectionalLight { l, .. } in lights {
        given.assume_above(n.dot(l), Term::of(TINY));
        given.assume_above(Term::ONE, n.dot(l)); // where it is not, the sum takes 1
        taken.push((n.dot(l), COSINE, [0.0, 1.0]));
        let highlight = match model {
            Model::Lambert => continue,
            Model::Phong => term::phong(reflection(n, l), v, 32),
            Model::BlinnPhong => {
                let w = Measured {
                    w: *l,
                    w_length: Term::ONE,
                    length: Term::ONE,
                };
                Term::halfway_power(*n, w, *v, 32)
            }
        };
        given.assume_above(highlight, Term::of(TINY));
        taken.push((highlight, model.highlight(), [0.0, 1.0]));
    }
    let material = Material {
        k_a,
        k_d,
        k_s,
        m: 32,
    };
    let lit = lights.map(IncidentLight::from);
    let shaded = match model {
        Model::Lambert => shade::lambert(n, &material, i_a, lit),
        Model::Phong => shade::phong(n, v, &material, i_a, lit),
        Model::BlinnPhong => shade::blinn_phong(n, v, &material, i_a, lit),
    };
    Formula {
        results: vec![shaded.total().r],
        taken,
        ..Formula::default()
    }
}

#[derive(Clone, Copy)]
enum Model {
    Lambert,
    Phong,
    BlinnPhong,
}

impl Model {
    /// By how many u a highlight with m = 32 is off. The page derives by how many R·V and (N·H)² are, 12 and 11, and the
    /// power is proved.
    fn highlight(self) -> f64 {
        match self {
            Self::Lambert => 0.0,
            Self::Phong => 32.0 * 12.0 + 15.5,
            Self::BlinnPhong => 16.0 * 11.0 + 7.5 + 3.5, // the last for L + V
        }
    }
}

/// By how many u a cosine is off, which the row of `lambert` proves.
const COSINE: f64 = 3.0;

/// What an error is a share of.
#[derive(Clone, Copy, PartialEq)]
enum Of {
    Result,
    One,
    /// the number with this name, without rounding
    Named(char),
    /// what the formula gives of the magnitudes of its numbers, without rounding and without signs: the sum of |aᵢbᵢ|
    /// for that of aᵢbᵢ
    Magnitudes,
    /// one, which the result itself exceeds by no more
    Excess,
}

/// What is proved of a row of the page: its name, the most that it is off by, in units of roundoff, of what, and its formula.
type Bound = (&'static str, f64, Of, fn(Given) -> Formula);

#[rustfmt::skip]
const BOUNDS: &[Bound] = &[
    ("length", 2.5, Of::Result, |given| vec![vector(given, "v").length()].into()),
    ("unit", 3.5, Of::Result, |given| first(vector(given, "v").unit())),
    ("sphere", 5.5, Of::Result, |given| first(normal::sphere(vector(given, "c"), vector(given, "p")))),
    ("paraboloid", 5.4, Of::Result, paraboloid),
    ("reflection", 9.0, Of::One, mirrored),
    ("half_vector", 5.5, Of::Result, |given| first(half_vector(direction(given, "l"), direction(given, "v")))),
    ("lambert", COSINE, Of::Magnitudes, lambert),
    ("phong_1", COSINE, Of::Magnitudes, phong),
    ("phong_32", 111.5, Of::One, |given| power(given, 32, COSINE, 0.125)),
    ("blinn_128", 447.5, Of::One, |given| power(given, 128, COSINE, 0.6)),
    ("raise_32", 31.0, Of::Result, |given| vec![32_u32.raise(number(given, "c", 0.125, 1.0))].into()),
    ("raise_1000", 999.0, Of::Result, |given| vec![1000_u32.raise(number(given, "c", 0.94, 1.0))].into()),
    ("phong_normalization", 3.0, Of::Result, |given| vec![term::phong_normalization(number(given, "m", TINY, 1e6))].into()),
    ("blinn_normalization", 11.75, Of::Result, |given| vec![term::blinn_normalization(number(given, "m", TINY, 1e6))].into()),
    ("attenuation", 5.0, Of::Result, attenuated),
    ("ranged", 8.5, Of::Named('f'), |given| ranged(given, true)),
    ("ranged_unsquared", 7.0, Of::Named('f'), |given| ranged(given, false)),
    ("soft_cone", 11.9, Of::Named('w'), |given| soft_cone(given, false)),
    ("smoothstep", 8.6, Of::Named('w'), |given| soft_cone(given, true)),
    ("lamp_direction", 6.5, Of::Result, |given| vec![lamp(given).l().x].into()),
    ("lamp_intensity", 13.0, Of::Result, |given| vec![lamp(given).intensity().r].into()),
    ("shade_lambert", 9.0, Of::Magnitudes, |given| shaded(given, Model::Lambert)),
    ("highlight_phong", 399.5, Of::One, |given| power(given, 32, 12.0, 0.125)),
    ("shade_phong", 405.5, Of::Magnitudes, |given| shaded(given, Model::Phong)),
    ("highlight_blinn", 183.5, Of::One, |given| power(given, 16, 11.0, 0.125)),
    ("shade_blinn", 193.0, Of::Magnitudes, |given| shaded(given, Model::BlinnPhong)),
    // claims rather than rows
    ("lambert_of_units", 16.0, Of::Excess, |given| units(given, |n, l| n.dot(l))),
    ("cone_of_everything", 16.0, Of::Excess, |given| units(given, |axis, l| -(-axis).dot(l))),
];

fn paraboloid(given: Given) -> Formula {
    let [u, v] = ["u", "v"].map(|name| given.number(name, Range::within(-1.0, 1.0)));
    let surface = |u, v| Vec3::new(u, v, u * u + u * v + v * v);
    first(normal::parametric(surface, u, v))
}

fn lambert(given: Given) -> Formula {
    let [n, l] = ["n", "l"].map(|name| direction(given, name));
    given.assume_above(n.dot(l), Term::ZERO);
    vec![term::lambert(n, l)].into()
}

fn phong(given: Given) -> Formula {
    let [r, v] = ["r", "v"].map(|name| direction(given, name));
    given.assume_above(r.dot(v), Term::of(TINY));
    given.assume_at_most(r.dot(v), Term::ONE);
    vec![term::phong(r, v, 1)].into()
}

fn attenuated(given: Given) -> Formula {
    let [a, b, c] = coefficients(given);
    let q = number(given, "q", (-30.0_f64).exp2(), 4.0);
    vec![attenuation(a, b, c, q)].into()
}

/// The cosine between two directions: 2 N·L = |N|² + |L|² − |N − L|².
fn units(given: Given, cosine: fn(UnitVec3<Term>, UnitVec3<Term>) -> Term) -> Formula {
    let (n, l) = (given.unit("n"), given.unit("l"));
    let components = [n.x, n.y, n.z, l.x, l.y, l.z];
    let letters = ['a', 'b', 'c', 'e', 'f', 'g'];
    let names = letters.into_iter().zip(components);
    Formula {
        results: vec![cosine(n, l)],
        exact: components.map(|x| (x, [-1.000_001, 1.000_001])).into(),
        names: names.chain([('p', n.dot(n)), ('q', l.dot(l))]).collect(),
        rules: UNITS,
        ..Formula::default()
    }
}
const UNITS: &str = "X -> (P + Q - ((a-e)*(a-e) + (b-f)*(b-f) + (c-g)*(c-g)))/2;
x -> X + (x - X);
P -> p - (p - P);
Q -> q - (q - Q);
";

/// Whether a decision is that a vector must be rescaled: its square is not from 1/p to p.
fn is_rescaled(g: &Graph, (test, answer): (Test, bool)) -> bool {
    let Test::Above(inside, _) = test else {
        return false;
    };
    let inside = g.nodes[inside as usize];
    !answer && matches!(inside, Node::Select(Test::AtMost(..), ..))
}

/// Writes one script for a share of each bound, format and way through the formula, but for vectors that are rescaled.
pub fn write(folder: &Path, share: f64) -> std::io::Result<()> {
    fs::create_dir_all(folder)?;
    for &(name, most, of, formula) in BOUNDS {
        for format in [Format::F32, Format::F64] {
            let mut scripts = Vec::new();
            paths(format, formula, |run, formula| {
                let (g, most) = (&run.graph, most * share);
                if run.path.iter().any(|fact| is_rescaled(g, *fact)) {
                    return;
                }
                for &result in &formula.results {
                    let script = Script::new(g, run.known.clone(), &formula);
                    scripts.push(script.text(result, most, of));
                }
            });
            assert!(!scripts.is_empty(), "{name} has no way");
            for (way, script) in scripts.into_iter().enumerate() {
                let file = format!("{name}.{way}.{format:?}.g");
                fs::write(folder.join(file), script)?;
            }
        }
    }
    Ok(())
}
