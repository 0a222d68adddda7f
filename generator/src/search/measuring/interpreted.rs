//! A plan as a solver, without compiling it: the runtime's kernels with sizes that are known at run
//! time.
//!
//! What differs from an emitted solver is where the numbers are kept. The operations and their
//! order are the same, so the solutions have the same bits, those of second attempts included.

use std::ops::Range;

use eliminant::emitted::{self, Dynamic, Product, Sizes, SizesOf, SolverInstance, Tables, Term};
use eliminant::{Complex, Scalar, SolveError};

use crate::plan::system_table::SystemTable;
use crate::plan::value_layout::ValueLayout;
use crate::plan::{LEAST_PIVOT_OF_PRESOLVE, Plan, PlannedBlock, PlannedDerivation, PlannedRecovery, Zeros};

use super::interpreted_chains::{self, InterpretedChains};
use super::interpreted_elimination::Elimination;
use super::interpreted_program::{Program, condition, values};

/// All tables of a solver, in the runtime's form.
#[derive(Clone, Debug)]
pub struct InterpretedSolver {
    unknowns: usize,
    solutions: usize,
    has_origin: bool,
    zeros: Zeros,
    chains: Option<InterpretedChains>,
    program: Program,
    /// Whether an elimination at twice the precision computes the coefficients anew.
    has_precise_coefficients: bool,
    elimination: Elimination,
    layout: ValueLayout,
    action_monomial: Vec<i8>,
    /// For each unknown the pairs of positions that it is read from.
    ratios: Vec<Vec<(u16, u16)>>,
    steps: Vec<Vec<i8>>,
    images: Vec<Vec<emitted::Image>>,
    linear: Option<PlannedBlock>,
    recoveries: Vec<PlannedRecovery>,
    equations: System,
    nonzero: System,
    positive: Vec<Vec<crate::plan::Term>>,
    /// The number of scalings, and the weights of data and unknowns in them.
    scalings: (usize, Vec<i8>, Vec<i8>),
    /// The unknowns that are elements of vectors up to scale.
    in_vectors: u32,
    /// The unknowns of vectors up to scale whose elements have different units, and their charts.
    vectors: Vec<(Range<usize>, Vec<Vec<f64>>)>,
    /// What the data of each parameter satisfy, and how many there are.
    parameters: Vec<(emitted::Condition, u32)>,
    /// What data are derived.
    derived: Vec<PlannedDerivation>,
    /// The quotients of the template, and the coefficients of the equations. If there are
    /// quotients, only the latter must be finite.
    quotients: [Vec<u16>; 2],
    /// The number of data of the problem, and of all.
    stated: usize,
    inputs: usize,
}

/// The tables of a polynomial system, owned.
#[derive(Clone, Debug)]
struct System {
    chain: Vec<Product>,
    ends: Vec<u32>,
    terms: Vec<Term>,
    is_dense: bool,
}

impl InterpretedSolver {
    /// The solver of a plan.
    pub fn of(plan: &Plan) -> Self {
        let unknowns = plan.unknowns.len();
        let layout = ValueLayout::of(plan);
        Self {
            unknowns,
            solutions: plan.solutions,
            has_origin: plan.has_origin,
            zeros: plan.zeros,
            chains: plan.chains.as_ref().map(InterpretedChains::of),
            program: Program::of(plan),
            has_precise_coefficients: plan.has_precise_coefficients(),
            elimination: Elimination::of(plan),
            ratios: (0..unknowns).map(|unknown| layout.ratios(plan, unknown)).collect(),
            layout,
            action_monomial: plan.action_monomial.clone(),
            steps: plan.steps(),
            images: plan.images.clone(),
            linear: plan.linear.clone(),
            recoveries: plan.recoveries.clone(),
            equations: System::of(&plan.equations, unknowns),
            nonzero: System::of(&plan.nonzero, unknowns),
            positive: plan.positive.clone(),
            scalings: (plan.scalings.len(), plan.weights_of_data(), plan.weights_of_unknowns()),
            in_vectors: plan.unknowns_in_vectors(),
            vectors: plan.vectors_with_units().filter_map(|field| Some((field.unknowns(), field.chart()?))).collect(),
            parameters: parameters(plan),
            derived: plan.derived.clone(),
            quotients: [plan.quotients(), plan.coefficients_of_statements()]
                .map(|coefficients| coefficients.iter().map(|id| id.0).collect()),
            stated: plan.stated,
            inputs: plan.inputs(),
        }
    }

