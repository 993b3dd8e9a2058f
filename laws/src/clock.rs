//! The time of a run, where there is a clock.

use std::time::Duration;

/// The time since some moment, which never goes back.
///
/// A page has no clock that the standard library knows. There, the default stands still, so only the numbers of
/// scenes and of batches end a search, unless [`Laws`](crate::Laws) is given a clock such as one that asks the
/// page for `performance.now()`.
pub type Clock = fn() -> Duration;

/// The clock of the standard library, where it has one.
#[cfg(not(all(target_family = "wasm", target_os = "unknown")))]
pub fn of_machine() -> Duration {
    use std::sync::LazyLock;
    use std::time::Instant;

    static START: LazyLock<Instant> = LazyLock::new(Instant::now);
    START.elapsed()
}

/// No clock: asking the standard library for one would end the program.
#[cfg(all(target_family = "wasm", target_os = "unknown"))]
pub fn of_machine() -> Duration {
    Duration::ZERO
}
