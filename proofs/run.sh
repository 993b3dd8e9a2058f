#!/usr/bin/env bash
# Proves what docs/proofs.md lists and tests the prover. It plants faults in a copy of the source, each of which must make a
# claim fail, and wrong rules in the prover, each of which its tests must find. With `--all` it tests the prover with
# ten times as many numbers, and proves the integers of `Fixed` and the power by a real m; with `--coq`, Coq checks what
# Gappa proves. The last line says how many claims were proved, by which means, and how many are open. Installs what is missing.
set -euo pipefail
cd "$(dirname "$0")/.."
. tests/firmware/toolchain.sh
install_packages gappa python3-venv
solver=${CARGO_TARGET_DIR:-target}/solver
[[ -x "$solver/bin/pip" ]] || python3 -m venv "$solver"
"$solver/bin/python" -c "import bitwuzla" 2>/dev/null || "$solver/bin/pip" install -q bitwuzla==0.9.1

runs=20
[[ "${1:-}" == --all ]] && runs=200
cargo build --release -p shading-proofs
prover="${CARGO_TARGET_DIR:-target}/release/shading-proofs"
"$prover" check "$runs"

# faults planted in a copy of the source, which is built once with all of them
copy=${CARGO_TARGET_DIR:-target}/planted
rm -rf "$copy"/{src,proofs} && mkdir -p "$copy/docs"
cp -r src proofs "$copy"
cp docs/*.md README.md "$copy" && cp docs/*.md "$copy/docs"
cp -r --parents tests/bits/interface.rs tests/public-api/interface.txt "$copy"
"$prover" plant "$copy"
cat >"$copy/Cargo.toml" <<'END'
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

[workspace.lints.rust]
END
cp Cargo.lock "$copy"
RUSTFLAGS="--cap-lints allow" cargo build -q --release --manifest-path "$copy/proofs/Cargo.toml" --target-dir "$copy/target"
"$prover" faults "$copy/target/release/shading-proofs"

# the error bounds, which Gappa proves
scripts=${CARGO_TARGET_DIR:-target}/bounds
rm -rf "$scripts"
"$prover" bounds "$scripts"
proves() { # whether Gappa proves a script, and sees that both sides of each rule are equal
    gappa -Eprecision=150 -Echange-threshold=0.0001 "$1" 2>"$scripts/log" && ! grep -q "trivially equal\|nonzero" "$scripts/log"
}
proved=0 open=0
for script in "$scripts"/*.g; do
    if proves "$script"; then
        proved=$((proved + 1))
    else
        open=$((open + 1))
        echo "open: $script"
        cat "$scripts/log"
    fi
done
# Coq checks the certificates, given that the two sides of each rule are equal, which Gappa has seen
if [[ " $* " == *" --coq "* ]]; then
    install_packages coq libcoq-gappa
    mkdir -p "$scripts/coq"
    certified=0
    for script in "$scripts"/*.g proofs/fixed/direction.g; do
        certificate=$scripts/coq/$(basename "$script" | tr . _).v
        gappa -Eprecision=150 -Echange-threshold=0.0001 -Bcoq "$script" >"$certificate" 2>"$scripts/log"
        if timeout 120 coqc -q "$certificate" &>"$scripts/log"; then
            certified=$((certified + 1))
        else
            echo "Coq does not check it in two minutes: $script"
        fi
    done
    echo "certificates: $certified checked by Coq"
fi

# the integers of `Fixed`: every input of the reciprocals and the root, and by a solver every input of the other operators
decide() { # the claims of a copy of the source, or one of them, for each processor
    local source=$1 target
    for target in x86_64-unknown-linux-gnu thumbv6m-none-eabi; do
        rustc --edition 2024 --target "$target" --crate-type=rlib -C opt-level=1 -C overflow-checks=on -C panic=abort \
            -C codegen-units=1 -C llvm-args=-unroll-max-count=1 --emit=llvm-ir -o "$fixed/$target.ll" \
            "$source/proofs/fixed/harness.rs" || exit
        "$solver/bin/python" proofs/fixed/prove.py "$fixed/$target.ll" "${@:2}" || return
    done
}
if [[ "${1:-}" == --all ]]; then
    "$prover" tried
    fixed=${CARGO_TARGET_DIR:-target}/fixed
    mkdir -p "$fixed/planted"
    rustc --edition 2024 -O -C overflow-checks=on -o "$fixed/every" proofs/fixed/every.rs
    "$fixed/every"
    installer rustup --quiet target add thumbv6m-none-eabi
    decide .
    gappa -Eprecision=150 proofs/fixed/direction.g
    for smaller in s/0.5041/0.5035/ s/1b-23/15b-27/; do
        sed "$smaller" proofs/fixed/direction.g >"$fixed/direction.g"
        ! gappa -Eprecision=150 "$fixed/direction.g" 2>/dev/null || { echo "proved, but must not be: $smaller"; exit 1; }
    done
    # each fault must be refuted for one processor at least
    while IFS='|' read -r file old new claim; do
        cp -r --parents proofs/fixed src/features/fixed "$fixed/planted"
        sed -i "s/$old/$new/" "$fixed/planted/src/features/fixed/$file"
        ! cmp -s {,"$fixed/planted/"}"src/features/fixed/$file" || { echo "$file has no $old"; exit 1; }
        if decide "$fixed/planted" "$claim"; then
            echo "proved, but must not be: $claim with $new instead of $old"
            exit 1
        fi
    done <<'END'
arithmetic.rs|rest >= divisor - rest|rest > divisor - rest|claim_quotient
arithmetic.rs|if rest >= divisor|if rest > divisor|claim_quotient
arithmetic.rs|checked_div(divisor).unwrap_or(u32::MAX)|checked_div(divisor).unwrap_or(0)|claim_quotient
product.rs|i64::from(steps as i32) == steps|i32::try_from((a as i64 * b as i64) >> 16).is_ok()|claim_product
vector.rs|steps as i32 as i64 == steps|sum.wrapping_sub(0x8000) >> 16 == (sum.wrapping_sub(0x8000) >> 16) as i32 as i64|claim_dot_of_long
vector.rs|product >> 34|product >> 32|claim_dot_of_long
vector.rs|mut i) = (0, 0x8000,|mut i) = (0, 0x7FFF,|claim_dot_of_short
vector.rs|(1 << 10)) >> 11|(1 << 11)) >> 11|claim_direction
vector.rs|bits.leading_zeros() - 1|bits.leading_zeros()|claim_direction
vector.rs|length >> 11 >> shift|length >> 10 >> shift|claim_length
vector.rs|upper_of_square(v\[2\].0 << shift);|upper_of_square(v[1].0 << shift);|claim_length
falloff.rs|self.up.clamp(0, 31)|self.up.clamp(0, 32)|claim_arrives
falloff.rs|self.share).saturating_add(whole)|self.share).wrapping_add(whole)|claim_arrives
product.rs|low + 0x8000) >> 16|low + 0x7FFF) >> 16|claim_short_part
product.rs|i32::from(high as i16) == high|i32::from((high - (low >> 16)) as i16) == high - (low >> 16)|claim_product
END
fi

# half of a bound must not be proved, nor a bound of a formula with a rounding more
"$prover" bounds "$scripts/half" 0.5
"$prover" roundings >"$scripts/roundings"
while read -r number bound; do
    PLANTED=$number "$copy/target/release/shading-proofs" bounds "$scripts/$number"
    cp "$scripts/$number/$bound.0.F32.g" "$scripts/half/$number.$bound.F32.g"
done <"$scripts/roundings"
for script in "$scripts"/half/*.F32.g; do
    if gappa -Eprecision=150 -Eno-auto-dichotomy "$script" 2>"$scripts/log"; then
        echo "proved, but must not be: $script"
        exit 1
    fi
done

# what intervals leave open, which Bitwuzla decides
rm -rf "$scripts/smt"
"$prover" smt "$scripts/smt"
solved=$("$solver/bin/python" proofs/solve.py 60 "$scripts/smt" | tee >(cat >&2) | tail -n 1)
# a fault in what the trait derives must be refuted
"$prover" derivations >"$scripts/derivations"
while read -r number claim; do
    PLANTED=$number "$copy/target/release/shading-proofs" smt "$scripts/smt/$number" "$claim"
    rm "$scripts/smt/$number"/outside_by_bits.*
    if "$solver/bin/python" proofs/solve.py 60 "$scripts/smt/$number" >/dev/null; then
        echo "proved, but must not be: $claim with the fault $number"
        exit 1
    fi
done <"$scripts/derivations"

claims=$("$prover" prove | tee >(cat >&2) | tail -n 1)
echo "$claims; $solved; bounds: $proved proved by Gappa, $open open"
[[ "$claims" == *" 0 open" && "$solved" == *" 0 open" && $open == 0 ]]