    /// The solver with data, one parameter after another, arrays row by row.
    ///
    /// # Errors
    /// [`SolveError::NonFiniteInput`] or [`SolveError::Overflow`].
    pub fn instance(&self, data: &[f64]) -> Result<InterpretedInstance<'_>, SolveError> {
        let (count, of_data, of_unknowns) = &self.scalings;
        let scalings =
            emitted::Scalings { count: *count, data: of_data, unknowns: of_unknowns, in_vectors: self.in_vectors };
        let (mut scaled, mut exponents) = (self.stated_data(data)?, vec![0; self.unknowns]);
        scalings.apply_into(&mut scaled, &mut exponents);
        let coefficients = self.coefficients::<f64>(&scaled);
        let [quotients, stated] = &self.quotients;
        match quotients.is_empty() {
            true => emitted::check_coefficients(&coefficients, &[data])?,
            false => {
                let stated: Vec<f64> = stated.iter().map(|&slot| coefficients[usize::from(slot)]).collect();
                emitted::check_coefficients(&stated, &[data])?;
            }
        }
        let rows = self.equations.rows(&coefficients);
        let read = vec![vec![0.0; self.layout.basis]; self.layout.read];
        let (steps, images) = (self.steps.iter().map(Vec::as_slice), self.images.iter().map(Vec::as_slice));
        Ok(InterpretedInstance {
            solver: self,
            data: scaled,
            exponents,
            coefficients,
            rows,
            read,
            steps: steps.collect(),
            images: images.collect(),
            lists: self.program.lists(),
            attempts: 0,
            memory: emitted::Memory::new(),
        })
    }

    /// The unknowns of the problem as it was given, from those of the scaled one, which exceed them
    /// by powers of two with these exponents.
    pub fn unscale<S: Scalar>(&self, exponents: &[i16], point: &mut [S]) {
        let mut of_others = exponents.to_vec();
        for (unknowns, chart) in &self.vectors {
            let exponents: Vec<i16> = of_others[unknowns.clone()].iter_mut().map(std::mem::take).collect();
            let mut vector = vec![S::ZERO; chart.len()];
            emitted::unscale_in_chart(chart, &exponents, (&mut point[unknowns.clone()], &mut vector));
        }
        emitted::unscale(&of_others, point);
    }

    /// The data of the problem, from those that are given.
    fn stated_data(&self, given: &[f64]) -> Result<Vec<f64>, SolveError> {
        let mut data = given.to_vec();
        for planned in self.derived.iter().take_while(|planned| planned.derivation.first_input < self.stated) {
            emitted::check_coefficients(&[], &[given])?;
            if planned.is_for_results {
                data.resize(planned.derivation.inputs().end, 0.0);
                continue;
            }
            match derived(planned, &data) {
                Err(_) if planned.is_tentative => data.resize(planned.derivation.inputs().end, f64::NAN),
                results => data.extend(results?),
            }
        }
        for planned in self.derived.iter().filter(|planned| planned.is_tentative) {
            data[planned.derivation.inputs()].fill(0.0);
        }
        Ok(data)
    }

    /// The coefficients in the precision of R, from the data of the problem. They are NaN where
    /// equations cannot be solved for monomials.
    fn coefficients<R: emitted::Real>(&self, data: &[f64]) -> Vec<R> {
        if self.inputs == self.stated {
            return self.program.evaluate(data);
        }
        let mut inputs: Vec<R> = data.iter().map(|&x| R::from_f64(x)).collect();
        for planned in self.derived.iter().filter(|planned| planned.derivation.first_input >= self.stated) {
            let Ok(results) = presolved(planned, &inputs) else {
                inputs.truncate(self.stated);
                inputs.resize(self.inputs, R::from_f64(f64::NAN));
                break;
            };
            inputs.extend(results);
        }
        self.program.evaluate_on(&inputs)
    }

    /// The real solutions, as `solve` of the emitted solver returns them.
    ///
    /// # Errors
    /// As the emitted solver.
    pub fn solve(&self, data: &[f64]) -> Result<Vec<Vec<f64>>, SolveError> {
        self.instance(data)?.solve()
    }

    /// All solutions, as `solve_complex` of the emitted solver returns them.
    ///
    /// # Errors
    /// As the emitted solver.
    pub fn solve_complex(&self, data: &[f64]) -> Result<Vec<Vec<Complex<f64>>>, SolveError> {
        self.instance(data)?.solve_complex()
    }
}

