# Source this file: it provides cargo for targets without an operating system, on a machine that may lack them.
#
# rustup fetches the compiled `core` of each target. If rustup is missing or cannot fetch, Debian's compiler builds `core`
# from Debian's sources instead. Either way, `cross TARGET COMMAND ARGUMENT...` runs cargo for a target.

chip_targets="thumbv6m-none-eabi thumbv7m-none-eabi thumbv7em-none-eabihf riscv32imac-unknown-none-elf"
no_std_targets="$chip_targets wasm32-unknown-unknown"

# Runs a command that installs something. Scripts may run side by side, but neither rustup nor apt-get may.
installer() { flock "${TMPDIR:-/tmp}/shading-installer.lock" "$@"; }

# Installs the given Debian packages that are missing.
install_packages() {
    local package missing="" as_root=""
    for package in "$@"; do
        dpkg --status "$package" >/dev/null 2>&1 || missing+=" $package"
    done
    [ -n "$missing" ] || return 0
    [ "$(id -u)" = 0 ] || as_root=sudo
    echo "installing$missing" >&2
    # shellcheck disable=SC2086 # one word per package, and none for nobody
    {
        installer $as_root apt-get update
        installer $as_root env DEBIAN_FRONTEND=noninteractive apt-get install --yes --no-install-recommends $missing
    } >/dev/null
}

# Chooses one of the two, and installs what it needs.
prepare_cross() {
    # shellcheck disable=SC2086 # one word per target
    if [ -z "${WITHOUT_RUSTUP-}" ] && installer timeout 120 rustup --quiet target add $no_std_targets; then
        cross_by=rustup
    else
        cross_by=debian
        install_packages rustc-web cargo-web rust-web-src lld
    fi
    echo "using $cross_by for the targets" >&2
}

cross() {
    local target=$1 command=$2
    shift 2
    if [ "$cross_by" = rustup ]; then
        cargo "$command" --target "$target" "$@"
        return
    fi
    local linker=ld.lld variable=CARGO_TARGET_${target^^}_LINKER
    [ "$target" = wasm32-unknown-unknown ] && linker=wasm-ld
    env PATH="/usr/bin:$PATH" RUSTC_BOOTSTRAP=1 "${variable//-/_}=$linker" \
        cargo "$command" -Zbuild-std=core --target "$target" "$@"
}
