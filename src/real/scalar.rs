//! A number that decides for itself whether there is a result.

/// A number that can be compared as a whole. Every [`PartialOrd`] type is a scalar. SIMD lanes are
/// not, because one lane may be greater where another is less.
///
/// A function that decides whether to return `Some` or `None` asks for a scalar. In generic code,
/// `T: Real + PartialOrd` is enough:
///
/// ```
/// use shading::{Real, UnitVec3, Vec3, normal};
///
/// fn north_pole<T: Real + PartialOrd>(radius: T) -> Option<UnitVec3<T>> {
///     normal::sphere(Vec3::ZERO, Vec3::new(T::ZERO, T::ZERO, radius))
/// }
/// assert_eq!(north_pole(2.0), Some(UnitVec3::<f32>::Z));
/// assert_eq!(north_pole(0.0_f32), None);
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be compared as a whole, and this function must decide whether there is a result",
    label = "expected `f32`, `f64`, `Fixed` or `Dual<_>`",
    note = "with SIMD lanes, call it for each lane, or call a function that returns no `Option`: `Vec3::unit_or` or `cast`",
    note = "in generic code, write `T: Real + PartialOrd`"
)]
pub trait Scalar: PartialOrd {}

#[diagnostic::do_not_recommend] // the trait's own message says what to do
impl<T: PartialOrd> Scalar for T {}
