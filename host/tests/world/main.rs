//! Scenes of format 2 as a user runs them.

mod accounts;
mod aims;
mod air;
mod bounces;
mod carried;
mod commanded;
mod conserving;
mod costs;
mod edges;
mod followed;
mod friction;
mod islands;
mod joined;
mod moreau;
mod pinned;
mod reading;
mod rest;
mod rigid;
mod runs;
mod single;
mod sliding;
mod stacks;
mod support;
mod touching;
mod woven;
mod yielding;
