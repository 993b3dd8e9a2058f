//! Normals, directions, terms, falloffs, cones.

use shading::{
    Attenuation, Beam, Cone, Dual, Falloff, Ranged, Real, Rgb, SoftCone, UnitVec3, Vec3,
};
use shading::{normal, term};

const ORIGIN: Vec3 = Vec3::ZERO;

pub fn call() {
    normals();
    derived_normals();
    directions();
    terms();
    attenuations();
    ranges();
    cones();
    soft_cones();
}

fn normals() {
    let [x, y, z] = [UnitVec3::X, UnitVec3::Y, UnitVec3::Z].map(Vec3::from);
    assert_eq!(normal::plane(0.0, 0.0, 2.0), Some(UnitVec3::Z));
    assert_eq!(normal::triangle(ORIGIN, x, y), Some(UnitVec3::Z));
    assert_eq!(normal::sphere(ORIGIN, z * 5.0), Some(UnitVec3::Z));
    let sphere = |p: Vec3<Dual>| p.dot(p) - 1.0;
    assert_eq!(normal::implicit(sphere, z), Some(UnitVec3::Z));
    let sheet = |u: Dual, v: Dual| Vec3::new(u, v, Dual::ZERO);
    assert_eq!(normal::parametric(sheet, 1.0, 2.0), Some(UnitVec3::Z));
    assert_eq!(normal::from_gradient(z * 3.0), Some(UnitVec3::Z));
    assert_eq!(normal::from_tangents(x, y), Some(UnitVec3::Z));
}

fn derived_normals() {
    let [x, y, z] = [UnitVec3::X, UnitVec3::Y, UnitVec3::Z].map(Vec3::from);
    let v: UnitVec3 = UnitVec3::Z;
    assert_eq!(normal::facing(UnitVec3::NEG_Z, v), v);
    let stretched = [x * 2.0, y * 3.0, z];
    assert_eq!(
        normal::transformed(UnitVec3::Z, stretched),
        Some(UnitVec3::Z)
    );
    assert_eq!(normal::mapped(UnitVec3::Z, x, 1.0, z), Some(UnitVec3::Z));
    let tangent = normal::tangent([ORIGIN, x, y], [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]);
    assert_eq!(tangent, Some((UnitVec3::X, 1.0)));
    let share = normal::corner(ORIGIN, x, y); // π/2 along z
    assert!(share.z > 1.57 && share.z < 1.58);
}

fn directions() {
    let l = UnitVec3::<f32>::new(0.6, 0.0, 0.8).unwrap();
    assert_eq!(shading::reflection(UnitVec3::Z, l).z, l.z);
    assert_eq!(shading::half_vector(l, l), l.unit());
}

fn terms() {
    let (x, z): (UnitVec3, UnitVec3) = (UnitVec3::X, UnitVec3::Z);
    assert_eq!(
        term::ambient(Rgb::gray(0.5), Rgb::gray(0.5)),
        Rgb::gray(0.25)
    );
    assert_eq!(term::lambert(z, z), 1.0);
    assert_eq!(term::phong(z, z, 8), 1.0);
    assert_eq!(term::blinn(z, x, 8.0), 0.0);
    // (0 + 2)/(2π) and (0 + 2)(0 + 4)/(8π(1 + 0)) are 1/π
    for factor in [
        term::phong_normalization(0.0_f32),
        term::blinn_normalization(0.0_f32),
    ] {
        assert!(factor > 0.318 && factor < 0.319);
    }
}

fn attenuations() {
    const HALF: Attenuation = Attenuation::<f32>::new(1.0, 0.0, 0.25).unwrap();
    assert_eq!(shading::attenuation(1.0, 0.0, 0.25, 2.0), 0.5);
    assert_eq!(Attenuation::at(HALF, 2.0), 0.5);
    assert_eq!(Attenuation::coefficients(HALF), [1.0, 0.0, 0.25]);
    let bright = Attenuation::<f64>::new(0.0, 0.0, 1.0).unwrap();
    let clamped = Attenuation::clamped(bright);
    assert!(Attenuation::is_clamped(clamped) && Attenuation::at(clamped, 0.5) == 1.0);
    assert_eq!(Attenuation::cast(HALF, f64::from).at(2.0), 0.5);
    assert_eq!(Attenuation::of(1.0, 0.0, 0.25), Some(HALF));
    assert_eq!(<Attenuation as Default>::default(), Attenuation::NONE);
    falloff(HALF);
    assert_eq!(
        <Attenuation as Falloff<f32>>::dim(&HALF, &Rgb::WHITE, 2.0),
        Rgb::gray(0.5)
    );
}

