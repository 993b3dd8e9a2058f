//! The illumination model: one sum over all lights.
//!
//! ```text
//! I_r = k_a I_a + Σ I (k_d max(0, N·L) + k_s highlight)
//! ```
//!
//! [`lambert`] has no highlight. The highlight of [`phong`] is max(0, R·V)ᵐ, and that of
//! [`blinn_phong`] max(0, N·H)ᵐ. A light with N·L ≤ 0 is behind the surface. It adds nothing, not
//! even a highlight, as in OpenGL.
//!
//! | argument | is | is made by |
//! |---|---|---|
//! | `n` | N, the normal of the surface at the point | [`normal`](mod@crate::normal) |
//! | `v` | V, the direction from the point to the eye | [`Vec3::unit`](crate::Vec3::unit) |
//! | `material` | k_a, k_d, k_s and m | [`Material`] |
//! | `i_a` | I_a, the ambient light of the scene, once for all lights | [`Rgb`] |
//! | `lights` | L and I of each light, as it arrives at the point | [`Light::at`](crate::Light::at) and `at` of each kind of light |
//!
//! The directions N, V and L all point away from the surface. N comes first, as in the formula: the
//! compiler cannot tell it from V, and with the two swapped, a surface is bright where it faces the light
//! from the eye's direction. Lights and reflectances should be 0 or more; the result is then 0 or more too,
//! in the unit of the intensities, which may be any.
//!
//! `lights` is any iterator over [`IncidentLight`]. You can write shadows, culling and area lights
//! as iterator adaptors.
//!
//! **Shadows.** Leave out the lights that do not reach the point. The shadow ray from the surface
//! ends at the light, at its [`distance`](IncidentLight::distance), so geometry beyond the light does not
//! block it.
//!
//! ```
//! use shading::f32::{Attenuation, IncidentLight, Material, PointLight, Rgb, UnitVec3, Vec3};
//! use shading::shade;
//!
//! /// Whether the ceiling z = 3 stands between p and the light.
//! fn is_blocked(p: Vec3, light: &IncidentLight) -> bool {
//!     let arrival = light.arrival();
//!     let t = (3.0 - p.z) / arrival.l.z;
//!     0.0 < t && t < arrival.distance
//! }
//!
//! let lamp = |height| PointLight {
//!     position: Vec3::new(0.0, 0.0, height),
//!     intensity: Rgb::WHITE,
//!     attenuation: Attenuation::NONE,
//! };
//! let lights = [lamp(2.0), lamp(5.0)]; // below the ceiling and above it
//! let clay = Material { k_a: Rgb::WHITE, k_d: Rgb::WHITE, k_s: Rgb::BLACK, m: 1 };
//!
//! let (p, n, v) = (Vec3::ZERO, UnitVec3::Z, UnitVec3::Z);
//! let lit = lights.iter().map(|light| light.at(p)).filter(|light| !is_blocked(p, light));
//! let shaded = shade::blinn_phong(n, v, &clay, Rgb::BLACK, lit);
//! assert_eq!(shaded.diffuse, Rgb::WHITE); // from the lower lamp alone
//! ```
//!
//! **Area lights.** Use many point lights, each with a fraction of the light, as in
//! [`guide::lights`](mod@crate::guide::lights#area-lights).
//!
//! **Overflow.** If the sum over the lights overflows, it counts as the largest finite number. The
//! result can then be infinite only through a reflectance above 1 or in the total. It cannot be NaN
//! if all numbers are finite and 0 or more. Without lights, the result is the ambient term.
//!
//! Source: Foley, van Dam et al. 1990, §16.1; OpenGL 2.1, §2.14.1.

use core::iter::Sum;
use core::ops::{Add, Mul};

use crate::color::Rgb;
use crate::direction::mirrored;
use crate::light::IncidentLight;
use crate::number::triple::assign;
use crate::number::{LightSum, Lobe, Mask, Measured, Real};
#[cfg(feature = "serde")]
use crate::number::{Read, Written};
use crate::term;
use crate::vector::UnitVec3;

