//! The factors that dim a light: the defaults of [`Real`]'s hooks for what arrives.

use super::{Mask, Real};

/// min(limit, 1/(a + bq + cq²)), and 0 if the denominator is negative or NaN.
#[inline(always)]
pub(crate) fn attenuation<T: Real>([a, b, c]: [T; 3], q: T, limit: T) -> T {
    let factor = T::ONE / (a + q * (b + c * q));
    factor.at_least(T::ZERO).at_most(limit)
}

/// max(0, 1 − (q/r)⁴), or its square.
#[inline(always)]
pub(crate) fn window<T: Real>(q: T, range: T, is_squared: T::Mask) -> T {
    let fraction = q / range;
    let square = fraction * fraction;
    let root = (T::ONE - square * square).at_least(T::ZERO);
    is_squared.select(root * root, root)
}

/// 1 from the cosine of the inner edge on, 0 below that of the outer edge, and t² or t²(3 − 2t) between.
#[inline(always)]
pub(crate) fn beam<T: Real>(cosine: T, [inner, outer]: [T; 2], is_smooth: T::Mask) -> T {
    let within = |edge: T, factor| edge.above(cosine).select(factor, T::ONE);
    let is_soft = inner.above(outer);
    if !is_soft.any() {
        return within(inner, T::ZERO);
    }
    // measured from the outer edge, so that small t keep their precision
    let t = (cosine - outer) / (inner - outer);
    let t = t.at_least(T::ZERO).at_most(T::ONE);
    let smoothstep = (t * t * (T::ONE + T::ONE + T::ONE - (t + t))).at_most(T::ONE);
    let factor = is_smooth.select(smoothstep, t * t);
    within(inner, is_soft.select(factor, T::ZERO))
}
