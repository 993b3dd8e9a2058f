//! Each SIMD lane has the bits of the scalar, whatever the other lanes hold. Lights in lanes add up to
//! those bits, in the order that their page gives; several at a time at one point, in their own order.

mod lights;

use std::fmt::Debug;

use proptest::prelude::*;
use shading::{
    Attenuation, Cone, DirectionalLight, Exponent, Light, Material, PointLight, Real, Rgb, Shaded,
    SpotLight, UnitVec3, Vec3, normal, reflection, shade, term,
};

/// The largest number of lanes of any type.
const LANES: usize = 16;

/// `f32` or `f64`, the type of one lane.
trait Scalar: Real + Exponent<Self> + PartialOrd + Debug {
    /// Zeros of both signs, subnormal and ordinary numbers, the ends of the range, infinities, and
    /// NaN.
    const EDGES: [Self; 18];
    const SIGNALING_NAN: Self;
    fn bits(self) -> u64;
}

/// A SIMD type.
trait Lanes: shading::Lanes<Lane = Self::Scalar> {
    type Scalar: Scalar + Exponent<Self>;
    fn lane(self, i: usize) -> Self::Scalar;
    fn gather(lane: impl FnMut(usize) -> Self::Scalar) -> Self {
        Self::from_fn(lane)
    }
    fn splat(x: Self::Scalar) -> Self {
        Self::from_fn(|_| x)
    }
}

macro_rules! lanes {
    ($float:ident: $($lanes:ident * $count:literal),*) => {
        impl Scalar for $float {
            const EDGES: [Self; 18] = {
                const TINY: $float = $float::from_bits(1);
                const ROUGH: $float = $float::from_bits(0x2D_4B1D); // subnormal; its root is irrational
                const LEAST: $float = $float::MIN_POSITIVE;
                const MAX: $float = $float::MAX;
                const INFINITY: $float = $float::INFINITY;
                [
                    0.0, -0.0, TINY, -TINY, ROUGH, -ROUGH, LEAST, -LEAST, 0.5, -0.7, 1.0, -1.0,
                    2.0, MAX, -MAX, INFINITY, -INFINITY, $float::NAN,
                ]
            };
            const SIGNALING_NAN: Self = $float::from_bits($float::INFINITY.to_bits() + 1);
            fn bits(self) -> u64 {
                // all NaNs count as equal
                if self.is_nan() { u64::MAX } else { self.to_bits().into() }
            }
        }
        $(
            impl Lanes for wide::$lanes {
                type Scalar = $float;
                fn lane(self, i: usize) -> $float {
                    self.to_array()[i]
                }
            }

            mod $lanes {
                use super::*;

                #[test]
                fn every_operation_agrees_at_the_edges() {
                    operations_agree::<wide::$lanes>();
                }

                #[test]
                fn powers_have_the_bits_of_the_scalar() {
                    powers_agree::<wide::$lanes>();
                }

                #[test]
                fn negative_or_nan_m_counts_as_0() {
                    no_shininess::<wide::$lanes>();
                }

                #[test]
                fn infinite_m_leaves_only_the_mirror_direction() {
                    infinite_shininess::<wide::$lanes>();
                }

                #[test]
                fn no_highlight_without_a_half_vector_or_a_cosine() {
                    no_highlight::<wide::$lanes>();
                }

                #[test]
                fn no_lights_make_no_pack() {
                    assert!(PointLight::<$float>::packed::<wide::$lanes>(&[]).next().is_none());
                }

                #[test]
                fn lamps_without_a_direction_add_nothing_in_lanes() {
                    lights::nowhere::<wide::$lanes>();
                }

                #[test]
                fn overflowing_lanes_are_the_largest_number() {
                    lights::overflow::<wide::$lanes>();
                }

                proptest! {
                    // WebAssembly has nowhere to keep a failing case
                    #![proptest_config(ProptestConfig { failure_persistence: None, ..<_>::default() })]

                    #[test]
                    fn everything_agrees(surfaces in surfaces(), lights in lights(), m in shininess()) {
                        agree::<wide::$lanes>(&surfaces, &lights, m);
                    }

                    #[test]
                    fn packs_hold_each_light_once(lights in lights::kinds()) {
                        lights::packs_hold::<wide::$lanes>(&lights);
                    }

                    #[test]
                    fn lanes_add_up_in_halves(numbers in prop::collection::vec(lights::edge(), LANES)) {
                        lights::add_up_in_halves::<wide::$lanes>(&numbers);
                    }

                    #[test]
                    fn lights_in_lanes_add_up_in_halves(
                        surface in surfaces(),
                        lights in prop::collection::vec(any_lamp(), 0..34),
                        m in shininess(),
                    ) {
                        lights::lights_add_up_in_halves::<wide::$lanes>(surface[0], &lights, m);
                    }
                }
            }
        )*
    };
}

