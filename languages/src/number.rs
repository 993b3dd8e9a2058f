//! The numbers that record.

use std::array;
use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

use shading::number::power::Bits;
use shading::number::{Dimmed, Mask, Measured, Toward};
use shading::{Elementary, Lobe, Real, Rgb, Vec3};

use crate::graph::{EXTREME, MAX, NEG_ONE, Node, ONE, Op, Test, ZERO, decide, with};
use crate::kind::Kind;

/// A number that records the formula which computes it.
///
/// The hooks of [`Real`] are recorded as calls of functions that the files define.
#[derive(Clone, Copy, Debug)]
pub struct Expr(pub(crate) usize);

/// The same number, which writes the hooks out: it records the functions behind the calls.
#[derive(Clone, Copy)]
pub(crate) struct Inline(pub usize);

/// The same, except that it calls the vectors between points.
#[derive(Clone, Copy)]
pub(crate) struct Crossed(pub usize);

/// Where a comparison holds.
#[derive(Clone, Copy, Debug)]
pub struct Above {
    test: Test,
    /// Whether it decides even where other masks choose.
    decides: bool,
}

impl Above {
    fn answer(self, lanes: bool) -> bool {
        let lanes = Some(lanes).filter(|_| !self.decides);
        let known = with(|g| g.holds(self.test, lanes));
        known.unwrap_or_else(|| decide(self.test))
    }

    fn is_anywhere(self) -> bool {
        // whether there is a direction decides whether there is a result
        let is_length = |n: usize| with(|g| g.is_length(n));
        let decides = self.decides || matches!(self.test, Test::Above(n, ZERO) if is_length(n));
        Self { decides, ..self }.answer(true)
    }
}

/// The results of a call.
fn call<const N: usize>(name: &'static str, arguments: &[usize]) -> [usize; N] {
    with(|g| {
        let call = g.node(Node::Call(name, arguments.to_vec()));
        array::from_fn(|part| g.node(Node::Part(call, part)))
    })
}

fn call_of_vectors<const N: usize>(name: &'static str, vectors: &[Vec3<Expr>]) -> [Expr; N] {
    let numbers = vectors.iter().flat_map(|v| [v.x.0, v.y.0, v.z.0]);
    call(name, &numbers.collect::<Vec<_>>()).map(Expr)
}

fn call_of_light(name: &'static str, x: Expr) -> Expr {
    Expr::call(name, &[Kind::Light.variables("light"), vec![x]].concat())
}

macro_rules! operators {
    ($number:ident: $($trait:ident::$method:ident)*) => {$(
        impl $trait for $number {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                Self(with(|g| g.binary(Op::$trait, self.0, other.0)))
            }
        }
    )*};
}

macro_rules! number {
    ($number:ident { $($hooks:item)* }) => {
        operators!($number: Add::add Sub::sub Mul::mul Div::div);

        impl Neg for $number {
            type Output = Self;
            fn neg(self) -> Self {
                Self(with(|g| g.neg(self.0)))
            }
        }

        impl $number {
            fn call(name: &'static str, arguments: &[Self]) -> Self {
                let arguments: Vec<_> = arguments.iter().map(|x| x.0).collect();
                let [result] = call(name, &arguments);
                Self(result)
            }
        }

        impl Mask<$number> for Above {
            fn any(self) -> bool {
                self.is_anywhere()
            }

            fn all(self) -> bool {
                self.answer(false)
            }

            fn select(self, then: $number, otherwise: $number) -> $number {
                $number(with(|g| g.select(self.test, then.0, otherwise.0)))
            }
        }

        impl Real for $number {
            type Mask = Above;
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
                Self::call("sqrt", &[self])
            }

            fn above(self, other: Self) -> Above {
                // (a choice between 1 and 0) > 0 is its test
                let test = with(|g| match g.nodes[self.0] {
                    Node::Select(test, ONE, ZERO) if other.0 == ZERO => test,
                    _ => Test::Above(self.0, other.0),
                });
                Above { test, decides: false }
            }

            fn at_least(self, floor: Self) -> Self {
                Self(with(|g| g.binary(Op::Max, self.0, floor.0)))
            }

            fn at_most(self, limit: Self) -> Self {
                Self(with(|g| g.binary(Op::Min, self.0, limit.0)))
            }

            fn any_outside(self, low: Self, high: Self) -> bool {
                let range = with(|g| (g.value(low.0), g.value(high.0)));
                let extreme = with(|g| g.value(EXTREME));
                assert_eq!(range, (extreme.map(|x| 1.0 / x), extreme), "the range of squares");
                decide(Test::Extreme(self.0))
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

            fn raise_root(self, square: Self) -> Self {
                (Self::of(0.5) * self).raise(square)
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
                self.0 == other.0
            }
        }

        impl PartialOrd for $number {
            /// Which of two formulas is the larger has no answer before they have numbers.
            fn partial_cmp(&self, _: &Self) -> Option<Ordering> {
                None
            }

            fn gt(&self, other: &Self) -> bool {
                decide(Test::Above(self.0, other.0))
            }

            fn lt(&self, other: &Self) -> bool {
                other.gt(self)
            }

            fn ge(&self, other: &Self) -> bool {
                decide(Test::AtLeast(self.0, other.0))
            }

            fn le(&self, other: &Self) -> bool {
                other.ge(self)
            }
        }
    };
}

