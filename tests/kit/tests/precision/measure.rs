//! The error of each function for an input made from some numbers.

use shading::{
    Attenuation, Cone, DirectionalLight, Elementary, IncidentLight, Lobe, Material, PointLight,
    Real, Rgb, Shaded, UnitVec3, Vec3, attenuation, half_vector, normal, reflection, shade, term,
};

use dashu_float::ops::Abs;

use crate::many_digits::{self as exact, Number, Vector, number, vector};
use crate::search::Numbers;
use kit::Float;

/// |computed − exact| in units in the last place of `of`, in the type T.
fn error<T: Float>(computed: T, exact: &Number, of: &Number) -> f64 {
    let difference = (number(computed.double()) - exact).to_f64().value();
    // the power of two at or below it: the exponent without the other bits
    let power_of_two = f64::from_bits(of.to_f64().value().to_bits() & f64::INFINITY.to_bits());
    let last_place = 2.0 * T::U * power_of_two;
    (difference / last_place).abs()
}

/// The largest error of a component in units in the last place of 1.
fn of_one<T: Float>(computed: UnitVec3<T>, exact: &Vector) -> f64 {
    let one = number(1.0);
    let components = <[T; 3]>::from(computed).into_iter().zip(exact);
    components
        .map(|(c, exact)| error(c, exact, &one))
        .fold(0.0, f64::max)
}

/// The largest error of a component in units in its own last place.
fn of_result<T: Float>(computed: UnitVec3<T>, exact: &Vector) -> f64 {
    let components = <[T; 3]>::from(computed).into_iter().zip(exact);
    components
        .map(|(c, exact)| error(c, exact, exact))
        .fold(0.0, f64::max)
}

/// A number within [−1, 1] whose size is between 2⁻⁴⁰ and 1: a quarter of them are small.
fn of_any_size(x: f64) -> f64 {
    let below = 0.25 - x.abs();
    let size = x.abs().max(0.125) * two_to(-150.0 * below.max(0.0));
    size.copysign(x)
}

/// 2ˣ for x rounded to an integer, without a function whose last digits differ between machines.
#[allow(clippy::cast_possible_truncation)]
fn two_to(x: f64) -> f64 {
    2.0_f64.powi(x.round() as i32)
}

/// A point in a cube of side 2; none of its coordinates is 0.
fn point<T: Float>(numbers: &mut Numbers) -> Vec3<T> {
    let mut coordinate = || T::of(of_any_size(numbers.next()));
    Vec3::new(coordinate(), coordinate(), coordinate())
}

/// A direction computed with correctly rounded operations.
fn direction<T: Float>(numbers: &mut Numbers) -> UnitVec3<T> {
    toward(point(numbers))
}

fn toward<T: Float>(v: Vec3<T>) -> UnitVec3<T> {
    let v = <[T; 3]>::from(v).map(T::double);
    let length = v.iter().map(|c| c * c).sum::<f64>().sqrt();
    UnitVec3::assume_unit(Vec3::from(v.map(|c| T::of(c / length))))
}

pub fn unit<T: Float>(numbers: &mut Numbers) -> f64 {
    let v = point::<T>(numbers);
    of_result(v.unit().expect("not 0"), &exact::unit(&vector(v)))
}

pub fn length<T: Float>(numbers: &mut Numbers) -> f64 {
    let v = point::<T>(numbers);
    let expected = exact::length(&vector(v));
    error(v.length(), &expected, &expected)
}

pub fn sphere<T: Float>(numbers: &mut Numbers) -> f64 {
    let [center, p] = [point::<T>(numbers), point(numbers)];
    let outward = exact::subtract(&vector(p), &vector(center));
    normal::sphere(center, p).map_or(0.0, |n| of_result(n, &exact::unit(&outward)))
}

pub fn triangle<T: Float>(numbers: &mut Numbers) -> f64 {
    let [a, b, c] = [point::<T>(numbers), point(numbers), point(numbers)];
    let [ab, ac] = [b, c].map(|p| exact::subtract(&vector(p), &vector(a)));
    let cross = exact::cross(&ab, &ac);
    let area = exact::length(&cross);
    if area == Number::ZERO {
        return 0.0;
    }
    let conditioning = exact::length(&ab) * exact::length(&ac) / area;
    normal::triangle(a, b, c).map_or(0.0, |n| {
        of_one(n, &exact::unit(&cross)) / conditioning.to_f64().value()
    })
}

