# Source this file: it defines the single measurements. If a promise is broken on purpose, `features` names it.

features=""

# Prints the directory into which cargo builds under a profile.
directory() { if [ "$1" = dev ]; then echo debug; else echo "$1"; fi; }

# Builds a program for a target under a profile and prints its path.
build() {
    local target=$1 profile=$2 program=$3 kind=bin place=
    [ "$program" = wasm ] && kind=example place=examples/ program=wasm
    cross "$target" build --quiet --profile "$profile" --features "$features" "--$kind" "$program" >&2 || return
    echo "target/$target/$(directory "$profile")/$place$program"
}

# Runs a program on the emulated machine of a target; more arguments go to the emulator.
emulate() {
    local target=$1 program=$2 machine
    shift 2
    case $target in
    thumbv6m-*) machine="qemu-system-arm -machine microbit" ;;
    thumbv7m-*) machine="qemu-system-arm -machine mps2-an385" ;;
    thumbv7em-*) machine="qemu-system-arm -machine mps2-an386 -cpu cortex-m4" ;;
    riscv32*) machine="qemu-system-riscv32 -machine virt -bios none" ;;
    esac
    # shellcheck disable=SC2086 # one word per argument
    timeout 120 $machine -nographic -semihosting-config enable=on,target=native "$@" -kernel "$program" </dev/null
}

# Prints the digests for a target, or `host`, under a profile: SINGLE-DOUBLE-FIXED.
digest() {
    local target=$1 profile=$2 program
    case $target in
    host) cargo run --quiet --profile "$profile" --features "$features" --bin host ;;
    wasm32-*) program=$(build "$target" "$profile" wasm) && node wasm.mjs "$program.wasm" ;;
    *)
        for program in single double fixed; do
            program=$(build "$target" "$profile" "$program") && emulate "$target" "$program" || return
        done | paste -sd -
        ;;
    esac
}

# Prints the instructions per point light, with an integer m and with a real one, under `release` or the profile given.
instructions() { counted "$1" "${2-release}" count; }

# Prints the same in fixed point, with an integer m.
instructions_of_fixed() { counted "$1" "${2-release}" count_fixed; }

# Prints what a program counts.
counted() {
    local shift=10 program
    case $1 in riscv32*) shift=0 ;; esac
    program=$(build "$1" "$2" "$3") && emulate "$1" "$program" -icount "shift=$shift"
}

# Prints the same for the C kernels at -O2: with an integer m, with a real one, and in fixed point.
instructions_of_c() {
    compile_c "$1" target/kernel -O2 c/kernel.c c/kernel_fixed.c c/count.c
    emulate "$1" target/kernel -icount shift=10 2>&1 # the debug console is standard error
}

# Prints the instructions per color: to sRGB bytes, from sRGB bytes, to RGB565.
instructions_to_encode() { counted "$1" "${2-release}" encode; }

# Prints the same in C: to sRGB bytes with powf, to sRGB bytes with a table, to RGB565 with powf.
instructions_to_encode_in_c() {
    compile_c "$1" target/encode -O2 c/encode.c c/count_encode.c
    emulate "$1" target/encode -icount shift=10 2>&1
}

# Prints the bytes that each of the three adds to flash.
flash_to_encode_in_c() {
    local function sizes=()
    for function in nothing powf8 table8 powf565; do
        compile_c "$1" target/encode -Os "-DMEASURED=$function" c/encode.c c/count_encode.c
        sizes+=("$(arm-none-eabi-size target/encode | awk 'NR == 2 { print $1 }')")
    done
    for i in 1 2 3; do echo $((sizes[i] - sizes[0])); done | xargs
}

# compile_c TARGET PROGRAM ARGUMENT...: compiles and links C for a target.
compile_c() {
    local target=$1 program=$2 flags
    shift 2
    case $target in
    thumbv6m-*) flags="-mcpu=cortex-m0" ;;
    thumbv7m-*) flags="-mcpu=cortex-m3" ;;
    thumbv7em-*) flags="-mcpu=cortex-m4 -mfpu=fpv4-sp-d16 -mfloat-abi=hard" ;;
    esac
    srgb_table >target/table.h
    # shellcheck disable=SC2086 # one word per flag
    arm-none-eabi-gcc -mthumb $flags -Wall -Wextra -Werror -ffunction-sections -nostartfiles \
        -T c/link.ld -Wl,--gc-sections -Itarget c/start.c "$@" -lm -o "$program"
}

# Prints the sRGB byte of each 4095th of linear light.
srgb_table() {
    awk 'BEGIN {
        for (i = 0; i < 4096; i++) {
            x = i / 4095
            e = x <= 0.0031308 ? 12.92 * x : 1.055 * x ^ (1 / 2.4) - 0.055
            printf "%d,%s", 255 * e + 0.5, i % 16 == 15 ? "\n" : " "
        }
    }'
}

# Prints the bytes that a public function, named as in the table of functions, adds to flash at opt-level s.
flash() { echo $(($(program_size "$1" "$2") - $(program_size "$1" nothing))); }

# Prints the size of .text and .rodata of the program that calls one function.
program_size() {
    local program
    program=$(MEASURED=$2 build "$1" small flash) || return
    arm-none-eabi-size -A "$program" | awk '$1 ~ /^\.(text|rodata)$/ { bytes += $2 } END { print bytes }'
}

# Prints the bytes of stack below the caller under a profile, in the order of src/bin/stack.rs.
stack() {
    local program
    program=$(build "$1" "$2" stack) && emulate "$1" "$program"
}

# Succeeds if the proof links, which it does if nothing can panic.
cannot_panic() { build "$1" "$2" proof >/dev/null 2>&1; }

# Succeeds if the proof contains no routine for doubles, neither of the Arm run-time ABI nor of libgcc.
has_no_doubles() {
    local program symbols
    program=$(build "$1" "$2" proof) && symbols=$(arm-none-eabi-nm "$program") || return
    ! grep -E ' (__aeabi_(c?d[a-z]+|d2[a-z]+|[a-z]+2d)|__[a-z]*df[a-z]*[0-9]?)$' <<<"$symbols"
}

# Succeeds if the unoptimized code of the functions that a shader would call contains no double, not even as a constant. All
# of the code must be in one file, or the check shows nothing. `Vec3::new` is the exception: the library compiles it for
# itself, but it computes nothing.
has_no_f64() {
    local code=target/single.ll
    CARGO_INCREMENTAL=0 cross "$1" rustc --quiet --features "$features" --example single -- \
        --emit=llvm-ir="$code" -C codegen-units=1 >&2 || return
    ! grep -E '^declare .*shading' "$code" | grep -v 'Vec3.*3new' && ! grep -w double "$code"
}
