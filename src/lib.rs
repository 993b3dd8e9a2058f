//! Local illumination as pure functions.
#![no_std]
#![cfg_attr(
    not(all(target_arch = "arm", target_abi = "eabihf")),
    forbid(unsafe_code)
)]
#![cfg_attr(docsrs, feature(doc_cfg))]

// floor 0: numbers
mod exponent;
mod real;
mod root;
// floor 1: vectors and colours
mod componentwise;
mod rgb;
mod vector;
// floor 2: differentiation
mod dual;
// floor 3: formulas
mod attenuation;
mod direction;
pub mod normal;
mod term;
// floor 4: scenes
mod light;
mod material;
// floor 5: the model
pub mod shade;

mod interop;

pub use attenuation::{Attenuation, Cone, attenuation};
pub use direction::{half_vector, reflection};
pub use dual::Dual;
pub use exponent::Exponent;
pub use light::{DirectionalLight, IncidentLight, Light, PointLight, SpotLight};
pub use material::Material;
pub use real::{Elementary, Real};
pub use rgb::Rgb;
pub use shade::Shaded;
pub use term::{ambient, blinn, lambert, phong};
pub use vector::{UnitVec3, Vec3};
