//! Calls every public function with numbers from any source, for the tests with arbitrary bits and
//! for the fuzzer. Bits that are not valid input must not cause a panic, and whatever the
//! documentation promises for them holds. Finite valid input gives neither NaN nor negative light.

use shading::{
    Attenuation, Cone, DirectionalLight, Dual, Elementary, IncidentLight, Light, Material,
    PointLight, Ranged, Real, Rgb, Shaded, SoftCone, SpotLight, UnitVec3, Vec3, attenuation,
    half_vector, normal, reflection, shade, term,
};

use super::number::Float;

/// The source of the numbers.
pub struct Numbers<'a, T> {
    pub next: &'a mut dyn FnMut() -> T,
    /// An integer m.
    pub m: u32,
}

impl<T: Float> Numbers<'_, T> {
    fn number(&mut self) -> T {
        (self.next)()
    }

    fn vector(&mut self) -> Vec3<T> {
        Vec3::new(self.number(), self.number(), self.number())
    }

    fn rgb(&mut self) -> Rgb<T> {
        Rgb::new(self.number(), self.number(), self.number())
    }

    fn dual(&mut self) -> Dual<T> {
        Dual {
            value: self.number(),
            gradient: self.vector(),
        }
    }

    fn material<M>(&mut self, m: M) -> Material<T, M> {
        Material {
            k_a: self.rgb(),
            k_d: self.rgb(),
            k_s: self.rgb(),
            m,
        }
    }

    /// Checked coefficients, or none if these are invalid.
    fn attenuation(&mut self) -> Attenuation<T> {
        let [a, b, c] = [(); 3].map(|()| self.number());
        Attenuation::of(a, b, c).unwrap_or(Attenuation::NONE)
    }

    fn lights(&mut self, l: UnitVec3<T>, axis: UnitVec3<T>) -> [Light<T>; 3] {
        let directional = DirectionalLight {
            l,
            intensity: self.rgb(),
        };
        let [point, tip] = [(); 2].map(|()| PointLight {
            position: self.vector(),
            intensity: self.rgb(),
            attenuation: self.attenuation(),
        });
        let cone = Cone::of_cosine(self.number())
            .or_else(|| Cone::of_half_angle(self.number()))
            .unwrap_or_else(|| Cone::of_half_angle(T::ONE).expect("1 radian"));
        let spot = SpotLight {
            point: tip,
            axis,
            cone,
        };
        [
            Light::Directional(directional),
            Light::Point(point),
            Light::Spot(spot),
        ]
    }
}

fn within_0_and_1<T: Float>(x: T) -> bool {
    x >= T::ZERO && x <= T::ONE
}

/// Checks that a direction has length 1 up to rounding. The squares and sums of the check are off
/// by 3u, and the normalizing by 3.5u, which counts twice in the square; an orthogonal axis is
/// exact.
fn assert_unit<T: Float>(n: UnitVec3<T>) {
    let [x, y, z] = <[T; 3]>::from(n).map(T::to_f64);
    let excess = x * x + y * y + z * z - 1.0;
    assert!(
        excess.abs() <= 10.0 * T::U,
        "the length of {n:?} is 1 + {excess:e}/2"
    );
}

fn assert_unit_if_any<T: Float>(n: Option<UnitVec3<T>>) {
    n.into_iter().for_each(assert_unit);
}

/// Checks that light is neither NaN nor negative.
fn assert_light<T: Float>(what: &str, light: Rgb<T>) {
    let is_light = <[T; 3]>::from(light)
        .into_iter()
        .all(|channel| channel >= T::ZERO);
    assert!(is_light, "{what}: {light:?}");
}

/// Calls every public function with numbers of arbitrary bits.
pub fn any_bits<T: Float>(mut numbers: Numbers<T>) {
    vectors(&mut numbers);
    normals(&mut numbers);
    terms(&mut numbers);
    scene(&mut numbers);
    duals(&mut numbers);
}

