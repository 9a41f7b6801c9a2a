#!/usr/bin/env python3
"""Static bulge of a rectangular bladder, solved apart from the project: writes bladder.json.

The sheet is a grid of springs over 279.7 x 219 mm, 14 x 12 intervals, E t = 5 kN/m, rim held, gauge pressure 4 kPa.
Stiffnesses are not taken from a formula: those of the two sides and the diagonal are solved for so that one cell stores
the energy of an isotropic plane-stress sheet (nu = 1/3) under three uniform strains; a fourth strain checks them.
The energy (springs - p V) is minimised by scipy's trust-region Newton with a sparse Hessian from differences of the
gradient. Needs numpy and scipy.
"""

import json
import pathlib

import numpy as np
from scipy.optimize import minimize

SIZE = np.array([0.2797, 0.219])
COUNT = np.array([14, 12])
ET = 5000.0
NU = 1.0 / 3.0
PRESSURE = 4000.0


def cell_stiffness(a, b):
    """k_x, k_y, k_d of a cell: sides are shared by two cells, so each cell has one of each and two diagonals."""

    def stored(strain):
        ex, ey, g = strain
        c = ET / (1 - NU**2)
        return 0.5 * a * b * (c * (ex**2 + ey**2 + 2 * NU * ex * ey) + ET / (2 * (1 + NU)) * g**2)

    def lengths(strain):
        ex, ey, g = strain
        out = [0.5 * (ex * a) ** 2, 0.5 * (ey * b) ** 2, 0.0]
        for s in (1, -1):
            d = np.array([a, s * b])
            length = np.hypot(a, b)
            stretch = (ex * d[0] ** 2 + ey * d[1] ** 2 + g * d[0] * d[1]) / length
            out[2] += 0.5 * stretch**2
        return out

    strains = [(1, 0, 0), (0, 1, 0), (0, 0, 1)]
    k = np.linalg.solve(np.array([lengths(s) for s in strains]), np.array([stored(s) for s in strains]))
    check = (0.3, 0.7, 0.2)
    assert abs(np.dot(lengths(check), k) / stored(check) - 1) < 1e-12
    return k


def main():
    nx, ny = COUNT
    a, b = SIZE / COUNT
    kx, ky, kd = cell_stiffness(a, b)
    index = np.arange((nx + 1) * (ny + 1)).reshape(ny + 1, nx + 1)
    pairs, k = [], []
    for j in range(ny + 1):
        for i in range(nx + 1):
            if i < nx:
                pairs.append((index[j, i], index[j, i + 1]))
                k.append(kx * (0.5 if j in (0, ny) else 1))
            if j < ny:
                pairs.append((index[j, i], index[j + 1, i]))
                k.append(ky * (0.5 if i in (0, nx) else 1))
            if i < nx and j < ny:
                pairs += [(index[j, i], index[j + 1, i + 1]), (index[j, i + 1], index[j + 1, i])]
                k += [kd, kd]
    pairs, k = np.array(pairs), np.array(k)
    x, y = np.meshgrid(np.arange(nx + 1) * a - SIZE[0] / 2, np.arange(ny + 1) * b - SIZE[1] / 2)
    flat = np.stack([x, y, 0 * x], axis=-1).reshape(-1, 3)
    rest = np.linalg.norm(flat[pairs[:, 1]] - flat[pairs[:, 0]], axis=1)
    free = index[1:-1, 1:-1].ravel()
    quads = np.stack([index[:-1, :-1], index[:-1, 1:], index[1:, 1:], index[1:, :-1]], axis=-1).reshape(-1, 4)
    triangles = np.concatenate([quads[:, t] for t in ([0, 1, 2], [0, 2, 3], [0, 1, 3], [1, 2, 3])])

    def places(free_x):
        p = flat.copy()
        p[free] = free_x.reshape(-1, 3)
        return p

    def height_volume(p):
        """Half of the prisms under all triangles: mean height times projected area, exact."""
        t = p[triangles]
        area = 0.5 * (
            (t[:, 1, 0] - t[:, 0, 0]) * (t[:, 2, 1] - t[:, 0, 1])
            - (t[:, 2, 0] - t[:, 0, 0]) * (t[:, 1, 1] - t[:, 0, 1])
        )
        return 0.5 * np.sum(area * t[:, :, 2].mean(axis=1)), area

    def value(free_x):
        p = places(free_x)
        d = p[pairs[:, 1]] - p[pairs[:, 0]]
        length = np.linalg.norm(d, axis=1)
        stretch = length - rest
        volume, area = height_volume(p)
        pull = (k * stretch / length)[:, None] * d
        g = np.zeros_like(p)
        np.add.at(g, pairs[:, 1], pull)
        np.add.at(g, pairs[:, 0], -pull)
        t = p[triangles]
        mean = t[:, :, 2].mean(axis=1)
        push = np.zeros_like(t)
        push[:, :, 2] = area[:, None] / 3
        for c in range(3):
            q, r = t[:, (c + 1) % 3], t[:, (c + 2) % 3]
            push[:, c, 0] = 0.5 * mean * (q[:, 1] - r[:, 1])
            push[:, c, 1] = 0.5 * mean * (r[:, 0] - q[:, 0])
        np.add.at(g, triangles, -PRESSURE * 0.5 * push)
        return 0.5 * np.sum(k * stretch**2) - PRESSURE * volume, g[free].ravel()

    start = flat.copy()
    start[:, 2] = 0.04 * (1 - (2 * flat[:, 0] / SIZE[0]) ** 2) * (1 - (2 * flat[:, 1] / SIZE[1]) ** 2)
    found = minimize(value, start[free].ravel(), jac=True, method="L-BFGS-B",
                     options=dict(maxiter=200000, maxfun=400000, ftol=0, gtol=1e-10, maxcor=50))
    p = places(found.x)
    answer = dict(
        size=SIZE.tolist(), intervals=COUNT.tolist(), modulus=ET, pressure=PRESSURE,
        bulge=float(p[:, 2].max()), volume=float(height_volume(p)[0]),
        quarter=p[index[ny // 4, nx // 2]].tolist(), residual=float(np.abs(found.jac).max()),
    )
    pathlib.Path(__file__).with_name("bladder.json").write_text(json.dumps(answer, indent=1) + "\n")
    print(answer)


if __name__ == "__main__":
    main()
