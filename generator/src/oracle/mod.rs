//! The true solutions of an instance, in numbers of 237 bits, by which what a solver returns in
//! `f64` is judged.
//!
//! ```text
//! points of the solver --Newton, 237 bits--> solutions --as many as the problem has?--> done
//!                                                |  fewer
//!                                                v
//!       the same template, 237 bits --eigenpairs--> points --Newton, 237 bits--> solutions
//! ```
//!
//! What it certifies: each solution is simple, its 50 leading digits are those of a solution of the
//! equations as stated with the data as given, and no two are the same. If they are as many as the
//! problem has for general data, they are all: no data have more isolated solutions than general
//! ones. Then the numbers of real and of complex solutions are certain.
//!
//! What it cannot: where fewer are found, others are multiple or infinite, share their eigenvalue
//! with others, or the template is singular for these data even at 237 bits.
//! `Truths::is_complete` says so. Nothing is a solution where more equations than unknowns
//! contradict each other by more than the rounding of data. Templates of more than
//! `MOST_OPERATIONS` are not tried.

mod number;
mod spectrum;
mod system;
mod template;

use eliminant::Complex;

pub use number::BITS;
use number::{rounded, widened};
use system::{System, WidePoint, norm};

use crate::plan::Plan;

/// Operations of a solve that are repeated at 237 bits at most: each takes some 0.3 microseconds.
pub const MOST_OPERATIONS: usize = 6_000_000;
/// Solutions that are closer than this, relative to their norms, are one: they are known to twice
/// as many digits.
const SAME: f64 = 1e-25;
/// A point that is this close to a known solution most likely leads to it.
const NEXT_TO: f64 = 1e-9;
/// A returned point approximates a solution that is at most this far, relative to the solution.
const NEAR: f64 = 1e-2;

/// The solutions of one instance.
pub struct Truths<'a> {
    system: System<'a>,
    points: Vec<WidePoint>,
    /// The number of solutions for general data.
    expected: usize,
}

/// How the points that a solver returns lie to the solutions.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Judged {
    /// The number of different solutions that points approximate.
    pub found: usize,
    /// The number of other points: there is no solution near them, or other points are closer to
    /// it.
    pub spurious: usize,
    /// The distance of each point that is not spurious from its solution, relative to its norm.
    pub errors: Vec<f64>,
    /// The relative residual of each point: max over the equations of |f| / sum of the moduli of
    /// its terms.
    pub residuals: Vec<f64>,
}

impl<'a> Truths<'a> {
    /// The solutions of an instance. `near` are points that are likely to be close to solutions,
    /// such as what a solver returns. `None` if a coefficient divides by 0.
    pub fn of(plan: &'a Plan, data: &[f64], near: &[Vec<Complex<f64>>]) -> Option<Self> {
        let starts: Vec<WidePoint> = near.iter().map(|point| point.iter().copied().map(widened).collect()).collect();
        let size = starts.iter().map(|start| norm(start)).filter(|size| size.is_finite()).reduce(f64::max);
        let system = System::new(plan, data, size.unwrap_or(1.0))?;
        let mut this = Self { system, points: Vec::new(), expected: plan.solutions };
        // Points that are next to a known solution, such as its conjugate, are looked at only if
        // solutions are missing.
        let mut next_to = Vec::new();
        for start in &starts {
            match this.points.iter().any(|known| this.system.distance(start, known) <= NEXT_TO) {
                true => next_to.push(start),
                false => this.add(start),
            }
        }
        if this.points.len() < this.expected {
            next_to.into_iter().for_each(|start| this.add(start));
        }
        if plan.has_origin {
            this.add(&template::origin(plan, &this.system));
        }
        if this.points.len() < this.expected && plan.operations().total() <= MOST_OPERATIONS {
            for point in template::points(plan, &this.system) {
                this.add(&point);
            }
        }
        Some(this)
    }

    /// Adds the solution near a point, if there is one, and its conjugate: data are real.
    fn add(&mut self, start: &[number::WideComplex]) {
        let refined = self.system.refined(start);
        if !refined.is_solution() || !self.system.is_admissible(&refined.point) {
            return;
        }
        let conjugate: WidePoint = refined.point.iter().map(|x| x.conj()).collect();
        for point in [refined.point, conjugate] {
            if self.points.iter().all(|known| self.system.distance(&point, known) > SAME) {
                self.points.push(point);
            }
        }
    }

    /// Whether these are all solutions, for certain.
    pub fn is_complete(&self) -> bool {
        self.points.len() == self.expected
    }

    /// The number of solutions.
    pub fn complex(&self) -> usize {
        self.points.len()
    }

    /// The number of real solutions that satisfy the inequalities of the problem.
    pub fn real(&self) -> usize {
        self.points.iter().filter(|point| self.is_real(point) && self.system.is_wanted(point)).count()
    }

