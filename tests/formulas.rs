//! Every formula against a value derived by hand. The derivation stands beside the value; the
//! tolerances count the roundings, in units u of the largest intermediate number.

use std::f64::consts::FRAC_1_PI;

use shading::{
    Attenuation, Cone, DirectionalLight, Dual, Elementary, Exponent, Light, Material, PointLight,
    Real, Rgb, Shaded, SpotLight, UnitVec3, Vec3, attenuation, half_vector, normal, reflection,
    shade, term,
};
use support::number::{Float, direction, for_f32_and_f64, vector};

for_f32_and_f64!(
    vectors_add_multiply_and_cross,
    colors_add_multiply_and_clamp,
    lambert_at_60_degrees_is_a_half,
    reflection_in_a_tilted_normal,
    half_vector_of_two_pythagorean_directions,
    phong_of_the_3_4_5_triangle,
    blinn_of_the_3_4_5_triangle,
    normalizations_of_small_shininess,
    powers_of_a_half_are_exact,
    ambient_is_the_product,
    attenuation_is_a_third,
    normals_of_the_box_with_diagonal_seven,
    normal_of_the_saddle,
    roof_of_a_house_half_as_wide,
    shares_of_half_an_equilateral_triangle,
    tangent_of_a_slanted_map,
    sample_of_a_normal_map_on_a_slanted_surface,
    two_lights_with_lambert,
    two_lights_with_phong,
    two_lights_with_blinn,
    spot_inside_and_outside_30_degrees,
    soft_spot_between_its_edges,
    faint_edge_of_a_soft_spot_keeps_its_digits,
    attenuation_halfway_to_its_range,
    a_scene_maps_to_another_number_type,
    dual_sum_product_and_quotient,
    dual_with_a_plain_number,
    dual_elementary_functions,
    dual_whole_powers,
);

/// Asserts that the numbers differ by at most `units` u.
fn assert_near<T: Float, const N: usize>(
    actual: impl Into<[T; N]>,
    expected: [f64; N],
    units: f64,
) {
    let actual = actual.into().map(T::to_f64);
    for (a, e) in actual.into_iter().zip(expected) {
        assert!(
            (a - e).abs() <= units * T::U,
            "{actual:?} instead of {expected:?}"
        );
    }
}

fn rgb<T: Real>(r: f64, g: f64, b: f64) -> Rgb<T> {
    Rgb::new(r, g, b).map(T::of)
}

/// L = (3, 0, 4)/5, at 36.87° from Z.
fn slanted<T: Float>() -> UnitVec3<T> {
    direction([3.0, 0.0, 4.0])
}

fn vectors_add_multiply_and_cross<T: Float>() {
    let (a, b) = (vector::<T>([1.0, 2.0, 3.0]), vector::<T>([4.0, -5.0, 6.0]));
    assert_eq!(a + b, vector([5.0, -3.0, 9.0]));
    assert_eq!(a - b, vector([-3.0, 7.0, -3.0]));
    assert_eq!(a * T::of(2.0), vector([2.0, 4.0, 6.0]));
    assert_eq!(-a, vector([-1.0, -2.0, -3.0]));
    // 4 − 10 + 18
    assert_eq!(a.dot(b), T::of(12.0));
    // (2·6 + 3·5, 3·4 − 1·6, −1·5 − 2·4)
    assert_eq!(a.cross(b), vector([27.0, 6.0, -13.0]));
    assert_eq!(a.cross(a), Vec3::ZERO);
    assert_eq!(<[T; 3]>::from(a), [1.0, 2.0, 3.0].map(T::of));
    assert_eq!(*-UnitVec3::<T>::X, vector([-1.0, 0.0, 0.0]));
}

