//! Floor 4: what a surface returns of the light that falls on it.

use crate::rgb::Rgb;

/// The material of a surface: its reflectances channel by channel, and its shininess.
///
/// The reflectances are not negative; 1 returns all the light. `M` is the type of the shininess, an
/// [`Exponent`](crate::Exponent): a `u32` takes the faster path.
///
/// ```
/// use shading::{Material, Rgb};
///
/// static BRASS: Material<f32, u32> = Material {
///     k_a: Rgb::new(0.33, 0.22, 0.03),
///     k_d: Rgb::new(0.78, 0.57, 0.11),
///     k_s: Rgb::new(0.99, 0.94, 0.81),
///     m: 28,
/// };
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material<T = f32, M = u32> {
    /// k_a, the share of the ambient light that is returned.
    pub k_a: Rgb<T>,
    /// k_d, the share of a light that is returned diffusely.
    pub k_d: Rgb<T>,
    /// k_s, the share of a light that is returned in the highlight.
    pub k_s: Rgb<T>,
    /// m ≥ 0, the shininess: the larger, the smaller the highlight.
    pub m: M,
}

impl<T, M> Material<T, M> {
    /// The same material in another number type: `f` converts each number, and may do no more
    /// than round it. The shininess stays as it is.
    #[inline]
    #[must_use]
    pub fn cast<U>(self, mut f: impl FnMut(T) -> U) -> Material<U, M> {
        Material {
            k_a: self.k_a.map(&mut f),
            k_d: self.k_d.map(&mut f),
            k_s: self.k_s.map(&mut f),
            m: self.m,
        }
    }
}
