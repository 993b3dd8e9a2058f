#!/usr/bin/env bash
# Tests the crate's promises on microcontrollers. Builds the programs in this folder, runs them on the host, in Node and in
# emulators, and fails if a digest differs or a budget is exceeded. Installs what it needs.
set -euo pipefail
cd "$(dirname "$0")"
. ./toolchain.sh
. ./checks.sh

m0=thumbv6m-none-eabi m3=thumbv7m-none-eabi m4f=thumbv7em-none-eabihf riscv=riscv32imac-unknown-none-elf

failures=0
complain() {
    echo "FAILED: $*" >&2
    failures=$((failures + 1))
}

# within WHAT VALUE LIMIT: complains if the value exceeds the limit
within() { [ "$2" -le "$3" ] || complain "$1: $2 exceeds $3"; }

echo "== install what is missing"
install_packages qemu-system-arm qemu-system-misc gcc-arm-none-eabi libnewlib-arm-none-eabi binutils-arm-none-eabi
command -v node >/dev/null || install_packages nodejs
prepare_cross
mkdir -p target

echo "== the library builds for every target"
for target in $no_std_targets; do
    (cd ../.. && cross "$target" build --quiet --package shading --lib --no-default-features) ||
        complain "$target: the library does not build"
done

echo "== the program on the page about embedded use"
awk '/^<!-- main.rs -->/ { page = 1 } /^<!-- end -->/ { page = 0 } /^```/ { code = !code; next } page && code' \
    ../../docs/embedded.md | diff --ignore-blank-lines - src/bin/first.rs || complain "the program in docs/embedded.md differs from first.rs"
for target in $m0 $m3 $m4f; do
    build "$target" small first >/dev/null || complain "$target: the program in docs/embedded.md does not build"
done

echo "== build what follows for every chip at once, which keeps each core busy"
if [ "$cross_by" = rustup ]; then
    for profile in dev release small; do
        # shellcheck disable=SC2086 # one word per target
        cargo build --quiet --profile $profile $(printf -- '--target %s ' $chip_targets) --bin single --bin double --bin fixed
    done
    for profile in release small; do
        # shellcheck disable=SC2086
        cargo build --quiet --profile $profile $(printf -- '--target %s ' $chip_targets) --bin count --bin count_fixed \
            --bin encode --bin proof --bin stack
    done
fi

echo "== the same bits, at opt-level 0, 3 and s"
expected=$(digest host dev)
declare -A digest_of
for target in host $no_std_targets; do
    for profile in dev release small; do
        got=$(digest "$target" "$profile") || got=none
        [ "$got" = "$expected" ] || complain "$target $profile: the digest is $got, but $expected on the host"
        digest_of[$target]=$got
    done
done

echo "== no panic, no doubles"
for target in $chip_targets; do
    for profile in release small; do
        cannot_panic "$target" "$profile" || complain "$target $profile: something can panic"
        has_no_doubles "$target" "$profile" || complain "$target $profile: something computes in doubles"
    done
done
has_no_f64 $m4f || complain "$m4f: an f32 path contains a double, perhaps only as a constant"

echo "== instructions of a point light, with an integer and a real m: C at -O2, Rust at opt-level 3"
declare -A instructions_of
for target in $chip_targets; do
    instructions_of[$target]=$(instructions "$target")
    echo "$target at opt-level s: $(instructions "$target" small)"
done
# budgets TARGET INTEGER REAL PERCENT: complains above these budgets, above what C takes with an integer m, or above this
# share of what C takes with powf. They suit gcc 12.2 and newlib 3.3.
budgets() {
    local target=$1 whole_budget=$2 real_budget=$3 percent=$4 whole real c_whole c_real
    read -r whole real <<<"${instructions_of[$target]}"
    read -r c_whole c_real _ <<<"$(instructions_of_c "$target")"
    echo "$target C: $c_whole $c_real, Rust: $whole $real"
    within "$target instructions, integer m" "$whole" "$whole_budget"
    within "$target instructions, integer m, compared with C" "$whole" "$c_whole"
    within "$target instructions, real m" "$real" "$real_budget"
    within "$target instructions, real m, compared with C" "$real" $((c_real * percent / 100))
}
budgets $m4f 121 147 60
budgets $m0 6919 9405 70

echo "== instructions of a point light in fixed point, with an integer m: C at -O2, Rust at opt-level 3"
declare -A fixed_instructions_of
for target in $chip_targets; do
    fixed_instructions_of[$target]=$(instructions_of_fixed "$target")
    echo "$target Rust: ${fixed_instructions_of[$target]}, at opt-level s: $(instructions_of_fixed "$target" small)"
