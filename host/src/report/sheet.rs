//! Cost sheets: what a subject asks for and what that costs, beside the same subject with everything on.
//!
//! Everything of a scene: ground, friction, dampers, air, gas where there are facets, at values that move
//! nothing, and the energy ledger. Everything of a mechanism: every parameter tunable, and energies, all
//! speeds and outputs after each step. The ratio is what is saved by modelling only what is asked for.

/// How a subject's image differs from what its file asks for.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Variant {
    /// Changes `key=value`.
    pub set: Vec<String>,
    /// Of a mechanism: every parameter tunable, every answer in each step.
    pub everything: bool,
}

/// What a step costs.
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
    /// What was left out.
    pub left_out: String,
    /// As asked, and with everything.
    pub costs: [Cost; 2],
    /// What turns everything on.
    pub everything: Variant,
}
