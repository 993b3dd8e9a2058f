//! A renderer that reads scenes from one file and writes colors to another.

use shading_laws::{Profile, Renderer, Scene, Triple};

use super::format;

/// Notes the scenes that a run asks for, and answers black. What is asked for does not depend on the answers, as long as
/// nothing is made smaller.
pub struct Scenes {
    profile: Profile,
    text: String,
}

impl Scenes {
    pub fn new(profile: Profile) -> Self {
        let text = String::new();
        Self { profile, text }
    }

    pub fn text(self) -> String {
        self.text
    }
}

impl Renderer for Scenes {
    fn profile(&self) -> Profile {
        self.profile.clone()
    }

    fn shade(&mut self, scenes: &[Scene]) -> Result<Vec<Triple>, String> {
        for scene in scenes {
            self.text += &scene.to_json();
            self.text.push('\n');
        }
        Ok(vec![[0.0; 3]; scenes.len()])
    }
}

/// Answers with the colors of a file, in their order.
pub struct Colors {
    profile: Profile,
    all: Vec<Triple>,
    given: usize,
}

impl Colors {
    pub fn new(profile: Profile, text: &str) -> Result<Self, String> {
        let lines = text.lines().enumerate();
        let read = |(i, line)| format::color(line).map_err(|why| format!("line {}: {why}", i + 1));
        Ok(Self {
            profile,
            all: lines.map(read).collect::<Result<_, _>>()?,
            given: 0,
        })
    }

    /// Sees to it that there are no colors left.
    pub fn finish(&self) -> Result<(), String> {
        if self.given == self.all.len() {
            return Ok(());
        }
        let (colors, scenes) = (self.all.len(), self.given);
        Err(format!("{colors} colors for {scenes} scenes; {SAME}"))
    }
}

const SAME: &str = "`scenes` and `judge` need the same options";

impl Renderer for Colors {
    fn profile(&self) -> Profile {
        self.profile.clone()
    }

    fn shade(&mut self, scenes: &[Scene]) -> Result<Vec<Triple>, String> {
        let end = self.given + scenes.len();
        let colors = self.all.get(self.given..end);
        let count = self.all.len();
        let colors = colors.ok_or_else(|| format!("only {count} colors; {SAME}"))?;
        let colors = colors.to_vec();
        self.given = end;
        Ok(colors)
    }
}
