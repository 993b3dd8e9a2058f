//! Tries a renderer in any language by the laws of local illumination.

mod color;
mod piped;

use std::ffi::OsString;
use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Duration;

use clap::builder::PossibleValuesParser;
use clap::{Args, Parser, Subcommand};
use shading_laws::{Laws, Profile, Renderer, Report, Scene, Triple};

use piped::Piped;

/// Tries a renderer in any language by the laws of local illumination.
///
/// The renderer reads scenes from its standard input and writes colors to its standard output.
#[derive(Parser)]
#[command(
    version,
    args_conflicts_with_subcommands = true,
    disable_help_subcommand = true
)]
#[command(
    after_help = "The exit status is 0 if all laws hold, 1 if one is broken, 2 if nothing was found before the renderer \
    ended or answered with nonsense, and 3 if nothing was found before the time was up or Ctrl-C was pressed."
)]
struct Arguments {
    /// The renderer: a program and its arguments
    #[arg(trailing_var_arg = true, required_unless_present = "list")]
    command: Vec<OsString>,
    #[command(flatten)]
    options: Options,
    /// The longest wait for the renderer's next line
    #[arg(long, value_name = "SECONDS", default_value = "10", value_parser = seconds)]
    timeout: Duration,
    /// List the laws
    #[arg(long)]
    list: bool,
    #[command(subcommand)]
    subcommand: Option<Other>,
}

/// What is tried, and how it is reported.
#[derive(Args)]
struct Options {
    /// Try other scenes: the seed from which they are generated
    #[arg(long, default_value = "0")]
    seed: u64,
    /// The number of random scenes, beside the fixed ones
    #[arg(long, default_value = "1024")]
    cases: usize,
    /// Try this law alone; may be repeated
    #[arg(long = "law", value_name = "NAME", hide_possible_values = true)]
    #[arg(value_parser = PossibleValuesParser::new(Laws::names().map(|(name, _)| name)))]
    laws: Vec<String>,
    /// Print the report as JSON
    #[arg(long)]
    json: bool,
    /// The most batches in which the smallest case of a broken law is looked for
    #[arg(long, value_name = "N", default_value = "200")]
    shrink: usize,
    /// The longest time of the run; a law of which not all cases are tried by then is no pass
    #[arg(long, value_name = "SECONDS", value_parser = seconds)]
    time: Option<Duration>,
}

/// A run without a renderer at the other end of a pipe.
#[derive(Args)]
struct Filed {
    /// What the renderer says of itself: one line of JSON, as it would write it
    #[arg(long, value_name = "JSON", default_value = "{}")]
    profile: String,
    #[command(flatten)]
    options: Options,
}

impl Filed {
    /// The profile, the laws, and the scenes, which do not depend on the answers.
    fn planned(&self) -> Result<(Profile, Laws, Vec<Scene>), String> {
        let profile = Profile::from_json(&self.profile);
        let profile = profile.map_err(|why| format!("--profile: {why}"))?;
        let laws = laws(&self.options);
        let scenes = laws.scenes(&profile)?;
        Ok((profile, laws, scenes))
    }
}

#[derive(Subcommand)]
enum Other {
    /// Print a small renderer to copy from
    Example {
        #[arg(value_parser = ["python", "javascript", "c"])]
        language: String,
    },
    /// Print the scenes, one a line, for a renderer that cannot be piped
    Scenes(Filed),
    /// Judge a file with the color of each scene, one a line, that `scenes` with the same options has printed
    Judge {
        #[command(flatten)]
        run: Filed,
        /// The file with the colors
        colors: PathBuf,
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

/// What was found before the time was up is no pass.
const CUT_SHORT: u8 = 3;

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
        Some(Other::Scenes(run)) => {
            let (_, _, scenes) = run.planned()?;
            let lines = scenes.iter().map(|scene| scene.to_json() + "\n");
            Ok((lines.collect(), 0))
        }
        Some(Other::Judge { run, colors }) => {
            let (profile, laws, scenes) = run.planned()?;
            let text = std::fs::read_to_string(colors)
                .map_err(|why| format!("cannot read {}: {why}", colors.display()))?;
            let lines = text.lines().enumerate();
            let color =
                |(i, line)| color::color(line).map_err(|why| format!("line {}: {why}", i + 1));
            let colors: Vec<Triple> = lines.map(color).collect::<Result<_, _>>()?;
            if colors.len() != scenes.len() {
                return Err(format!(
                    "{} colors for {} scenes; `scenes` and `judge` need the same options",
                    colors.len(),
                    scenes.len()
                ));
            }
            let mut report = laws.run(&mut Colors(profile, colors.into_iter()))?;
            report.error = None; // more is asked for than the file has: smaller scenes, and places
            told(&report, &run.options)
        }
        None if arguments.list => {
            let lines = Laws::names().map(|(name, says)| format!("{name:17}  {says}\n"));
            Ok((lines.collect(), 0))
        }
        None => {
            let laws = laws(&arguments.options);
            piped::listen_to_interrupts();
            let mut renderer = Piped::start(&arguments.command, arguments.timeout)?;
            let mut report = laws.run(&mut renderer)?;
            if report.error.is_none() && !report.is_cut_short() {
                report.error = renderer.finish().err();
            }
            let words = arguments.command.iter();
            let words: Vec<String> = words.map(|word| quoted(&word.to_string_lossy())).collect();
            report.command = Some(words.join(" "));
            told(&report, &arguments.options)
        }
    }
}

/// The report in the form that was asked for, and the exit status.
fn told(report: &Report, options: &Options) -> Outcome {
    if let Some(why) = report.error.as_ref().filter(|_| !report.is_broken()) {
        return Err(why.clone());
    }
    let text = if options.json {
        report.to_json() + "\n"
    } else {
        report.to_string()
    };
    let status = match () {
        () if report.passes() => 0,
        () if report.is_cut_short() && !report.is_broken() => CUT_SHORT,
        () => 1,
    };
    Ok((text, status))
}

/// A word for a shell.
fn quoted(word: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "_-./=:,+@%".contains(c);
    if !word.is_empty() && word.chars().all(is_plain) {
        word.to_owned()
    } else {
        format!("'{}'", word.replace('\'', r"'\''"))
    }
}

/// The laws as the options have them.
fn laws(options: &Options) -> Laws {
    Laws {
        seed: options.seed,
        cases: options.cases,
        only: options.laws.clone(),
        shrinks: options.shrink,
        time: options.time,
    }
}

/// A renderer that answers with the colors of a file, in their order, as long as there are any.
struct Colors(Profile, std::vec::IntoIter<Triple>);

impl Renderer for Colors {
    fn profile(&self) -> Profile {
        self.0.clone()
    }

    fn shade(&mut self, scenes: &[Scene]) -> Result<Vec<Triple>, String> {
        Ok(self.1.by_ref().take(scenes.len()).collect())
    }
}
