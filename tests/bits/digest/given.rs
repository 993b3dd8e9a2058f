//! The inputs of the functions: exact numbers, the same on every machine.

#[cfg(feature = "fixed")]
use shading::fixed::Fixed;
use shading::{
    Attenuation, Cone, DirectionalLight, Dual, Elementary, Exponent, IncidentLight, Light,
    Material, PointLight, Ranged, Rgb, Shaded, SoftCone, SpotLight, UnitVec3, Vec3, shade,
};

use super::fnv::Absorb;

/// `f32`, `f64` or a fixed-point number, with the functions that exist separately for each.
pub trait Number: Elementary + PartialOrd + Absorb + 'static {
    const EPSILON: Self;
    /// Sizes from zero to the largest number, with subnormal ones.
    const SIZES: [Self; 10];
    const CONE: Cone<Self>;

    /// A number in [−1, 1), with all the digits that the type holds.
    fn draw(numbers: &mut Numbers) -> Self;
    /// A finite number of any size.
    fn draw_any(numbers: &mut Numbers) -> Self;

    fn single(self) -> f32;
    fn normalized(v: Vec3<Self>) -> Option<UnitVec3<Self>>;

    fn times_vector(self, v: Vec3<Self>) -> Vec3<Self>;
    fn times_rgb(self, rgb: Rgb<Self>) -> Rgb<Self>;
}

/// `f32` or `f64`.
pub trait Float: Number + Exponent<Self> + From<f32> {
    /// self + dual, self − dual, self · dual and self / dual.
    fn before(self, dual: Dual<Self>) -> [Dual<Self>; 4];
}

macro_rules! number {
    ($number:ident, $epsilon:expr, $sizes:expr, $cone:expr, $draw:expr, $draw_any:expr, $single:expr) => {
        impl Number for $number {
            const EPSILON: Self = $epsilon;
            const SIZES: [Self; 10] = $sizes;
            const CONE: Cone<Self> = Cone::<$number>::from_half_angle($cone).unwrap();

            #[allow(clippy::cast_precision_loss)] // nothing is lost: as many bits are drawn as fit
            fn draw(numbers: &mut Numbers) -> Self {
                $draw(numbers)
            }

            fn draw_any(numbers: &mut Numbers) -> Self {
                $draw_any(numbers)
            }

            #[allow(clippy::cast_possible_truncation)] // of a double, on purpose: only `f32` is encoded
            fn single(self) -> f32 {
                $single(self)
            }

            fn normalized(v: Vec3<Self>) -> Option<UnitVec3<Self>> {
                UnitVec3::<$number>::normalized(v.x, v.y, v.z)
            }

            fn times_vector(self, v: Vec3<Self>) -> Vec3<Self> {
                self * v
            }

            fn times_rgb(self, rgb: Rgb<Self>) -> Rgb<Self> {
                self * rgb
            }
        }
    };
}

macro_rules! float {
    ($float:ident, $sizes:expr, $draw:expr, $any_bits:expr) => {
        number!(
            $float,
            $float::EPSILON,
            $sizes,
            0.9,
            $draw,
            |numbers: &mut Numbers| {
                let any = $float::from_bits($any_bits(numbers));
                if any.is_finite() { any } else { $float::MAX }
            },
            |number: $float| number as f32
        );

        impl Float for $float {
            fn before(self, dual: Dual<Self>) -> [Dual<Self>; 4] {
                [self + dual, self - dual, self * dual, self / dual]
            }
        }
    };
}

float!(
    f32,
    [
        0.0, 1e-45, 1e-38, 1e-20, 1e-8, 1.0, 4096.0, 1e15, 1e20, 3e38
    ],
    |numbers: &mut Numbers| (numbers.next() >> 8) as f32 / 8_388_608.0 - 1.0,
    |numbers: &mut Numbers| numbers.next()
);
float!(
    f64,
    [
        0.0, 5e-324, 1e-308, 1e-160, 1e-16, 1.0, 4096.0, 1e120, 1e160, 1.7e308
    ],
    |numbers: &mut Numbers| (numbers.next_u64() >> 11) as f64 / 4_503_599_627_370_496.0 - 1.0,
    |numbers: &mut Numbers| numbers.next_u64()
);

