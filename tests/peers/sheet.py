"""Steps of a bladder beside hand-written C, in one run: `python3 tests/peers/sheet.py`.

Builds `sheet.c` with `cc -O3 -march=native` four times (f32, f64; the runtime's work, and plain sums with -ffast-math),
runs it and `cargo bench --bench sheet` in turns, then numba, Warp and MuJoCo (`sheet_peers.py`, in a virtual environment under
`target/`), and prints the least time of a step with the ratio to C of the same work, and to ours. Under other load the ratios of
the least times move less than the times. So for 28 bladders, on one core and on two, in C also side by side in lanes, and for
a step of the energy-momentum method over Verlet's. Fails if a peer that does the same work comes elsewhere than C does, if
our steps, of one bladder or of 28 on one core, take longer than C's, or if two cores gain less for us than 0.95 of what they gain
for C; with a machine's AVX-512, which C is compiled for too.
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


MANY = 28
# Our time of a step over C's, at most, and what is hoped for with one bladder; our gain from two cores over C's, at least; time
# of a step of the energy-momentum method over Verlet's, at most.
BAR, STRETCH = 1.0, 0.6
GAIN = 0.95
CONSERVING = 4
# Bladders side by side in C: as many numbers as 32 bytes hold, and as 64 do.
LANES = {"f32": (8, 16), "f64": (4, 8)}


def build(real, name, flags):
    """Compiles the yardstick; returns its path."""
    OUT.mkdir(parents=True, exist_ok=True)
    path = OUT / f"{name}_{real}"
    source = ROOT / "tests" / "peers" / "sheet.c"
    command = ["cc", "-O3", "-march=native", f"-DREAL={real}", *flags, str(source), "-o", str(path), "-lm", "-pthread"]
    subprocess.run(command, check=True)
    return path


def ours():
    """Least time of a step (ns) and height by (scalar, form, kind)."""
    command = ["cargo", "bench", "--quiet", "-p", "smartbed-tests", "--bench", "sheet", "--", "50", "60"]
    text = subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True).stdout
    rows = [line.split() for line in text.splitlines() if line.startswith("f")]
    return {tuple(row[:3]): (float(row[3]), float(row[5])) for row in rows}


def c_runs(scalar, programs):
    """Least time of a step (ns) by (scalar, C, what) for all that C does."""
    runs = {name: (programs[name], ["50", "60"]) for name in ("same", "plain")}
    runs |= {f"many {cores}": (programs["same"], ["10", "75", str(MANY), str(cores)]) for cores in (1, 2)}
    runs |= {f"lanes {n}": (programs[f"lanes {n}"], ["10", "75", str(MANY), "1"]) for n in LANES[scalar]}
    for name, (path, numbers) in runs.items():
        text = subprocess.run([str(path), *numbers], check=True, capture_output=True, text=True).stdout
        yield (scalar, "C", name), float(text.split()[0])


def peers(yardsticks):
    """Least time of a step (ns) by (scalar, "peer", name); what could not run is printed with the reason."""
    python = run.prepare(run.SHEET_PACKAGES)
    program = ROOT / "tests" / "peers" / "sheet_peers.py"
    text = subprocess.run([python, program, "50", "40"], cwd=OUT, check=True, capture_output=True, text=True).stdout
    found = {}
    for scalar, name, *numbers in (line.split() for line in text.splitlines() if line.startswith(("f32 ", "f64 "))):
        if len(numbers) != 4 or numbers[0] == "not:":
            print(scalar, name, *numbers)
            continue
        found[scalar, "peer", name] = float(numbers[0])
        height, steps = float(numbers[2]), numbers[3]
        if height == height:
            ours = subprocess.run([yardsticks[scalar]["same"], steps, "1"], check=True, capture_output=True, text=True)
            error = abs(height - float(ours.stdout.split()[2]))
            assert error <= SAME_PLACE[scalar], (scalar, name, error)
    return found


def same_work(key):
    """What C does of the same work: many bladders on as many cores, or one."""
    scalar, kind, what = key
    many = what if kind == "C" and what.startswith("many") else f"many {what}" if kind == "many" else "same"
    return scalar, "C", "many 1" if what.startswith("lanes") else many


def main():
    least = {}
    yardsticks = {}
    for scalar, real in {"f32": "float", "f64": "double"}.items():
        flags = {"same": SAME_WORK, "plain": PLAIN} | {f"lanes {n}": [*SAME_WORK, f"-DLANES={n}"] for n in LANES[scalar]}
        yardsticks[scalar] = {name: build(real, name.replace(" ", "_"), of) for name, of in flags.items()}
    for _ in range(3):
        for scalar, programs in yardsticks.items():
            for key, time in c_runs(scalar, programs):
                least[key] = min(least.get(key, float("inf")), time)
        for key, (time, _) in ours().items():
            least[key] = min(least.get(key, float("inf")), time)
    if "--alone" not in sys.argv:
        least |= peers(yardsticks)
    print(f"{'':24}{'us a step':>10}{'ns a spring':>13}{'of C':>7}{'of ours':>9}")
    for key in sorted(least):
        time, same, ours_alone = least[key], least[same_work(key)], least[(key[0], "exact", "grid")]
        print(f"{' '.join(key):24}{time / 1e3:10.2f}{time / SPRINGS:13.2f}{time / same:7.2f}{time / ours_alone:9.2f}")
    missed = 0
    for scalar in yardsticks:
        for key in [(scalar, "exact", "grid"), (scalar, "many", "1")]:
            ratio = least[key] / least[same_work(key)]
            missed += ratio > BAR
            hoped = f"; {STRETCH} hoped for, {'reached' if ratio <= STRETCH else 'not reached'}" if "grid" in key else ""
            print(f"{' '.join(key)}: {ratio:.2f} of C, {BAR:.1f} asked for{'' if ratio <= BAR else ', MISSED'}{hoped}")
        gain = {who: least[scalar, *one] / least[scalar, *two] for who, one, two in [
            ("ours", ("many", "1"), ("many", "2")), ("C", ("C", "many 1"), ("C", "many 2"))]}
        stiff = least[scalar, "stiff", "energy_momentum"] / least[scalar, "stiff", "verlet"]
        gains = gain["ours"] / gain["C"]
        missed += (gains < GAIN) + (stiff > CONSERVING)
        print(f"{scalar}: two cores gain {gain['ours']:.2f}, in C {gain['C']:.2f}: {gains:.2f} of it, {GAIN} asked for"
              f"{'' if gains >= GAIN else ', MISSED'}; energy-momentum over Verlet {stiff:.1f},"
              f" {CONSERVING} asked for{'' if stiff <= CONSERVING else ', MISSED'}")
    return missed


if __name__ == "__main__":
    sys.exit(main())
