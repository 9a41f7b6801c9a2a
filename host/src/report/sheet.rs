//! Cost sheets: the cost of a subject as asked for, compared with the same subject with everything turned on.
//!
//! Everything for a scene: ground, friction, dampers, air, gas if it has facets, at values that do not affect the
//! motion, and the energy ledger. Everything for a mechanism: every parameter tunable, and energies, all speeds and
//! outputs after each step. The ratio is what is saved by modelling only what is asked for.

/// Changes to a subject's image relative to what its file asks for.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Variant {
    /// Settings `key=value`.
    pub set: Vec<String>,
    /// For a mechanism: every parameter tunable, every answer in each step.
    pub everything: bool,
}

/// Cost of a step.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Cost {
    /// Operations.
    pub operations: f64,
    /// Computing time (ns).
    pub nanoseconds: f64,
}

/// A subject's sheet.
#[derive(Clone, PartialEq, Debug)]
pub struct Sheet {
    /// What was asked for.
    pub asked: String,
    /// What was not asked for.
    pub left_out: String,
    /// Costs as asked for, and with everything.
    pub costs: [Cost; 2],
    /// The variant with everything turned on.
    pub everything: Variant,
}
