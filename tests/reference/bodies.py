#!/usr/bin/env python3
"""Trajectories of flexible bodies, written without a look at the program that they are held against.

Own shapes, own forces, own contact law (energy compensation), own volume of the gas, own integrator (Gragg, Bulirsch &
Stoer), all in 80-bit numbers. Every case is integrated twice, the second time in half the steps; `agreement` is what the
two differ by. Needs numpy.

    python3 tests/reference/bodies.py tests/reference/bodies.json [CASE...]
"""

import json
import sys

import numpy as np

Real = np.longdouble
G = Real("9.81")
COLUMNS = 7  # of the extrapolation: order 14


class Body:
    """Points, springs, facets; the state is one row of positions, one of velocities."""

    def __init__(self, points, springs, facets=(), fixed=()):
        self.x = np.array(points, dtype=Real)
        self.springs = np.array(springs, dtype=int).reshape(-1, 2)
        self.facets = [list(f) for f in facets]
        self.mass = np.ones(len(points), dtype=Real)
        self.free = np.ones(len(points), dtype=bool)
        self.free[list(fixed)] = False
        tail, head = self.springs.T
        # Row by point, column by spring: a pull acts forwards on the tail, backwards on the head.
        self.acts = np.zeros((len(points), len(self.springs)), dtype=Real)
        self.acts[tail, np.arange(len(tail))] += 1
        self.acts[head, np.arange(len(head))] -= 1
        self.rest = np.sqrt(((self.x[head] - self.x[tail]) ** 2).sum(axis=1))
        self.k, self.c, self.air, self.gravity = Real(5000), Real(0), Real(0), G
        self.gas = None
        # A patch over a skew quadrilateral halves the tetrahedron of its corners: it encloses the mean of what its
        # two triangulations do.
        split = [[(a, b, c), (a, c, d), (a, b, d), (b, c, d)] for a, b, c, d in self.facets]
        self.triangles = np.array(split, dtype=int).reshape(-1, 3)
        self.v = np.zeros_like(self.x)

    def springs_of(self, x):
        """Unit vectors tail -> head and lengths."""
        tail, head = self.springs.T
        d = x[head] - x[tail]
        length = np.sqrt((d * d).sum(axis=1))
        return d / length[:, None], length

    def force(self, x, v):
        f = -self.air * v
        f[:, 2] -= self.mass * self.gravity
        if len(self.springs):
            tail, head = self.springs.T
            d, length = self.springs_of(x)
            rate = ((v[head] - v[tail]) * d).sum(axis=1)
            pull = (self.k * (length - self.rest) + self.c * rate)[:, None] * d
            f += self.acts @ pull
        if self.gas:
            f += self.gas(self, x)
        return f

    def acceleration(self, x, v, held):
        a = self.force(x, v) / self.mass[:, None]
        a[~self.free] = 0
        a[held, 2] = 0
        return a


def cross(a, b):
    columns = [a[:, (i + 1) % 3] * b[:, (i + 2) % 3] - a[:, (i + 2) % 3] * b[:, (i + 1) % 3] for i in range(3)]
    return np.stack(columns, axis=1)


def volume(body, x):
    p, q, r = (x[body.triangles[:, i]] for i in range(3))
    return (p * cross(q, r)).sum() / 12


def volume_gradient(body, x):
    """Derivative of those determinants, corner by corner."""
    corners = body.triangles.T
    p, q, r = (x[c] for c in corners)
    gradient = np.zeros_like(x)
    for corner, share in zip(corners, (cross(q, r), cross(r, p), cross(p, q))):
        np.add.at(gradient, corner, share / 12)
    return gradient


def constant(pressure):
    return lambda body, x: Real(pressure) * volume_gradient(body, x)


def polytropic(gauge, ambient, v0, n):
    def force(body, x):
        absolute = (Real(gauge) + Real(ambient)) * (Real(v0) / volume(body, x)) ** Real(n)
        return (absolute - Real(ambient)) * volume_gradient(body, x)

    return force


