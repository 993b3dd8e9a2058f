//! The kernels of the module `shading` for Python. The package around them, `python/shading`,
//! brings the arrays into shape and explains the functions. Here, every array is contiguous and has
//! as many rows as there are points, or one.

use numpy::{Element, PyArray1, PyReadonlyArray1, PyReadonlyArray2, PyReadonlyArray3};
use pyo3::exceptions::{PyMemoryError, PyValueError};
use pyo3::prelude::*;

use crate::c::rgba;
use crate::implicit::Grid;
use crate::kernel::{Out, shade_all};
use crate::light::Light;
use crate::normals;
use crate::number::Number;
use crate::problem::Problem;
use crate::scene::{Model, Scene};
use crate::threads;

/// The numbers of a light, in the order of [`Light`].
type Numbers = [f64; 20];

fn light<T: Number>(numbers: &Numbers) -> Light<T> {
    let vector = |first: usize| [0, 1, 2].map(|i| T::of(numbers[first + i]));
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // 0, 1 or 2
    let whole = |index: usize| numbers[index] as u32;
    Light {
        kind: whole(0),
        position: vector(1),
        toward: vector(4),
        axis: vector(7),
        intensity: vector(10),
        attenuation: vector(13),
        range: T::of(numbers[16]),
        inner: T::of(numbers[17]),
        outer: T::of(numbers[18]),
        gltf: whole(19),
    }
}

/// The sentence, and the index of the row, of which the package knows the axes.
#[allow(clippy::needless_pass_by_value)] // as `map_err` wants it
fn refused(problem: Problem) -> PyErr {
    PyValueError::new_err((problem.message, problem.index))
}

fn triples<'a, T: Element>(array: &'a PyReadonlyArray2<'_, T>) -> PyResult<&'a [[T; 3]]> {
    Ok(array.as_slice()?.as_chunks().0)
}

/// Refuses what would need more memory than there is, which would end the process.
fn check_memory<T>(count: usize) -> PyResult<()> {
    Vec::<T>::new()
        .try_reserve_exact(count)
        .map_err(|_| PyMemoryError::new_err(format!("no memory for a result of {count} numbers")))
}

/// What `compute` writes into an array of so many numbers, without Python's lock.
fn filled<T: Number + Element>(
    py: Python,
    numbers: usize,
    compute: impl FnOnce(&mut [T]) -> Result<(), Problem> + Send,
) -> PyResult<Bound<PyArray1<T>>> {
    check_memory::<T>(numbers)?;
    let computed = py.detach(|| {
        let mut out = vec![T::ZERO; numbers];
        compute(&mut out).map(|()| out)
    });
    Ok(PyArray1::from_vec(py, computed.map_err(refused)?))
}

/// The colors of all points; with `parts`, the ambient ones of all points, then the diffuse, then
/// the specular ones.
#[allow(clippy::too_many_arguments)]
fn shade<'py, T: Number + Element>(
    py: Python<'py>,
    model: u32,
    count: usize,
    lights: &[Numbers],
    places: [&PyReadonlyArray2<'py, T>; 3],
    colors: [&PyReadonlyArray2<'py, T>; 4],
    m: &PyReadonlyArray1<'py, T>,
    visible: Option<&PyReadonlyArray1<'py, T>>,
    parts: bool,
) -> PyResult<Bound<'py, PyArray1<T>>> {
    let lights: Vec<Light<T>> = lights.iter().map(light).collect();
    let [points, normals, eye] = places.map(triples);
    let [k_a, k_d, k_s, ambient] = colors.map(triples);
    let scene = Scene {
        model: Model::of(model).map_err(refused)?,
        count,
        points: points?,
        normals: normals?,
        eye: eye?,
        k_a: k_a?,
        k_d: k_d?,
        k_s: k_s?,
        m: m.as_slice()?,
        ambient: ambient?,
        lights: &lights,
        visible: visible.map(|fractions| fractions.as_slice()).transpose()?,
    };
    filled(py, count.saturating_mul(if parts { 9 } else { 3 }), |out| {
        let lights = scene.checked()?;
        let rows = out.as_chunks_mut().0;
        let out = if parts {
            let (ambient, rest) = rows.split_at_mut(count);
            let (diffuse, specular) = rest.split_at_mut(count);
            Out::Parts([ambient, diffuse, specular])
        } else {
            Out::Total(rows)
        };
        shade_all(&scene, &lights, out);
        Ok(())
    })
}

fn field<'py, T: Number + Element>(
    py: Python<'py>,
    z: &PyReadonlyArray2<'py, T>,
    dx: T,
    dy: T,
) -> PyResult<Bound<'py, PyArray1<T>>> {
    let columns = z.as_array().ncols();
    let z = z.as_slice()?;
    filled(py, 3 * z.len(), |out| {
        normals::check_field(z, dx, dy)?;
        normals::height_field(z, columns, dx, dy, out.as_chunks_mut().0);
        Ok(())
    })
}

fn implicit<'py, T: Number + Element>(
    py: Python<'py>,
    values: &PyReadonlyArray3<'py, T>,
    points: &PyReadonlyArray2<'py, T>,
    steps: [T; 3],
) -> PyResult<Bound<'py, PyArray1<T>>> {
    let (layers, rows, columns) = values.as_array().dim();
    let points = triples(points)?;
    let grid = Grid {
        values: values.as_slice()?,
        counts: [columns, rows, layers],
        steps,
    };
    filled(py, 3 * points.len(), |out| {
        grid.check(points)?;
        grid.normals(points, out.as_chunks_mut().0);
        Ok(())
    })
}

