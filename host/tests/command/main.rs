//! The `smartbed` program as its users run it: answers, messages, exit statuses.

mod bed;
mod bed_in_f32;
mod bed_manual;
mod bed_mesh;
mod bed_page;
mod bed_supervised;
mod browser;
mod check_and_derive;
mod derived_parameters;
mod driven;
mod edges;
mod equilibrium;
mod eval;
mod figure;
mod files;
mod guide;
mod health;
mod hostile_text;
mod import;
mod import_planar;
mod kinds;
mod new_user;
mod nonsense;
mod reference;
mod report;
mod run;
mod scene_errors;
mod scene_manual;
mod schema;
mod settings;
mod support;
#[cfg(feature = "parquet")]
mod sweep_parquet;
mod tile;
mod view;
mod view_world;
