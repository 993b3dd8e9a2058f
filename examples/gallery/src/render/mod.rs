//! The renderer: rays, surfaces, scenes and pictures. All shading is the crate's; what is here
//! only finds out what is seen, and which lights reach it.

mod bvh;
pub mod film;
pub mod implicit;
pub mod label;
pub mod mesh;
pub mod png;
pub mod ray;
pub mod scene;
pub mod shape;
