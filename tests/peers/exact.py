"""Forward dynamics in 200-bit arithmetic, from an independent formulation.

Bodies are placed by positions and rotation matrices; velocities, angular velocities and bias
accelerations come from Taylor coefficients along paths through the configuration; constraints are
adjoined with multipliers: [M J'; J 0] [q''; -lambda] = [f; -bias]. No elimination of speeds, no
partial velocities, no shared expressions: nothing here resembles the generated equations.
"""
import gmpy2
from gmpy2 import mpfr

BITS = 200
gmpy2.get_context().precision = BITS
ZERO = mpfr(0)
ONE = mpfr(1)


class Jet:
    """Value, first and second derivative along a path."""

    __slots__ = ("a", "b", "c")

    def __init__(self, a, b=ZERO, c=ZERO):
        self.a, self.b, self.c = a, b, c

    def __add__(self, o):
        if isinstance(o, Jet):
            return Jet(self.a + o.a, self.b + o.b, self.c + o.c)
        return Jet(self.a + o, self.b, self.c)

    __radd__ = __add__

    def __neg__(self):
        return Jet(-self.a, -self.b, -self.c)

    def __sub__(self, o):
        return self + (-o)

    def __rsub__(self, o):
        return (-self) + o

    def __mul__(self, o):
        if isinstance(o, Jet):
            return Jet(self.a * o.a, self.a * o.b + self.b * o.a, self.a * o.c + 2 * self.b * o.b + self.c * o.a)
        return Jet(self.a * o, self.b * o, self.c * o)

    __rmul__ = __mul__

    def rate(self):
        """The first derivative as a jet; its own second derivative is not known and not used."""
        return Jet(self.b, self.c)

    def chain(self, f, f1, f2):
        return Jet(f, f1 * self.b, f2 * self.b * self.b + f1 * self.c)

    def inverse(self):
        i = 1 / self.a
        return self.chain(i, -i * i, 2 * i * i * i)


def sin(x):
    s, c = gmpy2.sin_cos(x.a)
    return x.chain(s, c, -s)


def cos(x):
    s, c = gmpy2.sin_cos(x.a)
    return x.chain(c, -s, -c)


def sqrt(x):
    r = gmpy2.sqrt(x.a)
    return x.chain(r, 1 / (2 * r), -1 / (4 * r * x.a))


def const(x):
    return Jet(mpfr(x))


# ---- vectors and rotation matrices as lists -----------------------------------------------------


def add(*vectors):
    return [sum(parts[1:], parts[0]) for parts in zip(*vectors)]


def scaled(s, v):
    return [s * x for x in v]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def product(a, b):
    return [[a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j] for j in range(3)] for i in range(3)]


def apply(m, v):
    return [dot(row, v) for row in m]


def column(m, j):
    return [m[i][j] for i in range(3)]


def rotation(axis, angle):
    """Rotation matrix about a coordinate axis; columns are the turned axes."""
    s, c = sin(angle), cos(angle)
    one, zero = const(1), const(0)
    i, j = {"x": (1, 2), "y": (2, 0), "z": (0, 1)}[axis]
    m = [[one if r == k else zero for k in range(3)] for r in range(3)]
    m[i][i], m[i][j], m[j][i], m[j][j] = c, -s, s, c
    return m


def spin(m):
    """Angular velocity in the inertial frame, as jets: the axial vector of R' R^T."""
    rate = [[x.rate() for x in row] for row in m]
    w = lambda i, j: dot(rate[i], m[j])
    return [w(2, 1), w(0, 2), w(1, 0)]


IDENTITY = [[const(1 if i == j else 0) for j in range(3)] for i in range(3)]


class Body:
    """Mass, place of the mass centre, rotation matrix and central inertia (rows), weight (mass)."""

    def __init__(self, mass, place, turn=None, inertia=None, weight=None):
        self.mass, self.place, self.turn, self.inertia = mass, place, turn, inertia
        self.weight = mass if weight is None else weight


def matrix(xx, yy, zz, xy=ZERO, xz=ZERO, yz=ZERO):
    return [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]


