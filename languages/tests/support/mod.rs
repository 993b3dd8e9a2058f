//! Arguments for the functions of the files.

#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss
)]
#![allow(dead_code)] // each test uses a part

use shading_languages::{Function, Kind};

/// Whether a result has no NaN, and no light below 0.
pub fn is_sound(function: &Function, result: &[f32]) -> bool {
    // vectors have signs, and what arrives begins with one
    let light = match function.result {
        Kind::Unit | Kind::Vector | Kind::Tangent | Kind::Measured => &[],
        Kind::Arrival => &result[3..],
        _ => result,
    };
    !result.iter().any(|x| x.is_nan()) && light.iter().all(|x| *x >= 0.0)
}

/// The numbers of the arguments of many calls, one call after another.
pub fn arguments(function: &Function, draw: Draw, calls: usize) -> Vec<f32> {
    let is_made_finite = ["arrival", "total"].contains(&function.name);
    let mut random = Random {
        state: 7,
        draw,
        is_made_finite,
    };
    let mut all = vec![];
    for _ in 0..calls {
        for (name, kind) in function.parameters {
            random.draw(name, *kind, &mut all);
        }
    }
    all
}

pub const ALL: [Draw; 4] = [Draw::Ordinary, Draw::Special, Draw::Extreme, Draw::Edge];

/// How the numbers of an argument are drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Draw {
    Ordinary,
    /// 0, −0, ±1, the least and the largest, beside ordinary ones.
    Special,
    /// From the least number to the largest, each of its own size.
    Extreme,
    /// Numbers at which a comparison of a formula holds with equality, or may, beside ordinary ones.
    Edge,
}

/// Directions. Halfway between the fourth and the fifth, the cosine to the first is 0. The square of the last is
/// above 1.
const DIRECTIONS: [[f32; 3]; 6] = [
    [1.0, 0.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, 0.0, 1.0],
    [0.6, 0.8, 0.0],
    [-0.6, 0.8, 0.0],
    [0.498_756_8, -0.813_002_8, -0.300_446_7],
];

/// Edges of a triangle. At some of the angles to the x-axis, the angle begins to be measured otherwise; at others,
/// it is rounded otherwise if a coefficient of its series is one step larger.
const SPECIAL_VECTORS: [[f32; 3]; 8] = [
    [0.0, 0.0, 0.0],
    [1.0, 0.0, 0.0],
    [1.0, 2.414_213_7, 0.0],
    [1.0, 0.414_213_57, 0.0],
    [1.0, 0.414_213_6, 0.0],
    [1.0, 0.284_191_2, 0.0],
    [1.0, 0.326_280_36, 0.0],
    [0.0, 1.0, 0.0],
];

/// Exponents of 1/2 at which the power is rounded otherwise if its last coefficient is one step larger.
const SPECIAL_EXPONENTS: [f32; 3] = [0.220_329_88, 0.348_216_27, 0.426_914_87];

/// The first is the second times 11,863,283/2²⁴, from which on a quotient's logarithm has the next exponent.
const SPECIAL_QUOTIENT: [f32; 2] = [0.353_554_28, 0.500_001_25];

struct Random {
    state: u64,
    draw: Draw,
    is_made_finite: bool,
}

