//! Promises broken on purpose, one per feature. With them, `run.sh` checks that each of its checks
//! can fail.

use core::hint::black_box;

/// Returns the zero that it is given; a feature adds the defect that it is named after.
#[inline(always)]
pub fn promise(zero: f32) -> f32 {
    if cfg!(feature = "broken-bits") && cfg!(target_os = "none") {
        return 1e-45;
    }
    if cfg!(feature = "broken-panic") {
        let digits = [0.0, 1.0];
        return digits[black_box(zero) as usize];
    }
    if cfg!(feature = "broken-doubles") {
        return (black_box(f64::from(zero)) * black_box(1.5)) as f32;
    }
    if cfg!(feature = "broken-instructions") {
        (0..10_000).for_each(|i| _ = black_box(i));
    }
    if cfg!(feature = "broken-flash") {
        #[cfg(target_os = "none")]
        crate::board::thousand_instructions();
    }
    if cfg!(feature = "broken-stack") {
        black_box([zero; 100]);
    }
    zero
}
