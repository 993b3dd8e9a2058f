//! Improved: a note on `Real` says what to write.

use shading::Vec3;

fn main() {
    let _up = Vec3::new(0, 0, 1);
}
