//! Numbers, integrators, flexible bodies, contact and impact: no_std, no heap, no panic.
//!
//! The layers, in reading order; a file imports only from layers above its own:
//!
//! - [`real`]: the scalar, with sine, cosine and square root that give the same bits everywhere;
//! - [`kernel`]: loops compiled for the widest registers at hand, chosen when the program runs;
//! - [`vec3`]: three components;
//! - [`mechanism`]: what generated equations implement;
//! - [`ode`]: state, coefficients, one step of any equations of motion, refused or taken as a whole; root location;
//! - [`gas`]: gas in a volume: pressure, valves, accounts;
//! - [`flexible`]: point masses, springs, pressure: forces and energies;
//! - [`surface`]: what can be touched: shapes and facets, gaps and their rates;
//! - [`rigid`]: rigid bodies: pose and momenta, free motion, impact with friction;
//! - [`contact`]: the ground's laws, impact with energy compensation, friction; a body with its contacts frozen;
//! - [`world`]: parts that move together: a flexible body attached to what carries it;
//! - [`guard`]: the step shortened to the first touch or release;
//! - [`scene`]: the whole step of a body on the ground;
//! - [`ledger`]: the accounts of energy, an observer;
//! - [`sensor`]: what a controller sees: sampled, late, noisy from a seed.
//!
//! Storage belongs to the caller: everything works on slices. One test as an example, a pendulum over
//! one second in f32, as a microcontroller would compute it:
//!
//! ```
#![doc = include_str!("../tests/example/pendulum.rs")]
//! ```
#![no_std]

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

/// (path within this crate's `src`, text) of the files that a generated stand-alone crate carries:
/// the numbers and the mechanism trait. They need `libm` and nothing else of this crate.
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

/// The same of the integrators, for a stand-alone crate that steps its mechanism: besides [`SOURCES`] they need nothing.
/// `ode::nodes`, the methods for the nodes of bodies, is not among them, so its line in `ode/mod.rs` is left out.
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
