//! The picture, four points at a time.

use shading::f32::Rgb;
use shading::{Shaded, UnitVec3, Vec3};
use wide::f32x4;

use crate::scene::{Part, Scene};
use crate::surface::Point;

/// Points in lanes.
pub struct Prepared(Vec<Four>);

struct Four {
    pixels: [usize; 4],
    p: Vec3<f32x4>,
    n: UnitVec3<f32x4>,
    v: UnitVec3<f32x4>,
}

impl Prepared {
    #[must_use]
    pub fn new(points: &[Point]) -> Self {
        Self(points.chunks(4).map(Four::new).collect())
    }

    /// Writes the pixels of the points.
    pub fn draw(&self, _points: &[Point], scene: &Scene, part: Part, pixels: &mut [u8]) {
        let scene = scene.cast(f32x4::splat);
        for four in &self.0 {
            let light = part.of(four.shaded(&scene));
            let [r, g, b] = <[f32x4; 3]>::from(light).map(f32x4::to_array);
            for lane in 0..4 {
                let [r, g, b] = Rgb::new(r[lane], g[lane], b[lane]).to_srgb8();
                pixels[4 * four.pixels[lane]..][..4].copy_from_slice(&[r, g, b, 255]);
            }
        }
    }

    /// The light from a point, by the code that draws: the same in scalars would be 2 KB more to fetch.
    #[must_use]
    pub fn shaded(point: &Point, scene: &Scene) -> Shaded {
        let Shaded {
            ambient,
            diffuse,
            specular,
        } = Four::new(&[*point]).shaded(&scene.cast(f32x4::splat));
        let [ambient, diffuse, specular] =
            [ambient, diffuse, specular].map(|light| light.map(|lanes| lanes.to_array()[0]));
        Shaded {
            ambient,
            diffuse,
            specular,
        }
    }
}

impl Four {
    #[inline(never)]
    fn shaded(&self, scene: &Scene<f32x4>) -> Shaded<f32x4> {
        scene.shaded(self.p, self.n, self.v)
    }

    /// From one to four points; the last one fills the remaining lanes.
    fn new(points: &[Point]) -> Self {
        let four: [Point; 4] = std::array::from_fn(|i| points[i.min(points.len() - 1)]);
        let lanes = |vector: fn(&Point) -> Vec3<f32>| {
            let vectors = four.each_ref().map(vector);
            let lane = |coordinate: fn(Vec3<f32>) -> f32| f32x4::new(vectors.map(coordinate));
            Vec3::new(lane(|a| a.x), lane(|a| a.y), lane(|a| a.z))
        };
        Self {
            pixels: four.map(|point| point.pixel),
            p: lanes(|point| point.p),
            n: UnitVec3::assume_unit(lanes(|point| *point.n)),
            v: UnitVec3::assume_unit(lanes(|point| *point.v)),
        }
    }
}
