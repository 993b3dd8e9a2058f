# Recipes for everyday work. `.ci/run` runs every check.

# list the recipes
default:
    @just --list

# check the format, run clippy, test the formulas: takes seconds
quick:
    cargo fmt --all
    cargo clippy --all-targets --all-features -- -D warnings
    cargo test --test formulas --test totality

# run every test, with all features
test:
    cargo test --all-features

# compare bits and measure instructions, flash and stack on emulated chips
chips:
    tests/firmware/run.sh

# measure the time beside the same by hand (`just bench quick forms` for some), and fail above a limit
bench *what:
    cargo bench -p shading-benches --features peers --bench time -- judge {{what}}

# measure the loops of the working tree against those of a commit
slower commit:
    benches/slower.sh {{commit}}

# renew what is generated: the pinned bits, the counts, the table of flash, the public interface
renew *what:
    .ci/renew {{what}}

# redraw the gallery's pictures that the pages show
pictures:
    cargo run --release -p gallery
    .ci/gallery --renew

# climb for an hour to where light in fixed point might rise with distance
climb:
    cargo test --release --features fixed --test fixed -- --ignored --nocapture rises

# open the documentation in a browser
doc:
    cargo doc --no-deps --all-features --open

# build the pages for demos and exercises, and serve them
page:
    clients/web/build.sh --serve

# test every f32 of a domain, and each mistake that the laws must find: takes minutes
exhaustive:
    cargo test --release -p kit --test exhaustive -- --ignored
    cargo test -p shading-laws -- --ignored