/// The material of a surface: three reflectances, each with three channels, and the shininess.
///
/// A reflectance is 0 or more; at 1, the surface reflects all the light. It is the fraction that the
/// surface reflects, not a color of light: the color of the light belongs to the light. `M` is the type of the
/// shininess, a [`Lobe`]; a `u32` is faster than a float.
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
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(
        deny_unknown_fields,
        bound(
            serialize = "T: Written, M: serde::Serialize",
            deserialize = "T: Read<'de>, M: serde::Deserialize<'de>"
        )
    )
)]
#[must_use]
pub struct Material<T = f32, M = u32> {
    /// k_a, the reflectance for ambient light.
    #[doc(alias = "albedo")]
    pub k_a: Rgb<T>,
    /// k_d, the diffuse reflectance.
    #[doc(alias("albedo", "texture"))]
    pub k_d: Rgb<T>,
    /// k_s, the reflectance of the highlight.
    pub k_s: Rgb<T>,
    /// m ≥ 0, the shininess: the larger it is, the smaller the highlight.
    #[doc(alias("exponent", "glossiness", "hardness", "roughness"))]
    pub m: M,
}

impl<T, M> Material<T, M> {
    /// The same material in another number type. `f` converts each reflectance and may only round
    /// it. The shininess does not change.
    #[inline]
    pub fn cast<U>(self, mut f: impl FnMut(T) -> U) -> Material<U, M> {
        Material {
            k_a: self.k_a.map(&mut f),
            k_d: self.k_d.map(&mut f),
            k_s: self.k_s.map(&mut f),
            m: self.m,
        }
    }
}

/// The light that a point reflects to the eye, in three parts.
///
/// A texture multiplies `ambient` and `diffuse`. A surface without a texture needs only the
/// [`total`](Shaded::total).
///
/// Results can be added and scaled, part by part, to combine several passes or to interpolate
/// between the corners of a triangle (Gouraud shading).
///
/// ```
/// use shading::f32::{Rgb, Shaded};
///
/// let corner = |diffuse| Shaded { diffuse: Rgb::gray(diffuse), ..Shaded::default() };
/// let middle: Shaded = [corner(0.25), corner(0.75)].into_iter().map(|c| c * 0.5).sum();
/// assert_eq!(middle.total(), Rgb::gray(0.5));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[must_use]
pub struct Shaded<T = f32> {
    /// k_a I_a, the ambient term.
    pub ambient: Rgb<T>,
    /// Σ k_d I max(0, N·L), the diffuse term.
    pub diffuse: Rgb<T>,
    /// Σ k_s I highlight, the specular term.
    pub specular: Rgb<T>,
}

impl<T: Real> Shaded<T> {
    /// The sum of the three parts, linear and not clamped.
    #[inline]
    pub fn total(self) -> Rgb<T> {
        self.ambient + self.diffuse + self.specular
    }
}

macro_rules! encoded {
    ($($number:ty)*) => {$(
        /// The [`total`](crate::Shaded::total), encoded for a picture or a display.
        impl $crate::Shaded<$number> {
            /// The total as sRGB bytes; see [`Rgb::<f32>::to_srgb8`](crate::Rgb::<f32>::to_srgb8).
            #[inline]
            #[must_use]
            pub fn to_srgb8(self) -> [u8; 3] {
                self.total().to_srgb8()
            }

            /// The total as sRGB with five, six and five bits; see
            /// [`Rgb::<f32>::to_rgb565`](crate::Rgb::<f32>::to_rgb565).
            #[inline]
            #[must_use]
            pub fn to_rgb565(self) -> u16 {
                self.total().to_rgb565()
            }

            /// The total as bytes, not encoded; see [`Rgb::<f32>::to_linear8`](crate::Rgb::<f32>::to_linear8).
            #[inline]
            #[must_use]
            pub fn to_linear8(self) -> [u8; 3] {
                self.total().to_linear8()
            }
        }
    )*};
}

encoded!(f32 f64);
#[cfg(feature = "fixed")]
pub(crate) use encoded;