    /// Judges points that were returned for these data. `only_real` says that only real solutions
    /// count that satisfy the inequalities of the problem.
    pub fn judge(&self, returned: &[Vec<Complex<f64>>], only_real: bool) -> Judged {
        let wide: Vec<WidePoint> = returned.iter().map(|point| point.iter().copied().map(widened).collect()).collect();
        let is_returned = |point: &WidePoint| self.is_real(point) && self.system.is_wanted(point);
        let counts = |at: &usize| !only_real || is_returned(&self.points[*at]);
        let mut pairs: Vec<(f64, usize, usize)> = Vec::new();
        for (point, of) in wide.iter().enumerate() {
            let near =
                (0..self.points.len()).filter(counts).map(|at| (self.system.distance(of, &self.points[at]), point, at));
            pairs.extend(near.filter(|&(error, ..)| error <= NEAR));
        }
        // The closest pairs first: no point and no solution belongs to two.
        pairs.sort_by(|(a, ..), (b, ..)| a.total_cmp(b));
        let (mut is_taken, mut is_found) = (vec![false; wide.len()], vec![false; self.points.len()]);
        let mut errors = Vec::new();
        for (error, point, at) in pairs {
            if !is_taken[point] && !is_found[at] {
                (is_taken[point], is_found[at]) = (true, true);
                errors.push(error);
            }
        }
        Judged {
            found: errors.len(),
            spurious: returned.len() - errors.len(),
            errors,
            residuals: returned.iter().map(|point| self.system.residual(point)).collect(),
        }
    }

    /// Whether all imaginary parts are 0 but for the last digits.
    fn is_real(&self, point: &WidePoint) -> bool {
        let imaginary: WidePoint = point.iter().map(|x| widened(Complex::new(0.0, rounded(x.im)))).collect();
        self.system.relative(norm(&imaginary), point) <= SAME
    }

    /// The solutions, rounded.
    pub fn rounded(&self) -> Vec<Vec<Complex<f64>>> {
        let round = |point: &WidePoint| point.iter().map(|x| Complex::new(rounded(x.re), rounded(x.im))).collect();
        self.points.iter().map(round).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::plan;
    use crate::problem::Problem;
    use crate::search::measuring::random_instance;
    use crate::template::file::TemplateFile;

    fn committed(name: &str) -> Plan {
        let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../templates");
        let read = |end: &str| std::fs::read_to_string(folder.join(format!("{name}.{end}"))).expect("a file");
        let problem = Problem::parse(name, &read("rs")).unwrap_or_else(|messages| panic!("{}", messages.render()));
        let file = TemplateFile::parse(&read("template.toml"), &problem.unknowns).expect("a template");
        plan(&problem, &file).expect("a plan").plan
    }

    /// Without any point to start from, the template at 237 bits gives all solutions: by
    /// eigenvalues and determinants, with presolve, sign changes and read pivots.
    #[test]
    fn the_template_alone_gives_all_solutions() {
        for name in ["two_conics", "relpose_5pt", "circle_least_squares", "tensor_eigenvectors", "pose_3pt_depths"] {
            let plan = committed(name);
            for k in 0..3 {
                let truths = Truths::of(&plan, &random_instance(&plan, 5, k), &[]).expect("no divisor");
                assert!(truths.is_complete(), "{name}, {k}: {} of {}", truths.complex(), plan.solutions);
                let rounded = truths.rounded();
                let judged = truths.judge(&rounded, false);
                assert_eq!((judged.found, judged.spurious), (plan.solutions, 0), "{name}");
                assert!(judged.errors.iter().all(|&error| error < 1e-15), "{name}: {judged:?}");
            }
        }
    }

    /// Four points in front of a camera are inequalities of degree four, the equations quadrics.
    #[test]
    fn inequalities_may_be_of_higher_degree_than_equations() {
        let plan = committed("pose_4pt_focal");
        let mut wanted = 0;
        for k in 0..20 {
            let truths = Truths::of(&plan, &random_instance(&plan, 5, k), &[]).expect("no divisor");
            assert_eq!(truths.judge(&truths.rounded(), true).found, truths.real());
            wanted += truths.real();
        }
        assert!(wanted > 0, "no real solution is tested");
    }

    /// x^2 = 2 and its neighbours: what is lost, wrong, or twice there is counted.
    #[test]
    fn missed_and_spurious_points_are_told() {
        let plan = committed("two_conics");
        let truths = Truths::of(&plan, &random_instance(&plan, 5, 1), &[]).expect("no divisor");
        let mut points = truths.rounded();
        let real = truths.real();
        assert_eq!(truths.judge(&points, true).found, real);
        let far: Vec<Complex<f64>> = points[0].iter().map(|x| x * 1.5 + 0.1).collect();
        points[1] = points[0].clone();
        points.push(far);
        let judged = truths.judge(&points, false);
        assert_eq!((judged.found, judged.spurious, judged.residuals.len()), (3, 2, 5), "{judged:?}");
        assert!(judged.residuals[4] > 1e-3 && judged.residuals[0] < 1e-14, "{judged:?}");
    }
}
