//! The table of instruction counts.

use std::fmt;

/// By how much a count may differ from the one in the table.
const TOLERANCE: f64 = 0.03;

/// The names of the functions and their instructions per call.
pub struct Table(pub Vec<(&'static str, f64)>);

impl fmt::Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        writeln!(
            f,
            "# instructions per call on x86-64, compiled by {}",
            compiler()
        )?;
        for (name, count) in &self.0 {
            writeln!(f, "{name:48} {count:8.1}")?;
        }
        Ok(())
    }
}

/// The version of the compiler: another one may give other counts.
fn compiler() -> String {
    let version = std::process::Command::new("rustc")
        .arg("--version")
        .output();
    let version = version.map(|output| String::from_utf8_lossy(&output.stdout).trim().to_owned());
    version.unwrap_or_default()
}

impl Table {
    /// Compares the counts with a table, and reports the differences.
    pub fn compare(&self, kept: &str) -> Result<(), String> {
        let lines = kept.lines().filter(|line| !line.starts_with('#'));
        let mut kept: Vec<(&str, f64)> = lines
            .filter_map(|line| line.rsplit_once(' '))
            .filter_map(|(name, count)| Some((name.trim(), count.parse().ok()?)))
            .collect();
        let mut off = Vec::new();
        for (name, count) in &self.0 {
            let place = kept.iter().position(|(kept, _)| kept == name);
            match place.map(|place| kept.swap_remove(place)) {
                Some((_, before)) if (count / before - 1.0).abs() <= TOLERANCE => {}
                Some((_, before)) => off.push(format!("{name}: {count:.1} instead of {before:.1}")),
                None => off.push(format!("{name}: not in the table")),
            }
        }
        off.extend(
            kept.iter()
                .map(|(name, _)| format!("{name}: only in the table")),
        );
        if off.is_empty() {
            Ok(())
        } else {
            Err(off.join("\n"))
        }
    }
}
