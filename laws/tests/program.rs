//! The program, with renderers that behave and renderers that do not.

#![cfg(feature = "cli")]
#![allow(missing_docs)]

use std::collections::BTreeSet;
use std::fs;
use std::process::Command;
use std::thread;

use serde_json::Value;
use tempfile::TempDir;

const PYTHON: &str = include_str!("../examples/renderer.py");

fn program() -> Command {
    Command::new(env!("CARGO_BIN_EXE_shading-laws"))
}

fn temporary() -> TempDir {
    tempfile::tempdir().expect("a temporary folder")
}

/// The exit status, the standard output and the standard error.
fn run(command: &mut Command) -> (Option<i32>, String, String) {
    let output = command.output().expect("the program starts");
    let text = |bytes| String::from_utf8(bytes).expect("UTF-8");
    (
        output.status.code(),
        text(output.stdout),
        text(output.stderr),
    )
}

/// Runs a line of a shell, in which the program is `$laws` and a script `$script`, and which must
/// end with this status.
#[track_caller]
fn shell(folder: &TempDir, script: &str, line: &str, expected: i32) -> String {
    let mut command = Command::new("bash");
    command.args(["-c", line]).current_dir(folder);
    command.env("laws", env!("CARGO_BIN_EXE_shading-laws"));
    let (status, stdout, stderr) = run(command.env("script", script));
    assert_eq!(status, Some(expected), "{line}\n{stdout}\n{stderr}");
    stdout + &stderr
}

/// A renderer in Python whose answers are all black, except that `body` runs for each line that it
/// reads, of which the `n`th is a scene or empty. It answers by `say`.
fn python(body: &str) -> String {
    let body = body.replace('\n', "\n    ");
    format!(
        r#"
import os, sys, time
def say(text):
    print(text, flush=True)
sys.stdin.readline()
say("{{}}")
n = 0
for line in sys.stdin:
    is_scene = line != "\n"
    n += is_scene
    {body}
    if is_scene:
        say("[0,0,0]")
"#
    )
}

/// The program cannot talk to the renderer, and says why in one line with all `parts`.
#[track_caller]
fn refused(command: &mut Command, parts: &[&str]) {
    let (status, stdout, stderr) = run(command);
    assert_eq!(status, Some(2), "{stdout}{stderr}");
    assert_eq!(stdout, "");
    // the others are the renderer's own; one that is killed may leave half a line before this one
    let lines = stderr.lines();
    let lines =
        lines.filter(|line| line.contains("shading-laws: ") && !line.contains(" scenes after "));
    assert_eq!(lines.count(), 1, "{stderr}");
    for part in parts {
        assert!(stderr.contains(part), "no {part:?} in: {stderr}");
    }
}

/// The examples keep all laws, built as their first lines say.
#[test]
fn examples_keep_all_laws() {
    let folder = temporary();
    for (language, build, command) in [
        ("python", "true", "python3 file.python"),
        ("javascript", "true", "node file.javascript"),
        ("c", "cc -x c -O2 file.c -o by_c -lm", "./by_c"),
    ] {
        // JavaScript's engine is not on every machine
        let is_there = Command::new("node").arg("--version").output().is_ok();
        if language == "javascript" && !is_there {
            continue;
        }
        let line =
            format!("$laws example {language} >file.{language} && {build} && $laws {command}");
        let report = shell(&folder, "", &line, 0);
        assert!(report.contains("0 of 3 laws broken"), "{report}");
    }
}

