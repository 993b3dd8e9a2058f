//! The kernels of the module `shading` for Python. The package around them, `python/shading`,
//! checks the arguments, brings the arrays into shape and explains the functions. Here, every array
//! is contiguous and has as many rows as there are points, or one.

use numpy::{Element, PyArray1, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::scene::{Light, Material, Model, Number, Place, shaded};

/// The numbers of a light, in the order of [`Light`].
type Numbers = [f64; 17];

fn light<T: Number>(numbers: &Numbers) -> Option<shading::Light<T>> {
    let vector = |first: usize| [0, 1, 2].map(|i| T::of(numbers[first + i]));
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // 0, 1 or 2
    let whole = |index: usize| numbers[index] as u32;
    Light {
        kind: whole(0),
        position: vector(1),
        direction: vector(4),
        intensity: vector(7),
        attenuation: vector(10),
        range: T::of(numbers[13]),
        inner: T::of(numbers[14]),
        outer: T::of(numbers[15]),
        gltf: whole(16),
    }
    .checked()
}

/// One row for each point, or one for all.
struct Rows<'a, R>(&'a [R]);

impl<R: Copy> Rows<'_, R> {
    fn at(&self, i: usize) -> R {
        self.0[if self.0.len() == 1 { 0 } else { i }]
    }
}

fn triples<'a, T: Element>(array: &'a PyReadonlyArray2<'_, T>) -> PyResult<Rows<'a, [T; 3]>> {
    Ok(Rows(array.as_slice()?.as_chunks().0))
}

/// The colors of all points; with `parts`, the ambient ones of all points, then the diffuse, then
/// the specular ones.
#[allow(clippy::too_many_arguments)]
fn shade<'py, T: Number + Element>(
    py: Python<'py>,
    model: u32,
    count: usize,
    lights: &[Numbers],
    points: &PyReadonlyArray2<'py, T>,
    normals: &PyReadonlyArray2<'py, T>,
    eye: &PyReadonlyArray2<'py, T>,
    [k_a, k_d, k_s, ambient]: [&PyReadonlyArray2<'py, T>; 4],
    m: &PyReadonlyArray1<'py, T>,
    visible: &PyReadonlyArray2<'py, T>,
    parts: bool,
) -> PyResult<Bound<'py, PyArray1<T>>> {
    let refuse = |message: String| PyValueError::new_err(message);
    let model = Model::of(model).map_err(|_| refuse("model: not a model".to_owned()))?;
    let lights = lights.iter().enumerate().map(|(i, numbers)| {
        let too_small = || {
            refuse(format!(
                "lights[{i}]: its numbers are too small or too large for this dtype"
            ))
        };
        light::<T>(numbers).ok_or_else(too_small)
    });
    let lights = lights.collect::<PyResult<Vec<_>>>()?;
    let (points, normals, eye) = (triples(points)?, triples(normals)?, triples(eye)?);
    let (k_a, k_d, k_s, ambient) = (
        triples(k_a)?,
        triples(k_d)?,
        triples(k_s)?,
        triples(ambient)?,
    );
    let m = Rows(m.as_slice()?);
    let columns = visible.as_array().ncols();
    let visible = visible.as_slice()?;
    let seen = |light: usize, i: usize| visible[light * columns + if columns == 1 { 0 } else { i }];
    let shade = move || {
        let mut out = vec![T::ZERO; count * if parts { 9 } else { 3 }];
        for i in 0..count {
            let place = Place {
                point: points.at(i),
                normal: normals.at(i),
                eye: eye.at(i),
            };
            let material = Material {
                k_a: k_a.at(i),
                k_d: k_d.at(i),
                k_s: k_s.at(i),
                m: m.at(i),
            };
            let arriving = lights.iter().enumerate().filter_map(|(k, light)| {
                let fraction = seen(k, i);
                (fraction > T::ZERO).then(|| light.at(place.point) * fraction)
            });
            let i_a = shading::Rgb::from(ambient.at(i));
            let result = shaded(model, place, &material, i_a, arriving);
            let mut put = |part: usize, light: shading::Rgb<T>| {
                let start = 3 * (part * count + i);
                out[start..start + 3].copy_from_slice(&<[T; 3]>::from(light));
            };
            if parts {
                put(0, result.ambient);
                put(1, result.diffuse);
                put(2, result.specular);
            } else {
                put(0, result.total());
            }
        }
        out
    };
    Ok(PyArray1::from_vec(py, py.detach(shade)))
}

macro_rules! kernels {
    ($($name:ident: $float:ident),*) => {$(
        #[pyfunction]
        #[allow(clippy::too_many_arguments, clippy::needless_pass_by_value)]
        fn $name<'py>(
            py: Python<'py>,
            model: u32,
            count: usize,
            lights: Vec<Numbers>,
            points: PyReadonlyArray2<'py, $float>,
            normals: PyReadonlyArray2<'py, $float>,
            eye: PyReadonlyArray2<'py, $float>,
            k_a: PyReadonlyArray2<'py, $float>,
            k_d: PyReadonlyArray2<'py, $float>,
            k_s: PyReadonlyArray2<'py, $float>,
            ambient: PyReadonlyArray2<'py, $float>,
            m: PyReadonlyArray1<'py, $float>,
            visible: PyReadonlyArray2<'py, $float>,
            parts: bool,
        ) -> PyResult<Bound<'py, PyArray1<$float>>> {
            let colors = [&k_a, &k_d, &k_s, &ambient];
            shade(py, model, count, &lights, &points, &normals, &eye, colors, &m, &visible, parts)
        }
    )*};
}
kernels!(shade_f32: f32, shade_f64: f64);

/// Whether the numbers are a light's.
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
fn is_light(numbers: Numbers) -> bool {
    light::<f64>(&numbers).is_some()
}

#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
fn to_srgb8<'py>(
    py: Python<'py>,
    colors: PyReadonlyArray2<'py, f32>,
) -> PyResult<Bound<'py, PyArray1<u8>>> {
    let colors = triples(&colors)?.0;
    let encode = || {
        let bytes = colors
            .iter()
            .flat_map(|&color| shading::Rgb::from(color).to_srgb8());
        bytes.collect::<Vec<u8>>()
    };
    Ok(PyArray1::from_vec(py, py.detach(encode)))
}

#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
fn from_srgb8<'py>(
    py: Python<'py>,
    bytes: PyReadonlyArray2<'py, u8>,
) -> PyResult<Bound<'py, PyArray1<f32>>> {
    let bytes = triples(&bytes)?.0;
    let decode = || {
        let colors = bytes
            .iter()
            .flat_map(|&bytes| <[f32; 3]>::from(shading::Rgb::from_srgb8(bytes)));
        colors.collect::<Vec<f32>>()
    };
    Ok(PyArray1::from_vec(py, py.detach(decode)))
}

#[pymodule(name = "_native")]
mod module {
    #[pymodule_export]
    use super::{from_srgb8, is_light, shade_f32, shade_f64, to_srgb8};
}
