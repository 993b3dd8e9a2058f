#!/usr/bin/env bash
# Builds the library, and shades the same scene from C, C++, Python and JavaScript. Each program compares every bit with the
# crate's and races against the same formulas in its own language. Installs what it needs.
set -euo pipefail
cd "$(dirname "$0")/../.."
. tests/firmware/toolchain.sh
command -v g++ >/dev/null || install_packages g++
command -v node >/dev/null || install_packages nodejs
installer rustup --quiet target add wasm32-unknown-unknown

cargo build --quiet --release -p languages
cargo build --quiet --release -p languages --lib --target wasm32-unknown-unknown
built=target/release work=target/languages
"$built/scene" "$work"

here=examples/languages flags=(-O3 -Wall -Wextra -Wpedantic -Werror)
# the static library from C, the dynamic one from C++
cc -std=c11 "${flags[@]}" "$here/main.c" "$built/libshading_c.a" -lm -lpthread -ldl -o "$work/from-c"
c++ -std=c++17 "${flags[@]}" "$here/main.cpp" -L "$built" -lshading_c -Wl,-rpath,"$PWD/$built" -o "$work/from-c++"
"$work/from-c" "$work"
"$work/from-c++" "$work"

[ -x "$work/python/bin/python" ] || python3 -m venv "$work/python"
"$work/python/bin/pip" --quiet --disable-pip-version-check install 'numpy>=2,<3' 'pillow>=11,<13'
"$work/python/bin/python" "$here/main.py" "$built/libshading_c.so" "$work"

node "$here/main.mjs" target/wasm32-unknown-unknown/release/shading_c.wasm "$work"
