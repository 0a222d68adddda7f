//! Solutions of data at which a template is singular are followed from data nearby.

use eliminant::emitted::{
    Condition, Family, Fixed, FixedTables, Product, ProductSums, Program, Real, Sizes, SizesOf, SolverInstance, Tables,
    Term, complex_solutions, polish, real_solutions,
};
use eliminant::{Complex, Scalar, SecondAttempts, SolveError};

/// x^3 + a x^2 + b x + c = 0 with the action 1/x on the basis 1, x, x^2: the action matrix divides
/// by c, and there is none where a solution is 0.
struct Cubic {
    data: [f64; 3],
    coefficients: [f64; 4],
    second_attempts: SecondAttempts,
    /// The data to which the instance was moved.
    moves: Vec<[f64; 3]>,
}

const EQUATIONS: FixedTables<1, 1, 4> = Tables::new::<4>(
    &[
        Product { parent: 0, unknown: 0 },
        Product { parent: 0, unknown: 0 },
        Product { parent: 1, unknown: 0 },
        Product { parent: 2, unknown: 0 },
    ],
    &[4],
    &[
        Term { coefficient: 0, monomial: 3 },
        Term { coefficient: 1, monomial: 2 },
        Term { coefficient: 2, monomial: 1 },
        Term { coefficient: 3, monomial: 0 },
    ],
);

impl Cubic {
    fn new(data: [f64; 3]) -> Self {
        let [a, b, c] = data;
        Self { data, coefficients: [1.0, a, b, c], second_attempts: SecondAttempts::Always, moves: Vec::new() }
    }

    /// With the solution 0 and these two others, of their sum and product.
    fn through_zero(sum: f64, product: f64) -> Self {
        Self::new([-sum, product, 0.0])
    }
}

impl SolverInstance for Cubic {
    type Basis = Fixed<3>;
    type Unknowns = Fixed<1>;
    type Values = Fixed<3>;
    type Solutions = Fixed<3>;

    fn sizes(&self) -> SizesOf<Self> {
        Sizes::FIXED
    }

    fn ratios(&self, _: usize) -> &[(u16, u16)] {
        &[(0, 1), (1, 2)]
    }

    fn allows_second_attempt(&self) -> bool {
        self.second_attempts.allows(100)
    }

    fn action_matrix<R: Real>(&mut self) -> Result<[[R; 3]; 3], SolveError> {
        let [_, a, b, c] = self.coefficients;
        if c.abs() < 1e-12 {
            return Err(SolveError::Degenerate { block: 0 });
        }
        Ok([[-b / c, -a / c, -1.0 / c], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(|row| row.map(R::from_f64)))
    }

    fn monomial_values<S: Scalar>(&self, _: S, vector: &[S; 3]) -> [S; 3] {
        *vector
    }

    fn recover<S: Scalar>(&self, _: &mut [S; 1]) {}

    fn polish<S: Scalar>(&self, x: &mut [S; 1], steps: usize) -> f64 {
        polish(x, (Fixed, Fixed), &EQUATIONS.bind(&self.coefficients), steps)
    }

    fn is_admissible<S: Scalar>(&self, _: &[S; 1]) -> bool {
        true
    }

    fn family(&self) -> Option<Family<'_>> {
        Some(Family {
            data: &self.data,
            parameters: &[(Condition::Free, 3)],
            program: Program {
                constants: &[1.0],
                runs: &[],
                operands: &[],
                product_sums: ProductSums { sums: &[], products: &[], factors: &[], places: &[] },
                results: &[0, 1, 2, 3],
            },
            counts: (4, 4),
            unknowns: 1,
            chain: EQUATIONS.chain,
            ends: EQUATIONS.ends,
            terms: EQUATIONS.terms,
        })
    }

    fn move_to(&mut self, data: &[f64]) {
        let data: [f64; 3] = data.try_into().unwrap();
        let (second_attempts, moves) = (self.second_attempts, [self.moves.as_slice(), &[data]].concat());
        *self = Self { second_attempts, moves, ..Self::new(data) };
    }
}

fn real(instance: &mut Cubic) -> Result<Vec<f64>, SolveError> {
    let mut found: Vec<f64> = real_solutions(instance)?.iter().map(|[x]| *x).collect();
    found.sort_by(f64::total_cmp);
    Ok(found)
}

fn close(found: &[f64], expected: &[f64]) -> bool {
    found.len() == expected.len() && found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-14)
}

#[test]
fn real_solutions_are_found_where_the_template_is_singular() {
    for others in [[1.0, 2.0], [-0.5, 3.0], [-1.0, 1.0], [1e-2, 7.0]] {
        let mut instance = Cubic::through_zero(others[0] + others[1], others[0] * others[1]);
        let mut expected = [0.0, others[0], others[1]];
        expected.sort_by(f64::total_cmp);
        let found = real(&mut instance).unwrap();
        assert!(close(&found, &expected), "{found:?} {expected:?}");
        // It went to data nearby and came back.
        assert_eq!(instance.moves.len(), 2);
        assert_eq!(instance.moves[1], Cubic::through_zero(others[0] + others[1], others[0] * others[1]).data);
        assert_ne!(instance.moves[0], instance.moves[1]);
    }
}

#[test]
fn complex_solutions_are_found_and_told_from_real_ones() {
    // 0 and 1 +- 2 i.
    let all = complex_solutions(&mut Cubic::through_zero(2.0, 5.0)).unwrap();
    for expected in [Complex::new(0.0, 0.0), Complex::new(1.0, 2.0), Complex::new(1.0, -2.0)] {
        assert!(all.iter().any(|[x]| (x - expected).modulus() < 1e-14), "{expected}: {all:?}");
    }
    assert_eq!(all.len(), 3);
    assert!(close(&real(&mut Cubic::through_zero(2.0, 5.0)).unwrap(), &[0.0]));
}

#[test]
fn solutions_that_are_not_isolated_are_not_returned() {
    // 0 twice.
    assert!(close(&real(&mut Cubic::through_zero(3.0, 0.0)).unwrap(), &[3.0]));
    // 0 three times: nothing is left.
    assert_eq!(real(&mut Cubic::through_zero(0.0, 0.0)), Err(SolveError::Degenerate { block: 0 }));
}

#[test]
fn general_data_and_bounded_work_need_no_other_data() {
    let mut general = Cubic::new([-6.0, 11.0, -6.0]);
    assert!(close(&real(&mut general).unwrap(), &[1.0, 2.0, 3.0]));
    assert!(general.moves.is_empty());
    let mut bounded = Cubic { second_attempts: SecondAttempts::Never, ..Cubic::through_zero(3.0, 2.0) };
    assert_eq!(real(&mut bounded), Err(SolveError::Degenerate { block: 0 }));
    assert!(bounded.moves.is_empty());
}
