"""Scenes of models/scenes as arrays for the peers: shape, forces, and the law of their touches.

Written independently of our own code, from the shapes and the law of the thesis; motions.py checks that both agree
when it compares the references. A scene with features that this file lacks is refused by name.
"""
import tomllib

import numpy

# Part of the rest length within which points touch together; normal force (N) that counts as none.
TOGETHER, NO_FORCE = 1e-11, 1e-9
KNOWN = {"format", "title", "shape", "links", "drop_height", "K", "C", "g", "law", "T", "step", "every", "rows", "columns",
         "width", "depth", "air_drag", "pressure"}


class Scene:
    """Points (n, 3), springs (m, 2) with rest lengths, facets (k, 4), which points are fixed; unit masses."""

    def __init__(self, path):
        text = tomllib.loads(path.read_text())
        if unknown := set(text) - KNOWN or text.get("C", 0.0) != 0.0 and {"C"}:
            raise NotImplementedError(f"{path.name}: {', '.join(unknown)}")
        points, self.fixed, springs, facets = getattr(self, text["shape"])(text)
        self.x, self.springs = numpy.array(points, float), numpy.array(springs)
        self.facets = numpy.array(facets, int).reshape(-1, 4)
        self.n, self.fixed = len(points), numpy.array(self.fixed)
        self.rest = numpy.linalg.norm(self.x[self.springs[:, 1]] - self.x[self.springs[:, 0]], axis=1)
        self.x[:, 2] += text.get("drop_height", 0.0)
        self.stiffness, self.gravity, self.drag = text["K"], text["g"], text.get("air_drag", 0.0)
        # Of the springs (N s/m): scenes of motions.py have none.
        self.damping = 0.0
        self.pressure, self.has_ground, self.seconds = text.get("pressure", 0.0), text["law"] != "none", text["T"]
        self.together = TOGETHER * self.rest.min()

    def chain(self, text):
        n = text["links"] + 1
        return [[0, 0, i] for i in range(n)], [False] * n, [[i, i + 1] for i in range(n - 1)], []

    def cube(self, _):
        points = [[x, y, z] for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
        return points, [False] * 8, [[a, b] for a in range(8) for b in range(a + 1, 8)], []

    def sheet(self, text):
        rows, columns = text["rows"], text["columns"]
        dx, dy = text["width"] / (columns + 1), text["depth"] / (rows + 1)
        inner = [(r, c) for r in range(1, rows + 1) for c in range(1, columns + 1)]
        frame = [(r, c) for r in range(rows + 2) for c in range(columns + 2) if (r in (0, rows + 1)) != (c in (0, columns + 1))]
        number = {place: i for i, place in enumerate(inner + frame)}
        springs = [[number[r, c], number[r, c + 1]] for r in range(1, rows + 1) for c in range(columns + 1)]
        springs += [[number[r, c], number[r + 1, c]] for c in range(1, columns + 1) for r in range(rows + 1)]
        cells = [[number.get(k) for k in ((r, c), (r, c + 1), (r + 1, c + 1), (r + 1, c))] for r in range(rows + 1) for c in range(columns + 1)]
        corners = [[i for i in cell if i is not None] for cell in cells]
        return ([[c * dx, r * dy, 0] for r, c in inner + frame], [False] * len(inner) + [True] * len(frame), springs,
                [cell if len(cell) == 4 else [*cell, cell[2]] for cell in corners if len(cell) >= 3])

    def shares(self, a, b, c, d, cross):
        """Forces per pressure on the corners of all facets: the gradient of the volume under bilinear patches."""
        of = lambda a, b, c, d: (cross(b - a, d - a) / 9 + cross(b - a, c - b) / 18 + cross(c - d, d - a) / 18 + cross(c - d, c - b) / 36)
        return of(a, b, c, d), of(b, c, d, a), of(c, d, a, b), of(d, a, b, c)

    def forces(self, x, v):
        """Of all points, in NumPy (n, 3)."""
        force = -self.drag * v - [0, 0, self.gravity]
        tail, head = self.springs.T
        along = x[head] - x[tail]
        pull = (self.stiffness * (1 - self.rest / numpy.sqrt((along * along).sum(1))))[:, None] * along
        numpy.add.at(force, tail, pull)
        numpy.add.at(force, head, -pull)
        return force + self.blown(x)

    def blown(self, x):
        """Forces of the pressure (n, 3). A triangle repeats its third corner: the patch's formula holds for it too."""
        force = numpy.zeros_like(x)
        if self.pressure:
            corners = [x[i] for i in self.facets.T]
            for i, share in zip(self.facets.T, self.shares(*corners, numpy.cross)):
                numpy.add.at(force, i, self.pressure * share)
        return force


class Ground:
    """Which points the ground holds, and which have just left it: their event functions are inactive until they are clear."""

    def __init__(self, scene, push=None):
        """`push(x)`: what the ground gives each point that it holds (N), where a peer has a faster way to it."""
        self.scene, self.push = scene, push or (lambda x: -scene.forces(x, numpy.zeros_like(x))[:, 2])
        self.held, self.leaving = numpy.zeros(scene.n, bool), numpy.zeros(scene.n, bool)

    def guard(self, x):
        """Turns negative at the next touch or release: smallest gap of what is free, smallest push on what is held."""
        gap = x[:, 2] + numpy.where(self.leaving, self.scene.together, 0.0)
        return (numpy.where(self.held, self.push(x), gap) if self.held.any() else gap).min()

    def sleeping(self, x):
        """Turns negative when all that left is clear of the ground."""
        return (2 * self.scene.together - x[self.leaving, 2]).max() if self.leaving.any() else 1.0

    def event(self, x, v):
        """Touch of all closing points at the surface, then release of what would be pulled; changes x and v."""
        self.leaving &= x[:, 2] <= self.scene.together
        touching = (x[:, 2] <= self.scene.together) & (v[:, 2] < 0) & ~self.held
        if touching.any():
            x[touching, 2] = 0.0
            compensate(self.scene, x, v, touching, self.held)
            self.leaving |= touching & (v[:, 2] > 0)
            self.held |= touching & (v[:, 2] <= 0)
        pulled = self.held & (self.push(x) <= NO_FORCE)
        self.held &= ~pulled
        self.leaving |= pulled


def compensate(scene, x, v, touching, held):
    """Touching points stop; their energy goes along the springs to free neighbours (thesis 4.10 to 4.13); changes v."""
    approach = numpy.where(touching, -v[:, 2], 0.0)
    energy = 0.5 * (approach**2).sum()
    v[touching, 2] = 0.0
    field, lift = numpy.zeros_like(v), numpy.zeros(scene.n)
    for tail, head in scene.springs:
        for i, k in ((tail, head), (head, tail)):
            d = (x[k] - x[i]) / numpy.linalg.norm(x[k] - x[i])
            if touching[i] and not touching[k] and not held[k] and not scene.fixed[k] and d[2] > 1e-6:
                field[k] += d[2] * d
                field[i] -= d[2] * d * [1, 1, 0]
                lift[i] += d[2] ** 2
    a, b = 0.5 * (field**2).sum(), (v * field).sum()
    if a == 0.0:
        v[touching, 2] = approach[touching]
        return
    root = numpy.sqrt(b * b + 4 * a * energy)
    down = 2 * energy / (b - root) if b < root else 0.0
    pushes = (approach + down * lift)[touching].min() >= 0
    v += (down if b <= 0 and pushes else (root - b) / (2 * a)) * field
