//! The interface of parts that carry others: its state gives the frames of its ports, and wrenches at the ports enter
//! its equations.

use core::ops::Range;

use crate::mechanism::Fault;
use crate::real::Scalar;
use crate::rigid::attitude::Attitude;
use crate::rigid::contact::Mobility;
use crate::rigid::{RigidBody, RigidState};
use crate::surface::Frame;
use crate::vec3::{self, Vec3};

/// Force and moment about the origin of a port's frame, components in N (N, N m).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wrench<S> {
    /// Force.
    pub force: Vec3<S>,
    /// Moment.
    pub moment: Vec3<S>,
}

impl<S: Scalar> Wrench<S> {
    /// No wrench.
    #[must_use]
    pub fn zero() -> Self {
        Wrench { force: vec3::zero(), moment: vec3::zero() }
    }

    /// Adds a force at a point (N, m, both in N) about the origin of a frame.
    pub fn add_force(&mut self, frame: &Frame<S>, point: Vec3<S>, force: Vec3<S>) {
        self.force = vec3::add(self.force, force);
        self.moment = vec3::add(self.moment, vec3::cross(vec3::sub(point, frame.origin), force));
    }

    /// Power at a frame that moves (W).
    #[must_use]
    pub fn power(&self, frame: &Frame<S>) -> S {
        vec3::dot(self.force, frame.velocity) + vec3::dot(self.moment, frame.angular_velocity)
    }
}

/// J M^-1 J' between two ports: changes of velocity and angular velocity of one (rows) by force and moment impulses
/// about the origin of the other (columns), all in N.
pub type InverseInertia<S> = [[S; 6]; 6];

