#!/usr/bin/env bash
# Draws the frame of the example `display` on an emulated Cortex-M0, in floating point and in fixed point. Writes the
# desktop's frame, the chip's frame and their difference to docs/pictures/desktop_and_chip.png, in fixed point to
# target/desktop_and_chip_fixed.png. Fails if a pixel differs, or if the frame in fixed point takes a floating-point routine.
# Then counts the instructions of a frame on each chip. Fails if fixed point takes more than half of those of f32 on a chip
# without an FPU.
set -euo pipefail
cd "$(dirname "$0")"
. ./toolchain.sh
. ./checks.sh

install_packages qemu-system-arm qemu-system-misc binutils-arm-none-eabi
prepare_cross
mkdir -p target
chip=thumbv6m-none-eabi

# frame TYPE PICTURE: draws in floating point, or in the type `fixed`
frame() {
    program=$(features=${1:+frame-in-$1} build $chip release frame)
    emulate $chip "$program" >target/frame.txt
    (cd ../.. && cargo run --quiet --release -p display --features "$1" -- --beside tests/firmware/target/frame.txt "$2")
    routines=$(arm-none-eabi-nm "$program" |
        grep -oE ' (__aeabi_(c?[df][a-z]+|[df]2[a-z]+|[a-z]+2[df])|__[a-z]*[sd]f[a-z]*[0-9]?)$') || true
}
frame "" "${1:-docs/pictures}/desktop_and_chip.png"
[ -n "$routines" ] || { echo "the search for floating-point routines finds none in floating point" >&2; exit 1; }
frame fixed target/desktop_and_chip_fixed.png
[ -z "$routines" ] || { echo "the frame in fixed point takes $routines" >&2; exit 1; }

for target in $chip_targets; do
    shift=8 # 256 ns an instruction: the timer wraps after four million, and a row takes half of that
    case $target in riscv32*) shift=0 ;; esac
    program=$(build "$target" release count_frame)
    read -r float fixed <<<"$(emulate "$target" "$program" -icount "shift=$shift")"
    echo "$target instructions of a frame: $float, in fixed point $fixed"
    [[ $target = *hf || $((2 * fixed)) -le $float ]] || { echo "fixed point is too slow" >&2; exit 1; }
done
