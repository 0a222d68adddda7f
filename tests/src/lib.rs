//! Every emitted solver under one signature, so that a test can run over all of them, and instances
//! whose solutions are known.

pub mod bounds;
pub mod case;
pub mod catalogue_page;
pub mod comparison;
pub mod equations;
pub mod families;
pub mod fate;
pub mod ground_truth;
pub mod histograms;
pub mod judge;
pub mod measure;
pub mod published;
pub mod source;
pub mod stack;
pub mod statistics;

pub use case::{Case, Returned, cases, templates_folder};