fn colors_add_multiply_and_clamp<T: Float>() {
    let (a, b) = (rgb::<T>(0.5, 1.0, 2.0), rgb::<T>(0.25, 0.5, -4.0));
    assert_eq!(a + b, rgb(0.75, 1.5, -2.0));
    assert_eq!(a - b, rgb(0.25, 0.5, 6.0));
    assert_eq!(a * b, rgb(0.125, 0.5, -8.0));
    assert_eq!(a * T::of(2.0), rgb(1.0, 2.0, 4.0));
    assert_eq!([a, b, a].into_iter().sum::<Rgb<T>>(), rgb(1.25, 2.5, 0.0));
    assert_eq!((a + b).clamped(), rgb(0.75, 1.0, 0.0));
    let mut sum = a;
    sum += b;
    assert_eq!(<[T; 3]>::from(sum), [0.75, 1.5, -2.0].map(T::of));
}

fn lambert_at_60_degrees_is_a_half<T: Float>() {
    // L = (√3/2, 0, ½); normalizing adds an error of 3.5u of ½
    let l = direction::<T>([3.0_f64.sqrt(), 0.0, 1.0]);
    assert_near([term::lambert(UnitVec3::Z, l)], [0.5], 2.0);
    assert_eq!(term::lambert(UnitVec3::Z, -l), T::ZERO);
}

fn reflection_in_a_tilted_normal<T: Float>() {
    // N = (3, 0, 4)/5, L = Z: N·L = 4/5, R = 8/5 (3, 0, 4)/5 − (0, 0, 1) = (24, 0, 7)/25
    let r = reflection(slanted::<T>(), UnitVec3::Z);
    assert_near(*r, [0.96, 0.0, 0.28], 11.0);
}

fn half_vector_of_two_pythagorean_directions<T: Float>() {
    // (2, 1, 2)/3 + (1, 2, 2)/3 = (3, 3, 4)/3, of length √34/3
    let [l, v] = [[2.0, 1.0, 2.0], [1.0, 2.0, 2.0]].map(direction::<T>);
    let h = half_vector(l, v).expect("halfway");
    assert_near(*h, [3.0, 3.0, 4.0].map(|c: f64| c / 34.0_f64.sqrt()), 8.0);
}

fn phong_of_the_3_4_5_triangle<T: Float>() {
    // R·V = 4/5: its square is 16/25 and its cube 64/125
    let (r, v) = (slanted::<T>(), UnitVec3::Z);
    assert_near(
        [term::phong(r, v, 2), term::phong(r, v, 3)],
        [0.64, 0.512],
        12.0,
    );
    assert_near(
        [term::phong(r, v, T::of(2.0)), term::phong(r, v, T::of(3.0))],
        [0.64, 0.512],
        16.0,
    );
    // √(4/5)
    assert_near([term::phong(r, v, T::of(0.5))], [0.8_f64.sqrt()], 8.0);
}

fn blinn_of_the_3_4_5_triangle<T: Float>() {
    // L·V = 4/5, |L + V|² = 2 + 8/5 = 18/5, N·H = (4/5 + 1)/√(18/5) = √(9/10)
    let n = UnitVec3::<T>::Z;
    let h = half_vector(slanted(), n).expect("halfway");
    assert_near(
        [term::blinn(n, h, 2), term::blinn(n, h, 4)],
        [0.9, 0.81],
        32.0,
    );
    assert_near([term::blinn(n, h, T::of(4.0))], [0.81], 36.0);
}

fn normalizations_of_small_shininess<T: Float>() {
    // (2 + 2)/(2π) = 2/π; (6 + 2)/(2π) = 4/π
    let phong = [2.0, 6.0].map(|m| term::phong_normalization(T::of(m)));
    assert_near(phong, [2.0, 4.0].map(|k| k * FRAC_1_PI), 3.0 * 4.0);
    // 4·6/(8π(½ + 2)) = 1.2/π; 8·10/(8π(⅛ + 6)) = 80/(49π), where the power of √½ is off by 6u at
    // most
    let blinn = [2.0, 6.0].map(|m| term::blinn_normalization(T::of(m)));
    assert_near(blinn, [1.2, 80.0 / 49.0].map(|k| k * FRAC_1_PI), 8.0);
    // halfway between two integers: 3.5/(2π), and 3.5·5.5/(8π(2^(−¾) + 1.5))
    let m = T::of(1.5);
    let blinn = 3.5 * 5.5 / 8.0 / (0.5_f64.powf(0.75) + 1.5);
    assert_near(
        [term::phong_normalization(m), term::blinn_normalization(m)],
        [1.75, blinn].map(|k| k * FRAC_1_PI),
        8.0,
    );
}

