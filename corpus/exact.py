"""Exact mathematics of one curved element, independent of the C++ library.

A polynomial is a *form*: {exponents: Fraction}. On the triangle the exponents (i, j, k) belong to the
barycentric coordinates; on the square (a, b, c, d) belong to 1-u, u, 1-v, v. A Bernstein coefficient is the
coefficient of the form divided by the multinomial of its exponents, so products need no tables.
"""
from fractions import Fraction as Q
from itertools import combinations
from math import comb, gcd, lcm


def multinomial(e):
    if len(e) == 3:
        return comb(sum(e), e[0]) * comb(e[1] + e[2], e[1])
    return comb(e[0] + e[1], e[1]) * comb(e[2] + e[3], e[3])


def add(f, g, factor=1):
    h = dict(f)
    for e, c in g.items():
        h[e] = h.get(e, 0) + factor * c
    return h


def mul(f, g):
    h = {}
    for e, c in f.items():
        for k, d in g.items():
            key = tuple(map(sum, zip(e, k)))
            h[key] = h.get(key, 0) + c * d
    return h


def power(f, n, one):
    return mul(power(f, n - 1, one), f) if n else one


def diff(f, r):
    """Partial derivative by the r-th coordinate of the form."""
    return {e[:r] + (e[r] - 1,) + e[r + 1:]: c * e[r] for e, c in f.items() if e[r]}


def cross(a, b, c, d):
    return add(mul(a, d), mul(b, c), -1)


def det3(a, b, c):
    """Determinant of three triples of forms."""
    total = {}
    for r in range(3):
        s, t = (r + 1) % 3, (r + 2) % 3
        total = add(total, mul(a[r], cross(b[s], b[t], c[s], c[t])))
    return total


def evaluate(f, at):
    return sum((c * prod_powers(at, e) for e, c in f.items()), Q(0))


def prod_powers(at, e):
    value = Q(1)
    for x, k in zip(at, e):
        value *= x ** k
    return value


def triangle_indices(n):
    """Exponents in file order: rows parallel to the edge from corner 0 to corner 1."""
    return [(n - r - c, c, r) for r in range(n + 1) for c in range(n - r + 1)]


def square_indices(p, q):
    return [(p - c, c, q - r, r) for r in range(q + 1) for c in range(p + 1)]


class Element:
    """Exact control points and weights in Bernstein form; `degree` is n or (p, q)."""

    def __init__(self, kind, degree, points, weights=None, basis="bernstein"):
        self.triangle = kind == "triangle"
        self.degree = degree
        self.indices = triangle_indices(degree) if self.triangle else square_indices(*degree)
        if len(points) != len(self.indices) or (weights and len(weights) != len(points)):
            raise ValueError("wrong number of points or weights")
        if basis == "lagrange":
            points = to_bernstein(self.indices, points)
        self.point = dict(zip(self.indices, points))
        self.weight = dict(zip(self.indices, weights or [Q(1)] * len(points)))
        self.rational = len(set(self.weight.values())) > 1
        w = self.weight if self.rational else {e: Q(1) for e in self.indices}
        scaled = {e: multinomial(e) * w[e] for e in self.indices}
        self.X = {e: scaled[e] * self.point[e][0] for e in self.indices}
        self.Y = {e: scaled[e] * self.point[e][1] for e in self.indices}
        self.W = scaled
        self.N = self.numerator()

    def numerator(self):
        """N with det J = n^2 N / W^3, or det J = p q N / W^3 on the square."""
        forms = (self.X, self.Y, self.W)
        if self.triangle:
            n = Q(self.degree)
            F = [[{e: c / n for e, c in diff(f, r).items()} for f in forms] for r in range(3)]
            if self.rational:
                return det3(*F)
            a, b = ([add(F[r][k], F[2][k], -1) for k in range(2)] for r in range(2))
            return cross(a[0], b[0], a[1], b[1])
        p, q = self.degree
        if not self.rational:
            (xu, xv), (yu, yv) = self.derivatives(self.X), self.derivatives(self.Y)
            return {e: c / (p * q) for e, c in cross(xu, xv, yu, yv).items()}
        F = {(a, b): [{e: c / Q(p * q) for e, c in diff(diff(f, a), 2 + b).items()} for f in forms]
             for a in (0, 1) for b in (0, 1)}
        terms = [((1, 0, 1, 0), (0, 0), (1, 0), (0, 1)), ((0, 1, 1, 0), (0, 0), (1, 0), (1, 1)),
                 ((1, 0, 0, 1), (0, 0), (1, 1), (0, 1)), ((0, 1, 0, 1), (1, 0), (1, 1), (0, 1))]
        N = {}
        for corner, a, b, c in terms:
            N = add(N, mul({corner: Q(1)}, det3(F[a], F[b], F[c])))
        return N

    def derivatives(self, f):
        """The two parameter derivatives: by (s, t) = (xi_2, xi_3), or by (u, v)."""
        pairs = ((1, 0), (2, 0)) if self.triangle else ((1, 0), (3, 2))
        return [add(diff(f, a), diff(f, b), -1) for a, b in pairs]

    def image(self, at):
        w = evaluate(self.W, at)
        return evaluate(self.X, at) / w, evaluate(self.Y, at) / w

    def det(self, at):
        scale = self.degree ** 2 if self.triangle else self.degree[0] * self.degree[1]
        return scale * evaluate(self.N, at) / evaluate(self.W, at) ** 3


