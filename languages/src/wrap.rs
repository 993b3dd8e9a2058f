//! Text in lines.

/// The longest line.
const WIDTH: usize = 110;

/// Signs before which a line may end.
const SIGNS: [&str; 8] = ["+ ", "- ", "* ", "/ ", "? ", ": ", "|| ", "&& "];

/// Text in lines of at most [`WIDTH`], each broken where the parentheses are fewest; all but the first are indented
/// as the next is.
pub fn wrapped(indent: &str, next: &str, text: &str) -> String {
    let (mut depth, mut best) = (0, None);
    for (at, c) in text.char_indices() {
        match c {
            '(' | '{' => depth += 1,
            ')' | '}' => depth -= 1,
            ' ' if at > 24 && indent.len() + at <= WIDTH => {
                let is_between_arguments = text[..at].ends_with(',');
                let is_before = |sign: &&str| text[at + 1..].starts_with(*sign);
                let breaks = is_between_arguments || SIGNS.iter().any(is_before);
                // between arguments rather than within one
                let rank = (depth, !is_between_arguments);
                if breaks && best.is_none_or(|(least, _)| rank <= least) {
                    best = Some((rank, at));
                }
            }
            _ => {}
        }
    }
    match best {
        Some((_, at)) if indent.len() + text.len() > WIDTH => {
            let rest = wrapped(next, next, &text[at + 1..]);
            format!("{indent}{}\n{rest}", &text[..at])
        }
        _ => format!("{indent}{text}\n"),
    }
}
