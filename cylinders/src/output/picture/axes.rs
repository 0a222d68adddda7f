//! Axes: ranges with their ticks, the frame with grid and labels, and a legend beside it.

use std::ops::Range;

use plotters::chart::{ChartBuilder, ChartContext};
use plotters::coord::cartesian::Cartesian2d;
use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};
use plotters::drawing::DrawingAreaErrorKind;
use plotters::element::{Circle, PathElement, Rectangle};
use plotters::prelude::{DrawingBackend, IntoFont};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{BLACK, Color, RGBColor, TRANSPARENT, TextStyle};

pub(super) use super::style::stroke;
use super::style::{draw_marker, draw_path};
use super::{Area, Drawn, rgb, units};
use crate::output::palette::Colour;

/// Heights of text, units.
const TITLE: f64 = 18.0;
const LABEL: f64 = 15.0;

/// Around the frame, units: title above; ticks and label below and to the left, there with a
/// margin.
const ABOVE: f64 = 34.0;
const BELOW: f64 = 52.0;
const LEFT: f64 = 80.0;
const MARGIN: f64 = 8.0;
const RIGHT: f64 = 18.0;

/// Approximate number of ticks of an axis.
const TICKS: f64 = 9.0;

/// First digits of the ticks of a short logarithmic axis.
const ROUND: [f64; 3] = [1.0, 2.0, 5.0];

/// How values are spread along an axis.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Scale {
    /// Evenly.
    Linear,
    /// By their decimal logarithm. Values that are not positive cannot be shown.
    Logarithmic,
}

/// An axis of a plot.
#[derive(Clone, Debug, Eq, PartialEq)]
pub struct Axis {
    /// The quantity that it shows, with its unit.
    pub label: String,
    /// Linear or logarithmic.
    pub scale: Scale,
}

/// An axis with its range.
#[derive(Clone, Debug)]
pub(super) struct Extent {
    scale: Scale,
    low: f64,
    high: f64,
    /// Whether ticks show the negative value, for axes that point down.
    downward: bool,
}

impl Axis {
    /// A linear axis.
    pub fn linear(label: &str) -> Self {
        Self { label: label.to_owned(), scale: Scale::Linear }
    }

    /// A logarithmic axis.
    pub fn logarithmic(label: &str) -> Self {
        Self { label: label.to_owned(), scale: Scale::Logarithmic }
    }

    /// Whether the axis can show a value.
    pub(super) fn shows(&self, value: f64) -> bool {
        value.is_finite() && (self.scale == Scale::Linear || value > 0.0)
    }

    /// The range of these values, widened to ticks. Values that the axis cannot show are ignored.
    pub(super) fn around(&self, values: impl Iterator<Item = f64>) -> Extent {
        let values = values.filter(|&value| self.shows(value));
        let (low, high) =
            values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
        let scale = self.scale;
        let (low, high) = match scale {
            _ if low > high => (1.0, 10.0),
            Scale::Logarithmic => {
                let (below, above) = (round_down(low), round_up(high));
                let decades = (above / below).log10();
                if is_short(below, above) && below < above || decades > 2.0 {
                    (below, above)
                } else {
                    let (low, high) = (low.log10().floor(), high.log10().ceil());
                    (10f64.powf(low), 10f64.powf(high.max(low + 1.0)))
                }
            }
            Scale::Linear => {
                // A single value gets a range around it; otherwise the step would be zero.
                let room = if high > low { 0.0 } else { high.abs().max(1.0) / 2.0 };
                let step = step(high - low + 2.0 * room);
                (((low - room) / step).floor() * step, ((high + room) / step).ceil() * step)
            }
        };
        Extent { scale, low, high, downward: false }
    }
}

impl Extent {
    /// The range from `low` to `high`, not widened.
    pub(super) fn exactly([low, high]: [f64; 2]) -> Self {
        Self { scale: Scale::Linear, low, high, downward: false }
    }

    /// The same extent, with ticks that show the negative value.
    pub(super) fn downward(self) -> Self {
        Self { downward: true, ..self }
    }

    pub(super) fn bounds(&self) -> [f64; 2] {
        [self.low, self.high]
    }

    fn position(&self, value: f64) -> f64 {
        match self.scale {
            Scale::Linear => (value - self.low) / (self.high - self.low),
            Scale::Logarithmic => (value / self.low).log10() / (self.high / self.low).log10(),
        }
    }

