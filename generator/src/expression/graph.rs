//! The graph of coefficient expressions, in which each value is one node.

use std::collections::{BTreeMap, HashMap};

use super::arithmetic::Arithmetic;
use super::derivation::{Derivation, DerivationKind};
use super::product_sum::{Product, ProductSum};
use super::rational::Rational;
use crate::algebra::{PRIMES, PrimeField};

/// A node of an [`ExpressionGraph`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ExpressionId(u32);

impl ExpressionId {
    /// Position among the nodes of its graph.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// One operation. Operands always have smaller ids.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Expression {
    /// A constant.
    Constant(Rational),
    /// The scalar number `.0` of the flattened data (see [`crate::problem::DataParameter`]), or of
    /// the data that are derived from them, which follow.
    Input(u32),
    /// a + b
    Add(ExpressionId, ExpressionId),
    /// a - b
    Subtract(ExpressionId, ExpressionId),
    /// a * b
    Multiply(ExpressionId, ExpressionId),
    /// a / b; the divisor depends on the data (only presolve makes these).
    Divide(ExpressionId, ExpressionId),
    /// -a
    Negate(ExpressionId),
    /// A coefficient of one of the sums of products of polynomials
    /// ([`ExpressionGraph::product_sums`]).
    Coefficient {
        /// The number of the sum.
        sum: u32,
        /// The number of the coefficient in the sum.
        at: u32,
    },
    /// A coordinate of the solution, by its number. Only results depend on it.
    Unknown(u32),
    /// The square root of a value that depends on the solution.
    Root(ExpressionId),
}

pub(super) type Fingerprint = [u32; 2];

/// What has no value for some data.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum NoValue {
    /// A divisor is zero.
    Quotient,
    /// An input is missing.
    Input,
    /// The derivation of this number: a matrix has lost rank, or there is no square root.
    Derivation(usize),
}

/// The fields in which fingerprints are taken. Searches and checks use other primes first.
pub(crate) const FINGERPRINT_FIELDS: [PrimeField; 2] = [PrimeField::new(PRIMES[4]), PrimeField::new(PRIMES[5])];

/// Expressions in the data, each value once. Nodes are in topological order: operands before their
/// users.
///
/// ```text
///   node            0    1    2        3        4              5
///   expression      0    1    input 0  input 1  2 * 3          4 - 1
///   fingerprints    the values modulo two primes at one point each: equal ones are one node
/// ```
#[derive(Clone, Debug)]
pub struct ExpressionGraph {
    nodes: Vec<Expression>,
    product_sums: Vec<ProductSum<ExpressionId>>,
    derivations: Vec<Derivation<ExpressionId>>,
    /// The nodes of the inputs.
    inputs: Vec<ExpressionId>,
    fingerprints: Vec<Fingerprint>,
    /// Which nodes depend on the solution.
    of_solution: Vec<bool>,
    by_fingerprint: HashMap<Fingerprint, ExpressionId>,
    names: BTreeMap<ExpressionId, String>,
}

impl ExpressionGraph {
    /// The graph of the constants 0 and 1 and the inputs. `points[k]` holds the values of all
    /// inputs at the k-th fingerprint point, see [`crate::problem::instance::fingerprint_points`].
    pub fn new(points: &[Vec<u32>; 2]) -> Self {
        let mut graph = Self {
            nodes: Vec::new(),
            product_sums: Vec::new(),
            derivations: Vec::new(),
            inputs: Vec::new(),
            fingerprints: Vec::new(),
            of_solution: Vec::new(),
            by_fingerprint: HashMap::new(),
            names: BTreeMap::new(),
        };
        graph.push(Expression::Constant(Rational::ZERO), [0, 0]);
        graph.push(Expression::Constant(Rational::ONE), [1, 1]);
        for (&a, &b) in points[0].iter().zip(&points[1]) {
            graph.push_input([a, b]);
        }
        graph
    }

    fn push_input(&mut self, fingerprint: Fingerprint) -> ExpressionId {
        let id = self.push_unshared(Expression::Input(self.inputs.len() as u32), fingerprint);
        self.inputs.push(id);
        id
    }

