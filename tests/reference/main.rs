//! Values that others computed (`tests/data/README.md`), a module for each source.

#[path = "../support/mod.rs"]
mod support;

mod gradients;
mod normals;
mod opengl;
mod povray;
mod specular_and_attenuation;
mod tachyon;
