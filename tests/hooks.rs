//! The hooks of [`Real`] through the numbers that wrap others: a dual number has the value of its
//! number's own hook, to the bit, and the gradient of the formula beside it.

#![allow(clippy::float_cmp)] // exact on purpose

use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

use kit::random::Random;
use shading::number::{Dimmed, LightSum, Mask, Measured, Toward};
use shading::{Dual, Lobe, Real, Rgb, UnitVec3, Vec3, normal};

/// Twenty-four numbers, from which each hook gets its arguments.
const COUNT: usize = 24;
type Input<T> = [T; COUNT];

fn vector<T: Copy>(input: &Input<T>, at: usize) -> Vec3<T> {
    Vec3::new(input[at], input[at + 1], input[at + 2])
}

fn truth<T: Real>(mask: T::Mask) -> T {
    mask.select(T::ONE, T::ZERO)
}

/// The results of every method of [`Real`] and of [`LightSum`] that a number can replace.
fn hooks<T: Real>(input: &Input<T>) -> Vec<(&'static str, T)> {
    let [n, v, w, color] = [0, 3, 6, 9].map(|at| vector(input, at));
    let n = *n.unit_or(UnitVec3::Z);
    let [x, y, c, q, limit, range, inner, factor] = core::array::from_fn(|i| input[12 + i]);
    let [a, b, k, _] = core::array::from_fn(|i| input[20 + i]);
    let color = Rgb::new(color.x, color.y, color.z);
    let (yes, no) = (T::ONE.above(T::ZERO), T::ZERO.above(T::ONE));
    let is_outside = if x.any_outside(T::ONE, T::EXTREME) {
        T::ONE
    } else {
        T::ZERO
    };
    let mut results = vec![
        ("above", truth(x.above(y))),
        ("sqrt", x.sqrt()),
        ("at_least", x.at_least(y)),
        ("at_most", x.at_most(y)),
        ("any_outside", is_outside),
        ("finite", x.finite()),
        ("half_angle_cosine", x.half_angle_cosine()),
        ("of_f32", T::of_f32(0.1)),
        ("of", T::of(0.1)),
        ("dot", T::dot(v, w)),
        ("faces", truth(T::faces(n, v))),
        ("cosine", T::cosine(n, &T::toward(n, v))),
        ("add", x + y),
    ];
    let mut measured = |name,
                        Measured {
                            w,
                            w_length,
                            length,
                        }: Measured<T>| {
        results.extend([w.x, w.y, w.z, w_length, length].map(|x| (name, x)));
    };
    measured("measured", T::measured(v));
    let toward = T::toward(n, v);
    measured("toward", toward.measured);
    results.push(("toward", toward.n_dot_w));
    for (name, v) in [
        ("between", T::between(v, w)),
        ("crossed", T::crossed(v, w, n)),
    ] {
        results.extend([v.x, v.y, v.z].map(|x| (name, x)));
    }
    for m in [0, 1, 2, 5, 32] {
        results.push(("whole_power", c.whole_power(m)));
        results.push(("halfway_power", T::halfway_power(n, T::measured(v), n, m)));
        results.push(("raise_root", m.raise_root(c)));
    }
    let light = Dimmed { color, factor };
    let mut lights = |name, Dimmed { color, factor }: Dimmed<T>| {
        results.extend([color.r, color.g, color.b, factor].map(|x| (name, x)));
        let sum = T::Sum::DARK.add(Dimmed { color, factor }, c);
        let total = sum.add(light, factor).total();
        results.extend([total.r, total.g, total.b].map(|x| (name, x)));
    };
    lights("attenuated", T::attenuated(color, [a, b, k], q, limit));
    lights("windowed", T::windowed(light, v, q, range, yes));
    lights("windowed", T::windowed(light, v, q, range, no));
    let edges = [inner.at_most(T::ONE), y.at_most(T::ONE)]; // cosines
    let measured = T::measured(v);
    lights("beamed", T::beamed(light, n, edges, yes, v, &measured));
    lights("beamed", T::beamed(light, n, edges, no, v, &measured));
    results
}

