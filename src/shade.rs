//! The illumination model: one sum over all lights.
//!
//! ```text
//! I_r = k_a I_a + Σ (k_d I max(0, N·L) + k_s I highlight)
//! ```
//!
//! [`lambert`] has no highlight. The highlight of [`phong`] is max(0, R·V)ᵐ, and that of
//! [`blinn_phong`] max(0, N·H)ᵐ. A light with N·L ≤ 0 is behind the surface. It adds nothing, not
//! even a highlight, as in OpenGL.
//!
//! The functions take these arguments:
//!
//! | argument | is | is made by |
//! |---|---|---|
//! | `n` | N, the normal of the surface at the point | [`normal`](mod@crate::normal) |
//! | `v` | V, the direction from the point to the eye | [`Vec3::unit`](crate::Vec3::unit) |
//! | `material` | k_a, k_d, k_s and m | [`Material`] |
//! | `i_a` | I_a, the ambient light of the scene, once for all lights | [`Rgb`] |
//! | `lights` | L and I of each light, as it arrives at the point | [`Light::at`](crate::Light::at) and `at` of each kind of light |
//!
//! The directions N, V and L all point away from the surface. Lights and reflectances should be 0
//! or more; the result is then 0 or more too. Intensities may be in any unit; the result is in the
//! same unit.
//!
//! `lights` is any iterator over [`IncidentLight`]. You can write shadows, culling and area lights
//! as iterator adaptors. With the feature `wide`, `PointLight::all_at` gives several lights at a
//! time in SIMD lanes. The sum adds them one after another, so its bits do not change.
//!
//! **Shadows.** Leave out the lights that do not reach the point. The shadow ray from the surface
//! ends at the light, at its [`distance`](IncidentLight::distance), so a wall behind a lamp casts
//! no shadow.
//!
//! ```
//! use shading::f32::{Attenuation, IncidentLight, Material, PointLight, Rgb, UnitVec3, Vec3};
//! use shading::shade;
//!
//! /// Whether the ceiling z = 3 stands between p and the light.
//! fn is_blocked(p: Vec3, light: &IncidentLight) -> bool {
//!     let t = (3.0 - p.z) / light.l.z;
//!     0.0 < t && t < light.distance
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
//! let lit = lights
//!     .iter()
//!     .filter_map(|light| light.in_front(p, n))
//!     .filter(|light| !is_blocked(p, light));
//! let shaded = shade::blinn_phong(n, v, &clay, Rgb::BLACK, lit);
//! assert_eq!(shaded.diffuse, Rgb::WHITE); // from the lower lamp alone
//! ```
//!
//! **Area lights.** Use many point lights, each with a share of the light, as in
//! [`guide::recipes`](mod@crate::guide::recipes).
//!
//! **Overflow.** If the sum over the lights overflows, it counts as the largest finite number. The
//! result can then be infinite only through a reflectance above 1 or in the total. It cannot be NaN
//! if all numbers are finite. Without lights, the result is the ambient term.
//!
//! Source: Foley, van Dam, Feiner, Hughes, *Computer Graphics: Principles and Practice*, 2nd ed.,
//! 1990, §16.1; *The OpenGL Graphics System: A Specification*, version 2.1, 2006, §2.14.1.

use core::iter::Sum;
use core::ops::{Add, Mul};

use crate::exponent::Exponent;
use crate::exponent::batch::{NoHighlight, Powers};
use crate::light::{IncidentLight, Lights};
use crate::material::Material;
use crate::real::{Real, Several};
use crate::rgb::Rgb;
use crate::term;
use crate::unit::UnitVec3;

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
    ///
    /// ```
    /// use shading::f32::{Rgb, Shaded};
    ///
    /// let (ambient, diffuse, specular) = (Rgb::gray(0.125), Rgb::gray(0.5), Rgb::gray(0.25));
    /// let shaded = Shaded { ambient, diffuse, specular };
    /// assert_eq!(shaded.total(), Rgb::gray(0.875));
    /// ```
    #[inline]
    #[must_use]
    pub fn total(self) -> Rgb<T> {
        self.ambient + self.diffuse + self.specular
    }
}

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
/// `n` is the normal N, which points away from the surface. `material` gives k_a and k_d; its k_s
/// and m are not used. `i_a` is the ambient light I_a of the scene. `lights` gives the L and I of
/// each light at the point. The specular part of the result is black. The direction to the eye does
/// not matter, so it is not an argument. The [module page](crate::shade) lists the ranges and the
/// degenerate cases.
///
/// Source: Johann Heinrich Lambert, *Photometria*, 1760; Foley, van Dam, Feiner, Hughes, *Computer
/// Graphics: Principles and Practice*, 2nd ed., 1990, §16.1.2.
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
#[must_use]
pub fn lambert<T: Real, M>(
    n: UnitVec3<T>,
    material: &Material<T, M>,
    i_a: Rgb<T>,
    lights: impl Lights<T>,
) -> Shaded<T> {
    sum(n, material, i_a, lights.arriving(), NoHighlight, |_| {
        Real::ZERO
    })
}

