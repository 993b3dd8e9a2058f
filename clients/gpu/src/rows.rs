//! Every function of a WGSL file on random arguments, compared with the crate.

use std::borrow::Cow;
use std::fmt::Write as _;

use shading_languages::{Arguments, Function, Kind, functions};
use wgpu::ShaderSource;

use crate::Result;
use crate::draw::{Draw, arguments};
use crate::gpu::Gpu;

const CALLS: usize = 20_000;

/// What the power of a Vulkan device may be off by in a result, for m up to 200. The logarithm may be off
/// by 2⁻²¹, so its product with m by 200 · 2⁻²¹ and the power by ln 2 times that, 1,109 · 2⁻²⁴; the
/// exponential adds less than 91.
const POWER_BOUND: f32 = 1200.0 / 16_777_216.0;

/// Whether a file has the crate's own power.
#[derive(Clone, Copy, PartialEq)]
pub enum Power {
    Own,
    BuiltIn,
}

/// Compares all functions. Where the file has its own power, each bit must be the crate's.
pub fn compare(gpu: &Gpu, file: &str, power: Power) -> Result<()> {
    let draws = match power {
        // not `Extreme`, whose subnormal numbers a device may take for 0
        Power::Own => &[Draw::Ordinary, Draw::Special][..],
        Power::BuiltIn => &[Draw::Ordinary],
    };
    let (mut exact, mut largest) = (0, 0.0_f32);
    for function in functions() {
        let mut is_exact = true;
        for &draw in draws {
            let numbers = arguments(function, draw, CALLS);
            let source = ShaderSource::Wgsl(Cow::from(format!("{file}{}", kernel(function))));
            let width = function.result.width();
            let found = gpu.run(source, &[bytemuck::cast_slice(&numbers)], CALLS, width);
            let inputs: usize = function.parameters.iter().map(|p| p.1.width()).sum();
            for (x, y) in numbers.chunks(inputs).zip(found.chunks(width)) {
                let right = (function.compute)(Arguments::new(x.to_vec()));
                for (&y, &right) in y.iter().zip(&right) {
                    // a driver may simplify 0 − x to −x: zeros may have another sign
                    if y == right {
                        continue;
                    }
                    is_exact = false;
                    let difference = (y - right).abs() / right.abs().max(1.0);
                    largest = largest.max(difference);
                    if power == Power::Own || difference.is_nan() || difference > POWER_BOUND {
                        let name = function.name;
                        return Err(format!(
                            "{name} {draw:?} {x:?}: {y:e}, and the crate {right:e}"
                        )
                        .into());
                    }
                }
            }
        }
        exact += usize::from(is_exact);
    }
    let steps = largest * 16_777_216.0;
    println!(
        "{exact} of {} functions have the crate's bits; the largest difference is {steps} · 2⁻²⁴",
        functions().len()
    );
    Ok(())
}

/// The end of a module that computes a function for a buffer of numbers.
fn kernel(function: &Function) -> String {
    let mut at = 0;
    let arguments: Vec<_> = function
        .parameters
        .iter()
        .map(|p| argument(p.1, &mut at))
        .collect();
    let (name, arguments) = (function.name, arguments.join(", "));
    let mut stores = String::new();
    let results = numbers("r", function.result);
    for (i, number) in results.iter().enumerate() {
        writeln!(stores, "    y[{} * id.x + {i}] = {number};", results.len()).expect("a string");
    }
    format!(
        "@group(0) @binding(0) var<storage, read> x: array<f32>;
@group(0) @binding(1) var<storage, read_write> y: array<f32>;
@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {{
    let k = {at} * id.x;
    if k >= arrayLength(&x) {{
        return;
    }}
    let r = shading_{name}({arguments});
{stores}}}
"
    )
}

fn argument(kind: Kind, at: &mut usize) -> String {
    if kind.width() == 1 {
        *at += 1;
        return format!("x[k + {}]", *at - 1);
    }
    let (of, parts): (_, Vec<_>) = if let Some((name, _, fields)) = kind.fields() {
        let fields = fields.iter().map(|field| argument(field.1, at));
        (format!("shading_{name}"), fields.collect())
    } else {
        let numbers = (0..kind.width()).map(|_| argument(Kind::Number, at));
        (format!("vec{}f", kind.width()), numbers.collect())
    };
    format!("{of}({})", parts.join(", "))
}

fn numbers(of: &str, kind: Kind) -> Vec<String> {
    match (kind.fields(), kind.width()) {
        (Some((_, _, fields)), _) => {
            let field = |(name, kind): &(&str, Kind)| numbers(&format!("{of}.{name}"), *kind);
            fields.iter().flat_map(field).collect()
        }
        (None, 1) => vec![of.into()],
        (None, width) => ["x", "y", "z"][..width]
            .iter()
            .map(|c| format!("{of}.{c}"))
            .collect(),
    }
}