/// A number with results that can be compared.
trait Number: Real + Debug + 'static {
    fn exact(self) -> f64;
}

impl Number for f32 {
    fn exact(self) -> f64 {
        self.into()
    }
}

impl Number for f64 {
    fn exact(self) -> f64 {
        self
    }
}

#[cfg(feature = "fixed")]
impl Number for shading::fixed::Fixed {
    fn exact(self) -> f64 {
        self.into()
    }
}

/// A number that replaces every hook by something else: what wraps it must not compute by itself.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
struct Odd(f64);

macro_rules! operators {
    ($($operator:ident $method:ident),*) => {$(
        impl $operator for Odd {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                Self(self.0.$method(other.0))
            }
        }
    )*};
}
operators!(Add add, Sub sub, Mul mul, Div div);

impl Neg for Odd {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Number for Odd {
    fn exact(self) -> f64 {
        self.0
    }
}

#[derive(Clone, Copy)]
struct OddSum(f64);

impl LightSum<Odd> for OddSum {
    const DARK: Self = Self(0.125);
    fn add(self, light: Dimmed<Odd>, cosine: Odd) -> Self {
        Self(self.0 + light.color.g.0 - light.factor.0 - cosine.0)
    }
    fn total(self) -> Rgb<Odd> {
        Rgb::new(self.0, self.0 + 1.0, self.0 + 2.0).map(Odd)
    }
}

impl Real for Odd {
    type Mask = bool;
    type Sum = OddSum;
    const ZERO: Self = Self(0.0);
    const ONE: Self = Self(1.0);
    const NEG_ONE: Self = Self(-1.0);
    const MAX: Self = Self(f64::MAX);
    const EXTREME: Self = Self(<f64 as Real>::EXTREME);
    fn of(literal: f64) -> Self {
        Self(literal + 1.0)
    }
    fn of_f32(literal: f32) -> Self {
        Self(f64::from(literal) + 2.0)
    }
    fn sqrt(self) -> Self {
        Self(self.0.abs().sqrt() + 3.0)
    }
    fn above(self, other: Self) -> bool {
        self.0 > other.0 + 0.25
    }
    fn at_least(self, floor: Self) -> Self {
        Self(self.0.max(floor.0) + 4.0)
    }
    fn at_most(self, limit: Self) -> Self {
        Self(self.0.min(limit.0) - 5.0)
    }
    fn any_outside(self, low: Self, _: Self) -> bool {
        self.0 > low.0
    }
    fn finite(self) -> Self {
        Self(self.0 + 6.0)
    }
    fn dot(a: Vec3<Self>, b: Vec3<Self>) -> Self {
        Self(a.x.0 * b.y.0 + 7.0)
    }
    fn faces(n: Vec3<Self>, v: Vec3<Self>) -> bool {
        n.x.0 < v.z.0
    }
    fn measured(v: Vec3<Self>) -> Measured<Self> {
        let (w_length, length) = (Self(v.x.0 + 8.0), Self(v.y.0 + 9.0));
        Measured {
            w: v * v.z,
            w_length,
            length,
        }
    }
    fn toward(n: Vec3<Self>, v: Vec3<Self>) -> Toward<Self> {
        let measured = Self::measured(n + v);
        let n_dot_w = Self(n.x.0 + 10.0);
        Toward { measured, n_dot_w }
    }
    fn cosine(n: Vec3<Self>, toward: &Toward<Self>) -> Self {
        Self(n.z.0 + toward.n_dot_w.0 + toward.measured.w.x.0)
    }
    fn between(origin: Vec3<Self>, v: Vec3<Self>) -> Vec3<Self> {
        v * origin.x
    }
    fn crossed(origin: Vec3<Self>, a: Vec3<Self>, b: Vec3<Self>) -> Vec3<Self> {
        a * origin.y + b
    }
    fn whole_power(self, m: u32) -> Self {
        Self(self.0 + f64::from(m))
    }
    fn halfway_power(n: Vec3<Self>, w: Measured<Self>, v: Vec3<Self>, m: impl Lobe<Self>) -> Self {
        m.raise(Self(n.x.0 + w.length.0 - v.z.0))
    }
    fn attenuated(color: Rgb<Self>, abc: [Self; 3], q: Self, limit: Self) -> Dimmed<Self> {
        let [a, b, c] = abc;
        Dimmed {
            color: color * (a + q),
            factor: b - c + limit,
        }
    }
    fn windowed(
        light: Dimmed<Self>,
        v: Vec3<Self>,
        q: Self,
        range: Self,
        is_squared: bool,
    ) -> Dimmed<Self> {
        let factor = if is_squared {
            light.factor + q + v.x
        } else {
            range
        };
        Dimmed {
            color: light.color,
            factor,
        }
    }
    fn beamed(
        light: Dimmed<Self>,
        axis: Vec3<Self>,
        [inner, outer]: [Self; 2],
        is_smooth: bool,
        v: Vec3<Self>,
        measured: &Measured<Self>,
    ) -> Dimmed<Self> {
        let c = axis.x + v.y + measured.w.z;
        let color = light.color * if is_smooth { c + inner } else { outer };
        Dimmed {
            color,
            factor: light.factor,
        }
    }
}

/// A number of any size, often a zero or an end.
fn number<T: Real>(random: &mut Random) -> T {
    let sign = if random.fraction() < 0.5 { -1.0 } else { 1.0 };
    match random.below(16) {
        0 => T::ZERO,
        1 => T::ONE,
        2 => T::MAX,
        3 => T::EXTREME * T::of(sign * random.fraction()),
        4..=6 => T::of(sign * random.within(-120.0, 120.0).exp2()),
        _ => T::of(sign * 4.0 * random.fraction()),
    }
}

fn vector_of_numbers<T: Real>(random: &mut Random) -> Vec3<T> {
    Vec3::from([(); 3].map(|()| number(random)))
}

fn arguments<T: Real>(random: &mut Random) -> Input<T> {
    let mut input: Input<T> = core::array::from_fn(|_| number(random));
    // what the hooks take within [0, 1], or from 0 on
    input[14] = T::of(random.fraction());
    for x in &mut input[9..] {
        *x = x.at_least(-*x);
    }
    input
}

fn same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan()
}

