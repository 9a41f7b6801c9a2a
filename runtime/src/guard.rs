//! Locates the first touch, release or change of friction within a step. Guards cross zero downwards at an event
//! (thesis 4.4, the event function).
//!
//! Guards on rigid ground: of a free point, its gap; of a departing point, gap + tolerance (insensitive to rounding);
//! of a held point, N h^2/m, the displacement that its normal force would cause in a step h. With friction also: of a
//! sliding point, v.d0 h - mu N tau h/m, what friction leaves of its slip along d0, the initial slip direction; of a
//! stuck point, (mu N - |T|) h^2/m, the reserve of friction. Soft ground has the last two only. The smallest guard of
//! all points decides; its root is located by trying steps of different lengths, so the state at the event is a state
//! of the method itself. Free nodes are first checked in blocks (`reach`): almost always none can reach the ground
//! within the step.

mod reach;

use crate::contact::{ContactState, Ground, Repertoire, Start, System, advance};
use crate::flexible::BodyError;
use crate::kernel;
use crate::ode::nodes::{Motion, Workspace};
use crate::ode::root::Search;
use crate::real::Scalar;
use crate::vec3;
use reach::{Nearest, blocks, is_clear};
pub(crate) use reach::{PASSED_OVER, are_free};

/// Most trial steps for one root (60 bisections reduce a step to nothing).
const TRIALS: usize = 64;

/// Two times between which the smallest guard becomes negative.
#[derive(Clone, Copy, Debug)]
struct Bracket<S> {
    lo: S,
    guard_lo: S,
    hi: S,
    guard_hi: S,
    /// Root of the parabola through gap and rate at `lo` and gap at `hi`, of the point that crosses first.
    guess: Option<S>,
    /// A departing point that rises and returns within the step, whose guard is therefore armed.
    armed: Option<usize>,
}

/// Where a step ends, and the cost of finding out.
#[derive(Clone, Copy, Debug)]
pub struct Shortened<S> {
    /// Length of the step (s).
    pub tau: S,
    /// Whether an event ends it.
    pub is_event: bool,
    /// Steps tried in addition to the one handed in, each with the method's force evaluations.
    pub trials: usize,
}

/// Smallest guard (m) of a state that a step reaches after tau; `h` scales forces and speeds.
fn smallest_guard<S: Scalar, R: Repertoire<S>>(
    system: &System<S, R>,
    ground: &Ground<S>,
    start: Start<S>,
    motion: &Motion<S>,
    times: (S, S),
    armed: Option<usize>,
) -> S {
    let of = |block| block_guard(system, ground, start, motion, times, armed, block);
    blocks(start.modes).map(of).fold(S::ONE / S::EPSILON, |smallest, guard| smallest.min(guard))
}

/// The same for a block of nodes.
fn block_guard<S: Scalar, R: Repertoire<S>>(
    system: &System<S, R>,
    ground: &Ground<S>,
    start: Start<S>,
    motion: &Motion<S>,
    (tau, h): (S, S),
    armed: Option<usize>,
    (first, modes): (usize, &[ContactState]),
) -> S {
    let of = |i: usize, mode: ContactState| {
        if system.body.inverse_mass(i) == S::ZERO {
            return S::ONE / S::EPSILON;
        }
        let gap = ground.gap(vec3::at(motion.pos, i));
        match mode {
            _ if R::SOFT && !ground.is_rigid() => friction_guard(system, ground, start, motion, i, (tau, h)),
            ContactState::Free => gap,
            ContactState::Departing if armed == Some(i) => gap,
            // A point that moves away is no return: a method of order 2 has not yet lifted a point that rises as t^3.
            ContactState::Departing if ground.gap_rate(vec3::at(motion.vel, i)) >= S::ZERO => {
                gap.max(S::ZERO) + ground.tolerance
            }
            ContactState::Departing => gap + ground.tolerance,
            ContactState::Held | ContactState::Stuck => {
                let pressed = system.normal_force(motion.force(i)) * system.body.inverse_mass(i) * h * h;
                pressed.min(friction_guard(system, ground, start, motion, i, (tau, h)))
            }
        }
    };
    let asleep = S::ONE / S::EPSILON;
    let nearest = |pos| kernel::run(Nearest { body: &system.body, ground, first, count: modes.len(), pos });
    if are_free(modes) && ground.is_rigid() {
        return nearest(motion.pos);
    }
    // A point that a soft ground does not push at the start gets no friction within the step.
    if are_free(modes) && nearest(start.motion.pos) > S::ZERO {
        return asleep;
    }
    let guards = modes.iter().enumerate().map(|(i, mode)| of(first + i, *mode));
    guards.fold(asleep, |smallest, guard| smallest.min(guard))
}