# --- shapes, point by point in the order of the scenes -----------------------------------------------------------------


def complete(points):
    return [[i, j] for i in range(len(points)) for j in range(i + 1, len(points))]


def cube():
    square = [(0, 0), (1, 0), (1, 1), (0, 1)]
    points = [(x, y, z) for z in (0, 1) for x, y in square]
    facets = [[0, 3, 2, 1], [4, 5, 6, 7]] + [[i, (i + 1) % 4, (i + 1) % 4 + 4, i + 4] for i in range(4)]
    return Body(points, complete(points), facets)


def ring(n, radius, z):
    pi = Real("3.14159265358979323846264338327950288")
    return [(radius * np.cos(2 * pi * i / n), radius * np.sin(2 * pi * i / n), z) for i in range(n)]


def cylinder(n=8, storeys=2, radius=Real("0.5"), height=Real(1)):
    points, springs = [], []
    for s in range(storeys + 1):
        points += ring(n, radius, height * s / storeys)
    for s in range(storeys + 1):
        here = [s * n + i for i in range(n)]
        springs += [[here[i], here[(i + 1) % n]] for i in range(n)]
        springs += [[here[i], here[i + n // 2]] for i in range(n // 2)]
        if s < storeys:
            for i in range(n):
                j = (i + 1) % n
                springs += [[here[i], here[i] + n], [here[i], here[j] + n], [here[j], here[i] + n]]
    return Body(points, springs)


def ball(n=8, bands=6, radius=Real("0.5")):
    pi = Real("3.14159265358979323846264338327950288")
    points = [(Real(0), Real(0), Real(0))]
    for b in range(1, bands):
        points += ring(n, radius * np.sin(pi * b / bands), radius * (1 - np.cos(pi * b / bands)))
    north, centre = len(points), len(points) + 1
    points += [(Real(0), Real(0), 2 * radius), (Real(0), Real(0), radius)]
    circle = [[1 + b * n + i for i in range(n)] for b in range(bands - 1)]
    springs = [[0, p] for p in circle[0]] + [[p, north] for p in circle[-1]]
    for b, here in enumerate(circle):
        springs += [[here[i], here[(i + 1) % n]] for i in range(n)]
        if b + 1 < len(circle):
            above = circle[b + 1]
            for i in range(n):
                j = (i + 1) % n
                springs += [[here[i], above[i]], [here[i], above[j]], [here[j], above[i]]]
    springs += [[p, centre] for p in range(centre)]
    return Body(points, springs)


def sheet(n=5, width=Real("1.4")):
    """n x n points within a frame of anchors; the corner cells are triangles between the anchors and the corner point."""
    pitch, number, points = width / (n + 1), {}, []
    inner = [(r, c) for r in range(1, n + 1) for c in range(1, n + 1)]
    rim = [(r, c) for r in range(n + 2) for c in range(n + 2) if (r in (0, n + 1)) != (c in (0, n + 1))]
    for r, c in inner + rim:
        number[r, c] = len(points)
        points.append((c * pitch, r * pitch, Real(0)))
    springs = [[number[r, c], number[r, c + 1]] for r in range(1, n + 1) for c in range(n + 1)]
    springs += [[number[r, c], number[r + 1, c]] for c in range(1, n + 1) for r in range(n + 1)]
    facets = []
    for r in range(n + 1):
        for c in range(n + 1):
            cell = [number[k] for k in [(r, c), (r, c + 1), (r + 1, c + 1), (r + 1, c)] if k in number]
            facets.append(cell if len(cell) == 4 else cell + cell[-1:])
    return Body(points, springs, facets, [number[k] for k in rim])


# --- integration -------------------------------------------------------------------------------------------------------


def gragg(body, x, v, held, h, n):
    """n modified midpoint steps over h."""
    def slope(x, v):
        moving = v.copy()
        moving[~body.free] = 0
        return moving, body.acceleration(x, v, held)

    s = h / n
    x0, v0 = x, v
    dx, dv = slope(x0, v0)
    x1, v1 = x0 + s * dx, v0 + s * dv
    for _ in range(n - 1):
        dx, dv = slope(x1, v1)
        x0, v0, x1, v1 = x1, v1, x0 + 2 * s * dx, v0 + 2 * s * dv
    dx, dv = slope(x1, v1)
    return (x0 + x1 + s * dx) / 2, (v0 + v1 + s * dv) / 2


def advance(body, x, v, held, h):
    """Extrapolates over the squares of the inner steps."""
    rows = []
    for j in range(COLUMNS):
        row = [np.stack(gragg(body, x, v, held, h, 2 * (j + 1)))]
        for m in range(1, j + 1):
            ratio = (Real(j + 1) / Real(j + 1 - m)) ** 2
            row.append(row[-1] + (row[-1] - rows[-1][m - 1]) / (ratio - 1))
        rows.append(row)
    x, v = rows[-1][-1]
    v[held, 2] = 0
    return x, v


# --- contact with the floor z = 0: energy compensation, frictionless ---------------------------------------------------


def compensate(body, x, v, touching, held):
    m = body.mass
    approach = np.where(touching, -v[:, 2], 0)
    energy = (m * approach**2).sum() / 2
    v[touching, 2] = 0
    direction = np.zeros_like(v)
    lift = np.zeros(len(m), dtype=Real)
    d, _ = body.springs_of(x)
    for (tail, head), u in zip(body.springs, d):
        for i, k, e in [(tail, head, u), (head, tail, -u)]:
            if touching[i] and not touching[k] and not held[k] and body.free[k] and e[2] > Real("1e-6"):
                w = e[2]
                direction[k] += w * e / m[k]
                direction[i] -= w * e / m[i]
                lift[i] += w * w
    direction[touching, 2] = 0
    a = (m[:, None] * direction**2).sum() / 2
    b = (m[:, None] * v * direction).sum()
    if a == 0:
        v[touching, 2] = approach[touching]
        return
    root = np.sqrt(b * b + 4 * a * energy)
    low, high = (-b - root) / (2 * a), (-b + root) / (2 * a)
    ground = m * approach + low * lift
    v += (low if b <= 0 and (ground[touching] >= 0).all() else high) * direction


def locate(body, x, v, held, h, guard):
    """The length in (0, h] at which the guard, positive before and negative after, is 0: regula falsi with halving."""
    low, high = Real(0), h
    g_low, g_high = guard(x, v), guard(*advance(body, x, v, held, h))
    for _ in range(200):
        s = low + (high - low) * g_low / (g_low - g_high)
        if not low < s < high:
            break
        g = guard(*advance(body, x, v, held, s))
        if abs(g) < Real("1e-17") or high - low < Real("1e-18"):
            return s
        if g > 0:
            low, g_low, g_high = s, g, g_high / 2
        else:
            high, g_high, g_low = s, g, g_low / 2
    return high


def run(body, seconds, samples, step, floor):
    x, v = body.x.copy(), body.v.copy()
    n = len(x)
    held, asleep = np.zeros(n, dtype=bool), np.zeros(n, dtype=bool)
    t, states, events = Real(0), [], []
    times = [Real(seconds) * (i + 1) / samples for i in range(samples)]
    for time in times:
        while time - t > Real("1e-15"):
            h = min(step, time - t)
            x1, v1 = advance(body, x, v, held, h)
            if floor:
                gap = np.where(body.free & ~held & ~asleep, x1[:, 2], Real(1))
                push = np.where(held, -body.force(x1, v1)[:, 2], Real(1))
                if gap.min() < 0 or push.min() < 0:
                    found = []
                    if gap.min() < 0:
                        for i in np.flatnonzero(gap < 0):
                            found.append(locate(body, x, v, held, h, lambda x, v, i=i: x[i, 2]))
                    for i in np.flatnonzero(push < 0):
                        found.append(locate(body, x, v, held, h, lambda x, v, i=i: -body.force(x, v)[i, 2]))
                    h = min(found)
                    x, v = advance(body, x, v, held, h)
                    t += h
                    touching = body.free & ~held & ~asleep & (x[:, 2] < Real("1e-11")) & (v[:, 2] < 0)
                    if touching.any():
                        x[touching, 2] = 0
                        compensate(body, x, v, touching, held)
                        held |= touching & (v[:, 2] == 0)
                    leaving = held & (-body.force(x, v)[:, 2] < Real("1e-9"))
                    held &= ~leaving
                    asleep |= leaving
                    events.append(t)
                    continue
            x, v, t = x1, v1, t + h
            asleep &= ~(x[:, 2] > Real("1e-9"))
        states.append(np.concatenate([x.ravel(), v.ravel()]))
    return states, events


def raised(body, height):
    body.x[:, 2] += Real(height)
    return body


def with_(body, **values):
    for name, value in values.items():
        setattr(body, name, value if callable(value) else Real(value))
    return body


def pressed_cube():
    body = cube()
    body.gas = polytropic(2000, 100000, 1, "1.4")
    body.gravity = Real(0)
    return body


CASES = {
    # name: body, scene and settings, seconds, samples, step, on the floor?
    "cube": (lambda: raised(cube(), 1), "cube", [], 0.8, 16, 1e-3, True),
    "cube_damped": (lambda: with_(raised(cube(), 1), c=10), "cube", ["C=10"], 1.0, 20, 1e-3, True),
    "cylinder": (lambda: raised(cylinder(), 1), "cylinder", [], 0.6, 12, 1e-3, True),
    "cylinder_damped": (lambda: with_(raised(cylinder(), 1), c=10), "cylinder", ["C=10"], 0.8, 16, 1e-3, True),
    "ball": (lambda: raised(ball(), 1), "ball", [], 0.6, 12, 1e-3, True),
    "ball_damped": (lambda: with_(raised(ball(), 1), c=10), "ball", ["C=10"], 0.6, 12, 1e-3, True),
    "sheet": (
        lambda: with_(sheet(), air=5, gas=constant(4000)),
        "bladder",
        ["rows=5", "columns=5"],
        0.5,
        10,
        1e-3,
        False,
    ),
    "gas": (
        pressed_cube,
        "cube",
        ["law=none", "g=0", "drop_height=0", "pressure=2000", "gas=polytropic", "ambient=100000", "volume=1", "exponent=1.4"],
        0.5,
        10,
        1e-3,
        False,
    ),
}


def main(path, names):
    cases = []
    for name in names or CASES:
        body, scene, settings, seconds, samples, step, floor = CASES[name]
        coarse, first = run(body(), seconds, samples, Real(step), floor)
        fine, second = run(body(), seconds, samples, Real(step) / 2, floor)
        assert len(first) == len(second), (name, len(first), len(second))
        agreement = [float(abs(a - b).max()) for a, b in zip(coarse, fine)]
        between = max((float(abs(a - b)) for a, b in zip(first, second)), default=0.0)
        print(f"{name}: {len(first)} events to {between:.1e} s, states to {max(agreement):.1e}", file=sys.stderr, flush=True)
        cases.append(
            {
                "case": name,
                "scene": scene,
                "settings": settings,
                "sample_times": [seconds * (i + 1) / samples for i in range(samples)],
                "states": [[float(y) for y in state] for state in fine],
                "agreement": agreement,
                "events": [float(t) for t in second],
            }
        )
    with open(path, "w", encoding="utf-8") as file:
        file.write("[\n" + ",\n".join(json.dumps(case) for case in cases) + "\n]\n")


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2:])
