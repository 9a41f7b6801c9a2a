//! Many steps of the energy-momentum method of a body that is one grid under constant pressure, its numbers by
//! component from the first step to the last.
//!
//! In: the motion at the start, how many steps. Out: the motion at the end but for its forces, the same bits however
//! many steps are taken at once; the rows keep it, so that the next need not read it again. Unknown is the way D of the
//! nodes over a step, D = h v + h^2/2 f(D)/m with the mean forces f of [`mean`](crate::flexible::mean). It is improved
//! by Chebyshev's iteration, whose coefficients follow from a bound on the stiffness: a row is done as soon as its
//! forces are known, so that an iteration passes once through the grid.
//!
//! An iteration needs neither roots nor divisions: lengths at the start are taken once a step, the inverses of those at
//! the end by Newton's method from the iteration before. The mean of a quadratic form Q over a straight way, which the
//! pressure needs, is Q/4 at its start and 3 Q/4 after two thirds of it (Radau's rule, exact for such forms).

use super::course::{Course, Forces, Largest, arrive, improve, measure, pull_and_push, set_out};
use super::layout::WIDTH;
use super::line::{Corner, LEAD, Springs, Wide, get, larger, set};
use super::span::Span;
use crate::flexible::pressure::{self, Weights};
use crate::kernel::Kernel;
use crate::real::Scalar;
use crate::vec3;

/// Takes steps; returns whether all could be taken. Where one would be refused, or nearly so, the motion is unchanged;
/// steps taken one by one then tell which and why.
#[derive(Debug)]
pub struct Conserve<'a, 'm, S> {
    /// The steps; a facet beside the grid touches two neighbouring rows.
    pub span: Span<'a, 'm, S>,
    /// [`Course::new`] of each row and of one more.
    pub courses: &'a mut [Course<S>],
    /// Evaluations of all forces so far.
    pub evaluations: &'a mut usize,
}

/// Most iterations between two checks of the residual.
const MAX_UNCHECKED: usize = 3;
/// Most checks of it in a step.
const MAX_CHECKS: usize = 60;
/// Rounding units of the way that end the iteration.
const SETTLED: f64 = 4.0;
/// Bound on the stiffness of a node over that of its springs in one direction: on an inclined sheet those of the other
/// add to it.
const BOTH: f64 = 1.3;

impl<S: Scalar> Kernel for Conserve<'_, '_, S> {
    type Output = bool;

    #[inline(always)]
    fn run(mut self) -> bool {
        let is_high = |corners: &[Corner; 4]| {
            let lowest = corners.iter().fold(usize::MAX, |row, corner| row.min(corner.row));
            corners.iter().any(|corner| corner.row > lowest + 1)
        };
        if self.span.beside.iter().any(is_high) {
            return false;
        }
        self.span.begin(self.courses.iter_mut().map(|course| &mut course.line));
        let scale = S::from_f64(0.5) * self.span.h * self.span.h;
        for course in &mut *self.courses {
            for (mobility, inverse_mass) in course.mobility.iter_mut().zip(&course.line.inverse_mass) {
                *mobility = scale * *inverse_mass;
            }
        }
        let (bounds, mut forces) = (self.bounds(), Forces::zero());
        for _ in 0..self.span.steps {
            if !self.step(&bounds, &mut forces) {
                return false;
            }
        }
        self.span.end(self.courses.iter().map(|course| &course.line))
    }
}

impl<S: Scalar> Conserve<'_, '_, S> {
    fn bounds(&self) -> Bounds<S> {
        let (mut stiffest, mut strained) = (S::ZERO, S::ZERO);
        let mut below = [[S::ZERO; 2]; WIDTH];
        for Course { line, mobility, .. } in &*self.courses {
            // Pressure on the cells beside a spring changes like the force of one of stiffness P L.
            let of = |springs: &Springs<S>, lane: usize| {
                let (stiffness, length) = (springs.stiffness[lane], springs.rest_length[lane]);
                [stiffness + self.span.pressure.abs() * length, stiffness * length]
            };
            let mut left = [S::ZERO; 2];
            for lane in 0..WIDTH {
                let (right, up) = (of(&line.right, lane), of(&line.up, lane));
                let [stiffness, force] =
                    [0, 1].map(|n: usize| larger(left[n] + right[n], below[lane][n] + up[n]));
                stiffest = larger(stiffness * mobility[lane], stiffest);
                strained = larger(force * mobility[lane], strained);
                (left, below[lane]) = (right, up);
            }
        }
        Bounds { reach: larger(S::from_f64(BOTH) * stiffest, S::EPSILON), strained }
    }

