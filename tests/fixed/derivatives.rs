//! Dual numbers over fixed point. Each search climbs to the largest share of a bound, which follows from
//! the roundings by half a step (0.51 for a direction) and is derived beside it. Exact results are computed
//! in `f64`, whose roundings are a billionth of a step.

use shading::fixed::{Attenuation, Dual, Fixed, Vec3};
use shading::{Elementary, Real, normal};

use crate::{Random, exact, steps};

type DualVec3 = shading::Vec3<Dual>;

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

fn length(v: [f64; 3]) -> f64 {
    dot(v, v).sqrt()
}

/// The largest share of its bound that an error reaches, over places given by N numbers in [−1, 1]. The
/// search starts at several places and takes every step that does not lead down.
fn climb<const N: usize>(share: impl Fn([f64; N]) -> f64) -> f64 {
    let mut random = Random(66);
    let heights = (0..20).map(|_| {
        let mut top = [(); N].map(|()| random.within(-1.0, 1.0));
        let mut height = share(top);
        for _ in 0..2000 {
            let mut place = top;
            for _ in 0..=random.below(2) {
                let number = &mut place[random.below(N)];
                let size = 2_f64.powi(-i32::try_from(random.below(24)).expect("small"));
                *number = (*number + size * random.within(-1.0, 1.0)).clamp(-1.0, 1.0);
            }
            let found = share(place);
            assert!(found <= 1.0, "{found} of the bound at {place:?}");
            if found >= height {
                (top, height) = (place, found);
            }
        }
        height
    });
    heights.fold(0.0, f64::max)
}

/// From 2⁻¹⁶ to 2¹⁴, with the sign of the number.
fn of_any_size(number: f64) -> Fixed {
    Fixed::new((30.0 * number.abs() - 16.0).exp2().copysign(number))
}

/// The largest error of a direction's components, in steps.
fn error(direction: [Fixed; 3], exact: [f64; 3]) -> f64 {
    let size = length(exact);
    let errors = [0, 1, 2].map(|i| (steps(direction[i]) - exact[i] / size * 65536.0).abs());
    errors.into_iter().fold(0.0, f64::max)
}

fn assert_bound(what: &str, largest: f64) {
    println!("{what}: {largest:.3} of the bound");
    // a bound far above all errors would show nothing
    assert!((0.25..=1.0).contains(&largest), "{what}: {largest}");
}

/// A vector whose value and gradients have any size.
fn any_vector(numbers: [f64; 12]) -> (DualVec3, [f64; 3], [[f64; 3]; 3]) {
    let value = [0, 1, 2].map(|i| of_any_size(numbers[i]));
    let slope = |i: usize, k: usize| Fixed::new(4.0 * numbers[3 + 3 * k + i]);
    let duals = [0, 1, 2].map(|i| Dual {
        value: value[i],
        gradient: Vec3::new(slope(i, 0), slope(i, 1), slope(i, 2)),
    });
    let slopes = [0, 1, 2].map(|k| [0, 1, 2].map(|i| exact(slope(i, k))));
    (duals.into(), value.map(exact), slopes)
}

/// ∇|v| = u·∇v: each component of u is off by 0.51 steps, and the sum is rounded.
#[test]
fn gradients_of_a_length_are_within_their_bound() {
    let largest = climb(|numbers| {
        let (v, value, slopes) = any_vector(numbers);
        let size = length(value);
        let gradient: [Fixed; 3] = v.length().gradient.into();
        let shares = [0, 1, 2].map(|k| {
            let expected = dot(value, slopes[k]) / size;
            let bound = 0.5 + 0.51 * slopes[k].iter().map(|s| s.abs()).sum::<f64>();
            (steps(gradient[k]) - expected * 65536.0).abs() / bound
        });
        shares.into_iter().fold(0.0, f64::max)
    });
    assert_bound("∇|v|", largest);
}

