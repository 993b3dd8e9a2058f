# Source this file to install what a script needs.

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
