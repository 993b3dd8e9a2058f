//! Many points on all processors. WebAssembly has no threads here.

#[cfg(not(target_family = "wasm"))]
use rayon::prelude::*;

/// So many points are one task.
pub const SPAN: usize = 2048;

/// From so many points on, waking the threads costs less than they save.
#[cfg(not(target_family = "wasm"))]
const WORTH_IT: usize = 4 * SPAN;

/// Whether so many points are worth the threads, and the threads exist. A process that was forked
/// off has none of its parent's threads, and would wait for them forever.
#[cfg(not(target_family = "wasm"))]
fn are_worth_it(count: usize) -> bool {
    static PROCESS: std::sync::OnceLock<u32> = std::sync::OnceLock::new();
    let process = std::process::id();
    count >= WORTH_IT && *PROCESS.get_or_init(|| process) == process
}

/// Does all the tasks, which have so many points together.
pub fn each<Task: Send>(tasks: Vec<Task>, count: usize, work: impl Fn(Task) + Send + Sync) {
    #[cfg(not(target_family = "wasm"))]
    if are_worth_it(count) {
        return tasks.into_par_iter().for_each(work);
    }
    let _ = count;
    tasks.into_iter().for_each(work);
}

/// Whether something holds of every span of the rows.
pub fn all<R: Sync>(rows: &[R], holds: impl Fn(&[R]) -> bool + Send + Sync) -> bool {
    #[cfg(not(target_family = "wasm"))]
    if are_worth_it(rows.len()) {
        return rows.par_chunks(SPAN).all(holds);
    }
    rows.chunks(SPAN).all(holds)
}

/// Makes each row of the output from the row of the input.
pub fn map<A: Copy + Sync, B: Send>(input: &[A], out: &mut [B], f: impl Fn(A) -> B + Send + Sync) {
    let count = input.len();
    let spans = input.chunks(SPAN).zip(out.chunks_mut(SPAN)).collect();
    each(spans, count, |(input, out): (&[A], &mut [B])| {
        for (&input, out) in input.iter().zip(out) {
            *out = f(input);
        }
    });
}
