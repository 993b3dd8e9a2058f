//! What the properties are tried with. Each input is made in `f64`, shrinks to its default, prints
//! itself as Rust, and is cast to the number that is tried.

use core::fmt::Debug;

use proptest::strategy::BoxedStrategy;
use shading::{
    Attenuation, Cone, DirectionalLight, IncidentLight, Light, Material, PointLight, Real, Rgb,
    Shaded, SpotLight, UnitVec3, Vec3, shade,
};

use crate::source::Source;
use crate::{Number, has_digits, strategies};

/// An input in `f64`.
pub trait Given: Clone + Debug + 'static {
    /// Cases with the edges in them, of sizes that a number has.
    fn any(sizes: Sizes) -> BoxedStrategy<Self>;
    /// The expression that makes it.
    fn source(&self) -> String;
}

/// The same input in another number.
pub trait Of<T> {
    type Plain: Given;
    fn of(plain: &Self::Plain) -> Self;
}

/// The exponents of the smallest and of the largest power of two that a number has.
#[derive(Clone, Copy, Debug)]
pub struct Sizes {
    pub least: i32,
    pub most: i32,
}

impl Sizes {
    #[allow(clippy::cast_possible_truncation)]
    pub fn of<T: Number>() -> Self {
        Self {
            least: T::SMALLEST.log2() as i32,
            most: T::LARGEST.log2() as i32,
        }
    }
}

/// The default, the cast and the source of an input, from those of each field.
macro_rules! given {
    ($name:ident by $any:expr, |$f:ident| $($field:ident = $default:expr => $cast:expr),+ $(,)?) => {
        impl Default for $name {
            fn default() -> Self {
                Self { $($field: $default),+ }
            }
        }

        impl<T: Real> $name<T> {
            /// The same in another number.
            pub fn cast<U: Real>(&self, $f: impl Fn(T) -> U + Copy) -> $name<U> {
                let Self { $($field),+ } = self;
                $name { $($field: $cast),+ }
            }
        }

        impl<T: Number> Of<T> for $name<T> {
            type Plain = $name;
            fn of(plain: &$name) -> Self {
                plain.cast(T::of)
            }
        }

        impl Given for $name {
            fn any(sizes: Sizes) -> BoxedStrategy<Self> {
                $any(sizes)
            }

            fn source(&self) -> String {
                let default = Self::default();
                let mut fields: Vec<String> = Vec::new();
                $(if self.$field != default.$field {
                    fields.push(format!("{}: {}", stringify!($field), self.$field.source()));
                })+
                if fields.is_empty() {
                    return concat!(stringify!($name), "::default()").into();
                }
                format!("{} {{ {}, ..{0}::default() }}", stringify!($name), fields.join(", "))
            }
        }
    };
}

/// A point that is lit, and looked at.
#[derive(Clone, Debug)]
pub struct Scene<T = f64> {
    pub n: UnitVec3<T>,
    pub v: UnitVec3<T>,
    pub p: Vec3<T>,
    pub material: Material<T>,
    pub ambient: Rgb<T>,
    pub lights: Vec<Light<T>>,
}

given!(Scene by strategies::scenes, |f|
    n = UnitVec3::Z => n.cast(f),
    v = UnitVec3::Z => v.cast(f),
    p = Vec3::ZERO => p.map(f),
    material = shiny(1) => material.cast(f),
    ambient = Rgb::BLACK => ambient.map(f),
    lights = Vec::new() => lights.iter().map(|light| light.cast(f)).collect(),
);

impl<T: Real + PartialOrd> Scene<T> {
    /// The light that arrives at the point, from each light.
    pub fn arriving(&self) -> Vec<IncidentLight<T>> {
        self.lights.iter().map(|light| light.at(self.p)).collect()
    }

    /// The three sums of some light: of Lambert, of Phong, and of Blinn and Phong.
    pub fn shaded(&self, lights: &[IncidentLight<T>]) -> [Shaded<T>; 3] {
        let lights = || lights.iter().copied();
        [
            shade::lambert(self.n, &self.material, self.ambient, lights()),
            shade::phong(self.n, self.v, &self.material, self.ambient, lights()),
            shade::blinn_phong(self.n, self.v, &self.material, self.ambient, lights()),
        ]
    }

    /// The same lights on a white surface without ambient light, so that the sums are of the lights
    /// alone.
    #[must_use]
    pub fn white(&self) -> Self {
        Self {
            material: shiny(self.material.m),
            ambient: Rgb::BLACK,
            ..self.clone()
        }
    }

