//! Derives the equations of motion.

fn main() {
    smartbed_codegen::build("models/pendulum.toml", &smartbed_codegen::Options::default());
}
