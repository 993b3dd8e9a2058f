//! Mistakes in a header for C: each operator, each minimum and each number for another, one at a time.

/// A header with one mistake.
#[derive(Clone)]
pub struct Mutant {
    /// The line as it is.
    pub after: String,
    pub header: String,
    /// The function or the table that has the mistake, without its prefix.
    pub within: String,
}

/// What stands in the place of what.
const SWAPS: [(&str, &str); 33] = [
    (" + ", " - "),
    (" - ", " + "),
    (" * ", " / "),
    (" / ", " * "),
    (" < ", " > "),
    (" < ", " <= "),
    (" <= ", " > "),
    (" <= ", " < "),
    (" > ", " < "),
    (" > ", " >= "),
    (" >= ", " < "),
    (" >= ", " > "),
    (" == ", " != "),
    (" != ", " == "),
    (" && ", " || "),
    (" || ", " && "),
    (" << ", " >> "),
    (" >> ", " << "),
    (" & ", " | "),
    (" | ", " & "),
    (" ^ ", " | "),
    ("!(", "("),
    ("_min(", "_max("),
    ("_max(", "_min("),
    ("_add(", "_sub("),
    ("_sub(", "_add("),
    ("_add3(", "_sub3("),
    ("_sub3(", "_add3("),
    ("_mul(", "_add("),
    ("_mul3(", "_add3("),
    ("_scale(", "_over("),
    ("_over(", "_scale("),
    ("_cross(", "_add("),
];

/// All mutants of a header. The first and the last lines of a file, macros and comments have none.
pub fn mutants(header: &str) -> Vec<Mutant> {
    let lines: Vec<_> = header.lines().collect();
    let (mut all, mut is_comment, mut is_macro) = (vec![], false, false);
    let mut within = String::new();
    for (at, line) in lines.iter().enumerate() {
        let begins_comment = line.trim_start().starts_with("/*");
        let is_code = !(is_comment || is_macro || begins_comment || line.starts_with('#'));
        // a function, or a table
        if let Some((head, _)) = line.split_once(['(', '['])
            && head.starts_with("static")
        {
            let name = head.rsplit(' ').next().expect("a name");
            within = name.trim_start_matches("shading_").into();
        }
        if is_code {
            let code = line.find("/*").map_or(*line, |end| &line[..end]);
            for after in swapped(code).into_iter().chain(other_numbers(code)) {
                let after = after + &line[code.len()..];
                let mut lines = lines.clone();
                lines[at] = &after;
                all.push(Mutant {
                    header: lines.join("\n"),
                    within: within.clone(),
                    after,
                });
            }
        }
        is_comment = (is_comment || line.contains("/*")) && !line.contains("*/");
        is_macro = (is_macro || line.starts_with('#')) && line.ends_with('\\');
    }
    all
}

fn swapped(code: &str) -> Vec<String> {
    // the name of a function is not its call
    let is_head = code.ends_with(") {") && code.starts_with("static");
    let swaps = SWAPS
        .iter()
        .filter(|_| !is_head && !code.starts_with("SHADING"));
    let of = |(from, to): &(&str, &str)| {
        let places = code.match_indices(from).map(|(at, _)| at);
        let change = |at| format!("{}{to}{}", &code[..at], &code[at + from.len()..]);
        places.map(change).collect::<Vec<_>>()
    };
    swaps.flat_map(of).collect()
}

/// Each number for the next one, and 0 for 1.
fn other_numbers(code: &str) -> Vec<String> {
    let mut all = vec![];
    let mut at = 0;
    while at < code.len() {
        let rest = &code[at..];
        let is_part = |c: char| c.is_ascii_alphanumeric() || c == '.' || c == '_';
        let length = rest.find(|c| !is_part(c)).unwrap_or(rest.len());
        let word = &rest[..length];
        // an exponent has a sign
        let is_float = word.starts_with(|c: char| c.is_ascii_digit()) && word.contains('.');
        let length = if is_float && word.ends_with('e') {
            let exponent = &rest[length + 1..];
            let is_part = |c: char| c.is_ascii_alphanumeric();
            length + 1 + exponent.find(|c| !is_part(c)).unwrap_or(exponent.len())
        } else {
            length.max(rest.chars().next().map_or(1, char::len_utf8))
        };
        if let Some(next) = next_number(&rest[..length]) {
            all.push(format!("{}{next}{}", &code[..at], &rest[length..]));
        }
        at += length;
    }
    all
}

fn next_number(word: &str) -> Option<String> {
    if !word.starts_with(|c: char| c.is_ascii_digit()) {
        return None;
    }
    if let Some(digits) = word.strip_prefix("0x") {
        let digits = digits.trim_end_matches('u');
        return Some(format!("0x{:X}", u64::from_str_radix(digits, 16).ok()? + 1));
    }
    if word.contains('.') {
        let x: f32 = word.trim_end_matches('f').parse().ok()?;
        let next = if x == 0.0 {
            1.0
        } else {
            f32::from_bits(x.to_bits() + 1)
        };
        let next = if next.is_finite() { next } else { 1e38 };
        return Some(format!("{next:?}f"));
    }
    let x: u64 = word.trim_end_matches('u').parse().ok()?;
    Some((x + 1).to_string())
}

/// What a function or a table of a header may change: itself, what names it, and what names that.
pub fn changed_by(header: &str, name: &str) -> Vec<String> {
    let mut all = vec![name.to_string()];
    let mut within = String::new();
    for line in header.lines() {
        if line.starts_with("static")
            && let Some((head, _)) = line.split_once(['(', '['])
        {
            let name = head.rsplit(' ').next().expect("a name");
            within = name.trim_start_matches("shading_").into();
            continue;
        }
        // each calls only those before it
        let names = |known: &String| {
            let mut rest = line.split("shading_").skip(1);
            rest.any(|rest| {
                rest.split(|c: char| !c.is_alphanumeric() && c != '_')
                    .next()
                    == Some(known)
            })
        };
        if !all.contains(&within) && all.iter().any(names) {
            all.push(within.clone());
        }
    }
    all
}