/// The mistakes of a table, made in another program than this: each is found, nearly all have
/// exactly the place that stands there, and none has another.
fn mistakes_are_found_and_placed(step: usize, seed: usize) {
    let rows = include_str!("mistakes.txt").lines();
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
    let report = shell(&temporary(), &script, &line, 1);
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
    let report = shell(&temporary(), &script, r#"$laws python3 -c "$script""#, 1);
    let (_, first) = report.split_once("Finding 1 of ").expect("a finding");
    assert!(
        first[3..].starts_with("a scene changes the color of the scenes after it"),
        "{report}"
    );
    for part in ["  color 2: ", "The last scene alone has the right color."] {
        assert!(first.contains(part), "{report}");
    }
}

/// Takes out single lines of an example. What is left has no memory, so none may be told of it.
fn lines_are_missed(language: &str, step: usize) {
    let folder = temporary();
    let file = format!("file.{language}");
    let text = shell(&folder, "", &format!("$laws example {language}"), 0);
    let lines: Vec<&str> = text.lines().collect();
    let line = match language {
        // what is not initialized or not returned would be what was there before, which is memory
        "c" => {
            "cc -Werror=return-type -x c -O1 -ftrivial-auto-var-init=zero file.c -o by_c -lm &&
             $laws --timeout 2 --cases 64 --no-shrink ./by_c"
        }
        "python" => "$laws --timeout 2 --cases 64 --no-shrink python3 file.python",
        _ => "$laws --timeout 2 --cases 64 --no-shrink node file.javascript",
    };
    for missing in (0..lines.len()).step_by(step) {
        let left = [&lines[..missing], &lines[missing + 1..]].concat();
        fs::write(folder.path().join(&file), left.join("\n") + "\n").expect("a file");
        let mut command = Command::new("bash");
        command.args(["-c", line]).current_dir(&folder);
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

#[test]
fn nan_breaks_a_law_and_the_report_names_the_scene() {
    let script = python("if is_scene: say('[0,NaN,0]'); continue");
    let line = r#"$laws --cases 8 python3 -c "$script""#;
    let report = shell(&temporary(), &script, line, 1);
    let command = "printf '%s\\n' '{\"shading-laws\":1}' '{\"model\":";
    assert!(report.contains(command), "{report}");
}

#[test]
fn departures_are_listed() {
    let list = shell(&temporary(), "", "$laws --list", 0);
    for line in ["\nHighlightNotGated  ", "\nConeExponent=1  "] {
        assert!(list.contains(line), "{list}");
    }
}

#[test]
fn a_wrong_command_is_refused() {
    let folder = temporary();
    fs::write(folder.path().join("renderer"), "").expect("a file");
    for (command, part) in [
        ("./no_such_renderer", "No such file"),
        ("renderer", "do you mean ./?"),
        ("./renderer", "is it executable"),
    ] {
        refused(program().arg(command).current_dir(&folder), &[part]);
    }
    assert_eq!(run(&mut program()).0, Some(2));
    assert_eq!(run(program().args(["--timeout", "0", "cat"])).0, Some(2));
}

/// What does not speak the format, at the start, in an answer, after one, or at the end.
#[test]
fn nonsense_is_refused() {
    let endless = "longer than 65536 bytes";
    let starts = [
        ("exit 3", r#"{"shading-laws":1}: it ended (exit status: 3)"#),
        ("exec 0<&- >&-; exit 3", "exit status: 3"),
        ("kill -SEGV $$", "SIGSEGV"),
        ("cat", "unknown field `shading-laws`"), // says what it hears
        ("echo ready", "expected a JSON object or {}, in \"ready\""),
        (r#"echo '{"hue":1}'"#, "unknown field `hue`"),
        (r#"echo '{"bits":8,"bits":8}'"#, "duplicate field `bits`"),
        (r#"echo '{"bits":"8"}'"#, "invalid type: string"),
        (r#"echo '{"models":[]}'"#, "models is empty"),
        ("cat /dev/zero", endless),
        (r"printf '\377\n'", "not UTF-8"),
        ("exec sleep 1000", "no line within 5s"),
        ("exec >&-; exec sleep 1000", "it closed its output"),
        ("echo '{}'; exec sleep 1000", "scene 1: no answer within 5s"),
    ];
    let answers = [
        ("sys.exit(3)", "it ended (exit status: 3)"),
        ("os.abort()", "it ended (signal: 6"),
        ("say('dark')", "expected [red,green,blue], found \"dark\""),
        ("say('')", "expected [red,green,blue], found \"\""),
        ("say('[1,2]')", "expected 3 numbers, found 2"),
        ("say('[1,2,3,4]')", "expected 3 numbers, found 4"),
        ("say('[1,2,red]')", "\"red\" is no number"),
        ("say('[' + '1' * 10**6)", endless),
        ("os.write(1, b'[\\xff,0,0]\\n')", "is not UTF-8"),
        (
            "os.write(1, b'[0.'); sys.exit(3)",
            "3) in the middle of the line \"[0.\"",
        ),
        ("pass", "no answer within 5s"),
    ];
    let hint = "the empty line has no answer";
    let lines = [
        ("if not is_scene: say('[0,0,0]')", hint),
        ("if not is_scene: say('')", hint),
        ("if not is_scene: say('done')", hint),
        ("if is_scene and n == 3: say('[0,0,0]')", ""), // one too many
    ];
    let end = PYTHON.to_owned() + "\n    sys.exit(3)\n";
    let mut all = vec![("python3", end, vec!["it ended (exit status: 3)"])];
    all.extend(starts.map(|(script, part)| ("sh", script.into(), vec![part])));
    all.extend(answers.map(|(body, part)| {
        // what is not answered is missed at the end of the batch
        let of_scene = if body.ends_with("pass") {
            "scene "
        } else {
            "scene 3: "
        };
        let scene = r#"the scene: {"model":""#;
        let body = format!("if is_scene and n == 3:\n    {body}\n    continue");
        ("python3", python(&body), vec![of_scene, part, scene])
    }));
    all.extend(lines.map(|(body, part)| ("python3", python(body), vec![part])));
    // black is right, so that nothing else is found before
    let dark = r#"say('{"departs":["AmbientTimes=0","LightTimes=0"]}')"#;
    for (_, script, _) in &mut all {
        *script = script.replace(r#"say("{}")"#, dark);
    }
    // those that take five seconds take them together
    let is_late = |parts: &[&str]| parts.iter().any(|part| part.contains("within 5s"));
    all.sort_by_key(|(.., parts)| is_late(parts));
    for some in all.chunks(4) {
        std::thread::scope(|scope| {
            for (interpreter, script, parts) in some {
                scope.spawn(move || {
                    let timeout = if is_late(parts) { "5" } else { "60" };
                    let mut command = program();
                    command.args(["--cases", "4", "--timeout", timeout]);
                    refused(command.args([interpreter, "-c", script]), parts);
                });
            }
        });
    }
}

/// A pass that did not try every case is no pass; a slow renderer tries each law, and what it is
/// about is told meanwhile.
#[test]
fn a_run_that_is_cut_short_does_not_pass() {
    let slow = PYTHON.replace(
        "        if line.strip():",
        "        if line.strip():\n            import time; time.sleep(0.02)",
    );
    assert_ne!(slow, PYTHON);
    let line = r#"$laws --time 1 python3 -c "$script""#;
    let report = shell(&temporary(), &slow, line, 3);
    assert!(report.contains("0 of 3 laws broken"), "{report}");
    assert!(report.contains("formula holds in"), "{report}");
    assert!(!report.contains("holds in 0 cases"), "{report}");
    // Ctrl-C tells what was found
    let interrupt = r#"$laws python3 -c "$script" & sleep 4; kill -INT $!; wait $!"#;
    let report = shell(&temporary(), &slow, interrupt, 3);
    for part in [" s; broken laws: 0", "but the run ended before the other"] {
        assert!(report.contains(part), "{report}");
    }
}

/// A renderer that does not end by itself is ended.
#[test]
fn an_endless_renderer_is_ended() {
    let endless = PYTHON.to_owned() + "\n    import time\n    time.sleep(1000)\n";
    let line = r#"$laws --cases 4 python3 -c "$script""#;
    shell(&temporary(), &endless, line, 0);
}

/// What was found before a renderer ended is told.
#[test]
fn a_renderer_that_dies_leaves_what_was_found() {
    let script = python("if n == 500: sys.exit(3)");
    let report = shell(&temporary(), &script, r#"$laws python3 -c "$script""#, 1);
    assert!(report.contains("formula is BROKEN in"), "{report}");
    let why = "the run ended early: scene 500: it ended (exit status: 3)";
    assert!(report.contains(why), "{report}");
}

#[test]
fn output_that_cannot_be_written_is_no_panic() {
    if cfg!(target_os = "linux") {
        let stderr = shell(&temporary(), "", "$laws --list >/dev/full", 2);
        assert!(stderr.contains("cannot write the report: No space left"));
    }
    assert_eq!(shell(&temporary(), "", "$laws --list | true", 0), "");
}
