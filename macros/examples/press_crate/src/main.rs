//! Prints how the ram of a press accelerates under 100 N.

use smartbed_runtime::mechanism::{Fault, Mechanism};

/// `Press`, also called `Model`, its parameters, names and places.
mod press {
    smartbed_macros::mechanism!("models/press.toml", scalar = f32, set = { m = 10.0 });
}

fn main() -> Result<(), Fault> {
    let (mut q_dot, mut u_dot) = ([0.0], [0.0]);
    press::Model::default().rates(0.0, &press::NOMINAL, &[0.0], &[100.0], &mut q_dot, &mut u_dot)?;
    println!("{:.3} m/s^2", u_dot[press::u::u_z]);
    Ok(())
}
