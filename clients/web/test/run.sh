#!/usr/bin/env bash
# Builds the page and tries it in headless Chromium; with a folder, writes screenshots there.
set -euo pipefail
cd "$(dirname "$0")"
command -v chromium >/dev/null || (. ../../../tests/firmware/toolchain.sh && install_packages chromium)
command -v npm >/dev/null || (. ../../../tests/firmware/toolchain.sh && install_packages nodejs npm)
npm ci --silent --no-audit --no-fund
../build.sh
cargo build --quiet --release --manifest-path ../Cargo.toml --bin draw
node page.mjs "${CARGO_TARGET_DIR:-$PWD/../../target}/release/draw" "$@"
