//! The form of each type in a file. These texts are a promise to everyone who has written one.

use std::fmt::Debug;

use serde::Serialize;
use serde::de::DeserializeOwned;
use shading::f32::{
    Attenuation, Cone, DirectionalLight, Light, Material, PointLight, Rgb, SpotLight, UnitVec3,
    Vec3,
};

/// In both formats, the value is written as this text, and the text is read as this value.
fn is(value: &(impl Serialize + DeserializeOwned + PartialEq + Debug), json: &str, ron: &str) {
    assert_eq!(serde_json::to_string(value).unwrap(), json);
    assert_eq!(ron::to_string(value).unwrap(), ron);
    reads(json, ron, value);
}

/// Both texts are read as this value.
fn reads<V: DeserializeOwned + PartialEq + Debug>(json: &str, ron: &str, value: &V) {
    assert_eq!(&serde_json::from_str::<V>(json).unwrap(), value, "{json}");
    assert_eq!(&ron::from_str::<V>(ron).unwrap(), value, "{ron}");
}

#[test]
fn parts() {
    let v = Vec3::new(1.0, -2.5, 0.0);
    is(&v, "[1.0,-2.5,0.0]", "(1.0,-2.5,0.0)");
    reads("[1, -2.5, 0]", "(1, -2.5, 0)", &v);
    is(&UnitVec3::NEG_Y, "[0.0,-1.0,0.0]", "(0.0,-1.0,0.0)");
    is(
        &Rgb::new(0.5, 0.25, 2.0),
        "[0.5,0.25,2.0]",
        "(0.5,0.25,2.0)",
    );

    let falling = Attenuation::new(1.0, 0.0, 0.25).unwrap();
    let within = falling.within(8.0).unwrap();
    is(
        &falling,
        r#"{"a":1.0,"b":0.0,"c":0.25,"limit":null,"range":null,"range_gltf":null}"#,
        "(a:1.0,b:0.0,c:0.25,limit:None,range:None,range_gltf:None)",
    );
    is(
        &falling.within_gltf(8.0).unwrap().clamped(),
        r#"{"a":1.0,"b":0.0,"c":0.25,"limit":1.0,"range":null,"range_gltf":8.0}"#,
        "(a:1.0,b:0.0,c:0.25,limit:Some(1.0),range:None,range_gltf:Some(8.0))",
    );
    reads(
        r#"{"c": 0.25, "a": 1, "b": 0}"#,
        "(c: 0.25, b: 0, a: 1)",
        &falling,
    );
    reads("[1, 0, 0.25]", "Attenuation(a: 1, b: 0, c: 0.25)", &falling);
    let implicit = "#![enable(implicit_some)] (a: 1, b: 0, c: 0.25, range: 8)";
    reads("[1, 0, 0.25, null, 8]", implicit, &within);

    let hard = Cone::from_cosine(0.5).unwrap();
    is(&hard, r#"{"cosine":0.5}"#, "cosine(0.5)");
    is(
        &Cone::from_cosines(0.875, 0.5).unwrap(),
        r#"{"cosines":{"inner":0.875,"outer":0.5,"smoothstep":false}}"#,
        "cosines((inner:0.875,outer:0.5,smoothstep:false))",
    );
    is(
        &Cone::from_cosines(0.875, 0.5).unwrap().smoothstep(),
        r#"{"cosines":{"inner":0.875,"outer":0.5,"smoothstep":true}}"#,
        "cosines((inner:0.875,outer:0.5,smoothstep:true))",
    );
    is(&hard.smoothstep(), r#"{"cosine":0.5}"#, "cosine(0.5)");
    let of_angle = Cone::from_half_angle(0.75).unwrap();
    reads(r#"{"half_angle": 0.75}"#, "half_angle(0.75)", &of_angle);
    let of_angles = Cone::from_half_angles(0.25, 0.75).unwrap();
    reads(
        r#"{"half_angles": {"outer": 0.75, "inner": 0.25}}"#,
        "half_angles((outer: 0.75, inner: 0.25))",
        &of_angles,
    );
}

#[test]
fn lights_are_maps_named_by_their_kind() {
    let point = PointLight {
        position: Vec3::new(2.0, -1.5, 0.5),
        intensity: Rgb::new(1.0, 0.5, 0.25),
        attenuation: Attenuation::new(1.0, 0.0, 0.25)
            .unwrap()
            .within(8.0)
            .unwrap(),
    };
    let json = concat!(
        r#"{"position":[2.0,-1.5,0.5],"intensity":[1.0,0.5,0.25],"attenuation":"#,
        r#"{"a":1.0,"b":0.0,"c":0.25,"limit":null,"range":8.0,"range_gltf":null}}"#
    );
    let ron = "(position:(2.0,-1.5,0.5),intensity:(1.0,0.5,0.25),attenuation:\
               (a:1.0,b:0.0,c:0.25,limit:None,range:Some(8.0),range_gltf:None))";
    let named = format!(r#"{{"point":{json}}}"#);
    is(&Light::Point(point), &named, &format!("point({ron})"));
    let (axis, cone) = (UnitVec3::NEG_Z, Cone::from_cosine(0.875).unwrap());
    let spot = Light::Spot(SpotLight { point, axis, cone });
    is(
        &spot,
        &format!(
            r#"{{"spot":{{"point":{json},"axis":[0.0,0.0,-1.0],"cone":{{"cosine":0.875}}}}}}"#
        ),
        &format!("spot((point:{ron},axis:(0.0,0.0,-1.0),cone:cosine(0.875)))"),
    );
    // formats without names hold the fields in order, a kind as its number, an option after a byte
    let bytes = |numbers: &[f32]| numbers.iter().flat_map(|x| x.to_le_bytes()).collect();
    let fields: [Vec<u8>; 8] = [
        vec![2], // a spot
        bytes(&[2.0, -1.5, 0.5, 1.0, 0.5, 0.25, 1.0, 0.0, 0.25]),
        vec![0, 1], // not clamped; a range
        bytes(&[8.0]),
        vec![0], // squared
        bytes(&[0.0, 0.0, -1.0]),
        vec![0], // one cosine
        bytes(&[0.875]),
    ];
    assert_eq!(postcard::to_allocvec(&spot).unwrap(), fields.concat());
}

const PAGE: &str = include_str!("../../../docs/schema.md");

#[test]
fn page_shows_one_light_in_two_formats() {
    let block = |start| {
        PAGE.split_once(start)
            .unwrap()
            .1
            .split_once("```")
            .unwrap()
            .0
    };
    let light: Light = serde_json::from_str(block("```json\n")).unwrap();
    assert_eq!(light, ron::from_str(block("```ron\n")).unwrap());
    assert!(matches!(light, Light::Spot(spot) if spot.cone.is_smoothstep()));
}

#[test]
fn examples_in_the_table_of_the_page_are_read() {
    fn read<V: DeserializeOwned>(json: &str) {
        serde_json::from_str::<V>(json).unwrap_or_else(|error| panic!("{json}: {error}"));
    }
    let mut count = 0;
    for row in PAGE.lines().filter(|line| line.starts_with("| `")) {
        let mut code = row.split('`').skip(1).step_by(2);
        let name = code.next().unwrap();
        for json in code.filter(|code| code.starts_with(['[', '{'])) {
            count += 1;
            match name {
                "Vec3" => read::<Vec3>(json),
                "Rgb" => read::<Rgb>(json),
                "UnitVec3" => read::<UnitVec3>(json),
                "Attenuation" => read::<Attenuation>(json),
                "Cone" => read::<Cone>(json),
                "DirectionalLight" => read::<DirectionalLight>(json),
                "PointLight" => read::<PointLight>(json),
                "Material" => read::<Material>(json),
                other => panic!("{other}"),
            }
        }
    }
    assert_eq!(count, 13);
}
