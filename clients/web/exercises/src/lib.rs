//! A page of exercises: the laws try a function that a student writes in JavaScript, and `shading` draws the right
//! picture.
//!
//! The page writes JSON to [`input`] and calls a function. What the function answers is text, which [`text`] points
//! to, or numbers.

mod picture;
mod surfaces;

use std::sync::{Mutex, MutexGuard, PoisonError};

use shading_laws::{Fault, Laws, Profile, Progress, Renderer, Scene};

#[link(wasm_import_module = "page")]
unsafe extern "C" {
    /// Shades scenes, JSON values between commas, and writes three numbers for each. Nonzero ends the run.
    fn shade_all(scenes: *const u8, length: usize, colors: *mut f64) -> u32;
    /// Hears how many scenes were asked for, and how many laws are broken.
    fn goes_on(asked: usize, of: usize, broken: usize);
}

static INPUT: Mutex<Vec<u8>> = Mutex::new(Vec::new());
static TEXT: Mutex<String> = Mutex::new(String::new());
static NUMBERS: Mutex<Vec<f64>> = Mutex::new(Vec::new());

fn lock<T>(of: &'static Mutex<T>) -> MutexGuard<'static, T> {
    of.lock().unwrap_or_else(PoisonError::into_inner)
}

fn read() -> String {
    String::from_utf8_lossy(&lock(&INPUT)).into_owned()
}

/// The student's function, which answers in JavaScript.
struct Student(Profile);

impl Renderer for Student {
    fn profile(&self) -> Profile {
        self.0.clone()
    }

    fn shade(&mut self, scenes: &[Scene]) -> Result<Vec<[f64; 3]>, String> {
        let lines: Vec<String> = scenes.iter().map(Scene::to_json).collect();
        let (lines, mut colors) = (lines.join(","), vec![[0.0; 3]; scenes.len()]);
        // SAFETY: the page reads this text, writes three numbers a scene, and does not call back
        let stopped = unsafe { shade_all(lines.as_ptr(), lines.len(), colors.as_mut_ptr().cast()) };
        if stopped == 0 {
            Ok(colors)
        } else {
            Err("the function threw an error".into())
        }
    }

    fn goes_on(&mut self, progress: &Progress) -> bool {
        // SAFETY: it takes three numbers
        unsafe { goes_on(progress.asked, progress.of, progress.broken) };
        true
    }
}

/// Where the page writes so many bytes.
#[unsafe(no_mangle)]
pub extern "C" fn input(length: usize) -> *mut u8 {
    let mut input = lock(&INPUT);
    *input = vec![0; length];
    input.as_mut_ptr()
}

/// Where the text of the last answer is.
#[unsafe(no_mangle)]
pub extern "C" fn text() -> *const u8 {
    lock(&TEXT).as_ptr()
}

/// How long it is, in bytes.
#[unsafe(no_mangle)]
pub extern "C" fn text_length() -> usize {
    lock(&TEXT).len()
}

/// Tries the student's function by the laws. The input is its profile, and the text is the report.
#[unsafe(no_mangle)]
pub extern "C" fn check(cases: usize, seed: u32) {
    let laws = Laws {
        cases,
        seed: seed.into(),
        ..Laws::default()
    };
    let report = Profile::from_json(&read()).and_then(|profile| laws.run(&mut Student(profile)));
    *lock(&TEXT) = match report {
        Ok(report) => report.to_json(),
        Err(why) => format!("{{\"error\":{why:?}}}"),
    };
}

/// Lists the known mistakes as text: the name and the words of each, in lines that a tab divides.
#[unsafe(no_mangle)]
pub extern "C" fn mistakes() {
    let lines = Fault::known().map(|fault| format!("{}\t{fault}\n", fault.id()));
    *lock(&TEXT) = lines.collect();
}

/// A ball in the light of a scene, the input, row by row. A pixel is p, n, v, the right color, and the color that a
/// mistake gives, by its number in the list; n is 0 beside the ball.
#[unsafe(no_mangle)]
pub extern "C" fn draw(size: usize, mistake: usize) -> *const f64 {
    let fault = Fault::known().nth(mistake);
    let mut numbers = lock(&NUMBERS);
    *numbers = match Scene::from_json(&read()) {
        Ok(scene) => picture::ball(&scene, size, fault),
        Err(_) => vec![0.0; 15 * size * size], // black, as where there is no ball
    };
    numbers.as_ptr()
}

/// Where the page writes so many numbers.
#[unsafe(no_mangle)]
pub extern "C" fn numbers(count: usize) -> *mut f64 {
    let mut numbers = lock(&NUMBERS);
    *numbers = vec![0.0; count];
    numbers.as_mut_ptr()
}

/// The crate's normal of a surface, by its place in the list, from the numbers that were written; 0 if there is none.
#[unsafe(no_mangle)]
pub extern "C" fn normal(surface: usize) -> *const f64 {
    let mut numbers = lock(&NUMBERS);
    *numbers = surfaces::normal(surface, &numbers).into();
    numbers.as_ptr()
}