/// Guard (m) of a point on the ground against sticking, reversing and slipping.
fn friction_guard<S: Scalar, R: Repertoire<S>>(
    system: &System<S, R>,
    ground: &Ground<S>,
    start: Start<S>,
    motion: &Motion<S>,
    i: usize,
    (tau, h): (S, S),
) -> S {
    let asleep = S::ONE / S::EPSILON;
    if !R::FRICTION || ground.friction <= S::ZERO {
        return asleep;
    }
    let per_mass = ground.friction * system.body.inverse_mass(i) * h;
    let mode = start.modes.get(i).copied().unwrap_or_default();
    let push = |motion| system.pressure(motion, i, mode);
    if mode == ContactState::Stuck {
        let side = vec3::norm(vec3::tangential(motion.force(i), ground.normal));
        return per_mass * h * (push(motion) - side / ground.friction);
    }
    let slip = vec3::tangential(vec3::at(start.motion.vel, i), ground.normal);
    let (d0, speed) = vec3::direction(slip);
    let pushes = [start.motion, motion].map(|m| push(m).max(S::ZERO));
    // A point that comes down within the step has friction for part of it only, so this guard does not apply.
    if speed <= S::ZERO || pushes[0] <= S::ZERO {
        return asleep;
    }
    let mean = S::from_f64(0.5) * (pushes[0] + pushes[1]);
    vec3::dot(vec3::at(motion.vel, i), d0) * h - per_mass * mean * tau
}

/// Checks the step of length `h` just tried (its end is in `work.end`) and shortens it to the first event.
///
/// The end of the shortened step is then in `work.end`.
///
/// # Errors
/// From the trial steps.
pub fn shorten_to_event<S: Scalar, R: Repertoire<S>>(
    system: &System<S, R>,
    ground: &Ground<S>,
    start: Start<S>,
    h: S,
    method: R::Method,
    work: &mut Workspace<S>,
) -> Result<Shortened<S>, BodyError<S>> {
    let (bracket, trials) = find_bracket(system, ground, start, h, method, work)?;
    match bracket {
        Some(bracket) => {
            let located = locate(system, ground, start, h, bracket, method, work)?;
            Ok(Shortened { trials: trials + located.trials, ..located })
        }
        None => Ok(Shortened { tau: h, is_event: false, trials }),
    }
}

/// Brackets the first event, if there is one; also returns the number of steps tried.
fn find_bracket<S: Scalar, R: Repertoire<S>>(
    system: &System<S, R>,
    ground: &Ground<S>,
    start: Start<S>,
    h: S,
    method: R::Method,
    work: &mut Workspace<S>,
) -> Result<(Option<Bracket<S>>, usize), BodyError<S>> {
    let guard =
        |motion: &Motion<S>, tau, armed| smallest_guard(system, ground, start, motion, (tau, h), armed);
    // Evaluated only where there is an event.
    let guard_lo = || guard(start.motion, S::ZERO, None).max(S::ZERO);
    let (guard_hi, dip) = look(system, ground, start, h, &work.end);
    if guard_hi < S::ZERO {
        let guard_lo = guard_lo();
        let guess = first_crossing(ground, start, h, &work.end);
        let whole = Bracket { lo: S::ZERO, guard_lo, hi: h, guard_hi, guess, armed: None };
        let Some((point, top)) = find_return(ground, start, h, &work.end) else {
            return Ok((Some(whole), 0));
        };
        let guard_hi = guard(&work.end, h, Some(point));
        advance(system, start, top, method, work)?;
        let above = guard(&work.end, top, Some(point));
        if above > S::ZERO {
            let late = Bracket { lo: top, guard_lo: above, hi: h, guard_hi, guess: None, armed: Some(point) };
            return Ok((Some(late), 1));
        }
        return Ok((Some(whole), 1));
    }
    if let Some(bottom) = dip {
        let guard_lo = guard_lo();
        advance(system, start, bottom, method, work)?;
        let guard_hi = guard(&work.end, bottom, None);
        if guard_hi < S::ZERO {
            let guess = first_crossing(ground, start, bottom, &work.end);
            let dip = Bracket { lo: S::ZERO, guard_lo, hi: bottom, guard_hi, guess, armed: None };
            return Ok((Some(dip), 1));
        }
        advance(system, start, h, method, work)?;
        return Ok((None, 2));
    }
    Ok((None, 0))
}

