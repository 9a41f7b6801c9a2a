//! One step of a body's motion while no point touches or leaves: the methods, their state and scratch memory.
//!
//! In: a state, the step tau, a method. Out: the state at the end, in the workspace; the state itself is
//! left alone, so a step can be tried, shortened and tried again.
//! Positions and speeds carry what rounding dropped (compensated sums): an f32 point at 10 m moves at 1 mm/s.

pub mod explicit;
pub mod implicit;
pub mod moreau;
pub mod verlet;

use crate::contact::compensation::PointImpact;
use crate::contact::{ContactLaw, Mode, System, massless, soft};
use crate::flexible::BodyError;
use crate::flexible::force;
use crate::ode::tableau;
use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// Method of integration between events.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Method<S> {
    /// v first, then x with the new v: order 1.
    SymplecticEuler,
    /// Velocity Verlet: order 2; dampers are solved implicitly, half before and half after.
    Verlet,
    /// Nystrom's classical order 4, three evaluations; for forces of positions (dampers lower the order).
    Nystrom4,
    /// Blanes & Moan's symplectic splitting of order 4, small error constant; for forces of positions.
    BlanesMoan4,
    /// The classical Runge-Kutta method of order 4.
    Rk4,
    /// Implicit midpoint rule: order 2.
    ImplicitMidpoint,
    /// Midpoint rule with mean forces along the springs (Simo, Tarnow; Gonzalez): order 2, energy kept exactly.
    EnergyMomentum,
    /// Dormand & Prince 5(4) with step control.
    DormandPrince {
        /// Error allowed per step, absolute and relative.
        tolerance: S,
        /// Longest step (s).
        longest: S,
    },
    /// Dormand & Prince 8(5,3) with step control.
    Dop853 {
        /// Error allowed per step, absolute and relative.
        tolerance: S,
        /// Longest step (s).
        longest: S,
    },
}

impl<S: Scalar> Method<S> {
    /// Rows of stage memory per point.
    #[must_use]
    pub fn stages(&self) -> usize {
        match self {
            Method::SymplecticEuler | Method::Verlet | Method::ImplicitMidpoint | Method::EnergyMomentum => 1,
            Method::Nystrom4 => 3,
            Method::Rk4 => 4,
            Method::DormandPrince { .. } | Method::BlanesMoan4 => 7,
            Method::Dop853 { .. } => 12,
        }
    }

    /// Order of the step size control, 0 for fixed steps.
    #[must_use]
    pub fn control_order(&self) -> u32 {
        match self {
            Method::DormandPrince { .. } => 5,
            Method::Dop853 { .. } => 8,
            _ => 0,
        }
    }
}

/// Positions, speeds and forces of all points at one time.
#[derive(Debug)]
pub struct Motion<'a, S> {
    /// Positions (m).
    pub pos: &'a mut [Vec3<S>],
    /// What rounding dropped from the positions.
    pub pos_rest: &'a mut [Vec3<S>],
    /// Velocities (m/s).
    pub vel: &'a mut [Vec3<S>],
    /// What rounding dropped from the velocities.
    pub vel_rest: &'a mut [Vec3<S>],
    /// Forces of positions (N).
    pub elastic: &'a mut [Vec3<S>],
    /// Forces of speeds (N).
    pub viscous: &'a mut [Vec3<S>],
}

/// Vectors per point in a [`Motion`].
pub const MOTION_ROWS: usize = 6;

impl<'a, S: Scalar> Motion<'a, S> {
    /// Cuts the six rows of n from a buffer; returns what is left.
    ///
    /// # Errors
    /// [`BodyError::Scratch`] if the buffer is too short.
    #[expect(clippy::type_complexity, reason = "the pair is the whole answer")]
    pub fn cut(
        buffer: &'a mut [Vec3<S>],
        n: usize,
    ) -> Result<(Motion<'a, S>, &'a mut [Vec3<S>]), BodyError<S>> {
        let (pos, buffer) = cut(buffer, n)?;
        let (pos_rest, buffer) = cut(buffer, n)?;
        let (vel, buffer) = cut(buffer, n)?;
        let (vel_rest, buffer) = cut(buffer, n)?;
        let (elastic, buffer) = cut(buffer, n)?;
        let (viscous, buffer) = cut(buffer, n)?;
        Ok((Motion { pos, pos_rest, vel, vel_rest, elastic, viscous }, buffer))
    }

    /// Total force on point i (N).
    #[must_use]
    pub fn force(&self, i: usize) -> Vec3<S> {
        vec3::add(vec3::at(self.elastic, i), vec3::at(self.viscous, i))
    }

    /// Takes all values of another motion.
    pub fn copy_from(&mut self, other: &Motion<S>) {
        copy(self.pos, other.pos);
        copy(self.pos_rest, other.pos_rest);
        copy(self.vel, other.vel);
        copy(self.vel_rest, other.vel_rest);
        copy(self.elastic, other.elastic);
        copy(self.viscous, other.viscous);
    }