/// (√(x² + y²) − R)² + z² − r². Its gradient is along ((√(x² + y²) − R)/√(x² + y²) (x, y), z).
pub fn implicit<T: Float>(numbers: &mut Numbers) -> f64 {
    fn torus<T: Real>(p: Vec3<T>) -> T {
        let aside = (p.x * p.x + p.y * p.y).sqrt() - T::of(2.0);
        aside * aside + p.z * p.z - T::of(0.25)
    }
    let p = point::<T>(numbers);
    let [x, y, z] = vector(p);
    let distance = (&x * &x + &y * &y).sqrt();
    let aside = (&distance - number(2.0)) / &distance;
    let gradient = [x * &aside, y * &aside, z];
    let n = normal::implicit(torus, p).expect("smooth");
    of_one(n, &exact::unit(&gradient))
}

/// (u, v, u² + uv + v²), whose tangents are (1, 0, 2u + v) and (0, 1, u + 2v).
pub fn parametric<T: Float>(numbers: &mut Numbers) -> f64 {
    fn paraboloid<T: Elementary>(u: T, v: T) -> Vec3<T> {
        Vec3::new(u, v, u * u + u * v + v * v)
    }
    let p = point::<T>(numbers);
    let [u, v, _] = vector(p);
    let across = [-(&u + &u + &v), -(&u + &v + &v), number(1.0)];
    let n = normal::parametric(paraboloid, p.x, p.y).expect("smooth");
    of_one(n, &exact::unit(&across))
}

pub fn transformed<T: Float>(numbers: &mut Numbers) -> f64 {
    let n = direction::<T>(numbers);
    let columns = [point::<T>(numbers), point(numbers), point(numbers)];
    normal::transformed(n, columns).map_or(0.0, |transformed| {
        let (n, columns) = (vector(n), columns.map(vector));
        let expected = exact::unit(&exact::cofactors(&columns, &n));
        of_one(transformed, &expected) / exact::conditioning(&columns, &n)
    })
}

/// A triangle's share, whose length is the angle.
pub fn corner<T: Float>(numbers: &mut Numbers) -> f64 {
    let [a, b, c] = [point::<T>(numbers), point(numbers), point(numbers)];
    let [ab, ac] = [b, c].map(|p| exact::subtract(&vector(p), &vector(a)));
    let cross = exact::cross(&ab, &ac);
    let area = exact::length(&cross);
    if area == Number::ZERO {
        return 0.0;
    }
    let angle = exact::angle(&ab, &ac);
    let conditioning = exact::length(&ab) * exact::length(&ac) / area;
    let share = exact::scale(&exact::unit(&cross), &angle);
    let computed = <[T; 3]>::from(normal::corner(a, b, c));
    let errors = computed.into_iter().zip(&share);
    let largest = errors
        .map(|(c, exact)| error(c, exact, &angle))
        .fold(0.0, f64::max);
    largest / conditioning.to_f64().value()
}

/// The conditioning is (|p₂ − p₁||y₃ − y₁| + |p₃ − p₁||y₂ − y₁|)/|d T|.
pub fn tangent<T: Float>(numbers: &mut Numbers) -> f64 {
    let corners = [point::<T>(numbers), point(numbers), point(numbers)];
    let [x, y] = [point::<T>(numbers), point(numbers)].map(<[T; 3]>::from);
    let map = [[x[0], y[0]], [x[1], y[1]], [x[2], y[2]]];
    let [a, b, c] = corners.map(vector);
    let [e2, e3] = [b, c].map(|p| exact::subtract(&p, &a));
    let [[x2, x3], [y2, y3]] = [x, y].map(|x| {
        let [x1, x2, x3] = x.map(|x| number(x.double()));
        [x2 - &x1, x3 - x1]
    });
    let d = x2 * &y3 - x3 * &y2;
    let t = exact::subtract(&exact::scale(&e2, &y3), &exact::scale(&e3, &y2));
    let length = exact::length(&t);
    // the sign of d must be beyond rounding
    if length == Number::ZERO || d.to_f64().value().abs() < 1e-5 {
        return 0.0;
    }
    let lengths = exact::length(&e2) * y3.abs() + exact::length(&e3) * y2.abs();
    let side = number(1.0_f64.copysign(d.to_f64().value()));
    let expected = exact::scale(&exact::unit(&t), &side);
    normal::tangent(corners, map).map_or(0.0, |(t, _)| {
        of_one(t, &expected) / (lengths / length).to_f64().value()
    })
}

