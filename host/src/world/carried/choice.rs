//! Queries about a world's equations, and functions that replace its method or state, for measurements.

use super::methods::{Contacts, Stepping};
use super::{CarriedWorld, HostCarrier, words};
use smartbed_codegen::diagnostic::Diagnostic;

impl CarriedWorld {
    /// Without contacts: its equations are smooth.
    #[must_use]
    pub fn is_smooth(&self) -> bool {
        self.contacts == Contacts::None
    }

    /// Does a command, a law or a load of a mechanism depend on the time?
    #[must_use]
    pub fn reads_time(&self) -> bool {
        let reads = |own: &HostCarrier| matches!(own, HostCarrier::Mechanism(own) if own.reads_time());
        self.carriers.iter().any(reads)
    }

    /// The kind of its contacts, which restricts the methods.
    #[must_use]
    pub fn contacts(&self) -> Contacts {
        self.contacts
    }

    /// Stability limit of the step (s): the largest that resolves the fastest motion of the flexible parts and of
    /// what holds their nodes, if there is one.
    #[must_use]
    pub fn largest_stable_step(&self) -> Option<f64> {
        self.stable
    }

    /// Chooses the method with this name.
    ///
    /// # Errors
    /// There is none.
    pub fn choose(&mut self, name: &str) -> Result<(), String> {
        let words = |error: Diagnostic| format!("{}; {}", error.message, error.help.unwrap_or_default());
        self.method = self.contacts.method(name).map_err(words)?;
        self.scratch = vec![0.0; self.ode_method().scratch(self.x.len())];
        if let (Some(touching), Stepping::Ode(method)) = (&mut self.touching, self.method.1) {
            touching.choose(method, self.x.len());
        }
        Ok(())
    }

    /// Sets time and state, in the layout of [`CarriedWorld::numbers`].
    ///
    /// # Errors
    /// A state of another size, or one that cannot be assembled.
    pub fn put(&mut self, t: f64, x: &[f64]) -> Result<(), String> {
        if x.len() != self.x.len() {
            return Err(crate::world::engine::other_world());
        }
        self.t = t;
        self.x.copy_from_slice(x);
        self.low.fill(0.0);
        self.with(|mut island| island.place(t, x)).map_err(words)
    }
}
