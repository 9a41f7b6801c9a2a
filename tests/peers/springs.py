"""Steps of bodies that are not grids compared with plain C, in one run: `python3 tests/peers/springs.py`.

Builds `springs.c` with `cc -O3 -march=native` in f32 and f64, runs it and `cargo bench --bench springs` in turns on the same
bodies, and prints the least time of a step per spring, and the time before the first step. Fails if a step takes longer than
in C, if per spring a million springs take more than FAR times a few of them, or set-up and stable step more than LINEAR times,
or if C's result differs.
"""

import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
OUT = ROOT / "target" / "peers" / "springs"
# Of the height of a point (m), by scalar: C divides once where the runtime multiplies.
SAME_PLACE = {"f32": 1e-5, "f64": 1e-11}
FAR = 1.5
LINEAR = 3.0


def build(real):
    """Compiles the yardstick; returns its path."""
    path = OUT / f"springs_{real}"
    source = ROOT / "tests" / "peers" / "springs.c"
    flags = ["-O3", "-march=native", "-fno-math-errno", "-fno-trapping-math", f"-DREAL={real}"]
    subprocess.run(["cc", *flags, str(source), "-o", str(path), "-lm"], check=True)
    return path


def ours():
    """What the bench prints, by (scalar, body)."""
    command = ["cargo", "bench", "--quiet", "-p", "smartbed-tests", "--bench", "springs", "--", str(OUT)]
    text = subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True).stdout
    rows = [line.split() for line in text.splitlines() if line.startswith("f")]
    return {(row[0], row[1]): [float(number) for number in row[2:]] for row in rows}


def main():
    OUT.mkdir(parents=True, exist_ok=True)
    programs = {"f32": build("float"), "f64": build("double")}
    best, c, wrong = {}, {}, []
    for _ in range(2):
        for key, (least, set_up, stable, height, steps, turns, count) in ours().items():
            held = best.setdefault(key, [least, set_up, stable, count])
            best[key] = [min(a, b) for a, b in zip(held, [least, set_up, stable, count])]
            command = [programs[key[0]], OUT / f"{key[1]}.txt", f"{steps:.0f}", f"{turns:.0f}"]
            text = subprocess.run([str(part) for part in command], check=True, capture_output=True, text=True).stdout
            time, place = (float(number) for number in text.split())
            c[key] = min(c.get(key, time), time)
            if abs(place - height) > SAME_PLACE[key[0]]:
                wrong.append(f"{key}: C comes to {place}, not {height}")
    print(f"{'':16}{'springs':>9}{'ns a spring':>13}{'C':>7}{'of C':>6}{'set-up':>8}{'stable step':>13}")
    for key, (least, set_up, stable, count) in sorted(best.items()):
        print(f"{' '.join(key):16}{count:9.0f}{least:13.2f}{c[key]:7.2f}{least / c[key]:6.2f}{set_up:8.0f}{stable:13.0f}")
        few = best[key[0], "small"]
        wrong += [f"{key}: slower than C"] * (least > c[key])
        if key[1] == "million":
            wrong += [f"{key}: {least / few[0]:.2f} times as long a spring"] * (least > FAR * few[0])
            for name, long, short in [("set-up", set_up, few[1]), ("stable step", stable, few[2])]:
                wrong += [f"{key}: {name} {long / short:.2f} times as long a spring"] * (long > LINEAR * short)
    print("\n".join(wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