def to_bernstein(indices, nodes):
    """Control points of the element that passes through equispaced nodes (Gauss-Jordan elimination)."""
    degree = [sum(indices[0])] * 3 if len(indices[0]) == 3 else [sum(indices[0][:2])] * 2 + [sum(indices[0][2:])] * 2
    rows = []
    for node, xy in zip(indices, nodes):
        at = [Q(x, d) for x, d in zip(node, degree)]
        rows.append([multinomial(e) * prod_powers(at, e) for e in indices] + list(xy))
    size = len(rows)
    for c in range(size):
        pivot = next(r for r in range(c, size) if rows[r][c])
        rows[c], rows[pivot] = rows[pivot], rows[c]
        rows[c] = [x / rows[c][c] for x in rows[c]]
        for r in range(size):
            if r != c and rows[r][c]:
                factor = rows[r][c]
                rows[r] = [x - factor * y for x, y in zip(rows[r], rows[c])]
    return [tuple(row[size:]) for row in rows]


# ---- the sign of a polynomial by dyadic subdivision -------------------------------------------------------

def bernstein(f, triangle):
    """Exponents in file order with their Bernstein coefficients."""
    some = next(iter(f))
    order = triangle_indices(sum(some)) if triangle else square_indices(sum(some[:2]), sum(some[2:]))
    return [(e, Q(f.get(e, 0)) / multinomial(e)) for e in order]


def bernstein_rows(f, triangle):
    """Bernstein coefficients as rows of integers (all scaled by one positive number)."""
    values = bernstein(f, triangle)
    scale = lcm(*(v.denominator for _, v in values))
    rows = {}
    for e, v in values:
        rows.setdefault(e[-1], []).append(int(v * scale))
    return [rows[r] for r in sorted(rows)]


def split_row(row, lift):
    """The two halves of a univariate polynomial, times 2^(degree + lift)."""
    left, right, level = [], [], row
    for r in range(len(row)):
        shift = len(row) - 1 - r + lift
        left.append(level[0] << shift)
        right.append(level[-1] << shift)
        level = [a + b for a, b in zip(level, level[1:])]
    return left, right[::-1]


def halves(rows, triangle):
    """Bisect the edge between corners 0 and 1; the next bisection takes the edge opposite the new vertex."""
    n = len(rows) - 1
    parts = [split_row(row, r if triangle else 0) for r, row in enumerate(rows)]
    left, right = [p[0] for p in parts], [p[1] for p in parts]
    if not triangle:
        return [list(map(list, zip(*half))) for half in (left, right)]
    return ([[left[n - j - k][k] for j in range(n - k + 1)] for k in range(n + 1)],
            [[right[j][n - j - k] for j in range(n - k + 1)] for k in range(n + 1)])


def rotated(rows):
    """The same polynomial with corners (0, 1, 2) renamed (1, 2, 0)."""
    n = len(rows) - 1
    return [[rows[c][n - r - c] for c in range(n - r + 1)] for r in range(n + 1)]


