//! The edges of triangles of every size, and their cross product.

use super::Fixed;
use super::product::{product, zeros};

pub(super) const fn between(origin: [Fixed; 3], v: [Fixed; 3]) -> [Fixed; 3] {
    let [x, y, z] = edge(origin, v);
    with_21_bits([x as i64, y as i64, z as i64])
}

/// It is exact before it is rounded, so that parallel edges give 0, unless an edge is longer than 32,768.
pub(super) const fn crossed(origin: [Fixed; 3], a: [Fixed; 3], b: [Fixed; 3]) -> [Fixed; 3] {
    let ([a, b, c], [x, y, z]) = (edge(origin, a), edge(origin, b));
    with_21_bits([minor(b, z, c, y), minor(c, x, a, z), minor(a, y, b, x)])
}

/// The vector between two points times a power of two, with a component from 2³⁰ to 2³¹ unless it is 0.
// a call on every target: three normals and a corner share it
#[inline(never)]
const fn edge([a, b, c]: [Fixed; 3], [x, y, z]: [Fixed; 3]) -> [i32; 3] {
    let (mut d, dx) = x.0.overflowing_sub(a.0);
    let (mut e, dy) = y.0.overflowing_sub(b.0);
    let (mut f, dz) = z.0.overflowing_sub(c.0);
    if dx | dy | dz {
        d = (x.0 >> 1) - (a.0 >> 1);
        e = (y.0 >> 1) - (b.0 >> 1);
        f = (z.0 >> 1) - (c.0 >> 1);
    }
    let bits = d.unsigned_abs() | e.unsigned_abs() | f.unsigned_abs();
    let shift = zeros(bits | bits << 1 | 1); // 0 for −2³¹, too
    [d << shift, e << shift, f << shift]
}

/// ad − bc. Of the products, only (−2³¹)² is 2⁶², and none is −2⁶².
const fn minor(a: i32, d: i32, b: i32, c: i32) -> i64 {
    product(a, d) - product(b, c)
}

/// A vector times a power of two, with a component from 16 to 32 unless it is 0. The opposite
/// vector gives the opposite.
#[inline(never)]
const fn with_21_bits([x, y, z]: [i64; 3]) -> [Fixed; 3] {
    const fn shifted(x: i64, left: u32) -> Fixed {
        let size = ((x.unsigned_abs() << left >> 42) as i32 + 1) >> 1;
        Fixed(if x < 0 { -size } else { size })
    }
    let left = (x.unsigned_abs() | y.unsigned_abs() | z.unsigned_abs() | 1).leading_zeros();
    [shifted(x, left), shifted(y, left), shifted(z, left)]
}
