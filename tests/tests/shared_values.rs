//! Data whose solutions share a value of the action monomial, and data with a double solution.

use eliminant_generator::algebra::Random;
use eliminant_generator::search::measuring::interpreted::InterpretedSolver;
use eliminant_tests::ground_truth::{Line, gram, minimal_conic, minimal_data, null_space, relative_error, uniform};

use eliminant_tests::{Case, cases};
use nalgebra::{Matrix2, Rotation2, Vector2};

const INSTANCES: u64 = 1_000;
/// A truth counts as found if some solution is this close.
const FOUND: f64 = 1e-6;

fn case(name: &str) -> Case {
    cases().into_iter().find(|case| case.name == name).unwrap_or_else(|| panic!("no case {name}"))
}

/// How many of the truths are close to one of the points.
fn count_found(truths: &[Vec<f64>], points: &[Vec<f64>]) -> usize {
    truths.iter().filter(|truth| points.iter().any(|point| relative_error(point, truth) <= FOUND)).count()
}

/// The sides of an isosceles triangle, and the dual conics (d1, .., d5) of its incircle and its
/// three excircles. The axis, on which two of the centres lie, has the direction `turn` * (0, 1).
fn isosceles(half_base: f64, height: f64, turn: Rotation2<f64>, shift: Vector2<f64>) -> (Vec<Line>, Vec<Vec<f64>>) {
    let leg = half_base.hypot(height);
    let corners = [[-half_base, 0.0], [half_base, 0.0], [0.0, height]].map(|[x, y]| turn * Vector2::new(x, y) + shift);
    let normals = [[height / leg, half_base / leg], [-height / leg, half_base / leg], [0.0, -1.0]];
    let line = |k: usize| {
        let normal = turn * Vector2::from(normals[k]);
        Line { normal, offset: -normal.dot(&corners[(k + 1) % 3]) }
    };
    // Barycentric coordinates: the lengths of the sides, for an excircle one of them negative.
    let circle = |signs: [f64; 3]| {
        let weights = [signs[0] * leg, signs[1] * leg, signs[2] * 2.0 * half_base];
        let sum: f64 = weights.iter().sum();
        let centre = (corners[0] * weights[0] + corners[1] * weights[1] + corners[2] * weights[2]) / sum;
        let (x, y, radius) = (centre.x, centre.y, 2.0 * half_base * height / sum);
        vec![radius * radius - x * x, -x * y, -x, radius * radius - y * y, -y]
    };
    let signs = [[1.0, 1.0, 1.0], [-1.0, 1.0, 1.0], [1.0, -1.0, 1.0], [1.0, 1.0, -1.0]];
    ((0..3).map(line).collect(), signs.map(circle).to_vec())
}

/// Quarter turns, exact, or any.
fn turn(random: &mut Random, exact: bool) -> Rotation2<f64> {
    let [c, s] = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]][random.below(4) as usize];
    match exact {
        true => Rotation2::from_matrix_unchecked(Matrix2::new(c, -s, s, c)),
        false => Rotation2::new(uniform(random, 0.0, std::f64::consts::TAU)),
    }
}

