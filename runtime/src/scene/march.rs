//! Many steps at once of a body without ground and without an observer.
//!
//! In: the state, the length of a step, how many. Out: the state; by Verlet's method with the bits of as many
//! [`super::step`], by the energy-momentum method with the bits of as many marches of one step, which are those of
//! [`super::step`] to rounding.

use super::state::State;
use crate::contact::{Frozen, System};
use crate::flexible::grid::{Conserve, Corner, Course, Line, March, Span, WIDTH};
use crate::flexible::{Gas, PressureForm};
use crate::kernel;
use crate::ode::nodes::Workspace;
use crate::real::Scalar;

/// Memory of a march.
#[derive(Debug)]
pub struct Marching<'a, S> {
    /// Its rows.
    pub rows: Rows<'a, S>,
    /// The facets that are no cells of it.
    pub beside: &'a [[Corner; 4]],
    /// Whether the rows hold the state: false at first, set by a march, to be cleared by any other change of the state.
    pub is_current: &'a mut bool,
}

/// Each row of the body's grid, and one more, as the method keeps it.
#[derive(Debug)]
pub enum Rows<'a, S> {
    /// [`Line::new`], for Verlet's method.
    Verlet(&'a mut [Line<S>]),
    /// [`Course::new`], for the energy-momentum method.
    EnergyMomentum(&'a mut [Course<S>]),
}

impl<S> Rows<'_, S> {
    fn count(&self) -> usize {
        match self {
            Rows::Verlet(lines) => lines.len(),
            Rows::EnergyMomentum(courses) => courses.len(),
        }
    }
}

/// Whether a body can be marched: no ground, one grid no wider than [`WIDTH`] that is all of it, no dampers, no air,
/// constant pressure shared out by volume or by area.
#[must_use]
pub fn can_march<S: Scalar>(system: &System<S>) -> bool {
    let body = &system.body;
    let [grid] = body.grids else { return false };
    let is_all = grid.nodes == [0, body.points()] && grid.springs == [0, body.springs.len()];
    let is_still = system.ground.is_none() && body.massless.points.is_empty() && !system.is_damped();
    let gas = body.inflation.map(|inflation| (inflation.gas, inflation.form));
    let is_constant = matches!(gas, Some((Gas::Constant(_), PressureForm::Exact | PressureForm::Facet)));
    is_all && is_still && is_constant && grid.columns <= WIDTH
}

/// Takes so many steps of length h, if the body [`can_march`] and none is refused; else nothing has happened.
pub fn march<'a, S: Scalar>(
    system: &System<S>,
    state: &mut State<'a, S>,
    (h, steps): (S, usize),
    marching: Marching<S>,
    work: &mut Workspace<'a, S>,
) -> bool {
    let body = &system.body;
    let ([grid], Some(inflation)) = (body.grids, body.inflation) else { return false };
    let Gas::Constant(pressure) = inflation.gas else { return false };
    let is_asked = h > S::ZERO && steps > 0 && marching.rows.count() > grid.rows;
    if !is_asked || !can_march(system) {
        return false;
    }
    let Marching { rows, beside, is_current } = marching;
    let span = Span {
        grid,
        form: inflation.form,
        pressure,
        beside,
        gravity: body.gravity,
        h,
        steps,
        motion: &mut state.motion,
        goes_on: *is_current,
    };
    let mut evaluations = 0;
    let taken = match rows {
        Rows::Verlet(lines) => {
            evaluations = steps;
            kernel::run(March { span, lines })
        }
        Rows::EnergyMomentum(courses) => {
            let march = Conserve { span, courses, evaluations: &mut evaluations };
            // The forces at the end are refused only where a spring has run away, for which the march has looked.
            kernel::run(march) && state.motion.refresh(&Frozen { system, modes: state.modes }).is_ok()
        }
    };
    *is_current = taken;
    if taken {
        work.evaluations += evaluations;
        (0..steps).for_each(|_| state.pass(h));
    }
    taken
}