#[cfg(feature = "fixed")]
number!(
    Fixed,
    Fixed::STEP,
    [
        Fixed::new(0.0),
        Fixed::STEP,
        Fixed::new(0.001),
        Fixed::new(0.1),
        Fixed::new(0.5),
        Fixed::new(1.0),
        Fixed::new(181.0), // its square is within the range
        Fixed::new(182.0), // and that of this number is not
        Fixed::new(16384.0),
        Fixed::MAX
    ],
    Fixed::new(0.9),
    |numbers: &mut Numbers| Fixed::from_bits(numbers.next_i32() >> 15),
    Numbers::next_fixed,
    Fixed::to_f32
);

/// A linear congruential generator (Knuth's constants, as in *Numerical Recipes*).
pub struct Numbers(pub u32);

impl Numbers {
    fn next(&mut self) -> u32 {
        self.0 = self.0.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        self.0
    }

    fn next_u64(&mut self) -> u64 {
        u64::from(self.next()) << 32 | u64::from(self.next())
    }

    #[cfg(feature = "fixed")]
    fn next_i32(&mut self) -> i32 {
        i32::from_le_bytes(self.next().to_le_bytes())
    }

    /// A number of any size, each as often as the others.
    #[cfg(feature = "fixed")]
    pub fn next_fixed(&mut self) -> Fixed {
        let bits = self.next_i32();
        Fixed::from_bits(bits >> (self.next() >> 27))
    }

    /// A number in [0, 1).
    #[cfg(feature = "fixed")]
    pub fn next_share(&mut self) -> Fixed {
        Fixed::from_bits(self.next_i32() >> 16 & 0xFFFF)
    }

    /// A number with any bits.
    #[cfg(feature = "fixed")]
    pub fn next_bits(&mut self) -> Fixed {
        Fixed::from_bits(self.next_i32())
    }

    /// Chooses one of several values.
    fn choose<T: Copy, const N: usize>(&mut self, choices: [T; N]) -> T {
        const { assert!(N > 0) }
        // uses the upper bits, the better ones of a linear congruential generator
        choices[(self.next() >> 8) as usize % N]
    }

    /// A vector with each coordinate in [−1, 1).
    fn vector<T: Number>(&mut self) -> Vec3<T> {
        Vec3::new(T::draw(self), T::draw(self), T::draw(self))
    }

    fn along_an_axis<T: Number>(&mut self) -> Vec3<T> {
        let [x, y, z] = [UnitVec3::X, UnitVec3::Y, UnitVec3::Z];
        *self.choose([x, y, z, -x, -z]) * self.choose(T::SIZES)
    }
}

/// The number of places at which the functions are called.
const PLACES: u32 = 1024;

/// Most places are ordinary. An eighth of them have vectors of any size, an eighth have vectors
/// whose components are of any size, and an eighth have vectors and directions along the axes, many
/// of which coincide or are opposite.
pub fn places<T: Number>() -> impl Iterator<Item = Given<T>> {
    let mut numbers = Numbers(1);
    (0..PLACES).map(move |i| {
        let vector: fn(&mut Numbers) -> Vec3<T> = match i % 8 {
            5 => |numbers| numbers.vector() * T::draw_any(numbers),
            6 => |numbers| Vec3::from([(); 3].map(|()| T::draw_any(numbers))),
            7 => Numbers::along_an_axis,
            _ => |numbers| numbers.vector() * T::of_f32(4.0),
        };
        Given::new(&mut numbers, vector)
    })
}

