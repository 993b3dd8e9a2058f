//! Prints the names of the functions whose flash is measured, one a line.

macro_rules! names {
    (
        ARITHMETIC: Number $arithmetic:tt SWEEPS: Number $sweeps:tt SERIES: Float $series:tt
        $($section:ident: $bound:ident {
            $($row:ident $name:literal |$given:ident| $call:expr => $promise:ident;)*
        })*
    ) => {
        [$($($name),*),*]
    };
}

fn main() {
    for name in functions::for_each_function!(names) {
        println!("{name}");
    }
    println!("fixed: shade::blinn_phong, integer m");
}
