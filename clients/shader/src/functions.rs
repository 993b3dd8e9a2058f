//! The functions of the library that a shader can call, from the table of all functions, on inputs of any kind.

use bytemuck::{Pod, Zeroable};
use kit::row::{saddle, torus};
use shading::{
    Attenuation, Cone, DirectionalLight, Dual, Elementary, IncidentLight, Lobe, Material,
    PointLight, Real, Rgb, Shaded, SpotLight, UnitVec3, Vec3, normal, shade, term,
};

#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C)]
pub struct Input {
    /// Points.
    pub a: Vec3,
    pub b: Vec3,
    pub c: Vec3,
    /// Directions of length 1.
    pub n: Vec3,
    pub l: Vec3,
    pub v: Vec3,
    /// Colors.
    pub k: Rgb,
    pub i: Rgb,
    /// Of an attenuation.
    pub coefficients: Vec3,
    /// A distance, and a range.
    pub q: f32,
    pub r: f32,
    /// The cosines of a soft cone's edges.
    pub inner: f32,
    pub outer: f32,
    /// Shininess.
    pub m: f32,
    pub integer: u32,
}

/// The same as the types of the library, with the names that the table has for them: as far as a
/// shader has them. The point p is `Input::a`, and the lamps are around `Input::b`.
pub struct Given<T> {
    p: Vec3<T>,
    a: Vec3<T>,
    b: Vec3<T>,
    n: UnitVec3<T>,
    l: UnitVec3<T>,
    v: UnitVec3<T>,
    x: T,
    y: T,
    cosine: T,
    f: Dual<T>,
    rgb: Rgb<T>,
    integer: Material<T, u32>,
    real: Material<T, T>,
    attenuation: Attenuation<T>,
    sun: DirectionalLight<T>,
    lamps: [PointLight<T>; 1],
    /// From each of four lamps to the next: a shader cannot index an array of them.
    step: Vec3<T>,
    spot: SpotLight<T>,
    soft_spot: SpotLight<T>,
    shaded: Shaded<T>,
}

impl Given<f32> {
    fn by(input: &Input) -> Self {
        let unit = UnitVec3::assume_unit; // a shader has no `map` of an array
        let (n, l, v) = (unit(input.n), unit(input.l), unit(input.v));
        let Vec3 { x, y, z } = input.coefficients;
        let attenuation = Attenuation::new(x, y, z).unwrap_or(Attenuation::NONE);
        let lamp = |attenuation| PointLight {
            position: input.b,
            intensity: input.i,
            attenuation,
        };
        let spot = |attenuation, inner| SpotLight {
            point: lamp(attenuation),
            axis: v,
            cone: Cone::from_cosines(inner, input.outer).unwrap(),
        };
        let (k_a, k_d, k_s) = (input.k, input.k, input.i);
        let m = input.integer;
        Self {
            p: input.a,
            a: input.b,
            b: input.c,
            n,
            l,
            v,
            x: input.q,
            y: input.r,
            cosine: if input.inner < 0.0 {
                -input.inner
            } else {
                input.inner
            },
            f: Dual {
                value: input.q,
                gradient: input.b,
            },
            rgb: input.i,
            integer: Material { k_a, k_d, k_s, m },
            real: Material {
                k_a,
                k_d,
                k_s,
                m: input.m,
            },
            attenuation,
            sun: DirectionalLight {
                l,
                intensity: input.i,
            },
            lamps: [lamp(attenuation)],
            step: input.c,
            spot: spot(attenuation, input.outer),
            soft_spot: spot(attenuation.within(input.r).unwrap(), input.inner),
            shaded: Shaded {
                ambient: k_a,
                diffuse: k_s,
                specular: k_d,
            },
        }
    }
}

impl<T: Number> Given<T> {
    /// The light that arrives from each lamp.
    #[allow(clippy::wrong_self_convention)] // the name in the table of functions
    fn from_lamps(&self) -> impl Iterator<Item = IncidentLight<T>> {
        let (lamp, step, p) = (self.lamps[0], self.step, self.p);
        (0..4_u32).map(move |k| {
            let mut position = lamp.position;
            for _ in 0..k {
                position += step;
            }
            PointLight { position, ..lamp }.at(p)
        })
    }
}

/// Up to nine numbers. No result is zeros.
#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
pub struct Output(pub [f32; 3], pub [f32; 3], pub [f32; 3]);

const NOTHING: [f32; 3] = [0.0; 3];

/// A result of numbers.
pub trait Value: Copy {
    fn output(self) -> Output;
}

macro_rules! values {
    ($($value:ty: |$result:ident| $output:expr;)*) => {
        $(impl<T: Number> Value for $value {
            fn output(self) -> Output {
                let $result = self;
                $output
            }
        })*
    };
}

values! {
    [T; 2]: |r| Output([r[0].into(), r[1].into(), 1.0], NOTHING, NOTHING);
    [T; 3]: |r| Output([r[0].into(), r[1].into(), r[2].into()], NOTHING, NOTHING);
    Vec3<T>: |r| [r.x, r.y, r.z].output();
    UnitVec3<T>: |r| (*r).output();
    Rgb<T>: |r| [r.r, r.g, r.b].output();
    Dual<T>: |r| Output(r.gradient.output().0, [r.value.into(), 1.0, 0.0], NOTHING);
    IncidentLight<T>: |r| Output(r.l().output().0, r.intensity().output().0, [r.distance().into(), 1.0, 0.0]);
    Shaded<T>: |r| Output(r.ambient.output().0, r.diffuse.output().0, r.specular.output().0);
}

impl Value for f32 {
    fn output(self) -> Output {
        Output([self, 1.0, 0.0], NOTHING, NOTHING)
    }
}

impl Value for bool {
    fn output(self) -> Output {
        if self { 1.0.output() } else { 0.0.output() }
    }
}

impl<V: Value> Value for Option<V> {
    fn output(self) -> Output {
        match self {
            Some(value) => value.output(),
            None => Output(NOTHING, NOTHING, NOTHING),
        }
    }
}

/// `f32`, in generic code: the rows of the table take the operations of the traits, which are the
/// same on every processor.
pub trait Number: Elementary + PartialOrd + Into<f32> + Value {}

impl Number for f32 {}

pub trait Float: Number + Lobe<Self> {}

impl Float for f32 {}

fn operations<T: Number>(g: &Given<T>) -> impl Value {
    Vec3::new(g.a.x / g.b.x, g.a.y / g.b.y, Real::sqrt(g.a.z.abs()))
}

macro_rules! kernels {
    (
        ARITHMETIC: Number $arithmetic:tt SWEEPS: Number $sweeps:tt SERIES: Float $series:tt
        BYTES: Number $bytes:tt ANGLES: Number $angles:tt OFF_GPU: Number $off_gpu:tt
        $($section:ident: $bound:ident {
            $($row:ident $name:literal |$given:ident| $call:expr => $promise:ident;)*
        })*
    ) => {
        $($(
            fn $row<T: $bound>($given: &Given<T>) -> impl Value { $call }
        )*)*

        /// The functions, in the order of their numbers, which begin at 1.
        #[allow(non_camel_case_types)]
        enum Row { $($($row,)*)* }

        /// The name of each number; 0 is ÷ and √, which the functions take from the driver.
        pub const NAMES: &[&str] = &["÷ and √", $($($name,)*)*];

        pub fn call(function: u32, input: &Input) -> Output {
            let given = Given::by(input);
            $($(
                if function == Row::$row as u32 + 1 {
                    return $row(&given).output();
                }
            )*)*
            operations(&given).output()
        }
    };
}
kit::for_each_function!(kernels);
