#!/usr/bin/env bash
# Tests the crate's promises on microcontrollers: builds the programs in this folder, runs them in emulators, and fails if a
# digest differs or a budget is exceeded. `run.sh one` tries a Cortex-M4F alone: the bits, the panics and the counts; `run.sh
# renew` writes flash.txt; `run.sh approximate` also draws the ball with approximate roots. Installs what it needs.
set -euo pipefail
cd "$(dirname "$0")"
. ../../.ci/toolchain

m0=thumbv6m-none-eabi m3=thumbv7m-none-eabi m4f=thumbv7em-none-eabihf riscv=riscv32imac-unknown-none-elf
chips="$m0 $m3 $m4f $riscv"
[ "${1-}" != one ] || chips=$m4f

failures=0
complain() {
    echo "FAILED: $*" >&2
    failures=$((failures + 1))
}

# within WHAT VALUE LIMIT: complains if the value exceeds the limit
within() { [ "$2" -le "$3" ] || complain "$1: $2 exceeds $3"; }

# build TARGET PROFILE PROGRAM: prints the path of the program. The profile is `release`, at opt-level 3; `small`, at opt-level
# s; or `ball`, as an author builds firmware that must be fast and small. They are one profile for cargo, which compiles the
# macros and the build scripts of dependencies once for each profile; so the next build may replace the program.
build() {
    local features="" level=3 lto=false
    case $2 in
    small) level=s ;;
    ball) lto=fat ;;
    esac
    case $3 in
    ball | frame) features=ball ;;
    c) features=c ;;
    esac
    CARGO_PROFILE_RELEASE_OPT_LEVEL=$level CARGO_PROFILE_RELEASE_LTO=$lto \
        cargo build --quiet --target "$1" --release --bin "$3" --features "$features" >&2 && echo "target/$1/release/$3"
}

# run TARGET PROFILE PROGRAM ARGUMENT...: prints what the program prints in the emulator
run() {
    local machine program
    case $1 in
    thumbv6m-*) machine="qemu-system-arm -machine microbit" ;;
    thumbv7m-*) machine="qemu-system-arm -machine mps2-an385" ;;
    thumbv7em-*) machine="qemu-system-arm -machine mps2-an386 -cpu cortex-m4" ;;
    riscv32*) machine="qemu-system-riscv32 -machine virt -bios none" ;;
    esac
    program=$(build "$1" "$2" "$3") || return
    # shellcheck disable=SC2086 # one word per argument
    timeout 120 $machine -nographic -semihosting-config enable=on,target=native "${@:4}" -kernel "$program" </dev/null
}

# bytes PROGRAM: prints the size of its .text and .rodata
bytes() {
    readelf --section-headers --wide "$1" |
        awk '{ sub(/^ *\[ *[0-9]+\]/, "") } $1 ~ /^\.(text|rodata)$/ { bytes += strtonum("0x" $5) } END { print bytes }'
}

# size TARGET NAME: prints the size of the program that calls one function
size() {
    local program
    program=$(MEASURED=$2 build "$1" small flash) && bytes "$program"
}

# flash TARGET NAME: prints the bytes that a public function, named as in the table of functions, adds to an empty program
declare -A empty
flash() { echo $(($(size "$1" "$2") - empty[$1])); }

install_packages qemu-system-arm qemu-system-misc gawk gcc-arm-none-eabi libnewlib-arm-none-eabi gcc-riscv64-unknown-elf \
    picolibc-riscv64-unknown-elf
# shellcheck disable=SC2086 # one word per target
installer rustup --quiet target add $chips wasm32-unknown-unknown

if [ "${1-}" != one ]; then
    for target in $m4f $m0; do empty[$target]=$(size $target nothing); done
fi
if [ "${1-}" = renew ]; then
    {
        echo "# bytes of flash that a function adds to an empty program, at opt-level s: Cortex-M4F, Cortex-M0"
        names=$(sed -nE '/^ {8}(SWEEPS|SERIES|ARITHMETIC):/,/^ {8}\}/d; s/^ {12}[a-z0-9_]+ "(.*)" \|.*/\1/p' ../kit/src/table.rs)
        while read -r name; do
            printf '%-48s %6d %6d\n' "$name" "$(flash $m4f "$name")" "$(flash $m0 "$name")"
        done <<<"$names"$'\nshade::blinn_phong, integer m, fixed point'
    } >target/flash.txt
    mv target/flash.txt flash.txt
    exit
