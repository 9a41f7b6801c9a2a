#!/usr/bin/env python3
"""Forward dynamics of chains in space beside Pinocchio's articulated-body algorithm: time and error, one interleaved run.

    python3 tests/peers/chains.py [--rounds 101]

Point masses at the ends of rods on hinges about x, y and z in turn, with 10, 20 and 40 links, as in
codegen/tests/it/hinge_by_hinge.rs. The status is 1 if a chain takes more than 0.3 of Pinocchio's time, or if the two differ.
"""
import ctypes
import random
import subprocess

import run

LINKS, BAR, SAME = (10, 20, 40), 0.3, 1e-9
LENGTH, MASS, GRAVITY = 0.3, 0.5, 9.81
STATES, CALLS = 32, 2_000

PINOCCHIO = """#include <pinocchio/multibody.hpp>
#include <pinocchio/algorithm/aba.hpp>
using namespace pinocchio;
static Model model; static Data *data; static Eigen::VectorXd q, v, tau;
extern "C" void load(int n, double length, double mass, double gravity) {
  model = Model(); model.gravity.linear() << 0, 0, -gravity;
  for (int i = 0; i < n; i++) {
    SE3 place = SE3::Identity(); Eigen::Vector3d rod = Eigen::Vector3d::Zero(), before = Eigen::Vector3d::Zero();
    rod[(i + 2) % 3] = length; if (i) before[(i + 1) % 3] = length; place.translation() = before;
    std::string name = "j" + std::to_string(i); JointIndex j;
    if (i % 3 == 0) j = model.addJoint(i, JointModelRX(), place, name);
    else if (i % 3 == 1) j = model.addJoint(i, JointModelRY(), place, name);
    else j = model.addJoint(i, JointModelRZ(), place, name);
    model.appendBodyToJoint(j, Inertia(mass, rod, Eigen::Matrix3d::Zero()), SE3::Identity());
  }
  data = new Data(model); q.setZero(n); v.setZero(n); tau.setZero(n);
}
extern "C" void eval(const double *in, double *out) {
  const int n = model.nv;
  for (int i = 0; i < n; i++) { q[i] = in[i]; v[i] = in[n + i]; }
  aba(model, *data, q, v, tau); for (int i = 0; i < n; i++) out[i] = data->ddq[i];
}
"""


def model(n):
    """The chain's model text."""
    text = [f'format = 1\nname = "chain{n}"\ndof = {n}\ngravity = "-g*N.z"\n[parameters]',
            f'g = {{ value = {GRAVITY}, unit = "m/s^2" }}\nl = {{ value = {LENGTH}, unit = "m" }}\nm = {{ value = {MASS}, unit = "kg" }}']
    for i in range(n):
        point, frame = (f"p{i - 1}", f"f{i - 1}") if i else ("O", "N")
        text.append(f'[coordinates.q{i}]\nunit = "rad"\n[frames.f{i}]\nparent = "{frame}"\nrotations = [["{"xyz"[i % 3]}", "q{i}"]]\n'
                    f'[points.p{i}]\nposition = "{point} + l*f{i}.{"zxy"[i % 3]}"\n[bodies.b{i}]\ncentre = "p{i}"\nmass = "m"')
    return "\n".join(text) + "\n"


def ours(directory):
    """The library with every chain, and its operations."""
    import with_smartbed

    source = directory / "chains" / "src"
    source.mkdir(parents=True, exist_ok=True)
    (source.parent / "Cargo.toml").write_text(with_smartbed.MANIFEST.format(runtime=run.ROOT / "runtime"))
    text, operations = "//! Generated equations behind C entries.\n", {}
    for n in LINKS:
        file = source / f"chain{n}.toml"
        file.write_text(model(n))
        about = with_smartbed.emit_file(file, ["time"], source / f"chain{n}.rs")
        operations[n] = about["operations"]
        # As other mechanisms are timed: what depends on parameters alone is prepared before.
        mechanism = type("Chain", (), {"q": about["q"], "u": about["u"], "independent": range(n), "inputs": [], "constrained": False,
                                       "slots": [*about["q"], *about["u"], *about["parameters"]], "results": n})
        text += with_smartbed.entry(f"chain{n}", about, mechanism)
    (source / "lib.rs").write_text(text)
    subprocess.run(["cargo", "build", "-q", "--release", "--offline"], cwd=source.parent, check=True)
    return ctypes.CDLL(str(source.parent / "target" / "release" / "libpeers_ours.so")), operations


def measure(directory, rounds):
    """Prints a line a chain; those that miss a bar are returned."""
    import compare
    import with_pinocchio

    library, operations = ours(directory)
    timer = compare.timer(directory)
    numbers, missed = random.Random(1), []
    whole = with_pinocchio.compile_source(PINOCCHIO, directory, "chains_pinocchio")
    for n in LINKS:
        # A copy for each chain: one is loaded at a time.
        own = directory / f"chain{n}_pinocchio.so"
        own.write_bytes(whole.read_bytes())
        pinocchio = ctypes.CDLL(str(own))
        pinocchio.load(n, *(ctypes.c_double(x) for x in (LENGTH, MASS, GRAVITY)))
        # In the order of the slots of `ours`: those of the model's text.
        rows = [[numbers.uniform(-2, 2) for _ in range(2 * n)] + [GRAVITY, LENGTH, MASS] for _ in range(STATES)]
        flat = (ctypes.c_double * (STATES * len(rows[0])))(*(x for one in rows for x in one))
        getattr(library, f"prepare_chain{n}")(flat)
        functions = [getattr(library, f"eval_chain{n}"), pinocchio.eval]
        found = []
        for function in functions:
            out = (ctypes.c_double * n)()
            function(flat, out)
            found.append(list(out))
        size = max(abs(x) for x in found[1])
        error = max(abs(a - b) for a, b in zip(*found)) / size
        out, times = (ctypes.c_double * n)(), ([], [])
        for _ in range(rounds):
            for function, mine in zip(functions, times):
                mine.append(timer(function, flat, len(rows[0]), STATES, out, CALLS))
        ratio = compare.ratio(*times)
        print(f"{n} links: {operations[n]} operations, {min(times[0]):.0f} ns; Pinocchio {min(times[1]):.0f} ns; ratio {ratio}; they differ by {error:.1e}")
        missed += [f"{n} links take {ratio} of Pinocchio's time"] if ratio > BAR else []
        missed += [f"{n} links: accelerations differ by {error}"] if not error < SAME else []
    return missed


if __name__ == "__main__":
    run.alone(__doc__, measure)
