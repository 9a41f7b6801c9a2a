"""Builds every mechanism with every peer, compares the outputs, measures times in alternating turns, writes the table."""
import ctypes
import importlib
import json
import pathlib
import platform
import re
import statistics
import subprocess
import time

import mechanisms
import states
import with_smartbed

FLAGS = ["-O3", "-shared", "-fPIC", "-w"]
# Peers that give C source and a count, and peers that are libraries.
GENERATORS = {"CasADi": "with_casadi", "SymPy Kane": "with_sympy", "SymForce": "with_symforce"}
LIBRARIES = {"Pinocchio": "with_pinocchio", "MuJoCo": "with_mujoco"}
# Ours, by the form of the program.
OURS = {"smartbed": "short", "smartbed for time": "time"}
# What the project reaches for everywhere: worst error over CasADi's, ms of a derivation with default and with all effort.
ERROR, DERIVATION = 2, (5, 200)
# And by model: operations of the short form, and which form's time over CasADi's.
REACH = {"tile": (640, "smartbed", 0.17), "arm6": (1100, "smartbed", 0.75), "bicycle": (1050, "smartbed", 0.75),
         "fourbar": (100, None, None), "pendulum10": (340, "smartbed for time", 0.6)}
# States that the timing cycles through, and evaluations per turn.
TIMED_STATES, CALLS = 32, 4_000

TIMER = """#include <time.h>
typedef void (*entry)(const double *, double *);
double nanoseconds(entry f, const double *in, long size, long states, double *out, long calls) {
  struct timespec a, b; clock_gettime(CLOCK_MONOTONIC, &a);
  for (long i = 0, k = 0; i < calls; i++) { f(in + k * size, out); if (++k == states) k = 0; }
  clock_gettime(CLOCK_MONOTONIC, &b);
  return ((b.tv_sec - a.tv_sec) * 1e9 + (b.tv_nsec - a.tv_nsec)) / calls;
}
"""


def compile_c(source, name, directory):
    c, so = directory / f"{name}.c", directory / f"{name}.so"
    c.write_text(source)
    subprocess.run(["gcc", *FLAGS, str(c), "-o", str(so), "-lm"], check=True, capture_output=True, text=True)
    return ctypes.CDLL(str(so))


def timer(directory):
    """A clock for compiled functions: nanoseconds of one call, from (function, inputs, their number, states, results, calls)."""
    nanoseconds = compile_c(TIMER, "timer", directory).nanoseconds
    nanoseconds.restype = ctypes.c_double
    nanoseconds.argtypes = [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_long, ctypes.c_long, ctypes.c_void_p, ctypes.c_long]
    return lambda function, *rest: nanoseconds(ctypes.cast(function, ctypes.c_void_p), *rest)


class Entry:
    """One peer's forward dynamics of one mechanism, or why there is none."""

    def __init__(self, function=None, operations=None, build_ms=None, missing=None):
        self.function, self.operations, self.build_ms, self.missing = function, operations, build_ms, missing
        self.times, self.errors = [], []
        # Ours alone: preparing, its operations, and an evaluation that prepares inside.
        self.prepare, self.prepare_operations, self.whole, self.whole_times = None, None, None, []
        self.default_ms = None


def reason(error):
    return f"{type(error).__name__}: {str(error).splitlines()[0] if str(error) else ''}"[:160]


def build(names, directory):
    """{model: {peer: Entry}}, ours first."""
    built = {name: mechanisms.MECHANISMS[name]() for name in names}
    table = {name: {} for name in names}
    try:
        library, emitted = with_smartbed.build(built, directory)
        library = ctypes.CDLL(str(library))
        for (name, form), about in emitted.items():
            peer = next(peer for peer, of in OURS.items() if of == form)
            entry = Entry(library[f"eval_{name}_{form}"], about["operations"], about["milliseconds"])
            entry.prepare, entry.whole = library[f"prepare_{name}_{form}"], library[f"whole_{name}_{form}"]
            entry.prepare_operations, entry.default_ms = about["prepare"], about["default_milliseconds"]
            table[name][peer] = entry
    except Exception as error:  # reported in the table
        for name in names:
            table[name] = {peer: Entry(missing=reason(error)) for peer in OURS}
    for peer, module in (GENERATORS | LIBRARIES).items():
        for name in names:
            print(f"building {name} with {peer} ...", flush=True)
            try:
                table[name][peer] = build_one(peer, importlib.import_module(module), name, built[name], directory)
            except Exception as error:  # reported in the table
                table[name][peer] = Entry(missing=reason(error))
    return built, table


