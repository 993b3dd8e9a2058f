//! Local illumination as pure functions: what light a point of a surface sends to the eye.
//!
//! A renderer hands this crate a point, a normal, a direction to the eye and some lights, and gets
//! light back: Lambert's, Phong's and Blinn's reflection, attenuated point lights, spots, and the
//! exact normals of surfaces. It draws nothing, owns no scene and knows no screen. Take it for a ray
//! tracer, a rasteriser, a display on a microcontroller, or to check a shader against.
//!
//! ```
//! use shading::*;
//!
//! static SUN: DirectionalLight<f32> = DirectionalLight { l: UnitVec3::Z, intensity: Rgb::WHITE };
//! static LAMP: PointLight<f32> = PointLight {
//!     position: Vec3::new(2.0, 0.0, 2.0),
//!     intensity: Rgb::new(1.0, 0.8, 0.6),
//!     attenuation: Attenuation::<f32>::new(1.0, 0.0, 0.25).unwrap(), // 1/(1 + q²/4)
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
//! # Why this one
//!
//! 1. **One formula, every number.** Each formula is written once, over [`Real`]: `f32`, `f64`,
//!    the dual number [`Dual`] that differentiates itself, SIMD lanes (feature `wide`), or a type of
//!    your own.
//! 2. **Total.** Every function is defined for every input of its types: no panic, no NaN from
//!    finite input, no negative light from lights and materials that are not negative. What has no
//!    answer is an `Option`.
//! 3. **The same bits everywhere.** Only + − × ÷ √ in a fixed order: an `f32` result is the same on
//!    x86-64, Arm Cortex-M0 and M4F, RISC-V and wasm, and in every SIMD lane.
//! 4. **Small and fast.** One dependency, `libm`; no allocation, no `std`; no double precision in an
//!    `f32` path (`sin` and `cos` of [`Elementary`] aside).
//! 5. **Traceable.** Every formula's page gives formula, convention, degenerate case and source.
//!
//! # Conventions
//!
//! - **All directions point away from the surface** and are [`UnitVec3`]: N, L to the light, V to
//!   the eye, R, H. [`reflection`] takes L; GLSL's `reflect` takes −L.
//! - **Colours are linear** and not limited to 1. Decode sRGB before; clamp and encode once, after.
//! - **q is the distance**, not its square, in [`attenuation`]. Directional lights have none.
//! - **A spot's angle is the half-angle**, in radians, and its edge is inside.
//! - **Lambert has no 1/π**, the highlights are not normalised: the formulas are the books'.
//! - **No highlight on a face turned from the light**: the sums in [`mod@shade`] see to it. The
//!   factors of [`mod@term`] alone do not.
//! - **m = 0 or not, a cosine ≤ 0 gives no highlight.**
//!
//! # More to read
//!
//! - Firmware, from an empty project to a lit pixel, and what each function costs: [`mod@embedded`].
//! - How fast it is, beside the same formulas by hand: [`mod@performance`].
//! - What each function gives where its formula has no answer: [`mod@totality`].
//! - How far each function is from its formula: [`mod@precision`].
//! - How to try the invariants of illumination on a number type of your own: [`mod@invariants`].
//!
//! # The floors
//!
//! Each file uses only files on floors below it.
//!
//! | floor | holds |
//! |---|---|
//! | 5 the model | [`mod@shade`]: [`lambert`](shade::lambert), [`phong`](shade::phong), [`blinn_phong`](shade::blinn_phong), the sums over lights |
//! | 4 scenes | [`DirectionalLight`], [`PointLight`], [`SpotLight`], [`Light`], [`IncidentLight`]; [`Material`] |
//! | 3 formulas | [`normal`]; [`reflection`], [`half_vector`]; [`mod@term`]; [`attenuation`], [`Attenuation`], [`Cone`] |
//! | 2 differentiation | [`Dual`] |
//! | 1 vectors, colours | [`Vec3`], [`UnitVec3`]; [`Rgb`] |
//! | 0 numbers | [`Real`], [`Elementary`]; [`Exponent`] |
//!
//! # Features
//!
//! - `approx`: `AbsDiffEq`, `RelativeEq` and `UlpsEq` for [`Vec3`], [`UnitVec3`] and [`Rgb`].
//! - `wide`: [`Real`] and [`Exponent`] for the SIMD types of the crate `wide`. A scene in scalars
//!   goes into lanes by `cast`: `light.cast(f32x8::splat)`.
//!
//! No feature is on by default.
#![no_std]
#![deny(unsafe_code)]
#![cfg_attr(
    not(any(
        all(target_arch = "x86_64", target_feature = "sse2"),
        all(target_arch = "arm", target_abi = "eabihf")
    )),
    forbid(unsafe_code)
)]
#![cfg_attr(docsrs, feature(doc_cfg))]

// floor 0: numbers
mod elementary;
mod exponent;
mod filter;
mod power;
mod real;
mod root;
// floor 1: vectors and colours
mod componentwise;
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
pub mod term;
// floor 4: scenes
mod light;
mod material;
// floor 5: the model
pub mod shade;

mod interop;
#[cfg(feature = "wide")]
mod lanes;

pub use attenuation::{Attenuation, attenuation};
pub use cone::Cone;
pub use direction::{half_vector, reflection};
pub use dual::Dual;
pub use elementary::Elementary;
pub use exponent::Exponent;
pub use light::{DirectionalLight, IncidentLight, Light, PointLight, SpotLight};
pub use material::Material;
pub use real::Real;
pub use rgb::Rgb;
pub use shade::Shaded;

pub use unit::UnitVec3;
pub use vector::Vec3;

// the types of a scene in one number type
mod aliases;
pub use aliases::{f32, f64};

// pages of the documentation, without code
#[cfg(doc)]
#[doc = include_str!("../docs/embedded.md")]
pub mod embedded {}
#[cfg(doc)]
#[doc = include_str!("../docs/invariants.md")]
pub mod invariants {}
#[cfg(doc)]
#[doc = include_str!("../docs/performance.md")]
pub mod performance {}
#[cfg(doc)]
#[doc = include_str!("../docs/precision.md")]
pub mod precision {}
#[cfg(doc)]
#[doc = include_str!("../docs/totality.md")]
pub mod totality {}

/// The README's code blocks, compiled as doc-tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