done
within "$m0 instructions, fixed point" "${fixed_instructions_of[$m0]}" 1600
within "$m3 instructions, fixed point" "${fixed_instructions_of[$m3]}" 420
within "$riscv instructions, fixed point" "${fixed_instructions_of[$riscv]}" 420
for target in $m0 $m3 $m4f; do
    read -r _ _ c <<<"$(instructions_of_c "$target")"
    echo "$target C: $c"
    within "$target instructions, fixed point, compared with C" "${fixed_instructions_of[$target]}" "$c"
done

echo "== instructions of a color: to sRGB, from sRGB, to RGB565; in C: to sRGB with powf, with a table, to RGB565 with powf"
for target in $chip_targets; do
    echo "$target Rust: $(instructions_to_encode "$target"), at opt-level s: $(instructions_to_encode "$target" small)"
done
# encodes TARGET TO_SRGB TO_RGB565: complains above these budgets, or above a quarter of what C takes with powf
encodes() {
    local target=$1 srgb _ rgb565 c_srgb c_table c_rgb565
    read -r srgb _ rgb565 <<<"$(instructions_to_encode "$target")"
    read -r c_srgb c_table c_rgb565 <<<"$(instructions_to_encode_in_c "$target")"
    echo "$target C: $c_srgb $c_table $c_rgb565, flash: $(flash_to_encode_in_c "$target")"
    within "$target instructions to sRGB" "$srgb" "$2"
    within "$target instructions to RGB565" "$rgb565" "$3"
    within "$target instructions to sRGB, compared with C" "$srgb" $((c_srgb / 4))
    within "$target instructions to RGB565, compared with C" "$rgb565" $((c_rgb565 / 4))
}
encodes $m4f 80 93
encodes $m0 100 101

echo "== flash that a function adds to an empty program, at opt-level s"
declare -A flash_of fixed_flash_of
for target in $chip_targets; do
    flash_of[$target]=$(flash "$target" "shade::blinn_phong, integer m")
    fixed_flash_of[$target]=$(flash "$target" "fixed: shade::blinn_phong, integer m")
done
real=$(flash $m4f "shade::blinn_phong, real m")
kilobyte_and_tenth=1126 # 1.1 × 1024
fixed_flash=2662        # 2.6 × 1024
within "$m4f flash, integer m" "${flash_of[$m4f]}" $kilobyte_and_tenth
within "$m4f flash, real m" "$real" $((${flash_of[$m4f]} + kilobyte_and_tenth))
within "$m0 flash, fixed point" "${fixed_flash_of[$m0]}" $fixed_flash

echo "== stack below the caller: each model, integer and real m and fixed point, all lights and those in front, opt-levels 3 and s"
for target in $chip_targets; do
    depths="$(stack "$target" release) $(stack "$target" small)"
    # in fixed point, the last six of each are for chips without an FPU
    [ "$target" != $m4f ] || depths=$(cut -d' ' -f1-10,17-26 <<<"$depths")
    echo "$target stack_bytes=${depths// /,}"
    for depth in $depths; do within "$target stack" "$depth" 256; done
done

echo "== each check can fail"
# broken FEATURE CHECK...: the check must fail when the feature breaks its promise
broken() {
    features=broken-$1
    shift
    if "$@" >/dev/null 2>&1; then complain "with $features, this check should fail but passes: $*"; fi
    features=""
}
same_bits() { [ "$(digest $m0 release | cut -d- -f"$1")" = "$(cut -d- -f"$1" <<<"$expected")" ]; }
few_instructions() { [ "$(instructions $m4f | cut -d' ' -f1)" -le 121 ]; }
few_in_fixed_point() { [ "$(instructions_of_fixed "$1")" -le "$2" ]; }
little_flash() { [ "$(flash "$1" "$2")" -le "$3" ]; }
little_stack() { [ "$(stack $m0 release | cut -d' ' -f"$1")" -le 256 ]; }
broken bits same_bits 1
broken bits same_bits 3
broken panic cannot_panic $m4f release
broken doubles has_no_doubles $m4f release
broken doubles has_no_f64 $m4f
broken instructions few_instructions
broken instructions few_in_fixed_point $m0 1600
broken instructions few_in_fixed_point $m3 420
broken instructions few_in_fixed_point $riscv 420
broken flash little_flash $m4f "shade::blinn_phong, integer m" $kilobyte_and_tenth
broken flash little_flash $m0 "fixed: shade::blinn_phong, integer m" $fixed_flash
broken stack little_stack 1
broken stack little_stack 11

echo "== summary"
for target in host $no_std_targets; do
    echo "$target digest=${digest_of[$target]}" \
        "instructions_per_point_light=${instructions_of[$target]:--} ${fixed_instructions_of[$target]:--}" \
        "flash_bytes=${flash_of[$target]:--} ${fixed_flash_of[$target]:--}" |
        sed -E 's/([0-9-]) ([0-9-])/\1,\2/g'
done
[ "$failures" = 0 ] || { echo "$failures checks failed" >&2; exit 1; }
