//! A flexible scene on the emulated chip: bitwise equal to the host over several impacts, exact counts.

use crate::emulator::{one_at_a_time, outcome};
use smartbed::firmware::{Arguments, measure};
use smartbed::scene::{Scene, Simulation, open};
use smartbed_firmware::digest::Digest;
use smartbed_runtime::contact::System;
use smartbed_runtime::scene::{Event, Flow, Observer};

/// Counts touches, to check that the run has some.
#[derive(Default)]
struct Touches(usize);

impl Observer<f32> for Touches {
    fn flow(&mut self, _: &System<f32>, _: Flow<f32>) {}
    fn event(&mut self, _: &System<f32>, event: Event<f32>) {
        self.0 += usize::from(event.impact.is_some());
    }
}

fn scene(name: &str, settings: &[String]) -> Scene {
    let path = format!("{}/../models/scenes/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    open(&path, settings).unwrap_or_else(|message| panic!("{message}"))
}

/// Digest of the host's trajectory in f32, stepped by this test's own compiler, and its touches.
fn here(scene: &Scene) -> (Digest, usize) {
    let mut simulation =
        Simulation::<f32>::new(&scene.lists, &scene.around, scene.method).expect("a simulation");
    let step = scene.step as f32;
    let (mut digest, mut touches) = (Digest::default(), Touches::default());
    simulation.begin(step, &mut touches).expect("a start");
    for _ in 0..scene.steps() {
        simulation.step(step, &mut touches).expect("no step is refused");
        digest.add(simulation.pos().as_flattened());
        digest.add(simulation.vel().as_flattened());
    }
    (digest, touches.0)
}

#[test]
fn a_truss_that_hits_the_ground_moves_alike_on_host_and_chip() {
    let _image = one_at_a_time();
    let mut digests = Vec::new();
    for settings in [vec![], vec!["K=4000".to_owned()]] {
        let (digest, touches) = here(&scene("truss", &settings));
        assert!(touches >= 1, "{settings:?}: no impact");
        let arguments =
            Arguments { model: Some("truss".to_owned()), set: settings.clone(), ..Arguments::default() };
        let chip = outcome(&arguments);
        println!(
            "truss {settings:?}: {touches} impacts, step {:?} instructions, {:?} cycles by model",
            chip.step.instructions, chip.step.cycles
        );
        assert_eq!(chip.digest.as_bytes(), digest.hex(), "{settings:?}: this test's own compiler");
        assert_eq!(Some(&chip.digest), chip.host_digest.as_ref(), "{settings:?}: the image's compiler");
        assert_eq!(chip.step.calls, 3000, "3 s at 1 ms");
        assert!(chip.step.instructions[2] > chip.step.instructions[0], "an impact costs more than a flight");
        digests.push(chip.digest);
    }
    assert_ne!(digests[0], digests[1], "a changed stiffness changes both");
}

/// Its constants are rounded by the compiler: the chip has no double precision to do so.
#[test]
fn blanes_and_moans_method_has_the_same_bits_on_host_and_chip() {
    let _image = one_at_a_time();
    let arguments = Arguments {
        model: Some("damper_mass_fixed_end".to_owned()),
        set: vec!["run.method=blanes_moan4".to_owned()],
        steps: Some(100),
        ..Arguments::default()
    };
    let chip = outcome(&arguments);
    assert_eq!(Some(&chip.digest), chip.host_digest.as_ref());
}

#[test]
fn a_method_of_adaptive_step_is_refused() {
    let arguments = Arguments {
        model: Some("truss".to_owned()),
        set: vec!["method=dop853".to_owned()],
        ..Arguments::default()
    };
    let failure = measure(&arguments).expect_err("no fixed step");
    assert_eq!(failure.status(), 1);
    assert!(failure.to_string().contains("--set method=verlet"), "{failure}");
}
