//! The program, with renderers that behave and renderers that do not.

#![cfg(feature = "cli")]
#![allow(missing_docs)]

mod nonsense;
mod planted;

use std::process::Command;

const PYTHON: &str = include_str!("../../examples/renderer.py");

/// The folder in which all commands run.
const FOLDER: &str = env!("CARGO_TARGET_TMPDIR");

fn program() -> Command {
    Command::new(env!("CARGO_BIN_EXE_shading-laws"))
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
fn shell(script: &str, line: &str, expected: i32) -> String {
    let mut command = Command::new("bash");
    command.args(["-c", line]).current_dir(FOLDER);
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

/// The renderer of a script that declares nothing, in the dark: black is right, so nothing but what it answers
/// otherwise is found.
fn in_the_dark(script: &str) -> String {
    let dark = r#"say('{"departs":["AmbientTimes=0","LightTimes=0"]}')"#;
    script.replace(r#"say("{}")"#, dark)
}

/// The examples keep all laws, built as their first lines say.
#[test]
fn examples_keep_all_laws() {
    for (language, build, command) in [
        ("python", "true", "python3 example.python"),
        ("javascript", "true", "node example.javascript"),
        ("c", "cc -O2 example.c -o by_c -lm", "./by_c"),
    ] {
        // JavaScript's engine is not on every machine
        let is_there = Command::new("node").arg("--version").output().is_ok();
        if language == "javascript" && !is_there {
            continue;
        }
        let line =
            format!("$laws example {language} >example.{language} && {build} && $laws {command}");
        let report = shell("", &line, 0);
        assert!(report.contains("0 of 3 laws broken"), "{report}");
    }
}

/// What Python, JavaScript, Rust, glibc, musl and the C library of Windows write for what is not finite is read: each
/// in one of twelve scenes that are asked once.
#[test]
fn nan_breaks_a_law_and_the_report_names_the_scene() {
    let script = python(
        r#"
lost = 'NaN nan -nan null "NaN" -nan(ind) nan(0x8000) 1.#QNAN -1.#IND00 Infinity -inf 1e999'.split()
scenes = [4, 5, 6, 7, 8, 9, 10, 14, 15, 16, 17, 18]
if is_scene and n in scenes:
    say('[0,%s,0]' % lost[scenes.index(n)])
    continue"#,
    );
    let report = shell(
        &in_the_dark(&script),
        r#"$laws --cases 4 python3 -c "$script""#,
        1,
    );
    assert!(report.contains("finite is BROKEN in 12 of"), "{report}");
    let command = "printf '%s\\n' '{\"shading-laws\":1}' '{\"model\":";
    assert!(report.contains(command), "{report}");
}

/// The third scene is the first again. It has another color now, even if that is no number.
#[test]
fn nan_for_a_scene_that_is_asked_again_is_memory() {
    for color in ["[0,0.5,0]", "[0,NaN,0]"] {
        let wrong = format!("if is_scene and n == 3:\n    say('{color}')\n    continue");
        let line = r#"$laws --cases 4 python3 -c "$script""#;
        let report = shell(&in_the_dark(&python(&wrong)), line, 1);
        for part in ["no_memory is BROKEN in 1 of", "formula holds in"] {
            assert!(report.contains(part), "{report}");
        }
    }
}

#[test]
fn departures_are_listed() {
    let list = shell("", "$laws --list", 0);
    for line in ["\nHighlightNotGated  ", "\nConeExponent=1  "] {
        assert!(list.contains(line), "{list}");
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
    let report = shell(&slow, line, 3);
    assert!(report.contains("0 of 3 laws broken"), "{report}");
    assert!(report.contains("formula holds in"), "{report}");
    assert!(!report.contains("holds in 0 cases"), "{report}");
    // Ctrl-C tells what was found
    let interrupt = r#"$laws python3 -c "$script" & sleep 4; kill -INT $!; wait $!"#;
    let report = shell(&slow, interrupt, 3);
    for part in [" s; broken laws: 0", "but the run ended before the other"] {
        assert!(report.contains(part), "{report}");
    }
}

/// A renderer that does not end by itself is ended.
#[test]
fn an_endless_renderer_is_ended() {
    let endless = PYTHON.to_owned() + "\n    import time\n    time.sleep(1000)\n";
    let line = r#"$laws --cases 4 python3 -c "$script""#;
    shell(&endless, line, 0);
}

/// What was found before a renderer ended is told.
#[test]
fn a_renderer_that_dies_leaves_what_was_found() {
    let script = python("if n == 500: sys.exit(3)");
    let report = shell(&script, r#"$laws python3 -c "$script""#, 1);
    assert!(report.contains("formula is BROKEN in"), "{report}");
    let why = "the run ended early: scene 500: it ended (exit status: 3)";
    assert!(report.contains(why), "{report}");
}

#[test]
fn output_that_cannot_be_written_is_no_panic() {
    if cfg!(target_os = "linux") {
        let stderr = shell("", "$laws --list >/dev/full", 2);
        assert!(stderr.contains("cannot write the report: No space left"));
    }
    assert_eq!(shell("", "$laws --list | true", 0), "");
}
