//! Many steps of velocity Verlet of a body that is one grid under constant pressure, its numbers by component from the
//! first step to the last.
//!
//! In: the motion at the start, how many steps. Out: the motion at the end, with the bits that [`Verlet`] gives step by
//! step; the rows keep it, so that the next march need not read it again. A step goes through the grid once: the forces
//! of a row, its second half kick, and at once the first half kick and the drift of the next step, because no row
//! further on asks for its places any more.
//!
//! [`Verlet`]: crate::ode::nodes::method::Verlet

use super::layout::WIDTH;
use super::line::{LEAD, Lanes, Line, Springs, Vectors, Wide, add_sizes, get, larger, push_beside, set, sum};
use super::span::Span;
use crate::flexible::pressure::{self, Weights};
use crate::kernel::Kernel;
use crate::ode::nodes::add_compensated;
use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// Takes steps; returns whether all could be taken. Where one would be refused, or nearly so, the motion is unchanged;
/// steps taken one by one then tell which and why.
#[derive(Debug)]
pub struct March<'a, 'm, S> {
    /// The steps.
    pub span: Span<'a, 'm, S>,
    /// [`Line::new`] of each row and of one more.
    pub lines: &'a mut [Line<S>],
}

impl<S: Scalar> Kernel for March<'_, '_, S> {
    type Output = bool;

    #[inline(always)]
    fn run(mut self) -> bool {
        self.span.begin(self.lines.iter_mut());
        let (h, steps) = (self.span.h, self.span.steps);
        // Sums of sizes: bounds of the largest, and no number where one is none.
        let [mut places, mut speeds] = [[S::ZERO; WIDTH]; 2];
        for line in &mut *self.lines {
            add_sizes(&line.pos, &mut places);
            kick_and_drift(h, line);
            add_sizes(&line.half, &mut speeds);
        }
        let mut forces = [Forces::zero(), Forces::zero()];
        for step in 1..=steps {
            self.step(step == steps, &mut forces);
        }
        let (mut speed, mut stretch) = (sum(&speeds), S::ZERO);
        for forces in &forces {
            speed = forces.speed.as_flattened().iter().fold(speed, |largest, x| larger(*x, largest));
            stretch = forces.stretch.iter().fold(stretch, |largest, x| larger(*x, largest));
        }
        // No place is further off than this at any time.
        let ways = h * S::from_f64(1.001 * steps as f64) * speed;
        let is_near = stretch <= S::ONE && speed <= S::FAR && sum(&places) + ways <= S::FAR;
        is_near && self.span.end(self.lines.iter())
    }
}

impl<S: Scalar> March<'_, '_, S> {
    /// From the middle of a step to that of the next, or to its end if it is the last.
    #[inline(always)]
    fn step(&mut self, is_last: bool, [even, odd]: &mut [Forces<S>; 2]) {
        let Span { beside, form, pressure, .. } = self.span;
        push_beside(beside, form, pressure, self.lines);
        odd.begin(even);
        let (mut forces, mut below) = (even, odd);
        for row in 0..self.span.grid.rows {
            self.row(row, is_last, forces, below);
            core::mem::swap(&mut forces, &mut below);
        }
    }

    /// The same for the nodes of a row.
    #[inline(always)]
    fn row(&mut self, row: usize, is_last: bool, forces: &mut Forces<S>, below: &Forces<S>) {
        let Some([line, above]) = self.lines.get_mut(row..).and_then(<[_]>::first_chunk_mut) else { return };
        let Span { form, pressure, gravity, h, .. } = self.span;
        pull_and_push(Weights::of(form, false), pressure, [line, above], forces, below);
        if is_last && line.has_beside {
            arrive::<S, true, true>(h, gravity, line, forces, below);
        } else if is_last {
            arrive::<S, true, false>(h, gravity, line, forces, below);
        } else if line.has_beside {
            arrive::<S, false, true>(h, gravity, line, forces, below);
        } else if !line.is_still {
            arrive::<S, false, false>(h, gravity, line, forces, below);
        } else {
            forces.speed = below.speed;
        }
    }
}

/// Forces between the nodes of a row and those to their right and above (N), and the largest numbers of all rows so
/// far: in another memory than those of the row below, or they would be written lane by lane where they grow.
#[repr(align(64))]
struct Forces<S> {
    /// On the tails of the springs to the right.
    right: Wide<S>,
    /// On the tails of the springs upwards.
    up: Wide<S>,
    /// On the corners of the cells between this row and the one above.
    cells: [Wide<S>; 4],
    /// Components of velocities half-way (m/s).
    speed: Vectors<S>,
    /// Lengths of springs over that at which one has run away.
    stretch: Lanes<S>,
}

impl<S: Scalar> Forces<S> {
    fn zero() -> Self {
        let row = [[S::ZERO; LEAD + WIDTH]; 3];
        let (speed, stretch) = ([[S::ZERO; WIDTH]; 3], [S::ZERO; WIDTH]);
        Forces { right: row, up: row, cells: [row; 4], speed, stretch }
    }

    /// What lies below the first row: no forces, the largest numbers of the step before.
    #[inline(always)]
    fn begin(&mut self, other: &Forces<S>) {
        let Forces { up, cells: [_, _, c, d], speed, stretch, .. } = self;
        for row in [up, c, d] {
            row.as_flattened_mut().fill(S::ZERO);
        }
        for (speed, other) in speed.iter_mut().zip(&other.speed) {
            *speed = larger_of(speed, other);
        }
        *stretch = larger_of(stretch, &other.stretch);
    }
}

