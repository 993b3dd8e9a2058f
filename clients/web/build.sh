#!/usr/bin/env bash
# Builds the page into clients/target/web, from where any file server serves it: `web/build.sh --serve` does, at
# http://localhost:8000.
set -euo pipefail
cd "$(dirname "$0")/.."
target=wasm32-unknown-unknown
page=$PWD/target/web

rustup --quiet target add $target
mkdir -p "$page"
cp web/site/* "$page"
cargo build --quiet --package web --lib --release --target $target
cp "${CARGO_TARGET_DIR:-target}/$target/release/web.wasm" "$page"
wc -c "$page/web.wasm"
[ "${1-}" != --serve ] || exec python3 -m http.server --bind localhost --directory "$page"
