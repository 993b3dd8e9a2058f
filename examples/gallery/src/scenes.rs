//! What the pictures show.

use std::f32::consts::{PI, TAU};

use shading::f32::{
    Attenuation, Cone, DirectionalLight, Light, Material, PointLight, Rgb, Shaded, SpotLight,
    UnitVec3, Vec3,
};
use shading::{Dual, Elementary, Real, normal};

use crate::mesh::{Mesh, bunny, teapot};
use crate::render::{
    Camera, Field, Implicit, Look, Meeting, Model, Object, Plane, Ray, Scene, Sphere, Surface,
};

pub struct Picture {
    pub name: &'static str,
    pub caption: &'static str,
    pub rows: Vec<Vec<Scene>>,
    /// Width and height.
    pub size: [usize; 2],
}

/// The gallery, in the order of the README's table.
pub fn all() -> Vec<Picture> {
    let picture = |name, caption, rows| Picture {
        name,
        caption,
        rows,
        size: [800, 600],
    };
    let strip = |name, caption, row| Picture {
        name,
        caption,
        rows: vec![row],
        size: [1600, 400],
    };
    vec![
        strip(
            "the_sum",
            "Ambient, diffuse and specular, and their sum.",
            the_sum(),
        ),
        picture(
            "ks_and_m",
            "k_s grows downward, and m grows to the right: 4, 20 and 120.",
            ks_and_m(),
        ),
        picture(
            "m",
            "Phong with m = 1, 5 and 10; below, the highlights alone.",
            highlights(&[(Model::Phong, 1), (Model::Phong, 5), (Model::Phong, 10)]),
        ),
        picture(
            "phong_and_blinn",
            "Phong with m = 20; Blinn–Phong with m = 20 and with m = 80.",
            highlights(&[
                (Model::Phong, 20),
                (Model::BlinnPhong, 20),
                (Model::BlinnPhong, 80),
            ]),
        ),
        picture(
            "sunset",
            "Phong's highlight stays round; Blinn's stretches toward the eye.",
            vec![vec![
                sunset(Model::Phong, 300),
                sunset(Model::BlinnPhong, 1200),
            ]],
        ),
        strip(
            "lights",
            "A directional light, a point light, a spot, and a square of 64 point lights.",
            lights(),
        ),
        picture(
            "three_colors",
            "Red, green and blue spots add up to white.",
            vec![vec![three_colors()]],
        ),
        picture(
            "attenuation",
            "From the top: 1, 1/(0.5 q), 1/(0.25 q²), and the last within a range of 5.",
            attenuation(),
        ),
        picture(
            "soft_spot",
            "A hard edge; squared, as in glTF; a smoothstep, as in three.js.",
            vec![vec![soft_spots()]],
        ),
        picture(
            "teapot",
            "The Utah teapot, shaded from its Bézier patches.",
            vec![vec![shown(
                teapot(),
                glossy(Rgb::new(0.5, 0.17, 0.07), 0.5, 60),
                [-1.6, 3.0, 7.4],
            )]],
        ),
        picture(
            "gyroid",
            "One function gives the points and, with dual numbers, the normals.",
            vec![vec![gyroid()]],
        ),
        strip(
            "bunny",
            "A normal for each triangle, and for each vertex by normal::corner.",
            [false, true]
                .map(|smooth| {
                    shown(
                        bunny(smooth),
                        glossy(Rgb::new(0.45, 0.36, 0.28), 0.2, 15),
                        [0.0, 2.6, 7.4],
                    )
                })
                .into(),
        ),
        picture(
            "normal_map",
            "A flat wall and round balls, with normal maps.",
            vec![vec![bricks()]],
        ),
    ]
}

const STUDIO: [Rgb; 2] = [Rgb::new(0.055, 0.06, 0.07), Rgb::new(0.008, 0.009, 0.011)];
const BLACK: [Rgb; 2] = [Rgb::BLACK; 2];
const WARM: Rgb = Rgb::new(1.0, 0.93, 0.8);

