//! Colours that stay apart for people who see colours differently (Okabe & Ito, "Color Universal
//! Design", 2008).

/// Red, green, blue.
pub(crate) type Colour = [u8; 3];

/// Of what is there for comparison only.
pub(crate) const GREY: Colour = [150, 150, 150];
/// Of what was given: lines, cameras.
pub(crate) const GIVEN: Colour = [213, 94, 0];

/// Of what was found: one colour for each cylinder or series, from the start again when they run
/// out.
pub(crate) fn series(index: usize) -> Colour {
    const SERIES: [Colour; 6] =
        [[0, 114, 178], [0, 158, 115], [204, 121, 167], [230, 159, 0], [86, 180, 233], [110, 70, 30]];
    SERIES[index % SERIES.len()]
}
