"""Processor time of a new user's first command: builds the generator and the command, then writes the first page and plot.

    python3 tests/first_run.py           now, and before the build was made leaner, in one sitting; status 1 above half of it
    python3 tests/first_run.py --now     now alone
    python3 tests/first_run.py --rest    now alone, and the first command after it that needs the whole program

Sources are taken from git as committed, and built in a folder of their own below target; packages are fetched before.
"""

import pathlib
import resource
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
# The last commit of the day on which the half was promised.
BEFORE = "249bbc3"


def seconds(folder, command):
    """Processor time (user and system) of a command and of what it starts."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(["cargo", "smartbed", *command], cwd=folder, check=True, stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def measured(commit, rest):
    """Processor time from sources to the first picture; and of the first command that needs the rest, if that is asked for."""
    folder = ROOT / "target" / "first_run"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    archive = subprocess.run(["git", "archive", commit], cwd=ROOT, capture_output=True, check=True).stdout
    subprocess.run(["tar", "x"], cwd=folder, input=archive, check=True)
    subprocess.run(["cargo", "fetch", "--quiet", "--locked"], cwd=folder, check=True)
    first = seconds(folder, ["run", "fourbar", "--view", "fourbar.html", "--plot", "fourbar.svg"])
    for picture in ["fourbar.html", "fourbar.svg"]:
        assert (folder / picture).stat().st_size > 1000, f"{picture} is no picture"
    more = seconds(folder, ["run", "single_spring", "--plot", "spring.png"]) if rest else None
    assert not rest or (folder / "spring.png").stat().st_size > 1000, "spring.png is no picture"
    shutil.rmtree(folder)
    return first, more


now, more = measured("HEAD", "--rest" in sys.argv)
print(f"now: {now:.0f} s of processor time", flush=True)
if more is not None:
    print(f"then the whole program, once: {more:.0f} s")
elif "--now" not in sys.argv:
    then, _ = measured(BEFORE, False)
    print(f"{BEFORE}: {then:.0f} s; now {now / then:.2f} of that, half is promised")
    sys.exit(now > then / 2)