    fn ticks(&self) -> Vec<f64> {
        match self.scale {
            Scale::Linear => {
                let step = step(self.high - self.low);
                // Ends that are ticks up to rounding count as ticks.
                let (first, last) = ((self.low / step - 1e-9).ceil() as i64, (self.high / step + 1e-9).floor() as i64);
                (first..=last).map(|index| index as f64 * step).collect()
            }
            Scale::Logarithmic if is_short(self.low, self.high) => {
                let (first, last) = (self.low.log10().floor() as i32, self.high.log10().ceil() as i32);
                let decades = (first..=last).map(|exponent| 10f64.powi(exponent));
                let ticks = decades.flat_map(|decade| ROUND.map(|factor| factor * decade));
                let inside = |tick: &f64| (self.low * (1.0 - 1e-9)..=self.high * (1.0 + 1e-9)).contains(tick);
                ticks.filter(inside).collect()
            }
            Scale::Logarithmic => {
                // Ends that are whole decades up to rounding count as ticks.
                let (first, last) =
                    ((self.low.log10() - 1e-9).ceil() as i32, (self.high.log10() + 1e-9).floor() as i32);
                let step = ((f64::from(last - first) / TICKS).ceil() as usize).max(1);
                (first..=last).step_by(step).map(|exponent| 10f64.powi(exponent)).collect()
            }
        }
    }
}

/// Whether a logarithmic axis is so short that its ticks are the numbers of [`ROUND`] times a power
/// of ten, not whole decades.
fn is_short(low: f64, high: f64) -> bool {
    high / low < 1001.0 && low >= 1e-4 && high <= 1e6
}

/// The largest number of [`ROUND`] times a power of ten that is at most this.
fn round_down(value: f64) -> f64 {
    let decade = 10f64.powf(value.log10().floor());
    let factors = ROUND.into_iter().rev().map(|factor| factor * decade);
    factors.into_iter().find(|&round| round <= value * (1.0 + 1e-9)).unwrap_or(decade)
}

/// The smallest number of [`ROUND`] times a power of ten that is at least this.
fn round_up(value: f64) -> f64 {
    let decade = 10f64.powf(value.log10().floor());
    let factors = ROUND.map(|factor| factor * decade);
    factors.into_iter().find(|&round| round >= value * (1.0 - 1e-9)).unwrap_or(10.0 * decade)
}

/// The step of about [`TICKS`] ticks: 1, 2 or 5 times a power of ten.
fn step(range: f64) -> f64 {
    let least = range / TICKS;
    let decade = 10f64.powf(least.log10().floor());
    [1.0, 2.0, 5.0].map(|factor| factor * decade).into_iter().find(|&step| step >= least).unwrap_or(10.0 * decade)
}

impl Ranged for Extent {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, (start, end): (i32, i32)) -> i32 {
        // The clamp keeps values far outside from overflowing.
        let position = self.position(*value).clamp(-10.0, 10.0);
        start + (position * f64::from(end - start)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, _: Hint) -> Vec<f64> {
        self.ticks()
    }

    fn range(&self) -> Range<f64> {
        self.low..self.high
    }
}

impl ValueFormatter<f64> for Extent {
    fn format_ext(&self, value: &f64) -> String {
        if self.scale == Scale::Logarithmic {
            if is_short(self.low, self.high) {
                // One digit and its zeros.
                let decimals = (-(value * 1.000_001).log10().floor()).max(0.0) as usize;
                return format!("{value:.decimals$}");
            }
            return format!("1e{}", value.log10().round());
        }
        let (step, value) = (step(self.high - self.low), if self.downward { -value } else { *value });
        if self.low.abs().max(self.high.abs()) >= 1e6 || step < 1e-4 {
            return format!("{value:.1e}");
        }
        let decimals = (-(step * 1.000_001).log10().floor()).max(0.0) as usize;
        // Minus zero becomes zero.
        format!("{:.decimals$}", value + 0.0)
    }
}

/// Width and height of the frame in an area of a picture, pixels of the fine grid.
pub(super) fn frame_size<DB: DrawingBackend>(area: &Area<DB>) -> [f64; 2] {
    let (width, height) = area.dim_in_pixel();
    [f64::from(width) - f64::from(units(LEFT + RIGHT)), f64::from(height) - f64::from(units(ABOVE + BELOW))]
}

