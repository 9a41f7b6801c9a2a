#!/usr/bin/env python3
"""Accelerations of the Stewart platform and the delta robot, in 50 digits, by Lagrange's equations in the plate's place.

The kinetic energy is a sum of weighted squares of velocities of points and directions, all of which are closed forms of the
plate's place: for a thin rod of mass m and length l its centre (m) and its direction (m l^2/12), for the plate its centre and
its axes. M = sum w J'J, and with T = x' M x'/2 the equations are M x'' = Q - dV/dx - M' x' + dT/dx. Derivatives are differences
of 30 digits. Needs mpmath. codegen/tests/it/joint_models.rs holds what it prints.
"""

from mpmath import acos, atan2, cos, expm, lu_solve, matrix, mp, mpf, nstr, pi, sin, sqrt

mp.dps = 60
STEP = mpf(10) ** -20
G = mpf("9.81")


def d(text):
    return mpf(text)


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def plus(a, b, factor=1):
    return [x + factor * y for x, y in zip(a, b)]


def length(a):
    return sqrt(sum(x * x for x in a))


def jacobian(f, x):
    """Columns: derivatives of the list f(x)."""
    columns = []
    for i in range(len(x)):
        up, down = list(x), list(x)
        up[i] += STEP
        down[i] -= STEP
        columns.append([(a - b) / (2 * STEP) for a, b in zip(f(up), f(down))])
    return columns


def accelerations(parts, heights, drives, x, v, inputs):
    """parts(x): weights and vectors; heights(x): masses and heights; drives(x): what the inputs work on."""
    n = len(x)
    weights = [w for w, _ in parts(x)]

    def mass(at):
        columns = jacobian(lambda y: [c for _, vector in parts(y) for c in vector], at)
        spread = [w for w in weights for _ in range(3)]
        return matrix(n, n) + matrix(
            [[sum(w * a * b for w, a, b in zip(spread, columns[i], columns[j])) for j in range(n)] for i in range(n)]
        )

    velocity = matrix(v)
    # M' x' - dT/dx by differences of M of a coarser step.
    coarse = mpf(10) ** -12
    slopes = []
    for i in range(n):
        up, down = list(x), list(x)
        up[i] += coarse
        down[i] -= coarse
        slopes.append((mass(up) - mass(down)) / (2 * coarse))
    rate = sum((v[i] * slopes[i] for i in range(n)), matrix(n, n))
    potential = jacobian(lambda y: [sum(G * m * z for m, z in heights(y))], x)
    work = jacobian(drives, x)
    right = matrix(n, 1)
    for i in range(n):
        gyroscopic = (velocity.T * slopes[i] * velocity)[0] / 2
        driven = sum(f * w for f, w in zip(inputs, work[i]))
        right[i] = driven - potential[i][0] + gyroscopic
    right -= rate * velocity
    return lu_solve(mass(x), right)


def rod(mass, long, centre, direction):
    return [(mass, centre), (mass * long**2 / 12, direction)]