def build_one(peer, module, name, mechanism, directory):
    start = time.perf_counter()
    if peer in GENERATORS:
        source, operations = module.build(mechanism)
        milliseconds = (time.perf_counter() - start) * 1e3
        return Entry(compile_c(source, f"{name}_{module.__name__}", directory).eval, operations, milliseconds)
    library = module.build(name, directory)
    function = library[f"eval_{name}"] if peer == "Pinocchio" else library["eval"]
    return Entry(function)


def references(name):
    data = json.loads((states.REFERENCE / "accuracy" / f"{name}.json").read_text())
    return list(data["parameters"].values()), data["states"]


def prepare_all(mechanism, entries):
    """Hands the parameters to those that prepare; they lie behind coordinates, speeds and inputs."""
    parameters, rows = references(mechanism.name)
    q, u, inputs, *_ = rows[0]
    values = (ctypes.c_double * len(mechanism.slots))(*q, *u, *inputs, *parameters)
    for entry in entries:
        if entry.prepare:
            entry.prepare(values)


def check(mechanism, entries):
    """Errors of u' at all reference states; parameters, the same for all, are prepared here."""
    parameters, rows = references(mechanism.name)
    out, again = (ctypes.c_double * mechanism.results)(), (ctypes.c_double * mechanism.results)()
    prepare_all(mechanism, entries)
    for q, u, inputs, expected, scale in rows:
        values = (ctypes.c_double * len(mechanism.slots))(*q, *u, *inputs, *parameters)
        for entry in entries:
            entry.function(values, out)
            if entry.whole:
                entry.whole(values, again)
                assert list(out) == list(again), f"{mechanism.name}: preparing inside an evaluation changes its results"
            found = list(out)[-len(expected) :]
            entry.errors.append(max(abs(a - b) for a, b in zip(found, expected)) / scale)


def time_in_turns(built, table, rounds, directory):
    clock = timer(directory)
    for turn in range(rounds):
        for name, mechanism in built.items():
            parameters, rows = references(name)
            flat = [x for q, u, w, *_ in rows[:TIMED_STATES] for x in (*q, *u, *w, *parameters)]
            values, out = (ctypes.c_double * len(flat))(*flat), (ctypes.c_double * 64)()
            for entry in table[name].values():
                for function, times in ((entry.function, entry.times), (entry.whole, entry.whole_times)):
                    if function:
                        times.append(clock(function, values, len(mechanism.slots), TIMED_STATES, out, CALLS))


def machine():
    """Processor, as text and as a folder's name."""
    text = platform.processor() or platform.machine()
    try:
        found = re.search(r"model name\s*:\s*(.*)", pathlib.Path("/proc/cpuinfo").read_text())
        text = found.group(1) if found else text
    except OSError:
        pass
    return text, re.sub(r"[^a-z0-9]+", "-", re.sub(r"\(.*?\)", "", text).lower()).strip("-")


def versions():
    first = lambda *command: subprocess.run(command, capture_output=True, text=True).stdout.splitlines()[0]
    found = {"gcc": first("gcc", "--version"), "rustc": first("rustc", "--version")}
    for module in ("casadi", "sympy", "symforce", "pinocchio", "mujoco"):
        try:
            found[module] = importlib.import_module(module).__version__
        except Exception as error:  # reported
            found[module] = "missing: " + reason(error)
    return found


def ratio(times, base):
    """Median over the turns of the ratio within a turn: other load on the machine affects one turn equally, but not all turns."""
    return round(statistics.median(a / b for a, b in zip(times, base)), 3) if base else None


def summary(table):
    """Numbers of every entry, by model and peer."""
    result = {}
    for name, entries in table.items():
        base = entries["CasADi"]
        result[name] = {}
        for peer, entry in entries.items():
            if entry.missing:
                result[name][peer] = {"missing": entry.missing}
                continue
            result[name][peer] = {
                "operations": entry.operations,
                "nanoseconds": round(statistics.median(entry.times), 1),
                "fastest": round(min(entry.times), 1),
                "ratio_to_casadi": ratio(entry.times, base.times),
                "ratio_of_fastest": base.times and round(min(entry.times) / min(base.times), 3),
                "worst_error": max(entry.errors),
                "median_error": statistics.median(entry.errors),
                "build_ms": entry.build_ms and round(entry.build_ms, 2),
            }
            if entry.whole:
                whole = statistics.median(entry.whole_times)
                result[name][peer] |= {"prepare_operations": entry.prepare_operations, "nanoseconds_preparing": round(whole, 1),
                                       "default_ms": round(entry.default_ms, 2), "ratio_preparing": ratio(entry.whole_times, base.times)}
    return result


