//! Compilers take the files, those for C without a warning.

use std::fs;
use std::path::Path;
use std::process::Command;

use shading_languages::dialect::{C, GLSL, HLSL};
use shading_languages::{implicit, parametric};
use surface::{figure, rounded_box, wave};

mod surface;

/// Runs a command in the folder of the files, and fails with what it prints if it does.
fn succeeds(command: &[&str]) {
    let output = Command::new(command[0])
        .args(&command[1..])
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .unwrap_or_else(|error| panic!("{command:?} does not run: {error}"));
    let printed = [output.stdout, output.stderr].concat();
    let printed = String::from_utf8_lossy(&printed);
    assert!(output.status.success(), "{command:?}: {printed}");
}

/// Writes a file among those of the tests, and returns its path.
fn written(name: &str, text: &str) -> String {
    let path = format!("{}/{name}", env!("CARGO_TARGET_TMPDIR"));
    fs::write(&path, text).unwrap();
    path
}

fn file(name: &str) -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(name)).unwrap()
}

#[test]
fn c_and_cpp_compile_without_a_warning() {
    let source = written(
        "both.c",
        "#include \"shading.h\"\n#include \"shading_fixed.h\"\n#include \"shading.h\"\n#include \"shading_fixed.h\"\n",
    );
    let warnings = "-Wall -Wextra -pedantic -Wdouble-promotion -Wconversion -Wshadow -Werror";
    for (compiler, flags) in [
        ("gcc", "-std=c99"),
        ("gcc", "-std=c17"),
        ("g++", "-std=c++11"),
        ("clang", "-std=c99"),
        ("clang", "-x c++ -std=c++11"),
    ] {
        let flags = format!("{compiler} {flags} {warnings} -I. -O2 -c -o /dev/null {source}");
        succeeds(&flags.split(' ').collect::<Vec<_>>());
    }
}

/// The code of the page on C, and its sketch with what Arduino would include.
#[test]
fn the_code_of_the_page_compiles() {
    let page = file("../docs/c.md");
    let mut blocks = page.split("\n```").skip(1).step_by(2);
    let mut block = |language: &str| {
        let text = blocks.find_map(|block| block.strip_prefix(language));
        text.unwrap_or_else(|| panic!("a block of {language}"))
            .to_string()
    };
    let warnings = "-Wall -Wextra -Werror -Wno-unused-function";
    let source = written("page.c", &block("c\n"));
    succeeds(
        &format!("gcc -std=c99 {warnings} -I. -c -o /dev/null {source}")
            .split(' ')
            .collect::<Vec<_>>(),
    );
    let arduino = "#include <stdint.h>\n\
        struct Port { void begin(long) {} void print(char) {} void println() {} };\n\
        static Port Serial;\n";
    let sketch = format!("{arduino}{}", block("cpp\n"));
    let source = written("sketch.cpp", &sketch);
    succeeds(
        &format!("g++ -std=c++11 {warnings} -Iarduino/src -c -o /dev/null {source}")
            .split(' ')
            .collect::<Vec<_>>(),
    );
}

/// As a compute shader that is Vulkan's, and as a shader of OpenGL and its browsers.
#[test]
fn glsl_and_hlsl_compile() {
    for power in ["", "#define SHADING_EXACT_POWER\n"] {
        for version in ["300 es", "310 es", "330", "450"] {
            let source = written(
                "shading.frag",
                &format!(
                    "#version {version}\nprecision highp float;\n{power}{}{}",
                    file("shading.glsl"),
                    "out vec4 color;\nvoid main() {\n    color = vec4(1.0);\n}\n"
                ),
            );
            succeeds(&["glslangValidator", &source]);
        }
        let module = written("shading.spv", "");
        let version = format!("#version 450\n{power}");
        let compute = "layout(local_size_x = 1) in;\nvoid main() {\n}\n";
        let source = written(
            "shading.comp",
            &[&version, &file("shading.glsl"), compute].concat(),
        );
        succeeds(&["glslangValidator", "-V", "-o", &module, &source]);
        succeeds(&["spirv-val", &module]);
        let compute = "[numthreads(1, 1, 1)]\nvoid main() {\n}\n";
        let source = written(
            "shading.hlsl",
            &[power, &file("shading.hlsl"), compute].concat(),
        );
        let hlsl = [
            "-D", "-S", "comp", "-e", "main", "-V", "-o", &module, &source,
        ];
        succeeds(&[&["glslangValidator"], &hlsl[..]].concat());
        succeeds(&["spirv-val", &module]);
    }
}

/// Surfaces of the user's compile after the files that they call.
#[test]
fn surfaces_compile() {
    let [c, glsl, hlsl] = [&C, &GLSL, &HLSL].map(|dialect| {
        let wave = parametric(dialect, "wave", wave, wave);
        let figure = implicit(dialect, "figure", figure, figure);
        implicit(dialect, "rounded_box", rounded_box, rounded_box) + &figure + &wave
    });
    let source = written("surfaces.c", &format!("#include \"shading.h\"\n{c}"));
    succeeds(&[
        "gcc",
        "-std=c99",
        "-Wall",
        "-Werror",
        "-Wno-unused-function",
        "-I.",
        "-fsyntax-only",
        &source,
    ]);
    let file_of = |name: &str| file(&format!("shading.{name}"));
    let version = "#version 300 es\nprecision highp float;\n";
    let main = "out vec4 color;\nvoid main() {\n    color = vec4(1.0);\n}\n";
    let source = written(
        "surfaces.frag",
        &[version, &file_of("glsl"), &glsl, main].concat(),
    );
    succeeds(&["glslangValidator", &source]);
    let main = "[numthreads(1, 1, 1)]\nvoid main() {\n}\n";
    let source = written("surfaces.hlsl", &[&file_of("hlsl"), &hlsl, main].concat());
    let module = written("surfaces.spv", "");
    let command = "glslangValidator -D -S comp -e main -V -o";
    let command: Vec<_> = command.split(' ').chain([&module[..], &source]).collect();
    succeeds(&command);
}
