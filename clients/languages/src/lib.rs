//! `shading` for C and whatever can call C: `shading.h` declares and explains the functions. With
//! the feature `python`, it is a module for Python. JavaScript calls the functions of C, in
//! WebAssembly.
//!
//! Nothing here panics. If it did, the panic would end the program and not unwind into C.

#[cfg(target_arch = "x86_64")]
mod avx2;
mod c;
mod implicit;
mod kernel;
#[cfg(any(target_arch = "x86_64", target_feature = "simd128"))]
mod lanes;
mod light;
mod normals;
mod number;
mod pointer;
mod problem;
#[cfg(feature = "python")]
mod python;
mod scene;
#[cfg(target_feature = "simd128")]
mod simd128;
#[cfg(test)]
mod tests;
mod threads;
