"""Does an implicit step pay for a stiff bladder? `python3 tests/peers/stiffness.py` in the environment of run.py.

A sheet of 27 x 27 nodes of 55 mg over 0.2 x 0.2 m, E t = 5 kN/m, bulged by 30 mm. Prints the longest stable step of Verlet's method
and the lowest frequency; for steps h how many products with K conjugate gradients take for (1 + h^2/4 M^-1 K) x = f to 1e-3 and 1e-6,
beside the explicit steps of the same time; processor time of a banded factorisation and of a solution with it.
"""
import time

import numpy
import scipy.linalg
import scipy.sparse
import scipy.sparse.linalg

NODES, WIDTH, BULGE = 27, 0.2, 0.03
STIFFNESS, MASS, PRESSURE = 5000.0, 55e-6, 4000.0
SPACING = WIDTH / (NODES + 1)
STEPS, ACCURACIES = (0.2e-3, 0.5e-3, 1e-3, 2e-3, 5e-3, 1e-2), (1e-3, 1e-6)


def place(row, column):
    """Of a node of the frame and what it holds (m)."""
    height = BULGE * numpy.sin(numpy.pi * row / (NODES + 1)) * numpy.sin(numpy.pi * column / (NODES + 1))
    return numpy.array([column * SPACING, row * SPACING, height])


def matrix():
    """M^-1 K of the free nodes, springs between neighbours in rows and columns (1/s^2)."""
    number = lambda row, column: (row - 1) * NODES + column - 1 if 0 < row <= NODES and 0 < column <= NODES else None
    entries = {}
    for row in range(NODES + 2):
        for column in range(NODES + 2):
            for other in ((row, column + 1), (row + 1, column)):
                ends = [number(row, column), number(*other)]
                along = place(*other) - place(row, column)
                length = numpy.linalg.norm(along)
                outer = numpy.outer(along, along) / length**2
                block = STIFFNESS / MASS * (outer + (1 - SPACING / length) * (numpy.eye(3) - outer))
                for a in ends:
                    for b in ends:
                        if a is not None and b is not None:
                            entries[a, b] = entries.get((a, b), 0) + (block if a == b else -block)
    at = [(3 * a + i, 3 * b + j, block[i, j]) for (a, b), block in entries.items() for i in range(3) for j in range(3)]
    rows, columns, values = zip(*at)
    return scipy.sparse.csc_matrix((values, (rows, columns)), shape=(3 * NODES**2,) * 2)


def products(system, force):
    """Products that conjugate gradients take to each accuracy."""
    exact, found, left, taken = scipy.sparse.linalg.spsolve(system, force), numpy.zeros_like(force), force.copy(), []
    way, size = left.copy(), left @ left
    for count in range(1, 2000):
        image = system @ way
        gain = size / (way @ image)
        found, left = found + gain * way, left - gain * image
        size, before = left @ left, size
        way = left + size / before * way
        error = numpy.linalg.norm(found - exact) / numpy.linalg.norm(exact)
        taken += [count for accuracy in ACCURACIES[len(taken):] if error < accuracy]
        if len(taken) == len(ACCURACIES):
            break
    return taken


def banded(system, force):
    """Least processor time (us) of a factorisation and of a solution."""
    entries = system.tocoo()
    band = numpy.zeros((max(entries.row - entries.col) + 1, len(force)))
    lower = entries.row >= entries.col
    band[(entries.row - entries.col)[lower], entries.col[lower]] = entries.data[lower]
    took = []
    for _ in range(20):
        start = time.process_time()
        factors = scipy.linalg.cholesky_banded(band, lower=True)
        between = time.process_time()
        scipy.linalg.cho_solve_banded((factors, True), force)
        took.append((between - start, time.process_time() - between))
    return [1e6 * min(times) for times in zip(*took)]


def main():
    stiffness = matrix()
    highest = numpy.sqrt(scipy.sparse.linalg.eigsh(stiffness, k=1, return_eigenvectors=False)[0])
    lowest = numpy.sqrt(scipy.sparse.linalg.eigsh(stiffness, k=1, sigma=0, return_eigenvectors=False)[0])
    print(f"longest explicit step {2e6 / highest:.0f} us, frequencies {lowest:.0f} to {highest:.0f} rad/s")
    force = numpy.tile([0, 0, PRESSURE * SPACING**2 / MASS], NODES**2)
    system = lambda h: (scipy.sparse.identity(len(force)) + h * h / 4 * stiffness).tocsc()
    for h in STEPS:
        rough, fine = products(system(h), force)
        print(f"{1e3 * h:5.1f} ms: {rough} products to 1e-3, {fine} to 1e-6, explicit steps {h * highest / 2:.1f}")
    print("banded: factors {:.0f} us, a solution {:.0f} us".format(*banded(system(5e-3), force)))


if __name__ == "__main__":
    main()
