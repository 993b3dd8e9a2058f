//! Every function of the files in HLSL and in Metal, by the compilers that run without Direct3D and without macOS:
//! glslang translates HLSL to SPIR-V, and g++ takes Metal as C++, through a shim.

use std::borrow::Cow;
use std::fmt::Write as _;
use std::fs;
use std::io::Write as _;
use std::path::Path;
use std::process::{Command, Stdio};

use shading_languages::{Function, Kind, functions};
use wgpu::ShaderSource;

use crate::Result;
use crate::gpu::Gpu;
use crate::rows::{CALLS, Power, Tally, compare_shaders, numbers, of_file};

fn with_power(name: &str, power: Power) -> Result<String> {
    let head = match power {
        Power::Own => "#define SHADING_EXACT_POWER\n",
        Power::BuiltIn => "",
    };
    Ok(format!("{head}{}", of_file(name)?))
}

/// Compares all functions in HLSL. The folder is for what is translated.
pub fn compare_hlsl(folder: &Path, power: Power) -> Result<()> {
    let gpu = Gpu::new()?;
    let file = with_power("shading.hlsl", power)?;
    compare_shaders(&gpu, power, &|function| {
        let source = format!("{file}{}", in_hlsl(function));
        Ok(ShaderSource::SpirV(Cow::from(spirv(folder, &source)?)))
    })
}

/// Compares all functions in Metal. The folder is for the program.
pub fn compare_metal(folder: &Path, power: Power) -> Result<()> {
    let file = with_power("shading.metal", power)?;
    let program = metal_program(folder, &file)?;
    let mut tally = Tally::default();
    for (i, function) in functions().iter().enumerate() {
        tally.of_function(function, CALLS, power, &mut |numbers| {
            answer(&program, &i.to_string(), bytemuck::cast_slice(numbers))
        })?;
    }
    tally.report();
    Ok(())
}

/// What glslang makes of a shader.
fn spirv(folder: &Path, source: &str) -> Result<Vec<u32>> {
    let (shader, module) = (folder.join("call.hlsl"), folder.join("call.spv"));
    fs::write(&shader, source)?;
    let output = Command::new("glslangValidator")
        .args(["-D", "-S", "comp", "-e", "main", "-V", "-o"])
        .args([&module, &shader])
        .output()?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stdout).into());
    }
    Ok(bytemuck::pod_collect_to_vec(&fs::read(module)?))
}

/// A program that computes the function of the number that its argument is.
fn metal_program(folder: &Path, file: &str) -> Result<std::path::PathBuf> {
    let mut source = format!(
        "{}{file}#include <cstdio>\n#include <cstdlib>\n",
        include_str!("../shaders/shim.hpp")
    );
    source += "int main(int, char **arguments) {\n    switch (std::atoi(arguments[1])) {\n";
    for (i, function) in functions().iter().enumerate() {
        write!(
            source,
            "    case {i}:\n{}        break;\n",
            in_metal(function)
        )?;
    }
    source += "    }\n}\n";
    let (text, program) = (folder.join("calls.cpp"), folder.join("calls"));
    fs::write(&text, source)?;
    let compiled = Command::new("g++")
        .args(["-std=c++11", "-O2", "-ffp-contract=off", "-I"])
        .args([folder, Path::new("-o"), &program, &text])
        .status()?;
    if !compiled.success() {
        return Err("g++ does not take the file".into());
    }
    Ok(program)
}

fn answer(program: &Path, argument: &str, input: &[u8]) -> Result<Vec<f32>> {
    let mut child = Command::new(program)
        .arg(argument)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()?;
    let mut stdin = child.stdin.take().expect("a pipe");
    let input = input.to_vec();
    let writer = std::thread::spawn(move || stdin.write_all(&input));
    let output = child.wait_with_output()?;
    writer.join().expect("the writer")?;
    Ok(bytemuck::pod_collect_to_vec(&output.stdout))
}

/// The name of a type, whose structs and vectors have a prefix.
fn type_of(kind: Kind, prefix: &str) -> String {
    match (kind.fields(), kind.width()) {
        (Some((name, _, _)), _) => format!("{prefix}{name}"),
        (None, 1) => "float".into(),
        (None, width) => format!("float{width}"),
    }
}

/// Statements that declare the arguments of a function and fill them, and its call.
fn call(function: &Function, prefix: &str, number: &dyn Fn(usize) -> String) -> String {
    let (mut statements, mut at) = (String::new(), 0..);
    for (i, (_, kind)) in function.parameters.iter().enumerate() {
        writeln!(statements, "{} a{i};", type_of(*kind, prefix)).expect("a string");
        for (target, at) in numbers(&format!("a{i}"), *kind).iter().zip(&mut at) {
            writeln!(statements, "{target} = {};", number(at)).expect("a string");
        }
    }
    let arguments: Vec<_> = (0..function.parameters.len())
        .map(|i| format!("a{i}"))
        .collect();
    let of = type_of(function.result, prefix);
    let (name, arguments) = (function.name, arguments.join(", "));
    statements + &format!("{of} r = {prefix}{name}({arguments});\n")
}

fn inputs(function: &Function) -> usize {
    function.parameters.iter().map(|p| p.1.width()).sum()
}

/// The end of a shader that computes a function for a buffer of numbers.
fn in_hlsl(function: &Function) -> String {
    let (inputs, results) = (inputs(function), numbers("r", function.result));
    let stores = (0..)
        .zip(&results)
        .fold(String::new(), |stores, (i, number)| {
            format!("{stores}y[{} * id.x + {i}] = {number};\n", results.len())
        });
    format!(
        "[[vk::binding(0)]] StructuredBuffer<float> x : register(t0);
[[vk::binding(1)]] RWStructuredBuffer<float> y : register(u1);
[numthreads(64, 1, 1)]
void main(uint3 id : SV_DispatchThreadID) {{
if (id.x >= {CALLS}) {{
return;
}}
{}{stores}}}
",
        call(function, "shading_", &|i| format!(
            "x[{inputs} * id.x + {i}]"
        ))
    )
}

/// The statements that compute a function for each call that they read.
fn in_metal(function: &Function) -> String {
    let (inputs, results) = (inputs(function), numbers("r", function.result));
    format!(
        "for (float x[{inputs}]; std::fread(x, sizeof x, 1, stdin) == 1;) {{
{}const float y[] = {{{}}};
std::fwrite(y, sizeof y, 1, stdout);
}}
",
        call(function, "shading::", &|i| format!("x[{i}]")),
        results.join(", ")
    )
}
