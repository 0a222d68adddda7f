//! Quantiles of samples.

/// A sample in ascending order. NaN comes last, as if infinite.
pub(super) struct Sorted(Vec<f64>);

impl Sorted {
    pub(super) fn new(values: impl IntoIterator<Item = f64>) -> Self {
        let number = |value: f64| if value.is_nan() { f64::INFINITY } else { value };
        let mut values: Vec<_> = values.into_iter().map(number).collect();
        values.sort_by(f64::total_cmp);
        Self(values)
    }

    /// The value below which this part of the sample lies; NaN for an empty sample.
    pub(super) fn quantile(&self, part: f64) -> f64 {
        let place = self.0.len().saturating_sub(1) as f64 * part;
        self.0.get(place.round() as usize).copied().unwrap_or(f64::NAN)
    }

    pub(super) fn median(&self) -> f64 {
        self.quantile(0.5)
    }

    /// Mean of the sample; infinite if a value is.
    pub(super) fn mean(&self) -> f64 {
        self.0.iter().sum::<f64>() / self.0.len() as f64
    }

    /// Number of values that are larger than a limit.
    pub(super) fn count_above(&self, limit: f64) -> usize {
        self.0.len() - self.0.partition_point(|&value| value <= limit)
    }
}
