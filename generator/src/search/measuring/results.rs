//! Solutions of an interpreted plan beside known ones, and what a problem returns for them.

use eliminant::emitted::{chart_entry, to_chart, vector_of};

use super::interpreted_program::values;
use crate::expression::arithmetic::Float64;
use crate::plan::{Plan, interpret};
use crate::problem::SolutionField;
use crate::problem::scene::DrawnScene;

/// A known solution counts as found if a returned one is this close, relative to it.
const FOUND: f64 = 1e-6;

/// Numbers all of which are known.
pub(crate) fn all(known: &[f64]) -> Vec<Option<f64>> {
    known.iter().copied().map(Some).collect()
}

/// Whether what a scene says of its solution is among the real solutions that were returned; true
/// if it says nothing.
pub fn has_known(plan: &Plan, points: &[Vec<f64>], scene: &DrawnScene) -> bool {
    match (&scene.solution, &scene.results) {
        (Some(known), _) => in_charts(plan, known).is_ok_and(|known| is_among(points, &all(&known))),
        (_, Some(known)) => is_among_results(plan, results_of(plan, &scene.data, points), known),
        _ => true,
    }
}

/// Whether a known solution, or a known result, is among those that were returned, to
/// [`FOUND`] of its length; at the origin of that of the largest.
pub(crate) fn is_among(returned: &[Vec<f64>], known: &[Option<f64>]) -> bool {
    let norm = |x: &mut dyn Iterator<Item = f64>| x.map(|x| x * x).sum::<f64>().sqrt();
    // What is not known makes no difference.
    let error = |(x, known): (&f64, &Option<f64>)| known.map_or(0.0, |known| x - known);
    let size = match norm(&mut known.iter().flatten().copied()) {
        0.0 => returned.iter().map(|point| norm(&mut point.iter().copied())).fold(f64::MIN_POSITIVE, f64::max),
        own => own,
    };
    returned.iter().any(|point| norm(&mut point.iter().zip(known).map(error)) <= FOUND * size)
}

/// As [`is_among`] for what a problem returns. A field that is given up to scale counts with length
/// 1, and of a returned one the multiple that is nearest to the known one.
pub(crate) fn is_among_results(plan: &Plan, mut returned: Vec<Vec<f64>>, known: &[Option<f64>]) -> bool {
    let (mut known, mut start) = (known.to_vec(), 0);
    for field in plan.output.iter().flat_map(|output| &output.fields) {
        let place = start..start + field.scalars();
        start = place.end;
        let stated: Vec<f64> = known[place.clone()].iter().copied().flatten().collect();
        if !field.is_projective || stated.len() < place.len() {
            continue;
        }
        let norm = dot(&stated, &stated).sqrt();
        let unit: Vec<f64> = stated.iter().map(|x| x / norm).collect();
        for results in &mut returned {
            let values = &mut results[place.clone()];
            let scale = dot(values, &unit) / dot(values, values);
            values.iter_mut().for_each(|x| *x *= scale);
        }
        known[place].copy_from_slice(&all(&unit));
    }
    is_among(&returned, &known)
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// A solution as a solver returns it, with vectors that are given up to scale in coordinates of
/// their charts. One that is in coordinates already stays as it is.
pub(crate) fn in_charts(plan: &Plan, solution: &[f64]) -> Result<Vec<f64>, String> {
    if solution.len() == plan.unknowns.len() {
        return Ok(solution.to_vec());
    }
    let scalars: usize = plan.fields.iter().map(SolutionField::scalars).sum();
    match solution.len() == scalars {
        true => Ok(coordinates(&plan.fields, solution)),
        false => Err(format!("a solution of `{}` has {scalars} numbers, not {}", plan.name, solution.len())),
    }
}

/// The unknowns of a solution of which all scalars are given.
pub(super) fn coordinates(fields: &[SolutionField], solution: &[f64]) -> Vec<f64> {
    let (mut unknowns, mut rest) = (Vec::new(), solution);
    for field in fields {
        let (values, others) = rest.split_at(field.scalars());
        rest = others;
        let start = unknowns.len();
        unknowns.extend(&values[..field.unknowns().len()]);
        if let Some(chart) = field.chart() {
            to_chart(&chart, values, &mut unknowns[start..]);
        }
    }
    unknowns
}

/// The scalars of all fields of a solution: vectors that are given up to scale have length 1.
pub fn scalars_of(plan: &Plan, point: &[f64]) -> Vec<f64> {
    let mut scalars = Vec::new();
    for field in &plan.fields {
        let unknowns = &point[field.unknowns()];
        match field.chart() {
            None => scalars.extend(unknowns),
            Some(chart) => {
                let mut vector = vec![0.0; field.scalars()];
                vector_of(&chart, unknowns, &mut vector);
                scalars.extend(vector);
            }
        }
    }
    scalars
}

/// What the problem returns for each solution: the fields one after another, arrays row by row.
/// Nothing if it returns nothing, or if data that are derived for it have no value.
pub fn results_of(plan: &Plan, data: &[f64], points: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let Some(output) = &plan.output else { return Vec::new() };
    let Some(coefficients) = interpret::coefficients_of_results(plan, output, Float64, data) else {
        return Vec::new();
    };
    let of_point = |point: &Vec<f64>| {
        let values = values(&output.of_solution, &[&coefficients[..], &variables(plan, point)].concat());
        output.scalars.iter().map(|id| values[id.0 as usize]).collect()
    };
    points.iter().map(of_point).collect()
}

/// The coordinates that results are computed from: the unknowns, of vectors that are given up to
/// scale their coordinates; then the last coordinate of each of these.
fn variables(plan: &Plan, point: &[f64]) -> Vec<f64> {
    let (mut x, mut last) = (point.to_vec(), Vec::new());
    for field in &plan.fields {
        let Some(chart) = field.chart() else { continue };
        let mut vector = vec![0.0; field.scalars()];
        vector_of(&chart, &point[field.unknowns()], &mut vector);
        let factor = field.scale_of_chart();
        let coordinates: Vec<f64> = chart.iter().map(|row| factor * chart_entry(row, &vector)).collect();
        if let Some((of_last, others)) = coordinates.split_last() {
            x[field.unknowns()].copy_from_slice(others);
            last.push(*of_last);
        }
    }
    x.extend(last);
    x
}
