//! Forces of springs and facets that form a grid: each node is read and written once, next to its neighbours.
//!
//! In: the layout of a grid in the lists of a body ([`Grid`]), positions. Out: the sums of forces that the lists give,
//! bit for bit: a node's terms are added in their order, left, right, below, above, then its four cells. [`weave`]
//! computes position-dependent forces, [`damp`] speed-dependent ones, [`mean`] means over a step. The columns of a row
//! are computed side by side; a row wider than [`WIDTH`] is cut into strips, whose borders are computed twice. Missing
//! springs and cells have force 0.

pub mod damp;
pub mod layout;
pub mod mean;
mod strip;
pub mod weave;

pub use damp::Damp;
pub use layout::{Family, Grid, Run, WIDTH, beside, pitch};
pub use mean::Mean;
pub use weave::Weave;
