//! Every function of a file on random arguments, compared with the crate: in WGSL on a Vulkan device, and in
//! GLSL in a browser.

use std::fmt::Write as _;

use shading_languages::{Function, Kind, files, functions};
use wgpu::ShaderSource;

use crate::Result;
use crate::draw::{Draw, arguments, is_sound};
use crate::gpu::Gpu;

pub const CALLS: usize = 20_000;

/// Calls in a browser, which fill rows of 64.
const CALLS_IN_A_BROWSER: usize = 1024;

pub const DRAWS: [Draw; 3] = [Draw::Ordinary, Draw::Special, Draw::Extreme];

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

impl Power {
    /// By whether a file is to be exact.
    pub fn of(how: &str) -> Self {
        match how {
            "exact" => Self::Own,
            _ => Self::BuiltIn,
        }
    }
}

/// How a file computes beside the crate.
#[derive(Default)]
pub struct Tally {
    functions: usize,
    largest: f32,
    /// The calls with extreme numbers, and how many of them have the crate's results.
    extreme: usize,
    equal: usize,
}

impl Tally {
    /// Judges the results of a function. Where the file has its own power, they must be the crate's for
    /// ordinary and special numbers. A device may take subnormal numbers for 0, so that extreme ones must only
    /// be sound.
    fn judge(
        &mut self,
        function: &Function,
        draw: Draw,
        numbers: &[f32],
        found: &[f32],
        power: Power,
    ) -> Result<bool> {
        let inputs: usize = function.parameters.iter().map(|p| p.1.width()).sum();
        let mut is_exact = true;
        for (x, y) in numbers
            .chunks(inputs)
            .zip(found.chunks(function.result.width()))
        {
            let right = (function.compute)(x);
            // a driver may simplify 0 − x to −x: zeros may have another sign. A device may give 0 for a
            // subnormal number.
            let flushed = |x: &f32| if x.is_subnormal() { 0.0 } else { *x };
            let is_equal = y.iter().map(flushed).eq(right.iter().map(flushed));
            let differences = y
                .iter()
                .zip(&right)
                .map(|(y, right)| (y - right).abs() / right.abs().max(1.0));
            let largest = differences.fold(0.0, f32::max);
            let is_right = match (draw, power) {
                (Draw::Extreme | Draw::Edge, _) => {
                    self.extreme += 1;
                    self.equal += usize::from(is_equal);
                    true
                }
                (_, Power::Own) => is_equal,
                (Draw::Ordinary, Power::BuiltIn) => largest <= POWER_BOUND,
                (Draw::Special, Power::BuiltIn) => true, // a power of the least number
            };
            if draw == Draw::Ordinary {
                is_exact &= is_equal;
                self.largest = self.largest.max(largest);
            }
            if !is_right || !is_sound(function, y) {
                let name = function.name;
                return Err(
                    format!("{name} {draw:?} {x:?}: {y:?}, and the crate {right:?}").into(),
                );
            }
        }
        Ok(is_exact)
    }

    /// Judges what a function gives for each draw.
    pub fn of_function(
        &mut self,
        function: &Function,
        calls: usize,
        power: Power,
        compute: &mut dyn FnMut(&[f32]) -> Result<Vec<f32>>,
    ) -> Result<()> {
        let mut is_exact = true;
        for draw in DRAWS {
            let numbers = arguments(function, draw, calls);
            let found = compute(&numbers)?;
            if found.len() != calls * function.result.width() {
                return Err(format!("{}: {} numbers", function.name, found.len()).into());
            }
            is_exact &= self.judge(function, draw, &numbers, &found, power)?;
        }
        self.functions += usize::from(is_exact);
        Ok(())
    }

    pub fn report(&self) {
        let (all, steps) = (functions().len(), self.largest * 16_777_216.0);
        let Self {
            functions,
            extreme,
            equal,
            ..
        } = self;
        println!(
            "{functions} of {all} functions have the crate's bits; the largest difference is {steps} · 2⁻²⁴"
        );
        println!(
            "{extreme} calls with extreme numbers: no NaN, no negative light, {equal} with the crate's result"
        );
    }
}

/// The text of a file.
pub fn of_file(name: &str) -> Result<String> {
    let file = files().into_iter().find(|file| file.0 == name);
    Ok(file.ok_or("no file")?.1)
}

/// Compares all functions in WGSL.
pub fn compare(gpu: &Gpu, file: &str, power: Power) -> Result<()> {
    compare_shaders(gpu, power, &|function| {
        let source = format!("{file}{}", in_wgsl(function));
        Ok(ShaderSource::Wgsl(source.into()))
    })
}

