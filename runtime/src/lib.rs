//! Numbers, integrators, flexible bodies, contact and impact: no_std, no heap, no panic.
#![no_std]

pub mod advance;
pub mod body;
pub mod contact;
pub mod ledger;
pub mod mechanism;
pub mod real;
pub mod scene;

/// (path within this crate's `src`, text) of the files that a generated stand-alone crate carries:
/// the numbers and the mechanism trait. They need `libm` and nothing else of this crate.
#[cfg(feature = "source")]
pub const SOURCES: &[(&str, &str)] = &[
    ("mechanism.rs", include_str!("mechanism.rs")),
    ("real/mod.rs", include_str!("real/mod.rs")),
    ("real/counting.rs", include_str!("real/counting.rs")),
    ("real/double.rs", include_str!("real/double.rs")),
    ("real/lane.rs", include_str!("real/lane.rs")),
    ("real/simd.rs", include_str!("real/simd.rs")),
    ("real/single.rs", include_str!("real/single.rs")),
    ("real/sqrt.rs", include_str!("real/sqrt.rs")),
    ("real/trig.rs", include_str!("real/trig.rs")),
];