    /// The constant 0.
    pub const ZERO: ExpressionId = ExpressionId(0);
    /// The constant 1.
    pub const ONE: ExpressionId = ExpressionId(1);

    /// The node of the input with flat index `input`; equal inputs (symmetric data) are one node.
    pub fn input(&self, input: usize) -> ExpressionId {
        let own = self.inputs[input];
        self.by_fingerprint.get(&self.fingerprints[own.index()]).copied().unwrap_or(own)
    }

    /// Number of inputs, those that are derived included.
    pub fn input_count(&self) -> usize {
        self.inputs.len()
    }

    /// The data that are derived from data, each from inputs before it.
    pub fn derivations(&self) -> &[Derivation<ExpressionId>] {
        &self.derivations
    }

    /// Derives data from data. The results are those of an earlier derivation if it is the same;
    /// `None` if a matrix has lost rank for all data.
    pub fn derive(&mut self, kind: DerivationKind, operands: &[ExpressionId]) -> Option<Vec<ExpressionId>> {
        let known = self.derivations.iter().find(|known| known.kind == kind && known.operands == operands);
        if let Some(known) = known {
            return Some(known.inputs().map(|input| self.input(input)).collect());
        }
        let [first, second] = [0, 1].map(|k| {
            let operands: Vec<u32> = operands.iter().map(|id| self.fingerprints[id.index()][k]).collect();
            FINGERPRINT_FIELDS[k].derive(kind, &operands, 0.0)
        });
        let (first, second) = (first?, second?);
        self.derivations.push(Derivation { kind, operands: operands.to_vec(), first_input: self.inputs.len() });
        Some(first.into_iter().zip(second).map(|(a, b)| self.push_input([a, b])).collect())
    }

    /// All nodes, operands before their users.
    pub fn nodes(&self) -> &[Expression] {
        &self.nodes
    }

    /// Sums of products of polynomials, by their coefficients. All operands of a sum have smaller
    /// ids than its coefficients.
    pub fn product_sums(&self) -> &[ProductSum<ExpressionId>] {
        &self.product_sums
    }

    /// The node at this position.
    pub fn id(&self, position: usize) -> ExpressionId {
        ExpressionId(position as u32)
    }

    /// The expression of a node.
    pub fn node(&self, id: ExpressionId) -> Expression {
        self.nodes[id.index()]
    }

    /// Remembers what people call a computed value. Constants and inputs need no name, and the
    /// first name stays.
    pub fn name(&mut self, id: ExpressionId, name: &str) {
        if !matches!(self.node(id), Expression::Constant(_) | Expression::Input(_)) {
            self.names.entry(id).or_insert_with(|| name.to_owned());
        }
    }

    /// All values with names, in order.
    pub fn names(&self) -> impl Iterator<Item = (ExpressionId, &str)> {
        self.names.iter().map(|(&id, name)| (id, name.as_str()))
    }

    /// The value of a constant node.
    pub fn as_constant(&self, id: ExpressionId) -> Option<Rational> {
        match self.node(id) {
            Expression::Constant(value) => Some(value),
            _ => None,
        }
    }

    /// A constant.
    pub fn constant(&mut self, value: Rational) -> ExpressionId {
        let image = FINGERPRINT_FIELDS.map(|field| field.constant(value));
        match image {
            [Some(a), Some(b)] => self.push(Expression::Constant(value), [a, b]),
            // A fingerprint prime divides the denominator: such a constant is not shared.
            _ => self.push_unshared(Expression::Constant(value), [0, 0]),
        }
    }

    /// a + b
    pub fn add(&mut self, a: ExpressionId, b: ExpressionId) -> ExpressionId {
        if let (Some(x), Some(y)) = (self.as_constant(a), self.as_constant(b))
            && let Some(sum) = x.checked_add(y)
        {
            return self.constant(sum);
        }
        let fingerprint = self.combine(a, b, PrimeField::add);
        // a + (-b) is a - b, one operation instead of two.
        match (self.node(a), self.node(b)) {
            (_, Expression::Negate(c)) => self.push(Expression::Subtract(a, c), fingerprint),
            (Expression::Negate(c), _) => self.push(Expression::Subtract(b, c), fingerprint),
            _ => self.push(Expression::Add(a.min(b), a.max(b)), fingerprint),
        }
    }

