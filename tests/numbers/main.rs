//! Every property, for every number: `f32::light::lights_add_up`.

mod broken;
mod naive;

mod f32 {
    properties::all!(f32, with functions);
}

mod f64 {
    properties::all!(f64, with functions);
}

mod dual {
    properties::all!(shading::Dual<f64>);
}

/// A half: 11 bits, and a short range with subnormal numbers.
mod half {
    properties::all!(crate::naive::Half);
}

mod bf16 {
    properties::all!(crate::naive::Bf16);
}

/// Saturating fixed point, 16.16.
mod q16 {
    properties::all!(crate::naive::Q16, without doubling);
}

/// The crate's own fixed point: ties go up, and a sum of light holds more digits than a color.
#[cfg(feature = "fixed")]
mod fixed {
    properties::all!(shading::fixed::Fixed, without doubling, mirroring, ordering, plain);
}