fn powers_of_a_half_are_exact<T: Float>() {
    let half = T::of(0.5);
    let mut expected = T::ONE;
    for m in 0..100_u32 {
        assert_eq!(m.raise(half), expected, "{m}");
        if expected.to_f64() <= T::MIN_POSITIVE * 4.0 {
            break;
        }
        expected = expected * half;
    }
}

fn ambient_is_the_product<T: Float>() {
    assert_eq!(
        term::ambient(rgb::<T>(0.5, 0.25, 0.0), rgb(0.5, 2.0, 3.0)),
        rgb(0.25, 0.5, 0.0)
    );
}

fn attenuation_is_a_third<T: Float>() {
    // 1 + ½·2 + ¼·2² = 3
    let [a, b, c, q] = [1.0, 0.5, 0.25, 2.0].map(T::of);
    assert_eq!(attenuation(a, b, c, q), T::of(1.0 / 3.0));
    assert_eq!(
        Attenuation::of(a, b, c).expect("coefficients").at(q),
        T::of(1.0 / 3.0)
    );
}

fn normals_of_the_box_with_diagonal_seven<T: Float>() {
    // 6² + 3² + 2² = 7²
    let expected = [6.0 / 7.0, 3.0 / 7.0, 2.0 / 7.0];
    let [six, three, two] = [6.0, 3.0, 2.0].map(T::of);
    // (−1, 2, 0) × (−1, 0, 3) = (6, 3, 2)
    let [a, b, c] = [[1.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 3.0]].map(vector::<T>);
    // ∇(xyz) = (yz, xz, xy), at (1, 2, 3)
    let product = |p: Vec3<Dual<T>>| p.x * p.y * p.z;
    let normals = [
        normal::plane(six, three, two),
        normal::triangle(a, b, c),
        normal::sphere(vector([1.0, 1.0, 1.0]), vector([7.0, 4.0, 3.0])),
        normal::implicit(product, vector([1.0, 2.0, 3.0])),
        normal::from_gradient(vector([6.0, 3.0, 2.0])),
        normal::from_tangents(b - a, c - a),
    ];
    for n in normals {
        assert_near(*n.expect("a normal"), expected, 3.5);
    }
}

fn normal_of_the_saddle<T: Float>() {
    // s = (u, v, uv): S_u × S_v = (1, 0, v) × (0, 1, u) = (−v, −u, 1), at (2, 2)
    let saddle = |u: Dual<T>, v: Dual<T>| Vec3::new(u, v, u * v);
    let n = normal::parametric(saddle, T::of(2.0), T::of(2.0)).expect("a normal");
    assert_near(*n, [-2.0 / 3.0, -2.0 / 3.0, 1.0 / 3.0], 3.5);
}

