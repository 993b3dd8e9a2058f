#!/usr/bin/env bash
# Builds the library, shades the same scene from C, C++, JavaScript and Python, and compares each bit with the crate's.
# Installs what it needs.
set -euo pipefail
cd "$(dirname "$0")"
. ../../tests/firmware/toolchain.sh
command -v g++ >/dev/null || install_packages g++
command -v node >/dev/null || install_packages nodejs
installer rustup --quiet target add wasm32-unknown-unknown

built=${CARGO_TARGET_DIR:-$PWD/../target}
work=$built/languages
mkdir -p "$work"
cargo build --quiet --release
cargo build --quiet --release --lib --target wasm32-unknown-unknown
"$built/release/scene" "$work/expected"

# check LANGUAGE COMMAND...: the command writes the colors to the file that follows it
check() {
    "${@:2}" "$work/from-$1"
    cmp "$work/from-$1" "$work/expected"
    echo "$1: every bit is the crate's"
}
flags=(-O3 -Wall -Wextra -Wpedantic -Werror)
# the static library from C, the dynamic one from C++
cc -std=c11 "${flags[@]}" main.c "$built/release/libshading_c.a" -lm -lpthread -ldl -o "$work/c"
c++ -std=c++17 "${flags[@]}" main.cpp -L "$built/release" -lshading_c -Wl,-rpath,"$built/release" -o "$work/c++"
check C "$work/c"
check C++ "$work/c++"
check JavaScript node main.mjs "$built/wasm32-unknown-unknown/release/shading_c.wasm"

# the wheel, from a copy of this folder that stands alone
python=$work/python/bin/python
[ -x "$python" ] || python3 -m venv "$work/python"
rm -rf "$work/copy"
mkdir "$work/copy"
cp -r Cargo.toml pyproject.toml src shading.ipynb "$work/copy"
sed -i "s#path = \"../..\"#path = \"$(realpath ../..)\"#" "$work/copy/Cargo.toml"
echo "[workspace]" >>"$work/copy/Cargo.toml"
CARGO_TARGET_DIR=$built/wheel "$python" -m pip --quiet --disable-pip-version-check install "$work/copy" pillow nbclient ipykernel
cat >"$work/notebook.py" <<'PYTHON'
import sys, nbformat, nbclient
notebook = nbformat.read("shading.ipynb", as_version=4)
notebook.cells.append(nbformat.v4.new_code_cell(f"colors.tofile({sys.argv[1]!r})"))
nbclient.NotebookClient(notebook).execute()
PYTHON
check Python "$python" "$work/notebook.py"
"$python" -c 'import shading; assert all("shape (..., 3)" in f.__doc__ for f in (shading.shade, shading.to_srgb8))'