/// ∇u = (∇v − u ∇|v|)/|v|: the dividend is off by the errors of u and ∇|v| and two roundings, and the
/// divisor by half a step and 2⁻²³ of it.
#[test]
fn gradients_of_a_direction_are_within_their_bound() {
    let largest = climb(|numbers| {
        let (v, value, slopes) = any_vector(numbers);
        let size = length(value);
        let unit = v.unit_or(shading::UnitVec3::X);
        let gradients = [unit.x, unit.y, unit.z].map(|u| <[Fixed; 3]>::from(u.gradient));
        let mut largest = 0.0_f64;
        for k in 0..3 {
            let along = dot(value, slopes[k]) / size;
            let of_along = 0.5 + 0.51 * slopes[k].iter().map(|s| s.abs()).sum::<f64>();
            for i in 0..3 {
                let u = value[i] / size;
                let expected = (slopes[k][i] - along * u) / size;
                let of_dividend = 0.51 * along.abs() + of_along * (u.abs() + 0.00001) + 0.5;
                let of_divisor = 0.5 + size / 128.0; // in steps, of which 65536·2⁻²³ make 1/128
                let least = size - of_divisor / 65536.0;
                let bound = (of_dividend + expected.abs() * of_divisor) / least + 0.5;
                if expected.abs() + bound / 65536.0 < 32767.0 && least > 0.0 {
                    let error = (steps(gradients[i][k]) - expected * 65536.0).abs();
                    largest = largest.max(error / bound);
                }
            }
        }
        largest
    });
    assert_bound("∇(v/|v|)", largest);
}

/// The share of its bound that the error of an implicit normal takes; `of_gradient` is that of the gradient, in steps.
fn implicit(
    f: impl Fn(DualVec3) -> Dual,
    p: Vec3,
    gradient: impl Fn([f64; 3]) -> [f64; 3],
    of_gradient: impl Fn([f64; 3]) -> f64,
) -> f64 {
    let Some(n) = normal::implicit(&f, p) else {
        return if p == Vec3::ZERO { 0.0 } else { f64::INFINITY };
    };
    let place = <[f64; 3]>::from(p.map(exact));
    let gradient = gradient(place);
    // an error of the gradient turns it by as much over its length; then the direction is rounded
    let bound = 0.51 + of_gradient(place) / length(gradient);
    error((*n).into(), gradient) / bound
}

fn any_point(numbers: [f64; 3]) -> Vec3 {
    Vec3::from(numbers.map(of_any_size))
}

fn point_within(numbers: [f64; 3], size: f64) -> Vec3 {
    Vec3::from(numbers.map(|number| Fixed::new(size * number)))
}

/// ∇|p| is the direction of p, whose three components are off by 0.51 steps.
#[test]
fn sphere_by_its_radius_has_its_normal_everywhere() {
    let p = Vec3::from([20.0, 15.0, 0.0].map(Fixed::new));
    let n = normal::implicit(|p| p.length() - Dual::constant(Fixed::new(5.0)), p);
    let error = error((*n.expect("a normal")).into(), [0.8, 0.6, 0.0]);
    assert!(error <= 0.51 + 0.51 * 3_f64.sqrt(), "{error} steps");

    let largest = climb(|numbers| {
        let f = |p: DualVec3| p.length() - Dual::constant(Fixed::ONE);
        implicit(
            f,
            any_point(numbers),
            |p| p,
            |p| 0.51 * 3_f64.sqrt() * length(p),
        )
    });
    assert_bound("|p| − r", largest);
}

/// ∇(p·p) = 2p is exact.
#[test]
fn sphere_by_its_square_has_its_normal_everywhere() {
    let largest = climb(|numbers| {
        let f = |p: DualVec3| p.dot(p) - Dual::constant(Fixed::ONE);
        implicit(f, any_point(numbers), |p| p, |_| 0.0)
    });
    assert_bound("p·p − r²", largest);
}

/// With ρ = √(x² + y²), the gradient of (ρ − R)² + z² − r² is 2((ρ − R)x/ρ, (ρ − R)y/ρ, z). `of_rho` and
/// `of_slope` are the errors of ρ and of its slopes x/ρ and y/ρ in steps. A product is rounded, and the sum
/// of two equal ones doubles that.
fn torus(
    rho: impl Fn(DualVec3) -> Dual,
    of_rho: impl Fn(f64) -> f64,
    of_slope: impl Fn(f64) -> f64,
) -> f64 {
    climb(|[x, y, z, ring]: [f64; 4]| {
        let p = point_within([x, y, z], 100.0);
        let ring = Fixed::new(50.0 + 40.0 * ring);
        let f = |p: DualVec3| {
            let away = rho(p) - Dual::constant(ring);
            away * away + p.z * p.z - Dual::constant(Fixed::ONE)
        };
        let rho = exact(p.x).hypot(exact(p.y));
        let away = rho - exact(ring);
        // on the ring itself and on the axis there is no normal
        if rho < 1.0 || away.hypot(exact(p.z)) < 1.0 {
            return 0.0;
        }
        let gradient = |[x, y, z]: [f64; 3]| [2.0 * away * x / rho, 2.0 * away * y / rho, 2.0 * z];
        implicit(f, p, gradient, |_| {
            let one = 2.0 * (away.abs() * of_slope(rho) + of_rho(rho) + 0.5);
            one * 2_f64.sqrt()
        })
    })
}