/// Compares all functions, each by a shader that computes it for a buffer of numbers.
pub fn compare_shaders(
    gpu: &Gpu,
    power: Power,
    shader: &dyn Fn(&Function) -> Result<ShaderSource<'static>>,
) -> Result<()> {
    let mut tally = Tally::default();
    for function in functions() {
        let kernel = gpu.kernel(shader(function)?);
        let width = function.result.width();
        tally.of_function(function, CALLS, power, &mut |numbers| {
            Ok(kernel.run(&[bytemuck::cast_slice(numbers)], CALLS, width))
        })?;
    }
    tally.report();
    Ok(())
}

/// The calls of all functions in GLSL, each with the bits of its numbers, as a page has them.
pub fn calls() -> String {
    let mut page = String::new();
    for function in functions() {
        let inputs: usize = function.parameters.iter().map(|p| p.1.width()).sum();
        let draws = DRAWS.map(|draw| arguments(function, draw, CALLS_IN_A_BROWSER));
        let bits: Vec<_> = draws
            .iter()
            .flatten()
            .map(|x| x.to_bits().to_string())
            .collect();
        let bits = bits.join(" ");
        let results = function.result.width();
        let call = in_glsl(function, inputs);
        write!(
            page,
            "<script type=\"text/plain\" class=\"call\" data-inputs=\"{inputs}\" data-results=\"{results}\">
{call}</script>
<pre>{bits}</pre>
"
        )
        .expect("a string");
    }
    page
}

/// Judges what a page has answered to the calls: of each function four numbers of each call, and then four more.
pub fn judge_all(mut answers: &[f32], power: Power) -> Result<()> {
    let mut tally = Tally::default();
    for function in functions() {
        let (width, calls) = (function.result.width(), DRAWS.len() * CALLS_IN_A_BROWSER);
        let size = 4 * calls * width.div_ceil(4);
        let (own, rest) = answers
            .split_at_checked(size)
            .ok_or("the page has not answered all")?;
        answers = rest;
        let number = |call: usize, i: usize| own[4 * calls * (i / 4) + 4 * call + i % 4];
        let mut is_exact = true;
        for (k, draw) in DRAWS.into_iter().enumerate() {
            let calls = k * CALLS_IN_A_BROWSER..(k + 1) * CALLS_IN_A_BROWSER;
            let found: Vec<_> = calls
                .flat_map(|call| (0..width).map(move |i| number(call, i)))
                .collect();
            let numbers = arguments(function, draw, CALLS_IN_A_BROWSER);
            is_exact &= tally.judge(function, draw, &numbers, &found, power)?;
        }
        tally.functions += usize::from(is_exact);
    }
    tally.report();
    Ok(())
}

/// The end of a module that computes a function for a buffer of numbers.
fn in_wgsl(function: &Function) -> String {
    let mut at = 0;
    let arguments: Vec<_> = function
        .parameters
        .iter()
        .map(|p| argument(p.1, &mut at, &|i| format!("x[k + {i}]"), "f"))
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

/// The end of a fragment shader that computes a function for the numbers of a texture, and gives four of its
/// results.
fn in_glsl(function: &Function, inputs: usize) -> String {
    let mut at = 0;
    let arguments: Vec<_> = function
        .parameters
        .iter()
        .map(|p| argument(p.1, &mut at, &|i| format!("x({i})"), ""))
        .collect();
    let (name, arguments) = (function.name, arguments.join(", "));
    let of = match (function.result.fields(), function.result.width()) {
        (Some((name, _, _)), _) => format!("shading_{name}"),
        (None, 1) => "float".into(),
        (None, width) => format!("vec{width}"),
    };
    let mut results = numbers("r", function.result);
    results.resize(8, "0.0".into());
    format!(
        "
uniform sampler2D numbers;
uniform int part;
out vec4 color;

float x(int i) {{
    int k = {inputs} * (64 * int(gl_FragCoord.y) + int(gl_FragCoord.x)) + i;
    return texelFetch(numbers, ivec2((k >> 2) & 1023, k >> 12), 0)[k & 3];
}}

void main() {{
    {of} r = shading_{name}({arguments});
    float y[8] = float[8]({});
    color = vec4(y[4 * part], y[4 * part + 1], y[4 * part + 2], y[4 * part + 3]);
}}
",
        results.join(", ")
    )
}

/// An argument, of numbers from one on; the names of types have a suffix.
fn argument(kind: Kind, at: &mut usize, number: &dyn Fn(usize) -> String, suffix: &str) -> String {
    if kind.width() == 1 {
        *at += 1;
        return number(*at - 1);
    }
    let (of, parts): (_, Vec<_>) = if let Some((name, _, fields)) = kind.fields() {
        let fields = fields
            .iter()
            .map(|field| argument(field.1, at, number, suffix));
        (format!("shading_{name}"), fields.collect())
    } else {
        let numbers = (0..kind.width()).map(|_| argument(Kind::Number, at, number, suffix));
        (format!("vec{}{suffix}", kind.width()), numbers.collect())
    };
    format!("{of}({})", parts.join(", "))
}

pub fn numbers(of: &str, kind: Kind) -> Vec<String> {
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
