//! The largest error of each function.

use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;
use shading::{
    Elementary, Exponent, IncidentLight, Material, PointLight, Real, Rgb, Shaded, UnitVec3, Vec3,
    attenuation, half_vector, normal, reflection, shade, term,
};

use crate::many_digits::{self as exact, Number, Vector, number, vector};
use crate::srgb;
use crate::support::number::Float;

/// A line of the table.
pub struct Row {
    pub function: &'static str,
    pub unit: &'static str,
    pub error: f64,
}

/// How many inputs each function is measured on.
const INPUTS: usize = 3000;

const OF_RESULT: &str = "of the result";
const OF_ONE: &str = "of 1";
const CONDITIONED: &str = "of 1, times the conditioning";
const OF_LIGHT: &str = "of all the light";
const OF_LEVEL: &str = "levels";

pub fn rows<T: Float>() -> Vec<Row> {
    let row = |function, unit, error| Row {
        function,
        unit,
        error,
    };
    vec![
        row("`Vec3::unit`, `normal::plane`", OF_RESULT, unit::<T>()),
        row("`normal::sphere`", OF_RESULT, sphere::<T>()),
        row("`normal::triangle`", CONDITIONED, triangle::<T>()),
        row("`normal::implicit`, a torus", OF_ONE, implicit::<T>()),
        row(
            "`normal::parametric`, a paraboloid",
            OF_ONE,
            parametric::<T>(),
        ),
        row("`reflection`", OF_ONE, mirrored::<T>()),
        row("`half_vector`", OF_RESULT, half::<T>()),
        row("`lambert`", OF_ONE, diffuse::<T>()),
        row(
            "`phong`, m = 1",
            OF_ONE,
            highlights::<T, _>(term::phong, 1_u32, 1.0),
        ),
        row(
            "`phong`, m = 32",
            OF_ONE,
            highlights::<T, _>(term::phong, 32_u32, 32.0),
        ),
        row(
            "`phong`, m = 32.5",
            OF_ONE,
            highlights::<T, _>(term::phong, T::of(32.5), 32.5),
        ),
        row(
            "`blinn`, m = 128",
            OF_ONE,
            highlights::<T, _>(term::blinn, 128_u32, 128.0),
        ),
        row(
            "`blinn`, m = 128.5",
            OF_ONE,
            highlights::<T, _>(term::blinn, T::of(128.5), 128.5),
        ),
        row(
            "`Exponent::raise`, m = 32",
            OF_RESULT,
            power::<T, _>(32_u32, 32.0, true),
        ),
        row(
            "`Exponent::raise`, m = 32.5",
            OF_ONE,
            power::<T, _>(T::of(32.5), 32.5, false),
        ),
        row(
            "`Exponent::raise`, m = 1000",
            OF_RESULT,
            power::<T, _>(1000_u32, 1000.0, true),
        ),
        row(
            "`Exponent::raise`, m = 1000.5",
            OF_ONE,
            power::<T, _>(T::of(1000.5), 1000.5, false),
        ),
        row(
            "`phong_normalization`, real m",
            OF_RESULT,
            normalization::<T, _>(term::phong_normalization, |m| {
                (m + number(2.0)) / (number(2.0) * exact::pi())
            }),
        ),
        row(
            "`blinn_normalization`, real m",
            OF_RESULT,
            normalization::<T, _>(term::blinn_normalization, |m| {
                let power = number(0.5).powf(&(m / number(2.0)));
                let product = (m + number(2.0)) * (m + number(4.0));
                product / (number(8.0) * exact::pi() * (power + m))
            }),
        ),
        row("`attenuation`", OF_RESULT, attenuated::<T>()),
        row("`PointLight::at`, direction", OF_RESULT, lamp::<T>()[0]),
        row("`PointLight::at`, intensity", OF_RESULT, lamp::<T>()[1]),
        row(
            "`shade::lambert`, four lights",
            OF_LIGHT,
            shaded::<T>(Model::Lambert),
        ),
        row(
            "`shade::phong`, m = 32",
            OF_LIGHT,
            shaded::<T>(Model::Phong),
        ),
        row(
            "`shade::blinn_phong`, m = 32",
            OF_LIGHT,
            shaded::<T>(Model::BlinnPhong),
        ),
    ]
}

