#!/usr/bin/env bash
# Proves what docs/proofs.md lists, in about a minute; with `--all`, tests the prover itself with a hundred times as
# many numbers. The last line says how many claims were proved, by which means, and how many are open.
set -euo pipefail
cd "$(dirname "$0")/.."

runs=20
[[ "${1:-}" == --all ]] && runs=2000
cargo build --release -p shading-proofs
prover="${CARGO_TARGET_DIR:-target}/release/shading-proofs"
"$prover" check "$runs"
"$prover" prove
