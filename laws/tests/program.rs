//! The program, with renderers that behave and renderers that do not.

#![cfg(feature = "cli")]
#![allow(missing_docs)]

use std::fs;
use std::process::{Command, Output};
use std::time::{Duration, Instant};

use serde_json::Value;
use tempfile::TempDir;

fn program() -> Command {
    Command::new(env!("CARGO_BIN_EXE_shading-laws"))
}

fn temporary() -> TempDir {
    tempfile::tempdir().expect("a temporary folder")
}

/// The exit status, the standard output and the standard error.
fn run(command: &mut Command) -> (Option<i32>, String, String) {
    let Output {
        status,
        stdout,
        stderr,
    } = command.output().expect("the program starts");
    let [stdout, stderr] = [stdout, stderr].map(|text| String::from_utf8(text).expect("UTF-8"));
    (status.code(), stdout, stderr)
}

/// Runs a command that must succeed.
fn succeed(command: &mut Command) -> String {
    let (status, stdout, stderr) = run(command);
    assert_eq!(status, Some(0), "{command:?}\n{stdout}\n{stderr}");
    stdout
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

/// Tries a script by the laws; `interpreter` is `sh` or `python3`.
fn try_script(interpreter: &str, script: &str, options: &[&str]) -> (Option<i32>, String, String) {
    run(program().args(options).args([interpreter, "-c", script]))
}

/// The program cannot talk to the renderer, and says why in one line with all `parts`.
#[track_caller]
fn refused((status, stdout, stderr): (Option<i32>, String, String), parts: &[&str]) {
    assert_eq!(status, Some(2), "{stdout}{stderr}");
    assert_eq!(stdout, "");
    // the others are the renderer's own; one that is killed may leave half a line before this one
    let lines = stderr
        .lines()
        .filter(|line| line.contains("shading-laws: "));
    assert_eq!(lines.count(), 1, "{stderr}");
    for part in parts {
        assert!(stderr.contains(part), "no {part:?} in: {stderr}");
    }
}

const SCENE: &str = r#"the scene: {"model":""#;

const PYTHON: &str = include_str!("../examples/renderer.py");

/// The examples keep all laws, built as their first lines say.
#[test]
fn examples_keep_all_laws() {
    let folder = temporary();
    for (language, build, command) in [
        ("python", "true", "python3 renderer.python"),
        ("c", "cc -O2 renderer.c -o by_c -lm", "./by_c"),
        (
            "rust",
            "rustc -O --edition 2021 renderer.rust -o by_rust",
            "./by_rust",
        ),
    ] {
        let text = succeed(program().args(["example", language]));
        fs::write(folder.path().join(format!("renderer.{language}")), text).expect("a file");
        succeed(Command::new("sh").args(["-c", build]).current_dir(&folder));
        let mut command = command.split(' ');
        let report = succeed(program().args(&mut command).current_dir(&folder));
        assert!(report.contains("0 of 27 laws broken"), "{report}");
    }
}

/// Forty mistakes in the example, written against another program than this: the old text, the new text, the mistakes that
/// are named and what they are placed by.
#[test]
fn edits_of_the_example_are_found_named_and_placed() {
    let folder = temporary();
    let (mut unnamed, mut astray) = (Vec::new(), Vec::new());
    let rows: Vec<&str> = include_str!("edits.txt").lines().collect();
    for row in &rows {
        let [old, new, names, places] = row.split(" => ").collect::<Vec<_>>()[..] else {
            panic!("{row}");
        };
        let [old, new] = [old, new].map(|text| text.replace('⏎', "\n"));
        assert!(PYTHON.contains(&old), "{old}");
        let edited = PYTHON.replacen(&old, &new, 1);
        fs::write(folder.path().join("renderer.py"), edited).expect("a file");
        let mut command = program();
        // a few laws, so that forty runs take seconds
        for law in ["formula", "cone", "mirror", "length_of_v", "channels_apart"] {
            command.args(["--law", law]);
        }
        command.args(["--json", "--cases", "32", "--shrink", "0"]);
        command
            .args(["python3", "renderer.py"])
            .current_dir(&folder);
        let (status, report, stderr) = run(&mut command);
        assert_eq!(status, Some(1), "{row}: {stderr}");
        let report: Value = serde_json::from_str(&report).expect("JSON");
        let findings = report["findings"].as_array().expect("findings");
        let causes = findings
            .iter()
            .filter_map(|one| one["cause"]["mistakes"].as_array());
        let text = |value: &Value| value.as_str().unwrap_or_default().to_owned();
        let named: Vec<String> = causes
            .flatten()
            .map(|one| text(&one["id"]) + &text(&one["of"]))
            .collect();
        let has = |name: &str| named.iter().any(|id| id.starts_with(name));
        if !names.split(", ").all(has) {
            unnamed.push((row, named));
        }
        let found = findings
            .iter()
            .filter_map(|one| one["places"].as_array())
            .flatten();
        let found = found
            .filter_map(|place| place["only_with"].as_array())
            .flatten();
        let found: Vec<&str> = found.filter_map(Value::as_str).collect();
        if !places.split(", ").all(|place| found.contains(&place)) {
            astray.push((row, found.join(", ")));
        }
    }
    assert!(unnamed.len() * 10 <= rows.len(), "{unnamed:#?}");
    assert!(astray.is_empty(), "{astray:#?}");
}

#[test]
fn nan_breaks_a_law_and_the_report_names_the_scene() {
    for nan in ["NaN", "nan", "1e999", "-Infinity"] {
        let script = python(&format!("if is_scene: say('[0,{nan},0]'); continue"));
        let (status, report, stderr) = try_script("python3", &script, &["--law", "finite"]);
        assert_eq!(status, Some(1), "{report}{stderr}");
        let command = "printf '%s\\n' '{\"shading-laws\":1}' '{\"model\":";
        assert!(report.contains(command), "{report}");
    }
}

#[test]
fn laws_are_listed_and_chosen() {
    let list = succeed(program().arg("--list"));
    let names: Vec<&str> = list
        .lines()
        .filter_map(|line| line.split("  ").next())
        .collect();
    assert!(names.len() > 2, "{list}");

    let python = PYTHON;
    let options = ["--law", names[0], "--law", names[1], "--cases", "16"];
    let (status, report, _) = try_script("python3", python, &options);
    assert_eq!(status, Some(0), "{report}");
    let is_named = |name: &&str| report.contains(*name);
    assert!(
        names[..2].iter().all(is_named) && !is_named(&names[2]),
        "{report}"
    );

    let (status, _, stderr) = try_script("python3", python, &["--law", "gravity"]);
    assert_eq!(status, Some(2));
    assert!(stderr.contains("gravity"), "{stderr}");
}

#[test]
fn a_wrong_command_is_refused() {
    refused(
        run(program().arg("./no_such_renderer")),
        &["./no_such_renderer", "No such file"],
    );

    let folder = temporary();
    fs::write(folder.path().join("renderer"), "").expect("a file");
    let in_folder = |command| run(program().arg(command).current_dir(&folder));
    refused(in_folder("renderer"), &["write ./renderer"]);
    refused(in_folder("./renderer"), &["is it executable?"]);

    assert_eq!(run(&mut program()).0, Some(2));
    assert_eq!(run(program().args(["--timeout", "0", "cat"])).0, Some(2));
}

#[test]
fn a_wrong_start_is_refused() {
    for (script, part) in [
        (
            "exit 3",
            r#"in answer to {"shading-laws":1}: it ended (exit status: 3)"#,
        ),
        ("exec 0<&- >&-; exit 3", "exit status: 3"),
        ("kill -SEGV $$", "SIGSEGV"),
        ("cat", "unknown field `shading-laws`"), // says what it hears
        ("echo ready", "expected a JSON object or {}, in \"ready\""),
        (r#"echo '{"hue":1}'"#, "unknown field `hue`"),
        (r#"echo '{"bits":8,"bits":8}'"#, "duplicate field `bits`"),
        (r#"echo '{"bits":"8"}'"#, "invalid type: string"),
        (r#"echo '{"models":[]}'"#, "models is empty"),
        ("cat /dev/zero", "longer than 65536 bytes"),
        (r"printf '\377\n'", "not UTF-8"),
    ] {
        refused(try_script("sh", script, &[]), &[part]);
    }
}

#[test]
fn a_wrong_answer_is_refused_with_its_scene() {
    let long = "longer than 65536 bytes";
    for (body, part) in [
        ("sys.exit(3)", "scene 3: it ended (exit status: 3)"),
        ("os.abort()", "scene 3: it ended (signal: 6"),
        ("say('dark')", "expected [red,green,blue], found \"dark\""),
        ("say('')", "expected [red,green,blue], found \"\""),
        ("say('[1,2]')", "scene 3: expected 3 numbers, found 2"),
        ("say('[1,2,3,4]')", "scene 3: expected 3 numbers, found 4"),
        ("say('[1,2,red]')", "scene 3: \"red\" is no number"),
        ("say('[null,null,null]')", "JavaScript"),
        ("say('[' + '1' * 10**6)", long),
        ("os.write(1, b'[\\xff,0,0]\\n')", "is not UTF-8"),
        (
            "os.write(1, b'[0.'); sys.exit(3)",
            "3) in the middle of the line \"[0.\"",
        ),
    ] {
        let script = format!("if is_scene and n == 3:\n    {body}\n    continue");
        let tried = try_script("python3", &python(&script), &[]);
        refused(tried, &["scene 3: ", part, SCENE]);
    }
}

#[test]
fn too_many_answers_are_refused() {
    let hint = "the empty line has no answer";
    for answer in ["[0,0,0]", "", "done"] {
        let at_the_end = python(&format!("if not is_scene: say('{answer}')"));
        refused(
            try_script("python3", &at_the_end, &[]),
            &["after the answer to scene ", hint],
        );
    }
    // a single line too many is known at the end of the pipe
    let once = python("if is_scene and n == 3: say('[0,0,0]')");
    let (status, ..) = try_script("python3", &once, &[]);
    assert_eq!(status, Some(2));
}

/// The program waits for each of these renderers until its time is over. All wait at once.
#[test]
fn a_renderer_that_hangs_is_refused() {
    let begin = Instant::now();
    let late = |script: &str, parts: &[&str]| {
        refused(try_script("sh", script, &["--timeout", "2"]), parts);
    };
    let few = python("if n == 3: continue");
    let few = || try_script("python3", &few, &["--timeout", "2"]);
    let endless = PYTHON.to_owned() + "\n    import time\n    time.sleep(1000)\n";
    std::thread::scope(|scope| {
        scope.spawn(|| late("exec sleep 1000", &["no line within 2s"]));
        scope.spawn(|| late("exec >&-; exec sleep 1000", &["it closed its output"]));
        scope.spawn(|| {
            late(
                "echo '{}'; exec sleep 1000",
                &["scene 1: no answer within 2s", SCENE],
            );
        });
        scope.spawn(|| refused(few(), &["no answer within 2s", SCENE]));
        // this one keeps the laws, and does not end by itself
        scope.spawn(|| {
            assert_eq!(
                try_script("python3", &endless, &["--cases", "4"]).0,
                Some(0)
            );
        });
    });
    assert!(begin.elapsed() < Duration::from_secs(100)); // 1000 is how long they sleep
}

/// What was found before a renderer ended is told, and is in the files.
#[test]
fn a_renderer_that_dies_leaves_what_was_found() {
    let folder = temporary();
    let script = python("if n == 500: sys.exit(3)");
    let mut command = program();
    command.args([
        "--junit",
        "junit.xml",
        "--save",
        "cases",
        "python3",
        "-c",
        &script,
    ]);
    let (status, report, _) = run(command.current_dir(&folder));
    let why = "the run ended early: scene 500: it ended (exit status: 3)";
    assert!(status == Some(1) && report.contains(why), "{report}");
    let of = |name| fs::read_to_string(folder.path().join(name)).expect("a file");
    let (xml, cases) = (of("junit.xml"), of("cases"));
    assert!(
        xml.contains("<error message=\"scene 500: it ended") && xml.contains("<failure"),
        "{xml}"
    );
    assert!(
        cases.contains(r#"{"law":"ambient_alone","scene":{"model":"#),
        "{cases}"
    );
}

#[test]
fn a_status_after_the_last_color_is_reported() {
    let script = PYTHON.to_owned() + "\n    sys.exit(3)\n";
    let tried = try_script("python3", &script, &["--cases", "4", "--law", "finite"]);
    refused(tried, &["after its last color it ended (exit status: 3)"]);
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_reported() {
    let listing = format!("{} --list > /dev/full", env!("CARGO_BIN_EXE_shading-laws"));
    let (status, _, stderr) = run(Command::new("sh").args(["-c", &listing]));
    assert_eq!(status, Some(2));
    assert!(
        stderr.contains("cannot write the report: No space left"),
        "{stderr}"
    );
}

#[test]
fn control_characters_of_a_name_are_escaped() {
    let script = python("").replace("say(\"{}\")", r#"say('{"name":"a\\u001b[31mb"}')"#);
    let (_, report, stderr) = try_script("python3", &script, &["--cases", "4"]);
    assert!(
        report.starts_with("a\\u{1b}[31mb, seed 0"),
        "{report}{stderr}"
    );
}

/// Without a pipe: scenes to a file, colors from a file, and the same verdicts.
#[test]
fn a_file_of_colors_is_judged() {
    let folder = temporary();
    let options = ["--cases", "8", "--profile", r#"{"roundoff":1.2e-16}"#];
    let scenes = succeed(program().arg("scenes").args(options));
    let python = PYTHON;
    fs::write(folder.path().join("renderer.py"), python).expect("a file");
    fs::write(folder.path().join("scenes"), "{}\n".to_owned() + &scenes).expect("a file");
    let answer = "python3 renderer.py <scenes | tail -n +2 >colors";
    succeed(Command::new("sh").args(["-c", answer]).current_dir(&folder));
    let judge = |file: &str| {
        let mut command = program();
        command
            .arg("judge")
            .args(options)
            .arg(file)
            .current_dir(&folder);
        run(&mut command)
    };
    let (status, report, stderr) = judge("colors");
    assert_eq!(status, Some(0), "{report}{stderr}");

    let colors = fs::read_to_string(folder.path().join("colors")).expect("colors");
    let black = colors.lines().map(|_| "[0,0,0]\n").collect::<String>();
    fs::write(folder.path().join("black"), black).expect("a file");
    let (status, report, _) = judge("black");
    assert_eq!(status, Some(1));
    assert!(
        report.contains("Finding 1 of 1: all colors are black"),
        "{report}"
    );

    fs::write(folder.path().join("few"), "[0,0,0]\n").expect("a file");
    refused(judge("few"), &["1 colors for", "need the same options"]);
    fs::write(folder.path().join("many"), colors + "[0,0,0]\n").expect("a file");
    refused(judge("many"), &["colors for", "need the same options"]);
}

/// What is known to be broken passes, and what is known and holds does not; stored cases are tried again.
#[test]
fn known_failures_and_stored_cases() {
    let folder = temporary();
    let black = python("");
    let go = |options: &[&str]| {
        let mut command = program();
        command.args(["--law", "ambient_alone", "--law", "eye", "--cases", "8"]);
        command.args(options).args(["python3", "-c", &black]);
        run(command.current_dir(&folder))
    };
    let (status, ..) = go(&["--save", "cases"]);
    assert_eq!(status, Some(1));
    let cases = fs::read_to_string(folder.path().join("cases")).expect("cases");
    assert!(
        cases.starts_with(r#"{"law":"ambient_alone","scene":{"#),
        "{cases}"
    );
    let (status, report, stderr) = go(&["--replay", "cases"]);
    assert_eq!(status, Some(1), "{stderr}");
    assert!(report.contains("ambient_alone is BROKEN in"), "{report}");

    fs::write(folder.path().join("known"), "ambient_alone # black\n").expect("a file");
    assert_eq!(go(&["--known", "known"]).0, Some(0));
    fs::write(folder.path().join("known"), "ambient_alone\neye\n").expect("a file");
    let (status, report, _) = go(&["--known", "known"]);
    assert_eq!(status, Some(1));
    assert!(
        report.contains("eye holds, but is known as broken"),
        "{report}"
    );
    fs::write(folder.path().join("known"), "eye\ngravity\n").expect("a file");
    refused(
        go(&["--known", "known"]),
        &["known: line 2: there is no law gravity"],
    );
    fs::write(folder.path().join("cases"), "{}\n").expect("a file");
    refused(
        go(&["--replay", "cases"]),
        &["replayed case 1: missing field"],
    );
}

/// Another program's parser reads the XML and finds what the report has.
#[test]
fn reports_come_as_junit() {
    let folder = temporary();
    let named = r#"say('{"name":"<&\\u0007>"}')"#;
    let black = python("").replace(r#"say("{}")"#, named);
    let count = r"
import sys, xml.etree.ElementTree as E
root = E.parse(sys.argv[1]).getroot()
suite = root.find('testsuite')
of = lambda name: len(root.findall('.//' + name))
print(root.get('tests'), of('testcase'), root.get('failures'), of('failure'), of('skipped'), suite.get('name'))
";
    let mut command = program();
    command.args([
        "--law",
        "ambient_alone",
        "--law",
        "eye",
        "--law",
        "as_said",
        "--cases",
        "8",
    ]);
    command.args(["--junit", "junit.xml", "python3", "-c", &black]);
    let (status, report, stderr) = run(command.current_dir(&folder));
    assert_eq!(status, Some(1), "{report}{stderr}");
    let read = succeed(
        Command::new("python3")
            .args(["-c", count, "junit.xml"])
            .current_dir(&folder),
    );
    assert_eq!(read.trim(), r"4 4 1 1 1 <&\u{7}>, seed 0");
    let xml = fs::read_to_string(folder.path().join("junit.xml")).expect("a file");
    assert!(xml.contains("the color is k_a I_a"), "{xml}");
}

/// Whoever closes the program's output does not make it panic.
#[test]
fn a_closed_pipe_is_no_panic() {
    let listing = format!("{} --list | true", env!("CARGO_BIN_EXE_shading-laws"));
    let (_, _, stderr) = run(Command::new("bash").args(["-c", &listing]));
    assert_eq!(stderr, "");
}