lanes!(f32: f32x4 * 4, f32x8 * 8, f32x16 * 16);
lanes!(f64: f64x4 * 4, f64x8 * 8);

/// What differs from lane to lane: a point, N, V, and whether the point is at the first light.
type Surface = ([f64; 3], [f64; 3], [f64; 3], bool);
/// What all lanes share: the position, the intensity, a, b, c, the axis, and the cosine of the
/// cone.
type Lamp = ([f64; 3], [f64; 3], [f64; 3], [f64; 3], f64);

/// Mostly ordinary numbers; some whose squares underflow or overflow in `f32`, some that are
/// subnormal there, zeros, and the largest number.
fn number() -> BoxedStrategy<f64> {
    prop_oneof![
        12 => -4.0..4.0,
        1 => prop_oneof![Just(0.0), Just(-0.0), Just(f64::from(f32::MAX)), Just(-1e-45)],
        1 => (-1.0..1.0, -140..127).prop_map(|(x, power)| x * 2.0_f64.powi(power)),
    ]
    .boxed()
}

fn vector() -> impl Strategy<Value = [f64; 3]> {
    [number(), number(), number()]
}

/// Three numbers that are not negative.
fn light() -> impl Strategy<Value = [f64; 3]> {
    vector().prop_map(|v| v.map(f64::abs))
}

fn surfaces() -> impl Strategy<Value = Vec<Surface>> {
    let at_the_light = prop::bool::weighted(0.05);
    prop::collection::vec((vector(), vector(), vector(), at_the_light), LANES)
}

fn any_lamp() -> impl Strategy<Value = Lamp> {
    (vector(), light(), light(), vector(), -1.0..1.0)
}

fn lights() -> impl Strategy<Value = Vec<Lamp>> {
    prop::collection::vec(any_lamp(), 1..4)
}

/// Mostly a sensible m, sometimes any other.
fn shininess() -> impl Strategy<Value = f64> {
    let others = [-0.0, -1.0, f64::INFINITY, f64::NEG_INFINITY, f64::NAN];
    prop_oneof![8 => 0.0..300.0, 1 => prop::sample::select(others.to_vec())]
}

fn vec3<L: Lanes>(v: impl Fn(usize) -> [f64; 3]) -> Vec3<L> {
    let of = |k| L::gather(|i| L::Scalar::of(v(i)[k]));
    Vec3::new(of(0), of(1), of(2))
}

/// A light of each kind, with the number type of one lane.
fn lamp<S: Scalar>((position, intensity, [a, b, c], axis, cosine): &Lamp) -> [Light<S>; 3] {
    let of = |v: [f64; 3]| v.map(S::of);
    let axis = Vec3::from(of(*axis)).unit_or(UnitVec3::Z);
    let point = PointLight {
        position: of(*position).into(),
        intensity: of(*intensity).into(),
        attenuation: Attenuation::of(S::of(*a), S::of(*b), S::of(*c)).unwrap_or(Attenuation::NONE),
    };
    [
        Light::Point(point),
        Light::Directional(DirectionalLight {
            l: axis,
            intensity: point.intensity,
        }),
        Light::Spot(SpotLight {
            point,
            axis,
            cone: Cone::of_cosine(S::of(*cosine)).unwrap(),
        }),
    ]
}

/// Everything that can be computed at a surface point.
fn everything<T: Real, M: Exponent<T>>(
    p: Vec3<T>,
    [n, v]: [Vec3<T>; 2],
    lights: &[Light<T>],
    material: &Material<T, M>,
) -> Vec<T> {
    let [n, v] = [n, v].map(|direction| direction.unit_or(UnitVec3::X));
    let (m, i_a) = (material.m, Rgb::gray(T::of(0.25)));
    let mut all = vec![
        term::lambert(n, v),
        term::phong(n, v, m),
        term::blinn(n, v, m),
    ];
    let mut color = |c: Rgb<T>| all.extend(<[T; 3]>::from(c));
    color(<[T; 3]>::from(normal::facing(n, v)).into());
    color(<[T; 3]>::from(normal::corner(p, *n, *v)).into());
    for light in lights.iter().map(|light| light.at(p)) {
        color(light.intensity);
        color(Rgb::gray(light.distance));
        color(<[T; 3]>::from(light.l).into());
        color(light.intensity.clamped());
        color(<[T; 3]>::from(reflection(n, light.l)).into());
    }
    let at = || lights.iter().map(|light| light.at(p));
    let in_front = lights.iter().filter_map(|light| light.in_front(p, n));
    let mut shaded = |s: Shaded<T>| [s.ambient, s.diffuse, s.specular].map(&mut color);
    shaded(shade::lambert(n, material, i_a, at()));
    shaded(shade::phong(n, v, material, i_a, at()));
    shaded(shade::blinn_phong(n, v, material, i_a, at()));
    shaded(shade::blinn_phong(n, v, material, i_a, in_front));
    all
}

