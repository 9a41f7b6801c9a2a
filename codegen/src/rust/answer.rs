//! The functions of an emitted file.

use crate::expr::ExprId;
use crate::program::Program;
use std::collections::BTreeMap;

/// Operations by kind.
pub(super) type Cost = BTreeMap<&'static str, usize>;

/// A function of the emitted file.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Answer {
    /// q', u' and the worst pivot.
    Rates,
    /// Kinetic and potential energy.
    Energy,
    /// All speeds, dependent ones included.
    Speeds,
    /// Requested outputs.
    Outputs,
    /// Newton's correction of the dependent coordinates.
    Projection,
    /// Power of the drive; a program that is not driven has none.
    Drive,
    /// The equations before the elimination; emitted only on request.
    Augmented,
}

impl Answer {
    /// Answers that need no mass.
    pub const KINEMATIC: [Self; 3] = [Self::Speeds, Self::Outputs, Self::Projection];

    /// Every answer of a complete file, in its order; [`Answer::Augmented`] is a form of its own.
    pub const ALL: [Self; 6] =
        [Self::Rates, Self::Energy, Self::Speeds, Self::Outputs, Self::Projection, Self::Drive];

    /// Those of [`Answer::ALL`] that a program has.
    #[must_use]
    pub fn of(program: &Program) -> Vec<Self> {
        Self::ALL.into_iter().filter(|&answer| answer != Self::Drive || program.drive.is_some()).collect()
    }

    /// Name of the emitted function and of the answer on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Rates => "rates",
            Self::Energy => "energy",
            Self::Speeds => "speeds",
            Self::Outputs => "outputs",
            Self::Projection => "projection",
            Self::Drive => "drive",
            Self::Augmented => "augmented",
        }
    }

    /// The results of the answer in the emitted function's order.
    #[must_use]
    pub fn roots(self, program: &Program) -> Vec<ExprId> {
        let second = |list: &[(String, ExprId)]| list.iter().map(|(_, e)| *e).collect();
        match self {
            Self::Rates => {
                let mut roots = program.forward_dynamics();
                roots.push(program.rates.worst_pivot);
                roots
            }
            Self::Energy => program.energy.to_vec(),
            Self::Speeds => second(&program.speeds),
            Self::Outputs => second(&program.outputs),
            Self::Projection => {
                let mut roots: Vec<_> = program.correction.iter().map(|(_, e)| *e).collect();
                roots.push(program.residual);
                roots
            }
            Self::Drive => program.drive.into_iter().collect(),
            Self::Augmented => program.augmented_roots(),
        }
    }

    /// What it gives, in a sentence.
    pub(super) fn doc(self) -> &'static str {
        match self {
            Self::Rates => {
                "Rates of the coordinates, of the independent speeds, and the worst pivot relative to nominal."
            }
            Self::Energy => "Kinetic and potential energy (J).",
            Self::Speeds => "All speeds in the order of `SPEED_NAMES`, dependent ones included.",
            Self::Outputs => "Requested outputs in the order of `OUTPUT_NAMES`.",
            Self::Projection => {
                "Newton's corrections of the coordinates `CORRECTED`, and the largest residual before them."
            }
            Self::Drive => "Power that what drives the mechanism puts in (W).",
            Self::Augmented => {
                "Mass matrix M, Jacobian J (row-major), forcing f and bias b of M y' - J' lambda = f, J y' = -b, y as in `UNKNOWN_NAMES`."
            }
        }
    }
}