/// Values of dual numbers, and of dual numbers of those. Choices, and what dims and sums lights, are by the
/// formulas, so they have the values of a number without hooks of its own for them.
fn values<T: Number>(has_no_hooks: bool) {
    let mut random = Random(1);
    for _ in 0..1000 {
        let input: Input<T> = arguments(&mut random);
        let once: Input<Dual<T>> = core::array::from_fn(|i| {
            let along = vector_of_numbers(&mut random);
            Dual {
                value: input[i],
                gradient: along,
            }
        });
        let twice: Input<Dual<Dual<T>>> = core::array::from_fn(|i| {
            let along = vector_of_numbers(&mut random);
            Dual {
                value: once[i],
                gradient: along.map(Dual::constant),
            }
        });
        let expected = hooks(&input);
        let by_formula = [
            "at_least",
            "at_most",
            "finite",
            "attenuated",
            "windowed",
            "beamed",
        ];
        let is_tried = |name| has_no_hooks || !by_formula.contains(&name);
        for (i, (name, once)) in hooks(&once).into_iter().enumerate() {
            if !is_tried(name) {
                continue;
            }
            let (is, should) = (once.value.exact(), expected[i].1.exact());
            assert!(
                same(is, should),
                "{name}: {is} instead of {should}, {input:?}"
            );
        }
        for (i, (name, twice)) in hooks(&twice).into_iter().enumerate() {
            if !is_tried(name) {
                continue;
            }
            let (is, should) = (twice.value.value.exact(), expected[i].1.exact());
            assert!(
                same(is, should),
                "{name}, twice: {is} instead of {should}, {input:?}"
            );
        }
    }
}

