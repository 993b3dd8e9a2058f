#!/usr/bin/env bash
# Checks the clients: their tests, each command of README.md but the shader's and its picture, and the page in a
# browser. Installs what is missing. With a folder, the page's screenshots go there.
set -euo pipefail
cd "$(dirname "$0")"
out=$PWD/target/pictures
mkdir -p "$out"

cargo fmt --all --check
cargo clippy --quiet --workspace --all-targets -- -D warnings
cargo test --quiet --workspace

cargo run --quiet --release -p rasterizer -- "$out/teapot.png"
for vectors in glam nalgebra; do
    cargo run --quiet --release -p tracer -- $vectors "$out/tracer_$vectors.png"
done
cargo run --quiet --release -p tracer --example many_lamps # fails if lanes draw another picture
bunny/frame.sh "$out/bunny.png"
web/test/run.sh "$@"

# refused with one line, and without a picture
refuses() {
    local status=0
    cargo run --quiet --release -p "$@" >target/out 2>target/message || status=$?
    [ "$status" = 1 ] && [ "$(wc -l <target/message)" = 1 ] && [ ! -s target/out ] || {
        echo "not refused as it should be (status $status): $*" >&2
        cat target/message >&2
        exit 1
    }
    cat target/message
}
printf 'v 0 0 0\nf 1 1 1\n' >target/point.obj
refuses tracer -- glam target/point.obj
refuses tracer -- nalgebra missing.obj
refuses tracer -- vek
refuses tracer -- glam target/no/such/folder.png
refuses rasterizer -- target/no/such/folder.png