/// The value of a polynomial. The first term is taken as it is, as emitted code does.
fn sum<S: Scalar>(terms: &[crate::plan::Term], coefficients: &[f64], x: &[S]) -> S {
    let product = |term: &crate::plan::Term| {
        let factors = term.exponents.iter().zip(x).flat_map(|(&e, &x)| (0..e).map(move |_| x));
        factors.fold(S::from_f64(coefficients[usize::from(term.coefficient.0)]), |product, x| product * x)
    };
    terms.iter().map(product).reduce(|sum, term| sum + term).unwrap_or(S::ZERO)
}

/// The results of a derivation of the problem.
fn derived(planned: &PlannedDerivation, data: &[f64]) -> Result<Vec<f64>, SolveError> {
    let PlannedDerivation { derivation, program, .. } = planned;
    let values = values(program, data);
    let operands: Vec<f64> = derivation.operands.iter().map(|id| values[id.0 as usize]).collect();
    derivation.kind.over_reals(operands, 0.0)
}

/// The results of a derivation of presolve.
fn presolved<R: emitted::Real>(planned: &PlannedDerivation, inputs: &[R]) -> Result<Vec<R>, SolveError> {
    let PlannedDerivation { derivation, program, .. } = planned;
    let values = values(program, inputs);
    let operands: Vec<R> = derivation.operands.iter().map(|id| values[id.0 as usize]).collect();
    derivation.kind.solved(operands, LEAST_PIVOT_OF_PRESOLVE)
}

/// What the data of each parameter satisfy, and how many there are. Derived data are as free as
/// general ones.
fn parameters(plan: &Plan) -> Vec<(emitted::Condition, u32)> {
    let given = plan.data.iter().map(|parameter| (condition(parameter), parameter.len() as u32));
    let derived = Some((plan.stated - plan.given()) as u32).filter(|&count| count > 0);
    given.chain(derived.map(|count| (emitted::Condition::Free, count))).collect()
}

impl System {
    fn of(polynomials: &[Vec<crate::plan::Term>], unknowns: usize) -> Self {
        let table = SystemTable::of(polynomials, unknowns);
        Self {
            is_dense: table.is_dense(),
            chain: table.chain.iter().map(|&(parent, unknown)| Product { parent, unknown }).collect(),
            ends: table.ends,
            terms: table.terms.iter().map(|&(coefficient, monomial)| Term { coefficient, monomial }).collect(),
        }
    }

    /// The coefficients of all equations, one row for each monomial, if they are stored as a
    /// matrix.
    fn rows(&self, coefficients: &[f64]) -> Option<Vec<Vec<f64>>> {
        let rows = coefficients.chunks(self.ends.len().max(1)).take(self.chain.len());
        self.is_dense.then(|| rows.map(<[f64]>::to_vec).collect())
    }

    fn tables(&self, unknowns: usize) -> Tables<'_, Dynamic, Dynamic, Dynamic> {
        let sizes = (Dynamic(unknowns), Dynamic(self.ends.len()), Dynamic(self.chain.len()));
        Tables { sizes, chain: &self.chain, ends: &self.ends, terms: &self.terms }
    }
}

/// An interpreted solver with the coefficients of one instance.
#[derive(Debug)]
pub struct InterpretedInstance<'a> {
    solver: &'a InterpretedSolver,
    /// Scaled, as all that follows.
    data: Vec<f64>,
    /// Exponents of the powers of two by which the unknowns are scaled.
    exponents: Vec<i16>,
    coefficients: Vec<f64>,
    /// The coefficients of all equations, one row for each monomial, if they are stored as a
    /// matrix.
    rows: Option<Vec<Vec<f64>>>,
    /// Monomials that unknowns are read from, as combinations of the basis; known after the
    /// elimination.
    read: Vec<Vec<f64>>,
    steps: Vec<&'a [i8]>,
    images: Vec<&'a [emitted::Image]>,
    /// Of the program: factors and places.
    lists: [Vec<&'a [u32]>; 2],
    /// How often the template was eliminated.
    attempts: usize,
    /// Memory of second attempts.
    memory: emitted::Memory,
}

