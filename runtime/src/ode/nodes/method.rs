//! Integration methods for [`Newton`]'s equations: each a type of its own, and an enum of all.
//!
//! A program that knows its method names the type and links nothing else (a microcontroller's image); one that
//! chooses at run time takes [`Method`].

use super::motion::Motion;
use super::newton::Newton;
use super::workspace::Workspace;
use super::{damped, midpoint, nystrom, verlet};
use crate::ode::tableau::{self, Tableau};
use crate::real::{Constant, Scalar};

/// One step of a method.
pub trait Step<S: Scalar>: Copy {
    /// Rows of stage memory per node.
    fn stages(&self) -> usize;
    /// Order of the step size control, 0 for fixed steps.
    fn control_order(&self) -> u32 {
        0
    }
    /// Longest step (s) that an adaptive method takes.
    fn longest(&self) -> Option<S> {
        None
    }
    /// Whether the total energy oscillates with the body's vibrations, as Verlet's does.
    fn is_verlet(&self) -> bool {
        false
    }
    /// Advances by tau into `work.end`; returns the error estimate in units of the tolerance (0 for fixed steps).
    ///
    /// # Errors
    /// No convergence, a node whose position or speed is not finite, or a fault of the forces; the start is unchanged.
    fn step<N: Newton<S>>(
        &self,
        newton: &N,
        start: &Motion<S>,
        tau: S,
        work: &mut Workspace<S>,
    ) -> Result<S, N::Fault>;
}

/// v first, then x with the new v: order 1, symplectic.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SymplecticEuler;

/// Velocity Verlet: order 2; dampers are solved implicitly, in half a step before and half a step after.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Verlet;

/// Verlet's method with implicit dampers by conjugate gradients: order 2; only the springs bound its step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DampedVerlet;

/// Nystrom's classical order 4, three evaluations; for forces that depend on positions only (dampers lower the order).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Nystrom4;

/// Blanes & Moan's symplectic splitting of order 4, small error constant; for forces that depend on positions only.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BlanesMoan4;

/// The classical Runge-Kutta method of order 4.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rk4;

/// Implicit midpoint rule: order 2.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ImplicitMidpoint;

/// Midpoint rule with mean forces along the springs (Simo & Tarnow; Gonzalez): order 2, conserves energy exactly.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EnergyMomentum;

/// Dormand & Prince 5(4) with step control.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DormandPrince<S> {
    /// Allowed error per step, absolute and relative.
    pub tolerance: S,
    /// Longest step (s).
    pub longest: S,
}

/// Dormand & Prince 8(5,3) with step control.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dop853<S> {
    /// Allowed error per step, absolute and relative.
    pub tolerance: S,
    /// Longest step (s).
    pub longest: S,
}

/// Implements [`Step`] by an explicit tableau; those with a tolerance choose their steps by the error estimate.
macro_rules! explicit {
    ($($method:ident: $stages:literal stages of $tableau:ident),* $(,)?) => {$(
        impl<S: Scalar> Step<S> for $method {
            fn stages(&self) -> usize {
                $stages
            }
            fn step<N: Newton<S>>(
                &self,
                newton: &N,
                start: &Motion<S>,
                tau: S,
                work: &mut Workspace<S>,
            ) -> Result<S, N::Fault> {
                const TABLEAU: Tableau<Constant, $stages> = tableau::$tableau.rounded();
                nystrom::step(&TABLEAU, newton, start, tau, S::ONE, work)
            }
        }
    )*};
    (adaptive $($method:ident: $stages:literal stages of $tableau:ident, order $order:literal),* $(,)?) => {$(
        impl<S: Scalar> Step<S> for $method<S> {
            fn stages(&self) -> usize {
                $stages
            }
            fn control_order(&self) -> u32 {
                $order
            }
            fn longest(&self) -> Option<S> {
                Some(self.longest)
            }
            fn step<N: Newton<S>>(
                &self,
                newton: &N,
                start: &Motion<S>,
                tau: S,
                work: &mut Workspace<S>,
            ) -> Result<S, N::Fault> {
                const TABLEAU: Tableau<Constant, $stages> = tableau::$tableau.rounded();
                nystrom::step(&TABLEAU, newton, start, tau, self.tolerance, work)
            }
        }
    )*};
}