    /// a - b
    pub fn sub(&mut self, a: ExpressionId, b: ExpressionId) -> ExpressionId {
        if a == Self::ZERO {
            return self.neg(b);
        }
        if let (Some(x), Some(y)) = (self.as_constant(a), self.as_constant(b))
            && let Some(difference) = y.checked_neg().and_then(|y| x.checked_add(y))
        {
            return self.constant(difference);
        }
        let fingerprint = self.combine(a, b, PrimeField::sub);
        match self.node(b) {
            Expression::Negate(c) => self.push(Expression::Add(a.min(c), a.max(c)), fingerprint),
            _ => self.push(Expression::Subtract(a, b), fingerprint),
        }
    }

    /// a b
    pub fn mul(&mut self, a: ExpressionId, b: ExpressionId) -> ExpressionId {
        if let (Some(x), Some(y)) = (self.as_constant(a), self.as_constant(b))
            && let Some(product) = x.checked_mul(y)
        {
            return self.constant(product);
        }
        // Signs move outwards: (-a) b = -(a b).
        if let Expression::Negate(c) = self.node(a) {
            let product = self.mul(c, b);
            return self.neg(product);
        }
        if let Expression::Negate(c) = self.node(b) {
            let product = self.mul(a, c);
            return self.neg(product);
        }
        let minus_one = Rational::integer(-1);
        if self.as_constant(a) == Some(minus_one) {
            return self.neg(b);
        }
        if self.as_constant(b) == Some(minus_one) {
            return self.neg(a);
        }
        let fingerprint = self.combine(a, b, PrimeField::mul);
        self.push(Expression::Multiply(a.min(b), a.max(b)), fingerprint)
    }

    /// a / b, or `None` if b is zero for all data.
    pub fn div(&mut self, a: ExpressionId, b: ExpressionId) -> Option<ExpressionId> {
        let inverses = [0, 1].map(|k| FINGERPRINT_FIELDS[k].inverse(self.fingerprints[b.index()][k]));
        let [Some(x), Some(y)] = inverses else { return None };
        if let Some(divisor) = self.as_constant(b) {
            let reciprocal = Rational::ONE.checked_div(divisor)?;
            let reciprocal = self.constant(reciprocal);
            return Some(self.mul(a, reciprocal));
        }
        let fingerprint = [0, 1].map(|k| {
            let numerator = self.fingerprints[a.index()][k];
            FINGERPRINT_FIELDS[k].mul(numerator, [x, y][k])
        });
        Some(self.push(Expression::Divide(a, b), fingerprint))
    }

    /// -a
    pub fn neg(&mut self, a: ExpressionId) -> ExpressionId {
        match self.node(a) {
            Expression::Negate(b) => return b,
            Expression::Constant(value) => {
                if let Some(negative) = value.checked_neg() {
                    return self.constant(negative);
                }
            }
            _ => {}
        }
        let fingerprint = self.negated(self.fingerprints[a.index()]);
        self.push(Expression::Negate(a), fingerprint)
    }

    /// Whether a value depends on the solution.
    pub fn is_of_solution(&self, id: ExpressionId) -> bool {
        self.of_solution[id.index()]
    }

    /// The same graph, in which no node that depends on the solution is found again: its values are
    /// computed anew, in another way.
    pub(crate) fn without_solution(&self) -> Self {
        let mut graph = self.clone();
        graph.by_fingerprint.retain(|_, id| !self.is_of_solution(*id));
        graph
    }

    fn depends_on_solution(&self, node: Expression) -> bool {
        matches!(node, Expression::Unknown(_)) || self.operands(node).any(|operand| self.is_of_solution(operand))
    }

    /// Whether the value is zero for all data (on their variety).
    pub fn is_zero(&self, id: ExpressionId) -> bool {
        self.fingerprints[id.index()] == [0, 0]
    }

    /// The values at the two fingerprint points. They identify an expression, however it was
    /// written.
    pub fn fingerprint(&self, id: ExpressionId) -> [u32; 2] {
        self.fingerprints[id.index()]
    }

    /// Whether an input is among the nodes that are needed.
    pub(crate) fn is_input_among(&self, needed: &[bool], input: usize) -> bool {
        needed[self.inputs[input].index()]
    }

