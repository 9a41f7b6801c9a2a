"""Steps of the bladder of `sheet.c` in numba, Warp and MuJoCo: `sheet.py` runs this in its virtual environment.

Prints a line for each: scalar, peer, least and median time of a step (ns) over turns, height of the middle (m), after how many
steps. All do less than the runtime: plain sums, no test for NaN and infinity. numba walks rows as the C does, each spring
once, with `fastmath`. Warp gathers by node, as its threads want it: each spring twice, three launches a step. MuJoCo has a sheet
of its own, a flex of triangles without gas; its motion differs and only the number of nodes is the same, so no height is compared.
"""

import statistics
import sys
import time

import numpy

N = 29
H, K, L, P, G = 1e-4, 5000.0, 0.05, 2000.0, -9.81


def start(real):
    """Positions, 1/mass, stiffness to the right and up, pressure of each cell, rows first."""
    row, column = numpy.mgrid[0:N, 0:N]
    inner = (row > 0) & (row < N - 1) & (column > 0) & (column < N - 1)
    z = numpy.where(inner, 0.01 * numpy.sin(0.3 * column) * numpy.cos(0.2 * row), 0.0)
    x = numpy.array([column * L, row * L, z])
    right = K * ((row > 0) & (row < N - 1) & (column < N - 1))
    up = K * ((column > 0) & (column < N - 1) & (row < N - 1))
    corner = ((row == 0) | (row == N - 2)) & ((column == 0) | (column == N - 2))
    cell = P * ((row < N - 1) & (column < N - 1) & ~corner)
    return [numpy.ascontiguousarray(a, dtype=real) for a in (x, inner, right, up, cell)]


def measure(step, steps, turns):
    """Least and median time of a step (ns); `step` takes how many."""
    step(1)
    took = []
    for _ in range(turns):
        begin = time.perf_counter_ns()
        step(steps)
        took.append((time.perf_counter_ns() - begin) / steps)
    return min(took), statistics.median(took)