    /// Recomputes the forces of these positions and speeds; settles massless points first.
    ///
    /// # Errors
    /// From the gas law.
    pub fn refresh(&mut self, system: &System<S>) -> Result<(), BodyError<S>> {
        eval_elastic(system, self.pos, self.elastic)?;
        eval_viscous(system, self.pos, self.vel, self.viscous);
        Ok(())
    }
}

fn cut<T, S>(buffer: &mut [T], n: usize) -> Result<(&mut [T], &mut [T]), BodyError<S>> {
    let given = buffer.len();
    buffer.split_at_mut_checked(n).ok_or(BodyError::Scratch { needed: n, given })
}

/// Copies row by row; no panic if the lengths differ.
pub(crate) fn copy<T: Copy>(to: &mut [T], from: &[T]) {
    for (a, b) in to.iter_mut().zip(from) {
        *a = *b;
    }
}

/// Scratch memory of one body.
#[derive(Debug)]
pub struct Workspace<'a, S> {
    /// The state at the end of the step tried last.
    pub end: Motion<'a, S>,
    /// Change of position over the step.
    pub dx: &'a mut [Vec3<S>],
    /// Change of velocity over the step.
    pub dv: &'a mut [Vec3<S>],
    /// Positions, speeds and forces at a stage.
    pub stage_pos: &'a mut [Vec3<S>],
    /// Velocities at a stage.
    pub stage_vel: &'a mut [Vec3<S>],
    /// Forces at a stage, of positions.
    pub stage_elastic: &'a mut [Vec3<S>],
    /// Forces at a stage, of speeds.
    pub stage_viscous: &'a mut [Vec3<S>],
    /// Accelerations of all stages, n per stage.
    pub stages: &'a mut [Vec3<S>],
    /// Impulses.
    pub impacts: &'a mut [PointImpact<S>],
    /// Evaluations of all forces so far.
    pub evaluations: usize,
}

/// Vectors that a [`Workspace`] needs for n points.
#[must_use]
pub fn workspace_len<S: Scalar>(n: usize, method: Method<S>) -> usize {
    n * (MOTION_ROWS + 6 + method.stages())
}

impl<'a, S: Scalar> Workspace<'a, S> {
    /// Cuts the workspace from the caller's memory.
    ///
    /// # Errors
    /// [`BodyError::Scratch`] if it is shorter than [`workspace_len`], or `impacts` shorter than n.
    pub fn new(
        buffer: &'a mut [Vec3<S>],
        impacts: &'a mut [PointImpact<S>],
        n: usize,
        method: Method<S>,
    ) -> Result<Workspace<'a, S>, BodyError<S>> {
        if impacts.len() < n {
            return Err(BodyError::Scratch { needed: n, given: impacts.len() });
        }
        let (end, buffer) = Motion::cut(buffer, n)?;
        let (dx, buffer) = cut(buffer, n)?;
        let (dv, buffer) = cut(buffer, n)?;
        let (stage_pos, buffer) = cut(buffer, n)?;
        let (stage_vel, buffer) = cut(buffer, n)?;
        let (stage_elastic, buffer) = cut(buffer, n)?;
        let (stage_viscous, buffer) = cut(buffer, n)?;
        let (stages, _) = cut(buffer, n * method.stages())?;
        let evaluations = 0;
        Ok(Workspace {
            end,
            dx,
            dv,
            stage_pos,
            stage_vel,
            stage_elastic,
            stage_viscous,
            stages,
            impacts,
            evaluations,
        })
    }

    /// Recomputes the forces at the end of the step.
    ///
    /// # Errors
    /// From the gas law.
    pub fn refresh_end(&mut self, system: &System<S>) -> Result<(), BodyError<S>> {
        self.evaluations += 1;
        self.end.refresh(system)
    }
}

/// Where a step starts.
#[derive(Clone, Copy, Debug)]
pub struct Start<'a, 'm, S> {
    /// State.
    pub motion: &'a Motion<'m, S>,
    /// Modes, frozen over the step.
    pub modes: &'a [Mode],
}

impl<S: Scalar> Start<'_, '_, S> {
    /// Mode of point i.
    #[must_use]
    pub fn mode(&self, i: usize) -> Mode {
        self.modes.get(i).copied().unwrap_or_default()
    }
}

/// Advances by tau into `work.end`; returns the error estimate in units of the tolerance (0 for fixed steps).
///
/// # Errors
/// Not finite, not converged, or from the gas law; the start is untouched.
pub fn advance<S: Scalar>(
    system: &System<S>,
    start: Start<S>,
    tau: S,
    method: Method<S>,
    work: &mut Workspace<S>,
) -> Result<S, BodyError<S>> {
    let error = match method {
        Method::SymplecticEuler => verlet::symplectic_euler(system, start, tau, work)?,
        Method::Verlet => verlet::verlet(system, start, tau, work)?,
        Method::Nystrom4 => {
            explicit::step(&const { tableau::NYSTROM_4.rounded() }, system, start, tau, S::ONE, work)?
        }
        Method::BlanesMoan4 => {
            explicit::step(&const { tableau::BLANES_MOAN_4.rounded() }, system, start, tau, S::ONE, work)?
        }
        Method::Rk4 => explicit::step(&const { tableau::RK4.rounded() }, system, start, tau, S::ONE, work)?,
        Method::ImplicitMidpoint => implicit::midpoint(system, start, tau, work)?,
        Method::EnergyMomentum => implicit::energy_momentum(system, start, tau, work)?,
        Method::DormandPrince { tolerance, .. } => {
            explicit::step(&const { tableau::DORMAND_PRINCE.rounded() }, system, start, tau, tolerance, work)?
        }
        Method::Dop853 { tolerance, .. } => {
            explicit::step(&const { tableau::DOP853.rounded() }, system, start, tau, tolerance, work)?
        }
    };
    check_finite(&work.end)?;
    Ok(error)
}

