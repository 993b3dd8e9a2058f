//! Every mistake that can be planted in `shading.h` and in `shading_fixed.h` is found by the comparison with the
//! crate, except those of `equivalent.txt` and `equivalent_fixed.txt`, which change nothing. It takes minutes, and
//! the compiler `tcc`:
//!
//! ```sh
//! cargo test --release -p shading-languages --test mutants -- --ignored --nocapture
//! ```

use std::fmt::Write as _;
use std::path::Path;
use std::process::Command;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::{fs, thread};

use fixed_point::{LEVELS, PROGRAM, by_the_crate, levels_by_the_crate, scenes, words};
use host::{answer, bytes, compiled, preprocessed};
use mutant::{Mutant, changed_by, mutants};
use shading_languages::functions;
use support::{ALL, Draw, arguments};

mod fixed_point;
mod host;
mod mutant;
mod support;

/// What a program is asked, and what the crate answers.
struct Question {
    argument: &'static str,
    /// The functions that it asks, or nothing for all.
    asks: Vec<&'static str>,
    input: Vec<u8>,
    expected: Vec<u8>,
}

/// What is asked of the functions of `shading.h`.
fn of_floats() -> Vec<Question> {
    let mut all = vec![];
    for draw in ALL {
        for function in functions() {
            // one step of a coefficient changes few results, and some equalities need several numbers at an edge
            let has_polynomial =
                function.name.starts_with("power") || function.name == "normal_corner";
            let is_long = has_polynomial || draw == Draw::Edge;
            let calls = if is_long { 500_000 } else { 20_000 };
            let input = arguments(function, draw, calls);
            let width: usize = function.parameters.iter().map(|p| p.1.width()).sum();
            let compute = |x: &[f32]| (function.compute)(x);
            let expected: Vec<_> = input.chunks(width).flat_map(compute).collect();
            all.push(Question {
                argument: function.name,
                asks: vec![function.name],
                input: bytes(&input),
                expected: bytes(&expected),
            });
        }
    }
    let light = host::light();
    all.push(Question {
        argument: "levels",
        asks: vec!["to_srgb8", "to_rgb565"],
        input: bytes(&light),
        expected: host::levels_by_the_crate(&light),
    });
    all
}

const SCENES: usize = 40_000;

/// What is asked of those of `shading_fixed.h`: a few scenes before many.
fn of_fixed_point() -> Vec<Question> {
    let scenes: Vec<_> = scenes().take(SCENES).collect();
    let of = |scenes: &[_]| Question {
        argument: "",
        asks: vec![],
        input: words(scenes.iter().flatten()),
        expected: words(&scenes.iter().flat_map(by_the_crate).collect::<Vec<_>>()),
    };
    let levels = Question {
        argument: LEVELS,
        asks: vec![],
        input: vec![],
        expected: levels_by_the_crate(),
    };
    vec![of(&scenes[..1000]), levels, of(&scenes[1000..])]
}

/// A program that computes the functions of a header that are asked.
type Program<'a> = dyn Fn(&dyn Fn(&str) -> bool) -> String + Sync + 'a;

/// A header, the compilers that take it, and the program.
struct Subject<'a> {
    name: &'a str,
    /// Each with what a program for it begins with.
    compilers: &'a [(&'a [&'a str], &'a str)],
    program: &'a Program<'a>,
    questions: &'a [Question],
}

