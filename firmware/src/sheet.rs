//! A sheet in a frame, stepped row by row in single precision; prints the digest of its trajectory.
//!
//! In: constant tables that `smartbed firmware SCENE` prints. Out: the [`Digest`] of every (x, v), node by node, after
//! each step. [`sheet_step`] is a symbol of the image so that the emulator can count it.
#![cfg_attr(target_os = "none", no_std, no_main)]

use smartbed_firmware::{
    STEPS,
    digest::{Digest, report},
};
use smartbed_runtime::flexible::walk::{Lost, Node};

/// The sheet.
#[allow(clippy::all, unused_imports, reason = "generated: a sheet without springs names no tie")]
mod table {
    use smartbed_runtime::flexible::walk::{Sheet, Tie};

    include!(concat!(env!("OUT_DIR"), "/scene.rs"));
}
use table::{INVERSE_MASS, NODES, POS, SHEET, STEP, VEL};

/// Takes all steps.
fn simulate() -> Result<Digest, Lost> {
    let mut nodes = [Node::new([0.0; 3], [0.0; 3], 0.0); NODES];
    for (node, ((pos, vel), inverse_mass)) in nodes.iter_mut().zip(POS.iter().zip(&VEL).zip(&INVERSE_MASS)) {
        *node = Node::new(*pos, *vel, *inverse_mass);
    }
    SHEET.begin(&mut nodes)?;
    let mut digest = Digest::default();
    for _ in 0..STEPS {
        sheet_step(&mut nodes)?;
        for node in &nodes {
            digest.add(&node.pos);
            digest.add(&node.vel);
        }
    }
    Ok(digest)
}

/// One step of the scene's length.
///
/// # Errors
/// As [`smartbed_runtime::flexible::walk::Sheet::step`].
#[expect(unsafe_code, reason = "the emulator's plug-in finds the function by its plain name")]
#[unsafe(no_mangle)]
#[inline(never)]
pub fn sheet_step(nodes: &mut [Node<f32>; NODES]) -> Result<(), Lost> {
    SHEET.step(nodes, STEP)
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
