//! The program, with renderers that behave and renderers that do not.

use std::fs;
use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};

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

/// Puts a script to the test; `interpreter` is `sh` or `python3`.
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

/// Writes an example, builds it and puts it to the test, by the commands that the program prints.
fn follow(language: &str, file: &str) {
    let folder = temporary();
    let told = succeed(program().args(["example", language]).current_dir(&folder));
    assert!(folder.path().join(file).exists(), "{told}");
    let commands: Vec<&str> = told
        .lines()
        .filter_map(|l| l.strip_prefix("    "))
        .collect();
    let (test, build) = commands.split_last().expect("a command");
    for command in build {
        succeed(
            Command::new("sh")
                .args(["-c", command])
                .current_dir(&folder),
        );
    }
    let arguments = test.strip_prefix("shading-laws ").expect("the program");
    let report = succeed(program().args(arguments.split(' ')).current_dir(&folder));
    assert!(report.contains(file), "{report}");

    let (status, _, again) = run(program().args(["example", language]).current_dir(&folder));
    assert_eq!(status, Some(2));
    assert!(again.contains("exists already"), "{again}");
}

#[test]
fn python_example_keeps_all_laws() {
    follow("python", "renderer.py");
}

#[test]
fn c_example_keeps_all_laws() {
    follow("c", "renderer.c");
}

#[test]
fn rust_example_keeps_all_laws() {
    follow("rust", "renderer.rs");
}

