"""Instructions of a simulated second of every scene and mechanism there was before worlds, and of some worlds, now against then.

    python3 tests/instructions.py               status 1 where one takes more than 5 % more than then
    python3 tests/instructions.py stack_boxes   these alone, with the programs that they need

Then: bodies and mechanisms before bodies were made of elements, worlds before redundant contacts were shared out.
The programs are built from git as committed, as a user builds them, in folders below target that are kept; valgrind counts.
A run is counted twice, once longer, so that starting, reading and deriving are not counted.
"""

import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
# The last commits before bodies were made of elements, which worlds began with, and before redundant contacts were shared out.
ELEMENTS, SHARED = "41cd486", "e8e626b"
MOST = 1.05
# Names and two simulated times (s): a few thousand steps apart, in worlds a few hundred.
BODIES = {
    "single_spring": (0.5, 1.5),
    "double_spring": (0.5, 1.5),
    "mass_on_4_springs": (0.5, 1.5),
    "spring_loaded_pendulum": (0.5, 1.5),
    "closed_loop_3_links": (0.5, 1.5),
    "bar_on_wall": (0.2, 0.6),
    "truss": (0.2, 0.6),
    "complex_structure": (0.2, 0.6),
    "prism": (0.2, 0.6),
    "cube": (0.2, 0.4),
    "cylinder": (0.2, 0.4),
    "ball": (0.2, 0.4),
    "bladder": (0.02, 0.06),
    "pendulum": (1.0, 3.0),
    "pendulum10": (1.0, 3.0),
    "fourbar": (1.0, 3.0),
    "bicycle": (1.0, 3.0),
    "arm6": (1.0, 3.0),
    "tile": (1.0, 3.0),
}
WORLDS = {
    "stack_boxes": (0.02, 0.3),
    "box_bounce": (0.5, 2.0),
    "rod_with_friction": (0.1, 0.5),
    "two_cubes": (0.1, 0.5),
    "stack_cubes": (0.1, 0.2),
    "ball_on_bladder": (0.1, 0.3),
    "arm6_pushes_wall": (0.1, 0.3),
    "tile_with_bladder": (0.1, 0.3),
}
THEN = {name: ELEMENTS for name in BODIES} | {name: SHARED for name in WORLDS}


def built(commit):
    """The program of a commit, with its folder, where its models are."""
    number = subprocess.run(["git", "rev-parse", commit], cwd=ROOT, capture_output=True, text=True, check=True)
    folder = ROOT / "target" / "instructions" / number.stdout.strip()[:12]
    if not folder.exists():
        folder.mkdir(parents=True)
        archive = subprocess.run(["git", "archive", commit], cwd=ROOT, capture_output=True, check=True).stdout
        subprocess.run(["tar", "x"], cwd=folder, input=archive, check=True)
    command = ["cargo", "build", "--quiet", "--release", "--locked", "-p", "smartbed", "--target-dir", folder / "target"]
    subprocess.run(command, cwd=folder, check=True)
    return folder


def counted(folder, name, seconds):
    """Instructions of a run."""
    run = [folder / "target/release/smartbed", "run", name, "--seconds", str(seconds), "--every", "100000"]
    command = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", *run]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    if done.returncode:
        sys.exit(f"{name}: {done.stderr}")
    return int(re.search(r"Collected : (\d+)", done.stderr)[1])


def each(folder, name):
    short, long = (BODIES | WORLDS)[name]
    return (counted(folder, name, long) - counted(folder, name, short)) / (long - short)


names = sys.argv[1:] or list(THEN)
unknown = [name for name in names if name not in THEN]
if unknown:
    sys.exit(f"unknown: {', '.join(unknown)}; known: {', '.join(THEN)}")
programs = {commit: built(commit) for commit in ["HEAD", *dict.fromkeys(THEN[name] for name in names)]}
more = []
for name in names:
    ratio = each(programs["HEAD"], name) / each(programs[THEN[name]], name)
    print(f"{name}: {ratio:.3f} of the instructions of {THEN[name]}", flush=True)
    if ratio > MOST:
        more.append(name)
if more:
    sys.exit(f"more than {MOST} times: {', '.join(more)}")
