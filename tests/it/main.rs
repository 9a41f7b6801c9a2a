//! The only test binary.

mod agreement;
mod closed_forms;
mod cost;
mod emulator;
mod energy;
mod equation_index;
mod golden;
mod newton_euler_oracle;
mod tile_equations;
mod tile_motion;
