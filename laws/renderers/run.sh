#!/usr/bin/env bash
# Runs the laws on each renderer, or only on those that you name: `run.sh mesa chip`. It fails if a law holds that was
# broken, or the other way around: expected.txt has the outcomes. Installs what is missing.
set -euo pipefail
cd "$(dirname "$0")"
. ../../tests/firmware/toolchain.sh
mkdir -p target

# Each function builds a renderer and hands the command that starts it to `judge`.

mesa() {
    install_packages gcc libc6-dev libosmesa6-dev
    "${CC:-cc}" -std=c99 -O2 -Wall -Wextra -Werror mesa/host.c -lOSMesa -lm -o target/mesa
    judge target/mesa
}

chip() {
    cargo build --quiet --release -p chip
    judge target/release/chip
}