/// Equations of motion with ports, frames at which wrenches act.
pub trait Carrier<S: Scalar> {
    /// Number of coordinates q.
    fn n_q(&self) -> usize;
    /// Number of speeds u.
    fn n_u(&self) -> usize;
    /// Number of ports.
    fn n_ports(&self) -> usize;
    /// The ports that an impulse at this port moves, including itself.
    fn coupled(&self, port: usize) -> Range<usize> {
        let _ = port;
        0..self.n_ports()
    }
    /// J M^-1 J' at a state: the response of port `ports[0]` to an impulse at `ports[1]`.
    ///
    /// # Errors
    /// [`Fault::Shape`] if a slice has not the stated length.
    fn inverse_inertia(
        &mut self,
        t: S,
        q: &[S],
        u: &[S],
        ports: [usize; 2],
    ) -> Result<InverseInertia<S>, Fault>;
    /// Tells, by member of a group, the power (W) that the drive of its commanded motion supplies because of wrenches
    /// at its ports, given the frames of the ports.
    fn drive_powers(&mut self, frames: &[Frame<S>], wrenches: &[Wrench<S>], tell: &mut impl FnMut(usize, S)) {
        let _ = (frames, wrenches, tell);
    }
    /// Tells, by member of a group, all power (W) that its drives and actuators give and that its dampers take, at a
    /// state [q, u] under wrenches at its ports, given the frames of the ports.
    ///
    /// # Errors
    /// [`Fault::Shape`] if a slice has not the stated length.
    fn powers(
        &mut self,
        t: S,
        [q, u]: [&[S]; 2],
        (frames, wrenches): (&[Frame<S>], &[Wrench<S>]),
        tell: &mut impl FnMut(usize, [S; 2]),
    ) -> Result<(), Fault> {
        let _ = (t, q, u);
        self.drive_powers(frames, wrenches, &mut |member, power| tell(member, [power, S::ZERO]));
        Ok(())
    }
    /// Writes the frames of the ports, with their motion.
    ///
    /// # Errors
    /// [`Fault::Shape`] if a slice has not the stated length.
    fn frames(&mut self, t: S, q: &[S], u: &[S], frames: &mut [Frame<S>]) -> Result<(), Fault>;
    /// Writes q_dot and u_dot under a wrench at each port; returns the worst pivot (1 if there is none).
    ///
    /// # Errors
    /// [`Fault::Shape`] if a slice has not the stated length.
    fn rates(
        &mut self,
        t: S,
        q: &[S],
        u: &[S],
        wrenches: &[Wrench<S>],
        q_dot: &mut [S],
        u_dot: &mut [S],
    ) -> Result<S, Fault>;
    /// Writes mean rates over a step from t of length h, so that the end is the start plus h times them. In: [t, h], q
    /// and u at the start, middle and end; wrenches as means over the step, about the mean origins of the frames.
    /// Returns the worst pivot.
    ///
    /// Default: rates at the middle (order 2), for carriers without mean rates that conserve energy.
    ///
    /// # Errors
    /// As [`Carrier::rates`].
    fn mean_rates(
        &mut self,
        [t, h]: [S; 2],
        [_, q, _]: [&[S]; 3],
        [_, u, _]: [&[S]; 3],
        wrenches: &[Wrench<S>],
        q_dot: &mut [S],
        u_dot: &mut [S],
    ) -> Result<S, Fault> {
        self.rates(t + S::from_f64(0.5) * h, q, u, wrenches, q_dot, u_dot)
    }
    /// Whether the rates of its speeds depend on its speeds at given wrenches.
    fn is_damped(&self) -> bool {
        self.n_u() > 0
    }
    /// Kinetic and potential energy (J).
    ///
    /// # Errors
    /// [`Fault::Shape`] if a slice has not the stated length.
    fn energy(&mut self, t: S, q: &[S], u: &[S]) -> Result<(S, S), Fault>;
    /// One correction of q towards the constraints; returns the largest residual before it.
    ///
    /// # Errors
    /// [`Fault::Shape`] if `q` has not the stated length.
    fn project(&mut self, q: &mut [S]) -> Result<S, Fault> {
        let _ = q;
        Ok(S::ZERO)
    }
    /// One correction of the speeds towards the constraints, where more of them are state than are independent (see
    /// [`Mechanism::project_speeds`](crate::mechanism::Mechanism::project_speeds)).
    ///
    /// # Errors
    /// [`Fault::Shape`] if a slice has not the stated length.
    fn project_speeds(&mut self, q: &[S], u: &mut [S]) -> Result<(), Fault> {
        let _ = (q, u);
        Ok(())
    }
    /// Sets the time (s) of the next corrections.
    fn set_time(&mut self, t: S) {
        let _ = t;
    }
    /// Corrections after each step: 0 without constraints, else 1, at most 2.
    fn projections(&self) -> u8 {
        0
    }
}

/// Frames that move as commanded, whatever wrenches act on them: `law(t, port)`. The drive supplies the power of the
/// wrenches with the opposite sign.
#[derive(Clone, Copy, Debug)]
pub struct Commanded<F> {
    /// The commanded motion.
    pub law: F,
    /// Number of ports.
    pub ports: usize,
}

impl<S: Scalar, F: Fn(S, usize) -> Frame<S>> Carrier<S> for Commanded<F> {
    fn n_q(&self) -> usize {
        0
    }
    fn n_u(&self) -> usize {
        0
    }
    fn n_ports(&self) -> usize {
        self.ports
    }
    fn coupled(&self, _: usize) -> Range<usize> {
        0..0
    }
    fn inverse_inertia(&mut self, _: S, _: &[S], _: &[S], _: [usize; 2]) -> Result<InverseInertia<S>, Fault> {
        Ok([[S::ZERO; 6]; 6])
    }
    fn drive_powers(&mut self, frames: &[Frame<S>], wrenches: &[Wrench<S>], tell: &mut impl FnMut(usize, S)) {
        let seams = frames.iter().zip(wrenches);
        tell(0, seams.fold(S::ZERO, |sum, (frame, wrench)| sum - wrench.power(frame)));
    }
    fn frames(&mut self, t: S, _: &[S], _: &[S], frames: &mut [Frame<S>]) -> Result<(), Fault> {
        frames.iter_mut().enumerate().for_each(|(port, frame)| *frame = (self.law)(t, port));
        Ok(())
    }
    fn rates(
        &mut self,
        _: S,
        _: &[S],
        _: &[S],
        _: &[Wrench<S>],
        _: &mut [S],
        _: &mut [S],
    ) -> Result<S, Fault> {
        Ok(S::ONE)
    }
    fn energy(&mut self, _: S, _: &[S], _: &[S]) -> Result<(S, S), Fault> {
        Ok((S::ZERO, S::ZERO))
    }
}

