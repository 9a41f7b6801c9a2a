//! The bed's numbers against closed forms, hand-made maps and independent references.

mod dynamics;
mod figure;
mod files;
mod metrics;
mod plan;
mod rest;
mod sheet;