/// The largest of the errors on the inputs, which are the same in each run; rounded up to a tenth.
fn largest<S: Strategy>(inputs: S, error: impl Fn(S::Value) -> f64) -> f64 {
    let mut runner = TestRunner::deterministic();
    let errors = (0..INPUTS).map(|_| {
        let tree = inputs.new_tree(&mut runner).expect("no input is refused");
        error(tree.current())
    });
    (errors.fold(0.0, f64::max) * 10.0).ceil() / 10.0
}

/// |computed − exact| in units in the last place of `of`, those of the type T.
fn error<T: Float>(computed: T, exact: &Number, of: &Number) -> f64 {
    let difference = (number(computed.to_f64()) - exact).to_f64().value();
    // the power of two below: the exponent without the other bits
    let power_of_two = f64::from_bits(of.to_f64().value().to_bits() & f64::INFINITY.to_bits());
    let last_place = 2.0 * T::U * power_of_two;
    (difference / last_place).abs()
}

/// The largest error of a component, in units in the last place of 1.
fn of_one<T: Float>(computed: UnitVec3<T>, exact: &Vector) -> f64 {
    let one = number(1.0);
    let components = <[T; 3]>::from(computed).into_iter().zip(exact);
    components
        .map(|(c, exact)| error(c, exact, &one))
        .fold(0.0, f64::max)
}

/// The largest error of a component, in units in its last place.
fn of_result<T: Float>(computed: UnitVec3<T>, exact: &Vector) -> f64 {
    let components = <[T; 3]>::from(computed).into_iter().zip(exact);
    components
        .map(|(c, exact)| error(c, exact, exact))
        .fold(0.0, f64::max)
}

/// A point within a cube of side 2, off its middle.
fn point<T: Float>() -> impl Strategy<Value = Vec3<T>> {
    let coordinate = || -1.0..1.0;
    [coordinate(), coordinate(), coordinate()]
        .prop_filter("next to 0", |p: &[f64; 3]| p.iter().all(|c| c.abs() > 1e-3))
        .prop_map(|p| Vec3::from(p.map(T::of)))
}

/// A direction, by correctly rounded operations.
fn direction<T: Float>() -> impl Strategy<Value = UnitVec3<T>> {
    point().prop_map(toward)
}

fn toward<T: Float>(v: Vec3<T>) -> UnitVec3<T> {
    let v = <[T; 3]>::from(v).map(T::to_f64);
    let length = v.iter().map(|c| c * c).sum::<f64>().sqrt();
    UnitVec3::assume_unit(Vec3::from(v.map(|c| T::of(c / length))))
}

/// Two directions near each other, as those of a highlight are.
fn close<T: Float>() -> impl Strategy<Value = [UnitVec3<T>; 2]> {
    (direction(), point(), 0.0..0.5)
        .prop_map(|(a, aside, far): (UnitVec3<T>, _, f64)| [a, toward(*a + aside * T::of(far))])
}

fn unit<T: Float>() -> f64 {
    largest(point::<T>(), |v| {
        of_result(v.unit().expect("not 0"), &exact::unit(&vector(v)))
    })
}

fn sphere<T: Float>() -> f64 {
    largest([point::<T>(), point()], |[center, p]| {
        let outward = exact::subtract(&vector(p), &vector(center));
        of_result(
            normal::sphere(center, p).expect("not the center"),
            &exact::unit(&outward),
        )
    })
}

fn triangle<T: Float>() -> f64 {
    largest([point::<T>(), point(), point()], |[a, b, c]| {
        let [ab, ac] = [b, c].map(|p| exact::subtract(&vector(p), &vector(a)));
        let cross = exact::cross(&ab, &ac);
        let conditioning = exact::length(&ab) * exact::length(&ac) / exact::length(&cross);
        let n = normal::triangle(a, b, c).expect("a triangle");
        of_one(n, &exact::unit(&cross)) / conditioning.to_f64().value()
    })
}

/// (√(x² + y²) − R)² + z² − r², whose gradient is along ((√(x² + y²) − R)/√(x² + y²) (x, y), z).
fn implicit<T: Float>() -> f64 {
    fn torus<T: Real>(p: Vec3<T>) -> T {
        let aside = (p.x * p.x + p.y * p.y).sqrt() - T::of(2.0);
        aside * aside + p.z * p.z - T::of(0.25)
    }
    largest(point::<T>(), |p| {
        let [x, y, z] = vector(p);
        let distance = (&x * &x + &y * &y).sqrt();
        let aside = (&distance - number(2.0)) / &distance;
        let gradient = [x * &aside, y * &aside, z];
        of_one(
            normal::implicit(torus, p).expect("smooth"),
            &exact::unit(&gradient),
        )
    })
}

