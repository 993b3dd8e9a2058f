//! Puts a renderer in any language to the test.

mod example;
mod filed;
mod format;
mod piped;
mod process;

use std::ffi::OsString;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use clap::builder::PossibleValuesParser;
use clap::{Args, Parser, Subcommand};
use indicatif::{ProgressBar, ProgressStyle};
use shading_laws::{Laws, Profile, Progress, Report, Reproduction};

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
    after_help = "The exit status is 0 if all laws hold and all that the renderer says it has was \
    exercised, 1 if not, and 2 if the renderer does not answer or answers with nonsense."
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
    #[arg(long)]
    seed: Option<u64>,
    /// The number of random cases of each law
    #[arg(long)]
    cases: Option<usize>,
    /// Try this law alone; may be repeated
    #[arg(long = "law", value_name = "NAME", hide_possible_values = true)]
    #[arg(value_parser = PossibleValuesParser::new(Laws::names().map(|(name, _)| name)))]
    laws: Vec<String>,
    /// Print the report as JSON
    #[arg(long, conflicts_with = "tap")]
    json: bool,
    /// Print the report in the Test Anything Protocol
    #[arg(long)]
    tap: bool,
    /// Write the report to this file as JUnit's XML, too
    #[arg(long, value_name = "FILE")]
    junit: Option<PathBuf>,
    /// Show broken cases as calls of the example's function in this language, instead of a command
    #[arg(long)]
    language: Option<Language>,
    /// The laws that are known to be broken: a file with a name a line
    #[arg(long, value_name = "FILE")]
    known: Option<PathBuf>,
    /// Try the cases of this file first, which --save has written
    #[arg(long, value_name = "FILE")]
    replay: Option<PathBuf>,
    /// Write the smallest case of each broken law to this file
    #[arg(long, value_name = "FILE")]
    save: Option<PathBuf>,
    /// The most batches in which the smallest case of a broken law is looked for
    #[arg(long, value_name = "N", default_value = "200")]
    shrink: usize,
    /// The longest time of that
    #[arg(long, value_name = "SECONDS", default_value = "60", value_parser = seconds)]
    shrink_time: Duration,
    /// The longest time of the run; a law that is not tried by then is no pass
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
    fn profile(&self) -> Result<Profile, String> {
        format::profile(&self.profile, "the renderer").map_err(|why| format!("--profile: {why}"))
    }
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

/// Ctrl-C was pressed. The renderer is killed then, and that it ended is no news.
static INTERRUPTED: AtomicBool = AtomicBool::new(false);

/// The exit status of a program that was interrupted.
const INTERRUPT: u8 = 130;

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    match run(arguments) {
        Ok((text, passes)) => {
            let mut stdout = io::stdout();
            let written = stdout
                .write_all(text.as_bytes())
                .and_then(|()| stdout.flush());
            match written {
                // whoever no longer reads has read enough
                Err(why) if why.kind() != io::ErrorKind::BrokenPipe => {
                    let _ = writeln!(io::stderr(), "shading-laws: cannot write the report: {why}");
                    ExitCode::from(2)
                }
                _ => ExitCode::from(u8::from(!passes)),
            }
        }
        Err(_) if INTERRUPTED.load(Ordering::SeqCst) => ExitCode::from(INTERRUPT),
        Err(why) => {
            let _ = writeln!(io::stderr(), "shading-laws: {why}");
            ExitCode::from(2)
        }
    }
}

/// What to print, and whether all is well.
fn run(mut arguments: Arguments) -> Result<(String, bool), String> {
    match arguments.subcommand.take() {
        Some(Other::Example { language, to }) => return Ok((example::write(language, to)?, true)),
        Some(Other::Scenes(run)) => {
            let mut scenes = filed::Scenes::new(run.profile()?);
            unasked(&run.options)?.run(&mut scenes)?;
            return Ok((scenes.text(), true));
        }
        Some(Other::Judge { run, colors }) => {
            let text = read(&colors)?;
            let mut renderer = filed::Colors::new(run.profile()?, &text)?;
            let report = unasked(&run.options)?.run(&mut renderer)?;
            renderer.finish()?;
            return printed(report, &run.options);
        }
        None => {}
    }
    if arguments.list {
        return Ok((list(), true));
    }
    let mut report = report(&arguments)?;
    if arguments.options.language.is_none() {
        let words = arguments
            .command
            .iter()
            .map(|word| quoted(&word.to_string_lossy()));
        report.reproduction = Reproduction::Command(words.collect::<Vec<_>>().join(" "));
    }
    printed(report, &arguments.options)
}

