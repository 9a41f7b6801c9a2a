//! Triads: how each is turned against its parent, and which unit vectors are constant in several of them.

use crate::expr::{Dag, ExprId};
use crate::id::{IdVec, ids};
use crate::model::Axis;
use rustc_hash::FxHashMap as HashMap;
use std::collections::BTreeMap;

ids! {
    /// A right-handed triad of unit vectors: a frame, or a step of its successive rotations.
    TriadId,
}

impl TriadId {
    /// The inertial triad: the first that is pushed.
    pub const INERTIAL: Self = Self(0);
}

/// Three components.
pub type Components = [ExprId; 3];

/// An angular velocity along the axes of the rotated triad: per axis a sum of pairs (a, b), each meaning a times the
/// rate of b.
pub type Spin = [Vec<(ExprId, ExprId)>; 3];

/// How a triad is turned.
#[derive(Clone, Debug)]
pub enum Turn {
    /// The inertial triad.
    Inertial,
    /// A simple rotation of `parent` about its own axis.
    Simple {
        /// The triad turned.
        parent: TriadId,
        /// About this axis of it.
        axis: Axis,
        /// By this angle (rad).
        angle: ExprId,
    },
    /// Unit vectors given by their components in another triad: `rows[k]` is axis k.
    Directions {
        /// That triad.
        parent: TriadId,
        /// Axis k in its components.
        rows: [Components; 3],
        /// The angular velocity relative to `parent`, if a formula is known that is shorter than Kane's definition.
        spin: Option<Spin>,
    },
}

/// All triads of a model; the first is inertial.
#[derive(Clone, Debug, Default)]
pub struct Triads {
    pub(super) turns: IdVec<TriadId, Turn>,
    /// The triad, its parent, ... , the inertial one.
    pub(super) ancestors: IdVec<TriadId, Vec<TriadId>>,
    /// (triad, axis) -> where else that unit vector has constant components.
    pub(super) constants: BTreeMap<(TriadId, Axis), Vec<(TriadId, Components)>>,
    /// Scalar products of two terms computed so far: the velocities of many bodies share their leading terms.
    pub(super) products: HashMap<[(TriadId, Components); 2], ExprId>,
    /// Components of terms in other triads, as computed so far.
    pub(super) expressed: HashMap<(TriadId, Components, TriadId), Components>,
}

impl Triads {
    /// Adds a triad.
    pub fn push(&mut self, turn: Turn) -> TriadId {
        let parent = match turn {
            Turn::Inertial => None,
            Turn::Simple { parent, .. } | Turn::Directions { parent, .. } => Some(parent),
        };
        let triad = self.turns.push(turn);
        let mut ancestors = vec![triad];
        ancestors.extend(parent.iter().flat_map(|&parent| &self.ancestors[parent]));
        self.ancestors.push(ancestors);
        triad
    }

    /// How a triad is turned.
    #[must_use]
    pub fn turn(&self, triad: TriadId) -> &Turn {
        &self.turns[triad]
    }

    /// A triad fixed in `frame` by one constant rotation in which `axis` of `triad` is constant.
    #[must_use]
    pub fn aligned(&self, dag: &Dag, (triad, axis): (TriadId, Axis), frame: TriadId) -> Option<TriadId> {
        let is_fixed = |t: TriadId| match self.turns[t] {
            Turn::Simple { parent, angle, .. } => parent == frame && dag.is_constant(angle),
            _ => false,
        };
        let places = self.constants.get(&(triad, axis))?;
        places.iter().map(|(other, _)| *other).find(|&other| is_fixed(other))
    }

    /// Number of triads.
    #[must_use]
    pub fn len(&self) -> usize {
        self.turns.len()
    }

    /// None yet?
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.turns.is_empty()
    }

    /// Records that `axis` of `triad` has the constant `components` in `other` wherever the constraints hold.
    pub fn declare_constant(&mut self, triad: TriadId, axis: Axis, other: TriadId, components: Components) {
        self.constants.entry((triad, axis)).or_default().push((other, components));
        self.products.clear();
        self.expressed.clear();
    }

    /// The triads in which `axis` of `triad` has constant components, with these components.
    #[must_use]
    pub fn constants_of(&self, triad: TriadId, axis: Axis) -> &[(TriadId, Components)] {
        self.constants.get(&(triad, axis)).map_or(&[], Vec::as_slice)
    }
}
