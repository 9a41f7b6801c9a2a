//! Simulation of mechanisms, rigid and flexible bodies with contact, in f32 or f64: no_std, no heap, no panic.
//!
//! In: numbers, equations of motion and bodies in slices of the caller. Out: their state one step later, or a fault
//! that leaves the state as it was. The layers in reading order; a file imports only from layers above its own:
//!
//! - [`real`]: the scalar, with sine, cosine and square root that give the same bits on every machine;
//! - [`kernel`]: loops over many nodes, compiled for several register widths and chosen at run time;
//! - [`vec3`]: vectors of three components;
//! - [`mechanism`]: the trait that generated equations implement;
//! - [`ode`]: one step of any equations of motion, refused or taken as a whole; location of events in time;
//! - [`gas`]: gas in a chamber: pressure, nozzles, energy account;
//! - [`flexible`]: forces and energies of point masses joined by springs, under pressure and gravity;
//! - [`surface`]: shapes and facets that contact detection works on, gaps and gap rates;
//! - [`rigid`]: rigid bodies: pose and momenta, free motion, impact with friction;
//! - [`contact`]: contact laws on the ground, impact with energy compensation, friction;
//! - [`world`]: flexible bodies attached to moving carriers (mechanisms, rigid bodies), in contact with one another;
//! - [`guard`]: shortens a step to the first touch or release;
//! - [`scene`]: the whole step of a flexible body on the ground;
//! - [`ledger`]: energy accounts, which only observe;
//! - [`sensor`]: readings as a controller sees them: sampled, delayed, with seeded noise.
//!
//! Storage belongs to the caller: everything works on slices. Example (also a test): a pendulum over one second in
//! f32, as a microcontroller would compute it:
//!
//! ```
#![doc = include_str!("../tests/example/pendulum.rs")]
//! ```
#![no_std]
// What a step or a tick calls must not panic.
#![cfg_attr(not(test), deny(clippy::unwrap_used, clippy::expect_used, clippy::panic))]

pub mod real;

pub mod kernel;

pub mod vec3;

pub mod mechanism;

pub mod ode;

pub mod gas;

pub mod flexible;

pub mod surface;

pub mod rigid;

pub mod contact;

pub mod world;

pub mod guard;

pub mod scene;

pub mod ledger;

pub mod sensor;

/// Files that a generated stand-alone crate carries, as (path within this crate's `src`, text): the scalars and the
/// mechanism trait. They need `libm` and nothing else of this crate.
#[cfg(feature = "source")]
pub const SOURCES: &[(&str, &str)] = &[
    ("mechanism.rs", include_str!("mechanism.rs")),
    ("real/mod.rs", include_str!("real/mod.rs")),
    ("real/counting.rs", include_str!("real/counting.rs")),
    ("real/double.rs", include_str!("real/double.rs")),
    ("real/lane.rs", include_str!("real/lane.rs")),
    ("real/pair.rs", include_str!("real/pair.rs")),
    ("real/simd.rs", include_str!("real/simd.rs")),
    ("real/single.rs", include_str!("real/single.rs")),
    ("real/sqrt.rs", include_str!("real/sqrt.rs")),
    ("real/trig.rs", include_str!("real/trig.rs")),
];

/// Further files of a stand-alone crate that also steps its mechanism: the integrators, which need [`SOURCES`] only.
/// `ode::nodes`, the methods for nodes of flexible bodies, is left out, and so is its line in `ode/mod.rs`.
#[cfg(feature = "source")]
pub const INTEGRATOR_SOURCES: &[(&str, &str)] = &[
    ("ode/mod.rs", include_str!("ode/mod.rs")),
    ("ode/dormand_prince.rs", include_str!("ode/dormand_prince.rs")),
    ("ode/driven.rs", include_str!("ode/driven.rs")),
    ("ode/method.rs", include_str!("ode/method.rs")),
    ("ode/root.rs", include_str!("ode/root.rs")),
    ("ode/runge_kutta.rs", include_str!("ode/runge_kutta.rs")),
    ("ode/shared_work.rs", include_str!("ode/shared_work.rs")),
    ("ode/splitting.rs", include_str!("ode/splitting.rs")),
    ("ode/state.rs", include_str!("ode/state.rs")),
    ("ode/step_size.rs", include_str!("ode/step_size.rs")),
    ("ode/system.rs", include_str!("ode/system.rs")),
    ("ode/tableau.rs", include_str!("ode/tableau.rs")),
    ("ode/trial.rs", include_str!("ode/trial.rs")),
];
