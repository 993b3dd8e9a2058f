//! Mistakes that are planted in the examples: each is found, and told where it is.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::Command;
use std::thread;

use serde_json::Value;

use crate::{FOLDER, PYTHON, run, shell};

/// The mistakes of a table, made in another program than this: each is found, nearly all have
/// exactly the place that stands there, and none has another.
fn mistakes_are_found_and_placed(step: usize, seed: usize) {
    let rows = include_str!("../mistakes.txt").lines();
    let rows: Vec<&str> = rows
        .filter(|row| !row.starts_with('#'))
        .step_by(step)
        .collect();
    let some = |part: usize| -> Vec<_> {
        let of_part = rows.iter().skip(part).step_by(2);
        of_part.filter_map(|row| misplaced(row, seed)).collect()
    };
    let inexact: Vec<String> = thread::scope(|scope| {
        let threads = [0, 1].map(|part| scope.spawn(move || some(part)));
        threads
            .into_iter()
            .flat_map(|thread| thread.join().expect("no panic"))
            .collect()
    });
    println!("seed {seed}, {} rows, not exact: {inexact:#?}", rows.len());
    assert!(inexact.len() * 20 <= rows.len().max(20));
}

#[test]
fn some_mistakes_in_the_example_are_found_and_placed() {
    mistakes_are_found_and_placed(6, 0);
}

#[test]
#[ignore = "it takes minutes"]
fn all_mistakes_in_the_example_are_found_and_placed_at_five_seeds() {
    for seed in 0..5 {
        mistakes_are_found_and_placed(1, seed);
    }
}

