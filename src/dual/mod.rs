//! Dual numbers, which carry their own derivatives.

mod functions;
mod real;

use core::cmp::Ordering;
use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::number::triple::assign;
use crate::number::{Elementary, Real};
use crate::vector::Vec3;

/// A dual number: a value and its gradient, ∇ = (∂/∂x, ∂/∂y, ∂/∂z).
///
/// Arithmetic on dual numbers is forward-mode automatic differentiation. It gives the exact
/// derivatives of a function as written, so you neither derive formulas on paper nor choose a step
/// size.
///
/// [`normal::implicit`](crate::normal::implicit) and
/// [`normal::parametric`](crate::normal::parametric) pass such numbers to your function. They mix
/// with plain numbers: `p.dot(p) - 1.0`, `2.0 * p.x`. Comparisons compare only the values. Where
/// the derivative does not exist (√ at 0, ln below 0), the gradient is not finite. A choice, as
/// [`max`](Dual::max) makes it, has the gradient of the number chosen, also where the two are equal.
///
/// The value is that of the plain number, to the bit. One exception: a `Dual` of
/// fixed-point numbers dims and sums light by the formulas, and has fewer digits of it than fixed point.
///
/// ```
/// use shading::{Dual, Vec3};
///
/// let p = Dual::point(Vec3::new(3.0_f64, 0.0, 2.0));
/// let f = p.x.powi(2) * p.z + p.y.cos();
/// assert_eq!(f.value, 19.0);
/// assert_eq!(f.gradient, Vec3::new(12.0, 0.0, 9.0)); // (2xz, −sin y, x²)
/// ```
///
/// Source: William K. Clifford, *Preliminary Sketch of Biquaternions*, 1873; Griewank and Walther
/// 2008.
#[doc(alias = "autodiff")]
#[derive(Clone, Copy, Debug)]
#[must_use]
pub struct Dual<T = f32> {
    /// The value.
    pub value: T,
    /// The partial derivatives with respect to the three independent variables.
    pub gradient: Vec3<T>,
}

impl<T: Real> Dual<T> {
    #[inline]
    const fn new(value: T, gradient: Vec3<T>) -> Self {
        Self { value, gradient }
    }

    /// A constant, whose gradient is 0.
    #[inline]
    pub const fn constant(value: T) -> Self {
        Self::new(value, Vec3::ZERO)
    }

    /// The coordinates of a point as the three independent variables.
    #[inline]
    pub const fn point(p: Vec3<T>) -> Vec3<Self>
    where
        T: Copy,
    {
        let [zero, one] = [T::ZERO, T::ONE];
        Vec3::new(
            Self::new(p.x, Vec3::new(one, zero, zero)),
            Self::new(p.y, Vec3::new(zero, one, zero)),
            Self::new(p.z, Vec3::new(zero, zero, one)),
        )
    }

    /// Applies a function g by the chain rule, given its value and its slope.
    ///
    /// ```text
    /// ∇g(f) = g′(f) ∇f
    /// ```
    ///
    /// `value` is g(f) and `slope` is g′(f), both at f, the value of this number. This adds any
    /// differentiable function that is missing:
    ///
    /// ```
    /// use shading::f64::Dual;
    ///
    /// fn asin(x: Dual) -> Dual {
    ///     x.chain(x.value.asin(), 1.0 / (1.0 - x.value * x.value).sqrt())
    /// }
    /// assert_eq!(asin(Dual::constant(1.0)).value, core::f64::consts::FRAC_PI_2);
    /// ```
    #[inline]
    pub fn chain(self, value: T, slope: T) -> Self {
        Self::new(value, self.gradient * slope)
    }

    /// The square root. At 0, its gradient is not finite.
    #[inline]
    pub fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.chain(root, T::ONE / (root + root))
    }

    /// The larger of two numbers; `other`, with its gradient, if they are equal or this one is NaN.
    #[inline]
    pub fn max(self, other: impl Into<Self>) -> Self {
        self.at_least(other.into())
    }

    /// The smaller of two numbers; this one, with its gradient, if they are equal or one is NaN.
    #[inline]
    pub fn min(self, other: impl Into<Self>) -> Self {
        self.at_most(other.into())
    }
}