#[test]
fn a_dual_number_has_the_value_of_its_number() {
    values::<f32>(true);
    values::<f64>(true);
    values::<Odd>(false);
    #[cfg(feature = "fixed")]
    values::<shading::fixed::Fixed>(false);
}

/// Every hook of the trait is tried here.
#[test]
fn every_method_is_tried() {
    let text = include_str!("../src/number/real.rs");
    let body = text.split_once("pub trait Real:").expect("the trait").1;
    let body = body.split_once("\n}\n").expect("its end").0;
    let names = body
        .lines()
        .filter_map(|line| line.trim().strip_prefix("fn "));
    let names: Vec<_> = names
        .map(|rest| rest.split('(').next().unwrap_or(rest))
        .collect();
    let tried: Vec<_> = hooks(&[1.0_f64; COUNT])
        .into_iter()
        .map(|(name, _)| name)
        .collect();
    let missing: Vec<_> = names.iter().filter(|name| !tried.contains(name)).collect();
    assert!(
        missing.is_empty() && names.len() > 15,
        "{missing:?} of {names:?}"
    );
}

/// A central difference of step h is off by h² times the third derivative.
#[test]
fn the_gradient_of_a_hook_is_the_difference() {
    let mut random = Random(3);
    for _ in 0..200 {
        // away from edges: a light in front, within the range and between the edges of the cone
        let mut input: Input<f64> = core::array::from_fn(|_| 0.5 + random.fraction());
        (input[14], input[15], input[16], input[17]) = (0.7, 1.0 + random.fraction(), 50.0, 4.0);
        (input[13], input[18], input[19]) = (0.4, 0.9, 0.5 * random.fraction());
        let along: Input<Vec3<f64>> = core::array::from_fn(|_| {
            Vec3::new(random.fraction(), random.fraction(), random.fraction()) - Vec3::splat(0.5)
        });
        let duals = core::array::from_fn(|i| Dual {
            value: input[i],
            gradient: along[i],
        });
        let moved = |h: f64| hooks(&core::array::from_fn(|i| input[i] + h * along[i].y));
        let (below, above) = (moved(-1e-4), moved(1e-4));
        for (i, (name, dual)) in hooks(&duals).into_iter().enumerate() {
            let slope = (above[i].1 - below[i].1) / 2e-4;
            let is_near = (dual.gradient.y - slope).abs() <= 2e-6 * (1.0 + slope.abs());
            assert!(
                is_near,
                "{name}: {} instead of {slope}, {input:?}",
                dual.gradient.y
            );
        }
    }
}

/// The largest angle between the normal of a sphere and the exact one, over points of every size.
fn worst_angle<T: Number + PartialOrd>(exponents: std::ops::Range<i32>) -> f64 {
    let (mut random, mut worst) = (Random(5), 0.0_f64);
    for exponent in exponents {
        for _ in 0..20 {
            let mut coordinate = || T::of(random.signed() * 2.0_f64.powi(exponent));
            let p = Vec3::new(coordinate(), coordinate(), coordinate());
            let exact = p.map(Number::exact).unit();
            let is =
                normal::implicit(|p| p.length() - T::of(25.0), p).map(|n| n.map(Number::exact));
            let Some(exact) = exact else {
                continue; // all coordinates rounded to 0
            };
            let is = is.unwrap_or_else(|| panic!("{p:?} has no normal"));
            worst = worst.max((is.cross(*exact)).length().asin().to_degrees());
            assert!(is.dot(exact) > 0.0);
        }
    }
    worst
}

/// Rounding n to steps of 2⁻¹⁶ turns it by at most √3/2 · 2⁻¹⁶, and the unit of the gradient likewise.
#[test]
fn the_normal_of_a_length_is_right_at_every_distance() {
    assert!(worst_angle::<f32>(-140..128) < 1e-4); // the least has nine bits, exactly
    assert!(worst_angle::<f64>(-1060..1024) < 1e-13);
    #[cfg(feature = "fixed")]
    assert!(worst_angle::<shading::fixed::Fixed>(-8..15) < 0.002);
}

