#!/usr/bin/env python3
"""Thrusts and reactions of a tile with massless legs, in 70 digits, from its geometry alone.

The platform's centre is the Fermat point of the three connectors: unit vectors towards it sum to zero. The platform moves
along a path h(t); Newton's and Euler's equations give the wrench that it takes, virtual power the thrusts, statics with rods
that push only across themselves the reactions. Needs mpmath. codegen/tests/it/reactions.rs holds what it prints.
"""

from mpmath import cos, findroot, lu_solve, matrix, mp, mpf, pi, sin, sqrt

mp.dps = 70
RADIUS, MASS, GRAVITY = mpf("0.1"), mpf(3), mpf("9.81")
INERTIA = [mpf("0.012"), mpf("0.016"), mpf("0.026")]
AZIMUTHS = [pi * degrees / 180 for degrees in (90, 210, 330)]
HEIGHTS = [mpf("0.03"), mpf("0.01"), mpf("-0.01")]
SPEEDS = [mpf("0.004"), mpf("-0.001"), mpf("0.002")]
ACCELERATIONS = [mpf("0.1"), mpf("-0.05"), mpf("0.02")]
AXES = range(3)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(a):
    length = sqrt(dot(a, a))
    return [x / length for x in a]


def connectors(heights):
    return [[RADIUS * cos(a), RADIUS * sin(a), h] for a, h in zip(AZIMUTHS, heights)]


def pose(heights):
    """The platform's centre and its axes, x towards connector A, one after the other."""
    at = connectors(heights)
    normal = unit(cross(minus(at[1], at[0]), minus(at[2], at[0])))

    def residual(*centre):
        rods = [unit(minus(connector, centre)) for connector in at]
        return sum(d[0] for d in rods), sum(d[1] for d in rods), dot(normal, minus(centre, at[0])) / RADIUS

    centre = list(findroot(residual, (mpf(0), mpf(0), sum(heights) / 3)))
    x = unit(minus(at[0], centre))
    return centre + x + cross(normal, x) + normal


def axes(values):
    return [values[3:6], values[6:9], values[9:12]]


def first(f, step=mpf(10) ** -9):
    """Derivative at 0: differences of sixth order, an error below 1e-50."""
    sides = [(mpf(3) / 4, 1), (-mpf(3) / 20, 2), (mpf(1) / 60, 3)]
    pairs = [(weight, f(n * step), f(-n * step)) for weight, n in sides]
    return [sum(w * (a[i] - b[i]) for w, a, b in pairs) / step for i in range(12)]


def second(f, step=mpf(10) ** -7):
    sides = [(mpf(3) / 2, 1), (-mpf(3) / 20, 2), (mpf(1) / 90, 3)]
    middle, pairs = f(mpf(0)), [(weight, f(n * step), f(-n * step)) for weight, n in sides]
    return [(sum(w * (a[i] + b[i]) for w, a, b in pairs) - mpf(49) / 18 * middle[i]) / step**2 for i in range(12)]


def turning(frame, rate):
    """Half the sum of e x e': angular velocity from e', angular acceleration from e''."""
    products = [cross(e, e_dot) for e, e_dot in zip(frame, rate)]
    return [sum(p[i] for p in products) / 2 for i in AXES]


def thrusts(speeds, accelerations):
    def path(t):
        return pose([h + t * v + t * t * a / 2 for h, v, a in zip(HEIGHTS, speeds, accelerations)])

    rate, curvature, frame = first(path), second(path), axes(pose(HEIGHTS))
    force = [MASS * curvature[i] for i in AXES]
    force[2] += MASS * GRAVITY
    w = [dot(e, turning(frame, axes(rate))) for e in frame]
    alpha = [dot(e, turning(frame, axes(curvature))) for e in frame]
    momentum = [i * x for i, x in zip(INERTIA, w)]
    own = [i * a + c for i, a, c in zip(INERTIA, alpha, cross(w, momentum))]
    moment = [sum(frame[j][i] * own[j] for j in AXES) for i in AXES]
    found = []
    for leg in AXES:
        partial = first(lambda t: pose([h + (t if i == leg else 0) for i, h in enumerate(HEIGHTS)]))
        found.append(dot(force, partial[:3]) + dot(moment, turning(frame, axes(partial))))
    return found


def reactions():
    """Force of each leg on its rod at rest: balance of forces and moments, and no force along a rod."""
    arms = [minus(at, pose(HEIGHTS)[:3]) for at in connectors(HEIGHTS)]
    left, right = matrix(9, 9), matrix(9, 1)
    right[2] = MASS * GRAVITY
    for leg, arm in enumerate(arms):
        for i in AXES:
            left[i, 3 * leg + i] = 1
            left[6 + leg, 3 * leg + i] = arm[i]
            j, k = (i + 1) % 3, (i + 2) % 3
            left[3 + i, 3 * leg + k] = arm[j]
            left[3 + i, 3 * leg + j] = -arm[k]
    found = lu_solve(left, right)
    return [[found[3 * leg + i] for i in AXES] for leg in AXES]


def show(name, values):
    print(name, [float(x) if abs(x) > mpf(10) ** -40 else 0.0 for x in values])


show("thrusts in motion", thrusts(SPEEDS, ACCELERATIONS))
show("thrusts at rest", thrusts([mpf(0)] * 3, [mpf(0)] * 3))
for leg, force in zip("ABC", reactions()):
    show(f"leg {leg}", force)
