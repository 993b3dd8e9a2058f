//! Each SIMD lane has the bits of the scalar, whatever the other lanes hold, and lights in lanes add up
//! in the order that their page gives.

use std::fmt::Debug;

use proptest::prelude::*;
use shading::number::Mask;
use shading::{
    Attenuation, Cone, DirectionalLight, IncidentLight, Lanes, Light, Lobe, Material, PointLight,
    Real, Rgb, Shaded, SpotLight, UnitVec3, Vec3, attenuation, normal, reflection, shade, term,
};

/// `f32` or `f64`, the type of one lane.
trait Scalar: Real + Lobe<Self> + PartialOrd + Debug {
    /// Zeros of both signs, subnormal and ordinary numbers, the ends of the range, infinities and NaN.
    const EDGES: [Self; 18];
    const SIGNALING_NAN: Self;
    fn bits(self) -> u64;
}

/// A SIMD type, and its lane with a number.
trait Simd: Lanes<Lane: Scalar + Lobe<Self>> {
    fn lane(self, i: usize) -> Self::Lane;
}

macro_rules! scalar {
    ($($float:ident)*) => {$(
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
    )*};
}

scalar! { f32 f64 }

macro_rules! lanes {
    ($($float:ident: $($lanes:ident)*;)*) => {$($(
        impl Simd for wide::$lanes {
            fn lane(self, i: usize) -> $float {
                self.to_array()[i]
            }
        }

        mod $lanes {
            #[test]
            fn operations_and_powers_agree_at_the_edges() {
                super::edges_agree::<wide::$lanes>();
            }

            #[test]
            fn everything_agrees() {
                super::everything_agrees::<wide::$lanes>();
            }

            #[test]
            fn a_light_behind_adds_nothing_whatever_it_holds() {
                super::behind::<wide::$lanes>();
            }

            #[test]
            fn packs_hold_each_light_once_and_add_up_in_halves() {
                super::packs::<wide::$lanes>();
            }

            #[test]
            fn sums_of_lanes() {
                super::sums::<wide::$lanes>();
            }
        }
    )*)*};
}

lanes! {
    f32: f32x4 f32x8;
    f64: f64x2 f64x4;
}

// in `wide`, they are pairs of the others, but with AVX-512; elsewhere, the others suffice
#[cfg(target_arch = "x86_64")]
lanes! {
    f32: f32x16;
    f64: f64x8;
}

fn assert_same<S: Scalar>(lanes: &[S], alone: &[S], what: impl Debug) {
    assert_eq!(lanes.len(), alone.len());
    for (k, (lane, alone)) in lanes.iter().zip(alone).enumerate() {
        assert!(
            lane.bits() == alone.bits(),
            "{what:?}, number {k}: {lane:?} instead of {alone:?}"
        );
    }
}

/// A direction whose dot product with Z is c; its length does not matter here.
fn tilted<T: Real>(c: T) -> UnitVec3<T> {
    UnitVec3::assume_unit(Vec3::new(T::ZERO, T::ZERO, c))
}

