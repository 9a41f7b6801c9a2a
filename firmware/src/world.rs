//! A world on the chip: flexible parts on derived mechanisms and other carriers, in steps of fixed length.
//!
//! In: the tables and equations that `smartbed firmware SCENE` prints for a scene of format 2. Out: the [`Digest`] of
//! the state after each step; on the host the last state too. The runtime's [`Island`] is stepped, or its [`World`]
//! where parts touch, as on the host; an image links only the one that its scene needs. [`world_step`] is a symbol of
//! the image so that the emulator can count it.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[macro_use]
#[allow(unused_macros, reason = "a scene may have no mechanism")]
mod carriers;

use smartbed_firmware::{
    STEPS,
    digest::{Digest, report},
};
use smartbed_runtime::flexible::{Body, Massless};
use smartbed_runtime::mechanism::Fault;
use smartbed_runtime::ode::State;
use smartbed_runtime::rigid::contact::Twist;
use smartbed_runtime::surface::Frame;
use smartbed_runtime::world::{Coupling, Group, Inertias, Island, Memory, StepMemory, Touch, World, Wrench};

/// The world.
#[allow(clippy::all, unused_imports, dead_code, reason = "generated: what a scene names depends on it")]
mod table {
    use smartbed_runtime::flexible::{PressureForm::*, Spring};
    use smartbed_runtime::gas::{Chamber, Gas, GasState, Regulated};
    use smartbed_runtime::mechanism::{Fault, Mechanism};
    use smartbed_runtime::ode::Method::{self, *};
    use smartbed_runtime::rigid::RigidBody;
    use smartbed_runtime::surface::Shape::*;
    use smartbed_runtime::surface::{Capsule, Cuboid, Frame, Sphere};
    use smartbed_runtime::vec3::{self, Vec3};
    use smartbed_runtime::world::Content::*;
    use smartbed_runtime::world::Thing::{self, *};
    use smartbed_runtime::world::{
        Attachment, Carrier, Cell, Floating, InverseInertia, Pair, Place, Still, Wall, Wrench,
    };

    include!(concat!(env!("OUT_DIR"), "/scene.rs"));
}
use table::{
    AIR_DRAG, ANSWERS, ATTACHMENTS, CELLS, CONTACTS, FACETS, GRAVITY, HELD, MASS, METHOD, Member, NODES,
    NUMBERS, PAIRS, PORTS, POS, RESTRAINED, SPRINGS, START, STEP, THINGS, members,
};

/// Scratch numbers of a step.
const SCRATCH: usize = match METHOD {
    Some(method) => method.scratch(NUMBERS),
    None => StepMemory::<f32>::scratch(NUMBERS),
};
/// Ports that contacts may involve: none in a scene without contacts.
const SEEN_PORTS: usize = if METHOD.is_none() { PORTS } else { 0 };
/// Nodes that contacts may involve.
const SEEN_NODES: usize = if METHOD.is_none() { NODES } else { 0 };

/// Takes all steps; returns the digest, and passes the last state to `show`.
fn simulate(show: impl FnOnce(&[f32])) -> Result<Digest, Fault> {
    let body = Body {
        mass: &MASS,
        fixed: &HELD,
        inverse_mass: &[],
        springs: &SPRINGS,
        gravity: GRAVITY,
        air_drag: AIR_DRAG,
        facets: &FACETS,
        inflation: None,
        massless: Massless::default(),
        grids: &[],
        patches: None,
    };
    let (mut pos, mut vel) = (POS, [[0.0; 3]; NODES]);
    let [mut elastic, mut viscous] = [[[0.0; 3]; NODES]; 2];
    let (mut frames, mut wrenches) = ([Frame::inertial(); PORTS], [Wrench::zero(); PORTS]);
    let memory = Memory {
        pos: &mut pos,
        vel: &mut vel,
        elastic: &mut elastic,
        viscous: &mut viscous,
        frames: &mut frames,
        wrenches: &mut wrenches,
    };
    let mut carriers = members();
    let group = Group { members: &mut carriers };
    let island = Island::new(group, body, &ATTACHMENTS, memory)?.with_cells(&CELLS)?;
    let island = island.with_restrained(&RESTRAINED)?;
    let mut world = World { island, things: &THINGS, pairs: &PAIRS };
    let (mut x, mut low) = (START, [0.0; NUMBERS]);
    let mut state = State::resume(&mut x, &mut low)?;
    let [mut first, mut last] = [[Frame::inertial(); SEEN_PORTS]; 2];
    let [mut start, mut free, mut end] = [[Twist::zero(); SEEN_PORTS + SEEN_NODES]; 3];
    let [mut now, mut before] = [[Touch::empty(); CONTACTS]; 2];
    let mut memory = StepMemory {
        scratch: &mut [0.0; SCRATCH],
        frames: [&mut first, &mut last],
        twists: [&mut start, &mut free, &mut end],
        normals: &mut [[0.0; 3]; SEEN_NODES],
        inertias: Inertias {
            couplings: &mut [Coupling::default(); SEEN_PORTS],
            answers: &mut [[[0.0; 6]; 6]; ANSWERS],
            nodes: &mut [0.0; SEEN_NODES],
        },
        // Pairs are declared and few: bounding boxes are not worth their memory.
        extents: &mut [],
        touches: [&mut now, &mut before],
        counts: [0; 2],
    };
    let mut digest = Digest::default();
    for n in 0..STEPS {
        world_step(&mut world, n as f32 * STEP, &mut state, &mut memory)?;
        digest.add(state.x());
    }
    show(state.x());
    Ok(digest)
}

/// One step of the scene's length from `t`.
///
/// # Errors
/// Faults of the method; the state is then the last good one.
#[expect(unsafe_code, reason = "the emulator's plug-in finds the function by its plain name")]
#[unsafe(no_mangle)]
#[inline(never)]
fn world_step(
    world: &mut World<'_, f32, Group<'_, Member>>,
    t: f32,
    state: &mut State<'_, f32>,
    memory: &mut StepMemory<'_, f32>,
) -> Result<(), Fault> {
    match METHOD {
        Some(method) => method.step(&mut world.island, t, STEP, state, memory.scratch).map(|_| ()),
        None => world.step(t, STEP, state, memory).map(|_| ()),
    }
}

/// Runs all steps and hands the report to `write`; false if a step was refused.
fn demonstrate_with(write: impl FnMut(&[u8]), show: impl FnOnce(&[f32])) -> bool {
    report(simulate(show).ok(), write)
}

/// On the host the last state follows the digest, for comparison with other simulations.
#[cfg(not(target_os = "none"))]
fn main() -> std::process::ExitCode {
    smartbed_firmware::console::print(|text| {
        let mut last = Vec::new();
        let is_done = demonstrate_with(|bytes| text.extend_from_slice(bytes), |x| last = x.to_vec());
        let state: String = last.iter().map(|x| format!(" {x:e}")).collect();
        text.extend_from_slice(format!("state{state}\n").as_bytes());
        is_done
    })
}

/// Runs all steps and hands the report to `write`; false if a step was refused.
#[cfg(target_os = "none")]
fn demonstrate(write: impl FnMut(&[u8])) -> bool {
    demonstrate_with(write, |_| ())
}

#[cfg(target_os = "none")]
#[expect(unsafe_code, reason = "cortex-m-rt asks for an unsafe handler: a hard fault may come anywhere")]
mod chip;
