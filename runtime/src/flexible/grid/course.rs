//! A row of a grid over a step of the energy-momentum method, as [`super::Conserve`] keeps it.
//!
//! In: the row at the start of the step, the ways of its nodes and of those above it. Out: the mean forces, better
//! ways, the row at the end.

use super::layout::{Grid, WIDTH};
use super::line::{Corner, LEAD, Lanes, Line, Springs, Vectors, Wide, get, larger, set};
use crate::flexible::pressure::{self, Weights};
use crate::ode::nodes::add_compensated;
use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// A row of nodes over a step.
#[derive(Clone, Debug)]
#[repr(C, align(64))]
pub struct Course<S> {
    /// The row at the start of the step.
    pub(super) line: Line<S>,
    /// The way of the nodes over the step (m).
    pub(super) way: Wide<S>,
    /// Positions after two thirds of the way (m).
    pub(super) ahead: Wide<S>,
    /// Last change of the way by the iteration (m).
    turn: Vectors<S>,
    /// The way by velocities and constant forces (m).
    free: Vectors<S>,
    /// Forces that do not depend on the way (N).
    constant: Vectors<S>,
    /// h^2/2 over the mass (s^2/kg).
    pub(super) mobility: Lanes<S>,
    /// Lengths of the springs to the right.
    pub(super) right: Lengths<S>,
    /// Lengths of the springs upwards.
    pub(super) up: Lengths<S>,
}

/// Lengths of a row's springs in one direction, l at the start of the step and l' at its end.
#[derive(Clone, Debug)]
pub(super) struct Lengths<S> {
    /// l (m).
    start: Lanes<S>,
    /// 1/l' (1/m).
    inverse: Lanes<S>,
    /// 1/(l + l') (1/m).
    inverse_sum: Lanes<S>,
}

impl<S: Scalar> Course<S> {
    /// A row of a grid, see [`Line::new`].
    #[must_use]
    pub fn new(grid: &Grid<S>, row: usize, inverse_mass: &[Vec3<S>], beside: &[[Corner; 4]]) -> Self {
        let (lanes, wide) = ([S::ZERO; WIDTH], [[S::ZERO; LEAD + WIDTH]; 3]);
        let lengths = Lengths { start: lanes, inverse: lanes, inverse_sum: lanes };
        Course {
            line: Line::new(grid, row, inverse_mass, beside),
            way: wide,
            ahead: wide,
            turn: [lanes; 3],
            free: [lanes; 3],
            constant: [lanes; 3],
            mobility: lanes,
            right: lengths.clone(),
            up: lengths,
        }
    }
}

/// The largest numbers of an iteration, lane by lane.
pub(super) struct Largest<S> {
    /// Components of the residual (m).
    residual: Lanes<S>,
    /// Components of the way (m).
    way: Lanes<S>,
    /// What an inverse length y leaves: |1 - l^2 y^2|.
    inverse: Lanes<S>,
    /// Lengths of springs over that at which one has run away.
    stretch: Lanes<S>,
}

impl<S: Scalar> Largest<S> {
    #[inline(always)]
    pub(super) fn none() -> Self {
        let lanes = [S::ZERO; WIDTH];
        Largest { residual: lanes, way: lanes, inverse: lanes, stretch: lanes }
    }

    pub(super) fn numbers(&self) -> [S; 4] {
        [&self.residual, &self.way, &self.inverse, &self.stretch]
            .map(|lanes| lanes.iter().fold(S::ZERO, |largest, x| larger(*x, largest)))
    }
}

/// Forces from a row of nodes (N).
#[repr(align(64))]
pub(super) struct Forces<S> {
    /// On the tails of the springs to the right.
    right: Wide<S>,
    /// On the right lower corners of the cells above the row.
    lower: Wide<S>,
    /// On their right upper corners.
    upper: Wide<S>,
    /// On the nodes of the row, as tails of springs upwards and as left lower corners.
    pub(super) own: Wide<S>,
    /// On the nodes of the row above, as heads of these springs and as left upper corners.
    pub(super) over: Wide<S>,
    /// On the nodes of the row, by what is below it.
    carried: Vectors<S>,
}