/// Each operation of the number type, on each pair of edges, and each power of each edge.
fn edges_agree<L: Simd>() {
    fn operations<T: Real>(a: T, b: T) -> [T; 12] {
        [
            a + b,
            a - b,
            a * b,
            a / b,
            -a,
            a.sqrt(),
            a.above(T::ZERO).select(b, T::ONE),
            a.above(b).select(T::ONE, b),
            a.at_least(b),
            a.at_most(b),
            (Vec3::new(b, T::ONE, a) / b).z,
            term::lambert(UnitVec3::Z, tilted(a)),
        ]
    }
    fn powers<T: Real, M: Lobe<T>>(cosine: T, m: M) -> [T; 3] {
        let fraction = cosine.at_least(T::ZERO).at_most(T::ONE);
        [
            term::phong(UnitVec3::Z, tilted(cosine), m),
            term::blinn(tilted(cosine), UnitVec3::Z, m),
            m.raise_root(fraction),
        ]
    }
    let edges = L::Lane::EDGES;
    let from = |first: usize, lane: usize| edges[(first + lane) % edges.len()];
    for (j, k) in (0..edges.len()).flat_map(|j| (0..edges.len()).map(move |k| (j, k))) {
        let [a, b] = [j, k].map(|first| L::from_fn(|i| from(first, i)));
        for i in 0..L::COUNT {
            let (a_i, b_i) = (from(j, i), from(k, i));
            assert_same(
                &operations(a, b).map(|x| x.lane(i)),
                &operations(a_i, b_i),
                (a_i, b_i),
            );
            assert_same(
                &powers(a, edges[k]).map(|x| x.lane(i)),
                &powers(a_i, edges[k]),
                (a_i, edges[k]),
            );
        }
        let mixed = L::from_fn(|i| if i == 0 { edges[j] } else { edges[k] });
        assert_eq!(
            mixed.above(L::ZERO).any(),
            edges[j] > <_>::ZERO || edges[k] > <_>::ZERO
        );
        for m in [0, 1, 2, 3, 100, u32::MAX] {
            for i in 0..L::COUNT {
                assert_same(
                    &powers(a, m).map(|x| x.lane(i)),
                    &powers(from(j, i), m),
                    (from(j, i), m),
                );
            }
        }
    }
    // a signaling NaN is no shininess: c⁰ = 1, also in lanes
    let half = L::from_fn(|_| L::Lane::of(0.5));
    let power = term::phong(UnitVec3::Z, tilted(half), L::Lane::SIGNALING_NAN);
    assert_same(
        &[power.to_lanes().as_ref()[0]],
        &[L::Lane::ONE],
        "signaling",
    );
}

/// Mostly ordinary numbers; some whose squares underflow or overflow, zeros, the lengths from which
/// vectors are scaled, the ends, and what is not finite.
fn number() -> BoxedStrategy<f64> {
    const ENDS: &[f64] = &[
        0.0,
        -0.0,
        f32::MAX as f64,
        -1e-45,
        1_125_899_906_842_624.0, // 2⁵⁰
        1.0 / 1_125_899_906_842_624.0,
        2.348_542_582_773_833_2e108, // 2³⁶⁰
        1.0 / 2.348_542_582_773_833_2e108,
        f64::MAX,
        f64::INFINITY,
        f64::NEG_INFINITY,
        f64::NAN,
    ];
    prop_oneof![
        16 => -4.0..4.0,
        1 => prop::sample::select(ENDS),
        1 => (-1.0..1.0, -140..127).prop_map(|(x, power)| x * 2.0_f64.powi(power)),
        1 => (-1.0..1.0, -1000..1000).prop_map(|(x, power)| x * 2.0_f64.powi(power)),
    ]
    .boxed()
}

/// A place and a light of each kind: 40 numbers, which every lane draws on its own.
#[derive(Clone, Copy)]
struct Place<T> {
    p: Vec3<T>,
    n: UnitVec3<T>,
    v: UnitVec3<T>,
    q: T,
    sun: DirectionalLight<T>,
    lamp: PointLight<T>,
    spot: SpotLight<T>,
    rgb: Rgb<T>,
}

const NUMBERS: usize = 40;

impl<S: Scalar> Place<S> {
    fn new(numbers: &[f64]) -> Self {
        let mut numbers = numbers.iter().copied();
        let mut next = || numbers.next().expect("as many");
        let mut vector = || Vec3::from([(); 3].map(|()| S::of(next())));
        let [p, position, aside] = [(); 3].map(|()| vector());
        let [n, v, l, axis] = [(); 4].map(|()| vector().unit_or(UnitVec3::Z));
        let [intensity, coefficients, rgb, kind] =
            [(); 4].map(|()| vector().map(|x| x.at_least(-x)));
        let [a, b, c] = coefficients.into();
        let falloff = Attenuation::new(a, b, c).unwrap_or_default();
        // a lane may have a range, be clamped, or have glTF's window where another has none
        let range = match (kind.x > S::of(2.0), kind.z > S::of(2.0)) {
            (false, _) => None,
            (true, false) => falloff.within(kind.x),
            (true, true) => falloff.within_gltf(kind.x),
        };
        let falloff = range.unwrap_or(falloff);
        let falloff = if kind.y > S::of(2.0) {
            falloff.clamped()
        } else {
            falloff
        };
        let inner = S::of(next() / 4.0).at_least(S::NEG_ONE).at_most(S::ONE);
        let outer = if kind.z > S::ONE {
            inner
        } else {
            (inner - kind.y).at_least(S::NEG_ONE)
        };
        let cone = Cone::from_cosines(inner, outer).expect("in order");
        let cone = if kind.x > S::ONE {
            cone.smoothstep()
        } else {
            cone
        };
        let intensity = Rgb::from(<[S; 3]>::from(intensity));
        let at_the_lamp = kind.x > S::of(3.8);
        let lamp = PointLight {
            position,
            intensity,
            attenuation: falloff,
        };
        Self {
            p: if at_the_lamp { position } else { p },
            n,
            v: if kind.y > S::of(3.8) { -l } else { v },
            q: S::of(next().abs()),
            sun: DirectionalLight { l, intensity },
            lamp,
            spot: SpotLight {
                point: PointLight {
                    position: aside,
                    ..lamp
                },
                axis,
                cone,
            },
            rgb: Rgb::from(<[S; 3]>::from(rgb)),
        }
    }
}

