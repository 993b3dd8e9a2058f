//! Dual numbers, which carry their own derivatives.

use core::cmp::Ordering;
use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::elementary::Elementary;
use crate::real::Real;
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
/// the derivative does not exist (√ at 0, ln below 0), the gradient is not finite.
///
/// ```
/// use shading::{Dual, Elementary, Vec3};
///
/// let p = Dual::point(Vec3::new(3.0_f64, 0.0, 2.0));
/// let f = p.x * p.x * p.z + p.y.cos();
/// assert_eq!(f.value, 19.0);
/// assert_eq!(f.gradient, Vec3::new(12.0, 0.0, 9.0)); // (2xz, −sin y, x²)
/// ```
///
/// Source: William K. Clifford, *Preliminary Sketch of Biquaternions*, 1873; Griewank and Walther
/// 2008.
#[doc(alias = "autodiff")]
#[derive(Clone, Copy, Debug)]
pub struct Dual<T = f32> {
    /// The value.
    pub value: T,
    /// The partial derivatives with respect to the three independent variables.
    pub gradient: Vec3<T>,
}

impl<T: Real> Dual<T> {
    /// A constant, whose gradient is 0.
    ///
    /// ```
    /// use shading::{Dual, Vec3};
    /// assert_eq!(Dual::constant(2.0_f32).gradient, Vec3::ZERO);
    /// ```
    #[inline]
    #[must_use]
    pub const fn constant(value: T) -> Self {
        Self {
            value,
            gradient: Vec3::ZERO,
        }
    }

    /// The coordinates of a point as the three independent variables.
    ///
    /// ```
    /// use shading::{Dual, UnitVec3, Vec3};
    /// let p = Dual::point(Vec3::new(1.0_f32, 2.0, 3.0));
    /// assert_eq!((p.y.value, p.y.gradient), (2.0, *UnitVec3::Y));
    /// ```
    #[inline]
    #[must_use]
    pub const fn point(p: Vec3<T>) -> Vec3<Self>
    where
        T: Copy,
    {
        let [zero, one] = [T::ZERO, T::ONE];
        Vec3::new(
            Self {
                value: p.x,
                gradient: Vec3::new(one, zero, zero),
            },
            Self {
                value: p.y,
                gradient: Vec3::new(zero, one, zero),
            },
            Self {
                value: p.z,
                gradient: Vec3::new(zero, zero, one),
            },
        )
    }

    /// Applies a function g by the chain rule, given its value and its slope.
    ///
    /// ```text
    /// ∇g(f) = g′(f) ∇f
    /// ```
    ///
    /// `value` is g(f) and `slope` is g′(f), both at f, the value of this number. This adds any
    /// differentiable function that [`Elementary`](crate::Elementary) lacks:
    ///
    /// ```
    /// use shading::{Dual, Vec3};
    ///
    /// fn tan(x: Dual<f64>) -> Dual<f64> {
    ///     let tan = x.value.tan();
    ///     x.chain(tan, 1.0 + tan * tan)
    /// }
    /// let x = Dual::point(Vec3::new(0.0, 0.5, 0.0)).x;
    /// assert_eq!(tan(x).gradient, Vec3::new(1.0, 0.0, 0.0));
    /// ```
    #[inline]
    #[must_use]
    pub fn chain(self, value: T, slope: T) -> Self {
        Self {
            value,
            gradient: self.gradient * slope,
        }
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
        Self {
            value: -self.value,
            gradient: -self.gradient,
        }
    }
}

/// The sum rule.
impl<T: Real> Add for Dual<T> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self {
            value: self.value + other.value,
            gradient: self.gradient + other.gradient,
        }
    }
}

/// The sum rule.
impl<T: Real> Sub for Dual<T> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self {
            value: self.value - other.value,
            gradient: self.gradient - other.gradient,
        }
    }
}

/// The product rule.
impl<T: Real> Mul for Dual<T> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        Self {
            value: self.value * other.value,
            gradient: self.gradient * other.value + other.gradient * self.value,
        }
    }
}

/// The quotient rule, computed as (f′ − (f/g) g′)/g.
impl<T: Real> Div for Dual<T> {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        let slopes = self.gradient - other.gradient * value;
        Self {
            value,
            gradient: slopes / other.value,
        }
    }
}

impl<T: Real> Add<T> for Dual<T> {
    type Output = Self;
    #[inline]
    fn add(self, number: T) -> Self {
        Self {
            value: self.value + number,
            ..self
        }
    }
}

impl<T: Real> Sub<T> for Dual<T> {
    type Output = Self;
    #[inline]
    fn sub(self, number: T) -> Self {
        Self {
            value: self.value - number,
            ..self
        }
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
        Self {
            value: self.value / number,
            gradient: self.gradient / number,
        }
    }
}

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

#[diagnostic::do_not_recommend] // the trait's own message names the types
impl<T: Real> Real for Dual<T> {
    const ZERO: Self = Self::constant(T::ZERO);
    const ONE: Self = Self::constant(T::ONE);
    const NEG_ONE: Self = Self::constant(T::NEG_ONE);
    const MAX: Self = Self::constant(T::MAX);
    const EXTREME: Self = Self::constant(T::EXTREME);

    #[inline]
    fn of(literal: f64) -> Self {
        Self::constant(T::of(literal))
    }

    #[inline]
    fn of_f32(literal: f32) -> Self {
        Self::constant(T::of_f32(literal))
    }

    #[inline]
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.chain(root, T::ONE / (root + root))
    }

    #[inline]
    fn if_positive(self, then: Self, otherwise: Self) -> Self {
        let select = |a, b| self.value.if_positive(a, b);
        Self {
            value: select(then.value, otherwise.value),
            gradient: Vec3::new(
                select(then.gradient.x, otherwise.gradient.x),
                select(then.gradient.y, otherwise.gradient.y),
                select(then.gradient.z, otherwise.gradient.z),
            ),
        }
    }

    #[inline]
    fn any_positive(self) -> bool {
        self.value.any_positive()
    }
}

impl<T: Elementary> Elementary for Dual<T> {
    #[inline]
    fn sin(self) -> Self {
        self.chain(self.value.sin(), self.value.cos())
    }

    #[inline]
    fn cos(self) -> Self {
        self.chain(self.value.cos(), -self.value.sin())
    }

    #[inline]
    fn exp(self) -> Self {
        let power = self.value.exp();
        self.chain(power, power)
    }

    #[inline]
    fn ln(self) -> Self {
        let ln = self.value.ln();
        // below 0, 1/x has a value, but the logarithm does not
        let slope = (-self.value).if_positive(ln, T::ONE / self.value);
        self.chain(ln, slope)
    }
}