#[test]
fn examples_are_written_where_one_says() {
    let folder = temporary();
    let file = folder.path().join("mine.c");
    let told = succeed(program().args(["example", "c", "--to"]).arg(&file));
    assert!(file.exists() && told.contains("mine.c"), "{told}");
    succeed(program().args(["example", "c", "--to"]).arg(folder.path()));
    assert!(folder.path().join("renderer.c").exists());
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
fn reports_come_as_json() {
    for (script, status) in [
        (include_str!("../../examples/renderer.py"), 0),
        (&python("if is_scene: say('[0,NaN,0]'); continue"), 1),
    ] {
        let (code, report, _) = try_script("python3", script, &["--json", "--cases", "16"]);
        assert_eq!(code, Some(status), "{report}");
        let report: serde_json::Value = serde_json::from_str(&report).expect("JSON");
        assert!(report.is_object(), "{report}");
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

    let python = include_str!("../../examples/renderer.py");
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
    let start = |script| try_script("sh", script, &[]);
    let ends = "exit status: 3";
    refused(
        start("exit 3"),
        &[r#"in answer to {"shading-laws":1}"#, ends],
    );
    refused(start("exec 0<&- >&-; exit 3"), &[ends]);
    refused(start("kill -SEGV $$"), &["SIGSEGV"]);
    refused(
        start("cat"),
        &[r#""shading-laws": there is no such member"#],
    ); // says what it hears
    refused(start("echo ready"), &["expected a JSON object", "ready"]);
    refused(
        start(r#"echo '{"hue":1}'"#),
        &[r#""hue": there is no such member"#],
    );
    refused(
        start(r#"echo '{"bits":"8"}'"#),
        &[r#""bits": invalid type"#],
    );
    refused(start(r#"echo '{"models":[]}'"#), &["models is empty"]);
    refused(start("cat /dev/zero"), &["longer than 65536 bytes"]);
    refused(start(r"printf '\377\n'"), &["not UTF-8"]);
}

#[test]
fn a_wrong_answer_is_refused_with_its_scene() {
    let third = |body: &str| {
        let script = python(&format!(
            "if is_scene and n == 3:\n    {body}\n    continue"
        ));
        try_script("python3", &script, &[])
    };
    refused(
        third("sys.exit(3)"),
        &["scene 3: it ended (exit status: 3)", SCENE],
    );
    refused(
        third("os.abort()"),
        &["scene 3: it ended (signal: 6", SCENE],
    );
    refused(
        third("say('dark')"),
        &["scene 3: expected [red,green,blue], found \"dark\"", SCENE],
    );
    refused(
        third("say('')"),
        &["scene 3: expected [red,green,blue], found \"\"", SCENE],
    );
    refused(
        third("say('[1,2]')"),
        &["scene 3: expected 3 numbers, found 2", SCENE],
    );
    refused(
        third("say('[1,2,3,4]')"),
        &["scene 3: expected 3 numbers, found 4", SCENE],
    );
    refused(
        third("say('[1,2,red]')"),
        &["scene 3: \"red\" is no number", SCENE],
    );
    refused(
        third("say('[' + '1' * 10**6)"),
        &["scene 3", "longer than 65536 bytes", SCENE],
    );
    refused(
        third("sys.stdout.buffer.write(b'[\\xff,0,0]\\n'); sys.stdout.buffer.flush()"),
        &["scene 3", "is not UTF-8", SCENE],
    );
    refused(
        third("sys.stdout.write('[0.'); sys.exit(3)"),
        &[
            "scene 3",
            "(exit status: 3) in the middle of the line \"[0.\"",
            SCENE,
        ],
    );
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

/// The program waits for each of these renderers until its time is over, and kills what it started. All wait at once. A
/// limit of time leaves a busy machine enough to start a script.
#[test]
fn a_renderer_that_hangs_is_killed_with_what_it_started() {
    let begin = Instant::now();
    let late = |script: &str, parts: &[&str]| {
        let folder = temporary();
        let script = format!("echo $$ >group; {script}");
        let mut command = program();
        command
            .args(["--timeout", "4", "sh", "-c", &script])
            .current_dir(&folder);
        refused(run(&mut command), parts);
        assert_gone(&folder.path().join("group"));
    };
    let start = |script: &str, part: &str| late(script, &[part]);
    let first = |script: &str| {
        let script = format!("echo '{{}}'; {script}");
        late(&script, &["scene 1: no answer within 4s", SCENE]);
    };
    std::thread::scope(|scope| {
        scope.spawn(|| start("sleep 1000; :", "no line within 4s"));
        scope.spawn(|| start("exec >&-; sleep 1000; :", "it closed its output"));
        scope.spawn(|| first("sleep 1000; :"));
        // this one ends at once, and leaves a process that holds the pipe
        scope.spawn(|| first("sleep 1000 & exit 0"));
        scope.spawn(|| first("cat >/dev/null; sleep 1000"));
        scope.spawn(too_few_answers_are_refused);
        scope.spawn(a_renderer_that_does_not_end_is_killed);
    });
    assert!(begin.elapsed() < Duration::from_secs(100)); // 1000 is how long they sleep
}

fn too_few_answers_are_refused() {
    let script = python("if n == 3: continue");
    let tried = try_script("python3", &script, &["--timeout", "4"]);
    let left = "1 scene of the batch left";
    refused(tried, &["scene ", "no answer within 4s", left, SCENE]);
}

/// This one keeps the laws, and does not end by itself.
fn a_renderer_that_does_not_end_is_killed() {
    let folder = temporary();
    let endless = include_str!("../../examples/renderer.py").to_owned()
        + "\n    import os, time\n"
        + "    print(os.getpid(), file=open('group', 'w'), flush=True)\n    time.sleep(1000)\n";
    let mut command = program();
    command
        .args(["--cases", "16", "python3", "-c", &endless])
        .current_dir(&folder);
    succeed(&mut command);
    assert_gone(&folder.path().join("group"));
}

#[test]
fn an_interrupt_kills_the_renderer() {
    let folder = temporary();
    let group = folder.path().join("group");
    let mut command = program();
    command.args([
        "sh",
        "-c",
        "echo $$ >group.new; mv group.new group; sleep 1000; :",
    ]);
    command.current_dir(&folder).stderr(Stdio::null());
    let mut running = command.spawn().expect("the program starts");
    while !group.exists() {
        std::thread::sleep(Duration::from_millis(10));
    }
    succeed(Command::new("kill").args(["-INT", &running.id().to_string()]));
    assert_eq!(running.wait().expect("an end").code(), Some(130));
    assert_gone(&group);
}

/// No process is left in the group whose number is in a file.
fn assert_gone(file: &Path) {
    let group = fs::read_to_string(file).expect("the number of the group");
    let probe = format!("kill -0 -- -{}", group.trim());
    let begin = Instant::now();
    while run(Command::new("sh").args(["-c", &probe])).0 == Some(0) {
        assert!(
            begin.elapsed() < Duration::from_secs(5),
            "group {group} lives"
        );
        std::thread::sleep(Duration::from_millis(10));
    }
}

#[test]
fn a_status_after_the_last_color_is_reported() {
    let script = include_str!("../../examples/renderer.py").to_owned() + "\n    sys.exit(3)\n";
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
    let python = include_str!("../../examples/renderer.py");
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
        report.contains("Likely cause: all colors are black"),
        "{report}"
    );

    fs::write(folder.path().join("few"), "[0,0,0]\n").expect("a file");
    refused(judge("few"), &["only 1 colors", "need the same options"]);
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
    let (status, report, stderr) = go(&["--replay", "cases", "--tap"]);
    assert_eq!(status, Some(1), "{stderr}");
    assert!(
        report.starts_with("TAP version 13\n1..3\nnot ok 1 - ambient_alone\n"),
        "{report}"
    );

    fs::write(folder.path().join("known"), "ambient_alone # black\n").expect("a file");
    assert_eq!(go(&["--known", "known"]).0, Some(0));
    fs::write(folder.path().join("known"), "ambient_alone\neye\n").expect("a file");
    let (status, report, _) = go(&["--known", "known"]);
    assert_eq!(status, Some(1));
    assert!(report.contains("holds, but is known as broken"), "{report}");
    fs::write(folder.path().join("cases"), "{}\n").expect("a file");
    refused(go(&["--replay", "cases"]), &["cases: line 1: no \"law\""]);
}

/// The code that a report shows, pasted after an example with a mistake, gives the colors that the report shows.
#[test]
fn broken_cases_are_reproduced_in_the_language_of_the_example() {
    let folder = temporary();
    let path = |name: &str| folder.path().join(name);
    let python = include_str!("../../examples/renderer.py");
    let python = python.replace(r#"mul(scene["k_a"], scene["i_a"])"#, r#"scene["k_a"]"#);
    fs::write(path("renderer.py"), &python).expect("a file");
    let report = |options: &[&str]| {
        let mut command = program();
        command
            .args(["--law", "ambient_alone", "--cases", "8"])
            .args(options);
        command
            .args(["python3", "renderer.py"])
            .current_dir(&folder);
        let (status, report, stderr) = run(&mut command);
        assert_eq!(status, Some(1), "{report}{stderr}");
        report
    };
    let numbers = |text: &str| -> Vec<f64> {
        let words = text.split(|c: char| !c.is_ascii_digit() && !".-e".contains(c));
        words.filter_map(|word| word.parse().ok()).collect()
    };
    let sh = |command: &str| {
        succeed(
            Command::new("sh")
                .args(["-c", command])
                .current_dir(&folder),
        )
    };
    let after = |report: &str, words: &str| {
        let (_, code) = report.split_once(words).expect("code");
        code.to_owned()
    };

    let plain = report(&[]);
    let shown = plain
        .lines()
        .find_map(|line| line.strip_prefix("  color 1: "));
    let shown = numbers(shown.expect("a color"));
    assert_eq!(shown.len(), 3, "{plain}");
    let said = sh(&after(&plain, "to reproduce it:"));
    assert_eq!(numbers(said.lines().nth(1).expect("a color")), shown);

    let calls = after(&report(&["--language", "python"]), "in Python:");
    fs::write(
        path("calls.py"),
        format!("import json\nfrom renderer import shade\n{calls}"),
    )
    .expect("a file");
    assert_eq!(numbers(&sh("python3 calls.py")), shown);

    let c = include_str!("../../examples/renderer.c").replace("mul(s.k_a, s.i_a)", "s.k_a");
    let calls = after(&report(&["--language", "c"]), "in C:");
    let c = c.replace("int main(", "int renderer(") + "int main(void) {\n" + &calls + "}\n";
    fs::write(path("calls.c"), c).expect("a file");
    assert_eq!(numbers(&sh("cc calls.c -o calls -lm && ./calls")), shown);

    let rust = include_str!("../../examples/renderer.rs");
    let rust = rust.replace("mul(k_a, triple(numbers))", "(k_a, triple(numbers)).0");
    let calls = after(&report(&["--language", "rust"]), "in Rust:");
    let rust = rust.replace("fn main(", "fn renderer(") + "fn main() {\n" + &calls + "}\n";
    fs::write(path("calls.rs"), rust).expect("a file");
    assert_eq!(
        numbers(&sh("rustc --edition 2021 calls.rs 2>/dev/null && ./calls")),
        shown
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