/// The places of all lanes at once.
fn gathered<L: Simd>(places: &[Place<L::Lane>]) -> Place<L> {
    let gather = |of: fn(&Place<L::Lane>) -> L::Lane| L::from_fn(|i| of(&places[i]));
    let unit = |of: fn(&Place<L::Lane>) -> UnitVec3<L::Lane>| {
        let part = |k: usize| L::from_fn(|i| <[L::Lane; 3]>::from(of(&places[i]))[k]);
        UnitVec3::assume_unit(Vec3::new(part(0), part(1), part(2)))
    };
    let suns: Vec<_> = places.iter().map(|place| place.sun).collect();
    let lamps: Vec<_> = places.iter().map(|place| place.lamp).collect();
    let spots: Vec<_> = places.iter().map(|place| place.spot).collect();
    Place {
        p: Vec3::new(gather(|c| c.p.x), gather(|c| c.p.y), gather(|c| c.p.z)),
        n: unit(|c| c.n),
        v: unit(|c| c.v),
        q: gather(|c| c.q),
        sun: DirectionalLight::packed(&suns).next().expect("a pack"),
        lamp: PointLight::packed(&lamps).next().expect("a pack"),
        spot: SpotLight::packed(&spots).next().expect("a pack"),
        rgb: Rgb::new(
            gather(|c| c.rgb.r),
            gather(|c| c.rgb.g),
            gather(|c| c.rgb.b),
        ),
    }
}

/// A highlight that is infinite, and NaN at a cosine of 0.
#[derive(Clone, Copy)]
struct Infinite;

impl<T: Real> Lobe<T> for Infinite {
    fn raise(self, cosine: T) -> T {
        cosine / T::ZERO
    }
}

/// Any highlight, so that [`everything`] is compiled once for each number, which takes a while.
#[derive(Clone, Copy)]
enum Any<S> {
    Whole(u32),
    Real(S),
    Infinite,
}

impl<T: Real, S: Lobe<T>> Lobe<T> for Any<S> {
    fn raise(self, cosine: T) -> T {
        match self {
            Self::Whole(m) => m.raise(cosine),
            Self::Real(m) => m.raise(cosine),
            Self::Infinite => Infinite.raise(cosine),
        }
    }

    fn raise_root(self, square: T) -> T {
        match self {
            Self::Whole(m) => m.raise_root(square),
            Self::Real(m) => m.raise_root(square),
            Self::Infinite => Infinite.raise_root(square),
        }
    }

    fn raise_quotient(self, square: T, of: T) -> T {
        match self {
            Self::Whole(m) => m.raise_quotient(square, of),
            Self::Real(m) => m.raise_quotient(square, of),
            Self::Infinite => Infinite.raise_quotient(square, of),
        }
    }
}

