//! Runs the demonstration and prints its digest: on the chip through semihosting, on the host to
//! standard output. The same library, so the same digest.
#![cfg_attr(target_os = "none", no_std, no_main)]

use smartbed_firmware::{STEPS, digest::report, simulation::Simulation};

/// Runs all steps and hands the report to `write`; None if a step was refused.
fn simulate(write: impl FnMut(&[u8])) -> Option<Simulation> {
    let run = |mut simulation: Simulation| simulation.run(STEPS).map(|digest| (digest, simulation));
    let done = Simulation::new().map_err(|fault| (0, fault)).and_then(run).ok();
    report(done.as_ref().map(|(digest, _)| *digest), write);
    done.map(|(_, simulation)| simulation)
}

/// On the host the last state follows the digest, for comparison with other simulations.
#[cfg(not(target_os = "none"))]
fn main() -> std::process::ExitCode {
    smartbed_firmware::console::print(|text| {
        let done = simulate(|bytes| text.extend_from_slice(bytes));
        let state: String = done.iter().flat_map(Simulation::x).map(|x| format!(" {x:e}")).collect();
        text.extend_from_slice(format!("state{state}\n").as_bytes());
        done.is_some()
    })
}

/// Runs all steps and hands the report to `write`; false if a step was refused.
#[cfg(target_os = "none")]
fn demonstrate(write: impl FnMut(&[u8])) -> bool {
    simulate(write).is_some()
}

#[cfg(target_os = "none")]
#[expect(unsafe_code, reason = "cortex-m-rt asks for an unsafe handler: a hard fault may come anywhere")]
mod chip;
