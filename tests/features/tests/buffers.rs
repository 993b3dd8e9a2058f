//! Vectors, colors and directions as bytes, the shader's struct of `docs/gpu.md`, and conversions
//! by way of `mint`.

use shading::f32::{Rgb, UnitVec3, Vec3};

const PAGE: &str = include_str!("../../../docs/gpu.md");
const FILE: &str = include_str!("../../../languages/shading.wgsl");

#[test]
fn slices_are_bytes_without_padding() {
    let bytes = [1.0_f32, 2.0, 3.0, 4.0, 5.0, 6.0].map(f32::to_ne_bytes);
    let [v, w] = [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]];
    let expected = bytes.as_flattened();
    assert_eq!(
        bytemuck::cast_slice::<Vec3, u8>(&[v.into(), w.into()]),
        expected
    );
    assert_eq!(
        bytemuck::cast_slice::<Rgb, u8>(&[v.into(), w.into()]),
        expected
    );
    let unit = [v, w].map(|v| UnitVec3::assume_unit(v.into()));
    assert_eq!(bytemuck::cast_slice::<UnitVec3, u8>(&unit), expected);
    let read = bytemuck::pod_read_unaligned::<[f32; 6]>(expected);
    assert_eq!(
        bytemuck::cast_slice::<f32, Vec3>(&read),
        [v.into(), w.into()]
    );
}

/// The members of the page's struct in Rust, and where each begins; at last, where it ends.
fn written(name: &str) -> Vec<(&'static str, u32)> {
    let body = PAGE.split_once(&format!("struct Gpu{name} {{")).unwrap().1;
    let lines = body
        .lines()
        .skip(1)
        .map(|line| line.trim().split_once(": "));
    let mut end = 0;
    let members = lines.map_while(|member| member).map(|(name, kind)| {
        let begin = end;
        end += match kind.split(',').next().unwrap() {
            "f32" => 4,
            "[f32; 2]" => 8,
            "Vec3" | "Rgb" | "[f32; 3]" => 12,
            other => panic!("{other}"),
        };
        (name, begin)
    });
    let members: Vec<_> = members.collect();
    [&members[..], &[("", end)]].concat()
}

/// The page's structs in Rust and those of the file in WGSL have the same members at the same places.
#[test]
fn shaders_read_the_structs_of_the_page() {
    let module = naga::front::wgsl::parse_str(FILE).unwrap();
    for name in ["Light", "Material"] {
        let mut types = module.types.iter().map(|(_, kind)| kind);
        let in_the_file = format!("shading_{name}");
        let kind = types.find(|kind| kind.name.as_ref() == Some(&in_the_file));
        let naga::TypeInner::Struct { members, span } = &kind.unwrap().inner else {
            panic!("{name} is no struct");
        };
        let read = members
            .iter()
            .map(|member| (member.name.as_deref().unwrap(), member.offset));
        let read = read.chain([("", *span)]);
        let is_named = |(name, _): &(&str, u32)| !name.starts_with("padding");
        let named: Vec<_> = read.filter(is_named).collect();
        let written = written(name).into_iter().filter(is_named);
        assert_eq!(named, written.collect::<Vec<_>>(), "{name}");
    }
}

#[test]
fn glam_and_mint_keep_each_coordinate_in_its_place() {
    fn to_mint<V: mint::IntoMint>(vector: V) -> V::MintType {
        vector.into()
    }
    let v = Vec3::new(1.0, 2.0, 3.0);
    assert_eq!(to_mint(v), mint::Vector3::from([1.0, 2.0, 3.0]));
    assert_eq!(to_mint(UnitVec3::Y), mint::Vector3::from([0.0, 1.0, 0.0]));
    assert_eq!(mint::Point3::from(v), mint::Point3::from([1.0, 2.0, 3.0]));
    let there: glam::Vec3 = mint::Vector3::from(v).into();
    assert_eq!(there, glam::vec3(1.0, 2.0, 3.0));
    assert_eq!(Vec3::from(mint::Vector3::from(there)), v);
    assert_eq!(Vec3::from(mint::Point3::from(there)), v);
    let n = mint::Vector3::from(UnitVec3::NEG_Z.cast(f64::from));
    assert_eq!(glam::DVec3::from(n), glam::DVec3::NEG_Z);
}
