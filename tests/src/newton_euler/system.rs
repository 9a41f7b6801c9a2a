//! Newton-Euler per body with the joints solved numerically, dense and in f64.
//!
//! Unknown: acceleration of every free body and one multiplier per joint row.
//! ```text
//!     [ M  J^T ] [ a ]   [ f     ]
//!     [ J  0   ] [-l ] = [ gamma ]      M a = f + J^T l,  J a = gamma
//! ```
//! M = diag(m, I), f = applied forces and the gyroscopic -w x I w. Independent of the generator:
//! nothing here knows generalised coordinates, partial velocities or elimination.

use super::body::{Body, Moving, Pose, Twist};
use super::jet::Jet;
use nalgebra::{DMatrix, DVector, Vector3};

/// A mechanism in maximal coordinates.
pub trait Linkage {
    /// The bodies, with what acts on them.
    fn bodies(&self) -> Vec<Body>;
    /// Where the bodies are.
    fn poses(&self) -> Vec<Pose>;
    /// Joints: rows that are zero at every time.
    fn joints(&self, bodies: &[Moving]) -> Vec<Jet>;
    /// Rolling and other rows linear in the velocities; `rate` is their time derivative.
    fn rolling(&self, _bodies: &[Moving]) -> Vec<Jet> {
        Vec::new()
    }
    /// Rates of all coordinates as read from the bodies (`value` linear in the velocities, `rate` its derivative).
    fn coordinate_rates(&self, bodies: &[Moving]) -> Vec<Jet>;
    /// Which coordinate rates are the independent speeds.
    fn independent(&self) -> Vec<usize>;
    /// Gravity (m/s^2).
    fn gravity(&self) -> Vector3<f64>;
}

/// What the oracle knows about one state.
#[derive(Clone, Debug)]
pub struct Motion {
    /// Rates of all coordinates.
    pub q_dot: Vec<f64>,
    /// Second derivatives of all coordinates.
    pub q_ddot: Vec<f64>,
    /// Rates of the independent speeds.
    pub u_dot: Vec<f64>,
    /// The bodies with velocities and accelerations.
    pub bodies: Vec<Moving>,
    /// One multiplier per row: joints first, then rolling.
    pub multipliers: Vec<f64>,
    /// Force and torque of all joints on each body [N, N m].
    pub reactions: Vec<Twist>,
    /// Kinetic energy (J).
    pub kinetic: f64,
    /// Potential energy of the weights (J); zero with all mass centres at the origin's height.
    pub potential: f64,
    /// Largest joint residual at the given configuration.
    pub residual: f64,
}

/// The motion of a linkage that moves with independent speeds `u`.
///
/// # Panics
/// If the rows do not determine the velocities or accelerations: the oracle's own model is wrong.
#[must_use]
pub fn solve(linkage: &impl Linkage, u: &[f64]) -> Motion {
    let definitions = linkage.bodies();
    let poses = linkage.poses();
    let at_rest: Vec<Moving> = poses.iter().copied().map(Moving::at_rest).collect();
    let residual = linkage.joints(&at_rest).iter().fold(0.0, |worst: f64, row| worst.max(row.value.abs()));
    let velocity_rows = velocity_rows(linkage, &definitions, &at_rest);
    let bodies = solve_velocities(&velocity_rows, &definitions, &at_rest, u);
    let n_rows = velocity_rows.nrows() - u.len();
    solve_accelerations(linkage, &definitions, bodies, &velocity_rows.rows(0, n_rows).into_owned(), residual)
}

/// Writes component `dof` of a twist.
fn component(twist: &mut Twist, dof: usize) -> &mut f64 {
    if dof < 3 { &mut twist.linear[dof] } else { &mut twist.angular[dof - 3] }
}

/// Rows of joints, rolling and independent speeds against every unit velocity.
fn velocity_rows(linkage: &impl Linkage, definitions: &[Body], at_rest: &[Moving]) -> DMatrix<f64> {
    let mut columns = Vec::new();
    for (index, definition) in definitions.iter().enumerate() {
        for dof in 0..definition.n_dof() {
            let mut bodies = at_rest.to_vec();
            *component(&mut bodies[index].velocity, dof) = 1.0;
            let joints = linkage.joints(&bodies).into_iter().map(|row| row.rate);
            let rolling = linkage.rolling(&bodies).into_iter().map(|row| row.value);
            let rates = linkage.coordinate_rates(&bodies);
            let speeds = linkage.independent().into_iter().map(|k| rates[k].value);
            let column: Vec<f64> = joints.chain(rolling).chain(speeds).collect();
            columns.push(DVector::from_vec(column));
        }
    }
    DMatrix::from_columns(&columns)
}

