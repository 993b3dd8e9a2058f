//! Each SIMD lane has the bits of the scalar, whatever stands in the other lanes.

use std::fmt::Debug;

use proptest::prelude::*;
use shading::{
    Attenuation, Cone, Exponent, Light, Material, PointLight, Real, Rgb, Shaded, SpotLight,
    UnitVec3, Vec3, normal, reflection, shade, term,
};
use wide::{f32x4, f32x8, f32x16, f64x4, f64x8};

/// The most lanes of all the types.
const LANES: usize = 16;

/// `f32` or `f64`, as the lanes hold it.
trait Scalar: Real + Exponent<Self> + Debug {
    fn bits(self) -> u64;
    fn attenuation(a: Self, b: Self, c: Self) -> Option<Attenuation<Self>>;
    fn cone(cosine: Self) -> Option<Cone<Self>>;
}

/// A SIMD type.
trait Lanes: Real {
    type Scalar: Scalar + Exponent<Self>;
    const COUNT: usize;
    fn gather(lane: impl FnMut(usize) -> Self::Scalar) -> Self;
    fn lane(self, i: usize) -> Self::Scalar;
}

macro_rules! lanes {
    ($float:ident: $($lanes:ident * $count:literal),*) => {
        impl Scalar for $float {
            fn bits(self) -> u64 {
                // any NaN is as good as another
                if self.is_nan() { u64::MAX } else { self.to_bits().into() }
            }
            fn attenuation(a: Self, b: Self, c: Self) -> Option<Attenuation<Self>> {
                Attenuation::<$float>::new(a, b, c)
            }
            fn cone(cosine: Self) -> Option<Cone<Self>> {
                Cone::<$float>::from_cosine(cosine)
            }
        }
        $(
            impl Lanes for $lanes {
                type Scalar = $float;
                const COUNT: usize = $count;
                fn gather(lane: impl FnMut(usize) -> $float) -> Self {
                    Self::new(std::array::from_fn(lane))
                }
                fn lane(self, i: usize) -> $float {
                    self.to_array()[i]
                }
            }

            proptest! {
                #[test]
                fn $lanes(surfaces in surfaces(), lights in lights(), m in 0.0..300.0_f64) {
                    agree::<$lanes>(&surfaces, &lights, m);
                }
            }
        )*
    };
}

lanes!(f32: f32x4 * 4, f32x8 * 8, f32x16 * 16);
lanes!(f64: f64x4 * 4, f64x8 * 8);

/// What differs from lane to lane: a point, N, V, and whether the point is at the first light.
type Surface = ([f64; 3], [f64; 3], [f64; 3], bool);
/// What is the same in all: position, intensity, a, b, c, the axis and the cosine of the cone.
type Lamp = ([f64; 3], [f64; 3], [f64; 3], [f64; 3], f64);

/// Ordinary numbers mostly; of the others some whose squares vanish or overflow in `f32`, some
/// that are subnormal there, zeros and the largest.
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

/// Not negative.
fn light() -> impl Strategy<Value = [f64; 3]> {
    vector().prop_map(|v| v.map(f64::abs))
}

fn surfaces() -> impl Strategy<Value = Vec<Surface>> {
    let at_the_light = prop::bool::weighted(0.05);
    prop::collection::vec((vector(), vector(), vector(), at_the_light), LANES)
}

fn lights() -> impl Strategy<Value = Vec<Lamp>> {
    prop::collection::vec((vector(), light(), light(), vector(), -1.0..1.0), 1..4)
}

fn vec3<L: Lanes>(v: impl Fn(usize) -> [f64; 3]) -> Vec3<L> {
    let of = |k| L::gather(|i| L::Scalar::of(v(i)[k]));
    Vec3::new(of(0), of(1), of(2))
}

/// A light of each kind, over the number type of the lanes.
fn lamp<S: Scalar>((position, intensity, [a, b, c], axis, cosine): &Lamp) -> [Light<S>; 3] {
    let of = |v: [f64; 3]| v.map(S::of);
    let axis = Vec3::from(of(*axis)).unit_or(UnitVec3::Z);
    let point = PointLight {
        position: of(*position).into(),
        intensity: of(*intensity).into(),
        attenuation: S::attenuation(S::of(*a), S::of(*b), S::of(*c)).unwrap_or(Attenuation::NONE),
    };
    [
        Light::Point(point),
        Light::Directional(shading::DirectionalLight {
            l: axis,
            intensity: point.intensity,
        }),
        Light::Spot(SpotLight {
            point,
            axis,
            cone: S::cone(S::of(*cosine)).unwrap(),
        }),
    ]
}

/// Everything there is to compute at a surface point.
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
    let mut colour = |c: Rgb<T>| all.extend(<[T; 3]>::from(c));
    colour(<[T; 3]>::from(normal::facing(n, v)).into());
    colour(<[T; 3]>::from(normal::corner(p, *n, *v)).into());
    for light in lights.iter().map(|light| light.at(p)) {
        colour(light.intensity);
        colour(Rgb::gray(light.distance));
        colour(<[T; 3]>::from(light.l).into());
        colour(light.intensity.clamped());
        colour(<[T; 3]>::from(reflection(n, light.l)).into());
    }
    let at = || lights.iter().map(|light| light.at(p));
    let in_front = lights.iter().filter_map(|light| light.in_front(p, n));
    let mut shaded = |s: Shaded<T>| [s.ambient, s.diffuse, s.specular].map(&mut colour);
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
