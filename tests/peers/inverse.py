#!/usr/bin/env python3
"""Inverse dynamics of the six-joint arm beside Pinocchio's recursive Newton-Euler algorithm and CasADi: operations, time and error, one interleaved run.

    python3 tests/peers/inverse.py [--rounds 101]

CasADi gets the recursion in symbols and finds common sub-expressions. The status is 1 if ours takes more than 0.75 of Pinocchio's
time or of CasADi's operations, or if the three differ. What depends on parameters alone is counted on neither side: ours is prepared.
"""
import ctypes
import random
import re
import subprocess

import run

BAR, SAME = 0.75, 1e-12
STATES, CALLS = 64, 20_000
JOINTS = 6

PINOCCHIO = """
#include <pinocchio/algorithm/rnea.hpp>
extern "C" void inverse(const double *in, double *out) {
  for (int i = 0; i < 6; i++) { q[i] = in[i]; v[i] = in[6+i]; tau[i] = in[12+i]; }
  rnea(model, *data, q, v, tau); for (int i = 0; i < 6; i++) out[i] = data->tau[i];
}
"""

ENTRY = """//! Generated equations behind C entries.
#[allow(warnings, reason = "generated")]
mod arm {{ include!("arm.rs"); }}
static mut PREPARED: core::mem::MaybeUninit<arm::Prepared> = core::mem::MaybeUninit::uninit();
fn prepared(x: &[f64]) -> arm::Prepared {{
    arm::prepare(&arm::Parameters {{ {fields} }})
}}
#[inline(always)]
fn torques(x: &[f64], p: &arm::Prepared, out: *mut f64) {{
    let part = |n: usize| -> &[f64; 6] {{ x[6 * n..6 * n + 6].try_into().unwrap() }};
    let found = arm::inverse_dynamics(0.0, part(0), part(1), &[0.0; 6], part(2), p);
    unsafe {{ out.cast::<[f64; 6]>().write(found.{part}) }};
}}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn prepare(input: *const f64) {{
    unsafe {{ (*&raw mut PREPARED).write(prepared(core::slice::from_raw_parts(input, {n_in}))) }};
}}
/// With what depends on parameters alone prepared before.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn inverse(input: *const f64, output: *mut f64) {{
    unsafe {{ torques(core::slice::from_raw_parts(input, {n_in}), (*&raw const PREPARED).assume_init_ref(), output) }};
}}
/// Prepares inside every evaluation, as CasADi's function does.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn whole(input: *const f64, output: *mut f64) {{
    let x = unsafe {{ core::slice::from_raw_parts(input, {n_in}) }};
    torques(x, &prepared(x), output);
}}
"""


def ours(directory, slots):
    """The library, its operations, and those of preparing."""
    import with_smartbed

    source = directory / "inverse" / "src"
    source.mkdir(parents=True, exist_ok=True)
    command = ["cargo", "run", "-q", "--release", "-p", "smartbed", "--", "derive", "models/arm6.toml", "--effort", "all",
               "--answers", "inverse_dynamics", "-o", str(source / "arm.rs")]
    subprocess.run(command, cwd=run.ROOT, check=True)
    text = (source / "arm.rs").read_text()
    operations, preparing = (int(re.search(rf"^// Cost of {name}: (\d+) operations", text, re.MULTILINE).group(1))
                             for name in ("inverse_dynamics", "prepare"))
    names = re.findall(r'"(\w+)"', re.search(r"PARAMETER_NAMES: [^=]*= \[(.*?)\];", text, re.DOTALL).group(1))
    part = re.search(r"pub struct InverseDynamics \{.*?pub (\w+):", text, re.DOTALL).group(1)
    fields = ", ".join(f"{name}: x[{slots.index(name)}]" for name in names)
    (source / "lib.rs").write_text(ENTRY.format(fields=fields, part=part, n_in=len(slots)))
    (source.parent / "Cargo.toml").write_text(with_smartbed.MANIFEST.format(runtime=run.ROOT / "runtime"))
    subprocess.run(["cargo", "build", "-q", "--release", "--offline"], cwd=source.parent, check=True)
    return ctypes.CDLL(str(source.parent / "target" / "release" / "libpeers_ours.so")), operations, preparing


