//! `nalgebra`, in double precision.

use crate::vector::Vector;

// glue
impl Vector for nalgebra::Vector3<f64> {
    type Number = f64;
    fn of(coordinates: [f64; 3]) -> Self {
        coordinates.into()
    }
    fn array(self) -> [f64; 3] {
        self.into()
    }
    fn dot(self, other: Self) -> f64 {
        nalgebra::Matrix::dot(&self, &other)
    }
    fn cross(self, other: Self) -> Self {
        nalgebra::Matrix::cross(&self, &other)
    }
}
// end of glue