/// Time of the earliest zero of the parabolas g0 + r0 s + (g1 - g0 - r0) s^2 of the free points that end
/// below the surface: exact for Verlet, whose positions are parabolas over the step.
fn first_crossing<S: Scalar>(ground: &Ground<S>, start: Start<S>, h: S, end: &Motion<S>) -> Option<S> {
    let mut first: Option<S> = None;
    if !ground.is_rigid() {
        return first;
    }
    for (i, _) in start.modes.iter().enumerate().filter(|(_, m)| **m == ContactState::Free) {
        let g0 = ground.gap(vec3::at(start.motion.pos, i));
        let r0 = h * ground.gap_rate(vec3::at(start.motion.vel, i));
        let g1 = ground.gap(vec3::at(end.pos, i));
        if g1 < S::ZERO && g0 > S::ZERO {
            // Opposite signs at both ends, so the root is real: s = 2 g0/(sqrt(r0^2 - 4 b g0) - r0).
            let b = g1 - g0 - r0;
            let root = (r0 * r0 - S::from_f64(4.0) * b * g0).max(S::ZERO).sqrt();
            let time = h * (S::from_f64(2.0) * g0 / (root - r0));
            first = Some(first.map_or(time, |t| t.min(time)));
        }
    }
    first
}

/// Gap over a step as the cubic through values and rates at both ends: g0 + r0 s + b s^2 + c s^3, 0 <= s <= 1.
struct Cubic<S> {
    g0: S,
    r0: S,
    b: S,
    c: S,
}

impl<S: Scalar> Cubic<S> {
    fn new(ground: &Ground<S>, start: Start<S>, end: &Motion<S>, h: S, i: usize) -> Cubic<S> {
        let g0 = ground.gap(vec3::at(start.motion.pos, i));
        let r0 = h * ground.gap_rate(vec3::at(start.motion.vel, i));
        let g1 = ground.gap(vec3::at(end.pos, i));
        let r1 = h * ground.gap_rate(vec3::at(end.vel, i));
        let two = S::from_f64(2.0);
        Cubic { g0, r0, b: S::from_f64(3.0) * (g1 - g0) - two * r0 - r1, c: two * (g0 - g1) + r0 + r1 }
    }

    fn at(&self, s: S) -> S {
        self.g0 + s * (self.r0 + s * (self.b + s * self.c))
    }

    /// The s in (0, 1) where r0 + 2 b s + 3 c s^2 changes sign: downwards (a maximum) if `top`, else upwards (a
    /// minimum).
    fn turn(&self, top: bool) -> Option<S> {
        // With q = b -+ root the two zeros are -q/(3 c) and -r0/q.
        let root = (self.b * self.b - S::from_f64(3.0) * self.c * self.r0).max(S::ZERO).sqrt();
        let root = if top { -root } else { root };
        let s = if (self.b >= S::ZERO) == (root >= S::ZERO) {
            -self.r0 / (self.b + root)
        } else {
            (root - self.b) / (S::from_f64(3.0) * self.c)
        };
        (s > S::ZERO && s < S::ONE).then_some(s)
    }
}

/// A departing point that ends below the surface after rising first: the point and the time of its maximum.
fn find_return<S: Scalar>(ground: &Ground<S>, start: Start<S>, h: S, end: &Motion<S>) -> Option<(usize, S)> {
    let departing = start.modes.iter().enumerate().filter(|(_, m)| **m == ContactState::Departing);
    for (i, _) in departing {
        let gap = Cubic::new(ground, start, end, h, i);
        if gap.at(S::ONE) < -ground.tolerance
            && let Some(s) = gap.turn(true).filter(|s| gap.at(*s) > S::ZERO)
        {
            return Some((i, s * h));
        }
    }
    None
}

