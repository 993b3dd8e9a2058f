//! Runs the kernels on a Vulkan device and compares every number with the CPU's: `shader MODULE
//! [DEVICE]`. It exits with 1 where they differ by more than the bounds below.

mod module;
mod vulkan;

use std::error::Error;
use std::{env, fs, thread};

use bytemuck::Zeroable;
use fastrand::Rng;
use kernel::functions::{Input, NAMES, Output, Value, call};
use kernel::{BLINN_PHONG, LAMBERT, Lamp, PHONG, Point, RADII, ring, shaded};
use shading::f32::{Rgb, UnitVec3, Vec3};
use shading::reflection;

use vulkan::Gpu;

type Result<T> = std::result::Result<T, Box<dyn Error>>;

const BATCH: usize = 1 << 16;
const BATCHES: u64 = 16;

/// What Vulkan allows ÷ to be off by, 2.5 units in the last place, and √, which is 1 over a number
/// that is off by 2 units. Together with the rounding of the CPU, √ is off by 9.
const DRIVER_BOUND: u64 = 9;

/// A number of the scene differs by less than 2⁻¹¹ on a driver that is as inexact as Vulkan allows.
/// u is 2⁻²⁴; ÷ is off by 5u and √ by 9u.
///
/// The ring's circle has the radius 0.7 and its tube 0.25. The distance from the axis is at most
/// 0.95 and off by 11u of itself; less 0.7, it is off by 10.7u, which turns a tube's radius by 43u.
/// The slope of the root is off by 15u and its products by 3u, the rest of the gradient by 4u, and
/// `unit` by 15.5u: 81u in all, 50u on the CPU. N·L is off by 103u, 60u on the CPU. R turns by 2 ·
/// 81 + 18.5u and has 9u of its own, R·V 3u more: 193u; on the CPU 119u. The 30th power magnifies
/// this at most 30 times and adds 15u: 5,805u and 3,585u. A highlight has at most k_s I = 0.76, the
/// diffuse part k_d I = 0.69. With 12u for the sums, the two differ by at most 0.76 · 9,390 + 0.69
/// · 163 + 1.6 · 24 < 7,300u.
const SCENE_BOUND: f32 = 1.0 / 2048.0;

/// Functions that neither divide nor take a root, and so have the CPU's bits on every device.
const WITHOUT_DIVISION: [&str; 5] = [
    "reflection",
    "term::ambient",
    "term::lambert",
    "normal::facing",
    "DirectionalLight::at",
];

/// How the GPU's numbers compare with the CPU's.
#[derive(Default)]
struct Tally {
    numbers: u64,
    /// Equal, or both NaN; zeros may have another sign, as drivers simplify 0 − x to −x and x·0 to 0.
    equal: u64,
    /// The largest difference in units in the last place, and as a number.
    units: u64,
    difference: f32,
}

impl Tally {
    fn compare(&mut self, gpu: &[Output], cpu: &[Output]) {
        let [gpu, cpu] = [gpu, cpu].map(bytemuck::cast_slice::<_, f32>);
        for (gpu, cpu) in gpu.iter().zip(cpu) {
            // what a function does not fill is 0 on both sides
            if gpu.to_bits() | cpu.to_bits() != 0 {
                self.numbers += 1;
                if gpu == cpu || gpu.is_nan() && cpu.is_nan() {
                    self.equal += 1;
                } else {
                    self.units = self.units.max(rank(*gpu).abs_diff(rank(*cpu)));
                    self.difference = self.difference.max((gpu - cpu).abs());
                }
            }
        }
    }

    fn report(&self, name: &str) {
        let Self {
            numbers,
            equal,
            units,
            difference,
        } = self;
        print!("{name}: {equal} of {numbers} numbers are equal");
        if self.is_exact() {
            println!();
        } else {
            println!("; largest difference {units} units in the last place, {difference:e}");
        }
    }

    fn is_exact(&self) -> bool {
        self.equal == self.numbers && self.numbers > 0
    }
}