fn vectors<T: Float>(numbers: &mut Numbers<T>) {
    let (a, b, s) = (numbers.vector(), numbers.vector(), numbers.number());
    let _ = (a + b, a - b, a * s, -a, a.dot(b), a.cross(b));
    assert_unit_if_any(a.unit());
    assert_unit(a.unit_or(UnitVec3::Z));
    assert_unit_if_any(UnitVec3::of(a.x, a.y, a.z));
    let [u, v] = [a, b].map(UnitVec3::assume_unit);
    let _ = (-u, *reflection(u, v));
    assert_unit_if_any(half_vector(u, v));

    let (x, y) = (numbers.rgb(), numbers.rgb());
    let _ = (
        x + y,
        x - y,
        x * y,
        x * s,
        [x, y].into_iter().sum::<Rgb<T>>(),
    );
    assert!(<[T; 3]>::from(x.clamped()).into_iter().all(within_0_and_1));
    #[allow(clippy::cast_possible_truncation)] // the encodings exist for f32 only
    let single = x.map(|channel| channel.to_f64() as f32);
    let bytes = single.to_srgb8();
    assert_eq!(Rgb::from_srgb8(bytes).to_srgb8(), bytes);
    assert_eq!(single.clamped().to_rgb565(), single.to_rgb565());
    assert_eq!(
        Rgb::from_rgb565(single.to_rgb565()).to_rgb565(),
        single.to_rgb565()
    );
    assert_eq!(single.clamped().to_linear8(), single.to_linear8());
    assert_eq!(single.clamped().to_linear565(), single.to_linear565());
    let double = single.map(f64::from);
    assert_eq!(
        (double.to_srgb8(), double.to_rgb565()),
        (bytes, single.to_rgb565())
    );
    let _ = (s.sqrt(), s.abs(), s.sin(), s.cos(), s.exp(), s.ln());
    // a signaling NaN, which no operation returns, may be its own positive part
    assert!((s + T::ZERO).at_least(T::ZERO) >= T::ZERO);
    let _ = [i32::MIN, -1, 0, 1, i32::MAX].map(|power| s.powi(power));
}

fn normals<T: Float>(numbers: &mut Numbers<T>) {
    let [a, b, c] = [(); 3].map(|()| numbers.vector());
    assert_unit_if_any(normal::plane(a.x, a.y, a.z));
    assert_unit_if_any(normal::triangle(a, b, c));
    assert_unit_if_any(normal::sphere(a, b));
    assert_unit_if_any(normal::from_gradient(a));
    assert_unit_if_any(normal::from_tangents(a, b));
    assert_unit_if_any(normal::implicit(|p| p.dot(p) - numbers.number(), c));
    assert_unit_if_any(normal::implicit(|p| (p.x / p.y).sqrt() + p.z.ln().sin(), c));
    let s = |u: Dual<T>, v: Dual<T>| Vec3::new(u * v, u.exp() / v, (u - v).abs());
    assert_unit_if_any(normal::parametric(s, c.x, c.y));
    let [n, v] = [a, b].map(UnitVec3::assume_unit);
    let facing = normal::facing(n, v);
    let is_nan = <[T; 3]>::from(n).iter().any(|c| c.to_f64().is_nan());
    assert!(facing == n || facing == -n || is_nan);
    assert_unit_if_any(normal::transformed(n, [a, b, c]));
    assert_unit_if_any(normal::mapped(n, b, c.x, c));
    let share = normal::corner(a, b, c).length();
    assert!(share.to_f64() <= std::f64::consts::PI * (1.0 + 8.0 * T::U));
}

