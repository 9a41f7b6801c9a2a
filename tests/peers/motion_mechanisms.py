"""Motions of mechanisms in the peers: CasADi with SciPy or CVODES, and MuJoCo for the pendulum."""
import ctypes

import casadi as ca
import mujoco
import numpy
import scipy.integrate

import compare
import mechanisms
import states
import with_casadi

# Values of the pendulum's model.
PENDULUM = {"m": 0.5, "l": 0.3, "c": 0.01, "g": 9.81}
SAMPLES = 10
TOLERANCES = [1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12]
STEPS = [0.05, 0.02, 0.01, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4]


def symbols(name):
    """Names of the coordinates and of the independent speeds."""
    if name == "pendulum":
        return ["q"], ["u_q"]
    mechanism = mechanisms.MECHANISMS[name]()
    return mechanism.q, [mechanism.u[k] for k in mechanism.independent]


def equations(name):
    """x -> x' as a CasADi function, x coordinates and independent speeds, no inputs."""
    if name == "pendulum":
        x, p = ca.SX.sym("x", 2), PENDULUM
        rate = -p["g"] / p["l"] * ca.sin(x[0]) - p["c"] / (p["m"] * p["l"] ** 2) * x[1]
        return ca.Function("f", [x], [ca.vertcat(x[1], rate)])
    mechanism = mechanisms.MECHANISMS[name]()
    x = ca.SX.sym("x", len(mechanism.q) + len(mechanism.independent))
    values = list(states.parameters(name).values())
    return ca.Function("f", [x], [with_casadi.function(mechanism)(ca.vertcat(x, ca.DM.zeros(len(mechanism.inputs)), *values))], {"cse": True})


def compiled(name, f, directory):
    """The function's C, compiled as in run.py, as a right-hand side for SciPy; its inputs after the state are handed on."""
    generator = ca.CodeGenerator("f", {"with_header": False})
    generator.add(f)
    wrapper = ("\nvoid eval(const double *in, const double *more, double *out) { const double *a[%d] = {in%s}; double *r[%d] = {out}; "
               "static casadi_int iw[%d]; static double w[%d]; f(a, r, iw, w, 0); }\n")
    more = ", more" if f.n_in() > 1 else ""
    source = generator.dump() + wrapper % (f.sz_arg(), more, f.sz_res(), f.sz_iw() + 1, f.sz_w() + 1)
    function, n = compare.compile_c(source, f"{name}_motion", directory).eval, f.size1_in(0)
    function.argtypes, function.restype = [ctypes.c_void_p] * 3, None

    def rates(_, x, more=None):
        x, out = numpy.ascontiguousarray(x), numpy.empty(n)
        function(x.ctypes.data, None if more is None else more.ctypes.data, out.ctypes.data)
        return out

    return rates


def scipy_solver(rates, start, seconds, method, tolerance, n):
    times = numpy.linspace(0, seconds, SAMPLES + 1)[1:]

    def solve():
        # Dense output costs accuracy: every sample is the end of an integration.
        x, evaluations, samples, t = start, 0, [], 0.0
        for end in times:
            done = scipy.integrate.solve_ivp(rates, (t, end), x, method=method, rtol=tolerance, atol=tolerance)
            if not done.success:
                raise RuntimeError(done.message)
            x, t, evaluations = done.y[:, -1], end, evaluations + done.nfev
            samples.append(x[:n])
        return numpy.array(samples), evaluations

    return solve


def cvodes_solver(f, start, seconds, tolerance, n):
    x = ca.SX.sym("x", len(start))
    grid = numpy.linspace(0, seconds, SAMPLES + 1)[1:]
    options = {"abstol": tolerance, "reltol": tolerance, "max_num_steps": 1_000_000}
    integrator = ca.integrator("i", "cvodes", {"x": x, "ode": f(x)}, 0, grid, options)
    return lambda: (numpy.array(integrator(x0=start)["xf"])[:n].T, None)


def mujoco_solver(start, seconds, integrator, step):
    p = PENDULUM
    model = mujoco.MjModel.from_xml_string(
        f'<mujoco><compiler boundmass="0" boundinertia="0"/><option timestep="{step}" integrator="{integrator}" gravity="0 0 -{p["g"]}">'
        '<flag contact="disable" constraint="disable"/></option><worldbody><body>'
        f'<joint type="hinge" axis="1 0 0" damping="{p["c"]}"/><inertial pos="0 0 -{p["l"]}" mass="{p["m"]}" diaginertia="1e-14 1e-14 1e-14"/>'
        "</body></worldbody></mujoco>")
    data, steps = mujoco.MjData(model), round(seconds / SAMPLES / step)

    def solve():
        mujoco.mj_resetData(model, data)
        data.qpos[:], data.qvel[:] = start[:1], start[1:]
        samples = []
        for _ in range(SAMPLES):
            mujoco.mj_step(model, data, steps)
            samples.append(data.qpos.copy())
        return numpy.array(samples), SAMPLES * steps * (4 if integrator == "RK4" else 1)

    return solve


def prepare(name, start, seconds, directory):
    """What checks the reference, and (method, its control, what solves or why nothing can) of every point."""
    f, n = equations(name), len(symbols(name)[0])
    rates = compiled(name, f, directory)

    def solvers():
        for tolerance in TOLERANCES:
            for method in ("DOP853", "RK45"):
                yield f"CasADi, SciPy {method}", {"tolerance": tolerance}, scipy_solver(rates, start, seconds, method, tolerance, n)
            yield "CasADi, CVODES", {"tolerance": tolerance}, cvodes_solver(f, start, seconds, tolerance, n)
        if name != "pendulum":
            yield "MuJoCo", None, "loops are soft constraints there"
            return
        for step in STEPS:
            for integrator in ("RK4", "Euler", "implicitfast"):
                yield f"MuJoCo {integrator}", {"step": step}, mujoco_solver(start, seconds, integrator, step)

    return scipy_solver(rates, start, seconds, "DOP853", 1e-13, n), solvers()
