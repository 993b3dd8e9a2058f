//! Vectors of any length, scaled by a power of two before they are multiplied.

use crate::real::{Real, triple};
use crate::vector::Vec3;

/// v, tamed.
#[inline]
pub(crate) fn tame<T: Real>(v: Vec3<T>) -> Vec3<T> {
    T::tame(v.into()).into()
}

/// `to` − `from`, tamed.
#[inline]
pub(crate) fn tame_difference<T: Real>(to: Vec3<T>, from: Vec3<T>) -> Vec3<T> {
    T::tame_difference(to.into(), from.into()).into()
}

/// v, tamed, and the power of two that tamed it.
#[inline]
pub(crate) fn tame_and_scale<T: Real>(v: Vec3<T>) -> (Vec3<T>, T) {
    let (tame, scale) = triple::extreme_difference(v.into(), [T::ZERO; 3], v.dot(v));
    (tame.into(), scale)
}