/// The report in the form that was asked for, and whether all is well.
fn printed(mut report: Report, options: &Options) -> Result<(String, bool), String> {
    if let Some(language) = options.language {
        report.reproduction = language.reproduction();
    }
    let write = |file: &Option<PathBuf>, text: &dyn Fn() -> String| match file {
        Some(file) => std::fs::write(file, text())
            .map_err(|why| format!("cannot write {}: {why}", file.display())),
        None => Ok(()),
    };
    write(&options.save, &|| report.cases())?;
    write(&options.junit, &|| report.to_junit())?;
    let text = match () {
        () if options.json => report.to_json(),
        () if options.tap => report.to_tap(),
        () => report.to_string(),
    };
    Ok((text.trim_end().to_owned() + "\n", report.passes()))
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

fn read(file: &Path) -> Result<String, String> {
    std::fs::read_to_string(file).map_err(|why| format!("cannot read {}: {why}", file.display()))
}

/// Each law and what it says, a line each.
fn list() -> String {
    let width = Laws::names().map(|(name, _)| name.len()).max().unwrap_or(0);
    let lines: Vec<String> = Laws::names()
        .map(|(name, says)| format!("{name:width$}  {says}"))
        .collect();
    lines.join("\n") + "\n"
}

/// The laws as the options have them.
fn laws(options: &Options) -> Result<Laws, String> {
    let mut laws = Laws::new().shrinking(options.shrink, options.shrink_time);
    if let Some(seed) = options.seed {
        laws = laws.seed(seed);
    }
    if let Some(cases) = options.cases {
        laws = laws.cases(cases);
    }
    if let Some(limit) = options.time {
        laws = laws.time(limit);
    }
    for law in &options.laws {
        laws = laws.only(law);
    }
    if let Some(file) = &options.known {
        for line in read(file)?.lines() {
            let name = line.split('#').next().unwrap_or_default().trim();
            if !name.is_empty() {
                laws = laws.known(name);
            }
        }
    }
    match &options.replay {
        Some(file) => laws
            .replay(&read(file)?)
            .map_err(|why| format!("{}: {why}", file.display())),
        None => Ok(laws),
    }
}

/// The same, and what is asked for does not depend on the answers.
fn unasked(options: &Options) -> Result<Laws, String> {
    Ok(laws(options)?.shrinking(0, Duration::ZERO))
}

fn report(arguments: &Arguments) -> Result<Report, String> {
    let laws = laws(&arguments.options)?;
    ctrlc::set_handler(|| {
        INTERRUPTED.store(true, Ordering::SeqCst);
        process::interrupt(INTERRUPT);
    })
    .map_err(|error| error.to_string())?;
    let mut renderer = Piped::start(&arguments.command, arguments.timeout)?;
    let bar = ProgressBar::new(0); // on a terminal only
    if let Ok(style) = ProgressStyle::with_template("{bar:30} {pos}/{len} {wide_msg}") {
        bar.set_style(style);
    }
    let report = laws.run_with(&mut renderer, &mut |progress: Progress| {
        bar.set_length(progress.of as u64);
        bar.set_position(progress.done as u64);
        let what = match progress.shrinking {
            0 => String::new(),
            batches => format!(": broken; looking for a smaller scene, batch {batches}"),
        };
        bar.set_message(format!("{}{what}", progress.law));
    });
    bar.finish_and_clear();
    let report = report?;
    renderer.finish()?;
    Ok(report)
}
