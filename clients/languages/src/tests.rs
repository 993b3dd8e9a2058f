//! What `shading.h` promises about errors.
#![allow(clippy::borrow_as_ptr, reason = "as C passes pointers")]

use std::ptr::null;

use super::*;

const POINTS: [[f32; 3]; 2] = [[0.0, 0.0, 1.0], [0.5, 0.0, 0.75]];
const NORMALS: [[f32; 3]; 2] = [[0.0, 0.0, 2.0], [1.0, 0.0, 1.0]];
const CLAY: Material = Material {
    k_a: [0.1; 3],
    k_d: [0.5; 3],
    k_s: [0.5; 3],
    m: 32.0,
};
const LAMP: Light = Light {
    kind: 2,
    position: [2.0, 1.0, 2.0],
    direction: [-2.0, -1.0, -1.0],
    intensity: [1.0; 3],
    attenuation: [1.0, 0.0, 0.25],
    range: f32::INFINITY,
    inner: 0.25,
    outer: 0.5,
    gltf: 0,
};

/// The status, and the output, which an error must not change.
fn shade(model: u32, material: Material, light: Light) -> (i32, [[f32; 3]; 2]) {
    let mut out = [[-1.0; 3]; 2];
    let (eye, ambient) = ([0.0, 0.0, 5.0], [0.5; 3]);
    // SAFETY: the pointers are those of arrays of two
    let status = unsafe {
        let (points, normals) = (POINTS.as_ptr(), NORMALS.as_ptr());
        shading_shade(
            model,
            2,
            points,
            normals,
            &eye,
            &material,
            &ambient,
            &light,
            1,
            &raw mut out[0],
        )
    };
    assert_eq!(status == 0, out != [[-1.0; 3]; 2], "{status}");
    (status, out)
}

#[test]
fn lambert_ignores_the_highlight() {
    let expected = shade(0, CLAY, LAMP);
    assert_eq!(expected.0, 0);
    for (k_s, m) in [(f32::NAN, 32.0), (-1.0, 32.0), (0.5, f32::NAN), (0.5, -1.0)] {
        let odd = Material {
            k_s: [k_s; 3],
            m,
            ..CLAY
        };
        assert_eq!(shade(0, odd, LAMP), expected);
        assert_eq!(shade(1, odd, LAMP).0, 6);
        assert_eq!(shade(2, odd, LAMP).0, 6);
    }
}

#[test]
fn what_is_not_light_is_refused() {
    let dark = Material {
        k_d: [-1.0; 3],
        ..CLAY
    };
    assert_eq!(shade(3, CLAY, LAMP).0, 5);
    assert_eq!(shade(0, dark, LAMP).0, 6);
    for light in [
        Light { kind: 3, ..LAMP },
        Light {
            direction: [0.0; 3],
            ..LAMP
        },
        Light {
            intensity: [f32::INFINITY; 3],
            ..LAMP
        },
        Light {
            attenuation: [0.0; 3],
            ..LAMP
        },
        Light { range: 0.0, ..LAMP },
        Light { inner: 1.0, ..LAMP },
        Light { gltf: 2, ..LAMP },
    ] {
        assert_eq!(shade(2, CLAY, light).0, 7);
    }
}

#[test]
fn an_output_overlaps_no_input() {
    // one room for all: 3 floats each, but 10 of the material and 17 of the light, whose kind is no kind
    let mut room = [0.5_f32; 42];
    let start = room.as_mut_ptr();
    let shade_into = |out: usize| {
        let [points, normals, eye, material, ambient, lights, out] =
            [0, 3, 6, 9, 19, 22, out].map(|index| start.wrapping_add(index));
        let (points, normals, eye) = (points.cast(), normals.cast(), eye.cast());
        let (material, ambient, lights) = (material.cast(), ambient.cast(), lights.cast());
        // SAFETY: all is inside of the room, and any bits are numbers
        unsafe {
            shading_shade(
                0,
                1,
                points,
                normals,
                eye,
                material,
                ambient,
                lights,
                1,
                out.cast(),
            )
        }
    };
    assert_eq!(shade_into(39), 7);
    for out in 0..39 {
        assert_eq!(shade_into(out), 4, "{out}");
    }
}

#[test]
fn bad_pointers_are_refused() {
    let mut out = [[0.0; 3]; 2];
    let mut call = |points: *const [f32; 3], count, lights| {
        let (eye, ambient) = ([0.0, 0.0, 5.0], [0.5; 3]);
        // SAFETY: what is not null is valid, or refused before it is read
        unsafe {
            let normals = NORMALS.as_ptr();
            shading_shade(
                2,
                count,
                points,
                normals,
                &eye,
                &CLAY,
                &ambient,
                lights,
                1,
                &raw mut out[0],
            )
        }
    };
    assert_eq!(call(POINTS.as_ptr(), 2, &LAMP), 0);
    assert_eq!(call(null(), 2, &LAMP), 1);
    assert_eq!(call(POINTS.as_ptr(), 2, null()), 1);
    assert_eq!(call(POINTS.as_ptr().wrapping_byte_add(2), 1, &LAMP), 2);
    assert_eq!(call(POINTS.as_ptr(), usize::MAX, &LAMP), 3);
    assert_eq!(call(null(), 0, &LAMP), 0, "nothing to do");
}