/// Whether a mutant is found by a function that it changes, as one of the compilers sees it; nothing, if it does
/// not compile.
fn is_found(subject: &Subject, mutant: &Mutant, unchanged: &str) -> Option<bool> {
    let thread = format!("{:?}", thread::current().id());
    let name = format!("mutant_{}_{thread}", std::process::id()).replace(['(', ')'], "");
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{name}.d"));
    fs::create_dir_all(&folder).unwrap();
    fs::write(folder.join("arm_acle.h"), SATURATING).unwrap();
    let changed = changed_by(&mutant.header, &mutant.within);
    let is_changed = |name: &str| changed.iter().any(|changed| changed == name);
    let may_find = |q: &&Question| q.asks.is_empty() || q.asks.iter().any(|name| is_changed(name));
    let mut questions: Vec<_> = subject.questions.iter().filter(may_find).collect();
    // the function itself before others
    questions.sort_by_key(|q| q.argument != mutant.within);
    let source = (subject.program)(&is_changed);
    for (compiler, head) in subject.compilers {
        let include = folder.to_str().expect("a path");
        let command = [compiler, &["-std=c99", "-w", "-I", include][..]].concat();
        let source = format!("{head}{source}");
        let write = |header: &str| fs::write(folder.join(subject.name), header).unwrap();
        let seen = |header: &str| {
            write(header);
            preprocessed(&command, &source, &name)
        };
        let may_be_hidden = subject.compilers.len() > 1 && mutant.header != unchanged;
        if may_be_hidden && seen(&mutant.header) == seen(unchanged) {
            continue; // the line is for another processor
        }
        write(&mutant.header);
        let program = compiled(&command, &source, &name).ok()?;
        let is_other =
            |q: &&Question| answer(&program, q.argument, &q.input).as_ref() != Some(&q.expected);
        if questions.iter().any(is_other) {
            return Some(true);
        }
    }
    Some(false)
}

/// The mutants that are not found.
fn survivors(subject: &Subject) -> Vec<Mutant> {
    let name = subject.name;
    let header = host::header(name);
    let all = mutants(&header);
    let unchanged = Mutant {
        after: String::new(),
        within: String::new(),
        header: header.clone(),
    };
    assert_eq!(is_found(subject, &unchanged, &header), Some(false));
    let (next, found) = (AtomicUsize::new(0), AtomicUsize::new(0));
    let survivors = Mutex::new(vec![]);
    let work = || {
        while let Some(mutant) = all.get(next.fetch_add(1, Ordering::Relaxed)) {
            match is_found(subject, mutant, &header) {
                None => {}
                Some(true) => _ = found.fetch_add(1, Ordering::Relaxed),
                Some(false) => survivors.lock().unwrap().push(mutant.clone()),
            }
        }
    };
    let processors = thread::available_parallelism().map_or(1, usize::from);
    thread::scope(|scope| (0..processors).for_each(|_| _ = scope.spawn(work)));
    let survivors = survivors.into_inner().unwrap();
    let found = found.into_inner();
    println!("{name}: {found} of {} are found", found + survivors.len());
    survivors
}

/// Fails unless the survivors are those of a list, which says why nothing can find them.
fn are_equivalent(survivors: &[Mutant], list: &str) {
    let mut found: Vec<_> = survivors.iter().map(|mutant| mutant.after.trim()).collect();
    let mut listed = vec![];
    for section in list.split("\n\n").skip(1) {
        let (why, mutants) = section.split_once('\n').expect("a reason and mutants");
        listed.extend(mutants.lines());
        println!("{}: {why}", mutants.lines().count());
    }
    found.sort_unstable();
    listed.sort_unstable();
    for mutant in found.iter().filter(|mutant| !listed.contains(mutant)) {
        println!("not listed: {mutant}");
    }
    for mutant in listed.iter().filter(|mutant| !found.contains(mutant)) {
        println!("found: {mutant}");
    }
    assert!(found == listed, "the list of equivalent mutants is another");
}

#[test]
#[ignore = "takes minutes"]
fn mistakes_in_single_precision_are_found() {
    let survivors = survivors(&Subject {
        name: "shading.h",
        compilers: &[(&["gcc"], "")],
        program: &|is_asked| host::program(is_asked),
        questions: &of_floats(),
    });
    are_equivalent(&survivors, include_str!("equivalent.txt"));
}

/// The lines of a header that compute an arctangent of t, as a function.
fn arctangent(header: &str, name: &str) -> String {
    let begin = header.find("    float z = t * t;").expect("the series");
    let end = header.find("    float angle = ").expect("the angle");
    let lines = &header[begin..end];
    format!("static float {name}(float t) {{\n{lines}    return arctangent;\n}}\n")
}