fi

echo "== the library builds for every target"
# shellcheck disable=SC2046 # one word per target
(cd ../.. && cargo build --quiet --package shading --lib --no-default-features --target-dir tests/firmware/target \
    $(printf -- '--target %s ' $chips wasm32-unknown-unknown)) || complain "the library does not build"

echo "== the same bits"
for NUMBER in f32 f64 fixed; do
    export NUMBER
    expected=$(cargo run --quiet --release --bin digest)
    for target in $chips; do
        for profile in release small; do
            [ "$NUMBER $profile" != "f64 small" ] || continue # doubles on a chip are slow, and rare
            got=$(run "$target" $profile digest) || got=none
            [ "$got" = "$expected" ] || complain "$target $profile, $NUMBER: the digest is $got, but $expected on the host"
        done
    done
done

echo "== no panic, no doubles"
for target in $chips; do
    for profile in release small; do
        program=$(build "$target" $profile proof) || { complain "$target $profile: something can panic" && continue; }
        ! readelf --symbols --wide "$program" | grep -E ' (__aeabi_(c?d[a-z]+|d2[a-z]+|[a-z]+2d)|__[a-z]*df[a-z]*[0-9]?)$' ||
            complain "$target $profile: something computes in doubles"
    done
done

echo "== instructions of a point light: integer m, real m, fixed point; at opt-level 3, then s"
declare -A budget=([$m4f]="168 180 375" [$m0]="7465 10135 1255" [$m3]="4110 5840 397" [$riscv]="3724 5311 540")
for target in $chips; do
    icount="-icount shift=10" # the emulator's clock counts instructions
    [ "$target" != $riscv ] || icount="-icount shift=0"
    # shellcheck disable=SC2086 # two words
    counts=$(run "$target" release count $icount)
    # shellcheck disable=SC2086
    echo "$target: $counts / $(run "$target" small count $icount)"
    read -ra counts <<<"$counts"
    read -ra budgets <<<"${budget[$target]}"
    for i in "${!counts[@]}"; do within "$target instructions" "${counts[i]}" "${budgets[i]}"; done
done

finish() {
    [ "$failures" = 0 ] || { echo "$failures checks failed" >&2; exit 1; }
    exit 0
}
[ "${1-}" != one ] || finish

echo "== instructions of a point light with a real m: by the crate, by the crate as a light of any kind, by the header for C, by it with lamps alone; its bytes of stack"
# GCC knows that a Cortex-M4 multiplies and adds sooner in two instructions than in one; rustc must be told the processor
export CARGO_TARGET_THUMBV7EM_NONE_EABIHF_RUSTFLAGS="-C target-cpu=cortex-m4"
for target in $m4f $m0 $riscv; do
    icount="-icount shift=10"
    [ "$target" != $riscv ] || icount="-icount shift=0"
    # shellcheck disable=SC2086 # two words
    read -r by_the_crate of_any_kind by_the_header lamps_alone stack <<<"$(run "$target" release c $icount)"
    echo "$target: $by_the_crate, $of_any_kind, $by_the_header, $lamps_alone; $stack"
    within "$target: bytes of stack in C" "$stack" 228
    # the lights of the header are of any kind
    within "$target: hundredths of the crate's instructions in C" $((100 * by_the_header / of_any_kind)) 105
    within "$target: hundredths of those of a lamp" $((100 * lamps_alone / by_the_crate)) \
        $([ "$target" = $m4f ] && echo 93 || echo 100)
done
unset CARGO_TARGET_THUMBV7EM_NONE_EABIHF_RUSTFLAGS

