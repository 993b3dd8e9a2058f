//! Every public function that computes something, each called by a function of its own.

#[cfg(feature = "wide")]
mod packed;

use std::hint::black_box;

use shading::{
    Attenuation, Cone, DirectionalLight, Dual, Elementary, Exponent, Light, Material, PointLight,
    Ranged, Real, Rgb, SoftCone, SpotLight, UnitVec3, Vec3, normal, shade,
};

/// The number of places.
pub const CALLS: u16 = 4096;

/// Everything that a function may take, at a random surface point.
#[derive(Clone, Copy)]
pub struct Place {
    p: Vec3<f32>,
    a: Vec3<f32>,
    n: UnitVec3<f32>,
    l: UnitVec3<f32>,
    v: UnitVec3<f32>,
    x: f32,
}

const POINT: PointLight<f32> = PointLight {
    position: Vec3::new(1.0, 2.0, 3.0),
    intensity: Rgb::new(1.0, 0.9, 0.8),
    attenuation: Attenuation::<f32>::new(1.0, 0.1, 0.05).unwrap(),
};
const SPOT: SpotLight<f32> = SpotLight {
    point: POINT,
    axis: UnitVec3::<f32>::new(0.0, -0.6, -0.8).unwrap(),
    cone: Cone::<f32>::from_half_angle(0.5).unwrap(),
};
const SOFT_SPOT: SpotLight<f32, SoftCone<f32>, Ranged<f32>> = SpotLight {
    point: PointLight {
        position: POINT.position,
        intensity: POINT.intensity,
        attenuation: POINT.attenuation.within(4.0).unwrap(),
    },
    axis: SPOT.axis,
    cone: SoftCone::<f32>::from_half_angles(0.3, 0.5).unwrap(),
};
const SUN: DirectionalLight<f32> = DirectionalLight {
    l: UnitVec3::<f32>::Y,
    intensity: POINT.intensity,
};
const WHOLE: Material<f32, u32> = Material {
    k_a: Rgb::new(0.3, 0.25, 0.2),
    k_d: Rgb::new(0.6, 0.5, 0.4),
    k_s: Rgb::new(0.4, 0.4, 0.35),
    m: 50,
};
const REAL: Material<f32, f32> = Material {
    k_a: WHOLE.k_a,
    k_d: WHOLE.k_d,
    k_s: WHOLE.k_s,
    m: 50.5,
};
static LIGHTS: [Light<f32>; 3] = [
    Light::Point(POINT),
    Light::Spot(SPOT),
    Light::Directional(SUN),
];
static POINTS: [PointLight<f32>; 4] = [POINT; 4];