# ---- models: place(q jets, parameters) -> bodies, closures, slips ---------------------------------


class Pendulum:
    def __init__(self, n):
        self.n = n
        self.independent = list(range(n))

    def parameters(self):
        return [f"m{i}" for i in range(self.n)] + [f"l{i}" for i in range(self.n)] + ["g"]

    def gravity(self, p):
        return [ZERO, -p["g"], ZERO]

    def place(self, q, p):
        x, y, bodies = const(0), const(0), []
        for i in range(self.n):
            x, y = x + p[f"l{i}"] * sin(q[i]), y - p[f"l{i}"] * cos(q[i])
            bodies.append(Body(p[f"m{i}"], [x, y, const(0)]))
        return bodies, [], []

    def force(self, q, u, w, p):
        return [ZERO] * self.n


class Arm:
    alpha = [0, -90, 0, -90, 90, -90]
    n = 6
    independent = list(range(6))

    def gravity(self, p):
        return [ZERO, ZERO, -p["g"]]

    def place(self, q, p):
        origin, turn, bodies = [const(0)] * 3, IDENTITY, []
        for i in range(6):
            value = lambda name: Jet(p[f"{name}{i}"])
            origin = add(origin, apply(turn, [value("px"), value("py"), value("pz")]))
            seat = rotation("x", const(gmpy2.const_pi() * self.alpha[i] / 180))
            turn = product(turn, product(seat, rotation("z", q[i])))
            centre = add(origin, apply(turn, [value("cx"), value("cy"), value("cz")]))
            inertia = matrix(*(p[f"{name}{i}"] for name in ("Ixx", "Iyy", "Izz", "Ixy", "Ixz", "Iyz")))
            bodies.append(Body(p[f"m{i}"], centre, turn, inertia))
        return bodies, [], []

    def force(self, q, u, w, p):
        return list(w)


class Fourbar:
    n = 3
    independent = [0]

    def gravity(self, p):
        return [ZERO, -p["g"], ZERO]

    def place(self, q, p):
        x, y, bodies = const(0), const(0), []
        for i in range(3):
            l, turn = p[f"l{i + 1}"], rotation("z", q[i])
            dx, dy = l * turn[0][0], l * turn[1][0]
            half = mpfr("0.5")
            centre = [x + half * dx, y + half * dy, const(0)]
            bodies.append(Body(p[f"m{i + 1}"], centre, turn, matrix(ZERO, ZERO, p[f"I{i + 1}"])))
            x, y = x + dx, y + dy
        return bodies, [x - p["l4"], y], []

    def force(self, q, u, w, p):
        return [w[0], ZERO, ZERO]


class Tile:
    n = 12
    independent = [0, 4, 8]

    def gravity(self, p):
        return [ZERO, ZERO, -p["g"]]

    def place(self, q, p):
        rods, centres, bodies = [], [], []
        for leg, azimuth in enumerate((90, 210, 330)):
            h, psi, th, s = q[4 * leg : 4 * leg + 4]
            column_turn = rotation("z", const(gmpy2.const_pi() * azimuth / 180))
            turn = product(column_turn, product(rotation("z", psi), rotation("y", th)))
            rod = scaled(-ONE, column(turn, 0))
            foot = add(scaled(p["R"], column(column_turn, 0)), [const(0), const(0), h])
            bodies.append(Body(p["ms"] + p["mr"], foot, weight=p["ms"]))
            bodies.append(Body(p["mc"], foot, turn, matrix(p["Ic1"], p["Ic2"], p["Ic3"])))
            rods.append(rod)
            centres.append(add(foot, scaled(s, rod)))
        x = scaled(-ONE, rods[0])
        y = scaled(1 / gmpy2.sqrt(mpfr(3)), add(rods[2], scaled(-ONE, rods[1])))
        z = cross(x, y)
        turn = [[x[i], y[i], z[i]] for i in range(3)]
        bodies.append(Body(p["M"], centres[0], turn, matrix(p["Ix"], p["Iy"], p["Iz"])))
        apart = lambda k: add(centres[0], scaled(-ONE, centres[k]))
        return bodies, apart(1) + apart(2) + add(*rods), []

    def force(self, q, u, w, p):
        f = [ZERO] * 12
        for leg in range(3):
            f[4 * leg] = w[leg] - p["c"] * u[4 * leg]
        return f