explicit!(Nystrom4: 3 stages of NYSTROM_4, BlanesMoan4: 7 stages of BLANES_MOAN_4, Rk4: 4 stages of RK4);
explicit!(adaptive
    DormandPrince: 7 stages of DORMAND_PRINCE, order 5,
    Dop853: 12 stages of DOP853, order 8,
);

/// Implements [`Step`] by a function without an error estimate.
macro_rules! plain {
    ($($method:ident: $function:path, $verlet:literal);* $(;)?) => {$(
        impl<S: Scalar> Step<S> for $method {
            fn stages(&self) -> usize {
                1
            }
            fn is_verlet(&self) -> bool {
                $verlet
            }
            fn step<N: Newton<S>>(
                &self,
                newton: &N,
                start: &Motion<S>,
                tau: S,
                work: &mut Workspace<S>,
            ) -> Result<S, N::Fault> {
                $function(newton, start, tau, work).map(|()| S::ZERO)
            }
        }
    )*};
}

plain! {
    SymplecticEuler: verlet::symplectic_euler, false;
    Verlet: verlet::verlet, true;
    DampedVerlet: damped::damped_verlet, false;
    ImplicitMidpoint: midpoint::midpoint, false;
    EnergyMomentum: midpoint::energy_momentum, false;
}

/// A method chosen at run time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Method<S> {
    /// [`SymplecticEuler`].
    SymplecticEuler,
    /// [`Verlet`].
    Verlet,
    /// [`DampedVerlet`].
    DampedVerlet,
    /// [`Nystrom4`].
    Nystrom4,
    /// [`BlanesMoan4`].
    BlanesMoan4,
    /// [`Rk4`].
    Rk4,
    /// [`ImplicitMidpoint`].
    ImplicitMidpoint,
    /// [`EnergyMomentum`].
    EnergyMomentum,
    /// [`DormandPrince`].
    DormandPrince(DormandPrince<S>),
    /// [`Dop853`].
    Dop853(Dop853<S>),
}

/// Evaluates an expression with the value of the chosen method's type.
macro_rules! with_type {
    ($method:expr, $typed:ident => $expression:expr) => {
        match $method {
            Method::SymplecticEuler => with_type!(SymplecticEuler, $typed, $expression),
            Method::Verlet => with_type!(Verlet, $typed, $expression),
            Method::DampedVerlet => with_type!(DampedVerlet, $typed, $expression),
            Method::Nystrom4 => with_type!(Nystrom4, $typed, $expression),
            Method::BlanesMoan4 => with_type!(BlanesMoan4, $typed, $expression),
            Method::Rk4 => with_type!(Rk4, $typed, $expression),
            Method::ImplicitMidpoint => with_type!(ImplicitMidpoint, $typed, $expression),
            Method::EnergyMomentum => with_type!(EnergyMomentum, $typed, $expression),
            Method::DormandPrince(method) => with_type!(*method, $typed, $expression),
            Method::Dop853(method) => with_type!(*method, $typed, $expression),
        }
    };
    ($method:expr, $typed:ident, $expression:expr) => {{
        let $typed = $method;
        $expression
    }};
}

impl<S: Scalar> Step<S> for Method<S> {
    fn stages(&self) -> usize {
        with_type!(self, method => Step::<S>::stages(&method))
    }
    fn control_order(&self) -> u32 {
        with_type!(self, method => Step::<S>::control_order(&method))
    }
    fn longest(&self) -> Option<S> {
        with_type!(self, method => method.longest())
    }
    fn is_verlet(&self) -> bool {
        *self == Method::Verlet
    }
    fn step<N: Newton<S>>(
        &self,
        newton: &N,
        start: &Motion<S>,
        tau: S,
        work: &mut Workspace<S>,
    ) -> Result<S, N::Fault> {
        with_type!(self, method => method.step(newton, start, tau, work))
    }
}
