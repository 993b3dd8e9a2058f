# Recipes for everyday work. `.ci/run` is the whole.

# list the recipes
default:
    @just --list

# format, clippy, formulas: seconds
quick:
    cargo fmt --all
    cargo clippy --all-targets --all-features -- -D warnings
    cargo test --test formulas --test conventions

# every test, with all features
test:
    cargo test --all-features

# the same bits, instructions, flash and stack on emulated chips
chips:
    tests/firmware/run.sh

# the race against handwritten code, and the instructions of every function
bench:
    cargo bench --bench versus
    cargo bench --bench instructions -- --check

# the gallery into target/gallery, and the README's pictures
pictures:
    cargo run --release -p gallery
    cargo run --release -p gallery -- --readme
    cargo run --release -p display -- target/display
    cp target/display/ball.png docs/pictures/ball_on_a_display.png
    tests/firmware/frame.sh

# the documentation, in a browser
doc:
    cargo doc --no-deps --all-features --open

# every f32 of a domain: minutes
exhaustive:
    cargo test --release -- --ignored