/// Forces of positions at a stage, with massless points settled and a soft ground's push.
pub(crate) fn eval_elastic<S: Scalar>(
    system: &System<S>,
    pos: &mut [Vec3<S>],
    out: &mut [Vec3<S>],
) -> Result<(), BodyError<S>> {
    if let Some(ground) = &system.ground
        && ground.law == ContactLaw::MasslessPoint
    {
        massless::settle(&system.body, ground, pos);
    }
    force::eval_elastic(&system.body, pos, out)?;
    if let Some(ground) = &system.ground {
        soft::accumulate_elastic(ground, pos, out);
    }
    Ok(())
}

/// Forces of speeds at a stage.
pub(crate) fn eval_viscous<S: Scalar>(
    system: &System<S>,
    pos: &[Vec3<S>],
    vel: &[Vec3<S>],
    out: &mut [Vec3<S>],
) {
    if system.body.is_damped() {
        force::eval_viscous(&system.body, pos, vel, out);
    } else {
        out.iter_mut().for_each(|f| *f = vec3::zero());
    }
    if let Some(ground) = &system.ground {
        soft::accumulate_viscous(ground, pos, vel, out);
    }
}

/// end = start + (dx, dv) by compensated sums, then the forces there.
pub(crate) fn finish<S: Scalar>(
    system: &System<S>,
    start: Start<S>,
    work: &mut Workspace<S>,
) -> Result<(), BodyError<S>> {
    place_positions(start, work);
    place_velocities(system, start, work);
    work.refresh_end(system)
}

/// Positions at the end.
pub(crate) fn place_positions<S: Scalar>(start: Start<S>, work: &mut Workspace<S>) {
    let from = start.motion;
    sum_compensated(from.pos, from.pos_rest, work.dx, work.end.pos, work.end.pos_rest);
}

/// Moves the end's positions by `dx`, by compensated sums.
pub(crate) fn shift_positions<S: Scalar>(work: &mut Workspace<S>) {
    let Workspace { end, dx, stage_pos, stage_vel, .. } = work;
    copy(stage_pos, end.pos);
    copy(stage_vel, end.pos_rest);
    sum_compensated(stage_pos, stage_vel, dx, end.pos, end.pos_rest);
}

/// Velocities at the end; a held point keeps none along the normal, not even rounding.
pub(crate) fn place_velocities<S: Scalar>(system: &System<S>, start: Start<S>, work: &mut Workspace<S>) {
    let (from, end) = (start.motion, &mut work.end);
    sum_compensated(from.vel, from.vel_rest, work.dv, end.vel, end.vel_rest);
    for (i, (v, rest)) in end.vel.iter_mut().zip(end.vel_rest.iter_mut()).enumerate() {
        *v = system.admissible(start.mode(i), *v);
        *rest = system.admissible(start.mode(i), *rest);
    }
}

/// out + rest_out = x + rest + dx, with Knuth's exact sum of two.
fn sum_compensated<S: Scalar>(
    x: &[Vec3<S>],
    rest: &[Vec3<S>],
    dx: &[Vec3<S>],
    out: &mut [Vec3<S>],
    rest_out: &mut [Vec3<S>],
) {
    let inputs = x.iter().zip(rest).zip(dx);
    for (((x, rest), dx), (out, rest_out)) in inputs.zip(out.iter_mut().zip(rest_out)) {
        let terms = x.iter().zip(rest).zip(dx);
        for (((x, rest), dx), (out, rest_out)) in terms.zip(out.iter_mut().zip(rest_out)) {
            let change = *dx + *rest;
            let sum = *x + change;
            let part = sum - *x;
            *rest_out = (*x - (sum - part)) + (change - part);
            *out = sum;
        }
    }
}

pub(crate) fn check_finite<S: Scalar>(motion: &Motion<S>) -> Result<(), BodyError<S>> {
    // Squares, because energies and errors are made of them.
    let finite = |x: &Vec3<S>, v: &Vec3<S>| (vec3::dot(*x, *x) + vec3::dot(*v, *v)).is_finite();
    let bad = motion.pos.iter().zip(motion.vel.iter()).position(|(x, v)| !finite(x, v));
    match bad {
        Some(point) => Err(BodyError::NotFinite { point }),
        None => Ok(()),
    }
}
