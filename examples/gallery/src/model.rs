//! Models from OBJ files, scaled to a common size.

use std::collections::HashMap;
use std::fs;
use std::path::Path;
use std::sync::Arc;

use shading::{Vec3, normal};
use tobj::{LoadError, LoadOptions};

use crate::render::mesh::{Flat, Mesh, Share, Smooth};

/// A model that stands on the floor y = 0 at the origin.
pub struct Model {
    /// The largest y of the model.
    pub height: f32,
    mesh: Arc<Mesh>,
    /// The normals in the file at the corners of the triangles; zero where the file has none.
    normals: Option<Vec<[Vec3<f32>; 3]>>,
}

/// A triangle of an OBJ file: the positions of its corners and the normals there.
type Triangle = ([[f32; 3]; 3], Option<[Vec3<f32>; 3]>);

impl Model {
    /// Reads a file, and reports what is wrong with it and where.
    pub fn read(path: &Path) -> Result<Self, String> {
        fs::read(path)
            .map_err(|error| error.to_string())
            .and_then(|bytes| String::from_utf8(bytes).map_err(|_| "not a text file".into()))
            .and_then(|obj| Self::parse(&obj))
            .map_err(|error| format!("cannot read the model {}: {error}", path.display()))
    }

    /// Parses the text of an OBJ file.
    pub fn parse(obj: &str) -> Result<Self, String> {
        let triangles = triangles(obj)?;
        let placed = placed(&triangles)?;

        let mut positions = Vec::new();
        let mut known = HashMap::new();
        let mut corners = Vec::new();
        let mut normals = Vec::new();
        for (triangle, (_, own)) in placed.into_iter().zip(triangles) {
            let [v1, v2, v3] = triangle;
            // a triangle that is a line or a point is invisible
            if normal::triangle(v1, v2, v3).is_none() {
                continue;
            }
            // files repeat a vertex for each object and each texture; here the copies become one
            // vertex
            corners.push(triangle.map(|vertex| {
                let bits = <[f32; 3]>::from(vertex).map(f32::to_bits);
                *known.entry(bits).or_insert_with(|| {
                    positions.push(vertex);
                    positions.len() - 1
                })
            }));
            normals.extend(own);
        }
        if corners.is_empty() {
            return Err("it has no face with an area".into());
        }
        Ok(Self {
            height: positions.iter().map(|p| p.y).fold(0.0, f32::max),
            normals: (normals.len() == corners.len()).then_some(normals),
            mesh: Arc::new(Mesh::new(positions, corners)),
        })
    }

    /// One normal for each triangle.
    pub fn flat(&self) -> Flat {
        Flat(self.mesh.clone())
    }

    /// The normals in the file, or if it has none, the mean around each vertex; both interpolated.
    pub fn smooth(&self) -> Smooth {
        match &self.normals {
            Some(normals) => Smooth::new(self.mesh.clone(), normals),
            None => self.averaged(normal::corner),
        }
    }

    /// The mean normal around each vertex, weighted by the shares of the triangles, and
    /// interpolated.
    pub fn averaged(&self, share: Share) -> Smooth {
        Smooth::averaged(self.mesh.clone(), share)
    }
}

fn triangles(obj: &str) -> Result<Vec<Triangle>, String> {
    let options = LoadOptions {
        single_index: true,
        triangulate: true,
        ignore_points: true,
        ignore_lines: true,
    };
    let mut rest = obj.as_bytes();
    // the gallery uses its own materials
    let (models, _) = tobj::load_obj_buf(&mut rest, &options, |_| Ok(Default::default()))
        .map_err(|error| explained(error, &obj[..obj.len() - rest.len()]))?;

    let mut triangles = Vec::new();
    for mesh in models.iter().map(|model| &model.mesh) {
        let positions = triples(&mesh.positions);
        let normals = triples(&mesh.normals);
        // if only some corners of a mesh have normals, there is no way to tell which
        let has_normals = normals.len() == positions.len();
        for corners in triples(&mesh.indices) {
            let corners = corners.map(|i| i as usize);
            triangles.push((
                corners.map(|i| positions[i]),
                has_normals.then(|| corners.map(|i| normals[i].into())),
            ));
        }
    }
    if triangles.is_empty() {
        return Err("it has no faces".into());
    }
    let mut coordinates = triangles.iter().flat_map(|(corners, _)| corners).flatten();
    if !coordinates.all(|coordinate| coordinate.is_finite()) {
        return Err("a vertex has a coordinate that is not a finite number".into());
    }
    Ok(triangles)
}

fn triples<T: Copy>(numbers: &[T]) -> Vec<[T; 3]> {
    numbers
        .chunks_exact(3)
        .map(|three| [three[0], three[1], three[2]])
        .collect()
}

/// Describes an error of the reader, with the line of the file where it stopped.
fn explained(error: LoadError, read: &str) -> String {
    match error {
        // detected only after all faces of an object have been read
        LoadError::FaceVertexOutOfBounds => "a face refers to a vertex that does not exist".into(),
        LoadError::FaceTexCoordOutOfBounds => {
            "a face refers to a texture point that does not exist".into()
        }
        LoadError::FaceNormalOutOfBounds => "a face refers to a normal that does not exist".into(),
        LoadError::InvalidPolygon => "a face has no vertices".into(),
        _ => format!("line {}: {error}", read.lines().count()),
    }
}

/// Moves the triangles to the middle of the floor, scaled to a height of at most 2 and a width of
/// at most 2.8.
fn placed(triangles: &[Triangle]) -> Result<Vec<[Vec3<f32>; 3]>, String> {
    /// Slightly above the floor, so that a flat model is visible.
    const GAP: f64 = 2e-3;

    let [x, y, z] = [0, 1, 2].map(|axis| ends(triangles, axis));
    let extent = |[low, high]: [f64; 2]| high - low;
    let scale = (2.0 / extent(y)).min(2.8 / extent(x).max(extent(z)));
    if !scale.is_finite() {
        return Err("all its vertices coincide".into());
    }
    let place = |vertex: [f32; 3]| {
        let [along_x, along_y, along_z] = vertex.map(f64::from);
        let placed = Vec3::new(
            (along_x - f64::midpoint(x[0], x[1])) * scale,
            (along_y - y[0]) * scale + GAP,
            (along_z - f64::midpoint(z[0], z[1])) * scale,
        );
        placed.map(|coordinate| coordinate as f32)
    };
    Ok(triangles
        .iter()
        .map(|(corners, _)| corners.map(place))
        .collect())
}

/// The smallest and the largest coordinate along an axis, in `f64` so that their difference is
/// finite.
fn ends(triangles: &[Triangle], axis: usize) -> [f64; 2] {
    let along = || {
        let vertices = triangles.iter().flat_map(|(corners, _)| corners);
        vertices.map(|vertex| f64::from(vertex[axis]))
    };
    [
        along().fold(f64::INFINITY, f64::min),
        along().fold(f64::NEG_INFINITY, f64::max),
    ]
}
