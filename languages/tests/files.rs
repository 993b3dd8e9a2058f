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

#[test]
fn each_name_of_the_books_names_something() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let [names, file] = ["src/names.txt", "shading_exact.wgsl"]
        .map(|name| fs::read_to_string(folder.join(name)).unwrap());
    let mut count = 0;
    for section in names.split("\n[").skip(1) {
        let (title, lines) = section.split_once("]\n").expect("a title");
        let beginning = format!("shading_{title}");
        let functions = || {
            file.split("\nfn ")
                .filter(|text| text.starts_with(&beginning))
        };
        for line in lines.lines().filter(|line| !line.is_empty()) {
            let (name, _) = line.split_once(" = ").expect("a name and its formula");
            let declared = format!("    let {name} = ");
            assert!(
                functions().any(|function| function.contains(&declared)),
                "{title}: {name}"
            );
            count += 1;
        }
    }
    assert!(count > 100);
}