/// The conditioning is |N||T|/|N × T|.
pub fn mapped<T: Float>(numbers: &mut Numbers) -> f64 {
    let (n, tangent) = (direction::<T>(numbers), point::<T>(numbers));
    let sample = direction::<T>(numbers);
    let h = if numbers.next() > 0.0 { 1.0 } else { -1.0 };
    normal::mapped(n, tangent, T::of(h), *sample).map_or(0.0, |mapped| {
        let [n, tangent, sample] = [*n, tangent, *sample].map(vector);
        let conditioning = exact::length(&tangent) / exact::length(&exact::cross(&n, &tangent));
        let expected = exact::mapped(&n, &tangent, &number(h), &sample);
        of_one(mapped, &exact::unit(&expected)) / conditioning.to_f64().value()
    })
}

pub fn mirrored<T: Float>(numbers: &mut Numbers) -> f64 {
    let [n, l] = [direction::<T>(numbers), direction(numbers)];
    of_one(reflection(n, l), &exact::reflection(&vector(n), &vector(l)))
}

pub fn half<T: Float>(numbers: &mut Numbers) -> f64 {
    let [l, v] = [direction::<T>(numbers), direction(numbers)];
    let (exact_l, exact_v) = (vector(l), vector(v));
    half_vector(l, v).map_or(0.0, |h| {
        of_result(h, &exact::half_vector(&exact_l, &exact_v))
    })
}

pub fn diffuse<T: Float>(numbers: &mut Numbers) -> f64 {
    let [n, l] = [direction::<T>(numbers), direction(numbers)];
    let cosine = exact::positive_part(exact::dot(&vector(n), &vector(l)));
    error(term::lambert(n, l), &cosine, &number(1.0))
}

/// Phong's factor of R and V, or Blinn's of N and H, for two directions near each other.
pub fn highlight<T: Float, M: Lobe<T>>(
    factor: fn(UnitVec3<T>, UnitVec3<T>, M) -> T,
    m: M,
    exact_m: f64,
) -> impl Fn(&mut Numbers) -> f64 {
    move |numbers| {
        let a = direction::<T>(numbers);
        let aside = point(numbers) * T::of(numbers.within(0.0, 0.5));
        let b = toward(*a + aside);
        let cosine = exact::dot(&vector(a), &vector(b));
        let expected = exact::highlight(cosine, exact_m);
        error(factor(a, b, m), &expected, &number(1.0))
    }
}

/// An integer power of a cosine so near to 1 that no power is below 2⁻¹⁰⁰.
pub fn whole_power<T: Float>(m: u32, least: f64) -> impl Fn(&mut Numbers) -> f64 {
    move |numbers| {
        let cosine = T::of(numbers.within(least, 1.0));
        let expected = exact::power(&number(cosine.double()), f64::from(m));
        error(m.raise(cosine), &expected, &expected)
    }
}

/// A real power of such a cosine.
pub fn real_power<T: Float>(m: f64, least: f64) -> impl Fn(&mut Numbers) -> f64 {
    move |numbers| {
        let cosine = T::of(numbers.within(least, 1.0));
        let expected = exact::power(&number(cosine.double()), m);
        error(T::of(m).raise(cosine), &expected, &number(1.0))
    }
}

/// A factor that depends on m, for m from 0 to 1000.
pub fn normalization<T: Float>(
    factor: fn(T) -> T,
    formula: fn(&Number) -> Number,
) -> impl Fn(&mut Numbers) -> f64 {
    move |numbers| {
        let m = T::of(numbers.within(0.0, 1000.0));
        let expected = formula(&number(m.double()));
        error(factor(m), &expected, &expected)
    }
}

pub fn phong_normalization(m: &Number) -> Number {
    (m + number(2.0)) / (number(2.0) * exact::pi())
}

pub fn blinn_normalization(m: &Number) -> Number {
    let power = number(0.5).powf(&(m / number(2.0)));
    (m + number(2.0)) * (m + number(4.0)) / (number(8.0) * exact::pi() * (power + m))
}

