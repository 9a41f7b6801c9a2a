//! Newton-Euler for a drawn mechanism, numerically: m a = f and I alpha + w x I w = tau of every body, constraints by
//! their Jacobian. Everything is affine in the rates, so columns are jets at unit rates:
//!     J q'' = gamma,   Z' (M q'' - f) = 0,   J Z = 0;   M = sum m Kv' Kv + Kw' I Kw,   f = sum Kv' (F - m a0) + ...
//! Rank and null space Z of J come from full pivoting: redundant rows are those that nothing is left of.

use super::description::{Description, Load};
use super::expression::Scalar;
use super::posture::Posture;
use crate::newton_euler::jet::Jet;
use nalgebra::{DMatrix, DVector, Matrix3, Vector3};

/// Pivots below this share of the largest count as 0.
const RANK: f64 = 1e-9;

/// A state: every coordinate (closed forms too) and the independent speeds.
#[derive(Clone, Debug)]
pub struct State {
    /// Time.
    pub t: f64,
    /// All coordinates; what stands for closed forms is not read.
    pub q: Vec<f64>,
    /// Independent speeds.
    pub u: Vec<f64>,
    /// Inputs.
    pub inputs: Vec<f64>,
    /// Parameters.
    pub parameters: Vec<f64>,
}

/// What the oracle knows about a state.
#[derive(Clone, Debug)]
pub struct Answer {
    /// All coordinates.
    pub q: Vec<f64>,
    /// Rates of all coordinates.
    pub q_dot: Vec<f64>,
    /// Rates of the independent speeds.
    pub u_dot: Vec<f64>,
    /// Sizes of the terms that each of them is a sum of.
    pub u_dot_terms: Vec<f64>,
    /// All speeds.
    pub speeds: Vec<f64>,
    /// Their rates, and the sizes of the terms of these.
    pub speeds_dot: [Vec<f64>; 2],
    /// Outputs.
    pub outputs: Vec<f64>,
    /// Kinetic and potential energy.
    pub energy: [f64; 2],
    /// Size of the terms of the potential energy.
    pub potential_terms: f64,
    /// Rank of the constraints.
    pub rank: usize,
    /// Smallest eigenvalue over the largest of the mass matrix of the motions that the constraints leave, each in units
    /// in which it has unit inertia: near 0, or below, where changed moments of inertia are those of no body.
    pub inertia: f64,
    /// Smallest pivot over the largest: of the constraints (zeros apart), and of the independent speeds' share of the
    /// motions that they leave. 0 where a state is singular.
    pub health: f64,
}

/// The mechanism at rest, and with each coordinate of the state moving at unit rate.
struct Evaluated<'a> {
    description: &'a Description,
    state: &'a State,
    moving: Vec<usize>,
    rest: Posture<'a>,
    units: Vec<Posture<'a>>,
}

impl<'a> Evaluated<'a> {
    fn new(description: &'a Description, state: &'a State, moving: Vec<usize>) -> Self {
        let n = moving.len();
        let rest = posture(description, state, &moving, &DVector::zeros(n));
        let unit = |k| {
            posture(description, state, &moving, &DVector::from_fn(n, |i, _| f64::from(u8::from(i == k))))
        };
        let units = (0..n).map(unit).collect();
        Self { description, state, moving, rest, units }
    }

    /// With the given rates of the state's coordinates and no second rates.
    fn posture(&self, rates: &DVector<f64>) -> Posture<'a> {
        posture(self.description, self.state, &self.moving, rates)
    }

    /// Columns and constant part of a list of numbers that is affine in the rates.
    fn affine(&self, of: &dyn Fn(&Posture<'_>) -> Vec<f64>) -> (DMatrix<f64>, DVector<f64>) {
        let constant = DVector::from_vec(of(&self.rest));
        let mut columns = DMatrix::zeros(constant.len(), self.units.len());
        for (k, unit) in self.units.iter().enumerate() {
            columns.set_column(k, &(DVector::from_vec(of(unit)) - &constant));
        }
        (columns, constant)
    }
}

