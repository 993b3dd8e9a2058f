#!/usr/bin/env bash
# Compiles the kernel to PTX, target/kernel.ptx: `ptx.sh TOOLCHAIN`. Fails where it computes in doubles, fuses or
# rounds in any other way than IEEE 754; checks it with `ptxas`, if that is installed.
set -euo pipefail
cd "$(dirname "$0")"
target=nvptx64-nvidia-cuda
llvm=$(rustc "+$1" --print sysroot)/lib/rustlib/x86_64-unknown-linux-gnu/bin

# as bitcode, which the toolchain's own LLVM links: rustup has no linker for this target
RUSTFLAGS="--emit=llvm-bc -C codegen-units=1 -C target-cpu=sm_70" \
    cargo "+$1" rustc --package kernel --lib --crate-type rlib --release \
    --target $target -Zbuild-std=core --target-dir target/cuda
crates=()
for crate in core libm shading kernel; do
    # the newest: an older one may lie beside it
    crates+=("$(find target/cuda/$target -name "$crate-*.bc" -printf '%T@ %p\n' | sort -n | tail -1 | cut -d' ' -f2)")
done
"$llvm/llvm-link" "${crates[@]}" -o target/cuda/linked.bc
"$llvm/opt" -passes='internalize,globaldce,default<O3>' -internalize-public-api-list=draw \
    target/cuda/linked.bc -o target/cuda/kernel.bc
"$llvm/llc" -O3 -mcpu=sm_70 -fp-contract=off target/cuda/kernel.bc -o target/kernel.ptx

if grep -E '[.]f64|fma|mad[.a-z]*[.]f32|[.](approx|ftz)' target/kernel.ptx ||
    grep -E '(add|sub|mul|div|rcp|sqrt)[.]f32' target/kernel.ptx; then
    echo "not as IEEE 754 rounds" >&2
    exit 1
fi
grep -oE '(add|sub|mul|div|rcp|sqrt)[.]rn[.]f32' target/kernel.ptx | sort | uniq -c
if command -v ptxas >/dev/null; then
    for architecture in sm_70 sm_80 sm_90; do
        ptxas --gpu-name $architecture target/kernel.ptx --output-file target/cuda/kernel.cubin
        echo "ptxas takes it for $architecture"
    done
else
    echo "ptxas is not installed; the Python package nvidia-cuda-nvcc-cu12 brings it"
fi
