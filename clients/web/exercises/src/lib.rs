//! A page of exercises: the laws try a function that a student writes in JavaScript, and `shading` draws the right
//! picture.
//!
//! The page writes numbers where [`numbers`] points to and calls a function, which answers with numbers, or
//! with text where [`text`] points to. Nothing here reads JSON, for which the page would be a tenth larger.

mod picture;

use std::sync::{Mutex, MutexGuard, PoisonError};

use shading_laws::{Fault, Kind, Laws, Model, Profile, Progress, Renderer, Scene};

#[link(wasm_import_module = "page")]
unsafe extern "C" {
    /// Shades scenes, JSON values between commas, and writes three numbers for each. Nonzero ends the run.
    fn shade_all(scenes: *const u8, length: usize, colors: *mut f64) -> u32;
    /// Hears how many scenes were asked for, and how many laws are broken.
    fn goes_on(asked: usize, of: usize, broken: usize);
}

static TEXT: Mutex<String> = Mutex::new(String::new());
static NUMBERS: Mutex<Vec<f64>> = Mutex::new(Vec::new());

fn lock<T>(of: &'static Mutex<T>) -> MutexGuard<'static, T> {
    of.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Those whose bits are set; all, if none is.
fn chosen<T: Copy>(all: &[T], bits: u32) -> Vec<T> {
    let is_chosen = |i: &usize| bits == 0 || bits >> i & 1 == 1;
    (0..all.len()).filter(is_chosen).map(|i| all[i]).collect()
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

/// Tries the student's function by the laws, with so many random scenes. The bits choose models and kinds
/// of light, and whether there may be a highlight behind the surface. The text is the report; a cause is in
/// it if the page has no words of its own.
#[unsafe(no_mangle)]
pub extern "C" fn check(
    models: u32,
    lights: u32,
    is_ungated: bool,
    explains: bool,
    cases: usize,
    seed: u32,
) {
    let departs = if is_ungated {
        vec!["HighlightNotGated".into()]
    } else {
        Vec::new()
    };
    let profile = Profile {
        models: chosen(&Model::ALL, models),
        lights: chosen(&Kind::ALL, lights),
        departs,
        ..Profile::default()
    };
    let laws = Laws {
        cases,
        explains,
        seed: seed.into(),
        ..Laws::default()
    };
    let report = laws.run(&mut Student(profile));
    *lock(&TEXT) = report.map_or_else(|why| why, |report| report.to_json());
}

/// Lists the known mistakes as text: the name and the words of each, in lines that a tab divides.
#[unsafe(no_mangle)]
pub extern "C" fn mistakes() {
    let lines = Fault::known().map(|fault| format!("{}\t{fault}\n", fault.id()));
    *lock(&TEXT) = lines.collect();
}

/// A ball in the light of a scene, whose numbers were written, row by row. A pixel is p, n, v, the right
/// color, and the color that a mistake gives, by its number in the list; n is 0 beside the ball.
#[unsafe(no_mangle)]
pub extern "C" fn draw(size: usize, mistake: usize) -> *const f64 {
    let fault = Fault::known().nth(mistake);
    let mut numbers = lock(&NUMBERS);
    *numbers = match picture::scene(&numbers) {
        Some(scene) => picture::ball(&scene, size, fault),
        None => vec![0.0; 15 * size * size], // black, as where there is no ball
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
