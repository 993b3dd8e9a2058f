//! Local illumination as pure functions: Lambert, Phong and Blinn–Phong shading of a point.
//!
// The picture is part of the page, because a registry shows no relative links, and a page without
// a network no absolute ones. To renew it, run convert docs/pictures/teapot.png -crop 800x530+0+30
// -resize 480x -quality 85 -strip jpg:- | base64 --wrap=0
#![cfg_attr(doc, doc = include_str!("teapot.html"))]
//!
//! # Example
//!
//! A lamp lights the top of a unit sphere, from the point to the bytes of a pixel:
//!
//! ```
//! use shading::f32::{Attenuation, Material, PointLight, Rgb, Vec3};
//! use shading::{normal, shade};
//!
//! let lamp = PointLight {
//!     position: Vec3::new(2.0, 0.0, 2.0),
//!     intensity: Rgb::new(1.0, 0.8, 0.6),
//!     attenuation: Attenuation::new(1.0, 0.0, 0.25).unwrap(), // 1/(1 + q²/4)
//! };
//! let clay = Material { k_a: Rgb::gray(0.1), k_d: Rgb::gray(0.6), k_s: Rgb::gray(0.3), m: 32 };
//!
//! let p = Vec3::new(0.0, 0.0, 1.0);
//! let n = normal::sphere(Vec3::ZERO, p).unwrap();
//! let v = (Vec3::new(0.0, -4.0, 3.0) - p).unit().unwrap(); // to the eye
//! let lights = [lamp].into_iter().map(|light| light.at(p)); // `.filter` out those in shadow
//! let shaded = shade::blinn_phong(n, v, &clay, Rgb::gray(0.2), lights);
//! let [red, green, blue] = shaded.total().to_srgb8();
//! ```
//!
//! Vectors of other libraries are converted through arrays, by `Vec3::from(array)` and
//! `<[f32; 3]>::from(v)`; `at` accepts every type that converts to an array. For a direction that is
//! already normalized, write [`UnitVec3::assume_unit`]`(array.into())`. The generic types, such as
//! `shading::PointLight<T>`, accept every number type. The aliases in [`mod@f32`] and [`mod@f64`]
//! name one, so that literals need no annotation. Constructors for constants begin with `const_`,
//! such as `Attenuation::const_new`.
//!
//! # What it computes
//!
//! | | formula | function |
//! |---|---|---|
//! | the model | k_a I_a + Σ I (k_d max(0, N·L) + k_s highlight) | [`shade::lambert`], [`shade::phong`], [`shade::blinn_phong`] |
//! | ambient term | k_a I_a | [`term::ambient`] |
//! | Lambert's factor | max(0, N·L) | [`term::lambert`] |
//! | Phong's highlight | max(0, R·V)ᵐ | [`term::phong`] |
//! | Blinn's highlight | max(0, N·H)ᵐ | [`term::blinn`] |
//! | reflection vector | R = 2(N·L)N − L | [`reflection`] |
//! | half vector | H = (L + V)/\|L + V\| | [`half_vector`] |
//! | normalization | (m + 2)/(2π), (m + 2)(m + 4)/(8π(2^(−m/2) + m)) | [`term::phong_normalization`], [`term::blinn_normalization`] |
//! | attenuation | 1/(a + bq + cq²) | [`attenuation`](attenuation()), [`Attenuation`] |
//! | range | max(0, 1 − (q/r)⁴)²/(a + bq + cq²), or without the square | [`Attenuation::within`], [`Attenuation::within_gltf`] |
//! | spot | t² or t²(3 − 2t), t from 0 at the outer edge to 1 at the inner | [`Cone`] |
//! | what arrives at p | L, I and q | [`DirectionalLight`], [`PointLight`], [`SpotLight`], [`Light`] |
//! | plane | (a, b, c)/\|(a, b, c)\| | [`normal::plane`] |
//! | triangle | (v₂ − v₁) × (v₃ − v₁), length 1 | [`normal::triangle`] |
//! | sphere | (p − center)/\|p − center\| | [`normal::sphere`] |
//! | implicit surface | ∇f/\|∇f\| | [`normal::implicit`], [`normal::from_gradient`] |
//! | parametric surface | ∂s/∂u × ∂s/∂v, length 1 | [`normal::parametric`], [`normal::from_tangents`] |
//! | two-sided surface | N if F·V ≥ 0, else −N | [`normal::facing`] |
//! | transformed normal | cof(M) N, length 1 | [`normal::transformed`] |
//! | smooth mesh | a triangle's normal times its angle at a vertex, to be summed | [`normal::corner`] |
//! | tangents | t and h of a triangle with texture coordinates | [`normal::tangent`] |
//! | normal map | x t + y b + z N, length 1 | [`normal::mapped`] |
//! | encodings | linear light to sRGB bytes or RGB565, and back | [`Rgb::to_srgb8`](Rgb::<f32>::to_srgb8), [`Rgb::to_rgb565`](Rgb::<f32>::to_rgb565), [`Rgb::from_srgb8`], [`Rgb::from_rgb565`] |
//!
//! F is the normal of the face; N is the normal that you shade with.
//!
//! # Conventions
//!
//! - **All directions point away from the surface** and are [`UnitVec3`]: the normal N, L to the light, V
//!   to the eye, R and H.
//! - **Colors are linear** and may exceed 1. Encode once, after the sum.
//! - **q is the distance**, not its square. Directional lights are not attenuated.
//! - **A shadow ray ends at the light**, at its [distance](IncidentLight::distance): geometry beyond the
//!   light does not block it.
//! - **A spot's angle is measured from its axis**, in radians. A point on the edge is lit.
//! - **Lambert has no 1/π**, and the highlights are not normalized.
//! - **A face turned away from a light has no highlight** in the sums of [`mod@shade`]; the factors in
//!   [`mod@term`] do not check this.
//! - **A cosine of 0 or below gives no highlight**, whatever m is, even m = 0.
//!
//! # Features
//!
//! No feature is on by default. Without features, `libm` is the only dependency.
//!
//! - `approx` implements `AbsDiffEq`, `RelativeEq` and `UlpsEq` for vectors, colors, [`IncidentLight`] and
//!   [`Shaded`].
//! - `bytemuck` implements `Pod` for [`Vec3`] and [`Rgb`], and `NoUninit` for [`UnitVec3`].
//! - `defmt` implements `Format` for the types of a scene, so that a microcontroller can log them.
//! - `fixed` adds a signed 16.16 fixed-point number, and aliases of the scene types that use it.
//! - `mint` converts [`Vec3`] from and to `mint`'s `Vector3` and `Point3`, and [`UnitVec3`] to `Vector3`.
//! - `serde` reads and writes lights and materials; invalid input is an error that says what is wrong and, in a
//!   text format, where.
//! - `wide` implements [`Real`] and [`Lobe`] for the SIMD types of the crate `wide`.
//!
//! # Guide
//!
//! - [Recipes](guide::recipes): parts of a renderer to copy, found by what you see or by topic, on five
//!   pages: [lights](guide::lights), [surfaces](guide::surfaces), [materials](guide::materials), [images
//!   and colors](guide::colors) and [speed](guide::speed).
//! - [Porting](guide::porting): how to replace your own loop and keep your vectors; the lights of other programs.
//! - [Numbers](guide::numbers): how to compute with a number type of your own.
//! - [Embedded](guide::embedded): from an empty folder to a picture on an emulated board; costs on chips.
//! - [GPU](guide::gpu): the formulas in shading languages, and scenes in buffers.
//! - [C](guide::c): the formulas in C and C++, without Rust.
//! - [Scenes in files](guide::schema): the forms that `serde` reads.
//! - [Totality](guide::totality): what each function gives where its formula has no answer.
//! - [Proofs](guide::proofs): which of that is proved, and how.
//! - [Precision](guide::precision): how far each function is from its formula.
//! - [Performance](guide::performance): which way to take, and what it costs.
//! - [Sources](guide::sources): where each formula comes from, and whether the source was read.
//!
//! # References
//!
//! - J. H. Lambert, *Photometria*, 1760.
//! - B. T. Phong, *Illumination for Computer Generated Pictures*, 1975.
//! - J. F. Blinn, *Models of Light Reflection for Computer Synthesized Pictures*, 1977; *Simulation of
//!   Wrinkled Surfaces*, 1978; M. S. Mikkelsen, *Simulation of Wrinkled Surfaces Revisited*, 2008.
//! - J. D. Foley, A. van Dam, S. K. Feiner, J. F. Hughes, *Computer Graphics: Principles and Practice*,
//!   2nd ed., 1990.
//! - *The OpenGL Graphics System: A Specification*, version 2.1, 2006.
//! - Khronos, *KHR_lights_punctual*, an extension of glTF 2.0.
//! - A. Griewank, A. Walther, *Evaluating Derivatives*, 2nd ed., 2008.
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

