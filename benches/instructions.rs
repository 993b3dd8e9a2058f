//! Counts the instructions of each public function under valgrind, whose counts repeat exactly.
//!
//! `cargo bench -p shading-benches --bench instructions` prints the table; with `-- --check`, it
//! fails if a count differs from `instructions.txt` by more than 3%; with `-- --write`, it writes
//! that file. Each function is called out of line at the ordinary places of the digests; `nothing`
//! is the cost of that alone.

mod ggx;

use std::fmt::Write;
use std::hint::black_box;
use std::process::{Command, ExitCode};

use kit::{Given, places::places, row};
use shading::{Lanes, Lobe, Material, PointLight, Rgb, Shaded, Vec3, shade};
use wide::{f32x4, f32x8};

type Place = Given<f32>;

const TABLE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/instructions.txt");
const TOLERANCE: f64 = 0.03;
const PREFIX: &str = "shading_counted_";

macro_rules! counted {
    ($($row:ident $name:literal |$g:ident| $call:expr;)*) => {
        &[$({
            #[unsafe(export_name = concat!("shading_counted_", stringify!($row)))]
            #[inline(never)]
            extern "C" fn $row($g: &Place) {
                black_box($name); // without a difference, the compiler would merge equal functions
                let _ = black_box($call);
            }
            ($name, stringify!($row), $row)
        }),*]
    };
}

macro_rules! rows {
    (
        ARITHMETIC: Number $arithmetic:tt SWEEPS: Number $sweeps:tt SERIES: Float $series:tt
        $($section:ident: $bound:ident {
            $($row:ident $name:literal |$given:ident| $call:expr => $promise:ident;)*
        })*
    ) => {
        counted! { $($($row $name |g| row::$row(g);)*)* }
    };
}

type Function = (&'static str, &'static str, extern "C" fn(&Place));
const ROWS: &[Function] = kit::for_each_function!(rows);
const OTHERS: &[Function] = counted! {
    baseline "nothing" |g| g.x;
    by_arrival "GGX, by IncidentLight::arrival" |g| ggx::by_arrival(g);
    by_hand "GGX, by hand" |g| ggx::by_hand(g);
    into_lanes "Vec3::from_lanes, eight" |g|
        Vec3::<f32x8>::from_lanes([g.a, g.b, g.p, *g.n, *g.l, *g.v, g.p, g.a]);
    out_of_lanes "Rgb::to_lanes, eight" |g| Rgb::new(g.x, g.y, g.cosine).map(f32x8::splat).to_lanes();
    packed "PointLight::packed, eight" |g| PointLight::packed::<f32x8>(&[g.lamps[0]; 8]).next();
    four_integer "shade::blinn_phong, integer m, four lanes" |g| sum::<f32x4, _>(g, g.integer);
    four_real "shade::blinn_phong, real m, four lanes" |g| sum::<f32x4, _>(g, g.real);
    eight_integer "shade::blinn_phong, integer m, eight lanes" |g| sum::<f32x8, _>(g, g.integer);
    eight_real "shade::blinn_phong, real m, eight lanes" |g| sum::<f32x8, _>(g, g.real);
};

/// A sum in lanes, each of which has the same lamp.
#[inline]
fn sum<L: Lanes<Lane = f32>, M: Lobe<L>>(g: &Place, material: Material<f32, M>) -> Shaded<f32> {
    let splat = |x| L::from_fn(|_| x);
    let [n, v] = [g.n, g.v].map(|direction| direction.cast(splat));
    let lamp = g.lamps[0].cast(splat).at(g.p.map(splat));
    shade::blinn_phong(n, v, &material.cast(splat), Rgb::WHITE, [lamp]).sum_of_lanes()
}

fn all() -> impl Iterator<Item = &'static Function> {
    OTHERS[..1].iter().chain(ROWS).chain(&OTHERS[1..])
}

fn main() -> ExitCode {
    let given = |option: &str| std::env::args().any(|a| a == option);
    let mut places: Vec<Place> = places()
        .enumerate()
        .filter(|(i, _)| i % 8 < 5)
        .map(|(_, place)| place)
        .collect();
    for place in &mut places {
        (place.integer.m, place.real.m) = (50, 50.5);
    }
    if given("--call") {
        for (_, _, function) in all() {
            for place in &places {
                function(place);
            }
        }
        return ExitCode::SUCCESS;
    }
    let kept = std::fs::read_to_string(TABLE).unwrap_or_default();
    let counts = counts(f64::from(u16::try_from(places.len()).unwrap()));
    let (mut table, mut off) = (
        format!(
            "# instructions per call on x86-64, compiled by {}\n",
            rustc()
        ),
        0,
    );
    for (name, row, _) in all() {
        let count = counts
            .iter()
            .find(|(counted, _)| counted == row)
            .map_or(f64::NAN, |(_, count)| *count);
        writeln!(table, "{name:48} {count:8.1}").unwrap();
        let before = kept
            .lines()
            .find_map(|line| line.strip_prefix(name)?.trim().parse::<f64>().ok());
        if given("--check")
            && !before.is_some_and(|before| (count / before - 1.0).abs() <= TOLERANCE)
        {
            eprintln!("{name}: {count:.1} instead of {before:?}");
            off += 1;
        }
    }
    print!("{table}");
    if given("--check") && kept.lines().count() != table.lines().count() {
        eprintln!("instructions.txt has other rows than the table of functions");
        off += 1;
    }
    if given("--write") {
        std::fs::write(TABLE, table).unwrap();
    }
    ExitCode::from(u8::from(off > 0))
}

/// The instructions of a call by row.
fn counts(calls: f64) -> Vec<(String, f64)> {
    let out = concat!(env!("CARGO_TARGET_TMPDIR"), "/callgrind.out");
    let this = std::env::current_exe().unwrap();
    let counted = Command::new("valgrind")
        .args([
            "--tool=callgrind",
            "--quiet",
            &format!("--callgrind-out-file={out}"),
        ])
        .arg(this)
        .arg("--call")
        .status();
    assert!(
        counted.is_ok_and(|status| status.success()),
        "valgrind counted nothing"
    );
    let shown = Command::new("callgrind_annotate")
        .args(["--inclusive=yes", "--threshold=100", out])
        .output()
        .unwrap();
    let shown = String::from_utf8(shown.stdout).unwrap();
    let count = |line: &str| {
        let (number, name) = (line.split_whitespace().next()?, line.split_once(PREFIX)?.1);
        let row = name
            .split(|c: char| !c.is_alphanumeric() && c != '_')
            .next()?;
        Some((
            row.to_owned(),
            number.replace(',', "").parse::<f64>().ok()? / calls,
        ))
    };
    shown.lines().filter_map(count).collect()
}

/// The version of the compiler: another one may give other counts.
fn rustc() -> String {
    let version = Command::new("rustc").arg("--version").output().unwrap();
    String::from_utf8(version.stdout).unwrap().trim().to_owned()
}
