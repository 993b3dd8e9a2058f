//! A port, before and after. `euc`'s own example `teapot` shades by hand; `frag.rs` holds what takes the
//! place of its formulas. `build.rs` puts both together from the package's source.

/// The example's `main` for one frame, with a buffer in place of its window.
macro_rules! picture {
    ($pixel:ty) => {
        pub fn picture(model: &crate::Model, frame: u16) -> Vec<$pixel> {
            use euc::buffer::Buffer2d;
            let mut color = Buffer2d::new(crate::SIDE, <$pixel>::default());
            let mut depth = Buffer2d::new(crate::SIDE, 1.0);
            let teapot = Teapot {
                mvp: crate::model_view_projection(f32::from(frame)),
                positions: &model.positions,
                normals: &model.normals,
                light_dir: Vec3::new(1.0, 1.0, 1.0).normalized(),
            };
            teapot.draw::<euc::rasterizer::Triangles<_>, _>(
                &model.indices,
                &mut color,
                Some(&mut depth),
            );
            color.as_ref().to_vec()
        }
    };
}
use picture;

#[allow(clippy::all, clippy::pedantic)] // as its authors wrote it
mod before {
    use euc::Pipeline;
    use vek::{Clamp, Mat4, Rgba, Vec3, Vec4};
    include!(concat!(env!("OUT_DIR"), "/before.rs"));
    crate::picture!(u32);
}

#[allow(clippy::all, clippy::pedantic)]
mod after {
    use euc::Pipeline;
    use shading::f32::UnitVec3;
    use shading::term;
    use vek::{Clamp, Mat4, Rgba, Vec3, Vec4};
    include!(concat!(env!("OUT_DIR"), "/after.rs"));
    crate::picture!(u32);

    // glue
    fn direction(v: Vec3<f32>) -> UnitVec3 {
        UnitVec3::assume_unit(v.into_array().into())
    }
    // end of glue
}

/// What the fragments of a picture are computed from: the normals and the direction to the light.
mod seen {
    use euc::Pipeline;
    use vek::{Mat4, Vec3, Vec4};

    struct Teapot<'a> {
        mvp: Mat4<f32>,
        positions: &'a [Vec3<f32>],
        normals: &'a [Vec3<f32>],
        light_dir: Vec3<f32>,
    }

    impl Pipeline for Teapot<'_> {
        type Vertex = u32;
        type VsOut = Vec3<f32>;
        type Pixel = Option<f32>;

        fn vert(&self, index: &u32) -> ([f32; 4], Vec3<f32>) {
            let p = self.positions[*index as usize] + Vec3::new(0.0, -0.5, 0.0);
            (
                (self.mvp * Vec4::from_point(p)).into_array(),
                self.normals[*index as usize],
            )
        }

        /// R·V as the example computes it.
        fn frag(&self, n: &Vec3<f32>) -> Option<f32> {
            let n = Vec3::from(self.mvp * Vec4::from(*n)).normalized();
            Some(self.light_dir.reflected(n).dot(-Vec3::unit_z()))
        }
    }
    crate::picture!(Option<f32>);
}

pub use after::picture as after;
pub use before::picture as before;
pub use seen::picture as seen;

pub const SIDE: [usize; 2] = [800, 600];

/// The camera of the frame i, which swings around the teapot.
fn model_view_projection(i: f32) -> vek::Mat4<f32> {
    use vek::{Mat4, Vec3};
    Mat4::perspective_fov_rh_no(1.3, SIDE[0] as f32, SIDE[1] as f32, 0.01, 100.0)
        * Mat4::translation_3d(Vec3::new(0.0, 0.0, -1.5))
        * Mat4::<f32>::scaling_3d(0.8)
        * Mat4::rotation_x((i * 0.002).sin() * 8.0)
        * Mat4::rotation_y((i * 0.004).cos() * 4.0)
        * Mat4::rotation_z((i * 0.008).sin() * 2.0)
}

/// The teapot that the package draws.
pub struct Model {
    positions: Vec<vek::Vec3<f32>>,
    normals: Vec<vek::Vec3<f32>>,
    indices: Vec<u32>,
}

/// # Errors
///
/// If the package has no such model.
pub fn teapot() -> Result<Model, tobj::LoadError> {
    let options = tobj::LoadOptions {
        single_index: true,
        ..Default::default()
    };
    let (models, _) = tobj::load_obj(env!("TEAPOT"), &options)?;
    let mesh = models
        .into_iter()
        .next()
        .ok_or(tobj::LoadError::ReadError)?
        .mesh;
    let triples = |numbers: &[f32]| numbers.chunks(3).map(vek::Vec3::from_slice).collect();
    Ok(Model {
        positions: triples(&mesh.positions),
        normals: triples(&mesh.normals),
        indices: mesh.indices,
    })
}
