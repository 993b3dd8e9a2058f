//! A gallery of the crate: each formula at work, on spheres, implicit surfaces, the Utah teapot and
//! the Stanford bunny.
//!
//! ```text
//! cargo run --release -p gallery
//! ```
//!
//! `scenes` says what is drawn and is the place to start; `render` is a small ray tracer.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss,
    reason = "pixels are counted with whole numbers and placed with floating-point ones"
)]

mod arguments;
mod model;
mod render;
mod scenes;

use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::{env, fs};

use arguments::{Command, Subject};
use model::Model;
use render::film::Film;
use render::png;

const WIDTH: usize = 800;
const HEIGHT: usize = 600;
/// How many times smaller the pictures of the README are.
const THUMBNAIL: usize = 2;

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
        Ok(Command::Draw(subject, folder)) => draw(&subject, folder),
        Err(error) => Err(format!("{error}; --help shows what can be asked for")),
    }
}

fn draw(subject: &Subject, folder: Option<PathBuf>) -> Result<(), String> {
    let (pictures, default, smaller) = match subject {
        Subject::Gallery => (scenes::all(), "target/gallery", 1),
        Subject::Thumbnails => (scenes::of_readme(), "docs/pictures", THUMBNAIL),
        Subject::Model(path) => (scenes::model(&Model::read(path)?), "target/gallery", 1),
    };
    let folder = folder.unwrap_or_else(|| in_the_workspace(default));
    fs::create_dir_all(&folder)
        .map_err(|error| format!("cannot make the folder {}: {error}", folder.display()))?;
    for picture in pictures {
        let film = Film::of(&*picture.view, WIDTH, HEIGHT).reduced(smaller);
        let path = folder.join(format!("{}.png", picture.name));
        png::write(&film, &path)
            .map_err(|error| format!("cannot write {}: {error}", path.display()))?;
        say(&path.display().to_string())?;
    }
    Ok(())
}

/// A folder of the workspace, as seen from here.
fn in_the_workspace(folder: &str) -> PathBuf {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2);
    let folder = root.unwrap_or(Path::new("")).join(folder);
    env::current_dir()
        .ok()
        .and_then(|here| Some(folder.strip_prefix(here).ok()?.to_path_buf()))
        .unwrap_or(folder)
}

/// Like `println`, but a reader that has gone away is an error and not a panic.
fn say(line: &str) -> Result<(), String> {
    writeln!(io::stdout(), "{line}")
        .map_err(|error| format!("cannot write to standard output: {error}"))
}
