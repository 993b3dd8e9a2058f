//! The report for programs that read JUnit's XML, as most continuous integration does.

use std::fmt::Write;

use crate::report::{LawReport, Report, Verdict, printable};

/// What a law came to: a mark in the report, why, and more words.
enum Mark {
    Passed,
    Skipped(String),
    Failed(String, String),
}

impl Report {
    /// The report as JUnit's XML: a test case for each law, and one for what was exercised. A law that was not tried is
    /// skipped, and so is one that is known to be broken.
    ///
    /// ```
    /// use shading_laws::{Laws, Profile, from_fn};
    ///
    /// let mut black = from_fn(Profile::default(), |_scene| [0.0; 3]);
    /// let report = Laws::new().only("eye").cases(20).run(&mut black).unwrap();
    /// assert!(report.to_junit().contains("<testcase classname=\"shading-laws\" name=\"eye\"/>"));
    /// ```
    #[must_use]
    pub fn to_junit(&self) -> String {
        let laws = self.laws.iter().map(|law| (law.name, self.mark(law)));
        let missing = self.unexercised();
        let exercised = match missing.first() {
            None => Mark::Passed,
            Some(first) => Mark::Failed(format!("not exercised: {first}"), missing.join("\n")),
        };
        let cases: Vec<_> = laws.chain([("exercised", exercised)]).collect();
        let count = |is: fn(&Mark) -> bool| cases.iter().filter(|(_, mark)| is(mark)).count();
        let (failed, skipped) = (
            count(|mark| matches!(mark, Mark::Failed(..))),
            count(|mark| matches!(mark, Mark::Skipped(_))),
        );
        let counts = format!(
            "tests=\"{}\" failures=\"{failed}\" errors=\"0\" skipped=\"{skipped}\"",
            cases.len()
        );
        let (name, seed) = (escaped(&printable(&self.profile.name)), self.seed);
        let mut xml = format!(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites {counts}>\n\
             <testsuite name=\"{name}, seed {seed}\" {counts}>\n"
        );
        for (name, mark) in cases {
            let result = match mark {
                Mark::Passed => "/>".to_owned(),
                Mark::Skipped(why) => {
                    format!("><skipped message=\"{}\"/></testcase>", escaped(&why))
                }
                Mark::Failed(why, text) => format!(
                    "><failure message=\"{}\">{}</failure></testcase>",
                    escaped(&why),
                    escaped(&text)
                ),
            };
            let _ = writeln!(
                xml,
                "<testcase classname=\"shading-laws\" name=\"{name}\"{result}"
            );
        }
        xml + "</testsuite>\n</testsuites>\n"
    }

    fn mark(&self, law: &LawReport) -> Mark {
        match &law.verdict {
            Verdict::NotTried { because } if *because == "the time is up" => {
                Mark::Failed((*because).into(), String::new())
            }
            Verdict::NotTried { because } => Mark::Skipped((*because).into()),
            Verdict::Broken { .. } if self.is_known(law) => {
                Mark::Skipped("known to be broken".into())
            }
            Verdict::Broken { smallest, .. } => Mark::Failed(law.says.into(), smallest.to_string()),
            Verdict::Holds { .. } if self.is_known(law) => {
                Mark::Failed("holds, but is known as broken".into(), String::new())
            }
            Verdict::Holds { .. } => Mark::Passed,
        }
    }
}

/// A text in XML, which has no control characters but the ends of lines.
fn escaped(text: &str) -> String {
    let mut xml = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => xml += "&amp;",
            '<' => xml += "&lt;",
            '>' => xml += "&gt;",
            '"' => xml += "&quot;",
            c if c.is_control() && c != '\n' => xml.push('\u{fffd}'),
            c => xml.push(c),
        }
    }
    xml
}
