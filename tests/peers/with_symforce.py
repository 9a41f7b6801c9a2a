"""SymForce: Kane's equations from its derivatives, its common sub-expressions; elimination by straight_line."""
import symforce

symforce.set_epsilon_to_number()
import symforce.symbolic as sf

import states
import straight_line


class S:
    sin, cos, sqrt = staticmethod(sf.sin), staticmethod(sf.cos), staticmethod(sf.sqrt)


def rate(e, q, u):
    """d/dt at constant u."""
    return sum((sf.S(e).diff(x) * y for x, y in zip(q, u)), sf.S(0))


def kane(bodies, loads, q, u):
    """M and f over all speeds."""
    n = len(u)
    mass, force = [[sf.S(0)] * n for _ in range(n)], [sf.S(0)] * n
    for body in bodies:
        terms = [(list(body.velocity.c), body.mass, None)]
        if body.spin is not None:
            terms.append((list(body.spin.c), None, body.inertia))
        for vector, m, inertia in terms:
            partial = [[sf.S(c).diff(y) for y in u] for c in vector]
            bias = [rate(c, q, u) for c in vector]
            times = (lambda v: [m * x for x in v]) if inertia is None else (
                lambda v: [sum((a * b for a, b in zip(row, v)), sf.S(0)) for row in inertia])
            turning = body.frame if inertia is None else body.axes
            carried = vector if inertia is None else times(vector)
            push = times(bias)
            if turning is not None:
                extra = type(turning).cross(turning, type(turning)(*carried)).c
                push = [a + (m * b if inertia is None else b) for a, b in zip(push, extra)]
            for i in range(n):
                column = [row[i] for row in partial]
                weighted = times(column)
                force[i] -= sum((a * b for a, b in zip(column, push)), sf.S(0))
                for j in range(i + 1):
                    mass[i][j] += sum((a * row[j] for a, row in zip(weighted, partial)), sf.S(0))
                    mass[j][i] = mass[i][j]
    for strength, speed in loads:
        for i in range(n):
            force[i] += strength * sf.S(speed).diff(u[i])
    return mass, force


def build(mechanism):
    """(C source, operations)."""
    symbols = lambda names: [sf.Symbol(name) for name in names]
    q, u, w, p = map(symbols, (mechanism.q, mechanism.u, mechanism.inputs, mechanism.parameters))
    named = dict(zip(mechanism.parameters, p))
    rows = []
    if hasattr(mechanism, "composite"):
        mass, force = mechanism.composite(S, q, u, w, named)
    else:
        bodies, loads, rows = mechanism.kinematics(S, q, u, w, named)
        mass, force = kane(bodies, loads, q, u)
    jacobian = [[sf.S(row).diff(y) for y in u] for row in rows]
    bias = [rate(row, q, u) for row in rows]
    return share(mechanism, q, u, mass, force, jacobian, bias)


def share(mechanism, q, u, mass, force, jacobian, bias):
    flat = [sf.S(e) for row in mass for e in row] + [sf.S(e) for e in force]
    flat += [e for row in jacobian for e in row] + list(bias)
    temporaries, flat = sf.cse(flat, symbols=(sf.Symbol(f"t{i}") for i in range(10**6)))
    take = iter(flat)
    n = len(u)
    outputs = (
        [[next(take) for _ in range(n)] for _ in range(n)],
        [next(take) for _ in range(n)],
        [[next(take) for _ in range(n)] for _ in jacobian],
        [next(take) for _ in bias],
    )
    value = lambda e, point: float(sf.S(e).subs({x: point[str(x)] for x in e.free_symbols}))
    numbers = [[[value(row[k], point) for k in mechanism.dependent] for row in jacobian]
               for point in (states.typical(mechanism) if jacobian else [])]
    return straight_line.program(mechanism, temporaries, [mechanism.u[k] for k in mechanism.dependent], outputs, numbers)

