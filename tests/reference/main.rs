//! The crate in `f64` against what four programs computed (`tests/data/README.md`).

mod programs;
mod scene;

use std::fs;
use std::path::Path;

/// Compares each row of a file, color by color, and counts the rows, so that none is passed over.
fn compare(file: &str, rows: usize, row: impl Fn(&mut Fields) -> Comparison) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/data")
        .join(file);
    let text = fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    let mut compared = 0;
    for line in text.lines().skip(1) {
        let mut fields = Fields(line.split(',').collect::<Vec<_>>().into_iter());
        let Comparison {
            color,
            expected,
            tolerance,
        } = row(&mut fields);
        assert_eq!(fields.0.next(), None, "a field is left over: {line}");
        for i in 0..3 {
            let error = (color[i] - expected[i]).abs();
            assert!(
                tolerance[i] <= 1e-4 * expected[i].max(1.0),
                "{file}: too wide: {line}"
            );
            assert!(
                error <= tolerance[i],
                "{file}: {color:?} instead of {expected:?}, off by {error:e}: {line}"
            );
        }
        compared += 1;
    }
    assert_eq!(compared, rows);
}

struct Comparison {
    color: [f64; 3],
    expected: [f64; 3],
    tolerance: [f64; 3],
}

/// The fields of a row, one after the other.
struct Fields<'a>(std::vec::IntoIter<&'a str>);

impl<'a> Fields<'a> {
    fn text(&mut self) -> &'a str {
        self.0.next().expect("a field")
    }

    fn number(&mut self) -> f64 {
        let text = self.text();
        text.parse().unwrap_or_else(|e| panic!("{text}: {e}"))
    }

    fn three(&mut self) -> [f64; 3] {
        [(); 3].map(|()| self.number())
    }

    /// An `f32` in eight hexadecimal digits.
    fn bits(&mut self) -> f64 {
        let bits = u32::from_str_radix(self.text(), 16).expect("eight hexadecimal digits");
        f32::from_bits(bits).into()
    }

    fn three_bits(&mut self) -> [f64; 3] {
        [(); 3].map(|()| self.bits())
    }

    /// As many lights as the next field says.
    fn lamps(&mut self, lamp: fn(&mut Self) -> scene::Lamp) -> Vec<scene::Lamp> {
        let count = self.text().parse().expect("the number of lights");
        (0..count).map(|_| lamp(self)).collect()
    }
}