def with_numba(real):
    """What takes so many steps, and what tells the height of the middle (m)."""
    import numba

    @numba.njit(fastmath=True, error_model="numpy")
    def forces(x, right, up, cell, f, pulls, rises, shares):
        half, eighth, warp = x.dtype.type(0.5), x.dtype.type(0.125), x.dtype.type(1 / 24)
        rest, weight, one = x.dtype.type(L), x.dtype.type(G), x.dtype.type(1)
        rises[:] = 0
        shares[:] = 0
        for r in range(N):
            now, old = r % 2, 1 - r % 2
            below = min(r + 1, N - 1)
            for i in range(N - 1):
                dx, dy, dz = x[0, r, i + 1] - x[0, r, i], x[1, r, i + 1] - x[1, r, i], x[2, r, i + 1] - x[2, r, i]
                length = numpy.sqrt(dx * dx + dy * dy + dz * dz)
                s = right[r, i] * (length - rest) * (one / length)
                pulls[0, i + 1], pulls[1, i + 1], pulls[2, i + 1] = dx * s, dy * s, dz * s
            if r < N - 1:
                for i in range(N):
                    dx, dy, dz = x[0, below, i] - x[0, r, i], x[1, below, i] - x[1, r, i], x[2, below, i] - x[2, r, i]
                    length = numpy.sqrt(dx * dx + dy * dy + dz * dz)
                    s = up[r, i] * (length - rest) * (one / length)
                    rises[now, 0, i], rises[now, 1, i], rises[now, 2, i] = dx * s, dy * s, dz * s
                for i in range(N - 1):
                    px, py, pz = x[0, below, i + 1] - x[0, r, i], x[1, below, i + 1] - x[1, r, i], x[2, below, i + 1] - x[2, r, i]
                    qx, qy, qz = x[0, below, i] - x[0, r, i + 1], x[1, below, i] - x[1, r, i + 1], x[2, below, i] - x[2, r, i + 1]
                    gx = x[0, r, i] + x[0, below, i + 1] - (x[0, r, i + 1] + x[0, below, i])
                    gy = x[1, r, i] + x[1, below, i + 1] - (x[1, r, i + 1] + x[1, below, i])
                    gz = x[2, r, i] + x[2, below, i + 1] - (x[2, r, i + 1] + x[2, below, i])
                    nx, ny, nz = py * qz - pz * qy, pz * qx - px * qz, px * qy - py * qx
                    sx, sy, sz = qy * gz - qz * gy, qz * gx - qx * gz, qx * gy - qy * gx
                    ax, ay, az = py * gz - pz * gy, pz * gx - px * gz, px * gy - py * gx
                    e, t = eighth * cell[r, i], warp * cell[r, i]
                    a, b, c, d = shares[now, 0], shares[now, 1], shares[now, 2], shares[now, 3]
                    a[0, i + 1], a[1, i + 1], a[2, i + 1] = nx * e + sx * t, ny * e + sy * t, nz * e + sz * t
                    c[0, i + 1], c[1, i + 1], c[2, i + 1] = nx * e - sx * t, ny * e - sy * t, nz * e - sz * t
                    b[0, i + 1], b[1, i + 1], b[2, i + 1] = nx * e + ax * t, ny * e + ay * t, nz * e + az * t
                    d[0, i + 1], d[1, i + 1], d[2, i + 1] = nx * e - ax * t, ny * e - ay * t, nz * e - az * t
            else:
                rises[now] = 0
                shares[now] = 0
            for j in range(3):
                a, b, c, d = shares[now, 0, j], shares[now, 1, j], shares[old, 2, j], shares[old, 3, j]
                for i in range(N):
                    sum = -pulls[j, i] + pulls[j, i + 1] - rises[old, j, i] + rises[now, j, i]
                    f[j, r, i] = sum + c[i] + d[i + 1] + b[i] + a[i + 1]
            for i in range(N):
                f[2, r, i] += weight

    @numba.njit(fastmath=True, error_model="numpy")
    def advance(count, x, v, w, right, up, cell, f, pulls, rises, shares):
        h, half = x.dtype.type(H), x.dtype.type(H / 2)
        for _ in range(count):
            for j in range(3):
                for r in range(N):
                    for i in range(N):
                        v[j, r, i] += half * (f[j, r, i] * w[r, i])
                        x[j, r, i] += h * v[j, r, i]
            forces(x, right, up, cell, f, pulls, rises, shares)
            for j in range(3):
                for r in range(N):
                    for i in range(N):
                        v[j, r, i] += half * (f[j, r, i] * w[r, i])

    x, w, right, up, cell = start(real)
    v, f = numpy.zeros_like(x), numpy.zeros_like(x)
    room = numpy.zeros((3, N + 1), real), numpy.zeros((2, 3, N), real), numpy.zeros((2, 4, 3, N + 1), real)
    forces(x, right, up, cell, f, *room)
    return lambda count: advance(count, x, v, w, right, up, cell, f, *room), lambda: x[2, N // 2, N // 2]


def with_warp(real):
    """The same in Warp on the processor, single precision."""
    import warp

    warp.config.quiet = True
    warp.init()
    rest, weight = warp.constant(warp.float32(L)), warp.constant(warp.float32(G))
    across, h = warp.constant(N), warp.constant(warp.float32(H))

    @warp.func
    def pull(a: warp.vec3, b: warp.vec3, k: float):
        d = b - a
        length = warp.length(d)
        return d * (k * (length - rest) / length)

    @warp.func
    def share(x: warp.array(dtype=warp.vec3), cell: warp.array(dtype=float), at: int, corner: int):
        a, b, c, d = x[at], x[at + 1], x[at + across + 1], x[at + across]
        p, q, g = c - a, d - b, (a + c) - (b + d)
        side, sign = warp.cross(q, g), 1.0
        if corner == 1 or corner == 3:
            side = warp.cross(p, g)
        if corner > 1:
            sign = -1.0
        return (warp.cross(p, q) * 0.125 + side * (sign / 24.0)) * cell[at]

    @warp.kernel
    def drift(x: warp.array(dtype=warp.vec3), v: warp.array(dtype=warp.vec3), f: warp.array(dtype=warp.vec3), w: warp.array(dtype=float)):
        i = warp.tid()
        v[i] = v[i] + f[i] * (0.5 * h * w[i])
        x[i] = x[i] + v[i] * h

    @warp.kernel
    def force(x: warp.array(dtype=warp.vec3), f: warp.array(dtype=warp.vec3), right: warp.array(dtype=float), up: warp.array(dtype=float), cell: warp.array(dtype=float)):
        i = warp.tid()
        r, c = i / across, i % across
        if r > 0 and c > 0 and r < across - 1 and c < across - 1:
            sum = warp.vec3(0.0, 0.0, weight) - pull(x[i - 1], x[i], right[i - 1]) + pull(x[i], x[i + 1], right[i])
            sum = sum - pull(x[i - across], x[i], up[i - across]) + pull(x[i], x[i + across], up[i])
            sum = sum + share(x, cell, i - across - 1, 2) + share(x, cell, i - across, 3)
            f[i] = sum + share(x, cell, i - 1, 1) + share(x, cell, i, 0)

    @warp.kernel
    def kick(v: warp.array(dtype=warp.vec3), f: warp.array(dtype=warp.vec3), w: warp.array(dtype=float)):
        i = warp.tid()
        v[i] = v[i] + f[i] * (0.5 * h * w[i])

    x, w, right, up, cell = start(real)
    x = warp.array(x.reshape(3, -1).T.copy(), dtype=warp.vec3, device="cpu")
    v, f = warp.zeros_like(x), warp.zeros_like(x)
    w, right, up, cell = [warp.array(a.ravel(), dtype=float, device="cpu") for a in (w, right, up, cell)]
    force_again = lambda: warp.launch(force, N * N, inputs=[x, f, right, up, cell], device="cpu")
    force_again()
    launches = [warp.launch(kernel, N * N, inputs=inputs, device="cpu", record_cmd=True)
                for kernel, inputs in [(drift, [x, v, f, w]), (force, [x, f, right, up, cell]), (kick, [v, f, w])]]

    def step(count):
        for _ in range(count):
            for launch in launches:
                launch.launch()

    return step, lambda: x.numpy()[N // 2 * N + N // 2][2]


def with_mujoco(_):
    """A flex of 27 x 27 free nodes, its frame pinned; Euler's method, without contacts."""
    import mujoco

    last = N - 1
    frame = f"0 0 {last} 0  0 {last} {last} {last}  0 0 0 {last}  {last} 0 {last} {last}"
    text = f"""<mujoco><option timestep="{H}" integrator="Euler"><flag contact="disable"/></option><worldbody>
    <flexcomp name="sheet" type="grid" dim="2" count="{N} {N} 1" spacing="{L} {L} {L}" mass="{N * N}" radius="0.001">
    <elasticity young="1e6" poisson="0.3" thickness="0.005" elastic2d="stretch"/><contact selfcollide="none"/>
    <pin gridrange="{frame}"/></flexcomp></worldbody></mujoco>"""
    model = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(model)
    data.qpos[0] += 0.01
    mujoco.mj_forward(model, data)
    # All nodes but the frame move, and the sheet pulls them.
    assert model.nv == 3 * (N - 2) ** 2 and abs(data.qfrc_passive).max() > 1, model.nv
    return lambda count: mujoco.mj_step(model, data, count), lambda: numpy.nan


def main():
    steps, turns = int(sys.argv[1]), int(sys.argv[2])
    peers = [("f32", "numba", with_numba), ("f64", "numba", with_numba), ("f32", "Warp", with_warp), ("f64", "MuJoCo", with_mujoco)]
    for scalar, name, make in peers:
        few = steps if name == "numba" else 5
        try:
            step, height = make(numpy.float32 if scalar == "f32" else numpy.float64)
            least, median = measure(step, few, turns)
            print(f"{scalar} {name} {least:.1f} {median:.1f} {height():.9g} {1 + few * turns}", flush=True)
        except Exception as error:  # What cannot be installed or run stays in the table, with the reason.
            print(f"{scalar} {name} not: {error!r}"[:300], flush=True)


if __name__ == "__main__":
    main()
