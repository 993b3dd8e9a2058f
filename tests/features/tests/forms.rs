//! The form of each type in a file: these texts are a promise to everyone who has written one.

use std::fmt::Debug;

use serde::Serialize;
use serde::de::DeserializeOwned;
use shading::f64::{
    Attenuation, Cone, DirectionalLight, Light, Material, PointLight, Ranged, Rgb, SoftCone,
    SpotLight, UnitVec3, Vec3,
};

const LAMP: PointLight = PointLight {
    position: Vec3::new(2.0, -1.5, 0.5),
    intensity: Rgb::new(1.0, 0.8, 0.6),
    attenuation: Attenuation::new(1.0, 0.0, 0.25).unwrap(),
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
fn vectors_directions_and_colors_are_lists() {
    is(
        &Vec3::new(1.0, -2.5, 0.0),
        "[1.0,-2.5,0.0]",
        "(1.0,-2.5,0.0)",
    );
    is(&UnitVec3::NEG_Y, "[0.0,-1.0,0.0]", "(0.0,-1.0,0.0)");
    is(
        &Rgb::new(0.5, 0.25, 2.0),
        "[0.5,0.25,2.0]",
        "(0.5,0.25,2.0)",
    );
}

#[test]
fn numbers_need_no_point() {
    reads("[1, -2.5, 0]", "(1, -2.5, 0)", &Vec3::new(1.0, -2.5, 0.0));
}

#[test]
fn attenuation_is_the_list_of_its_coefficients() {
    is(&LAMP.attenuation, "[1.0,0.0,0.25]", "(1.0,0.0,0.25)");
    is(&Attenuation::NONE, "[1.0,0.0,0.0]", "(1.0,0.0,0.0)");
    reads("[1, 0, 0.25]", "[1, 0, 0.25]", &LAMP.attenuation);
}

#[test]
fn clamped_attenuation_is_a_map() {
    is(
        &LAMP.attenuation.clamped(),
        r#"{"coefficients":[1.0,0.0,0.25],"clamped":true}"#,
        "(coefficients:(1.0,0.0,0.25),clamped:true)",
    );
    reads(
        r#"{"clamped": false, "coefficients": [1, 0, 0.25]}"#,
        "(clamped: false, coefficients: (1, 0, 0.25))",
        &LAMP.attenuation,
    );
    reads(
        r#"{"coefficients": [1, 0, 0.25]}"#,
        "Attenuation(coefficients: (1, 0, 0.25))",
        &LAMP.attenuation,
    );
}

#[test]
fn cone_is_written_by_its_cosine_and_read_by_its_half_angle_too() {
    let sixty_degrees_wide = Cone::from_cosine(0.5).unwrap();
    is(&sixty_degrees_wide, r#"{"cosine":0.5}"#, "(cosine:0.5)");
    reads(
        r#"{"half_angle": 0.75}"#,
        "(half_angle: 0.75)",
        &Cone::from_half_angle(0.75).unwrap(),
    );
}

#[test]
fn range_is_one_more_entry() {
    is(
        &LAMP.attenuation.within(8.0).unwrap(),
        r#"{"coefficients":[1.0,0.0,0.25],"range":8.0}"#,
        "(coefficients:(1.0,0.0,0.25),range:8.0)",
    );
    is(
        &LAMP.attenuation.clamped().within(8.0).unwrap(),
        r#"{"coefficients":[1.0,0.0,0.25],"clamped":true,"range":8.0}"#,
        "(coefficients:(1.0,0.0,0.25),clamped:true,range:8.0)",
    );
    is(
        &LAMP.attenuation.within(8.0).unwrap().unsquared(),
        r#"{"coefficients":[1.0,0.0,0.25],"range":8.0,"unsquared":true}"#,
        "(coefficients:(1.0,0.0,0.25),range:8.0,unsquared:true)",
    );
    is(
        &Ranged::from(LAMP.attenuation).unsquared(),
        r#"{"coefficients":[1.0,0.0,0.25],"unsquared":true}"#,
        "(coefficients:(1.0,0.0,0.25),unsquared:true)",
    );
    reads(
        r#"{"unsquared": false, "range": 8, "coefficients": [1, 0, 0.25]}"#,
        "(unsquared: false, range: 8, coefficients: (1, 0, 0.25))",
        &LAMP.attenuation.within(8.0).unwrap(),
    );
}

#[test]
fn attenuation_without_a_range_is_read_where_there_may_be_one() {
    is(
        &Ranged::from(LAMP.attenuation),
        "[1.0,0.0,0.25]",
        "(1.0,0.0,0.25)",
    );
    is(
        &Ranged::from(LAMP.attenuation.clamped()),
        r#"{"coefficients":[1.0,0.0,0.25],"clamped":true}"#,
        "(coefficients:(1.0,0.0,0.25),clamped:true)",
    );
}

#[test]
fn soft_edge_is_one_more_entry() {
    let cone = SoftCone::from_cosines(0.875, 0.5).unwrap();
    is(
        &cone,
        r#"{"cosine":0.5,"inner_cosine":0.875}"#,
        "(cosine:0.5,inner_cosine:0.875)",
    );
    is(
        &cone.smoothstep(),
        r#"{"cosine":0.5,"inner_cosine":0.875,"smoothstep":true}"#,
        "(cosine:0.5,inner_cosine:0.875,smoothstep:true)",
    );
    reads(
        r#"{"inner_half_angle": 0.25, "half_angle": 0.75}"#,
        "(half_angle: 0.75, inner_half_angle: 0.25)",
        &SoftCone::from_half_angles(0.25, 0.75).unwrap(),
    );
}

#[test]
fn hard_cone_is_read_where_there_may_be_a_soft_one() {
    let cone = Cone::from_half_angle(0.75).unwrap();
    reads(
        r#"{"half_angle": 0.75}"#,
        "(half_angle: 0.75)",
        &SoftCone::from(cone),
    );
    let cone = Cone::from_cosine(0.5).unwrap();
    is(&SoftCone::from(cone), r#"{"cosine":0.5}"#, "(cosine:0.5)");
}

#[test]
fn lights_are_maps_of_their_fields() {
    is(
        &DirectionalLight {
            l: UnitVec3::Z,
            intensity: Rgb::WHITE,
        },
        r#"{"l":[0.0,0.0,1.0],"intensity":[1.0,1.0,1.0]}"#,
        "(l:(0.0,0.0,1.0),intensity:(1.0,1.0,1.0))",
    );
    is(
        &LAMP,
        r#"{"position":[2.0,-1.5,0.5],"intensity":[1.0,0.8,0.6],"attenuation":[1.0,0.0,0.25]}"#,
        "(position:(2.0,-1.5,0.5),intensity:(1.0,0.8,0.6),attenuation:(1.0,0.0,0.25))",
    );
}

#[test]
fn any_light_is_named_by_its_kind() {
    is(
        &Light::<Cone>::Directional(DirectionalLight {
            l: UnitVec3::X,
            intensity: Rgb::gray(0.5),
        }),
        r#"{"directional":{"l":[1.0,0.0,0.0],"intensity":[0.5,0.5,0.5]}}"#,
        "directional((l:(1.0,0.0,0.0),intensity:(0.5,0.5,0.5)))",
    );
    is(
        &Light::<Cone>::Point(LAMP),
        r#"{"point":{"position":[2.0,-1.5,0.5],"intensity":[1.0,0.8,0.6],"attenuation":[1.0,0.0,0.25]}}"#,
        "point((position:(2.0,-1.5,0.5),intensity:(1.0,0.8,0.6),attenuation:(1.0,0.0,0.25)))",
    );
    is(
        &Light::Spot(SpotLight {
            point: LAMP,
            axis: UnitVec3::NEG_Z,
            cone: Cone::from_cosine(0.875).unwrap(),
        }),
        r#"{"spot":{"point":{"position":[2.0,-1.5,0.5],"intensity":[1.0,0.8,0.6],"attenuation":[1.0,0.0,0.25]},"axis":[0.0,0.0,-1.0],"cone":{"cosine":0.875}}}"#,
        "spot((point:(position:(2.0,-1.5,0.5),intensity:(1.0,0.8,0.6),attenuation:(1.0,0.0,0.25)),axis:(0.0,0.0,-1.0),cone:(cosine:0.875)))",
    );
}

#[test]
fn material_has_four_fields() {
    let [k_a, k_d, k_s] = [0.125, 0.5, 0.25].map(Rgb::gray);
    is(
        &Material {
            k_a,
            k_d,
            k_s,
            m: 32,
        },
        r#"{"k_a":[0.125,0.125,0.125],"k_d":[0.5,0.5,0.5],"k_s":[0.25,0.25,0.25],"m":32}"#,
        "(k_a:(0.125,0.125,0.125),k_d:(0.5,0.5,0.5),k_s:(0.25,0.25,0.25),m:32)",
    );
    is(
        &Material {
            k_a,
            k_d,
            k_s,
            m: 32.5,
        },
        r#"{"k_a":[0.125,0.125,0.125],"k_d":[0.5,0.5,0.5],"k_s":[0.25,0.25,0.25],"m":32.5}"#,
        "(k_a:(0.125,0.125,0.125),k_d:(0.5,0.5,0.5),k_s:(0.25,0.25,0.25),m:32.5)",
    );
}

#[test]
fn integer_m_is_read_as_a_real_one() {
    let [k_a, k_d, k_s] = [1.0, 0.0, 0.0].map(Rgb::gray);
    reads(
        r#"{"m": 32, "k_s": [0, 0, 0], "k_d": [0, 0, 0], "k_a": [1, 1, 1]}"#,
        "(m: 32, k_s: (0, 0, 0), k_d: (0, 0, 0), k_a: (1, 1, 1))",
        &Material {
            k_a,
            k_d,
            k_s,
            m: 32.0,
        },
    );
}

/// Formats without names hold the fields in order, and a kind as its number.
#[test]
fn binary_forms_hold_the_fields_in_order() {
    let light = shading::f32::Light::Spot(shading::f32::SpotLight {
        point: shading::f32::PointLight {
            position: shading::Vec3::new(2.0, -1.5, 0.5),
            intensity: shading::Rgb::new(1.0, 0.8, 0.6),
            attenuation: shading::f32::Attenuation::new(1.0, 0.0, 0.25).unwrap(),
        },
        axis: shading::f32::UnitVec3::NEG_Z,
        cone: shading::f32::Cone::from_cosine(0.875).unwrap(),
    });
    let numbers = [2.0, -1.5, 0.5, 1.0, 0.8, 0.6, 1.0, 0.0, 0.25].map(f32::to_le_bytes);
    let rest = [0.0, 0.0, -1.0, 0.875].map(f32::to_le_bytes);
    let (kind, not_clamped) = ([2], [0]);
    let bytes = [
        &kind,
        numbers.as_flattened(),
        &not_clamped,
        rest.as_flattened(),
    ]
    .concat();
    assert_eq!(postcard::to_allocvec(&light).unwrap(), bytes);
    assert_eq!(
        postcard::from_bytes::<shading::f32::Light>(&bytes).unwrap(),
        light
    );
}

/// The same with a range and a soft edge.
#[test]
fn binary_forms_hold_all_fields() {
    let light: features::Light = shading::Light::Spot(shading::SpotLight {
        point: shading::PointLight {
            position: shading::Vec3::new(2.0, -1.5, 0.5),
            intensity: shading::Rgb::new(1.0, 0.8, 0.6),
            attenuation: shading::f32::Attenuation::new(1.0, 0.0, 0.25)
                .unwrap()
                .into(),
        },
        axis: shading::f32::UnitVec3::NEG_Z,
        cone: shading::f32::Cone::from_cosine(0.875).unwrap().into(),
    });
    let numbers = [2.0, -1.5, 0.5, 1.0, 0.8, 0.6, 1.0, 0.0, 0.25].map(f32::to_le_bytes);
    let rest = [0.0, 0.0, -1.0, 0.875, 0.875].map(f32::to_le_bytes);
    let bytes = [
        &[2],
        numbers.as_flattened(),
        &[0],
        &f32::INFINITY.to_le_bytes(),
        &[0],
        rest.as_flattened(),
        &[0],
    ]
    .concat();
    assert_eq!(postcard::to_allocvec(&light).unwrap(), bytes);
    assert_eq!(
        postcard::from_bytes::<features::Light>(&bytes).unwrap(),
        light
    );
}

/// The page on scene files shows one light in two formats.
#[test]
fn page_shows_a_light_that_can_be_read() {
    let page = include_str!("../../../docs/schema.md");
    let block = |language: &str| {
        let start = page.find(&format!("```{language}\n")).unwrap() + 4 + language.len();
        &page[start..start + page[start..].find("```").unwrap()]
    };
    let light: Light = serde_json::from_str(block("json")).unwrap();
    assert_eq!(light, ron::from_str(block("ron")).unwrap());
    assert!(matches!(light, Light::Spot(spot) if spot.axis == UnitVec3::NEG_Y));
}
