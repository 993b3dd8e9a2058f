//! `glam`, in single precision.

use crate::vector::Vector;

// glue
impl Vector for glam::Vec3 {
    type Number = f32;
    fn of(coordinates: [f32; 3]) -> Self {
        Self::from_array(coordinates)
    }
    fn array(self) -> [f32; 3] {
        self.to_array()
    }
    fn dot(self, other: Self) -> f32 {
        self.dot(other)
    }
    fn cross(self, other: Self) -> Self {
        self.cross(other)
    }
}
// end of glue
