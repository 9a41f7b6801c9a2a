//! The only test binary.
mod flexible_reference;
mod bar_on_wall;
mod impact_property;
mod flexible_energy;
mod flexible_pressure;
mod hard_cases;
mod flexible_scene;
