//! Shades many points, several side by side. Each has the bits that it has alone.
#![allow(
    clippy::inline_always,
    reason = "what is not inlined into `for_avx2` is not compiled for AVX2"
)]

use std::ops::Range;

use shading::number::{Mask, Measured};
use shading::{IncidentLight, Lobe, Material, Real, Rgb, Shaded, UnitVec3, Vec3, shade};

use crate::number::{Number, Pack};
use crate::scene::{Model, Scene};
use crate::threads::{self, SPAN};

/// Where the colors of some points go: their sum, or the ambient, the diffuse and the specular part.
pub enum Out<'a, T> {
    Total(&'a mut [[T; 3]]),
    Parts([&'a mut [[T; 3]]; 3]),
}

impl<T> Out<'_, T> {
    fn len(&self) -> usize {
        match self {
            Self::Total(total) => total.len(),
            Self::Parts([ambient, ..]) => ambient.len(),
        }
    }

    /// Cuts it into spans.
    fn spans(self) -> Vec<Self> {
        match self {
            Self::Total(total) => total.chunks_mut(SPAN).map(Self::Total).collect(),
            Self::Parts(parts) => {
                let [a, d, s] = parts.map(|part| part.chunks_mut(SPAN));
                a.zip(d)
                    .zip(s)
                    .map(|((a, d), s)| Self::Parts([a, d, s]))
                    .collect()
            }
        }
    }
}

impl<T: Number> Out<'_, T> {
    /// The colors of `here` points, from `done` on.
    #[inline(always)]
    fn put<P: Pack<Lane = T>>(&mut self, done: usize, here: usize, shaded: Shaded<P>) {
        let put = |out: &mut [[T; 3]], color: Rgb<P>| {
            // of a constant length, unless it is the rest
            if here == P::COUNT {
                P::put(color.into(), &mut out[done..done + P::COUNT]);
            } else {
                P::put(color.into(), &mut out[done..done + here]);
            }
        };
        match self {
            Self::Total(total) => put(total, shaded.total()),
            Self::Parts([ambient, diffuse, specular]) => {
                put(ambient, shaded.ambient);
                put(diffuse, shaded.diffuse);
                put(specular, shaded.specular);
            }
        }
    }
}

/// Shades all points of the scene, whose lights these are.
pub fn shade_all<T: Number>(scene: &Scene<T>, lights: &[shading::Light<T>], out: Out<T>) {
    let spans = out.spans().into_iter().enumerate().collect();
    threads::each(spans, scene.count, |(i, out)| {
        #[cfg(target_arch = "x86_64")]
        if is_x86_feature_detected!("avx2") {
            // SAFETY: the processor has AVX2
            return unsafe { for_avx2(scene, lights, i * SPAN, out) };
        }
        for_any(scene, lights, i * SPAN, out);
    });
}

/// For processors with AVX2: everything it calls is inlined, and so compiled for AVX2.
#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn for_avx2<T: Number>(scene: &Scene<T>, lights: &[shading::Light<T>], start: usize, out: Out<T>) {
    span::<T::Avx2>(scene, lights, start, out);
}

#[inline(never)]
fn for_any<T: Number>(scene: &Scene<T>, lights: &[shading::Light<T>], start: usize, out: Out<T>) {
    span::<T::Lanes>(scene, lights, start, out);
}

/// As on a processor without AVX2.
#[cfg(test)]
pub fn span_for_any<T: Number>(scene: &Scene<T>, lights: &[shading::Light<T>], out: &mut [[T; 3]]) {
    for_any(scene, lights, 0, Out::Total(out));
}

/// The rows of an array for a pack of points.
struct Rows<'a, P: Pack> {
    rows: &'a [[P::Lane; 3]],
    one: [P; 3],
}

impl<'a, P: Pack> Rows<'a, P> {
    #[inline(always)]
    fn new(rows: &'a [[P::Lane; 3]]) -> Self {
        let first = rows.first().copied().unwrap_or([P::Lane::ZERO; 3]);
        let one = first.map(P::splat);
        Self { rows, one }
    }

    /// Those of `here` points from `first` on. Copies of the last one fill the pack.
    #[inline(always)]
    fn at(&self, first: usize, here: usize) -> [P; 3] {
        if self.rows.len() == 1 {
            return self.one;
        }
        let rows = &self.rows[first..first + here];
        if here == P::COUNT {
            return P::columns(rows);
        }
        [0, 1, 2].map(|c| P::gather(|lane| rows[lane.min(here - 1)][c]))
    }
}

/// A model with its shininess: which sum a pack of points takes.
trait Formula<P: Pack>: Copy {
    fn sum(
        self,
        directions: [UnitVec3<P>; 2],
        material: &Reflectances<P>,
        i_a: Rgb<P>,
        lights: impl Iterator<Item = IncidentLight<P>>,
    ) -> Shaded<P>;
}

type Reflectances<P> = shading::Material<P, ()>;

#[derive(Clone, Copy)]
struct Lambert;

#[derive(Clone, Copy)]
struct Phong<M>(M);

#[derive(Clone, Copy)]
struct BlinnPhong<M>(M);

#[inline(always)]
fn with<P: Pack, M>(m: M, &Reflectances { k_a, k_d, k_s, .. }: &Reflectances<P>) -> Material<P, M> {
    Material { k_a, k_d, k_s, m }
}

