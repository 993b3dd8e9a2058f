//! Calls one function of the crate and nothing else. Compared with a program that calls `nothing`,
//! this program grows by the flash that the function takes, with everything that it pulls in. The
//! variable `MEASURED` names the function at build time.
#![no_std]
#![no_main]

use core::hint::black_box;
use core::sync::atomic::AtomicU32;

use firmware::{board, broken};
use shading::fixed::Fixed;
use shading::{
    Attenuation, Cone, DirectionalLight, Dual, Elementary, Exponent, Light, Material, PointLight,
    Ranged, Real, Rgb, SoftCone, SpotLight, UnitVec3, Vec3, attenuation, half_vector, normal,
    reflection, shade, term,
};

type N = UnitVec3<f32>;

/// Keeps only the named call, and rejects a name that is not in the list at compile time.
macro_rules! measure {
    ($($name:literal => $call:expr,)*) => {
        const { assert!($(is_measured($name) ||)* false) }
        $(if const { is_measured($name) } {
            $call;
        })*
    };
}

const fn is_measured(name: &str) -> bool {
    let (mut name, mut measured) = (name.as_bytes(), env!("MEASURED").as_bytes());
    while let ([a, after_a @ ..], [b, after_b @ ..]) = (name, measured) {
        if *a != *b {
            return false;
        }
        (name, measured) = (after_a, after_b);
    }
    name.is_empty() && measured.is_empty()
}

/// Arguments in RAM about which the compiler knows nothing.
struct Given<T> {
    n: UnitVec3<T>,
    l: UnitVec3<T>,
    v: UnitVec3<T>,
    p: Vec3<T>,
    a: Vec3<T>,
    b: Vec3<T>,
    i_a: Rgb<T>,
    whole: Material<T, u32>,
    real: Material<T, T>,
    attenuation: Attenuation<T>,
    cone: Cone<T>,
    sun: DirectionalLight<T>,
    lamps: [PointLight<T>; 4],
    spot: SpotLight<T>,
    soft_spot: SpotLight<T, SoftCone<T>, Ranged<T>>,
    light: Light<T>,
    bytes: [u8; 3],
}

#[board::entry]
fn main() -> ! {
    const SIZE: usize = size_of::<Given<f32>>();
    const { assert!(size_of::<Given<Fixed>>() == SIZE) };
    static MEMORY: [AtomicU32; SIZE / 4] = [const { AtomicU32::new(0) }; SIZE / 4];
    loop {
        let memory = black_box(MEMORY.as_ptr());
        // SAFETY: zeros are a valid value of every type in them, and nothing writes to them.
        unsafe { measured(&*memory.cast(), &*memory.cast()) };
    }
}