/// Everything that a function may take, at one place.
pub struct Given<T> {
    pub p: Vec3<T>,
    pub a: Vec3<T>,
    pub b: Vec3<T>,
    pub n: UnitVec3<T>,
    pub l: UnitVec3<T>,
    pub v: UnitVec3<T>,
    pub x: T,
    pub y: T,
    /// In [0, 1], and often next to an end.
    pub cosine: T,
    pub f: Dual<T>,
    pub h: Dual<T>,
    pub rgb: Rgb<T>,
    pub k_a: Rgb<T>,
    pub k_d: Rgb<T>,
    pub k_s: Rgb<T>,
    pub attenuation: Attenuation<T>,
    pub sun: DirectionalLight<T>,
    /// The attenuation of the second lamp is clamped.
    pub lamps: [PointLight<T>; 2],
    pub spot: SpotLight<T>,
}

impl<T: Number> Given<T> {
    fn new(numbers: &mut Numbers, vector: fn(&mut Numbers) -> Vec3<T>) -> Self {
        let [p, a, b, c] = [(); 4].map(|()| vector(numbers));
        let [n, l, v, axis] = [(); 4].map(|()| vector(numbers).unit_or(UnitVec3::Z));
        let [k_a, k_d, k_s, rgb, intensity] =
            [(); 5].map(|()| Rgb::from(<[T; 3]>::from(vector(numbers))).map(T::abs));
        let Vec3 { x, y, z } = vector(numbers);

        let share = T::draw(numbers).abs();
        let near_one = T::ONE - share * T::of_f32(64.0) * T::EPSILON;
        let any = T::draw_any(numbers).abs().at_most(T::ONE);
        let cosine = numbers.choose([share, share, near_one, any]);

        let attenuation = Attenuation::of(x.abs(), y.abs(), z.abs()).unwrap_or(Attenuation::NONE);
        let lamp = |position, attenuation| PointLight {
            position,
            intensity,
            attenuation,
        };
        let cone = Cone::of_cosine(T::draw(numbers)).unwrap_or(T::CONE);
        Self {
            p,
            a,
            b,
            n,
            l,
            v,
            x,
            y,
            cosine,
            f: Dual {
                value: x,
                gradient: a,
            },
            h: Dual {
                value: y,
                gradient: b,
            },
            rgb,
            k_a,
            k_d,
            k_s,
            attenuation,
            sun: DirectionalLight { l, intensity },
            lamps: [lamp(a, attenuation), lamp(b, attenuation.clamped())],
            spot: SpotLight {
                point: lamp(c, attenuation),
                axis,
                cone,
            },
        }
    }

    /// The material with a given shininess.
    pub fn material<M>(&self, m: M) -> Material<T, M> {
        let &Self { k_a, k_d, k_s, .. } = self;
        Material { k_a, k_d, k_s, m }
    }

    /// The spotlight with a soft edge and with a range that is often close to the distance.
    pub fn soft_spot(&self) -> Option<SpotLight<T, SoftCone<T>, Ranged<T>>> {
        let SpotLight { point, axis, .. } = self.spot;
        let range = self.y.abs() + (point.position - self.p).length();
        let point = PointLight {
            position: point.position,
            intensity: point.intensity,
            attenuation: Ranged::of(point.attenuation, range)?,
        };
        let cone = SoftCone::of_cosines(self.cosine, -T::ONE)?;
        Some(SpotLight { point, axis, cone })
    }

    pub fn lights(&self) -> [Light<T>; 4] {
        let [lamp, clamped] = self.lamps.map(Light::Point);
        [
            Light::Directional(self.sun),
            lamp,
            Light::Spot(self.spot),
            clamped,
        ]
    }

    /// The light that arrives from each light, twice: more than four are in front of the surface.
    pub fn arriving(&self) -> impl Iterator<Item = IncidentLight<T>> {
        let lights = self.lights().map(|light| light.at(self.p));
        lights.into_iter().chain(lights)
    }

    pub fn shaded(&self) -> Shaded<T> {
        shade::blinn_phong(self.n, self.v, &self.material(2), self.rgb, self.arriving())
    }
}