/// ∂²|v| = (I − u uᵀ)/|v|, at sizes that are measured after scaling.
#[test]
fn the_curvature_of_a_length() {
    for size in [1e-200, 1e-120, 1.0, 1e120, 1e200] {
        let p = Vec3::new(3.0, -4.0, 12.0) * size;
        let length = Dual::point(Dual::point(p)).length();
        let u = *p.unit().expect("a direction");
        let rows: [Dual<f64>; 3] = length.gradient.into();
        for (i, row) in rows.into_iter().enumerate() {
            let axis = [UnitVec3::X, UnitVec3::Y, UnitVec3::Z][i];
            let expected = (*axis - u * u.dot(axis)) / (13.0 * size);
            let error = (row.gradient - expected).length() * 13.0 * size;
            assert!(error < 1e-14, "{size}: {error}");
        }
    }
}

/// 2^(y²) at 0 has the second derivative 2 ln 2; of xʸ at (2, 0), ∂x∂y is ½.
#[test]
fn powers_differentiate_twice() {
    let y = Dual::point(Dual::point(Vec3::new(0.0_f64, 0.0, 0.0))).y;
    let power = Dual::constant(Dual::constant(2.0)).powf(y * y);
    let ln_2 = core::f64::consts::LN_2;
    assert!((power.gradient.y.gradient.y - 2.0 * ln_2).abs() < 1e-15);
    let p = Dual::point(Dual::point(Vec3::new(2.0_f64, 0.0, 0.0)));
    let power = p.x.powf(p.y);
    assert_eq!(power.gradient.x.gradient.y, 0.5);
    assert_eq!(power.gradient.y.gradient.x, 0.5);
    assert!((power.gradient.y.gradient.y - ln_2 * ln_2).abs() < 1e-15);
}

#[test]
fn a_power_whose_reciprocal_overflows_has_a_gradient() {
    let x = Dual::point(Vec3::new(1e10_f32, 1.0, 1.0)).x;
    assert_eq!(x.powi(-4).gradient.x, 0.0); // −4e-50
    let x = Dual::point(Vec3::new(0.5_f64, 1.0, 1.0)).x;
    let slopes = [-3, -1, 0, 1, 3, i32::MIN, i32::MAX].map(|n| x.powi(n).gradient.x);
    assert_eq!(
        slopes,
        [-48.0, -4.0, 0.0, 1.0, 0.75, f64::NEG_INFINITY, 0.0]
    );
    let zero = Dual::point(Vec3::new(0.0_f64, 1.0, 1.0)).x;
    assert_eq!([0, 1, 2].map(|n| zero.powi(n).gradient.x), [0.0, 1.0, 0.0]);
}

#[cfg(feature = "fixed")]
mod fixed {
    use shading::fixed::Fixed;
    use shading::{
        Attenuation, Cone, Dual, IncidentLight, Material, PointLight, Real, Rgb, SpotLight,
        UnitVec3, Vec3, normal, shade,
    };

    use kit::random::Random;