fn terms<T: Float>(numbers: &mut Numbers<T>) {
    let [r, v] = [(); 2].map(|()| UnitVec3::assume_unit(numbers.vector()));
    let m = numbers.number();
    let _ = term::ambient(numbers.rgb(), numbers.rgb());
    assert!(term::lambert(r, v) >= T::ZERO);
    assert!(
        within_0_and_1(term::phong(r, v, numbers.m))
            && within_0_and_1(term::blinn(r, v, numbers.m))
    );
    assert!(within_0_and_1(term::phong(r, v, m)) && within_0_and_1(term::blinn(r, v, m)));
    for factor in [term::phong_normalization(m), term::blinn_normalization(m)] {
        assert!(factor > T::ZERO && factor.is_finite(), "{factor:e}");
    }

    let [a, b, c, q] = [(); 4].map(|()| numbers.number());
    let _ = (
        attenuation(a, b, c, q),
        numbers.attenuation().clamped().at(q),
    );
    let ranged = Ranged::of(numbers.attenuation(), q);
    let factor = ranged.map_or(T::ZERO, |ranged| ranged.at(numbers.number()));
    assert!(factor >= T::ZERO);
    let soft = SoftCone::of_cosines(a, q).or_else(|| SoftCone::of_half_angles(a, q));
    if let Some(cone) = soft {
        let [inner, outer] = cone.cosines();
        assert!(inner >= outer && outer >= -T::ONE && inner <= T::ONE);
        for cone in [cone, cone.smoothstep()] {
            assert!(within_0_and_1(cone.factor(r, v)));
        }
    }
    let cone = Cone::of_cosine(q).or_else(|| Cone::of_half_angle(q));
    if let Some(cone) = cone {
        assert!(cone.cosine() >= -T::ONE && cone.cosine() <= T::ONE);
        assert!(within_0_and_1(cone.factor(r, v)));
    }
}

fn scene<T: Float>(numbers: &mut Numbers<T>) {
    let [n, v, l, axis] = [(); 4].map(|()| UnitVec3::assume_unit(numbers.vector()));
    let m = numbers.number();
    let material = numbers.material(m);
    let lights = numbers.lights(l, axis);
    let (p, i_a) = (numbers.vector(), numbers.rgb());
    let _ = shade_all(n, v, &material, i_a, &lights, p);
    let whole = Material {
        m: numbers.m,
        ..numbers.material(0)
    };
    let _ = shade_all(n, v, &whole, i_a, &lights, p);
}

fn shade_all<T: Real, M: shading::Exponent<T>>(
    n: UnitVec3<T>,
    v: UnitVec3<T>,
    material: &Material<T, M>,
    i_a: Rgb<T>,
    lights: &[Light<T>],
    p: Vec3<T>,
) -> [Shaded<T>; 4] {
    // twice, so that the sum may overflow even if no light does
    let twice = || lights.iter().chain(lights).map(|light| light.at(p));
    [
        shade::lambert(n, material, i_a, twice()),
        shade::phong(
            n,
            v,
            material,
            i_a,
            twice().filter_map(|light| light.in_front(n)),
        ),
        shade::blinn_phong(n, v, material, i_a, twice()),
        shade::blinn_phong(n, v, material, i_a, Light::all_in_front(lights, p, n)),
    ]
}

fn duals<T: Float>(numbers: &mut Numbers<T>) {
    let (x, y, s) = (numbers.dual(), numbers.dual(), numbers.number());
    let _ = (x + y, x - y, x * y, x / y, -x, x + s, x - s, x * s, x / s);
    let _ = (
        x.sqrt(),
        x.sin(),
        x.cos(),
        x.exp(),
        x.ln(),
        x.abs(),
        x.chain(s, s),
    );
    let _ = [i32::MIN, -1, 0, 1, i32::MAX].map(|power| x.powi(power));
    let _ = (x.at_least(Dual::ZERO), x.at_most(y), x == y, x < y);
    let v = Vec3::new(x, y, Dual::constant(s));
    let _ = (v.unit(), v.unit_or(UnitVec3::X), v.cross(v), v.dot(v));
    let u = UnitVec3::assume_unit(v);
    let _ = (
        term::phong(u, u, numbers.m),
        term::blinn(u, u, numbers.m),
        term::lambert(u, u),
    );
}

