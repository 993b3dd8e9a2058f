//! Vectors of any length, scaled by a power of two before they are multiplied.

use crate::real::{Real, triple};
use crate::vector::Vec3;

/// v, rescaled.
#[inline]
pub(crate) fn rescaled<T: Real>(v: Vec3<T>) -> Vec3<T> {
    T::rescaled(v.into()).into()
}

/// `to` − `from`, rescaled.
#[inline]
pub(crate) fn rescaled_difference<T: Real>(to: Vec3<T>, from: Vec3<T>) -> Vec3<T> {
    T::rescaled_difference(to.into(), from.into()).into()
}

/// v, rescaled, and the power of two that rescaled it.
#[inline]
pub(crate) fn rescaled_with_scale<T: Real>(v: Vec3<T>) -> (Vec3<T>, T) {
    let (rescaled, scale) = triple::extreme_difference(v.into(), [T::ZERO; 3], v.dot(v));
    (rescaled.into(), scale)
}