/// Everything that can be computed of a number that is not compared.
fn everything<T: Real, S: Lobe<T>>(c: &Place<T>, m: Any<S>) -> Vec<T> {
    let &Place {
        p, n, v, q, rgb, ..
    } = c;
    let material = Material {
        k_a: rgb,
        k_d: rgb * rgb,
        k_s: Rgb::new(rgb.g, rgb.b, T::ONE),
        m,
    };
    let lights: [Light<T>; 3] = [c.sun.into(), c.lamp.into(), c.spot.into()];
    let lit = || lights.iter().map(|light| light.at(p));
    let shaded = [
        shade::lambert(n, &material, rgb, lit()),
        shade::phong(n, v, &material, rgb, lit()),
        shade::blinn_phong(n, v, &material, rgb, lit()),
        shade::blinn_phong(
            n,
            v,
            &material,
            rgb,
            lit().filter(|light| light.is_in_front(n)),
        ),
    ];
    let of_light = |light: IncidentLight<T>| {
        let dimmed = (light * q * rgb).intensity();
        [
            Vec3::from(light.l()),
            Vec3::splat(light.distance()),
            vector(light.intensity()),
            vector(dimmed),
        ]
    };
    let vectors = [
        vec![
            Vec3::from(reflection(n, v)),
            normal::facing(n, v, n).into(),
            normal::corner(p, *n, *v),
        ],
        vec![
            p.cross(n),
            *(p - v).unit_or(n),
            Vec3::splat(p.length()),
            p.lerp(*v, q),
            vector(rgb.clamped()),
        ],
        lit().flat_map(of_light).collect(),
        shaded
            .iter()
            .flat_map(|s| [s.ambient, s.diffuse, s.specular, s.total()].map(vector))
            .collect(),
    ];
    let numbers = [
        term::lambert(n, v),
        term::phong(n, v, m),
        term::blinn(n, v, m),
        T::halfway_power(*n, T::measured(p), *v, m),
        attenuation(rgb.r, rgb.g, rgb.b, q),
        c.lamp.attenuation.at(q),
        c.spot.cone.factor(n, v),
    ];
    vectors
        .concat()
        .into_iter()
        .flat_map(<[T; 3]>::from)
        .chain(numbers)
        .collect()
}

fn vector<T: Real>(rgb: Rgb<T>) -> Vec3<T> {
    Vec3::from(<[T; 3]>::from(rgb))
}

fn config(cases: u32) -> ProptestConfig {
    // WebAssembly has nowhere to keep a failing case
    ProptestConfig {
        cases,
        failure_persistence: None,
        ..<_>::default()
    }
}

fn places<S: Scalar>(count: usize) -> impl Strategy<Value = Vec<Place<S>>> {
    let place = prop::collection::vec(number(), NUMBERS).prop_map(|numbers| Place::new(&numbers));
    prop::collection::vec(place.no_shrink(), count)
}

impl<S: Scalar> Debug for Place<S> {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        write!(
            f,
            "{:?}",
            (
                self.p, self.n, self.v, self.q, self.sun, self.lamp, self.spot, self.rgb
            )
        )
    }
}

fn everything_agrees<L: Simd>() {
    fn agree<L: Simd>(places: &[Place<L::Lane>], m: Any<L::Lane>) {
        let lanes = everything(&gathered::<L>(places), m);
        for (i, place) in places.iter().enumerate() {
            let lane: Vec<_> = lanes.iter().map(|x| x.lane(i)).collect();
            assert_same(&lane, &everything(place, m), ("lane", i, place));
        }
    }
    proptest!(config(96), |(places in places::<L::Lane>(L::COUNT), m in 0..300_u32, real in 0.0..300.0)| {
        agree::<L>(&places, Any::Whole(m));
        agree::<L>(&places, Any::Real(L::Lane::of(real)));
    });
}