    /// The values of all nodes for the given values of the inputs; `None` if a divisor is zero.
    /// What depends on a solution counts as 0. Derived data may be missing at the end of the
    /// inputs: they are then derived, and `None` if a matrix has lost rank.
    pub fn evaluate<A: Arithmetic>(&self, arithmetic: A, inputs: &[A::Value]) -> Option<Vec<A::Value>> {
        self.try_evaluate(arithmetic, inputs).ok()
    }

    /// Like [`ExpressionGraph::evaluate`]; the error says what has no value.
    pub(crate) fn try_evaluate<A: Arithmetic>(&self, f: A, inputs: &[A::Value]) -> Result<Vec<A::Value>, NoValue> {
        let mut values: Vec<A::Value> = Vec::with_capacity(self.nodes.len());
        let mut sums: Vec<Vec<A::Value>> = vec![Vec::new(); self.product_sums.len()];
        let mut inputs = inputs.to_vec();
        for (node, &is_of_solution) in self.nodes.iter().zip(&self.of_solution) {
            if is_of_solution {
                values.push(f.zero());
                continue;
            }
            let at = |id: &ExpressionId| values[id.index()];
            let value = match node {
                Expression::Constant(value) => f.constant(*value).ok_or(NoValue::Quotient)?,
                Expression::Input(input) => {
                    if *input as usize == inputs.len() {
                        inputs.extend(self.derived(f, inputs.len(), at)?);
                    }
                    *inputs.get(*input as usize).ok_or(NoValue::Input)?
                }
                Expression::Add(a, b) => f.add(at(a), at(b)),
                Expression::Subtract(a, b) => f.sub(at(a), at(b)),
                Expression::Multiply(a, b) => f.mul(at(a), at(b)),
                Expression::Divide(a, b) => f.div(at(a), at(b)).ok_or(NoValue::Quotient)?,
                Expression::Negate(a) => f.neg(at(a)),
                Expression::Coefficient { sum, at: coefficient } => {
                    let known = &mut sums[*sum as usize];
                    if known.is_empty() {
                        *known = self.product_sums[*sum as usize].evaluate(f, |id| at(&id));
                    }
                    known[*coefficient as usize]
                }
                // They depend on a solution.
                Expression::Unknown(_) | Expression::Root(_) => f.zero(),
            };
            values.push(value);
        }
        Ok(values)
    }

    /// The results of the derivation whose first result is this input. `at` has the values of nodes
    /// before it.
    fn derived<A: Arithmetic>(
        &self,
        f: A,
        input: usize,
        at: impl Fn(&ExpressionId) -> A::Value,
    ) -> Result<Vec<A::Value>, NoValue> {
        let found = self.derivations.iter().position(|derivation| derivation.first_input == input);
        let (number, derivation) = found.map(|at| (at, &self.derivations[at])).ok_or(NoValue::Input)?;
        let operands: Vec<A::Value> = derivation.operands.iter().map(at).collect();
        f.derive(derivation.kind, &operands, 0.0).ok_or(NoValue::Derivation(number))
    }

    /// The values of all inputs, from those that are given; `None` as for
    /// [`ExpressionGraph::evaluate`].
    pub fn all_inputs<A: Arithmetic>(&self, arithmetic: A, given: &[A::Value]) -> Option<Vec<A::Value>> {
        let values = self.evaluate(arithmetic, given)?;
        Some(self.inputs.iter().map(|id| values[id.index()]).collect())
    }

    /// Takes fingerprints at other data: `given` are the values of the inputs that are given, over
    /// field k of [`FINGERPRINT_FIELDS`]. Returns false, and changes nothing, where a value does
    /// not exist there.
    pub(crate) fn move_fingerprints(&mut self, k: usize, given: &[u32]) -> bool {
        let Some(values) = self.evaluate(FINGERPRINT_FIELDS[k], given) else { return false };
        let mut moved = self.fingerprints.clone();
        for (at, value) in values.into_iter().enumerate() {
            match self.of_solution[at] {
                false => moved[at][k] = value,
                true => match self.fingerprint_of_solution(at, &moved) {
                    Some(fingerprint) => moved[at] = fingerprint,
                    None => return false,
                },
            }
        }
        self.fingerprints = moved;
        self.by_fingerprint.clear();
        for (&fingerprint, id) in self.fingerprints.iter().zip(0..) {
            self.by_fingerprint.entry(fingerprint).or_insert(ExpressionId(id));
        }
        true
    }

