//! Forces of springs and facets that form a grid: each node is read and written once, next to its neighbours.
//!
//! In: where the nodes of a grid stand in the lists of a body ([`Grid`]), positions. Out: the sums of forces that the
//! lists give, number for number: a node's terms are added in their order, left, right, below, above, then its four
//! cells; [`elastic`] has the forces of positions, [`volume`] the volume that gas needs, [`damping`] forces of speeds,
//! [`mean`] the means over a step; [`march`] takes the steps of a [`span`] by Verlet's method, [`conserve`] by the
//! energy-momentum method. Rows are computed side by side; a row wider than [`WIDTH`] goes in strips, whose borders are
//! computed twice. Where there is no spring or cell its force is 0.

pub mod conserve;
pub mod course;
pub mod damping;
pub mod elastic;
pub mod layout;
pub mod line;
pub mod march;
pub mod mean;
pub mod span;
mod strip;
pub mod volume;

pub use conserve::Conserve;
pub use course::Course;
pub use damping::DampingForces;
pub use elastic::ElasticForces;
pub use layout::{Family, Grid, Run, WIDTH, beside, pitch};
pub use line::{Corner, Line};
pub use march::March;
pub use mean::MeanForces;
pub use span::Span;
pub use volume::CellVolume;
