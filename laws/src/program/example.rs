//! Renderers to copy from.

use std::fs::OpenOptions;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use clap::ValueEnum;
use shading_laws::Reproduction;

#[derive(Clone, Copy, ValueEnum)]
pub enum Language {
    Python,
    C,
    Rust,
}

impl Language {
    fn name_and_text(self) -> (&'static str, &'static str) {
        match self {
            Self::Python => ("renderer.py", include_str!("../../examples/renderer.py")),
            Self::C => ("renderer.c", include_str!("../../examples/renderer.c")),
            Self::Rust => ("renderer.rs", include_str!("../../examples/renderer.rs")),
        }
    }

    /// Calls of the example's function.
    pub fn reproduction(self) -> Reproduction {
        match self {
            Self::Python => Reproduction::Python,
            Self::C => Reproduction::C,
            Self::Rust => Reproduction::Rust,
        }
    }

    /// The commands that put the renderer in `file` to the test.
    fn commands(self, file: &Path) -> String {
        let extension = if file.extension().is_some() {
            ""
        } else {
            "out"
        };
        let program = file.with_extension(extension);
        let program = match program.parent() {
            Some(folder) if folder.as_os_str().is_empty() => Path::new(".").join(&program),
            _ => program,
        };
        let [file, program] = [file, &program].map(|path| path.display().to_string());
        match self {
            Self::Python => format!("    shading-laws python3 {file}"),
            Self::C => format!("    cc -O2 {file} -o {program} -lm\n    shading-laws {program}"),
            Self::Rust => format!(
                "    rustc -O --edition 2021 {file} -o {program}\n    shading-laws {program}"
            ),
        }
    }
}

/// Writes the example to a new file, and returns what to do with it. `to` is a file or a folder.
pub fn write(language: Language, to: Option<PathBuf>) -> Result<String, String> {
    let (name, text) = language.name_and_text();
    let file = match to {
        None => name.into(),
        Some(folder) if folder.is_dir() => folder.join(name),
        Some(file) => file,
    };
    let mut options = OpenOptions::new();
    let written = options
        .write(true)
        .create_new(true)
        .open(&file)
        .and_then(|mut file| file.write_all(text.as_bytes()));
    match written {
        Ok(()) => Ok(format!(
            "{} is a renderer that keeps all laws. Put it to the test:\n\n{}\n",
            file.display(),
            language.commands(&file)
        )),
        Err(error) if error.kind() == io::ErrorKind::AlreadyExists => Err(format!(
            "{} exists already; move it away, or write elsewhere with --to",
            file.display()
        )),
        Err(error) => Err(format!("cannot write {}: {error}", file.display())),
    }
}
