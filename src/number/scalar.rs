//! Numbers that can be compared as a whole.

/// A number that can be compared as a whole. Every [`PartialOrd`] type is a scalar. SIMD lanes are
/// not, because one lane may be greater where another is less.
///
/// A function that decides whether to return `Some` or `None` asks for a scalar. In generic code,
/// write `T: Real + PartialOrd`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be compared as a whole, and this function must decide whether there is a result",
    label = "expected `f32`, `f64` or `Dual<_>`",
    note = "with SIMD lanes, call it for each lane, or call a function that returns no `Option`: `Vec3::unit_or` or `cast`",
    note = "in generic code, write `T: Real + PartialOrd`"
)]
pub trait Scalar: PartialOrd {}

#[diagnostic::do_not_recommend] // the trait's own message says what to do
impl<T: PartialOrd> Scalar for T {}
