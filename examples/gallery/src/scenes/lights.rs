//! The three kinds of light over the same floor, an area light, and three lights that add up to
//! white.

use std::f32::consts::{PI, TAU};

use shading::{
    Attenuation, Cone, DirectionalLight, Elementary, Light, PointLight, Rgb, SpotLight, UnitVec3,
    Vec3,
};

use super::{Picture, STUDIO, empty, floor, glossy, matte, tiles, toward};
use crate::render::film::spread;
use crate::render::implicit::{Field, Implicit};
use crate::render::ray::Camera;
use crate::render::scene::{Backdrop, Object, Scene};
use crate::render::shape::Sphere;

pub fn pictures() -> Vec<Picture> {
    vec![
        Picture::new(
            "10_directional_light",
            &["directional light"],
            pins(directional(), None),
        ),
        Picture::new(
            "11_point_light",
            &["point light"],
            pins(point(), Some(POINT.position)),
        ),
        Picture::new(
            "12_spot_light",
            &["spot light"],
            pins(Light::Spot(SPOT), Some(SPOT.point.position)),
        ),
        Picture::new(
            "13_area_light",
            &["area light: many point lights"],
            balls_under_a_square(),
        ),
        Picture::new(
            "14_three_colors_make_white",
            &["red + green + blue = white"],
            three_colors(),
        )
        .for_readme(),
    ]
}

const WARM: Rgb<f32> = Rgb::new(1.0, 0.93, 0.8);

fn directional() -> Light<f32> {
    Light::Directional(DirectionalLight {
        l: toward(-0.75, 0.8, 0.35),
        intensity: WARM,
    })
}

const POINT: PointLight<f32> = PointLight {
    position: Vec3::new(0.0, 1.7, 0.0),
    intensity: Rgb::new(1.5, 1.4, 1.2),
    attenuation: Attenuation::<f32>::new(1.0, 0.0, 0.16).unwrap(),
};

fn point() -> Light<f32> {
    Light::Point(POINT)
}

const SPOT: SpotLight<f32> = SpotLight {
    point: PointLight {
        position: Vec3::new(-1.8, 2.4, 0.0),
        intensity: WARM,
        attenuation: Attenuation::NONE,
    },
    axis: UnitVec3::<f32>::new(0.6, -0.8, 0.0).unwrap(),
    cone: Cone::<f32>::from_half_angle(PI / 7.0).unwrap(),
};

/// Pins in rows on tiles, under one light.
fn pins(light: Light<f32>, lamp: Option<Vec3<f32>>) -> Scene {
    let camera = Camera::perspective([2.9, 5.0, 7.6], [0.0, 0.42, 0.1], 30.0);
    let gray = |value| glossy(Rgb::new(value, 0.98 * value, 0.95 * value), 0.0, 1);
    let mut objects = vec![tiles(gray(0.42), gray(0.3)).fading(2.4, 6.5)];
    for (x, z) in [-1.5, 0.0, 1.5]
        .into_iter()
        .flat_map(|x| [(x, -1.5), (x, 0.0), (x, 1.5)])
    {
        let red = Rgb::new(0.6, 0.2, 0.06);
        // a low pin in the middle, under the lamp
        let height = if x == 0.0 && z == 0.0 { 0.2 } else { 0.75 };
        objects.push(Object::new(Pin::at(x, z, height), glossy(red, 0.35, 40)));
    }
    objects.extend(lamp.map(|position| {
        let shape = Sphere {
            center: position,
            radius: 0.07,
        };
        Object::glowing(shape, Rgb::new(1.0, 0.95, 0.85))
    }));
    Scene {
        objects,
        lights: vec![light],
        ambient: Rgb::gray(0.09),
        ..empty(camera, STUDIO)
    }
}

/// The points at the same distance from a line that goes up.
struct Pin {
    x: f32,
    z: f32,
    height: f32,
}

impl Pin {
    const RADIUS: f32 = 0.2;

    fn at(x: f32, z: f32, height: f32) -> Implicit<Self> {
        let radius = 0.5 * height + Self::RADIUS + 0.01;
        Implicit::new(Self { x, z, height }, [x, 0.5 * height, z], radius)
    }
}

impl Field for Pin {
    fn value<T: Elementary>(&self, p: Vec3<T>) -> T {
        let [x, z, height, radius] =
            [self.x, self.z, self.height, Self::RADIUS].map(|number| T::of(number.into()));
        let y = p.y - p.y.at_least(T::ZERO).at_most(height);
        let from_line = Vec3::new(p.x - x, y, p.z - z);
        from_line.dot(from_line).sqrt() - radius
    }
}

/// A square of light: many weak lamps spread over it.
fn balls_under_a_square() -> Scene {
    const LAMPS: u32 = 64;
    const SIDE: f32 = 1.8;
    let camera = Camera::perspective([0.0, 2.6, 7.2], [0.0, 0.62, 0.0], 27.0);
    let lamp = |(x, z)| {
        Light::Point(PointLight {
            position: Vec3::new(SIDE * (x - 0.5) - 1.6, 3.4, SIDE * (z - 0.5) + 0.8),
            intensity: WARM * (1.1 / LAMPS as f32),
            attenuation: Attenuation::NONE,
        })
    };
    let ball = |x, y, z, radius, color| {
        Object::new(Sphere::new([x, y, z], radius), glossy(color, 0.35, 60))
    };
    Scene {
        objects: vec![
            floor(matte(Rgb::gray(0.34))).fading(1.5, 5.2),
            ball(-1.3, 0.55, 0.2, 0.55, Rgb::new(0.1, 0.36, 0.3)),
            ball(0.1, 0.95, -0.3, 0.55, Rgb::new(0.62, 0.4, 0.08)),
            ball(1.5, 0.4, 0.5, 0.4, Rgb::new(0.58, 0.14, 0.08)),
        ],
        lights: spread(LAMPS).map(lamp).collect(),
        ..empty(camera, STUDIO)
    }
}

/// Red, green, and blue spots on white. In the shadow of one, the other two mix.
fn three_colors() -> Scene {
    let camera = Camera::perspective([0.0, 7.4, 6.2], [0.0, 0.1, 0.15], 22.5);
    let spots = [
        Rgb::new(1.0, 0.0, 0.0),
        Rgb::new(0.0, 1.0, 0.0),
        Rgb::new(0.0, 0.0, 1.0),
    ];
    let spot = |(i, intensity)| {
        let angle = TAU * (i as f32 / 3.0 + 0.25);
        let (cos, sin) = (Elementary::cos(angle), Elementary::sin(angle));
        let position = Vec3::new(4.2 * cos, 7.5, -4.2 * sin);
        let target = Vec3::new(0.55 * cos, 0.0, -0.55 * sin);
        Light::Spot(SpotLight {
            axis: (target - position).unit_or(-UnitVec3::Y),
            point: PointLight {
                position,
                intensity,
                attenuation: Attenuation::NONE,
            },
            cone: Cone::<f32>::from_half_angle(PI / 18.0).expect("it is below π"),
        })
    };
    let white = matte(Rgb::gray(0.92));
    Scene {
        objects: vec![
            floor(white).fading(2.5, 6.0),
            Object::new(
                Sphere::new([0.0, 0.42, 0.0], 0.42),
                glossy(Rgb::gray(0.75), 0.2, 60),
            ),
        ],
        lights: spots.into_iter().enumerate().map(spot).collect(),
        ambient: Rgb::gray(0.01),
        ..empty(camera, Backdrop::BLACK)
    }
}