impl<T: Real> Add for Shaded<T> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self {
            ambient: self.ambient + other.ambient,
            diffuse: self.diffuse + other.diffuse,
            specular: self.specular + other.specular,
        }
    }
}

impl<T: Real> Mul<T> for Shaded<T> {
    type Output = Self;
    #[inline]
    fn mul(self, factor: T) -> Self {
        Self {
            ambient: self.ambient * factor,
            diffuse: self.diffuse * factor,
            specular: self.specular * factor,
        }
    }
}

assign!([T] Shaded<T>, Self: Add);
assign!([T] Shaded<T>, T: Mul);

impl<T: Real> Sum for Shaded<T> {
    #[inline]
    fn sum<I: Iterator<Item = Self>>(iter: I) -> Self {
        let none = Self {
            ambient: Rgb::BLACK,
            diffuse: Rgb::BLACK,
            specular: Rgb::BLACK,
        };
        iter.fold(none, Add::add)
    }
}

/// Shades a diffuse surface.
///
/// ```text
/// I_r = k_a I_a + Σ k_d I max(0, N·L)
/// ```
///
/// The k_s and m of `material` are not used, and the specular part of the result is black. The
/// direction to the eye does not matter, so it is not an argument. The [module page](crate::shade)
/// lists the arguments and the degenerate cases of all three sums.
///
/// Source: Lambert 1760; Foley, van Dam et al. 1990, §16.1.2.
///
/// ```
/// use shading::f32::{DirectionalLight, Material, Rgb, UnitVec3, Vec3};
/// use shading::shade;
///
/// let chalk = Material { k_a: Rgb::gray(0.1), k_d: Rgb::gray(0.5), k_s: Rgb::BLACK, m: 1 };
/// let sun = DirectionalLight { l: UnitVec3::Z, intensity: Rgb::WHITE };
/// let shaded = shade::lambert(UnitVec3::Z, &chalk, Rgb::WHITE, [sun.at(Vec3::ZERO)]);
/// assert_eq!(shaded.total(), Rgb::gray(0.6));
/// ```
#[inline]
pub fn lambert<T: Real, M>(
    n: UnitVec3<T>,
    material: &Material<T, M>,
    i_a: Rgb<T>,
    lights: impl IntoIterator<Item = IncidentLight<T>>,
) -> Shaded<T> {
    let mut shaded = sum(n, material, i_a, lights, |_| T::ZERO);
    shaded.specular = Rgb::BLACK;
    shaded
}

/// Shades a shiny surface with Phong's highlight.
///
/// ```text
/// I_r = k_a I_a + Σ I (k_d max(0, N·L) + k_s max(0, R·V)ᵐ)
/// ```
///
/// R is the [`reflection`](crate::reflection()) of L. A light with N·L ≤ 0 adds nothing. The
/// [module page](crate::shade) lists the arguments.
///
/// Source: Phong 1975.
///
/// ```
/// use shading::f32::{DirectionalLight, Material, Rgb, UnitVec3, Vec3};
/// use shading::shade;
///
/// let wax = Material { k_a: Rgb::BLACK, k_d: Rgb::gray(0.5), k_s: Rgb::gray(0.25), m: 10 };
/// let sun = DirectionalLight { l: UnitVec3::Z, intensity: Rgb::WHITE };
/// let (n, v) = (UnitVec3::Z, UnitVec3::Z); // the eye is where the light is reflected to
/// let shaded = shade::phong(n, v, &wax, Rgb::BLACK, [sun.at(Vec3::ZERO)]);
/// assert_eq!(shaded.total(), Rgb::gray(0.75));
/// ```
#[inline]
pub fn phong<T: Real, M: Lobe<T>>(
    n: UnitVec3<T>,
    v: UnitVec3<T>,
    material: &Material<T, M>,
    i_a: Rgb<T>,
    lights: impl IntoIterator<Item = IncidentLight<T>>,
) -> Shaded<T> {
    // R is the direction of w mirrored
    sum(n, material, i_a, lights, |measured| {
        let r_dot_v = mirrored(n, measured.w).dot(v) / measured.w_length;
        term::highlight(r_dot_v, material.m)
    })
}

