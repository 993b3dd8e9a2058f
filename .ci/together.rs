// The recipes as one program uses them: what one makes, another takes. `.ci/pages blocks` puts the items of each
// recipe into a module that is named after it.
use shading::f32::{DirectionalLight, IncidentLight, Light, Rgb, UnitVec3, Vec3};

fn main() {
    // a plastic of a file, in the shadow of nothing, painted, and dithered for two screens
    let mtl = wavefront_materials::Mtl {
        kd: Some([0.5; 3]),
        ks: Some([0.25; 3]),
        ns: 32.0,
        ..Default::default()
    };
    let plastic = wavefront_materials::material(&mtl);
    let (n, p) = (UnitVec3::Z, Vec3::ZERO);
    let lamp = lights_of_a_gltf_file::gltf(
        "point",
        [1.0; 3],
        8.0,
        Vec3::new(0.0, 0.0, 2.0),
        n,
        None,
        None,
    )
    .unwrap();
    let sun = Light::from(DirectionalLight {
        l: height_maps_and_the_sun::sun(315.0, 45.0),
        intensity: color_temperature::black_body(5000.0),
    });
    let lights = [lamp, sun];
    let nothing = |_: Vec3, _: UnitVec3, _: f32| false;
    let shaded = shadows::shaded(p, n, n, &plastic, &lights, nothing);
    assert!(shaded.specular.r > 0.0 && shaded.diffuse.r > shaded.ambient.r);
    let painted = textures_and_emission::painted(shaded, [255; 3], 255, 255, Rgb::BLACK);
    assert!((painted.r - shaded.total().r).abs() < 1e-6);
    let seen = fog_toward_the_eye::fogged(painted, Rgb::gray(0.5), 1.0, 20.0);
    let mapped = exposure_and_luminance::reinhard(seen * exposure_and_luminance::exposure(0.0));
    assert!(bands::dithered(mapped, bands::threshold(1, 2)) > [0; 3]);

    // the same material in the other sums, with what arrives without the lights below the face
    let above = || lights_below_the_face::above(&lights, p, n);
    let faded = a_highlight_that_fades::faded(
        n,
        n,
        &plastic,
        Rgb::BLACK,
        above().collect::<Vec<_>>().into_iter(),
    );
    assert!(faded.specular.r <= shaded.specular.r);
    let rough = rough_surfaces::diffuse(
        &plastic,
        Rgb::BLACK,
        above(),
        rough_surfaces::oren_nayar(n, n, 0.5),
    );
    assert!(rough.r > 0.0 && rough.r < faded.diffuse.r + 1e-6);
    assert!(
        hair_brushed_metal_and_lines::strand(UnitVec3::X, n, &plastic, Rgb::BLACK, above()).r > 0.0
    );
    let wrapped = rough_surfaces::diffuse(
        &plastic,
        Rgb::BLACK,
        above(),
        wrapped_and_toon_shading::wrapped(n, 0.5),
    );
    assert!(wrapped.r > rough.r);

    // the side of a mirrored cube at x = 1, which the mirror moves to x = −1: normal and face are turned
    // together
    let mirror = [UnitVec3::NEG_X, UnitVec3::Y, UnitVec3::Z].map(|axis| *axis);
    let outward = mirrored_objects::outward(UnitVec3::X, mirror).unwrap();
    let v = Vec3::new(-1.0, 0.0, 1.0).unit().unwrap();
    let lit = |face| {
        let n = two_sided_surfaces::two_sided(face, *outward, None, v);
        let sun = Light::from(DirectionalLight {
            l: v,
            intensity: Rgb::WHITE,
        });
        let lit: Vec<_> = lights_below_the_face::above(&[sun], p, face).collect();
        rough_surfaces::diffuse(&plastic, Rgb::BLACK, lit.into_iter(), |l| n.dot(l).max(0.0)).r
    };
    assert!((lit(outward) - 0.5 * 0.5_f32.sqrt()).abs() < 1e-6); // k_d N·L, L at 45° to the side

    // a leaf in the plane z = 0 casts a shadow, but not on itself: it keeps the sun behind it, which
    // `shadows` leaves out, and the one in front of it
    let through = Rgb::new(0.2, 0.5, 0.1);
    let itself = |from: Vec3, toward: UnitVec3, within: f32| {
        let t = -from.z / toward.z;
        0.0 < t && t < within
    };
    let sun = |l| {
        Light::from(DirectionalLight {
            l,
            intensity: Rgb::WHITE,
        })
    };
    let suns = [sun(UnitVec3::NEG_Z), sun(n)];
    let reaching: Vec<IncidentLight> = leaves_and_paper_2::reaching_leaf(p, n, &suns, itself);
    assert_eq!(reaching.len(), 2);
    let behind = &reaching[..1];
    let leaf = leaves_and_paper::leaf(n, n, &plastic, through, Rgb::BLACK, behind);
    assert_eq!(leaf.total(), through);
    let front = leaves_and_paper::leaf(n, n, &plastic, through, Rgb::BLACK, &reaching[1..]);
    let by_shadows = shadows::shaded(p, n, n, &plastic, &suns, itself);
    assert_eq!(by_shadows.diffuse, front.diffuse); // the light from the front alone
}