/// What the list says to be so for each number, is.
#[test]
#[ignore = "takes half a minute"]
fn mistakes_that_change_no_number_change_none() {
    let header = host::header("shading.h");
    let list = include_str!("equivalent.txt");
    let (_, lines) = list
        .split_once("of the arctangent: each of")
        .expect("the section");
    let is_listed = |mutant: &&Mutant| lines.lines().any(|line| line == mutant.after.trim());
    let all = mutants(&header);
    let all: Vec<_> = all.iter().filter(is_listed).collect();
    assert_eq!(all.len(), lines.lines().skip(1).count());

    let mut source = String::from("#include \"shading.h\"\n#include <stdio.h>\n");
    source += &arctangent(&header, "right");
    let mut differs = String::from("0");
    for (i, mutant) in all.iter().enumerate() {
        source += &arctangent(&mutant.header, &format!("mutant_{i}"));
        write!(differs, " | (mutant_{i}(t) != right(t))").unwrap();
    }
    // t is at most tan(π/8), 0.41421356, but for its rounding; an arctangent of -t has the same bits
    let main = format!(
        "int main(void) {{
    int32_t bits;
    for (bits = 0; bits <= shading_bits(0.4143f); bits++) {{
        float t = shading_from_bits(bits);
        if ({differs}) {{
            return 1;
        }}
    }}
    for (bits = shading_bits(-0.9999996f); bits <= shading_bits(-1.00008f); bits++) {{
        if (shading_beam_smoothstep(shading_from_bits(bits), -0.9999996f, -2.0f) != 1.0f) {{
            return 1;
        }}
    }}
    return 0;
}}
"
    );
    source += &main;
    let program = compiled(&["gcc", "-O3", "-std=c99"], &source, "each_number").unwrap();
    assert!(Command::new(program).status().unwrap().success());
}

#[test]
#[ignore = "takes minutes"]
fn mistakes_in_fixed_point_are_found() {
    const WIDE: &str = "-DSHADING_FIXED_NARROW_PRODUCT=0";
    const NARROW: &str = "-DSHADING_FIXED_NARROW_PRODUCT=1";
    // GCC sees what is undefined
    const CHECKED: [&str; 2] = ["-fsanitize=undefined", "-fno-sanitize-recover=undefined"];
    let survivors = survivors(&Subject {
        name: "shading_fixed.h",
        compilers: &[
            (&["tcc", WIDE], ""), // it compiles in a hundredth of a second
            (&["tcc", NARROW], ""),
            (&["tcc", WIDE], LIKE_GCC_FOR_ARM),
            (&["gcc", CHECKED[0], CHECKED[1], WIDE], ""),
            (&["gcc", CHECKED[0], CHECKED[1], NARROW], ""),
        ],
        program: &|_| PROGRAM.into(),
        questions: &of_fixed_point(),
    });
    are_equivalent(&survivors, include_str!("equivalent_fixed.txt"));
}

/// What the header finds in GCC for a Cortex-M4.
const LIKE_GCC_FOR_ARM: &str = "\
#include <stdint.h>
#include <stdio.h>
static int leading_zeros(uint32_t x) {
    int zeros = 0;
    for (; zeros < 32 && !(x >> 31); x <<= 1) zeros++;
    return zeros;
}
#define __GNUC__ 12
#define __ARM_FEATURE_DSP 1
#define __attribute__(x)
#define __builtin_clz leading_zeros
";

/// The operations of `arm_acle.h` that the header uses.
const SATURATING: &str = "\
static int32_t saturated(int64_t x) {
    return x < INT32_MIN ? INT32_MIN : x > INT32_MAX ? INT32_MAX : (int32_t)x;
}
static int32_t __qadd(int32_t x, int32_t y) { return saturated((int64_t)x + y); }
static int32_t __qsub(int32_t x, int32_t y) { return saturated((int64_t)x - y); }
";
