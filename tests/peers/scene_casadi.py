"""Scenes in CasADi: forces as one compiled C function, motion by SciPy between the events, or by CVODES where there are none."""
import casadi as ca
import numpy
import scipy.integrate

import scenes

SAMPLES = 10
MOST_RESTARTS = 10_000
TOLERANCES = [1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11]


def equations(scene):
    """(x and v by columns, 1 where an acceleration is free) -> (v, accelerations), as a CasADi function."""
    n, (tail, head) = scene.n, scene.springs.T
    state, free = ca.MX.sym("x", 6 * n), ca.MX.sym("free", 3 * n)
    x, v = (ca.reshape(part, n, 3) for part in (state[:3 * n], state[3 * n:]))
    # Sums over a point's springs and facets are products with sparse matrices of ones.
    at = lambda index: ca.DM(ca.Sparsity.triplet(n, len(index), index.tolist(), list(range(len(index)))), 1)
    along = x[head.tolist(), :] - x[tail.tolist(), :]
    tension = scene.stiffness * (1 - scene.rest / ca.sqrt(ca.sum2(along * along)))
    if scene.damping:
        tension += scene.damping * ca.sum2(along * (v[head.tolist(), :] - v[tail.tolist(), :])) / ca.sum2(along * along)
    force = (at(tail) - at(head)) @ (ca.repmat(tension, 1, 3) * along) - scene.drag * v - ca.repmat(ca.DM([[0, 0, scene.gravity]]), n, 1)
    if scene.pressure:
        cross = lambda a, b: ca.horzcat(*(a[:, i] * b[:, j] - a[:, j] * b[:, i] for i, j in ((1, 2), (2, 0), (0, 1))))
        corners = scene.facets.T
        for index, share in zip(corners, scene.shares(*(x[i.tolist(), :] for i in corners), cross)):
            force += scene.pressure * (at(index) @ share)
    moves = free * ca.DM(numpy.tile(~scene.fixed, 3).astype(float))
    f = ca.Function("f", [state, free], [ca.vertcat(ca.vec(v), moves * ca.vec(force))], {"cse": True})
    # Without loops what is small is faster; of 5,000 statements per coordinate gcc makes nothing in ten minutes.
    return f.expand() if n < 100 else f


def with_scipy(scene, rates, method, tolerance, seconds):
    """What solves: integrations from event to event, and from sample to sample because dense output costs accuracy."""
    ends = numpy.linspace(0, seconds, SAMPLES + 1)[1:]
    columns = lambda y: y.reshape(2, 3, scene.n).transpose(0, 2, 1)
    everything = numpy.ones((3, scene.n))
    push = lambda x: -rates(0, numpy.concatenate([x.T.ravel(), numpy.zeros(3 * scene.n)]), everything)[5 * scene.n:]

    def solve():
        ground = scenes.Ground(scene, push)
        y = numpy.concatenate([scene.x.T.ravel(), numpy.zeros(3 * scene.n)])
        t, evaluations, restarts, samples = 0.0, 0, 0, []
        events = [lambda _, y, *rest: ground.guard(columns(y)[0]), lambda _, y, *rest: ground.sleeping(columns(y)[0])]
        for event in events:
            event.terminal, event.direction = True, -1
        for end in ends:
            while t < end:
                free = numpy.ones((3, scene.n))
                free[2, ground.held] = 0.0
                done = scipy.integrate.solve_ivp(rates, (t, end), y, method=method, rtol=tolerance, atol=tolerance, args=(free,),
                                                 events=events if scene.has_ground else None)
                if not done.success:
                    raise RuntimeError(done.message)
                restarts += 1
                if restarts > MOST_RESTARTS:
                    raise RuntimeError("event after event")
                t, y, evaluations = done.t[-1], done.y[:, -1], evaluations + done.nfev
                if done.status == 1:
                    x, v = columns(y).copy()
                    ground.event(x, v)
                    y = numpy.concatenate([x.T.ravel(), v.T.ravel()])
            samples.append(columns(y)[0].ravel().copy())
        return numpy.array(samples), evaluations

    return solve


ADAMS = {"linear_multistep_method": "adams", "nonlinear_solver_iteration": "functional"}
KRYLOV = {"linear_multistep_method": "bdf", "nonlinear_solver_iteration": "newton", "newton_scheme": "gmres"}


def with_cvodes(scene, f, tolerance, seconds, how=ADAMS):
    """What solves: Adams' method with functional iteration, or Gear's with Krylov's; neither needs a Jacobian of 4,000 columns."""
    x, grid = ca.SX.sym("x", 6 * scene.n), numpy.linspace(0, seconds, SAMPLES + 1)[1:]
    options = {"abstol": tolerance, "reltol": tolerance, "max_num_steps": 1_000_000, **how}
    integrator = ca.integrator("i", "cvodes", {"x": x, "ode": f(x, 1)}, 0, grid, options)
    start = numpy.concatenate([scene.x.T.ravel(), numpy.zeros(3 * scene.n)])
    return lambda: (numpy.array(integrator(x0=start)["xf"])[:3 * scene.n].T.reshape(-1, 3, scene.n).transpose(0, 2, 1).reshape(SAMPLES, -1), None)


def solvers(scene, f, rates, seconds):
    """(method, its control, what solves or why nothing can) of every point."""
    for tolerance in TOLERANCES:
        for method in ("DOP853", "RK45"):
            yield f"CasADi, SciPy {method}", {"tolerance": tolerance}, with_scipy(scene, rates, method, tolerance, seconds)
        if not scene.has_ground:
            yield "CasADi, CVODES", {"tolerance": tolerance}, with_cvodes(scene, f, tolerance, seconds)
    if scene.has_ground:
        yield "CasADi, CVODES", None, "events of its integrators are experimental: not built"
