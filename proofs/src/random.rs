//! Random formulas, by which the prover is tested: with numbers, each value must lie in the range that the
//! prover derives for it, have the bits that `f32` or `f64` gives, and keep to every goal that is proved.

use shading::{Real, UnitVec3, Vec3, reflection};
use shading_proofs::{Format, Given, Goal, Known, Node, Range, Run, Term, try_out};

/// A linear congruential generator (Knuth's constants).
#[derive(Clone)]
struct Random(u64);

impl Random {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        usize::try_from(self.0 >> 33).expect("31 bits") % n
    }
    fn pick<T: Copy>(&mut self, values: &[T]) -> T {
        values[self.below(values.len())]
    }
    /// Vectors share their components more often than chance would have it.
    fn vector<T: Real>(&mut self, values: &[T]) -> Vec3<T> {
        match self.below(4) {
            i @ 0..3 => Vec3::new(values[3 * i], values[3 * i + 1], values[3 * i + 2]),
            _ => [0; 3].map(|_| self.pick(values)).into(),
        }
    }
    fn range(&mut self) -> Range {
        let (tiny, big) = ((-140.0_f64).exp2(), 120.0_f64.exp2());
        match self.below(10) {
            0 | 1 => Range::ANY,
            2 => Range::within(0.0, f64::INFINITY),
            3 => Range::unsigned(0.0, 2.0),
            4 => Range::within(-1.0, 1.0),
            5 => Range::within(-tiny, tiny),
            6 => Range::within(-big, big),
            7 => Range::within(f64::NEG_INFINITY, f64::INFINITY),
            8 => Range::NOT_FINITE,
            _ => Range::within(0.0, 0.0).or_nan(),
        }
    }
}

const VARIABLES: usize = 9;

/// Up to 24 operations on nine numbers, the same for the same seed.
fn formula<T: Real + PartialOrd>(mut random: Random, variables: [T; VARIABLES]) -> Vec<T> {
    let mut values = variables.to_vec();
    for _ in 0..random.below(22) + 3 {
        let [x, y, a, b] = [0; 4].map(|_| random.pick(&values));
        let value = match random.below(23) {
            0 | 1 => x + y,
            2 | 3 => x - y,
            4 | 5 => x * y,
            6 | 7 => x / y,
            8 => x.sqrt(),
            9 => x.if_above(y, a, b),
            10 => {
                let same = x;
                [x.abs(), -x, x * x, x - same][random.below(4)]
            }
            11 => [x.at_least(T::ZERO), x.at_most(T::ONE), x.at_most(T::MAX)][random.below(3)],
            12 => random.vector(&values).dot(random.vector(&values)),
            13 => random.vector(&values).cross(random.vector(&values)).x,
            14 => random.vector(&values).length(),
            15 => {
                let v = random.vector(&values);
                v.x / v.dot(v).sqrt()
            }
            16 => cosine(random.vector(&values), random.vector(&values), b),
            17 => {
                // parallel vectors, whose cosine rounding takes beyond 1
                let v = random.vector(&values);
                cosine(v, v * a, b)
            }
            18 => {
                let (n, v) = (random.vector(&values), random.vector(&values));
                let v = [v, n.cross(v)][random.below(2)]; // almost at right angles
                let c = [T::of(-1.0 / 512.0), T::of(-1e-20), T::ZERO][random.below(3)];
                seen_from_behind(n, v, c, [T::ONE / T::EXTREME, T::ZERO][random.below(2)])
            }
            22 => {
                let n = random.vector(&values);
                let l = [n, random.vector(&values)][random.below(2)];
                mirrored(n, l, x)
            }
            19 if random.below(3) == 0 => (x - y) / (x + y),
            19 => slope([x, x.abs(), T::ONE][random.below(3)], y),
            _ => {
                // a decision, from which the prover learns
                let is_decided = [x > y, x <= y, x == y, (x - y).any_positive()][random.below(4)];
                if is_decided { x * x } else { x / x.abs() }
            }
        };
        values.push(value);
    }
    values
}

/// The cosine between two vectors, or another number that is computed from the products of their components.
fn cosine<T: Real + PartialOrd>(v: Vec3<T>, w: Vec3<T>, other: T) -> T {
    let (a, b) = (v.dot(v), w.dot(w));
    if a > T::ZERO && b > T::ZERO {
        let products = other.if_positive(v.dot(w), v.cross(w).x);
        products / (a.sqrt() * b.sqrt())
    } else {
        other
    }
}

/// The quotient of two numbers or of their difference and sum, whichever is small.
fn slope<T: Real + PartialOrd>(s: T, c: T) -> T {
    if c.abs() * T::of(2.4) > s {
        if s > c.abs() * T::of(0.4) {
            (s - c.abs()) / (s + c.abs())
        } else {
            s / c
        }
    } else {
        c / s
    }
}

