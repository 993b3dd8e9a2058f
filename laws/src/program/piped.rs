//! A renderer at the other end of two pipes, for which nobody waits forever.

use std::ffi::OsString;
use std::io::{self, BufRead, BufReader, Read, Write};
use std::process::{Child, ChildStdin, ChildStdout, Command, ExitStatus, Stdio};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, SyncSender, channel, sync_channel};
use std::thread;
use std::time::{Duration, Instant};

use shading_laws::{Profile, Progress, Renderer, Scene, Triple};

use crate::color::{color, quoted};

/// What the program says first.
const VERSION: &str = r#"{"shading-laws":1}"#;

/// The longest line that is read, so that an endless one does not fill the memory.
const LONGEST: u64 = 65_536;

/// How long a process may take to end, on a machine that is busy, too.
const GRACE: Duration = Duration::from_secs(5);

/// How often a run that takes long says how far it is.
const TOLD: Duration = Duration::from_secs(3);

/// How often a wait looks for Ctrl-C.
const LOOK: Duration = Duration::from_millis(100);

/// Whether Ctrl-C was pressed.
static IS_INTERRUPTED: AtomicBool = AtomicBool::new(false);

/// A program that speaks the format. Two threads write and read, because a process that waits for
/// its output to be read does not read its input.
pub struct Piped {
    command: Vec<OsString>,
    child: Child,
    /// It has ended, and is started again when more is asked.
    is_over: bool,
    input: Option<Sender<String>>,
    lines: Receiver<Vec<u8>>,
    profile: Profile,
    timeout: Duration,
    /// The number of scenes that it was asked for since it was started.
    scenes: usize,
    progress: Option<Progress>,
    start: Instant,
    told: Instant,
}

impl Piped {
    /// Starts the program, and asks what it is.
    pub fn start(command: &[OsString], timeout: Duration) -> Result<Self, String> {
        let (program, arguments) = command.split_first().ok_or("there is no command")?;
        let mut to_start = Command::new(program);
        to_start.args(arguments);
        to_start.stdin(Stdio::piped()).stdout(Stdio::piped());
        // in a group of its own, it does not end at Ctrl-C, and what was found is told
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(&mut to_start, 0);
        let mut child = to_start.spawn().map_err(|error| {
            let name = program.to_string_lossy();
            let is_here = std::path::Path::new(program).is_file();
            let hint = "; is it executable, and do you mean ./?";
            let hint = if is_here { hint } else { "" };
            format!("cannot start {name}: {error}{hint}")
        })?;
        let (input, to_write) = channel::<String>();
        let (read, lines) = sync_channel(1024);
        let (stdin, stdout) = (child.stdin.take(), child.stdout.take());
        thread::spawn(move || write(stdin?, &to_write));
        thread::spawn(move || read_lines(stdout?, &read));
        let mut piped = Self {
            command: command.to_vec(),
            child,
            is_over: false,
            input: Some(input),
            lines,
            profile: Profile::default(),
            timeout,
            scenes: 0,
            progress: None,
            start: Instant::now(),
            told: Instant::now(),
        };
        piped.write(format!("{VERSION}\n"));
        let late = format!("no line within {timeout:?}; does it flush its output?");
        let profile = piped.line(timeout).and_then(|line| {
            let line = line.ok_or(late)?;
            Profile::from_json(&line).map_err(|why| format!("{why}, in {}", quoted(&line)))
        });
        piped.profile = profile.map_err(|why| format!("in answer to {VERSION}: {why}"))?;
        if piped.profile.name == Profile::default().name {
            let words: Vec<_> = command.iter().map(|word| word.to_string_lossy()).collect();
            piped.profile.name = words.join(" ");
        }
        Ok(piped)
    }

    /// Closes the renderer's input, and sees to it that it ends, without more lines to say and with status 0.
    pub fn finish(mut self) -> Result<(), String> {
        self.input = None;
        self.nothing_more(self.timeout.min(Duration::from_secs(2)))?;
        match self.status() {
            Some(status) if !status.success() => {
                Err(format!("after its last color it ended ({status})"))
            }
            _ => Ok(()),
        }
    }

    fn nothing_more(&mut self, patience: Duration) -> Result<(), String> {
        let line = match self.line(patience) {
            Ok(Some(line)) => quoted(&line),
            Err(why) if !self.is_over => why,
            Ok(None) | Err(_) => return Ok(()), // an end is told by whoever asks next
        };
        Err(format!(
            "after the answer to scene {}, the last of a batch, it wrote another line: {line}; the \
             empty line has no answer",
            self.scenes
        ))
    }

    /// Writes a text, without waiting until it is read. A process that no longer reads gives no line.
    fn write(&self, text: String) {
        if let Some(input) = &self.input {
            let _ = input.send(text);
        }
    }

