//! Many steps at once of a body that nothing meets and nobody looks at in between.
//!
//! In: the state, the length of a step, how many. Out: the state, with the bits of [`super::step`] as often by Verlet's method.

use super::state::State;
use crate::contact::System;
use crate::flexible::grid::{Corner, Line, March, WIDTH};
use crate::flexible::{Gas, PressureForm};
use crate::kernel;
use crate::ode::nodes::Workspace;
use crate::real::Scalar;

/// Memory of a march.
#[derive(Debug)]
pub struct Marching<'a, S> {
    /// [`Line::new`] of each row of the body's grid, and of one more.
    pub lines: &'a mut [Line<S>],
    /// The facets that are no cells of it.
    pub beside: &'a [[Corner; 4]],
    /// Whether the lines hold the state: false at first; a march that takes its steps says so, and who changes the state
    /// otherwise takes it back.
    pub is_current: &'a mut bool,
}

/// Whether a body can be marched: no ground, one grid no wider than [`WIDTH`] that is all of it, no dampers, no air, constant
/// pressure shared out by volume or by area.
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
    let is_asked = h > S::ZERO && steps > 0 && marching.lines.len() > grid.rows;
    if !is_asked || !can_march(system) {
        return false;
    }
    let taken = kernel::run(March {
        grid,
        form: inflation.form,
        pressure,
        beside: marching.beside,
        gravity: body.gravity,
        h,
        steps,
        motion: &mut state.motion,
        lines: marching.lines,
        goes_on: *marching.is_current,
    });
    *marching.is_current = taken;
    if taken {
        work.evaluations += steps;
        (0..steps).for_each(|_| state.pass(h));
    }
    taken
}
