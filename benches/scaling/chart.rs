//! Charts with two logarithmic axes.

use std::error::Error;
use std::ops::Range;

use plotters::prelude::*;

pub struct Chart<'a> {
    pub title: &'a str,
    pub x: Range<f64>,
    pub y: Range<f64>,
    /// a place without lines
    pub legend: SeriesLabelPosition,
    pub lines: Vec<(String, Vec<(f64, f64)>)>,
}

impl Chart<'_> {
    pub fn draw(self, file: &str) -> Result<(), Box<dyn Error>> {
        let area = SVGBackend::new(file, (800, 500)).into_drawing_area();
        area.fill(&WHITE)?;
        let mut chart = ChartBuilder::on(&area)
            .caption(self.title, ("sans-serif", 20))
            .margin(25)
            .x_label_area_size(30)
            .y_label_area_size(60)
            .build_cartesian_2d(self.x.log_scale(), self.y.log_scale())?;
        chart
            .configure_mesh()
            .light_line_style(WHITE)
            .x_label_formatter(&|x| format!("{x:.0e}"))
            .y_label_formatter(&|y| format!("{y:.0e}"))
            .draw()?;
        for (i, (name, points)) in self.lines.into_iter().enumerate() {
            println!("{name}: {points:?}");
            let color = Palette99::pick(i);
            let markers = points.clone().into_iter();
            chart.draw_series(markers.map(|point| Circle::new(point, 3, color.filled())))?;
            chart
                .draw_series(LineSeries::new(points, &color))?
                .label(name)
                .legend(move |(x, y)| PathElement::new([(x, y), (x + 20, y)], Palette99::pick(i)));
        }
        chart
            .configure_series_labels()
            .position(self.legend)
            .border_style(BLACK)
            .draw()?;
        area.present()?;
        println!("{file}");
        Ok(())
    }
}
