"""SymPy: KanesMethod and cse; elimination of the dependent speeds by straight_line."""
import sympy as sm
import sympy.physics.mechanics as me

import states
import straight_line


class S:
    sin, cos, sqrt = staticmethod(sm.sin), staticmethod(sm.cos), staticmethod(sm.sqrt)


def in_frame(vector, frame):
    return sum((sm.sympify(c) * axis for c, axis in zip(vector.c, (frame.x, frame.y, frame.z))), me.Vector(0))


def rigid_body(index, body, inertial):
    """The body as SymPy knows it; its velocity is given in a turning frame where that is shorter."""
    home = inertial
    if body.frame is not None:
        home = me.ReferenceFrame(f"F{index}")
        home.set_ang_vel(inertial, in_frame(body.frame, home))
    centre = me.Point(f"C{index}")
    centre.set_vel(inertial, in_frame(body.velocity, home))
    if body.spin is None:
        return me.Particle(f"P{index}", centre, body.mass)
    axes = me.ReferenceFrame(f"A{index}")
    axes.set_ang_vel(inertial, in_frame(body.axes, axes))
    turning = axes
    if body.axes is not body.spin:
        turning = me.ReferenceFrame(f"B{index}")
        turning.set_ang_vel(inertial, in_frame(body.spin, axes))
    i = [[sm.sympify(x) for x in row] for row in body.inertia]
    inertia = me.inertia(axes, i[0][0], i[1][1], i[2][2], i[0][1], i[1][2], i[0][2])
    return me.RigidBody(f"R{index}", centre, turning, body.mass, (inertia, centre))


def build(mechanism):
    """(C source, operations)."""
    q, u = ([me.dynamicsymbols(x) for x in names] for names in (mechanism.q, mechanism.u))
    w, p = ([sm.Symbol(x) for x in names] for names in (mechanism.inputs, mechanism.parameters))
    bodies, loads, rows = mechanism.kinematics(S, q, u, w, dict(zip(mechanism.parameters, p)))
    inertial, t = me.ReferenceFrame("N"), me.dynamicsymbols._t
    kane = me.KanesMethod(inertial, q_ind=q, u_ind=u, kd_eqs=[x.diff(t) - y for x, y in zip(q, u)])
    kane.kanes_equations([rigid_body(i, body, inertial) for i, body in enumerate(bodies)], [])
    force = [f + sum(strength * sm.sympify(speed).diff(y) for strength, speed in loads) for f, y in zip(kane.forcing, u)]
    rows = [sm.sympify(row) for row in rows]
    jacobian = [[row.diff(y) for y in u] for row in rows]
    bias = [sum(row.diff(x) * y for x, y in zip(q, u)) for row in rows]
    plain = {s: sm.Symbol(str(s.func)) for s in q + u}
    strip = lambda e: sm.sympify(e).xreplace(plain)
    n = len(u)
    flat = [strip(e) for e in list(kane.mass_matrix) + force + [e for row in jacobian for e in row] + bias]
    temporaries, shared = sm.cse(flat, symbols=sm.numbered_symbols("t"))
    take = iter(shared)
    outputs = (
        [[next(take) for _ in range(n)] for _ in range(n)],
        [next(take) for _ in range(n)],
        [[next(take) for _ in range(n)] for _ in rows],
        [next(take) for _ in rows],
    )
    points = [{sm.Symbol(k): v for k, v in point.items()} for point in (states.typical(mechanism) if rows else [])]
    entries = [[strip(row[k]) for k in mechanism.dependent] for row in jacobian]
    names = list(points[0]) if points else []
    values = sm.lambdify(names, entries, "math")
    numbers = [values(*(point[name] for name in names)) for point in points]
    return straight_line.program(mechanism, temporaries, [mechanism.u[k] for k in mechanism.dependent], outputs, numbers)
