"""A copy of the tree in which every drawn place reads `if mutant(17) { changed } else { original }`, and its test programs.

All mutants share one build: the environment variable SMARTBED_MUTANT says which of them a run is about.
"""

import json
import os
import pathlib
import subprocess
import sys

import areas

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
WORK = ROOT / "target" / "mutants"
TREE = WORK / "tree"

FUNCTION = """
/// Is this mutant the one that the environment names?
#[must_use]
#[inline]
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


def run(command, **options):
    return subprocess.run(command, text=True, capture_output=True, **options)


def write(changes):
    """The tree with every drawn place made a switch; lines keep their numbers. What stays the same is not written."""
    listed = run(["git", "ls-files", "--cached", "--others", "--exclude-standard"], cwd=ROOT).stdout.splitlines()
    names = [n for n in listed if (ROOT / n).is_file()]
    texts = {name: (ROOT / name).read_bytes() for name in names}
    # Switches need no style; other flags would build every dependency anew.
    texts["Cargo.toml"] = texts["Cargo.toml"].replace(b'= "deny"', b'= "allow"')
    for c in sorted(changes, key=lambda c: -c["start"]):
        crate = b"crate" if c["file"].startswith("runtime/") else b"smartbed_runtime"
        test, text = b"%s::mutant(%d)" % (crate, c["number"]), texts[c["file"]]
        original = text[c["start"] : c["end"]]
        texts[c["file"]] = text[: c["start"]] + c["switch"](test, original) + text[c["end"] :]
    texts["runtime/src/lib.rs"] += FUNCTION.encode()
    for stale in (f for f in TREE.rglob("*") if f.is_file() and str(f.relative_to(TREE)) not in texts):
        stale.unlink()
    for name, text in texts.items():
        target = TREE / name
        if not target.is_file() or target.read_bytes() != text:
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(text)


def build(changes, stage):
    """Test programs of a stage by package and target, and the changes that the compiler refuses: if there are any, no
    programs."""
    programs = sorted({program[:2] for c in changes for program in c["tests"][stage]})
    environment = dict(os.environ)
    environment.setdefault("CARGO_TARGET_DIR", str(WORK / "target"))
    write(changes)
    built, refused, failed = {}, [], ""
    # One call a kind of target: cargo builds the named targets of every package that it is given.
    for target in sorted({target for _, target in programs}):
        options = [o for p, t in programs if t == target for o in ("-p", p)]
        options += ["--lib"] if target == "lib" else ["--test", target]
        command = ["cargo", "test", "--no-run", "--message-format=json", *options]
        done = run(command, cwd=TREE, env=environment)
        failed += done.stderr[-3000:] if done.returncode else ""
        for m in (json.loads(line) for line in done.stdout.splitlines() if line.startswith("{")):
            if m["reason"] == "compiler-artifact" and m.get("executable") and m["profile"]["test"]:
                built[pathlib.Path(m["manifest_path"]).parent.name, target] = m["executable"]
            elif m["reason"] == "compiler-message" and m["message"]["level"] == "error":
                spans = m["message"]["spans"]
                refused += [c for c in changes if any(stands_in(span, c) for span in spans)]
    if failed and not refused:
        sys.exit(f"the tree does not build: {failed}")
    return {} if refused else {(p, t): built[areas.FOLDERS[p], t] for p, t in programs}, refused


def stands_in(span, change):
    """Is a message about this change?"""
    first, last = change["lines"]
    return span["file_name"] == change["file"] and first <= span["line_end"] and span["line_start"] <= last
