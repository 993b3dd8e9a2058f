//! A small ray tracer over any vectors: here those of `glam` and of `nalgebra`. `scene.rs` has what
//! concerns `shading`: lights, shadows, and one sum for each pixel.

pub mod bvh;
pub mod mesh;
mod on_glam;
mod on_nalgebra;
pub mod picture;
pub mod scene;
pub mod vector;
