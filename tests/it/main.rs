//! The only test binary.

mod agreement;
mod bar_on_wall;
mod closed_forms;
mod cost;
mod emulator;
mod emulator_scene;
mod energy;
mod equation_index;
mod flexible_energy;
mod flexible_pressure;
mod flexible_reference;
mod flexible_scene;
mod golden;
mod hard_cases;
mod impact_property;
mod newton_euler_oracle;
mod scene_graph;
mod tile_equations;
mod tile_motion;
