//! Builds the C programs to compare with, if there is a C compiler.

fn main() {
    println!("cargo:rerun-if-changed=c");
    println!("cargo:rustc-check-cfg=cfg(c_peers)");
    match compile("scalar", "2", None)
        .and_then(|()| compile("lanes", "fast", Some("-march=native")))
    {
        Ok(()) => {
            // the power functions, for one number and for many at a time
            println!("cargo:rustc-link-lib=mvec");
            println!("cargo:rustc-link-lib=m");
            println!("cargo:rustc-cfg=c_peers");
        }
        Err(error) => println!("cargo:warning=there are no C programs to compare with: {error}"),
    }
}

fn compile(name: &str, level: &str, flag: Option<&str>) -> Result<(), cc::Error> {
    let mut build = cc::Build::new();
    build
        .file(format!("c/{name}.c"))
        .opt_level_str(level)
        .debug(false);
    build.flags(flag).try_compile(&format!("peer_{name}"))
}