/// Makes the mistakes of a row, and says what is told if it is not exactly the place of the row.
/// Nothing may be told that is neither a part of it nor more than it.
fn misplaced(row: &str, seed: usize) -> Option<String> {
    let fields: Vec<&str> = row.rsplitn(3, " => ").collect();
    let [expected, names, edits] = fields[..] else {
        panic!("{row}");
    };
    let mut script = PYTHON.to_owned();
    for edit in edits.split(" && ") {
        let (old, new) = edit.split_once(" => ").expect(row);
        let [old, new] = [old, new].map(|text| text.replace('⏎', "\n"));
        assert!(script.contains(&old), "{old}");
        script = script.replacen(&old, &new, 1);
    }
    // few laws and cases, so that ninety runs take seconds
    let options = format!("--seed {seed} --cases 128 --no-shrink --json");
    let line = format!(r#"$laws {options} python3 -c "$script" 2>/dev/null"#);
    let report = shell(&script, &line, 1);
    for name in names.split(", ").filter(|name| *name != "-") {
        let is_named = report.contains(&format!("\"{name}"));
        assert!(is_named, "{row}: not named {name}: {report}");
    }
    let report: Value = serde_json::from_str(&report).expect("JSON");
    let list = |value: &Value| value.as_array().cloned().unwrap_or_default();
    let findings = list(&report["findings"]);
    let places = findings.iter().flat_map(|finding| list(&finding["places"]));
    let knobs = |place: Value| -> BTreeSet<String> {
        let knobs = list(&place["only_with"]).into_iter();
        knobs
            .map(|knob| knob.as_str().unwrap_or_default().to_owned())
            .collect()
    };
    let told: BTreeSet<BTreeSet<String>> = places.map(knobs).collect();
    let expected = expected.split(" + ").map(|place| {
        let knobs = place.split(", ").filter(|knob| *knob != "all");
        knobs.map(str::to_owned).collect()
    });
    let expected: BTreeSet<BTreeSet<String>> = expected.collect();
    for place in &told {
        let is_like = |other: &BTreeSet<String>| place.is_subset(other) || other.is_subset(place);
        assert!(expected.iter().any(is_like), "{row}: {told:?}");
    }
    (told != expected).then(|| format!("{row}: {told:?}"))
}

/// What is kept by a part of its key is wrong only after other scenes, which the report gives in their order.
#[test]
fn what_is_remembered_is_told_with_what_was_asked_before() {
    let script = PYTHON.replace(
        "def shade(scene):\n",
        "kept = {}\n\n\ndef shade(scene):\n    scene[\"k_d\"] = kept.setdefault(scene[\"m\"], scene[\"k_d\"])\n",
    );
    assert_ne!(script, PYTHON);
    let report = shell(&script, r#"$laws python3 -c "$script""#, 1);
    let (_, first) = report.split_once("Finding 1 of ").expect("a finding");
    assert!(
        first[3..].starts_with("a scene changes the color of the scenes after it"),
        "{report}"
    );
    for part in ["  color 2: ", "The last scene alone has the right color."] {
        assert!(first.contains(part), "{report}");
    }
}

/// What depends on many scenes is not reproduced by one of them.
#[test]
fn what_many_scenes_bring_about_is_reproduced_by_the_run() {
    let script = PYTHON.replace(
        "def shade(scene):\n",
        "count = 0\n\n\ndef shade(scene):\n    global count\n    count += 1\n    \
         scene[\"k_d\"][0] += count % 64 == 0\n",
    );
    assert_ne!(script, PYTHON);
    let report = shell(&script, r#"$laws python3 -c "$script""#, 1);
    assert!(
        report.contains("To reproduce it, run the laws again with this seed."),
        "{report}"
    );
    assert!(!report.contains("To reproduce it:"), "{report}");
}

/// What is wrong only after other scenes looks like few digits. It is told once, as what it is.
#[test]
fn what_is_remembered_is_not_told_of_digits() {
    let script = PYTHON.replace(
        "def shade(scene):\n",
        "count = 0\n\n\ndef shade(scene):\n    global count\n    count += 1\n",
    );
    let drifting = "    return scale(color, 1 + (count % 5 - 2) / 4096)\n";
    let script = script.replace("    return color\n", drifting);
    assert!(script.contains("global count") && script.contains(drifting));
    let report = shell(&script, r#"$laws python3 -c "$script""#, 1);
    assert!(
        report.contains("Finding 1 of 1: a scene changes"),
        "{report}"
    );
}

/// In few digits, a mistake that changes little fits what another one makes slightly too dark. It explains nothing
/// of that: the colors remain as wrong.
#[test]
fn what_changes_little_explains_little() {
    for (old, new, place) in [
        ("n_dot_l)\n", "0.95 * n_dot_l)\n", "diffuse, lights"),
        ("1 / (a + b", "0.9 / (a + b", "lamps, lights"),
    ] {
        let script = PYTHON.replace("2**-53", "2**-11").replacen(old, new, 1);
        assert!(script.contains("2**-11") && script.contains(new));
        let report = shell(&script, r#"$laws python3 -c "$script""#, 1);
        for part in ["Finding 1 of 1: no known", &format!("only with: {place}.")] {
            assert!(report.contains(part), "{report}");
        }
    }
}

/// Directions to lamps in `f32`, and all else in `f64`, as the profile says. Who declared `f32` for all would lose
/// mistakes of ambient light.
#[test]
fn digits_that_one_place_lacks_are_not_to_be_given_up_everywhere() {
    let single = "[struct.unpack(\"f\", struct.pack(\"f\", c))[0] for c in scale(to_light, 1 / q)]";
    let script = PYTHON.replace("scale(to_light, 1 / q)", single);
    assert_ne!(script, PYTHON);
    let script = format!("import struct\n{script}");
    let report = shell(&script, r#"$laws python3 -c "$script""#, 1);
    for part in ["a roundoff of 2^-2", "  Wrong only with: lamps, lights.\n"] {
        assert!(report.contains(part), "{report}");
    }
    assert!(!report.contains("add to the profile"), "{report}");
}

/// Takes out single lines of an example. What is left has no memory, so none may be told of it.
fn lines_are_missed(language: &str, step: usize) {
    let file = Path::new(FOLDER).join(format!("missing.{language}"));
    let text = shell("", &format!("$laws example {language}"), 0);
    let lines: Vec<&str> = text.lines().collect();
    let line = match language {
        // what is not initialized or not returned would be what was there before, which is memory
        "c" => {
            "cc -Werror=return-type -O1 -ftrivial-auto-var-init=zero missing.c -o missing -lm &&
             $laws --timeout 2 --cases 64 --no-shrink ./missing"
        }
        "python" => "$laws --timeout 2 --cases 64 --no-shrink python3 missing.python",
        _ => "$laws --timeout 2 --cases 64 --no-shrink node missing.javascript",
    };
    for missing in (0..lines.len()).step_by(step) {
        let left = [&lines[..missing], &lines[missing + 1..]].concat();
        fs::write(&file, left.join("\n") + "\n").expect("a file");
        let mut command = Command::new("bash");
        command.args(["-c", line]).current_dir(FOLDER);
        command.env("laws", env!("CARGO_BIN_EXE_shading-laws"));
        let (_, report, _) = run(&mut command);
        // an answer to a line that has none shifts the others, and is told first
        let is_shifted = report.contains("the run ended early: after the answer to scene");
        let is_memory = ["a scene changes the color", "no_memory is BROKEN"]
            .iter()
            .any(|part| report.contains(part));
        assert!(is_shifted || !is_memory, "{}: {report}", lines[missing]);
    }
}

#[test]
fn a_missing_line_is_no_memory() {
    lines_are_missed("python", 9);
}

#[test]
#[ignore = "it takes minutes"]
fn no_missing_line_is_memory() {
    for language in ["python", "javascript", "c"] {
        lines_are_missed(language, 1);
    }
}
