//! A broken case as code to run.

use crate::scene::Scene;

/// How a report shows a broken case as code to run, beside the scenes as lines of the format.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum Reproduction {
    /// Rust, with the scenes of this library.
    #[default]
    Scenes,
    /// A command of a shell that hands the lines to a renderer, which this command starts.
    Command(String),
    /// Calls of `shade`, as the example in Python has it.
    Python,
    /// Calls of `shade`, as the example in C has it.
    C,
    /// Calls of `shade`, as the example in Rust has it.
    Rust,
}

impl Reproduction {
    /// The code, and above it what it is.
    pub(crate) fn of(&self, scenes: &[Scene]) -> String {
        let each = |line: &dyn Fn(String) -> String| -> String {
            let lines = scenes.iter().map(|scene| line(scene.to_json()));
            lines.collect::<Vec<_>>().concat()
        };
        match self {
            Self::Scenes => {
                let shown = scenes.iter().map(|scene| {
                    let scene = scene.to_string().replace('\n', "\n        ");
                    format!("        {scene},\n")
                });
                format!(
                    "  to reproduce it in Rust:\n    let scenes = [\n{}    ];\n    \
                     let colors = renderer.shade(&scenes)?;\n",
                    shown.collect::<String>()
                )
            }
            // a line has neither a quote of this kind nor a backslash
            Self::Command(command) => format!(
                "  to reproduce it:\nprintf '%s\\n' '{{\"shading-laws\":1}}'{} '' | {command}\n",
                each(&|line| format!(" '{line}'"))
            ),
            Self::Python => format!(
                "  to reproduce it in Python:\n{}",
                each(&|line| format!("print(shade(json.loads('{line}')))\n"))
            ),
            Self::C => format!(
                "  to reproduce it in C:\n    Vec color;\n{}",
                each(&|line| format!(
                    "    color = shade({line:?});\n    \
                     printf(\"%.17g %.17g %.17g\\n\", color.x, color.y, color.z);\n"
                ))
            ),
            Self::Rust => format!(
                "  to reproduce it in Rust:\n{}",
                each(&|line| format!("    println!(\"{{:?}}\", shade(r#\"{line}\"#));\n"))
            ),
        }
    }
}
