//! Where the energy goes: what moves and what is stored, what is lost, what drives and regulators give.
//!
//! In: a motion before and after a stage. Out: sums in J. Powers are taken by the trapezoid rule, so that what is left over
//! falls as the square of the step, and is what the method itself adds or loses.

/// All energy (J).
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Ledger {
    /// Of everything that moves.
    pub kinetic: f64,
    /// Of the sheets, and of the plates below them.
    pub sheets: f64,
    /// Of the air.
    pub air: f64,
    /// Of pressed tissue, and along its surface where friction holds.
    pub tissue: f64,
    /// Of weight and joints.
    pub body: f64,
    /// Lost in the sheets so far.
    pub lost_in_sheets: f64,
    /// Lost in tissue so far.
    pub lost_in_tissue: f64,
    /// Lost in joints so far.
    pub lost_in_joints: f64,
    /// Lost by slip so far.
    pub lost_by_friction: f64,
    /// Given by screws and regulators so far.
    pub driven: f64,
    /// Given by meetings of neighbours' sheets whose feet and normals went along, so far.
    pub turned: f64,
    /// All energy at the start.
    pub start: f64,
}

impl Ledger {
    /// Kinetic and stored.
    #[must_use]
    pub fn energy(&self) -> f64 {
        self.kinetic + self.sheets + self.air + self.tissue + self.body
    }

    /// Lost so far.
    #[must_use]
    pub fn lost(&self) -> f64 {
        self.lost_in_sheets + self.lost_in_tissue + self.lost_in_joints + self.lost_by_friction
    }

    /// What the method has made, or lost where below 0.
    #[must_use]
    pub fn left_over(&self) -> f64 {
        self.energy() - self.start + self.lost() - self.driven - self.turned
    }
}
