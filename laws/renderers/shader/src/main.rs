//! The shader behind pipes, in the format of `shading-laws`.

use std::error::Error;
use std::io::{BufRead, Write, stdin, stdout};

use shader::{PHONG, Shader};
use shading_laws::{Renderer, Scene};

fn main() -> Result<(), Box<dyn Error>> {
    let mut shader = Shader::new(PHONG)?;
    let (mut out, mut lines) = (stdout().lock(), stdin().lock().lines());
    lines.next().ok_or("no version")??;
    writeln!(out, r#"{{"name":"a WGSL shader"}}"#)?;
    let mut batch = Vec::new();
    for line in lines {
        let line = line?;
        if !line.is_empty() {
            batch.push(Scene::from_json(&line)?);
            continue;
        }
        for [r, g, b] in shader.shade(&batch)? {
            writeln!(
                out,
                "{}",
                format!("[{r},{g},{b}]").replace("inf", "Infinity")
            )?;
        }
        out.flush()?;
        batch.clear();
    }
    Ok(())
}
