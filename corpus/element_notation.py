"""How the elements of the corpus are written down: lists of points, polynomials, maps of given Jacobian.

`add` only records; make_elements.py proves every expected verdict before it writes a file.
"""
from fractions import Fraction as Q
from random import Random

from exact import multinomial, mul, power, square_indices, triangle_indices

ELEMENTS = []


def add(name, expect, source, degree, points, weights=None, basis="bernstein", proof=None):
    """points: "x,y x,y ..." or a list of pairs of strings; degree: n, or (p, q) for a quadrilateral."""
    if isinstance(points, str):
        points = [tuple(p.split(",")) for p in points.split()]
    if isinstance(weights, str):
        weights = weights.split()
    ELEMENTS.append({"name": name, "expect": expect, "source": source,
                     "kind": "triangle" if isinstance(degree, int) else "quadrilateral", "degree": degree,
                     "basis": basis, "points": points, "weights": weights, "proof": proof})


def text(pairs):
    return [tuple(str(Q(x)) for x in p) for p in pairs]


def doubles(points):
    """The nearest doubles of decimal points, as exact fractions."""
    return [tuple(str(Q(float(x))) for x in p.split(",")) for p in points.split()]


def grid(n, spacing=1, radius=0, seed=0, unit=1):
    """Regular triangular net, each point moved by at most `radius` units of `unit` in each coordinate."""
    random = Random(seed)
    return text([tuple(spacing * Q(x) + unit * random.randint(-radius, radius) for x in e[1:])
                 for e in triangle_indices(n)])


def square(p, q, radius=0, seed=0, unit=1):
    random = Random(seed)
    return text([tuple(Q(x) + unit * random.randint(-radius, radius) for x in (e[1], e[3]))
                 for e in square_indices(p, q)])


def curve_top(p, q, heights):
    """x = u; the rows rise evenly to the top edge with the given heights."""
    return text([(Q(c, p), Q(r, q) * Q(heights[c])) for r in range(q + 1) for c in range(p + 1)])


# Polynomials in (s, t), or (u, v) on the square, are {(power of s, power of t): coefficient}.
S, T = {(1, 0): Q(1)}, {(0, 1): Q(1)}


def poly(*terms):
    """Sum of products of polynomials and numbers: poly((3, S, S), (-1, T)) is 3 s^2 - t."""
    total = {}
    for term in terms:
        product = {(0, 0): Q(1)}
        for factor in term:
            product = mul(product, factor if isinstance(factor, dict) else {(0, 0): Q(factor)})
        for e, c in product.items():
            total[e] = total.get(e, 0) + c
    return total


def form(f, n, kind="triangle"):
    """Homogeneous form of a polynomial: degree n on the triangle, bidegree n on the square."""
    total = {}
    for (a, b), c in f.items():
        if kind == "triangle":
            ones = {(1, 0, 0): Q(1), (0, 1, 0): Q(1), (0, 0, 1): Q(1)}
            term = mul({(0, a, b): c}, power(ones, n - a - b, {(0, 0, 0): Q(1)}))
        else:
            u, v = {(1, 0, 0, 0): Q(1), (0, 1, 0, 0): Q(1)}, {(0, 0, 1, 0): Q(1), (0, 0, 0, 1): Q(1)}
            one = {(0, 0, 0, 0): Q(1)}
            term = mul({(0, a, 0, b): c}, mul(power(u, n[0] - a, one), power(v, n[1] - b, one)))
        for e, d in term.items():
            total[e] = total.get(e, 0) + d
    return total


def prescribed(g, kind="triangle"):
    """The map x = s, y = integral of g dt, whose Jacobian determinant is g exactly: (degree, points)."""
    y = {(a, b + 1): c / (b + 1) for (a, b), c in g.items()}
    if kind == "triangle":
        n = max(a + b for a, b in y)
        order, first = triangle_indices(n), n
    else:
        n = max(1, *(a for a, b in y)), max(b for a, b in y)
        order, first = square_indices(*n), n[0]
    f = form(y, n, kind)
    return n, text([(Q(e[1], first), f.get(e, Q(0)) / multinomial(e)) for e in order])


def jacobian(name, expect, source, g, kind="triangle", proof=None):
    lead = "Map x = s, y = integral of g dt" if kind == "triangle" else "Map x = u, y = integral of g dv"
    degree, points = prescribed(g, kind)
    add(name, expect, f"{lead}, so det J = g. {source}", degree, points, proof=proof)
