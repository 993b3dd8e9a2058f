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
use support::{Draw, arguments};

mod support;

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
    let all = arguments(function, draw, count);
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
