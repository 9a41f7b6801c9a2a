"""CasADi: Kane's equations from its Jacobians, its symbolic solver and common sub-expressions; C by its generator."""
import casadi as ca

COUNTED = {ca.OP_ADD, ca.OP_SUB, ca.OP_TWICE, ca.OP_MUL, ca.OP_SQ, ca.OP_DIV, ca.OP_INV, ca.OP_SIN, ca.OP_COS, ca.OP_SQRT}
FREE = {ca.OP_INPUT, ca.OP_OUTPUT, ca.OP_CONST, ca.OP_NEG, ca.OP_ASSIGN}


class S:
    sin, cos, sqrt = staticmethod(ca.sin), staticmethod(ca.cos), staticmethod(ca.sqrt)


def column(v):
    return ca.vertcat(*(v.c if hasattr(v, "c") else v))


def kane(bodies, loads, q, u):
    """M and f over all speeds."""
    mass, force = ca.SX(len(u), len(u)), ca.SX(len(u), 1)
    q, u = column(q), column(u)
    for body in bodies:
        velocity = column(body.velocity)
        partial, bias = ca.jacobian(velocity, u), ca.jtimes(velocity, q, u)
        if body.frame is not None:
            bias += ca.cross(column(body.frame), velocity)
        mass += body.mass * (partial.T @ partial)
        force -= body.mass * (partial.T @ bias)
        if body.spin is not None:
            spin, inertia = column(body.spin), ca.blockcat([[ca.SX(x) if not isinstance(x, int) or x else ca.SX(1, 1) for x in row] for row in body.inertia])
            partial, bias = ca.jacobian(spin, u), ca.jtimes(spin, q, u)
            moment = inertia @ bias + ca.cross(column(body.axes), inertia @ spin)
            mass += partial.T @ (inertia @ partial)
            force -= partial.T @ moment
    for strength, speed in loads:
        force += ca.jacobian(speed, u).T * strength
    return mass, force


def ldl(a, b):
    """Solves a symmetric positive system in symbols."""
    n = a.shape[0]
    a, b = [[a[i, j] for j in range(n)] for i in range(n)], [b[i] for i in range(n)]
    factor = {}
    for j in range(n):
        inverse = 1 / a[j][j]
        for i in range(j + 1, n):
            factor[i, j] = a[i][j] * inverse
            for k in range(j + 1, i + 1):
                a[i][k] -= factor[i, j] * a[k][j]
            b[i] -= factor[i, j] * b[j]
        a[j][j] = inverse
    for i in reversed(range(n)):
        b[i] *= a[i][i]
        for k in range(i + 1, n):
            b[i] -= factor[k, i] * b[k]
    return ca.vertcat(*b)


def function(mechanism):
    symbols = lambda names: [ca.SX.sym(name) for name in names]
    q, u, w, p = map(symbols, (mechanism.q, mechanism.u, mechanism.inputs, mechanism.parameters))
    independent = [u[k] for k in mechanism.independent]
    arguments = ca.vertcat(*q, *independent, *w, *p)
    named = dict(zip(mechanism.parameters, p))
    if hasattr(mechanism, "composite"):
        mass, right = mechanism.composite(S, q, u, w, named)
        out = ldl(ca.blockcat(mass), ca.vertcat(*right))
    else:
        bodies, loads, rows = mechanism.kinematics(S, q, u, w, named)
        mass, force = kane(bodies, loads, q, u)
        out = reduced(mechanism, mass, force, ca.vertcat(*rows), q, u) if rows else ldl(mass, force)
    return ca.Function("f", [arguments], [ca.cse(out)], {"cse": True})


def reduced(mechanism, mass, force, rows, q, u):
    """q' and u' with the dependent speeds eliminated."""
    q, u = column(q), column(u)
    jacobian, bias = ca.jacobian(rows, u), ca.jtimes(rows, q, u)
    n, k = len(mechanism.u), len(mechanism.independent)
    solution = ca.solve(jacobian[:, mechanism.dependent], ca.horzcat(-jacobian[:, mechanism.independent], -bias))
    partial, beta = ca.SX(n, k), ca.SX(n, 1)
    for j, i in enumerate(mechanism.independent):
        partial[i, j] = 1
    for r, i in enumerate(mechanism.dependent):
        partial[i, :], beta[i] = solution[r, :k], solution[r, k]
    u_dot = ldl(partial.T @ mass @ partial, partial.T @ (force - mass @ beta))
    speeds = partial @ u[mechanism.independent]
    return ca.substitute(ca.vertcat(speeds, u_dot), u[mechanism.dependent], speeds[mechanism.dependent])


def build(mechanism):
    """(C source with `void eval(const double*, double*)`, operations)."""
    return compiled(function(mechanism))


def compiled(f):
    """The same of any function named f."""
    kinds = [f.instruction_id(i) for i in range(f.n_instructions())]
    unknown = set(kinds) - COUNTED - FREE
    assert not unknown, unknown
    generator = ca.CodeGenerator("f", {"with_header": False})
    generator.add(f)
    wrapper = (
        "\nvoid eval(const double *in, double *out) { const double *a[%d] = {in}; double *r[%d] = {out};"
        " casadi_int iw[%d]; double w[%d]; f(a, r, iw, w, 0); }\n"
    ) % (max(f.sz_arg(), 1), max(f.sz_res(), 1), max(f.sz_iw(), 1), max(f.sz_w(), 1))
    return generator.dump() + wrapper, sum(kind in COUNTED for kind in kinds)


def per_evaluation(f, n):
    """Operations of f that depend on its first n numbers: the others could be prepared, as ours are."""
    moving, count = set(), 0
    for k in range(f.n_instructions()):
        kind, sources, targets = f.instruction_id(k), f.instruction_input(k), f.instruction_output(k)
        if kind == ca.OP_INPUT:
            changes = sources[1] < n
        else:
            changes = kind not in (ca.OP_CONST, ca.OP_OUTPUT) and not moving.isdisjoint(sources)
        if kind != ca.OP_OUTPUT:
            (moving.update if changes else moving.difference_update)(targets)
        count += changes and kind in COUNTED
    return count
