/// The mixed Nash equilibria of four players with two strategies each: 9 solutions.
///
/// McKelvey and McLennan, "The maximal number of regular totally mixed Nash equilibria", Journal of
/// Economic Theory 1997: n players have as many as there are derangements of n things.
///
/// Of each player `gain` holds the coefficients of 1, the probabilities of the three other players,
/// their products of two, and that of three.
fn game_4_players(gain: [[f64; 8]; 4]) -> (p: [f64; 4]) {
    for [i, j, k, l] in [[0, 1, 2, 3], [1, 0, 2, 3], [2, 0, 1, 3], [3, 0, 1, 2]] {
        let [a, b, c] = [p[j], p[k], p[l]];
        dot(gain[i], [1, a, b, c, a * b, a * c, b * c, a * b * c]) == 0;
    }
}