/// A scene without objects and lights, seen from `eye` under an angle in degrees.
fn empty(eye: [f32; 3], at: [f32; 3], degrees: f32, backdrop: [Rgb; 2]) -> Scene {
    Scene {
        eye: eye.into(),
        at: at.into(),
        camera: Camera::Perspective(degrees),
        objects: Vec::new(),
        lights: Vec::new(),
        ambient: Rgb::gray(0.12),
        model: Model::BlinnPhong,
        part: Shaded::total,
        backdrop,
    }
}

const fn glossy(color: Rgb, k_s: f32, m: u32) -> Material {
    Material {
        k_a: color,
        k_d: color,
        k_s: Rgb::gray(k_s),
        m,
    }
}

const fn matte(color: Rgb) -> Material {
    glossy(color, 0.0, 1)
}

fn painted(
    surface: impl Surface + 'static,
    paint: impl Fn(Vec3) -> Material + Sync + 'static,
) -> Object {
    Object {
        surface: Box::new(surface),
        look: Look::Painted(Box::new(paint)),
        fade: [f32::MAX; 2],
    }
}

fn object(surface: impl Surface + 'static, material: Material) -> Object {
    painted(surface, move |_| material)
}

fn ball(center: [f32; 3], radius: f32, material: Material) -> Object {
    object(Sphere(center.into(), radius), material)
}

/// Shows where a lamp is.
fn bulb(position: Vec3, color: Rgb) -> Object {
    Object {
        look: Look::Glowing(color),
        ..object(Sphere(position, 0.07), matte(color))
    }
}

const FLOOR: Plane = Plane([0.0, 1.0, 0.0, 0.0]);

fn floor(material: Material, fade: [f32; 2]) -> Object {
    Object {
        fade,
        ..object(FLOOR, material)
    }
}

/// The floor in squares of one unit.
fn tiles(light: f32, dark: f32) -> Object {
    let gray = |value| matte(Rgb::new(value, 0.98 * value, 0.95 * value));
    painted(FLOOR, move |p| {
        gray(if (p.x.floor() + p.z.floor()).rem_euclid(2.0) > 0.5 {
            dark
        } else {
            light
        })
    })
}

fn sun(x: f32, y: f32, z: f32, intensity: Rgb) -> Light {
    DirectionalLight {
        l: Vec3::new(x, y, z).unit_or(UnitVec3::Y),
        intensity,
    }
    .into()
}

fn lamp(position: Vec3, intensity: Rgb, [a, b, c]: [f32; 3]) -> PointLight {
    PointLight {
        position,
        intensity,
        attenuation: Attenuation::new(a, b, c).expect("coefficients"),
    }
}

/// A key light, and a weak one from behind.
fn keyed() -> Vec<Light> {
    vec![
        sun(-0.7, 0.9, 0.7, Rgb::new(0.95, 0.92, 0.86)),
        sun(0.8, 1.0, -1.0, Rgb::new(0.14, 0.18, 0.25)),
    ]
}

/// A model on a floor.
fn shown(mesh: Mesh, material: Material, eye: [f32; 3]) -> Scene {
    Scene {
        objects: vec![
            floor(matte(Rgb::gray(0.16)), [1.0, 4.6]),
            object(mesh, material),
        ],
        lights: keyed(),
        ..empty(eye, [0.0, 0.8, 0.0], 21.0, STUDIO)
    }
}

/// Each term alone, and their sum. The background is black, so that the first three add up to the fourth.
fn the_sum() -> Vec<Scene> {
    let parts: [fn(Shaded) -> Rgb; 4] =
        [|s| s.ambient, |s| s.diffuse, |s| s.specular, Shaded::total];
    let scene = |part| Scene {
        objects: vec![
            floor(glossy(Rgb::gray(0.24), 0.25, 12), [1.6, 5.2]),
            ball(
                [-1.35, 0.8, 0.25],
                0.8,
                glossy(Rgb::new(0.66, 0.07, 0.05), 0.8, 30),
            ),
            object(
                Implicit(Ring, Sphere(Vec3::new(0.35, 0.95, -1.0), 1.0)),
                glossy(Rgb::new(0.72, 0.42, 0.06), 0.8, 25),
            ),
            object(
                Implicit(Cube, Sphere(Vec3::new(1.5, 0.6, 0.3), 1.1)),
                glossy(Rgb::new(0.06, 0.2, 0.55), 0.8, 20),
            ),
        ],
        lights: vec![lamp(Vec3::new(-3.2, 5.2, 4.2), Rgb::gray(0.95), [1.0, 0.0, 0.0]).into()],
        ambient: Rgb::gray(0.2),
        part,
        ..empty([0.0, 2.7, 7.2], [0.16, 0.7, 0.0], 41.0, BLACK)
    };
    parts.map(scene).into()
}

