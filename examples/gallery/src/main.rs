//! A gallery of the crate: each formula at work on spheres, implicit surfaces, the Utah teapot, and
//! the Stanford bunny.
//!
//! ```text
//! cargo run --release -p gallery
//! ```
//!
//! Start with `scenes`, which describes the pictures; `render` is a small ray tracer.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss,
    reason = "pixels are counted with integers and placed with floating-point numbers"
)]

mod arguments;
mod model;
mod render;
mod scenes;

use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;
use std::{env, fs};

use arguments::{Command, Request, Subject};
use indicatif::{ProgressBar, ProgressStyle};
use model::Model;
use render::film::Film;
use render::{label, png};

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("gallery: {message}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), String> {
    match arguments::parse(env::args_os().skip(1)) {
        Ok(Command::Help) => say(arguments::HELP.trim_end()),
        Ok(Command::Draw(request)) => draw(request),
        Err(error) => Err(format!("{error}; --help shows the options")),
    }
}

fn draw(request: Request) -> Result<(), String> {
    let (mut pictures, default) = match &request.subject {
        Subject::Gallery => (scenes::all(), "target/gallery"),
        Subject::Readme => (scenes::of_readme(), "docs/pictures"),
        Subject::Model(path) => (scenes::model(&Model::read(path)?), "target/gallery"),
    };
    if let Some(only) = &request.only {
        pictures.retain(|picture| picture.name.contains(only.as_str()));
        if pictures.is_empty() {
            return Err(format!("no picture has a name that contains {only}"));
        }
    }
    let folder = request.folder.unwrap_or_else(|| in_the_workspace(default));
    fs::create_dir_all(&folder)
        .map_err(|error| format!("cannot create the folder {}: {error}", folder.display()))?;

    // hidden if standard error is not a terminal
    let style = ProgressStyle::with_template("{bar:30} {pos}/{len} {msg}");
    let bar = ProgressBar::new(pictures.len() as u64)
        .with_style(style.map_err(|error| error.to_string())?);
    for picture in pictures {
        bar.set_message(picture.name);
        let start = Instant::now();
        let (width, height) = picture.size(request.size);
        let mut film = Film::of(&*picture.view, width, height);
        label::write(&mut film, picture.labels);
        let path = folder.join(format!("{}.png", picture.name));
        png::write(&film, &path)
            .map_err(|error| format!("cannot write {}: {error}", path.display()))?;
        let seconds = start.elapsed().as_secs_f32();
        bar.suspend(|| say(&format!("{}  {seconds:.1} s", path.display())))?;
        bar.inc(1);
    }
    bar.finish_and_clear();
    Ok(())
}

/// A folder of the workspace, relative to the current directory if possible.
fn in_the_workspace(folder: &str) -> PathBuf {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2);
    let folder = root.unwrap_or(Path::new("")).join(folder);
    env::current_dir()
        .ok()
        .and_then(|here| Some(folder.strip_prefix(here).ok()?.to_path_buf()))
        .unwrap_or(folder)
}

/// Like `println`, but a closed pipe is an error, not a panic.
fn say(line: &str) -> Result<(), String> {
    writeln!(io::stdout(), "{line}")
        .map_err(|error| format!("cannot write to standard output: {error}"))
}
