//! Local illumination as pure functions: Lambert, Phong and Blinn–Phong shading of one point.
//!
//! Pass in a normal, the direction to the eye, a material and the light that arrives at a point.
//! Get back the reflected light: ambient, diffuse and specular apart. The crate draws nothing, owns
//! no scene and knows nothing of screens. Use it in a ray tracer or a rasterizer, on a
//! microcontroller with a display, or to check a shader.
//!
// Inside the page, because a registry shows no relative links and a page without a network no absolute ones. Renew it by
// convert docs/pictures/16_teapot.png -crop 800x530+0+30 -resize 480x -quality 85 -strip jpg:- | base64 --wrap=0
#![cfg_attr(doc, doc = include_str!("teapot.html"))]
//!
//! ```
//! use shading::f32::{Attenuation, Material, PointLight, Rgb, UnitVec3, Vec3};
//! use shading::shade;
//!
//! static LAMP: PointLight = PointLight {
//!     position: Vec3::new(2.0, 0.0, 2.0),
//!     intensity: Rgb::new(1.0, 0.8, 0.6),
//!     attenuation: Attenuation::const_new(1.0, 0.0, 0.25).unwrap(), // 1/(1 + q²/4)
//! };
//! let [k_a, k_d, k_s] = [0.1, 0.6, 0.3].map(Rgb::gray);
//! let clay = Material { k_a, k_d, k_s, m: 32 };
//!
//! let (p, n) = (Vec3::new(0.0, 0.0, 1.0), UnitVec3::Z);
//! let v = (Vec3::new(0.0, -4.0, 3.0) - p).unit().unwrap(); // to the eye
//! let shaded = shade::blinn_phong(n, v, &clay, Rgb::gray(0.2), [LAMP.at(p)]);
//! assert!(shaded.total().r > shaded.total().b);
//! ```
//!
//! # Where to find what
//!
//! | you have | you want | use |
//! |---|---|---|
//! | a surface | its normal | [`mod@normal`] |
//! | a light and a point | the light that arrives there: L, I and the distance | [`DirectionalLight`], [`PointLight`], [`SpotLight`], [`Light`] |
//! | N, V, a [`Material`], lights | the reflected light | [`shade::lambert`], [`shade::phong`], [`shade::blinn_phong`] |
//! | N, L, V | R or H | [`reflection`], [`half_vector`] |
//! | N, L, R, V or H | one factor of the formula | [`mod@term`] |
//! | a distance | the falloff of the light | [`attenuation()`], [`Attenuation`] |
//! | a spot's axis and L | the share of its light that arrives | [`Cone`] |
//! | linear light | the bytes of a picture or a display, and back | [`to_srgb8`](Rgb::<f32>::to_srgb8), [`to_rgb565`](Rgb::<f32>::to_rgb565), [`from_srgb8`](Rgb::from_srgb8), [`from_rgb565`](Rgb::from_rgb565) |
//! | a scene in one number type | short type names | [`mod@f32`], [`mod@f64`] |
//! | a number type of your own | everything above for that type | [`Real`] |
//!
//! # Conventions
//!
//! - **All directions point away from the surface** and are [`UnitVec3`]: the normal N, L to the
//!   light, V to the eye, R and H. [`reflection`] takes L; GLSL's `reflect` takes −L.
//! - **Colors are linear** and may exceed 1. Encode once, after the sum.
//! - **q is the distance**, not its square. Directional lights are not attenuated.
//! - **A shadow ray ends at the light**, at the distance that [`IncidentLight`] gives. A wall
//!   behind a lamp casts no shadow.
//! - **A spot's angle is measured from its axis**, in radians. A point on the edge is lit.
//! - **Lambert has no 1/π**, and the highlights are not normalized. If your renderer has a 1/π,
//!   [`term::phong_normalization`] and [`term::blinn_normalization`] give the factor.
//! - **A face turned away from a light has no highlight.** The sums in [`mod@shade`] ensure this;
//!   the factors in [`mod@term`] alone do not.
//! - **A cosine of 0 or below gives no highlight**, whatever m is, even m = 0.
//!
//! [`guide::totality`] lists what each function gives where its formula has no answer, and says on
//! which machines a result has the same bits. [`guide::proofs`] says what of it is proved, and
//! [`guide::precision`] bounds the errors.
//!
//! # Features
//!
//! No feature is on by default. Without features, `libm` is the only dependency.
//!
//! - `approx` implements `AbsDiffEq`, `RelativeEq` and `UlpsEq` for [`Vec3`], [`UnitVec3`],
//!   [`Rgb`], [`IncidentLight`] and [`Shaded`].
//! - `bytemuck` implements `Pod` for [`Vec3`] and [`Rgb`], and `NoUninit` for [`UnitVec3`].
//!   [`guide::buffers`] shows how to fill uniform buffers with them.
//! - `defmt` implements `Format` for all types, so that a microcontroller can log them.
//! - `mint` converts [`Vec3`] from and to `mint`'s `Vector3` and `Point3`, and [`UnitVec3`] to
//!   `Vector3`. Through these types it converts to the vectors of any version of glam, nalgebra,
//!   cgmath, euclid and vek.
//! - `serde` reads and writes lights, materials and their parts. [`guide::schema`] describes the
//!   format. Input that a constructor would refuse is an error, which names the field and the
//!   reason.
//! - `wide` implements [`Real`] and [`Exponent`] for the SIMD types of the crate `wide`. Each lane
//!   has the bits of the scalar, except on 32-bit Arm with NEON, whose `f32` instructions flush
//!   subnormal numbers. On x86 without SSE2 the feature does not build. `cast` converts a scene of
//!   scalars into lanes, to shade several points at once: `light.cast(f32x8::splat)`. To shade
//!   one point with several lights at once, [`PointLight::packed`](PointLight#method.packed) puts
//!   lights into lanes. The page of [`Lanes`](trait@Lanes) lists the functions that do not take lanes.
//!
//! # The floors
//!
//! Each file uses only files on lower floors and files to its left on its own floor.
//!
//! | floor | files |
//! |---|---|
//! | 6 names | `aliases` |
//! | 5 the model | `shade` |
//! | 4 scenes | `light` |
//! | 3 formulas | `direction`, `term`, `normal`, `attenuation`, `cone` |
//! | 2 differentiation | `dual` |
//! | 1 vectors, colors | `vector`, `unit`, `rgb`, `encoding` |
//! | 0 numbers | `real`, `exponent`, `elementary` |
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

