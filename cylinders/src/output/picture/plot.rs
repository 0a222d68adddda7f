//! Plots: series of points with lines and bands over linear and logarithmic axes.

use plotters::element::Polygon;
use plotters::prelude::DrawingBackend;
use plotters::style::Color;

use super::axes::{Axis, Entry, Mark, frame, legend, legend_width};
use super::style::{draw_marker, draw_path};
use super::{Area, Drawn, Picture, rgb, units};
use crate::output::palette;

/// A plot of several series, each in its own colour, with its own dashes and markers. Points that
/// are not finite, or not positive on a logarithmic axis, are left out.
#[derive(Clone, Debug)]
pub struct Plot {
    /// Title.
    pub title: String,
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// The series.
    pub series: Vec<Series>,
}

/// A series of a plot.
#[derive(Clone, Debug)]
pub struct Series {
    /// Name, for the legend.
    pub label: String,
    /// Points `(x, y)`, joined in their order.
    pub points: Vec<[f64; 2]>,
    /// A band around the points, such as quantiles.
    pub band: Option<Band>,
}

/// A band between two curves.
#[derive(Clone, Debug)]
pub struct Band {
    /// Name, for the legend.
    pub label: String,
    /// `(x, low, high)`.
    pub limits: Vec<[f64; 3]>,
}

impl Picture for Plot {
    fn size(&self) -> (u32, u32) {
        (640 + legend_width(&self.entries()), 480)
    }

    fn draw<DB: DrawingBackend>(&self, area: &Area<DB>) -> Drawn<DB> {
        let (area, beside) = area.split_horizontally(units(640.0));
        legend(&beside, &self.entries())?;
        let points = || self.series.iter().flat_map(|series| &series.points);
        let limits = || self.series.iter().filter_map(|series| series.band.as_ref()).flat_map(|band| &band.limits);
        let x = self.x.around(points().map(|point| point[0]).chain(limits().map(|limit| limit[0])));
        let y = self.y.around(points().map(|point| point[1]).chain(limits().flat_map(|limit| [limit[1], limit[2]])));
        let chart = frame(&area, &self.title, (&self.x.label, x), (&self.y.label, y))?;
        let area = chart.plotting_area();
        for (index, series) in self.series.iter().enumerate() {
            let colour = rgb(palette::series(index));
            if let Some(band) = &series.band {
                let shown = |limit: &&[f64; 3]| self.x.shows(limit[0]) && limit[1..].iter().all(|&y| self.y.shows(y));
                let limits: Vec<_> = band.limits.iter().filter(shown).collect();
                let lower = limits.iter().map(|limit| (limit[0], limit[1]));
                let upper = limits.iter().rev().map(|limit| (limit[0], limit[2]));
                area.draw(&Polygon::new(lower.chain(upper).collect::<Vec<_>>(), colour.mix(0.2)))?;
            }
        }
        // Lines are drawn above all bands.
        for (index, series) in self.series.iter().enumerate() {
            let shown = |&&[x, y]: &&[f64; 2]| self.x.shows(x) && self.y.shows(y);
            let points: Vec<_> = series.points.iter().filter(shown).map(|&[x, y]| (x, y)).collect();
            draw_path(area, index, &points)?;
            points.iter().try_for_each(|&point| draw_marker(area, index, point))?;
        }
        Ok(())
    }
}

impl Plot {
    fn entries(&self) -> Vec<Entry> {
        let entries = |(index, series): (usize, &Series)| {
            let colour = palette::series(index);
            let band = series.band.as_ref().map(|band| Entry { mark: Mark::Band, colour, label: band.label.clone() });
            [Entry { mark: Mark::Marked(index), colour, label: series.label.clone() }].into_iter().chain(band)
        };
        self.series.iter().enumerate().flat_map(entries).collect()
    }
}