/// Elastic forces of the springs from a row, and those of the cells above it.
#[inline(always)]
fn pull_and_push<S: Scalar>(
    weights: Weights<S>,
    pressure: S,
    [line, above]: [&Line<S>; 2],
    forces: &mut Forces<S>,
    below: &Forces<S>,
) {
    let [a, b, c, d] = &mut forces.cells;
    for lane in 0..WIDTH {
        let [here, right] = [lane, lane + 1].map(|lane| get(&line.pos, lane));
        let [up, across] = [lane, lane + 1].map(|lane| get(&above.pos, lane));
        let (on_tail, one) = pull(&line.right, lane, vec3::sub(right, here));
        set(&mut forces.right, LEAD + lane, on_tail);
        let (on_tail, other) = pull(&line.up, lane, vec3::sub(up, here));
        set(&mut forces.up, LEAD + lane, on_tail);
        forces.stretch[lane] = larger(larger(one, other), below.stretch[lane]);
        // The force of a cell that does not exist is 0.
        let pressure = line.cells[lane] * pressure;
        let shares = pressure::shares(weights, [here, right, across, up]);
        let [on_a, on_b, on_c, on_d] = shares.map(|share| vec3::scale(share, pressure));
        set(a, LEAD + lane, on_a);
        set(b, LEAD + lane, on_b);
        set(c, LEAD + lane, on_c);
        set(d, LEAD + lane, on_d);
    }
}

/// Elastic force (N) on the tail of a spring, and its length over that at which it has run away.
#[inline(always)]
fn pull<S: Scalar>(springs: &Springs<S>, lane: usize, way: Vec3<S>) -> (Vec3<S>, S) {
    let (direction, length) = vec3::direction(way);
    let tension = springs.stiffness[lane] * (length - springs.rest_length[lane]);
    (vec3::scale(direction, tension), length * springs.shortness[lane])
}

/// v += h/2 a; x += h v at the start, forces in `half`.
#[inline(always)]
fn kick_and_drift<S: Scalar>(h: S, line: &mut Line<S>) {
    let half = S::from_f64(0.5) * h;
    for i in 0..3 {
        for lane in 0..WIDTH {
            let kick = half * (line.half[i][lane] * line.inverse_mass[lane]);
            drift(h, line, i, lane, line.vel[i][lane] + kick);
        }
    }
}

/// x += h v, v half-way.
#[inline(always)]
fn drift<S: Scalar>(h: S, line: &mut Line<S>, i: usize, lane: usize, v: S) {
    line.half[i][lane] = v;
    let way = if line.inverse_mass[lane] > S::ZERO { h * v } else { S::ZERO };
    let (x, rest) = (line.pos[i][lane], line.pos_rest[i][lane]);
    (line.pos[i][lane], line.pos_rest[i][lane]) = add_compensated(x, rest, way);
}

/// v += h/2 a at the end of a step and, if it is not the last, what [`kick_and_drift`] does at the start of the next;
/// after the last the forces stand in `half`.
#[inline(always)]
fn arrive<S: Scalar, const LAST: bool, const BESIDE: bool>(
    h: S,
    gravity: Vec3<S>,
    line: &mut Line<S>,
    forces: &mut Forces<S>,
    below: &Forces<S>,
) {
    let half = S::from_f64(0.5) * h;
    let Forces { right, up, cells: [a, b, _, _], speed, .. } = forces;
    let [_, _, c, d] = &below.cells;
    for (i, speed) in speed.iter_mut().enumerate() {
        for (lane, speed) in speed.iter_mut().enumerate() {
            let (left, here) = (LEAD + lane - 1, LEAD + lane);
            // In the order of the lists: weight, springs, cells below and above, facets that are no cells.
            let mut sum = gravity[i] * line.mass[lane];
            sum = (sum - right[i][left]) + right[i][here];
            sum = (sum - below.up[i][here]) + up[i][here];
            sum = (sum + c[i][left]) + d[i][here];
            sum = (sum + b[i][left]) + a[i][here];
            if BESIDE {
                sum = (sum + line.beside[0][i][lane]) + line.beside[1][i][lane];
            }
            let kick = half * (sum * line.inverse_mass[lane]);
            let (start, rest) = (line.vel[i][lane], line.vel_rest[i][lane]);
            let end = line.half[i][lane] + kick;
            let (v, rest) = add_compensated(start, rest, end - start);
            (line.vel[i][lane], line.vel_rest[i][lane]) = (v, rest);
            if LAST {
                line.half[i][lane] = sum;
                *speed = below.speed[i][lane];
            } else {
                drift(h, line, i, lane, v + kick);
                *speed = larger((v + kick).abs(), below.speed[i][lane]);
            }
        }
    }
}

/// The larger of two numbers lane by lane.
#[inline(always)]
fn larger_of<S: Scalar>(a: &Lanes<S>, b: &Lanes<S>) -> Lanes<S> {
    let mut larger_ones = [S::ZERO; WIDTH];
    for lane in 0..WIDTH {
        larger_ones[lane] = larger(a[lane], b[lane]);
    }
    larger_ones
}
