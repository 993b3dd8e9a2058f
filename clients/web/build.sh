#!/usr/bin/env bash
# Builds the page into clients/target/web, from where any file server serves it: with SIMD, and without for
# browsers that have none.
set -euo pipefail
cd "$(dirname "$0")/.."
target=wasm32-unknown-unknown
build=${CARGO_TARGET_DIR:-$PWD/target}
page=$PWD/target/web

rustup --quiet target add $target
mkdir -p "$page"
cp web/site/* "$page"
# build NAME FLAGS
build() {
    RUSTFLAGS=$2 cargo build --package web --lib --profile page --target $target --target-dir "$build/web-$1"
    cp "$build/web-$1/$target/page/web.wasm" "$page/$1.wasm"
}
build simd "-C target-feature=+simd128"
build scalar ""
wc -c "$page"/*.wasm
echo "wrote $page"