    /// The next line that it writes, without its end; nothing if none came in time.
    fn line(&mut self, patience: Duration) -> Result<Option<String>, String> {
        let end = Instant::now() + patience;
        let line = loop {
            let left = end.saturating_duration_since(Instant::now());
            match self.lines.recv_timeout(left.min(LOOK)) {
                Ok(line) => break line,
                Err(RecvTimeoutError::Disconnected) => return Err(self.end()),
                Err(RecvTimeoutError::Timeout) if IS_INTERRUPTED.load(Ordering::Relaxed) => {
                    return Err("interrupted".into());
                }
                Err(RecvTimeoutError::Timeout) if left <= LOOK => return Ok(None),
                Err(RecvTimeoutError::Timeout) => self.tell(),
            }
        };
        let text = String::from_utf8_lossy(&line);
        let start = quoted(text.trim_end_matches('\n'));
        let is_text = std::str::from_utf8(&line).is_ok();
        match text.strip_suffix('\n') {
            Some(whole) if is_text => Ok(Some(whole.into())),
            Some(_) => Err(format!("{start} is not UTF-8")),
            None if line.len() as u64 > LONGEST => {
                Err(format!("the line {start} is longer than {LONGEST} bytes"))
            }
            None => Err(format!("{} in the middle of the line {start}", self.end())),
        }
    }

    /// Says how far a run is that takes long.
    fn tell(&mut self) {
        let Some(Progress { asked, of, broken }) = self.progress else {
            return;
        };
        if self.told.elapsed() < TOLD {
            return;
        }
        self.told = Instant::now();
        let seconds = self.start.elapsed().as_secs();
        let done = asked.min(of);
        let line = format!("{done} of {of} scenes after {seconds} s; broken laws: {broken}");
        let _ = writeln!(io::stderr(), "shading-laws: {line}");
    }

    /// How it ended, after it has closed its output.
    fn end(&mut self) -> String {
        self.is_over = true;
        match self.status() {
            Some(status) => format!("it ended ({status})"),
            None => "it closed its output".into(),
        }
    }

    /// How it ended, if it ends soon.
    fn status(&mut self) -> Option<ExitStatus> {
        let begin = Instant::now();
        while begin.elapsed() < GRACE {
            if let Ok(Some(status)) = self.child.try_wait() {
                return Some(status);
            }
            thread::sleep(Duration::from_millis(5));
        }
        None
    }
}

impl Renderer for Piped {
    fn profile(&self) -> Profile {
        self.profile.clone()
    }

    fn shade(&mut self, scenes: &[Scene]) -> Result<Vec<Triple>, String> {
        if self.is_over {
            self.begin_again()?;
        }
        // a line too many comes at once, if it comes; a moment after the first batches of fifty scenes shows it
        let patience = Duration::from_millis(if self.scenes < 50 { 50 } else { 0 });
        if self.scenes > 0 {
            self.nothing_more(patience)?;
        }

        let lines: Vec<String> = scenes.iter().map(Scene::to_json).collect();
        self.write(lines.join("\n") + "\n\n");
        let mut colors = Vec::with_capacity(scenes.len());
        for (i, line) in lines.iter().enumerate() {
            self.scenes += 1;
            let (left, patience) = (scenes.len() - i, self.timeout);
            let answer = self.line(patience).and_then(|line| {
                line.ok_or_else(|| format!(
                    "no answer within {patience:?}, and {left} of the batch left; it must answer each \
                     scene and flush its output at the empty line"
                ))
            });
            let color = answer.and_then(|answer| color(&answer));
            let number = self.scenes;
            colors.push(color.map_err(|why| format!("scene {number}: {why}; the scene: {line}"))?);
            if IS_INTERRUPTED.load(Ordering::Relaxed) {
                return Err("interrupted".into());
            }
            if let Some(progress) = &mut self.progress {
                progress.asked += 1;
            }
            self.tell();
        }
        Ok(colors)
    }

    fn begin_again(&mut self) -> Result<bool, String> {
        let (progress, start) = (self.progress, self.start);
        *self = Self::start(&self.command, self.timeout)?;
        (self.progress, self.start) = (progress, start);
        Ok(true)
    }

    fn goes_on(&mut self, progress: &Progress) -> bool {
        self.progress = Some(*progress);
        self.tell();
        !IS_INTERRUPTED.load(Ordering::Relaxed)
    }
}

/// Lets Ctrl-C end the run, and a second one the program.
pub fn listen_to_interrupts() {
    let listen = || {
        if IS_INTERRUPTED.swap(true, Ordering::Relaxed) {
            std::process::exit(130);
        }
    };
    let _ = ctrlc::set_handler(listen); // without it, Ctrl-C ends the program
}

impl Drop for Piped {
    fn drop(&mut self) {
        self.input = None; // it ends by itself, or is killed
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

fn write(mut stdin: ChildStdin, texts: &Receiver<String>) -> Option<()> {
    let mut texts = texts.iter();
    texts.try_for_each(|text| stdin.write_all(text.as_bytes()).ok())
}

/// Hands on each line, with its end, and the beginning of one that is too long or has no end.
fn read_lines(stdout: ChildStdout, lines: &SyncSender<Vec<u8>>) -> Option<()> {
    let mut stdout = BufReader::new(stdout);
    loop {
        let mut line = Vec::new();
        let mut limited = stdout.by_ref().take(LONGEST + 1);
        limited.read_until(b'\n', &mut line).ok()?;
        let is_whole = line.last()? == &b'\n';
        lines.send(line).ok().filter(|()| is_whole)?;
    }
}
