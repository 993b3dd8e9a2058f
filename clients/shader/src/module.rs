//! Adds to a SPIR-V module those rules of IEEE 754 that a device supports.

/// The rules that a device can be asked to keep in single precision.
#[derive(Clone, Copy, Debug)]
pub struct FloatControls {
    pub subnormals: bool,
    pub zeros_and_infinities: bool,
    pub round_to_even: bool,
}

const HEADER: usize = 5;
const ENTRY_POINT: u32 = 15;
const EXECUTION_MODE: u32 = 16;
const CAPABILITY: u32 = 17;
const DECORATE: u32 = 71;
const NO_CONTRACTION: u32 = 42;
/// Negation, sum, difference, product, quotient.
const ARITHMETIC: [u32; 5] = [127, 129, 131, 133, 136];

/// The module with each sum, difference, product and quotient kept as written. Otherwise a driver may fuse a
/// product with a sum, or simplify (x + c) − c to x.
pub fn exact(module: &[u32], controls: FloatControls) -> Vec<u32> {
    // the capability and the execution mode of each
    let modes = [
        (controls.subnormals, 4464, 4459),
        (controls.zeros_and_infinities, 4466, 4461),
        (controls.round_to_even, 4467, 4462),
    ];
    let modes = || modes.iter().filter(|mode| mode.0);
    let mut exact = module[..HEADER].to_vec();
    for (_, capability, _) in modes() {
        exact.extend(instruction(CAPABILITY, &[*capability]));
    }
    let (mut entry_points, mut is_decorated) = (Vec::new(), false);
    for words in instructions(module) {
        let opcode = words[0] & 0xFFFF;
        if opcode == ENTRY_POINT {
            entry_points.push(words[2]);
        } else {
            // execution modes stand behind the last entry point
            for entry_point in entry_points.drain(..) {
                for (_, _, mode) in modes() {
                    exact.extend(instruction(EXECUTION_MODE, &[entry_point, *mode, 32]));
                }
            }
        }
        if opcode == DECORATE && !is_decorated {
            is_decorated = true;
            for result in arithmetic(module) {
                exact.extend(instruction(DECORATE, &[result, NO_CONTRACTION]));
            }
        }
        exact.extend(words);
    }
    assert!(is_decorated, "the buffers have decorations");
    exact
}

fn instruction(opcode: u32, operands: &[u32]) -> impl Iterator<Item = u32> {
    let count = 1 + operands.len() as u32;
    std::iter::once(count << 16 | opcode).chain(operands.iter().copied())
}

/// Each instruction with its operands.
fn instructions(module: &[u32]) -> impl Iterator<Item = &[u32]> {
    let mut rest = &module[HEADER..];
    std::iter::from_fn(move || {
        let count = rest.first()? >> 16;
        let (first, others) = rest.split_at(count as usize);
        rest = others;
        Some(first)
    })
}

/// The results of floating-point arithmetic.
fn arithmetic(module: &[u32]) -> impl Iterator<Item = u32> {
    let is_arithmetic = |words: &&[u32]| ARITHMETIC.contains(&(words[0] & 0xFFFF));
    instructions(module)
        .filter(is_arithmetic)
        .map(|words| words[2])
}
