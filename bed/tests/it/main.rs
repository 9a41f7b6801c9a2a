//! The bed's numbers against closed forms, hand-made maps and independent references.

mod files;
mod metrics;
