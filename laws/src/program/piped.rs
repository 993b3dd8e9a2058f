//! A renderer at the other end of two pipes, to which lines are written and from which lines are read, neither forever.

use std::ffi::OsString;
use std::io::{self, BufRead, BufReader, Read, Write};
use std::process::{Child, ChildStdin, ChildStdout, Command, ExitStatus, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, SyncSender, channel, sync_channel};
use std::thread;
use std::time::{Duration, Instant};

use shading_laws::{Profile, Renderer, Scene, Triple};

/// What the program says first.
const VERSION: &str = r#"{"shading-laws":1}"#;

/// The longest line that is read, so that an endless one does not fill the memory.
const LONGEST: u64 = 65_536;

/// How long a process may take to end, on a machine that is busy, too.
const GRACE: Duration = Duration::from_secs(5);

/// A program that speaks the format. Two threads write and read, because a process that waits for its output to be read
/// does not read its input.
pub struct Piped {
    command: Vec<OsString>,
    child: Child,
    /// It has ended, and is started again when more is asked.
    is_over: bool,
    input: Option<Sender<String>>,
    lines: Receiver<Vec<u8>>,
    profile: Profile,
    timeout: Duration,
    scenes: usize,
    batches: usize,
    /// Its last line was no text.
    unreadable: bool,
}

impl Piped {
    /// Starts the program, and asks what it is.
    pub fn start(command: &[OsString], timeout: Duration) -> Result<Self, String> {
        let (program, arguments) = command.split_first().ok_or("there is no command")?;
        let mut to_start = Command::new(program);
        to_start.args(arguments);
        to_start.stdin(Stdio::piped()).stdout(Stdio::piped());
        let mut child = to_start.spawn().map_err(|error| {
            let name = program.to_string_lossy();
            let hint = match error.kind() {
                io::ErrorKind::NotFound if std::path::Path::new(program).exists() => {
                    format!("; to start the file in this folder, write ./{name}")
                }
                io::ErrorKind::PermissionDenied => "; is it executable?".into(),
                _ => String::new(),
            };
            format!("cannot start {name}: {error}{hint}")
        })?;
        let (input, to_write) = channel();
        let (read, lines) = sync_channel(1024);
        if let Some(stdin) = child.stdin.take() {
            thread::spawn(move || write(stdin, &to_write));
        }
        if let Some(stdout) = child.stdout.take() {
            thread::spawn(move || read_lines(stdout, &read));
        }
        let mut piped = Self {
            command: command.to_vec(),
            child,
            is_over: false,
            input: Some(input),
            lines,
            profile: Profile::default(),
            timeout,
            scenes: 0,
            batches: 0,
            unreadable: false,
        };
        let name: Vec<_> = command.iter().map(|word| word.to_string_lossy()).collect();
        let profile = piped.introduced(&name.join(" "));
        piped.profile = profile.map_err(|why| format!("in answer to {VERSION}: {why}"))?;
        Ok(piped)
    }

    fn introduced(&mut self, command: &str) -> Result<Profile, String> {
        self.write(format!("{VERSION}\n"));
        let line = self.line(self.timeout)?.ok_or_else(|| {
            format!(
                "no line within {:?}; does it flush its output?",
                self.timeout
            )
        })?;
        let mut profile =
            Profile::from_json(&line).map_err(|why| format!("{why}, in {}", quoted(&line)))?;
        if profile.name == Profile::default().name {
            command.clone_into(&mut profile.name);
        }
        Ok(profile)
    }

    /// Closes the renderer's input, and sees to it that it ends.
    ///
    /// # Errors
    ///
    /// It has more lines to say, or it ends with another status than 0.
    pub fn finish(mut self) -> Result<(), String> {
        self.input = None;
        self.nothing_more(self.timeout.min(Duration::from_secs(2)))?;
        match self.status_within(GRACE) {
            Some(status) if !status.success() => {
                Err(format!("after its last color it ended ({status})"))
            }
            _ => Ok(()),
        }
    }

    fn nothing_more(&mut self, patience: Duration) -> Result<(), String> {
        // an end is told by whoever asks next
        let line = match self.line(patience) {
            Ok(Some(line)) => quoted(&line),
            Err(why) if self.unreadable => why,
            Ok(None) | Err(_) => return Ok(()),
        };
        Err(format!(
            "after the answer to scene {}, the last of a batch, it wrote another line: {line}; the \
             empty line has no answer",
            self.scenes
        ))
    }

    fn answer(&mut self, left: usize) -> Result<Triple, String> {
        let line = self.line(self.timeout)?.ok_or_else(|| {
            let scenes = if left == 1 { "scene" } else { "scenes" };
            format!(
                "no answer within {:?}, and {left} {scenes} of the batch left; it must answer each \
                 scene and flush its output at the empty line",
                self.timeout
            )
        })?;
        color(&line)
    }

    /// Writes a text, without waiting until it is read. That the process no longer reads becomes
    /// known when it gives no line.
    fn write(&self, text: String) {
        if let Some(input) = &self.input {
            let _ = input.send(text);
        }
    }

