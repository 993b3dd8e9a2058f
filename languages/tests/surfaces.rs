//! A surface of the user's, and its normal, are in C what they are in Rust, on each path through its decisions.

use std::fmt::Write;

use host::{answer, bytes, compiled};
use shading::number::Mask;
use shading::{Dual, Elementary, Real, Scalar, UnitVec3, Vec3, normal};
use shading_languages::dialect::C;
use shading_languages::{implicit, parametric};
use surface::{figure, pencil, rounded_box, wave};

mod host;
mod surface;

/// The numbers of a point or a direction; 0 where there is none.
fn numbers(of: Option<UnitVec3<f32>>) -> [f32; 3] {
    of.map_or([0.0; 3], |n| <[f32; 3]>::from(*n))
}

/// Multiples of 1/4, of which many are equal, and numbers between.
fn coordinates() -> Vec<f32> {
    let quarters = (-6_i8..=6).map(|i| f32::from(i) * 0.25);
    quarters.chain([-0.9, 0.1, 0.3, 0.77, 1.9]).collect()
}

/// Surfaces in C beside what Rust computes.
#[derive(Default)]
struct Surfaces {
    text: String,
    main: String,
    arguments: Vec<f32>,
    expected: Vec<(String, Vec<f32>)>,
}

impl Surfaces {
    /// Adds a surface as text, how its numbers are called, and its arguments and numbers.
    fn add(&mut self, name: &str, text: &str, call: &str, rows: Vec<(Vec<f32>, Vec<f32>)>) {
        let Some((arguments, results)) = rows.first() else {
            return;
        };
        let (width, count) = (arguments.len(), results.len());
        let calls = rows.len();
        self.text += text;
        write!(
            self.main,
            "    for (i = 0; i < {calls}; i++) {{
        float x[{width}], y[{count}];
        if (fread(x, sizeof x, 1, stdin) != 1) return 1;
        {call}
        fwrite(y, sizeof y, 1, stdout);
    }}
"
        )
        .unwrap();
        for (arguments, results) in rows {
            self.arguments.extend(&arguments);
            self.expected
                .push((format!("{name}{arguments:?}"), results));
        }
    }

    /// Adds f(p) = 0, at the points whose numbers are kept.
    fn implicit(
        &mut self,
        name: &str,
        text: &str,
        points: &[Vec3<f32>],
        of: impl Fn(Vec3<f32>) -> Option<(f32, Option<UnitVec3<f32>>)>,
    ) {
        let row = |p: &Vec3<f32>| {
            let (value, n) = of(*p)?;
            Some((vec![p.x, p.y, p.z], [&[value], &numbers(n)[..]].concat()))
        };
        let rows = points.iter().filter_map(row).collect();
        let call = format!(
            "shading_vec3 p = shading_vector(x[0], x[1], x[2]), n = {name}_normal(p);
        y[0] = {name}(p), y[1] = n.x, y[2] = n.y, y[3] = n.z;"
        );
        self.add(name, text, &call, rows);
    }

    /// Asserts that the program in C gives what Rust does, but for the roundoff of its library.
    fn agree(&self, program: &str, roundoff: f32) {
        let (text, main) = (&self.text, &self.main);
        let text = format!(
            "#include <stdio.h>\n#include \"shading.h\"\n{text}
int main(void) {{\n    int i;\n{main}    return 0;\n}}\n"
        );
        let command = "gcc -std=c99 -O1 -Wall -Wno-unused-function -Wno-unused-variable";
        let program = compiled(&command.split(' ').collect::<Vec<_>>(), &text, program).unwrap();
        let found = answer(&program, "", &bytes(&self.arguments)).expect("an answer");
        let mut found = found
            .chunks_exact(4)
            .map(|b| f32::from_le_bytes(b.try_into().unwrap()));
        for (row, right) in &self.expected {
            let found: Vec<_> = found.by_ref().take(right.len()).collect();
            assert_eq!(found.len(), right.len());
            let is_same = |(a, b): (&f32, &f32)| {
                (a - b).abs() <= roundoff * a.abs().max(1.0) || a.is_nan() && b.is_nan()
            };
            assert!(
                right.iter().zip(&found).all(is_same),
                "{row}: in Rust {right:?}, in C {found:?}"
            );
        }
    }
}

fn points() -> Vec<Vec3<f32>> {
    let all = coordinates();
    let with = |x: f32| {
        all.iter()
            .flat_map(|y| all.iter().map(|z| Vec3::new(x, *y, *z)))
            .collect::<Vec<_>>()
    };
    all.iter().flat_map(|x| with(*x)).collect()
}

macro_rules! add_implicit {
    ($surfaces:ident $f:ident) => {
        let of = |p| Some(($f(p), normal::implicit($f, p)));
        $surfaces.implicit(
            stringify!($f),
            &implicit(&C, stringify!($f), $f, $f),
            &points(),
            of,
        );
    };
}

