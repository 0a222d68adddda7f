//! Solutions of data at which a template is singular are followed from data nearby.

use eliminant::emitted::{
    Condition, Family, Fixed, FixedTables, Product, ProductSums, Program, Real, Sizes, SizesOf, SolverInstance, Tables,
    Term, complex_solutions, polish, real_solutions,
};
use eliminant::{Complex, Scalar, SecondAttempts, SolveError};

/// x^3 + a x^2 + b x + c = 0 with the action 1/y on the basis 1, y, y^2, where y = x - 1:
///
/// ```text
///   f = y^3 + d y^2 + e y + g       1/y * [ 1  ]   [ -e/g  -d/g  -1/g ] [ 1  ]
///                                         [ y  ] = [  1     0     0   ] [ y  ]
///                                         [ y^2]   [  0     1     0   ] [ y^2]
/// ```
///
/// There is no action matrix where a solution is x = 1, and g = 0.
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

    /// With the solution 1 and two others, of that sum and product.
    fn through_one(sum: f64, product: f64) -> Self {
        Self::new([-sum - 1.0, product + sum, -product])
    }
}

impl SolverInstance for Cubic {
    type Basis = Fixed<3>;
    type Unknowns = Fixed<1>;
    type Values = Fixed<2>;
    type Solutions = Fixed<3>;

    fn sizes(&self) -> SizesOf<Self> {
        Sizes::FIXED
    }

    fn ratios(&self, _: usize) -> &[(u16, u16)] {
        &[(0, 1)]
    }

    fn allows_second_attempt(&self) -> bool {
        self.second_attempts.allows(100)
    }

    fn action_matrix<R: Real>(&mut self) -> Result<[[R; 3]; 3], SolveError> {
        let [_, a, b, c] = self.coefficients;
        let [d, e, g] = [a + 3.0, 2.0 * a + b + 3.0, 1.0 + a + b + c];
        if g.abs() < 1e-12 {
            return Err(SolveError::Degenerate { block: 0 });
        }
        Ok([[-e / g, -d / g, -1.0 / g], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(|row| row.map(R::from_f64)))
    }

    fn monomial_values<S: Scalar>(&self, _: S, vector: &[S; 3]) -> [S; 2] {
        [vector[0], vector[0] + vector[1]]
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
            inputs: 3,
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

/// The condition of the roots here is below 100.
const ROUNDING: f64 = 1e-13;

fn close(found: &[f64], expected: &[f64]) -> bool {
    found.len() == expected.len() && found.iter().zip(expected).all(|(a, b)| (a - b).abs() < ROUNDING)
}

#[test]
fn real_solutions_are_found_where_the_template_is_singular() {
    for others in [[-1.0, 2.0], [-0.5, 3.0], [-1.0, 0.5], [1e-2, 7.0]] {
        let instance = || Cubic::through_one(others[0] + others[1], others[0] * others[1]);
        let mut moved = instance();
        let mut expected = [1.0, others[0], others[1]];
        expected.sort_by(f64::total_cmp);
        let found = real(&mut moved).unwrap();
        assert!(close(&found, &expected), "{found:?} {expected:?}");
        // It went to data nearby and came back.
        assert_eq!((moved.moves.len(), moved.moves[1]), (2, instance().data));
        assert_ne!(moved.moves[0], moved.moves[1]);
    }
}

#[test]
fn complex_solutions_are_found_and_told_from_real_ones() {
    // 1 and 3 +- 2 i.
    let all = complex_solutions(&mut Cubic::through_one(6.0, 13.0)).unwrap();
    for expected in [Complex::new(1.0, 0.0), Complex::new(3.0, 2.0), Complex::new(3.0, -2.0)] {
        assert!(all.iter().any(|[x]| (x - expected).modulus() < ROUNDING), "{expected}: {all:?}");
    }
    assert_eq!(all.len(), 3);
    assert!(close(&real(&mut Cubic::through_one(6.0, 13.0)).unwrap(), &[1.0]));
}

#[test]
fn solutions_that_are_not_isolated_are_not_returned() {
    // 1 twice.
    assert!(close(&real(&mut Cubic::through_one(4.0, 3.0)).unwrap(), &[3.0]));
    // 1 three times: nothing is left.
    assert_eq!(real(&mut Cubic::through_one(2.0, 1.0)), Err(SolveError::Degenerate { block: 0 }));
}

#[test]
fn general_data_and_bounded_work_need_no_other_data() {
    // 2, 3 and 4.
    let mut general = Cubic::new([-9.0, 26.0, -24.0]);
    assert!(close(&real(&mut general).unwrap(), &[2.0, 3.0, 4.0]));
    assert!(general.moves.is_empty());
    let mut bounded = Cubic { second_attempts: SecondAttempts::Never, ..Cubic::through_one(5.0, 6.0) };
    assert_eq!(real(&mut bounded), Err(SolveError::Degenerate { block: 0 }));
    assert!(bounded.moves.is_empty());
}
