//! A sheet at rest at a pressure that rises and falls, in single precision; prints the digest of its shapes.
//!
//! In: constant tables that `smartbed firmware SCENE --at-rest` prints. Out: the [`Digest`] of all positions and the
//! volume after each millisecond. [`rest_step`] is a symbol of the image so that the emulator can count it.
#![cfg_attr(target_os = "none", no_std, no_main)]

use smartbed_firmware::{
    STEPS,
    digest::{Digest, report},
};
use smartbed_runtime::flexible::rest::Rest;
use smartbed_runtime::real::Real;

/// The sheet.
mod table {
    include!(concat!(env!("OUT_DIR"), "/scene.rs"));
}
use table::{NODES, PLACES, RANGE, TURN, VOLUME};

const REST: Rest<'static, f32> = Rest { range: RANGE, places: &PLACES, volume: &VOLUME };

/// Takes all steps.
fn simulate() -> Digest {
    let mut pos = [[0.0; 3]; NODES];
    let mut digest = Digest::default();
    for step in 1..=STEPS {
        // Written out: `x.sin_cos()` would mean the standard library's method on a host.
        let (_, cosine) = Real::sin_cos(TURN * step as f32);
        let [low, high] = RANGE;
        let volume = rest_step(low + (high - low) * 0.5 * (1.0 - cosine), &mut pos);
        digest.add(pos.as_flattened());
        digest.add(&[volume]);
    }
    digest
}

/// Positions of the sheet at rest at a pressure (Pa); returns the volume below it (m^3).
#[expect(unsafe_code, reason = "the emulator's plug-in finds the function by its plain name")]
#[unsafe(no_mangle)]
#[inline(never)]
pub fn rest_step(pressure: f32, pos: &mut [[f32; 3]; NODES]) -> f32 {
    REST.place(pressure, pos)
}

/// Runs all steps and hands the report to `write`.
fn demonstrate(write: impl FnMut(&[u8])) -> bool {
    report(Some(simulate()), write)
}

#[cfg(not(target_os = "none"))]
fn main() -> std::process::ExitCode {
    smartbed_firmware::console::print(|text| demonstrate(|bytes| text.extend_from_slice(bytes)))
}

#[cfg(target_os = "none")]
#[expect(unsafe_code, reason = "cortex-m-rt asks for an unsafe handler: a hard fault may come anywhere")]
mod chip;
