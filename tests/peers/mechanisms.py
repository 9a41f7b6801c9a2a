"""The mechanisms for the peers, written once over any scalar: velocities in components, linear in u.

A mechanism lists bodies (mass, velocity of the mass centre, spin), loads (force, speed along it) and
constraint rows (scalars linear in u that vanish). `S` supplies sin, cos, sqrt. A body's velocity may
be given in a turning frame of angular velocity `frame`; a spin is the angular velocity in axes
where the inertia matrix is constant, and the angular velocity of those axes.
"""
import math

import states


class Vec:
    """Three components over any scalar."""

    def __init__(self, x, y, z):
        self.c = (x, y, z)

    def __add__(self, o):
        return Vec(*(a + b for a, b in zip(self.c, o.c)))

    def __sub__(self, o):
        return Vec(*(a - b for a, b in zip(self.c, o.c)))

    def __neg__(self):
        return Vec(*(-a for a in self.c))

    def times(self, s):
        return Vec(*(s * a for a in self.c))

    def dot(self, o):
        return sum((a * b for a, b in zip(self.c[1:], o.c[1:])), self.c[0] * o.c[0])

    def cross(self, o):
        (a, b, c), (x, y, z) = self.c, o.c
        return Vec(b * z - c * y, c * x - a * z, a * y - b * x)


class Turn:
    """A rotation about a coordinate axis: `out` to the parent's components, `back` to the turned ones."""

    def __init__(self, axis, c, s):
        self.axis, self.c, self.s = "xyz".index(axis), c, s

    def _apply(self, v, s):
        i, j = (self.axis + 1) % 3, (self.axis + 2) % 3
        w = list(v.c)
        w[i], w[j] = self.c * v.c[i] - s * v.c[j], s * v.c[i] + self.c * v.c[j]
        return Vec(*w)

    def out(self, v):
        return self._apply(v, self.s)

    def back(self, v):
        return self._apply(v, -self.s)


class Body:
    def __init__(self, mass, velocity, spin=None, inertia=None, axes=None, frame=None):
        self.mass, self.velocity, self.spin, self.inertia = mass, velocity, spin, inertia
        self.axes = spin if axes is None else axes
        self.frame = frame


def symmetric(xx, yy, zz, xy=0, xz=0, yz=0):
    return [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]


class Mechanism:
    """Names, and which speeds are independent; the rest follows from the constraint rows."""

    constrained = True

    def __init__(self, name, q, u, inputs, independent):
        self.name, self.q, self.u, self.inputs = name, q, u, inputs
        self.parameters = list(states.parameters(name))
        self.independent = independent
        self.dependent = [k for k in range(len(u)) if k not in independent]

    @property
    def slots(self):
        """Names of one evaluation's arguments: q, independent u, inputs, parameters."""
        return self.q + [self.u[k] for k in self.independent] + self.inputs + self.parameters

    @property
    def results(self):
        """How many numbers one evaluation gives: q' (constrained mechanisms only) and u'."""
        return (len(self.q) if self.constrained else 0) + len(self.independent)


class Pendulum(Mechanism):
    constrained = False

    def __init__(self, n):
        names = lambda letter: [f"{letter}{i}" for i in range(n)]
        super().__init__(f"pendulum{n}", names("q"), names("u"), [], list(range(n)))

    def kinematics(self, S, q, u, w, p):
        x, y, bodies, loads = 0, 0, [], []
        for i in range(len(q)):
            x, y = x + p[f"l{i}"] * S.cos(q[i]) * u[i], y + p[f"l{i}"] * S.sin(q[i]) * u[i]
            bodies.append(Body(p[f"m{i}"], Vec(x, y, 0)))
            loads.append((-p[f"m{i}"] * p["g"], y))
        return bodies, loads, []


class Fourbar(Mechanism):
    def __init__(self):
        super().__init__("fourbar", ["q1", "q2", "q3"], ["u1", "u2", "u3"], ["T"], [0])

    def kinematics(self, S, q, u, w, p):
        x, y, bodies, loads = 0, 0, [], [(w[0], u[0])]
        for i in range(3):
            m, l = p[f"m{i + 1}"], p[f"l{i + 1}"]
            dx, dy = -l * S.sin(q[i]) * u[i], l * S.cos(q[i]) * u[i]
            bodies.append(Body(m, Vec(x + dx / 2, y + dy / 2, 0), Vec(0, 0, u[i]), symmetric(0, 0, p[f"I{i + 1}"])))
            loads.append((-m * p["g"], y + dy / 2))
            x, y = x + dx, y + dy
        return bodies, loads, [x, y]