macro_rules! inherent {
    ($($method:ident($($argument:ident: $type:ty)?))*) => {
        /// The functions of [`Elementary`], without an import.
        impl<T: Elementary> Dual<T> {
            $(#[doc = concat!("[`Elementary::", stringify!($method), "`]")]
            #[inline]
            pub fn $method(self $(, $argument: $type)?) -> Self {
                Elementary::$method(self $(, $argument.into())?)
            })*
        }
    };
}

inherent!(abs() sin() cos() tan() atan2(x: impl Into<Self>) exp() ln()
    powi(exponent: i32) powf(exponent: impl Into<Self>));

/// A constant, so that `x.max(0.0)` takes a plain number.
impl<T: Real> From<T> for Dual<T> {
    #[inline]
    fn from(value: T) -> Self {
        Self::constant(value)
    }
}

macro_rules! with_plain_vectors {
    ($($trait:ident $method:ident)*) => {$(
        /// A vector of duals and one of plain numbers, such as `p - center` within an implicit surface.
        impl<T: Real> $trait<Vec3<T>> for Vec3<Dual<T>> {
            type Output = Self;
            #[inline]
            fn $method(self, other: Vec3<T>) -> Self {
                self.$method(other.map(Dual::constant))
            }
        }
    )*};
}

with_plain_vectors!(Add add Sub sub);

impl<T: PartialEq> PartialEq for Dual<T> {
    #[inline]
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

impl<T: PartialOrd> PartialOrd for Dual<T> {
    #[inline]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.value.partial_cmp(&other.value)
    }
}

impl<T: Real> Neg for Dual<T> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self::new(-self.value, -self.gradient)
    }
}

/// The sum rule.
impl<T: Real> Add for Dual<T> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self::new(self.value + other.value, self.gradient + other.gradient)
    }
}

/// The sum rule.
impl<T: Real> Sub for Dual<T> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::new(self.value - other.value, self.gradient - other.gradient)
    }
}

/// The product rule.
impl<T: Real> Mul for Dual<T> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        let gradient = self.gradient * other.value + other.gradient * self.value;
        Self::new(self.value * other.value, gradient)
    }
}

/// The quotient rule, computed as (f′ − (f/g) g′)/g.
impl<T: Real> Div for Dual<T> {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        let slopes = self.gradient - other.gradient * value;
        Self::new(value, slopes / other.value)
    }
}

impl<T: Real> Add<T> for Dual<T> {
    type Output = Self;
    #[inline]
    fn add(self, number: T) -> Self {
        Self::new(self.value + number, self.gradient)
    }
}

impl<T: Real> Sub<T> for Dual<T> {
    type Output = Self;
    #[inline]
    fn sub(self, number: T) -> Self {
        Self::new(self.value - number, self.gradient)
    }
}

impl<T: Real> Mul<T> for Dual<T> {
    type Output = Self;
    #[inline]
    fn mul(self, number: T) -> Self {
        self.chain(self.value * number, number)
    }
}

impl<T: Real> Div<T> for Dual<T> {
    type Output = Self;
    #[inline]
    fn div(self, number: T) -> Self {
        Self::new(self.value / number, self.gradient / number)
    }
}

assign!([T] Dual<T>, Self: Add Sub Mul Div);
assign!([T] Dual<T>, T: Add Sub Mul Div);

macro_rules! number_first {
    ($float:ident: $($trait:ident $method:ident),*) => {
        $(impl $trait<Dual<$float>> for $float {
            type Output = Dual<$float>;
            #[inline]
            fn $method(self, dual: Dual<$float>) -> Dual<$float> {
                Dual::constant(self).$method(dual)
            }
        })*
    };
}

number_first!(f32: Add add, Sub sub, Mul mul, Div div);
number_first!(f64: Add add, Sub sub, Mul mul, Div div);