fn agree<L: Lanes>(surfaces: &[Surface], lamps: &[Lamp], m: f64) {
    let real = L::Scalar::of(m);
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    let whole = m as u32;
    agree_for::<L, L::Scalar>(surfaces, lamps, real);
    agree_for::<L, u32>(surfaces, lamps, whole);
}

fn agree_for<L: Lanes, M: Exponent<L> + Exponent<L::Scalar>>(
    surfaces: &[Surface],
    lamps: &[Lamp],
    m: M,
) {
    let splat = |x: L::Scalar| L::gather(|_| x);
    let lights: Vec<_> = lamps.iter().flat_map(lamp::<L::Scalar>).collect();
    let lights_of_lanes: Vec<_> = lights.iter().map(|light| light.cast(splat)).collect();
    let material = Material {
        k_a: Rgb::gray(L::Scalar::of(0.5)),
        k_d: Rgb::new(0.75, 0.5, 0.0).map(L::Scalar::of),
        k_s: Rgb::new(0.25, 1.0, 0.1).map(L::Scalar::of),
        m,
    };
    let place = |i: usize| {
        let (p, _, _, at_the_light) = surfaces[i];
        if at_the_light { lamps[0].0 } else { p }
    };
    let directions: [Vec3<L>; 2] = [vec3(|i| surfaces[i].1), vec3(|i| surfaces[i].2)];
    let lanes = everything(
        vec3(place),
        directions,
        &lights_of_lanes,
        &material.cast(splat),
    );
    for (i, surface) in surfaces.iter().enumerate().take(L::COUNT) {
        let scalar = |v: [f64; 3]| Vec3::from(v.map(L::Scalar::of));
        let directions = [surface.1, surface.2].map(scalar);
        let alone = everything(scalar(place(i)), directions, &lights, &material);
        for (k, (lanes, alone)) in lanes.iter().zip(alone).enumerate() {
            let lane = lanes.lane(i);
            let equal = lane.bits() == alone.bits();
            assert!(equal, "lane {i}, number {k}: {lane:?} instead of {alone:?}");
        }
    }
}

/// Each operation of the number type, on each pair of edges.
fn operations_agree<L: Lanes>() {
    let edges = L::Scalar::EDGES;
    let from = |first: usize, lane: usize| edges[(first + lane) % edges.len()];
    for (j, k) in (0..edges.len()).flat_map(|j| (0..edges.len()).map(move |k| (j, k))) {
        let [a, b] = [j, k].map(|first| L::gather(|i| from(first, i)));
        let lanes = operations(a, b);
        for i in 0..L::COUNT {
            let (a, b) = (from(j, i), from(k, i));
            for ((what, lanes), (_, alone)) in lanes.iter().zip(operations(a, b)) {
                let lane = lanes.lane(i);
                let equal = lane.bits() == alone.bits();
                assert!(
                    equal,
                    "{what} of {a:?} and {b:?}: {lane:?} instead of {alone:?}"
                );
            }
        }
        let (a, b) = (edges[j], edges[k]);
        let first_is_b = L::gather(|i| if i == 0 { b } else { a });
        let any = a.any_positive() || b.any_positive();
        assert_eq!(
            first_is_b.any_positive(),
            any,
            "{a:?}, and {b:?} in the first lane"
        );
    }
}

