//! The numbers that record.

use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

use shading::number::power::Bits;
use shading::number::{Dimmed, Mask, Measured, Toward};
use shading::{Elementary, Lobe, Real, Rgb, Vec3};

use crate::graph::{EXTREME, MAX, NEG_ONE, ONE, Op, ZERO, with};
use crate::kind::{Kind, Value};

/// A number that records the formula which computes it.
///
/// The hooks of [`Real`] are recorded as calls of functions that the files define. A comparison is recorded, too,
/// and decides which path is recorded.
#[derive(Clone, Copy, Debug)]
pub struct Expr(pub(crate) usize);

/// The same number, which writes the hooks out: it records the functions behind the calls.
#[derive(Clone, Copy)]
pub(crate) struct Inline(pub usize);

/// The same, except that it calls the vectors between points.
#[derive(Clone, Copy)]
pub(crate) struct Crossed(pub usize);

/// The result of a function that takes the light and a number, where the function that is recorded takes a light.
fn call_of_light(name: &'static str, x: Expr) -> Option<Expr> {
    with(|g| g.is_lit()).then(|| {
        let light = with(|g| g.parameter("light", Kind::Light));
        let light = light.into_iter().map(Expr);
        Expr::call(name, &light.chain([x]).collect::<Vec<_>>())
    })
}

