#!/usr/bin/env bash
# Proves what docs/proofs.md tells of: by rules, by Gappa, and by Bitwuzla, which repeats only what a change touched, for
# three minutes. A fault planted in a copy of the source must refute each claim that names it. With `--all`, Bitwuzla repeats
# everything, each wrong rule in a copy of the prover must be found, and Coq checks the certificates of Gappa. The last lines say
# how long each part took. Installs what is missing.
set -euo pipefail
cd "$(dirname "$0")/.."
. .ci/toolchain
all=$([[ "${1:-}" == --all ]] && echo yes || true)
target=${CARGO_TARGET_DIR:-target}
work=$target/proofs
solver=$target/solver/bin/python
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

rules() { "$target/release/shading-proofs" prove | tee "$work/rules"; }

queries() {
    [[ -z $all ]] || : >proofs/answers.txt
    "$target/release/shading-proofs" queries "$work/queries"
    local bound name format
    for bound in "$work"/bounds/*.g; do # what Gappa proves is not asked
        bound=$(basename "$bound")
        rm -f "$work/queries/${bound%%.*}".*
    done
    "$solver" proofs/solve.py "$work/queries" proofs/answers.txt 180 "$([[ $all ]] && echo inf || echo 180)" "$work/left"
    while read -r name format; do
        grep "^$name $format " proofs/answers.txt | grep -q " proved$" || { echo "open: $name $format" && exit 1; }
    done <"$work/left"
}

gappa_proves() { # whether Gappa proves a script, and sees that both sides of each rule are equal
    gappa -Eprecision=150 -Echange-threshold=0.0001 "$1" 2>"$1.log" && ! grep -q "trivially equal\|nonzero" "$1.log"
}
export -f gappa_proves

bounds() {
    "$target/release/shading-proofs" bounds "$work/bounds"
    printf '%s\n' "$work"/bounds/*.g | xargs -P 2 -I{} bash -c 'gappa_proves {} || { echo "open: {}"; cat {}.log; exit 1; }'
    # half of a bound must not be proved
    "$target/release/shading-proofs" bounds "$work/half" 0.5
    printf '%s\n' "$work"/half/*.F32.g | xargs -P 2 -I{} bash -c \
        '! gappa -Eprecision=150 -Eno-auto-dichotomy {} 2>/dev/null || { echo "proved, but must not be: {}"; exit 1; }'
    # what neither the rules nor Gappa prove is left to Bitwuzla
    sed -n 's/^\(\w*\) \(F[0-9]*\): open.*/\1 \2/p' "$work/rules" | while read -r name format; do
        [[ -e $work/bounds/$name.0.$format.g ]] || echo "$name $format"
    done >"$work/left"
    echo "bounds: $(ls "$work"/bounds/*.g | wc -l) proved by Gappa"
}

copy() { # FOLDER: a copy of the crate and of this package, built on its own
    mkdir -p "$1"
    cp -r src docs README.md Cargo.lock proofs "$1"
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
    python3 proofs/plant.py proofs/faults.txt "$work/faults/src" lib.rs >/dev/null
    RUSTFLAGS="--cap-lints allow" cargo build -q --release --manifest-path "$work/faults/proofs/Cargo.toml" --target-dir "$target/planted"
    "$solver" proofs/refute.py proofs/faults.txt "$target/planted/release/shading-proofs" "$work/refuted"
}

wrong_rules() {
    copy "$work/wrong"
    local count tests
    count=$(python3 proofs/plant.py proofs/wrong_rules.txt "$work/wrong/proofs/src" lib.rs)
    (cd "$work/wrong" && RUSTFLAGS="--cap-lints allow" cargo test -q --release -p shading-proofs --no-run --target-dir target)
    tests=$(ls "$work"/wrong/target/release/deps/{prover,exhaustive}-* | grep -v '\.d$' | tr '\n' ' ')
    seq 0 $((count - 1)) | xargs -P 2 -I{} bash -c "for tests in $tests; do for test in \$(\$tests --list | sed -n 's/: test\$//p'); do
        PLANTED={} \$tests --exact \$test >/dev/null 2>&1 || exit 0; done; done; echo 'no test finds rule {}'; exit 1"
    echo "wrong rules: $count found"
}

certificates() {
    install_packages coq libcoq-gappa
    local script certified=0
    for script in "$work"/bounds/*.g; do
        gappa -Eprecision=150 -Echange-threshold=0.0001 -Bcoq "$script" >"${script%.g}.v" 2>/dev/null
        if timeout 120 coqc -q "${script%.g}.v" &>/dev/null; then
            certified=$((certified + 1))
        else
            echo "Coq does not check it in two minutes: $script"
        fi
    done
    echo "certificates: $certified checked by Coq"
}

part tools tools
part rules rules
part bounds bounds
part queries queries
part faults faults
if [[ $all ]]; then
    part "wrong rules" wrong_rules
    part certificates certificates
fi
printf '%s\n' "${times[@]}"