#[allow(clippy::too_many_lines)] // one line per function
#[inline(never)]
fn measured(given: &Given<f32>, fixed: &Given<Fixed>) {
    let &Given {
        n,
        l,
        v,
        p,
        a,
        b,
        i_a,
        ..
    } = given;
    let (whole, real) = (&given.whole, &given.real);
    let lights = || given.lamps.iter().map(|lamp| lamp.at(p));
    measure! {
        "nothing" => keep(()),
        "Vec3::unit" => keep(p.unit()),
        "Vec3::unit_or" => keep(p.unit_or(n)),
        "UnitVec3::new" => keep(N::new(p.x, p.y, p.z)),
        "Rgb::clamped" => keep(i_a.clamped()),
        "Rgb::to_srgb8" => keep(i_a.to_srgb8()),
        "Rgb::from_srgb8" => keep(Rgb::from_srgb8(given.bytes)),
        "Rgb::to_rgb565" => keep(i_a.to_rgb565()),
        "ambient" => keep(term::ambient(i_a, i_a)),
        "lambert" => keep(term::lambert(n, l)),
        "phong, integer m" => keep(term::phong(n, v, whole.m)),
        "phong, real m" => keep(term::phong(n, v, real.m)),
        "blinn, integer m" => keep(term::blinn(n, v, whole.m)),
        "blinn, real m" => keep(term::blinn(n, v, real.m)),
        "phong_normalization" => keep(term::phong_normalization(real.m)),
        "blinn_normalization" => keep(term::blinn_normalization(real.m)),
        "reflection" => keep(reflection(n, l)),
        "half_vector" => keep(half_vector(l, v)),
        "attenuation" => keep(attenuation(a.x, a.y, a.z, p.x)),
        "Attenuation::new" => keep(Attenuation::<f32>::new(a.x, a.y, a.z)),
        "Attenuation::at" => keep(given.attenuation.at(p.x)),
        "Cone::from_half_angle" => keep(Cone::<f32>::from_half_angle(a.x)),
        "Cone::factor" => keep(given.cone.factor(n, l)),
        "SoftCone::from_half_angles" => keep(SoftCone::<f32>::from_half_angles(a.x, a.y)),
        "SoftCone::factor" => keep(given.soft_spot.cone.factor(n, l)),
        "Ranged::at" => keep(given.soft_spot.point.attenuation.at(p.x)),
        "normal::plane" => keep(normal::plane(a.x, a.y, a.z)),
        "normal::triangle" => keep(normal::triangle(p, a, b)),
        "normal::sphere" => keep(normal::sphere(a, p)),
        "normal::implicit, of a torus" => keep(normal::implicit(torus, p)),
        "normal::from_gradient" => keep(normal::from_gradient(a)),
        "normal::parametric, of a saddle" => keep(normal::parametric(saddle, a.x, a.y)),
        "normal::from_tangents" => keep(normal::from_tangents(a, b)),
        "normal::facing" => keep(normal::facing(n, v)),
        "normal::transformed" => keep(normal::transformed(n, [p, a, b])),
        "normal::corner" => keep(normal::corner(p, a, b)),
        "normal::mapped" => keep(normal::mapped(n, p, a.x, b)),
        "DirectionalLight::at" => keep(given.sun.at(p)),
        "PointLight::at" => keep(given.lamps[0].at(p)),
        "SpotLight::at" => keep(given.spot.at(p)),
        "SpotLight::at, soft and ranged" => keep(given.soft_spot.at(p)),
        "Light::at" => keep(given.light.at(p)),
        "shade::lambert" => keep(shade::lambert(n, whole, i_a, lights())),
        "shade::phong, integer m" => keep(shade::phong(n, v, whole, i_a, lights())),
        "shade::phong, real m" => keep(shade::phong(n, v, real, i_a, lights())),
        "shade::blinn_phong, integer m" => keep(shade::blinn_phong(n, v, whole, i_a, lights())),
        "shade::blinn_phong, fixed point" => {
            let &Given { n, v, p, i_a, .. } = fixed;
            let lights = fixed.lamps.iter().map(|lamp| lamp.at(p));
            keep(shade::blinn_phong(n, v, &fixed.whole, i_a, lights));
        },
        "shade::blinn_phong, real m" => keep(shade::blinn_phong(n, v, real, i_a, lights())),
        "Exponent::raise, integer m" => keep(whole.m.raise(a.x)),
        "Exponent::raise, real m" => keep(real.m.raise(a.x)),
        "Real::sqrt" => keep(Real::sqrt(a.x)),
        "Elementary::exp" => keep(Elementary::exp(a.x)),
        "Elementary::ln" => keep(Elementary::ln(a.x)),
        "Elementary::sin" => keep(Elementary::sin(a.x)),
    }
}

fn torus(p: Vec3<Dual<f32>>) -> Dual<f32> {
    let ring = (p.x * p.x + p.y * p.y).sqrt() - 2.0;
    ring * ring + p.z * p.z - 0.25
}

fn saddle(u: Dual<f32>, v: Dual<f32>) -> Vec3<Dual<f32>> {
    Vec3::new(u, v, u * u - v * v)
}

/// Keeps a result that would otherwise be optimized away.
#[inline(always)]
fn keep<T>(result: T) {
    black_box(&result);
    if size_of::<T>() > 0 {
        broken::promise(0.0);
    }
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    loop {}
}