/// One of two names: the second, if a test is known to fail.
fn chosen(test: Expr, [name, otherwise]: [&'static str; 2]) -> &'static str {
    let fails = with(|g| g.known(test.0)) == Some(false);
    if fails { otherwise } else { name }
}

/// Operations that are recorded as they are called.
macro_rules! operations {
    ($number:ident $trait:ident $(($output:ident))?: $($method:ident($($other:ident)?) $op:expr),*) => {
        impl $trait for $number {
            $(type $output = Self;)?
            $(fn $method(self $(, $other: Self)?) -> Self {
                Self(with(|g| g.number($op, &[self.0 $(, $other.0)?])))
            })*
        }
    };
}

macro_rules! number {
    ($number:ident, { $($hooks:item)* }) => {
        operations!($number Add(Output): add(x) Op::Add);
        operations!($number Sub(Output): sub(x) Op::Sub);
        operations!($number Mul(Output): mul(x) Op::Mul);
        operations!($number Div(Output): div(x) Op::Div);
        operations!($number Neg(Output): neg() Op::Neg);
        operations!($number Elementary: sin() Op::Own("sin"), cos() Op::Own("cos"), tan() Op::Own("tan"),
            atan2(x) Op::Own("atan2"), exp() Op::Own("exp"), ln() Op::Own("log"), powf(exponent) Op::Own("pow"),
            abs() Op::Own("abs"));

        impl $number {
            /// The result of a function of the files.
            fn call<V: Value<Self>>(name: &'static str, arguments: &[Self]) -> V {
                let arguments: Vec<_> = arguments.iter().map(|x| x.0).collect();
                let result = with(|g| g.call(name, &arguments));
                V::take(&mut result.into_iter().map(Self))
            }
        }

        impl Mask<Self> for $number {
            fn any(self) -> bool {
                with(|g| g.decide(self.0))
            }

            fn all(self) -> bool {
                self.any()
            }

            fn select(self, then: Self, otherwise: Self) -> Self {
                Self(with(|g| g.select(self.0, then.0, otherwise.0)))
            }
        }

        impl Real for $number {
            type Mask = Self;
            type Sum = Rgb<Self>;
            const ZERO: Self = Self(ZERO);
            const ONE: Self = Self(ONE);
            const NEG_ONE: Self = Self(NEG_ONE);
            const MAX: Self = Self(MAX);
            const EXTREME: Self = Self(EXTREME);

            #[allow(clippy::cast_possible_truncation)] // the files compute in single precision
            fn of(literal: f64) -> Self {
                Self(with(|g| g.constant(literal as f32)))
            }

            fn sqrt(self) -> Self {
                Self(with(|g| g.add(Op::Own("sqrt"), Kind::Number, &[self.0])))
            }

            fn above(self, other: Self) -> Self {
                Self(with(|g| g.number(Op::Above, &[self.0, other.0])))
            }

            fn any_outside(self, low: Self, high: Self) -> bool {
                assert!([low, high] == [Self::ONE / Self::EXTREME, Self::EXTREME], "the range of squares");
                Self::call::<Self>("is_extreme", &[self]).any()
            }

            fn finite(self) -> Self {
                self.at_most(Self::MAX)
            }

            fn dot(a: Vec3<Self>, b: Vec3<Self>) -> Self {
                let [a, b] = [a, b].map(|v| [v.x.0, v.y.0, v.z.0]);
                Self(with(|g| g.dot(a, b)))
            }

            $($hooks)*
        }

        // the powers by a real number are the crate's own, as it computes them in single precision
        impl Lobe<Self> for $number {
            fn raise(self, cosine: Self) -> Self {
                Self::call("power", &[cosine, self.at_least(Self::ZERO)])
            }

            fn raise_quotient(self, square: Self, of: Self) -> Self {
                let half = (Self::of(0.5) * self).at_least(Self::ZERO);
                Self::call("power_of_quotient", &[square, of, half])
            }
        }

        impl Bits for $number {
            fn split(self, least: Self) -> (Self, Self) {
                let part = |name| Self::call(name, &[self, least]);
                (part("exponent"), part("significand"))
            }

            fn two_to_low_bits(self) -> Self {
                Self::call("two_to_low_bits", &[self])
            }

            // by the bits, because a compiler may take (y + c) - c for y
            fn unshifted(self, shift: Self) -> Self {
                Self::call("steps_above", &[self, shift])
            }
        }

        impl PartialEq for $number {
            fn eq(&self, other: &Self) -> bool {
                self.partial_cmp(other) == Some(Ordering::Equal)
            }
        }

        impl PartialOrd for $number {
            fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
                if self > other {
                    Some(Ordering::Greater)
                } else if other > self {
                    Some(Ordering::Less)
                } else {
                    (self >= other).then_some(Ordering::Equal)
                }
            }

            fn gt(&self, other: &Self) -> bool {
                self.above(*other).any()
            }

            fn lt(&self, other: &Self) -> bool {
                other.gt(self)
            }

            fn ge(&self, other: &Self) -> bool {
                Self(with(|g| g.number(Op::AtLeast, &[self.0, other.0]))).any()
            }

            fn le(&self, other: &Self) -> bool {
                other.ge(self)
            }
        }
    };
}

number!(Inline, {});

number!(Crossed, {
    fn between(origin: Vec3<Self>, v: Vec3<Self>) -> Vec3<Self> {
        let [origin, v] = [origin, v].map(|v| v.map(|x| Expr(x.0)));
        Expr::between(origin, v).map(|x| Self(x.0))
    }
});

number!(Expr, {
    fn measured(v: Vec3<Self>) -> Measured<Self> {
        Self::call("measured", &v.numbers())
    }

    fn toward(n: Vec3<Self>, v: Vec3<Self>) -> Toward<Self> {
        let measured = Self::measured(v);
        let n_dot_w = Self::dot(n, measured.w);
        Toward { measured, n_dot_w }
    }

    fn between(origin: Vec3<Self>, v: Vec3<Self>) -> Vec3<Self> {
        Self::call("between", &[origin, v].map(Value::numbers).concat())
    }

    fn crossed(origin: Vec3<Self>, a: Vec3<Self>, b: Vec3<Self>) -> Vec3<Self> {
        Self::call("crossed", &[origin, a, b].map(Value::numbers).concat())
    }

    fn windowed(
        mut light: Dimmed<Self>,
        _v: Vec3<Self>,
        q: Self,
        range: Self,
        is_squared: Self,
    ) -> Dimmed<Self> {
        let name = chosen(is_squared, ["window", "window_gltf"]);
        let by_window = || light.factor * Self::call(name, &[q, range]);
        light.factor = call_of_light("falloff", q).unwrap_or_else(by_window);
        light
    }

    fn beamed(
        mut light: Dimmed<Self>,
        axis: Vec3<Self>,
        [inner, outer]: [Self; 2],
        is_smooth: Self,
        _v: Vec3<Self>,
        measured: &Measured<Self>,
    ) -> Dimmed<Self> {
        let cosine = Self::dot(-axis, measured.w) / measured.w_length;
        // a soft edge may be smooth, and a hard one is neither
        let name = chosen(is_smooth, ["beam_smoothstep", "beam"]);
        let by_edges = || Self::call(name, &[cosine, inner, outer]);
        light.factor = light.factor * call_of_light("spot", cosine).unwrap_or_else(by_edges);
        light
    }
});