/// Joint and rolling rows = 0, speed rows = u: as many equations as unknown velocities.
fn solve_velocities(rows: &DMatrix<f64>, definitions: &[Body], at_rest: &[Moving], u: &[f64]) -> Vec<Moving> {
    assert!(rows.is_square(), "{} rows for {} velocities", rows.nrows(), rows.ncols());
    let mut right = DVector::zeros(rows.nrows());
    right.rows_mut(rows.nrows() - u.len(), u.len()).copy_from_slice(u);
    let velocities = refined_solution(rows, &right);
    let mut bodies = at_rest.to_vec();
    let mut next = velocities.iter();
    for (body, definition) in bodies.iter_mut().zip(definitions) {
        for dof in 0..definition.n_dof() {
            *component(&mut body.velocity, dof) = *next.next().expect("one velocity per column");
        }
    }
    bodies
}

/// Solution of a regular system by full pivoting, refined twice in the same precision.
fn refined_solution(matrix: &DMatrix<f64>, right: &DVector<f64>) -> DVector<f64> {
    let lu = matrix.clone().full_piv_lu();
    let mut x = lu.solve(right).expect("the oracle's rows must be independent");
    for _ in 0..2 {
        x += lu.solve(&(right - matrix * &x)).expect("same matrix");
    }
    x
}

/// M (with room for the rows), f, and the kinetic and potential energy.
fn masses_and_forces(
    linkage: &impl Linkage,
    definitions: &[Body],
    bodies: &[Moving],
    n_rows: usize,
) -> (DMatrix<f64>, DVector<f64>, [f64; 2]) {
    let size = n_rows + definitions.iter().map(Body::n_dof).sum::<usize>();
    let mut matrix = DMatrix::zeros(size, size);
    let mut right = DVector::zeros(size);
    let mut kinetic = 0.0;
    let mut potential = 0.0;
    let mut first = 0;
    for (body, definition) in bodies.iter().zip(definitions) {
        let mass = definition.mass + definition.added_mass;
        matrix.view_mut((first, first), (3, 3)).fill_diagonal(mass);
        let force = definition.force + linkage.gravity() * definition.mass;
        right.rows_mut(first, 3).copy_from(&force);
        kinetic += 0.5 * mass * body.velocity.linear.norm_squared();
        potential -= definition.mass * linkage.gravity().dot(&body.pose.centre);
        if let Some(inertia) = definition.inertia {
            let inertia = body.pose.rotation * inertia * body.pose.rotation.transpose();
            let w = body.velocity.angular;
            matrix.view_mut((first + 3, first + 3), (3, 3)).copy_from(&inertia);
            right.rows_mut(first + 3, 3).copy_from(&(definition.torque - w.cross(&(inertia * w))));
            kinetic += 0.5 * w.dot(&(inertia * w));
        }
        first += definition.n_dof();
    }
    (matrix, right, [kinetic, potential])
}

/// Assembles and solves the system in this module's first lines.
fn solve_accelerations(
    linkage: &impl Linkage,
    definitions: &[Body],
    mut bodies: Vec<Moving>,
    jacobian: &DMatrix<f64>,
    residual: f64,
) -> Motion {
    let (n_rows, n_dof) = jacobian.shape();
    let (mut matrix, mut right, [kinetic, potential]) =
        masses_and_forces(linkage, definitions, &bodies, n_rows);
    matrix.view_mut((n_dof, 0), (n_rows, n_dof)).copy_from(jacobian);
    matrix.view_mut((0, n_dof), (n_dof, n_rows)).copy_from(&jacobian.transpose());
    let joints = linkage.joints(&bodies).into_iter().map(|row| -row.second);
    let rolling = linkage.rolling(&bodies).into_iter().map(|row| -row.rate);
    for (k, gamma) in joints.chain(rolling).enumerate() {
        right[n_dof + k] = gamma;
    }
    let solution = refined_solution(&matrix, &right);
    let multipliers: Vec<f64> = solution.rows(n_dof, n_rows).iter().map(|x| -x).collect();
    let wrenches = jacobian.transpose() * DVector::from_column_slice(&multipliers);
    let mut reactions = Vec::new();
    let mut k = 0;
    for (body, definition) in bodies.iter_mut().zip(definitions) {
        let mut reaction = Twist::zero();
        for dof in 0..definition.n_dof() {
            *component(&mut body.acceleration, dof) = solution[k];
            *component(&mut reaction, dof) = wrenches[k];
            k += 1;
        }
        reactions.push(reaction);
    }
    let rates = linkage.coordinate_rates(&bodies);
    let q_ddot: Vec<f64> = rates.iter().map(|rate| rate.rate).collect();
    Motion {
        q_dot: rates.iter().map(|rate| rate.value).collect(),
        u_dot: linkage.independent().into_iter().map(|k| q_ddot[k]).collect(),
        q_ddot,
        bodies,
        multipliers,
        reactions,
        kinetic,
        potential,
        residual,
    }
}