class Tile(Mechanism):
    def __init__(self):
        q = [kind + leg for leg in "ABC" for kind in ("h", "psi", "th", "s")]
        super().__init__("tile", q, ["u_" + name for name in q], ["FA", "FB", "FC"], [0, 4, 8])

    def kinematics(self, S, q, u, w, p):
        half = math.sqrt(3) / 2
        rods, turning, centres, bodies, loads = [], [], [], [], []
        for leg, (ca, sa) in enumerate(((0, 1), (-half, -0.5), (half, -0.5))):
            _, psi, th, s = q[4 * leg : 4 * leg + 4]
            h1, psi1, th1, s1 = u[4 * leg : 4 * leg + 4]
            cp, sp, ct, st = S.cos(psi), S.sin(psi), S.cos(th), S.sin(th)
            cx, cy = ca * cp - sa * sp, sa * cp + ca * sp
            rod = Vec(-ct * cx, -ct * cy, st)
            rate = Vec(th1 * st * cx + psi1 * ct * cy, th1 * st * cy - psi1 * ct * cx, th1 * ct)
            rods.append(rod)
            turning.append(rate)
            centres.append(Vec(0, 0, h1) + rod.times(s1) + rate.times(s))
            bodies.append(Body(p["ms"] + p["mr"] + p["mc"], Vec(0, 0, h1), Vec(-psi1 * st, th1, psi1 * ct),
                               symmetric(p["Ic1"], p["Ic2"], p["Ic3"])))
            loads.append((w[leg] - p["c"] * h1 - (p["ms"] + p["mc"]) * p["g"], h1))
        x, x1 = -rods[0], -turning[0]
        z = rods[0].cross(rods[1]).times(2 / math.sqrt(3))
        z1 = (turning[0].cross(rods[1]) + rods[0].cross(turning[1])).times(2 / math.sqrt(3))
        y, y1 = z.cross(x), z1.cross(x) + z.cross(x1)
        spin = Vec(y1.dot(z), z1.dot(x), x1.dot(y))
        bodies.append(Body(p["M"], centres[0], spin, symmetric(p["Ix"], p["Iy"], p["Iz"])))
        loads.append((-p["M"] * p["g"], centres[0].c[2]))
        closed = [centres[0] - centres[1], centres[1] - centres[2], turning[0] + turning[1] + turning[2]]
        return bodies, loads, [x for v in closed for x in v.c]


