//! Numbers in columns of a text.

/// Numbers from this size on, or below its inverse, are written with an exponent.
const LARGE: f64 = 1e9;
const SMALL: f64 = 1e-3;

/// A number in a column of at least 14 characters, with a space before it: seven decimals, or seven
/// significant digits and an exponent if it is very large or small.
pub(crate) fn number(value: f64) -> String {
    column(value, value.abs())
}

/// The coordinates of a point or vector, all in the same form.
pub(crate) fn triple(values: [f64; 3]) -> String {
    let size = values.iter().fold(0.0_f64, |size, value| size.max(value.abs()));
    values.map(|value| column(value, size)).concat()
}

fn column(value: f64, size: f64) -> String {
    let text = match size == 0.0 || (SMALL..LARGE).contains(&size) {
        true => format!("{value:.7}"),
        false => format!("{value:.6e}"),
    };
    format!(" {text:>13}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_stay_apart_and_small_numbers_show_their_digits() {
        assert_eq!(number(33.25), "    33.2500000");
        assert_eq!(number(1.234_567_8e-6), "   1.234568e-6");
        assert_eq!(number(0.0), "     0.0000000");
        let utm = triple([691_607.123_456_7, 5_334_760.5, -12.0]);
        assert_eq!(utm.split_whitespace().count(), 3, "{utm}");
        assert_eq!(triple([1e-5, 1.0, -1.0]), "     0.0000100     1.0000000    -1.0000000");
        assert_eq!(triple([1e12, 1.0, 2.0]).split_whitespace().count(), 3);
    }
}
