"""Curves: SELF, PAIR, MEET (certificate-format.md, "INJECTIVE", "MEET"). A curve is a list of homogeneous control points (x, y, w)."""
from collections import namedtuple
from fractions import Fraction as Q
from math import comb

import polynomials as P
from tokens import require, well


def halves(c):
    left, right, row = [c[0]], [c[-1]], list(c)
    while len(row) > 1:
        row = [tuple((a + b) / 2 for a, b in zip(p, q)) for p, q in zip(row, row[1:])]
        left.append(row[0])
        right.append(row[-1])
    return left, right[::-1]


def polar(c, parameters):
    row = list(c)
    for t in parameters:
        row = [tuple(a + t * (b - a) for a, b in zip(p, q)) for p, q in zip(row, row[1:])]
    return row[0]


def restricted(c, low, high):
    n = len(c) - 1
    return [polar(c, [low] * (n - i) + [high] * i) for i in range(n + 1)]


def affine(p):
    return Q(p[0]) / p[2], Q(p[1]) / p[2]


def point(c, t):
    return affine(polar(c, [Q(t)] * (len(c) - 1)))


def dot(n, p):
    return n[0] * p[0] + n[1] * p[1]


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def minus(a, b):
    return a[0] - b[0], a[1] - b[1]


def check_self(tokens, c, depth=0):
    well(depth <= 512, "too deep")
    if tokens.rule(["m", "h"]) == "m":
        n = tokens.integer(), tokens.integer()
        z = [dot(n, affine(p)) for p in c]
        require(all(a < b for a, b in zip(z, z[1:])), "m")
        return
    a, b = halves(c)
    check_self(tokens, a, depth + 1)
    check_self(tokens, b, depth + 1)
    check_pair(tokens, a, b, {"eb"})


def check_pair(tokens, a, b, joints, depth=0):
    """joints: subset of {"eb": the end of a with the beginning of b, "be": the beginning of a with the end of b}."""
    well(depth <= 512, "too deep")
    rule = tokens.rule(["s", "j", "a", "b", "r"])
    if rule == "s":
        n = tokens.integer(), tokens.integer()
        require(not joints, "s: joint")
        require(max(dot(n, affine(p)) for p in a) < min(dot(n, affine(p)) for p in b), "s")
    elif rule == "j":
        n = tokens.integer(), tokens.integer()
        require(len(joints) == 1, "j: joints")
        rest_a, rest_b = (a[:-1], b[1:]) if "eb" in joints else (a[:0:-1], b[-2::-1])
        q = affine(a[-1] if "eb" in joints else a[0])
        require(q == affine(b[0] if "eb" in joints else b[-1]), "j: not one point")
        za = [dot(n, minus(affine(p), q)) for p in rest_a]
        zb = [dot(n, minus(affine(p), q)) for p in rest_b]
        require(all(z <= 0 for z in za) and all(z >= 0 for z in zb), "j")
        require(za[0] < 0 and zb[-1] > 0, "j: ends")
    elif rule in "ab":
        first, second = halves(a if rule == "a" else b)
        if rule == "a":
            check_pair(tokens, first, b, joints - {"eb"}, depth + 1)
            check_pair(tokens, second, b, joints - {"be"}, depth + 1)
        else:
            check_pair(tokens, a, first, joints - {"be"}, depth + 1)
            check_pair(tokens, a, second, joints - {"eb"}, depth + 1)
    else:
        require(len(joints) <= 1, "r: joints")
        if "eb" in joints:
            a = a[::-1]
        if "be" in joints:
            b = b[::-1]
        r = contact_resultant(a, b)
        require(r, "r: zero")
        if joints:
            while r[0] == 0:
                r = r[1:]
        c = P.bernstein1(r)
        require(all(x > 0 for x in c) or all(x < 0 for x in c), "r")


def components(c, variable):
    """X, Y, W of a curve as polynomials in (s, t); the parameter is `variable`."""
    rows = [P.from_bernstein1([p[k] for p in c]) for k in range(3)]
    return [P.clean({((i, 0) if variable == 0 else (0, i)): Q(x) for i, x in enumerate(row)}) for row in rows]


