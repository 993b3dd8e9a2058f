#!/usr/bin/env bash
# Checks the clients but the shader: their tests, each command of README.md, the chip's picture against this machine's, and
# the page in a browser. Installs what is missing. With a folder, the page's screenshots go there.
set -euo pipefail
pictures=${1:+$(realpath "$1")}
cd "$(dirname "$0")"
. ../tests/firmware/toolchain.sh
install_packages qemu-system-arm
command -v "${CHROMIUM:-chromium}" >/dev/null || install_packages chromium
command -v npm >/dev/null || install_packages nodejs npm
installer rustup --quiet target add thumbv7em-none-eabihf
built=${CARGO_TARGET_DIR:-$PWD/target}
mkdir -p "$built"

cargo fmt --check -p clients -p languages -p web
cargo clippy --quiet --workspace --all-targets -- -D warnings
cargo clippy --quiet -p languages --features python --lib -- -D warnings
cargo test --quiet --workspace

cargo build --quiet --release --workspace --bins
(cd "$built" && release/tracer && release/teapot && release/dispatch)

(cd chip && cargo fmt --check && cargo clippy --quiet --release -- -D warnings)
(cd chip && timeout 60 cargo run --quiet --release) >"$built/chip.txt"
cargo run --quiet --manifest-path chip/Cargo.toml | cmp - "$built/chip.txt"
[ "$(wc -l <"$built/chip.txt")" = 384 ] # twelve frames

languages/run.sh

(cd web/test && npm ci --silent --no-audit --no-fund)
web/build.sh
node web/test/page.mjs "$built/release/draw" $pictures