echo "== the ball, by the crate, by hand and in C: bytes of flash, millions of instructions, pixels that differ from the exact picture"
# ball TARGET PROGRAM: prints the bytes, the instructions and the digest of the picture
ball() {
    local program icount="-icount shift=7"
    export BALL=$2
    [ "$1" != $riscv ] || icount="-icount shift=0"
    program=$(build "$1" ball ball) || return
    # shellcheck disable=SC2086 # two words
    echo "$(bytes "$program")" "$(run "$1" ball frame $icount)"
}
pictures=$(cargo run --quiet --release --bin frame --features ball)
approximate=$([ "${1-}" != approximate ] || echo f32_by_micromath)
# bytes and thousands of instructions
declare -A limit=(
    [$m4f fixed]="3328 21500" [$m0 fixed]="4830 73000" [$riscv fixed]="4480 30000"
    [$m4f f32]="2120 11200" [$m0 f32]="4900 379500" [$riscv f32]="6380 193500"
)
declare -A flash_of thousands
for target in $m4f $m0 $riscv; do
    for program in f32 f32_by_hand $approximate f32_in_c fixed fixed_by_hand fixed_in_c; do
        read -r flash_of[$program] instructions digest <<<"$(ball "$target" $program)"
        thousands[$program]=$((instructions / 1000))
        read -r _ expected levels wrong <<<"$(grep "^$program " <<<"$pictures")"
        echo "$target $program: ${flash_of[$program]} bytes, ${thousands[$program]} thousand; $wrong pixels by up to $levels levels"
        [ "$digest" = "$expected" ] || complain "$target $program: the picture is not the host's"
        [ "$program" = f32_by_micromath ] || within "$target $program: levels" "$levels" 1
    done
    for program in f32 fixed; do
        read -r most_bytes most_thousands <<<"${limit[$target $program]}"
        within "$target $program: bytes of the ball" "${flash_of[$program]}" "$most_bytes"
        within "$target $program: thousands of instructions" "${thousands[$program]}" "$most_thousands"
    done
    within "$target: hundredths of the flash by hand" $((100 * flash_of[fixed] / flash_of[fixed_by_hand])) 138
    within "$target: hundredths of the instructions by hand" $((100 * thousands[fixed] / thousands[fixed_by_hand])) \
        $([ "$target" = $riscv ] && echo 55 || echo 50)
    within "$target: hundredths of the crate's instructions in fixed point in C" \
        $((100 * thousands[fixed_in_c] / thousands[fixed])) $([ "$target" = $riscv ] && echo 125 || echo 118)
    program=$(BALL=fixed build "$target" ball ball)
    ! readelf --symbols --wide "$program" | grep -E ' (__aeabi_(c?[df][a-z]+|[a-z]+2[df]|[df]2[a-z]+)|__[a-z]*[sd]f[a-z]*[0-9]?)$' ||
        complain "$target: a program in fixed point computes in floating point"
    ! readelf --symbols --wide "$program" | grep -E ' (__aeabi_u?ldivmod|__u?divdi3)$' ||
        complain "$target: a program in fixed point divides 64 bits"
done

echo "== flash of a program with one sum, and with five"
# these vary by up to 24 bytes with the path of the checkout, by which rustc orders functions
declare -A sites=(
    [$m4f fixed]="3220 9700" [$m0 fixed]="5070 11500" [$riscv fixed]="5170 13850"
    [$m4f f32]="1520 5950" [$m0 f32]="4860 9320" [$riscv f32]="6120 11748"
)
for target in $m4f $m0 $riscv; do
    for NUMBER in f32 fixed; do
        export NUMBER
        one=$(bytes "$(SITES=1 build "$target" ball sites)")
        five=$(bytes "$(SITES=5 build "$target" ball sites)")
        echo "$target $NUMBER: $one, $five"
        read -r most_of_one most_of_five <<<"${sites[$target $NUMBER]}"
        within "$target $NUMBER: bytes with one sum" "$one" "$most_of_one"
        within "$target $NUMBER: bytes with five sums" "$five" "$most_of_five"
    done
done

echo "== stack below the caller: Lambert, Phong, Blinn–Phong, the last two with a real m; in fixed point the first three"
for target in $chips; do
    for profile in release small; do
        depths=$(run "$target" $profile stack)
        echo "$target $profile: $depths"
        read -ra depths <<<"$depths"
        for i in "${!depths[@]}"; do within "$target $profile stack" "${depths[i]}" $((i < 5 ? 404 : 504)); done
    done
done

echo "== flash, at opt-level s"
for name in "shade::blinn_phong, integer m" "shade::blinn_phong, real m" "Rgb::to_srgb8"; do
    on_m0=$(flash $m0 "$name")
    got="$(flash $m4f "$name") $on_m0"
    kept=$(sed -n "s/^$name  *\([0-9]* *[0-9]*\)$/\1/p" flash.txt | tr -s ' ')
    echo "$name: $got"
    [ "$got" = "$kept" ] || complain "$name: flash.txt says $kept; \`.ci/renew flash\` renews it"
    [ "$name" != "shade::blinn_phong, integer m" ] || within "$m0 flash of $name" "$on_m0" 4900
done

finish
