#!/usr/bin/env bash
# Prints a Markdown table of the bytes that each public function adds to flash at opt-level s.
set -euo pipefail
cd "$(dirname "$0")"
. ./toolchain.sh
. ./checks.sh

install_packages binutils-arm-none-eabi
prepare_cross
echo "| function | Cortex-M4F | Cortex-M0 |"
echo "|---|---:|---:|"
cargo run --quiet --bin rows | while read -r function; do
    echo "| $function | $(flash thumbv7em-none-eabihf "$function") | $(flash thumbv6m-none-eabi "$function") |"
done