fn posture<'a>(
    description: &'a Description,
    state: &'a State,
    moving: &[usize],
    rates: &DVector<f64>,
) -> Posture<'a> {
    let mut q: Vec<Jet> = state.q.iter().map(|&x| Jet::constant(x)).collect();
    for (&i, &rate) in moving.iter().zip(rates.iter()) {
        q[i].rate = rate;
    }
    Posture::new(description, &state.parameters, &state.inputs, state.t, &q)
}

/// Equations of configuration: zero where they hold.
#[must_use]
pub fn configuration_rows(posture: &Posture<'_>) -> Vec<Jet> {
    let d = posture.description;
    let mut rows: Vec<Jet> = d.configuration.iter().flat_map(|row| row.rows(posture)).collect();
    for (point, place) in d.points.iter().zip(&posture.points) {
        for closure in &point.closures {
            rows.extend((*place - closure.at(posture)).components());
        }
    }
    rows
}

/// All constraints at the level of velocities: what vanishes, and its rate.
fn constraint_rows(posture: &Posture<'_>) -> Vec<Jet> {
    let mut rows: Vec<Jet> = configuration_rows(posture).into_iter().map(Jet::derivative).collect();
    rows.extend(posture.description.motion.iter().flat_map(|row| row.rows(posture)));
    rows
}

fn speed_rows(posture: &Posture<'_>) -> Vec<Jet> {
    posture.description.speeds.iter().map(|speed| speed.value.at(posture)).collect()
}

fn values(rows: Vec<Jet>) -> Vec<f64> {
    rows.into_iter().map(|row| row.value).collect()
}

fn rates(rows: Vec<Jet>) -> DVector<f64> {
    DVector::from_vec(rows.into_iter().map(|row| row.rate).collect())
}

/// Rows J, their null space Z and an inverse J+: J J+ g = g for every g that they reach.
struct Rows {
    rank: usize,
    /// Smallest pivot over the largest.
    health: f64,
    null: DMatrix<f64>,
    inverse: DMatrix<f64>,
}

impl Rows {
    /// Gauss and Jordan with full pivoting, both results refined once.
    fn new(matrix: &DMatrix<f64>) -> Self {
        let (m, n) = matrix.shape();
        let mut reduced = matrix.clone();
        let mut transform = DMatrix::identity(m, m);
        let (mut pivots, mut sizes): (Vec<(usize, usize)>, Vec<f64>) = (Vec::new(), Vec::new());
        while let Some((row, column)) = largest(&reduced, &pivots) {
            let pivot = reduced[(row, column)];
            if pivot.abs() <= RANK * sizes.first().copied().unwrap_or(0.0) || pivot == 0.0 {
                break;
            }
            sizes.push(pivot.abs());
            pivots.push((row, column));
            for all in [&mut transform, &mut reduced] {
                let scaled = all.row(row) / pivot;
                all.set_row(row, &scaled);
            }
            for other in (0..m).filter(|&r| r != row) {
                let factor = reduced[(other, column)];
                for all in [&mut transform, &mut reduced] {
                    let cleared = all.row(other) - all.row(row) * factor;
                    all.set_row(other, &cleared);
                }
            }
        }
        let free: Vec<usize> = (0..n).filter(|c| pivots.iter().all(|(_, p)| p != c)).collect();
        let mut inverse = DMatrix::zeros(n, m);
        let mut null = DMatrix::zeros(n, free.len());
        for &(row, column) in &pivots {
            inverse.set_row(column, &transform.row(row));
            for (k, &c) in free.iter().enumerate() {
                null[(column, k)] = -reduced[(row, c)];
            }
        }
        free.iter().enumerate().for_each(|(k, &c)| null[(c, k)] = 1.0);
        null -= &inverse * (matrix * &null);
        let health = sizes.last().map_or(1.0, |smallest| smallest / sizes[0]);
        Self { rank: pivots.len(), health, null, inverse }
    }