/// The height of an area whose frame has this ratio of height to width, units.
pub(super) fn height_for(width: f64, ratio: f64) -> f64 {
    (width - LEFT - RIGHT) * ratio + ABOVE + BELOW
}

/// A frame with its coordinates.
pub(super) type Frame<'a, DB> = ChartContext<'a, DB, Cartesian2d<Extent, Extent>>;

/// Draws title, frame, grid, ticks and labels.
pub(super) fn frame<'a, DB: DrawingBackend>(
    area: &'a Area<DB>,
    title: &str,
    (x_label, x): (&str, Extent),
    (y_label, y): (&str, Extent),
) -> Result<Frame<'a, DB>, DrawingAreaErrorKind<DB::ErrorType>> {
    let (width, _) = area.dim_in_pixel();
    let middle = (units(LEFT) + width as i32 - units(RIGHT)) / 2;
    let centred = text(TITLE).pos(Pos::new(HPos::Center, VPos::Center));
    area.draw_text(title, &centred, (middle, units(ABOVE / 2.0)))?;
    let mut chart = ChartBuilder::on(area)
        .margin_top(units(ABOVE))
        .margin_right(units(RIGHT))
        .margin_left(units(MARGIN))
        .margin_bottom(units(MARGIN))
        .x_label_area_size(units(BELOW - MARGIN))
        .y_label_area_size(units(LEFT - MARGIN))
        .build_cartesian_2d(x, y)?;
    chart
        .configure_mesh()
        .x_desc(x_label)
        .y_desc(y_label)
        .label_style(text(LABEL))
        .axis_desc_style(text(LABEL))
        .set_all_tick_mark_size(units(5.0))
        .light_line_style(TRANSPARENT)
        .bold_line_style(stroke(RGBColor(225, 225, 225), 1.0))
        .axis_style(stroke(RGBColor(60, 60, 60), 1.0))
        .draw()?;
    Ok(chart)
}

/// Black text of this height, units.
pub(super) fn text(height: f64) -> TextStyle<'static> {
    ("sans-serif", f64::from(units(height))).into_font().color(&BLACK)
}

/// What a legend shows beside a label.
#[derive(Clone, Copy, Debug)]
pub(super) enum Mark {
    Line,
    /// The line of a series, by its index.
    Series(usize),
    /// The same with its marker.
    Marked(usize),
    Band,
    Dot,
}

/// A line of a legend.
pub(super) struct Entry {
    pub(super) mark: Mark,
    pub(super) colour: Colour,
    pub(super) label: String,
}

/// The width that a legend takes, units.
pub(super) fn legend_width(entries: &[Entry]) -> u32 {
    let longest = entries.iter().map(|entry| entry.label.chars().count()).max();
    longest.map_or(0, |longest| 62 + (longest as f64 * 0.52 * LABEL) as u32)
}

/// Draws a legend at the upper left of an area, below the height of the title.
pub(super) fn legend<DB: DrawingBackend>(area: &Area<DB>, entries: &[Entry]) -> Drawn<DB> {
    for (row, entry) in entries.iter().enumerate() {
        let y = units(ABOVE + 12.0 + 22.0 * row as f64);
        let (left, right) = (units(2.0), units(42.0));
        let colour = rgb(entry.colour);
        match entry.mark {
            Mark::Line => area.draw(&PathElement::new([(left, y), (right, y)], stroke(colour, 2.0)))?,
            Mark::Series(index) => draw_path(area, index, &[(left, y), (right, y)])?,
            Mark::Marked(index) => {
                draw_path(area, index, &[(left, y), (right, y)])?;
                draw_marker(area, index, ((left + right) / 2, y))?;
            }
            Mark::Band => {
                let corners = [(left, y - units(6.0)), (right, y + units(6.0))];
                area.draw(&Rectangle::new(corners, colour.mix(0.3).filled()))?;
            }
            Mark::Dot => area.draw(&Circle::new(((left + right) / 2, y), units(3.5), colour.filled()))?,
        }
        let beside = text(LABEL).pos(Pos::new(HPos::Left, VPos::Center));
        area.draw_text(&entry.label, &beside, (units(50.0), y))?;
    }
    Ok(())
}