macro_rules! functions {
    ($($(#[$if:meta])? $name:ident: |$place:ident| $body:expr;)*) => {
        $(
            $(#[$if])?
            #[unsafe(export_name = concat!("shading_counted_", stringify!($name)))]
            #[inline(never)]
            extern "C" fn $name($place: &Place) {
                black_box($body);
            }
        )*
        /// Each function's name, and the function that calls it.
        pub const FUNCTIONS: &[(&str, extern "C" fn(&Place))] = &[$($(#[$if])? (stringify!($name), $name)),*];
    };
}

functions! {
    nothing: |s| s.x;
    dot: |s| s.p.dot(s.a);
    cross: |s| s.p.cross(s.a);
    unit: |s| s.p.unit();
    unit_or: |s| s.p.unit_or(s.n);
    reflection: |s| shading::reflection(s.n, s.l);
    half_vector: |s| shading::half_vector(s.l, s.v);
    ambient: |s| shading::term::ambient(REAL.k_a, Rgb::gray(s.x));
    lambert: |s| shading::term::lambert(s.n, s.l);
    phong_whole: |s| shading::term::phong(s.l, s.v, black_box(50_u32));
    phong_real: |s| shading::term::phong(s.l, s.v, black_box(50.5_f32));
    blinn_whole: |s| shading::term::blinn(s.n, s.v, black_box(50_u32));
    blinn_real: |s| shading::term::blinn(s.n, s.v, black_box(50.5_f32));
    power_whole: |s| black_box(50_u32).raise(s.x);
    power_real: |s| black_box(50.5_f32).raise(s.x);
    attenuation: |s| shading::attenuation(1.0, 0.1, s.x, s.a.x);
    attenuation_checked: |s| black_box(POINT.attenuation).at(s.x);
    cone: |s| black_box(SPOT.cone).factor(s.v, s.l);
    soft_cone: |s| black_box(SOFT_SPOT.cone).factor(s.v, s.l);
    attenuation_ranged: |s| black_box(SOFT_SPOT.point.attenuation).at(s.x);
    directional_light: |s| black_box(&SUN).at(s.p);
    point_light: |s| black_box(&POINT).at(s.p);
    point_light_in_front: |s| black_box(&POINT).in_front(s.p, s.n);
    spot_light: |s| black_box(&SPOT).at(s.p);
    spot_light_in_front: |s| black_box(&SPOT).in_front(s.p, s.n);
    soft_spot_light: |s| black_box(&SOFT_SPOT).at(s.p);
    soft_spot_light_in_front: |s| black_box(&SOFT_SPOT).in_front(s.p, s.n);
    any_light: |s| black_box(&LIGHTS)[1].at(s.p);
    clamped: |s| Rgb::from(<[f32; 3]>::from(s.p)).clamped();
    to_srgb8: |s| Rgb::from(<[f32; 3]>::from(s.p)).to_srgb8();
    from_srgb8: |s| { let [r, g, b, _] = s.x.to_bits().to_le_bytes(); Rgb::from_srgb8([r, g, b]) };
    to_rgb565: |s| Rgb::from(<[f32; 3]>::from(s.p)).to_rgb565();
    phong_normalization: |s| shading::term::phong_normalization(50.0 * s.x);
    blinn_normalization: |s| shading::term::blinn_normalization(50.0 * s.x);
    normal_plane: |s| normal::plane(s.p.x, s.p.y, s.p.z);
    normal_triangle: |s| normal::triangle(s.p, s.a, *s.v);
    normal_sphere: |s| normal::sphere(s.a, s.p);
    normal_implicit: |s| normal::implicit(torus, s.p);
    normal_from_gradient: |s| normal::from_gradient(s.p);
    normal_parametric: |s| normal::parametric(paraboloid, s.p.x, s.p.y);
    normal_from_tangents: |s| normal::from_tangents(s.p, s.a);
    normal_facing: |s| normal::facing(s.n, s.v);
    normal_transformed: |s| normal::transformed(s.n, [s.p, s.a, *s.l]);
    normal_corner: |s| normal::corner(s.p, s.a, *s.v);
    normal_mapped: |s| normal::mapped(s.n, s.p, s.x, s.a);
    dual_sine: |s| Dual::point(s.p).x.sin();
    sum_lambert: |s| shade::lambert(s.n, black_box(&REAL), Rgb::WHITE, at(s));
    sum_phong_whole: |s| shade::phong(s.n, s.v, black_box(&WHOLE), Rgb::WHITE, at(s));
    sum_phong_real: |s| shade::phong(s.n, s.v, black_box(&REAL), Rgb::WHITE, at(s));
    sum_blinn_phong_whole: |s| shade::blinn_phong(s.n, s.v, black_box(&WHOLE), Rgb::WHITE, at(s));
    sum_blinn_phong_real: |s| shade::blinn_phong(s.n, s.v, black_box(&REAL), Rgb::WHITE, at(s));
    sum_in_front_whole: |s| shade::blinn_phong(s.n, s.v, black_box(&WHOLE), Rgb::WHITE, in_front(s));
    sum_in_front_real: |s| shade::blinn_phong(s.n, s.v, black_box(&REAL), Rgb::WHITE, in_front(s));
    sum_all_in_front_whole: |s| shade::blinn_phong(s.n, s.v, black_box(&WHOLE), Rgb::WHITE, all_in_front(s));
    sum_all_in_front_real: |s| shade::blinn_phong(s.n, s.v, black_box(&REAL), Rgb::WHITE, all_in_front(s));
    #[cfg(feature = "wide")]
    points_packed: |s| packed::points(s);
    #[cfg(feature = "wide")]
    lights_packed: |s| packed::lights(s);
    #[cfg(feature = "wide")]
    sum_of_lanes: |_s| black_box(&packed::SHADED).sum_of_lanes();
    #[cfg(feature = "wide")]
    sum_4_packed_whole: |s| packed::FOUR.sum_whole(s);
    #[cfg(feature = "wide")]
    sum_4_packed_real: |s| packed::FOUR.sum_real(s);
    #[cfg(feature = "wide")]
    sum_8_packed_whole: |s| packed::EIGHT.sum_whole(s);
    #[cfg(feature = "wide")]
    sum_8_packed_real: |s| packed::EIGHT.sum_real(s);
    total: |s| shade::lambert(s.n, &REAL, Rgb::gray(s.x), []).total();
}

/// Four point lights.
fn at(s: &Place) -> impl Iterator<Item = shading::IncidentLight<f32>> {
    black_box(&POINTS).iter().map(|light| light.at(s.p))
}

fn in_front(s: &Place) -> impl Iterator<Item = shading::IncidentLight<f32>> {
    black_box(&POINTS)
        .iter()
        .filter_map(|light| light.in_front(s.p, s.n))
}

fn all_in_front(s: &Place) -> impl Iterator<Item = shading::IncidentLight<f32>> {
    PointLight::all_in_front(black_box(&POINTS), s.p, s.n)
}

fn torus<T: Real>(p: Vec3<T>) -> T {
    let ring = (p.x * p.x + p.y * p.y).sqrt() - T::of(2.0);
    ring * ring + p.z * p.z - T::of(0.25)
}

fn paraboloid<T: Real>(u: T, v: T) -> Vec3<T> {
    Vec3::new(u, v, u * u + v * v)
}

/// Random places.
pub fn places() -> Vec<Place> {
    let mut random = fastrand::Rng::with_seed(1975);
    let mut vector = || Vec3::from([(); 3].map(|()| 4.0 * random.f32() - 2.0));
    let mut place = |_| Place {
        p: vector(),
        a: vector(),
        n: vector().unit_or(UnitVec3::X),
        l: vector().unit_or(UnitVec3::Y),
        v: vector().unit_or(UnitVec3::Z),
        x: vector().x.abs() / 2.0,
    };
    (0..CALLS).map(&mut place).collect()
}
