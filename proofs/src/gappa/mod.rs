//! The error bounds of `docs/precision.md`, as scripts for Gappa, which proves them from the recorded formulas.
//!
//! A number below 2⁻⁴⁰ is left out, because what underflow takes from it is no share of the result.

mod script;

use std::fs;
use std::path::Path;

use shading::{
    Attenuation, Exponent, IncidentLight, Material, PointLight, Ranged, Real, Rgb, SoftCone,
    UnitVec3, Vec3,
};
use shading::{attenuation, half_vector, normal, reflection, shade, term};
use shading_proofs::{Format, Given, Node, Range, Term, Test, paths, with};

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
fn coefficients(given: Given) -> [Term; 3] {
    ["a", "b", "c"].map(|name| number(given, name, 0.01, 2.0))
}
fn lamp(given: Given) -> IncidentLight<Term> {
    let mut fields = coefficients(given).into_iter();
    let attenuation = Attenuation::<f32>::NONE.cast(|_| fields.next().unwrap());
    let intensity = Rgb::gray(number(given, "I", 0.1, 1.0));
    PointLight {
        position: vector(given, "s"),
        intensity,
        attenuation,
    }
    .at(vector(given, "p"))
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
    let mut fields = coefficients(given).into_iter().chain([r]);
    let ranged = Attenuation::<f32>::NONE.within(1.0).unwrap();
    let ranged = if is_squared {
        ranged
    } else {
        ranged.unsquared()
    };
    let ranged: Ranged<Term> = ranged.cast(|_| fields.next().unwrap());
    given.assume_at_most(q / r, Term::ONE);
    let free = ranged.attenuation().at(q);
    let share = q / r;
    let fourth = (share * share) * (share * share);
    let [a, b, c] = ranged.attenuation().coefficients();
    let root = (Term::ONE - fourth).at_least(Term::ZERO);
    let window = if is_squared { root * root } else { root };
    Formula {
        results: vec![ranged.at(q)],
        exact: vec![(share, [(-30.0_f64).exp2(), 1.0]), (fourth, [0.0, 1.0])],
        names: vec![
            ('f', free),
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
    let cosine_of = |name| {
        given.number(
            name,
            Range::within(2.0 * TINY.sqrt() - 1.0, 1.0 - 2.0 * TINY.sqrt()),
        )
    };
    let mut fields = ["inner", "outer"].map(cosine_of).into_iter();
    let cone = SoftCone::<f32>::from_cosines(0.9, 0.5).unwrap();
    let cone: SoftCone<Term> =
        if is_smooth { cone.smoothstep() } else { cone }.cast(|_| fields.next().unwrap());
    let [inner, outer] = cone.cosines().map(unlimited);
    let factor = cone.factor(axis, l);

    // between the edges; beyond them a limit takes t no farther from what it should be
    let cosine = (-axis).dot(l);
    let (over, width, to_inner) = (cosine - outer, inner - outer, inner - cosine);
    let t = over / width;
    given.assume_above(to_inner, Term::ZERO);
    given.assume_above(t, Term::ZERO);
    given.assume_at_most(t.at_least(Term::ZERO), Term::ONE);
    let limited = to_inner.if_positive(t.at_least(Term::ZERO).at_most(Term::ONE), Term::ONE);
    let (square, rest) = (
        limited * limited,
        Term::ONE + Term::ONE + Term::ONE - (limited + limited),
    );
    given.assume_at_most(square * rest, Term::ONE);

    let names = [('o', over), ('w', width), ('t', t)];
    let of_smooth = [('f', square), ('s', rest)];
    Formula {
        results: vec![factor],
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
    let lights =
        [1, 2, 3, 4].map(|i| (direction(given, &format!("l{i}")), share(&format!("I{i}"))));
    let mut taken = Vec::new();
    for (l, _) in lights {
        given.assume_above(n.dot(l), Term::of(TINY));
        taken.push((n.dot(l), COSINE, [0.0, 1.0]));
        let [n_, l_, v_] = [n, l, v].map(<[Term; 3]>::from);
        let (cosine, m) = match model {
            Model::Lambert => continue,
            Model::Phong => (Term::reflected_cosine(n_, l_, v_), 32_u32),
            Model::BlinnPhong => {
                let h = *l + *v;
                given.assume_at_most(Term::ONE / Term::EXTREME, h.z * h.z + h.y * h.y + h.x * h.x);
                (Term::half_cosine(n_, l_, v_, true), 16)
            }
        };
        let cosine = term::lambert(n, l).if_positive(cosine, Term::ZERO);
        let highlight = m.raise(cosine);
        given.assume_above(highlight, Term::of(TINY));
        taken.push((highlight, model.highlight(), [0.0, 1.0]));
    }
    let material = Material {
        k_a,
        k_d,
        k_s,
        m: 32,
    };
    let lit = lights.map(|(l, i)| IncidentLight {
        l,
        intensity: Rgb::gray(i),
        distance: Term::MAX,
    });
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
}

/// What is proved of a row of the page.
struct Bound {
    name: &'static str,
    /// The row.
    function: &'static str,
    /// In units of roundoff.
    most: f64,
    of: Of,
    formula: fn(Given) -> Formula,
}

const fn bound(
    name: &'static str,
    function: &'static str,
    most: f64,
    of: Of,
    formula: fn(Given) -> Formula,
) -> Bound {
    Bound {
        name,
        function,
        most,
        of,
        formula,
    }
}

const BOUNDS: &[Bound] = &[
    bound("length", "`Vec3::length`", 2.5, Of::Result, |given| {
        vec![vector(given, "v").length()].into()
    }),
    bound(
        "unit",
        "`Vec3::unit`, `normal::plane`",
        3.5,
        Of::Result,
        |given| first(vector(given, "v").unit()),
    ),
    bound("sphere", "`normal::sphere`", 5.5, Of::Result, |given| {
        first(normal::sphere(vector(given, "c"), vector(given, "p")))
    }),
    bound(
        "paraboloid",
        "`normal::parametric`, a paraboloid",
        5.4,
        Of::Result,
        |given| {
            let [u, v] = ["u", "v"].map(|name| given.number(name, Range::within(-1.0, 1.0)));
            first(normal::parametric(
                |u, v| Vec3::new(u, v, u * u + u * v + v * v),
                u,
                v,
            ))
        },
    ),
    bound("reflection", "`reflection`", 9.0, Of::One, mirrored),
    bound("half_vector", "`half_vector`", 5.5, Of::Result, |given| {
        first(half_vector(direction(given, "l"), direction(given, "v")))
    }),
    bound("lambert", "`lambert`", COSINE, Of::Magnitudes, |given| {
        let [n, l] = ["n", "l"].map(|name| direction(given, name));
        given.assume_above(n.dot(l), Term::ZERO);
        vec![term::lambert(n, l)].into()
    }),
    bound(
        "phong_1",
        "`phong`, m = 1",
        COSINE,
        Of::Magnitudes,
        |given| {
            let [r, v] = ["r", "v"].map(|name| direction(given, name));
            given.assume_above(r.dot(v), Term::of(TINY));
            given.assume_at_most(r.dot(v), Term::ONE);
            vec![term::phong(r, v, 1)].into()
        },
    ),
    bound("phong_32", "`phong`, m = 32", 111.5, Of::One, |given| {
        power(given, 32, COSINE, 0.125)
    }),
    bound("blinn_128", "`blinn`, m = 128", 447.5, Of::One, |given| {
        power(given, 128, COSINE, 0.6)
    }),
    bound(
        "raise_32",
        "`Exponent::raise`, m = 32",
        31.0,
        Of::Result,
        |given| vec![32_u32.raise(number(given, "c", 0.125, 1.0))].into(),
    ),
    bound(
        "raise_1000",
        "`Exponent::raise`, m = 1000",
        999.0,
        Of::Result,
        |given| vec![1000_u32.raise(number(given, "c", 0.94, 1.0))].into(),
    ),
    bound(
        "phong_normalization",
        "`phong_normalization`",
        3.0,
        Of::Result,
        |given| vec![term::phong_normalization(number(given, "m", TINY, 1e6))].into(),
    ),
    bound(
        "blinn_normalization",
        "`blinn_normalization`",
        11.75,
        Of::Result,
        |given| vec![term::blinn_normalization(number(given, "m", TINY, 1e6))].into(),
    ),
    bound("attenuation", "`attenuation`", 5.0, Of::Result, |given| {
        let [a, b, c] = coefficients(given);
        vec![attenuation(
            a,
            b,
            c,
            number(given, "q", (-30.0_f64).exp2(), 4.0),
        )]
        .into()
    }),
    bound("ranged", "`Ranged::at`", 8.5, Of::Named('f'), |given| {
        ranged(given, true)
    }),
    bound(
        "ranged_unsquared",
        "`Ranged::at`, unsquared",
        7.0,
        Of::Named('f'),
        |given| ranged(given, false),
    ),
    bound(
        "soft_cone",
        "`SoftCone::factor`",
        11.9,
        Of::Named('w'),
        |given| soft_cone(given, false),
    ),
    bound(
        "smoothstep",
        "`SoftCone::factor`, a smoothstep",
        8.6,
        Of::Named('w'),
        |given| soft_cone(given, true),
    ),
    bound(
        "lamp_direction",
        "`PointLight::at`, direction",
        6.5,
        Of::Result,
        |given| vec![lamp(given).l.x].into(),
    ),
    bound(
        "lamp_intensity",
        "`PointLight::at`, intensity",
        13.0,
        Of::Result,
        |given| vec![lamp(given).intensity.r].into(),
    ),
    bound(
        "shade_lambert",
        "`shade::lambert`, four lights",
        9.0,
        Of::Magnitudes,
        |given| shaded(given, Model::Lambert),
    ),
    bound(
        "highlight_phong",
        "`shade::phong`, m = 32",
        399.5,
        Of::One,
        |given| power(given, 32, 12.0, 0.125),
    ),
    bound(
        "shade_phong",
        "`shade::phong`, m = 32",
        405.5,
        Of::Magnitudes,
        |given| shaded(given, Model::Phong),
    ),
    bound(
        "highlight_blinn",
        "`shade::blinn_phong`, m = 32",
        183.5,
        Of::One,
        |given| power(given, 16, 11.0, 0.125),
    ),
    bound(
        "shade_blinn",
        "`shade::blinn_phong`, m = 32",
        193.0,
        Of::Magnitudes,
        |given| shaded(given, Model::BlinnPhong),
    ),
];

/// What is wrong with the last columns of the table of `docs/precision.md`: "Gappa" needs a bound that is proved, and
/// "hand" a derivation. "hand; Gappa 2.7" is a row whose derivation goes below what Gappa proves.
pub fn complaints(page: &str) -> Vec<String> {
    let rows = page.lines().filter(|line| line.starts_with("| `"));
    let rows: Vec<Vec<&str>> = rows
        .map(|row| row.trim_matches(['|', ' ']).split(" | ").collect())
        .collect();
    let unknown = |bound: &&Bound| rows.iter().all(|row| row[0] != bound.function);
    let unknown = BOUNDS
        .iter()
        .filter(unknown)
        .map(|bound| format!("docs/precision.md has no row {}", bound.function));
    unknown
        .chain(rows.iter().filter_map(|row| complaint(page, row)))
        .collect()
}

fn complaint(page: &str, row: &[&str]) -> Option<String> {
    let &[function, _, _, most, unit, by] = row else {
        return Some(format!("not a row of six cells: {row:?}"));
    };
    // an error of one u is half a unit in the last place of 1
    let units = if unit.starts_with("of 1") { 0.5 } else { 1.0 };
    let tenths = |bound: &Bound| format!("{:.1}", (bound.most * units * 10.0 - 1e-9).ceil() / 10.0);
    // the sum comes after the highlights that it takes
    let proved = BOUNDS
        .iter()
        .rfind(|bound| bound.function == function)
        .map(tenths);
    let name = function.split_inclusive('`').take(2).collect::<String>();
    let is_derived = page
        .split("\n- **")
        .skip(1)
        .any(|part| part.split("**").next().is_some_and(|of| of.contains(&name)));
    match (by, proved) {
        ("hand", None) if is_derived => None,
        ("Gappa", Some(proved)) if proved == most => None,
        ("Gappa, hand", Some(proved)) if proved == most && is_derived => None,
        (by, Some(proved)) if is_derived && by == format!("hand; Gappa {proved}") => None,
        (_, proved) => Some(format!(
            "{function}: {most} by {by}, but Gappa proves {proved:?}"
        )),
    }
}

/// Writes one script for a share of each bound, format and way through the formula, but for vectors that are rescaled.
pub fn write(folder: &Path, share: f64) -> std::io::Result<()> {
    fs::create_dir_all(folder)?;
    for Bound {
        name,
        most,
        of,
        formula,
        ..
    } in BOUNDS
    {
        for format in [Format::F32, Format::F64] {
            let mut scripts = Vec::new();
            paths(format, formula, |run, formula| {
                let is_rescaled = |&(test, answer): &(Test, bool)| {
                    answer && matches!(test, Test::Outside(_, _, high) if high == Term::EXTREME.0)
                };
                if !run.path.iter().any(is_rescaled) {
                    let write = |&result| {
                        Script::new(&run.graph, run.known.clone(), &formula).text(
                            result,
                            *most * share,
                            *of,
                        )
                    };
                    scripts.extend(formula.results.iter().map(write));
                }
            });
            assert!(!scripts.is_empty(), "{name} has no way");
            for (way, script) in scripts.into_iter().enumerate() {
                fs::write(folder.join(format!("{name}.{way}.{format:?}.g")), script)?;
            }
        }
    }
    Ok(())
}