def reach(result):
    """What was reached for and found: rows of (model, what, found, bar)."""
    for name, (operations, peer, bar) in REACH.items():
        entries = result.get(name, {})
        ours, timed, casadi = (entries.get(key, {}) for key in ("smartbed", peer or "smartbed", "CasADi"))
        if "operations" not in ours or "operations" not in timed:
            continue
        yield name, "operations", ours["operations"], operations
        yield name, "derivation, default effort, ms", ours["default_ms"], DERIVATION[0]
        yield name, "derivation, all effort, ms", ours["build_ms"], DERIVATION[1]
        if "operations" not in casadi:
            continue
        if bar:
            yield name, f"ns / CasADi's ({peer})", max(timed["ratio_to_casadi"], timed["ratio_of_fastest"]), bar
        yield name, "worst error / CasADi's", round(ours["worst_error"] / casadi["worst_error"], 3), ERROR


def reach_table(result):
    lines = ["| model | what | found | bar | holds |", "|---|---|---|---|---|"]
    return lines + [f"| {name} | {what} | {found} | {bar} | {'yes' if found <= bar else 'no'} |" for name, what, found, bar in reach(result)]


def markdown(result, about):
    lines = [f"# Forward dynamics: {about['machine']}", "", f"{about['date']}; gcc -O3 and rustc opt-level 3, no target-cpu; "
             f"medians of {about['rounds']} turns, all in one process, in turns; ratios are medians of the ratios within a turn. Errors of the independent accelerations relative to the largest "
             "acceleration of the state (dependent ones included), at 1,000 random states, against 200-bit arithmetic. Operations: + - * / sqrt sin cos, 1 each. Other work may have "
             "run on the machine: trust the ratios.", "",
             "| model | peer | operations | prepare | ns | ns / CasADi's | ns preparing | / CasADi's | worst error | median error | build, ms |",
             "|---|---|---|---|---|---|---|---|---|---|---|"]
    for name, entries in result.items():
        for peer, e in entries.items():
            if "missing" in e:
                lines.append(f"| {name} | {peer} | - | - | - | - | - | - | - | - | {e['missing']} |")
                continue
            show = lambda x: "-" if x is None else x
            lines.append(f"| {name} | {peer} | {show(e['operations'])} | {show(e.get('prepare_operations'))} | {e['nanoseconds']} | "
                         f"{show(e['ratio_to_casadi'])} | {show(e.get('nanoseconds_preparing'))} | {show(e.get('ratio_preparing'))} | "
                         f"{e['worst_error']:.1e} | {e['median_error']:.1e} | {show(e['build_ms'])} |")
    lines += ["", *reach_table(result), "", "`prepare` is what depends on parameters alone: ours computes it once per parameter set, outside the timed loop, "
              "and its operations, for all answers (energies and projection too), are not in `operations`. `ns preparing` is an evaluation that prepares every time, like the peers, which "
              "compute everything in every evaluation. `smartbed` is the form with fewest operations, `smartbed for time` the one chosen for time.",
              "", "SymPy and SymForce give mass matrix, forces and constraint rows with common sub-expressions; a sparse straight-line "
              "elimination is appended and counted (straight_line.py). CasADi solves in its own symbols. Build times of Python peers "
              "are inside a warm process; ours is the whole derivation and emission in a fresh one, the fastest of several. Ratios of times in the table of bars: the "
              "larger of the median's and the fastest's.", "", "Versions: "
              + ", ".join(f"{k} {v}" for k, v in about["versions"].items()) + "."]
    return "\n".join(lines) + "\n"


def run(names, rounds, directory, results):
    directory.mkdir(parents=True, exist_ok=True)
    built, table = build(names, directory)
    for name, mechanism in built.items():
        check(mechanism, [entry for entry in table[name].values() if entry.function])
    time_in_turns(built, table, rounds, directory)
    processor, folder = machine()
    about = {"machine": processor, "date": time.strftime("%Y-%m-%d"), "rounds": rounds, "versions": versions()}
    result = summary(table)
    text = markdown(result, about)
    target = results / folder
    target.mkdir(parents=True, exist_ok=True)
    (target / "peers.md").write_text(text)
    (target / "peers.json").write_text(json.dumps({"about": about, "models": result}, indent=1) + "\n")
    print(text)
    return [f"{name}: {what}: {found}, bar {bar}" for name, what, found, bar in reach(result) if found > bar]
