//! The normals of height fields and meshes.

use shading::{UnitVec3, Vec3, normal};

use crate::light::is_finite;
use crate::number::Number;
use crate::problem::{Problem, Status, triple};

pub fn check_steps<T: Number, const N: usize>(
    names: [&str; N],
    steps: [T; N],
) -> Result<(), Problem> {
    for (name, step) in names.into_iter().zip(steps) {
        if !is_finite(step) || step == T::ZERO {
            let expected = "a finite number that is not 0";
            return Err(Problem::new(Status::Step, name, expected, step));
        }
    }
    Ok(())
}

pub fn check_field<T: Number>(z: &[T], dx: T, dy: T) -> Result<(), Problem> {
    check_steps(["dx", "dy"], [dx, dy])?;
    match z.iter().position(|&z| !is_finite(z)) {
        None => Ok(()),
        Some(i) => {
            let expected = "finite heights (fill in what is missing first)";
            Err(Problem::new(Status::Heights, "z", expected, z[i]).at(i, z.len()))
        }
    }
}

/// The slope at the middle of three heights, or at an end of them. It is exact for parabolas.
pub fn slope<T: Number>(z: impl Fn(usize) -> T, i: usize, count: usize, step: T) -> T {
    let two = T::ONE + T::ONE;
    let difference = match count {
        0 | 1 => return T::ZERO,
        2 => return (z(1) - z(0)) / step,
        _ if i == 0 => (z(1) - z(0)) * two - (z(2) - z(0)) / two,
        _ if i == count - 1 => (z(i) - z(i - 1)) * two - (z(i) - z(i - 2)) / two,
        _ => (z(i + 1) - z(i - 1)) / two,
    };
    difference / step
}

/// The normals (−∂z/∂x, −∂z/∂y, 1), normalized. They are 0 where a slope overflows.
pub fn height_field<T: Number>(z: &[T], columns: usize, dx: T, dy: T, out: &mut [[T; 3]]) {
    let rows = z.len() / columns.max(1);
    for (i, out) in out.iter_mut().enumerate() {
        let (row, column) = (i / columns, i % columns);
        let along_x = slope(|k| z[row * columns + k], column, columns, dx);
        let along_y = slope(|k| z[k * columns + column], row, rows, dy);
        let n = Vec3::new(-along_x, -along_y, T::ONE).unit();
        *out = n.map_or([T::ZERO; 3], |n| (*n).into());
    }
}

pub fn check_mesh<T: Number>(vertices: &[[T; 3]], faces: &[[u32; 3]]) -> Result<(), Problem> {
    let is_bad = |vertex: &[T; 3]| !vertex.iter().all(|&x| is_finite(x));
    if let Some(i) = vertices.iter().position(is_bad) {
        let got = triple(vertices[i]);
        let problem = Problem::new(Status::Points, "vertices", "finite numbers", got);
        return Err(problem.at(i, vertices.len()));
    }
    let count = vertices.len();
    let is_bad = |face: &[u32; 3]| face.iter().any(|&vertex| vertex as usize >= count);
    match faces.iter().position(is_bad) {
        None => Ok(()),
        Some(i) => {
            let expected = format!("indices below {count}, the number of vertices");
            let got = triple(faces[i]);
            Err(Problem::new(Status::Faces, "faces", &expected, got).at(i, faces.len()))
        }
    }
}

pub fn check_crease<T: Number>(crease: T) -> Result<(), Problem> {
    if crease >= T::ZERO && crease <= T::of(std::f64::consts::PI) {
        return Ok(());
    }
    let expected = "0 <= crease <= pi, in radians (a degree is pi/180)";
    Err(Problem::new(Status::Crease, "crease", expected, crease))
}

/// What a face adds to the normals of its three vertices.
fn corners<T: Number>(vertices: &[[T; 3]], face: [u32; 3]) -> [Vec3<T>; 3] {
    let [a, b, c] = face.map(|vertex| Vec3::from(vertices[vertex as usize]));
    [
        normal::corner(a, b, c),
        normal::corner(b, c, a),
        normal::corner(c, a, b),
    ]
}

pub fn unit_or_zero<T: Number>(sum: Vec3<T>) -> [T; 3] {
    sum.unit().map_or([T::ZERO; 3], |n| (*n).into())
}

/// The normal of each vertex: those of the faces around it, weighted by their angles there. It is 0
/// where there is no face.
pub fn of_vertices<T: Number>(vertices: &[[T; 3]], faces: &[[u32; 3]], out: &mut [[T; 3]]) {
    let mut sums = vec![Vec3::new(T::ZERO, T::ZERO, T::ZERO); vertices.len()];
    for &face in faces {
        for (vertex, corner) in face.into_iter().zip(corners(vertices, face)) {
            let sum = &mut sums[vertex as usize];
            *sum += corner;
        }
    }
    for (out, sum) in out.iter_mut().zip(sums) {
        *out = unit_or_zero(sum);
    }
}

/// The normal of each corner of each face: of the faces around the vertex, only those count whose
/// normals differ from the face's by at most the angle `crease`.
pub fn of_corners<T: Number>(
    vertices: &[[T; 3]],
    faces: &[[u32; 3]],
    crease: T,
    out: &mut [[[T; 3]; 3]],
) {
    // a few roundoffs, so that the triangles of a flat face are one at an angle of 0
    let slack = T::of(16.0) * T::EPSILON;
    let least = crease.cos() - slack;
    let normals: Vec<Option<UnitVec3<T>>> = faces
        .iter()
        .map(|face| {
            let [a, b, c] = face.map(|vertex| Vec3::from(vertices[vertex as usize]));
            normal::triangle(a, b, c)
        })
        .collect();
    let mut around = vec![Vec::new(); vertices.len()];
    for (i, &face) in faces.iter().enumerate() {
        for (vertex, corner) in face.into_iter().zip(corners(vertices, face)) {
            around[vertex as usize].push((i, corner));
        }
    }
    for ((face, own), out) in faces.iter().zip(&normals).zip(out) {
        for (&vertex, out) in face.iter().zip(out) {
            let is_smooth = |other: usize| match (own, normals[other]) {
                (Some(a), Some(b)) => a.dot(*b) >= least,
                _ => own.is_none(), // a face without a normal takes what there is
            };
            let sum = around[vertex as usize]
                .iter()
                .filter(|&&(other, _)| is_smooth(other))
                .fold(Vec3::new(T::ZERO, T::ZERO, T::ZERO), |sum, &(_, corner)| {
                    sum + corner
                });
            *out = unit_or_zero(sum);
        }
    }
}
