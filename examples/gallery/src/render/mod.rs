//! The renderer: rays, surfaces, scenes, and pictures. The crate does all the shading; this module
//! only finds out what is visible, and which lights reach it.

mod bvh;
pub mod film;
pub mod implicit;
pub mod label;
pub mod mesh;
pub mod png;
pub mod ray;
pub mod scene;
pub mod shape;