/// Runs the whole model on finite valid input made from any finite numbers. Light is never negative
/// and never NaN, and whatever is promised to be finite is finite.
pub fn finite_and_valid<T: Float>(numbers: Numbers<T>) {
    let Numbers { next, m: whole } = numbers;
    let mut finite = || {
        let x = next();
        if x.is_finite() { x } else { T::ONE }
    };
    let mut signed = Numbers {
        next: &mut finite,
        m: whole,
    };
    let [n, v, l, axis] = [(); 4].map(|()| signed.vector().unit_or(UnitVec3::Z));
    let p = signed.vector();
    let position = signed.vector();
    assert_unit_if_any(normal::triangle(p, position, signed.vector()));

    // −0 is not negative, so it is kept
    let mut positive = || {
        let x = finite();
        if x < T::ZERO { -x } else { x }
    };
    let mut numbers = Numbers {
        next: &mut positive,
        m: whole,
    };
    let m = numbers.number();
    let material = numbers.material(m);
    let mut lights = numbers.lights(l, axis);
    if let Light::Point(point) = &mut lights[1] {
        point.position = position;
    }
    let i_a = numbers.rgb();
    directions(n, v, l, [m, numbers.number()]);
    for light in lights {
        incident(light, p);
    }
    let whole = Material {
        m: whole,
        ..numbers.material(0)
    };
    for shaded in shade_all(n, v, &material, i_a, &lights, p)
        .into_iter()
        .chain(shade_all(n, v, &whole, i_a, &lights, p))
    {
        assert_light("ambient", shaded.ambient);
        assert_light("diffuse", shaded.diffuse);
        assert_light("specular", shaded.specular);
        assert_light("total", shaded.total());
    }
    dual_values(n, v, &whole, i_a, &lights, p);
}

fn directions<T: Float>(n: UnitVec3<T>, v: UnitVec3<T>, l: UnitVec3<T>, [m, q]: [T; 2]) {
    let r = reflection(n, l);
    // 2(N·L)N − L has eleven roundings, which count twice in the square
    let square = r.dot(*r).to_f64();
    assert!((square - 1.0).abs() <= 30.0 * T::U, "|R|² = {square}");
    assert_unit_if_any(half_vector(l, v));
    assert!(within_0_and_1(term::phong(r, v, m)) && within_0_and_1(term::blinn(n, v, m)));
    let factor = Attenuation::NONE.at(q);
    assert_eq!(factor, T::ONE);
}

/// The light that arrives is finite and comes from a direction.
fn incident<T: Float>(light: Light<T>, p: Vec3<T>) {
    let IncidentLight {
        l,
        intensity,
        distance,
    } = light.at(p);
    assert_unit(l);
    assert_light("arriving", intensity);
    assert!(
        <[T; 3]>::from(intensity).into_iter().all(T::is_finite),
        "{intensity:?}"
    );
    assert!(distance >= T::ZERO && distance <= T::MAX, "{distance:?}");
}

/// The value of a dual number has the bits that its plain number computes.
fn dual_values<T: Float>(
    n: UnitVec3<T>,
    v: UnitVec3<T>,
    material: &Material<T, u32>,
    i_a: Rgb<T>,
    lights: &[Light<T>; 3],
    p: Vec3<T>,
) {
    let plain = shade_all(n, v, material, i_a, lights, p);
    let dual = shade_all(
        n.cast(Dual::constant),
        v.cast(Dual::constant),
        &material.cast(Dual::constant),
        i_a.map(Dual::constant),
        &lights.map(|light| light.cast(Dual::constant)),
        Dual::point(p),
    );
    for (plain, dual) in plain.into_iter().zip(dual) {
        let value = |x: Dual<T>| x.value;
        assert_eq!(plain.diffuse, dual.diffuse.map(value));
        assert_eq!(plain.specular, dual.specular.map(value));
    }
}