/// The coefficients a, b, c, often 0 but not all of them.
fn coefficients<T: Float>(numbers: &mut Numbers) -> [T; 3] {
    let [a, b, c] = [(); 3].map(|()| T::of(2.0 * of_any_size(numbers.next()).max(0.0)));
    let is_nothing = a.double() + b.double() + c.double() == 0.0;
    [if is_nothing { T::ONE } else { a }, b, c]
}

pub fn attenuated<T: Float>(numbers: &mut Numbers) -> f64 {
    let [a, b, c] = coefficients::<T>(numbers);
    let q = T::of(100.0 * of_any_size(numbers.next()).abs());
    let expected = exact::attenuation(&vector([a, b, c]), &number(q.double()));
    error(attenuation(a, b, c, q), &expected, &expected)
}

/// The factor of a cone whose edge is 0.01 to 1 wide, times the width.
pub fn soft_cone<T: Float>(is_smooth: bool) -> impl Fn(&mut Numbers) -> f64 {
    move |numbers| {
        let [axis, l] = [direction::<T>(numbers), direction(numbers)];
        let outer = numbers.within(-1.0, 0.9);
        let inner = outer + numbers.within(0.01, f64::min(1.0, 1.0 - outer));
        let cone = Cone::from_cosines(T::of(inner), T::of(outer)).expect("cosines");
        let cosine = -exact::dot(&vector(axis), &vector(l));
        let [inner, outer] = cone.cosines().map(|cosine| number(cosine.double()));
        let width = inner - &outer;
        let t = exact::clamped((cosine - outer) / &width);
        let (cone, expected) = if is_smooth {
            (cone.smoothstep(), &t * &t * (number(3.0) - &t - &t))
        } else {
            (cone, &t * &t)
        };
        error(cone.factor(axis, l), &expected, &number(1.0)) * width.to_f64().value()
    }
}

/// The attenuation up to the range, where the light ends.
pub fn ranged<T: Float>(is_squared: bool) -> impl Fn(&mut Numbers) -> f64 {
    move |numbers| {
        let [a, b, c] = coefficients::<T>(numbers);
        let free = Attenuation::new(a, b, c).expect("positive");
        let r = T::of(numbers.within(0.1, 100.0));
        let q = r * T::of(of_any_size(numbers.next()).abs());
        let share = number(q.double()) / number(r.double());
        let window = exact::clamped(number(1.0) - share.powi(4.into()));
        let free_factor = exact::attenuation(&vector([a, b, c]), &number(q.double()));
        let (ranged, expected) = if is_squared {
            (free.within(r), &free_factor * &window * &window)
        } else {
            (free.within_gltf(r), &free_factor * &window)
        };
        error(ranged.expect("a range").at(q), &expected, &free_factor)
    }
}

/// A lamp, the vector to it, and the light that arrives; `None` at the lamp.
fn lamp<T: Float>(numbers: &mut Numbers) -> Option<(PointLight<T>, Vector, IncidentLight<T>)> {
    let [a, b, c] = coefficients(numbers);
    let [position, p] = [point(numbers), point(numbers)];
    let lamp = PointLight {
        position,
        intensity: Rgb::from([(); 3].map(|()| T::of(numbers.within(0.01, 4.0)))),
        attenuation: Attenuation::new(a, b, c)?,
    };
    let way = exact::subtract(&vector(position), &vector(p));
    (position != p).then(|| (lamp, way, lamp.at(p)))
}

pub fn lamp_direction<T: Float>(numbers: &mut Numbers) -> f64 {
    lamp::<T>(numbers).map_or(0.0, |(_, way, incident)| {
        of_result(incident.l(), &exact::unit(&way))
    })
}

pub fn lamp_intensity<T: Float>(numbers: &mut Numbers) -> f64 {
    lamp::<T>(numbers).map_or(0.0, |(lamp, way, incident)| {
        let coefficients = vector(lamp.attenuation.coefficients());
        let factor = exact::attenuation(&coefficients, &exact::length(&way));
        let channels = <[T; 3]>::from(incident.intensity()).into_iter();
        let errors = channels.zip(vector(lamp.intensity)).map(|(computed, i)| {
            let expected = i * &factor;
            error(computed, &expected, &expected)
        });
        errors.fold(0.0, f64::max)
    })
}

#[derive(Clone, Copy)]
pub enum Model {
    Lambert,
    Phong,
    BlinnPhong,
}

/// The kind of four lights.
#[derive(Clone, Copy, PartialEq)]
pub enum Lights {
    Suns,
    Lamps,
}

