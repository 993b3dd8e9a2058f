#!/usr/bin/env bash
# Races the loops of the working tree against those of a commit, both in one program: benches/slower.sh COMMIT. Fails if a
# loop takes more than 1.05 of its former time.
set -euo pipefail
cd "$(dirname "$0")/.."
commit=$(git rev-parse --verify "$1^{commit}")
mkdir -p target/slower
cat >target/slower/Cargo.toml <<END
[package]
name = "slower"
edition = "2024"

[[bin]]
name = "slower"
path = "$PWD/benches/slower.rs"

[dependencies]
shading.path = "$PWD"
before = { package = "shading", git = "file://$(git rev-parse --path-format=absolute --git-common-dir)", rev = "$commit" }
fastrand = "2"

[workspace]
END
cargo run --release --manifest-path target/slower/Cargo.toml "${@:2}"