def casadi(directory, slots):
    """CasADi's entry, its operations, and those of them that do not depend on parameters alone."""
    import casadi as ca
    import compare
    import mechanisms
    import with_casadi

    arm = mechanisms.Arm()
    symbols = [ca.SX.sym(name) for name in slots]
    q, u, u_dot, parameters = (symbols[:6], symbols[6:12], symbols[12:18], symbols[18:])
    torques, *_ = arm.recursion(with_casadi.S, q, u, u_dot, dict(zip(slots[18:], parameters)))
    function = ca.Function("f", [ca.vertcat(*symbols)], [ca.cse(ca.vertcat(*torques))], {"cse": True})
    source, operations = with_casadi.compiled(function)
    return compare.compile_c(source, "inverse_casadi", directory).eval, operations, with_casadi.per_evaluation(function, 3 * JOINTS)


def pinocchio(directory):
    """Pinocchio's entry, with the arm of the forward comparison."""
    import numpy
    import with_pinocchio

    library = ctypes.CDLL(str(with_pinocchio.compile_source(with_pinocchio.SOURCE + PINOCCHIO, directory, "inverse_pinocchio")))
    n, rows, gravity = with_pinocchio.joints("arm6")
    array = lambda x: numpy.array(x, float).ctypes.data_as(ctypes.c_void_p)
    library.load(n, array(rows), array(gravity))
    return library.inverse


def measure(directory, rounds):
    """Prints the figures; bars that are missed are returned."""
    import compare
    import states

    values = states.parameters("arm6")
    slots = [f"{letter}{i}" for letter in ("q", "u", "a") for i in range(JOINTS)] + list(values)
    library, operations, preparing = ours(directory, slots)
    theirs, their_operations, moving = casadi(directory, slots)
    numbers = random.Random(1)
    rows = [[numbers.uniform(-2, 2) for _ in range(3 * JOINTS)] + list(values.values()) for _ in range(STATES)]
    flat = (ctypes.c_double * (STATES * len(slots)))(*(x for one in rows for x in one))
    library.prepare(flat)
    entries = {"ours": library.inverse, "ours, preparing inside": library.whole, "Pinocchio": pinocchio(directory), "CasADi": theirs}

    error = 0.0
    for n in range(STATES):
        start = (ctypes.c_double * len(slots)).from_buffer(flat, n * len(slots) * 8)
        found = []
        for function in entries.values():
            out = (ctypes.c_double * JOINTS)()
            function(start, out)
            found.append(list(out))
        size = max(abs(x) for x in found[0])
        error = max(error, *(abs(a - b) / size for other in found[1:] for a, b in zip(found[0], other)))

    timer = compare.timer(directory)
    out, times = (ctypes.c_double * JOINTS)(), {name: [] for name in entries}
    for _ in range(rounds):
        for name, function in entries.items():
            times[name].append(timer(function, flat, len(slots), STATES, out, CALLS))
    ratios = {name: compare.ratio(times["ours"], times[name]) for name in ("Pinocchio", "CasADi")}
    print(f"operations: ours {operations} and {preparing} once per parameter set, CasADi {their_operations}; ratio {operations / their_operations:.3f}, "
          f"{(operations + preparing) / their_operations:.3f} with all of ours, {operations / moving:.3f} without those of CasADi ({their_operations - moving}) "
          "that depend on parameters alone")
    print("time: " + ", ".join(f"{name} {min(mine):.0f} ns" for name, mine in times.items()))
    print(f"ours takes {ratios['Pinocchio']} of Pinocchio's time, {ratios['CasADi']} of CasADi's; torques differ by {error:.1e}")
    bars = {"Pinocchio's time": ratios["Pinocchio"], "CasADi's operations": operations / moving}
    missed = [f"{value:.3f} of {name} instead of {BAR}" for name, value in bars.items() if not value <= BAR]
    return missed + ([] if error < SAME else [f"torques differ by {error}"])


if __name__ == "__main__":
    run.alone(__doc__, measure)
