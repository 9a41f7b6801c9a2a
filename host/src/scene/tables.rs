//! A scene as Rust constants for the firmware: printed from the simulation that the host steps.
//!
//! In: a [`Simulation`] in single precision before its first step. Out: the text of a Rust file. `Debug` output of the
//! runtime's plain types is a Rust expression, and for an f32 the shortest decimal that reads back to the same bits:
//! the tables hold exactly the host's numbers.

use super::Simulation;
use smartbed_runtime::contact::{ContactLaw, System};
use smartbed_runtime::ode::nodes::{Step, workspace_len};
use std::fmt::Debug;
use std::fmt::Write as _;

/// The constants; `step` is the scene's step (s).
#[must_use]
pub fn rust(simulation: &Simulation<f32>, step: f32) -> String {
    let system = simulation.system();
    let body = &system.body;
    let method = simulation.method();
    let n = body.points();
    let mut text = String::new();
    let mut constant = |name: &str, kind: &str, value: &dyn Debug| {
        let _ = writeln!(text, "pub const {name}: {kind} = {value:?};");
    };
    constant("POINTS", "usize", &n);
    constant("STAGES", "usize", &method.stages());
    constant("SCRATCH", "usize", &workspace_len(n, method.stages()));
    constant("STEP", "f32", &step);
    constant("GRAVITY", "[f32; 3]", &body.gravity);
    constant("AIR_DRAG", "f32", &body.air_drag);
    constant("GROUND", "Option<Ground<f32>>", &system.ground);
    constant("INFLATION", "Option<Inflation<f32>>", &body.inflation);
    let mut table = |name: &str, kind: &str, length: usize, values: &dyn Debug| {
        let _ = writeln!(text, "pub static {name}: [{kind}; {length}] = {values:?};");
    };
    table("MASS", "f32", n, &body.mass);
    table("FIXED", "bool", n, &body.fixed);
    table("SPRINGS", "Spring<f32>", body.springs.len(), &body.springs);
    table("FACETS", "[usize; 4]", body.facets.len(), &body.facets);
    table("MASSLESS", "usize", body.massless.points.len(), &body.massless.points);
    table("LINKS_FROM", "usize", body.massless.first.len(), &body.massless.first);
    table("LINKS", "usize", body.massless.springs.len(), &body.massless.springs);
    table("POS", "[f32; 3]", n, &simulation.pos());
    table("VEL", "[f32; 3]", n, &simulation.vel());
    text + &repertoire(&system, &format!("{method:?}"), method.control_order() > 0)
}

/// The type of the method and of all laws that this scene can use, so that the image links nothing else.
fn repertoire(system: &System<f32>, method: &str, is_adaptive: bool) -> String {
    // `Name`, or `Name(Name { .. })` for a method with parameters.
    let (name, value) =
        method.split_once('(').map_or((method, method), |(name, rest)| (name, rest.trim_end_matches(')')));
    let of = if is_adaptive { "<f32>" } else { "" };
    let law = system.ground.map(|ground| ground.law);
    let met = [
        ("DAMPING", system.is_damped()),
        ("GAS", system.body.inflation.is_some()),
        ("COMPENSATION", matches!(law, Some(ContactLaw::Compensation { .. }))),
        ("ANCHOR", matches!(law, Some(ContactLaw::Compensation { anchor: true, .. }))),
        ("NEWTON", matches!(law, Some(ContactLaw::Newton { .. }))),
        ("MOREAU", matches!(law, Some(ContactLaw::Moreau { .. }))),
        ("MASSLESS", matches!(law, Some(ContactLaw::MasslessPoint))),
        ("SOFT", system.soft_ground().is_some()),
        ("FRICTION", system.rough_ground().is_some()),
    ];
    let mut text = format!("pub const METHOD: {name}{of} = {value};\n");
    let _ = writeln!(text, "impl Repertoire<f32> for Here {{\n    type Method = {name}{of};");
    for (name, is_met) in met {
        let _ = writeln!(text, "    const {name}: bool = {is_met};");
    }
    text + "}\n"
}

#[cfg(test)]
mod tests {
    use super::rust;
    use crate::scene::{Simulation, parse};

    #[test]
    fn numbers_are_those_of_the_simulation() {
        let scene = parse(
            "x",
            "format = 1\nshape = \"chain\"\ndrop_height = 0.1\nmethod = \"energy_momentum\"\n",
            &[],
        )
        .expect("a scene");
        let simulation =
            Simulation::<f32>::new(&scene.lists, &scene.around, scene.method).expect("a simulation");
        let text = rust(&simulation, 1e-3);
        assert!(text.contains("static POS: [[f32; 3]; 2] = [[0.0, 0.0, 0.1], [0.0, 0.0, 1.1]];"), "{text}");
        assert!(text.contains("Spring { tail: 0, head: 1, stiffness: 5000.0,"), "{text}");
        assert!(text.contains("law: Compensation { eta: 1.0,"), "{text}");
        assert!(text.contains("METHOD: EnergyMomentum = EnergyMomentum;"), "{text}");
        assert!(text.contains("const COMPENSATION: bool = true;"), "{text}");
        assert!(text.contains("const GAS: bool = false;"), "{text}");
    }
}
