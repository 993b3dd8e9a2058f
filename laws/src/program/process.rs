//! Another process, to which lines are written and from which lines are read, neither forever.

use std::ffi::OsString;
use std::io::{self, BufRead, BufReader, Read, Write};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::sync::Mutex;
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, SyncSender, channel, sync_channel};
use std::thread;
use std::time::{Duration, Instant};

/// The longest line that is read, so that an endless one does not fill the memory.
const LONGEST: u64 = 65_536;

/// How long a process may take to end, on a machine that is busy, too.
const GRACE: Duration = Duration::from_secs(5);

/// The process to kill at an interrupt. It is locked while one starts, so that none escapes.
static STARTED: Mutex<Option<u32>> = Mutex::new(None);

/// Kills the process, if one was started, and ends the program.
pub fn interrupt(status: u8) -> ! {
    let started = STARTED.lock();
    if let Ok(Some(id)) = started.as_deref() {
        kill_group(*id);
    }
    std::process::exit(status.into()) // still locked
}

/// A process and the two ends of its pipes. Two threads write and read, because a process that
/// waits for its output to be read does not read its input. Dropping it kills the process.
pub struct Process {
    child: Child,
    ended: bool,
    input: Option<Sender<String>>,
    lines: Receiver<Line>,
}

enum Line {
    Whole(Vec<u8>),
    /// Of a line that is too long, or of the last line if it has no end.
    Beginning(Vec<u8>),
}

/// Why there is no line.
pub enum NoLine {
    /// None came in time.
    Late,
    /// There is one, but not as text. Says why not.
    Unreadable(String),
    /// There never will be one. Says why not.
    Over(String),
}

impl Process {
    pub fn start(command: &[OsString]) -> Result<Self, String> {
        let (program, arguments) = command.split_first().ok_or("there is no command")?;
        let mut command = Command::new(program);
        command
            .args(arguments)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped());
        // a group of its own, so that what it starts can be killed with it
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(&mut command, 0);
        let mut started = STARTED.lock().map_err(|error| error.to_string())?;
        let mut child = command.spawn().map_err(|error| {
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
        *started = Some(child.id());
        let (input, to_write) = channel();
        let (read, lines) = sync_channel(1024);
        if let Some(stdin) = child.stdin.take() {
            thread::spawn(move || write(stdin, &to_write));
        }
        if let Some(stdout) = child.stdout.take() {
            thread::spawn(move || read_lines(stdout, &read));
        }
        Ok(Self {
            child,
            ended: false,
            input: Some(input),
            lines,
        })
    }

    /// Writes a text, without waiting until it is read. That the process no longer reads becomes
    /// known when it gives no line.
    pub fn write(&self, text: String) {
        if let Some(input) = &self.input {
            let _ = input.send(text);
        }
    }

    /// Closes the input of the process.
    pub fn close(&mut self) {
        self.input = None;
    }

    /// The next line that it writes, without its end.
    pub fn line(&mut self, patience: Duration) -> Result<String, NoLine> {
        match self.lines.recv_timeout(patience) {
            Ok(Line::Whole(line)) => String::from_utf8(line).map_err(|error| {
                let line = String::from_utf8_lossy(error.as_bytes());
                NoLine::Unreadable(format!("{} is not UTF-8", super::format::quoted(&line)))
            }),
            Ok(Line::Beginning(line)) => {
                let quoted = super::format::quoted(&String::from_utf8_lossy(&line));
                Err(NoLine::Unreadable(if line.len() as u64 > LONGEST {
                    format!("the line {quoted} is longer than {LONGEST} bytes")
                } else {
                    format!("{} in the middle of the line {quoted}", self.end())
                }))
            }
            Err(RecvTimeoutError::Timeout) => Err(NoLine::Late),
            Err(RecvTimeoutError::Disconnected) => Err(NoLine::Over(self.end())),
        }
    }

    /// How it ended, after it has closed its output.
    fn end(&mut self) -> String {
        match self.status_within(GRACE) {
            Some(status) => format!("it ended ({status})"),
            None => "it closed its output".into(),
        }
    }

    /// How it ended, if it ends soon.
    pub fn status(&mut self) -> Option<std::process::ExitStatus> {
        self.status_within(GRACE)
    }

    fn status_within(&mut self, patience: Duration) -> Option<std::process::ExitStatus> {
        let begin = Instant::now();
        loop {
            if let Ok(Some(status)) = self.child.try_wait() {
                self.ended = true;
                return Some(status);
            }
            if begin.elapsed() >= patience {
                return None;
            }
            thread::sleep(Duration::from_millis(5));
        }
    }
}

impl Drop for Process {
    fn drop(&mut self) {
        self.close();
        if !self.ended {
            kill_group(self.child.id());
            let _ = self.child.kill();
            let _ = self.child.wait();
        }
    }
}

#[cfg(unix)]
fn kill_group(id: u32) {
    use nix::sys::signal::{Signal, killpg};
    use nix::unistd::Pid;

    if let Ok(id) = id.try_into() {
        let _ = killpg(Pid::from_raw(id), Signal::SIGKILL);
    }
}

#[cfg(not(unix))]
fn kill_group(_id: u32) {}

fn write(mut stdin: ChildStdin, texts: &Receiver<String>) {
    for text in texts {
        if stdin.write_all(text.as_bytes()).is_err() {
            return;
        }
    }
}

fn read_lines(stdout: ChildStdout, lines: &SyncSender<Line>) {
    let mut stdout = BufReader::new(stdout);
    loop {
        let mut line = Vec::new();
        let read = stdout
            .by_ref()
            .take(LONGEST + 1)
            .read_until(b'\n', &mut line);
        if read.is_err() || line.is_empty() {
            return;
        }
        let is_whole = line.last() == Some(&b'\n');
        if is_whole {
            line.pop();
        }
        let line = if is_whole {
            Line::Whole
        } else {
            Line::Beginning
        }(line);
        if lines.send(line).is_err() || !is_whole {
            return;
        }
    }
}
