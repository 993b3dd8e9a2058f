//! The lights of a sum.

use super::incident::IncidentLight;
use crate::real::{Real, Several};

/// What the [sums](crate::shade) take as lights: any iterator over [`IncidentLight`]. With the
/// feature `wide`, also `InLanes`, an iterator over several lights at a time.
///
/// There is nothing to implement or to call.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not an iterator over `IncidentLight<{T}>`",
    label = "expected the lights at a point, such as `[sun.at(p)]` or `lamps.iter().map(|lamp| lamp.at(p))`"
)]
pub trait Lights<T> {
    /// `T`, or lanes of it.
    #[doc(hidden)]
    type Number: Several<T>;

    #[doc(hidden)]
    fn arriving(self) -> impl Iterator<Item = IncidentLight<Self::Number>>;
}

#[diagnostic::do_not_recommend] // the trait's own message names the types
impl<T: Real, I: IntoIterator<Item = IncidentLight<T>>> Lights<T> for I {
    type Number = T;

    #[inline(always)]
    fn arriving(self) -> impl Iterator<Item = IncidentLight<T>> {
        self.into_iter()
    }
}
