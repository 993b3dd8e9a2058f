//! Triangles from an OBJ file, shaded smoothly. The file's normals, if any, are not needed: each vertex
//! gets the mean of its triangles'.

use shading::{Vec3, normal};

use crate::bvh::{Bvh, joined};
use crate::vector::{Vector, direction, ours};

pub struct Mesh<V: Vector> {
    vertices: Vec<V>,
    normals: Vec<Vec3<V::Number>>,
    triangles: Vec<[usize; 3]>,
    bvh: Bvh<V::Number>,
    /// Triangles that are a line or a point, and so are invisible.
    pub without_area: usize,
}

impl<V: Vector> Mesh<V> {
    /// Reads a model and puts it on the floor at a place, scaled to a height. An error names the line of the file.
    pub fn read(obj: &str, height: f32, place: [f32; 3]) -> Result<Self, String> {
        let (points, faces) = parsed(obj)?;
        let area = |&[a, b, c]: &[usize; 3]| {
            normal::triangle::<f64>(points[a].into(), points[b].into(), points[c].into())
        };
        let all = faces.len();
        let triangles: Vec<_> = faces
            .into_iter()
            .filter(|face| area(face).is_some())
            .collect();
        let corners = || triangles.iter().flatten().map(|&i| [points[i]; 2]);
        let [low, high] = corners()
            .reduce(joined)
            .ok_or("it has no triangle with an area")?;
        let tall = high[1] - low[1];
        let wide = (high[0] - low[0]).max(high[2] - low[2]);
        // a flat model is as wide as others are high
        let scale = f64::from(height) / if tall > 0.0 { tall } else { wide };
        let middle = [
            0.5 * low[0] + 0.5 * high[0],
            low[1],
            0.5 * low[2] + 0.5 * high[2],
        ];
        let vertex = |p: &[f64; 3]| {
            V::of_f32(std::array::from_fn(|i| {
                ((p[i] - middle[i]) * scale) as f32 + place[i]
            }))
        };
        Ok(Self::new(
            points.iter().map(vertex).collect(),
            triangles,
            all,
        ))
    }

    fn new(vertices: Vec<V>, triangles: Vec<[usize; 3]>, all: usize) -> Self {
        let mut normals = vec![Vec3::ZERO; vertices.len()];
        for &[a, b, c] in &triangles {
            for [i, j, k] in [[a, b, c], [b, c, a], [c, a, b]] {
                normals[i] +=
                    normal::corner(ours(vertices[i]), ours(vertices[j]), ours(vertices[k]));
            }
        }
        let bounds = |triangle: &[usize; 3]| {
            let [a, b, c] = triangle.map(|i| [vertices[i].into(); 2]);
            joined(joined(a, b), c)
        };
        let bounds: Vec<_> = triangles.iter().map(bounds).collect();
        Self {
            bvh: Bvh::new(&bounds),
            vertices,
            normals,
            without_area: all - triangles.len(),
            triangles,
        }
    }

    /// Where a ray first meets the mesh before the limit, and the normal there.
    pub fn nearest(&self, from: V, along: V, limit: V::Number) -> Option<(V::Number, V)> {
        let mut found = None;
        self.bvh.walk(from, along, limit, |triangle, limit| {
            match self.meet(triangle, from, along) {
                Some((t, shares)) if t < limit => {
                    found = Some((t, triangle, shares));
                    t
                }
                _ => limit,
            }
        });
        found.map(|(t, triangle, shares)| (t, self.normal(triangle, shares, along)))
    }

    /// Möller and Trumbore, *Fast, minimum storage ray–triangle intersection*, 1997.
    fn meet(&self, triangle: usize, from: V, along: V) -> Option<(V::Number, [V::Number; 3])> {
        let [v1, v2, v3] = self.triangles[triangle].map(|i| self.vertices[i]);
        let (e1, e2, s) = (v2 - v1, v3 - v1, from - v1);
        let (h, q) = (along.cross(e2), s.cross(e1));
        let (zero, one) = (V::Number::from(0.0), V::Number::from(1.0));
        let scale = one / e1.dot(h);
        let [b, c, t] = [s.dot(h), along.dot(q), e2.dot(q)].map(|product| product * scale);
        let shares = [one - b - c, b, c];
        // rounding must not open a gap between two triangles
        let edge = V::Number::from(-1e-6);
        (t > zero && shares.iter().all(|&share| share >= edge)).then_some((t, shares))
    }

    /// The interpolated normal, on the side that the ray sees.
    fn normal(&self, triangle: usize, shares: [V::Number; 3], along: V) -> V {
        let corners = self.triangles[triangle].map(|i| self.normals[i]);
        let sum = (0..3).fold(Vec3::ZERO, |sum, i| sum + corners[i] * shares[i]);
        let toward = -direction(along);
        <[V::Number; 3]>::from(normal::facing(sum.unit_or(toward), toward)).into()
    }
}

type Faces = (Vec<[f64; 3]>, Vec<[usize; 3]>);

fn parsed(obj: &str) -> Result<Faces, String> {
    let (mut points, mut faces) = (Vec::new(), Vec::new());
    for (line, number) in obj.lines().zip(1..) {
        let wrong = |what: &str| format!("line {number}: {what}");
        let mut words = line.split_whitespace();
        match words.next() {
            Some("v") => {
                let coordinates = words
                    .take(3)
                    .map(|word| word.parse::<f64>().ok().filter(|x| x.abs() <= 1e30));
                let coordinates: Option<Vec<f64>> = coordinates.collect();
                let point = coordinates.and_then(|c| <[f64; 3]>::try_from(c).ok());
                points.push(point.ok_or_else(|| wrong("a vertex takes three finite numbers"))?);
            }
            Some("f") => {
                let corners: Option<Vec<usize>> =
                    words.map(|word| index(word, points.len())).collect();
                let corners =
                    corners.ok_or_else(|| wrong("a face has a vertex that is not there"))?;
                // a polygon as a fan
                faces.extend(
                    corners
                        .windows(2)
                        .skip(1)
                        .map(|pair| [corners[0], pair[0], pair[1]]),
                );
            }
            _ => {}
        }
    }
    Ok((points, faces))
}

/// The vertex of `7/1/2`: counted from 1, or from the end if it is negative.
fn index(word: &str, count: usize) -> Option<usize> {
    let number: isize = word.split('/').next()?.parse().ok()?;
    let index = if number < 0 {
        count.checked_add_signed(number)?
    } else {
        usize::try_from(number).ok()?.checked_sub(1)?
    };
    (index < count).then_some(index)
}