/// N·L of a unit vector toward a light that seems to be behind: n·v < c(|x| + |y| + |z|) − t.
fn seen_from_behind<T: Real + PartialOrd>(n: Vec3<T>, v: Vec3<T>, c: T, t: T) -> T {
    let (Vec3 { x, y, z }, n) = (
        T::rescaled_difference(v.into(), [T::ZERO; 3]).0.into(),
        n * (T::ONE / n.length()),
    );
    let size = v.x.abs() + v.y.abs() + v.z.abs();
    let l = Vec3::new(x, y, z) * (T::ONE / (x * x + y * y + z * z).sqrt());
    if size * c - t > n.dot(v) {
        n.dot(l)
    } else {
        size
    }
}

/// The mirror image of a direction, or its square, where the mirror is longer than 1.
fn mirrored<T: Real + PartialOrd>(n: Vec3<T>, l: Vec3<T>, other: T) -> T {
    let (n, l) = (n * (T::of(1.0001) / n.length()), l * (T::ONE / l.length()));
    let is_near = |square: T, one: f64| square > T::of(one - 1e-6) && T::of(one + 1e-6) > square;
    if is_near(n.dot(n), 1.000_200_01) && is_near(l.dot(l), 1.0) {
        let r: Vec3<T> = reflection(UnitVec3::assume_unit(n), UnitVec3::assume_unit(l)).into();
        other.if_positive(r.x, r.dot(r))
    } else {
        other
    }
}

fn goals(mut random: Random, terms: &[Term]) -> Vec<Goal> {
    let mut goals = Vec::new();
    for _ in 0..6 {
        let [x, y] = [0; 2].map(|_| random.pick(terms));
        let (zero, one) = (Term::ZERO, Term::ONE);
        goals.extend([
            Goal::Same(x, y),
            Goal::AtMost(x, y),
            Goal::Same(x + zero, x),
            Goal::Same(x * one, x),
        ]);
        goals.extend([
            Goal::Same(x.at_least(zero), x),
            Goal::Same(x.if_above(y, x, y), x),
            Goal::AtMost(x, x.at_least(y)),
        ]);
        goals.extend([
            Goal::Same(-(x - y), y - x),
            Goal::AtMost(x * y, y * x),
            Goal::AtMost(x, (y * y).sqrt()),
        ]);
    }
    goals
}

/// Tests the prover with one formula and some inputs; returns how many values were compared.
pub fn check(seed: u64, format: Format, runs: u64) -> Result<u64, String> {
    let random = Random(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15));
    let (mut compared, mut wrong) = (0, None);
    let run = |given: Given| {
        let mut ranges = random.clone();
        let variables = std::array::from_fn(|i| given.number(&format!("x{i}"), ranges.range()));
        let terms = formula(random.clone(), variables);
        goals(random.clone(), &terms)
            .into_iter()
            .chain(terms.into_iter().map(|term| Goal::Same(term, term)))
            .collect()
    };
    try_out(format, run, runs, |Run { graph: g, path, .. }, goals| {
        let mut known = Known::default();
        for &(test, answer) in path {
            known.refine(g, test, answer);
        }
        let mut variables = g
            .nodes
            .iter()
            .zip(&g.values)
            .filter(|(node, _)| matches!(node, Node::Var(_)));
        let variables: [f64; VARIABLES] =
            std::array::from_fn(|_| *variables.next().expect("a variable").1);
        let floats: Vec<f64> = match format {
            #[allow(clippy::cast_possible_truncation)] // it is one of these numbers
            Format::F32 => formula(random.clone(), variables.map(|x| x as f32))
                .into_iter()
                .map(f64::from)
                .collect(),
            Format::F64 => formula(random.clone(), variables),
        };
        let of_terms = goals[goals.len() - floats.len()..]
            .iter()
            .map(|goal| g.values[goal.nodes()[0] as usize]);
        let differs =
            |(a, b): (f64, &f64)| a.to_bits() != b.to_bits() && !(a.is_nan() && b.is_nan());
        let outside = (0..)
            .zip(&g.values)
            .find(|&(id, x)| !known.range(g, id).contains(*x));
        if known.impossible {
            wrong = Some(format!("the path {path:?} is not impossible"));
        } else if let Some((id, x)) = outside {
            wrong = Some(format!(
                "{:?} is {x:e}, not in {:?}",
                g.nodes[id as usize],
                known.range(g, id)
            ));
        } else if let Some((a, b)) = of_terms.zip(&floats).find(|&pair| differs(pair)) {
            wrong = Some(format!("{a:e} is not {b:e}"));
        } else if let Some(goal) = goals
            .iter()
            .find(|goal| !goal.holds(g) && goal.is_proved(g, &known))
        {
            wrong = Some(format!("{goal:?} is proved, and wrong"));
        }
        compared += g.values.len() as u64;
        wrong.is_none()
    });
    wrong.map_or(Ok(compared), |wrong| {
        Err(format!("{format:?}, formula {seed}: {wrong}"))
    })
}
