"""Mutation testing with one build: which wrong changes of the code does no test notice?

    python3 tests/mutants/run.py [--seed 1] [--count 300] [--only REGEX]

`places.py` lists what may be changed, from the syntax tree: operators, signs, whole functions, and calls that build
expressions (`pip install tree-sitter tree-sitter-rust`). A seed draws from the list. In a copy of the tree every drawn place reads `if mutant(17) { changed } else { original }`,
so that all mutants share one build; each is then a run of the test programs that can kill it, until one fails.

Survivors must stand in survivors.tsv with a reason: status 1 where more than 5 % of the mutants do not.
"""

import argparse
import json
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import threading
import time

import places

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
WORK = ROOT / "target" / "mutants"
TREE = WORK / "tree"
UNEXPLAINED = 0.05
# A mutant that needs this many times what the tests need without any hangs: it is noticed.
PATIENCE = 4.0

FUNCTION = """
/// Is this mutant the one that the environment names?
#[must_use]
#[cfg(not(target_os = "none"))]
pub fn mutant(number: u32) -> bool {
    extern crate std;
    static CHOSEN: std::sync::OnceLock<u32> = std::sync::OnceLock::new();
    let read = || std::env::var("SMARTBED_MUTANT").ok().and_then(|n| n.parse().ok()).unwrap_or(0);
    *CHOSEN.get_or_init(read) == number
}

/// There are none on the chip.
#[must_use]
#[cfg(target_os = "none")]
pub const fn mutant(_: u32) -> bool {
    false
}
"""

EQUATIONS = [
    ("smartbed-tests", ["random_mechanisms", "every_field"]),
    ("smartbed-codegen", ["--skip", "example_crate", "--skip", "hostile"]),
    ("smartbed-tests", ["accuracy::", "agreement::", "energy::", "cost::all", "cost::closed", "hard_mechanisms::"]),
]
BODIES = [
    ("smartbed-runtime", []),
    ("smartbed-tests", ["contact_laws", "impact", "hard_cases::", "flexible_", "rigid_", "bar_on_wall"]),
    ("smartbed-tests", ["observed_order", "dense_output", "tile_motion::"]),
]
IMAGE = [("smartbed-tests", ["emulator::defects_are_refused"])]
# Where mutants are drawn, and which tests can kill them, the quickest first.
AREAS = [
    ("codegen/src/dynamics/**/*.rs", EQUATIONS),
    ("codegen/src/kinematics/**/*.rs", EQUATIONS),
    ("codegen/src/value/**/*.rs", EQUATIONS),
    ("runtime/src/contact/**/*.rs", BODIES),
    ("runtime/src/advance/**/*.rs", BODIES),
    ("runtime/src/integrator/**/*.rs", BODIES),
    ("host/src/firmware/image/**/*.rs", IMAGE),
]
FOLDERS = {"smartbed-tests": "tests", "smartbed-codegen": "codegen", "smartbed-runtime": "runtime"}
# Mechanisms that the random ones are cut down to: enough to meet every branch often.
ENVIRONMENT = {"SMARTBED_MECHANISMS": "1000"}


def run(command, **options):
    return subprocess.run(command, text=True, capture_output=True, **options)


def listed(pattern):
    """What may be changed in the files of a pattern."""
    files = sorted(ROOT.glob(pattern))
    return [c for file in files for c in places.of(str(file.relative_to(ROOT)), file.read_bytes())]


def draw(seed, count, only):
    """So many places of each area in proportion, by seed; none inside another."""
    chosen = []
    for pattern, tests in AREAS:
        for change in listed(pattern):
            change["tests"] = tests
            chosen.append(change)
    chosen = [c for c in chosen if not only or re.search(only, c["key"])]
    random.Random(seed).shuffle(chosen)
    kept = []
    for change in chosen:
        beside = [k for k in kept if k["file"] == change["file"]]
        if all(change["end"] <= k["start"] or k["end"] <= change["start"] for k in beside):
            kept.append(change)
        if len(kept) == count:
            break
    for number, change in enumerate(kept, 1):
        change["number"] = number
    return kept


def write(changes):
    """The tree with every drawn place made a switch; lines keep their numbers."""
    shutil.rmtree(TREE, ignore_errors=True)
    TREE.mkdir(parents=True)
    files = run(["git", "ls-files"], cwd=ROOT).stdout.splitlines()
    for name in files:
        target = TREE / name
        target.parent.mkdir(parents=True, exist_ok=True)
        if (ROOT / name).is_file():
            shutil.copy2(ROOT / name, target)
    # Switches need no style; other flags would build every dependency anew.
    settings = TREE / "Cargo.toml"
    settings.write_text(settings.read_text().replace('= "deny"', '= "allow"'))
    library = TREE / "runtime/src/lib.rs"
    library.write_text(library.read_text() + FUNCTION)
    for name in {c["file"] for c in changes}:
        text = (TREE / name).read_bytes()
        crate = b"crate" if name.startswith("runtime/") else b"smartbed_runtime"
        for c in sorted((c for c in changes if c["file"] == name), key=lambda c: -c["start"]):
            test = b"%s::mutant(%d)" % (crate, c["number"])
            original = text[c["start"] : c["end"]]
            text = text[: c["start"]] + c["switch"](test, original) + text[c["end"] :]
        (TREE / name).write_bytes(text)


