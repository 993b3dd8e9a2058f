//! The mistakes that newcomers make, and what the compiler tells them.
//!
//! Each program of `tests/mistakes` makes one, and beside it stands the message. A comment says by
//! which attribute this crate improved the message, or why it is left to the compiler.

#![cfg(not(feature = "mint"))] // it adds to what the compiler lists

use std::process::Command;

/// Half of each message is the compiler's, and each version words it anew.
const COMPILER: &str = "rustc 1.95.0";

#[test]
#[ignore = "the messages are those of one version of the compiler"]
fn mistakes_are_told_as_recorded() {
    let rustc = Command::new("rustc").arg("--version").output();
    let version = String::from_utf8(rustc.expect("rustc").stdout).expect("a version");
    assert!(
        version.starts_with(COMPILER),
        "the messages were recorded with {COMPILER}, and this is {version}\
        Run `cargo +1.95.0 test --test mistakes -- --ignored`. Or renew them: write the new version into\n\
        tests/mistakes.rs, run `TRYBUILD=overwrite cargo test --test mistakes -- --ignored`, and read\n\
        `git diff tests/mistakes`: the notes of this crate must still be there."
    );
    trybuild::TestCases::new().compile_fail("tests/mistakes/*.rs");
}
