#!/usr/bin/env bash
# Builds the static library, compiles main.c against it, and runs the program.
set -euo pipefail
cd "$(dirname "$0")/../.."
cargo build --quiet --release -p from-c
"${CC:-cc}" -std=c99 -Wall -Wextra -Werror examples/from-c/main.c target/release/libshading_c.a \
    -lm -lpthread -ldl -o target/release/from-c
target/release/from-c
