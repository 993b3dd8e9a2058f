#!/usr/bin/env bash
# Draws the bunny on an emulated Cortex-M0 and on this machine, and fails where the two differ.
# clients/bunny/frame.sh [PICTURE.png]
set -euo pipefail
picture=$(realpath "${1:-bunny.png}")
cd "$(dirname "$0")"
. ../../tests/firmware/toolchain.sh
. ../../tests/firmware/checks.sh

install_packages qemu-system-arm
prepare_cross
chip=thumbv6m-none-eabi build=${CARGO_TARGET_DIR:-$PWD/../target}
cross $chip build --quiet --release --bin board
cargo build --quiet --release --bin board --bin show
# 64 ns an instruction: the timer of the core wraps after 16 million of them
emulate $chip "$build/$chip/release/board" -icount shift=6 >"$build/chip.txt"
"$build/release/board" >"$build/desktop.txt"
diff <(tail -n +2 "$build/desktop.txt") <(tail -n +2 "$build/chip.txt") || {
    echo "the chip draws another frame" >&2
    exit 1
}
instructions=$(head -1 "$build/chip.txt")
echo "a frame takes $instructions instructions on a Cortex-M0: at 48 MHz, one for each cycle," \
    "$(awk "BEGIN { printf \"%.1f\", 48e6 / $instructions }") frames a second"
"$build/release/show" "$build/chip.txt" "$picture"
