//! The carriers of flexible parts on the host: mechanisms, floating rigid bodies, fixed frames.

use super::ported::Ported;
use smartbed_runtime::mechanism::Fault;
use smartbed_runtime::real::Scalar;
use smartbed_runtime::surface::Frame;
use smartbed_runtime::world::{Carrier, Floating, InverseInertia, Still, Wrench};
use std::ops::Range;

/// A carrier.
#[derive(Clone, Debug)]
pub enum HostCarrier<S: Scalar = f64> {
    /// A mechanism with the ports in use.
    Mechanism(Box<Ported<S>>),
    /// A rigid body, its axes the one port.
    Floating(Floating<S>),
    /// A frame fixed in space.
    Still(Still<S>),
}

impl<S: Scalar> Carrier<S> for HostCarrier<S> {
    fn n_q(&self) -> usize {
        match self {
            Self::Mechanism(own) => own.n_q(),
            Self::Floating(own) => own.n_q(),
            Self::Still(own) => own.n_q(),
        }
    }

    fn n_u(&self) -> usize {
        match self {
            Self::Mechanism(own) => own.n_u(),
            Self::Floating(own) => own.n_u(),
            Self::Still(own) => own.n_u(),
        }
    }

    fn n_ports(&self) -> usize {
        match self {
            Self::Mechanism(own) => own.n_ports(),
            Self::Floating(own) => own.n_ports(),
            Self::Still(own) => own.n_ports(),
        }
    }

    fn is_damped(&self) -> bool {
        match self {
            Self::Mechanism(own) => own.n_u() > 0,
            Self::Floating(own) => own.is_damped(),
            Self::Still(own) => own.is_damped(),
        }
    }

    fn coupled(&self, port: usize) -> Range<usize> {
        match self {
            Self::Mechanism(own) => own.coupled(),
            Self::Floating(own) => own.coupled(port),
            Self::Still(own) => own.coupled(port),
        }
    }

    fn inverse_inertia(
        &mut self,
        t: S,
        q: &[S],
        u: &[S],
        ports: [usize; 2],
    ) -> Result<InverseInertia<S>, Fault> {
        match self {
            Self::Mechanism(own) => own.inverse_inertia(t, q, u, ports),
            Self::Floating(own) => own.inverse_inertia(t, q, u, ports),
            Self::Still(own) => own.inverse_inertia(t, q, u, ports),
        }
    }

    fn powers(
        &mut self,
        t: S,
        [q, u]: [&[S]; 2],
        (_, wrenches): (&[Frame<S>], &[Wrench<S>]),
        tell: &mut impl FnMut(usize, [S; 2]),
    ) -> Result<(), Fault> {
        if let Self::Mechanism(own) = self {
            tell(0, own.powers(t, q, u, wrenches)?);
        }
        Ok(())
    }

    fn drive_powers(&mut self, frames: &[Frame<S>], wrenches: &[Wrench<S>], tell: &mut impl FnMut(usize, S)) {
        // What moves its own inertia and weight is in its account.
        if let Self::Mechanism(own) = self
            && let Some(power) = own.drive_against(frames, wrenches)
        {
            tell(0, power);
        }
    }

    fn frames(&mut self, t: S, q: &[S], u: &[S], frames: &mut [Frame<S>]) -> Result<(), Fault> {
        match self {
            Self::Mechanism(own) => own.frames(t, q, u, frames),
            Self::Floating(own) => own.frames(t, q, u, frames),
            Self::Still(own) => own.frames(t, q, u, frames),
        }
    }

    fn rates(
        &mut self,
        t: S,
        q: &[S],
        u: &[S],
        wrenches: &[Wrench<S>],
        q_dot: &mut [S],
        u_dot: &mut [S],
    ) -> Result<S, Fault> {
        match self {
            Self::Mechanism(own) => own.rates(t, (q, u), wrenches, (q_dot, u_dot)),
            Self::Floating(own) => own.rates(t, q, u, wrenches, q_dot, u_dot),
            Self::Still(own) => own.rates(t, q, u, wrenches, q_dot, u_dot),
        }
    }

    fn mean_rates(
        &mut self,
        [t, h]: [S; 2],
        q: [&[S]; 3],
        u: [&[S]; 3],
        wrenches: &[Wrench<S>],
        q_dot: &mut [S],
        u_dot: &mut [S],
    ) -> Result<S, Fault> {
        match self {
            Self::Mechanism(own) => {
                own.rates(t + S::from_f64(0.5) * h, (q[1], u[1]), wrenches, (q_dot, u_dot))
            }
            Self::Floating(own) => own.mean_rates([t, h], q, u, wrenches, q_dot, u_dot),
            Self::Still(own) => own.mean_rates([t, h], q, u, wrenches, q_dot, u_dot),
        }
    }

    fn energy(&mut self, t: S, q: &[S], u: &[S]) -> Result<(S, S), Fault> {
        match self {
            Self::Mechanism(own) => own.energy(t, q, u),
            Self::Floating(own) => own.energy(t, q, u),
            Self::Still(own) => own.energy(t, q, u),
        }
    }

    fn project(&mut self, q: &mut [S]) -> Result<S, Fault> {
        match self {
            Self::Mechanism(own) => own.project(q),
            Self::Floating(own) => own.project(q),
            Self::Still(own) => own.project(q),
        }
    }

    fn set_time(&mut self, t: S) {
        if let Self::Mechanism(own) = self {
            own.set_time(t);
        }
    }

    fn projections(&self) -> u8 {
        match self {
            Self::Mechanism(own) => own.projections(),
            Self::Floating(own) => own.projections(),
            Self::Still(own) => own.projections(),
        }
    }
}