/// ρ is a length and its slopes are those of a direction.
#[test]
fn torus_by_a_length_has_its_normal() {
    let rho = |p: DualVec3| shading::Vec3::new(p.x, p.y, Dual::constant(Fixed::ZERO)).length();
    let largest = torus(rho, |rho| 0.5 + rho / 128.0, |_| 0.51);
    assert_bound("torus by a length", largest);
}

/// x² and y² are rounded, which turns up in ρ divided by 2ρ, and ρ is rounded. The slope is 2x/(2ρ).
#[test]
fn torus_by_a_root_has_its_normal() {
    let of_rho = |rho: f64| 0.5 + 1.01 / (2.0 * rho);
    let rho = |p: DualVec3| (p.x * p.x + p.y * p.y).sqrt();
    let largest = torus(rho, of_rho, |rho| 0.5 + 1.01 * of_rho(rho) / rho);
    assert_bound("torus by a root", largest);
}

/// ∇(x²/a + y²/b − z) = (2x/a, 2y/b, −1), where each quotient is rounded.
#[test]
fn paraboloid_has_its_normal() {
    let largest = climb(|[x, y, z, a, b]: [f64; 5]| {
        let p = point_within([x, y, z], 100.0);
        let [a, b] = [a, b].map(|number| Fixed::new(0.5 + 50.0 * number.abs()));
        let f = |p: DualVec3| p.x * p.x / a + p.y * p.y / b - p.z;
        let gradient = |[x, y, _]: [f64; 3]| [2.0 * x / exact(a), 2.0 * y / exact(b), -1.0];
        implicit(f, p, gradient, |_| 0.5 * 2_f64.sqrt())
    });
    assert_bound("paraboloid", largest);
}

/// The normal of two tangents that are off by `of_u` and `of_v` steps in each component: each error turns
/// its tangent by as much over its length, and the normal by that over the sine between the tangents. Then
/// the tangents are scaled to 16 or more and cut off to a step, and their products are rounded.
fn parametric(
    s: impl Fn(Dual, Dual) -> DualVec3,
    [u, v]: [Fixed; 2],
    [s_u, s_v]: [[f64; 3]; 2],
    [of_u, of_v]: [f64; 2],
) -> f64 {
    let n = normal::parametric(&s, u, v).expect("a normal");
    let product = cross(s_u, s_v);
    let (of_u, of_v) = (of_u / length(s_u), of_v / length(s_v));
    let sine = length(product) / length(s_u) / length(s_v);
    let of_cross = (2.0 / 16.0 + 1.0 / 256.0) / sine;
    let bound = 0.51 + 3_f64.sqrt() * ((of_u + of_v) / sine + of_cross);
    error((*n).into(), product) / bound
}

/// r(cos u sin v, sin u sin v, cos v). A sine or a cosine is off by 0.51 steps, a product of two by both and
/// half a step, and r times that is rounded.
#[test]
fn parametric_sphere_has_its_normal() {
    let largest = climb(|[u, v, r]: [f64; 3]| {
        let [u, v] = [Fixed::new(4.0 * u), Fixed::new(1.5 + 1.4 * v)];
        let r = Fixed::new(1.0 + 99.0 * r.abs());
        let s = |u: Dual, v: Dual| {
            shading::Vec3::new(u.cos() * v.sin(), u.sin() * v.sin(), v.cos()).map(|c| c * r)
        };
        let ((su, cu), (sv, cv)) = (exact(u).sin_cos(), exact(v).sin_cos());
        let tangents = [[-su * sv, cu * sv, 0.0], [cu * cv, su * cv, -sv]];
        let r = exact(r);
        let of = |sum: f64| r * (0.51 * sum + 0.5) + 0.5;
        let errors = [of(sv.abs() + 1.0), of(cv.abs() + 1.0)];
        parametric(s, [u, v], tangents.map(|t| t.map(|c| r * c)), errors)
    });
    assert_bound("parametric sphere", largest);
}

