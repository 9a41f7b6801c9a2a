"""Random consistent states and the hard ones, by model. Given numbers are short decimals; dependent
coordinates are solved to 200 bits and rounded once to double."""
import json
import math
import pathlib
import random

import exact

REFERENCE = pathlib.Path(__file__).resolve().parent.parent / "reference"

TILE = dict(R=0.2, ms=0.8, mr=2.0, mc=0.15, Ic1=1e-4, Ic2=1e-4, Ic3=2e-4, M=6.0, Ix=0.09, Iy=0.09, Iz=0.17, c=40.0, g=9.81)
FOURBAR = dict(l1=1.0, l2=2.2, l3=1.8, l4=2.0, m1=1.1, m2=2.3, m3=1.7, I1=0.09, I2=0.9, I3=0.45, g=9.81)
PARALLELOGRAM = FOURBAR | dict(l1=1.0, l2=2.0, l3=1.0, l4=2.0)
# Below this sine of the angle between coupler and rocker the crank hardly drives the linkage.
SMALLEST_TRANSMISSION = 0.3


def stored(model):
    """Parameters of a stored reference."""
    data = json.loads((REFERENCE / f"{model}.json").read_text())
    return dict(zip(data["param_names"], data["samples"][0]["params"]))


def pendulum_parameters(n):
    r = random.Random(n)
    values = {f"m{i}": round(r.uniform(0.5, 1.5), 2) for i in range(n)}
    values |= {f"l{i}": round(r.uniform(0.5, 1.5), 2) for i in range(n)}
    return values | {"g": 9.81}


def parameters(model):
    """Parameters by name, in the order of the model text."""
    if model.startswith("pendulum"):
        return pendulum_parameters(int(model[8:]))
    return {"tile": TILE, "fourbar": FOURBAR}.get(model) or stored(model)


def draw(r, n, size):
    return [round(r.uniform(-size, size), 3) for _ in range(n)]


def tile_q(h):
    q = [x for height in h for x in (height, 0.0, 0.0, 0.2)]
    return [float(x) for x in exact.assemble(exact.MODELS["tile"], q, [1, 2, 3, 5, 6, 7, 9, 10, 11], TILE)]


def bicycle_q(yaw, roll, steer, rear, front):
    q = [yaw, roll, 0.0, steer, rear, front, 0.0, 0.0]
    return [float(x) for x in exact.assemble(exact.MODELS["bicycle"], q, [2], stored("bicycle"))][:6]


def fourbar_q(q1):
    """Open branch; None near the dead centres."""
    p = FOURBAR
    x, y = p["l4"] - p["l1"] * math.cos(q1), -p["l1"] * math.sin(q1)
    d = math.hypot(x, y)
    cosine = (p["l2"] ** 2 + d * d - p["l3"] ** 2) / (2 * p["l2"] * d)
    if not abs(cosine) < 1:
        return None
    q2 = math.atan2(y, x) + math.acos(cosine)
    q3 = math.atan2(y - p["l2"] * math.sin(q2), x - p["l2"] * math.cos(q2))
    if abs(math.sin(q3 - q2)) < SMALLEST_TRANSMISSION:
        return None
    return [float(x) for x in exact.assemble(exact.MODELS["fourbar"], [q1, q2, q3], [1, 2], p)]


def state(model, r):
    """(q, independent u, inputs)."""
    if model.startswith("pendulum"):
        n = int(model[8:])
        return draw(r, n, 2.0), draw(r, n, 3.0), []
    if model == "arm6":
        return draw(r, 6, 3.0), draw(r, 6, 2.0), draw(r, 6, 10.0)
    if model == "tile":
        return tile_q(draw(r, 3, 0.08)), draw(r, 3, 0.3), [round(r.uniform(-30, 60), 2) for _ in range(3)]
    if model == "bicycle":
        roll, steer = draw(r, 1, 0.5)[0], draw(r, 1, 0.6)[0]
        yaw, rear, front = draw(r, 3, 3.0)
        return bicycle_q(yaw, roll, steer, rear, front), draw(r, 2, 1.0) + [round(-r.uniform(3, 20), 2)], draw(r, 3, 5.0)
    while True:
        q = fourbar_q(draw(r, 1, 3.0)[0])
        if q:
            return q, draw(r, 1, 4.0), draw(r, 1, 3.0)


def states(model, count, seed=4):
    r = random.Random(seed)
    return [state(model, r) for _ in range(count)]


def typical(mechanism, count=60):
    """Values by name at some random states."""
    return [dict(zip(mechanism.q, q)) | parameters(mechanism.name) for q, _, _ in states(mechanism.name, count)]


def hard_states(model):
    """[(name, q, u, inputs, parameters)]."""
    if model == "tile":
        level = lambda h: (tile_q([h] * 3), [0.1, -0.05, 0.02], [10.0, 20.0, 30.0], TILE)
        return [("level", *level(0.0)), ("raised", *level(0.1))]
    if model == "bicycle":
        p = stored("bicycle")
        at = lambda roll, steer: (bicycle_q(0.3, roll, steer, 0.0, 0.0), [0.1, -0.2, -16.0], [1.0, 0.5, -2.0], p)
        straight = (bicycle_q(0.0, 0.0, 0.0, 0.0, 0.0), [0.0, 0.0, -16.0], [1.0, 0.5, -2.0], p)
        return [
            ("upright straight", *straight),
            ("leaned, zero steer", *at(0.3, 0.0)),
            ("steered, zero lean", *at(0.0, 0.4)),
            ("1e-7 from upright", *at(1e-7, -1e-7)),
        ]
    if model == "fourbar":
        name = lambda q1: f"parallelogram {q1:g} rad from its change point"
        at = lambda q1: ([q1, 0.0, float(exact.mpfr(q1) - exact.gmpy2.const_pi())], [1.5], [0.7], PARALLELOGRAM)
        return [(name(q1), *at(q1)) for q1 in (1.0, 1e-3, 1e-6)]
    return []
