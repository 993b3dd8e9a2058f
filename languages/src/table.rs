//! The functions of the files: what each is called, takes and gives, and what it says of itself. The formulas
//! are the crate's.

use shading::number::{Dimmed, LightSum, Measured, power};
use shading::{
    Arrival, DirectionalLight, IncidentLight, Material, Rgb, Shaded, UnitVec3, Vec3, attenuation,
    half_vector, normal, reflection, shade, term,
};

use crate::kind::{Kind, Light, Number, Sums, Tangent, Value, of_kind};
use crate::light::cone;
use crate::number::{Crossed, Expr, Inline};

/// A function of the files.
pub struct Function {
    pub name: &'static str,
    pub doc: &'static str,
    pub parameters: &'static [(&'static str, Kind)],
    pub result: Kind,
    /// Records it, given the numbers of its parameters.
    pub(crate) record: fn(&[usize]) -> Vec<usize>,
    /// What the crate computes, given the numbers of its parameters.
    pub compute: fn(&[f32]) -> Vec<f32>,
}

/// All functions, in the order of the files: each calls only those before it.
#[must_use]
pub fn functions() -> &'static [Function] {
    FUNCTIONS
}

/// A light that arrives, as a sum takes it.
fn arrived<T: Number>(light: &Arrival<T>) -> [IncidentLight<T>; 1] {
    let (l, intensity) = (light.l, light.intensity);
    [DirectionalLight { l, intensity }.at(Vec3::ZERO)]
}

/// What reflects all light.
fn white<T: Number>(m: T) -> Material<T, T> {
    let [k_a, k_d, k_s] = [Rgb::WHITE; 3];
    Material { k_a, k_d, k_s, m }
}

fn added<T: Number>(sums: &Sums<T>, shaded: Shaded<T>) -> Sums<T> {
    let diffuse = sums.diffuse + shaded.diffuse;
    let specular = sums.specular + shaded.specular;
    Sums { diffuse, specular }
}

fn both<T: Number>(shaded: Shaded<T>) -> Rgb<T> {
    shaded.diffuse + shaded.specular
}

fn full<T: Number>() -> Dimmed<T> {
    let (color, factor) = (Rgb::WHITE, T::ONE);
    Dimmed { color, factor }
}

/// The factor of a beam by the cosine to its axis.
fn beam<T: Number>(cosine: T, edges: [T; 2], is_smooth: T::Mask) -> T {
    let [w, axis] = [T::ONE, -cosine].map(|x| Vec3::new(x, T::ZERO, T::ZERO));
    let measured = Measured::take(&mut [T::ONE, T::ZERO, T::ZERO, T::ONE, T::ONE].into_iter());
    T::beamed(full(), axis, edges, is_smooth, w, &measured).factor
}

fn window<T: Number>(q: T, r: T, is_squared: T::Mask) -> T {
    let v = Vec3::new(q, T::ZERO, T::ZERO);
    T::windowed(full(), v, q, r, is_squared).factor
}