def build(changes):
    """Test programs by package; mutants that the compiler refuses are left out."""
    packages = sorted({package for c in changes for package, _ in c["tests"]})
    options = [option for package in packages for option in ("-p", package)] + ["--test", "it"]
    environment = dict(os.environ)
    environment.setdefault("CARGO_TARGET_DIR", str(WORK / "target"))

    def cargo(*command):
        done = run(["cargo", *command, "--message-format=json", "--keep-going", *options], cwd=TREE, env=environment)
        return done, [json.loads(line) for line in done.stdout.splitlines() if line.startswith("{")]

    while True:
        write(changes)
        done, messages = cargo("check", "--profile", "test")
        if not done.returncode:
            break
        wrong = set()
        for m in messages:
            if m["reason"] == "compiler-message" and m["message"]["level"] == "error":
                for span in m["message"]["spans"]:
                    wrong |= {c["number"] for c in changes if c["file"] == span["file_name"]
                              and c["lines"][0] <= span["line_end"] and span["line_start"] <= c["lines"][1]}
        if not wrong:
            sys.exit(f"the tree does not build: {done.stderr[-3000:]}")
        print(f"{len(wrong)} mutants do not compile", flush=True)
        changes = [c for c in changes if c["number"] not in wrong]
    done, messages = cargo("test", "--no-run")
    if done.returncode:
        sys.exit(f"the tree does not build: {done.stderr[-3000:]}")
    tests = [m for m in messages if m["reason"] == "compiler-artifact" and m.get("executable") and m["profile"]["test"]]
    by_folder = {pathlib.Path(m["manifest_path"]).parent.name: m["executable"] for m in tests}
    return changes, {p: by_folder[FOLDERS[p]] for p in packages}


def outcome(program, filters, number, limit, known=frozenset()):
    """Names of tests that fail: all without a mutant, else the first beside those known; a crash or a hang is one."""
    folder, executable = program
    environment = dict(os.environ, SMARTBED_MUTANT=str(number), **ENVIRONMENT)
    environment["CARGO_MANIFEST_DIR"] = str(TREE / folder)
    failed = set()
    with subprocess.Popen([executable, *filters], cwd=TREE / folder, env=environment, text=True, errors="replace",
                          stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as tests:
        late = []
        clock = threading.Timer(limit or 1e6, lambda: (late.append(True), tests.kill()))
        clock.start()
        for line in tests.stdout:
            failed |= set(re.findall(r"^test (\S+) \.\.\. FAILED", line)) - known
            if number and failed:
                tests.kill()
        status = tests.wait()
        clock.cancel()
    if late:
        return {"no end"}
    return failed or ({"crash"} if status not in (0, 101) else set())


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("--seed", type=int, default=1)
    arguments.add_argument("--count", type=int, default=300)
    arguments.add_argument("--only", help="draw only where this matches `file | line`")
    asked = arguments.parse_args()
    reasons = dict(line.split("\t", 1) for line in (HERE / "survivors.tsv").read_text().splitlines()[1:] if line)
    changes, programs = build(draw(asked.seed, asked.count, asked.only))
    own, limits = {}, {}
    for package, filters in {(p, tuple(f)) for c in changes for p, f in c["tests"]}:
        start = time.time()
        own[package, filters] = outcome((FOLDERS[package], programs[package]), filters, 0, None)
        limits[package, filters] = 30 + PATIENCE * (time.time() - start)
        print(f"without a mutant: {package} {' '.join(filters)}: fails {sorted(own[package, filters])}", flush=True)
    survivors, unexplained = [], []
    for c in changes:
        killed = None
        for package, filters in c["tests"]:
            key = (package, tuple(filters))
            program = (FOLDERS[package], programs[package])
            fails = outcome(program, filters, c["number"], limits[key], own[key])
            if fails:
                killed = sorted(fails)[0]
                break
        print(f"{c['number']}\t{killed or 'SURVIVES'}\t{c['key']}", flush=True)
        if not killed:
            survivors.append(c)
            if c["key"] not in reasons:
                unexplained.append(c)
    share = len(unexplained) / max(len(changes), 1)
    print(f"{len(changes)} mutants, {len(survivors)} survive, {len(unexplained)} without a reason ({share:.1%})")
    return int(share > UNEXPLAINED)


if __name__ == "__main__":
    sys.exit(main())