number!(Inline {});

number!(Crossed {
    fn between(origin: Vec3<Self>, v: Vec3<Self>) -> Vec3<Self> {
        let [origin, v] = [origin, v].map(|v| v.map(|x| Expr(x.0)));
        Expr::between(origin, v).map(|x| Self(x.0))
    }
});

number!(Expr {
    fn faces(n: Vec3<Self>, v: Vec3<Self>) -> Above {
        Above { decides: true, ..Self::dot(n, v).above(Self::ZERO) }
    }

    fn measured(v: Vec3<Self>) -> Measured<Self> {
        let [x, y, z, w_length, length] = call_of_vectors("measured", &[v]);
        Measured { w: Vec3::new(x, y, z), w_length, length }
    }

    fn toward(n: Vec3<Self>, v: Vec3<Self>) -> Toward<Self> {
        let measured = Self::measured(v);
        Toward { measured, n_dot_w: Self::dot(n, measured.w) }
    }

    fn between(origin: Vec3<Self>, v: Vec3<Self>) -> Vec3<Self> {
        call_of_vectors("between", &[origin, v]).into()
    }

    fn crossed(origin: Vec3<Self>, a: Vec3<Self>, b: Vec3<Self>) -> Vec3<Self> {
        call_of_vectors("crossed", &[origin, a, b]).into()
    }

    fn windowed(
        Dimmed { color, factor }: Dimmed<Self>,
        _v: Vec3<Self>,
        q: Self,
        range: Self,
        is_squared: Above,
    ) -> Dimmed<Self> {
        if with(|g| g.is_lit()) {
            return Dimmed { color, factor: call_of_light("falloff", q) };
        }
        let name = if is_squared.is_anywhere() { "window" } else { "window_gltf" };
        Dimmed { color, factor: factor * Self::call(name, &[q, range]) }
    }

    fn beamed(
        Dimmed { color, factor }: Dimmed<Self>,
        axis: Vec3<Self>,
        [inner, outer]: [Self; 2],
        is_smooth: Above,
        _v: Vec3<Self>,
        measured: &Measured<Self>,
    ) -> Dimmed<Self> {
        let cosine = Self::dot(-axis, measured.w) / measured.w_length;
        if with(|g| g.is_lit()) {
            return Dimmed { color, factor: factor * call_of_light("spot", cosine) };
        }
        // a soft edge may be smooth, and a hard one is neither
        let is_square = with(|g| g.holds(is_smooth.test, None)) == Some(false);
        let name = if is_square { "beam" } else { "beam_smoothstep" };
        Dimmed { color, factor: factor * Self::call(name, &[cosine, inner, outer]) }
    }
});

macro_rules! elementary {
    ($($method:ident($($other:ident)?) $function:literal)*) => {
        impl Elementary for Expr {
            $(fn $method(self $(, $other: Self)?) -> Self {
                Self::call($function, &[self $(, $other)?])
            })*
        }
    };
}

elementary!(sin() "sin" cos() "cos" tan() "tan" atan2(x) "atan2" exp() "exp" ln() "log" powf(exponent) "pow" abs() "abs");

/// A parameter, or a component of one.
pub(crate) fn variable(name: &str, component: Option<usize>) -> Expr {
    Expr(with(|g| g.node(Node::Var(name.into(), component))))
}
