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
# grouped BYTES: with a comma before the last three digits
grouped() { sed -E 's/([0-9])([0-9]{3})$/\1,\2/' <<<"$1"; }

cargo run --quiet --bin rows | while read -r function; do
    m4f=$(flash thumbv7em-none-eabihf "$function")
    m0=$(flash thumbv6m-none-eabi "$function")
    named=$(sed -E 's/^fixed: (.*)/\1, fixed point/; s/^([^,]*)/`\1`/' <<<"$function")
    echo "| $named | $(grouped "$m4f") | $(grouped "$m0") |"
done
