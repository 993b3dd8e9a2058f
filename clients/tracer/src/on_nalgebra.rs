//! `nalgebra`, in double precision.

use crate::vector::Vector;

// glue
impl Vector for nalgebra::Vector3<f64> {
    type Number = f64;
    fn dot(self, other: Self) -> f64 {
        nalgebra::Matrix::dot(&self, &other)
    }
    fn cross(self, other: Self) -> Self {
        nalgebra::Matrix::cross(&self, &other)
    }
}
// end of glue
