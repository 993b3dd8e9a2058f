//! A whole scene: the Bézier patches of the Utah teapot, their normals, and their shading under
//! four lights.

#[path = "support/teapot.rs"]
mod teapot;

use std::hint::black_box;
use std::time::Duration;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use shading::{
    Attenuation, Exponent, Material, PointLight, Real, Rgb, UnitVec3, Vec3, normal, shade,
};

const STEPS: u16 = 24;

fn teapot(criterion: &mut Criterion) {
    let patches = teapot::patches();
    let parameters: Vec<_> = teapot::parameters(patches.len(), STEPS).collect();
    let mut group = criterion.benchmark_group("teapot");
    group.throughput(Throughput::Elements(parameters.len() as u64));
    group.bench_function("normals", |bencher| {
        bencher.iter(|| {
            for &(patch, u, v) in &parameters {
                let surface = |u, v| teapot::point(&patches[patch], u, v);
                black_box(normal::parametric(surface, u, v));
            }
        });
    });
    let surface: Vec<_> = parameters
        .iter()
        .filter_map(|&(patch, u, v)| {
            let at = |u, v| teapot::point(&patches[patch], u, v);
            Some((
                teapot::point(&patches[patch], u, v),
                normal::parametric(at, u, v)?,
            ))
        })
        .collect();
    shading(&mut group, "f32, integer m", &surface, 50, |x| x);
    shading(&mut group, "f32, real m", &surface, 50.5_f32, |x| x);
    shading(&mut group, "f64, integer m", &surface, 50, f64::from);
    shading(&mut group, "f64, real m", &surface, 50.5_f64, f64::from);
}

/// Four point lights around the pot.
const LIGHTS: [PointLight<f32>; 4] = {
    const fn lamp(x: f32, y: f32, z: f32) -> PointLight<f32> {
        PointLight {
            position: Vec3::new(x, y, z),
            intensity: Rgb::new(1.0, 0.9, 0.8),
            attenuation: Attenuation::<f32>::new(1.0, 0.1, 0.05).unwrap(),
        }
    }
    [
        lamp(5.0, 0.0, 4.0),
        lamp(0.0, -5.0, 6.0),
        lamp(-5.0, 0.0, 1.0),
        lamp(0.0, 5.0, 2.0),
    ]
};

type Group<'a> = criterion::BenchmarkGroup<'a, criterion::measurement::WallTime>;

/// Every model, with the number type that `of` makes from an `f32`.
fn shading<T: Real, M: Exponent<T>>(
    group: &mut Group,
    number: &str,
    surface: &[(Vec3<f32>, UnitVec3<f32>)],
    m: M,
    of: impl Fn(f32) -> T + Copy,
) {
    let surface: Vec<_> = surface
        .iter()
        .map(|&(p, n)| (p.map(of), n.cast(of)))
        .collect();
    let lights = LIGHTS.map(|light| light.cast(of));
    let [k_a, k_d, k_s] = [0.2, 0.6, 0.4].map(|k| Rgb::gray(of(k)));
    let material = Material { k_a, k_d, k_s, m };
    let (i_a, eye) = (Rgb::WHITE, Vec3::new(6.0, -8.0, 5.0).map(of));

    let mut model = |name: &str, shade: &dyn Fn(Vec3<T>, UnitVec3<T>, UnitVec3<T>) -> Rgb<T>| {
        group.bench_function(format!("{name}, {number}"), |bencher| {
            bencher.iter(|| {
                for &(p, n) in &surface {
                    black_box(shade(p, n, (eye - p).unit_or(n)));
                }
            });
        });
    };
    let lit = |p, n| PointLight::all_in_front(&lights, p, n);
    model("lambert", &|p, n, _| {
        shade::lambert(n, &material, i_a, lit(p, n)).total()
    });
    model("phong", &|p, n, v| {
        shade::phong(n, v, &material, i_a, lit(p, n)).total()
    });
    model("blinn_phong", &|p, n, v| {
        shade::blinn_phong(n, v, &material, i_a, lit(p, n)).total()
    });
    let each = |p, n| lights.iter().filter_map(move |light| light.in_front(p, n));
    model("blinn_phong, one light at a time", &|p, n, v| {
        shade::blinn_phong(n, v, &material, i_a, each(p, n)).total()
    });
    let all = |p| lights.iter().map(move |light| light.at(p));
    model("blinn_phong, no early exit", &|p, n, v| {
        shade::blinn_phong(n, v, &material, i_a, all(p)).total()
    });
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .sample_size(20)
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_secs(1));
    targets = teapot
}
criterion_main!(benches);
