#!/usr/bin/env bash
# Checks the clients, or some of them: `run.sh [programs] [chip] [languages] [page] [shader]`. Without a name, it checks all but
# the shader, whose compiler takes a quarter of an hour to build. Installs what is missing. PICTURES names a folder for the
# pages' screenshots; DEVICE is the number of the Vulkan device, 0 if nothing is said: Mesa's, where no driver is installed.
set -euo pipefail
cd "$(dirname "$0")"
. ../.ci/toolchain
built=${CARGO_TARGET_DIR:-$PWD/target}
mkdir -p "$built"

programs() {
    cargo fmt --check -p clients -p languages -p web -p exercises
    cargo clippy --quiet --workspace --all-targets -- -D warnings
    cargo clippy --quiet -p languages --features python --lib -- -D warnings
    cargo test --quiet --workspace
    cargo build --quiet --release --bins
    (cd "$built" && release/tracer && release/teapot && release/dispatch)
}

# the ball on the emulated chip has the bits that it has here, in fixed point and in f32; and the ring has them on the bus of
# its display, with and without an FPU
chip() {
    install_packages qemu-system-arm
    local targets="thumbv7em-none-eabihf thumbv6m-none-eabi" target
    # shellcheck disable=SC2086 # one word per target
    installer rustup --quiet target add $targets
    (cd chip && cargo fmt --check)
    local number
    for number in fixed ""; do
        (cd chip && cargo clippy --quiet --release --features "$number" -- -D warnings)
        (cd chip && timeout 60 cargo run --quiet --release --features "$number") >"$built/chip.txt"
        cargo run --quiet --manifest-path chip/Cargo.toml --features "$number" | cmp - "$built/chip.txt"
    done
    [ "$(wc -l <"$built/chip.txt")" = 384 ] # twelve frames

    cargo run --quiet --manifest-path chip/Cargo.toml --bin ring -- "$built/ring.png" >"$built/ring.txt"
    cmp "$built/ring.png" ../docs/pictures/ring.png
    [ "$(wc -l <"$built/ring.txt")" = 4 ]
    for target in $targets; do
        (cd chip && timeout 60 cargo run --quiet --release --bin ring --target $target) | tee "$built/chip.txt"
        sed 's/,.*//' "$built/chip.txt" | cmp - "$built/ring.txt"
        # no frame takes more than 9 million instructions, and none computes in floating point
        awk '{ if ($4 > 9000) exit 1 }' "$built/chip.txt"
        ! readelf --symbols --wide "chip/target/$target/release/ring" | grep -E ' __aeabi_(c?[df][a-z]+|[a-z]+2[df]|[df]2[a-z]+)$' || exit 1
    done
}

# the same scene from C, C++, JavaScript and Python: each bit is the crate's
languages() {
    command -v g++ >/dev/null || install_packages g++
    command -v npm >/dev/null || install_packages nodejs npm
    installer rustup --quiet target add wasm32-unknown-unknown
    local work=$built/languages
    mkdir -p "$work"
    cargo build --quiet --release -p languages
    cargo build --quiet --release -p languages --lib --target wasm32-unknown-unknown
    "$built/release/scene" "$work/expected"

    # the static library from C, the dynamic one from C++
    local flags=(-O3 -Wall -Wextra -Wpedantic -Werror)
    cc -std=c11 "${flags[@]}" languages/main.c "$built/release/libshading_c.a" -lm -lpthread -ldl -o "$work/c"
    c++ -std=c++17 "${flags[@]}" languages/main.cpp -L "$built/release" -lshading_c -Wl,-rpath,"$built/release" -o "$work/c++"
    draws_the_same C "$work/c"
    draws_the_same C++ "$work/c++"

    # the npm package: its tests and types, from the module that cargo has built
    (cd languages/javascript && npm ci --silent --no-audit --no-fund && CARGO_TARGET_DIR=$built npm run --silent build && npm test --silent)
    draws_the_same JavaScript node languages/main.mjs

    # the wheel, from a copy of the folder that stands alone: its tests, its types and the notebook
    local python=$work/python/bin/python
    [ -x "$python" ] || python3 -m venv "$work/python"
    rm -rf "$work/copy"
    cp -r languages "$work/copy"
    sed -i "s#path = \"../..\"#path = \"$(realpath ..)\"#" "$work/copy/Cargo.toml"
    echo "[workspace]" >>"$work/copy/Cargo.toml"
    CARGO_TARGET_DIR=$built/wheel "$python" -m pip --quiet --disable-pip-version-check install "$work/copy[notebook,test]"
    draws_the_same Python "$python" languages/main.py
    (cd "$work/copy" && "$python" -m pytest --quiet -p no:cacheprovider)
    (cd "$work/copy" && "$python" -m mypy --no-error-summary python/shading python/tests)
    "$python" -c 'import nbclient, nbformat; nbclient.NotebookClient(nbformat.read("languages/shading.ipynb", 4),
        resources={"metadata": {"path": "languages"}}).execute()'
}

# draws_the_same LANGUAGE COMMAND...: the command writes the colors to the file that follows it
draws_the_same() {
    "${@:2}" "$built/languages/from-$1"
    cmp "$built/languages/from-$1" "$built/languages/expected"
    echo "$1: every bit is the crate's"
}

# the pages in a browser
page() {
    command -v "${CHROMIUM:-chromium}" >/dev/null || install_packages chromium
    command -v npm >/dev/null || install_packages nodejs npm
    (cd web/test && npm ci --silent --no-audit --no-fund)
    web/build.sh
    cargo build --quiet --release -p web --bin draw
    node web/test/demos.mjs "$built/release/draw" ${PICTURES:+"$(realpath "$PICTURES")"}
    node web/test/exercises.mjs ${PICTURES:+"$(realpath "$PICTURES")"}
}

# every function and a scene on a Vulkan device
shader() {
    local toolchain=nightly-2026-08-15 module=$built/kernel.spv # the toolchain that rust-gpu 0.11 is written for
    install_packages spirv-tools libvulkan1 mesa-vulkan-drivers
    rustup toolchain list | grep -q "^$toolchain" ||
        installer rustup toolchain install $toolchain --profile minimal --no-self-update \
            --component rust-src --component rustc-dev --component llvm-tools
    (cd shader && cargo fmt --check && cargo clippy --quiet --lib --bins -- -D warnings)
    (cd shader && cargo +$toolchain run --quiet --release --example compiler -- "$module")
    local unwanted
    for unwanted in Float64 Int64 Int8 Fma; do
        ! spirv-dis "$module" | grep --word-regexp "$unwanted" || { echo "the module needs $unwanted" >&2; exit 1; }
    done
    (cd shader && cargo run --quiet --release -- "$module" "${DEVICE:-0}")
}

[ $# -gt 0 ] || set -- programs chip languages page
for step in "$@"; do
    echo "== $step"
    $step
done