impl<S: Scalar> Forces<S> {
    pub(super) fn zero() -> Self {
        let wide = [[S::ZERO; LEAD + WIDTH]; 3];
        Forces {
            right: wide,
            lower: wide,
            upper: wide,
            own: wide,
            over: wide,
            carried: [[S::ZERO; WIDTH]; 3],
        }
    }

    /// Nothing is below the first row.
    #[inline(always)]
    pub(super) fn begin(&mut self) {
        self.carried.as_flattened_mut().fill(S::ZERO);
    }

    /// The forces on the tails of a node's springs, and on the corners of the cell to the right above it.
    #[inline(always)]
    pub(super) fn set(&mut self, lane: usize, [right, up]: [Vec3<S>; 2], [a, b, c, d]: [Vec3<S>; 4]) {
        set(&mut self.right, LEAD + lane, right);
        set(&mut self.lower, LEAD + lane, b);
        set(&mut self.upper, LEAD + lane, c);
        set(&mut self.own, LEAD + lane, vec3::add(up, a));
        set(&mut self.over, LEAD + lane, vec3::sub(d, up));
    }

    /// The sum on a node of the row. What is carried to the row above takes the place of what was carried to it.
    #[inline(always)]
    fn on(&mut self, i: usize, lane: usize) -> S {
        let (left, here) = (LEAD + lane - 1, LEAD + lane);
        let sum = (self.right[i][here] - self.right[i][left]) + (self.own[i][here] + self.lower[i][left]);
        let sum = sum + self.carried[i][lane];
        self.carried[i][lane] = self.over[i][here] + self.upper[i][left];
        sum
    }
}

/// Length of a spring at the start of a step, and a first guess of the others.
#[inline(always)]
pub(super) fn measure<S: Scalar>(lengths: &mut Lengths<S>, lane: usize, way: Vec3<S>) {
    let length = vec3::norm(way);
    // Where there is no spring there may be no length; any guess is good then.
    let inverse = S::ONE / if length > S::ZERO { length } else { S::ONE };
    lengths.start[lane] = length;
    lengths.inverse[lane] = inverse;
    lengths.inverse_sum[lane] = S::from_f64(0.5) * inverse;
}

/// Mean forces of the springs from a row, and of the cells above it.
#[inline(always)]
pub(super) fn pull_and_push<S: Scalar, const LOOK: bool>(
    weights: Weights<S>,
    course: &mut Course<S>,
    above: &Course<S>,
    forces: &mut Forces<S>,
    largest: &mut Largest<S>,
) {
    let Course { line, way, ahead, right: to_right, up: upwards, .. } = course;
    for lane in 0..WIDTH {
        let [here, right] = [lane, lane + 1].map(|lane| [get(&line.pos, lane), get(way, lane)]);
        let up = [get(&above.line.pos, lane), get(&above.way, lane)];
        let to_right = pull::<S, LOOK>(&line.right, to_right, lane, [here, right], largest);
        let upwards = pull::<S, LOOK>(&line.up, upwards, lane, [here, up], largest);
        let [here, right] = [lane, lane + 1].map(|lane| get(ahead, lane));
        let [up, across] = [lane, lane + 1].map(|lane| get(&above.ahead, lane));
        let shares = pressure::quad_shares(weights.times(line.cells[lane]), [here, right, across, up]);
        forces.set(lane, [to_right, upwards], shares);
    }
}

