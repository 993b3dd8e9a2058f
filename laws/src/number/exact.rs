//! Sums of products beyond double precision, for measuring errors.

use std::array::from_fn;

/// Σ aᵢbᵢ as if computed with twice the precision of `f64`.
///
/// Source: Ogita, Rump, Oishi 2005, *Accurate Sum and Dot Product*, algorithm Dot2.
pub fn sum_of_products<const N: usize>(products: [(f64, f64); N]) -> f64 {
    let (mut sum, mut lost) = (0.0, 0.0);
    for (a, b) in products {
        let product = a * b;
        let next: f64 = sum + product;
        let added = next - sum;
        lost += (sum - (next - added)) + (product - added) + a.mul_add(b, -product);
        sum = next;
    }
    sum + lost
}

pub fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    sum_of_products([0, 1, 2].map(|i| (a[i], b[i])))
}

/// a·b − c·d
pub fn dot_difference([a, b]: [[f64; 3]; 2], [c, d]: [[f64; 3]; 2]) -> f64 {
    sum_of_products(from_fn::<_, 6, _>(|i| {
        if i < 3 {
            (a[i], b[i])
        } else {
            (-c[i - 3], d[i - 3])
        }
    }))
}

/// |a|² − 1
pub fn square_excess(a: [f64; 3]) -> f64 {
    sum_of_products([(a[0], a[0]), (a[1], a[1]), (a[2], a[2]), (-1.0, 1.0)])
}

pub fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        sum_of_products([(a[j], b[k]), (-a[k], b[j])])
    })
}

pub fn length(a: [f64; 3]) -> f64 {
    dot(a, a).sqrt()
}

/// det[a, b, c], to within about u of |a||b × c|
pub fn determinant(a: [f64; 3], b: [f64; 3], c: [f64; 3]) -> f64 {
    dot(a, cross(b, c))
}

pub fn subtract(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    from_fn(|i| a[i] - b[i])
}