/// The index of a number among all numbers, so that a difference counts units in the last place.
fn rank(x: f32) -> i64 {
    let bits = i64::from(x.to_bits() as i32);
    if bits < 0 {
        i64::from(i32::MIN) - bits
    } else {
        bits
    }
}

fn on_all_cores<A: Sync>(from: &[A], f: impl Fn(&A) -> Output + Sync) -> Vec<Output> {
    let (mut to, f) = (vec![Output::zeroed(); from.len()], &f);
    let share = from
        .len()
        .div_ceil(thread::available_parallelism().map_or(1, usize::from));
    thread::scope(|scope| {
        for (from, to) in from.chunks(share).zip(to.chunks_mut(share)) {
            scope.spawn(move || to.iter_mut().zip(from).for_each(|(to, from)| *to = f(from)));
        }
    });
    to
}

/// Random numbers, with special values among them.
struct Random(Rng);

impl Random {
    /// True once in this many times, on average.
    fn once_in(&mut self, n: u32) -> bool {
        self.0.u32(..n) == 0
    }

    /// Within ±1, sometimes 0 or an integer.
    fn signed(&mut self) -> f32 {
        match self.0.u32(..16) {
            0 => 0.0,
            1 => self.0.i32(-1..=1) as f32,
            _ => 2.0 * self.0.f32() - 1.0,
        }
    }

    /// Within [0, limit], sometimes 0.
    fn up_to(&mut self, limit: f32) -> f32 {
        if self.once_in(16) {
            0.0
        } else {
            self.0.f32() * limit
        }
    }

    /// Within a cube of side 2, sometimes of any size.
    fn point(&mut self) -> Vec3 {
        let point = Vec3::new(self.signed(), self.signed(), self.signed());
        if self.once_in(32) {
            point * 2_f32.powi(self.0.i32(-60..60))
        } else {
            point
        }
    }

    fn unit(&mut self) -> UnitVec3 {
        let vectors =
            std::iter::repeat_with(|| Vec3::new(self.signed(), self.signed(), self.signed()));
        vectors.filter_map(Vec3::unit).next().expect("one of many")
    }

    fn color(&mut self) -> Rgb {
        Rgb::new(self.up_to(1.0), self.up_to(1.0), self.up_to(1.0))
    }

    fn input(&mut self) -> Input {
        let (a, n, l) = (self.point(), self.unit(), self.unit());
        let b = if self.once_in(32) { a } else { self.point() };
        let c = if self.once_in(32) { b } else { self.point() };
        let v = match self.0.u32(..16) {
            0 => -l,
            1 => l,
            2 => reflection(n, l),
            _ => self.unit(),
        };
        let (one, other) = (self.signed(), self.signed());
        let inner = if self.once_in(16) {
            l.dot(-v).clamp(-1.0, 1.0)
        } else {
            one.max(other)
        };
        Input {
            a,
            b,
            c,
            n: *n,
            l: *l,
            v: *v,
            k: self.color(),
            i: self.color(),
            coefficients: Vec3::new(self.up_to(2.0), self.up_to(2.0), self.up_to(2.0)),
            q: self.up_to(4.0),
            r: 0.1 + self.up_to(4.0),
            inner,
            outer: inner.min(one.min(other)),
            m: self.up_to(200.0),
            integer: self.0.u32(..200),
        }
    }

    /// A point of the ring.
    fn place(&mut self) -> Point {
        let [(sin_u, cos_u), (sin_v, cos_v)] =
            [(); 2].map(|()| (self.0.f32() * std::f32::consts::TAU).sin_cos());
        let radius = RADII[0] + RADII[1] * cos_v;
        let p = Vec3::new(radius * cos_u, radius * sin_u, RADII[1] * sin_v);
        let v = (Vec3::new(0.0, 2.7, 7.2) - p)
            .unit()
            .expect("away from the eye");
        Point {
            p,
            m: 25.0,
            v: *v,
            padding: 0.0,
        }
    }
}

