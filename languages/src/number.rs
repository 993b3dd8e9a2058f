//! The numbers that record.

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
#[derive(Clone, Copy, Debug)]
pub(crate) struct Inline(usize);

/// The same, except that it calls the vectors between points.
#[derive(Clone, Copy, Debug)]
struct Crossed(usize);

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
fn call<const N: usize>(name: &'static str, arguments: &[usize]) -> [Expr; N] {
    with(|g| {
        let call = g.node(Node::Call(name, arguments.to_vec()));
        let mut parts = 0..;
        std::array::from_fn(|_| Expr(g.node(Node::Part(call, parts.next().expect("a part")))))
    })
}

fn call_one(name: &'static str, arguments: &[Expr]) -> Expr {
    let arguments: Vec<_> = arguments.iter().map(|x| x.0).collect();
    let [result] = call(name, &arguments);
    result
}

fn call_of_vectors<const N: usize>(name: &'static str, vectors: &[Vec3<Expr>]) -> [Expr; N] {
    let numbers = vectors.iter().flat_map(|v| [v.x.0, v.y.0, v.z.0]);
    call(name, &numbers.collect::<Vec<_>>())
}

fn is_defining(name: &str) -> bool {
    with(|g| g.defining == name)
}

/// Whether the function takes a light, of whose kind and falloff others decide.
fn is_of_a_light() -> bool {
    with(|g| g.defining == "arrival" || g.defining.starts_with("add_"))
}

fn call_of_light(name: &'static str, x: Expr) -> Expr {
    call_one(name, &[Kind::Light.variables("light"), vec![x]].concat())
}

fn inline(v: Vec3<Expr>) -> Vec3<Inline> {
    v.map(|x| Inline(x.0))
}

fn outside(v: Vec3<Inline>) -> Vec3<Expr> {
    v.map(|x| Expr(x.0))
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
                Self(call_one("sqrt", &[Expr(self.0)]).0)
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
        if is_defining("measured") {
            let Measured { w, w_length, length } = Inline::measured(inline(v));
            return Measured { w: outside(w), w_length: Self(w_length.0), length: Self(length.0) };
        }
        let [x, y, z, w_length, length] = call_of_vectors("measured", &[v]);
        Measured { w: Vec3::new(x, y, z), w_length, length }
    }

    fn toward(n: Vec3<Self>, v: Vec3<Self>) -> Toward<Self> {
        let measured = Self::measured(v);
        Toward { measured, n_dot_w: Self::dot(n, measured.w) }
    }

    fn between(origin: Vec3<Self>, v: Vec3<Self>) -> Vec3<Self> {
        if is_defining("between") {
            return outside(Inline::between(inline(origin), inline(v)));
        }
        call_of_vectors("between", &[origin, v]).into()
    }

    fn crossed(origin: Vec3<Self>, a: Vec3<Self>, b: Vec3<Self>) -> Vec3<Self> {
        if is_defining("crossed") {
            let [origin, a, b] = [origin, a, b].map(|v| v.map(|x| Crossed(x.0)));
            return Crossed::crossed(origin, a, b).map(|x| Self(x.0));
        }
        call_of_vectors("crossed", &[origin, a, b]).into()
    }

    fn attenuated(color: Rgb<Self>, coefficients: [Self; 3], q: Self, limit: Self) -> Dimmed<Self> {
        if is_of_a_light() {
            return Dimmed { color, factor: call_of_light("falloff", q) };
        }
        let coefficients = coefficients.map(|x| Inline(x.0));
        let dimmed = Inline::attenuated(Rgb::WHITE, coefficients, Inline(q.0), Inline(limit.0));
        Dimmed { color, factor: Self(dimmed.factor.0) }
    }

    fn windowed(
        Dimmed { color, factor }: Dimmed<Self>,
        v: Vec3<Self>,
        q: Self,
        range: Self,
        is_squared: Above,
    ) -> Dimmed<Self> {
        if is_of_a_light() {
            return Dimmed { color, factor }; // its falloff has the window
        }
        let name = if is_squared.is_anywhere() { "window" } else { "window_gltf" };
        if is_defining(name) {
            let one = Dimmed { color: Rgb::WHITE, factor: Inline::ONE };
            let window = Inline::windowed(one, inline(v), Inline(q.0), Inline(range.0), is_squared);
            return Dimmed { color, factor: factor * Self(window.factor.0) };
        }
        Dimmed { color, factor: factor * call_one(name, &[q, range]) }
    }

    fn beamed(
        Dimmed { color, factor }: Dimmed<Self>,
        axis: Vec3<Self>,
        inner_and_outer: [Self; 2],
        is_smooth: Above,
        _v: Vec3<Self>,
        measured: &Measured<Self>,
    ) -> Dimmed<Self> {
        let [inner, outer] = inner_and_outer;
        // a soft edge may be smooth, and a hard one is neither
        let is_square = with(|g| g.holds(is_smooth.test, None)) == Some(false);
        let name = if is_square { "beam" } else { "beam_smoothstep" };
        if is_defining(name) {
            let Measured { w, w_length, length } = *measured;
            let [w, axis] = [w, axis].map(inline);
            let measured = Measured { w, w_length: Inline(w_length.0), length: Inline(length.0) };
            let one = Dimmed { color: Rgb::WHITE, factor: Inline::ONE };
            let edges = [Inline(inner.0), Inline(outer.0)];
            let beam = Inline::beamed(one, axis, edges, is_smooth, w, &measured);
            return Dimmed { color, factor: factor * Self(beam.factor.0) };
        }
        let cosine = Self::dot(-axis, measured.w) / measured.w_length;
        if is_of_a_light() {
            return Dimmed { color, factor: factor * call_of_light("spot", cosine) };
        }
        Dimmed { color, factor: factor * call_one(name, &[cosine, inner, outer]) }
    }
});