// each row begins with the number that records it: a function behind a hook writes the hook out
macro_rules! functions {
    ($list:ident $(
        $(#[doc = $doc:literal])*
        $number:ident fn $name:ident($($p:ident: $kind:ident),*) -> $result:ident = $formula:expr;
    )*) => {
        pub const $list: &[Function] = &[$({
            fn compute<T: Number>(from: &[T]) -> Vec<T> {
                let mut from = from.iter().copied();
                $(let $p = <of_kind!($kind)>::take(&mut from);)*
                $formula.numbers()
            }
            fn record(numbers: &[usize]) -> Vec<usize> {
                let numbers: Vec<_> = numbers.iter().copied().map($number).collect();
                compute(&numbers).iter().map(|result| result.0).collect()
            }
            Function {
                name: stringify!($name),
                doc: concat!($($doc),*),
                parameters: &[$((stringify!($p), Kind::$kind)),*],
                result: Kind::$result,
                record,
                compute: compute::<f32>,
            }
        }),*];
    };
}

functions! {
    BUILT_IN_POWERS

    /// (c/d)^m for c/d within [0, 1] and m >= 0, by the language's own power.
    Expr fn power_of_quotient(c: Fraction, d: Fraction, m: Positive) -> Number =
        (c / d).at_most(T::ONE).powf(m);

    /// c^m for c within [0, 1] and m >= 0, by the language's own power.
    Expr fn power(c: Fraction, m: Positive) -> Number = c.powf(m);
}

functions! {
    FUNCTIONS

    /// (c/d)^m for c/d within [0, 1] and m >= 0, by the crate's own logarithm: within 2^-22.
    Expr fn power_of_quotient(c: Fraction, d: Fraction, m: Positive) -> Number =
        power::single_of_quotient(c, d, m);

    /// c^m for c within [0, 1] and m >= 0, within 2^-22.
    Expr fn power(c: Fraction, m: Positive) -> Number = power::single(c, m);

    /// The length of v, and w in its direction: v itself, or v times a power of 2 where its square is out of range.
    Inline fn measured(v: Vector) -> Measured = T::measured(v);

    /// v/|v|; 0 where v is 0.
    Expr fn unit(v: Vector) -> Unit = v.unit();

    /// The vector from a point to another, times a power of 2 where its square is out of range.
    Inline fn between(origin: Vector, p: Vector) -> Vector = T::between(origin, p);

    /// (a - origin) x (b - origin), in the right direction even where its square is out of range.
    Crossed fn crossed(origin: Vector, a: Vector, b: Vector) -> Vector = T::crossed(origin, a, b);

    /// The reflection vector R = 2(N.L)N - L. Phong 1975; Foley, van Dam et al. 16.1.
    Expr fn reflection(n: Unit, l: Unit) -> Unit = reflection(n, l);

    /// The half vector H = (L + V)/|L + V|; 0 where L = -V. Blinn 1977.
    Expr fn half_vector(l: Unit, v: Unit) -> Unit = half_vector(l, v);

    /// The ambient term k_a I_a. Foley, van Dam et al. 16.1.
    Expr fn term_ambient(k_a: Color, i_a: Color) -> Color = term::ambient(k_a, i_a);

    /// Lambert's factor max(0, N.L). Lambert 1760.
    Expr fn term_lambert(n: Unit, l: Unit) -> Number = term::lambert(n, l);

    /// Phong's highlight max(0, R.V)^m. Phong 1975.
    Expr fn term_phong(r: Unit, v: Unit, m: Positive) -> Number = term::phong(r, v, m);

    /// Blinn's highlight max(0, N.H)^m. Blinn 1977.
    Expr fn term_blinn(n: Unit, h: Unit, m: Positive) -> Number = term::blinn(n, h, m);

    /// What makes Phong's highlight reflect at most k_s: (m + 2)/(2 pi). Lafortune and Willems 1994.
    Expr fn term_phong_normalization(m: Positive) -> Number = term::phong_normalization(m);

    /// The same of Blinn's: (m + 2)(m + 4)/(8 pi (2^(-m/2) + m)). Giesen 2009.
    Expr fn term_blinn_normalization(m: Positive) -> Number = term::blinn_normalization(m);

    /// The attenuation 1/(a + bq + cq^2). Foley, van Dam et al. 16.1; OpenGL 2.1, 2.14.1.
    Expr fn attenuation(a: Positive, b: Positive, c: Positive, q: Positive) -> Number =
        attenuation(a, b, c, q);

    /// What ends a light at the range r: max(0, 1 - (q/r)^4)^2. Karis 2013.
    Inline fn window(q: Positive, r: Positive) -> Number = window(q, r, T::ONE.above(T::ZERO));

    /// The same without the square: KHR_lights_punctual.
    Inline fn window_gltf(q: Positive, r: Positive) -> Number =
        window(q, r, T::ZERO.above(T::ZERO));

    /// t^2, where t rises from 0 at the cosine of the outer edge to 1 at that of the inner. KHR_lights_punctual.
    Inline fn beam(cosine: Cosine, inner: Cosine, outer: Cosine) -> Number =
        beam(cosine, [inner, outer], T::ZERO.above(T::ZERO));

    /// The same with t^2(3 - 2t). POV-Ray 3.7.
    Inline fn beam_smoothstep(cosine: Cosine, inner: Cosine, outer: Cosine) -> Number =
        beam(cosine, [inner, outer], inner.above(outer));

    /// The factor of a spot's cone, given the cosines of its inner and its outer half-angle.
    Expr fn cone(axis: Unit, l: Unit, cosines: Cosines) -> Number = cone(cosines).factor(axis, l);

    /// The same with a smoothstep between the edges.
    Expr fn cone_smoothstep(axis: Unit, l: Unit, cosines: Cosines) -> Number =
        cone(cosines).smoothstep().factor(axis, l);

    /// What dims a light after the distance q: its attenuation, at most its limit, and the window of its range.
    Expr fn falloff(light: Light, q: Positive) -> Number = light.falloff(q);

    /// The factor of a spot's cone, by the cosine between its axis and -L.
    Expr fn spot(light: Light, cosine: Cosine) -> Number = light.spot(cosine);

    /// What arrives at the point p: L, the distance q and I. Foley, van Dam et al. 16.1.
    Expr fn arrival(light: Light, p: Vector) -> Arrival =
        light.each(p, |light| light.arrival());

    /// What one light adds by Lambert's model: I k_d max(0, N.L).
    Expr fn shade_lambert(n: Unit, material: Material, light: Arrival) -> Color =
        shade::lambert(n, &material, Rgb::BLACK, arrived(&light)).diffuse;

    /// What one light adds by Phong's model: I (k_d N.L + k_s max(0, R.V)^m), where N.L > 0. Phong 1975.
    Expr fn shade_phong(n: Unit, v: Unit, material: Material, light: Arrival) -> Color =
        both(shade::phong(n, v, &material, Rgb::BLACK, arrived(&light)));

    /// What one light adds by Blinn and Phong's model: I (k_d N.L + k_s max(0, N.H)^m), where N.L > 0. Blinn 1977.
    Expr fn shade_blinn_phong(n: Unit, v: Unit, material: Material, light: Arrival) -> Color =
        both(shade::blinn_phong(n, v, &material, Rgb::BLACK, arrived(&light)));

    /// The sums over lights after one more, by Lambert's model. A light from behind adds nothing and costs no root.
    Expr fn add_lambert(sums: Sums, n: Unit, light: Light, p: Vector) -> Sums =
        light.each(p, |light| added(&sums, shade::lambert(n, &white(T::ZERO), Rgb::BLACK, [light])));

    /// The same by Phong's model.
    Expr fn add_phong(sums: Sums, n: Unit, v: Unit, m: Positive, light: Light, p: Vector) -> Sums =
        light.each(p, |light| added(&sums, shade::phong(n, v, &white(m), Rgb::BLACK, [light])));

    /// The same by Blinn and Phong's model.
    Expr fn add_blinn_phong(sums: Sums, n: Unit, v: Unit, m: Positive, light: Light, p: Vector) -> Sums =
        light.each(p, |light| added(&sums, shade::blinn_phong(n, v, &white(m), Rgb::BLACK, [light])));

    /// The light that the point reflects: k_a I_a + k_d times the diffuse sum + k_s times the specular one.
    Expr fn total(sums: Sums, material: Material, i_a: Color) -> Color = {
        let diffuse = sums.diffuse.total() * material.k_d;
        let specular = sums.specular.total() * material.k_s;
        let ambient = term::ambient(material.k_a, i_a);
        Shaded { ambient, diffuse, specular }.total()
    };

    /// The normal of the plane ax + by + cz + d = 0: (a, b, c)/|(a, b, c)|. Foley, van Dam et al. 11.1.3.
    Expr fn normal_plane(a: Number, b: Number, c: Number) -> Unit = normal::plane(a, b, c);

    /// The normal of a triangle, counter-clockwise: (v2 - v1) x (v3 - v1), length 1. Foley, van Dam et al. 11.1.3.
    Expr fn normal_triangle(v1: Vector, v2: Vector, v3: Vector) -> Unit =
        normal::triangle(v1, v2, v3);

    /// The normal of a sphere: (p - center)/|p - center|. Foley, van Dam et al. 15.10.1.
    Expr fn normal_sphere(center: Vector, p: Vector) -> Unit = normal::sphere(center, p);

    /// The normal of f(p) = 0 by the gradient of f, length 1. Foley, van Dam et al. 11.4.
    Expr fn normal_from_gradient(gradient: Vector) -> Unit = normal::from_gradient(gradient);

    /// The normal of s(u, v): ds/du x ds/dv, length 1. Foley, van Dam et al. 11.3.4.
    Expr fn normal_from_tangents(s_u: Vector, s_v: Vector) -> Unit =
        normal::from_tangents(s_u, s_v);

    /// N toward the eye: N if F.V >= 0, else -N, where F is the normal of the face. GLSL 4.60, 8.5.
    Expr fn normal_facing(n: Unit, v: Unit, f: Unit) -> Unit = normal::facing(n, v, f);

    /// A normal transformed by the matrix of the columns a, b, c: cof(M) N, length 1. Lengyel 2024.
    Expr fn normal_transformed(n: Unit, a: Vector, b: Vector, c: Vector) -> Unit =
        normal::transformed(n, [a, b, c]);

    /// A triangle's normal times its angle at v1, to be summed over a mesh. Thuermer and Wuethrich 1998.
    Expr fn normal_corner(v1: Vector, v2: Vector, v3: Vector) -> Vector =
        normal::corner(v1, v2, v3);

    /// The tangent of a triangle and its handedness, by the texture coordinates of its vertices. Lengyel 2001.
    Expr fn normal_tangent(v1: Vector, v2: Vector, v3: Vector, uv1: Pair, uv2: Pair, uv3: Pair) -> Tangent = {
        let tangent = normal::tangent([v1, v2, v3], [uv1, uv2, uv3]);
        let (t, h) = tangent.map_or((Vec3::ZERO, T::ZERO), |(t, h)| (*t, h));
        Tangent { t: UnitVec3::assume_unit(t), h }
    };

    /// A normal from a map: x t + y b + z N, length 1. glTF 2.0, 3.7.2.1.
    Expr fn normal_mapped(n: Unit, tangent: Vector, h: Number, s: Vector) -> Unit =
        normal::mapped(n, tangent, h, s);
}
