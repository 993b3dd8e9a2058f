//! The committed files are what the source gives.

use std::fs;
use std::path::Path;

#[test]
fn the_files_are_those_of_the_source() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    for (name, text) in shading_languages::files() {
        let committed = fs::read_to_string(folder.join(name)).unwrap();
        assert!(
            committed == text,
            "run `cargo run -p shading-languages`: {name} is old"
        );
    }
}

#[test]
fn the_library_for_arduino_has_the_files_for_c() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    for name in ["shading.h", "shading_fixed.h"] {
        assert!(
            fs::read(folder.join(name)).unwrap()
                == fs::read(folder.join("arduino/src").join(name)).unwrap(),
            "run `cargo run -p shading-languages`: the copy of {name} is old"
        );
    }
}
