//! Lights in lanes.

use std::hint::black_box;
use std::sync::LazyLock;

use shading::{Exponent, Lanes, Light, Material, PointLight, Rgb, Shaded, shade};
use wide::{f32x4, f32x8};

use super::{LIGHTS, POINT, Place, REAL, WHOLE};

/// A scene whose lights fill one pack.
pub struct Scene<L> {
    points: Vec<PointLight<L>>,
    whole: Material<L, u32>,
    real: Material<L, f32>,
}

pub static FOUR: LazyLock<Scene<f32x4>> = LazyLock::new(Scene::new);
pub static EIGHT: LazyLock<Scene<f32x8>> = LazyLock::new(Scene::new);

/// What is summed up.
pub static SHADED: Shaded<f32x8> = {
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
        Self {
            points: PointLight::packed(&vec![POINT; L::COUNT]).collect(),
            whole: WHOLE.cast(splat),
            real: REAL.cast(splat),
        }
    }

    pub fn sum_whole(&self, place: &Place) -> Shaded<f32> {
        self.sum(place, &self.whole)
    }

    pub fn sum_real(&self, place: &Place) -> Shaded<f32> {
        self.sum(place, &self.real)
    }

    #[inline]
    fn sum<M: Exponent<L>>(&self, place: &Place, material: &Material<L, M>) -> Shaded<f32> {
        let [n, v] = [place.n, place.v].map(|direction| direction.cast(splat));
        let p = place.p.map(splat);
        let lit = self.points.iter().filter_map(|pack| pack.in_front(p, n));
        shade::blinn_phong(n, v, black_box(material), Rgb::WHITE, lit).sum_of_lanes()
    }
}

/// Eight point lights into a pack.
pub fn points(place: &Place) -> Option<PointLight<f32x8>> {
    let position = place.p;
    PointLight::packed(&[PointLight { position, ..POINT }; 8]).next()
}

/// A light of each kind into three packs.
pub fn lights(_: &Place) -> [Option<Light<f32x8>>; 3] {
    let mut packs = Light::packed(black_box(&LIGHTS));
    [(); 3].map(|()| packs.next())
}