macro_rules! add_parametric {
    ($surfaces:ident $s:ident) => {
        let name = stringify!($s);
        let mut rows = vec![];
        for u in coordinates() {
            for v in coordinates() {
                let n = numbers(normal::parametric($s, u, v));
                rows.push((vec![u, v], [<[f32; 3]>::from($s(u, v)), n].concat()));
            }
        }
        let call = format!(
            "shading_vec3 s = {name}(x[0], x[1]), n = {name}_normal(x[0], x[1]);
        y[0] = s.x, y[1] = s.y, y[2] = s.z, y[3] = n.x, y[4] = n.y, y[5] = n.z;"
        );
        $surfaces.add(name, &parametric(&C, name, $s, $s), &call, rows);
    };
}

#[test]
fn a_surface_is_what_it_is_in_rust_on_each_path() {
    // it calls no function of the library of C, so its numbers are the crate's, but for the sign of 0
    let mut exact = Surfaces::default();
    add_implicit!(exact figure);
    exact.agree("exact", 0.0);
    let mut others = Surfaces::default();
    add_implicit!(others rounded_box);
    add_parametric!(others wave);
    add_parametric!(others pencil);
    others.agree("others", 1e-6);
}

/// A surface at random: each step computes a number from some of those before.
struct Drawn(Vec<(u8, [usize; 4])>);

impl Drawn {
    const CONSTANTS: [f64; 6] = [0.0, 1.0, -1.0, 0.5, 2.0, 1e10];

    fn new(random: &mut fastrand::Rng) -> Self {
        let first = 3 + Self::CONSTANTS.len();
        let step = |i: usize| {
            (
                random.u8(0..18),
                std::array::from_fn(|_| random.usize(0..first + i)),
            )
        };
        Self((0..8).map(step).collect())
    }

    /// The numbers of the point, the constants, and those of each step.
    fn numbers<T: Elementary + Scalar + PartialOrd>(&self, p: Vec3<T>) -> Vec<T> {
        let mut all = vec![p.x, p.y, p.z];
        all.extend(Self::CONSTANTS.map(T::of));
        for (op, of) in &self.0 {
            let [a, b, c, d] = of.map(|i| all[i]);
            let (v, w) = (Vec3::new(a, b, c), Vec3::new(b, c, d));
            all.push(match op {
                0 => a + b,
                1 => a - b,
                2 => a * b,
                3 => a / b,
                4 => -a,
                5 => a.abs().sqrt(),
                6 => a.at_least(b),
                7 => a.at_most(b),
                8 => a.above(b).select(c, d),
                9 => {
                    if a < b {
                        c
                    } else {
                        d
                    }
                }
                10 => {
                    if a >= b {
                        c
                    } else {
                        d
                    }
                }
                11 => {
                    if a <= b && c > d {
                        a
                    } else {
                        c
                    }
                }
                12 => {
                    if a == b || a > c {
                        d
                    } else {
                        a
                    }
                }
                13 => v.length(),
                14 => v.dot(w),
                15 => v.cross(w).z,
                16 => v.unit().map_or(d, |n| n.y),
                _ => (p * a - v * b).dot(p),
            });
        }
        all
    }

    fn value<T: Elementary + Scalar + PartialOrd>(&self, p: Vec3<T>) -> T {
        *self.numbers(p).last().unwrap()
    }
}

#[test]
fn a_surface_at_random_is_what_it_is_in_rust_where_its_numbers_are_finite() {
    let mut random = fastrand::Rng::with_seed(7);
    let mut surfaces = Surfaces::default();
    for i in 0..100 {
        let (name, drawn) = (format!("drawn_{i}"), Drawn::new(&mut random));
        let text = implicit(&C, &name, |p| drawn.value(p), |p| drawn.value(p));
        let points = points();
        let points: Vec<_> = (0..60)
            .map(|_| points[random.usize(..points.len())])
            .collect();
        surfaces.implicit(&name, &text, &points, |p| {
            let is_finite = |x: &Dual<f32>| {
                let Vec3 {
                    x: d_x,
                    y: d_y,
                    z: d_z,
                } = x.gradient;
                [x.value, d_x, d_y, d_z].iter().all(|x| x.is_finite())
            };
            let numbers = drawn.numbers(Dual::point(p));
            let surface = || (drawn.value(p), normal::implicit(|p| drawn.value(p), p));
            numbers.iter().all(is_finite).then(surface)
        });
    }
    surfaces.agree("drawn", 0.0);
}

#[test]
#[should_panic(expected = "a formula takes more than 64 decisions")]
fn a_loop_until_a_number_is_small_is_refused() {
    fn halved<T: Real + PartialOrd>(p: Vec3<T>) -> T {
        let mut x = p.x;
        while x > T::ONE {
            x = x / T::of(2.0);
        }
        x
    }
    let _ = implicit(&C, "halved", halved, halved);
}

#[test]
fn a_long_formula_is_written_as_fast_as_a_short_one() {
    // each number is used several times, so that a text without variables would have 4^24 of them
    fn iterated<T: Real>(p: Vec3<T>) -> T {
        let (mut x, mut y) = (p.x, p.y);
        for _ in 0..24 {
            (x, y) = (x * x - y * y + p.x, (x + x) * y + p.y);
        }
        x * x + y * y - T::of(4.0)
    }
    let text = implicit(&C, "iterated", iterated, iterated);
    assert!((100..400).contains(&text.lines().count()));
}
