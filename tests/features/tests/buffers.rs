//! Vectors, directions, and colors as bytes, and the structs of `docs/buffers.md` as shaders see
//! them.

use std::collections::BTreeMap;

use bytemuck::{Pod, Zeroable, bytes_of, cast_slice};
use features::gpu::{GpuLight, GpuMaterial};
use naga::front::{glsl, wgsl};
use naga::{ShaderStage, TypeInner};
use shading::f32::{
    Attenuation, Cone, DirectionalLight, Light, Material, PointLight, Rgb, SpotLight, UnitVec3,
    Vec3,
};
use shading::fixed::Fixed;

const PAGE: &str = include_str!("../../../docs/buffers.md");

#[test]
fn three_numbers_follow_each_other_without_padding() {
    let numbers = [1.0_f32, 2.0, 3.0, 4.0, 5.0, 6.0];
    let vectors: &[Vec3] = cast_slice(&numbers);
    assert_eq!(
        vectors,
        [Vec3::new(1.0, 2.0, 3.0), Vec3::new(4.0, 5.0, 6.0)]
    );
    let colors: &[Rgb] = cast_slice(&numbers);
    assert_eq!(colors, [Rgb::new(1.0, 2.0, 3.0), Rgb::new(4.0, 5.0, 6.0)]);
    assert_eq!(
        cast_slice::<Vec3, u8>(vectors),
        cast_slice::<f32, u8>(&numbers)
    );
    assert_eq!(bytes_of(&UnitVec3::Y), bytes_of(&[0.0_f32, 1.0, 0.0]));

    assert_eq!(
        bytes_of(&shading::f64::UnitVec3::Z),
        bytes_of(&[0.0, 0.0, 1.0])
    );
    let fixed: &[shading::fixed::Vec3] = cast_slice(&[0x1_0000, 0x8000, -1]);
    let [half, step] = [Fixed::new(0.5), Fixed::STEP];
    assert_eq!(fixed, [shading::Vec3::new(Fixed::new(1.0), half, -step)]);
    assert_eq!(
        shading::Vec3::<i16>::zeroed(),
        shading::Vec3 { x: 0, y: 0, z: 0 }
    );
}

#[test]
fn page_shows_the_structs_that_are_tested() {
    assert!(PAGE.contains(include_str!("../src/gpu.rs")));
}

/// The name, offset, and size in bytes of each member of a struct, and of the struct itself.
type Layout = BTreeMap<String, (u32, u32)>;

/// The layout of a struct in the page's shader in this language.
fn layout(language: &str, name: &str) -> Layout {
    let start = PAGE.find(&format!("```{language}\n")).unwrap() + 4 + language.len();
    let source = &PAGE[start..start + PAGE[start..].find("```").unwrap()];
    let module = match language {
        "wgsl" => wgsl::parse_str(source).unwrap(),
        _ => glsl::Frontend::default()
            .parse(&glsl::Options::from(ShaderStage::Vertex), source)
            .unwrap(),
    };
    let mut types = module.types.iter().map(|(_, ty)| ty);
    let ty = types.find(|ty| ty.name.as_deref() == Some(name)).unwrap();
    let TypeInner::Struct { members, span } = &ty.inner else {
        panic!("{ty:?}")
    };
    let size = |ty| module.types[ty].inner.size(module.to_ctx());
    let members = members
        .iter()
        .map(|m| (m.name.clone().unwrap(), (m.offset, size(m.ty))));
    members.chain([(name.to_owned(), (0, *span))]).collect()
}

/// Checks that the shaders read exactly these numbers from the bytes of this struct.
fn shaders_read(name: &str, value: &impl Pod, expected: &[(&str, &[f32])]) {
    for language in ["glsl", "wgsl"] {
        let mut layout = layout(language, name);
        let bytes = bytes_of(value);
        assert_eq!(
            layout.remove(name),
            Some((0, u32::try_from(bytes.len()).unwrap())),
            "{language}"
        );
        for (member, numbers) in expected {
            let (offset, size) = layout.remove(*member).unwrap();
            let bytes = &bytes[offset as usize..][..size as usize];
            assert_eq!(
                bytes,
                cast_slice::<f32, u8>(numbers),
                "{language}: {member}"
            );
        }
        assert!(layout.is_empty(), "{language}: {layout:?}");
    }
}

const LAMP: PointLight = PointLight {
    position: Vec3::new(1.0, 2.0, 3.0),
    intensity: Rgb::new(4.0, 5.0, 6.0),
    attenuation: Attenuation::new(7.0, 8.0, 9.0).unwrap(),
};

#[test]
fn spot_arrives_in_the_shader() {
    let spot = SpotLight {
        point: PointLight {
            attenuation: LAMP.attenuation.clamped(),
            ..LAMP
        },
        axis: UnitVec3::new(0.0, 0.6, 0.8).unwrap(),
        cone: Cone::from_cosine(0.5).unwrap(),
    };
    shaders_read(
        "Light",
        &GpuLight::from(&Light::Spot(spot)),
        &[
            ("position", &[1.0, 2.0, 3.0]),
            ("is_directional", &[0.0]),
            ("intensity", &[4.0, 5.0, 6.0]),
            ("cosine", &[0.5]),
            ("coefficients", &[7.0, 8.0, 9.0]),
            ("limit", &[1.0]),
            ("axis", &[0.0, 0.6, 0.8]),
        ],
    );
}

#[test]
fn lamp_arrives_in_the_shader() {
    shaders_read(
        "Light",
        &GpuLight::from(&Light::Point(LAMP)),
        &[
            ("position", &[1.0, 2.0, 3.0]),
            ("is_directional", &[0.0]),
            ("intensity", &[4.0, 5.0, 6.0]),
            ("cosine", &[-1.0]),
            ("coefficients", &[7.0, 8.0, 9.0]),
            ("limit", &[f32::MAX]),
            ("axis", &[0.0, 0.0, 0.0]),
        ],
    );
}

#[test]
fn sun_arrives_in_the_shader() {
    let sun = DirectionalLight {
        l: UnitVec3::X,
        intensity: Rgb::new(4.0, 5.0, 6.0),
    };
    shaders_read(
        "Light",
        &GpuLight::from(&Light::Directional(sun)),
        &[
            ("position", &[1.0, 0.0, 0.0]),
            ("is_directional", &[1.0]),
            ("intensity", &[4.0, 5.0, 6.0]),
            ("cosine", &[0.0]),
            ("coefficients", &[0.0, 0.0, 0.0]),
            ("limit", &[0.0]),
            ("axis", &[0.0, 0.0, 0.0]),
        ],
    );
}

#[test]
fn material_arrives_in_the_shader() {
    let material = Material {
        k_a: Rgb::new(1.0, 2.0, 3.0),
        k_d: Rgb::new(4.0, 5.0, 6.0),
        k_s: Rgb::new(7.0, 8.0, 9.0),
        m: 10.0,
    };
    shaders_read(
        "Material",
        &GpuMaterial::from(&material),
        &[
            ("k_a", &[1.0, 2.0, 3.0]),
            ("m", &[10.0]),
            ("k_d", &[4.0, 5.0, 6.0]),
            ("k_s", &[7.0, 8.0, 9.0]),
        ],
    );
}
