//! The tile of the thesis, chapter 2: three screws, three connectors, one platform.
//!
//! A screw moves along z; its connector turns on it in yaw and pitch (no roll about its rod); the
//! platform's rods, fixed at 120 degrees in it, slide through the connectors. Bodies: screws A, B,
//! C (particles), connectors A, B, C, platform, payload if there is one. 30 rows, 33 velocities.
//! Connector frame Rz(alpha + psi) Ry(theta), x outwards along the rod. Reflected motor inertia
//! resists but does not weigh.

use super::body::{Body, Moving, Pose};
use super::jet::{Jet, JetVector};
use super::joint;
use super::system::{self, Linkage, Motion};
use nalgebra::{Matrix3, Rotation3, Vector3};

/// Directions from the axis to the screws, azimuths 90, 210, 330 degrees.
const SCREW_DIRECTIONS: [[f64; 2]; 3] = [[0.0, 1.0], [-SIN_60, -0.5], [SIN_60, -0.5]];
/// sin 60 degrees, rounded once.
const SIN_60: f64 = 0.866_025_403_784_438_6;
/// The platform in the list of bodies.
pub const PLATFORM: usize = 6;
/// Rows of one leg: 2 of the screw's guide, 4 of the connector's pivot, 4 of the rod.
const ROWS_PER_LEG: usize = 10;

/// Parameters of the tile, in the reference's order and meaning.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Parameters {
    /// Radius of the screws' circle (m).
    pub r: f64,
    /// Screw mass (kg).
    pub ms: f64,
    /// Reflected inertia of the drive on a height (kg), without weight.
    pub mr: f64,
    /// Connector mass (kg).
    pub mc: f64,
    /// Connector inertia about its own axes (kg m^2).
    pub ic: [f64; 3],
    /// Platform mass (kg).
    pub m: f64,
    /// Platform inertia about its own axes (kg m^2).
    pub i: [f64; 3],
    /// Viscous friction of a screw (N s/m).
    pub c: f64,
    /// Gravity, along -z (m/s^2).
    pub g: f64,
}

impl Parameters {
    /// From the reference's array: R ms mr mc Ic1 Ic2 Ic3 M Ix Iy Iz c g.
    ///
    /// # Panics
    /// If there are not 13 numbers.
    #[must_use]
    pub fn new(p: &[f64]) -> Self {
        assert_eq!(p.len(), 13, "R ms mr mc Ic1 Ic2 Ic3 M Ix Iy Iz c g");
        Self {
            r: p[0],
            ms: p[1],
            mr: p[2],
            mc: p[3],
            ic: [p[4], p[5], p[6]],
            m: p[7],
            i: [p[8], p[9], p[10]],
            c: p[11],
            g: p[12],
        }
    }

    /// Weight that the three thrusts carry at rest without load (N).
    #[must_use]
    pub fn weight(&self) -> f64 {
        (3.0 * (self.ms + self.mc) + self.m) * self.g
    }
}

/// What a tile may carry and touch; all zero by default.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Load {
    /// Mass on the platform (kg).
    pub payload: f64,
    /// Its place in the platform's frame (m).
    pub payload_at: [f64; 3],
    /// Stiffness of a spring under each screw (N/m).
    pub support: f64,
    /// Height at which these springs are slack (m).
    pub support_rest: f64,
    /// External force on the platform's centre (N).
    pub force: [f64; 3],
    /// External torque on the platform (N m).
    pub torque: [f64; 3],
    /// Stiffness of the end stops (N/m).
    pub stop: f64,
    /// Heights of the lower and the upper end stop (m).
    pub stops_at: [f64; 2],
}

impl Load {
    /// Force of springs and end stops on a screw at height `h` (N).
    fn on_screw(&self, h: f64) -> f64 {
        let [low, high] = self.stops_at;
        let stop = self.stop * ((low - h).max(0.0) - (h - high).max(0.0));
        stop - self.support * (h - self.support_rest)
    }

    /// Energy of the support spring of one screw (J).
    fn spring_energy(&self, h: f64) -> f64 {
        0.5 * self.support * (h - self.support_rest) * (h - self.support_rest)
    }
}

/// The tile at one configuration.
#[derive(Clone, Debug)]
pub struct Tile {
    /// Its parameters.
    pub parameters: Parameters,
    /// h, psi, theta, s of legs A, B, C.
    pub q: [f64; 12],
    /// Speeds of the screws, for friction (m/s).
    pub h_dot: [f64; 3],
    /// Thrusts of the drives (N).
    pub thrust: [f64; 3],
    /// What it carries.
    pub load: Load,
}

impl Tile {
    /// The oracle's answer.
    #[must_use]
    pub fn solve(&self) -> Motion {
        let mut motion = system::solve(self, &self.h_dot);
        motion.potential += (0..3).map(|leg| self.load.spring_energy(self.q[4 * leg])).sum::<f64>();
        motion
    }

    /// Connector point of a leg.
    #[must_use]
    pub fn connector(&self, leg: usize) -> Vector3<f64> {
        let [x, y] = SCREW_DIRECTIONS[leg];
        Vector3::new(self.parameters.r * x, self.parameters.r * y, self.q[4 * leg])
    }

    /// Rotation of a connector.
    #[must_use]
    pub fn connector_rotation(&self, leg: usize) -> Matrix3<f64> {
        let [x, y] = SCREW_DIRECTIONS[leg];
        let azimuth = Matrix3::new(x, -y, 0.0, y, x, 0.0, 0.0, 0.0, 1.0);
        let yaw = Rotation3::from_axis_angle(&Vector3::z_axis(), self.q[4 * leg + 1]);
        let pitch = Rotation3::from_axis_angle(&Vector3::y_axis(), self.q[4 * leg + 2]);
        azimuth * yaw.into_inner() * pitch.into_inner()
    }

