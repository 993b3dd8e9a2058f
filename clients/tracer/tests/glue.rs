//! The table of clients in `clients/README.md` tells the truth about their lines of glue.

use std::fs;
use std::path::Path;

/// The lines between the comments `// glue` and `// end of glue`.
fn glue(file: &str) -> usize {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(file);
    let text = fs::read_to_string(path).expect("a file of the clients");
    let from_begin = text.lines().skip_while(|line| !line.starts_with("// glue"));
    let lines = from_begin
        .skip(1)
        .take_while(|line| *line != "// end of glue");
    let count = lines.count();
    assert!(
        count > 0 && text.contains("// end of glue"),
        "{file} has no glue"
    );
    count
}

#[test]
fn table_counts_the_glue() {
    let readme = concat!(env!("CARGO_MANIFEST_DIR"), "/../README.md");
    let readme = fs::read_to_string(readme).expect("the README");
    let clients: [(&str, &[&str]); 4] = [
        ("`euc`", &["euc/src/lib.rs"]),
        ("`glam`", &["tracer/src/vector.rs", "tracer/src/on_glam.rs"]),
        (
            "`nalgebra`",
            &["tracer/src/vector.rs", "tracer/src/on_nalgebra.rs"],
        ),
        ("`embedded-graphics`", &["bunny/src/lib.rs"]),
    ];
    for (client, files) in clients {
        let lines: usize = files.iter().map(|file| glue(file)).sum();
        let is_row = |row: &&str| {
            row.starts_with("| ") && row.contains(client) && row.ends_with(&format!("| {lines} |"))
        };
        assert!(lines <= 15, "{client}: {lines} lines");
        assert!(
            readme.lines().any(|row| is_row(&row)),
            "{client}: {lines} lines"
        );
    }
}
