//! The command line.

use std::ffi::OsString;
use std::path::PathBuf;

use lexopt::prelude::{Long, Short, Value};

pub const HELP: &str = "\
Draws the gallery of the crate `shading`: pictures that show each formula at work.

Usage: cargo run --release -p gallery -- [OPTIONS] [FOLDER]

  FOLDER               where the pictures go; without it, target/gallery of the crate

Options:
  --model FILE.obj     draw a model of your own instead, flat and smooth
  --thumbnails         draw the pictures of the README instead, half as large; without
                       FOLDER, into docs/pictures of the crate
  -h, --help           show this
";

pub enum Command {
    Help,
    /// What is drawn, and the folder into which it goes, where one is given.
    Draw(Subject, Option<PathBuf>),
}

pub enum Subject {
    Gallery,
    /// Those pictures of the gallery that the README shows, small.
    Thumbnails,
    Model(PathBuf),
}

pub fn parse(arguments: impl IntoIterator<Item = OsString>) -> Result<Command, lexopt::Error> {
    let mut parser = lexopt::Parser::from_args(arguments);
    let (mut subject, mut folder) = (Subject::Gallery, None);
    while let Some(argument) = parser.next()? {
        match argument {
            Short('h') | Long("help") => return Ok(Command::Help),
            Long("model") => subject = Subject::Model(parser.value()?.into()),
            Long("thumbnails") => subject = Subject::Thumbnails,
            Value(path) if folder.is_none() => folder = Some(path.into()),
            _ => return Err(argument.unexpected()),
        }
    }
    Ok(Command::Draw(subject, folder))
}
