//! Blinn–Phong for C: one function over plain arrays. `shading.h` declares it, `main.c` calls it, and
//! `run.sh` builds and runs the two.

use shading::f32::{Attenuation, IncidentLight, Material, PointLight, Rgb, Vec3};
use shading::shade;

/// A point light, as in `shading.h`.
#[repr(C)]
pub struct Lamp {
    position: [f32; 3],
    intensity: [f32; 3],
    /// a, b, c of 1/(a + bq + cq²)
    attenuation: [f32; 3],
}

impl Lamp {
    fn at(&self, p: Vec3) -> Option<IncidentLight> {
        let [a, b, c] = self.attenuation;
        let attenuation = Attenuation::new(a, b, c)?;
        let (position, intensity) = (self.position.into(), self.intensity.into());
        Some(
            PointLight {
                position,
                intensity,
                attenuation,
            }
            .at(p),
        )
    }
}

/// The light that the point p sends along v. Neither n nor v needs to be normalized; if one of them
/// has no direction, the result is black. A lamp with invalid coefficients is dark.
///
/// # Safety
///
/// Every pointer must be valid: p, n, v, `k_a`, `k_d`, and `k_s` for three floats, and lamps for
/// `count` lamps.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn shading_blinn_phong(
    p: &[f32; 3],
    n: &[f32; 3],
    v: &[f32; 3],
    k_a: &[f32; 3],
    k_d: &[f32; 3],
    k_s: &[f32; 3],
    m: u32,
    lamps: *const Lamp,
    count: usize,
    out: &mut [f32; 3],
) {
    // SAFETY: the caller promises `count` valid lamps.
    let lamps = if count == 0 {
        &[]
    } else {
        unsafe { std::slice::from_raw_parts(lamps, count) }
    };
    let (p, n, v) = (Vec3::from(*p), Vec3::from(*n).unit(), Vec3::from(*v).unit());
    let [k_a, k_d, k_s] = [k_a, k_d, k_s].map(|k| Rgb::from(*k));
    let material = Material { k_a, k_d, k_s, m };
    *out = n.zip(v).map_or([0.0; 3], |(n, v)| {
        let lights = lamps.iter().filter_map(|lamp| lamp.at(p));
        shade::blinn_phong(n, v, &material, Rgb::WHITE, lights)
            .total()
            .into()
    });
}
