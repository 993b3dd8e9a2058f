//! The material of a surface.

use crate::rgb::Rgb;

/// The material of a surface: three reflectances, each with three channels, and the shininess.
///
/// A reflectance is 0 or more; at 1, the surface reflects all the light. It is the share that the
/// surface reflects, not a color of light: the light's color is in the light. `M` is the type of the
/// shininess, an [`Exponent`](crate::Exponent); a `u32` is faster than a float.
///
/// ```
/// use shading::f32::{Material, Rgb};
///
/// static BRASS: Material = Material {
///     k_a: Rgb::new(0.33, 0.22, 0.03),
///     k_d: Rgb::new(0.78, 0.57, 0.11),
///     k_s: Rgb::new(0.99, 0.94, 0.81),
///     m: 28,
/// };
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material<T = f32, M = u32> {
    /// k_a, the reflectance for ambient light.
    pub k_a: Rgb<T>,
    /// k_d, the diffuse reflectance.
    pub k_d: Rgb<T>,
    /// k_s, the reflectance of the highlight.
    pub k_s: Rgb<T>,
    /// m ≥ 0, the shininess: the larger it is, the smaller the highlight.
    pub m: M,
}

impl<T, M> Material<T, M> {
    /// The same material in another number type. `f` converts each reflectance and may only round
    /// it. The shininess does not change.
    ///
    /// ```
    /// use shading::f32::{Material, Rgb};
    /// let wax = Material { k_a: Rgb::BLACK, k_d: Rgb::gray(0.5), k_s: Rgb::gray(0.25), m: 10 };
    /// assert_eq!(wax.cast(f64::from).k_d, shading::f64::Rgb::gray(0.5));
    /// ```
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