    /// Whether no sum of the lights can overflow.
    pub fn is_in_range(&self) -> bool {
        let most = T::MAX * T::of(1.0 / 32.0);
        self.arriving().iter().all(|light| {
            let i = light.intensity();
            i.r < most && i.g < most && i.b < most
        })
    }

    /// The same lights with other colors, and the material and the ambient light, too.
    #[must_use]
    pub fn map_colors(&self, f: impl Fn(Rgb<T>) -> Rgb<T>) -> Self {
        let Material { k_a, k_d, k_s, m } = self.material;
        let mut scene = Self {
            material: material(f(k_a), f(k_d), f(k_s), m),
            ambient: f(self.ambient),
            ..self.clone()
        };
        for light in &mut scene.lights {
            let intensity = match light {
                Light::Directional(sun) => &mut sun.intensity,
                Light::Point(lamp) => &mut lamp.intensity,
                Light::Spot(spot) => &mut spot.point.intensity,
            };
            *intensity = f(*intensity);
        }
        scene
    }

    /// The scene with every direction and every point moved: directions by `turn` alone.
    #[must_use]
    pub fn moved(&self, turn: impl Fn(Vec3<T>) -> Vec3<T>, offset: Vec3<T>) -> Self {
        let unit = |u: UnitVec3<T>| UnitVec3::assume_unit(turn(*u));
        let place = |p: Vec3<T>| turn(p) + offset;
        let mut scene = Self {
            n: unit(self.n),
            v: unit(self.v),
            p: place(self.p),
            ..self.clone()
        };
        for light in &mut scene.lights {
            match light {
                Light::Directional(sun) => sun.l = unit(sun.l),
                Light::Point(lamp) => lamp.position = place(lamp.position),
                Light::Spot(spot) => {
                    spot.axis = unit(spot.axis);
                    spot.point.position = place(spot.point.position);
                }
            }
        }
        scene
    }

    /// The lamps, those of the spots among them.
    pub fn lamps(&self) -> impl Iterator<Item = PointLight<T>> {
        self.lights.iter().filter_map(|light| match light {
            Light::Directional(_) => None,
            Light::Point(lamp) => Some(*lamp),
            Light::Spot(spot) => Some(spot.point),
        })
    }
}

impl<T: Number> Scene<T> {
    /// Whether each lamp is at the point, or so far that its distance has digits: in fixed point, the square of a
    /// distance of a few steps is 0.
    pub fn has_distances(&self) -> bool {
        let is_measured = |lamp: PointLight<T>| {
            let way = lamp.position.map(T::exact) - self.p.map(T::exact);
            way == Vec3::ZERO || has_digits::<T>(way.dot(way))
        };
        T::U > 0.0 || self.lamps().all(is_measured)
    }
}

/// The normal, the direction to a light, the direction to the eye, and the shininess.
#[derive(Clone, Debug)]
pub struct Directions<T = f64> {
    pub n: UnitVec3<T>,
    pub l: UnitVec3<T>,
    pub v: UnitVec3<T>,
    pub m: u32,
}

given!(Directions by strategies::directions, |f|
    n = UnitVec3::Z => n.cast(f),
    l = UnitVec3::Z => l.cast(f),
    v = UnitVec3::Z => v.cast(f),
    m = 1 => *m,
);

/// Three points of any size, three of few bits with how far they move, and a texture map.
#[derive(Clone, Debug)]
pub struct Triangle<T = f64> {
    pub a: Vec3<T>,
    pub b: Vec3<T>,
    pub c: Vec3<T>,
    /// Of few bits, so that sums and products are exact in every number.
    pub corners: [Vec3<T>; 3],
    pub offset: Vec3<T>,
    /// The texture coordinates of the corners, of few bits.
    pub map: [[T; 2]; 3],
}

given!(Triangle by strategies::triangles, |f|
    a = Vec3::ZERO => a.map(f),
    b = Vec3::ZERO => b.map(f),
    c = Vec3::ZERO => c.map(f),
    corners = [Vec3::ZERO; 3] => corners.map(|v| v.map(f)),
    offset = Vec3::ZERO => offset.map(f),
    map = [[0.0; 2]; 3] => map.map(|v| v.map(f)),
);