    /// One step; returns whether it can be taken.
    #[inline(always)]
    fn step(&mut self, bounds: &Bounds<S>, forces: &mut Forces<S>) -> bool {
        self.begin(forces);
        let mut chebyshev = Chebyshev::new(bounds.reach);
        let (mut unseen, mut before) = (0, None);
        for _ in 0..MAX_CHECKS {
            for _ in 0..unseen {
                self.iterate::<false>(chebyshev.next(), forces);
            }
            let largest = self.iterate::<true>(chebyshev.next(), forces);
            let [residual, way, inverse, stretch] = largest.numbers();
            // A spring that collapses has a negative stiffness, for which the coefficients are not made.
            let rate = before.map_or(S::ONE, |last| mean_rate(residual / last, unseen + 1));
            let rate = larger(rate, chebyshev.gain);
            // What this iteration and the end of the step leave.
            let error = residual * rate * larger(rate, bounds.reach) / (S::ONE - rate);
            let goal = S::from_f64(SETTLED) * S::EPSILON * (way + bounds.strained);
            let is_settled = residual <= goal || rate < S::ONE && error <= goal;
            if is_settled && inverse <= S::ROOT_EPSILON {
                self.end(forces);
                return stretch <= S::ONE;
            }
            unseen = match before {
                None => MAX_UNCHECKED,
                Some(_) if rate < S::ONE => iterations(rate, error * rate, goal),
                Some(_) => 0,
            };
            before = Some(residual);
        }
        false
    }

    /// Lengths and forces at the start of a step; the way by constant forces alone.
    #[inline(always)]
    fn begin(&mut self, forces: &mut Forces<S>) {
        let pressure = S::from_f64(0.25) * self.span.pressure;
        let weights = Weights::of(self.span.form, false).times(pressure);
        forces.begin();
        for row in 0..self.span.grid.rows {
            let Some([course, above]) = self.courses.get_mut(row..).and_then(<[_]>::first_chunk_mut) else {
                break;
            };
            let Course { line, right: to_right, up: upwards, .. } = course;
            for lane in 0..WIDTH {
                let [here, right] = [lane, lane + 1].map(|lane| get(&line.pos, lane));
                let [up, across] = [lane, lane + 1].map(|lane| get(&above.line.pos, lane));
                measure(to_right, lane, vec3::sub(right, here));
                measure(upwards, lane, vec3::sub(up, here));
                let shares =
                    pressure::quad_shares(weights.times(line.cells[lane]), [here, right, across, up]);
                forces.set(lane, [vec3::zero(); 2], shares);
            }
            if line.has_beside {
                self.push_beside(row, pressure, |course| &course.line.pos, forces);
            }
            if let Some(course) = self.courses.get_mut(row) {
                set_out(self.span.h, &self.span.gravity, course, forces);
            }
        }
    }

    /// Improves the way by multiples of the residual and of its last change. Computes the largest numbers with `LOOK`
    /// only.
    #[inline(always)]
    fn iterate<const LOOK: bool>(&mut self, gains: [S; 2], forces: &mut Forces<S>) -> Largest<S> {
        let mut largest = Largest::none();
        forces.begin();
        for row in 0..self.span.grid.rows {
            self.forces::<LOOK>(row, forces, &mut largest);
            let Some(course) = self.courses.get_mut(row) else { break };
            improve::<S, LOOK>(gains, course, forces, &mut largest);
        }
        *self.evaluations += 1;
        largest
    }