    /// The next line that it writes, without its end; nothing if none came in time.
    fn line(&mut self, patience: Duration) -> Result<Option<String>, String> {
        let mut line = match self.lines.recv_timeout(patience) {
            Ok(line) => line,
            Err(RecvTimeoutError::Timeout) => return Ok(None),
            Err(RecvTimeoutError::Disconnected) => return Err(self.end()),
        };
        let is_whole = line.last() == Some(&b'\n');
        line.truncate(line.len() - usize::from(is_whole));
        let text = String::from_utf8_lossy(&line);
        let is_text = matches!(text, std::borrow::Cow::Borrowed(_));
        if is_whole && is_text {
            return Ok(Some(text.into_owned()));
        }
        self.unreadable = true;
        let start = quoted(&text);
        Err(if is_whole {
            format!("{start} is not UTF-8")
        } else if line.len() as u64 > LONGEST {
            format!("the line {start} is longer than {LONGEST} bytes")
        } else {
            format!("{} in the middle of the line {start}", self.end())
        })
    }

    /// How it ended, after it has closed its output.
    fn end(&mut self) -> String {
        self.is_over = true;
        match self.status_within(GRACE) {
            Some(status) => format!("it ended ({status})"),
            None => "it closed its output".into(),
        }
    }

    /// How it ended, if it ends soon.
    fn status_within(&mut self, patience: Duration) -> Option<ExitStatus> {
        let begin = Instant::now();
        loop {
            if let Ok(Some(status)) = self.child.try_wait() {
                return Some(status);
            }
            if begin.elapsed() >= patience {
                return None;
            }
            thread::sleep(Duration::from_millis(5));
        }
    }
}

impl Renderer for Piped {
    fn profile(&self) -> Profile {
        self.profile.clone()
    }

    fn shade(&mut self, scenes: &[Scene]) -> Result<Vec<Triple>, String> {
        if scenes.is_empty() {
            return Ok(vec![]);
        }
        if self.is_over {
            *self = Self::start(&self.command, self.timeout)?;
        }
        // a line too many comes at once, if it comes; a moment after the first batches shows it
        let patience = Duration::from_millis(if self.batches < 3 { 50 } else { 0 });
        if self.batches > 0 {
            self.nothing_more(patience)?;
        }
        self.batches += 1;

        let lines: Vec<String> = scenes.iter().map(Scene::to_json).collect();
        self.write(lines.join("\n") + "\n\n");
        let mut colors = Vec::with_capacity(scenes.len());
        for (i, line) in lines.iter().enumerate() {
            self.scenes += 1;
            let color = self.answer(scenes.len() - i);
            colors.push(
                color.map_err(|why| format!("scene {}: {why}; the scene: {line}", self.scenes))?,
            );
        }
        Ok(colors)
    }
}

impl Drop for Piped {
    fn drop(&mut self) {
        self.input = None; // it ends by itself, or is killed
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

fn write(mut stdin: ChildStdin, texts: &Receiver<String>) {
    for text in texts {
        if stdin.write_all(text.as_bytes()).is_err() {
            return;
        }
    }
}

/// Hands on each line, with its end, and the beginning of one that is too long or has no end.
fn read_lines(stdout: ChildStdout, lines: &SyncSender<Vec<u8>>) {
    let mut stdout = BufReader::new(stdout);
    loop {
        let mut line = Vec::new();
        let mut limited = stdout.by_ref().take(LONGEST + 1);
        let read = limited.read_until(b'\n', &mut line);
        let is_whole = line.last() == Some(&b'\n');
        if read.is_err() || line.is_empty() || lines.send(line).is_err() || !is_whole {
            return;
        }
    }
}

/// A color; also with the numbers that JSON lacks.
pub fn color(line: &str) -> Result<Triple, String> {
    let list = line.trim();
    let list = list
        .strip_prefix('[')
        .and_then(|list| list.strip_suffix(']'));
    let list = list.ok_or_else(|| format!("expected [red,green,blue], found {}", quoted(line)))?;
    let numbers = list.split(',').map(|text| component(text.trim()));
    let numbers: Result<Vec<f64>, _> = numbers.collect();
    let numbers = numbers.map_err(|why| format!("{why} in {}", quoted(line)))?;
    let count = numbers.len();
    Triple::try_from(numbers)
        .map_err(|_| format!("expected 3 numbers, found {count} in {}", quoted(line)))
}

fn component(text: &str) -> Result<f64, String> {
    text.parse().map_err(|_| match text {
        "" => "a number is missing".to_owned(),
        "null" => "null is no number; JavaScript writes it for NaN and Infinity".to_owned(),
        _ => format!("{} is no number", quoted(text)),
    })
}

/// The beginning of a text, in quotation marks and with its control characters escaped.
pub fn quoted(text: &str) -> String {
    const MOST: usize = 80;
    match text.char_indices().nth(MOST) {
        Some((end, _)) => format!("{:?}…", &text[..end]),
        None => format!("{text:?}"),
    }
}