fn ranges() {
    let one = Attenuation::NONE;
    let short = Attenuation::<f32>::within(one, 4.0).unwrap();
    assert_eq!(
        (Ranged::range(short), Ranged::attenuation(short)),
        (4.0, one)
    );
    assert_eq!(Ranged::at(short, 4.0), 0.0);
    assert_eq!(Ranged::of(one, 4.0), Some(short));
    assert_eq!(Ranged::cast(short, f64::from).range(), 4.0);
    assert_eq!(<Ranged as From<Attenuation>>::from(one).at(9.0), 1.0);
    assert!(Attenuation::<f64>::within(Attenuation::NONE, 0.0).is_none());
    assert_eq!(Ranged::from(Attenuation::<f64>::NONE).at(9.0), 1.0);
    falloff(short);
    assert_eq!(
        <Ranged as Falloff<f32>>::dim(&short, &Rgb::WHITE, 4.0),
        Rgb::BLACK
    );
}

/// What a lamp asks of its falloff, which lights the distance 1.
fn falloff<A: Falloff<f32>>(falloff: A) {
    assert!(Falloff::reaches(&falloff, 1.0));
    let light: Rgb = Falloff::dim(&falloff, &Rgb::WHITE, 1.0);
    assert!(light.r > 0.0);
    let _: <A as Falloff<f32>>::In<f64> = Falloff::cast(falloff, f64::from);
}

fn cones() {
    const HALF_SPACE: Cone = Cone::<f32>::from_cosine(0.0).unwrap();
    const WIDE: Cone<f64> = Cone::<f64>::from_half_angle(1.0).unwrap();
    assert!(Cone::<f32>::from_half_angle(1.0).is_some() && Cone::<f64>::from_cosine(2.0).is_none());
    assert_eq!(Cone::cosine(HALF_SPACE), 0.0);
    assert_eq!(Cone::of_cosine(0.0), Some(HALF_SPACE));
    assert_eq!(Cone::of_half_angle(1.0), Some(WIDE));
    assert_eq!(Cone::factor(WIDE, UnitVec3::Z, UnitVec3::NEG_Z), 1.0);
    assert_eq!(Cone::cast(HALF_SPACE, f64::from).cosine(), 0.0);
    beam(HALF_SPACE);
    assert_eq!(
        <Cone as Beam<f32>>::factor(HALF_SPACE, UnitVec3::Z, UnitVec3::Z),
        0.0
    );
}

fn soft_cones() {
    const SOFT: SoftCone = SoftCone::<f32>::from_cosines(0.75, 0.0).unwrap();
    const NARROW: SoftCone<f64> = SoftCone::<f64>::from_half_angles(0.1, 0.2).unwrap();
    assert_eq!(SoftCone::<f32>::from_half_angles(0.2, 0.1), None);
    assert_eq!(SoftCone::<f64>::from_cosines(0.0, 1.0), None);
    assert_eq!(SoftCone::cosines(SOFT), [0.75, 0.0]);
    assert_eq!(SoftCone::of_cosines(0.75, 0.0), Some(SOFT));
    assert_eq!(SoftCone::of_half_angles(0.1, 0.2), Some(NARROW));
    let smooth = SoftCone::smoothstep(SOFT);
    assert!(SoftCone::is_smoothstep(smooth) && !SoftCone::is_smoothstep(SOFT));
    assert_eq!(SoftCone::factor(NARROW, UnitVec3::Z, UnitVec3::NEG_Z), 1.0);
    assert_eq!(SoftCone::cast(SOFT, f64::from).cosines(), [0.75, 0.0]);
    let hard = Cone::<f32>::from_cosine(0.5).unwrap();
    assert_eq!(<SoftCone as From<Cone>>::from(hard).cosines(), [0.5, 0.5]);
    beam(SOFT);
    assert_eq!(
        <SoftCone as Beam<f32>>::factor(SOFT, UnitVec3::Z, UnitVec3::Z),
        0.0
    );
}

/// What a spot asks of its cone.
fn beam<C: Beam<f32>>(beam: C) {
    assert_eq!(Beam::factor(beam, UnitVec3::Z, UnitVec3::NEG_Z), 1.0_f32);
    let _: <C as Beam<f32>>::In<f64> = Beam::cast(beam, f64::from);
}
