//! Each function of `shading_fixed.h` has the bits of the crate, for any bits of its arguments, whichever
//! products the processor has; and no operation of it is undefined in C.

use fixed_point::{
    LEVELS, PROGRAM, RESULTS, Scene, by_the_crate, levels_by_the_crate, scenes, words,
};
use host::{answer, compiled};

mod fixed_point;
mod host;

#[test]
fn each_function_has_the_bits_of_the_crate() {
    let scenes: Vec<Scene> = scenes().take(14_000).collect();
    let sent = words(scenes.iter().flatten());
    let expected: Vec<_> = scenes.iter().map(by_the_crate).collect();
    let levels = levels_by_the_crate();
    // only GCC's check of undefined behavior comes with the compiler
    let checked = ["-fsanitize=undefined", "-fno-sanitize-recover=undefined"];
    for is_narrow in [0, 1] {
        for (compiler, flags) in [("gcc", &checked[..]), ("clang", &[])] {
            let name = format!("{compiler}, narrow {is_narrow}");
            let narrow = format!("-DSHADING_FIXED_NARROW_PRODUCT={is_narrow}");
            let command = [&[compiler, "-std=c99", "-O2", &narrow], flags].concat();
            let file = format!("fixed_by_{compiler}_{is_narrow}");
            let program = compiled(&command, PROGRAM, &file).unwrap();
            let given = answer(&program, "", &sent).expect("the program answers");
            assert_eq!(given.len(), 4 * RESULTS * scenes.len());
            let answers = given.chunks_exact(4 * RESULTS);
            for ((scene, expected), given) in scenes.iter().zip(&expected).zip(answers) {
                let right = words(expected);
                let first = (0..RESULTS).find(|i| right[4 * i..][..4] != given[4 * i..][..4]);
                assert!(
                    first.is_none(),
                    "{name}: result {first:?} of {scene:?}, in bytes {given:?} for {expected:?}"
                );
            }
            let given = answer(&program, LEVELS, &[]).expect("the program answers");
            assert!(given == levels, "{name}: a level differs");
        }
    }
}