class Bicycle:
    """Eight coordinates: those of the model, and x, y of the rear hub at the end."""

    n = 8
    independent = [1, 3, 4]

    def gravity(self, p):
        return [ZERO, ZERO, p["g"]]

    def place(self, q, p):
        yaw, roll, pitch, steer, rear, front, x, y = q
        leaned = product(rotation("z", yaw), rotation("x", roll))
        frame = product(leaned, rotation("y", pitch))
        tilt = const(p["lam"])
        fork = product(product(product(frame, rotation("y", tilt)), rotation("z", steer)), rotation("y", -tilt))
        rear_turn, front_turn = product(frame, rotation("y", rear)), product(fork, rotation("y", front))
        hub = [x, y, -p["rR"] * cos(roll)]
        at = lambda turn, a, b: add(scaled(a, column(turn, 0)), scaled(b, column(turn, 2)))
        foot = add(hub, at(frame, p["w"] + p["c"], p["rR"]))
        front_hub = add(foot, at(fork, -p["c"], -p["rF"]))
        bodies = [
            Body(p["mR"], hub, rear_turn, matrix(p["IRx"], p["IRy"], p["IRx"])),
            Body(p["mB"], add(hub, at(frame, p["xB"], p["zB"] + p["rR"])), frame,
                 matrix(p["IBxx"], p["IByy"], p["IBzz"], xz=p["IBxz"])),
            Body(p["mH"], add(foot, at(fork, p["xH"] - p["w"] - p["c"], p["zH"])), fork,
                 matrix(p["IHxx"], p["IHyy"], p["IHzz"], xz=p["IHxz"])),
            Body(p["mF"], front_hub, front_turn, matrix(p["IFx"], p["IFy"], p["IFx"])),
        ]
        contact = lambda turn, radius: self.to_ground(column(turn, 1), radius)
        rear_spoke, front_spoke = contact(frame, p["rR"]), contact(fork, p["rF"])
        height = front_hub[2] + front_spoke[2]
        slip = lambda place, turn, spoke: add([r.rate() for r in place], cross(spin(turn), spoke))[:2]
        slips = slip(hub, rear_turn, rear_spoke) + slip(front_hub, front_turn, front_spoke)
        return bodies, [height], slips

    @staticmethod
    def to_ground(axle, radius):
        """From a wheel's centre to its lowest point: down, less its part along the axle, to length."""
        down = [-(axle[2] * axle[0]), -(axle[2] * axle[1]), 1 - axle[2] * axle[2]]
        length = sqrt(dot(down, down))
        return scaled(radius * length.inverse(), down)

    def force(self, q, u, w, p):
        return [ZERO, w[0], ZERO, w[1], w[2], ZERO, ZERO, ZERO]


MODELS = {"pendulum3": Pendulum(3), "pendulum10": Pendulum(10), "arm6": Arm(), "fourbar": Fourbar(), "tile": Tile(),
          "bicycle": Bicycle()}


# ---- the equations --------------------------------------------------------------------------------


def solve(a, b):
    """Gauss with partial pivoting; b is a list of right-hand sides. Returns the list of solutions."""
    n = len(a)
    rows = [list(a[i]) + [rhs[i] for rhs in b] for i in range(n)]
    for k in range(n):
        pivot = max(range(k, n), key=lambda i: abs(rows[i][k]))
        rows[k], rows[pivot] = rows[pivot], rows[k]
        head = rows[k]
        for row in rows[k + 1 :]:
            if row[k] != 0:
                f = row[k] / head[k]
                for j in range(k, len(row)):
                    row[j] -= f * head[j]
    out = []
    for r in range(len(b)):
        x = [ZERO] * n
        for i in reversed(range(n)):
            x[i] = (rows[i][n + r] - sum(rows[i][j] * x[j] for j in range(i + 1, n))) / rows[i][i]
        out.append(x)
    return out


