//! Every mistake that can be planted in `shading.h` is found by the comparison with the crate, except those of
//! `equivalent.txt`, which change nothing. For `shading_fixed.h`, the mistakes that are not found are printed. It
//! takes minutes, and the compiler `tcc`:
//!
//! ```sh
//! cargo test --release -p shading-languages --test mutants -- --ignored --nocapture
//! ```

use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::{fs, thread};

use fixed_point::{LEVELS, PROGRAM, by_the_crate, levels_by_the_crate, scenes, words};
use host::{answer, bytes, compiled};
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

/// What is asked of those of `shading_fixed.h`: a few scenes before many.
fn of_fixed_point() -> Vec<Question> {
    let scenes: Vec<_> = scenes().take(100_000).collect();
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

/// A header, the compiler that takes it, and the program.
struct Subject<'a> {
    name: &'a str,
    compiler: &'a [&'a str],
    program: &'a Program<'a>,
    questions: &'a [Question],
}

/// Whether a mutant is found by a function that it changes; nothing, if it does not compile.
fn is_found(subject: &Subject, mutant: &Mutant) -> Option<bool> {
    let thread = format!("{:?}", thread::current().id());
    let id = format!("{}_{thread}", std::process::id()).replace(['(', ')'], "");
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(&id);
    fs::create_dir_all(&folder).unwrap();
    fs::write(folder.join(subject.name), &mutant.header).unwrap();
    let folder = folder.to_str().expect("a path");
    let command = [subject.compiler, &["-std=c99", "-w", "-I", folder]].concat();
    let changed = changed_by(&mutant.header, &mutant.within);
    let is_changed = |name: &str| changed.iter().any(|changed| changed == name);
    let may_find = |q: &&Question| q.asks.is_empty() || q.asks.iter().any(|name| is_changed(name));
    let mut questions: Vec<_> = subject.questions.iter().filter(may_find).collect();
    // the function itself before others
    questions.sort_by_key(|q| q.argument != mutant.within);
    let source = (subject.program)(&is_changed);
    let program = compiled(&command, &source, &format!("mutant_{id}")).ok()?;
    let is_other =
        |q: &Question| answer(&program, q.argument, &q.input).as_ref() != Some(&q.expected);
    Some(questions.into_iter().any(is_other))
}

/// The mutants that are not found.
fn survivors(subject: &Subject) -> Vec<Mutant> {
    let name = subject.name;
    let header = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(name)).unwrap();
    let all = mutants(&header);
    let unchanged = Mutant {
        before: String::new(),
        after: String::new(),
        within: String::new(),
        header,
    };
    assert_eq!(is_found(subject, &unchanged), Some(false));
    let (next, found) = (AtomicUsize::new(0), AtomicUsize::new(0));
    let survivors = Mutex::new(vec![]);
    let work = || {
        while let Some(mutant) = all.get(next.fetch_add(1, Ordering::Relaxed)) {
            match is_found(subject, mutant) {
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

fn report(survivors: &[Mutant]) {
    for Mutant { before, after, .. } in survivors {
        println!("- {}\n+ {}", before.trim(), after.trim());
    }
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
        compiler: &["gcc"],
        program: &|is_asked| host::program(is_asked),
        questions: &of_floats(),
    });
    are_equivalent(&survivors, include_str!("equivalent.txt"));
}

#[test]
#[ignore = "takes minutes"]
fn mistakes_in_fixed_point_are_found() {
    let questions = of_fixed_point();
    for narrow in [
        "-DSHADING_FIXED_NARROW_PRODUCT=0",
        "-DSHADING_FIXED_NARROW_PRODUCT=1",
    ] {
        report(&survivors(&Subject {
            name: "shading_fixed.h",
            compiler: &["tcc", narrow], // it compiles in a hundredth of a second
            program: &|_| PROGRAM.into(),
            questions: &questions,
        }));
    }
}
