//! The source names every item of the public interface, or a row of the table of functions does.

const INTERFACE: &str = include_str!("../../public-api/interface.txt");

const SOURCE: &str = concat!(
    include_str!("../../functions/src/table.rs"),
    include_str!("../src/fixed.rs"),
    include_str!("../src/items.rs"),
    include_str!("../src/names.rs"),
    include_str!("../src/traits.rs"),
    include_str!("../src/wide.rs"),
);

const TRAITS: &str = include_str!("../src/traits.rs");

/// The words before the path of an item.
const KINDS: [&str; 7] = ["const", "fn", "type", "struct", "enum", "trait", "mod"];

type Tokens<'a> = Vec<&'a str>;

/// Splits a text into names, `::` and single characters, and drops the lifetimes.
fn tokens(mut text: &str) -> Tokens<'_> {
    let mut tokens = Vec::new();
    while let Some(first) = text.trim_start().chars().next() {
        text = text.trim_start();
        let is_named = |c: char| c.is_alphanumeric() || c == '_';
        let after = |start: usize| {
            text[start..]
                .find(|c| !is_named(c))
                .map_or(text.len(), |end| start + end)
        };
        let end = match first {
            '\'' => after(1),
            _ if is_named(first) => after(0),
            _ if text.starts_with("::") => 2,
            _ => first.len_utf8(),
        };
        if first != '\'' {
            tokens.push(&text[..end]);
        }
        text = &text[end..];
    }
    tokens
}

/// The index at which the angle bracket after the first token closes.
fn closing(tokens: &[&str]) -> usize {
    let mut depth = 0;
    let mut closes = |token: &&str| {
        depth += i32::from(*token == "<") - i32::from(*token == ">");
        depth == 0
    };
    1 + tokens[1..].iter().position(&mut closes).expect("balanced")
}

/// Drops the parameters of this crate's types: `Vec3<T>` becomes `Vec3`.
fn plain<'a>(tokens: &[&'a str], types: &[&str]) -> Tokens<'a> {
    let (mut plain, mut i) = (Vec::new(), 0);
    while let Some(token) = tokens.get(i) {
        plain.push(*token);
        let has_parameters = types.contains(token) && tokens.get(i + 1) == Some(&"<");
        i += if has_parameters {
            closing(&tokens[i..])
        } else {
            0
        } + 1;
    }
    plain
}

/// Shortens each path to its last name, and puts `f32` for the parameter `T`.
fn short<'a>(path: &[&'a str]) -> Tokens<'a> {
    let next = path.iter().skip(1).copied().chain([""]);
    let named = path
        .iter()
        .zip(next)
        .filter(|(token, next)| **token != "::" && *next != "::");
    named
        .map(|(token, _)| if *token == "T" { "f32" } else { token })
        .collect()
}

fn has(source: &[&str], wanted: &[&str]) -> bool {
    source.windows(wanted.len()).any(|window| window == wanted)
}

/// Whether `traits.rs` has a row in which this type implements this trait.
fn implements(rows: &[&str], of: &[&str], implemented: &[&str]) -> bool {
    if ["Serialize", "Deserialize"].contains(&implemented[0]) {
        return has(
            &tokens(TRAITS),
            &[&["survives", "::", "<"], of, &["<"]].concat(),
        );
    }
    let implemented = match implemented {
        ["StructuralPartialEq"] => &["PartialEq"],
        _ => implemented,
    };
    let row = [of, &[":"]].concat();
    let starts = rows.windows(row.len()).enumerate();
    let mut traits = starts.filter(|(_, window)| *window == row).map(|(i, _)| {
        let mut depth = 0; // of brackets: an array has a semicolon, too
        let is_end = |token: &&str| {
            depth += i32::from(*token == "[") - i32::from(*token == "]");
            *token == ";" && depth == 0
        };
        let traits = &rows[i + row.len()..];
        let end = traits.iter().position(is_end).unwrap_or(traits.len());
        &traits[..end]
    });
    traits.any(|traits| {
        traits
            .split(|token| *token == ",")
            .any(|one| one == implemented)
    })
}

