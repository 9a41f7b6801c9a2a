//! The energy ledger: kinetic and stored energy, dissipation, and the work of drives and regulators.
//!
//! In: a motion before and after a stage. Out: sums in J. Powers are integrated by the trapezoidal rule, so that the
//! remainder decreases as the square of the step; it is what the method itself adds or removes.

/// All energies (J).
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Ledger {
    /// Kinetic energy.
    pub kinetic: f64,
    /// Stored in the sheets, and in the plates below them.
    pub sheets: f64,
    /// Stored in the air.
    pub air: f64,
    /// Stored in tissue by pressure and, where friction holds, by shear.
    pub tissue: f64,
    /// Potential energy of weight and joints.
    pub body: f64,
    /// Dissipated in the sheets so far.
    pub lost_in_sheets: f64,
    /// Dissipated in tissue so far.
    pub lost_in_tissue: f64,
    /// Dissipated in joints so far.
    pub lost_in_joints: f64,
    /// Dissipated by slip so far.
    pub lost_by_friction: f64,
    /// Work of screws and regulators so far.
    pub driven: f64,
    /// Gained so far because contacts between sheets were found anew with other feet and normals.
    pub turned: f64,
    /// Total energy at the start.
    pub start: f64,
}

impl Ledger {
    /// Kinetic plus stored energy.
    #[must_use]
    pub fn energy(&self) -> f64 {
        self.kinetic + self.sheets + self.air + self.tissue + self.body
    }

    /// Energy dissipated so far.
    #[must_use]
    pub fn lost(&self) -> f64 {
        self.lost_in_sheets + self.lost_in_tissue + self.lost_in_joints + self.lost_by_friction
    }

    /// Energy that the method itself has created; negative if it has lost some.
    #[must_use]
    pub fn left_over(&self) -> f64 {
        self.energy() - self.start + self.lost() - self.driven - self.turned
    }
}