    /// A solution of J x = g, refined.
    fn solve(&self, matrix: &DMatrix<f64>, g: &DVector<f64>) -> DVector<f64> {
        let mut x = &self.inverse * g;
        x += &self.inverse * (g - matrix * &x);
        x
    }
}

/// Place of the largest entry outside the rows and columns of the pivots.
fn largest(matrix: &DMatrix<f64>, pivots: &[(usize, usize)]) -> Option<(usize, usize)> {
    let rows = (0..matrix.nrows()).filter(|r| pivots.iter().all(|(p, _)| p != r));
    let columns = |r| (0..matrix.ncols()).filter(|c| pivots.iter().all(|(_, p)| p != c)).map(move |c| (r, c));
    rows.flat_map(columns).max_by(|a, b| matrix[*a].abs().total_cmp(&matrix[*b].abs()))
}

/// Puts the dependent coordinates on the constraints, Newton from where they are; false where that fails.
#[must_use]
pub fn assemble(description: &Description, state: &mut State) -> bool {
    let dependent: Vec<usize> =
        description.state().into_iter().filter(|&i| !description.coordinates[i].independent).collect();
    for _ in 0..30 {
        let at = Evaluated::new(description, state, dependent.clone());
        let residual = |p: &Posture<'_>| values(configuration_rows(p));
        let now = DVector::from_vec(residual(&at.rest));
        let (jacobian, _) = at.affine(&|p| rates(configuration_rows(p)).as_slice().to_vec());
        if now.is_empty() {
            return true;
        }
        let correction = Rows::new(&jacobian).solve(&jacobian, &now);
        if correction.amax() >= 0.3 || !correction.iter().all(|d| d.is_finite()) {
            return false;
        }
        dependent.iter().zip(correction.iter()).for_each(|(&i, d)| state.q[i] -= d);
        if correction.amax() < 1e-15 || (now.amax() < 1e-15 && correction.amax() < 1e-13) {
            return now.amax() < 1e-13;
        }
    }
    largest_residual(description, state) < 1e-13
}

/// Largest equation of configuration.
#[must_use]
pub fn largest_residual(description: &Description, state: &State) -> f64 {
    let at = Evaluated::new(description, state, description.state());
    let rows = configuration_rows(&at.rest);
    rows.iter().fold(0.0, |m: f64, row| m.max(row.value.abs()))
}

/// Jacobian of the constraints (of configuration first) over the state's coordinates, and how many are of
/// configuration.
#[must_use]
pub fn jacobian(description: &Description, state: &State) -> (DMatrix<f64>, usize) {
    let at = Evaluated::new(description, state, description.state());
    let n = configuration_rows(&at.rest).len();
    (at.affine(&|p| values(constraint_rows(p))).0, n)
}

/// Largest equation of velocity that these rates of the state's coordinates leave.
#[must_use]
pub fn largest_slip(description: &Description, state: &State, q_dot: &[f64]) -> f64 {
    let at = Evaluated::new(description, state, description.state());
    let (jacobian, offset) = at.affine(&|p| values(constraint_rows(p)));
    (jacobian * DVector::from_column_slice(q_dot) + offset).amax()
}

/// Do some equations of configuration follow from the others?
#[must_use]
pub fn is_redundant(description: &Description, state: &State) -> bool {
    let (jacobian, n) = jacobian(description, state);
    let rows = jacobian.rows(0, n).into_owned();
    let empty = rows.row_iter().filter(|row| row.amax() < RANK).count();
    Rows::new(&rows).rank < n - empty
}

/// Do the constraints hold some coordinate where it is?
#[must_use]
pub fn is_locked(description: &Description, state: &State) -> bool {
    let rows = Rows::new(&jacobian(description, state).0);
    rows.null.row_iter().any(|row| row.iter().all(|entry| entry.abs() < RANK))
}

/// Forces on the coordinates (term by term), for velocities `columns` of whatever they act on.
struct Balance {
    mass: DMatrix<f64>,
    force: DVector<f64>,
    terms: DVector<f64>,
    kinetic: f64,
    potential: [f64; 2],
}

