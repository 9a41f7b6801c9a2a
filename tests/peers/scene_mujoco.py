"""Scenes in MuJoCo: a body on slide joints per point, a tendon with stiffness per spring.

MuJoCo's own contact is soft and has no impact law that distributes energy along springs. Its integrators therefore move the
body between the events, and the step is split at them here: root by Brent's method on the length of a step, the law
from scenes.py, and while the ground holds points a second model without their vertical joints.
"""
import mujoco
import numpy
import scipy.optimize

import scenes

SAMPLES = 10
STEPS = [1 / 80, 1 / 160, 1 / 320, 1e-3, 5e-4, 2e-4, 1e-4]
EVALUATIONS = {"RK4": 4, "Euler": 1}
MOST_EVENTS = 64


def text(scene, integrator, held):
    """Joints give absolute places: all bodies sit at the origin."""
    body = ""
    for i in range(scene.n):
        if scene.fixed[i]:
            body += f'<site name="s{i}" pos="{" ".join(map(repr, scene.x[i].tolist()))}"/>'
            continue
        axes = ["1 0 0", "0 1 0"] + ([] if held[i] else ["0 0 1"])
        joints = "".join(f'<joint type="slide" axis="{axis}" damping="{scene.drag}"/>' for axis in axes)
        body += f'<body>{joints}<inertial pos="0 0 0" mass="1" diaginertia="1e-9 1e-9 1e-9"/><site name="s{i}"/></body>'
    tendons = "".join(f'<spatial stiffness="{scene.stiffness!r}" springlength="{rest!r}"><site site="s{a}"/><site site="s{b}"/></spatial>'
                      for (a, b), rest in zip(scene.springs, scene.rest.tolist()))
    return (f'<mujoco><compiler boundmass="0" boundinertia="0"/><option integrator="{integrator}" gravity="0 0 -{scene.gravity}">'
            f'<flag contact="disable" constraint="disable"/></option><worldbody>{body}</worldbody><tendon>{tendons}</tendon></mujoco>')


class Body:
    """The model with so many points held, and its coordinates among those of all points."""

    def __init__(self, scene, integrator, held):
        self.model = mujoco.MjModel.from_xml_string(text(scene, integrator, held))
        self.data = mujoco.MjData(self.model)
        moves = numpy.repeat(~scene.fixed[:, None], 3, axis=1)
        moves[:, 2] &= ~held
        self.places = numpy.flatnonzero(moves)

    def put(self, x, v):
        self.data.qpos[:], self.data.qvel[:] = x.ravel()[self.places], v.ravel()[self.places]

    def get(self, x, v):
        """x and v with the model's coordinates in place of theirs."""
        x, v = x.copy(), v.copy()
        x.ravel()[self.places], v.ravel()[self.places] = self.data.qpos, self.data.qvel
        return x, v

    def step(self, h, count=1):
        self.model.opt.timestep = h
        mujoco.mj_step(self.model, self.data, count)


def smooth(scene, integrator, h, seconds):
    body, count = Body(scene, integrator, numpy.zeros(scene.n, bool)), round(seconds / SAMPLES / h)

    def blow(_, data):
        data.qfrc_passive[:] += scene.blown(body.get(scene.x, scene.x)[0]).ravel()[body.places]

    def solve():
        mujoco.set_mjcb_passive(blow if scene.pressure else None)
        body.put(scene.x, numpy.zeros_like(scene.x))
        samples = []
        for _ in range(SAMPLES):
            body.step(seconds / SAMPLES / count, count)
            samples.append(body.get(scene.x, scene.x)[0].ravel())
        mujoco.set_mjcb_passive(None)
        return numpy.array(samples), SAMPLES * count * EVALUATIONS[integrator]

    return solve


def split(scene, integrator, h, seconds):
    """What solves, with the step split at events; models are made once per set of held points, outside the time."""
    bodies = {}
    count = round(seconds / SAMPLES / h)

    def solve():
        ground, x, v = scenes.Ground(scene), scene.x.copy(), numpy.zeros_like(scene.x)
        samples, steps = [], 0
        for _ in range(SAMPLES):
            for _ in range(count):
                left, events = seconds / SAMPLES / count, 0
                while left > 0:
                    key = ground.held.tobytes()
                    body = bodies[key] = bodies.get(key) or Body(scene, integrator, ground.held)

                    def after(tau):
                        nonlocal steps
                        steps += 1
                        body.put(x, v)
                        body.step(tau)
                        return body.get(x, v)

                    tau, end = left, after(left)
                    event = ground.guard(end[0]) < 0
                    events += event
                    if events > MOST_EVENTS or not numpy.isfinite(end[0]).all():
                        raise RuntimeError("the step is too long: no number, or event after event")
                    if event:
                        tau = scipy.optimize.brentq(lambda tau: ground.guard(after(tau)[0]) if tau > 0 else 1.0, 0, left, xtol=1e-15)
                        end = after(tau)
                    x, v = end
                    if event:
                        ground.event(x, v)
                    elif ground.sleeping(x) < 0:
                        ground.leaving[:] = False
                    left -= tau
            samples.append(x.ravel().copy())
        return numpy.array(samples), steps * EVALUATIONS[integrator]

    return solve


def solvers(scene, seconds):
    """(method, its control, what solves or why nothing can) of every point."""
    for step in STEPS:
        for integrator in EVALUATIONS:
            make, name = (split, f"MuJoCo {integrator}, split") if scene.has_ground else (smooth, f"MuJoCo {integrator}")
            yield name, {"step": step}, make(scene, integrator, step, seconds)
    if scene.has_ground:
        yield "MuJoCo, its own contact", None, "soft, without an impact that gives the energy to the neighbours: another motion"