impl InterpretedInstance<'_> {
    /// The real solutions, as `solve` of the emitted solver returns them.
    ///
    /// # Errors
    /// As the emitted solver.
    pub fn solve(&mut self) -> Result<Vec<Vec<f64>>, SolveError> {
        let found = match self.solver.chains {
            None => emitted::real_solutions(self)?,
            Some(_) => emitted::real_solutions_by_determinant(self)?,
        };
        let mut points = found.to_vec();
        points.retain(|point| self.is_wanted(point));
        points.iter_mut().for_each(|point| self.solver.unscale(&self.exponents, point));
        Ok(points)
    }

    /// Whether a point satisfies the inequalities of the problem.
    fn is_wanted(&self, x: &[f64]) -> bool {
        self.solver.positive.iter().all(|terms| sum(terms, &self.coefficients, x) > 0.0)
    }

    /// The values of all coefficients, of data in the unit of the solver.
    pub fn coefficients(&self) -> &[f64] {
        &self.coefficients
    }

    /// All solutions, as `solve_complex` of the emitted solver returns them.
    ///
    /// # Errors
    /// As the emitted solver.
    pub fn solve_complex(&mut self) -> Result<Vec<Vec<Complex<f64>>>, SolveError> {
        let mut points = emitted::complex_solutions(self)?.to_vec();
        points.iter_mut().for_each(|point| self.solver.unscale(&self.exponents, point));
        Ok(points)
    }

    /// The points of all eigenpairs of one attempt, neither polished nor judged: those of
    /// eigenpairs that belong to no solution are among them, a solution known beforehand is not.
    ///
    /// # Errors
    /// Those of the elimination and of the eigenvalues.
    pub fn unpolished_points(&mut self) -> Result<Vec<Vec<Complex<f64>>>, SolveError> {
        let mut points = Vec::new();
        emitted::unpolished_points(self, |point| points.push(point.clone()))?;
        points.iter_mut().for_each(|point| self.solver.unscale(&self.exponents, point));
        Ok(points)
    }

    /// The relative residual of a point.
    pub fn residual<S: Scalar>(&self, point: &[S]) -> f64 {
        let negative: Vec<i16> = self.exponents.iter().map(|exponent| -exponent).collect();
        let mut point = point.to_vec();
        self.solver.unscale(&negative, &mut point);
        self.polish(&mut point, 0)
    }

    /// By which powers of two the unknowns exceed those of the problem as it was given.
    pub fn exponents(&self) -> &[i16] {
        &self.exponents
    }

    /// How often the template was eliminated: twice if there was a second attempt.
    pub fn attempts(&self) -> usize {
        self.attempts
    }

    fn precise_coefficients(&self) -> Vec<emitted::DoubleDouble> {
        self.solver.coefficients(&self.data)
    }

    fn eliminated<R: emitted::Real>(&self) -> Result<Vec<Vec<R>>, SolveError> {
        let InterpretedSolver { elimination, layout, has_precise_coefficients, .. } = self.solver;
        if !has_precise_coefficients {
            return elimination.solve::<R, f64>(layout.basis, &self.coefficients);
        }
        let coefficients = R::of::<Dynamic>(&self.coefficients, || self.solver.coefficients(&self.data));
        elimination.solve::<R, R>(layout.basis, &coefficients)
    }
}

