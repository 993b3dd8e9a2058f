//! Reference values in `tests/data`, and a tally of how close the crate comes to them.

use std::collections::BTreeMap;
use std::fmt::Display;
use std::path::PathBuf;

use support::number::Float;

/// Reads a file of `tests/data`.
pub fn read(file: &str) -> String {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR"))
        .join("tests/data")
        .join(file);
    std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// A row of a table without quoting; its fields are named by the first line of the table.
pub struct Row {
    header: std::rc::Rc<[String]>,
    pub fields: Vec<String>,
}

/// The rows of a CSV file.
pub fn rows(file: &str) -> Vec<Row> {
    let text = read(file);
    let mut lines = text
        .lines()
        .map(|line| line.split(',').map(str::to_owned).collect());
    let header: Vec<String> = lines.next().expect("a header");
    let header: std::rc::Rc<[String]> = header.into();
    lines
        .map(|fields| Row {
            header: header.clone(),
            fields,
        })
        .collect()
}

impl Row {
    pub fn text(&self, name: &str) -> &str {
        let column = self.header.iter().position(|h| h == name);
        &self.fields[column.unwrap_or_else(|| panic!("no column {name}"))]
    }

    /// A decimal number, or the bit pattern of an `f32` if the column's name says so.
    pub fn number(&self, name: &str) -> f64 {
        let text = self.text(name);
        if name.ends_with("_hex32") {
            bits(text)
        } else {
            text.parse().expect(name)
        }
    }

    /// Three numbers in columns such as `nx`, `ny`, `nz`; `{}` in the pattern stands for the axis.
    pub fn vector(&self, pattern: &str) -> [f64; 3] {
        ["x", "y", "z"].map(|axis| self.number(&pattern.replace("{}", axis)))
    }

    /// The value of `name` in a column of the form `a=1.5;b=2`.
    pub fn parameter(&self, name: &str) -> f64 {
        let list = self.text("params").split(';');
        let value = list
            .filter_map(|pair| pair.split_once('='))
            .find(|(key, _)| *key == name);
        value
            .unwrap_or_else(|| panic!("no parameter {name}"))
            .1
            .parse()
            .expect(name)
    }
}

/// The number with this bit pattern: an `f32` in eight hexadecimal digits.
pub fn bits(hex: &str) -> f64 {
    f64::from(f32::from_bits(
        u32::from_str_radix(hex, 16).expect("eight hexadecimal digits"),
    ))
}

/// The tally of one comparison: what was compared, what could not be, and the largest error.
pub struct Tally {
    title: String,
    compared: usize,
    left_out: BTreeMap<&'static str, usize>,
    worst: Worst,
    /// The largest share of its tolerance that an error reached.
    share: f64,
}

#[derive(Default)]
struct Worst {
    error: f64,
    tolerance: f64,
}

impl Tally {
    pub fn new<T: Float>(title: impl Display) -> Self {
        Self {
            title: format!("{title}, {}", T::NAME),
            compared: 0,
            left_out: BTreeMap::new(),
            worst: Worst::default(),
            share: 0.0,
        }
    }

    /// Compares the numbers of a row, each with its tolerance.
    pub fn compare<const N: usize>(
        &mut self,
        row: impl Display,
        actual: [f64; N],
        expected: [f64; N],
        tolerance: [f64; N],
    ) {
        self.compared += 1;
        for i in 0..N {
            let (error, tolerance) = ((actual[i] - expected[i]).abs(), tolerance[i]);
            #[allow(clippy::float_cmp)] // both are infinite
            let equal = actual[i] == expected[i];
            assert!(
                equal || error <= tolerance,
                "{}, {row}: {actual:?} instead of {expected:?}, off by {error:e} in [{i}] with a tolerance of {tolerance:e}",
                self.title
            );
            if !equal && error > self.worst.error {
                self.worst = Worst { error, tolerance };
            }
            if !equal {
                self.share = self.share.max(error / tolerance);
            }
        }
    }

    /// Counts a row whose result was checked in another way: it is `None`, or a limit.
    pub fn checked(&mut self) {
        self.compared += 1;
    }

    /// Counts a row that cannot be compared, with the reason.
    pub fn leave_out(&mut self, reason: &'static str) {
        *self.left_out.entry(reason).or_default() += 1;
    }

    /// Prints the tally. It must account for every row: the number compared, and the number left
    /// out for each reason.
    pub fn close(self, compared: usize, left_out: &[(&'static str, usize)]) {
        let Self {
            title,
            worst,
            share,
            ..
        } = &self;
        println!(
            "{title}: {} rows, largest error {:.2e} (tolerance there {:.2e}), at most {:.0}% of its tolerance",
            self.compared,
            worst.error,
            worst.tolerance,
            100.0 * share
        );
        for (reason, count) in &self.left_out {
            println!("{title}: {count} rows left out: {reason}");
        }
        assert_eq!(self.compared, compared, "{title}: rows compared");
        assert_eq!(
            self.left_out,
            left_out.iter().copied().collect(),
            "{title}: rows left out"
        );
    }
}
