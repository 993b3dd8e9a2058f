//! Lights in lanes.

use std::hint::black_box;
use std::sync::LazyLock;

use shading::{Exponent, Lanes, Light, Material, PointLight, Rgb, Shaded, shade};
use wide::{f32x4, f32x8};

use super::{Place, input};

/// A scene whose lights fill one pack.
struct Scene<L> {
    points: Vec<PointLight<L>>,
    integer: Material<L, u32>,
    real: Material<L, f32>,
}

static FOUR: LazyLock<Scene<f32x4>> = LazyLock::new(Scene::new);
static EIGHT: LazyLock<Scene<f32x8>> = LazyLock::new(Scene::new);

/// Not clamped, as lamps of which some are and some are not are computed one by one.
static LAMPS: LazyLock<[PointLight<f32>; 4]> = LazyLock::new(|| {
    let [near, _, far, _] = Place::new(&input(&mut fastrand::Rng::with_seed(1977))).lamps;
    [near, far, near, far]
});

/// What is summed up.
static SHADED: Shaded<f32x8> = {
    let part = Rgb::gray(f32x8::new([0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.2, 0.1]));
    Shaded {
        ambient: part,
        diffuse: part,
        specular: part,
    }
};

fn splat<L: Lanes<Lane = f32>>(x: f32) -> L {
    L::from_fn(|_| x)
}

impl<L: Lanes<Lane = f32>> Scene<L>
where
    f32: Exponent<L>,
{
    fn new() -> Self {
        let place = Place::new(&input(&mut fastrand::Rng::with_seed(1977)));
        Self {
            points: PointLight::packed(&vec![place.lamps[0]; L::COUNT]).collect(),
            integer: place.integer.cast(splat),
            real: place.real.cast(splat),
        }
    }

    #[inline]
    fn sum<M: Exponent<L>>(&self, place: &Place, material: &Material<L, M>) -> Shaded<f32> {
        let [n, v] = [place.n, place.v].map(|direction| direction.cast(splat));
        let p = place.p.map(splat);
        let lit = self.points.iter().filter_map(|pack| pack.in_front(p, n));
        shade::blinn_phong(n, v, black_box(material), Rgb::WHITE, lit).sum_of_lanes()
    }
}

fn sum_all<M: Exponent<f32x4>>(place: &Place, material: &Material<f32, M>) -> Shaded<f32> {
    let lamps = PointLight::all_at::<f32x4>(&*LAMPS, place.p);
    shade::blinn_phong(place.n, place.v, black_box(material), Rgb::WHITE, lamps)
}

pub fn sum_all_integer(place: &Place) -> Shaded<f32> {
    sum_all(place, &place.integer)
}

pub fn sum_all_real(place: &Place) -> Shaded<f32> {
    sum_all(place, &place.real)
}

pub fn sum_all_kinds(place: &Place) -> Shaded<f32> {
    let lights = Light::all_at::<f32x4>(&place.lights, place.p);
    shade::blinn_phong(
        place.n,
        place.v,
        black_box(&place.integer),
        Rgb::WHITE,
        lights,
    )
}

pub fn sum_4_integer(place: &Place) -> Shaded<f32> {
    FOUR.sum(place, &FOUR.integer)
}

pub fn sum_4_real(place: &Place) -> Shaded<f32> {
    FOUR.sum(place, &FOUR.real)
}

pub fn sum_8_integer(place: &Place) -> Shaded<f32> {
    EIGHT.sum(place, &EIGHT.integer)
}

pub fn sum_8_real(place: &Place) -> Shaded<f32> {
    EIGHT.sum(place, &EIGHT.real)
}

pub fn sum_of_lanes(_: &Place) -> Shaded<f32> {
    black_box(&SHADED).sum_of_lanes()
}

/// Eight point lights into a pack.
pub fn points(place: &Place) -> Option<PointLight<f32x8>> {
    PointLight::packed(&[place.lamps[0]; 8]).next()
}

/// A light of each kind into three packs.
pub fn lights(place: &Place) -> [Option<Light<f32x8>>; 3] {
    let mut packs = Light::packed(&place.lights[..3]);
    [(); 3].map(|()| packs.next())
}
