//! Mistakes that newcomers make, and what the compiler says about them.
//!
//! Each program in `programs` makes one mistake, and the compiler's message stands beside it. A
//! comment names the attribute that this crate uses to improve the message, or says why the message
//! is left to the compiler.

use std::process::Command;

/// Half of each message comes from the compiler, and each version words it differently.
const COMPILER: &str = "rustc 1.95.0";

#[test]
fn messages_are_as_recorded() {
    let rustc = Command::new("rustc").arg("--version").output();
    let version = String::from_utf8(rustc.expect("rustc").stdout).expect("a version");
    assert!(
        version.starts_with(COMPILER),
        "the messages were recorded with {COMPILER}, and this is {version}\
        Run `cargo +1.95.0 test -p mistakes`. Or renew them: write the new version into\n\
        tests/mistakes/messages.rs, run `TRYBUILD=overwrite cargo test -p mistakes`, and read\n\
        `git diff tests/mistakes`: the notes of this crate must still be there."
    );
    trybuild::TestCases::new().compile_fail("programs/*.rs");
}
