//! Puts a renderer in any language to the test.

mod example;
mod format;
mod piped;
mod process;

use std::ffi::OsString;
use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use clap::builder::PossibleValuesParser;
use clap::{Parser, Subcommand};
use indicatif::{ProgressBar, ProgressStyle};
use shading_laws::{Laws, Progress, Report};

use example::Language;
use piped::Piped;

/// Puts a renderer in any language to the test of the laws of local illumination.
///
/// The renderer reads scenes from its standard input and writes colors to its standard output.
#[derive(Parser)]
#[command(
    version,
    args_conflicts_with_subcommands = true,
    disable_help_subcommand = true
)]
#[command(
    after_help = "The exit status is 0 if all laws hold, 1 if one is broken, and 2 if the renderer \
    does not answer or answers with nonsense."
)]
struct Arguments {
    /// The renderer: a program and its arguments
    #[arg(trailing_var_arg = true, required_unless_present = "list")]
    command: Vec<OsString>,
    /// Try other scenes: the seed from which they are generated
    #[arg(long)]
    seed: Option<u64>,
    /// The number of cases of each law
    #[arg(long)]
    cases: Option<usize>,
    /// Try this law alone; may be repeated
    #[arg(long = "law", value_name = "NAME", hide_possible_values = true)]
    #[arg(value_parser = PossibleValuesParser::new(Laws::names().map(|(name, _)| name)))]
    laws: Vec<String>,
    /// Print the report as JSON
    #[arg(long)]
    json: bool,
    /// The longest wait for the renderer's next line
    #[arg(long, value_name = "SECONDS", default_value = "10", value_parser = seconds)]
    timeout: Duration,
    /// List the laws
    #[arg(long)]
    list: bool,
    #[command(subcommand)]
    subcommand: Option<Other>,
}

#[derive(Subcommand)]
enum Other {
    /// Write a small renderer to copy from
    Example {
        language: Language,
        /// The file or folder to write to, instead of the current folder
        #[arg(long, value_name = "PATH")]
        to: Option<PathBuf>,
    },
}

fn seconds(text: &str) -> Result<Duration, String> {
    let seconds: f64 = text.parse().map_err(|_| "not a number")?;
    let duration = Duration::try_from_secs_f64(seconds).map_err(|error| error.to_string())?;
    if duration.is_zero() {
        return Err("not above 0".into());
    }
    Ok(duration)
}

/// Ctrl-C was pressed. The renderer is killed then, and that it ended is no news.
static INTERRUPTED: AtomicBool = AtomicBool::new(false);

/// The exit status of a program that was interrupted.
const INTERRUPT: u8 = 130;

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    match run(arguments) {
        Ok((text, is_broken)) => {
            // whoever no longer reads has read enough
            let _ = io::stdout().write_all(text.as_bytes());
            ExitCode::from(u8::from(is_broken))
        }
        Err(_) if INTERRUPTED.load(Ordering::SeqCst) => ExitCode::from(INTERRUPT),
        Err(why) => {
            let _ = writeln!(io::stderr(), "shading-laws: {why}");
            ExitCode::from(2)
        }
    }
}

/// What to print, and whether a law is broken.
fn run(arguments: Arguments) -> Result<(String, bool), String> {
    if let Some(Other::Example { language, to }) = arguments.subcommand {
        return Ok((example::write(language, to)?, false));
    }
    if arguments.list {
        return Ok((list(), false));
    }
    let report = report(&arguments)?;
    let text = if arguments.json {
        report.to_json()
    } else {
        report.to_string()
    };
    Ok((text.trim_end().to_owned() + "\n", report.is_broken()))
}

/// Each law and what it says, a line each.
fn list() -> String {
    let width = Laws::names().map(|(name, _)| name.len()).max().unwrap_or(0);
    let lines: Vec<String> = Laws::names()
        .map(|(name, says)| format!("{name:width$}  {says}"))
        .collect();
    lines.join("\n") + "\n"
}

fn report(arguments: &Arguments) -> Result<Report, String> {
    let mut laws = Laws::new();
    if let Some(seed) = arguments.seed {
        laws = laws.seed(seed);
    }
    if let Some(cases) = arguments.cases {
        laws = laws.cases(cases);
    }
    for law in &arguments.laws {
        laws = laws.only(law);
    }
    let mut renderer = Piped::start(&arguments.command, arguments.timeout, |process| {
        let kill = process.killer();
        let handler = move || {
            INTERRUPTED.store(true, Ordering::SeqCst);
            kill();
            std::process::exit(INTERRUPT.into());
        };
        ctrlc::set_handler(handler).map_err(|error| error.to_string())
    })?;
    let bar = ProgressBar::new(0); // on a terminal only
    if let Ok(style) = ProgressStyle::with_template("{bar:30} {pos}/{len} {wide_msg}") {
        bar.set_style(style);
    }
    let report = laws.run_with(&mut renderer, &mut |progress: Progress| {
        bar.set_length(progress.of as u64);
        bar.set_position(progress.done as u64);
        let what = if progress.shrinking {
            ": broken; looking for a smaller scene"
        } else {
            ""
        };
        bar.set_message(format!("{}{what}", progress.law));
    });
    bar.finish_and_clear();
    let report = report?;
    renderer.finish()?;
    Ok(report)
}
