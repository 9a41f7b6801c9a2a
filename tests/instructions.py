"""Instructions of a simulated second of every scene and mechanism there was before worlds, now against then.

    python3 tests/instructions.py        status 1 where one takes more than 5 % more than before bodies were made of elements

Both programs are built from git as committed, as a user builds them, in folders below target that are kept; valgrind counts.
A run is counted twice, once longer, so that starting, reading and deriving are not counted.
"""

import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
# The last commit before bodies were made of elements, which worlds began with.
BEFORE = "41cd486"
MOST = 1.05
# Names and two simulated times (s), a few thousand steps apart.
SUBJECTS = {
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
    short, long = SUBJECTS[name]
    return (counted(folder, name, long) - counted(folder, name, short)) / (long - short)


now, then = built("HEAD"), built(BEFORE)
more = []
for name in sys.argv[1:] or SUBJECTS:
    ratio = each(now, name) / each(then, name)
    print(f"{name}: {ratio:.3f} of the instructions of {BEFORE}", flush=True)
    if ratio > MOST:
        more.append(name)
if more:
    sys.exit(f"more than {MOST} times: {', '.join(more)}")
