/// The mixed Nash equilibria of three players with two strategies each: 2 solutions.
///
/// McKelvey and McLennan, "The maximal number of regular totally mixed Nash equilibria", Journal of
/// Economic Theory 1997. Each player is indifferent between both strategies, given the
/// probabilities p, q and r of the first strategies of the others.
///
/// Of each player `gain` holds the coefficients of 1, the probability of the next player, that of
/// the one after, and their product in what the first strategy gains over the second.
fn game_3_players(gain: [[f64; 4]; 3]) -> (p, q, r) {
    dot(gain[0], [1, q, r, q * r]) == 0;
    dot(gain[1], [1, r, p, r * p]) == 0;
    dot(gain[2], [1, p, q, p * q]) == 0;
}
