/// Circle tangent to n lines in the least-squares sense, in three unknowns of the dual conic, 9
/// solutions.
///
/// Gummeson & Oskarsson, "Robust and Accurate Cylinder Triangulation": the two constraints give d1
/// and d2, which leaves the cost as a polynomial in d3, d4, d5. Data and conic are those of
/// `circle_least_squares`.
fn circle_least_squares_dual(#[mean(of_line)] #[symmetric] gram: [[f64; 6]; 6]) -> (d3, d4, d5) {
    let d1 = d4 + d5 * d5 - d3 * d3;
    let d2 = -d3 * d5;
    let d = [d1, 2 * d2, 2 * d3, d4, 2 * d5, -1];
    let cost = dot(d, gram * d);
    gradient(cost) == 0;
    Circle { centre: [-d3, -d5], squared_radius: d1 + d3 * d3, cost: cost }
}

/// What a line a x + b y + c = 0 gives.
fn of_line(line: [f64; 3]) -> [[f64; 6]; 6] {
    let [a, b, c] = line;
    let r = [a * a, a * b, a * c, b * b, b * c, c * c];
    [r[0] * r, r[1] * r, r[2] * r, r[3] * r, r[4] * r, r[5] * r]
}

/// Ten tangents of a circle.
#[scene]
fn scene(#[unit] normals: [[f64; 2]; 10], place: [f64; 2], size: f64) -> (Data, Circle) {
    let radius = 3 / 2 + size;
    let mut gram = [[0; 6]; 6];
    for normal in normals {
        let line = concat(normal, -dot(normal, place) - radius);
        gram += of_line(line) / 10;
    }
    (Data { gram }, Circle { centre: place, squared_radius: radius * radius, cost: 0 })
}
