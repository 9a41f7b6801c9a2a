"""Processor time of a new user's first command: builds the generator and the command, then writes the first page and plot.

    python3 tests/first_run.py           now, and before the build was made leaner, in one sitting; status 1 above half of it
    python3 tests/first_run.py --now     now alone

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


def seconds(commit):
    """Processor time (user and system) from sources to the first picture."""
    folder = ROOT / "target" / "first_run"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    archive = subprocess.run(["git", "archive", commit], cwd=ROOT, capture_output=True, check=True).stdout
    subprocess.run(["tar", "x"], cwd=folder, input=archive, check=True)
    subprocess.run(["cargo", "fetch", "--quiet", "--locked"], cwd=folder, check=True)
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    command = ["cargo", "smartbed", "run", "fourbar", "--view", "fourbar.html", "--plot", "fourbar.svg"]
    subprocess.run(command, cwd=folder, check=True, stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    for picture in ["fourbar.html", "fourbar.svg"]:
        assert (folder / picture).stat().st_size > 1000, f"{picture} is no picture"
    shutil.rmtree(folder)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


now = seconds("HEAD")
print(f"now: {now:.0f} s of processor time", flush=True)
if "--now" not in sys.argv:
    then = seconds(BEFORE)
    print(f"{BEFORE}: {then:.0f} s; now {now / then:.2f} of that, half is promised")
    sys.exit(now > then / 2)
