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

/// A number. JavaScript writes `null` for one that is not finite, the C library of Windows
/// `-nan(ind)` and `1.#INF`, and others write strings.
fn number(text: &str) -> Option<f64> {
    let text = text.trim();
    let text = text
        .strip_prefix('"')
        .and_then(|text| text.strip_suffix('"'))
        .unwrap_or(text);
    if let Ok(number) = text.parse() {
        return Some(number);
    }
    let lower = text.to_ascii_lowercase();
    let size = lower.trim_start_matches(['-', '+']);
    let is_of_windows = |name: &str| {
        size.strip_prefix("1.#")
            .is_some_and(|rest| rest.starts_with(name))
    };
    match size {
        "null" | "none" => Some(f64::NAN),
        _ if size.starts_with("nan(") && size.ends_with(')') => Some(f64::NAN),
        _ if ["qnan", "snan", "ind"].into_iter().any(is_of_windows) => Some(f64::NAN),
        _ if is_of_windows("inf") && lower.starts_with('-') => Some(f64::NEG_INFINITY),
        _ if is_of_windows("inf") => Some(f64::INFINITY),
        _ => None,
    }
}

/// The beginning of a text, in quotation marks and with its control characters escaped.
pub fn quoted(text: &str) -> String {
    const MOST: usize = 80;
    match text.char_indices().nth(MOST) {
        Some((end, _)) => format!("{:?}…", &text[..end]),
        None => format!("{text:?}"),
    }
}

#[cfg(test)]
#[allow(clippy::float_cmp)] // read exactly
mod tests {
    use super::color;

    /// What Python, JavaScript, Rust, glibc, musl and the C library of Windows write for what is not finite.
    #[test]
    fn numbers_that_json_lacks_are_read() {
        for nan in [
            "NaN",
            "nan",
            "-nan",
            "null",
            "\"NaN\"",
            "-nan(ind)",
            "nan(0x8000)",
            "1.#QNAN",
            "-1.#IND00",
        ] {
            let read = color(&format!("[0,{nan},1]")).expect(nan);
            assert!(
                read[1].is_nan() && read[0] == 0.0 && read[2] == 1.0,
                "{nan}"
            );
        }
        for infinity in [
            "Infinity",
            "-Infinity",
            "inf",
            "-inf",
            "1.#INF",
            "-1.#INF00",
            "\"Infinity\"",
            "1e999",
        ] {
            let sign = if infinity.starts_with('-') { -1.0 } else { 1.0 };
            let read = color(&format!("[{infinity},0,0]")).expect(infinity);
            assert_eq!(read[0], sign * f64::INFINITY, "{infinity}");
        }
        for nonsense in [
            "[banana,0,0]",
            "[1.#x,0,0]",
            "[,0,0]",
            "[nan(,0,0]",
            "null",
            "[\"\",0,0]",
        ] {
            assert!(color(nonsense).is_err(), "{nonsense}");
        }
    }
}
