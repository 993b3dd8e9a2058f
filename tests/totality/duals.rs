//! Gradients of dual numbers where a derivative does not exist, and just beside.

use kit::Float;
use shading::{Dual, Vec3, normal};

kit::for_f32_and_f64!(
    a_gradient_that_is_finite_is_the_derivative_on_both_sides,
    a_tie_has_the_gradient_of_one_side,
    a_length_of_zero_has_no_gradient,
    an_angle_has_a_gradient_where_it_jumps,
);

type Function<T> = (&'static str, fn(Dual<T>) -> Dual<T>);

/// Every elementary function of one variable, and those of two with either of them fixed.
fn functions<T: Float>() -> Vec<Function<T>> {
    fn of<T: Float>(x: f64) -> Dual<T> {
        Dual::constant(T::of(x))
    }
    vec![
        ("√x", |x| x.sqrt()),
        ("sin", |x| x.sin()),
        ("cos", |x| x.cos()),
        ("tan", |x| x.tan()),
        ("exp", |x| x.exp()),
        ("ln", |x| x.ln()),
        ("1/x", |x| of::<T>(1.0) / x),
        ("x/(-x)", |x| x / -x),
        ("x²/x", |x| x * x / x),
        ("atan2(x, 0)", |x| x.atan2(of::<T>(0.0))),
        ("atan2(0, x)", |x| of::<T>(0.0).atan2(x)),
        ("atan2(x, 1)", |x| x.atan2(of::<T>(1.0))),
        ("atan2(x, x)", |x| x.atan2(x)),
        ("x⁻²", |x| x.powi(-2)),
        ("x⁻¹", |x| x.powi(-1)),
        ("x⁰", |x| x.powi(0)),
        ("x¹", |x| x.powi(1)),
        ("x³", |x| x.powi(3)),
        ("x^-1", |x| x.powf(of::<T>(-1.0))),
        ("x^0", |x| x.powf(of::<T>(0.0))),
        ("x^½", |x| x.powf(of::<T>(0.5))),
        ("x^1", |x| x.powf(of::<T>(1.0))),
        ("x^2½", |x| x.powf(of::<T>(2.5))),
        ("x^2", |x| x.powf(of::<T>(2.0))),
        ("x^x", |x| x.powf(x)),
        ("0^x", |x| of::<T>(0.0).powf(x)),
        ("1^x", |x| of::<T>(1.0).powf(x)),
        ("(-1)^x", |x| of::<T>(-1.0).powf(x)),
        ("2^x", |x| of::<T>(2.0).powf(x)),
    ]
}

/// At the points where functions break: the gradient is not finite, or it is the limit of differences
/// to both sides.
fn a_gradient_that_is_finite_is_the_derivative_on_both_sides<T: Float>() {
    let step = T::of((T::U).sqrt());
    let mut wrong = vec![];
    for (name, f) in functions::<T>() {
        for x in [0.0, -0.0, 1.0, -1.0, 0.5, -0.5, 2.0, -2.0, 3.0].map(T::of) {
            let variable = |x| Dual {
                value: x,
                gradient: Vec3::new(T::ONE, T::ZERO, T::ZERO),
            };
            let at = f(variable(x));
            let slope = at.gradient.x;
            if !Into::<f64>::into(slope).is_finite() {
                continue;
            }
            for there in [x + step, x - step] {
                let value = f(Dual::constant(there)).value;
                if Into::<f64>::into(value).is_nan() {
                    continue; // outside of the function's domain
                }
                let difference = (value - at.value) / (there - x);
                let off = (difference - slope).abs();
                let tolerance = T::of(100.0) * step * (T::ONE + slope.abs());
                let is_right = off <= tolerance;
                if !is_right {
                    wrong.push(format!(
                        "{name} at {x:?}: {slope:?}, but {difference:?} to {there:?}"
                    ));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The gradient of `max` is that of the second number, and the gradient of `min` that of the first.
fn a_tie_has_the_gradient_of_one_side<T: Float>() {
    let p = Dual::point(Vec3::<T>::ZERO);
    assert_eq!(p.x.max(p.y).gradient, p.y.gradient);
    assert_eq!(p.x.min(p.y).gradient, p.x.gradient);
    // so that an edge of two solids has the normal of one of them
    let [union, intersection] = [
        normal::implicit(|p| p.x.min(p.y), Vec3::<T>::ZERO),
        normal::implicit(|p| p.x.max(p.y), Vec3::ZERO),
    ];
    assert_eq!(
        [union, intersection].map(Option::unwrap),
        [shading::UnitVec3::X, shading::UnitVec3::Y]
    );
}

fn a_length_of_zero_has_no_gradient<T: Float>() {
    let length = Dual::point(Vec3::<T>::ZERO).x;
    let length = Vec3::new(length, length, length).length();
    assert_eq!(length.value, T::ZERO);
    assert!(!Into::<f64>::into(length.gradient.x).is_finite());
}

/// Left of the origin, `atan2` jumps from −π to π, and the angle itself goes on: 1/x at y = 0.
fn an_angle_has_a_gradient_where_it_jumps<T: Float>() {
    for y in [T::ZERO, -T::ZERO] {
        let p = Dual::point(Vec3::new(T::of(-2.0), y, T::ZERO));
        let angle = p.y.atan2(p.x);
        assert!((angle.value.abs() - T::of(std::f64::consts::PI)).abs() <= T::of(4.0 * T::U));
        assert_eq!(
            angle.gradient.map(|x| x + T::ZERO),
            Vec3::new(T::ZERO, T::of(-0.5), T::ZERO)
        );
    }
}