fn away<T: Elementary>(p: shading::Vec3<T>, center: [f64; 3]) -> shading::Vec3<T> {
    p - shading::Vec3::from(center).map(T::of)
}

/// An upright ring.
struct Ring;

impl Field for Ring {
    fn value<T: Elementary>(&self, p: shading::Vec3<T>) -> T {
        let q = away(p, [0.35, 0.95, -1.0]);
        let from_circle = (q.x * q.x + q.y * q.y).sqrt() - T::of(0.7);
        (from_circle * from_circle + q.z * q.z).sqrt() - T::of(0.25)
    }
}

/// A cube with rounded edges, turned by 30°.
struct Cube;

impl Field for Cube {
    fn value<T: Elementary>(&self, p: shading::Vec3<T>) -> T {
        let q = away(p, [1.5, 0.6, 0.3]);
        let (cos, sin) = (T::of(0.866_025_4), T::of(0.5));
        let turned = shading::Vec3::new(q.x * cos - q.z * sin, q.y, q.x * sin + q.z * cos);
        let outside = turned.map(|c| (c.abs() - T::of(0.38)).at_least(T::ZERO));
        outside.dot(outside).sqrt() - T::of(0.22)
    }
}

/// A ball in front of the eye, with the light over the left shoulder.
fn lone_ball(model: Model, material: Material, part: fn(Shaded) -> Rgb) -> Scene {
    Scene {
        camera: Camera::Parallel(2.8),
        objects: vec![ball([0.0; 3], 1.0, material)],
        lights: vec![sun(-0.5, 0.55, 0.67, Rgb::WHITE)],
        model,
        part,
        ..empty([0.0, 0.0, 5.0], [0.0; 3], 0.0, STUDIO)
    }
}

fn ks_and_m() -> Vec<Vec<Scene>> {
    let cell = |k_s, m| {
        lone_ball(
            Model::Phong,
            glossy(Rgb::new(0.04, 0.26, 0.16), k_s, m),
            Shaded::total,
        )
    };
    [0.2, 0.6]
        .map(|k_s| [4, 20, 120].map(|m| cell(k_s, m)).into())
        .into()
}

/// Balls, and their highlights alone below.
fn highlights(balls: &[(Model, u32)]) -> Vec<Vec<Scene>> {
    let parts: [fn(Shaded) -> Rgb; 2] = [Shaded::total, |shaded| shaded.specular];
    let purple = Rgb::new(0.22, 0.06, 0.3);
    let row = |part| {
        balls
            .iter()
            .map(|&(model, m)| lone_ball(model, glossy(purple, 0.6, m), part))
            .collect()
    };
    parts.map(row).into()
}

/// The sun low over water.
fn sunset(model: Model, m: u32) -> Scene {
    let (sun, orange) = (Vec3::new(0.0, 1.5, -9.0), Rgb::new(1.0, 0.62, 0.3));
    let sky = [Rgb::new(0.1, 0.07, 0.075), Rgb::new(0.012, 0.014, 0.03)];
    let disc = Object {
        surface: Box::new(Sphere(sun, 0.4)),
        ..bulb(sun, orange)
    };
    Scene {
        objects: vec![
            floor(glossy(Rgb::new(0.03, 0.06, 0.1), 0.8, m), [7.0, 22.0]),
            disc,
        ],
        lights: vec![lamp(sun, orange, [1.0, 0.0, 0.0]).into()],
        model,
        ..empty([0.0, 1.2, 7.0], [0.0, 0.62, 0.0], 26.0, sky)
    }
}

