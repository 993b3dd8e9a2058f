//! Every function of `shading.h` has the bits of the crate.

#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss
)]

use std::fmt::Write as _;
use std::io::{Read, Write as _};
use std::process::{Command, Stdio};

use shading_languages::{Arguments, Function, Kind, functions};

/// A program that computes the function that its argument names, for the numbers that it reads.
fn program() -> String {
    let mut out = String::from("#include \"shading.h\"\n#include <stdio.h>\n\n");
    for function in functions() {
        let mut at = 0;
        let arguments: Vec<_> = function
            .parameters
            .iter()
            .map(|p| argument(p.1, &mut at))
            .collect();
        let (name, arguments) = (function.name, arguments.join(", "));
        let results = numbers("r", function.result);
        let result = type_of(function.result);
        writeln!(
            out,
            "static int f_{name}(void) {{\n    float x[{at}], y[{}];",
            results.len()
        )
        .unwrap();
        writeln!(out, "    while (fread(x, sizeof x, 1, stdin) == 1) {{").unwrap();
        writeln!(out, "        {result} r = shading_{name}({arguments});").unwrap();
        for (i, number) in results.iter().enumerate() {
            writeln!(out, "        y[{i}] = {number};").unwrap();
        }
        writeln!(
            out,
            "        fwrite(y, sizeof y, 1, stdout);\n    }}\n    return 0;\n}}\n"
        )
        .unwrap();
    }
    out += "int main(int argc, char **argv) {\n    if (argc != 2) {\n        return 1;\n    }\n";
    for Function { name, .. } in functions() {
        writeln!(
            out,
            "    if (strcmp(argv[1], \"{name}\") == 0) {{\n        return f_{name}();\n    }}"
        )
        .unwrap();
    }
    out + "    return 1;\n}\n"
}

fn type_of(kind: Kind) -> String {
    match (kind.fields(), kind.width()) {
        (Some((name, _, _)), _) => format!("shading_{name}"),
        (None, 1) => "float".into(),
        (None, width) => format!("shading_vec{width}"),
    }
}

fn argument(kind: Kind, at: &mut usize) -> String {
    if kind.width() == 1 {
        *at += 1;
        return format!("x[{}]", *at - 1);
    }
    let parts: Vec<_> = match kind.fields() {
        Some((_, _, fields)) => fields.iter().map(|field| argument(field.1, at)).collect(),
        None => (0..kind.width())
            .map(|_| argument(Kind::Number, at))
            .collect(),
    };
    format!("({}){{{}}}", type_of(kind), parts.join(", "))
}

fn numbers(of: &str, kind: Kind) -> Vec<String> {
    match (kind.fields(), kind.width()) {
        (Some((_, _, fields)), _) => {
            let field = |(name, kind): &(&str, Kind)| numbers(&format!("{of}.{name}"), *kind);
            fields.iter().flat_map(field).collect()
        }
        (None, 1) => vec![of.into()],
        (None, width) => ["x", "y", "z"][..width]
            .iter()
            .map(|c| format!("{of}.{c}"))
            .collect(),
    }
}

/// How the numbers of an argument are drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Draw {
    Ordinary,
    /// 0, −0, ±1, the least and the largest, beside ordinary ones.
    Special,
    /// From the least number to the largest, each of its own size.
    Extreme,
}

struct Random {
    state: u64,
    draw: Draw,
}

impl Random {
    fn bits(&mut self) -> u64 {
        self.state = self
            .state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.state >> 33) ^ (self.state >> 11)
    }

    fn fraction(&mut self) -> f32 {
        (self.bits() & 0xFF_FFFF) as f32 / 16_777_216.0
    }

    fn special(&mut self, of: &[f32], otherwise: f32) -> f32 {
        if self.draw == Draw::Special && self.bits() & 1 == 0 {
            of[self.bits() as usize % of.len()]
        } else {
            otherwise
        }
    }

    /// 10^x for an x from −45 to 38.5.
    fn size(&mut self) -> f32 {
        if self.draw == Draw::Extreme {
            10_f64.powf(f64::from(self.fraction()) * 83.5 - 45.0) as f32
        } else {
            4.0
        }
    }

    fn signed(&mut self) -> f32 {
        let x = 2.0 * self.fraction() - 1.0;
        self.special(&[0.0, -0.0, 1.0, -1.0, 0.5, 0.999_999_9, -0.999_999_9], x)
    }

    fn positive(&mut self, size: f32) -> f32 {
        let x = size * self.fraction();
        self.special(&[0.0, 1.0, 1e-12, f32::MAX, f32::MIN_POSITIVE], x)
    }

    fn unit(&mut self) -> [f32; 3] {
        let v = shading::Vec3::new(self.signed(), self.signed(), self.signed());
        <[f32; 3]>::from(v.unit_or(shading::UnitVec3::Z))
    }

    fn draw(&mut self, name: &str, kind: Kind, all: &mut Vec<f32>) {
        match kind {
            Kind::Flag => all.push((self.bits() & 1) as f32),
            Kind::Cosine => {
                let x = self.signed();
                all.push(x);
            }
            Kind::Fraction => {
                let x = self.fraction();
                let x = self.special(&[0.0, 1.0, f32::MIN_POSITIVE, 0.999_999_94], x);
                all.push(x);
            }
            Kind::Number => {
                let x = self.signed() * self.size();
                all.push(x);
            }
            Kind::Positive => {
                let size = match name {
                    "m" => 200.0,
                    _ => 8.0,
                };
                let size = if self.draw == Draw::Extreme {
                    self.size()
                } else {
                    size
                };
                let x = self.positive(size);
                // a range and a limit are above 0
                all.push(if matches!(name, "range" | "limit" | "r") {
                    x.max(1e-30)
                } else {
                    x
                });
            }
            Kind::Pair => all.extend([self.signed(), self.signed()]),
            Kind::Cosines => {
                let (a, b) = (self.signed() + 0.0, self.signed() + 0.0);
                all.extend(if a > b { [a, b] } else { [b, a] });
            }
            Kind::Vector => {
                let size = self.size();
                let apart = self.draw == Draw::Extreme && self.bits() & 1 == 0;
                for _ in 0..3 {
                    let size = if apart { self.size() } else { size };
                    all.push(size * self.signed());
                }
            }
            Kind::Unit => all.extend(self.unit()),
            Kind::Color if name == "coefficients" => {
                for _ in 0..3 {
                    let x = self.positive(1.0).min(1e30);
                    all.push(x);
                }
                // not all are 0
                let at = all.len() - 3;
                if all[at..] == [0.0; 3] {
                    all[at] = 1.0;
                }
            }
            Kind::Color => {
                let size = if self.draw == Draw::Extreme {
                    self.size().min(1e18)
                } else {
                    1.0
                };
                for _ in 0..3 {
                    let x = size * self.fraction();
                    all.push(self.special(&[0.0, 1.0], x));
                }
            }
            _ => {
                for (name, kind) in kind.fields().expect("a struct").2 {
                    self.draw(name, *kind, all);
                }
            }
        }
    }
}