/// Centres on an axis of symmetry that is parallel to a coordinate axis share a coordinate; with
/// the stationary points that are no tangent circles up to five of the nine solutions do.
#[test]
fn all_circles_of_symmetric_triangles_are_found() {
    let solvers = ["circle_minimal", "circle_least_squares_dual", "circle_least_squares"].map(case);
    for (equilateral, exact) in [(false, true), (false, false), (true, true), (true, false)] {
        // For each solver: refused as degenerate, and one of the four circles missed.
        let mut counts = [[0; 2]; 3];
        for k in 0..INSTANCES {
            let mut random = Random::new(60_000_000 + k);
            let half_base = uniform(&mut random, 0.5, 2.0);
            let height = if equilateral { half_base * 3f64.sqrt() } else { uniform(&mut random, 0.5, 4.0) };
            let turn = turn(&mut random, exact);
            let shift = Vector2::from_fn(|_, _| uniform(&mut random, -2.0, 2.0));
            let (lines, circles) = isosceles(half_base, height, turn, shift);
            for (at, solver) in solvers.iter().enumerate() {
                // The solver's data, and which unknowns of the circle it has.
                let (data, unknowns) = match at {
                    0 => (minimal_data(&lines), 0..5),
                    1 => (gram(&lines), 2..5),
                    _ => (gram(&lines), 0..5),
                };
                let Ok(found) = (solver.solve)(&data) else {
                    counts[at][0] += 1;
                    continue;
                };
                let found: Vec<Vec<f64>> = match at {
                    0 => found.iter().map(|solution| minimal_conic(&data, solution)).collect(),
                    _ => found.iter().map(|solution| solution[..unknowns.len()].to_vec()).collect(),
                };
                let truths: Vec<Vec<f64>> = circles.iter().map(|circle| circle[unknowns.clone()].to_vec()).collect();
                counts[at][1] += usize::from(count_found(&truths, &found) < 4);
            }
        }
        println!(
            "equilateral {equilateral}, quarter turns {exact}: [degenerate, incomplete] of {INSTANCES}: {counts:?}"
        );
        // The least squares of an equilateral triangle are degenerate for these templates, whatever
        // the rotation.
        assert!(counts[0][0] == 0 && (equilateral || counts[1][0] + counts[2][0] == 0), "{counts:?}");
        assert!(counts.iter().all(|[_, incomplete]| *incomplete * 1000 <= INSTANCES as usize), "{counts:?}");
    }
}

/// Two conics of the pencil through two pairs of points, each pair with one x, real or conjugate;
/// and the real ones of the points.
fn conics_with_shared_x(random: &mut Random, pairs: [bool; 2]) -> (Vec<f64>, Vec<Vec<f64>>) {
    let (mut truths, mut rows) = (Vec::new(), Vec::new());
    for real in pairs {
        let [x, y, d] = [0; 3].map(|_| random.symmetric_unit());
        // Half the sum and half the difference of (x^2, x y, y^2, x, y, 1) at y + d and y - d, or y
        // + i d and y - i d, divided by d or i d.
        let square = if real { d * d } else { -d * d };
        rows.push(vec![x * x, x * y, y * y + square, x, y, 1.0]);
        rows.push(vec![0.0, x, 2.0 * y, 0.0, 1.0, 0.0]);
        truths.extend([y - d, y + d].into_iter().filter(|_| real).map(|y| vec![x, y]));
    }
    (null_space(&rows).concat(), truths)
}

#[test]
fn conics_that_meet_in_points_with_the_same_x() {
    let conics = case("two_conics");
    for pairs in [[true, true], [true, false], [false, false]] {
        let mut incomplete = [0; 2];
        for k in 0..INSTANCES {
            let (data, truths) = conics_with_shared_x(&mut Random::new(61_000_000 + k), pairs);
            let real = (conics.solve)(&data).unwrap_or_default();
            let all = (conics.solve_complex)(&data).unwrap_or_default();
            incomplete[0] += usize::from(count_found(&truths, &real) != truths.len() || real.len() != truths.len());
            incomplete[1] += usize::from(all.len() != 4);
        }
        println!("pairs real: {pairs:?}: [solve, solve_complex] incomplete on {incomplete:?} of {INSTANCES}");
        assert!(incomplete.iter().all(|count| count * 1000 <= INSTANCES as usize), "{incomplete:?}");
    }
}