class Bicycle(Mechanism):
    """Velocities in the yaw-roll frame, the shortest of the usual choices."""

    def __init__(self):
        q = ["yaw", "roll", "pitch", "steer", "thR", "thF"]
        super().__init__("bicycle", q, ["u_" + name for name in q], ["Troll", "Tsteer", "Trear"], [1, 3, 4])

    def kinematics(self, S, q, u, w, p):
        trig = lambda axis, angle: Turn(axis, S.cos(angle), S.sin(angle))
        leaned, pitch, tilt, steer = (trig(*x) for x in (("x", q[1]), ("y", q[2]), ("y", p["lam"]), ("z", q[3])))
        down = leaned.back(Vec(0, 0, 1))
        frame = down.times(u[0]) + Vec(u[1], 0, 0)
        rear = frame + Vec(0, u[2], 0)
        rear_wheel = rear + Vec(0, u[4], 0)
        hub = rear_wheel.cross(Vec(0, 0, -p["rR"]))
        to_rear = lambda v: tilt.out(steer.out(tilt.back(v)))
        to_front = lambda v: tilt.out(steer.back(tilt.back(v)))
        steer_axis = pitch.out(tilt.out(Vec(0, 0, 1)))
        front = rear + steer_axis.times(u[3])
        axle = pitch.out(to_rear(Vec(0, 1, 0)))
        front_wheel = front + axle.times(u[5])
        rear_centre = hub + rear.cross(pitch.out(Vec(p["xB"], 0, p["zB"] + p["rR"])))
        foot = hub + rear.cross(pitch.out(Vec(p["w"] + p["c"], 0, p["rR"])))
        front_centre = foot + front.cross(pitch.out(to_rear(Vec(p["xH"] - p["w"] - p["c"], 0, p["zH"]))))
        front_hub = foot + front.cross(pitch.out(to_rear(Vec(-p["c"], 0, -p["rF"]))))
        k = down.dot(axle)
        spoke = (down - axle.times(k)).times(p["rF"] / S.sqrt(1 - k * k))
        slip = front_hub + front_wheel.cross(spoke)
        wheel = lambda x, y: symmetric(x, y, x)
        front_axes = to_front(pitch.back(front))
        bodies = [
            Body(p["mR"], hub, pitch.back(rear_wheel), wheel(p["IRx"], p["IRy"]), pitch.back(rear), frame),
            Body(p["mB"], rear_centre, pitch.back(rear), symmetric(p["IBxx"], p["IByy"], p["IBzz"], xz=p["IBxz"]), None, frame),
            Body(p["mH"], front_centre, front_axes, symmetric(p["IHxx"], p["IHyy"], p["IHzz"], xz=p["IHxz"]), None, frame),
            Body(p["mF"], front_hub, to_front(pitch.back(front_wheel)), wheel(p["IFx"], p["IFy"]), front_axes, frame),
        ]
        loads = [(b.mass * p["g"], down.dot(b.velocity)) for b in bodies]
        loads += [(w[0], u[1]), (w[1], u[3]), (w[2], u[4])]
        return bodies, loads, list(slip.c)