    /// Platform centre as reached through a leg.
    #[must_use]
    pub fn centre_through(&self, leg: usize) -> Vector3<f64> {
        self.connector(leg) + self.rod(leg) * self.q[4 * leg + 3]
    }

    /// Direction of a rod, towards the centre.
    #[must_use]
    pub fn rod(&self, leg: usize) -> Vector3<f64> {
        -self.connector_rotation(leg).column(0).into_owned()
    }

    /// Force of a leg's connector on the platform's rod (N), from the multipliers of `motion`.
    #[must_use]
    pub fn rod_force(&self, motion: &Motion, leg: usize) -> Vector3<f64> {
        let across = self.connector_rotation(leg);
        let row = ROWS_PER_LEG * leg + 8;
        -(across.column(1) * motion.multipliers[row] + across.column(2) * motion.multipliers[row + 1])
    }

    /// Rows of one leg.
    fn leg(&self, bodies: &[Moving], leg: usize) -> Vec<Jet> {
        let (screw, connector, platform) = (&bodies[leg], &bodies[3 + leg], &bodies[PLATFORM]);
        let guide = JetVector::constant(self.connector(leg));
        let off_guide = screw.centre() - guide;
        let up = JetVector::constant(Vector3::z());
        let across = [connector.fixed(Vector3::y()), connector.fixed(Vector3::z())];
        let rod = platform.fixed(rod_in_platform(leg));
        let arm = connector.centre() - platform.centre();
        let mut rows = vec![off_guide.component(0), off_guide.component(1)];
        rows.extend(joint::coincide(&connector.centre(), &screw.centre()));
        rows.push(joint::perpendicular(&across[0], &up));
        rows.extend(across.iter().map(|side| joint::perpendicular(&rod, side)));
        rows.extend(across.iter().map(|side| joint::perpendicular(&arm, side)));
        rows
    }
}

/// Outward direction of a rod in the platform's frame: e1 = -d_A, e3 = (2/sqrt 3) d_A x d_B.
fn rod_in_platform(leg: usize) -> Vector3<f64> {
    [Vector3::x(), Vector3::new(-0.5, SIN_60, 0.0), Vector3::new(-0.5, -SIN_60, 0.0)][leg]
}

impl Linkage for Tile {
    fn bodies(&self) -> Vec<Body> {
        let p = &self.parameters;
        let inertia = |i: [f64; 3]| Matrix3::from_diagonal(&Vector3::from(i));
        let mut bodies = Vec::new();
        for leg in 0..3 {
            let thrust = self.thrust[leg] - p.c * self.h_dot[leg];
            let force = Vector3::new(0.0, 0.0, thrust + self.load.on_screw(self.q[4 * leg]));
            bodies.push(Body { added_mass: p.mr, force, ..Body::particle(p.ms) });
        }
        bodies.extend((0..3).map(|_| Body::rigid(p.mc, inertia(p.ic))));
        let (force, torque) = (self.load.force.into(), self.load.torque.into());
        bodies.push(Body { force, torque, ..Body::rigid(p.m, inertia(p.i)) });
        if self.load.payload != 0.0 {
            bodies.push(Body::particle(self.load.payload));
        }
        bodies
    }

    fn poses(&self) -> Vec<Pose> {
        let [a, b] = [self.rod(0), self.rod(1)];
        let e1 = -a;
        let e3 = a.cross(&b).normalize();
        let rotation = Matrix3::from_columns(&[e1, e3.cross(&e1), e3]);
        let screws = (0..3).map(|leg| Pose::at(self.connector(leg)));
        let connectors =
            (0..3).map(|leg| Pose { centre: self.connector(leg), rotation: self.connector_rotation(leg) });
        let platform = Pose { centre: self.centre_through(0), rotation };
        let mut poses: Vec<Pose> = screws.chain(connectors).chain([platform]).collect();
        if self.load.payload != 0.0 {
            poses.push(Pose::at(platform.centre + rotation * Vector3::from(self.load.payload_at)));
        }
        poses
    }

    fn joints(&self, bodies: &[Moving]) -> Vec<Jet> {
        let mut rows: Vec<Jet> = (0..3).flat_map(|leg| self.leg(bodies, leg)).collect();
        if let Some(payload) = bodies.get(PLATFORM + 1) {
            let seat = bodies[PLATFORM].point(Vector3::from(self.load.payload_at));
            rows.extend(joint::coincide(&payload.centre(), &seat));
        }
        rows
    }

    fn coordinate_rates(&self, bodies: &[Moving]) -> Vec<Jet> {
        let mut rates = Vec::new();
        for leg in 0..3 {
            let connector = &bodies[3 + leg];
            let turning = connector.angular_velocity();
            let arm = connector.centre() - bodies[PLATFORM].centre();
            rates.push(bodies[leg].centre().component(2).derivative());
            rates.push(turning.component(2)); // psi' z + theta' c2 has the z-component psi'
            rates.push(turning.dot(&connector.fixed(Vector3::y())));
            rates.push(arm.dot(&connector.fixed(Vector3::x())).derivative());
        }
        rates
    }

    fn independent(&self) -> Vec<usize> {
        vec![0, 4, 8]
    }

    fn gravity(&self) -> Vector3<f64> {
        Vector3::new(0.0, 0.0, -self.parameters.g)
    }
}