impl<P: Pack> Formula<P> for Lambert {
    #[inline(always)]
    fn sum(
        self,
        [n, _]: [UnitVec3<P>; 2],
        material: &Reflectances<P>,
        i_a: Rgb<P>,
        lights: impl Iterator<Item = IncidentLight<P>>,
    ) -> Shaded<P> {
        shade::lambert(n, &with(1, material), i_a, lights)
    }
}

impl<P: Pack, M: Lobe<P>> Formula<P> for Phong<M> {
    #[inline(always)]
    fn sum(
        self,
        [n, v]: [UnitVec3<P>; 2],
        material: &Reflectances<P>,
        i_a: Rgb<P>,
        lights: impl Iterator<Item = IncidentLight<P>>,
    ) -> Shaded<P> {
        shade::phong(n, v, &with(self.0, material), i_a, lights)
    }
}

impl<P: Pack, M: Lobe<P>> Formula<P> for BlinnPhong<M> {
    #[inline(always)]
    fn sum(
        self,
        [n, v]: [UnitVec3<P>; 2],
        material: &Reflectances<P>,
        i_a: Rgb<P>,
        lights: impl Iterator<Item = IncidentLight<P>>,
    ) -> Shaded<P> {
        shade::blinn_phong(n, v, &with(self.0, material), i_a, lights)
    }
}

/// The points from `start` on, as many as `out` has room for: run by run of the same shininess.
#[inline(always)]
fn span<P: Pack>(
    scene: &Scene<P::Lane>,
    lights: &[shading::Light<P::Lane>],
    start: usize,
    mut out: Out<P::Lane>,
) {
    let lights: Vec<_> = lights.iter().map(|light| light.cast(P::splat)).collect();
    let count = out.len();
    let mut done = 0;
    while done < count {
        let (m, run) = match scene.m {
            &[m] => (m, count),
            ms => {
                let ms = &ms[start + done..start + count];
                let run = ms.iter().take_while(|&&m| m == ms[0]).count();
                (ms[0], done + run.max(1))
            }
        };
        let points = Points {
            scene,
            lights: &lights,
            start,
            run: done..run,
        };
        match (scene.model, m.whole()) {
            (Model::Lambert, _) => points.shade(Lambert, &mut out),
            (Model::Phong, Some(m)) => points.shade(Phong(m), &mut out),
            (Model::Phong, None) => points.shade(Phong(m), &mut out),
            (Model::BlinnPhong, Some(m)) => points.shade(BlinnPhong(m), &mut out),
            (Model::BlinnPhong, None) => points.shade(BlinnPhong(m), &mut out),
        }
        done = run;
    }
}

/// Points with the same shininess.
struct Points<'a, P: Pack> {
    scene: &'a Scene<'a, P::Lane>,
    lights: &'a [shading::Light<P>],
    /// The index of the first point of `out`.
    start: usize,
    /// The points, counted from there.
    run: Range<usize>,
}

impl<P: Pack> Points<'_, P> {
    #[inline(always)]
    fn shade(self, formula: impl Formula<P>, out: &mut Out<P::Lane>) {
        let Self { scene, .. } = self;
        let (points, normals) = (Rows::<P>::new(scene.points), Rows::<P>::new(scene.normals));
        let (eye, ambient) = (Rows::<P>::new(scene.eye), Rows::<P>::new(scene.ambient));
        let (k_a, k_d) = (Rows::<P>::new(scene.k_a), Rows::<P>::new(scene.k_d));
        let k_s = Rows::<P>::new(scene.k_s);
        let visible = scene.visible.unwrap_or(&[]);
        let columns = visible.len() / scene.lights.len().max(1);
        for done in self.run.clone().step_by(P::COUNT) {
            let (first, here) = (self.start + done, P::COUNT.min(self.run.end - done));
            let p = Vec3::from(points.at(first, here));
            let (n, has_n) = direction(normals.at(first, here).into());
            let (v, has_v) = direction(Vec3::from(eye.at(first, here)) - p);
            let material = Reflectances {
                k_a: k_a.at(first, here).into(),
                k_d: k_d.at(first, here).into(),
                k_s: k_s.at(first, here).into(),
                m: (),
            };
            let i_a = ambient.at(first, here).into();
            let arriving = self.lights.iter().enumerate().filter_map(|(k, light)| {
                let light = light.at(p);
                if columns == 0 {
                    return Some(light);
                }
                let fraction = P::gather(|lane| {
                    let point = first + lane.min(here - 1);
                    visible[k * columns + if columns == 1 { 0 } else { point }]
                });
                let reaches = fraction.above(P::ZERO).any();
                reaches.then(|| light * fraction)
            });
            let shaded = formula.sum([n, v], &material, i_a, arriving);
            let seen = |x: P| has_n.select(has_v.select(x, P::ZERO), P::ZERO);
            let shaded = Shaded {
                ambient: shaded.ambient.map(seen),
                diffuse: shaded.diffuse.map(seen),
                specular: shaded.specular.map(seen),
            };
            out.put(done, here, shaded);
        }
    }
}

/// The direction of a vector, and where it has one.
#[inline(always)]
fn direction<P: Pack>(vector: Vec3<P>) -> (UnitVec3<P>, P::Mask) {
    let Measured { w, w_length, .. } = P::measured(vector);
    let exists = w_length.above(P::ZERO);
    let [x, y, z] = <[P; 3]>::from(w / w_length);
    let (x, y) = (exists.select(x, P::ZERO), exists.select(y, P::ZERO));
    let unit = Vec3::new(x, y, exists.select(z, P::ONE));
    (UnitVec3::assume_unit(unit), exists)
}
