#!/usr/bin/env bash
# Draws the frame of the example `display` on an emulated Cortex-M0. Writes the desktop's frame, the chip's frame and their
# difference to docs/pictures/desktop_and_chip.png. Fails if a pixel differs.
set -euo pipefail
cd "$(dirname "$0")"
. ./toolchain.sh
. ./checks.sh

install_packages qemu-system-arm
prepare_cross
mkdir -p target
emulate thumbv6m-none-eabi "$(build thumbv6m-none-eabi release frame)" >target/frame.txt
cd ../..
cargo run --quiet --release -p display -- --beside tests/firmware/target/frame.txt "${1:-docs/pictures}/desktop_and_chip.png"
