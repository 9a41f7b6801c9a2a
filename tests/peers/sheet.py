"""Steps of a bladder beside hand-written C, in one run: `python3 tests/peers/sheet.py`.

Builds `sheet.c` with `cc -O3 -march=native` four times (f32, f64; the runtime's work, and plain sums with -ffast-math),
runs it and `cargo bench --bench sheet` in turns, then numba, Warp and MuJoCo (`sheet_peers.py`, in a virtual environment under
`target/`), and prints the least time of a step with the ratio to C of the same work, and to ours. Under other load the ratios of
the least times move less than the times. Fails if a peer that does the same work comes elsewhere than C does.
"""

import pathlib
import subprocess
import sys

import run

ROOT = pathlib.Path(__file__).resolve().parents[2]
OUT = ROOT / "target" / "peers" / "sheet"
SPRINGS = 1512
SAME_WORK = ["-fno-math-errno", "-fno-trapping-math"]
PLAIN = ["-ffast-math", "-DPLAIN"]
# Of the height of the middle (m), by scalar: sums are in another order.
SAME_PLACE = {"f32": 1e-6, "f64": 1e-12}


def build(real, name, flags):
    """Compiles the yardstick; returns its path."""
    OUT.mkdir(parents=True, exist_ok=True)
    path = OUT / f"{name}_{real}"
    source = ROOT / "tests" / "peers" / "sheet.c"
    command = ["cc", "-O3", "-march=native", f"-DREAL={real}", *flags, str(source), "-o", str(path), "-lm"]
    subprocess.run(command, check=True)
    return path


def ours():
    """Least time of a step (ns) and height by (scalar, form, kind)."""
    command = ["cargo", "bench", "--quiet", "-p", "smartbed-tests", "--bench", "sheet", "--", "50", "60"]
    text = subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True).stdout
    rows = [line.split() for line in text.splitlines() if line.startswith("f")]
    return {tuple(row[:3]): (float(row[3]), float(row[5])) for row in rows}


def peers(yardsticks):
    """Least time of a step (ns) by (scalar, peer); what could not run is printed with the reason."""
    python = run.prepare(run.SHEET_PACKAGES)
    program = ROOT / "tests" / "peers" / "sheet_peers.py"
    text = subprocess.run([python, program, "50", "40"], cwd=OUT, check=True, capture_output=True, text=True).stdout
    found = {}
    for scalar, name, *numbers in (line.split() for line in text.splitlines() if line.startswith(("f32 ", "f64 "))):
        if len(numbers) != 4 or numbers[0] == "not:":
            print(scalar, name, *numbers)
            continue
        found[scalar, name] = float(numbers[0])
        height, steps = float(numbers[2]), numbers[3]
        if height == height:
            ours = subprocess.run([yardsticks[scalar]["same"], steps, "1"], check=True, capture_output=True, text=True)
            error = abs(height - float(ours.stdout.split()[2]))
            assert error <= SAME_PLACE[scalar], (scalar, name, error)
    return found


def main():
    scalars = {"f32": "float", "f64": "double"}
    yardsticks = {s: {n: build(r, n, f) for n, f in [("same", SAME_WORK), ("plain", PLAIN)]} for s, r in scalars.items()}
    least = {}
    for _ in range(3):
        for scalar, programs in yardsticks.items():
            for name, path in programs.items():
                numbers = subprocess.run([str(path), "50", "60"], check=True, capture_output=True, text=True).stdout.split()
                key = (scalar, "C", name)
                least[key] = min(least.get(key, float("inf")), float(numbers[0]))
        for key, (time, _) in ours().items():
            least[key] = min(least.get(key, float("inf")), time)
    least |= peers(yardsticks)
    print(f"{'':24}{'us a step':>10}{'ns a spring':>13}{'of C':>7}{'of ours':>9}")
    for key in sorted(least):
        time, same, ours = least[key], least[(key[0], "C", "same")], least[(key[0], "exact", "grid")]
        print(f"{' '.join(key):24}{time / 1e3:10.2f}{time / SPRINGS:13.2f}{time / same:7.2f}{time / ours:9.2f}")


if __name__ == "__main__":
    sys.exit(main())
