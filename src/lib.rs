//! Local illumination as pure functions: Lambert, Phong and Blinn–Phong shading of one point.
//!
//! Pass in a point, a normal, the direction to the eye and some lights; get the reflected light back,
//! part by part. The crate draws nothing, owns no scene and knows no screen. Use it in a ray tracer, a
//! rasterizer, on a display of a microcontroller, or to check a shader.
//!
//! ```
//! use shading::f32::{Attenuation, DirectionalLight, Material, PointLight, Rgb, UnitVec3, Vec3};
//! use shading::{normal, shade};
//!
//! static SUN: DirectionalLight = DirectionalLight { l: UnitVec3::Z, intensity: Rgb::WHITE };
//! static LAMP: PointLight = PointLight {
//!     position: Vec3::new(2.0, 0.0, 2.0),
//!     intensity: Rgb::new(1.0, 0.8, 0.6),
//!     attenuation: Attenuation::new(1.0, 0.0, 0.25).unwrap(), // 1/(1 + q²/4)
//! };
//! let clay = Material { k_a: Rgb::gray(0.1), k_d: Rgb::gray(0.6), k_s: Rgb::gray(0.3), m: 32 };
//!
//! let p = Vec3::new(0.0, 0.0, 1.0);
//! let n = normal::implicit(|p| p.dot(p) - 1.0, p).unwrap(); // the unit sphere
//! let v = (Vec3::new(0.0, -4.0, 3.0) - p).unit().unwrap();
//! let shaded = shade::blinn_phong(n, v, &clay, Rgb::gray(0.2), [SUN.at(p), LAMP.at(p)]);
//! assert!(shaded.total().r > shaded.total().b);
//! ```
//!
//! # Where to find what
//!
//! | you have | you want | use |
//! |---|---|---|
//! | a surface | its normal | [`mod@normal`] |
//! | a light and a point | L, I and the distance there | [`DirectionalLight`], [`PointLight`], [`SpotLight`], [`Light`] |
//! | N, V, a [`Material`], lights | the reflected light | [`shade::lambert`], [`shade::phong`], [`shade::blinn_phong`] |
//! | N, L, V | R or H | [`reflection`], [`half_vector`] |
//! | directions | one factor of the formula | [`mod@term`] |
//! | a distance | the falloff | [`attenuation()`], [`Attenuation`], within a range [`Ranged`] |
//! | the axis of a spot and L | its share of light | [`Cone`], with a soft edge [`SoftCone`] |
//! | linear light | the bytes of a picture or a display, and back | [`Rgb::to_srgb8`], [`Rgb::to_rgb565`], [`Rgb::from_srgb8`] |
//! | a scene in one number type | short type names | [`mod@f32`], [`mod@f64`] |
//! | a number type of your own | all of this for it | [`Real`] |
//!
//! # What it promises
//!
//! 1. **One formula, every number.** Each formula is written once, over [`Real`]: for `f32`, `f64`, the
//!    dual number [`Dual`], SIMD lanes (feature `wide`), or a type of your own.
//! 2. **Total.** Every function is defined for every input of its types, and none panics, whatever the
//!    bits. The formulas of illumination turn finite valid input (directions of length 1, lights and
//!    materials that are not negative) into finite light that is not negative. What has no answer is an
//!    `Option`. As in floats, a dot or cross product that overflows may be NaN: [`guide::totality`] lists
//!    every such case.
//! 3. **The same bits everywhere.** Only + − × ÷ √ in a fixed order: an `f32` result is the same on every
//!    machine that rounds as IEEE 754 says, and in every SIMD lane. The exceptions are x86 without SSE2, and
//!    programs that flush subnormal numbers to 0.
//! 4. **Small and fast.** One dependency, `libm`; no allocation, no `std`; no double precision in an
//!    `f32` path (`sin` and `cos` of [`Elementary`] aside).
//! 5. **Traceable.** Every formula's page gives the formula, convention, degenerate cases and source.
//!
//! # Conventions
//!
//! - **All directions point away from the surface** and are [`UnitVec3`]: N, L to the light, V to
//!   the eye, R, H. [`reflection`] takes L; GLSL's `reflect` takes −L.
//! - **Colors are linear** and not limited to 1. Decode sRGB before ([`Rgb::from_srgb8`]); encode once,
//!   after ([`Rgb::to_srgb8`]).
//! - **q is the distance**, not its square, in [`attenuation()`]. Directional lights have none.
//! - **A shadow ray ends at the light**: [`IncidentLight`] gives its distance. A wall behind a lamp casts
//!   no shadow.
//! - **A spot's angle is the half-angle**, in radians, and its edge is inside.
//! - **Lambert has no 1/π**, and the highlights are not normalized: the formulas are the books'. For
//!   renderers with a 1/π there is [`term::blinn_normalization`].
//! - **A face turned away from a light has no highlight.** The sums in [`mod@shade`] ensure it; the
//!   factors in [`mod@term`] alone do not.
//! - **A cosine ≤ 0 gives no highlight**, for every m, m = 0 included.
//!
//! # Features
//!
//! - `approx`: `AbsDiffEq`, `RelativeEq` and `UlpsEq` for [`Vec3`], [`UnitVec3`], [`Rgb`],
//!   [`IncidentLight`] and [`Shaded`].
//! - `bytemuck`: `Pod` for [`Vec3`] and [`Rgb`], `NoUninit` for [`UnitVec3`]. [`guide::buffers`] shows how
//!   to fill uniform buffers with them.
//! - `defmt`: `Format` for all types, to log them on a microcontroller.
//! - `mint`: [`Vec3`] from and to `mint`'s `Vector3` and `Point3`, and [`UnitVec3`] to `Vector3`. Through
//!   them it converts to the vectors of glam, nalgebra, cgmath, euclid and vek, in any version.
//! - `serde`: reads and writes lights, materials and their parts. [`guide::schema`] gives the format. Input
//!   that a constructor would refuse is an error with the field's name and the reason.
//! - `wide`: [`Real`] and [`Exponent`] for the SIMD types of the crate `wide`; each lane has the bits of
//!   the scalar. The exception is 32-bit Arm with NEON, whose `f32` instructions flush subnormal numbers;
//!   on x86 without SSE2 the feature does not build. `cast` takes a scene in scalars into lanes:
//!   `light.cast(f32x8::splat)`.
//!
//! No feature is on by default.
//!
//! # The floors
//!
//! Each file uses only files on floors below it, and those to its left on its own floor.
//!
//! | floor | files |
//! |---|---|
//! | 5 the model | `shade` |
//! | 4 scenes | `light`, `material` |
//! | 3 formulas | `direction`, `term`, `normal`, `attenuation`, `range`, `cone`, `soft_cone` |
//! | 2 differentiation | `dual` |
//! | 1 vectors, colors | `componentwise`, `vector`, `rescale`, `unit`, `rgb`, `encoding` |
//! | 0 numbers | `root`, `real`, `power`, `elementary`, `exponent` |
#![no_std]
#![deny(unsafe_code)]
#![cfg_attr(
    not(any(
        feature = "bytemuck",
        all(target_arch = "x86_64", target_feature = "sse2"),
        all(target_arch = "arm", target_abi = "eabihf")
    )),
    forbid(unsafe_code)
)]
#![cfg_attr(docsrs, feature(doc_cfg))]

