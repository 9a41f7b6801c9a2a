//! Parts that move together as one set of equations: flexible bodies whose nodes are attached to carriers, in contact.
//!
//! In: a [`Carrier`] (a mechanism with ports, a rigid body, a commanded frame, a [`Group`] of them), flexible bodies,
//! [`Attachment`]s. Out: an [`Island`], one [`Ode`](crate::ode::Ode) of all of them that every method of `ode` can
//! step. A [`World`] steps it with contacts, an [`Observer`] sees what works on what. In each evaluation attached nodes
//! follow the frames of their ports, and the forces on them enter the carrier's equations as wrenches: action and
//! reaction cancel to rounding, and methods keep their order.
//! ```text
//! x_k = O + A r_k,  v_k = v_O + omega x (x_k - O);   force = sum f_k,  moment about O = sum (x_k - O) x f_k
//! ```

mod accounts;
mod attachment;
mod behind;
mod booking;
mod carrier;
mod cell;
mod conjugate;
mod conserving;
mod contacts;
mod detect;
mod extent;
mod group;
mod impact;
mod inertia;
mod island;
mod located;
mod look;
mod observer;
mod over_shape;
mod pressed;
mod relax;
mod round;
mod scenery;
mod step;
mod sweep;
mod thing;
mod whole;
mod yielding;

pub use accounts::Accounts;
pub use attachment::Attachment;
pub use carrier::{Carrier, Commanded, Floating, InverseInertia, Still, Wrench};
pub use cell::{Cell, Content, Wall};
pub use conserving::MeanMemory;
pub use detect::Touch;
pub use extent::Extent;
pub use group::Group;
pub use impact::{Setting, Spare};
pub use inertia::{Coupling, Inertias};
pub use island::{Island, IslandEnergy, Memory};
pub use located::{LocatedMemory, LocatedReport};
pub use observer::{Ends, Forces, Observer, Push, Strike};
pub use pressed::Pressing;
pub use step::StepReport;
pub use sweep::FEW;
pub use thing::{Pair, Place, Thing};
pub use whole::{StepMemory, World};
pub use yielding::Yield;
