/// Positions of six receivers and four senders from all ranges between them: 38 solutions, of which
/// those that can be placed in space are returned.
///
/// Kuang, Burgess, Torstensson, Åström, "A complete characterization and solution to the microphone
/// position self-calibration problem", ICASSP 2013. Published as `toa_46`.
///
/// `ranges[i][j]` is the distance between receiver i and sender j. Relative to one of the senders,
/// which is called the first, let G be the Gram matrix of the other three and K its inverse, [k11 v
/// w; v k22 x; w x y]. A receiver with the squares r of its range to the first sender and s of
/// those to the others satisfies 4 r = c K c + 2 c g + a with c_j = r - s_j, g = K n, a = n K n and
/// n = diag(G). Six receivers give k11, k22, g and a as combinations of v, w, x, y and 1. How well
/// depends on which sender is the first and which the last: the best of 12 choices is taken. With C
/// = adj(K) and z = det(K), n is diag(C) / z. M = [K g; g a] is K times [1 n] from both sides: its
/// adjugate is z times the square of (n, -1).
///
/// Positions are known up to a motion and a mirror: the first of the senders is returned as the
/// origin, another one on the x axis, and the third in the plane of x and y.
fn calibration_6_receivers_4_senders(ranges: [[f64; 4]; 6]) -> (v, w, x, y, z) {
    let mut squares = ranges;
    for i in 0..6 {
        for j in 0..4 {
            squares[i][j] = ranges[i][j].pow(2);
        }
    }
    let mut sizes = [0; 12];
    let mut choices = [[[0; 4]; 10]; 12];
    for first in 0..4 {
        for last in 1..4 {
            let order = exchange(3, last) * exchange(0, first);
            let ordered = squares * order.t();
            let all = reshape(combinations(ordered), [30]);
            sizes[3 * first + last - 1] = 1;
            for entry in all {
                sizes[3 * first + last - 1] *= 1 + entry * entry;
            }
            choices[3 * first + last - 1] = concat(ordered, order);
        }
    }
    let chosen = least(sizes, choices);
    let ordered = chosen[0..6];
    let order = chosen[6..10];
    let [k11, k22, g1, g2, g3, a] = combinations(ordered) * [v, w, x, y, 1];
    let c11 = k22 * y - x * x;
    let c22 = k11 * y - w * w;
    let c33 = k11 * k22 - v * v;
    let c12 = w * x - v * y;
    let c13 = v * x - w * k22;
    let c23 = v * w - k11 * x;
    let diagonal = [c11, c22, c33];
    let k = [[k11, v, w], [v, k22, x], [w, x, y]];
    let g = [g1, g2, g3];
    let adjoint = [[c11, c12, c13], [c12, c22, c23], [c13, c23, c33]];
    adjoint * g == diagonal;
    z * g == k * diagonal;
    z * a == dot(diagonal, g);
    z == k11 * c11 + v * c12 + w * c13;
    z != 0;
    let m = [[k11, v, w, g1], [v, k22, x, g2], [w, x, y, g3], [g1, g2, g3, a]];
    det(m) == 0;
    for i in 0..3 {
        for j in i..3 {
            let [p, q, r] = [m[(i + 1) % 3], m[(i + 2) % 3], m[3]];
            let [s, t] = [(j + 1) % 3, (j + 2) % 3];
            z * det([[p[s], p[t], p[3]], [q[s], q[t], q[3]], [r[s], r[t], r[3]]]) == diagonal[i] * diagonal[j];
        }
    }
    // K is positive definite.
    z > 0;
    c11 > 0;
    y > 0;

    // With the Gram matrix C / z of the senders, their coordinates are a triangle. Receivers are
    // combinations of them.
    let mut parts = [[0; 3]; 6];
    for i in 0..6 {
        let [r, s1, s2, s3] = ordered[i];
        let p = (g + k * [r - s1, r - s2, r - s3]) / 2;
        parts[i] = [dot([c11, c12, c13], p), y * p[1] - x * p[2], p[2]];
    }
    Positions {
        senders: order.t()
            * [
                [0, 0, 0],
                [c11 / sqrt(c11 * z), 0, 0],
                [c12 / sqrt(c11 * z), y / sqrt(c11 * y), 0],
                [c13 / sqrt(c11 * z), -x / sqrt(c11 * y), 1 / sqrt(y)],
            ],
        receivers: parts * [[1 / sqrt(c11 * z), 0, 0], [0, 1 / sqrt(c11 * y), 0], [0, 0, 1 / sqrt(y)]],
    }
}

/// The coefficients of k11, k22, g and a in v, w, x, y and 1, a row for each.
fn combinations(squares: [[f64; 4]; 6]) -> [[f64; 5]; 6] {
    let mut leading = [[0; 6]; 6];
    let mut others = [[0; 5]; 6];
    for i in 0..6 {
        let r = squares[i][0];
        let [c1, c2, c3] = [r - squares[i][1], r - squares[i][2], r - squares[i][3]];
        leading[i] = [c1 * c1, c2 * c2, 2 * c1, 2 * c2, 2 * c3, 1];
        others[i] = [-2 * c1 * c2, -2 * c1 * c3, -2 * c2 * c3, -c3 * c3, 4 * r];
    }
    solve(leading, others)
}

/// The matrix that exchanges two of four.
fn exchange(i: _, j: _) -> [[f64; 4]; 4] {
    let mut matrix = identity(4);
    matrix[i][i] = 0;
    matrix[j][j] = 0;
    matrix[i][j] = 1;
    matrix[j][i] = 1;
    matrix
}

/// Senders and receivers in a cube. Which of them is the origin depends on the ranges.
#[scene]
fn scene(senders: [[f64; 3]; 4], receivers: [[f64; 3]; 6]) -> Data {
    let mut ranges = [[0; 4]; 6];
    for i in 0..6 {
        for j in 0..4 {
            ranges[i][j] = norm(receivers[i] - senders[j]);
        }
    }
    Data { ranges }
}