/// Compares every function on random inputs. Returns whether the driver rounds ÷ and √ correctly.
fn functions(gpu: &Gpu) -> Result<bool> {
    let (mut inputs, mut outputs) = (gpu.buffer::<Input>(BATCH)?, gpu.buffer::<Output>(BATCH)?);
    let buffers = [(&inputs).into(), (&outputs).into()];
    let mut tallies: Vec<Tally> = NAMES.iter().map(|_| Tally::default()).collect();
    let kernels =
        (0..NAMES.len() as u32).map(|function| gpu.kernel("function", function, &buffers));
    let kernels = kernels.collect::<Result<Vec<_>>>()?;
    for seed in 0..BATCHES {
        let mut random = Random(Rng::with_seed(seed));
        inputs.numbers().fill_with(|| random.input());
        for (function, (kernel, tally)) in (0..).zip(kernels.iter().zip(&mut tallies)) {
            gpu.run(kernel, BATCH)?;
            let expected = on_all_cores(inputs.numbers(), |input| call(function, input));
            tally.compare(outputs.numbers(), &expected);
        }
    }
    // the first is the driver's own division and root
    let is_exact = tallies[0].is_exact();
    if tallies[0].units > DRIVER_BOUND {
        return Err("÷ or √ is less exact than Vulkan allows".into());
    }
    for (name, tally) in NAMES.iter().zip(&tallies) {
        tally.report(name);
        if (is_exact || WITHOUT_DIVISION.contains(name)) && !tally.is_exact() {
            return Err(format!("{name} differs from the CPU").into());
        }
    }
    Ok(is_exact)
}

/// Compares a ring under a lamp, with every model, an integer m and a real m.
fn scene(gpu: &Gpu, is_exact: bool) -> Result<()> {
    let mut random = Random(Rng::with_seed(0));
    let lamp = Lamp {
        position: Vec3::new(-3.2, 5.2, 4.2),
        intensity: Rgb::gray(0.95),
        ..Lamp::zeroed()
    };
    let (mut points, mut outputs) = (gpu.buffer::<Point>(BATCH)?, gpu.buffer::<Output>(BATCH)?);
    let mut lamps = gpu.buffer::<Lamp>(1)?;
    lamps.numbers()[0] = lamp;
    points.numbers().fill_with(|| random.place());
    // where N·L is nearly 0, its sign may differ on a device that rounds differently, and a
    // highlight may end there
    let is_on_horizon = |point: &Point| {
        let n = shading::normal::implicit(ring, point.p);
        n.zip((lamp.position - point.p).unit())
            .is_none_or(|(n, l)| n.dot(l).abs() < 1.0 / 4096.0)
    };
    for how in [LAMBERT].into_iter().chain(PHONG).chain(BLINN_PHONG) {
        let kernel = gpu.kernel(
            "scene",
            how,
            &[(&points).into(), (&outputs).into(), (&lamps).into()],
        )?;
        gpu.run(&kernel, BATCH)?;
        let expected = on_all_cores(points.numbers(), |point| {
            shaded(how, point, &[lamp]).output()
        });
        let mut tally = Tally::default();
        for ((point, gpu), cpu) in points.numbers().iter().zip(outputs.numbers()).zip(expected) {
            if is_exact || !is_on_horizon(point) {
                tally.compare(&[*gpu], &[cpu]);
            }
        }
        tally.report(&format!("the scene by model {how}"));
        if is_exact && !tally.is_exact() || tally.difference > SCENE_BOUND {
            return Err("the scene differs from the CPU's by more than the bound".into());
        }
    }
    Ok(())
}

fn main() -> Result<()> {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let (module, device) = match &arguments[..] {
        [module] => (module, 0),
        [module, device] => (module, device.parse()?),
        _ => return Err("usage: shader MODULE [DEVICE]".into()),
    };
    let bytes = fs::read(module)?;
    let words: Vec<u32> = bytes
        .chunks_exact(4)
        .map(|word| u32::from_le_bytes(word.try_into().expect("four")))
        .collect();
    let gpu = Gpu::new(device, &words)?;
    println!("device: {}; {:?}", gpu.name, gpu.controls);
    let is_exact = functions(&gpu)?;
    println!("the driver rounds ÷ and √ correctly: {is_exact}");
    scene(&gpu, is_exact)
}
