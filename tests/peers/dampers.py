#!/usr/bin/env python3
"""Speed against error of a bladder with strong dampers, ours compared with CVODES: `python3 tests/peers/dampers.py [C ...]`.

The scene models/chip/stiff_bladder.toml (15 x 15 nodes, E t = 5 kN/m) for 20 ms from flat, its dampers C from 0.05 to 50 N s/m. Errors
are the largest of any coordinate at ten times, against our dop853 at 1e-13, with which CVODES at 1e-11 must agree; ours by
`smartbed report`, CVODES by Adams' method and by Gear's with GMRES. Prints for each C the cheapest run of
each method that keeps 1e-3 and 1e-4 of the motion, in ms of a processor for the 20 ms. Needs the environment of run.py, which it makes.
"""
import csv
import json
import os
import subprocess
import sys

import run

DIRECTORY = run.ROOT / "target" / "peers" / "dampers"
SCENE = run.ROOT / "models" / "chip" / "stiff_bladder.toml"
DAMPERS, SECONDS, SHARES = [float(word) for word in sys.argv[1:]] or (0.05, 2.0, 10.0, 50.0), 0.02, (1e-3, 1e-4)
TOLERANCES = (1e-3, 1e-4, 1e-5, 1e-6, 1e-7)
AGREEMENT = 1e-8


def changed(name, changes):
    """Our scene with some of its keys changed, as a file."""
    keys = tomllib.loads(SCENE.read_text()) | changes
    file = DIRECTORY / f"{name}.toml"
    file.write_text("".join(f"{key} = {json.dumps(value)}\n" for key, value in keys.items() if value is not None))
    return file


def peer_scene(damping):
    """The same for the peers, whose points have unit masses: every force but weight over the mass."""
    keys = tomllib.loads(SCENE.read_text())
    mass = keys["mass"]
    over = {key: keys[key] / mass for key in ("K", "pressure")}
    scene = scenes.Scene(changed("peer", over | {"C": 0.0, "mass": None, "method": None}))
    scene.damping = damping / mass
    return scene


def truth(file, n):
    """Coordinates at the samples from our own run."""
    target = file.with_suffix(".csv")
    command = ["cargo", "smartbed", "run", file, "--method", "dop853", "--tolerance", "1e-13", "--step", "1e-3", "--seconds", str(SECONDS),
               "--every", "2", "--csv", target]
    subprocess.run([str(word) for word in command], cwd=run.ROOT, check=True, capture_output=True)
    with target.open() as text:
        rows = list(csv.DictReader(text))[1:]
    return numpy.array([[float(row[f"{axis}{i}"]) for i in range(n) for axis in "xyz"] for row in rows])


def peers(damping, exact):
    """(method, control, error, ms) of CVODES."""
    scene = peer_scene(damping)
    f = scene_casadi.equations(scene)
    check = scene_casadi.with_cvodes(scene, f, 1e-11, SECONDS, scene_casadi.KRYLOV)()[0]
    agreement = abs(check - exact).max()
    assert agreement <= AGREEMENT, f"C = {damping}: the references differ by {agreement:.1e}"
    print(f"C = {damping}: the references agree to {agreement:.1e} m", flush=True)
    for tolerance in TOLERANCES:
        of = {"CVODES, Gear, GMRES": scene_casadi.with_cvodes(scene, f, tolerance, SECONDS, scene_casadi.KRYLOV),
              "CVODES, Adams": scene_casadi.with_cvodes(scene, f, tolerance, SECONDS)}
        for name, solve in of.items():
            try:
                found, _, nanoseconds = motions.measured(solve)
            except RuntimeError as error:
                print(f"  {name} {tolerance:g}: {str(error).splitlines()[0]}", flush=True)
                continue
            yield name, f"tolerance {tolerance:g}", abs(found - exact).max(), 1e-6 * nanoseconds


def ours(file):
    """(method, control, error, ms) of ours in f64."""
    out = DIRECTORY / "report"
    words = ["cargo", "smartbed", "report", file, "--no-chip", "--scalar", "f64", "--seconds", SECONDS, "--out", out, "--results", out]
    subprocess.run([str(word) for word in words], cwd=run.ROOT, check=True, capture_output=True)
    for point in json.loads((out / "report.json").read_text())["points"]:
        control = f"step {point['step']:.2e}" if point.get("step") else f"tolerance {point['tolerance']:g}"
        yield point["method"], control, point["error"], 1e-6 * SECONDS * point["nanoseconds"]


def main():
    DIRECTORY.mkdir(parents=True, exist_ok=True)
    os.chdir(DIRECTORY)
    for damping in DAMPERS:
        file = changed(f"stiff_{damping:g}", {"C": damping, "T": SECONDS, "method": "damped_verlet"})
        exact = truth(file, peer_scene(damping).n)
        points = [*ours(file), *peers(damping, exact)]
        extent = numpy.ptp(exact, axis=0).max()
        for share in SHARES:
            print(f"  {share:g} of {1e3 * extent:.1f} mm:")
            for name in dict.fromkeys(point[0] for point in points):
                good = [point for point in points if point[0] == name and point[2] <= share * extent]
                if good:
                    _, control, error, took = min(good, key=lambda point: point[3])
                    print(f"    {name:20} {control:18} {error:.1e} m {took:8.2f} ms", flush=True)


if __name__ == "__main__":
    run.inside(("numpy", "scipy", "casadi"))
    import tomllib

    import numpy

    import motions
    import scene_casadi
    import scenes

    main()
