#!/usr/bin/env python3
"""Motions of pendulum, four-bar and tile in the peers, as points for the report of speed against error.

    target/peers-venv/bin/python tests/peers/motions.py [FILE.json] [--models pendulum,fourbar]
    cargo smartbed report pendulum fourbar tile --points target/peers/points.json

Needs the environment of run.py, with SciPy. Errors as in the report: the largest of any coordinate at ten times,
evenly over the model's seconds, against our Dormand-Prince at 1e-13, with which SciPy's DOP853 at 1e-13 must agree to
1e-8. Times are processor time per simulated second, the fastest of three runs. What fails is printed and left out.
"""
import argparse
import csv
import ctypes
import json
import pathlib
import subprocess
import sys
import time

import casadi as ca
import mujoco
import numpy
import scipy.integrate

import compare
import mechanisms
import states
import with_casadi

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
# Simulated seconds of the models, and values of the pendulum's.
SECONDS = {"pendulum": 10, "fourbar": 1, "tile": 1}
PENDULUM = {"m": 0.5, "l": 0.3, "c": 0.01, "g": 9.81}
SAMPLES, RUNS, AGREEMENT = 10, 3, 1e-8
TOLERANCES = [1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12]
STEPS = [0.05, 0.02, 0.01, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4]


def reference(name, directory):
    """(names of the coordinates, state at the start, coordinates at the samples) from our own run."""
    seconds, target = SECONDS[name], directory / f"{name}_motion.csv"
    command = ["cargo", "smartbed", "run", name, "--method", "dormand-prince", "--tolerance", "1e-13", "--step", "1e-3",
               "--seconds", str(seconds), "--every", str(seconds * 1000 // SAMPLES), "--csv", str(target)]
    subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True)
    with target.open() as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == SAMPLES + 1, len(rows)
    mechanism = mechanisms.MECHANISMS.get(name, lambda: None)()
    q = mechanism.q if mechanism else ["q"]
    u = [mechanism.u[k] for k in mechanism.independent] if mechanism else ["u_q"]
    start = [float(rows[0][n]) for n in q + u]
    return q, numpy.array(start), numpy.array([[float(row[n]) for n in q] for row in rows[1:]])


def equations(name):
    """x -> x' as a CasADi function, x coordinates and independent speeds, no inputs."""
    if name == "pendulum":
        x, p = ca.SX.sym("x", 2), PENDULUM
        rate = -p["g"] / p["l"] * ca.sin(x[0]) - p["c"] / (p["m"] * p["l"] ** 2) * x[1]
        return ca.Function("f", [x], [ca.vertcat(x[1], rate)])
    mechanism = mechanisms.MECHANISMS[name]()
    x = ca.SX.sym("x", len(mechanism.q) + len(mechanism.independent))
    values = list(states.parameters(name).values())
    return ca.Function("f", [x], [with_casadi.function(mechanism)(ca.vertcat(x, ca.DM.zeros(len(mechanism.inputs)), *values))], {"cse": True})


def compiled(name, f, directory):
    """The function's C, compiled as in run.py, as a right-hand side for SciPy."""
    generator = ca.CodeGenerator("f", {"with_header": False})
    generator.add(f)
    wrapper = "\nvoid eval(const double *in, double *out) { const double *a[%d] = {in}; double *r[%d] = {out}; casadi_int iw[%d]; double w[%d]; f(a, r, iw, w, 0); }\n"
    source = generator.dump() + wrapper % (f.sz_arg(), f.sz_res(), f.sz_iw() + 1, f.sz_w() + 1)
    function, n = compare.compile_c(source, f"{name}_motion", directory).eval, f.size1_in(0)
    function.argtypes, function.restype = [ctypes.c_void_p] * 2, None

    def rates(_, x):
        x, out = numpy.ascontiguousarray(x), numpy.empty(n)
        function(x.ctypes.data, out.ctypes.data)
        return out

    return rates


def measured(solve):
    """What `solve` gives (coordinates at the samples, evaluations), and its fastest processor time in ns."""
    fastest = float("inf")
    for _ in range(RUNS):
        begin = time.process_time_ns()
        found = solve()
        fastest = min(fastest, time.process_time_ns() - begin)
    return *found, fastest


def scipy_solver(rates, start, seconds, method, tolerance, n):
    times = numpy.linspace(0, seconds, SAMPLES + 1)[1:]

    def solve():
        # Dense output costs accuracy: every sample is the end of an integration.
        x, evaluations, samples, t = start, 0, [], 0.0
        for end in times:
            done = scipy.integrate.solve_ivp(rates, (t, end), x, method=method, rtol=tolerance, atol=tolerance)
            if not done.success:
                raise RuntimeError(done.message)
            x, t, evaluations = done.y[:, -1], end, evaluations + done.nfev
            samples.append(x[:n])
        return numpy.array(samples), evaluations

    return solve


def cvodes_solver(f, start, seconds, tolerance, n):
    x = ca.SX.sym("x", len(start))
    grid = numpy.linspace(0, seconds, SAMPLES + 1)[1:]
    options = {"abstol": tolerance, "reltol": tolerance, "max_num_steps": 1_000_000}
    integrator = ca.integrator("i", "cvodes", {"x": x, "ode": f(x)}, 0, grid, options)
    return lambda: (numpy.array(integrator(x0=start)["xf"])[:n].T, None)


def mujoco_solver(start, seconds, integrator, step):
    p = PENDULUM
    model = mujoco.MjModel.from_xml_string(
        f'<mujoco><compiler boundmass="0" boundinertia="0"/><option timestep="{step}" integrator="{integrator}" gravity="0 0 -{p["g"]}">'
        '<flag contact="disable" constraint="disable"/></option><worldbody><body>'
        f'<joint type="hinge" axis="1 0 0" damping="{p["c"]}"/><inertial pos="0 0 -{p["l"]}" mass="{p["m"]}" diaginertia="1e-14 1e-14 1e-14"/>'
        "</body></worldbody></mujoco>")
    data, steps = mujoco.MjData(model), round(seconds / SAMPLES / step)

    def solve():
        mujoco.mj_resetData(model, data)
        data.qpos[:], data.qvel[:] = start[:1], start[1:]
        samples = []
        for _ in range(SAMPLES):
            mujoco.mj_step(model, data, steps)
            samples.append(data.qpos.copy())
        return numpy.array(samples), SAMPLES * steps * (4 if integrator == "RK4" else 1)

    return solve


def solvers(name, f, rates, start, n):
    """(method, its control, what solves) of every point."""
    seconds = SECONDS[name]
    for tolerance in TOLERANCES:
        for method in ("DOP853", "RK45"):
            yield f"CasADi, SciPy {method}", {"tolerance": tolerance}, scipy_solver(rates, start, seconds, method, tolerance, n)
        yield "CasADi, CVODES", {"tolerance": tolerance}, cvodes_solver(f, start, seconds, tolerance, n)
    if name == "pendulum":
        for step in STEPS:
            for integrator in ("RK4", "Euler", "implicitfast"):
                yield f"MuJoCo {integrator}", {"step": step}, mujoco_solver(start, seconds, integrator, step)


def points(name, directory):
    q, start, exact = reference(name, directory)
    f, seconds = equations(name), SECONDS[name]
    rates = compiled(name, f, directory)
    check, _ = scipy_solver(rates, start, seconds, "DOP853", 1e-13, len(q))()
    agreement = float(abs(check - exact).max())
    print(f"{name}: the references agree to {agreement:.1e}")
    if agreement > AGREEMENT:
        raise RuntimeError(f"the references of {name} differ by {agreement:.1e}: not the same motion")
    for method, control, solve in solvers(name, f, rates, start, len(q)):
        try:
            samples, evaluations, nanoseconds = measured(solve)
        except RuntimeError as error:
            print(f"  {method} {control}: {str(error).splitlines()[0]}")
            continue
        point = {"subject": name, "method": method, "scalar": "f64", **control, "error": float(abs(samples - exact).max()),
                 "nanoseconds": nanoseconds / seconds, "command": f"target/peers-venv/bin/python tests/peers/motions.py --models {name}"}
        if evaluations:
            point["evaluations"] = evaluations / seconds
        print(f"  {method} {control}: error {point['error']:.1e}, {point['nanoseconds']:.0f} ns per second")
        if numpy.isfinite(point["error"]):
            yield point


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file", nargs="?", type=pathlib.Path, default=ROOT / "target" / "peers" / "points.json")
    parser.add_argument("--models", default=",".join(SECONDS), help="which, with commas between")
    arguments = parser.parse_args()
    directory = ROOT / "target" / "peers"
    directory.mkdir(parents=True, exist_ok=True)
    found = []
    for name in arguments.models.split(","):
        try:
            found += points(name, directory)
        except (RuntimeError, AssertionError, KeyError, subprocess.CalledProcessError) as error:
            print(f"{name}: {type(error).__name__}: {error}", file=sys.stderr)
    arguments.file.write_text(json.dumps({"points": found, "tables": []}, indent=1) + "\n")
    print(f"{len(found)} points in {arguments.file}")


if __name__ == "__main__":
    main()
