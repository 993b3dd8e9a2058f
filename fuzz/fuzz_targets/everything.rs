//! Calls every public function with numbers made from the fuzzer's bytes, in `f32` and in `f64`:
//! nothing panics, and finite valid input gives neither NaN nor negative light.
#![no_main]

use kit::Float;
use kit::everything::{Numbers, any_bits, finite_and_valid};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| {
    let Some((m, bytes)) = data.split_first_chunk() else {
        return;
    };
    let m = u32::from_le_bytes(*m);
    feed(m, bytes, |bits| f32::from_bits(u32::from_le_bytes(bits)));
    feed(m, bytes, |bits| f64::from_bits(u64::from_le_bytes(bits)));
});

/// Makes numbers from the bytes, repeating them endlessly.
fn feed<T: Float, const N: usize>(m: u32, bytes: &[u8], of: impl Fn([u8; N]) -> T) {
    let numbers: Vec<T> = bytes.as_chunks().0.iter().copied().map(of).collect();
    if numbers.is_empty() {
        return;
    }
    for check in [any_bits, finite_and_valid] {
        let mut numbers = numbers.iter().copied().cycle();
        check(Numbers {
            next: &mut || numbers.next().expect("endless"),
            m,
        });
    }
}