/// A normal with a tangent and a sample of a normal map, and the columns of a matrix.
#[derive(Clone, Debug)]
pub struct Frame<T = f64> {
    pub n: UnitVec3<T>,
    pub v: UnitVec3<T>,
    pub tangent: Vec3<T>,
    pub sample: Vec3<T>,
    /// Of few bits.
    pub columns: [Vec3<T>; 3],
}

given!(Frame by strategies::frames, |f|
    n = UnitVec3::Z => n.cast(f),
    v = UnitVec3::Z => v.cast(f),
    tangent = *UnitVec3::X => tangent.map(f),
    sample = *UnitVec3::Z => sample.map(f),
    columns = [*UnitVec3::X, *UnitVec3::Y, *UnitVec3::Z] => columns.map(|v| v.map(f)),
);

/// A falloff without a range, a range, and two distances.
#[derive(Clone, Debug)]
pub struct Falloff<T = f64> {
    pub falloff: Attenuation<T>,
    /// The range.
    pub r: T,
    pub q: T,
    /// How much further the second distance is: at least 0.
    pub further: T,
}

given!(Falloff by strategies::falloffs, |f|
    falloff = Attenuation::NONE => falloff.cast(f),
    r = 0.5 => f(*r),
    q = 0.0 => f(*q),
    further = 0.0 => f(*further),
);

/// A cone, its axis, and two directions to the light.
#[derive(Clone, Debug)]
pub struct Beam<T = f64> {
    pub cone: Cone<T>,
    pub axis: UnitVec3<T>,
    pub l: UnitVec3<T>,
    pub other: UnitVec3<T>,
}

given!(Beam by strategies::beams, |f|
    cone = Cone::from_cosine(0.0).expect("a cosine") => cone.cast(f),
    axis = UnitVec3::Z => axis.cast(f),
    l = UnitVec3::Z => l.cast(f),
    other = UnitVec3::Z => other.cast(f),
);

/// Two numbers within [0, 1], one of any size and sign, and the shininess.
#[derive(Clone, Debug)]
pub struct Numbers<T = f64> {
    pub x: T,
    pub y: T,
    pub z: T,
    pub m: u32,
}

given!(Numbers by strategies::numbers, |f|
    x = 0.0 => f(*x),
    y = 0.0 => f(*y),
    z = 0.0 => f(*z),
    m = 1 => *m,
);

// short names, for what a failed test prints

pub fn vec3(x: f64, y: f64, z: f64) -> Vec3<f64> {
    Vec3::new(x, y, z)
}

pub fn unit(x: f64, y: f64, z: f64) -> UnitVec3<f64> {
    UnitVec3::assume_unit(Vec3::new(x, y, z))
}

/// The direction with these coordinates that points up, along z.
pub fn up(x: f64, y: f64) -> UnitVec3<f64> {
    unit(x, y, (1.0 - x * x - y * y).sqrt())
}

/// The direction with these coordinates that points down.
pub fn down(x: f64, y: f64) -> UnitVec3<f64> {
    unit(x, y, -(1.0 - x * x - y * y).sqrt())
}

pub fn rgb(r: f64, g: f64, b: f64) -> Rgb<f64> {
    Rgb::new(r, g, b)
}

pub fn sun(l: UnitVec3<f64>, intensity: Rgb<f64>) -> Light<f64> {
    DirectionalLight { l, intensity }.into()
}

pub fn lamp(
    position: Vec3<f64>,
    intensity: Rgb<f64>,
    attenuation: Attenuation<f64>,
) -> PointLight<f64> {
    PointLight {
        position,
        intensity,
        attenuation,
    }
}

pub fn spot(point: PointLight<f64>, axis: UnitVec3<f64>, cone: Cone<f64>) -> Light<f64> {
    SpotLight { point, axis, cone }.into()
}

pub fn coefficients(a: f64, b: f64, c: f64) -> Attenuation<f64> {
    Attenuation::new(a, b, c).expect("coefficients")
}

pub fn cone(inner: f64, outer: f64) -> Cone<f64> {
    Cone::from_cosines(inner, outer).expect("cosines")
}

/// A white material of this shininess.
pub fn shiny<T: Real>(m: u32) -> Material<T> {
    material(Rgb::WHITE, Rgb::WHITE, Rgb::WHITE, m)
}

pub fn material<T>(k_a: Rgb<T>, k_d: Rgb<T>, k_s: Rgb<T>, m: u32) -> Material<T> {
    Material { k_a, k_d, k_s, m }
}
