//! Colours that stay apart for people who see colours differently (Okabe & Ito, "Color Universal
//! Design", 2008).

/// Red, green, blue.
pub(crate) type Colour = [u8; 3];

/// Colour of what is shown for comparison only.
pub(crate) const GREY: Colour = [150, 150, 150];
/// Colour of the input: lines and cameras.
pub(crate) const GIVEN: Colour = [213, 94, 0];

/// Colours of the results: one for each cylinder or series. They repeat if there are more than six.
pub(crate) fn series(index: usize) -> Colour {
    const SERIES: [Colour; 6] =
        [[0, 114, 178], [0, 158, 115], [204, 121, 167], [230, 159, 0], [86, 180, 233], [110, 70, 30]];
    SERIES[index % SERIES.len()]
}