/// Mean force (N) on the tail of a spring, K ((l + l')/2 - L) (d + d')/(l + l'), from the places of its nodes at the
/// start of the step and their ways.
#[inline(always)]
fn pull<S: Scalar, const LOOK: bool>(
    springs: &Springs<S>,
    lengths: &mut Lengths<S>,
    lane: usize,
    [tail, head]: [[Vec3<S>; 2]; 2],
    largest: &mut Largest<S>,
) -> Vec3<S> {
    // Newton's factors are not to fall below `least`, so that both inverses stay positive however bad a guess was.
    let [half, two, least] = [0.5, 2.0, 0.25].map(S::from_f64);
    let before = vec3::sub(head[0], tail[0]);
    let after = vec3::add(before, vec3::sub(head[1], tail[1]));
    let square = vec3::dot(after, after);
    let (inverse, inverse_sum) = (lengths.inverse[lane], lengths.inverse_sum[lane]);
    let off = S::ONE - (square * inverse) * inverse;
    let inverse = inverse * larger(S::ONE + half * off, least);
    let length = square * inverse;
    let both = lengths.start[lane] + length;
    let inverse_sum = inverse_sum * larger(two - both * inverse_sum, least);
    (lengths.inverse[lane], lengths.inverse_sum[lane]) = (inverse, inverse_sum);
    let (stiffness, rest_length) = (springs.stiffness[lane], springs.rest_length[lane]);
    if LOOK {
        // Where there is no spring, lengths may be anything.
        let exists = stiffness > S::ZERO;
        let found = [off.abs(), length * springs.shortness[lane]];
        let [off, stretch] = found.map(|x| if exists { x } else { S::ZERO });
        largest.inverse[lane] = larger(largest.inverse[lane], off);
        largest.stretch[lane] = larger(largest.stretch[lane], stretch);
    }
    let pull = stiffness * (half - rest_length * inverse_sum);
    vec3::scale(vec3::add(before, after), pull)
}

/// The way by velocities and constant forces, with which a step begins.
#[inline(always)]
pub(super) fn set_out<S: Scalar>(h: S, gravity: &Vec3<S>, course: &mut Course<S>, forces: &mut Forces<S>) {
    for (i, gravity) in gravity.iter().enumerate() {
        for lane in 0..WIDTH {
            let force = *gravity * course.line.mass[lane] + forces.on(i, lane);
            let moves = course.line.inverse_mass[lane] > S::ZERO;
            let coast = if moves { h * course.line.vel[i][lane] } else { S::ZERO };
            let way = coast + course.mobility[lane] * force;
            (course.constant[i][lane], course.free[i][lane]) = (force, way);
            (course.way[i][lane], course.turn[i][lane]) = (way, S::ZERO);
            course.ahead[i][lane] = course.line.pos[i][lane] + S::from_f64(2.0 / 3.0) * way;
        }
    }
}

/// The next way of a row.
#[inline(always)]
pub(super) fn improve<S: Scalar, const LOOK: bool>(
    [by_residual, by_turn]: [S; 2],
    course: &mut Course<S>,
    forces: &mut Forces<S>,
    largest: &mut Largest<S>,
) {
    for i in 0..3 {
        for lane in 0..WIDTH {
            let by_force = course.mobility[lane] * forces.on(i, lane);
            let way = course.way[i][lane];
            let residual = (course.free[i][lane] - way) + by_force;
            let turn = by_residual * residual + by_turn * course.turn[i][lane];
            let way = way + turn;
            (course.way[i][lane], course.turn[i][lane]) = (way, turn);
            course.ahead[i][lane] = course.line.pos[i][lane] + S::from_f64(2.0 / 3.0) * way;
            if LOOK {
                largest.residual[lane] = larger(largest.residual[lane], residual.abs());
                largest.way[lane] = larger(largest.way[lane], way.abs());
            }
        }
    }
}

/// Places and velocities at the end of the step, both by the same force.
#[inline(always)]
pub(super) fn arrive<S: Scalar>(h: S, course: &mut Course<S>, forces: &mut Forces<S>) {
    for (i, constant) in course.constant.iter().enumerate() {
        for (lane, constant) in constant.iter().enumerate() {
            let inverse_mass = course.line.inverse_mass[lane];
            let change = h * ((*constant + forces.on(i, lane)) * inverse_mass);
            let (v, rest) = (course.line.vel[i][lane], course.line.vel_rest[i][lane]);
            (course.line.vel[i][lane], course.line.vel_rest[i][lane]) = add_compensated(v, rest, change);
            let way = h * v + S::from_f64(0.5) * h * change;
            let way = if inverse_mass > S::ZERO { way } else { S::ZERO };
            let (x, rest) = (course.line.pos[i][lane], course.line.pos_rest[i][lane]);
            (course.line.pos[i][lane], course.line.pos_rest[i][lane]) = add_compensated(x, rest, way);
        }
    }
}
