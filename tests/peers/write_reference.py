#!/usr/bin/env python3
"""Writes tests/reference/accuracy/<model>.json: states and their accelerations from exact.py, rounded once.

Needs gmpy2 (run.py installs it): python3 tests/peers/write_reference.py [model...]
"""
import json
import sys

import exact
import states

COUNT = 1000
MODELS = ["pendulum3", "fourbar", "tile", "arm6", "bicycle", "pendulum10"]


def line(model, q, u, inputs, p):
    mechanism = exact.MODELS[model]
    _, rates = exact.rates(mechanism, q, u, inputs, p)
    u_dot = [float(rates[k]) for k in mechanism.independent]
    # The hub's place is no coordinate of the model.
    largest = float("%.3g" % max(abs(float(x)) for x in rates[: len(q)]))
    return json.dumps([q, u, inputs, u_dot, largest], separators=(",", ":"))


def write(model):
    p = states.parameters(model)
    lines = [line(model, *s, p) for s in states.states(model, COUNT)]
    hard = [
        '{"name": %s, "parameters": %s, "state": %s}' % (json.dumps(name), json.dumps(of), line(model, q, u, w, of))
        for name, q, u, w, of in states.hard_states(model)
    ]
    text = '{"model": "%s",\n"about": "each state: q, independent u, inputs, their u_dot from 200-bit arithmetic of the doubles as given, and the largest rate of any speed, dependent ones included",\n' % model
    text += '"parameters": %s,\n"states": [\n%s\n],\n' % (json.dumps(p), ",\n".join(lines))
    text += '"hard": [%s]}\n' % ("\n" + ",\n".join(hard) + "\n" if hard else "")
    directory = states.REFERENCE / "accuracy"
    directory.mkdir(exist_ok=True)
    (directory / f"{model}.json").write_text(text)
    print(model, len(text), "bytes")


if __name__ == "__main__":
    for model in sys.argv[1:] or MODELS:
        write(model)
