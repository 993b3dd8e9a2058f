#!/usr/bin/env bash
# Builds the pages into clients/target/web, from where any file server serves them: `web/build.sh --serve` does, at
# http://localhost:8000.
set -euo pipefail
cd "$(dirname "$0")/.."
. ../.ci/toolchain
target=wasm32-unknown-unknown
site=$PWD/target/web

rustup --quiet target add $target
rm -rf "$site"
mkdir -p "$site"/{demos,exercises,pictures}
cp web/site/{index.html,file.js} "$site"
cp web/site/demos/index.html "$site/demos"
cp web/site/exercises/index.html "$site/exercises"
command -v npm >/dev/null || install_packages nodejs npm
(cd web/test && npm ci --silent --no-audit --no-fund)
# one file for each page, one for the worker, and the style sheet
web/test/node_modules/.bin/esbuild --log-level=warning --bundle --minify --charset=utf8 --format=esm --outdir="$site" \
    --outbase=web/site web/site/{demos/page.js,exercises/{page,worker}.js,style.css}
cp ../docs/pictures/{gyroid,ks_and_m,teapot,the_sum,three_colors}.png "$site/pictures"
command -v wasm-opt >/dev/null || install_packages binaryen
built=${CARGO_TARGET_DIR:-target}/$target/release
features=(--enable-bulk-memory --enable-sign-ext --enable-nontrapping-float-to-int --enable-mutable-globals)
cargo build --quiet --package web --lib --release --target $target
wasm-opt -O2 "${features[@]}" "$built/web.wasm" -o "$site/demos/demos.wasm"
# it is fetched more often than it computes
CARGO_PROFILE_RELEASE_OPT_LEVEL=z cargo build --quiet --package exercises --release --target $target
# nothing is below 1024 but the last of the stack, which begins at a megabyte
wasm-opt -Oz --converge --low-memory-unused "${features[@]}" "$built/exercises.wasm" -o "$site/exercises/exercises.wasm"
wc -c "$site"/*/*.wasm
[ "${1-}" != --serve ] || exec python3 -m http.server --bind localhost --directory "$site"
