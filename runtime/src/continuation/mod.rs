//! Solutions of data at which a template stands for nothing.
//!
//! A template is right for general data. It has a chart: its action monomial must be finite, and
//! some minors must not vanish. On data of structure they do vanish, although the solutions are as
//! good as any others: a component of a rotation is 0 for a camera that moves in a plane, say. The
//! solutions of such data are the ends of paths that begin at general data nearby (coefficient
//! parameter continuation: Morgan, Sommese, "Coefficient-parameter polynomial continuation", Appl.
//! Math. Comput. 29, 1989; Sommese, Wampler, "The numerical solution of systems of polynomials",
//! 2005, theorem 7.1.1):
//!
//! ```text
//!   data       d(1) general, real --- complex path ---> d(0) as given
//!               |  template                              ^
//!               v                                        |
//!   solutions  x(1), all of them  --- Newton ---------> x(0)
//! ```
//!
//! The path is complex, because real ones meet data with double solutions, where paths cross.
//! Complex ones do not, with probability one. Each isolated solution of the given data is the end
//! of a path. Paths may also end at infinity, or on solutions that fill curves; these are dropped.
//!
//! [`family`] is what a solver states about its problem, `path` the path of the data, `member` the
//! equations for complex data, and `track` follows the solutions. The last three take memory from
//! the heap, so that only the feature `alloc` has them.

pub(crate) mod family;
#[cfg(feature = "alloc")]
mod member;
#[cfg(feature = "alloc")]
pub(crate) mod path;
#[cfg(feature = "alloc")]
pub(crate) mod track;