def contact_polynomials(a, b):
    xa, ya, wa = components(a, 0)
    xb, yb, wb = components(b, 1)
    F = P.add2(P.mul2(xa, wb), P.mul2(xb, wa), -1)
    G = P.add2(P.mul2(ya, wb), P.mul2(yb, wa), -1)
    return F, G


def contact_resultant(a, b):
    F, G = contact_polynomials(a, b)
    n = max(P.degree2(F, 1), P.degree2(G, 1))
    return P.resultant_v(F, n, G, n)


def check_boundary(tokens, edges):
    for c in edges:
        check_self(tokens, c)
    m = len(edges)
    for i in range(m):
        for j in range(i + 1, m):
            check_pair(tokens, edges[i], edges[j], ({"eb"} if j == i + 1 else set()) | ({"be"} if (j + 1) % m == i else set()))


def check_root(m, low, high):
    require(len(m) >= 3, "root: degree")
    require(low < high, "root: interval")
    require(P.value1(m, low) * P.value1(m, high) < 0, "root: signs")


def nonnegative(f, m, low, high):
    return P.divides(m, f) or all(c >= 0 for c in P.bernstein1(f, low, high))


Meet = namedtuple("Meet", "kind first second numbers")


def read_meet(tokens, in_mesh, edges=4):
    kind = tokens.rule(["at", "root", "cross"])
    numbers = [tokens.polynomial(), tokens.rational(), tokens.rational()] if kind == "root" else []
    if kind == "root":
        check_root(*numbers)
    places = []
    for _ in range(2):
        places.append(tokens.edge() if in_mesh else (0, tokens.small(0, edges - 1)))
        if kind == "at":
            numbers.append(tokens.rational())
        elif kind == "root":
            numbers.append(tokens.rational_polynomial())
        else:
            numbers += [tokens.rational(), tokens.rational()]
    return Meet(kind, *places, numbers)


def end_parameter(s, i):
    """The distance of the polynomial or number s from the end i."""
    return (P.add1([Q(1)], s, -1) if i else s) if isinstance(s, list) else (1 - s if i else s)


def one_strict_sign(f, low, high):
    c = P.bernstein1(f, low, high)
    return all(x > 0 for x in c) or all(x < 0 for x in c)


def check_meet(meet, a, b, same, common):
    """common: pairs (i, j) of ends that are one point of the domain."""
    x = meet.numbers
    if meet.kind == "at":
        s, t = x
        require(0 <= s <= 1 and 0 <= t <= 1, "at: parameters")
        require(point(a, s) == point(b, t), "at: images")
        require(not (same and s == t), "at: one point")
        require(not any(s == i and t == j for i, j in common), "at: common corner")
    elif meet.kind == "root":
        m, low, high, s, t = x
        for F in contact_polynomials(a, b):
            require(P.divides(m, P.compose21(F, s, t)), "root: images")
        for f in (s, t):
            for i in (0, 1):
                require(nonnegative(end_parameter(f, i), m, low, high), "root: parameters")
        if same:
            require(one_strict_sign(P.add1(s, t, -1), low, high), "root: one point")
        for i, j in common:
            require(one_strict_sign(end_parameter(s, i), low, high) or one_strict_sign(end_parameter(t, j), low, high), "root: corner")
    else:
        s0, s1, t0, t1 = x
        require(0 <= s0 < s1 <= 1 and 0 <= t0 < t1 <= 1, "cross: intervals")
        A, B = ([affine(p) for p in restricted(c, *i)] for c, i in ((a, (s0, s1)), (b, (t0, t1))))
        d = minus(A[-1], A[0])
        require(d != (0, 0), "cross: d")
        e = (-d[1], d[0])
        require(all(dot(d, A[0]) <= dot(d, p) <= dot(d, A[-1]) for p in B), "cross: along")
        low, high = dot(e, B[0]), dot(e, B[-1])
        require(all(low <= dot(e, p) <= high for p in A) or all(high <= dot(e, p) <= low for p in A), "cross: across")
        require(not same or s1 < t0 or t1 < s0, "cross: one edge")
        for i, j in common:
            require(not ((s1 == 1 if i else s0 == 0) and (t1 == 1 if j else t0 == 0)), "cross: common corner")
