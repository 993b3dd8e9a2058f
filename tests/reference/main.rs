//! Values that others computed (`tests/data/README.md`), a module for each source.

// what the comparisons share
mod running;
mod scene;
mod surfaces;
mod table;
// the sources
mod engines;
mod gradients;
mod normals;
mod opengl;
mod povray;
mod specular_and_attenuation;
mod tachyon;
mod three_js;
