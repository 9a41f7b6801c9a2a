//! A flexible scene on the ground, stepped in single precision; prints the digest of its trajectory.
//!
//! In: constant tables that `smartbed firmware SCENE` prints from the same value that the host steps.
//! Out: the [`Digest`] of every (x, v), point by point, after each step of fixed length.
//! [`scene_step`] is a symbol of the image so that the emulator can count it.
#![cfg_attr(target_os = "none", no_std, no_main)]

use smartbed_firmware::{
    STEPS,
    digest::{Digest, report},
};
use smartbed_runtime::contact::compensation::PointImpact;
use smartbed_runtime::contact::{ContactState, System};
use smartbed_runtime::flexible::{Body, BodyError, Massless};
use smartbed_runtime::ode::nodes::{MOTION_ROWS, Motion, Workspace};
use smartbed_runtime::scene::{State, step};

/// The scene.
#[allow(clippy::all, unused_imports, reason = "generated: which variants a scene names depends on it")]
mod table {
    use smartbed_runtime::contact::ContactLaw::*;
    use smartbed_runtime::contact::ForceLaw::*;
    use smartbed_runtime::contact::{Ground, Repertoire};
    use smartbed_runtime::flexible::Gas::*;
    use smartbed_runtime::flexible::PressureForm::*;
    use smartbed_runtime::flexible::{Inflation, Spring};
    use smartbed_runtime::ode::nodes::method::*;

    /// The methods, elements and laws of this scene.
    #[derive(Clone, Copy, Debug)]
    pub struct Here;

    include!(concat!(env!("OUT_DIR"), "/scene.rs"));
}
use table::{
    AIR_DRAG, FACETS, FIXED, GRAVITY, GROUND, Here, INFLATION, LINKS, LINKS_FROM, MASS, MASSLESS, METHOD,
    POINTS, POS, SCRATCH, SPRINGS, STAGES, STEP, VEL,
};

/// Takes all steps.
fn simulate() -> Result<Digest, BodyError<f32>> {
    let body = Body {
        mass: &MASS,
        fixed: &FIXED,
        inverse_mass: &[],
        springs: &SPRINGS,
        gravity: GRAVITY,
        air_drag: AIR_DRAG,
        facets: &FACETS,
        inflation: INFLATION,
        massless: Massless { points: &MASSLESS, first: &LINKS_FROM, springs: &LINKS },
        grids: &[],
        patches: None,
    };
    let system = System::restricted(Body::new(body)?, GROUND);
    let mut memory = [[0.0; 3]; MOTION_ROWS * POINTS];
    let mut scratch = [[0.0; 3]; SCRATCH];
    let mut impacts = [PointImpact::none(); POINTS];
    let mut modes = [ContactState::Free; POINTS];
    let (motion, _) = Motion::cut(&mut memory, POINTS)?;
    motion.pos.iter_mut().zip(&POS).for_each(|(x, start)| *x = *start);
    motion.vel.iter_mut().zip(&VEL).for_each(|(v, start)| *v = *start);
    let mut work = Workspace::new(&mut scratch, POINTS, STAGES)?;
    let mut state = State {
        motion,
        modes: &mut modes,
        impacts: &mut impacts,
        time: [0.0; 2],
        next_step: 0.0,
        anchor: 0.0,
    };
    state.begin(&system, STEP, METHOD, &mut work, &mut ())?;
    let mut digest = Digest::default();
    for _ in 0..STEPS {
        scene_step(&system, &mut state, &mut work)?;
        digest.add(state.motion.pos.as_flattened());
        digest.add(state.motion.vel.as_flattened());
    }
    Ok(digest)
}

/// One step of the scene's length, with its touches and releases.
///
/// # Errors
/// As [`step`]; the state is then the last good one.
#[expect(unsafe_code, reason = "the emulator's plug-in finds the function by its plain name")]
#[unsafe(no_mangle)]
#[inline(never)]
pub fn scene_step<'a>(
    system: &System<f32, Here>,
    state: &mut State<'a, f32>,
    work: &mut Workspace<'a, f32>,
) -> Result<(), BodyError<f32>> {
    step(system, state, STEP, METHOD, work, &mut ()).map(|_| ())
}

/// Runs all steps and hands the report to `write`; false if a step was refused.
fn demonstrate(write: impl FnMut(&[u8])) -> bool {
    report(simulate().ok(), write)
}

#[cfg(not(target_os = "none"))]
fn main() -> std::process::ExitCode {
    smartbed_firmware::console::print(|text| demonstrate(|bytes| text.extend_from_slice(bytes)))
}

#[cfg(target_os = "none")]
#[expect(unsafe_code, reason = "cortex-m-rt asks for an unsafe handler: a hard fault may come anywhere")]
mod chip;
