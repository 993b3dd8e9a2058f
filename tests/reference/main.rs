//! Values computed by others (`tests/data/README.md`), one module per source.

// shared by the comparisons
mod json;
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