/// Shades a shiny surface with Blinn's highlight: Phong's model with the half vector.
///
/// ```text
/// I_r = k_a I_a + Σ I (k_d max(0, N·L) + k_s max(0, N·H)ᵐ)
/// ```
///
/// H is the [`half_vector`](crate::half_vector()) of L and V. A light with N·L ≤ 0 adds nothing. If
/// L = −V, there is no half vector and no highlight.
///
/// - `n` is N, the normal of the surface, and `v` is V, the direction from the point to the eye: both have
///   length 1. If they are swapped, the surface looks flat and has no dark side.
/// - `material` holds k_a, k_d, k_s and m.
/// - `i_a` is I_a, the ambient light of the scene, once for all lights.
/// - `lights` is what arrives at the point: `[lamp.at(p)]`, or `lights.iter().map(|light| light.at(p))`.
///
/// The result is linear light in three parts, which [`Shaded::total`] adds. Encode the total once, by
/// [`Rgb::to_srgb8`](crate::Rgb::to_srgb8).
///
/// Source: Blinn 1977.
///
/// ```
/// use shading::f32::{DirectionalLight, Material, Rgb, UnitVec3, Vec3};
/// use shading::shade;
///
/// let clay = Material { k_a: Rgb::gray(0.25), k_d: Rgb::gray(0.5), k_s: Rgb::gray(0.25), m: 32 };
/// let sun = DirectionalLight { l: UnitVec3::Z, intensity: Rgb::WHITE };
/// let (n, v) = (UnitVec3::Z, UnitVec3::Z); // the half vector is N
/// let shaded = shade::blinn_phong(n, v, &clay, Rgb::gray(0.5), [sun.at(Vec3::ZERO)]);
/// assert_eq!(shaded.total(), Rgb::gray(0.875)); // ¼ · ½ + ½ + ¼
/// ```
#[inline]
pub fn blinn_phong<T: Real, M: Lobe<T>>(
    n: UnitVec3<T>,
    v: UnitVec3<T>,
    material: &Material<T, M>,
    i_a: Rgb<T>,
    lights: impl IntoIterator<Item = IncidentLight<T>>,
) -> Shaded<T> {
    // H is the direction of |w| (L + V)
    sum(n, material, i_a, lights, |measured| {
        T::halfway_power(*n, measured, *v, material.m)
    })
}

/// The sum over the lights. It computes with w, a vector to the light that is not divided by its
/// length, which takes one division in place of three: N·L = N·w/|w|.
#[inline(always)] // into a caller that is compiled for AVX2, whose intrinsics are calls elsewhere
fn sum<T: Real, M>(
    n: UnitVec3<T>,
    material: &Material<T, M>,
    i_a: Rgb<T>,
    lights: impl IntoIterator<Item = IncidentLight<T>>,
    highlight: impl Fn(Measured<T>) -> T,
) -> Shaded<T> {
    let [mut diffuse, mut specular] = [T::Sum::DARK; 2];
    // not `for_each`, whose closure keeps the sums in memory
    for light in lights {
        // the sign of N·L decides before the root of |w|
        let in_front = light.in_front(n);
        if in_front.any() {
            let (toward, mut light) = light.toward(n);
            // of lanes; a product with 0 would not do, because ∞ · 0 is NaN
            let is_partly = !in_front.all();
            if is_partly {
                light.color = Rgb::select(in_front, light.color, Rgb::BLACK);
            }
            // first, and the highlight after it: in the other order a sum takes 6 % longer on x86-64
            diffuse = diffuse.add(light, T::cosine(*n, &toward));
            let mut highlight = highlight(toward.measured);
            if is_partly {
                highlight = in_front.select(highlight, T::ZERO);
            }
            specular = specular.add(light, highlight);
        }
    }
    Shaded {
        ambient: term::ambient(material.k_a, i_a),
        diffuse: diffuse.total() * material.k_d,
        specular: specular.total() * material.k_s,
    }
}
