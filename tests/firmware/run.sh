#!/usr/bin/env bash
# Holds the crate to its promises on microcontrollers: builds the programs of this folder, runs them on the host, in
# Node and in emulators, and fails where a digest differs. Installs what it needs.
set -euo pipefail
cd "$(dirname "$0")"
. ./toolchain.sh

failures=0
complain() {
    echo "FAILED: $*" >&2
    failures=$((failures + 1))
}

# The directory in which cargo puts what it builds under a profile.
directory() { if [ "$1" = dev ]; then echo debug; else echo "$1"; fi; }

# Runs a program on the emulated machine of a target.
emulate() {
    local target=$1 machine
    shift
    case $target in
    thumbv6m-*) machine="qemu-system-arm -machine microbit" ;;
    thumbv7em-*) machine="qemu-system-arm -machine mps2-an386 -cpu cortex-m4" ;;
    riscv32*) machine="qemu-system-riscv32 -machine virt -bios none" ;;
    esac
    # shellcheck disable=SC2086 # one word an argument
    timeout 120 $machine -nographic -semihosting-config enable=on,target=native "${@:2}" -kernel "$1" </dev/null
}

# Builds and runs the digest for a target, or `host`, under a profile.
digest() {
    local target=$1 profile=$2
    local built=target/$target/$(directory "$profile")
    case $target in
    host) cargo run --quiet --profile "$profile" --bin host ;;
    wasm32-*)
        cross "$target" build --quiet --profile "$profile" --example wasm
        node wasm.mjs "$built/examples/wasm.wasm"
        ;;
    *)
        cross "$target" build --quiet --profile "$profile" --bin digest
        emulate "$target" "$built/digest"
        ;;
    esac
}

echo "== the same bits, at opt-level 0, 3 and s"
install_packages qemu-system-arm qemu-system-misc
command -v node >/dev/null || install_packages nodejs
prepare_cross
expected=$(digest host dev)
for target in host $no_std_targets; do
    for profile in dev release small; do
        got=$(digest "$target" "$profile") || got=none
        echo "$target $profile digest=$got"
        [ "$got" = "$expected" ] || complain "$target $profile: digest $got, on the host $expected"
    done
done

[ "$failures" = 0 ] || { echo "$failures checks failed" >&2; exit 1; }
