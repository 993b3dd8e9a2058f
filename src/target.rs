//! What the processor has. The other files ask here, except for the instructions of
//! [`root`](crate::number) and of the lanes.

/// Whether flash is scarce: without an operating system, or under one for microcontrollers.
pub(crate) const SCARCE_FLASH: bool = cfg!(all(
    any(target_pointer_width = "16", target_pointer_width = "32"),
    any(
        target_os = "none",
        target_os = "espidf",
        target_os = "nuttx"
    ),
    not(target_family = "wasm")
));

/// Whether it has an FPU. Where flash is scarce, only Arm's hard-float ABI tells stable Rust so.
pub(crate) const FPU: bool = !SCARCE_FLASH || cfg!(target_abi = "eabihf");

/// Whether a product has no more bits than its factors, as on a Cortex-M0. A Cortex-M23 is like it,
/// but stable Rust cannot tell it from a Cortex-M33.
#[cfg(feature = "fixed")]
pub(crate) const NARROW_PRODUCT: bool =
    cfg!(all(target_arch = "arm", not(target_has_atomic = "32")));
