//! The command line.

use std::ffi::OsString;
use std::path::PathBuf;

use lexopt::prelude::{Long, Short, Value};

pub const HELP: &str = "\
Draws the gallery of the crate `shading`: pictures that show each formula at work.

Usage: cargo run --release --example gallery -- [OPTIONS] [FOLDER]

  FOLDER               where the pictures go; without it, target/gallery of the crate

Options:
  --model FILE.obj     draw a model of your own instead, flat and smooth
  --thumbnails         draw the pictures of the README (docs/pictures) instead, small
  -h, --help           show this
";

pub enum Command {
    Help,
    Draw(Order),
}

/// What is drawn, and where it goes.
#[derive(Default)]
pub struct Order {
    pub folder: Option<PathBuf>,
    pub model: Option<PathBuf>,
    pub thumbnails: bool,
}

pub fn parse(arguments: impl IntoIterator<Item = OsString>) -> Result<Command, lexopt::Error> {
    let mut parser = lexopt::Parser::from_args(arguments);
    let mut order = Order::default();
    while let Some(argument) = parser.next()? {
        match argument {
            Short('h') | Long("help") => return Ok(Command::Help),
            Long("model") => order.model = Some(parser.value()?.into()),
            Long("thumbnails") => order.thumbnails = true,
            Value(folder) if order.folder.is_none() => order.folder = Some(folder.into()),
            _ => return Err(argument.unexpected()),
        }
    }
    Ok(Command::Draw(order))
}
