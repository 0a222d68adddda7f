/// The equilibrium of a mixture of propane and air that burns, in element variables: 16
/// solutions.
///
/// Meintjes and Morgan, "Chemical equilibrium systems as numerical test problems", ACM Transactions
/// on Mathematical Software 1990, equations of section 3: five unknowns, Bézout's number 108.
///
/// `ratio` is that of air and fuel, `rate` the constants R, R5 to R10 of the reactions.
fn combustion(ratio: f64, rate: [f64; 7]) -> (y: [f64; 5]) {
    let [r, r5, r6, r7, r8, r9, r10] = rate;
    let [a, b, c, d, e] = y;
    a * b + a - 3 * e == 0;
    2 * a * b + a + 2 * r10 * b.pow(2) + b * c.pow(2) + r7 * b * c + r9 * b * d + r8 * b - ratio * e == 0;
    2 * b * c.pow(2) + r7 * b * c + 2 * r5 * c.pow(2) + r6 * c - 8 * e == 0;
    r9 * b * d + 2 * d.pow(2) - 4 * ratio * e == 0;
    a * b + a + r10 * b.pow(2) + b * c.pow(2) + r7 * b * c + r9 * b * d + r8 * b
        + r5 * c.pow(2) + r6 * c + d.pow(2) == r;
}
