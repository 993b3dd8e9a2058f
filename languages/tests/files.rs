//! The committed files are what the source gives.

#[test]
fn the_files_are_those_of_the_source() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    for (name, text) in shading_languages::files() {
        let committed = std::fs::read_to_string(folder.join(name)).unwrap();
        assert!(
            committed == text,
            "run `cargo run -p shading-languages`: {name} is old"
        );
    }
}
