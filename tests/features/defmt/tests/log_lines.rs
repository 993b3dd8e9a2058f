//! A log line of each type, sent and decoded.

use std::sync::Mutex;

use defmt_decoder::Table;
use shading::f32::{
    Attenuation, Cone, DirectionalLight, Dual, Light, Material, PointLight, Rgb, Shaded, SoftCone,
    SpotLight, UnitVec3, Vec3,
};

/// The bytes sent so far.
static SENT: Mutex<Vec<u8>> = Mutex::new(Vec::new());

#[defmt::global_logger]
struct Wire;

// SAFETY: only one thread of tests runs below, and there is nothing to acquire or release.
unsafe impl defmt::Logger for Wire {
    fn acquire() {}

    unsafe fn flush() {}

    unsafe fn release() {}

    unsafe fn write(bytes: &[u8]) {
        SENT.lock().unwrap().extend_from_slice(bytes);
    }
}

/// Sends a value, and returns what the host prints.
fn log(value: impl defmt::Format) -> String {
    defmt::println!("{}", value);
    let program = std::fs::read(std::env::current_exe().unwrap()).unwrap();
    let table = Table::parse(&program).unwrap().expect("log lines");
    let line = std::mem::take(&mut *SENT.lock().unwrap());
    table.decode(&line).unwrap().0.display_message().to_string()
}

const LAMP: PointLight = PointLight {
    position: Vec3::new(0.0, 1.5, -2.0),
    intensity: Rgb::new(1.0, 0.5, 0.25),
    attenuation: Attenuation::new(1.0, 0.0, 0.25).unwrap(),
};

/// A single test, since there is a single wire.
#[test]
fn each_type_has_a_line() {
    assert_eq!(log(LAMP.position), "Vec3(0.0, 1.5, -2.0)");
    assert_eq!(log(UnitVec3::NEG_X), "UnitVec3(-1.0, 0.0, 0.0)");
    assert_eq!(
        log(shading::f64::Rgb::new(1.0, 0.5, 0.1)),
        "Rgb(1.0, 0.5, 0.1)"
    );
    let number = shading::fixed::Fixed::new(-1.25);
    assert_eq!(log(number), "-1.25");
    assert_eq!(log(shading::Rgb::gray(number)), "Rgb(-1.25, -1.25, -1.25)");
    assert_eq!(
        log(Dual {
            value: 2.5,
            gradient: Vec3::new(1.0, 0.0, 0.5)
        }),
        "Dual(2.5, Vec3(1.0, 0.0, 0.5))"
    );
    assert_eq!(
        log(LAMP.attenuation.clamped()),
        "Attenuation([1.0, 0.0, 0.25], clamped: true)"
    );
    let cone = Cone::from_cosine(0.75).unwrap();
    assert_eq!(log(cone), "Cone(cosine: 0.75)");

    let sun = DirectionalLight {
        l: UnitVec3::Z,
        intensity: Rgb::gray(2.0),
    };
    let sun_line = "DirectionalLight(l: UnitVec3(0.0, 0.0, 1.0), intensity: Rgb(2.0, 2.0, 2.0))";
    assert_eq!(log(sun), sun_line);
    assert_eq!(log(<Light>::from(sun)), sun_line);
    let lamp_line = "PointLight(position: Vec3(0.0, 1.5, -2.0), intensity: Rgb(1.0, 0.5, 0.25), \
                     attenuation: Attenuation([1.0, 0.0, 0.25], clamped: false))";
    assert_eq!(log(LAMP), lamp_line);
    assert_eq!(log(<Light>::from(LAMP)), lamp_line);
    let spot = SpotLight {
        point: LAMP,
        axis: UnitVec3::NEG_Y,
        cone,
    };
    assert_eq!(
        log(Light::Spot(spot)),
        format!("SpotLight({lamp_line}, axis: UnitVec3(0.0, -1.0, 0.0), cone: Cone(cosine: 0.75))")
    );
    let ranged = LAMP.attenuation.within(8.0).unwrap().unsquared();
    let ranged_line =
        "Ranged(Attenuation([1.0, 0.0, 0.25], clamped: false), range: 8.0, unsquared: true)";
    assert_eq!(log(ranged), ranged_line);
    let soft = SoftCone::from_cosines(0.875, 0.75).unwrap().smoothstep();
    let soft_line = "SoftCone(cosines: [0.875, 0.75], smoothstep: true)";
    assert_eq!(log(soft), soft_line);
    let point = shading::PointLight {
        position: Vec3::ZERO,
        intensity: Rgb::BLACK,
        attenuation: ranged,
    };
    assert_eq!(
        log(shading::Light::Spot(shading::SpotLight {
            point,
            axis: UnitVec3::X,
            cone: soft
        })),
        format!(
            "SpotLight(PointLight(position: Vec3(0.0, 0.0, 0.0), intensity: Rgb(0.0, 0.0, 0.0), \
             attenuation: {ranged_line}), axis: UnitVec3(1.0, 0.0, 0.0), cone: {soft_line})"
        )
    );
    let incident = LAMP.at(Vec3::new(0.0, 1.5, 0.0));
    assert_eq!(
        log(incident),
        "IncidentLight(l: UnitVec3(0.0, 0.0, -1.0), intensity: Rgb(0.5, 0.25, 0.125), distance: 2.0)"
    );

    let [k_a, k_d, k_s] = [0.125, 0.5, 0.25].map(Rgb::gray);
    let reflectances =
        "k_a: Rgb(0.125, 0.125, 0.125), k_d: Rgb(0.5, 0.5, 0.5), k_s: Rgb(0.25, 0.25, 0.25)";
    assert_eq!(
        log(Material {
            k_a,
            k_d,
            k_s,
            m: 32
        }),
        format!("Material({reflectances}, m: 32)")
    );
    assert_eq!(
        log(Material {
            k_a,
            k_d,
            k_s,
            m: 0.5
        }),
        format!("Material({reflectances}, m: 0.5)")
    );
    assert_eq!(
        log(Shaded {
            ambient: k_a,
            diffuse: k_d,
            specular: k_s
        }),
        "Shaded(ambient: Rgb(0.125, 0.125, 0.125), diffuse: Rgb(0.5, 0.5, 0.5), specular: Rgb(0.25, 0.25, 0.25))"
    );
}