/// The points at the same distance from a line that goes up.
struct Pin(f64, f64, f64);

impl Field for Pin {
    fn value<T: Elementary>(&self, p: shading::Vec3<T>) -> T {
        let q = away(p, [self.0, 0.0, self.1]);
        let y = q.y - q.y.at_least(T::ZERO).at_most(T::of(self.2));
        shading::Vec3::new(q.x, y, q.z).length() - T::of(0.2)
    }
}

/// Pins in rows, under each kind of light.
fn lights() -> Vec<Scene> {
    let point = lamp(
        Vec3::new(0.0, 1.7, 0.0),
        Rgb::new(1.5, 1.4, 1.2),
        [1.0, 0.0, 0.16],
    );
    let spot = SpotLight {
        point: lamp(Vec3::new(-1.8, 2.4, 0.0), WARM, [1.0, 0.0, 0.0]),
        axis: const { UnitVec3::const_new(0.6, -0.8, 0.0).unwrap() },
        cone: const { Cone::const_from_half_angle(PI / 7.0).unwrap() },
    };
    let square = (0..64_u8).map(|i| {
        let (x, z) = (f32::from(i % 8) / 4.0 - 2.5, f32::from(i / 8) / 4.0 - 0.1);
        lamp(Vec3::new(x, 3.4, z), WARM * (1.1 / 64.0), [1.0, 0.0, 0.0]).into()
    });
    let kinds: [(Vec<Light>, Option<Vec3>); 4] = [
        (vec![sun(-0.75, 0.8, 0.35, WARM)], None),
        (vec![point.into()], Some(point.position)),
        (vec![spot.into()], Some(spot.point.position)),
        (square.collect(), None),
    ];
    kinds.map(|(lights, bulb_at)| pins(lights, bulb_at)).into()
}

fn pins(lights: Vec<Light>, bulb_at: Option<Vec3>) -> Scene {
    let mut objects = vec![Object {
        fade: [2.4, 6.5],
        ..tiles(0.42, 0.3)
    }];
    for (i, j) in (0..9_u8).map(|k| (k / 3, k % 3)) {
        let [x, z] = [i, j].map(|k| 1.5 * f64::from(k) - 1.5);
        let height = if (i, j) == (1, 1) { 0.2 } else { 0.75 }; // a low pin under the lamp
        let bound = Sphere(
            shading::Vec3::new(x, 0.5 * height, z).map(|c: f64| c as f32),
            0.5 * height as f32 + 0.21,
        );
        objects.push(object(
            Implicit(Pin(x, z, height), bound),
            glossy(Rgb::new(0.6, 0.2, 0.06), 0.35, 40),
        ));
    }
    objects.extend(bulb_at.map(|position| bulb(position, Rgb::new(1.0, 0.95, 0.85))));
    Scene {
        objects,
        lights,
        ambient: Rgb::gray(0.09),
        ..empty([2.9, 5.0, 7.6], [0.0, 0.42, 0.1], 34.0, STUDIO)
    }
}

/// Spots on white. In the shadow of one, the other two mix.
fn three_colors() -> Scene {
    let spot = |(i, intensity)| {
        let (sin, cos) = (TAU * (i as f32 / 3.0 + 0.25)).sin_cos();
        let position = Vec3::new(4.2 * cos, 7.5, -4.2 * sin);
        let axis = (Vec3::new(0.55 * cos, 0.0, -0.55 * sin) - position).unit_or(UnitVec3::NEG_Y);
        let cone = const { Cone::const_from_half_angle(PI / 18.0).unwrap() };
        SpotLight {
            point: lamp(position, intensity, [1.0, 0.0, 0.0]),
            axis,
            cone,
        }
        .into()
    };
    let colors = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Rgb::from);
    Scene {
        objects: vec![
            floor(matte(Rgb::gray(0.92)), [2.5, 6.0]),
            ball([0.0, 0.42, 0.0], 0.42, glossy(Rgb::gray(0.75), 0.2, 60)),
        ],
        lights: colors.into_iter().enumerate().map(spot).collect(),
        ambient: Rgb::gray(0.01),
        ..empty([0.0, 7.4, 6.2], [0.0, 0.1, 0.15], 22.5, BLACK)
    }
}

