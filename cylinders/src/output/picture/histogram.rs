//! Histograms of several samples over one axis, drawn as outlines with dashes, so that no histogram
//! hides another.

use plotters::element::Polygon;
use plotters::prelude::DrawingBackend;
use plotters::style::Color;

use super::axes::{Axis, Entry, Mark, frame, legend, legend_width};
use super::style::draw_path;
use super::{Area, Drawn, Picture, rgb, units};
use crate::output::palette;

/// A histogram of one or several samples: the part of each sample in each bin. Values that are not
/// finite are in no bin; the legend gives their number.
#[derive(Clone, Debug)]
pub struct Histogram {
    /// Title.
    pub title: String,
    /// The quantity, with its unit.
    pub label: String,
    /// Name and values of each sample.
    pub samples: Vec<(String, Vec<f64>)>,
    /// Number of bins, at least one.
    pub bins: usize,
}

impl Picture for Histogram {
    fn size(&self) -> (u32, u32) {
        (640 + legend_width(&self.entries()), 480)
    }

    fn draw<DB: DrawingBackend>(&self, area: &Area<DB>) -> Drawn<DB> {
        let (area, beside) = area.split_horizontally(units(640.0));
        legend(&beside, &self.entries())?;
        let x = Axis::linear(&self.label).around(self.samples.iter().flat_map(|(_, values)| values).copied());
        let [low, high] = x.bounds();
        let counts: Vec<_> = self.samples.iter().map(|(_, values)| shares(values, [low, high], self.bins)).collect();
        let highest = counts.iter().flatten().fold(0.0, |highest: f64, &share| highest.max(share));
        let y = Axis::linear("part of the sample").around([0.0, highest].into_iter());
        let chart = frame(&area, &self.title, (&self.label, x), ("part of the sample", y))?;
        for (index, shares) in counts.iter().enumerate() {
            let colour = rgb(palette::series(index));
            let edge = |bin: usize| low + (high - low) * bin as f64 / shares.len() as f64;
            let steps =
                shares.iter().enumerate().flat_map(|(bin, &share)| [(edge(bin), share), (edge(bin + 1), share)]);
            let outline: Vec<_> = [(low, 0.0)].into_iter().chain(steps).chain([(high, 0.0)]).collect();
            chart.plotting_area().draw(&Polygon::new(outline.clone(), colour.mix(0.15)))?;
            draw_path(chart.plotting_area(), index, &outline)?;
        }
        Ok(())
    }
}

impl Histogram {
    fn entries(&self) -> Vec<Entry> {
        let entry = |(index, (name, values)): (usize, &(String, Vec<f64>))| {
            let left_out = values.iter().filter(|value| !value.is_finite()).count();
            let label = if left_out == 0 { name.clone() } else { format!("{name} ({left_out} not finite)") };
            Entry { mark: Mark::Series(index), colour: palette::series(index), label }
        };
        self.samples.iter().enumerate().map(entry).collect()
    }
}

/// The part of all values in each of the bins between two bounds.
fn shares(values: &[f64], [low, high]: [f64; 2], bins: usize) -> Vec<f64> {
    let mut shares = vec![0.0; bins.max(1)];
    let last = shares.len() - 1;
    for value in values.iter().filter(|value| value.is_finite()) {
        let bin = ((value - low) / (high - low) * shares.len() as f64) as usize;
        shares[bin.min(last)] += 1.0 / values.len() as f64;
    }
    shares
}