// one paragraph per floor of the table above, the lowest first

mod elementary;
mod real;

mod encoding;
mod rgb;
mod unit;
mod vector;

mod dual;

mod attenuation;
mod cone;
mod direction;
pub mod normal;
pub mod term;

mod light;

pub mod shade;

mod aliases;
mod features;

pub use aliases::{f32, f64};
pub use attenuation::{Attenuation, attenuation};
pub use cone::Cone;
pub use direction::{half_vector, reflection};
pub use dual::Dual;
pub use elementary::Elementary;
#[cfg(feature = "wide")]
pub use features::Lanes;
pub use light::{DirectionalLight, IncidentLight, Light, PointLight, SpotLight};
pub use real::{Exponent, Real, Scalar};
pub use rgb::Rgb;
#[doc(inline)]
pub use shade::{Material, Shaded};
pub use unit::UnitVec3;
pub use vector::Vec3;

/// The guide, with one topic per page.
#[cfg(doc)]
pub mod guide {
    #[doc = include_str!("../docs/architecture.md")]
    pub mod architecture {}
    #[cfg(not(doctest))] // its examples need other crates; `tests/features` runs them
    #[doc = include_str!("../docs/buffers.md")]
    pub mod buffers {}
    #[doc = include_str!("../docs/embedded.md")]
    pub mod embedded {}
    #[doc = include_str!("../docs/invariants.md")]
    pub mod invariants {}
    #[doc = include_str!("../docs/performance.md")]
    pub mod performance {}
    #[doc = include_str!("../docs/porting.md")]
    pub mod porting {}
    #[doc = include_str!("../docs/precision.md")]
    pub mod precision {}
    #[doc = include_str!("../docs/proofs.md")]
    pub mod proofs {}
    #[doc = include_str!("../docs/recipes.md")]
    pub mod recipes {}
    #[cfg(not(doctest))] // its examples need other crates; `tests/features` runs them
    #[doc = include_str!("../docs/renderers.md")]
    pub mod renderers {}
    #[cfg(not(doctest))] // its examples need other crates; `tests/features` runs them
    #[doc = include_str!("../docs/schema.md")]
    pub mod schema {}
    #[doc = include_str!("../docs/shader.md")]
    pub mod shader {}
    #[doc = include_str!("../docs/totality.md")]
    pub mod totality {}
    #[doc = include_str!("../docs/vectors.md")]
    pub mod vectors {}
}

/// The README's code blocks, compiled as documentation tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