/// Balls that lead away from a lamp, one for each unit. All three attenuations are the same at a distance of 2.
fn attenuation() -> Vec<Vec<Scene>> {
    let strip = |(coefficients, range)| {
        let position = Vec3::new(-0.1, 1.3, 1.2);
        let wall = object(Plane([0.0, 0.0, 1.0, 1.4]), matte(Rgb::gray(0.35)));
        let mut objects = vec![tiles(0.42, 0.34), wall, bulb(position, WARM)];
        let paint = glossy(Rgb::new(0.1, 0.3, 0.6), 0.3, 40);
        objects.extend((0..8_u8).map(|i| ball([f32::from(i) + 0.5, 0.27, 0.0], 0.27, paint)));
        let mut lamp = lamp(position, Rgb::new(0.85, 0.79, 0.68), coefficients);
        lamp.attenuation = lamp.attenuation.within(range).expect("above 0");
        vec![Scene {
            objects,
            lights: vec![lamp.into()],
            ambient: Rgb::gray(0.03),
            ..empty([3.7, 2.4, 12.0], [3.7, 0.72, 0.0], 10.6, BLACK)
        }]
    };
    let forever = f32::INFINITY;
    [
        ([1.0, 0.0, 0.0], forever),
        ([0.0, 0.5, 0.0], forever),
        ([0.0, 0.0, 0.25], forever),
        ([0.0, 0.0, 0.25], 5.0),
    ]
    .map(strip)
    .into()
}

/// Lamps in front of a wall, all with the same outer half-angle.
fn soft_spots() -> Scene {
    let soft = const { Cone::const_from_half_angles(PI / 30.0, PI / 9.0).unwrap() };
    let hard = const { Cone::const_from_half_angles(PI / 9.0, PI / 9.0).unwrap() };
    let plaster = matte(Rgb::new(0.62, 0.59, 0.55));
    let mut scene = Scene {
        objects: vec![
            tiles(0.5, 0.4),
            object(Plane([0.0, 0.0, 1.0, 0.5]), plaster),
        ],
        ambient: Rgb::gray(0.035),
        ..empty([0.0, 1.5, 9.6], [0.0, 1.13, 0.0], 20.5, BLACK)
    };
    for (x, cone) in [(-1.55, hard), (0.0, soft), (1.55, soft.smoothstep())] {
        let point = lamp(
            Vec3::new(x, 2.55, 0.05),
            Rgb::new(4.4, 3.9, 3.1),
            [1.0, 0.0, 0.4],
        );
        scene.objects.push(bulb(point.position, WARM));
        scene.objects.push(ball(
            [x, 0.32, 0.1],
            0.32,
            glossy(Rgb::new(0.55, 0.12, 0.07), 0.4, 60),
        ));
        let axis = const { UnitVec3::const_new(0.0, -1.0, -0.1).unwrap() };
        scene.lights.push(SpotLight { point, axis, cone }.into());
    }
    scene
}

/// sin x cos y + sin y cos z + sin z cos x = 0, as a wall between two surfaces, cut to a ball.
struct Gyroid;

impl Field for Gyroid {
    fn value<T: Elementary>(&self, p: shading::Vec3<T>) -> T {
        let q = p * T::of(6.0);
        let gyroid = q.x.sin() * q.y.cos() + q.y.sin() * q.z.cos() + q.z.sin() * q.x.cos();
        // the slope of the gyroid is at most √3: each of its derivatives has the form ab − cd,
        // whose square is at most (a² + d²)(b² + c²), and the three add up to 3
        let wall = (gyroid.abs() - T::of(0.3)) * T::of(1.0 / (6.0 * 1.732_050_9));
        wall.at_least(p.length() - T::of(1.3))
    }
}

