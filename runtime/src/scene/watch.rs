//! The observer of a step, the data that it sees, and the report.

use crate::contact::compensation::{Impact, PointImpact};
use crate::contact::{ContactState, Full, System};
use crate::ode::nodes::Motion;
use crate::vec3;

/// Data of a touch or a release.
#[derive(Clone, Copy, Debug)]
pub struct Event<'a, S> {
    /// Time (s).
    pub time: S,
    /// The impact, for a touch.
    pub impact: Option<Impact<S>>,
    /// Impulse of each touching point.
    pub points: &'a [PointImpact<S>],
    /// Contact states after the event.
    pub modes: &'a [ContactState],
    /// Number of points released.
    pub released: usize,
}

/// Data of a piece of motion without events.
#[derive(Clone, Copy, Debug)]
pub struct Flow<'a, 'm, S> {
    /// State at its start.
    pub before: &'a Motion<'m, S>,
    /// State at its end.
    pub after: &'a Motion<'m, S>,
    /// Contact state of each point, the same all along.
    pub modes: &'a [ContactState],
    /// Its length (s).
    pub tau: S,
    /// Whether the speeds follow from forces and friction alone, without impulses.
    pub is_smooth: bool,
    /// Changes of speed by sliding friction, point by point; empty without friction.
    pub braked: &'a [vec3::Vec3<S>],
    /// Energy lost to sliding friction (J).
    pub friction: S,
    /// Energy lost to the impact law (J), for time-stepping laws.
    pub impact: S,
}

/// Observes a run. The unit type ignores it.
pub trait Observer<S, R = Full> {
    /// Motion without events.
    fn flow(&mut self, system: &System<S, R>, flow: Flow<S>);
    /// A touch or release.
    fn event(&mut self, system: &System<S, R>, event: Event<S>);
}

impl<S, R> Observer<S, R> for () {
    fn flow(&mut self, _: &System<S, R>, _: Flow<S>) {}
    fn event(&mut self, _: &System<S, R>, _: Event<S>) {}
}

/// Counts of one step.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub struct StepReport {
    /// Touches and releases.
    pub events: usize,
    /// Pieces without events.
    pub substeps: usize,
    /// Steps tried to locate events, each with the method's force evaluations.
    pub trials: usize,
    /// Evaluations of all forces, including those of trials.
    pub evaluations: usize,
    /// Whether the end of the step was stepped without events: [`super::MAX_EVENTS`] or [`super::MAX_SUBSTEPS`] was
    /// reached.
    pub cut_short: bool,
}