def number(x):
    return mpfr(x) if not isinstance(x, str) else mpfr(x)


def path(q, direction):
    return [Jet(a, b) for a, b in zip(q, direction)]


def unit(n, k):
    return [ONE if i == k else ZERO for i in range(n)]


def closures(model, q, p):
    """Residuals of the configuration constraints and their Jacobian, rows by coordinate columns."""
    columns = [model.place(path(q, unit(model.n, k)), p)[1] for k in range(model.n)]
    residual = [r.a for r in columns[0]]
    return residual, [[columns[k][i].b for k in range(model.n)] for i in range(len(residual))]


def assemble(model, q, dependent, p, steps=60):
    """Newton on the dependent coordinates to full precision (least squares where there are spare ones)."""
    q = [number(x) for x in q]
    p = {name: number(x) for name, x in p.items()}
    for _ in range(steps):
        residual, rows = closures(model, q, p)
        a = [[row[k] for k in dependent] for row in rows]
        [d] = solve(a, [[-r for r in residual]])
        for k, change in zip(dependent, d):
            q[k] += change
        if max(abs(x) for x in d) < mpfr(2) ** (-BITS // 2):
            return q
    raise ArithmeticError("does not assemble")


def rates(model, q, u, w, p):
    """(all speeds, all their rates) for the independent speeds u, everything taken exactly as given."""
    n = model.n
    q, u, w = ([number(x) for x in v] for v in (q, u, w))
    q += [ZERO] * (n - len(q))
    p = {name: number(x) for name, x in p.items()}
    columns = [model.place(path(q, unit(n, k)), p) for k in range(n)]
    rows = [[c[1][i].b for c in columns] for i in range(len(columns[0][1]))]
    rows += [[c[2][i].a for c in columns] for i in range(len(columns[0][2]))]
    dependent = [k for k in range(n) if k not in model.independent]
    u_all = [ZERO] * n
    for k, value in zip(model.independent, u):
        u_all[k] = value
    if rows:
        right = [-sum(row[k] * u_all[k] for k in model.independent) for row in rows]
        [d] = solve([[row[k] for k in dependent] for row in rows], [right])
        for k, value in zip(dependent, d):
            u_all[k] = value
    bodies, closed, slips = model.place(path(q, u_all), p)
    bias = [c.c for c in closed] + [s.b for s in slips]
    mass = [[ZERO] * n for _ in range(n)]
    force = list(model.force(q, u_all, w, p))
    gravity = model.gravity(p)
    for index, body in enumerate(bodies):
        parts = [c[0][index] for c in columns]
        j_v = [[r.b for r in part.place] for part in parts]
        push = [body.weight * gravity[i] - body.mass * body.place[i].c for i in range(3)]
        for k in range(n):
            force[k] += dot(j_v[k], push)
            for l in range(k + 1):
                mass[k][l] += body.mass * dot(j_v[k], j_v[l])
        if body.turn is not None:
            turn = [[x.a for x in row] for row in body.turn]
            across = [[turn[j][i] for j in range(3)] for i in range(3)]
            inertia = product(product(turn, body.inertia), across)
            w_jet = spin(body.turn)
            w0, w1 = [x.a for x in w_jet], [x.b for x in w_jet]
            j_w = [[x.a for x in spin(part.turn)] for part in parts]
            moment = [a + b for a, b in zip(apply(inertia, w1), cross(w0, apply(inertia, w0)))]
            for k in range(n):
                momentum = apply(inertia, j_w[k])
                force[k] -= dot(j_w[k], moment)
                for l in range(k + 1):
                    mass[k][l] += dot(momentum, j_w[l])
    m = len(rows)
    a = [[mass[max(k, l)][min(k, l)] for l in range(n)] + [row[k] for row in rows] for k in range(n)]
    a += [list(row) + [ZERO] * m for row in rows]
    [x] = solve(a, [force + [-b for b in bias]])
    return u_all, x[:n]