def stewart():
    rb, rp, mp_, ml, mr, long = d("0.4"), d("0.25"), d(5), d("0.8"), d("0.5"), d("0.3")
    feet = [pi * a / 180 for a in (-10, 10, 110, 130, 230, 250)]
    heads = [pi * a / 180 for a in (-50, 50, 70, 170, 190, 290)]
    e = [d("0.98"), d("0.1"), d("-0.12"), d("0.08")]
    size = length(e)
    a, b, c, f = [x / size for x in e]
    attitude = matrix([
        [a * a + b * b - c * c - f * f, 2 * (b * c - a * f), 2 * (b * f + a * c)],
        [2 * (b * c + a * f), a * a - b * b + c * c - f * f, 2 * (c * f - a * b)],
        [2 * (b * f - a * c), 2 * (c * f + a * b), a * a - b * b - c * c + f * f],
    ])

    def turned(x):
        """The attitude turned on by a small rotation vector along the plate's axes: its rate is the angular velocity."""
        u, v, w = x[3:]
        return attitude * expm(matrix([[0, -w, v], [w, 0, -u], [-v, u, 0]]))

    def legs(x):
        turn = turned(x)
        for foot, head in zip(feet, heads):
            at = turn * matrix([rp * cos(head), rp * sin(head), 0])
            top = plus(x[:3], list(at))
            way = minus(top, [rb * cos(foot), rb * sin(foot), mpf(0)])
            yield top, way, length(way)

    def parts(x):
        turn = turned(x)
        across = mp_ * rp**2 / 4
        # Second moments of a disc: along its plane m r^2/4 each, across it none.
        all_parts = [(mp_, x[:3])] + [(across, [turn[i, k] for i in range(3)]) for k in range(2)]
        for top, way, far in legs(x):
            along = [c / far for c in way]
            foot = minus(top, way)
            all_parts += rod(ml, long, plus(foot, along, long / 2), along)
            all_parts += rod(mr, long, plus(top, along, -long / 2), along)
        return all_parts

    def heights(x):
        found = [(mp_, x[2])]
        for top, way, far in legs(x):
            along = way[2] / far
            found += [(ml, long / 2 * along), (mr, top[2] - long / 2 * along)]
        return found

    x = [d("0.03"), d("-0.02"), d("0.52"), mpf(0), mpf(0), mpf(0)]
    v = [d("0.3"), d("-0.2"), d("0.1"), d("0.4"), d("-0.5"), d("0.7")]
    inputs = [d(n) for n in (20, -5, 12, 30, 8, 15)]
    found = accelerations(parts, heights, lambda y: [far for _, _, far in legs(y)], x, v, inputs)
    print("stewart", [nstr(x, 20) for x in found], "e", [nstr(x, 20) for x in (a, b, c, f)])


def delta():
    rb, rp, la, lf = d("0.12"), d("0.04"), d("0.2"), d("0.4")
    ma, mf, mp_ = d("0.3"), d("0.1"), d("0.5")

    def arms(x):
        for azimuth in (0, 2 * pi / 3, 4 * pi / 3):
            c, s = cos(azimuth), sin(azimuth)
            out, side, z = c * x[0] + s * x[1] + rp - rb, -s * x[0] + c * x[1], x[2]
            # |end - elbow| = lf with the elbow at la (cos q, 0, -sin q): a cos q + b sin q = k.
            a, b = 2 * la * out, -2 * la * z
            k = out**2 + side**2 + z**2 + la**2 - lf**2
            q = atan2(b, a) - acos(k / sqrt(a * a + b * b))

            def world(v, c=c, s=s):
                return [c * v[0] - s * v[1], s * v[0] + c * v[1], v[2]]

            arm = [cos(q), mpf(0), -sin(q)]
            elbow = [rb + la * arm[0], mpf(0), la * arm[2]]
            fore = [(e - p) / lf for e, p in zip([out + rb, side, z], elbow)]
            yield q, world(arm), world(elbow), world(fore), world([rb, mpf(0), mpf(0)])

    def parts(x):
        found = [(mp_, x)]
        for _, arm, elbow, fore, base in arms(x):
            found += rod(ma, la, plus(base, arm, la / 2), arm) + rod(mf, lf, plus(elbow, fore, lf / 2), fore)
        return found

    def heights(x):
        found = [(mp_, x[2])]
        for _, arm, elbow, fore, base in arms(x):
            found += [(ma, la / 2 * arm[2]), (mf, elbow[2] + lf / 2 * fore[2])]
        return found

    x, v = [d("0.05"), d("-0.03"), d("-0.41")], [d("0.4"), d("0.3"), d("-0.2")]
    inputs = [d("-1.2"), d("0.5"), d("-0.3")]
    found = accelerations(parts, heights, lambda y: [arm[0] for arm in arms(y)], x, v, inputs)
    print("delta", [nstr(x, 20) for x in found], "q", [nstr(arm[0], 20) for arm in arms(x)])


stewart()
delta()