fn roof_of_a_house_half_as_wide<T: Float>() {
    // the cofactors of diag(½, 1, 1) are diag(1, ½, ½), which turn (3, 0, 4)/5 into (3, 0, 2)/√13;
    // the slant is off by 3u, the cofactors by 5u, and the length by 3.5u
    let columns = [[0.5, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(vector::<T>);
    let n = normal::transformed(slanted(), columns).expect("a normal");
    let root = 13.0_f64.sqrt();
    assert_near(*n, [3.0 / root, 0.0, 2.0 / root], 12.0);
}

fn shares_of_half_an_equilateral_triangle<T: Float>() {
    // 30°, 60°, and 90°, seen from above; each angle is off by 8 roundings
    let [a, b, c] = [[0.0, 0.0, 0.0], [3.0_f64.sqrt(), 0.0, 0.0], [0.0, 1.0, 0.0]].map(vector::<T>);
    for ([v1, v2, v3], parts) in [([b, c, a], 6.0), ([c, a, b], 3.0), ([a, b, c], 2.0)] {
        let share = normal::corner(v1, v2, v3);
        assert_near(share, [0.0, 0.0, std::f64::consts::PI / parts], 16.0);
    }
}

fn tangent_of_a_slanted_map<T: Float>() {
    // e₁ = (2, 0, 0), e₂ = (0, 4, 3), and the map's differences are (1, 1) and (−1, 1): d = 2 and
    // T = (e₁ − e₂)/2 = (2, −4, −3)/2, of length √29/2
    let vertices = [[1.0, 0.0, 0.0], [3.0, 0.0, 0.0], [1.0, 4.0, 3.0]].map(vector);
    let map = [[2.0, 3.0], [3.0, 4.0], [1.0, 4.0]].map(|xy| xy.map(T::of));
    let (t, h) = normal::tangent(vertices, map).expect("a tangent");
    assert_near(*t, [2.0, -4.0, -3.0].map(|c| c / 29.0_f64.sqrt()), 8.0);
    assert_eq!(h, T::ONE);
    // the second and third texture coordinates change places: the differences of y stay (1, 1), and d = −2
    let (t, h) = normal::tangent(vertices, [map[0], map[2], map[1]]).expect("a tangent");
    assert_near(*t, [-2.0, 4.0, 3.0].map(|c| c / 29.0_f64.sqrt()), 8.0);
    assert_eq!(h, -T::ONE);
}

fn sample_of_a_normal_map_on_a_slanted_surface<T: Float>() {
    // N = (3, 0, 4)/5 and T = (2, 0, 1), whose component along N is 2N: t = (4, 0, −3)/5, and N × t
    // = (0, 1, 0). The sample (1, 2, 2)/3 gives (t + 2(0, 1, 0) + 2N)/3 = (2, 2, 1)/3.
    let n = normal::mapped(
        slanted(),
        vector([2.0, 0.0, 1.0]),
        T::ONE,
        vector([1.0, 2.0, 2.0]),
    );
    assert_near(
        *n.expect("a normal"),
        [2.0 / 3.0, 2.0 / 3.0, 1.0 / 3.0],
        24.0,
    );
    let n = normal::mapped(
        slanted(),
        vector([2.0, 0.0, 1.0]),
        -T::ONE,
        vector([1.0, 2.0, 2.0]),
    );
    assert_near(
        *n.expect("a normal"),
        [2.0 / 3.0, -2.0 / 3.0, 1.0 / 3.0],
        24.0,
    );
}

fn soft_spot_between_its_edges<T: Float>() {
    // the cosines go from 1 (less 4ε) down to 0.6, and L is at 0.8: t = ½, t² = ¼, t²(3 − 2t) = ½;
    // L is off by 3u, and t by 2.5 times as much, which counts up to 1.5 times
    let cone = Cone::of_cosines(T::ONE, T::of(0.6)).expect("cosines");
    let factors = [cone, cone.smoothstep()].map(|cone| cone.factor(-UnitVec3::Z, slanted()));
    assert_near(factors, [0.25, 0.5], 40.0);
}

fn faint_edge_of_a_soft_spot_keeps_its_digits<T: Float>() {
    // The cosine of L is c = ½ + kε, exactly, and both differences in t = (c − ½)/(inner − ½) are
    // exact. The quotient is off by 1u of itself, its square by 3u; here and in f64.
    let (outer, epsilon) = (0.5, 2.0 * T::U);
    for inner in [0.7, 0.8, 0.9, 0.95] {
        let cone = Cone::of_cosines(T::of(inner), T::of(outer)).expect("cosines");
        let width = cone.cosines()[0].to_f64() - outer;
        for k in (0..20).map(|i| f64::exp2(f64::from(i)) + 1.0) {
            let cosine = outer + k * epsilon;
            let l = UnitVec3::assume_unit(vector([(1.0 - cosine * cosine).sqrt(), 0.0, cosine]));
            let t = k * epsilon / width;
            let factor = cone.factor(-UnitVec3::Z, l).to_f64();
            let error = (factor / (t * t) - 1.0).abs();
            assert!(error <= 8.0 * T::U, "{inner}, {k}: {error:e}");
        }
    }
}

fn attenuation_halfway_to_its_range<T: Float>() {
    // 1/(1 + 4/4) (1 − (2/4)⁴)² = ½ (15/16)², without any rounding
    let free = Attenuation::of(T::ONE, T::ZERO, T::of(0.25)).expect("coefficients");
    let ranged = free.of_range(T::of(4.0)).expect("a range");
    assert_eq!(ranged.at(T::of(2.0)), T::of(225.0 / 512.0));
    // as glTF has it, ½ (1 − (2/4)⁴) = ½ 15/16
    assert_eq!(ranged.unsquared().at(T::of(2.0)), T::of(15.0 / 32.0));
    // a light with this attenuation: its whole intensity is ½ (15/16)² of (1, ½, 0)
    let lamp = PointLight {
        position: vector([0.0, 0.0, 2.0]),
        intensity: rgb(1.0, 0.5, 0.0),
        attenuation: ranged,
    };
    let incident = lamp.at(Vec3::ZERO);
    assert_eq!(incident.intensity, rgb(225.0 / 512.0, 225.0 / 1024.0, 0.0));
    let gltf = PointLight {
        attenuation: ranged.unsquared(),
        ..lamp
    };
    let incident = gltf.at(Vec3::ZERO);
    assert_eq!(incident.intensity, rgb(15.0 / 32.0, 15.0 / 64.0, 0.0));
}

/// A lamp two units above the origin, where ¼ of (1, ½, 0) arrives, and the slanted sun with
/// intensity ½; the eye is above.
fn two_lights<T: Float>() -> [Light<T>; 2] {
    let lamp = PointLight {
        position: vector([0.0, 0.0, 2.0]),
        intensity: rgb(1.0, 0.5, 0.0),
        attenuation: T::attenuation([0.0, 0.0, 1.0]).expect("coefficients"),
    };
    let sun = DirectionalLight {
        l: slanted(),
        intensity: rgb(0.5, 0.5, 0.5),
    };
    [Light::Point(lamp), Light::Directional(sun)]
}

fn material<T: Real>() -> Material<T, u32> {
    let [k_a, k_d, k_s] = [0.125, 0.5, 0.25].map(|k| Rgb::gray(T::of(k)));
    Material {
        k_a,
        k_d,
        k_s,
        m: 2,
    }
}

/// k_a I_a = 1/8 · 1/4. For the diffuse part, N·L = 1 and 4/5:
/// ½ (¼ + ½ · ⅘) = 0.325, ½ (⅛ + ⅖) = 0.2625, ½ · ⅖ = 0.2.
fn assert_ambient_and_diffuse<T: Float>(shaded: Shaded<T>) {
    assert_eq!(shaded.ambient, Rgb::gray(T::of(1.0 / 32.0)));
    assert_near(shaded.diffuse, [0.325, 0.2625, 0.2], 4.0);
}

fn two_lights_with_lambert<T: Float>() {
    let lights = two_lights::<T>().map(|light| light.at(Vec3::ZERO));
    let shaded = shade::lambert(UnitVec3::Z, &material(), Rgb::gray(T::of(0.25)), lights);
    assert_ambient_and_diffuse(shaded);
    assert_eq!(shaded.specular, Rgb::BLACK);
}

fn two_lights_with_phong<T: Float>() {
    let n = UnitVec3::<T>::Z;
    let lights = two_lights::<T>().map(|light| light.at(Vec3::ZERO));
    let shaded = shade::phong(n, n, &material(), Rgb::gray(T::of(0.25)), lights);
    assert_ambient_and_diffuse(shaded);
    // (R·V)² = 1 and 16/25: ¼ (¼ + ½ · 0.64) = 0.1425, ¼ (⅛ + 0.32) = 0.11125, ¼ · 0.32
    assert_near(shaded.specular, [0.1425, 0.11125, 0.08], 8.0);
    assert_near(shaded.total(), [0.498_75, 0.405, 0.311_25], 16.0);
}

fn two_lights_with_blinn<T: Float>() {
    let n = UnitVec3::<T>::Z;
    let lights = two_lights::<T>().map(|light| light.at(Vec3::ZERO));
    let shaded = shade::blinn_phong(n, n, &material(), Rgb::gray(T::of(0.25)), lights);
    assert_ambient_and_diffuse(shaded);
    // (N·H)² = 1 and 9/10: ¼ (¼ + ½ · 0.9) = 0.175, ¼ (⅛ + 0.45) = 0.14375, ¼ · 0.45
    assert_near(shaded.specular, [0.175, 0.143_75, 0.1125], 8.0);
}

fn spot_inside_and_outside_30_degrees<T: Float>() {
    let Light::Point(point) = two_lights::<T>()[0] else {
        unreachable!()
    };
    let axis = -UnitVec3::Z;
    let spot = SpotLight {
        point,
        axis,
        cone: T::cone(30.0).expect("a half-angle"),
    };
    // the points are 2 below the lamp, and 1 and 1.2 to the side: arctan ½ = 26.6°, arctan 0.6 =
    // 31.0°
    let within = vector::<T>([1.0, 0.0, 0.0]);
    assert_eq!(spot.at(within), point.at(within));
    assert_near(spot.at(within).intensity, [0.2, 0.1, 0.0], 4.0);
    assert_eq!(spot.at(vector([1.2, 0.0, 0.0])).intensity, Rgb::BLACK);
}

fn a_scene_maps_to_another_number_type<T: Float>() {
    // the value of a dual number is the result for the plain number
    let n = UnitVec3::<T>::Z;
    let plain = two_lights::<T>().map(|light| light.at(Vec3::ZERO));
    let dual = two_lights::<T>().map(|light| light.cast(Dual::constant).at(Vec3::ZERO));
    let shaded = shade::phong(n, n, &material(), Rgb::WHITE, plain);
    let (n, white) = (n.cast(Dual::constant), Rgb::WHITE);
    let mapped = material::<T>().cast(Dual::constant);
    let shaded_dual = shade::phong(n, n, &mapped, white, dual);
    assert_eq!(
        shaded_dual.total().map(|channel| channel.value),
        shaded.total()
    );
}

/// The variables x = 2, y = 3 and z = −1.
fn variables<T: Float>() -> Vec3<Dual<T>> {
    Dual::point(vector([2.0, 3.0, -1.0]))
}

fn assert_dual<T: Float>(dual: Dual<T>, value: f64, gradient: [f64; 3], units: f64) {
    assert_near([dual.value], [value], units);
    assert_near(dual.gradient, gradient, units);
}

fn dual_sum_product_and_quotient<T: Float>() {
    let Vec3 { x, y, z } = variables::<T>();
    assert_dual(x + y - z, 6.0, [1.0, 1.0, -1.0], 0.0);
    assert_dual(x * y * z, -6.0, [-3.0, -2.0, 6.0], 0.0);
    assert_dual(-x, -2.0, [-1.0, 0.0, 0.0], 0.0);
    // x²y/(x + y) = 12/5: ∂/∂x = (2xy(x + y) − x²y)/(x + y)² = 48/25, ∂/∂y = x³/(x + y)² = 8/25
    assert_dual(x * x * y / (x + y), 2.4, [1.92, 0.32, 0.0], 16.0);
    assert!(x < y && x == Dual::constant(T::of(2.0)));
}

fn dual_with_a_plain_number<T: Float>() {
    let Vec3 { x, y, .. } = variables::<T>();
    let two = T::of(2.0);
    assert_dual(x + two, 4.0, [1.0, 0.0, 0.0], 0.0);
    assert_dual(y - two, 1.0, [0.0, 1.0, 0.0], 0.0);
    assert_dual(y * two, 6.0, [0.0, 2.0, 0.0], 0.0);
    assert_dual(y / two, 1.5, [0.0, 0.5, 0.0], 0.0);
    // the chain rule: a slope of 5 times ∇(xy) = (3, 2, 0)
    assert_dual(
        (x * y).chain(T::ONE, T::of(5.0)),
        1.0,
        [15.0, 10.0, 0.0],
        0.0,
    );
    assert_dual(Dual::constant(two), 2.0, [0.0; 3], 0.0);
}

fn dual_elementary_functions<T: Float>() {
    let Vec3 { x, y, z } = variables::<T>();
    // functions of x = 2: libm is right to 1 ulp, which is 2u of a value less than 8
    assert_dual(x.sin(), 2.0_f64.sin(), [2.0_f64.cos(), 0.0, 0.0], 2.0);
    assert_dual(x.cos(), 2.0_f64.cos(), [-2.0_f64.sin(), 0.0, 0.0], 2.0);
    assert_dual(x.exp(), 2.0_f64.exp(), [2.0_f64.exp(), 0.0, 0.0], 16.0);
    assert_dual(x.ln(), 2.0_f64.ln(), [0.5, 0.0, 0.0], 2.0);
    // √(xy + z + 11) = 4: ∇ = (y, x, 1)/8
    assert_dual(
        (x * y + z + T::of(11.0)).sqrt(),
        4.0,
        [0.375, 0.25, 0.125],
        0.0,
    );
    assert_dual(z.abs(), 1.0, [0.0, 0.0, -1.0], 0.0);
    assert_dual(y.abs(), 3.0, [0.0, 1.0, 0.0], 0.0);
}

fn dual_whole_powers<T: Float>() {
    let x = variables::<T>().x;
    // xⁿ and n xⁿ⁻¹ at 2, where every power is a power of two
    for n in -10..=10 {
        let power = 2.0_f64.powi(n);
        assert_dual(
            x.powi(n),
            power,
            [f64::from(n) * power / 2.0, 0.0, 0.0],
            0.0,
        );
    }
}

/// A plain number to the left of a dual number: 3 + x, 3 − x, 3x, and 3/x at x = 2, where (3/x)′ =
/// −3/x² = −3/4.
macro_rules! plain_number_before_a_dual_number {
    ($($name:ident: $float:ident),*) => {
        $(#[test]
        fn $name() {
            let x = Dual::point(Vec3::<$float>::new(2.0, 3.0, -1.0)).x;
            assert_dual(3.0 + x, 5.0, [1.0, 0.0, 0.0], 0.0);
            assert_dual(3.0 - x, 1.0, [-1.0, 0.0, 0.0], 0.0);
            assert_dual(3.0 * x, 6.0, [3.0, 0.0, 0.0], 0.0);
            assert_dual(3.0 / x, 1.5, [-0.75, 0.0, 0.0], 0.0);
        })*
    };
}

plain_number_before_a_dual_number!(f32_before_a_dual_one: f32, f64_before_a_dual_one: f64);

/// Where Foley's limit holds, the light is constant. Elsewhere, 1/q² changes by −2/q³.
#[test]
fn a_limited_lamp_has_no_gradient() {
    let inverse_square = Attenuation::<f64>::new(0.0, 0.0, 1.0).expect("positive");
    let lamp = |attenuation| PointLight {
        position: Vec3::ZERO,
        intensity: Rgb::WHITE,
        attenuation,
    };
    let [free, limited] = [inverse_square, inverse_square.clamped()]
        .map(|attenuation| lamp(attenuation).cast(Dual::constant));
    for (q, slope, limited_slope) in [(0.5, -16.0, 0.0), (2.0, -0.25, -0.25)] {
        let p = Dual::point(Vec3::new(0.0, 0.0, q));
        for (lamp, slope) in [(free, slope), (limited, limited_slope)] {
            let gradient = lamp.at(p).intensity.r.gradient;
            assert_eq!(gradient, Vec3::new(0.0, 0.0, slope));
        }
    }
}

/// (cᵐ)′ = m cᵐ⁻¹, which is m at c = 1, also for an m of more than 16 bits.
#[test]
fn slope_of_a_large_power_is_its_exponent() {
    let cosine = Dual::point(Vec3::new(1.0_f64, 0.0, 0.0)).x;
    for m in [65_535_u32, 65_536, 100_001, u32::MAX] {
        let slope = Vec3::new(f64::from(m), 0.0, 0.0);
        assert_eq!(m.raise(cosine).gradient, slope);
    }
}
