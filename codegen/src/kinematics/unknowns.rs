//! The unknowns of the velocity level: speeds, components of lifted twists, and the clock.

use crate::expr::ExprId;
use crate::id::{Id, IdVec, ids};
use crate::model::SpeedId;
use std::ops::Index;

ids! {
    /// An unknown of the velocity level: a speed, a component of a lifted twist, or the clock.
    UnknownId,
}

/// An unknown of the velocity level.
#[derive(Clone, Debug)]
pub struct Unknown {
    /// Its name in the generated code.
    pub name: String,
    /// The symbol that stands for its value until the constraints are solved.
    pub value: ExprId,
    /// Its kind.
    pub kind: UnknownKind,
}

/// The kinds of unknowns.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum UnknownKind {
    /// An independent speed, known in the elimination.
    Independent(SpeedId),
    /// A dependent speed.
    Dependent(SpeedId),
    /// A component of the velocity or angular velocity of a body that closes a loop.
    Lifted,
    /// Time as a coordinate: its rate is 1, its partial velocities are the parts of velocities without speeds (Kane's
    /// v_t).
    Clock,
}

/// All unknowns: first the speeds in the model's order, then the clock if the model is driven, then the lifted ones.
#[derive(Clone, Debug, Default)]
pub struct Unknowns {
    all: IdVec<UnknownId, Unknown>,
    clock: Option<UnknownId>,
}

impl Unknowns {
    /// Adds one.
    pub fn push(&mut self, unknown: Unknown) -> UnknownId {
        let is_clock = unknown.kind == UnknownKind::Clock;
        let id = self.all.push(unknown);
        if is_clock {
            self.clock = Some(id);
        }
        id
    }

    /// Number of unknowns.
    #[must_use]
    pub fn len(&self) -> usize {
        self.all.len()
    }

    /// None?
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.all.is_empty()
    }

    /// The unknown whose value is 1, if the model is driven.
    #[must_use]
    pub fn clock(&self) -> Option<UnknownId> {
        self.clock
    }

    /// The unknown that belongs to a speed.
    #[must_use]
    pub fn of(&self, speed: SpeedId) -> UnknownId {
        UnknownId::from_index(speed.index())
    }

    /// The independent speeds.
    #[must_use]
    pub fn independent(&self) -> Vec<UnknownId> {
        self.those(|kind| matches!(kind, UnknownKind::Independent(_)))
    }

    /// The unknowns that the constraints determine: dependent speeds and lifted twists.
    #[must_use]
    pub fn dependent(&self) -> Vec<UnknownId> {
        self.those(|kind| matches!(kind, UnknownKind::Dependent(_) | UnknownKind::Lifted))
    }

    /// All unknowns but the clock.
    #[must_use]
    pub fn moving(&self) -> Vec<UnknownId> {
        self.those(|kind| kind != UnknownKind::Clock)
    }

    /// Is every unknown an independent speed?
    #[must_use]
    pub fn are_independent(&self) -> bool {
        self.iter().all(|unknown| matches!(unknown.kind, UnknownKind::Independent(_)))
    }

    /// Is the speed independent? Redundant speeds count as independent.
    #[must_use]
    pub fn is_independent(&self, speed: SpeedId) -> bool {
        matches!(self[self.of(speed)].kind, UnknownKind::Independent(_))
    }

    /// The same unknowns with every dependent speed declared independent.
    pub(super) fn all_speeds_independent(mut self) -> Self {
        for id in self.all.ids().collect::<Vec<_>>() {
            if let UnknownKind::Dependent(speed) = self.all[id].kind {
                self.all[id].kind = UnknownKind::Independent(speed);
            }
        }
        self
    }

    /// Ids in order.
    pub fn ids(&self) -> impl DoubleEndedIterator<Item = UnknownId> + use<> {
        self.all.ids()
    }

    /// Unknowns in order.
    pub fn iter(&self) -> std::slice::Iter<'_, Unknown> {
        self.all.iter()
    }

    /// Ids with unknowns, in order.
    pub fn enumerate(&self) -> impl DoubleEndedIterator<Item = (UnknownId, &Unknown)> {
        self.all.enumerate()
    }

    fn those(&self, wanted: impl Fn(UnknownKind) -> bool) -> Vec<UnknownId> {
        self.enumerate().filter(|(_, u)| wanted(u.kind)).map(|(id, _)| id).collect()
    }
}

impl Index<UnknownId> for Unknowns {
    type Output = Unknown;
    fn index(&self, id: UnknownId) -> &Unknown {
        &self.all[id]
    }
}
