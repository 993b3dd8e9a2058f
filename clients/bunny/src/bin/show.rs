//! `show FRAME.txt PICTURE.png`: a frame that `board` has printed, as a picture.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(not(target_os = "none"))]
mod show {
    use std::fs::{self, File};

    use bunny::{HEIGHT, WIDTH};

    pub fn write(frame: &str, picture: &str) -> Result<(), String> {
        let text = fs::read_to_string(frame).map_err(|error| format!("{frame}: {error}"))?;
        let pixels = pixels(&text).ok_or_else(|| format!("{frame}: not a frame"))?;
        let write = || {
            let mut encoder = png::Encoder::new(File::create(picture)?, 2 * WIDTH, 2 * HEIGHT);
            encoder.set_color(png::ColorType::Rgb);
            encoder.write_header()?.write_image_data(&enlarged(&pixels))
        };
        write().map_err(|error: png::EncodingError| format!("{picture}: {error}"))
    }

    fn pixels(text: &str) -> Option<Vec<u16>> {
        let mut pixels = vec![0; (WIDTH * HEIGHT) as usize];
        for line in text.lines().skip(1).filter(|line| !line.is_empty()) {
            let words: Vec<&str> = line.split(' ').collect();
            let [x, y, width, height, color] = words[..] else {
                return None;
            };
            let [x, y, width, height] =
                [x, y, width, height].map(|word| word.parse::<usize>().ok());
            let (x, y, width, height) = (x?, y?, width?, height?);
            let color = u16::from_str_radix(color, 16).ok()?;
            for row in pixels.chunks_mut(WIDTH as usize).skip(y).take(height) {
                row.get_mut(x..x + width)?.fill(color);
            }
        }
        Some(pixels)
    }

    /// Each pixel as two by two, in eight bits per channel.
    fn enlarged(pixels: &[u16]) -> Vec<u8> {
        let (width, height) = (WIDTH as usize, HEIGHT as usize);
        let all = (0..2 * height)
            .flat_map(|y| (0..2 * width).map(move |x| pixels[y / 2 * width + x / 2]));
        let eight = |bits: u16, most: u16| (bits * 255 / most) as u8;
        let bytes = |color: u16| {
            [
                eight(color >> 11, 31),
                eight(color >> 5 & 63, 63),
                eight(color & 31, 31),
            ]
        };
        all.flat_map(bytes).collect()
    }
}

#[cfg(not(target_os = "none"))]
fn main() -> std::process::ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let result = match &arguments[..] {
        [frame, picture] => show::write(frame, picture).map(|()| println!("wrote {picture}")),
        _ => Err("usage: show FRAME.txt PICTURE.png".into()),
    };
    if let Err(message) = &result {
        eprintln!("show: {message}");
    }
    std::process::ExitCode::from(u8::from(result.is_err()))
}
