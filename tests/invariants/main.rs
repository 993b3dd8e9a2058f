//! The invariants of local illumination, for every number type.
//!
//! The properties are in `laws/src/number`. Here they are tested for this crate's number types and for one
//! that users might write.

#![allow(clippy::float_cmp)] // floats are compared exactly, on purpose
#![allow(clippy::cast_precision_loss)] // counts of lights

mod encoding;
#[cfg(feature = "wide")]
mod lanes;
mod short;

mod single {
    shading_laws::number!(f32);
}
mod double {
    shading_laws::number!(f64);
}
mod dual {
    shading_laws::number!(shading::Dual<f64>, integer powers);
}
#[cfg(feature = "fixed")]
mod fixed {
    shading_laws::number!(shading::fixed::Fixed, integer powers);
}
