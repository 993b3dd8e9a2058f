//! Scene files of any bytes, in JSON, RON and postcard. Each gives an error that says where, or a
//! whole scene, which is written and read back unchanged. That what was read is valid needs no
//! check here: the constructors made it.
#![no_main]

use std::fmt::Debug;
use std::str;

use features::Scene;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| {
    match serde_json::from_slice::<Scene>(data) {
        Ok(scene) => {
            let text = serde_json::to_vec(&scene).expect("what was read can be written");
            is_unchanged(&scene, serde_json::from_slice(&text));
        }
        Err(error) => assert!(error.line() > 0),
    }
    if let Ok(text) = str::from_utf8(data) {
        match ron::from_str::<Scene>(text) {
            Ok(scene) => {
                let text = ron::to_string(&scene).expect("what was read can be written");
                is_unchanged(&scene, ron::from_str(&text));
            }
            Err(error) => assert!(error.span.end.line > 0),
        }
    }
    if let Ok(scene) = postcard::from_bytes::<Scene>(data) {
        let bytes = postcard::to_allocvec(&scene).expect("what was read can be written");
        is_unchanged(&scene, postcard::from_bytes(&bytes));
    }
});

/// `{:?}` shows all bits of a finite number.
fn is_unchanged<E: Debug>(written: &Scene, read: Result<Scene, E>) {
    let read = read.expect("it can be read back");
    assert_eq!(format!("{read:?}"), format!("{written:?}"));
}