/// (u, v, u² + uv + v²): its tangents are (1, 0, 2u + v) and (0, 1, u + 2v).
fn parametric<T: Float>() -> f64 {
    fn paraboloid<T: Elementary>(u: T, v: T) -> Vec3<T> {
        Vec3::new(u, v, u * u + u * v + v * v)
    }
    largest(point::<T>(), |p| {
        let [u, v, _] = vector(p);
        let across = [-(&u + &u + &v), -(&u + &v + &v), number(1.0)];
        let n = normal::parametric(paraboloid, p.x, p.y).expect("smooth");
        of_one(n, &exact::unit(&across))
    })
}

fn mirrored<T: Float>() -> f64 {
    largest([direction::<T>(), direction()], |[n, l]| {
        of_one(reflection(n, l), &exact::reflection(&vector(n), &vector(l)))
    })
}

fn half<T: Float>() -> f64 {
    largest([direction::<T>(), direction()], |[l, v]| {
        let h = half_vector(l, v).expect("not opposite");
        of_result(h, &exact::half_vector(&vector(l), &vector(v)))
    })
}

fn diffuse<T: Float>() -> f64 {
    largest([direction::<T>(), direction()], |[n, l]| {
        let cosine = exact::positive_part(exact::dot(&vector(n), &vector(l)));
        error(term::lambert(n, l), &cosine, &number(1.0))
    })
}

/// Phong's of R and V, or Blinn's of N and H.
fn highlights<T: Float, M: Exponent<T>>(
    factor: fn(UnitVec3<T>, UnitVec3<T>, M) -> T,
    m: M,
    exact_m: f64,
) -> f64 {
    largest(close::<T>(), |[a, b]| {
        let expected = exact::highlight(exact::dot(&vector(a), &vector(b)), exact_m);
        error(factor(a, b, m), &expected, &number(1.0))
    })
}

/// The power of a cosine so near to 1 that no power is below 2⁻¹⁰⁰.
fn power<T: Float, M: Exponent<T>>(m: M, exact_m: f64, relative: bool) -> f64 {
    let least = number(2.0).powf(&number(-100.0 / exact_m)).to_f64();
    largest((least.value()..1.0).prop_map(T::of), |cosine| {
        let expected = number(cosine.to_f64()).powf(&number(exact_m));
        let one = number(1.0);
        error(
            m.raise(cosine),
            &expected,
            if relative { &expected } else { &one },
        )
    })
}

/// A factor of m, from 0 to 1000; often small.
fn normalization<T: Float, F: Fn(&Number) -> Number>(factor: fn(T) -> T, formula: F) -> f64 {
    let m = prop_oneof![0.0..10.0, 0.0..1000.0].prop_map(T::of);
    largest(m, |m| {
        let expected = formula(&number(m.to_f64()));
        error(factor(m), &expected, &expected)
    })
}

/// The encodings of `f32`: every byte decoded, and random light encoded.
pub fn encodings() -> [Row; 3] {
    let decoded = (0..=255_u8).map(|byte| {
        let exact = srgb::decoded(&(srgb::number(byte.into()) / srgb::number(255.0)));
        let exact = exact.with_precision(150).value();
        error(Rgb::from_srgb8([byte; 3]).r, &exact, &exact)
    });
    let decoded = (decoded.fold(0.0, f64::max) * 10.0).ceil() / 10.0;
    let encoded = |highest: f64, level: fn(Rgb) -> f64| {
        let light = prop_oneof![0.0..=1.0_f32, 0.0..=0.01_f32];
        largest(light, |light| {
            let exact = srgb::encoded(&srgb::number(light.into())).to_f64().value();
            (level(Rgb::gray(light)) - highest * exact).abs()
        })
    };
    let bytes = encoded(255.0, |light| light.to_srgb8()[0].into());
    let red = encoded(31.0, |light| (light.to_rgb565() >> 11).into());
    let green = encoded(63.0, |light| (light.to_rgb565() >> 5 & 63).into());
    let row = |function, unit, error| Row {
        function,
        unit,
        error,
    };
    [
        row("`Rgb::from_srgb8`", OF_RESULT, decoded),
        row("`Rgb::to_srgb8`", OF_LEVEL, bytes),
        row("`Rgb::to_rgb565`", OF_LEVEL, red.max(green)),
    ]
}