/// The results of a program for many arguments.
fn run(program: &std::path::Path, function: &Function, numbers: &[f32]) -> Vec<f32> {
    let mut child = Command::new(program)
        .arg(function.name)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("the program starts");
    let bytes: Vec<u8> = numbers.iter().flat_map(|x| x.to_le_bytes()).collect();
    let mut stdin = child.stdin.take().unwrap();
    let writer = std::thread::spawn(move || stdin.write_all(&bytes).unwrap());
    let mut bytes = vec![];
    child
        .stdout
        .take()
        .unwrap()
        .read_to_end(&mut bytes)
        .unwrap();
    writer.join().unwrap();
    assert!(child.wait().unwrap().success());
    bytes
        .chunks_exact(4)
        .map(|b| f32::from_le_bytes(b.try_into().unwrap()))
        .collect()
}

/// The first difference between the program and the crate.
fn difference(
    program: &std::path::Path,
    function: &Function,
    draw: Draw,
    count: usize,
) -> Option<String> {
    let mut random = Random { state: 7, draw };
    let mut all = vec![];
    for _ in 0..count {
        function
            .parameters
            .iter()
            .for_each(|p| random.draw(p.0, p.1, &mut all));
    }
    let width: usize = function.parameters.iter().map(|p| p.1.width()).sum();
    let found = run(program, function, &all);
    let mut different = 0;
    let mut first = None;
    for (x, y) in all.chunks(width).zip(found.chunks(function.result.width())) {
        let right = (function.compute)(Arguments::new(x.to_vec()));
        assert_eq!(right.len(), y.len());
        if right.iter().zip(y).any(|(a, b)| a.to_bits() != b.to_bits()) {
            different += 1;
            first.get_or_insert_with(|| format!("{x:?}: the crate {right:?}, the file {y:?}"));
        }
        let is_light = !matches!(
            function.result,
            Kind::Unit | Kind::Vector | Kind::Tangent | Kind::Measured
        );
        for y in y {
            assert!(!y.is_nan(), "{} {draw:?} {x:?}: {y}", function.name);
            assert!(
                *y >= 0.0 || !is_light || function.result == Kind::Arrival,
                "{} {x:?}: {y}",
                function.name
            );
        }
    }
    assert_eq!(found.len(), count * function.result.width());
    first.map(|first| {
        format!(
            "{} {draw:?}: {different} of {count}, first {first}",
            function.name
        )
    })
}

fn compiled(compiler: &str, flags: &[&str], name: &str) -> std::path::PathBuf {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR"));
    let (source, program_) = (folder.join(format!("{name}.c")), folder.join(name));
    std::fs::write(&source, program()).unwrap();
    let status = Command::new(compiler)
        .args(flags)
        .args(["-I", env!("CARGO_MANIFEST_DIR"), "-o"])
        .arg(&program_)
        .arg(&source)
        .arg("-lm")
        .status()
        .expect("a compiler");
    assert!(status.success());
    program_
}

#[test]
fn each_bit_is_the_crates() {
    let program = compiled("gcc", &["-std=c99", "-O2", "-ffp-contract=off"], "bits-gcc");
    let mut all = vec![];
    for draw in [Draw::Ordinary, Draw::Special, Draw::Extreme] {
        all.extend(
            functions()
                .iter()
                .filter_map(|function| difference(&program, function, draw, 20_000)),
        );
    }
    assert!(all.is_empty(), "{}", all.join("\n"));
}
