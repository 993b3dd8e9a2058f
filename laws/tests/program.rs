//! The program, with renderers that behave and renderers that do not.

#![cfg(feature = "cli")]
#![allow(missing_docs)]

use std::fs;
use std::process::Command;

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

/// Runs a line of a shell, in which the program is `$laws` and a script `$script`, and which must end with this status.
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
    let lines = lines.filter(|line| line.contains("shading-laws: "));
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
        ("c", "cc -x c -O2 file.c -o by_c -lm", "./by_c"),
        (
            "rust",
            "rustc -O --edition 2021 file.rust -o by_rust",
            "./by_rust",
        ),
    ] {
        let line =
            format!("$laws example {language} >file.{language} && {build} && $laws {command}");
        let report = shell(&folder, "", &line, 0);
        assert!(report.contains("0 of 22 laws broken"), "{report}");
    }
}

/// Forty mistakes in the example, written against another program than this: the old text, the new text, the mistakes that
/// are named and what they are placed by.
#[test]
fn edits_of_the_example_are_found_named_and_placed() {
    let folder = temporary();
    let (mut unnamed, mut astray) = (Vec::new(), Vec::new());
    let rows: Vec<&str> = include_str!("edits.txt").lines().collect();
    // a few laws, so that forty runs take seconds
    let options = "--law formula --law cone --cases 32 --shrink 0 --json";
    for row in &rows {
        let [old, new, names, places] = row.split(" => ").collect::<Vec<_>>()[..] else {
            panic!("{row}");
        };
        let [old, new] = [old, new].map(|text| text.replace('⏎', "\n"));
        assert!(PYTHON.contains(&old), "{old}");
        let edited = PYTHON.replacen(&old, &new, 1);
        let line = format!(r#"$laws {options} python3 -c "$script""#);
        let report = shell(&folder, &edited, &line, 1);
        let report: Value = serde_json::from_str(&report).expect("JSON");
        let findings = report["findings"].as_array().expect("findings");
        let all = |of: &dyn Fn(&Value) -> Vec<String>| findings.iter().flat_map(of).collect();
        let text = |value: &Value| value.as_str().unwrap_or_default().to_owned();
        let list = |value: &Value| value.as_array().cloned().unwrap_or_default();
        let name = |one: Value| text(&one["id"]) + &text(&one["of"]);
        let named: Vec<String> = all(&|finding| {
            let mistakes = list(&finding["cause"]["mistakes"]).into_iter();
            mistakes.map(name).collect()
        });
        let found: Vec<String> = all(&|finding| {
            let places = list(&finding["places"]).into_iter();
            let knobs = places.flat_map(|place| list(&place["only_with"]));
            knobs.map(|knob| text(&knob)).collect()
        });
        let has = |name: &str| named.iter().any(|id| id.starts_with(name));
        if !names.split(", ").all(has) {
            unnamed.push((row, named));
        }
        if !places
            .split(", ")
            .all(|place| found.contains(&place.into()))
        {
            astray.push((row, found));
        }
    }
    println!("{} unnamed: {unnamed:#?}", unnamed.len());
    assert!(unnamed.len() * 10 <= rows.len(), "{unnamed:#?}");
    assert!(astray.is_empty(), "{astray:#?}");
}

#[test]
fn nan_breaks_a_law_and_the_report_names_the_scene() {
    for nan in ["NaN", "nan", "1e999", "-Infinity"] {
        let script = python(&format!("if is_scene: say('[0,{nan},0]'); continue"));
        let line = r#"$laws --law finite --cases 8 python3 -c "$script""#;
        let report = shell(&temporary(), &script, line, 1);
        let command = "printf '%s\\n' '{\"shading-laws\":1}' '{\"model\":";
        assert!(report.contains(command), "{report}");
    }
}

#[test]
fn laws_are_listed_and_chosen() {
    let folder = temporary();
    let list = shell(&folder, "", "$laws --list", 0);
    let names = list.lines().filter_map(|line| line.split("  ").next());
    let names: Vec<&str> = names.collect();
    assert!(names.len() > 2, "{list}");
    let (first, second) = (names[0], names[1]);
    let line = format!(r#"$laws --law {first} --law {second} --cases 16 python3 -c "$script""#);
    let report = shell(&folder, PYTHON, &line, 0);
    let is_named = |name: &&str| report.contains(*name);
    assert!(names[..2].iter().all(is_named) && !is_named(&names[2]));
    let stderr = shell(&folder, "", "$laws --law gravity true", 2);
    assert!(stderr.contains("gravity"), "{stderr}");
}

#[test]
fn a_wrong_command_is_refused() {
    let folder = temporary();
    fs::write(folder.path().join("renderer"), "").expect("a file");
    for (command, part) in [
        ("./no_such_renderer", "No such file"),
        ("renderer", "write ./renderer"),
        ("./renderer", "is it executable?"),
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
        ("exec sleep 1000", "no line within 2s"),
        ("exec >&-; exec sleep 1000", "it closed its output"),
        ("echo '{}'; exec sleep 1000", "scene 1: no answer within 2s"),
    ];
    let answers = [
        ("sys.exit(3)", "it ended (exit status: 3)"),
        ("os.abort()", "it ended (signal: 6"),
        ("say('dark')", "expected [red,green,blue], found \"dark\""),
        ("say('')", "expected [red,green,blue], found \"\""),
        ("say('[1,2]')", "expected 3 numbers, found 2"),
        ("say('[1,2,3,4]')", "expected 3 numbers, found 4"),
        ("say('[1,2,red]')", "\"red\" is no number"),
        ("say('[null,null,null]')", "JavaScript"),
        ("say('[' + '1' * 10**6)", endless),
        ("os.write(1, b'[\\xff,0,0]\\n')", "is not UTF-8"),
        (
            "os.write(1, b'[0.'); sys.exit(3)",
            "3) in the middle of the line \"[0.\"",
        ),
        ("pass", "no answer within 2s"),
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
    for some in all.chunks(4) {
        std::thread::scope(|scope| {
            for (interpreter, script, parts) in some {
                scope.spawn(move || {
                    let is_late = parts.iter().any(|part| part.contains("within 2s"));
                    let timeout = if is_late { "2" } else { "60" };
                    let mut command = program();
                    command.args(["--cases", "4", "--law", "finite", "--timeout", timeout]);
                    refused(command.args([interpreter, "-c", script]), parts);
                });
            }
        });
    }
}

/// A renderer that does not end by itself is ended.
#[test]
fn an_endless_renderer_is_ended() {
    let endless = PYTHON.to_owned() + "\n    import time\n    time.sleep(1000)\n";
    let line = r#"$laws --law finite --cases 4 python3 -c "$script""#;
    shell(&temporary(), &endless, line, 0);
}

/// What was found before a renderer ended is told, and is in the files.
#[test]
fn a_renderer_that_dies_leaves_what_was_found() {
    let folder = temporary();
    let script = python("if n == 500: sys.exit(3)");
    let line = r#"$laws --junit junit.xml --save cases python3 -c "$script""#;
    let report = shell(&folder, &script, line, 1);
    let why = "the run ended early: scene 500: it ended (exit status: 3)";
    assert!(report.contains(why), "{report}");
    let of = |name| fs::read_to_string(folder.path().join(name)).expect("a file");
    let (xml, cases) = (of("junit.xml"), of("cases"));
    assert!(xml.contains("<error message=\"scene 500: it ended") && xml.contains("<failure"));
    assert!(cases.contains(r#"{"law":"ambient_alone","scene":{"model":"#));
}

#[test]
fn output_that_cannot_be_written_is_no_panic() {
    if cfg!(target_os = "linux") {
        let stderr = shell(&temporary(), "", "$laws --list >/dev/full", 2);
        assert!(stderr.contains("cannot write the report: No space left"));
    }
    assert_eq!(shell(&temporary(), "", "$laws --list | true", 0), "");
}

/// Without a pipe: scenes to a file, colors from a file, and the same verdicts.
#[test]
fn a_file_of_colors_is_judged() {
    let folder = temporary();
    let options = r#"--cases 8 --profile '{"roundoff":1.2e-16}'"#;
    let answer = format!(
        r#"$laws scenes {options} | sed '1i {{}}' | python3 -c "$script" | tail -n +2 >colors
        $laws judge {options} colors"#
    );
    shell(&folder, PYTHON, &answer, 0);
    let black = format!("sed 's/.*/[0,0,0]/' colors >black; $laws judge {options} black");
    let report = shell(&folder, "", &black, 1);
    assert!(report.contains("Finding 1 of 1: all colors are black\n"));
    assert!(!report.contains("the run ended early"), "{report}");
    let few = format!("head -1 colors >few; $laws judge {options} few");
    let report = shell(&folder, "", &few, 2);
    assert!(report.contains("1 colors for") && report.contains("need the same options"));
}

/// What is known to be broken passes, and what is known and holds does not; stored cases are tried again.
#[test]
fn known_failures_and_stored_cases() {
    let folder = temporary();
    let go = |setup: &str, options: &str, status: i32, expected: &str| {
        let laws = "--law ambient_alone --law eye --cases 8";
        let line = format!(r#"{setup} $laws {laws} {options} python3 -c "$script""#);
        let text = shell(&folder, &python(""), &line, status);
        assert!(text.contains(expected), "{text}");
    };
    let broken = "ambient_alone is BROKEN in";
    go("", "--save cases", 1, broken);
    go(
        "grep -q '^{\"law\":\"ambient' cases &&",
        "--replay cases",
        1,
        broken,
    );
    let known = "--known known";
    go(
        "echo 'ambient_alone # black' >known;",
        known,
        0,
        "as is known",
    );
    go(
        "echo eye >>known;",
        known,
        1,
        "eye holds, but is known as broken",
    );
    go(
        "echo gravity >>known;",
        known,
        2,
        "known: line 3: there is no law gravity",
    );
    go(
        "echo {} >cases;",
        "--replay cases",
        2,
        "replayed case 1: missing field",
    );
}

/// Another program's parser reads the XML and finds what the report has; control characters of a name are escaped.
#[test]
fn reports_come_as_junit() {
    let folder = temporary();
    let named = r#"say('{"name":"<&\\u0007>"}')"#;
    let black = python("").replace(r#"say("{}")"#, named);
    let count = "
import xml.etree.ElementTree as E
root = E.parse('junit.xml').getroot()
of = lambda name: len(root.findall('.//' + name))
name = root.find('testsuite').get('name')
print(root.get('tests'), of('testcase'), root.get('failures'), of('failure'), of('skipped'), name)
";
    let laws = "--law ambient_alone --law eye --law as_said --cases 8";
    let line = format!(r#"$laws {laws} --junit junit.xml python3 -c "$script""#);
    let report = shell(&folder, &black, &line, 1);
    assert!(report.starts_with("<&\\u{7}>, seed 0"), "{report}");
    let read = shell(&folder, count, r#"python3 -c "$script""#, 0);
    assert_eq!(read.trim(), r"3 3 1 1 1 <&\u{7}>, seed 0");
    let xml = fs::read_to_string(folder.path().join("junit.xml")).expect("a file");
    assert!(xml.contains("the color is k_a I_a"), "{xml}");
}