/// The powers by a real number are the crate's own, as it computes them in single precision.
impl Lobe<Expr> for Expr {
    fn raise(self, cosine: Self) -> Self {
        call_one("power", &[cosine, self.at_least(Self::ZERO)])
    }

    fn raise_root(self, square: Self) -> Self {
        (Self::of(0.5) * self).raise(square)
    }

    fn raise_quotient(self, square: Self, of: Self) -> Self {
        let half = (Self::of(0.5) * self).at_least(Self::ZERO);
        call_one("power_of_quotient", &[square, of, half])
    }
}

impl Bits for Expr {
    fn split(self, least: Self) -> (Self, Self) {
        let part = |name| call_one(name, &[self, least]);
        (part("exponent"), part("significand"))
    }

    fn two_to_low_bits(self) -> Self {
        call_one("two_to_low_bits", &[self])
    }

    // by the bits, because a compiler may take (y + c) - c for y
    fn unshifted(self, shift: Self) -> Self {
        call_one("steps_above", &[self, shift])
    }
}

macro_rules! elementary {
    ($($method:ident($($other:ident)?) $function:literal)*) => {
        impl Elementary for Expr {
            $(fn $method(self $(, $other: Self)?) -> Self {
                call_one($function, &[self $(, $other)?])
            })*
        }
    };
}

elementary!(sin() "sin" cos() "cos" tan() "tan" atan2(x) "atan2" exp() "exp" ln() "log" powf(exponent) "pow" abs() "abs");

impl PartialEq for Expr {
    fn eq(&self, other: &Self) -> bool {
        self.0 == other.0
    }
}

impl PartialOrd for Expr {
    /// Which of two formulas is the larger has no answer before they have numbers.
    fn partial_cmp(&self, _: &Self) -> Option<Ordering> {
        None
    }

    fn gt(&self, other: &Self) -> bool {
        decide(Test::Above(self.0, other.0))
    }

    fn lt(&self, other: &Self) -> bool {
        decide(Test::Above(other.0, self.0))
    }

    fn ge(&self, other: &Self) -> bool {
        decide(Test::AtLeast(self.0, other.0))
    }

    fn le(&self, other: &Self) -> bool {
        decide(Test::AtLeast(other.0, self.0))
    }
}

/// A parameter, or a component of one.
pub(crate) fn variable(name: &str, component: Option<usize>) -> Expr {
    Expr(with(|g| g.node(Node::Var(name.into(), component))))
}
