//! Implements the relaxation of `settle::relax` for worlds of flexible parts.

use super::methods::{Contacts, RELAXED};
use super::{CarriedWorld, Place};
use crate::world::engine::Settled;
use crate::world::relaxing::Relaxing;
use crate::world::settle::relax;
use smartbed_runtime::mechanism::Fault;
use smartbed_runtime::ode::{Ode, State};
use smartbed_runtime::real::Scalar;
use smartbed_runtime::vec3;
use smartbed_runtime::world::{Accounts as Works, Carrier};

/// A scalar in which rest is found or not.
pub trait Settle: Scalar {
    /// Goes to static equilibrium from the start.
    ///
    /// # Errors
    /// Why there is none, in words.
    fn settle(world: &mut CarriedWorld<Self>) -> Result<Settled, String>;
}

impl Settle for f64 {
    fn settle(world: &mut CarriedWorld) -> Result<Settled, String> {
        relax(world)
    }
}

impl Settle for f32 {
    fn settle(_: &mut CarriedWorld<f32>) -> Result<Settled, String> {
        Err("settle: the search for rest needs f64, because rounding in f32 exceeds its tolerance".to_owned())
    }
}

impl Relaxing for CarriedWorld {
    fn vector(&self) -> Vec<f64> {
        self.x.clone()
    }

    fn split(&self) -> usize {
        self.split()
    }

    fn masses(&self) -> Vec<f64> {
        // Speeds of carriers have different units: each counts as those of a mass of 1 kg.
        let carriers = self.carriers.iter().map(Carrier::n_u).sum::<usize>();
        let free = self.fixed.mass.iter().zip(&self.fixed.held).filter(|(_, held)| !**held);
        std::iter::repeat_n(1.0, carriers).chain(free.flat_map(|(mass, _)| [*mass; 3])).collect()
    }

    fn owners(&self) -> Vec<usize> {
        let carriers = self.carriers.iter().enumerate();
        let mut owners: Vec<usize> =
            carriers.flat_map(|(number, carrier)| std::iter::repeat_n(number, carrier.n_u())).collect();
        for (number, place) in self.places.iter().enumerate() {
            let Place::Nodes(nodes, ..) = place else { continue };
            let free = self.fixed.held[nodes.clone()].iter().filter(|held| !**held).count();
            owners.extend(std::iter::repeat_n(self.carriers.len() + number, 3 * free));
        }
        owners
    }

    fn name(&self, owner: usize) -> String {
        let own = |(part, place): (usize, &Place)| match place {
            Place::Carrier(carrier, _) => *carrier == owner,
            Place::Nodes(..) => self.carriers.len() + part == owner,
            Place::Shape(..) => false,
        };
        let part = self.places.iter().enumerate().position(own);
        part.and_then(|part| self.names.get(part)).cloned().unwrap_or_default()
    }

    fn fastest_frame(&self) -> f64 {
        let speeds =
            self.starts.iter().flat_map(|f| [vec3::norm(f.velocity), vec3::norm(f.angular_velocity)]);
        speeds.fold(0.0, f64::max)
    }

    fn gravity(&self) -> f64 {
        vec3::norm(self.fixed.gravity)
    }

    fn advance(&mut self, x: &mut [f64], low: &mut [f64]) -> Result<(f64, f64), Fault> {
        let h = self.h;
        if self.contacts != Contacts::None {
            return Ok((h, self.step_touching(h, (x, low), true, &mut Vec::new())?.leaving));
        }
        let mut scratch = vec![0.0; RELAXED.scratch(x.len())];
        self.with(|island| {
            let mut state = State::resume(x, low)?;
            RELAXED.step(&mut Standing(island), 0.0, h, &mut state, &mut scratch).map(|_| (h, 0.0))
        })
    }

    fn restart(&mut self, x: Vec<f64>) {
        self.low = vec![0.0; x.len()];
        (self.x, self.t) = (x, 0.0);
        self.forget_volumes();
        self.works = Works::empty();
    }
}

/// The same equations with time fixed at 0.
struct Standing<O>(O);

impl<O: Ode<f64>> Ode<f64> for Standing<O> {
    fn n_x(&self) -> usize {
        self.0.n_x()
    }

    fn n_q(&self) -> usize {
        self.0.n_q()
    }

    fn rates(&mut self, _: f64, x: &[f64], x_dot: &mut [f64]) -> Result<f64, Fault> {
        self.0.rates(0.0, x, x_dot)
    }

    fn coordinate_rates(&mut self, _: f64, x: &[f64], x_dot: &mut [f64]) -> Result<f64, Fault> {
        self.0.coordinate_rates(0.0, x, x_dot)
    }

    fn is_damped(&self) -> bool {
        self.0.is_damped()
    }

    fn set_time(&mut self, _: f64) {
        self.0.set_time(0.0);
    }

    fn project(&mut self, x: &mut [f64]) -> Result<f64, Fault> {
        self.0.project(x)
    }

    fn projections(&self) -> u8 {
        self.0.projections()
    }
}
