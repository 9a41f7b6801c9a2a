//! The only test binary.
mod bar_on_wall;
mod flexible_energy;
mod flexible_pressure;
mod flexible_reference;
mod flexible_scene;
mod hard_cases;
mod impact_property;
