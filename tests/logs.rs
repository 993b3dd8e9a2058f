//! What `defmt` sends: the numbers as they are, each behind the index of its format.

use std::cell::RefCell;

use defmt::Format;
use shading::fixed::Fixed;
use shading::{
    Attenuation, Cone, DirectionalLight, Light, PointLight, Rgb, SpotLight, UnitVec3, Vec3,
};

thread_local! {
    static SENT: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
}

#[defmt::global_logger]
struct Sent;

// SAFETY: Each thread sends to a buffer of its own.
unsafe impl defmt::Logger for Sent {
    fn acquire() {}
    unsafe fn flush() {}
    unsafe fn release() {}
    unsafe fn write(bytes: &[u8]) {
        SENT.with_borrow_mut(|sent| sent.extend(bytes));
    }
}

defmt::timestamp!("");

fn sent(value: &impl Format) -> Vec<u8> {
    defmt::println!("{}", value);
    SENT.take()
}

fn contains(bytes: &[u8], number: &[u8]) -> bool {
    bytes.windows(number.len()).any(|window| window == number)
}

#[test]
fn a_light_of_any_kind_is_sent_as_that_kind() {
    fn assert_same(light: impl Format + Copy + Into<Light>) {
        let bytes = sent(&light);
        assert_eq!(sent(&light.into()), bytes);
        for channel in [4.0_f32, 5.0, 6.0] {
            assert!(contains(&bytes, &channel.to_le_bytes()), "{bytes:?}");
        }
    }

    let intensity = Rgb::new(4.0, 5.0, 6.0);
    let point = PointLight {
        position: Vec3::new(1.0, 2.0, 3.0),
        intensity,
        attenuation: Attenuation::NONE,
    };
    let (l, axis) = (UnitVec3::X, UnitVec3::NEG_Z);
    let cone = Cone::from_cosine(0.5).unwrap();
    assert_same(DirectionalLight { l, intensity });
    assert_same(point);
    assert_same(SpotLight { point, axis, cone });
}

#[test]
fn a_fixed_point_number_is_sent_in_double_precision() {
    let bytes = sent(&Fixed::new(-2.5));
    assert!(contains(&bytes, &(-2.5_f64).to_le_bytes()), "{bytes:?}");
}