/// ((R + r cos v) cos u, (R + r cos v) sin u, r sin v). The width ρ = R + r cos v is off by 0.51r + 0.5
/// steps, and so is r sin v, each of which is multiplied by a sine or cosine.
#[test]
fn parametric_torus_has_its_normal() {
    let largest = climb(|[u, v, ring, r]: [f64; 4]| {
        let [u, v] = [u, v].map(|number| Fixed::new(4.0 * number));
        let r = Fixed::new(0.5 + 10.0 * r.abs());
        let ring = r + Fixed::new(1.0 + 50.0 * ring.abs());
        let s = |u: Dual, v: Dual| {
            let rho = v.cos() * r + ring;
            shading::Vec3::new(rho * u.cos(), rho * u.sin(), v.sin() * r)
        };
        let ((su, cu), (sv, cv)) = (exact(u).sin_cos(), exact(v).sin_cos());
        let (ring, r) = (exact(ring), exact(r));
        let rho = ring + r * cv;
        let tangents = [
            [-rho * su, rho * cu, 0.0],
            [-r * sv * cu, -r * sv * su, r * cv],
        ];
        let one = 0.51 * r + 0.5;
        let errors = [0.51 * rho + one + 0.5, one + 0.51 * r + 0.5];
        parametric(s, [u, v], tangents, errors)
    });
    assert_bound("parametric torus", largest);
}

/// (u, v, (u² + v²)/k): the slope 2u/k is rounded.
#[test]
fn parametric_paraboloid_has_its_normal() {
    let largest = climb(|[u, v, k]: [f64; 3]| {
        let [u, v] = [u, v].map(|number| Fixed::new(100.0 * number));
        let k = Fixed::new(1.0 + 50.0 * k.abs());
        let s = |u: Dual, v: Dual| shading::Vec3::new(u, v, (u * u + v * v) / k);
        let k = exact(k);
        let tangents = [
            [1.0, 0.0, 2.0 * exact(u) / k],
            [0.0, 1.0, 2.0 * exact(v) / k],
        ];
        parametric(s, [u, v], tangents, [0.5, 0.5])
    });
    assert_bound("parametric paraboloid", largest);
}

/// The triangle (0, 0, 0), (1, 0, 0), (0, 1, t) has the normal (0, −t, 1)/√(1 + t²), whose derivative at
/// t = 0 is (0, −1, 0). The matrix with these edges and (0, 0, 1) as columns takes Z to the same normal. Of
/// any size, both are scaled by a power of two, and their gradients by the same one.
#[test]
fn derivatives_are_scaled_with_their_vectors() {
    for power in [-8, -3, 0, 3, 6] {
        let size = Dual::constant(Fixed::new(2_f64.powi(power)));
        let [x, y, z] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map(|axis: [i16; 3]| {
            shading::Vec3::from(axis.map(|c| Dual::constant(Fixed::from(c))))
        });
        let t = Dual::point(Vec3::ZERO).x;
        let (e1, e2) = (x * size, (y + z * t) * size);
        let zero = shading::Vec3::ZERO;
        let up = shading::UnitVec3::assume_unit(z);
        for n in [
            normal::triangle(zero, e1, e2),
            normal::transformed(up, [e1, e2, z * size]),
        ] {
            let n = n.expect("a normal");
            let slopes = [n.x, n.y, n.z].map(|c| steps(c.gradient.x));
            let errors = [slopes[0], slopes[1] + 65536.0, slopes[2]].map(f64::abs);
            assert!(
                errors.iter().all(|error| *error <= 2.0),
                "{power}: {slopes:?}"
            );
        }
    }
}

/// The window of a range is computed in one rounding, which the value of a dual number keeps.
#[test]
fn a_range_of_dual_numbers_has_the_values_of_plain_ones() {
    let ranged = Attenuation::NONE
        .within(Fixed::from_bits(7 << 15))
        .expect("a range");
    let dual = ranged.cast(Dual::constant);
    for q in (0..8 << 15).step_by(7).map(Fixed::from_bits) {
        assert_eq!(dual.at(Dual::constant(q)).value, ranged.at(q), "{q:?}");
    }
}