impl Balance {
    fn act(&mut self, columns: &DMatrix<f64>, force: Vector3<f64>) {
        let term = columns.transpose() * force;
        self.terms += term.abs();
        self.force += term;
    }
}

fn vector(v: Vector3<f64>) -> Vec<f64> {
    v.as_slice().to_vec()
}

/// Everything about a state.
///
/// # Panics
/// If rates and speeds of a regular state do not determine each other: the oracle is wrong.
#[must_use]
pub fn solve(description: &Description, state: &State) -> Option<Answer> {
    let at = Evaluated::new(description, state, description.state());
    let n = at.moving.len();
    let (jacobian, offset) = at.affine(&|p| values(constraint_rows(p)));
    let (speed_map, speed_offset) = at.affine(&|p| values(speed_rows(p)));
    let rows = Rows::new(&jacobian);
    let free = description.independent_speeds();
    let select = DMatrix::from_fn(free.len(), n, |i, j| speed_map[(free[i], j)]);
    let selected = &select * &rows.null;
    let share = Rows::new(&selected);
    let full = share.rank == free.len() && rows.null.ncols() == free.len();
    let health = if full { rows.health.min(share.health) } else { 0.0 };
    if !full {
        return None;
    }
    // q' = J+ (-b) + Z z with Y q' + y = u.
    let particular = -rows.solve(&jacobian, &offset);
    if (&jacobian * &particular + &offset).amax() > RANK {
        return None; // time prescribes what the constraints do not allow
    }
    let u = DVector::from_column_slice(&state.u);
    let of_free = DVector::from_fn(free.len(), |i, _| speed_offset[free[i]]);
    let reduced = share.solve(&selected, &(u - of_free - &select * &particular));
    let q_dot = &particular + &rows.null * reduced;
    let moving = at.posture(&q_dot);
    let mut balance = balance(&at, &moving);
    let gamma = -rates(constraint_rows(&moving));
    let start = rows.solve(&jacobian, &gamma);
    balance.terms += (&balance.mass * &start).abs();
    let inner = rows.null.transpose() * &balance.mass * &rows.null;
    let units =
        DVector::from_fn(inner.nrows(), |i, _| inner[(i, i)].abs().sqrt().max(f64::MIN_POSITIVE).recip());
    let eigenvalues =
        (DMatrix::from_diagonal(&units) * &inner * DMatrix::from_diagonal(&units)).symmetric_eigenvalues();
    let inverse = inner.clone().try_inverse()?;
    let mut second = start.clone();
    for _ in 0..2 {
        let rest = rows.null.transpose() * (&balance.force - &balance.mass * &second);
        second += &rows.null * (&inverse * rest);
    }
    let bias = rates(speed_rows(&moving));
    let u_ddot = &speed_map * &second + &bias;
    let terms = (&rows.null * &inverse * rows.null.transpose()).abs() * &balance.terms
        + rows.inverse.abs() * gamma.abs();
    let u_terms = speed_map.abs() * terms + bias.abs();
    let pick = |all: &DVector<f64>| free.iter().map(|&i| all[i]).collect::<Vec<f64>>();
    Some(Answer {
        q: moving.q.iter().map(|q| q.value).collect(),
        q_dot: moving.q.iter().map(|q| q.rate).collect(),
        u_dot: pick(&u_ddot),
        u_dot_terms: pick(&u_terms),
        speeds: values(speed_rows(&moving)),
        speeds_dot: [&u_ddot, &u_terms].map(|all| all.as_slice().to_vec()),
        outputs: description.outputs.iter().map(|e| e.at(&moving).value).collect(),
        energy: [balance.kinetic, balance.potential[0]],
        potential_terms: balance.potential[1],
        rank: rows.rank,
        inertia: eigenvalues.min() / eigenvalues.max(),
        health,
    })
}

