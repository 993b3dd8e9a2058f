//! Tries a renderer in any language by the laws of local illumination.

mod color;
mod piped;

use std::ffi::OsString;
use std::io::{self, Write};
use std::process::ExitCode;
use std::time::Duration;

use clap::{Parser, Subcommand};
use shading_laws::{Fault, Laws};

use piped::Piped;

/// Tries a renderer in any language by the laws of local illumination.
///
/// The renderer reads scenes from its standard input and writes colors to its standard output.
#[derive(Parser)]
#[command(
    version,
    args_conflicts_with_subcommands = true,
    disable_help_subcommand = true,
    after_help = "The exit status is 0 if all laws hold, 1 if one is broken, 2 if nothing was found before the renderer \
    ended or answered with nonsense, and 3 if nothing was found before the time was up or Ctrl-C was pressed."
)]
struct Arguments {
    /// The renderer: a program and its arguments
    #[arg(trailing_var_arg = true, required_unless_present = "list")]
    command: Vec<OsString>,
    /// Try other scenes: the seed from which they are generated
    #[arg(long, default_value = "0")]
    seed: u64,
    /// The number of random scenes, beside the fixed ones
    #[arg(long, default_value = "1024")]
    cases: usize,
    /// Print the report as JSON
    #[arg(long)]
    json: bool,
    /// Show a broken case as it was found, without looking for a smaller one
    #[arg(long)]
    no_shrink: bool,
    /// The longest time of the run; a law of which not all cases are tried by then is no pass
    #[arg(long, value_name = "SECONDS", value_parser = seconds)]
    time: Option<Duration>,
    /// The longest wait for the renderer's next line
    #[arg(long, value_name = "SECONDS", default_value = "10", value_parser = seconds)]
    timeout: Duration,
    /// List the departures that a profile may declare
    #[arg(long)]
    list: bool,
    #[command(subcommand)]
    subcommand: Option<Other>,
}

#[derive(Subcommand)]
enum Other {
    /// Print a small renderer to copy from
    Example {
        #[arg(value_parser = ["python", "javascript", "c"])]
        language: String,
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

/// What to print, and the exit status.
type Outcome = Result<(String, u8), String>;

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    let (text, mut status) = run(&arguments).unwrap_or_else(|why| {
        let _ = writeln!(io::stderr(), "shading-laws: {why}");
        (String::new(), 2)
    });
    match io::stdout().write_all(text.as_bytes()) {
        Err(why) if why.kind() != io::ErrorKind::BrokenPipe => {
            let _ = writeln!(io::stderr(), "shading-laws: cannot write the report: {why}");
            status = 2;
        }
        _ => {}
    }
    ExitCode::from(status)
}

fn run(arguments: &Arguments) -> Outcome {
    match &arguments.subcommand {
        Some(Other::Example { language }) => {
            let text = match language.as_str() {
                "python" => include_str!("../../examples/renderer.py"),
                "javascript" => include_str!("../../examples/renderer.js"),
                _ => include_str!("../../examples/renderer.c"),
            };
            Ok((text.into(), 0))
        }
        None if arguments.list => {
            let lines = Fault::known().map(|fault| format!("{:25}  {fault}\n", fault.name()));
            Ok((lines.collect(), 0))
        }
        None => judged(arguments),
    }
}

/// What a run with a renderer finds, in the form that was asked for.
fn judged(arguments: &Arguments) -> Outcome {
    let laws = Laws {
        seed: arguments.seed,
        cases: arguments.cases,
        shrinks: !arguments.no_shrink,
        time: arguments.time,
        ..Laws::default()
    };
    piped::listen_to_interrupts();
    let mut renderer = Piped::start(&arguments.command, arguments.timeout)?;
    let mut report = laws.run(&mut renderer)?;
    if report.error.is_none() && !report.is_cut_short() {
        report.error = renderer.finish().err();
    }
    let words = arguments.command.iter();
    report.command = Some(shell_words::join(words.map(|word| word.to_string_lossy())));
    let text = if arguments.json {
        report.to_json() + "\n"
    } else {
        report.to_string()
    };
    match &report.error {
        _ if report.passes() => Ok((text, 0)),
        _ if report.is_broken() => Ok((text, 1)),
        Some(why) => Err(why.clone()),
        None => Ok((text, 3)), // what was found before the time was up is no pass
    }
}