/// P and w P + L M touch in a point of P if L is the tangent there and M any line.
#[test]
fn conics_that_touch_have_the_point_once() {
    let conics = case("two_conics");
    let mut counts = [0; 4];
    for k in 0..INSTANCES {
        let mut random = Random::new(62_000_000 + k);
        let mut draw = || random.symmetric_unit();
        let (x, y) = (draw(), draw());
        let mut p = [draw(), draw(), draw(), draw(), draw(), 0.0];
        p[5] = -(p[0] * x * x + p[1] * x * y + p[2] * y * y + p[3] * x + p[4] * y);
        let (a, b) = (2.0 * p[0] * x + p[1] * y + p[3], p[1] * x + 2.0 * p[2] * y + p[4]);
        let (l, m) = ([a, b, -(a * x + b * y)], [draw(), draw(), draw()]);
        let product = [
            l[0] * m[0],
            l[0] * m[1] + l[1] * m[0],
            l[1] * m[1],
            l[0] * m[2] + l[2] * m[0],
            l[1] * m[2] + l[2] * m[1],
            l[2] * m[2],
        ];
        let weight = draw();
        let q: Vec<f64> = (0..6).map(|i| weight * p[i] + product[i]).collect();
        let found = (conics.solve)(&[p.to_vec(), q].concat()).unwrap_or_default();
        // Half of the digits at best, fewer where another intersection is close.
        let close = found.iter().filter(|point| relative_error(point, &[x, y]) <= 1e-4).count();
        counts[close.min(3)] += 1;
    }
    println!("the point is found [never, once, twice, more often] on {counts:?} of {INSTANCES}");
    assert!(counts[1] * 100 >= INSTANCES as usize * 99, "{counts:?}");
}

/// Known points at one height z: both solutions have the same x and y. Not too close to that
/// height, where the two become a double one, to which the polish converges slowly.
#[test]
fn trilateration_from_points_at_one_height() {
    let solver = case("trilateration");
    for height in [0.0, 1.0] {
        let mut counts = [0; 3];
        for k in 0..INSTANCES {
            let mut random = Random::new(63_000_000 + k);
            let mut draw = || random.symmetric_unit();
            let centres = [0; 3].map(|_| [draw(), draw(), height]);
            let side = draw().signum();
            let point = [draw(), draw(), height + side * uniform(&mut random, 0.05, 1.0)];
            let distance = |c: &[f64; 3]| (0..3).map(|j| (c[j] - point[j]).powi(2)).sum::<f64>().sqrt();
            let data = [centres.concat(), centres.iter().map(distance).collect()].concat();
            let truths = [point.to_vec(), vec![point[0], point[1], 2.0 * height - point[2]]];
            let found = (solver.solve)(&data).unwrap_or_default();
            assert_eq!(count_found(&found, &truths), found.len(), "{found:?}, not {truths:?}");
            counts[count_found(&truths, &found)] += 1;
        }
        println!("height {height}: [none, one, both] found on {counts:?} of {INSTANCES}");
        assert!(counts[2] * 1000 >= INSTANCES as usize * 999, "{counts:?}");
    }
}

/// The interpreted solver, by which templates are judged, finds what the emitted one finds: with
/// shared values, and with solutions that have an unknown zero.
#[test]
fn interpreted_and_emitted_find_the_same() {
    type Draw = fn(&mut Random) -> Vec<f64>;
    let triangle: Draw = |random| {
        let (half_base, height) = (uniform(random, 0.5, 2.0), uniform(random, 0.5, 4.0));
        let turn = turn(random, true);
        let shift = Vector2::from_fn(|_, _| uniform(random, -2.0, 2.0));
        gram(&isosceles(half_base, height, turn, shift).0)
    };
    let shared: Draw = |random| {
        let pairs = [random.below(2) == 0, random.below(2) == 0];
        conics_with_shared_x(random, pairs).0
    };
    // y divides the first equation.
    let zero: Draw = |random| {
        let mut conics = [0; 12].map(|_| random.symmetric_unit());
        [0, 3, 5].into_iter().for_each(|at| conics[at] = 0.0);
        conics.to_vec()
    };
    for (name, draw) in [("circle_least_squares_dual", triangle), ("two_conics", shared), ("two_conics", zero)] {
        let case = case(name);
        let plan = case.planned().plan;
        let interpreted = InterpretedSolver::of(&plan);
        let mut found = 0;
        for k in 0..INSTANCES {
            let data = draw(&mut Random::new(64_000_000 + k));
            let emitted = (case.solve_complex)(&data);
            assert_eq!(emitted, interpreted.solve_complex(&data), "{name}: {data:?}");
            found += emitted.unwrap_or_default().len();
        }
        println!("{name}: {found} solutions found on {INSTANCES} instances");
        assert!(found * 2 > plan.solutions * INSTANCES as usize, "{name}: {found}");
    }
}
