#!/usr/bin/env python3
"""Motions of mechanisms and scenes in the peers and in ours, in one run: speed against error, and which points dominate.

    python3 tests/peers/motions.py [--models pendulum,cube] [--no-report]

Needs the environment of run.py, which it makes. Errors as in the report: the largest of any coordinate at ten times,
evenly over the seconds, against our own run at 1e-13, with which SciPy's DOP853 at 1e-13 must agree to 1e-8. Times are
processor time per simulated second, the fastest of three runs. Right after the peers of all models `smartbed report`
measures ours, puts both into its plots and tables, and says whether a peer's point dominates ours: then, if references
differ, and if a peer's time over ours at its error is below the bar of ratios.py, the exit status is 1. Results go to tests/peers/results/<machine>/motions.md and .json.
"""
import argparse
import csv
import json
import os
import shutil
import subprocess
import sys
import time

import run

ROOT = run.ROOT
DIRECTORY = ROOT / "target" / "peers"
# Simulated seconds: the models' own; for the cube shorter, as long as exact methods agree: later a touch depends on rounding.
MECHANISMS = {"pendulum": 10, "fourbar": 1, "tile": 1}
SCENES = {"single_spring": 3, "cube": 2, "bladder": 2}
SECONDS = MECHANISMS | SCENES
SAMPLES, RUNS, AGREEMENT = 10, 3, 1e-8
# Runs longer than this (s) are not repeated; after one longer than that a method's finer ones are left out.
SHORT, LONG = 0.3, 3


def reference(name, columns, start_columns):
    """(state at the start, coordinates at the samples) from our own run."""
    seconds, target = SECONDS[name], DIRECTORY / f"{name}_motion.csv"
    method = "dop853" if name in SCENES else "dormand-prince"
    command = ["cargo", "smartbed", "run", name, "--method", method, "--tolerance", "1e-13", "--step", "1e-3",
               "--seconds", str(seconds), "--every", str(round(seconds * 1000) // SAMPLES), "--csv", str(target)]
    subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True)
    with target.open() as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == SAMPLES + 1, len(rows)
    take = lambda row, names: numpy.array([float(row[n]) for n in names])
    return take(rows[0], start_columns), numpy.array([take(row, columns) for row in rows[1:]])


def of_mechanism(name):
    q, u = motion_mechanisms.symbols(name)
    start, exact = reference(name, q, q + u)
    return exact, *motion_mechanisms.prepare(name, start, SECONDS[name], DIRECTORY)


def of_scene(name):
    scene, seconds = scenes.Scene(ROOT / "models" / "scenes" / f"{name}.toml"), SECONDS[name]
    _, exact = reference(name, [f"{axis}{i}" for i in range(scene.n) for axis in "xyz"], [])
    f = scene_casadi.equations(scene)
    rates = motion_mechanisms.compiled(name, f, DIRECTORY)
    peers = [scene_casadi.solvers(scene, f, rates, seconds), scene_mujoco.solvers(scene, seconds), scene_exudyn.solvers(scene, seconds)]
    return exact, scene_casadi.with_scipy(scene, rates, "DOP853", 1e-13, seconds), (solver for peer in peers for solver in peer)


def measured(solve):
    """What `solve` gives (coordinates at the samples, evaluations), and its fastest processor time in ns."""
    fastest = float("inf")
    for _ in range(RUNS):
        begin = time.process_time_ns()
        found = solve()
        fastest = min(fastest, time.process_time_ns() - begin)
        if fastest > SHORT * 1e9:
            break
    return *found, fastest


def points(name, missing):
    """The points of a model; what a peer cannot do goes to `missing`."""
    exact, check, solvers = (of_scene if name in SCENES else of_mechanism)(name)
    seconds, extent, slow = SECONDS[name], numpy.ptp(exact, axis=0).max(), set()
    agreement = float(abs(check()[0] - exact).max())
    print(f"{name}: the references agree to {agreement:.1e}", flush=True)
    if not agreement <= AGREEMENT:
        raise RuntimeError(f"the references of {name} differ by {agreement:.1e}: not the same motion")
    for method, control, solve in solvers:
        if control is None:
            missing.append([name, method, solve])
            continue
        if method in slow:
            continue
        try:
            samples, evaluations, nanoseconds = measured(solve)
        except RuntimeError as error:
            print(f"  {method} {control}: {str(error).splitlines()[0]}", flush=True)
            continue
        slow |= {method} if nanoseconds > LONG * 1e9 else set()
        error = float(abs(samples - exact).max())
        print(f"  {method} {control}: error {error:.1e}, {nanoseconds / seconds:.0f} ns per second", flush=True)
        # As in the report: an error a third as large as the motion is no answer.
        if error < 0.3 * extent:
            yield {"subject": name, "seconds": seconds, "method": method, "scalar": "f64", **control, "error": max(error, 1e-17),
                   "nanoseconds": nanoseconds / seconds, "command": f"python3 tests/peers/motions.py --models {name}",
                   **({"evaluations": evaluations / seconds} if evaluations else {})}


def report(names, file):
    """Ours beside them; returns what dominates, as told by the report, and ratios below their bar."""
    out = DIRECTORY / "report"
    command = ["cargo", "smartbed", "report", *names, "--no-chip", "--points", file.relative_to(ROOT),
               "--out", out.relative_to(ROOT), "--results", out.relative_to(ROOT)]
    subprocess.run(command, cwd=ROOT, check=True)
    processor, folder = compare.machine()
    target = run.HERE / "results" / folder
    target.mkdir(parents=True, exist_ok=True)
    for ending in ("md", "json"):
        shutil.copy(out / f"{folder}.{ending}", target / f"motions.{ending}")
    told = json.loads((out / "report.json").read_text())
    return told["dominating"] + ratios.check(told["points"])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--models", default=",".join(SECONDS), help="which, with commas between")
    parser.add_argument("--no-report", action="store_true", help="peers only: write their points, measure nothing of ours")
    arguments = parser.parse_args()
    names, found, missing, failed = arguments.models.split(","), [], [], []
    DIRECTORY.mkdir(parents=True, exist_ok=True)
    # MuJoCo writes its warnings into a file where it runs.
    os.chdir(DIRECTORY)
    for name in names:
        try:
            found += points(name, missing)
        except (RuntimeError, AssertionError, KeyError, NotImplementedError, subprocess.CalledProcessError) as error:
            failed.append(f"{name}: {type(error).__name__}: {error}")
    tables = [{"title": "What a peer cannot do", "columns": ["subject", "peer", "why"], "rows": missing,
               "command": f"python3 tests/peers/motions.py --models {','.join(names)}"}]
    file = DIRECTORY / "points.json"
    file.write_text(json.dumps({"points": found, "tables": tables if missing else []}, indent=1) + "\n")
    print(f"{len(found)} points in {file}")
    failed += [] if arguments.no_report else report(names, file)
    for line in failed:
        print(line, file=sys.stderr)
    sys.exit(bool(failed))


if __name__ == "__main__":
    run.inside()
    import numpy

    import compare
    import motion_mechanisms
    import ratios
    import scene_casadi
    import scene_exudyn
    import scene_mujoco
    import scenes

    main()
