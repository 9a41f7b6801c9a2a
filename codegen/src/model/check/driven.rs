//! Decides whether the mechanism is driven, that is, moves even with all speeds at zero, and whether it depends on
//! time.
//!
//! In: a model. Out: whether time enters positions or constraints, or a velocity has a part without speeds (Kane's
//! v_t): b of a motion constraint a_r u_r + b = 0, or a point's stated velocity. Decided on the text alone: a part that
//! happens to be zero counts too, which costs one unknown that nothing uses.

use crate::id::IdVec;
use crate::model::data::*;
use crate::model::expression::{Expr, ExprKind};
use crate::model::ids::*;
use crate::model::walk::Role;

/// What is known of each definition.
struct Definitions {
    /// It depends on time.
    reads_time: IdVec<DefinitionId, bool>,
    /// It does not vanish when all speeds are 0.
    has_free_part: IdVec<DefinitionId, bool>,
}

impl Model {
    /// Has any velocity a part without speeds?
    #[must_use]
    pub fn is_driven(&self) -> bool {
        let known = self.known_definitions();
        let has_free_part = |(role, e): (Role, &Expr)| {
            matches!(role, Role::MotionConstraint | Role::StatedVelocity(_)) && known.free_part_in(e)
        };
        self.is_moved_by_time() || self.expressions().into_iter().any(has_free_part)
    }

    /// Does time itself, not only a constant, prescribe any part of the motion?
    #[must_use]
    pub fn is_moved_by_time(&self) -> bool {
        let known = self.known_definitions();
        self.expressions().into_iter().any(|(role, e)| match role {
            Role::MotionConstraint
            | Role::StatedVelocity(_)
            | Role::ClosedForm(_)
            | Role::Speed(_)
            | Role::Orientation(..)
            | Role::FixedVector(..)
            | Role::Position(_)
            | Role::Closure(_)
            | Role::ConfigurationConstraint => known.time_in(e),
            _ => false,
        })
    }

    /// Does anything in the model depend on time: motion, loads, laws, outputs?
    #[must_use]
    pub fn reads_time(&self) -> bool {
        let known = self.known_definitions();
        self.expressions().into_iter().any(|(_, e)| known.time_in(e))
    }

    /// The first load that reads the time.
    #[must_use]
    pub fn load_of_time(&self) -> Option<&Load> {
        let known = self.known_definitions();
        self.loads.iter().find(|load| load.kind.expressions().into_iter().any(|(_, e)| known.time_in(e)))
    }

    /// Is the coordinate a function of time alone, so that no constraint is hidden in its closed form?
    pub(crate) fn is_prescribed(&self, coordinate: CoordinateId) -> bool {
        self.coordinates[coordinate].closed_form.as_ref().is_some_and(|form| self.reads_only_time(form))
    }

    fn reads_only_time(&self, form: &Expr) -> bool {
        let mut only = true;
        form.visit(&mut |e| match e.kind {
            ExprKind::Coordinate(other) => only &= self.is_prescribed(other),
            ExprKind::Definition(id) => only &= self.reads_only_time(&self.definitions[id].value),
            ExprKind::Point(_) | ExprKind::Axis(..) => only = false,
            _ => {}
        });
        only
    }

    fn known_definitions(&self) -> Definitions {
        let mut known = Definitions {
            reads_time: self.definitions.iter().map(|_| false).collect(),
            has_free_part: self.definitions.iter().map(|_| false).collect(),
        };
        for entity in &self.order {
            if let Entity::Definition(id) = *entity {
                let value = &self.definitions[id].value;
                known.reads_time[id] = known.time_in(value);
                known.has_free_part[id] = known.free_part_in(value);
            }
        }
        known
    }
}

impl Definitions {
    fn time_in(&self, expr: &Expr) -> bool {
        let mut found = false;
        expr.visit(&mut |e| {
            found |= match &e.kind {
                ExprKind::Time => true,
                ExprKind::Definition(id) => self.reads_time[*id],
                _ => false,
            };
        });
        found
    }

    /// Has a linear form in the speeds a part that remains when all of them are 0?
    fn free_part_in(&self, expr: &Expr) -> bool {
        match &expr.kind {
            // The parts of a velocity are examined where it is stated.
            ExprKind::Speed(_) | ExprKind::Rate(_) | ExprKind::Velocity(_) | ExprKind::AngularVelocity(_) => {
                false
            }
            ExprKind::Number(x) => *x != 0.0,
            ExprKind::Definition(id) => self.has_free_part[*id],
            ExprKind::Negate(a) | ExprKind::Divide(a, _) | ExprKind::Power(a, _) => self.free_part_in(a),
            ExprKind::Add(a, b) | ExprKind::Subtract(a, b) => self.free_part_in(a) || self.free_part_in(b),
            ExprKind::Multiply(a, b) | ExprKind::Dot(a, b) | ExprKind::Cross(a, b) => {
                self.free_part_in(a) && self.free_part_in(b)
            }
            _ => true,
        }
    }
}