fn mesh<'py, T: Number + Element>(
    py: Python<'py>,
    vertices: &PyReadonlyArray2<'py, T>,
    faces: &PyReadonlyArray2<'py, u32>,
    crease: Option<T>,
) -> PyResult<Bound<'py, PyArray1<T>>> {
    let (vertices, faces) = (triples(vertices)?, triples(faces)?);
    let numbers = crease.map_or(3 * vertices.len(), |_| 9 * faces.len());
    filled(py, numbers, |out| {
        normals::check_mesh(vertices, faces)?;
        let rows = out.as_chunks_mut().0;
        if let Some(crease) = crease {
            normals::check_crease(crease)?;
            normals::of_corners(vertices, faces, crease, rows.as_chunks_mut().0);
        } else {
            normals::of_vertices(vertices, faces, rows);
        }
        Ok(())
    })
}

macro_rules! kernels {
    ($($float:ident: $shade:ident, $field:ident, $implicit:ident, $mesh:ident);*) => {$(
        #[pyfunction]
        #[pyo3(signature = (model, count, lights, points, normals, eye, k_a, k_d, k_s, ambient, m, visible, parts))]
        #[allow(clippy::too_many_arguments, clippy::needless_pass_by_value)]
        fn $shade<'py>(
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
            visible: Option<PyReadonlyArray1<'py, $float>>,
            parts: bool,
        ) -> PyResult<Bound<'py, PyArray1<$float>>> {
            let places = [&points, &normals, &eye];
            let colors = [&k_a, &k_d, &k_s, &ambient];
            shade(py, model, count, &lights, places, colors, &m, visible.as_ref(), parts)
        }

        #[pyfunction]
        #[allow(clippy::needless_pass_by_value)]
        fn $field<'py>(
            py: Python<'py>,
            z: PyReadonlyArray2<'py, $float>,
            dx: $float,
            dy: $float,
        ) -> PyResult<Bound<'py, PyArray1<$float>>> {
            field(py, &z, dx, dy)
        }

        #[pyfunction]
        #[allow(clippy::needless_pass_by_value)]
        fn $implicit<'py>(
            py: Python<'py>,
            values: PyReadonlyArray3<'py, $float>,
            points: PyReadonlyArray2<'py, $float>,
            steps: [$float; 3],
        ) -> PyResult<Bound<'py, PyArray1<$float>>> {
            implicit(py, &values, &points, steps)
        }

        #[pyfunction]
        #[pyo3(signature = (vertices, faces, crease))]
        #[allow(clippy::needless_pass_by_value)]
        fn $mesh<'py>(
            py: Python<'py>,
            vertices: PyReadonlyArray2<'py, $float>,
            faces: PyReadonlyArray2<'py, u32>,
            crease: Option<$float>,
        ) -> PyResult<Bound<'py, PyArray1<$float>>> {
            mesh(py, &vertices, &faces, crease)
        }
    )*};
}
kernels!(
    f32: shade_f32, field_f32, implicit_f32, mesh_f32;
    f64: shade_f64, field_f64, implicit_f64, mesh_f64
);

/// Refuses what is not a light.
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
fn check_light(numbers: Numbers) -> PyResult<()> {
    light::<f64>(&numbers).checked().map(drop).map_err(refused)
}

/// Makes each row of bytes or numbers from three, without Python's lock.
fn converted<'py, A: Element + Copy + Sync, B: Element + Copy + Send, const N: usize>(
    py: Python<'py>,
    rows: &PyReadonlyArray2<'py, A>,
    zero: B,
    f: impl Fn([A; 3]) -> [B; N] + Send + Sync,
) -> PyResult<Bound<'py, PyArray1<B>>> {
    let rows = triples(rows)?;
    let convert = || {
        let mut out = vec![[zero; N]; rows.len()];
        threads::map(rows, &mut out, f);
        out.into_flattened()
    };
    Ok(PyArray1::from_vec(py, py.detach(convert)))
}

#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
fn to_srgb8<'py>(
    py: Python<'py>,
    colors: PyReadonlyArray2<'py, f32>,
) -> PyResult<Bound<'py, PyArray1<u8>>> {
    converted(py, &colors, 0, |color| shading::Rgb::from(color).to_srgb8())
}

#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
fn to_srgba8<'py>(
    py: Python<'py>,
    colors: PyReadonlyArray2<'py, f32>,
) -> PyResult<Bound<'py, PyArray1<u8>>> {
    converted(py, &colors, 0, rgba)
}

#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
fn from_srgb8<'py>(
    py: Python<'py>,
    bytes: PyReadonlyArray2<'py, u8>,
) -> PyResult<Bound<'py, PyArray1<f32>>> {
    converted(py, &bytes, 0.0, |bytes| {
        shading::Rgb::from_srgb8(bytes).into()
    })
}

#[pymodule(name = "_native")]
mod module {
    #[pymodule_export]
    use super::{
        check_light, field_f32, field_f64, from_srgb8, implicit_f32, implicit_f64, mesh_f32,
        mesh_f64, shade_f32, shade_f64, to_srgb8, to_srgba8,
    };
}