// one paragraph per layer of the table in CONTRIBUTING.md, the lowest first

pub mod number;
mod target;

mod color;
mod vector;

mod dual;

mod direction;
pub mod normal;
pub mod term;

mod light;

pub mod shade;

mod aliases;

#[cfg(feature = "fixed")]
pub mod fixed;
#[cfg(feature = "wide")]
mod lanes;

mod features;

pub use aliases::{f32, f64};
pub use color::Rgb;
pub use direction::{half_vector, reflection};
pub use dual::Dual;
#[cfg(feature = "wide")]
pub use lanes::Lanes;
pub use light::{Arrival, DirectionalLight, IncidentLight, Light, PointLight, SpotLight};
pub use light::{Attenuation, Cone, attenuation};
pub use number::elementary::Elementary;
pub use number::lobe::Lobe;
pub use number::real::Real;
pub use number::scalar::Scalar;
#[doc(inline)]
pub use shade::{Material, Shaded};
pub use vector::{UnitVec3, Vec3};

#[cfg(all(doc, not(doctest)))]
macro_rules! pages {
    ($($name:ident, $file:literal: $purpose:literal $(, $alias:literal)*;)*) => {$(
        #[doc = $purpose]
        ///
        // the first definition of a link counts, so these replace those of the files
        /// [falloffs]: mod@crate::guide::lights#falloffs-beams-and-filters-of-your-own
        /// [gltf]: mod@crate::guide::lights#lights-of-a-gltf-file
        /// [programs]: mod@crate::guide::porting#lights-and-materials-of-other-programs
        /// [watts]: mod@crate::guide::lights#lumen-and-candela
        /// [display]: mod@crate::guide::embedded#a-mesh-on-a-display
        /// [laws]: https://docs.rs/shading-laws
        /// [embedded]: mod@crate::guide::embedded
        /// [c]: mod@crate::guide::c
        /// [gpu]: mod@crate::guide::gpu
        /// [numbers]: mod@crate::guide::numbers
        /// [performance]: mod@crate::guide::performance
        /// [porting]: mod@crate::guide::porting
        /// [precision]: mod@crate::guide::precision
        /// [proofs]: mod@crate::guide::proofs
        /// [recipes]: mod@crate::guide::recipes
        /// [lanes]: mod@crate::guide::speed#points-in-lanes
        /// [a-highlight-that-fades]: mod@crate::guide::materials#a-highlight-that-fades
        /// [a-normal-map-of-a-height-image]: mod@crate::guide::surfaces#a-normal-map-of-a-height-image
        /// [a-relief-that-looks-wrong]: mod@crate::guide::surfaces#a-relief-that-looks-wrong
        /// [a-shininess-from-a-roughness]: mod@crate::guide::materials#a-shininess-from-a-roughness
        /// [ambient-light]: mod@crate::guide::lights#ambient-light
        /// [area-lights]: mod@crate::guide::lights#area-lights
        /// [bands]: mod@crate::guide::colors#bands
        /// [brighter-at-a-grazing-angle]: mod@crate::guide::materials#brighter-at-a-grazing-angle
        /// [bumps-from-heights]: mod@crate::guide::surfaces#bumps-from-heights
        /// [color-temperature]: mod@crate::guide::lights#color-temperature
        /// [colors]: mod@crate::guide::colors
        /// [colors-of-16-bits]: mod@crate::guide::speed#colors-of-16-bits
        /// [cool-to-warm-shading]: mod@crate::guide::materials#cool-to-warm-shading
        /// [depth-images]: mod@crate::guide::surfaces#depth-images
        /// [distances-along-the-ray]: mod@crate::guide::surfaces#distances-along-the-ray
        /// [exposure-and-luminance]: mod@crate::guide::colors#exposure-and-luminance
        /// [falloffs-beams-and-filters-of-your-own]: mod@crate::guide::lights#falloffs-beams-and-filters-of-your-own
        /// [filters-of-svg]: mod@crate::guide::surfaces#filters-of-svg
        /// [fog-toward-the-eye]: mod@crate::guide::colors#fog-toward-the-eye
        /// [globes-and-the-moon]: mod@crate::guide::surfaces#globes-and-the-moon
        /// [gouraud-shading]: mod@crate::guide::speed#gouraud-shading
        /// [hair-brushed-metal-and-lines]: mod@crate::guide::materials#hair-brushed-metal-and-lines
        /// [height-maps-and-the-sun]: mod@crate::guide::surfaces#height-maps-and-the-sun
        /// [highlights-that-sparkle]: mod@crate::guide::materials#highlights-that-sparkle
        /// [leaves-and-paper]: mod@crate::guide::materials#leaves-and-paper
        /// [lights]: mod@crate::guide::lights
        /// [lights-below-the-face]: mod@crate::guide::lights#lights-below-the-face
        /// [lights-of-a-gltf-file]: mod@crate::guide::lights#lights-of-a-gltf-file
        /// [limits-and-ranges]: mod@crate::guide::lights#limits-and-ranges
        /// [lumen-and-candela]: mod@crate::guide::lights#lumen-and-candela
        /// [marching-cubes]: mod@crate::guide::surfaces#marching-cubes
        /// [materials]: mod@crate::guide::materials
        /// [materials-of-threejs]: mod@crate::guide::materials#materials-of-threejs
        /// [mirrored-objects]: mod@crate::guide::surfaces#mirrored-objects
        /// [moved-and-morphed-meshes]: mod@crate::guide::surfaces#moved-and-morphed-meshes
        /// [normal-maps]: mod@crate::guide::surfaces#normal-maps
        /// [one-space]: mod@crate::guide::surfaces#one-space
        /// [points-in-lanes]: mod@crate::guide::speed#points-in-lanes
        /// [reliefs]: mod@crate::guide::surfaces#reliefs-and-surface-plots-of-other-programs
        /// [rim-lights-and-toon-highlights]: mod@crate::guide::materials#rim-lights-and-toon-highlights
        /// [rough-surfaces]: mod@crate::guide::materials#rough-surfaces
        /// [shadows]: mod@crate::guide::lights#shadows
        /// [smooth-meshes-and-creases]: mod@crate::guide::surfaces#smooth-meshes-and-creases
        /// [speed]: mod@crate::guide::speed
        /// [spherical-lamps]: mod@crate::guide::lights#spherical-lamps
        /// [spots]: mod@crate::guide::lights#spots
        /// [surfaces]: mod@crate::guide::surfaces
        /// [textures-and-emission]: mod@crate::guide::colors#textures-and-emission
        /// [two-normal-maps]: mod@crate::guide::surfaces#two-normal-maps
        /// [two-sided-surfaces]: mod@crate::guide::surfaces#two-sided-surfaces
        /// [wavefront-materials]: mod@crate::guide::materials#wavefront-materials
        /// [wrapped-and-toon-shading]: mod@crate::guide::materials#wrapped-and-toon-shading
        /// [schema]: mod@crate::guide::schema
        /// [sources]: mod@crate::guide::sources
        /// [totality]: mod@crate::guide::totality
        ///
        #[doc = include_str!($file)]
        $(#[doc(alias = $alias)])*
        pub mod $name {}
    )*};
}

/// The guide, with one topic per page.
#[cfg(all(doc, not(doctest)))] // `.ci/pages` compiles the examples as a reader sees them
pub mod guide {
    pages! {
        embedded, "../docs/embedded.md": "From an empty folder to a picture on an emulated board, and what the functions cost on chips.";
        c, "../docs/c.md": "The formulas in C and C++, without Rust.";
        gpu, "../docs/gpu.md": "The formulas in shading languages, and scenes in uniform and storage buffers.";
        numbers, "../docs/numbers.md": "How to compute with a number type of your own, and how to test it.";
        performance, "../docs/performance.md": "Which way to take, and what it costs.";
        porting, "../docs/porting.md": "How to replace a loop of your own, with your vectors.",
            "three", "babylon", "godot", "unity", "unreal", "bevy", "blender",
            "opengl", "directx", "javafx", "panda3d", "collada", "usd";
        precision, "../docs/precision.md": "How far each function is from its formula.";
        proofs, "../docs/proofs.md": "Which promises are proved, from what, and how to prove one of your own.";
        recipes, "../docs/recipes.md": "Parts of a renderer to copy, by what you see and by topic.";
        lights, "../docs/lights.md": "Recipes for lamps, suns and spots: shadows, falloffs, files and units.",
            "hemisphere", "shadow", "penumbra", "flashlight", "candela", "lumen", "kelvin", "gltf", "voxel", "solar";
        surfaces, "../docs/surfaces.md": "Recipes for normals: both sides, meshes, maps, heights and depths.",
            "bump", "hillshade", "terrain", "heightmap", "crease", "skinning", "depth", "stl", "svg", "globe", "moon";
        materials, "../docs/materials.md": "Recipes for materials: plastic, clay, leaves, hair, files and other programs.",
            "roughness", "fresnel", "mtl", "toon", "rim", "metal", "anisotropic", "subsurface";
        colors, "../docs/colors.md": "Recipes for images: textures, exposure, bands and fog.",
            "texture", "exposure", "tonemap", "dither", "fog", "gamma";
        speed, "../docs/speed.md": "Recipes for speed: Gouraud shading, and points in lanes.", "simd", "interpolate";
        schema, "../docs/schema.md": "The forms in which `serde` reads and writes lights and materials.";
        sources, "../docs/sources.md": "Where each formula comes from, and whether the source was read.";
        totality, "../docs/totality.md": "What each function gives where its formula has no answer.";
    }
}

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
