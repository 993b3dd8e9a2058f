//! Gradients within their rounding errors, which [`Running`] bounds operation by operation. A search climbs
//! to the largest share of a bound.

use shading::{Dual, Real};
use support::running::{Bounded, Running};

use crate::formulas::COUNT;
use crate::plain::Plain;
use crate::{Random, Scene, all, dual, four, resize};

/// The largest share that a search finds. It starts at random scenes and takes every step that does not
/// lead down; a step changes one number. The first three vectors are multiplied by a power of two with one of
/// these exponents.
fn largest(sizes: [i32; 3], share: impl Fn(&Scene) -> f64) -> f64 {
    let mut random = Random(1);
    let mut below = |count: usize| usize::try_from(random.bits() % count as u64).expect("small");
    let share = |scene: &Scene, size| {
        let mut scene = *scene;
        resize(&mut scene, size);
        share(&scene)
    };
    let hills = (0..2).flat_map(|hill| sizes.map(|size| (hill, size)));
    let heights = hills.map(|(hill, size)| {
        let mut top = Random(hill).scene(0);
        let mut height = share(&top, size);
        for _ in 0..STEPS {
            let mut scene = top;
            let number = &mut scene[below(COUNT)][below(4)];
            let digit = 2_f64.powi(-i32::try_from(below(9)).expect("small"));
            *number = (*number + [digit, -digit][below(2)]).clamp(-4.0, 4.0);
            let found = share(&scene, size);
            if found >= height {
                (top, height) = (scene, found);
            }
        }
        height
    });
    heights.fold(0.0, f64::max)
}

/// The steps of each climb.
const STEPS: u32 = 100;

/// How far two results are apart, as a share of the most that rounding explains. Results and bounds beyond
/// the range of single precision, where sums and quotients overflow, are left out.
fn share(a: f64, b: f64, bound: f64) -> f64 {
    let most = f64::from(f32::MAX);
    if a == b || a.abs().max(b.abs()).max(bound) >= most || bound.is_nan() {
        0.0
    } else {
        (a - b).abs() / bound
    }
}

/// The largest share among the results.
fn of_all<T: Real, U: Real>(
    ours: Vec<Dual<T>>,
    others: Vec<Dual<U>>,
    share: impl Fn(T, U) -> f64,
) -> f64 {
    let pairs = ours.into_iter().zip(others);
    let pairs = pairs.flat_map(|(ours, others)| four(ours).into_iter().zip(four(others)));
    pairs
        .map(|(ours, other)| share(ours, other))
        .fold(0.0, f64::max)
}

/// Single precision against the same derivative in double precision.
#[test]
fn gradients_in_single_precision_agree_with_double() {
    let found = largest([0, -70, 70], |scene| {
        let ours = all(&scene.map(dual::<f32>));
        let others = all(&scene.map(dual::<Running<24>>));
        of_all(ours, others, |ours, other| {
            // a denominator that overflows, and so a quotient that is 0
            let underflow = f64::from(f32::MIN_POSITIVE);
            share(ours.into(), other.value(), other.error() + underflow)
        })
    });
    println!("{found:.3} of the bound");
    assert!((0.1..=1.0).contains(&found), "{found}");
}

/// The derivative of each operation against that of its algorithm, which a number without the operation takes.
#[test]
fn derivatives_are_those_of_the_algorithms() {
    let found = largest([0, -20, 20], |scene| {
        let ours = all(&scene.map(dual::<Running<53>>));
        let others = all(&scene.map(|number| Plain(dual::<Running<53>>(number))));
        let others = others.into_iter().map(|Plain(dual)| dual).collect();
        of_all(ours, others, |a, b| {
            share(a.value(), b.value(), a.error() + b.error())
        })
    });
    println!("{found:.3} of the bound");
    assert!((0.01..=1.0).contains(&found), "{found}");
}