    /// What arrives at a moving point, and three sums over it: the formulas in fixed point. Each factor is
    /// rounded, and a light of 4 magnifies that. In steps, the attenuation is off by up to 3, the window by
    /// 4, the cone by 8 and the cosine by 2, and a highlight of m = 20 by 1½ each time that it is
    /// multiplied: 47 in all. Two lights of 4 over a reflectance of ½ make 188 of that.
    #[test]
    fn sums_of_dual_numbers_in_fixed_point_are_near_those_of_f64() {
        fn sums<T: Real>(p: Vec3<T>, spot: &SpotLight<T>, clay: &Material<T>) -> Vec<T> {
            let (n, v) = (
                UnitVec3::Z,
                (Vec3::new(T::ZERO, T::ONE, T::ONE + T::ONE) - p).unit_or(UnitVec3::Z),
            );
            let lights = || [spot.at(p), spot.point.at(p)];
            let arrival = IncidentLight::arrival(&lights()[0]);
            let sums = [
                shade::lambert(n, clay, Rgb::WHITE, lights()),
                shade::phong(n, v, clay, Rgb::WHITE, lights()),
                shade::blinn_phong(n, v, clay, Rgb::WHITE, lights()),
            ];
            let sums = sums
                .map(|s| [s.diffuse.r, s.diffuse.g, s.specular.b])
                .concat();
            [
                sums,
                vec![arrival.l.x, arrival.intensity.g, arrival.distance],
            ]
            .concat()
        }

        let x = Fixed::new;
        let lamp = PointLight {
            position: Vec3::new(x(1.0), x(2.0), x(3.0)),
            intensity: Rgb::new(x(4.0), x(2.0), x(1.0)),
            attenuation: Attenuation::new(x(0.25), x(0.5), x(0.125))
                .and_then(|a| a.within(x(9.0)))
                .expect("valid"),
        };
        let cone = Cone::from_cosines(x(0.9), x(0.5))
            .expect("in order")
            .smoothstep();
        let spot = SpotLight {
            point: lamp,
            axis: UnitVec3::NEG_Z,
            cone,
        };
        let clay = Material {
            k_a: Rgb::WHITE,
            k_d: Rgb::gray(x(0.5)),
            k_s: Rgb::gray(x(0.25)),
            m: 20,
        };
        let mut random = Random(9);
        for _ in 0..500 {
            let p = Vec3::new(
                x(4.0 * random.fraction()),
                x(4.0 * random.fraction()),
                x(2.0 * random.fraction()),
            );
            let exact = sums(
                p.map(f64::from),
                &spot.cast(f64::from),
                &clay.cast(f64::from),
            );
            let duals = sums(
                Dual::point(p),
                &spot.cast(Dual::constant),
                &clay.cast(Dual::constant),
            );
            for (dual, exact) in duals.into_iter().zip(exact) {
                let error = (f64::from(dual.value) - exact).abs() * 65_536.0;
                assert!(error <= 188.0, "{dual:?} instead of {exact}, {p:?}");
            }
        }
    }

    /// Fixed point chooses the length of a cross product, and the gradient follows: a normal turns
    /// as it does in `f64`, up to eight steps, half of one for each product, sum and quotient on
    /// the way.
    #[test]
    fn the_slope_of_a_normal_in_fixed_point_is_that_of_f64() {
        fn slopes<T: Real + PartialOrd>(p: Vec3<T>, [b, c]: [Vec3<T>; 2]) -> Vec<T> {
            let moving = Dual::point(p);
            let [b, c] = [b, c].map(|v| v.map(Dual::constant));
            let triangle = normal::triangle(moving, b, c).expect("a triangle");
            let sphere = normal::sphere(b, moving).expect("a direction");
            let gradients = [triangle, sphere].map(|n| [n.x, n.y, n.z].map(|x| x.gradient));
            let numbers = gradients.concat().into_iter();
            numbers.flat_map(<[T; 3]>::from).collect()
        }

        let mut random = Random(11);
        for size in [2.0, 6.0, 30.0] {
            for _ in 0..100 {
                let mut near = |at: [f64; 3]| {
                    Vec3::from(at.map(|x| Fixed::new(size * (x + 0.2 * random.signed()))))
                };
                let [p, b, c] = [[0.0, 0.0, 0.3], [1.0, 0.1, 0.0], [-0.2, 1.0, 0.4]].map(&mut near);
                let exact = |v: Vec3<Fixed>| v.map(f64::from);
                let should = slopes(exact(p), [b, c].map(exact));
                let is = slopes(p, [b, c]);
                for (is, should) in is.into_iter().zip(should) {
                    let error = (f64::from(is) - should).abs();
                    assert!(
                        error <= 8.0 / 65_536.0,
                        "{is} for {should} at {p:?}, {b:?}, {c:?}"
                    );
                }
            }
        }
    }
}
