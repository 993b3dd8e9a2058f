#!/usr/bin/env bash
# Prints how long a clean release build takes for four packages: this crate with its dependency, glam, a renderer that uses
# this crate, and one that uses glam. Each figure is the least of five builds, without downloads.
set -euo pipefail
crate=$(cd "$(dirname "$0")/.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# package NAME DEPENDENCY: makes a binary with that dependency, from the source on standard input
package() {
    mkdir -p "$work/$1/src"
    cat > "$work/$1/src/main.rs"
    printf '[package]\nname = "%s"\nedition = "2024"\n[workspace]\n[dependencies]\n%s\n' "$1" "$2" > "$work/$1/Cargo.toml"
    cargo fetch --quiet --manifest-path "$work/$1/Cargo.toml"
}

# build LABEL NAME PACKAGES...: prints the least time
build() {
    local label=$1 name=$2 least=999999 start took; shift 2
    for _ in 1 2 3 4 5; do
        rm -rf "$work/$name/target"
        start=$(date +%s%N)
        cargo build --quiet --release --offline --manifest-path "$work/$name/Cargo.toml" "$@"
        took=$(( ($(date +%s%N) - start) / 1000000 ))
        (( took < least )) && least=$took
    done
    printf '%-28s %5d ms\n' "$label" "$least"
}

package with-shading "shading = { path = \"$crate\" }" <<'RUST'
use shading::*;
fn main() {
    let lamp = PointLight {
        position: Vec3::new(2.0_f32, -2.0, 3.0),
        intensity: Rgb::WHITE,
        attenuation: Attenuation::NONE,
    };
    let material = Material { k_a: Rgb::gray(0.1), k_d: Rgb::gray(0.6), k_s: Rgb::gray(0.3), m: 30.5 };
    for i in 0..100 {
        let p = Vec3::new(i as f32 * 0.01, 0.0, 1.0);
        let n = p.unit_or(UnitVec3::Z);
        let shaded = shade::blinn_phong(n, UnitVec3::Z, &material, Rgb::WHITE, [lamp.at(p)]);
        println!("{:?}", shaded.total());
    }
}
RUST
package with-glam 'glam = "0.34"' <<'RUST'
use glam::Vec3;
fn main() {
    let lamp = Vec3::new(2.0, -2.0, 3.0);
    for i in 0..100 {
        let p = Vec3::new(i as f32 * 0.01, 0.0, 1.0);
        let (n, l, v) = (p.normalize(), (lamp - p).normalize(), Vec3::Z);
        let n_dot_l = n.dot(l);
        let mut sum = Vec3::splat(0.1);
        if n_dot_l > 0.0 {
            let h = (l + v).normalize();
            sum += Vec3::splat(0.6 * n_dot_l + 0.3 * n.dot(h).max(0.0).powf(30.5));
        }
        println!("{sum:?}");
    }
}
RUST

build 'shading' with-shading -p shading
build 'glam' with-glam -p glam
build 'a renderer with shading' with-shading
build 'a renderer with glam' with-glam