/// Shades a shiny surface with Phong's highlight.
///
/// ```text
/// I_r = k_a I_a + Σ I (k_d max(0, N·L) + k_s max(0, R·V)ᵐ)
/// ```
///
/// `n` is the normal N and `v` the direction V to the eye; both point away from the surface.
/// `material` gives k_a, k_d, k_s and m. `i_a` is the ambient light I_a of the scene. `lights`
/// gives the L and I of each light at the point; R is the [`reflection`](crate::reflection()) of L.
/// A light with N·L ≤ 0 adds nothing. The [module page](crate::shade) lists the ranges and the
/// degenerate cases.
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
///
/// Source: Bui Tuong Phong, *Illumination for Computer Generated Pictures*, 1975.
#[inline]
#[must_use]
pub fn phong<T: Real, A: Lights<T>, M: Exponent<A::Number>>(
    n: UnitVec3<T>,
    v: UnitVec3<T>,
    material: &Material<T, M>,
    i_a: Rgb<T>,
    lights: A,
) -> Shaded<T> {
    let (normal, v) = (n.cast(A::Number::in_each), v.cast(A::Number::in_each));
    let r_dot_v = |l: UnitVec3<_>| Real::reflected_cosine(normal.into(), l.into(), v.into());
    sum(n, material, i_a, lights.arriving(), material.m, r_dot_v)
}

/// Shades a shiny surface with Blinn's highlight: Phong's model with the half vector.
///
/// ```text
/// I_r = k_a I_a + Σ I (k_d max(0, N·L) + k_s max(0, N·H)ᵐ)
/// ```
///
/// `n` is the normal N and `v` the direction V to the eye; both point away from the surface.
/// `material` gives k_a, k_d, k_s and m. `i_a` is the ambient light I_a of the scene. `lights`
/// gives the L and I of each light at the point; H is the [`half_vector`](crate::half_vector()) of
/// L and V. A light with N·L ≤ 0 adds nothing. If L = −V, there is no half vector and no highlight.
/// The [module page](crate::shade) lists the ranges and the other degenerate cases.
///
/// ```
/// use shading::f32::{DirectionalLight, Material, Rgb, UnitVec3, Vec3};
/// use shading::shade;
///
/// let wax = Material { k_a: Rgb::BLACK, k_d: Rgb::gray(0.5), k_s: Rgb::gray(0.25), m: 40 };
/// let sun = DirectionalLight { l: UnitVec3::Z, intensity: Rgb::WHITE };
/// let (n, v) = (UnitVec3::Z, UnitVec3::Z); // the eye is where the light is reflected to
/// let shaded = shade::blinn_phong(n, v, &wax, Rgb::BLACK, [sun.at(Vec3::ZERO)]);
/// assert_eq!(shaded.total(), Rgb::gray(0.75));
/// ```
///
/// Source: James F. Blinn, *Models of Light Reflection for Computer Synthesized Pictures*, 1977.
#[inline]
#[must_use]
pub fn blinn_phong<T: Real, A: Lights<T>, M: Exponent<A::Number>>(
    n: UnitVec3<T>,
    v: UnitVec3<T>,
    material: &Material<T, M>,
    i_a: Rgb<T>,
    lights: A,
) -> Shaded<T> {
    let half = material.m.half();
    let (normal, v) = (n.cast(A::Number::in_each), v.cast(A::Number::in_each));
    let n_dot_h =
        |l: UnitVec3<_>| Real::half_cosine(normal.into(), l.into(), v.into(), half.is_some());
    sum(
        n,
        material,
        i_a,
        lights.arriving(),
        half.unwrap_or(material.m),
        n_dot_h,
    )
}

/// The sum over the lights. Their highlights are the m-th powers of the cosines.
#[inline]
fn sum<T: Real, L: Several<T>, M, E: Exponent<L>>(
    n: UnitVec3<T>,
    material: &Material<T, M>,
    i_a: Rgb<T>,
    lights: impl Iterator<Item = IncidentLight<L>>,
    m: E,
    cosine: impl Fn(UnitVec3<L>) -> L,
) -> Shaded<T> {
    let n = n.cast(L::in_each);
    // the ambient term is stored first, so that I_a need not be kept
    let mut shaded = Shaded {
        ambient: term::ambient(material.k_a, i_a),
        diffuse: Rgb::BLACK,
        specular: Rgb::BLACK,
    };
    let (mut diffuse, mut specular) = ([T::ZERO; 4], [T::ZERO; 4]);
    let mut highlights = m.powers(Rgb::BLACK, |intensity: Rgb<L>, highlight| {
        specular = (intensity * highlight).added_to(specular);
    });
    macro_rules! add {
        ($light:expr) => {
            let IncidentLight { l, intensity, .. } = $light;
            let n_dot_l = term::lambert(n, l);
            if n_dot_l.any_positive() {
                // after the highlight, this takes a Cortex-M0 seven instructions more
                diffuse = (intensity * n_dot_l).added_to(diffuse);
                highlights.take(intensity, n_dot_l.if_positive(cosine(l), L::ZERO));
            }
        };
    }
    // The iterator's own loop is inlined where its `next` is not, which halves the time under four lights.
    // A closure would take more stack than a small chip has.
    #[cfg(not(target_os = "none"))]
    lights.for_each(|light| {
        add!(light);
    });
    #[cfg(target_os = "none")]
    for light in lights {
        add!(light);
    }
    highlights.finish();
    let color = |[r, g, b, _]: [T; 4]| Rgb::new(r, g, b);
    shaded.diffuse = color(diffuse).reflected(material.k_d);
    shaded.specular = color(specular).reflected(material.k_s);
    shaded
}
