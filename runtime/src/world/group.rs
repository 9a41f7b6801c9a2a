//! Several carriers as one: their coordinates, speeds and ports follow one another.

use core::ops::Range;

use super::carrier::{Carrier, InverseInertia, Wrench};
use crate::mechanism::Fault;
use crate::real::Scalar;
use crate::surface::Frame;

/// Carriers that act on one another only through the parts that they carry.
#[derive(Debug)]
pub struct Group<'a, C> {
    /// The carriers.
    pub members: &'a mut [C],
}

/// Cuts the first `n` entries off a list.
fn cut<'x, T>(list: &mut &'x [T], n: usize) -> Result<&'x [T], Fault> {
    let (first, rest) = list.split_at_checked(n).ok_or(Fault::Shape)?;
    *list = rest;
    Ok(first)
}

fn cut_mut<'x, T>(list: &mut &'x mut [T], n: usize) -> Result<&'x mut [T], Fault> {
    let (first, rest) = core::mem::take(list).split_at_mut_checked(n).ok_or(Fault::Shape)?;
    *list = rest;
    Ok(first)
}

fn cut_all<'x, T>([one, two, three]: &mut [&'x [T]; 3], n: usize) -> Result<[&'x [T]; 3], Fault> {
    Ok([cut(one, n)?, cut(two, n)?, cut(three, n)?])
}

impl<C> Group<'_, C> {
    /// The member that has a port, with the numbers of its first coordinate, speed and port.
    fn find<S: Scalar>(&self, port: usize) -> Option<([usize; 3], &C)>
    where
        C: Carrier<S>,
    {
        let mut first = [0; 3];
        for member in self.members.iter() {
            if port < first[2] + member.n_ports() {
                return Some((first, member));
            }
            first = [first[0] + member.n_q(), first[1] + member.n_u(), first[2] + member.n_ports()];
        }
        None
    }

    /// Lets each member write its rates under the wrenches at its ports; returns the worst pivot.
    fn each_rates<S: Scalar>(
        &mut self,
        mut wrenches: &[Wrench<S>],
        [mut q_dot, mut u_dot]: [&mut [S]; 2],
        mut rates: impl FnMut(&mut C, &[Wrench<S>], [&mut [S]; 2]) -> Result<S, Fault>,
    ) -> Result<S, Fault>
    where
        C: Carrier<S>,
    {
        let mut worst = S::ONE;
        for member in self.members.iter_mut() {
            let dot = [cut_mut(&mut q_dot, member.n_q())?, cut_mut(&mut u_dot, member.n_u())?];
            let wrenches = cut(&mut wrenches, member.n_ports())?;
            let pivot = rates(member, wrenches, dot)?.abs();
            // A minimum would lose NaN.
            worst = if pivot < worst || !pivot.is_finite() { pivot } else { worst };
        }
        Ok(worst)
    }
}

