#!/usr/bin/env python3
"""How much longer peers take than ours for the same error: the least ratio of each model, and whether it keeps its bar.

    python3 tests/peers/ratios.py [FILE.json ...]

Without files: the stored results of every machine. For each point of a peer, its time over that of our fastest point with
no larger error; a point that none of ours reaches counts as 0. The exit status is 1 if a model's least ratio is below the
bar. motions.py applies this to what it has just measured.
"""
import json
import pathlib
import sys

# What the project aims at, in every model.
BAR = 5


def least(points):
    """{model: (ratio, the peer's point)}: the least ratio of each model with peers."""
    found = {}
    for peer in (point for point in points if point["peer"]):
        ours = [own["nanoseconds"] for own in points
                if not own["peer"] and own["subject"] == peer["subject"] and own["error"] <= peer["error"]]
        ratio = peer["nanoseconds"] / min(ours) if ours else 0.0
        if ratio < found.get(peer["subject"], (float("inf"),))[0]:
            found[peer["subject"]] = ratio, peer
    return found


def check(points):
    """Prints the least ratios; returns what is below the bar."""
    missed = []
    for model, (ratio, peer) in least(points).items():
        print(f"{model}: least ratio {ratio:.2f} to {peer['method']} at {peer['error']:.1e}; at least {BAR} expected")
        if ratio < BAR:
            missed.append(f"{model}: {peer['method']} takes {ratio:.2f} times as long as ours at {peer['error']:.1e}; expected {BAR}")
    return missed


def main():
    files = sys.argv[1:] or sorted((pathlib.Path(__file__).parent / "results").glob("*/motions.json"))
    missed = [] if files else ["no results: run motions.py first"]
    for file in files:
        missed += check(json.loads(pathlib.Path(file).read_text())["points"])
    for line in missed:
        print(line, file=sys.stderr)
    sys.exit(bool(missed))


if __name__ == "__main__":
    main()
