"""Mutation testing with one build: which wrong changes of the code does no test notice?

    python3 tests/mutants/run.py [--seed 1] [--count 300] [--only REGEX] [--jobs 1] [--again] [--so-far]

`places.py` lists what may be changed, from the syntax tree: operators, signs, whole functions, and calls that build
expressions (`pip install tree-sitter tree-sitter-rust`); `areas.py` says where, and which tests can notice it. A seed
draws from the list, `switched.py` builds all that is drawn at once. Each mutant is then a run of the test programs
that can kill it, until one fails, stage by stage. Verdicts go to verdicts-SEED.jsonl beside this file as they are found: a run that
was stopped goes on where it was; `--again` runs those anew that survived, `--so-far` runs none and tells what is known.

Survivors must stand in survivors.tsv with a reason: status 1 where more than 5 % of the mutants do not. One that has a
reason is run through its first stage alone.
"""

import argparse
import collections
import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import resource
import subprocess
import sys
import threading
import time

import areas
import places
import switched

HERE = pathlib.Path(__file__).resolve().parent
UNEXPLAINED = 0.05
# The verdict about what the compiler refuses.
REFUSED = "does not compile"
# A mutant hangs that takes this many times the processor time that the tests take without any, and some seconds.
PATIENCE, GRACE = 4.0, 10.0
# Wall time over processor time at which one that sleeps is given up: machines are busy.
ASLEEP = 20.0
# Bytes at which one that collects without end is stopped.
MEMORY = 4 << 30


def listed(pattern):
    """What may be changed in the files of a pattern; changes of the same words in one file are told apart by number."""
    found = []
    for file in sorted(switched.ROOT.glob(pattern)):
        seen = collections.Counter()
        for change in places.of(str(file.relative_to(switched.ROOT)), file.read_bytes()):
            seen[change["key"]] += 1
            if seen[change["key"]] > 1:
                change["key"] += f" | {seen[change['key']]}"
            found.append(change)
    return found


def draw(seed, count, only, refused):
    """So many places, none inside another, but those that the compiler is known to refuse. What is drawn does not hang
    on what changes elsewhere in the code."""
    drawn = [dict(change, tests=tests, area=pattern.removesuffix("/**/*.rs"))
             for pattern, tests in areas.AREAS for change in listed(pattern)]
    drawn = [c for c in drawn if c["key"] not in refused and (not only or re.search(only, c["key"]))]
    drawn.sort(key=lambda c: hashlib.sha256(f"{seed} {c['key']}".encode()).digest())
    kept = []
    for change in drawn:
        beside = [k for k in kept if k["file"] == change["file"]]
        if all(change["end"] <= k["start"] or k["end"] <= change["start"] for k in beside):
            kept.append(change)
        if len(kept) == count:
            break
    for number, change in enumerate(kept, 1):
        change["number"] = number
    return kept


