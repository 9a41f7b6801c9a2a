//! Everything of the runtime that can be judged from outside.

mod by_blocks;
mod conserving;
mod double_double;
mod flexible;
mod flexible_impact;
mod flexible_methods;
mod functions;
mod gas;
mod grid;
mod integrator;
mod island;
mod layering;
mod located;
mod massless;
mod narrow;
mod random;
mod rigid_scene;
mod scenery;
mod sensor;
mod several;
mod sides;
mod state;
mod surface;
mod systems;
mod vector;
mod world;
