//! The command line.

use std::ffi::OsString;
use std::path::PathBuf;

use lexopt::prelude::{Long, Short, Value, ValueExt};

pub const HELP: &str = "\
Draws the gallery of the crate `shading`: pictures that show each formula at work.

Usage: cargo run --release -p gallery -- [OPTIONS] [FOLDER]

  FOLDER               where the pictures go [default: target/gallery of the workspace]

Options:
  --only NAME          draw only the pictures whose names contain NAME
  --size WIDTHxHEIGHT  draw them at this size, in pixels [default: 800x600]
  --model FILE.obj     draw a model of your own instead, flat and smooth
  --readme             draw the READMEs' pictures instead [default FOLDER: docs/pictures]
  -h, --help           show this
";

pub enum Command {
    Help,
    Draw(Request),
}

pub struct Request {
    pub subject: Subject,
    pub only: Option<String>,
    /// Width and height, in pixels.
    pub size: (usize, usize),
    pub folder: Option<PathBuf>,
}

pub enum Subject {
    Gallery,
    /// The pictures of the gallery that the READMEs show.
    Readme,
    Model(PathBuf),
}

pub fn parse(arguments: impl IntoIterator<Item = OsString>) -> Result<Command, lexopt::Error> {
    let mut parser = lexopt::Parser::from_args(arguments);
    let mut request = Request {
        subject: Subject::Gallery,
        only: None,
        size: (800, 600),
        folder: None,
    };
    while let Some(argument) = parser.next()? {
        match argument {
            Short('h') | Long("help") => return Ok(Command::Help),
            Long("only") => request.only = Some(parser.value()?.string()?),
            Long("size") => request.size = parser.value()?.parse_with(size)?,
            Long("model") => request.subject = Subject::Model(parser.value()?.into()),
            Long("readme") => request.subject = Subject::Readme,
            Value(path) if request.folder.is_none() => request.folder = Some(path.into()),
            _ => return Err(argument.unexpected()),
        }
    }
    Ok(Command::Draw(request))
}

fn size(text: &str) -> Result<(usize, usize), String> {
    let sides = text
        .split_once('x')
        .map(|(width, height)| (width.parse(), height.parse()));
    match sides {
        Some((Ok(width @ 1..=8192), Ok(height @ 1..=8192))) => Ok((width, height)),
        _ => Err("a size is two numbers from 1 to 8192, such as 800x600".into()),
    }
}
