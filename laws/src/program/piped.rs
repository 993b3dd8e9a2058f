//! A renderer at the other end of two pipes.

use std::ffi::OsString;
use std::time::Duration;

use shading_laws::{Profile, Renderer, Scene, Triple};

use super::format;
use super::process::{NoLine, Process};

/// A program that speaks the format.
pub struct Piped {
    process: Process,
    profile: Profile,
    timeout: Duration,
    scenes: usize,
    batches: usize,
}

impl Piped {
    /// Starts the program, and asks what it is.
    pub fn start(command: &[OsString], timeout: Duration) -> Result<Self, String> {
        let mut process = Process::start(command)?;
        process.write(format!("{}\n", format::VERSION));
        let name: Vec<_> = command.iter().map(|word| word.to_string_lossy()).collect();
        let profile = match process.line(timeout) {
            Ok(line) => format::profile(&line, &name.join(" ")),
            Err(NoLine::Unreadable(why) | NoLine::Over(why)) => Err(why),
            Err(NoLine::Late) => Err(format!(
                "no line within {timeout:?}; does it flush its output?"
            )),
        };
        let profile = profile.map_err(|why| format!("in answer to {}: {why}", format::VERSION))?;
        Ok(Self {
            process,
            profile,
            timeout,
            scenes: 0,
            batches: 0,
        })
    }

    /// Closes the renderer's input, and sees to it that it ends.
    ///
    /// # Errors
    ///
    /// It has more lines to say, or it ends with another status than 0.
    pub fn finish(mut self) -> Result<(), String> {
        self.process.close();
        self.nothing_more(self.timeout.min(Duration::from_secs(2)))?;
        match self.process.status() {
            Some(status) if !status.success() => {
                Err(format!("after its last color it ended ({status})"))
            }
            _ => Ok(()),
        }
    }

    fn nothing_more(&mut self, patience: Duration) -> Result<(), String> {
        let line = match self.process.line(patience) {
            Ok(line) => format::quoted(&line),
            Err(NoLine::Unreadable(why)) => why,
            Err(NoLine::Late | NoLine::Over(_)) => return Ok(()),
        };
        Err(format!(
            "after the answer to scene {}, the last of a batch, it wrote another line: {line}; the \
             empty line has no answer",
            self.scenes
        ))
    }

    fn answer(&mut self, left: usize) -> Result<Triple, String> {
        match self.process.line(self.timeout) {
            Ok(line) => format::color(&line),
            Err(NoLine::Unreadable(why) | NoLine::Over(why)) => Err(why),
            Err(NoLine::Late) => Err(format!(
                "no answer within {:?}, and {left} {} of the batch left; it must answer each \
                 scene and flush its output at the empty line",
                self.timeout,
                if left == 1 { "scene" } else { "scenes" }
            )),
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
        // a line too many comes at once, if it comes; a moment after the first batches shows it
        let patience = Duration::from_millis(if self.batches < 3 { 50 } else { 0 });
        if self.batches > 0 {
            self.nothing_more(patience)?;
        }
        self.batches += 1;

        let lines: Vec<String> = scenes.iter().map(Scene::to_json).collect();
        self.process.write(lines.join("\n") + "\n\n");
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
