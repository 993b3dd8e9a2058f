//! Pointers that cannot be right.
#![allow(clippy::borrow_as_ptr, reason = "as C passes pointers")]

use std::ptr::{null, null_mut};

use super::{POINTS, refusal, scene, shade, sun};
use crate::c::{
    CScene, Each, shading_from_srgb8, shading_shade, shading_to_srgb8, shading_to_srgba8,
};

#[test]
fn bad_pointers_are_refused() {
    let lights = [sun()];
    let good = scene(&lights);
    let status = |change: &dyn Fn(&mut CScene)| {
        let mut scene = good;
        change(&mut scene);
        let mut out = [[0.0; 3]; 2];
        // SAFETY: what is not null is valid, or refused before it is read
        unsafe { shading_shade(&scene, &raw mut out[0], null_mut()) }
    };
    assert_eq!(status(&|_| ()), 0);
    assert_eq!(status(&|scene| scene.points = null()), 1);
    assert_eq!(status(&|scene| scene.normals = null()), 1);
    assert_eq!(status(&|scene| scene.lights = null()), 1);
    assert_eq!(
        status(&|scene| scene.points = scene.points.wrapping_byte_add(2)),
        2
    );
    assert_eq!(
        status(&|scene| scene.each.m = POINTS.as_ptr().wrapping_byte_add(1).cast()),
        2
    );
    assert_eq!(status(&|scene| scene.count = usize::MAX), 3);
    assert_eq!(status(&|scene| scene.parts = 2), 5);
    assert_eq!(
        status(&|scene| (scene.count, scene.points, scene.normals) = (0, null(), null())),
        0
    );
    // SAFETY: null is refused
    unsafe {
        assert_eq!(shading_shade(null(), null_mut(), null_mut()), 1);
        assert_eq!(shading_to_srgb8(1, null(), null_mut()), 1);
        assert_eq!(shading_to_srgba8(1, &POINTS[0], null_mut()), 1);
        assert_eq!(shading_from_srgb8(0, null(), null_mut()), 0);
    }
}

#[test]
fn a_sentence_names_the_pointer() {
    let lights = [sun()];
    let says = |change: &dyn Fn(&mut CScene)| {
        let mut scene = scene(&lights);
        change(&mut scene);
        shade(&scene).expect_err("refused").3
    };
    let odd = POINTS.as_ptr().wrapping_byte_add(1);
    let is_null = "the pointer is null, and its buffer is not empty";
    let is_odd = "the pointer is not a multiple of its type's alignment";
    assert_eq!(
        says(&|scene| scene.points = null()),
        format!("points: {is_null}")
    );
    assert_eq!(
        says(&|scene| scene.lights = null()),
        format!("lights: {is_null}")
    );
    assert_eq!(
        says(&|scene| scene.normals = odd),
        format!("normals: {is_odd}")
    );
    assert_eq!(
        says(&|scene| scene.each.visible = odd.cast()),
        format!("each.visible: {is_odd}")
    );
    assert_eq!(
        says(&|scene| scene.light_count = usize::MAX),
        "lights: the buffer is larger than the address space"
    );

    let scene = scene(&lights);
    // SAFETY: null and an output that is an input are refused
    let (nowhere, in_place) = unsafe {
        (
            refusal(|error| shading_shade(&scene, null_mut(), error)),
            refusal(|error| shading_shade(&scene, scene.normals.cast_mut(), error)),
        )
    };
    assert_eq!(nowhere.expect_err("refused").3, format!("out: {is_null}"));
    assert_eq!(
        in_place.expect_err("refused").3,
        "normals: the output overlaps this input"
    );
}

#[test]
fn an_output_overlaps_no_input() {
    // one room for all: points, normals, textures and fractions of one point
    let mut room = [0.5_f32; 30];
    let start = room.as_mut_ptr();
    let lights = [sun()];
    let at = |index: usize| start.wrapping_add(index).cast_const();
    let scene = CScene {
        count: 1,
        points: at(0).cast(),
        normals: at(3).cast(),
        each: Each {
            eye: at(6).cast(),
            k_a: at(9).cast(),
            k_d: at(12).cast(),
            k_s: at(15).cast(),
            ambient: at(18).cast(),
            m: at(21),
            visible: at(22),
        },
        ..scene(&lights)
    };
    // SAFETY: all is inside of the room, and any bits are numbers
    let shade_into =
        |out: usize| unsafe { shading_shade(&scene, at(out).cast_mut().cast(), null_mut()) };
    for out in 0..23 {
        assert_eq!(shade_into(out), 4, "{out}");
    }
    assert_eq!(shade_into(23), 0);
}

#[test]
fn parts_add_up() {
    let lights = [sun()];
    let mut scene = scene(&lights);
    scene.material.k_a = [0.25, 0.5, 0.75];
    scene.material.k_s = [0.125; 3];
    let total = shade(&scene).expect("valid");
    scene.parts = 1;
    let parts = shade(&scene).expect("valid");
    for (i, total) in total.iter().enumerate() {
        for c in 0..3 {
            assert_eq!(parts[i][c] + parts[2 + i][c] + parts[4 + i][c], total[c]);
        }
        assert_eq!(parts[i], [0.25, 0.5, 0.75], "the ambient part");
    }
}
