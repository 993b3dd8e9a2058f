//! `glam`, in single precision.

use crate::vector::Vector;

// glue
impl Vector for glam::Vec3 {
    type Number = f32;
    fn dot(self, other: Self) -> f32 {
        self.dot(other)
    }
    fn cross(self, other: Self) -> Self {
        self.cross(other)
    }
}
// end of glue