/// Inertia of the bodies and everything that acts on them.
fn balance(at: &Evaluated<'_>, moving: &Posture<'_>) -> Balance {
    let n = at.moving.len();
    let d = at.description;
    let zero = DVector::zeros(n);
    let mut balance = Balance {
        mass: DMatrix::zeros(n, n),
        force: zero.clone(),
        terms: zero,
        kinetic: 0.0,
        potential: [0.0; 2],
    };
    let gravity = d.gravity.as_ref().map_or_else(Vector3::zeros, |g| g.at(moving).value);
    let number = |e: &Scalar| e.at(moving).value;
    for body in &d.bodies {
        if let Some(mass) = body.mass.as_ref().map(number) {
            let (columns, _) = at.affine(&|p| vector(p.points[body.centre].rate));
            let place = &moving.points[body.centre];
            balance.mass += columns.transpose() * &columns * mass;
            balance.kinetic += 0.5 * mass * place.rate.norm_squared();
            balance.act(&columns, place.second * -mass);
            if body.weight {
                balance.act(&columns, gravity * mass);
                let terms = gravity.component_mul(&place.value) * mass;
                balance.potential[0] -= terms.sum();
                balance.potential[1] += terms.abs().sum();
            }
        }
        if let Some((frame, moments)) = &body.inertia {
            let [xx, yy, zz, xy, xz, yz] = moments.each_ref().map(|m| m.as_ref().map_or(0.0, number));
            let inertia = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
            let axes = moving.frames[*frame].map(|e| e.value);
            let rotation = Matrix3::from_columns(&axes);
            let inertia = rotation * inertia * rotation.transpose();
            let (columns, _) = at.affine(&|p| vector(p.angular_velocity(*frame).value));
            let w = moving.angular_velocity(*frame);
            balance.mass += columns.transpose() * inertia * &columns;
            balance.kinetic += 0.5 * w.value.dot(&(inertia * w.value));
            balance.act(&columns, -(inertia * w.rate));
            balance.act(&columns, -w.value.cross(&(inertia * w.value)));
        }
    }
    d.loads.iter().for_each(|load| act(at, moving, load, &mut balance));
    balance
}

/// What one load does.
fn act(at: &Evaluated<'_>, moving: &Posture<'_>, load: &Load, balance: &mut Balance) {
    let of_point = |i: usize| at.affine(&|p| vector(p.points[i].rate)).0;
    let of_frame = |i: usize| at.affine(&|p| vector(p.angular_velocity(i).value)).0;
    let number = |e: &Scalar| e.at(moving).value;
    match load {
        Load::Force(point, force, reaction) => {
            let force = force.at(moving).value;
            balance.act(&of_point(*point), force);
            reaction.iter().for_each(|other| balance.act(&of_point(*other), -force));
        }
        Load::Torque(frame, torque, reaction) => {
            let torque = torque.at(moving).value;
            balance.act(&of_frame(*frame), torque);
            reaction.iter().for_each(|other| balance.act(&of_frame(*other), -torque));
        }
        Load::Spring([a, b], stiffness, rest, damping) => {
            let line = moving.points[*b] - moving.points[*a];
            let length = line.value.norm();
            let direction = line.value / length;
            let stretch = length - number(rest);
            let tension = number(stiffness) * stretch
                + damping.as_ref().map_or(0.0, number) * line.rate.dot(&direction);
            balance.act(&of_point(*a), direction * tension);
            balance.act(&of_point(*b), direction * -tension);
            let energy = 0.5 * number(stiffness) * stretch * stretch;
            balance.potential[0] += energy;
            balance.potential[1] += energy.abs();
        }
        Load::CoordinateSpring(i, stiffness, rest, damping) => {
            let (columns, _) = at.affine(&|p| vec![p.q[*i].rate]);
            let stretch = moving.q[*i].value - number(rest);
            let damping = damping.as_ref().map_or(0.0, number);
            let term = columns.transpose() * -(number(stiffness) * stretch + damping * moving.q[*i].rate);
            let term = term.column(0).into_owned();
            balance.terms += term.abs();
            balance.force += term;
            let energy = 0.5 * number(stiffness) * stretch * stretch;
            balance.potential[0] += energy;
            balance.potential[1] += energy.abs();
        }
    }
}
