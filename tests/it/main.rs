//! The only test binary.
mod flexible_reference;
