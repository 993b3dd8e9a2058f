#!/usr/bin/env bash
# Tries each renderer by the laws, or only those that you name: `run.sh mesa chip`. Fails if the outcome of a law is not
# that of expected.txt. The reports are in target/reports. Installs what is missing.
set -euo pipefail
cd "$(dirname "$0")"
. ../../.ci/toolchain
mkdir -p target/reports
cargo fmt --check -p chip -p shader

# Each function builds a renderer and hands the command that starts it to `judge`.

# Judges a host in Python, with the packages of all of them, after the options for the program.
judge_python() {
    install_packages libosmesa6 python3-venv
    [ -x target/python/bin/pip ] || python3 -m venv target/python
    target/python/bin/pip install --quiet --disable-pip-version-check --no-deps --requirement python/requirements.txt
    judge "$@" -- target/python/bin/python "python/$renderer.py"
}

mesa() { judge_python; }

vtk() { judge_python; }

povray() {
    install_packages povray
    judge_python --cases 256 # a picture of POV-Ray takes at least a third of a second
}

chip() {
    cargo clippy --quiet -p chip -- -D warnings
    cargo build --quiet --release -p chip
    judge -- target/release/chip
}

shader() {
    install_packages libvulkan1 mesa-vulkan-drivers
    export XDG_RUNTIME_DIR=${XDG_RUNTIME_DIR:-$PWD/target} # Mesa asks for it
    cargo clippy --quiet -p shader --all-targets -- -D warnings
    cargo test --quiet --release -p shader # it needs no pipe: its test has the outcome of each law
}

web() {
    command -v "${CHROMIUM:-chromium}" >/dev/null || install_packages chromium
    command -v npm >/dev/null || install_packages nodejs npm
    npm ci --prefix web --silent --no-audit --no-fund --ignore-scripts
    judge --timeout 60 -- node web/host.mjs
}

# the same, but it says that it clamps, and that a light behind the surface has a highlight
web_said() {
    judge --timeout 60 -- node web/host.mjs '{"clamps":[0,1],"departs":["HighlightNotGated"]}'
}

# Runs the laws on a command, with the options before `--`, and compares the outcome of each with the expected one, and the
# colors of scenes that are worked out by hand with those that the pages state.
judge() {
    local report=target/reports/$renderer.txt status=0
    cargo run --quiet --release --manifest-path ../Cargo.toml -- "$@" >"$report" || status=$?
    [ "$status" -le 1 ] || exit "$status"
    sed -nE "s/^(\w+) holds in [0-9]+ cases$/$renderer \1 holds/p; s/^(\w+) is BROKEN .*/$renderer \1 broken/p" "$report" |
        diff --unified=0 --label expected --label found <(grep "^$renderer " expected.txt) - || failed=1
    grep --after-context=3 "^Finding" "$report" || true
    while [ "$1" != -- ]; do shift; done
    python3 claims.py "$renderer" "${@:2}" || failed=1
}

renderers=(mesa chip shader web web_said vtk povray)
failed=0
for renderer in "${@:-"${renderers[@]}"}"; do
    [[ " ${renderers[*]} " == *" $renderer "* ]] || {
        echo "there is no renderer $renderer; the renderers are: ${renderers[*]}" >&2
        exit 2
    }
    printf '\n== %s\n' "$renderer"
    SECONDS=0
    "$renderer"
    echo "== $renderer: $SECONDS s"
done
exit $failed
