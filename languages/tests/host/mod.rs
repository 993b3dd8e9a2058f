//! Programs in C, which compute the functions of a header for the numbers that they read.

#![allow(dead_code)] // each test uses a part

use std::fmt::Write as _;
use std::io::{Read, Write as _};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use shading::Rgb;
use shading_languages::{Function, Kind, functions};

/// A program that computes the function of `shading.h` that its argument names; one of some.
pub fn program(which: impl Fn(&str) -> bool) -> String {
    let mut out = String::from("#include \"shading.h\"\n#include <stdio.h>\n\n");
    let functions = || functions().iter().filter(|function| which(function.name));
    for function in functions() {
        out += &reader(function);
    }
    out += LEVELS;
    out += "int main(int argc, char **argv) {\n    if (argc != 2) {\n        return 1;\n    }\n";
    for Function { name, .. } in functions() {
        writeln!(
            out,
            "    if (strcmp(argv[1], \"{name}\") == 0) {{\n        return f_{name}();\n    }}"
        )
        .unwrap();
    }
    out += "    if (strcmp(argv[1], \"levels\") == 0) {\n        return levels();\n    }\n";
    out + "    return 1;\n}\n"
}

/// Reads light, and writes its levels of 8 bits and of RGB565.
const LEVELS: &str = "\
static int levels(void) {
    float x;
    while (fread(&x, sizeof x, 1, stdin) == 1) {
        uint16_t y[2];
        y[0] = shading_to_srgb8(x);
        y[1] = shading_to_rgb565(shading_vector(x, x, x));
        fwrite(y, sizeof y, 1, stdout);
    }
    return 0;
}

";

/// A function that reads arguments, and writes results.
fn reader(function: &Function) -> String {
    let mut at = 0;
    let mut arguments: Vec<_> = function
        .parameters
        .iter()
        .map(|p| argument(p.1, &mut at))
        .collect();
    let (name, of) = (function.name, type_of(function.result));
    let call = if function.parameters[0].1 == function.result && function.result.fields().is_some()
    {
        // it changes its first argument
        let before = std::mem::replace(&mut arguments[0], "&r".into());
        let before = before.trim_start_matches('&');
        format!(
            "{of} r = {before};\n        shading_{name}({});",
            arguments.join(", ")
        )
    } else {
        format!("{of} r = shading_{name}({});", arguments.join(", "))
    };
    let results = numbers("r", function.result);
    let stores = (0..)
        .zip(&results)
        .fold(String::new(), |stores, (i, number)| {
            format!("{stores}        y[{i}] = {number};\n")
        });
    format!(
        "static int f_{name}(void) {{
    float x[{at}], y[{}];
    while (fread(x, sizeof x, 1, stdin) == 1) {{
        {call}
{stores}        fwrite(y, sizeof y, 1, stdout);
    }}
    return 0;
}}

",
        results.len()
    )
}

fn type_of(kind: Kind) -> String {
    match (kind.fields(), kind.width()) {
        (Some((name, _, _)), _) => format!("shading_{name}"),
        (None, 1) => "float".into(),
        (None, width) => format!("shading_vec{width}"),
    }
}

/// An argument of the numbers from one on; a struct is passed by a pointer.
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
    let pointer = if kind.fields().is_some() { "&" } else { "" };
    format!("{pointer}({}){{{}}}", type_of(kind), parts.join(", "))
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

/// A header of this package.
pub fn header(name: &str) -> String {
    std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(name)).expect("a header")
}

/// Compiles a text in C to a program, or says why it cannot be.
pub fn compiled(command: &[&str], source: &str, name: &str) -> Result<PathBuf, String> {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    let (file, program) = (folder.join(format!("{name}.c")), folder.join(name));
    std::fs::write(&file, source).unwrap();
    let output = Command::new(command[0])
        .args(&command[1..])
        .args(["-ffp-contract=off", "-o"])
        .args([&program, &file])
        .args(["-I", env!("CARGO_MANIFEST_DIR"), "-lm"])
        .output()
        .expect("a compiler");
    if output.status.success() {
        Ok(program)
    } else {
        Err(String::from_utf8_lossy(&output.stderr).into_owned())
    }
}

/// What a compiler sees of a text in C.
pub fn preprocessed(command: &[&str], source: &str, name: &str) -> Vec<u8> {
    let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{name}.c"));
    std::fs::write(&file, source).unwrap();
    let output = Command::new(command[0])
        .args(&command[1..])
        .args(["-E", "-P"])
        .arg(&file)
        .output()
        .expect("a compiler");
    output.stdout
}

/// What a program answers to what it reads; nothing, if it fails or takes a quarter of a minute.
pub fn answer(program: &Path, argument: &str, input: &[u8]) -> Option<Vec<u8>> {
    let mut child = Command::new("timeout")
        .arg("15")
        .arg(program)
        .arg(argument)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("the program starts");
    let (mut stdin, mut stdout) = (child.stdin.take().unwrap(), child.stdout.take().unwrap());
    let mut output = vec![];
    std::thread::scope(|scope| {
        // a program that ends early does not read all
        scope.spawn(move || stdin.write_all(input).ok());
        stdout.read_to_end(&mut output).unwrap();
    });
    child.wait().unwrap().success().then_some(output)
}

pub fn bytes(numbers: &[f32]) -> Vec<u8> {
    numbers.iter().flat_map(|x| x.to_le_bytes()).collect()
}

/// Red's level of 5 bits, green's of 6 bits and red's of 8 bits, of a gray.
fn levels(x: f32) -> [u32; 3] {
    let (gray, bits) = (Rgb::gray(x), u32::from(Rgb::gray(x).to_rgb565()));
    [bits >> 11, bits >> 5 & 63, gray.to_srgb8()[0].into()]
}

/// The least light of each level and the number below, beside numbers out of range. Levels rise with light, so a
/// function that has these has all.
pub fn light() -> Vec<f32> {
    let mut all = vec![
        0.0,
        -0.0,
        -1.0,
        1.0,
        2.0,
        f32::MAX,
        f32::MIN,
        f32::MIN_POSITIVE,
    ];
    for (encoding, highest) in [31, 63, 255].into_iter().enumerate() {
        for level in 1..=highest {
            let (mut below, mut from) = (0.0_f32, 1.0_f32);
            while from.to_bits() - below.to_bits() > 1 {
                let middle = f32::from_bits(u32::midpoint(below.to_bits(), from.to_bits()));
                if levels(middle)[encoding] < level {
                    below = middle;
                } else {
                    from = middle;
                }
            }
            all.extend([below, from]);
        }
    }
    all
}

pub fn levels_by_the_crate(light: &[f32]) -> Vec<u8> {
    let of = |x: &f32| {
        let byte = u16::from(Rgb::gray(*x).to_srgb8()[0]);
        [byte, Rgb::gray(*x).to_rgb565()].map(u16::to_le_bytes)
    };
    light.iter().flat_map(of).flatten().collect()
}
