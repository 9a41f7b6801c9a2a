"""Completes a peer's derivation: from mass matrix, forces and constraint rows to straight-line C.

A peer that gives M, f, the constraint Jacobian J and its bias (SymPy, SymForce) gets the same sparse
elimination, written statement by statement: each entry that is not zero is a C name or literal,
each operation one statement, counted.
"""


class Lines:
    """C statements and how many operations they hold.

    What depends on the dependent speeds must wait until these are solved: such names are `late`, and
    a statement that uses one goes behind the others.
    """

    def __init__(self):
        self.early, self.later, self.late, self.operations, self.count = [], [], set(), 0, 0

    def state(self, name, text, late):
        """name = text."""
        (self.later if late else self.early).append(f"  const double {name} = {text};")
        if late:
            self.late.add(name)

    def operation(self, a, sign, b):
        self.operations += 1
        self.count += 1
        name = f"e{self.count}"
        self.state(name, f"{a} {sign} {b}", any(x.strip("(-)") in self.late for x in (a, b)))
        return name

    def add(self, a, b):
        return b if a == "0" else a if b == "0" else self.operation(a, "+", b)

    def sub(self, a, b):
        if b == "0":
            return a
        return f"(-{b})" if a == "0" else self.operation(a, "-", b)

    def mul(self, a, b):
        if "0" in (a, b):
            return "0"
        return b if a == "1" else a if b == "1" else self.operation(a, "*", b)

    def div(self, a, b):
        return "0" if a == "0" else a if b == "1" else self.operation(a, "/", b)

    def solve(self, a, right, numbers):
        """Rows of a (square) and right-hand sides; pivots by least fill among entries that are large at
        every state of `numbers`, the values of a at several states."""
        n = len(a)
        rows = [list(a[i]) + list(right[i]) for i in range(n)]
        values = [[list(map(float, row)) for row in table] for table in numbers]
        left, order = list(range(n)), []
        unused = list(range(n))
        for _ in range(n):
            i, j = self._pivot(rows, values, left, unused)
            left.remove(i)
            unused.remove(j)
            order.append((i, j))
            inverse = self.div("1", rows[i][j])
            for k in unused + list(range(n, len(rows[i]))):
                rows[i][k] = self.mul(inverse, rows[i][k])
            for table in values:
                table[i] = [x / table[i][j] for x in table[i]]
            for r in left:
                factor = rows[r][j]
                if factor == "0":
                    continue
                for k in unused + list(range(n, len(rows[r]))):
                    rows[r][k] = self.sub(rows[r][k], self.mul(factor, rows[i][k]))
                for table in values:
                    value = table[r][j]
                    for k in unused:
                        table[r][k] -= value * table[i][k]
                rows[r][j] = "0"
        solution = [None] * n
        for step in reversed(range(n)):
            i, j = order[step]
            result = rows[i][n:]
            for _, later in order[step + 1 :]:
                result = [self.sub(x, self.mul(rows[i][later], y)) for x, y in zip(result, solution[later])]
            solution[j] = result
        return solution

    @staticmethod
    def _pivot(rows, values, left, unused):
        """Row and column: least fill among entries of at least this part of the best worst-case size."""
        part = 0.2
        sizes = {}
        for i in left:
            for j in unused:
                if rows[i][j] != "0":
                    sizes[i, j] = min(abs(t[i][j]) / max(1e-300, max(abs(t[i][k]) for k in unused)) for t in values)
        enough = part * max(sizes.values())
        fill = lambda i, j: (sum(rows[i][k] != "0" for k in unused) - 1) * (sum(rows[r][j] != "0" for r in left) - 1)
        return min((ij for ij, size in sizes.items() if size >= enough), key=lambda ij: (fill(*ij), -sizes[ij]))

    def positive(self, a, b):
        """Solves a symmetric positive system by L D L^T."""
        n = len(a)
        a, b, factor = [list(row) for row in a], list(b), {}
        for j in range(n):
            inverse = self.div("1", a[j][j])
            for i in range(j + 1, n):
                factor[i, j] = self.mul(a[i][j], inverse)
                for k in range(j + 1, i + 1):
                    a[i][k] = self.sub(a[i][k], self.mul(factor[i, j], a[k][j]))
                b[i] = self.sub(b[i], self.mul(factor[i, j], b[j]))
            a[j][j] = inverse
        for i in reversed(range(n)):
            b[i] = self.mul(b[i], a[i][i])
            for k in range(i + 1, n):
                b[i] = self.sub(b[i], self.mul(factor[k, i], b[k]))
        return b

    def sum_of_products(self, a, b):
        total = "0"
        for x, y in zip(a, b):
            total = self.add(total, self.mul(x, y))
        return total


