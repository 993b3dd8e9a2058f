//! A color as a renderer writes it.

use shading_laws::Triple;

/// A color; also with the numbers that JSON lacks, however a language writes them.
pub fn color(line: &str) -> Result<Triple, String> {
    let list = line.trim().strip_prefix('[');
    let list = list.and_then(|list| list.strip_suffix(']'));
    let list = list.ok_or_else(|| format!("expected [red,green,blue], found {}", quoted(line)))?;
    let one = |text| {
        number(text).ok_or_else(|| format!("{} is no number in {}", quoted(text), quoted(line)))
    };
    let numbers: Vec<f64> = list.split(',').map(one).collect::<Result<_, String>>()?;
    let count = numbers.len();
    Triple::try_from(numbers)
        .map_err(|_| format!("expected 3 numbers, found {count} in {}", quoted(line)))
}

/// A number. What is not finite is `null` in JavaScript, `-nan(ind)` and `1.#INF` in the C library of
/// Windows, and a string in other languages.
fn number(text: &str) -> Option<f64> {
    let text = text.trim().trim_matches('"');
    let lower = text.to_ascii_lowercase();
    let size = lower.trim_start_matches(['-', '+']);
    let mut names = ["null", "none", "nan", "1.#"].iter();
    let is_nan = names.any(|it| size.starts_with(it));
    text.parse().ok().or(is_nan.then_some(f64::NAN))
}

/// The beginning of a text, in quotation marks and with its control characters escaped.
pub fn quoted(text: &str) -> String {
    const MOST: usize = 80;
    match text.char_indices().nth(MOST) {
        Some((end, _)) => format!("{:?}…", &text[..end]),
        None => format!("{text:?}"),
    }
}