def outcome(folder, executable, filters, number, limit, known=frozenset()):
    """Names of tests that fail: all without a mutant, else the first beside those known; a crash or a hang is one."""
    environment = dict(os.environ, SMARTBED_MUTANT=str(number), **areas.ENVIRONMENT)
    environment["CARGO_MANIFEST_DIR"] = str(switched.TREE / folder)

    def bounds():
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        resource.setrlimit(resource.RLIMIT_CPU, (int(limit), int(limit) + 5))

    failed = set()
    with subprocess.Popen([executable, *filters], cwd=switched.TREE / folder, env=environment, text=True,
                          errors="replace", preexec_fn=bounds, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as tests:
        late = []
        clock = threading.Timer(ASLEEP * limit, lambda: (late.append(True), tests.kill()))
        clock.start()
        for line in tests.stdout:
            failed |= set(re.findall(r"^test (\S+) \.\.\. FAILED", line)) - known
            if number and failed:
                tests.kill()
        status = tests.wait()
        clock.cancel()
    if failed:
        return failed
    if late or status == -24:
        return {"no end"}
    return {"crash"} if status not in (0, 101) else set()


class Judge:
    """Runs test programs and knows what they do without a mutant."""

    def __init__(self, programs):
        self.programs, self.own, self.limits = programs, {}, {}

    def prepare(self, program):
        package, target, filters = program
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        self.own[program] = self.fails(program, 0, 3600)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        self.limits[program] = GRACE + PATIENCE * seconds
        print(f"without a mutant: {package} {target} {' '.join(filters)}: {seconds:.0f} s, "
              f"fails {sorted(self.own[program])}", flush=True)

    def fails(self, program, number, limit):
        package, target, filters = program
        return outcome(areas.FOLDERS[package], self.programs[package, target], filters, number, limit,
                       self.own.get(program, frozenset()))

    def verdict(self, change, stage):
        """The test that kills a mutant, or None."""
        for program in change["tests"][stage]:
            fails = self.fails(program, change["number"], self.limits[program])
            if fails:
                return min(fails)
        return None


class Verdicts:
    """What kills each mutant, or None, and at which stage that was found; each written down at once."""

    def __init__(self, path):
        self.path = path
        lines = path.read_text().splitlines() if path.exists() else []
        self.found = {key: (stage, killer) for key, stage, killer in map(json.loads, lines)}

    def note(self, key, stage, killer):
        self.found[key] = (stage, killer)
        with self.path.open("a") as log:
            print(json.dumps([key, stage, killer]), file=log)
        print(f"{stage}\t{killer or 'survives'}\t{key}", flush=True)

    def refused(self):
        return {key for key, (_, killer) in self.found.items() if killer == REFUSED}

    def waits(self, change, stage, reasons):
        """Did it survive all stages before this one without a reason, and not yet go through this one?"""
        last, killer = self.found.get(change["key"], (-1, None))
        return killer is None and last < stage and not (last >= 0 and change["key"] in reasons)


def judge(changes, waiting, stage, verdicts, jobs):
    """Those waiting for one stage; False if the compiler refused some of all, so that there are others to draw."""
    programs, refused = switched.build(changes, stage)
    for change in refused:
        verdicts.note(change["key"], stage, REFUSED)
    if refused:
        return False
    judge = Judge(programs)
    for program in sorted({program for c in waiting for program in c["tests"][stage]}):
        judge.prepare(program)
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        at_work = {pool.submit(judge.verdict, c, stage): c for c in waiting}
        for done in concurrent.futures.as_completed(at_work):
            verdicts.note(at_work[done]["key"], stage, done.result())
    return True


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("--seed", type=int, default=1)
    arguments.add_argument("--count", type=int, default=300)
    arguments.add_argument("--only", help="draw only where this matches `file | line | change`")
    arguments.add_argument("--jobs", type=int, default=1)
    arguments.add_argument("--again", action="store_true", help="run anew what survived")
    arguments.add_argument("--so-far", action="store_true", help="run none, tell what is known")
    asked = arguments.parse_args()
    start = time.time()
    reasons = dict(line.split("\t", 1) for line in (HERE / "survivors.tsv").read_text().splitlines()[1:] if line)
    switched.WORK.mkdir(parents=True, exist_ok=True)
    verdicts = Verdicts(HERE / f"verdicts-{asked.seed}.jsonl")
    if asked.again:
        verdicts.found = {key: found for key, found in verdicts.found.items() if found[1]}
    stage = areas.STAGES if asked.so_far else 0
    changes = draw(asked.seed, asked.count, asked.only, verdicts.refused())
    while stage < areas.STAGES:
        waiting = [c for c in changes if verdicts.waits(c, stage, reasons)]
        if not waiting or judge(changes, waiting, stage, verdicts, asked.jobs):
            stage += 1
        changes = draw(asked.seed, asked.count, asked.only, verdicts.refused())
    share = table(changes, verdicts, reasons)
    print(f"seed {asked.seed}, {(time.time() - start) / 60:.0f} min")
    return int(share > UNEXPLAINED)


def table(changes, verdicts, reasons):
    """Prints what became of the mutants of each area; returns the share of those judged that survive without a reason."""
    columns = ["waiting", "killed", "explained", "unexplained"]
    counts = collections.defaultdict(collections.Counter)
    for change in changes:
        stage, killer = verdicts.found.get(change["key"], (-1, None))
        fate = "killed" if killer else "explained" if change["key"] in reasons else "unexplained"
        if not killer and (stage < 0 or fate == "unexplained" and stage < areas.STAGES - 1):
            fate = "waiting"
        if fate == "unexplained":
            print(f"UNEXPLAINED\t{change['key']}")
        for row in (change["area"], "all"):
            counts[row][fate] += 1
    print(f"| where | drawn | {' | '.join(columns)} |\n|---{'|---' * 5}|")
    for row, count in sorted(counts.items(), key=lambda row: (row[0] == "all", row[0])):
        print(f"| {row} | {count.total()} | {' | '.join(str(count[c]) for c in columns)} |")
    judged = counts["all"].total() - counts["all"]["waiting"]
    return counts["all"]["unexplained"] / max(judged, 1)


if __name__ == "__main__":
    sys.exit(main())
