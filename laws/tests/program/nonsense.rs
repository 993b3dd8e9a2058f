//! Commands that start nothing, and renderers that do not speak the format.

use std::fs;
use std::path::Path;
use std::process::Command;
use std::thread;

use crate::{FOLDER, PYTHON, in_the_dark, program, python, run};

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

#[test]
fn a_wrong_command_is_refused() {
    fs::write(Path::new(FOLDER).join("not_executable"), "").expect("a file");
    for (command, part) in [
        ("./no_such_renderer", "No such file"),
        ("not_executable", "do you mean ./?"),
        ("./not_executable", "is it executable"),
    ] {
        refused(program().arg(command).current_dir(FOLDER), &[part]);
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
        ("say('[1.x,0,0]')", "\"1.x\" is no number"),
        ("say('[,0,0]')", "\"\" is no number"),
        ("say('[\"\",0,0]')", "is no number"),
        ("say('null')", "expected [red,green,blue], found \"null\""),
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
    // so that nothing else is found before
    for (_, script, _) in &mut all {
        *script = in_the_dark(script);
    }
    // those that take five seconds take them together
    let is_late = |parts: &[&str]| parts.iter().any(|part| part.contains("within 5s"));
    all.sort_by_key(|(.., parts)| is_late(parts));
    for some in all.chunks(4) {
        thread::scope(|scope| {
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