/// Returns the smallest guard at the end of a step, and the time of the deepest minimum of free points that are above
/// the surface at both ends and below it in between. Blocks that stay clear of the ground are skipped.
fn look<S: Scalar, R: Repertoire<S>>(
    system: &System<S, R>,
    ground: &Ground<S>,
    start: Start<S>,
    h: S,
    end: &Motion<S>,
) -> (S, Option<S>) {
    let (mut smallest, mut deepest, mut time) = (S::ONE / S::EPSILON, -ground.tolerance, None);
    for (first, modes) in blocks(start.modes) {
        if ground.is_rigid() && is_clear(ground, (first, modes), [start.motion, end], h) {
            continue;
        }
        smallest = smallest.min(block_guard(system, ground, start, end, (h, h), None, (first, modes)));
        if ground.is_rigid() {
            for (i, _) in modes.iter().enumerate().filter(|(_, m)| **m == ContactState::Free) {
                let gap = Cubic::new(ground, start, end, h, first + i);
                if gap.r0 < S::ZERO
                    && let Some(s) = gap.turn(false).filter(|s| gap.at(*s) < deepest)
                {
                    (deepest, time) = (gap.at(s), Some(s * h));
                }
            }
        }
    }
    (smallest, time)
}

/// Locates the root of the smallest guard; also returns the number of steps tried.
///
/// Ends where the guard is negative by no more than rounding, with that state in `work.end`. The solution of an
/// implicit step may jump as its length changes: where a spring is pressed to zero length at the ground, one solution
/// ends and the next is deep below. The step then ends before the jump, without an event: from there shorter steps,
/// whose solution is unique, continue.
fn locate<S: Scalar, R: Repertoire<S>>(
    system: &System<S, R>,
    ground: &Ground<S>,
    start: Start<S>,
    h: S,
    bracket: Bracket<S>,
    method: R::Method,
    work: &mut Workspace<S>,
) -> Result<Shortened<S>, BodyError<S>> {
    let small = S::EPSILON * (S::ONE + ground.offset.abs());
    // Shifted by half of the guard allowed, so that the root aimed at lies on the negative side.
    let shift = S::from_f64(0.5) * small;
    let (low, high) = ((bracket.lo, bracket.guard_lo + shift), (bracket.hi, bracket.guard_hi + shift));
    let mut search = Search::new(low, high, bracket.guess);
    let (mut positive, mut negative) = (bracket.lo, bracket.hi);
    for trial in 0..TRIALS {
        let (old, new) = search.ends();
        if (new - old).abs() <= S::from_f64(2.0) * S::EPSILON * new.max(old) {
            break;
        }
        let tau = search.propose();
        advance(system, start, tau, method, work)?;
        let guard = smallest_guard(system, ground, start, &work.end, (tau, h), bracket.armed);
        if guard < S::ZERO {
            negative = tau;
            if -guard <= small {
                return Ok(Shortened { tau, is_event: true, trials: trial + 1 });
            }
        } else {
            positive = tau;
        }
        search.take(tau, guard + shift);
    }
    advance(system, start, negative, method, work)?;
    if ground.is_rigid() && positive > S::ZERO && jumps(system, ground, start, &work.end) {
        advance(system, start, positive, method, work)?;
        return Ok(Shortened { tau: positive, is_event: false, trials: TRIALS });
    }
    Ok(Shortened { tau: negative, is_event: true, trials: TRIALS })
}

/// Whether a point is clearly below the surface after a step that should have ended at it.
fn jumps<S: Scalar, R: Repertoire<S>>(
    system: &System<S, R>,
    ground: &Ground<S>,
    start: Start<S>,
    end: &Motion<S>,
) -> bool {
    start.modes.iter().enumerate().any(|(i, mode)| {
        let closing = *mode == ContactState::Free || ground.gap_rate(vec3::at(end.vel, i)) < S::ZERO;
        let moves = system.body.inverse_mass(i) > S::ZERO;
        moves && !mode.is_held() && closing && ground.is_deep(vec3::at(end.pos, i))
    })
}