/// Lights of each kind that are behind the surface in one lane or in all but one, with each edge as
/// their intensity, or with a highlight that is not finite.
fn behind<L: Simd>() {
    let edges = L::Lane::EDGES;
    let (zero, one) = (L::Lane::ZERO, L::Lane::ONE);
    let place = |intensity: L::Lane, is_behind: bool| {
        let z = if is_behind { -one } else { one };
        let l = UnitVec3::assume_unit(Vec3::new(zero, zero, z));
        let intensity = Rgb::gray(intensity);
        let attenuation = Attenuation::NONE;
        let lamp = PointLight {
            position: *l,
            intensity,
            attenuation,
        };
        Place {
            p: Vec3::ZERO,
            n: UnitVec3::Z,
            v: UnitVec3::assume_unit(Vec3::new(L::Lane::of(0.6), zero, L::Lane::of(0.8))),
            q: one,
            sun: DirectionalLight { l, intensity },
            lamp,
            spot: SpotLight {
                point: lamp,
                axis: -l,
                cone: Cone::from_cosine(zero).expect("a cosine"),
            },
            rgb: Rgb::WHITE,
        }
    };
    let highlights = [Any::Whole(3), Any::<L::Lane>::Infinite];
    // each edge alone, in front of the surface and behind it
    let alone = edges.map(|edge| {
        [false, true].map(|is_behind| {
            let place = place(edge, is_behind);
            highlights.map(|m| everything(&place, m))
        })
    });
    for first in 0..edges.len() {
        for (lane, is_behind) in (0..L::COUNT).flat_map(|lane| [(lane, true), (lane, false)]) {
            let edge = |i: usize| (first + 5 * i) % edges.len();
            let is_behind = |i: usize| (i == lane) == is_behind;
            let places: Vec<_> = (0..L::COUNT)
                .map(|i| place(edges[edge(i)], is_behind(i)))
                .collect();
            let gathered = gathered::<L>(&places);
            let lanes = highlights.map(|m| everything(&gathered, m));
            for i in 0..L::COUNT {
                let alone = &alone[edge(i)][usize::from(is_behind(i))];
                for (lanes, alone) in lanes.iter().zip(alone) {
                    let lane: Vec<_> = lanes.iter().map(|x| x.lane(i)).collect();
                    assert_same(&lane, alone, ("lane", i, &places));
                }
            }
        }
    }
}

/// Lights keep their order, whatever they differ in; lanes without a light hold the first, black.
fn packs<L: Simd>() {
    fn in_lanes<L: Simd, V>(
        packs: impl Iterator<Item = V>,
        lane: impl Fn(&V, usize) -> String,
    ) -> Vec<String> {
        packs
            .flat_map(|pack| (0..L::COUNT).map(|i| lane(&pack, i)).collect::<Vec<_>>())
            .collect()
    }
    assert!(PointLight::<L::Lane>::packed::<L>(&[]).next().is_none());
    let m = 3_u32;
    let count = 0..2 * L::COUNT + 2;
    let one = places::<L::Lane>(1);
    proptest!(config(64), |(places in count.prop_flat_map(places::<L::Lane>), one in one)| {
        let rounded = places.len().div_ceil(L::COUNT) * L::COUNT;
        let expected = |black: fn(&mut Place<L::Lane>)| (0..rounded).map(|i| {
            let mut first = places[i / L::COUNT * L::COUNT];
            black(&mut first);
            *places.get(i).unwrap_or(&first)
        }).collect::<Vec<_>>();
        let suns: Vec<_> = places.iter().map(|c| c.sun).collect();
        let lamps: Vec<_> = places.iter().map(|c| c.lamp).collect();
        let spots: Vec<_> = places.iter().map(|c| c.spot).collect();
        let text = |light: &dyn Debug| format!("{light:?}");
        prop_assert_eq!(
            in_lanes::<L, _>(DirectionalLight::packed::<L>(&suns), |p, i| text(&p.cast(|x| x.lane(i)))),
            expected(|c| c.sun.intensity = Rgb::BLACK).iter().map(|c| text(&c.sun)).collect::<Vec<_>>()
        );
        prop_assert_eq!(
            in_lanes::<L, _>(PointLight::packed::<L>(&lamps), |p, i| text(&p.cast(|x| x.lane(i)))),
            expected(|c| c.lamp.intensity = Rgb::BLACK).iter().map(|c| text(&c.lamp)).collect::<Vec<_>>()
        );
        prop_assert_eq!(
            in_lanes::<L, _>(SpotLight::packed::<L>(&spots), |p, i| text(&p.cast(|x| x.lane(i)))),
            expected(|c| c.spot.point.intensity = Rgb::BLACK).iter().map(|c| text(&c.spot)).collect::<Vec<_>>()
        );

        // the sum in lanes is the sum in each, and then in halves
        let splat = |x: L::Lane| L::from_fn(|_| x);
        let Place { p, n, v, rgb, .. } = one[0];
        let white = Material { k_a: rgb, k_d: Rgb::WHITE, k_s: Rgb::WHITE, m };
        let packs = PointLight::packed::<L>(&lamps).map(|pack| pack.at(p.map(splat)));
        let sum = shade::blinn_phong(n.cast(splat), v.cast(splat), &white.cast(splat), rgb.map(splat), packs);
        let sum = sum.sum_of_lanes();
        let alone: Vec<_> = (0..L::COUNT).map(|i| {
            let lamps = lamps.iter().skip(i).step_by(L::COUNT).map(|lamp| lamp.at(p));
            shade::blinn_phong(n, v, &white, rgb, lamps)
        }).collect();
        let in_halves = |of: fn(&Shaded<L::Lane>) -> L::Lane| {
            halves(&alone.iter().map(of).collect::<Vec<_>>()).at_most(Real::MAX)
        };
        assert_same(
            &[sum.ambient.r, sum.diffuse.r, sum.diffuse.b, sum.specular.g],
            &[rgb.r * rgb.r, in_halves(|s| s.diffuse.r), in_halves(|s| s.diffuse.b), in_halves(|s| s.specular.g)],
            "halves",
        );
    });
}