impl SolverInstance for InterpretedInstance<'_> {
    type Basis = Dynamic;
    type Unknowns = Dynamic;
    type Values = Dynamic;
    type Solutions = Dynamic;

    fn sizes(&self) -> SizesOf<Self> {
        Sizes {
            basis: Dynamic(self.solver.layout.basis),
            unknowns: Dynamic(self.solver.unknowns),
            values: Dynamic(self.solver.layout.len()),
            solutions: Dynamic(self.solver.solutions),
        }
    }

    fn ratios(&self, unknown: usize) -> &[(u16, u16)] {
        &self.solver.ratios[unknown]
    }

    fn has_origin(&self) -> bool {
        self.solver.has_origin
    }

    fn loses_zeros(&self) -> bool {
        self.solver.zeros.lacks_pairs
    }

    fn misreads_zeros(&self) -> bool {
        self.solver.zeros.is_misread
    }

    fn action_value<S: Scalar>(&self, unknowns: &Vec<S>) -> Option<S> {
        let exponents = &self.solver.action_monomial;
        (!exponents.is_empty()).then(|| emitted::monomial_value(unknowns, exponents))
    }

    fn symmetries(&self) -> Option<emitted::Symmetries<'_>> {
        let symmetries = emitted::Symmetries { steps: &self.steps, images: &self.images };
        (!self.images.is_empty()).then_some(symmetries)
    }

    fn has_large_quotients(&self) -> bool {
        let [own, stated] = &self.solver.quotients;
        emitted::Quotients { own, stated }.are_large(|slot| self.coefficients[slot])
    }

    fn has_precise_coefficients(&self) -> bool {
        self.solver.has_precise_coefficients
    }

    fn memory(&self) -> Option<&emitted::Memory> {
        Some(&self.memory)
    }

    fn action_matrix<R: emitted::Real>(&mut self) -> Result<Vec<Vec<R>>, SolveError> {
        self.attempts += 1;
        let right = self.eliminated::<R>()?;
        let basis = Dynamic(self.solver.layout.basis);
        let read = Dynamic(self.solver.layout.read);
        self.read = emitted::solved_rows((read, basis), &self.solver.elimination.read, &right);
        Ok(emitted::action_matrix(basis, &self.solver.elimination.action, &right))
    }

    fn monomial_values<S: Scalar>(&self, value: S, vector: &Vec<S>) -> Vec<S> {
        let layout = &self.solver.layout;
        emitted::monomial_values(Dynamic(layout.len()), (value, vector), layout.has_image, &self.read)
    }

    fn recover<S: Scalar>(&self, x: &mut Vec<S>) {
        if let Some(block) = &self.solver.linear {
            let entries = block.rows.iter().flatten();
            let mut rows: Vec<S> = entries.map(|entry| sum(entry, &self.coefficients, x)).collect();
            let mut linear = vec![S::ZERO; block.unknowns.len()];
            emitted::least_squares(&mut rows, &mut linear);
            block.unknowns.iter().zip(linear).for_each(|(&unknown, value)| x[unknown] = value);
        }
        for recovery in &self.solver.recoveries {
            x[recovery.unknown] = sum(&recovery.terms, &self.coefficients, x);
        }
    }

    fn polish<S: Scalar>(&self, x: &mut Vec<S>, steps: usize) -> f64 {
        let tables = self.solver.equations.tables(self.solver.unknowns);
        let (sizes, coefficients) = (tables.polynomials(), || self.precise_coefficients());
        match &self.rows {
            Some(rows) => {
                let system = emitted::DenseSystem { sizes: tables.sizes, monomials: tables, rows };
                emitted::polish_precisely(x, sizes, &system, steps, coefficients)
            }
            None => emitted::polish_precisely(x, sizes, &tables.bind(&self.coefficients), steps, coefficients),
        }
    }

    fn error_bound<S: Scalar>(&self, x: &Vec<S>) -> f64 {
        let tables = self.solver.equations.tables(self.solver.unknowns);
        let (sizes, coefficients) = (tables.polynomials(), self.precise_coefficients());
        match &self.rows {
            Some(rows) => {
                let system = emitted::DenseSystem { sizes: tables.sizes, monomials: tables, rows };
                emitted::error_bound(x, sizes, &system, &coefficients)
            }
            None => emitted::error_bound(x, sizes, &tables.bind(&self.coefficients), &coefficients),
        }
    }

    fn family(&self) -> Option<emitted::Family<'_>> {
        let InterpretedSolver { program, equations, parameters, unknowns, .. } = self.solver;
        (!self.data.is_empty()).then(|| emitted::Family {
            data: &self.data,
            inputs: self.solver.inputs,
            parameters,
            program: program.view(&self.lists),
            counts: (program.values, program.results.len()),
            unknowns: *unknowns,
            chain: &equations.chain,
            ends: &equations.ends,
            terms: &equations.terms,
        })
    }

    fn move_to(&mut self, data: &[f64]) {
        emitted::join_into(&[data], &mut self.data);
        self.coefficients = self.solver.coefficients(&self.data);
        self.rows = self.solver.equations.rows(&self.coefficients);
    }

    fn is_admissible<S: Scalar>(&self, x: &Vec<S>) -> bool {
        let tables = self.solver.nonzero.tables(self.solver.unknowns);
        self.solver.nonzero.ends.is_empty() || tables.bind(&self.coefficients).exceeds(x, emitted::VANISHING)
    }
}

impl<'a> emitted::HiddenVariableSolver for InterpretedInstance<'a> {
    type Chains = &'a InterpretedChains;

    fn chains(&self) -> &'a InterpretedChains {
        // Without chains nobody asks.
        self.solver.chains.as_ref().unwrap_or(&interpreted_chains::NONE)
    }
}
