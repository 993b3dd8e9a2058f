#!/usr/bin/env bash
# Proves what docs/proofs.md says, each part with the tool that the page names, and fails where one proves less. With `--all`, a
# fault planted in a copy of the source must refute each claim that names it, Bitwuzla repeats what takes it minutes,
# each wrong rule in a copy of the prover must be found, what is not recorded is tried with every number, and Coq checks the
# certificates of Gappa. The last lines say how long each part took. Installs what is missing.
set -euo pipefail
cd "$(dirname "$0")/.."
. .ci/toolchain
all=$([[ "${1:-}" == --all ]] && echo yes || true)
target=${CARGO_TARGET_DIR:-target}
work=$target/proofs
solver=$target/solver/bin/python
prover=$target/release/shading-proofs
times=()

part() { # NAME COMMAND…: runs a part, and remembers how long it took
    local start=$SECONDS
    echo "== $1"
    "${@:2}"
    times+=("$1: $((SECONDS - start)) s")
}

tools() {
    install_packages gappa python3-venv
    [[ -x $solver ]] || python3 -m venv "$target/solver"
    "$solver" -c "import bitwuzla" 2>/dev/null || "$solver" -m pip install -q bitwuzla==0.9.1
    cargo build --release -p shading-proofs
    rm -rf "$work"
    mkdir -p "$work"
}

# whether Gappa proves a script, without taking a rule whose sides are equal by definition or may divide by 0
gappa_proves() {
    gappa -Eprecision=150 -Echange-threshold=0.0001 "$1" 2>"$1.log" && ! grep -q "trivially equal\|nonzero" "$1.log"
}
export -f gappa_proves

bounds() {
    "$prover" bounds "$work/bounds"
    printf '%s\n' "$work"/bounds/*.g | xargs -P 2 -I{} bash -c 'gappa_proves {} || { echo "open: {}"; cat {}.log; exit 1; }'
    # half of a bound must not be proved
    "$prover" bounds "$work/half" 0.5
    printf '%s\n' "$work"/half/*_F32_*.g | xargs -P 2 -I{} bash -c \
        '! gappa -Eprecision=150 -Eno-auto-dichotomy {} 2>/dev/null || { echo "proved, but must not be: {}"; exit 1; }'
    echo "bounds: $(ls "$work"/bounds/*.g | wc -l) proved by Gappa"
}

# what Bitwuzla proves or repeats; with --all, also what takes it minutes
queries() {
    # shellcheck disable=SC2046 # one word per claim
    "$prover" queries "$work/queries" $("$prover" claims | sed -n 's/:.*bitwuzla$//p') \
        ${all:+blinn_normalization corner_of_none implicit_of_none sphere_of_none}
    "$solver" proofs/solve.py "$work/queries" "$([[ $all ]] && echo 600 || echo 120)"
}

copy() { # FOLDER: a copy of the crate and of this package, built on its own
    mkdir -p "$1/tests"
    cp -r src docs README.md Cargo.lock proofs "$1"
    cp -r tests/kit "$1/tests"
    sed -i '/^\[dev-dependencies/,/^$/d' "$1"/{proofs,tests/kit}/Cargo.toml
    rm "$1/proofs/tests/every.rs"
    cat >"$1/Cargo.toml" <<'END'
[package]
name = "shading"
version = "0.1.0"
edition = "2024"

[workspace]
members = ["proofs"]

[dependencies]
libm = "0.2.16"

[features]
fixed = []
serde = []
wide = []

[workspace.lints.rust]
END
}

faults() {
    copy "$work/faults"
    "$solver" proofs/plant.py proofs/faults.txt "$work/faults/src" >/dev/null
    RUSTFLAGS="--cap-lints allow" cargo build -q --release --manifest-path "$work/faults/proofs/Cargo.toml" --target-dir "$target/planted"
    "$solver" proofs/refute.py proofs/faults.txt "$target/planted/release/shading-proofs" "$work/refuted"
}

wrong_rules() {
    copy "$work/wrong"
    local count tests
    count=$("$solver" proofs/plant.py proofs/wrong_rules.txt "$work/wrong/proofs/src")
    (cd "$work/wrong" && RUSTFLAGS="--cap-lints allow" cargo test -q --release -p shading-proofs --no-run --target-dir target)
    tests=$(printf '%s\n' "$work"/wrong/target/release/deps/{ranges,prover,exhaustive}-* | grep -v '\.d$' | tr '\n' ' ')
    seq 0 $((count - 1)) | xargs -P 2 -I{} bash -c "for tests in $tests; do for test in \$(\$tests --list | sed -n 's/: test\$//p'); do
        PLANTED={} \$tests --exact \$test >/dev/null 2>&1 || exit 0; done; done; echo 'no test finds rule {}'; exit 1"
    echo "wrong rules: $count found"
}

# what is not recorded; fixed point with checks for overflow
every_number() {
    cargo test --release -p shading-proofs --test every --config profile.release.overflow-checks=true -- \
        --include-ignored --test-threads 2
}

integers() {
    "$prover" operands >"$work/operands"
    "$solver" proofs/fixed.py "$work/operands"
}

certificates() {
    install_packages coq libcoq-gappa
    # shellcheck disable=SC2016 # the inner shell expands it
    printf '%s\n' "$work"/bounds/*.g | xargs -P 2 -I{} bash -c 'script={}
        gappa -Eprecision=150 -Echange-threshold=0.0001 -Bcoq $script >${script%.g}.v 2>/dev/null
        coqc -q ${script%.g}.v >$script.coq 2>&1 || { echo "Coq does not check $script"; cat $script.coq; exit 1; }'
    echo "certificates: $(ls "$work"/bounds/*.vo | wc -l) checked by Coq"
}

part tools tools
part rules "$prover" prove
part bounds bounds
part queries queries
part integers integers
if [[ $all ]]; then
    part faults faults
    part "wrong rules" wrong_rules
    part "every number" every_number
    part certificates certificates
fi
printf '%s\n' "${times[@]}"
