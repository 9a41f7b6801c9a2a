//! The tile controller: the computations of the chip, testable on the host.
//!
//! `tile` is the controller itself, [`link`] its protocol, [`supervisor`] the other end of it. The demonstration, each
//! millisecond: the commanded heave and slopes ([`command`]) become three heights, a control law
//! ([`control`]) turns them into forces, and the tile's own equations ([`mechanism`], derived from the
//! model at build time) advance by one step ([`simulation`]). Every state goes into a [`digest`], by
//! which host and chip are compared.
//!
//! The image of a mechanism is compiled without the controller (`link`); that of a flexible scene uses only the digest:
//! with the feature `scene` nothing is derived.
//!
//! Invariants: single precision only, no panic, no heap, no recursion, no fused multiply-add; so
//! the host's trajectory is the chip's, bit for bit. A module imports only from those above it.
#![no_std]
// What a step or a tick calls must not panic.
#![cfg_attr(not(test), deny(clippy::unwrap_used, clippy::expect_used, clippy::panic))]

#[cfg(any(test, not(target_os = "none")))]
extern crate std;

#[cfg(all(feature = "model", not(feature = "scene")))]
#[allow(clippy::all, reason = "generated, for scalars that may lack assignment operators")]
pub mod mechanism {
    //! The equations of motion, derived from the model by the build script.
    include!(concat!(env!("OUT_DIR"), "/mechanism.rs"));
    include!(concat!(env!("OUT_DIR"), "/model.rs"));
}

pub mod command;
#[cfg(not(target_os = "none"))]
pub mod console;
pub mod control;
pub mod digest;
pub mod names;
#[cfg(all(feature = "model", not(feature = "scene")))]
pub mod simulation;

#[cfg(feature = "link")]
pub mod defect;
#[cfg(feature = "link")]
pub mod link;
#[cfg(feature = "link")]
pub mod tile;
#[cfg(feature = "link")]
pub mod turns;

#[cfg(all(feature = "controller", not(feature = "scene")))]
pub mod node;
#[cfg(all(feature = "controller", not(feature = "scene")))]
pub mod station;
#[cfg(feature = "link")]
pub mod supervisor;

#[cfg(all(feature = "plant", not(feature = "scene")))]
pub mod plant;

#[cfg(all(feature = "plant", not(feature = "scene")))]
pub mod lockstep;

/// Number of steps of the demonstration that the image runs.
pub const STEPS: u32 = include!(concat!(env!("OUT_DIR"), "/steps.rs"));
