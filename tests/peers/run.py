#!/usr/bin/env python3
"""Forward dynamics by the generator and by its peers: operations, time and error, one interleaved run.

    python3 tests/peers/run.py [--models tile,arm6] [--rounds 101]

Makes a virtual environment under target/peers-venv, installs the peers with pip, builds each
mechanism with each, compiles the C with gcc -O3, compares all outputs at 1,000 states with 200-bit
arithmetic, times them in turns, prints the table and writes tests/peers/results/<machine>/.
The exit status is 1 if one of the project's bars is missed: operations, time and error against CasADi's, time to derive.
Needs python3 with venv, gcc, g++ and cargo. What cannot be installed or built stays in the table.
"""
import argparse
import os
import pathlib
import subprocess
import sys
import venv

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
VENV = ROOT / "target" / "peers-venv"
# Package on the index by module.
PACKAGES = {"numpy": "numpy", "gmpy2": "gmpy2", "scipy": "scipy", "casadi": "casadi", "sympy": "sympy", "symforce": "symforce",
            "pinocchio": "pin", "mujoco": "mujoco", "exudyn": "exudyn"}
# Those of sheets alone.
SHEET_PACKAGES = {"numpy": "numpy", "numba": "numba", "warp": "warp-lang", "mujoco": "mujoco"}


def prepare(modules=tuple(PACKAGES)):
    """The environment's interpreter, with whatever could be installed of these modules."""
    python = VENV / "bin" / "python"
    if not python.exists():
        venv.create(VENV, with_pip=True)
    known = PACKAGES | SHEET_PACKAGES
    for module, package in ((module, known[module]) for module in modules):
        if subprocess.run([python, "-c", f"import {module}"], capture_output=True).returncode:
            print(f"installing {package} ...", flush=True)
            done = subprocess.run([python, "-m", "pip", "install", "-q", package], capture_output=True, text=True)
            if done.returncode:
                print(f"  {package} cannot be installed: {done.stderr.strip().splitlines()[-1:]}", flush=True)
    return python


def inside(modules=tuple(PACKAGES)):
    """Goes on within the environment that has these modules."""
    python = prepare(modules)
    if pathlib.Path(sys.prefix).resolve() != VENV.resolve():
        os.execv(python, [str(python), *sys.argv])


def alone(description, measure, modules=("numpy", "casadi", "pinocchio", "gmpy2")):
    """A comparison that is one command: `measure(directory, rounds)` returns the bars that are missed."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rounds", type=int, default=101, help="turns of the interleaved timing")
    arguments = parser.parse_args()
    inside(modules)
    directory = ROOT / "target" / "peers"
    directory.mkdir(parents=True, exist_ok=True)
    finish(measure(directory, arguments.rounds))


def finish(missed):
    """Ends with status 1 if a bar is missed."""
    for line in missed:
        print("missed:", line, file=sys.stderr)
    sys.exit(bool(missed))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--models", default="tile,arm6,bicycle,fourbar,pendulum10", help="which, with commas between")
    parser.add_argument("--rounds", type=int, default=101, help="turns of the interleaved timing")
    arguments = parser.parse_args()
    inside()
    import compare

    finish(compare.run(arguments.models.split(","), arguments.rounds, ROOT / "target" / "peers", HERE / "results"))


if __name__ == "__main__":
    main()
