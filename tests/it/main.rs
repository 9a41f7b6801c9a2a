//! The only test binary.

mod closed_forms;
mod newton_euler_oracle;
