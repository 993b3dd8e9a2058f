//! Every public function of the library's floors 3 to 5, on inputs of any kind.

use bytemuck::{Pod, Zeroable};
use shading::f32::{
    Attenuation, Cone, DirectionalLight, Dual, IncidentLight, Material, PointLight, Ranged, Rgb,
    Shaded, SoftCone, SpotLight, UnitVec3, Vec3,
};
use shading::{Real, attenuation, half_vector, normal, reflection, shade, term};

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

/// Up to nine numbers.
#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
pub struct Output(pub Vec3, pub Vec3, pub Vec3);

impl From<Vec3> for Output {
    fn from(v: Vec3) -> Self {
        Self(v, Vec3::ZERO, Vec3::ZERO)
    }
}

impl From<UnitVec3> for Output {
    fn from(u: UnitVec3) -> Self {
        Vec3::from(u).into()
    }
}

/// No vector is (0, 0, 0).
impl From<Option<UnitVec3>> for Output {
    fn from(u: Option<UnitVec3>) -> Self {
        match u {
            Some(u) => u.into(),
            None => Vec3::ZERO.into(),
        }
    }
}

fn vector(c: Rgb) -> Vec3 {
    Vec3::new(c.r, c.g, c.b)
}

impl From<IncidentLight> for Output {
    fn from(light: IncidentLight) -> Self {
        Self(
            *light.l,
            vector(light.intensity),
            Vec3::new(light.distance, 1.0, 0.0),
        )
    }
}

impl From<Option<IncidentLight>> for Output {
    fn from(light: Option<IncidentLight>) -> Self {
        match light {
            Some(light) => light.into(),
            None => Vec3::ZERO.into(),
        }
    }
}

impl From<Shaded> for Output {
    fn from(shaded: Shaded) -> Self {
        Self(
            vector(shaded.ambient),
            vector(shaded.diffuse),
            vector(shaded.specular),
        )
    }
}

/// The same as the types of the library.
struct Given {
    a: Vec3,
    b: Vec3,
    c: Vec3,
    n: UnitVec3,
    l: UnitVec3,
    v: UnitVec3,
    k: Rgb,
    i: Rgb,
    q: f32,
    m: f32,
    integer: u32,
    attenuation: Attenuation,
    ranged: Ranged,
    cone: Cone,
    soft_cone: SoftCone,
}

impl Given {
    fn by(input: &Input) -> Self {
        let Vec3 { x, y, z } = input.coefficients;
        let attenuation = Attenuation::new(x, y, z).unwrap_or(Attenuation::NONE);
        let everything = Cone::from_cosine(-1.0).unwrap();
        Self {
            a: input.a,
            b: input.b,
            c: input.c,
            n: UnitVec3::assume_unit(input.n),
            l: UnitVec3::assume_unit(input.l),
            v: UnitVec3::assume_unit(input.v),
            k: input.k,
            i: input.i,
            q: input.q,
            m: input.m,
            integer: input.integer,
            attenuation,
            ranged: attenuation.within(input.r).unwrap(),
            cone: Cone::from_cosine(input.inner).unwrap_or(everything),
            soft_cone: SoftCone::from_cosines(input.inner, input.outer).unwrap(),
        }
    }

    fn sun(&self) -> DirectionalLight {
        DirectionalLight {
            l: self.l,
            intensity: self.i,
        }
    }

    fn lamp<A>(&self, attenuation: A) -> PointLight<A> {
        PointLight {
            position: self.b,
            intensity: self.i,
            attenuation,
        }
    }

    fn spot<C, A>(&self, cone: C, attenuation: A) -> SpotLight<C, A> {
        SpotLight {
            point: self.lamp(attenuation),
            axis: self.v,
            cone,
        }
    }

    fn material<M>(&self, m: M) -> Material<M> {
        Material {
            k_a: self.k,
            k_d: self.k,
            k_s: self.i,
            m,
        }
    }

    /// Four lamps, of which some are in front.
    fn lights(&self) -> impl Iterator<Item = IncidentLight> {
        let (lamp, (p, n, step)) = (self.lamp(self.attenuation), (self.a, self.n, self.c));
        (0..4_u32).filter_map(move |k| {
            let position = lamp.position + step * k as f32;
            PointLight { position, ..lamp }.in_front(p, n)
        })
    }
}

macro_rules! functions {
    ($($number:literal $name:literal $given:ident $call:expr;)*) => {
        pub const NAMES: &[&str] = &[$($name),*];

        pub fn call(function: u32, input: &Input) -> Output {
            let given = Given::by(input);
            match function {
                $($number => { let $given = given; $call.into() })*
                _ => Vec3::ZERO.into(),
            }
        }
    };
}

