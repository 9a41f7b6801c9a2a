//! What a step shows while it happens, and what it reports at its end.

use crate::contact::compensation::{Impact, PointImpact};
use crate::contact::{ContactState, Full, System};
use crate::ode::nodes::Motion;
use crate::vec3;

/// A touch or a release.
#[derive(Clone, Copy, Debug)]
pub struct Event<'a, S> {
    /// Time (s).
    pub time: S,
    /// The impact, for a touch.
    pub impact: Option<Impact<S>>,
    /// Impulses by point (of the touching ones).
    pub points: &'a [PointImpact<S>],
    /// Modes after the event.
    pub modes: &'a [ContactState],
    /// Number of points let go.
    pub released: usize,
}

/// A stretch of motion without events.
#[derive(Clone, Copy, Debug)]
pub struct Flow<'a, 'm, S> {
    /// State at its start.
    pub before: &'a Motion<'m, S>,
    /// State at its end.
    pub after: &'a Motion<'m, S>,
    /// Each point against the ground, all the way.
    pub modes: &'a [ContactState],
    /// Its length (s).
    pub tau: S,
    /// True where the speeds follow from the forces and friction alone: no impulse within.
    pub is_smooth: bool,
    /// Changes of speed that sliding friction made all along it, point by point; empty without friction.
    pub braked: &'a [vec3::Vec3<S>],
    /// Energy lost to sliding friction in it (J).
    pub friction: S,
    /// Energy lost to the impact law in it (J) (time stepping laws).
    pub impact: S,
}

/// Sees a run. The unit type looks away.
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
    /// Stretches without events.
    pub substeps: usize,
    /// Steps tried to locate events, each with the method's force evaluations.
    pub trials: usize,
    /// Evaluations of all forces, those of trials included.
    pub evaluations: usize,
    /// Its end was stepped over without events: [`super::MAX_EVENTS`] or [`super::MAX_SUBSTEPS`] was reached.
    pub cut_short: bool,
}