// floor 0: numbers
mod elementary;
mod exponent;
mod power;
mod real;
mod root;
// floor 1: vectors and colours
mod componentwise;
mod encoding;
mod rescale;
mod rgb;
mod unit;
mod vector;
// floor 2: differentiation
mod dual;
// floor 3: formulas
mod attenuation;
mod cone;
mod direction;
pub mod normal;
mod range;
mod soft_cone;
pub mod term;
// floor 4: scenes
mod light;
mod material;
// floor 5: the model
pub mod shade;

// the optional features
mod features;

pub use attenuation::{Attenuation, Falloff, attenuation};
pub use cone::{Beam, Cone};
pub use direction::{half_vector, reflection};
pub use dual::Dual;
pub use elementary::Elementary;
pub use exponent::Exponent;
pub use light::{DirectionalLight, IncidentLight, Light, PointLight, SpotLight};
pub use material::Material;
pub use range::Ranged;
pub use real::Real;
pub use rgb::Rgb;
pub use shade::Shaded;
pub use soft_cone::SoftCone;

pub use unit::UnitVec3;
pub use vector::Vec3;

// the types of a scene in one number type
mod aliases;
pub use aliases::{f32, f64};

/// Pages on one topic each, beside the pages of the functions.
#[cfg(doc)]
pub mod guide {
    #[doc = include_str!("../docs/architecture.md")]
    pub mod architecture {}
    #[cfg(not(doctest))] // it needs more crates: `tests/features` runs its examples
    #[doc = include_str!("../docs/buffers.md")]
    pub mod buffers {}
    #[doc = include_str!("../docs/embedded.md")]
    pub mod embedded {}
    #[doc = include_str!("../docs/invariants.md")]
    pub mod invariants {}
    #[doc = include_str!("../docs/performance.md")]
    pub mod performance {}
    #[doc = include_str!("../docs/precision.md")]
    pub mod precision {}
    #[doc = include_str!("../docs/recipes.md")]
    pub mod recipes {}
    #[cfg(not(doctest))] // it needs more crates: `tests/features` runs its examples
    #[doc = include_str!("../docs/schema.md")]
    pub mod schema {}
    #[doc = include_str!("../docs/totality.md")]
    pub mod totality {}
    #[doc = include_str!("../docs/vectors.md")]
    pub mod vectors {}
}

/// The README's code blocks, compiled as doc-tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
