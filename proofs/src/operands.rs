//! What fixed point computes of some operands.

use kit::random::Random;
use shading::fixed::Fixed;
use shading::number::{Dimmed, LightSum};
use shading::{Real, Rgb, Vec3};

/// What products, dot products, the test of what faces a surface and sums give, for `fixed.py` to compare with.
pub fn print() {
    let mut random = Random(1);
    let mut next = || {
        let edges = [0, 1, 1 << 15, 1 << 16, 65_537, i32::MAX, i32::MIN];
        match random.below(8) {
            0 => edges[random.below(edges.len())],
            1 => edges[random.below(edges.len())].wrapping_neg(),
            _ => random.fixed().to_bits(),
        }
    };
    let of = Fixed::from_bits;
    for _ in 0..1000 {
        let [a, b, c, x, y, z] = core::array::from_fn(|_| next());
        println!(
            "(= (mul #x{a:08x} #x{b:08x}) #x{:08x})",
            (of(a) * of(b)).to_bits()
        );
        let dot = Real::dot(Vec3::new(a, b, c).map(of), Vec3::new(x, y, z).map(of)).to_bits();
        println!(
            "(= (dot #x{a:08x} #x{b:08x} #x{c:08x} #x{x:08x} #x{y:08x} #x{z:08x}) #x{dot:08x})"
        );
        // a normal has components up to 1
        let [i, j, k] = [a, b, c].map(|component| component % 65_537);
        let front = Real::faces(Vec3::new(i, j, k).map(of), Vec3::new(x, y, z).map(of));
        println!("(= (faces #x{i:08x} #x{j:08x} #x{k:08x} #x{x:08x} #x{y:08x} #x{z:08x}) {front})");
        println!(
            "(= (lit #x{a:08x} #x{b:08x}) #x{:08x})",
            lit(of(a), of(b)).to_bits()
        );
    }
}

/// The sum over one light.
fn lit(light: Fixed, cosine: Fixed) -> Fixed {
    let (color, factor) = (Rgb::gray(light), Fixed::ONE);
    <Fixed as Real>::Sum::DARK
        .add(Dimmed { color, factor }, cosine)
        .total()
        .r
}
