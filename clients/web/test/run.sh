#!/usr/bin/env bash
# Builds the page and tries it in headless Chromium; with a folder, screenshots go there.
set -euo pipefail
pictures=${1:+$(realpath "$1")}
cd "$(dirname "$0")"
. ../../../tests/firmware/toolchain.sh

command -v "${CHROMIUM:-chromium}" >/dev/null || install_packages chromium
command -v npm >/dev/null || install_packages nodejs npm
npm ci --silent --no-audit --no-fund
../build.sh
cargo build --quiet --release --manifest-path ../Cargo.toml --bin draw
node page.mjs "${CARGO_TARGET_DIR:-$PWD/../../target}/release/draw" $pictures