def middle(a, b):
    return tuple((x + y) / 2 for x, y in zip(a, b))


def decide(rows, triangle, budget=6000, depth=64):
    """Sign of a polynomial by repeated bisection: (status, parameter with a negative value or None).

    status: positive | zero (>= 0 with a zero) | negative | mixed | below (<= 0 with a zero) | open (budget).
    """
    corners = [(Q(1), Q(0), Q(0)), (Q(0), Q(1), Q(0)), (Q(0), Q(0), Q(1))] if triangle else \
        [(Q(0), Q(0)), (Q(1), Q(0)), (Q(0), Q(1)), (Q(1), Q(1))]
    level, seen, witness = [(rows, corners)], set(), None
    while level and budget > 0 and depth > 0:
        following, depth = [], depth - 1
        for rows, at in level:
            budget -= 1
            ends = [rows[0][0], rows[0][-1], rows[-1][0]] + ([] if triangle else [rows[-1][-1]])
            for value, where in zip(ends, at):
                seen.add((value > 0) - (value < 0))
                if value < 0 and witness is None:
                    witness = where
            if {1, -1} <= seen:
                return "mixed", witness
            values = [c for row in rows for c in row]
            if (min(values) >= 0 or max(values) <= 0) and (any(values) or 0 in seen):
                continue
            common = gcd(*values)
            rows = [[c // common for c in row] for row in rows]
            if triangle:
                m = middle(at[0], at[1])
                places = [(at[2], at[0], m), (at[1], at[2], m)]
            else:
                m, k = middle(at[0], at[1]), middle(at[2], at[3])
                places = [(at[0], at[2], m, k), (m, k, at[1], at[3])]
            following += zip(halves(rows, triangle), places)
        level = following
    if level:
        return "open", witness
    if -1 in seen:
        return ("below" if 0 in seen else "negative"), witness
    return ("zero" if 0 in seen else "positive"), None


# ---- published sufficient conditions ----------------------------------------------------------------------

def orient(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def det_indices(a, b, c):
    return (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
            + a[2] * (b[0] * c[1] - b[1] * c[0]))


def step(e, r):
    return e[:r] + (e[r] + 1,) + e[r + 1:]


def upright(element):
    """Index triples of the upright control triangles."""
    return [[step(m, r) for r in range(3)] for m in triangle_indices(element.degree - 1)]


def control_net(element):
    if not element.triangle or element.rational:
        return "not_applicable"
    good = all(orient(*(element.point[e] for e in t)) > 0 for t in upright(element))
    return "proved" if good else "inconclusive"


def orientation(element):
    if not element.triangle:
        return "not_applicable"
    P, n = element.point, element.degree
    for t in upright(element):
        if max(map(max, t)) == n and orient(*(P[e] for e in t)) <= 0:
            return "inconclusive"
    for t in combinations(element.indices, 3):
        d = det_indices(*t)
        if d and d * orient(*(P[e] for e in t)) < 0:
            return "inconclusive"
    return "proved"


def cone(element):
    """KMC22 Theorem 1 with each edge in turn as the curve edge."""
    if not element.triangle:
        return "not_applicable"
    return "proved" if any(cone_on_edge(element, a) for a in range(3)) else "inconclusive"


def cone_on_edge(element, a):
    n, b, c = element.degree, (a + 1) % 3, (a + 2) % 3

    def index(i, j):  # row i from the edge, place j along it
        e = [0, 0, 0]
        e[a], e[b], e[c] = n - i - j, j, i
        return tuple(e)

    tip = element.weight[index(n, 0)]
    p = {(i, j): element.point[index(i, j)] for i in range(n + 1) for j in range(n + 1 - i)}
    w = {(i, j): element.weight[index(i, j)] / tip for i, j in p}
    if w[0, 0] != 1 or w[0, n] != 1 or any(w[ij] != 1 for ij in w if ij[0] >= 1):
        return False

    def vector(f, g):
        return g[0] - f[0], g[1] - f[1]

    def turn(f, g):
        return f[0] * g[1] - f[1] * g[0]

    def dot(f, g):
        return f[0] * g[0] + f[1] * g[1]

    def parallel(f, g):
        return turn(f, g) == 0 and dot(f, g) > 0

    o = middle(p[0, 0], p[0, n])
    curve = [p[0, j] for j in range(n + 1)]
    guard = [tuple((1 - w[0, j]) * o[k] + w[0, j] * p[0, j][k] for k in (0, 1)) for j in range(n + 1)]
    d = vector(p[1, 0], p[1, n - 1]) if n > 1 else vector(*curve)
    for net in (curve, guard):
        v = [vector(x, y) for x, y in zip(net, net[1:])]
        if any(dot(d, x) <= 0 for x in v):
            return False
        if any(turn(x, vector(net[j], p[1, j])) <= 0 for j in range(n) for x in v + [d]):
            return False
    first = vector(p[0, 0], p[1, 0])
    return all(parallel(vector(p[i, j], p[i, j + 1]), d) and parallel(vector(p[i, j], p[i + 1, j]), first)
               for i in range(1, n) for j in range(n - i))


def coefficients(element):
    rows = bernstein_rows(element.N, element.triangle)
    ends = [rows[0][0], rows[0][-1], rows[-1][0], rows[-1][-1]]
    if min(ends) <= 0:
        return "refuted"
    return "proved" if min(map(min, rows)) >= 0 else "inconclusive"


CRITERIA = {"control-net": control_net, "orientation": orientation, "cone": cone, "coefficients": coefficients}


# ---- proofs of injectivity, given det J > 0 ---------------------------------------------------------------

def hull(element):
    """Every convex combination of the Bernstein coefficients of W^2 J has positive determinant."""
    columns = []
    for f in (element.X, element.Y):
        df = element.derivatives(f)
        if element.rational:
            dw = element.derivatives(element.W)
            df = [cross(d, f, v, element.W) for d, v in zip(df, dw)]
        if not element.triangle:
            df = [mul(d, elevate) for d, elevate in zip(df, ({(1, 0, 0, 0): 1, (0, 1, 0, 0): 1},
                                                             {(0, 0, 1, 0): 1, (0, 0, 0, 1): 1}))]
        columns += [[c for _, c in bernstein(d, element.triangle)] for d in df]
    M = list(zip(*columns))
    if any(a * d - b * c <= 0 for a, b, c, d in M):
        return False
    return all(a[0] * b[3] + b[0] * a[3] - a[1] * b[2] - b[1] * a[2] >= 0 for a, b in combinations(M, 2))


def midpoint_rule(element):
    """F(y) - F(x) = J((x + y) / 2) (y - x) for polynomials of total degree 2 along every line."""
    return not element.rational and (element.degree in (1, 2) or element.degree == (1, 1))


def shear(element):
    """x depends on the first parameter alone, strictly; det J > 0 then makes y strictly monotone in the other."""
    if element.rational:
        return False
    xu, xv = ([c for _, c in bernstein(d, element.triangle)] for d in element.derivatives(element.X))
    return not any(xv) and min(xu) > 0


def simple_boundary(element):
    """Each edge runs monotonely along its chord, and the control polygons of two neighbouring edges are
    parted by a line that meets one of them in their common corner alone (triangles only)."""
    if not element.triangle:
        return False
    edges = [[element.point[e] for e in element.indices if e[r] == 0] for r in (2, 0, 1)]
    for edge in edges:
        chord = [b - a for a, b in zip(edge[0], edge[-1])]
        if any(sum(c * (y - x) for c, x, y in zip(chord, a, b)) <= 0 for a, b in zip(edge, edge[1:])):
            return False
    return all(any(parted(A, B, p, q) for p in A + B for q in A + B if p != q) for A, B in combinations(edges, 2))


def parted(A, B, p, q):
    """The line from p to q has A on its left, B on its right, and meets one of them in one point: their corner."""
    sides = [[(orient(p, q, x), x) for x in net] for net in (A, B)]
    if min(s for s, _ in sides[0]) < 0 or max(s for s, _ in sides[1]) > 0:
        return False
    return any(len({x for s, x in side if s == 0}) == 1 for side in sides)