/// A frame at rest in N: space itself, or a rigid part fixed in it.
#[derive(Clone, Copy, Debug)]
pub struct Still<S>(pub Frame<S>);

impl<S: Scalar> Carrier<S> for Still<S> {
    fn n_q(&self) -> usize {
        0
    }
    fn n_u(&self) -> usize {
        0
    }
    fn n_ports(&self) -> usize {
        1
    }
    fn coupled(&self, _: usize) -> Range<usize> {
        0..0
    }
    fn inverse_inertia(&mut self, _: S, _: &[S], _: &[S], _: [usize; 2]) -> Result<InverseInertia<S>, Fault> {
        Ok([[S::ZERO; 6]; 6])
    }
    fn frames(&mut self, _: S, _: &[S], _: &[S], frames: &mut [Frame<S>]) -> Result<(), Fault> {
        frames.fill(self.0);
        Ok(())
    }
    fn rates(
        &mut self,
        _: S,
        _: &[S],
        _: &[S],
        _: &[Wrench<S>],
        _: &mut [S],
        _: &mut [S],
    ) -> Result<S, Fault> {
        Ok(S::ONE)
    }
    fn energy(&mut self, _: S, _: &[S], _: &[S]) -> Result<(S, S), Fault> {
        Ok((S::ZERO, S::ZERO))
    }
}

/// A free rigid body; its one port has the body's axes and its centre of mass as origin.
///
/// q = [position, Euler parameters], u = [velocity, angular momentum in N]; e_dot = (e, W)/2 with W in body axes.
#[derive(Clone, Copy, Debug)]
pub struct Floating<S> {
    /// Mass and inertia.
    pub body: RigidBody<S>,
    /// Acceleration of gravity (m/s^2).
    pub gravity: Vec3<S>,
}

impl<S: Scalar> Floating<S> {
    /// The rigid body's state from q and u.
    ///
    /// # Errors
    /// [`Fault::Shape`] if a slice has the wrong length.
    pub fn state(&self, q: &[S], u: &[S]) -> Result<RigidState<S>, Fault> {
        let ([x, y, z, e0, e1, e2, e3], [vx, vy, vz, hx, hy, hz]) = (q, u) else { return Err(Fault::Shape) };
        Ok(RigidState {
            position: [*x, *y, *z],
            velocity: [*vx, *vy, *vz],
            attitude: Attitude::new([*e0, *e1, *e2, *e3]),
            angular_momentum: [*hx, *hy, *hz],
        })
    }
}