def finish(lines, mechanism, mass, force, jacobian, bias, numbers):
    """Names of the results: u', or q' and u' with the dependent speeds eliminated. Entries are C
    names; `numbers` are values of the Jacobian's dependent part at several states."""
    if not jacobian:
        return lines.positive(mass, force)
    independent, dependent = mechanism.independent, mechanism.dependent
    pick = lambda rows, columns: [[row[k] for k in columns] for row in rows]
    negative = lambda x: "0" if x == "0" else f"(-{x})"
    right = [[negative(x) for x in row] + [negative(b)] for row, b in zip(pick(jacobian, independent), bias)]
    solution = lines.solve(pick(jacobian, dependent), right, numbers)
    k = len(independent)
    partial = [["1" if i == j else "0" for j in independent] for i in range(len(mechanism.u))]
    beta = ["0"] * len(mechanism.u)
    for row, i in zip(solution, dependent):
        partial[i], beta[i] = row[:k], row[k]
    columns = list(zip(*partial))
    speeds = [mechanism.u[i] for i in independent]
    q_dot = [lines.sum_of_products(row, speeds) for row in partial]
    for i in dependent:
        lines.state(mechanism.u[i], q_dot[i], False)
    weighted = [[lines.sum_of_products(row, column) for row in mass] for column in columns]
    net = [lines.sub(f, lines.sum_of_products(row, beta)) for f, row in zip(force, mass)]
    reduced = [[None] * k for _ in range(k)]
    for i in range(k):
        for j in range(i + 1):
            reduced[i][j] = reduced[j][i] = lines.sum_of_products(columns[i], weighted[j])
    return q_dot + lines.positive(reduced, [lines.sum_of_products(c, net) for c in columns])


def text_of(e):
    """(C text, operations) of a SymPy or symengine expression without common sub-expressions."""
    kind, arguments = type(e).__name__, e.args
    if kind in ("sin", "cos", "sqrt"):
        text, n = text_of(arguments[0])
        return f"{kind}({text})", n + 1
    if kind == "Pow":
        return power(*arguments)
    if kind == "Add":
        parts = [text_of(a) for a in arguments]
        return "(" + " + ".join(text for text, _ in parts) + ")", sum(n for _, n in parts) + len(parts) - 1
    if kind == "Mul":
        return multiplication(arguments)
    if not arguments:
        text = str(e)
        return (text, 0) if not text.lstrip("-")[0].isdigit() else (f"({float(e)!r})", 0)
    raise NotImplementedError(f"{kind}: {e}")


def power(base, exponent):
    """Integer powers as products, half-integer ones times a square root; inverse powers divide."""
    text, n = text_of(base)
    size = abs(float(exponent))
    times, root = int(size), size != int(size)
    assert size - times in (0, 0.5) and (times + root == 1 or n == 0), (base, exponent)
    product = "(" + "*".join([text] * times + [f"sqrt({text})"] * root) + ")"
    n += times + 2 * root - 1
    return (product, n) if float(exponent) > 0 else (f"(1.0/{product})", n + 1)


def multiplication(arguments):
    """A product; -1 is a sign, inverse powers are divided by."""
    above, below, n, sign = [], [], 0, ""
    for a in arguments:
        if a == -1:
            sign = "-"
            continue
        inverse = type(a).__name__ == "Pow" and float(a.args[1]) < 0
        text, m = text_of(1 / a if inverse else a)
        n += m
        (below if inverse else above).append(text)
    n += max(len(above), 1) - 1 + len(below)
    return "(" + sign + "*".join(above or ["1.0"]) + "".join(f"/{x}" for x in below) + ")", n


def program(mechanism, temporaries, names, outputs, numbers):
    """C source and operations. `temporaries` [(symbol, expression)] from common sub-expressions;
    `outputs` (M, f, J, bias) as nested lists of expressions; `names` the symbols of dependent speeds."""
    lines, late = Lines(), {str(name) for name in names}
    lines.late |= late
    symbols = {}

    def is_late(e):
        return any(str(s) in lines.late for s in e.free_symbols)

    def place(name, e):
        text, n = text_of(e)
        lines.operations += n
        lines.state(name, text, is_late(e))

    for symbol, e in temporaries:
        place(str(symbol), e)

    def entry(e):
        if e == 0:
            return "0"
        if e == 1:
            return "1"
        if e not in symbols:
            symbols[e] = f"v{len(symbols)}"
            place(symbols[e], e)
        return symbols[e]

    mass, force, jacobian, bias = outputs
    table = lambda rows: [[entry(e) for e in row] for row in rows]
    results = finish(lines, mechanism, table(mass), table([force])[0], table(jacobian), table([bias])[0], numbers)
    text = ["#include <math.h>", "void eval(const double *restrict in, double *restrict out) {"]
    text += [f"  const double {name} = in[{i}];" for i, name in enumerate(mechanism.slots)]
    text += lines.early + lines.later
    text += [f"  out[{i}] = {name};" for i, name in enumerate(results)] + ["}"]
    return "\n".join(text), lines.operations