    /// Places and velocities at the end of the step.
    #[inline(always)]
    fn end(&mut self, forces: &mut Forces<S>) {
        forces.begin();
        for row in 0..self.span.grid.rows {
            self.forces::<false>(row, forces, &mut Largest::none());
            let Some(course) = self.courses.get_mut(row) else { break };
            arrive(self.span.h, course, forces);
        }
        *self.evaluations += 1;
    }

    /// Mean forces from the nodes of a row.
    #[inline(always)]
    fn forces<const LOOK: bool>(&mut self, row: usize, forces: &mut Forces<S>, largest: &mut Largest<S>) {
        let pressure = S::from_f64(0.75) * self.span.pressure;
        let weights = Weights::of(self.span.form, false).times(pressure);
        let Some([course, above]) = self.courses.get_mut(row..).and_then(<[_]>::first_chunk_mut) else {
            return;
        };
        pull_and_push::<S, LOOK>(weights, course, above, forces, largest);
        if course.line.has_beside {
            self.push_beside(row, pressure, |course| &course.ahead, forces);
        }
    }

    /// Adds the forces of those facets that are no cells whose lowest corner is in a row.
    #[inline(always)]
    fn push_beside(
        &self,
        row: usize,
        pressure: S,
        place: impl Fn(&Course<S>) -> &Wide<S>,
        forces: &mut Forces<S>,
    ) {
        for corners in self.span.beside {
            if corners.iter().any(|corner| corner.row < row) || corners.iter().all(|corner| corner.row > row)
            {
                continue;
            }
            let places = corners.each_ref().map(|Corner { row, column, .. }| {
                self.courses.get(*row).map_or(vec3::zero(), |course| get(place(course), column % WIDTH))
            });
            let shares = pressure::corner_shares(self.span.form, places);
            for (corner, share) in corners.iter().zip(shares) {
                let on = if corner.row == row { &mut forces.own } else { &mut forces.over };
                let lane = LEAD + corner.column % WIDTH;
                set(on, lane, vec3::axpy(get(on, lane), pressure, share));
            }
        }
    }
}

/// Bounds on what the forces of springs do to the way, for all steps.
struct Bounds<S> {
    /// The largest factor with which a change of the way returns by them.
    reach: S,
    /// The way by strains of 1 (m): rounding of lengths changes it by EPSILON times as much.
    strained: S,
}

/// Chebyshev's iteration for eigenvalues from 1 to 1 + 2 radius.
struct Chebyshev<S> {
    radius: S,
    /// The middle of the eigenvalues over their radius.
    ratio: S,
    /// Quotient of the last two Chebyshev polynomials at `ratio`.
    quotient: Option<S>,
    /// What an iteration leaves of an error, after some.
    gain: S,
}

impl<S: Scalar> Chebyshev<S> {
    fn new(reach: S) -> Self {
        let radius = S::from_f64(0.5) * reach;
        let ratio = (S::ONE + radius) / radius;
        let gain = S::ONE / (ratio + (ratio * ratio - S::ONE).sqrt());
        Chebyshev { radius, ratio, quotient: None, gain }
    }

    /// Multiples of the residual and of the last change that the next iteration adds.
    fn next(&mut self) -> [S; 2] {
        let Some(last) = self.quotient else {
            self.quotient = Some(S::ONE / self.ratio);
            return [S::ONE / (S::ONE + self.radius), S::ZERO];
        };
        let quotient = S::ONE / (self.ratio + self.ratio - last);
        self.quotient = Some(quotient);
        [(quotient + quotient) / self.radius, quotient * last]
    }
}

/// Iterations from an error to a goal at a rate, [`MAX_UNCHECKED`] at most.
fn iterations<S: Scalar>(rate: S, mut error: S, goal: S) -> usize {
    let mut count = 0;
    while count < MAX_UNCHECKED && error > goal {
        (error, count) = (error * rate, count + 1);
    }
    count
}

/// The `count`-th root of a quotient: the mean reduction by an iteration.
fn mean_rate<S: Scalar>(quotient: S, count: usize) -> S {
    (quotient.ln() / S::from_f64(count.max(1) as f64)).exp()
}