/// A direction that is anywhere, or almost opposite to this one.
fn anywhere<T: Float>(v: UnitVec3<T>, numbers: &mut Numbers) -> Vec3<T> {
    let (aside, distance) = (point::<T>(numbers), numbers.next());
    if distance > 0.0 {
        aside * T::of(two_to(-30.0 * distance)) - *v
    } else {
        aside
    }
}

/// A light at p, and L and I as they arrive, exactly.
fn light<T: Float>(
    kind: Lights,
    p: Vec3<T>,
    v: UnitVec3<T>,
    numbers: &mut Numbers,
) -> (IncidentLight<T>, Vector, Number) {
    let (way, i) = (anywhere(v, numbers), T::of(numbers.within(0.0, 1.0)));
    let intensity = Rgb::gray(i);
    let exact_i = number(i.double());
    if kind == Lights::Suns {
        let l = toward(way);
        let sun = DirectionalLight { l, intensity };
        return (sun.into(), vector(l), exact_i);
    }
    let [a, b, c] = coefficients(numbers);
    let attenuation = Attenuation::new(a, b, c).expect("not all 0");
    let position = p + way * T::of(10.0 * of_any_size(numbers.next()).abs());
    let lamp = PointLight {
        position,
        intensity,
        attenuation,
    };
    let way = exact::subtract(&vector(position), &vector(p));
    let length = exact::length(&way);
    if length == Number::ZERO {
        return (lamp.at(p), vector(v), number(0.0)); // at the lamp, it is dark
    }
    let factor = exact::attenuation(&vector([a, b, c]), &length);
    (
        lamp.at(p),
        exact::scale(&way, &(number(1.0) / length)),
        exact_i * factor,
    )
}

/// A channel of the total under four lights, in units in the last place of k_a I_a + Σ I (k_d +
/// k_s). The half vector of a lamp counts over the least |L + V|, if that is below 1.
pub fn shaded<T: Float>(model: Model, kind: Lights) -> impl Fn(&mut Numbers) -> f64 {
    move |numbers| {
        let [n, v] = [direction::<T>(numbers), direction(numbers)];
        let p = point::<T>(numbers);
        let factors = [(); 4].map(|()| T::of(numbers.within(0.0, 1.0)));
        let lights = [(); 4].map(|()| light(kind, p, v, numbers));
        let [k_a, k_d, k_s, ambient] = factors.map(Rgb::gray);
        let material = Material {
            k_a,
            k_d,
            k_s,
            m: 32_u32,
        };
        let (exact_n, exact_v) = (vector(n), vector(v));
        // the highlight jumps at the horizon
        let is_clear = |l: &Vector| exact::dot(&exact_n, l).to_f64().value().abs() > 1e-3;
        let lights = lights.into_iter().filter(|(_, l, _)| is_clear(l));
        let incident = lights.clone().map(|(incident, _, _)| incident);
        let computed: Shaded<T> = match model {
            Model::Lambert => shade::lambert(n, &material, ambient, incident),
            Model::Phong => shade::phong(n, v, &material, ambient, incident),
            Model::BlinnPhong => shade::blinn_phong(n, v, &material, ambient, incident),
        };

        let [k_a, k_d, k_s, i_a] = factors.map(|k| number(k.double()));
        let mut sum = &k_a * &i_a;
        let mut all = sum.clone();
        let mut conditioning = 1.0_f64;
        for (_, l, i) in lights {
            let cosine = exact::dot(&exact_n, &l);
            all += &i * (&k_d + &k_s);
            if cosine > Number::ZERO {
                let highlight = match model {
                    Model::Lambert => number(0.0),
                    Model::Phong => {
                        let r = exact::reflection(&exact_n, &l);
                        exact::highlight(exact::dot(&r, &exact_v), 32.0)
                    }
                    Model::BlinnPhong => {
                        let h = exact::add(&l, &exact_v);
                        let length = exact::length(&h);
                        if length == Number::ZERO {
                            number(0.0)
                        } else {
                            if kind == Lights::Lamps {
                                conditioning = conditioning.max(1.0 / length.to_f64().value());
                            }
                            exact::highlight(exact::dot(&exact_n, &exact::unit(&h)), 32.0)
                        }
                    }
                };
                sum += i * (&k_d * cosine + &k_s * highlight);
            }
        }
        error(computed.total().r, &sum, &all) / conditioning
    }
}