/// The sum as its page gives it.
fn halves<S: Real>(lanes: &[S]) -> S {
    if let [one] = lanes {
        return *one;
    }
    let (lower, upper) = lanes.split_at(lanes.len() / 2);
    halves(
        &lower
            .iter()
            .zip(upper)
            .map(|(&a, &b)| a + b)
            .collect::<Vec<_>>(),
    )
}

/// A sum that overflows is the largest number, as one by one; a light without a direction adds nothing.
fn sums<L: Simd>() {
    let edges = L::Lane::EDGES;
    for first in 0..edges.len() {
        let lanes: Vec<_> = (0..L::COUNT)
            .map(|i| edges[(5 * i + first) % edges.len()])
            .collect();
        let of_lanes = L::from_fn(|i| lanes[i]);
        assert_same(
            &[of_lanes.to_lanes().as_ref()[0], of_lanes.sum()],
            &[lanes[0], halves(&lanes)],
            &lanes,
        );
        let [ambient, diffuse, specular] = [Rgb::gray(of_lanes); 3];
        let sum = Shaded {
            ambient,
            diffuse,
            specular,
        }
        .sum_of_lanes();
        let expected = halves(&lanes).at_most(Real::MAX);
        assert_same(
            &[sum.ambient.g, sum.diffuse.r, sum.specular.b],
            &[lanes[0], expected, expected],
            &lanes,
        );
    }

    let one = L::Lane::ONE;
    let at = |x: L::Lane, intensity| PointLight {
        position: Vec3::new(x, L::Lane::ZERO, L::Lane::ZERO),
        intensity: Rgb::gray(intensity),
        attenuation: Attenuation::NONE,
    };
    // one lane has a range, and the others none
    let mixed = [Some(one), None].map(|range| {
        let attenuation = range.and_then(|r| Attenuation::NONE.within(r));
        PointLight {
            attenuation: attenuation.unwrap_or_default(),
            ..at(one, one)
        }
    });
    let pack = PointLight::packed::<L>(&mixed).next().expect("a pack");
    for q in edges {
        let factor = pack.attenuation.at(L::from_fn(|_| q));
        let alone = mixed.map(|lamp| lamp.attenuation.at(q));
        assert_same(&[factor.lane(0), factor.lane(1)], &alone, q);
    }
    let mirror = Material {
        k_a: Rgb::gray(L::ONE),
        k_d: Rgb::gray(L::ONE),
        k_s: Rgb::gray(L::ONE),
        m: 1,
    };
    let shaded = |lamps: &[PointLight<L::Lane>]| {
        let packs = PointLight::packed::<L>(lamps).map(|pack| pack.at(Vec3::ZERO));
        shade::phong(UnitVec3::X, UnitVec3::X, &mirror, Rgb::BLACK, packs)
            .sum_of_lanes()
            .total()
            .r
    };
    let [.., infinity, minus_infinity, nan] = edges;
    for place in [L::Lane::ZERO, infinity, minus_infinity, nan] {
        assert_same(
            &[shaded(&[at(place, one), at(one, one), at(place, one)])],
            &[one + one],
            place,
        );
    }
    assert_same(
        &[shaded(&vec![at(one, L::Lane::MAX); L::COUNT + 1])],
        &[L::Lane::MAX + L::Lane::MAX],
        "overflow",
    );
}
