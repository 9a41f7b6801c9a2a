//! The only test binary.

mod accuracy;
mod agreement;
mod bar_on_wall;
mod bicycle_benchmark;
mod closed_forms;
mod contact_laws;
mod cost;
mod dense_output;
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
mod observed_order;
mod pair_impact;
mod rigid_impact;
mod scene_graph;
mod tile_equations;
mod tile_motion;