fn gyroid() -> Scene {
    Scene {
        objects: vec![object(
            Implicit(Gyroid, Sphere(Vec3::ZERO, 1.31)),
            glossy(Rgb::new(0.6, 0.3, 0.08), 0.35, 40),
        )],
        lights: keyed(),
        ambient: Rgb::gray(0.17),
        ..empty([-0.7, 2.3, 6.4], [0.0; 3], 28.5, STUDIO)
    }
}

/// A surface whose normals come from a height along x and y.
struct Mapped<S>(S, fn(Vec3) -> Vec3, fn(Dual32, Dual32) -> Dual32);

type Dual32 = Dual<f32>;

impl<S: Surface> Surface for Mapped<S> {
    fn meet(&self, ray: &Ray, limit: f32) -> Option<Meeting> {
        self.0.meet(ray, limit)
    }
    fn place(&self, ray: &Ray, meeting: &Meeting) -> (Vec3, Option<UnitVec3>) {
        let (p, n) = self.0.place(ray, meeting);
        let shading::Vec3 { x, y, .. } = Dual32::point((self.1)(p));
        let slope = (self.2)(x, y).gradient;
        let sample = Vec3::new(-slope.x, -slope.y, 1.0);
        (
            p,
            n.and_then(|n| normal::mapped(n, *UnitVec3::X, 1.0, sample)),
        )
    }
}

/// Half the size of a brick; the rest of 0.62 × 0.26 is mortar.
const HALF: [f32; 2] = [0.295, 0.115];

/// A point of the wall relative to the middle of its brick. Every other row is shifted by half a brick.
fn in_brick(p: Vec3) -> Vec3 {
    let row = (p.y / 0.26).floor();
    let off = 0.5 * row.rem_euclid(2.0);
    let column = (p.x / 0.62 + off).floor() - off;
    p - Vec3::new(0.62 * (column + 0.5), 0.26 * (row + 0.5), p.z)
}

fn bricks() -> Scene {
    let brick = |x: Dual32, y: Dual32| {
        let from_edge =
            (Dual::constant(HALF[0]) - x.abs()).at_most(Dual::constant(HALF[1]) - y.abs());
        let bevel = (from_edge * Dual::constant(16.0))
            .at_least(Dual::constant(0.0))
            .at_most(Dual::constant(1.0));
        let rough = (x * Dual::constant(43.0)).sin() * (y * Dual::constant(37.0)).sin();
        bevel * bevel * Dual::constant(0.03) + rough * Dual::constant(0.002)
    };
    let paint = |p: Vec3| {
        let q = in_brick(p);
        let is_mortar = q.x.abs() > HALF[0] || q.y.abs() > HALF[1];
        matte(if is_mortar {
            Rgb::gray(0.32)
        } else {
            Rgb::new(0.44, 0.16, 0.09)
        })
    };
    let gold = glossy(Rgb::new(0.5, 0.31, 0.05), 0.5, 45);
    // three waves at 60° to each other
    let dimples = |x: Dual32, y: Dual32| {
        let [a, b] = [x * Dual::constant(19.0), y * Dual::constant(33.0)];
        ((a + a).cos() + (a + b).cos() + (a - b).cos()) * Dual::constant(0.007)
    };
    let ribs = |x: Dual32, y: Dual32| ((x + y) * Dual::constant(27.0)).sin() * Dual::constant(0.02);
    let place = |x| Sphere(Vec3::new(x, 0.63, 0.2), 0.63);
    Scene {
        objects: vec![
            painted(Mapped(Plane([0.0, 0.0, 1.0, 1.1]), in_brick, brick), paint),
            object(FLOOR, matte(Rgb::gray(0.22))),
            object(place(-1.5), gold),
            object(Mapped(place(0.0), |p| p, dimples), gold),
            object(Mapped(place(1.5), |p| p, ribs), gold),
        ],
        lights: vec![
            lamp(
                Vec3::new(-3.4, 3.4, 4.0),
                Rgb::new(1.75, 1.65, 1.45),
                [1.0, 0.0, 0.025],
            )
            .into(),
        ],
        ambient: Rgb::gray(0.07),
        ..empty([0.0, 1.8, 8.6], [0.0, 1.0, 0.0], 23.0, STUDIO)
    }
}