/// The coefficients a, b, c.
fn coefficients<T: Float>() -> impl Strategy<Value = [T; 3]> {
    let coefficient = || (0.01..2.0).prop_map(T::of);
    [coefficient(), coefficient(), coefficient()]
}

fn attenuated<T: Float>() -> f64 {
    largest(
        (coefficients::<T>(), (0.0..100.0).prop_map(T::of)),
        |([a, b, c], q)| {
            let expected = exact::attenuation(&vector([a, b, c]), &number(q.to_f64()));
            error(attenuation(a, b, c, q), &expected, &expected)
        },
    )
}

/// The errors of the direction and of the intensity, with white light.
fn lamp<T: Float>() -> [f64; 2] {
    let inputs = || (coefficients::<T>(), point::<T>(), point::<T>());
    let at = |([a, b, c], position, p): ([T; 3], Vec3<T>, Vec3<T>)| {
        let attenuation = T::new_attenuation(a, b, c).expect("positive");
        let incident = PointLight {
            position,
            intensity: Rgb::WHITE,
            attenuation,
        }
        .at(p);
        let way = exact::subtract(&vector(position), &vector(p));
        let factor = exact::attenuation(&vector([a, b, c]), &exact::length(&way));
        [
            of_result(incident.l, &exact::unit(&way)),
            error(incident.intensity.r, &factor, &factor),
        ]
    };
    [
        largest(inputs(), |input| at(input)[0]),
        largest(inputs(), |input| at(input)[1]),
    ]
}

#[derive(Clone, Copy)]
enum Model {
    Lambert,
    Phong,
    BlinnPhong,
}

/// A channel of the total under four lights, in units in the last place of k_a I_a + Σ I (k_d + k_s).
fn shaded<T: Float>(model: Model) -> f64 {
    let share = || (0.0..1.0).prop_map(T::of);
    let factors = [share(), share(), share(), share()];
    let light = || (direction::<T>(), share());
    let lights = [light(), light(), light(), light()];
    largest(
        (direction::<T>(), direction::<T>(), factors, lights),
        |(n, v, factors, lights)| {
            let [k_a, k_d, k_s, i_a] = factors;
            let [k_a, k_d, k_s, ambient] = [k_a, k_d, k_s, i_a].map(Rgb::gray);
            let material = Material {
                k_a,
                k_d,
                k_s,
                m: 32_u32,
            };
            // the highlight has an edge on the horizon
            let lights = lights
                .into_iter()
                .filter(|(l, _)| n.dot(*l).to_f64().abs() > 1e-3);
            let incident = lights.clone().map(|(l, i)| IncidentLight {
                l,
                intensity: Rgb::gray(i),
            });
            let computed: Shaded<T> = match model {
                Model::Lambert => shade::lambert(n, &material, ambient, incident),
                Model::Phong => shade::phong(n, v, &material, ambient, incident),
                Model::BlinnPhong => shade::blinn_phong(n, v, &material, ambient, incident),
            };

            let [k_a, k_d, k_s, i_a] = factors.map(|k| number(k.to_f64()));
            let (n, v) = (vector(n), vector(v));
            let mut sum = &k_a * &i_a;
            let mut all = sum.clone();
            for (l, i) in lights {
                let (l, i) = (vector(l), number(i.to_f64()));
                let cosine = exact::dot(&n, &l);
                all += &i * (&k_d + &k_s);
                if cosine > Number::ZERO {
                    let highlight = match model {
                        Model::Lambert => number(0.0),
                        Model::Phong => {
                            exact::highlight(exact::dot(&exact::reflection(&n, &l), &v), 32.0)
                        }
                        Model::BlinnPhong => {
                            exact::highlight(exact::dot(&n, &exact::half_vector(&l, &v)), 32.0)
                        }
                    };
                    sum += i * (&k_d * cosine + &k_s * highlight);
                }
            }
            error(computed.total().r, &sum, &all)
        },
    )
}