    /// The fingerprints over field k of the inputs that are given.
    pub(crate) fn given_fingerprints(&self, k: usize, given: usize) -> Vec<u32> {
        self.inputs[..given].iter().map(|id| self.fingerprints[id.index()][k]).collect()
    }

    /// Which of the first inputs, up to this number, these values depend on.
    pub(crate) fn given_inputs_of(&self, used: &[ExpressionId], given: usize) -> Vec<bool> {
        let needed = self.needed_by_way_of_derivations(used, |_| true);
        self.inputs[..given].iter().map(|id| needed[id.index()]).collect()
    }

    fn combine(&self, a: ExpressionId, b: ExpressionId, op: fn(PrimeField, u32, u32) -> u32) -> Fingerprint {
        [0, 1].map(|k| op(FINGERPRINT_FIELDS[k], self.fingerprints[a.index()][k], self.fingerprints[b.index()][k]))
    }

    fn negated(&self, fingerprint: Fingerprint) -> Fingerprint {
        [0, 1].map(|k| FINGERPRINT_FIELDS[k].neg(fingerprint[k]))
    }

    /// The node with this value: an old one, the negative of an old one, or a new one.
    pub(super) fn push(&mut self, node: Expression, fingerprint: Fingerprint) -> ExpressionId {
        match self.by_fingerprint.get(&fingerprint) {
            // One that was written with a solution has no value without it.
            Some(&shared) if self.is_of_solution(shared) && !self.depends_on_solution(node) => {}
            Some(&shared) => return shared,
            None => {}
        }
        let negation = matches!(node, Expression::Negate(_) | Expression::Constant(_));
        let node = match self.by_fingerprint.get(&self.negated(fingerprint)) {
            Some(&opposite) if !negation => Expression::Negate(opposite),
            _ => node,
        };
        let id = self.push_unshared(node, fingerprint);
        self.by_fingerprint.insert(fingerprint, id);
        id
    }

    fn push_unshared(&mut self, node: Expression, fingerprint: Fingerprint) -> ExpressionId {
        let id = ExpressionId(self.nodes.len() as u32);
        self.of_solution.push(self.depends_on_solution(node));
        self.nodes.push(node);
        self.fingerprints.push(fingerprint);
        if let Expression::Input(_) = node {
            self.by_fingerprint.entry(fingerprint).or_insert(id);
        }
        id
    }

    /// The coefficients of a new sum. Those that depend on constants only become constants.
    pub(super) fn push_sum(&mut self, sum: ProductSum<ExpressionId>) -> Vec<ExpressionId> {
        let is_constant = |id: ExpressionId| self.as_constant(id).is_some();
        let mut depends = vec![false; sum.length];
        for (place, a, b) in sum.products.iter().flat_map(Product::pairs) {
            depends[place] |= !(is_constant(a) && is_constant(b));
        }
        let [first, second] =
            [0, 1].map(|k| sum.evaluate(FINGERPRINT_FIELDS[k], |id| self.fingerprints[id.index()][k]));
        let own = self.product_sums.len() as u32;
        // One pass over all products for all constants: one pass for each would be quadratic.
        let mut constants: Vec<Vec<(bool, ExpressionId, ExpressionId)>> = vec![Vec::new(); sum.length];
        for product in &sum.products {
            for (place, a, b) in product.pairs().filter(|&(place, ..)| !depends[place]) {
                constants[place].push((product.negative, a, b));
            }
        }
        let coefficients = (0..sum.length).map(|at| match depends[at] {
            true => self.push(Expression::Coefficient { sum: own, at: at as u32 }, [first[at], second[at]]),
            false => constants[at].iter().fold(Self::ZERO, |total, &(negative, a, b)| {
                let term = self.mul(a, b);
                if negative { self.sub(total, term) } else { self.add(total, term) }
            }),
        });
        let coefficients = coefficients.collect();
        self.product_sums.push(sum);
        coefficients
    }
}