impl<S: Scalar, C: Carrier<S>> Carrier<S> for Group<'_, C> {
    fn n_q(&self) -> usize {
        self.members.iter().map(Carrier::n_q).sum()
    }
    fn n_u(&self) -> usize {
        self.members.iter().map(Carrier::n_u).sum()
    }
    fn n_ports(&self) -> usize {
        self.members.iter().map(Carrier::n_ports).sum()
    }
    fn is_damped(&self) -> bool {
        self.members.iter().any(Carrier::is_damped)
    }
    fn coupled(&self, port: usize) -> Range<usize> {
        let Some(([.., first], member)) = self.find(port) else { return 0..0 };
        let Range { start, end } = member.coupled(port - first);
        first + start..first + end
    }
    fn inverse_inertia(
        &mut self,
        t: S,
        mut q: &[S],
        mut u: &[S],
        [seen, at]: [usize; 2],
    ) -> Result<InverseInertia<S>, Fault> {
        let mut first = 0;
        for member in self.members.iter_mut() {
            let (own_q, own_u) = (cut(&mut q, member.n_q())?, cut(&mut u, member.n_u())?);
            let ports = first..first + member.n_ports();
            if ports.contains(&seen) && ports.contains(&at) {
                return member.inverse_inertia(t, own_q, own_u, [seen - first, at - first]);
            }
            first = ports.end;
        }
        Ok([[S::ZERO; 6]; 6])
    }
    fn drive_powers(
        &mut self,
        mut frames: &[Frame<S>],
        mut wrenches: &[Wrench<S>],
        tell: &mut impl FnMut(usize, S),
    ) {
        for (number, member) in self.members.iter_mut().enumerate() {
            let n = member.n_ports();
            let (Ok(frames), Ok(wrenches)) = (cut(&mut frames, n), cut(&mut wrenches, n)) else { return };
            member.drive_powers(frames, wrenches, &mut |_, power| tell(number, power));
        }
    }
    fn powers(
        &mut self,
        t: S,
        [mut q, mut u]: [&[S]; 2],
        (mut frames, mut wrenches): (&[Frame<S>], &[Wrench<S>]),
        tell: &mut impl FnMut(usize, [S; 2]),
    ) -> Result<(), Fault> {
        for (number, member) in self.members.iter_mut().enumerate() {
            let n = member.n_ports();
            let state = [cut(&mut q, member.n_q())?, cut(&mut u, member.n_u())?];
            let seams = (cut(&mut frames, n)?, cut(&mut wrenches, n)?);
            member.powers(t, state, seams, &mut |_, powers| tell(number, powers))?;
        }
        Ok(())
    }
    fn frames(&mut self, t: S, mut q: &[S], mut u: &[S], mut frames: &mut [Frame<S>]) -> Result<(), Fault> {
        for member in self.members.iter_mut() {
            let (q, u) = (cut(&mut q, member.n_q())?, cut(&mut u, member.n_u())?);
            member.frames(t, q, u, cut_mut(&mut frames, member.n_ports())?)?;
        }
        Ok(())
    }
    fn rates(
        &mut self,
        t: S,
        mut q: &[S],
        mut u: &[S],
        wrenches: &[Wrench<S>],
        q_dot: &mut [S],
        u_dot: &mut [S],
    ) -> Result<S, Fault> {
        self.each_rates(wrenches, [q_dot, u_dot], |member, wrenches, [q_dot, u_dot]| {
            let (q, u) = (cut(&mut q, member.n_q())?, cut(&mut u, member.n_u())?);
            member.rates(t, q, u, wrenches, q_dot, u_dot)
        })
    }
    fn mean_rates(
        &mut self,
        times: [S; 2],
        mut q: [&[S]; 3],
        mut u: [&[S]; 3],
        wrenches: &[Wrench<S>],
        q_dot: &mut [S],
        u_dot: &mut [S],
    ) -> Result<S, Fault> {
        self.each_rates(wrenches, [q_dot, u_dot], |member, wrenches, [q_dot, u_dot]| {
            let (q, u) = (cut_all(&mut q, member.n_q())?, cut_all(&mut u, member.n_u())?);
            member.mean_rates(times, q, u, wrenches, q_dot, u_dot)
        })
    }
    fn energy(&mut self, t: S, mut q: &[S], mut u: &[S]) -> Result<(S, S), Fault> {
        let mut sum = (S::ZERO, S::ZERO);
        for member in self.members.iter_mut() {
            let (q, u) = (cut(&mut q, member.n_q())?, cut(&mut u, member.n_u())?);
            let (kinetic, potential) = member.energy(t, q, u)?;
            sum = (sum.0 + kinetic, sum.1 + potential);
        }
        Ok(sum)
    }
    fn project(&mut self, mut q: &mut [S]) -> Result<S, Fault> {
        let mut largest = S::ZERO;
        for member in self.members.iter_mut() {
            largest = largest.max(member.project(cut_mut(&mut q, member.n_q())?)?);
        }
        Ok(largest)
    }
    fn project_speeds(&mut self, mut q: &[S], mut u: &mut [S]) -> Result<(), Fault> {
        for member in self.members.iter_mut() {
            let q = cut(&mut q, member.n_q())?;
            member.project_speeds(q, cut_mut(&mut u, member.n_u())?)?;
        }
        Ok(())
    }
    fn set_time(&mut self, t: S) {
        self.members.iter_mut().for_each(|member| member.set_time(t));
    }
    fn projections(&self) -> u8 {
        self.members.iter().map(Carrier::projections).max().unwrap_or(0)
    }
}
