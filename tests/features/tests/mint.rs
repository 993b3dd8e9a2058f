//! Conversions to and from `mint` keep each coordinate in its place.

use shading::{UnitVec3, Vec3};

const V: Vec3<f32> = Vec3::<f32>::new(1.0, 2.0, 3.0);

fn to_mint<V: mint::IntoMint>(vector: V) -> V::MintType {
    vector.into()
}

#[test]
fn each_coordinate_keeps_its_place() {
    assert_eq!(mint::Vector3::from(V), mint::Vector3::from([1.0, 2.0, 3.0]));
    assert_eq!(mint::Point3::from(V), mint::Point3::from([1.0, 2.0, 3.0]));
    assert_eq!(Vec3::from(mint::Vector3::from(V)), V);
    assert_eq!(Vec3::from(mint::Point3::from(V)), V);
}

#[test]
fn a_vector_is_a_vector_of_mint() {
    assert_eq!(to_mint(V), mint::Vector3::from([1.0, 2.0, 3.0]));
    assert_eq!(to_mint(UnitVec3::Y), mint::Vector3::from([0.0, 1.0, 0.0]));
}

#[test]
fn glam_vectors_convert_both_ways() {
    let there: glam::Vec3 = mint::Vector3::from(V).into();
    assert_eq!(there, glam::vec3(1.0, 2.0, 3.0));
    assert_eq!(Vec3::from(mint::Point3::from(there)), V);

    let n = mint::Vector3::from(UnitVec3::<f64>::NEG_Z);
    assert_eq!(glam::DVec3::from(n), glam::DVec3::NEG_Z);
}

#[test]
fn nalgebra_vectors_and_points_convert_both_ways() {
    let vector: nalgebra::Vector3<f32> = mint::Vector3::from(V).into();
    assert_eq!(vector, nalgebra::Vector3::new(1.0, 2.0, 3.0));
    let back: mint::Vector3<f32> = vector.into();
    assert_eq!(Vec3::from(back), V);

    let point: nalgebra::Point3<f32> = mint::Point3::from(V).into();
    assert_eq!(point, nalgebra::Point3::new(1.0, 2.0, 3.0));
    let back: mint::Point3<f32> = point.into();
    assert_eq!(Vec3::from(back), V);
}
