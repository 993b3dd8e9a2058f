//! What the processor has. The other files ask here, except for the instructions of
//! [`root`](crate::number), and for what must not be compiled elsewhere.

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

/// Whether an instruction counts the zeros before a number.
#[cfg(feature = "fixed")]
pub(crate) const COUNTS_ZEROS: bool =
    !(NARROW_PRODUCT || cfg!(all(target_arch = "riscv32", not(target_feature = "zbb"))));

/// Whether the maximum of two floats makes a number of a signaling NaN.
pub(crate) const KEEPS_SIGNALING_NAN: bool = cfg!(target_arch = "aarch64");

/// Whether floats are in SSE2 registers. The maximum and minimum of SSE2 return the second operand
/// unless the first is greater or less. That is exactly a comparison and a selection (measured: sums in
/// lanes take 11 to 17 % fewer instructions).
pub(crate) const SSE2: bool = cfg!(target_feature = "sse2");

/// Whether the processor has an instruction for the root of lanes. Elsewhere `wide` computes the root in
/// software, incorrectly for subnormal numbers.
#[cfg(feature = "wide")]
pub(crate) const ROOT_OF_LANES: bool = cfg!(any(
    target_feature = "sse2",
    target_feature = "simd128",
    all(target_arch = "aarch64", target_feature = "neon")
));