fn operations<T: Real>(a: T, b: T) -> [(&'static str, T); 11] {
    [
        ("sum", a + b),
        ("difference", a - b),
        ("product", a * b),
        ("quotient", a / b),
        ("opposite", -a),
        ("root", a.sqrt()),
        ("if_positive", a.if_positive(b, T::ONE)),
        ("if_above", a.if_above(b, T::ONE, b)),
        ("abs", a.abs()),
        ("at_least", a.at_least(b)),
        ("at_most", a.at_most(b)),
    ]
}

/// A direction whose dot product with Z is c; its length does not matter here.
fn tilted<T: Real>(c: T) -> UnitVec3<T> {
    UnitVec3::assume_unit(Vec3::new(T::ZERO, T::ZERO, c))
}

fn powers_agree<L: Lanes>() {
    for m in L::Scalar::EDGES
        .into_iter()
        .chain([L::Scalar::SIGNALING_NAN])
    {
        powers_agree_for::<L, L::Scalar>(m);
    }
    for m in [0, 1, 2, 3, 100, u32::MAX] {
        powers_agree_for::<L, u32>(m);
    }
}

fn powers_agree_for<L: Lanes, M: Exponent<L> + Exponent<L::Scalar> + Debug>(m: M) {
    let edges = L::Scalar::EDGES;
    for first in 0..edges.len() {
        let cosine = |i: usize| edges[(first + i) % edges.len()];
        let lanes = term::phong(UnitVec3::Z, tilted(L::gather(cosine)), m);
        for i in 0..L::COUNT {
            let (lane, alone) = (
                lanes.lane(i),
                term::phong(UnitVec3::Z, tilted(cosine(i)), m),
            );
            let equal = lane.bits() == alone.bits();
            let c = cosine(i);
            assert!(
                equal,
                "{c:?} to the power of {m:?}: {lane:?} instead of {alone:?}"
            );
        }
    }
}

/// The highlights of Phong and of Blinn–Phong on a white mirror, seen from V.
fn highlights<L: Lanes, M: Exponent<L>>(l: UnitVec3<L>, v: UnitVec3<L>, m: M) -> [L; 2] {
    let material = Material {
        k_a: Rgb::BLACK,
        k_d: Rgb::BLACK,
        k_s: Rgb::WHITE,
        m,
    };
    let sun = DirectionalLight {
        l,
        intensity: Rgb::WHITE,
    };
    let light = || [sun.at(Vec3::ZERO)];
    let phong = shade::phong(UnitVec3::Z, v, &material, Rgb::BLACK, light());
    let blinn = shade::blinn_phong(UnitVec3::Z, v, &material, Rgb::BLACK, light());
    [phong, blinn].map(|shaded| shaded.specular.g)
}

/// (0.6, 0, 0.8).
fn aslant<L: Lanes>() -> UnitVec3<L> {
    let [x, z] = [0.6, 0.8].map(L::of);
    UnitVec3::assume_unit(Vec3::new(x, L::ZERO, z))
}

fn assert_all<L: Lanes>(lanes: L, expected: f64) {
    for i in 0..L::COUNT {
        let (lane, expected) = (lanes.lane(i), L::Scalar::of(expected));
        let equal = lane.bits() == expected.bits();
        assert!(equal, "lane {i}: {lane:?} instead of {expected:?}");
    }
}

/// c⁰ = 1.
fn no_shininess<L: Lanes>() {
    let below_0 = [-1.0, -0.0, f64::NEG_INFINITY].map(L::Scalar::of);
    let not_numbers = [L::Scalar::of(f64::NAN), L::Scalar::SIGNALING_NAN];
    for m in below_0.into_iter().chain(not_numbers) {
        for highlight in highlights::<L, _>(UnitVec3::Z, aslant(), m) {
            assert_all(highlight, 1.0);
        }
    }
}

/// 1^∞ = 1, and c^∞ = 0 for c < 1.
fn infinite_shininess<L: Lanes>() {
    let m = L::Scalar::of(f64::INFINITY);
    for highlight in highlights::<L, _>(UnitVec3::Z, UnitVec3::Z, m) {
        assert_all(highlight, 1.0);
    }
    for highlight in highlights::<L, _>(UnitVec3::Z, aslant(), m) {
        assert_all(highlight, 0.0);
    }
}

/// Where L = −V, H is 0/0; a cosine of NaN gives no highlight.
fn no_highlight<L: Lanes>() {
    let nan = tilted(L::of(f64::NAN));
    for [phong, blinn] in [
        highlights::<L, u32>(aslant(), -aslant(), 8),
        highlights(aslant(), -aslant(), L::Scalar::of(8.0)),
        highlights::<L, u32>(aslant(), nan, 8),
        highlights(aslant(), nan, L::Scalar::of(8.0)),
    ] {
        assert_all(phong, 0.0);
        assert_all(blinn, 0.0);
    }
    // behind the surface, N·L is −0
    assert_all(term::lambert(UnitVec3::<L>::Z, -UnitVec3::X), 0.0);
    assert_all(Rgb::gray(L::of(-0.0)).clamped().g, 0.0);
}
