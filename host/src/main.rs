//! The smartbed command.
fn main() {}