class Arm(Mechanism):
    """By composite bodies and recursion: the peers' own best way with a tree."""

    constrained = False
    alpha = [(1, 0), (0, -1), (1, 0), (0, -1), (0, 1), (0, -1)]

    def __init__(self):
        names = lambda letter: [f"{letter}{i}" for i in range(6)]
        super().__init__("arm6", names("q"), names("u"), names("T"), list(range(6)))

    def kinematics(self, S, q, u, w, p):
        """Velocities and spins in link axes: for peers that do Kane by themselves."""
        bodies, loads = [], []
        spin, origin, up = Vec(0, 0, 0), Vec(0, 0, 0), Vec(0, 0, 1)
        for i in range(6):
            seat, turn = Turn("x", *self.alpha[i]), Turn("z", S.cos(q[i]), S.sin(q[i]))
            back = lambda v: turn.back(seat.back(v))
            get = lambda *names: [p[f"{name}{i}"] for name in names]
            if i:
                origin = origin + spin.cross(Vec(*get("px", "py", "pz")))
            origin, up, spin = back(origin), back(up), back(spin) + Vec(0, 0, u[i])
            velocity = origin + spin.cross(Vec(*get("cx", "cy", "cz")))
            inertia = symmetric(*get("Ixx", "Iyy", "Izz", "Ixy", "Ixz", "Iyz"))
            bodies.append(Body(p[f"m{i}"], velocity, spin, inertia, None, spin))
            loads += [(-p[f"m{i}"] * p["g"], up.dot(velocity)), (w[i], u[i])]
        return bodies, loads, []

    def recursion(self, S, q, u, u_dot, p):
        """Torques by Newton-Euler recursion about the joints, with the turns and places of the joints and the links about them."""
        n = 6
        seats = [(Turn("x", *self.alpha[i]), Turn("z", S.cos(q[i]), S.sin(q[i]))) for i in range(n)]
        back = lambda i, v: seats[i][1].back(seats[i][0].back(v))
        joint = [Vec(*(p[f"{x}{i}"] for x in ("px", "py", "pz"))) for i in range(n)]
        spin, change, push = Vec(0, 0, 0), Vec(0, 0, 0), Vec(0, 0, p["g"])
        forces, moments, links = [], [], [self._about_joint(p, i) for i in range(n)]
        for i, (m, inertia, first) in enumerate(links):
            if i:
                push = push + change.cross(joint[i]) + spin.cross(spin.cross(joint[i]))
            push, spin, change = back(i, push), back(i, spin), back(i, change)
            change = change + Vec(spin.c[1] * u[i], -spin.c[0] * u[i], u_dot[i])
            spin = spin + Vec(0, 0, u[i])
            forces.append(push.times(m) + change.cross(first) + spin.cross(spin.cross(first)))
            moments.append(self._times(inertia, change) + spin.cross(self._times(inertia, spin)) + first.cross(push))
        for i in reversed(range(1, n)):
            force = self._out(seats[i], forces[i])
            forces[i - 1] = forces[i - 1] + force
            moments[i - 1] = moments[i - 1] + self._out(seats[i], moments[i]) + joint[i].cross(force)
        return [moment.c[2] for moment in moments], seats, joint, links

    def composite(self, S, q, u, w, p):
        """(M, torque - bias) by Newton-Euler recursion and composite bodies about the joints."""
        n = 6
        bias, seats, joint, links = self.recursion(S, q, u, [0] * n, p)
        out = lambda i, v: self._out(seats[i], v)
        composites = [(m, first, inertia) for m, inertia, first in links]
        right = [w[i] - bias[i] for i in range(n)]
        mass = [[None] * n for _ in range(n)]
        for i in reversed(range(n)):
            m, first, inertia = composites[i]
            force = Vec(-first.c[1], first.c[0], 0)
            moment = Vec(inertia[0][2], inertia[1][2], inertia[2][2])
            mass[i][i] = moment.c[2]
            for j in range(i, 0, -1):
                force = out(j, force)
                moment = out(j, moment) + joint[j].cross(force)
                mass[i][j - 1] = mass[j - 1][i] = moment.c[2]
            if i:
                composites[i - 1] = self._join(composites[i - 1], m, first, inertia, seats[i], joint[i])
        return mass, right

    @staticmethod
    def _out(seat, v):
        """Components in the frame of the link below."""
        return seat[0].out(seat[1].out(v))

    @staticmethod
    def _times(inertia, v):
        return Vec(*(Vec(*row).dot(v) for row in inertia))

    @staticmethod
    def _about_joint(p, i):
        """Mass, inertia about the joint and first moment of link i."""
        m, x, y, z, xx, yy, zz, xy, xz, yz = (p[f"{k}{i}"] for k in ("m", "cx", "cy", "cz", "Ixx", "Iyy", "Izz", "Ixy", "Ixz", "Iyz"))
        a, b, c = m * x, m * y, m * z
        return m, symmetric(xx + b * y + c * z, yy + a * x + c * z, zz + a * x + b * y, xy - a * y, xz - a * z, yz - b * z), Vec(a, b, c)

    @staticmethod
    def _rotate(inertia, turn):
        """R I R^T of a symmetric matrix, by columns and then rows."""
        columns = [turn.out(Vec(*(inertia[r][c] for r in range(3)))) for c in range(3)]
        rows = [turn.out(Vec(*(columns[c].c[r] for c in range(3)))) for r in range(3)]
        return [[rows[min(r, c)].c[max(r, c)] for c in range(3)] for r in range(3)]

    def _join(self, inner, m, first, inertia, seat, arm):
        """The composite body of the inner link: the outer one moved by `arm`."""
        m0, first0, inertia0 = inner
        turned = self._rotate(self._rotate(inertia, seat[1]), seat[0])
        h = seat[0].out(seat[1].out(first))
        moved = h + arm.times(m)
        twice = h + moved
        (px, py, pz), (kx, ky, kz), (hx, hy, hz), (nx, ny, nz) = arm.c, twice.c, h.c, moved.c
        shift = symmetric(py * ky + pz * kz, px * kx + pz * kz, px * kx + py * ky,
                          -(px * ny + hx * py), -(px * nz + hx * pz), -(py * nz + hy * pz))
        total = [[inertia0[r][c] + turned[r][c] + shift[r][c] for c in range(3)] for r in range(3)]
        for r in range(3):
            for c in range(r):
                total[r][c] = total[c][r]
        return m0 + m, first0 + moved, total


MECHANISMS = {"tile": Tile, "arm6": Arm, "bicycle": Bicycle, "fourbar": Fourbar, "pendulum10": lambda: Pendulum(10)}