impl<S: Scalar> Carrier<S> for Floating<S> {
    fn n_q(&self) -> usize {
        7
    }
    fn n_u(&self) -> usize {
        6
    }
    fn n_ports(&self) -> usize {
        1
    }
    /// Its speeds are velocity and angular momentum in N, which only forces and moments change.
    fn is_damped(&self) -> bool {
        false
    }
    fn inverse_inertia(&mut self, _: S, q: &[S], u: &[S], _: [usize; 2]) -> Result<InverseInertia<S>, Fault> {
        let mobility = Mobility::of(&self.body, &self.state(q, u)?);
        let mut inverse = [[S::ZERO; 6]; 6];
        for (axis, row) in mobility.inverse_inertia.into_iter().enumerate() {
            inverse[axis][axis] = mobility.inverse_mass;
            for (column, entry) in row.into_iter().enumerate() {
                inverse[3 + axis][3 + column] = entry;
            }
        }
        Ok(inverse)
    }
    fn frames(&mut self, _: S, q: &[S], u: &[S], frames: &mut [Frame<S>]) -> Result<(), Fault> {
        let own = self.body.frame(&self.state(q, u)?);
        frames.iter_mut().for_each(|frame| *frame = own);
        Ok(())
    }
    fn rates(
        &mut self,
        _: S,
        q: &[S],
        u: &[S],
        wrenches: &[Wrench<S>],
        q_dot: &mut [S],
        u_dot: &mut [S],
    ) -> Result<S, Fault> {
        let state = self.state(q, u)?;
        let half = S::from_f64(0.5);
        let [a, b, c] = vec3::scale(state.attitude.to_body(self.body.angular_velocity(&state)), half);
        let [e0, e1, e2, e3] = state.attitude.parameters();
        let turn = [
            -(e1 * a) - e2 * b - e3 * c,
            e0 * a + e2 * c - e3 * b,
            e0 * b + e3 * a - e1 * c,
            e0 * c + e1 * b - e2 * a,
        ];
        let (mut force, mut moment) = (vec3::scale(self.gravity, self.body.mass), vec3::zero());
        for wrench in wrenches {
            force = vec3::add(force, wrench.force);
            moment = vec3::add(moment, wrench.moment);
        }
        let acceleration = vec3::scale(force, S::ONE / self.body.mass);
        q_dot.iter_mut().zip(state.velocity.iter().chain(&turn)).for_each(|(to, from)| *to = *from);
        u_dot.iter_mut().zip(acceleration.iter().chain(&moment)).for_each(|(to, from)| *to = *from);
        Ok(S::ONE)
    }
    /// Rotates by Cayley's map, e' = e (1, h W/2)/|..|, with W the mean of the angular velocities at both ends in body
    /// axes. With M the mean moment, the kinetic energy changes by exactly h W . M (Simo & Wong 1991).
    fn mean_rates(
        &mut self,
        [_, h]: [S; 2],
        [q0, _, q1]: [&[S]; 3],
        [u0, _, u1]: [&[S]; 3],
        wrenches: &[Wrench<S>],
        q_dot: &mut [S],
        u_dot: &mut [S],
    ) -> Result<S, Fault> {
        let pivot = self.rates(S::ZERO, q0, u0, wrenches, q_dot, u_dot)?;
        let (from, to, half) = (self.state(q0, u0)?, self.state(q1, u1)?, S::from_f64(0.5));
        let spin = |state: &RigidState<S>| state.attitude.to_body(self.body.angular_velocity(state));
        let twice = vec3::add(spin(&from), spin(&to));
        let [a, b, c] = vec3::scale(twice, half * half * h);
        let [e0, e1, e2, e3] = from.attitude.parameters();
        let inverse = S::ONE / (S::ONE + (a * a + b * b + c * c)).sqrt();
        let turned = [
            e0 - e1 * a - e2 * b - e3 * c,
            e1 + e0 * a + e2 * c - e3 * b,
            e2 + e0 * b + e3 * a - e1 * c,
            e3 + e0 * c + e1 * b - e2 * a,
        ];
        let velocity = vec3::scale(vec3::add(from.velocity, to.velocity), half);
        let turns = turned.iter().zip([e0, e1, e2, e3]).map(|(to, from)| (*to * inverse - from) / h);
        q_dot.iter_mut().zip(velocity.into_iter().chain(turns)).for_each(|(to, from)| *to = from);
        Ok(pivot)
    }
    fn energy(&mut self, _: S, q: &[S], u: &[S]) -> Result<(S, S), Fault> {
        let state = self.state(q, u)?;
        let height = vec3::dot(self.gravity, state.position);
        Ok((self.body.kinetic(&state), -(self.body.mass * height)))
    }
}
