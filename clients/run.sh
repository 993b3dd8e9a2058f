#!/usr/bin/env bash
# Checks the clients, or some of them:
# `run.sh [programs] [chip] [languages] [page] [gpu] [packages] [javascript] [bench] [firefox]`.
# Without a name, it checks the first four: `gpu` compiles wgpu. `packages` builds what a
# release of the languages consists of, `javascript` tries the npm package in versions of Node.js, a bundler and a browser,
# `bench` measures beside NumPy, numba and jax, and `firefox` tries the page of exercises in that browser. Installs what is
# missing. PICTURES names a folder for the pages' screenshots.
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
    local work=$built/languages
    mkdir -p "$work"
    cargo build --quiet --release -p languages
    "$built/release/scene" "$work/expected"

    # the static library from C, the dynamic one from C++
    local flags=(-O3 -Wall -Wextra -Wpedantic -Werror)
    cc -std=c11 "${flags[@]}" languages/main.c "$built/release/libshading_c.a" -lm -lpthread -ldl -o "$work/c"
    c++ -std=c++17 "${flags[@]}" languages/main.cpp -L "$built/release" -lshading_c -Wl,-rpath,"$built/release" -o "$work/c++"
    draws_the_same C "$work/c"
    draws_the_same C++ "$work/c++"
    "$work/c" "$work/dome.ppm"
    [ "$(stat --format %s "$work/dome.ppm")" = 12301 ] # a header of 13 bytes, and 64 × 64 pixels of 3

    packages
    # each point has the bits that it has alone, in the lanes of WebAssembly, too
    installer rustup --quiet target add wasm32-wasip1
    CARGO_TARGET_DIR=$built/lanes RUSTFLAGS=-Ctarget-feature=+simd128 \
        CARGO_TARGET_WASM32_WASIP1_RUNNER="node --no-warnings $(realpath ../.ci/wasi.mjs)" \
        cargo test --quiet -p languages --lib --target wasm32-wasip1
    draws_the_same JavaScript node "$work/npm/main.mjs"
    (cd "$work/npm" && INTERFACE=$PWD/../interface.json npm test --silent)
    local python=$work/python/bin/python
    draws_the_same Python "$python" languages/main.py
    "$python" -m pip --quiet --disable-pip-version-check install hypothesis mypy pytest ipykernel nbclient pillow
    (cd languages && "$python" -m pytest --quiet -p no:cacheprovider)
    (cd languages && "$python" -m mypy --no-error-summary --cache-dir "$work/mypy" python/shading python/tests)
    "$python" -c 'import nbclient, nbformat; nbclient.NotebookClient(nbformat.read("languages/shading.ipynb", 4),
        resources={"metadata": {"path": "languages"}}).execute()'
    local recipe
    for recipe in languages/recipes/*.py; do
        (cd "$work" && "$python" "$OLDPWD/$recipe")
    done
}

# The wheel and the npm package, for a release, in target/languages/packages; and each in an empty environment, without Rust.
packages() {
    command -v npm >/dev/null || install_packages nodejs npm
    installer rustup --quiet target add wasm32-unknown-unknown
    local work=$built/languages
    local out=$work/packages
    rm -rf "$out" "$work/python" "$work/npm"
    mkdir -p "$out" "$work/npm"
    cp languages/interface.json "$work"
    CARGO_TARGET_DIR=$built/wheel python3 -m pip --quiet --disable-pip-version-check wheel --no-deps --wheel-dir "$out" ./languages
    (cd languages/javascript && CARGO_TARGET_DIR=$built npm run --silent build && npm pack --silent --pack-destination "$out")
    ls "$out"

    python3 -m venv "$work/python"
    without_rust "$work/python/bin/python" -m pip --quiet --disable-pip-version-check install --only-binary :all: "$out"/*.whl
    cp languages/javascript/test/* languages/main.mjs languages/page.html "$work/npm"
    (cd "$work/npm" && npm ci --silent --no-audit --no-fund &&
        without_rust npm install --silent --no-save --no-audit --no-fund "$out"/*.tgz)
}

# without_rust COMMAND...: where neither cargo nor rustc is found
without_rust() {
    local path
    path=$(tr : '\n' <<<"$PATH" | while read -r folder; do
        [ -x "$folder/cargo" ] || [ -x "$folder/rustc" ] || echo "$folder"
    done | paste --serial --delimiters :)
    PATH=$path "$@"
}

# the npm package in each supported version of Node.js, in a bundler, and in a browser without one
javascript() {
    command -v "${CHROMIUM:-chromium}" >/dev/null || install_packages chromium
    packages
    local work=$built/languages/npm version
    for version in 18 20 22; do
        (cd "$work" && npx --yes --package "node@$version" -- node -e '
            const { load, directional } = require("shading");
            const sun = directional({ toward: [0, 0, 1] });
            const scene = { points: [0, 0, 0], normals: [0, 0, 1], eye: [0, 0, 5], lights: sun, k_d: 0.5 };
            Promise.all([load(), import("shading").then((module) => module.load())]).then((both) => {
                for (const { shade } of both) if (shade(scene)[1] !== 0.5) process.exit(1);
                console.log(`Node.js ${process.version}: require and import`);
            });')
    done

    # vite says nothing about modules of Node.js
    mkdir -p "$work/bundle"
    sed 's#./node_modules/shading/index.js#shading#' "$work/page.html" >"$work/bundle/index.html"
    (cd "$work" && npx --yes vite@6 build --target es2022 bundle 2>&1) | tee "$built/vite.txt"
    ! grep --ignore-case -E 'node:|externalized|warn' "$built/vite.txt" || exit 1

    local server port=8765 folder
    for folder in "$work" "$work/bundle/dist"; do
        local page=page.html
        [ -e "$folder/page.html" ] || page=index.html
        python3 -m http.server --bind localhost --directory "$folder" $port >/dev/null 2>&1 &
        server=$!
        sleep 1
        "${CHROMIUM:-chromium}" --headless --no-sandbox --disable-gpu --virtual-time-budget=20000 --dump-dom \
            "http://localhost:$port/$page" 2>/dev/null >"$built/page.txt" || true
        kill $server
        grep --only-matching 'pixel 104 95 85 255' "$built/page.txt"
        port=$((port + 1))
    done
}

# beside NumPy, numba and jax, in one run
bench() {
    packages
    local python=$built/languages/python/bin/python
    "$python" -m pip --quiet --disable-pip-version-check install numba jax
    "$python" languages/bench.py
    (cd "$built/languages/npm" && cp ../../../languages/bench.mjs . && node bench.mjs)
}

# draws_the_same LANGUAGE COMMAND...: the command writes the colors to the file that follows it
draws_the_same() {
    "${@:2}" "$built/languages/from-$1"
    cmp "$built/languages/from-$1" "$built/languages/expected"
    echo "$1: every bit is the crate's"
}

# the page of exercises in Firefox
firefox() {
    command -v firefox-esr >/dev/null || install_packages firefox-esr
    web/build.sh
    node web/test/firefox.mjs
}

# the pages in a browser
page() {
    command -v "${CHROMIUM:-chromium}" >/dev/null || install_packages chromium
    web/build.sh
    cargo build --quiet --release -p web --bin draw --bin normals
    node web/test/demos.mjs "$built/release/draw" ${PICTURES:+"$(realpath "$PICTURES")"}
    node web/test/exercises.mjs "$built/release/normals" ${PICTURES:+"$(realpath "$PICTURES")"}
}

# the files of languages/: a ball and a teapot in C, C++, Metal (as C++), GLSL, HLSL and WGSL; every function in WGSL, GLSL, HLSL
# and Metal, also with extreme numbers; the laws on C and WGSL
gpu() {
    install_packages gcc g++ glslang-tools spirv-tools libvulkan1 mesa-vulkan-drivers
    command -v "${CHROMIUM:-chromium}" >/dev/null || install_packages chromium
    local work=$built/gpu files=../languages shaders=gpu/shaders power language how
    mkdir -p "$work"
    (cd gpu && cargo fmt --check && cargo clippy --quiet -- -D warnings && cargo build --quiet)
    local program=${CARGO_TARGET_DIR:-gpu/target}/debug/gpu
    "$program" scene "$work"

    local flags=(-O2 -ffp-contract=off -Wall -Wextra -pedantic -Wdouble-promotion -Werror -I "$files")
    gcc -std=c99 "${flags[@]}" $shaders/scene.c -o "$work/c" -lm
    g++ -x c++ -std=c++11 "${flags[@]}" $shaders/scene.c -o "$work/c++"
    touch "$work/metal_stdlib" # the shim has what the file needs of it
    g++ -x c++ -std=c++11 -O2 -ffp-contract=off -DMETAL -DSHADING_EXACT_POWER -I "$work" -I "$files" $shaders/scene.c -o "$work/metal"
    for language in c c++ metal; do
        "$work/$language" <"$work/scene.bin" >"$work/$language.bin"
        "$program" compare "$work/$language.bin" exact
    done

    # the laws hold, and do not where a reflection is wrong
    gcc -std=c99 "${flags[@]}" $shaders/laws.c -o "$work/laws" -lm
    "$program" laws "$work/laws"
    mkdir -p "$work/mistaken"
    sed 's/n_dot_w + n_dot_w/n_dot_w/' "$files/shading.h" >"$work/mistaken/shading.h"
    gcc -std=c99 -I "$work/mistaken" "${flags[@]}" $shaders/laws.c -o "$work/mistaken/laws" -lm
    "$program" laws "$work/mistaken/laws" mistaken

    for power in "" "#define SHADING_EXACT_POWER"; do
        for language in "#version 300 es" "#version 330"; do
            { printf '%s\nprecision highp float;\n%s\n' "$language" "$power" && cat "$files/shading.glsl" $shaders/scene.frag; } >"$work/scene.frag"
            glslangValidator "$work/scene.frag"
        done
        how=$([ -n "$power" ] && echo exact || echo nearly)
        in_a_browser "$power" "$how"
        for language in hlsl metal; do XDG_RUNTIME_DIR=$work "$program" $language "$work" "$how"; done
        { echo "$power" && cat $shaders/scene.hlsl; } >"$work/scene.hlsl"
        glslangValidator -D -S comp -e main -V -I"$files" "$work/scene.hlsl" -o "$work/scene.spv"
        spirv-val "$work/scene.spv"
    done
    XDG_RUNTIME_DIR=$work "$program" run "$work/scene.spv"
}

# in_a_browser POWER HOW: the scene and every function in GLSL with one of its powers, by WebGL without a GPU
in_a_browser() {
    local head
    head=$(printf '#version 300 es\nprecision highp float;\n%s\n' "$1" && cat "$files/shading.glsl")
    {
        echo '<pre id="scene">' && base64 "$work/scene.bin" && echo '</pre><script type="text/plain" id="shader">'
        echo "$head" && cat $shaders/webgl.frag && echo '</script>' && cat $shaders/webgl.html
    } >"$work/webgl.html"
    answer_of_a_browser webgl
    "$program" compare "$work/webgl.bin" "$2"
    {
        echo '<body><script type="text/plain" id="file">' && echo "$head" && echo '</script>'
        "$program" calls && cat $shaders/rows.html
    } >"$work/rows.html"
    answer_of_a_browser rows
    "$program" answers "$work/rows.bin" "$2"
}

# answer_of_a_browser PAGE: what the page writes into its result
answer_of_a_browser() {
    "${CHROMIUM:-chromium}" --headless --no-sandbox --use-angle=swiftshader --enable-unsafe-swiftshader \
        --virtual-time-budget=60000 --dump-dom "file://$(realpath "$work/$1.html")" 2>/dev/null |
        sed -n 's#^<pre id="result">\(.*\)</pre>$#\1#p' | base64 --decode >"$work/$1.bin"
}

[ $# -gt 0 ] || set -- programs chip languages page
for step in "$@"; do
    echo "== $step"
    $step
done
