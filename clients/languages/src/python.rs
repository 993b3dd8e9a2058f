//! The module `shading` for Python, on NumPy's arrays.

use numpy::{
    AllowTypeChange, PyArray1, PyArrayDyn, PyArrayLikeDyn, PyArrayMethods, PyUntypedArrayMethods,
};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::scene::{Light, Material, Model, Scene};

type Array<'py> = PyArrayLikeDyn<'py, f32, AllowTypeChange>;
type Vector = [f32; 3];

const NOTHING: Light = Light {
    kind: 0,
    position: [0.0; 3],
    direction: [0.0; 3],
    intensity: [0.0; 3],
    attenuation: [1.0, 0.0, 0.0],
    range: f32::INFINITY,
    inner: 0.0,
    outer: 0.0,
    unsquared: 0,
};

/// A light, made by `directional`, `point` or `spot`.
#[pyclass(name = "Light", module = "shading", frozen)]
struct PyLight(Light);

fn checked(light: Light) -> PyResult<PyLight> {
    let message = "the intensity and the attenuation must be finite and not negative, and not all of the attenuation 0; the \
                   direction must not be 0, the range above 0, and 0 <= inner <= outer <= pi";
    let _ = light
        .checked()
        .ok_or_else(|| PyValueError::new_err(message))?;
    Ok(PyLight(light))
}

/// A light so far away that its rays are parallel.
///
/// toward: the direction to the light, three numbers of any length.
/// intensity: linear red, green and blue.
#[pyfunction]
fn directional(toward: Vector, intensity: Vector) -> PyResult<PyLight> {
    checked(Light {
        direction: toward,
        intensity,
        ..NOTHING
    })
}

/// A light that shines from a point, with the intensity I/(a + b q + c q²) at the distance q.
///
/// position: three numbers, in the unit of the points.
/// intensity: linear red, green and blue.
/// attenuation: a, b and c; b per unit of length, c per its square.
/// range: the distance at which the light ends, in the unit of the points.
#[pyfunction]
#[pyo3(signature = (position, intensity, attenuation=[1.0, 0.0, 0.0], range=f32::INFINITY))]
fn point(
    position: Vector,
    intensity: Vector,
    attenuation: Vector,
    range: f32,
) -> PyResult<PyLight> {
    checked(Light {
        kind: 1,
        position,
        intensity,
        attenuation,
        range,
        ..NOTHING
    })
}

/// A point light that shines into a cone around its axis. Its edge lies between two half-angles, measured from the axis.
///
/// axis: the direction in which it shines, three numbers of any length.
/// inner, outer: half-angles in radians; equal for a hard edge.
/// The other arguments are those of `point`.
#[pyfunction]
#[pyo3(signature = (position, axis, intensity, inner, outer, attenuation=[1.0, 0.0, 0.0], range=f32::INFINITY))]
fn spot(
    position: Vector,
    axis: Vector,
    intensity: Vector,
    inner: f32,
    outer: f32,
    attenuation: Vector,
    range: f32,
) -> PyResult<PyLight> {
    let direction = axis;
    checked(Light {
        kind: 2,
        position,
        direction,
        intensity,
        attenuation,
        range,
        inner,
        outer,
        ..NOTHING
    })
}

/// The numbers of an array, three by three, row by row.
fn triples(array: &Array) -> PyResult<Vec<Vector>> {
    if array.shape().last() != Some(&3) {
        return Err(PyValueError::new_err(format!(
            "the shape must be (..., 3), not {:?}",
            array.shape()
        )));
    }
    let numbers: Vec<f32> = array.as_array().iter().copied().collect();
    Ok(numbers.as_chunks().0.to_vec())
}

/// The linear light that points of a surface send to the eye:
/// k_a ambient + sum of I (k_d max(0, N.L) + k_s max(0, cosine)^m) over the lights in front of the surface.
///
/// points, normals: arrays of one shape (..., 3). The normals have any length; where one has none, the result is black.
/// eye: a point, three numbers in the unit of the points.
/// lights: a list of lights.
/// k_a, k_d, k_s: what the surface reflects of each channel, from 0 to 1. m: the shininess, at least 0.
/// ambient: linear red, green and blue.
/// model: "lambert", "phong" or "blinn-phong".
///
/// Returns an array of float32 of the shape of the points: linear red, green and blue, at least 0 and without an upper limit.
#[pyfunction]
#[pyo3(signature = (points, normals, eye, lights, *, k_a=[0.0; 3], k_d=[0.0; 3], k_s=[0.0; 3], m=1.0, ambient=[1.0; 3],
                    model="blinn-phong"))]
#[allow(clippy::too_many_arguments, clippy::needless_pass_by_value)]
fn shade<'py>(
    py: Python<'py>,
    points: Array<'py>,
    normals: Array<'py>,
    eye: Vector,
    lights: Vec<PyRef<'py, PyLight>>,
    k_a: Vector,
    k_d: Vector,
    k_s: Vector,
    m: f32,
    ambient: Vector,
    model: &str,
) -> PyResult<Bound<'py, PyArrayDyn<f32>>> {
    let shape = points.shape().to_vec();
    if shape != normals.shape() {
        return Err(PyValueError::new_err(
            "points and normals must have the same shape",
        ));
    }
    let (points, normals) = (triples(&points)?, triples(&normals)?);
    let lights: Vec<Light> = lights.iter().map(|light| light.0).collect();
    let numbers = ["lambert", "phong", "blinn-phong"].iter().zip(0..);
    let number = numbers
        .filter(|(name, _)| **name == model)
        .map(|(_, number)| number)
        .next();
    let model = Model::of(number.unwrap_or(u32::MAX));
    let mut out = vec![[0.0; 3]; points.len()];
    let material = Material { k_a, k_d, k_s, m };
    let shaded = model.and_then(|model| {
        let scene = Scene {
            model,
            points: &points,
            normals: &normals,
            eye,
            material,
            ambient,
            lights: &lights,
        };
        scene.shade(&mut out)
    });
    shaded.map_err(|status| PyValueError::new_err(format!("not a {status:?}").to_lowercase()))?;
    PyArray1::from_slice(py, out.as_flattened()).reshape(shape)
}

/// The bytes of linear colors in sRGB.
///
/// colors: an array of shape (..., 3): linear red, green and blue, where 1 is the brightest that a screen shows.
///
/// Returns an array of uint8 of the same shape, each rounded to the nearest.
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
fn to_srgb8<'py>(py: Python<'py>, colors: Array<'py>) -> PyResult<Bound<'py, PyArrayDyn<u8>>> {
    let bytes: Vec<[u8; 3]> = triples(&colors)?
        .into_iter()
        .map(|color| shading::Rgb::from(color).to_srgb8())
        .collect();
    PyArray1::from_slice(py, bytes.as_flattened()).reshape(colors.shape())
}

/// Lambert, Phong and Blinn-Phong shading of arrays. All directions point away from the surface, and colors are linear.
#[pymodule(name = "shading")]
mod module {
    #[pymodule_export]
    use super::{PyLight, directional, point, shade, spot, to_srgb8};
}