/// Whether the source has a pattern or a value of this struct that names the field.
fn has_field(source: &[&str], of: &str, field: &str) -> bool {
    let mut structs = source
        .windows(2)
        .enumerate()
        .filter(|(_, pair)| *pair == [of, "{"]);
    structs.any(|(i, _)| {
        source[i..]
            .iter()
            .take_while(|token| **token != "}")
            .any(|token| *token == field)
    })
}

/// Whether the source names this item. A field and a variant have no kind.
fn names(source: &[&str], kind: Option<&str>, item: &[&str], types: &[&str]) -> bool {
    let number = item
        .windows(4)
        .find(|w| matches!(w, [_, "f32" | "f64" | "Fixed", ">", "::"]));
    let item = plain(item, types);
    let path = item
        .split(|token| ["(", "<", "=", ":"].contains(token))
        .next()
        .expect("a path");
    let [.., owner, _, name] = *path else {
        return true; // the crate itself
    };
    if path.contains(&"guide") {
        return true; // pages of the documentation
    }
    match (kind, number) {
        (Some("struct" | "enum" | "trait" | "mod"), _) => has(source, &[name]),
        (None, _) if item.get(path.len()) == Some(&":") => has_field(source, owner, name),
        (Some("type"), _) if ["f32", "f64", "fixed"].contains(&owner) => {
            has(source, &["module", "::", name])
        }
        (_, Some(number)) => [&[number[1]][..], &["$", "number"]].iter().any(|number| {
            let is_fixed = item.contains(&"Fixed") && number[0] == "$";
            !is_fixed
                && has(
                    source,
                    &[&[owner, "::", "<"], *number, &[">", "::", name]].concat(),
                )
        }),
        _ => {
            has(source, &[owner, "::", name])
                || has(source, &[owner, ">", "::", name])
                || has(source, &[owner, "<", "f32", ">", ">", "::", name])
        }
    }
}

/// The name in the line of a struct or an enum.
fn type_name<'a>(line: &Tokens<'a>) -> Option<&'a str> {
    let kind = line
        .iter()
        .position(|token| ["struct", "enum"].contains(token))?;
    let path = line[kind..]
        .split(|token| ["<", "("].contains(token))
        .next()?;
    path.last().copied()
}

#[test]
fn every_public_item_is_called() {
    let lines: Vec<Tokens> = INTERFACE.lines().map(tokens).collect();
    let types: Tokens = lines.iter().filter_map(type_name).collect();
    let source = plain(&tokens(SOURCE), &types);
    let rows = short(&tokens(TRAITS));
    let rows = [plain(&rows, &types), rows].concat();

    let mut implementor: &[&str] = &[]; // of the trait whose items follow
    let mut missing = Vec::new();
    for (line, text) in lines.iter().zip(INTERFACE.lines()) {
        let is_called = if line[0] == "impl" {
            let line = line
                .split(|token| *token == "where")
                .next()
                .expect("a header");
            let header = &line[if line[1] == "<" { closing(line) + 1 } else { 1 }..];
            let mut parts = header.split(|token| *token == "for");
            let implemented = parts.next().expect("a trait or a type");
            implementor = parts.next().unwrap_or_default();
            let [implemented, of] =
                [implemented, implementor].map(|path| short(&plain(path, &types)));
            of.is_empty() || implements(&rows, &of, &implemented)
        } else {
            let item = line.split(|token| *token == "pub").nth(1).expect("an item");
            let is_kind = |token: &&&str| KINDS.contains(token);
            let (kind, item) = item.split_at(item.iter().take_while(is_kind).count());
            let is_of_trait = !implementor.is_empty() && item.starts_with(implementor);
            is_of_trait || names(&source, kind.last().copied(), item, &types)
        };
        if !is_called {
            missing.push(text);
        }
    }
    assert!(missing.is_empty(), "not called:\n{}", missing.join("\n"));
}
