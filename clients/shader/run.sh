#!/usr/bin/env bash
# Compiles the kernel to a Vulkan shader, runs it on a Vulkan device, and fails where a number differs from the CPU's by more
# than `src/main.rs` derives: `clients/shader/run.sh [DEVICE]`. Where no graphics driver is installed, Mesa's runs it on the
# CPU.
#
# It installs what is missing: Debian packages, and rust-gpu's nightly by rustup, beside the default toolchain. The
# first run also compiles rust-gpu, in some 15 minutes.
set -euo pipefail
cd "$(dirname "$0")"
. ../../tests/firmware/toolchain.sh # install_packages

toolchain=nightly-2026-08-15 # the one that rust-gpu 0.11 is written for
install_packages spirv-tools libvulkan1 mesa-vulkan-drivers
rustup toolchain list | grep -q "^$toolchain" ||
    rustup toolchain install $toolchain --profile minimal --no-self-update \
        --component rust-src --component rustc-dev --component llvm-tools

echo "== the shader"
mkdir -p target
cargo +$toolchain run --release --example compiler -- target/kernel.spv
module=$(spirv-dis target/kernel.spv)
for unwanted in Float64 Int64 Int8 Fma; do
    if grep --word-regexp "$unwanted" <<<"$module"; then
        echo "the module needs $unwanted" >&2
        exit 1
    fi
done
grep OpCapability <<<"$module"

echo "== on the GPU and on the CPU"
cargo run --release -- target/kernel.spv "${1-0}"
