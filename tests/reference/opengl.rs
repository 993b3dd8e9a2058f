//! The sum over lights against OpenGL's fixed-function pipeline, as computed by Mesa's two software
//! renderers (`tests/data/README.md`).

use support::number::for_f32_and_f64;

use crate::scene::{Lamp, Scene, Source, Spot};
use crate::table::{Row, Tally, bits, rows};
use support::running::Float;

for_f32_and_f64!(single_light, multi_light);

fn single_light<T: Float>() {
    compare::<T>("gl_single_light.csv", 400);
}

fn multi_light<T: Float>() {
    compare::<T>("gl_multi_light.csv", 80);
}

/// The tolerance is that of the reference: Mesa's power is right to 2·10⁻⁵, and the result is
/// multiplied out in single precision. Our own `f32` adds m·u·k, with m up to 128 and k ≈ 10
/// roundings before the cosine: 8·10⁻⁵.
fn compare<T: Float>(file: &str, count: usize) {
    let (absolute, relative) = if T::NAME == "f32" {
        (1e-6, 1e-4)
    } else {
        (1e-7, 2.5e-5)
    };
    for renderer in ["soft", "llvm"] {
        let mut tally = Tally::new::<T>(format!("{file}, {renderer}pipe"));
        for row in rows(file) {
            let color: [T; 3] = scene(&row).shade::<T>().into();
            let expected = ["r", "g", "b"].map(|c| bits(row.text(&format!("{renderer}_{c}"))));
            let tolerance = expected.map(|c| absolute + relative * c);
            tally.compare(row.text("id"), color.map(T::to_f64), expected, tolerance);
        }
        tally.close(count, &[]);
    }
}

/// Reads numbers one after the other.
struct Reader<'a>(std::slice::Iter<'a, String>);

impl Reader<'_> {
    fn number(&mut self) -> f64 {
        bits(self.0.next().expect("a field"))
    }

    fn three(&mut self) -> [f64; 3] {
        [(); 3].map(|()| self.number())
    }
}

/// Reads the columns in order: the length of a row depends on the number of lights.
fn scene(row: &Row) -> Scene {
    let mut fields = Reader(row.fields[9..].iter());
    let [p, n, emission, k_a, k_d, k_s] = [(); 6].map(|()| fields.three());
    let m = fields.number();
    let i_a = fields.three();
    let count: usize = row.text("nlights").parse().expect("the number of lights");
    let lamps = (0..count).map(|_| lamp(&mut fields)).collect();
    assert!(fields.0.next().is_none(), "fields left over");
    Scene {
        p,
        n,
        n_as_given: true,
        eye: [0.0; 3],
        emission,
        ambient: [k_a, i_a],
        k_a,
        k_d,
        phong: ([0.0; 3], 0.0),
        blinn: (k_s, m),
        lamps,
    }
}

fn lamp(fields: &mut Reader) -> Lamp {
    let (position, w) = (fields.three(), fields.number());
    let [ambient, diffuse, specular, attenuation, axis] = [(); 5].map(|()| fields.three());
    let (exponent, cutoff) = (fields.number(), fields.number());
    let spot = (cutoff < 180.0).then(|| Spot {
        axis,
        half_angle_degrees: cutoff,
        inner_half_angle_degrees: None,
        profile: Box::new(move |cosine| cosine.max(0.0).powf(exponent)),
    });
    let source = if w == 0.0 {
        assert!(spot.is_none(), "a directional light has no cone");
        Source::Directional(position)
    } else {
        Source::Point(position.map(|c| c / w))
    };
    let bare_highlight_above = None;
    Lamp {
        source,
        attenuation,
        spot,
        ambient,
        diffuse,
        specular,
        bare_highlight_above,
    }
}