functions! {
    0 "÷ and √, which the others take from the driver" g
        Vec3::new(g.a.x / g.b.x, g.a.y / g.b.y, Real::sqrt(g.a.z.abs()));
    1 "attenuation" g {
        let [a, b, c] = g.attenuation.coefficients();
        Vec3::new(attenuation(a, b, c, g.q), g.attenuation.at(g.q), g.attenuation.clamped().at(g.q))
    };
    2 "Ranged" g Vec3::new(g.ranged.at(g.q), g.ranged.range(), g.ranged.attenuation().at(g.q));
    3 "Cone" g Vec3::new(g.cone.factor(g.v, g.l), g.cone.cosine(), 0.0);
    4 "Cone::from_half_angle" g match Cone::from_half_angle(g.q) {
        Some(cone) => Vec3::new(cone.cosine(), 1.0, 0.0),
        None => Vec3::ZERO,
    };
    5 "SoftCone" g {
        let [inner, outer] = g.soft_cone.cosines();
        Output(
            Vec3::new(inner, outer, 0.0),
            Vec3::new(g.soft_cone.factor(g.v, g.l), 0.0, 0.0),
            Vec3::new(g.soft_cone.smoothstep().factor(g.v, g.l), 0.0, 0.0),
        )
    };
    6 "SoftCone::from_half_angles" g match SoftCone::from_half_angles(g.q * 0.5, g.q) {
        Some(cone) => Vec3::new(cone.factor(g.v, g.l), 1.0, 0.0),
        None => Vec3::ZERO,
    };
    7 "reflection" g reflection(g.n, g.l);
    8 "half_vector" g half_vector(g.l, g.v);
    9 "term::ambient" g vector(term::ambient(g.k, g.i));
    10 "term::lambert" g Vec3::new(term::lambert(g.n, g.l), 0.0, 0.0);
    11 "term::phong" g
        Vec3::new(term::phong(g.l, g.v, g.integer), term::phong(g.l, g.v, g.m), 0.0);
    12 "term::blinn" g
        Vec3::new(term::blinn(g.n, g.v, g.integer), term::blinn(g.n, g.v, g.m), 0.0);
    13 "term::phong_normalization" g Vec3::new(term::phong_normalization(g.m), 0.0, 0.0);
    14 "term::blinn_normalization" g Vec3::new(term::blinn_normalization(g.m), 0.0, 0.0);
    15 "normal::plane" g normal::plane(g.a.x, g.a.y, g.a.z);
    16 "normal::triangle" g normal::triangle(g.a, g.b, g.c);
    17 "normal::sphere" g normal::sphere(g.a, g.b);
    18 "normal::implicit" g {
        let Vec3 { x, y, z } = g.b;
        let ellipsoid = move |p: shading::Vec3<Dual>| {
            p.x * p.x * Dual::constant(x) + p.y * p.y * Dual::constant(y) + p.z * p.z * Dual::constant(z)
        };
        normal::implicit(ellipsoid, g.a)
    };
    19 "normal::parametric" g {
        let Vec3 { x, y, z } = g.b;
        let paraboloid = move |u: Dual, v: Dual| shading::Vec3::new(
            u,
            v,
            u * u * Dual::constant(x) + u * v * Dual::constant(y) + v * v * Dual::constant(z),
        );
        normal::parametric(paraboloid, g.a.x, g.a.y)
    };
    20 "normal::from_gradient" g normal::from_gradient(g.a);
    21 "normal::from_tangents" g normal::from_tangents(g.a, g.b);
    22 "normal::facing" g normal::facing(g.n, g.v);
    23 "normal::transformed" g normal::transformed(g.n, [g.a, g.b, g.c]);
    24 "normal::corner" g normal::corner(g.a, g.b, g.c);
    25 "normal::mapped" g normal::mapped(g.n, g.a, g.b.x, g.c);
    26 "DirectionalLight::at" g g.sun().at(g.a);
    27 "DirectionalLight::in_front" g g.sun().in_front(g.a, g.n);
    28 "PointLight::at" g g.lamp(g.attenuation).at(g.a);
    29 "PointLight::in_front" g g.lamp(g.attenuation).in_front(g.a, g.n);
    30 "PointLight::at, within a range" g g.lamp(g.ranged).at(g.a);
    31 "PointLight::in_front, within a range" g g.lamp(g.ranged).in_front(g.a, g.n);
    32 "SpotLight::at" g g.spot(g.cone, g.attenuation).at(g.a);
    33 "SpotLight::in_front" g g.spot(g.cone, g.attenuation).in_front(g.a, g.n);
    34 "SpotLight::at, soft, within a range" g g.spot(g.soft_cone, g.ranged).at(g.a);
    35 "SpotLight::in_front, soft, within a range" g g.spot(g.soft_cone, g.ranged).in_front(g.a, g.n);
    36 "IncidentLight::in_front" g g.lamp(g.attenuation.clamped()).at(g.a).in_front(g.n);
    37 "shade::lambert" g shade::lambert(g.n, &g.material(1), g.k, g.lights());
    38 "shade::phong, m an integer" g shade::phong(g.n, g.v, &g.material(g.integer), g.k, g.lights());
    39 "shade::phong" g shade::phong(g.n, g.v, &g.material(g.m), g.k, g.lights());
    40 "shade::blinn_phong, m an integer" g
        shade::blinn_phong(g.n, g.v, &g.material(g.integer), g.k, g.lights());
    41 "shade::blinn_phong" g shade::blinn_phong(g.n, g.v, &g.material(g.m), g.k, g.lights());
    42 "Shaded::total" g
        vector(shade::blinn_phong(g.n, g.v, &g.material(g.m), g.k, g.lights()).total());
}