impl Random {
    fn bits(&mut self) -> u64 {
        self.state = self
            .state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.state >> 33) ^ (self.state >> 11)
    }

    fn fraction(&mut self) -> f32 {
        (self.bits() & 0xFF_FFFF) as f32 / 16_777_216.0
    }

    fn special(&mut self, of: &[f32], otherwise: f32) -> f32 {
        if self.draw == Draw::Special && self.bits() & 1 == 0 {
            of[self.bits() as usize % of.len()]
        } else {
            otherwise
        }
    }

    /// 10^x for an x from −45 to 38.5.
    fn size(&mut self) -> f32 {
        if self.draw == Draw::Extreme {
            10_f64.powf(f64::from(self.fraction()) * 83.5 - 45.0) as f32
        } else {
            4.0
        }
    }

    fn signed(&mut self) -> f32 {
        let x = 2.0 * self.fraction() - 1.0;
        self.special(&[0.0, -0.0, 1.0, -1.0, 0.5, 0.999_999_9, -0.999_999_9], x)
    }

    fn positive(&mut self, size: f32) -> f32 {
        let x = size * self.fraction();
        self.special(&[0.0, 1.0, 1e-12, f32::MAX, f32::MIN_POSITIVE], x)
    }

    fn unit(&mut self) -> [f32; 3] {
        let v = shading::Vec3::new(self.signed(), self.signed(), self.signed());
        <[f32; 3]>::from(v.unit_or(shading::UnitVec3::Z))
    }

    fn one_of<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.bits() as usize % all.len()]
    }

    /// An argument at an edge; nothing for a kind that has none.
    fn edge(&mut self, name: &str, kind: Kind) -> Option<Vec<f32>> {
        // the ends of the cosines that a cone stores, and what is one step beside
        const COSINES: [f32; 6] = [
            -1.0,
            -0.999_999_6,
            -0.999_999_5,
            0.999_999_5,
            0.999_999_6,
            1.0,
        ];
        Some(match kind {
            Kind::Cosine => vec![self.one_of(&COSINES)],
            Kind::Cosines => {
                let (a, b) = (self.one_of(&COSINES), self.one_of(&COSINES));
                vec![a.max(b), a.min(b)]
            }
            Kind::Positive if ["range", "limit", "r"].contains(&name) => {
                vec![self.one_of(&[1.0, 2e38, f32::MAX])]
            }
            Kind::Positive if name == "m" && self.bits() & 1 == 0 => {
                vec![self.one_of(&SPECIAL_EXPONENTS)]
            }
            Kind::Positive => vec![self.one_of(&[0.0, 1.0, 1e38])],
            Kind::Fraction if name == "d" => vec![self.one_of(&[SPECIAL_QUOTIENT[1], 1.0])],
            Kind::Fraction => vec![self.one_of(&[SPECIAL_QUOTIENT[0], 0.5, 1.0])],
            Kind::Color if name == "coefficients" => vec![1.0, 0.0, 0.0],
            // a sum or an intensity may have any size where the result is made finite
            Kind::Color if self.is_made_finite && !name.starts_with("k_") && name != "i_a" => {
                vec![self.one_of(&[1.0, 3e38]); 3]
            }
            Kind::Unit => {
                let sign = self.one_of(&[1.0, -1.0]);
                self.one_of(&DIRECTIONS).map(|x| x * sign).to_vec()
            }
            // two of these may be further apart than numbers go
            Kind::Vector if self.is_made_finite && self.one_of(&[true, false, false, false]) => {
                let size = self.one_of(&[2_f32.powi(127), -2_f32.powi(127)]);
                self.one_of(&DIRECTIONS).map(|x| x * size).to_vec()
            }
            Kind::Vector => {
                let of: &[[f32; 3]] = match self.bits() & 1 {
                    0 => &DIRECTIONS,
                    _ => &SPECIAL_VECTORS,
                };
                // the square of 2^50 and that of 2^-50 are at the ends of the range in which squares are exact
                let sizes = [
                    1.0,
                    1.0,
                    -1.0,
                    2_f32.powi(50),
                    2_f32.powi(-50),
                    2_f32.powi(126),
                ];
                let size = self.one_of(&sizes);
                self.one_of(of).map(|x| x * size).to_vec()
            }
            _ => return None,
        })
    }

    fn draw(&mut self, name: &str, kind: Kind, all: &mut Vec<f32>) {
        if self.draw == Draw::Edge
            && self.bits() & 3 != 0
            && let Some(numbers) = self.edge(name, kind)
        {
            return all.extend(numbers);
        }
        match kind {
            Kind::Flag => all.push((self.bits() & 1) as f32),
            Kind::Cosine => {
                let x = self.signed();
                all.push(x);
            }
            Kind::Fraction => {
                let x = self.fraction();
                let x = self.special(&[0.0, 1.0, f32::MIN_POSITIVE, 0.999_999_94], x);
                // a divisor is above 0
                all.push(if name == "d" {
                    x.max(f32::MIN_POSITIVE)
                } else {
                    x
                });
            }
            Kind::Number => {
                let x = self.signed() * self.size();
                all.push(x);
            }
            Kind::Positive => {
                let size = match name {
                    "m" => 200.0,
                    _ => 8.0,
                };
                let size = if self.draw == Draw::Extreme {
                    self.size()
                } else {
                    size
                };
                let x = self.positive(size);
                // a range and a limit are above 0
                all.push(if matches!(name, "range" | "limit" | "r") {
                    x.max(1e-30)
                } else {
                    x
                });
            }
            Kind::Pair => all.extend([self.signed(), self.signed()]),
            Kind::Cosines => {
                let (a, b) = (self.signed() + 0.0, self.signed() + 0.0);
                all.extend(if a > b { [a, b] } else { [b, a] });
            }
            Kind::Vector => {
                let size = self.size();
                let apart = self.draw == Draw::Extreme && self.bits() & 1 == 0;
                for _ in 0..3 {
                    let size = if apart { self.size() } else { size };
                    all.push(size * self.signed());
                }
            }
            Kind::Unit => all.extend(self.unit()),
            Kind::Color if name == "coefficients" => {
                for _ in 0..3 {
                    let x = self.positive(1.0).min(1e30);
                    all.push(x);
                }
                // not all are 0
                let at = all.len() - 3;
                if all[at..] == [0.0; 3] {
                    all[at] = 1.0;
                }
            }
            Kind::Color => {
                let size = if self.draw == Draw::Extreme {
                    self.size().min(1e18)
                } else {
                    1.0
                };
                for _ in 0..3 {
                    let x = size * self.fraction();
                    all.push(self.special(&[0.0, 1.0], x));
                }
            }
            _ => {
                for (name, kind) in kind.fields().expect("a struct").2 {
                    self.draw(name, *kind, all);
                }
            }
        }
    }
}
