//! Runs every call on the host.

#[test]
fn every_item_can_be_called() {
    downstream::numbers::call();
    downstream::vectors::call();
    downstream::formulas::call();
    downstream::scenes::call();
    downstream::types::call();
}

#[cfg(feature = "approx")]
#[test]
fn approx() {
    downstream::features::approx::call();
}

#[cfg(feature = "bytemuck")]
#[test]
fn bytemuck() {
    downstream::features::bytemuck::call();
}

#[cfg(feature = "fixed")]
#[test]
fn fixed() {
    downstream::features::fixed::call();
}

#[cfg(feature = "mint")]
#[test]
fn mint() {
    downstream::features::mint::call();
}

#[cfg(feature = "serde")]
#[test]
fn serde() {
    downstream::features::serde::call();
}

#[cfg(feature = "wide")]
#[test]
fn wide() {
    downstream::features::wide::call();
}

#[cfg(feature = "defmt")]
mod defmt {
    use std::sync::atomic::{AtomicUsize, Ordering};

    static SENT: AtomicUsize = AtomicUsize::new(0);

    #[defmt::global_logger]
    struct Wire;

    // SAFETY: one test sends, and there is nothing to take or give back.
    unsafe impl defmt::Logger for Wire {
        fn acquire() {}

        unsafe fn flush() {}

        unsafe fn release() {}

        unsafe fn write(bytes: &[u8]) {
            SENT.fetch_add(bytes.len(), Ordering::Relaxed);
        }
    }

    defmt::timestamp!("");

    #[test]
    fn defmt() {
        downstream::features::defmt::call();
        assert!(SENT.load(Ordering::Relaxed) > 0);
    }
}
