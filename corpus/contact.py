"""Proofs about elements that are powers of simpler maps: do two parts of the boundary meet, and where.

"ring": the element is the square of D, D injective, y of D a sum of terms >= 0 (zeros.py) and zero only for u = 0, where
x > 0, and, unless the last term keeps it away, at one point of u = 1. "crossing": y of D changes its sign on u = 1.
"cube": the cube of a straight triangle with a > 0, b >= 0. "line": an edge crosses the straight edge 0 on y = 0.
"""
from fractions import Fraction as Q
from itertools import product

import curves
import exact
import zeros
from element_notation import S, form, poly


def same_map(element, coordinates, degree, scales):
    """The element is the polynomial map `coordinates`, raised and reparametrised by `scales`."""
    plain = zeros.unweighted(element, scales) if scales else element
    assert not plain.rational
    kind = "quadrilateral"
    for have, f in ((plain.X, coordinates[0]), (plain.Y, coordinates[1])):
        assert not any(exact.add(have, form(f, plain.degree, kind), -1).values()), "another map"


def inner_element(coordinates, degree):
    forms = [form(f, degree, "quadrilateral") for f in coordinates]
    points = [tuple(f.get(e, Q(0)) / exact.multinomial(e) for f in forms) for e in exact.square_indices(*degree)]
    return exact.Element("quadrilateral", degree, points)


def injective(element):
    """det J > 0 by bisection, and a simple boundary by subdivision."""
    assert exact.decide(exact.bernstein_rows(element.N, element.triangle), element.triangle)[0] == "positive"
    P, (p, q) = element.point, element.degree
    bottom, top = ([P[p - c, c, q - r, r] for c in range(p + 1)] for r in (0, q))
    left, right = ([P[p - c, c, q - r, r] for r in range(q + 1)] for c in (0, p))
    loop = [curves.curve(points) for points in (bottom, right, top[::-1], left[::-1])]
    assert curves.simple_loop(loop), "the boundary of the inner map is not shown to be simple"


def ring(element, proof, expect):
    (x, y), degree = proof["inner"]
    same_map(element, (poly((1, x, x), (-1, y, y)), poly((2, x, y))), degree, proof.get("scales"))
    inner = inner_element((x, y), degree)
    injective(inner)
    kind = "quadrilateral"
    terms = [(proof["arch"], {(0, 0): Q(1)})] + proof["terms"]
    total = {}
    for factor, f in terms:
        assert all(c >= 0 for c in zeros.monomials(factor, kind).values())
        total = poly((1, total), (1, factor, f, f))
    assert zeros.clean(poly((1, total), (-1, y))) == {}, "y is another sum"
    assert all(inner.point[e][0] > 0 for e in inner.indices if e[1] == 0)
    systems = [list(map(zeros.clean, s)) for s in product(*(zeros.alternatives(term, kind) for term in terms))]
    elsewhere = [s for s in systems if S not in s]  # y = 0 other than along u = 0
    if expect == "injective":
        assert not elsewhere
        return "Injective: D is (det > 0, simple boundary), y >= 0 in D, and y = 0 only where x > 0."
    touching = [box for s in elsewhere for box in zeros.solve(s)]
    assert len(touching) == 1 and touching[0][0] == (1, 1)
    where = touching[0][1]  # x of D there lies inside the range of x on u = 0
    low, high = zeros.over(x, (Q(1), Q(1)), where)
    ends = [zeros.at(x, 0, 0), zeros.at(x, 0, 1)]
    assert min(ends) < -high and -low < max(ends)
    if proof["same"]:
        scales = proof.get("scales")
        first, second = proof["same"][1:]
        if scales:
            first, second = ((1 - p[0], p[0], 1 - p[1], p[1]) for p in
                             (zeros.moved((q[1], q[3]), "quadrilateral", scales) for q in (first, second)))
        assert first != second and element.image(first) == element.image(second)
    return "D is injective, y >= 0 in D, and y = 0 only for u = 0 and at that one point of u = 1."


def crossing(element, proof):
    (x, y), degree = proof["inner"]
    same_map(element, (poly((1, x, x), (-1, y, y)), poly((2, x, y))), degree, None)
    assert all(zeros.at(y, 0, Q(k, 20)) == 0 for k in range(21)) and max(b for _, b in y) < 20
    a, b = (Q(v) for v in proof["between"])
    assert zeros.at(y, 1, a) * zeros.at(y, 1, b) < 0
    low, high = zeros.over(x, (Q(1), Q(1)), (a, b))
    ends = [zeros.at(x, 0, 0), zeros.at(x, 0, 1)]
    assert min(ends) < -high and -low < max(ends)
    return f"y of D changes its sign on u = 1 between v = {a} and v = {b}."


def cube(element, proof):
    corners = [(Q(1, 2), Q(0)), (Q(2), Q(0)), (proof["tip"], Q(1))]
    assert all(a > 0 and b >= 0 for a, b in corners)
    for e in [(i, j, 9 - i - j) for i in range(10) for j in range(10 - i)]:  # enough points for degree 3
        at = tuple(Q(k, 9) for k in e)
        a, b = (sum(w * c[r] for w, c in zip(at, corners)) for r in (0, 1))
        assert element.image(at) == (a ** 3 - 3 * a * b * b + b ** 3, 3 * a * a * b - 3 * a * b * b)
    return "Injective: a > 0 and b >= 0 in the triangle, where the cube is injective."


def line(element, proof):
    """Edge 0 lies on y = 0 with x increasing; edge 2 crosses it at an irrational parameter of each."""
    first = [element.point[e] for e in element.indices if e[2] == 0]
    assert all(p[1] == 0 for p in first) and all(p[0] < q[0] for p, q in zip(first, first[1:]))
    side = [element.point[e] for e in element.indices if e[1] == 0]  # corner 0 to corner 2
    x, y = ([Q(c) for c in power_basis([p[r] for p in side])] for r in (0, 1))
    a, b = (Q(t) for t in proof["between"])
    assert zeros.value(y, a) * zeros.value(y, b) < 0
    low, high = zeros.over({(k, 0): c for k, c in enumerate(x)}, (a, b), (Q(0), Q(0)))
    assert first[0][0] < low and high < first[-1][0]
    y = zeros.trim(y)
    scale = 1
    for c in y:
        scale = scale * c.denominator // exact.gcd(scale, c.denominator)
    whole = [int(c * scale) for c in y]
    while not whole[0]:  # a root at 0 is the common corner
        whole, y = whole[1:], y[1:]
    candidates = (Q(sign * p, q) for p in divisors(abs(whole[0])) for q in divisors(abs(whole[-1])) for sign in (1, -1))
    assert 3 <= len(y) <= 4 and not any(zeros.value(y, r) == 0 for r in candidates), "a rational crossing"
    assert len(zeros.trim(zeros.remainder(x, y))) > 1  # so x there is irrational too, and the parameter on edge 0
    return f"y of edge 2 changes its sign between {a} and {b} (from corner 0), and has no rational root there."


def power_basis(points):
    n = len(points) - 1
    return [sum(exact.comb(n, i) * exact.comb(i, j) * (-1) ** (i - j) * points[j] for j in range(i + 1)) for i in range(n + 1)]


def divisors(n):
    small = [d for d in range(1, int(n ** 0.5) + 2) if n % d == 0]
    return sorted(set(small + [n // d for d in small]))


def check(element, proof, expect):
    if proof["contact"] == "ring":
        return ring(element, proof, expect)
    return {"crossing": crossing, "cube": cube, "line": line}[proof["contact"]](element, proof)
