"""The meshes of corpus/whole: how each is built, what it must be, and why."""
from fractions import Fraction as Q

import curves
from whole_build import Mesh, pt

CASES = {}  # name: (mesh, verdict, words, points where boundaries touch)
DOMAINS = []  # mesh, name of the curves file, [(curve, covered)], words
TINY = Q(1, 10 ** 12)


def case(name, verdict, words, mesh, touching=()):
    assert name not in CASES
    CASES[name] = mesh, verdict, words, touching


def fan(degree=1, bend=0, kind="triangle", at=(0, 0), scale=1):
    """A disc: six triangles or three quadrilaterals around a centre; `bend` moves the inner edge points."""
    m = Mesh()
    centre = m.node(*at)
    rim = [m.node(at[0] + scale * Q(x), at[1] + scale * Q(y)) for x, y in
           ((4, 0), (2, 3), (-2, 3), (-4, 0), (-2, -3), (2, -3))]
    if bend:
        sides = list(zip(rim, rim[1:] + rim[:1])) + [(centre, r) for r in (rim if kind == "triangle" else rim[::2])]
        for k, (a, b) in enumerate(sides):
            bulge(m, a, b, degree, Q(bend) * (1 if k % 2 else -1))
    if kind == "triangle":
        for a, b in zip(rim, rim[1:] + rim[:1]):
            m.triangle(centre, a, b, degree)
    else:
        for k in (0, 2, 4):
            m.quad(centre, rim[k], rim[k + 1], rim[(k + 2) % 6], degree)
    return m


def bulge(m, a, b, degree, size):
    """A curve of that degree from a to b, inner control points off the chord by `size` times its length."""
    (x, y), (z, w) = m.points[a], m.points[b]
    inner = [(x + Q(i, degree) * (z - x) + size * (w - y) * (i if degree > 2 else 1),
              y + Q(i, degree) * (w - y) - size * (z - x) * (1 if i % 2 else -1)) for i in range(1, degree)]
    m.bend(a, b, *inner)


def plate(missing, wide, high, degree, split=False, bend=Q(1, 12), mixed=False):
    """A grid of unit cells with cells missing, all edges curved; cells cut into triangles where `split`."""
    m = Mesh()
    node = {(i, j): m.node(i, j) for j in range(high + 1) for i in range(wide + 1)}
    curved = 2 if mixed else degree
    if curved > 1:
        for (i, j), a in node.items():
            for k, to in enumerate(((i + 1, j), (i, j + 1))):
                if to in node:
                    bulge(m, a, node[to], curved, bend * (1 if (i + j + k) % 2 else -1))
    for j in range(high):
        for i in range(wide):
            if (i, j) in missing:
                continue
            a, b, c, d = node[i, j], node[i + 1, j], node[i + 1, j + 1], node[i, j + 1]
            if split or mixed and (i + j) % 2:
                n = 4 if mixed else degree
                m.triangle(a, b, c, n)
                m.triangle(a, c, d, n)
            else:
                m.quad(a, b, c, d, (3, 2) if mixed else degree)
    return m


ARC = [((1, 0), (1, "4/3"), "3/5"), (("-7/25", "24/25"), (-1, "3/4"), "4/5"), ((-1, 0), (-1, "-4/3"), "3/5"),
       (("7/25", "-24/25"), (1, "-3/4"), "4/5")]


def circle(m, radius, at=(0, 0)):
    """Four nodes of a circle, joined by exact conic arcs."""
    ring = [m.node(*(Q(c) + radius * Q(x) for c, x in zip(at, p))) for p, _, _ in ARC]
    for k, (_, pole, weight) in enumerate(ARC):
        m.bend(ring[k], ring[(k + 1) % 4], [Q(c) + radius * Q(x) for c, x in zip(at, pole)], weights=[weight])
    return ring


def annulus(inner=1, outer=2):
    m = Mesh()
    a, b = circle(m, Q(outer)), circle(m, Q(inner))
    for k in range(4):
        m.quad(a[k], a[(k + 1) % 4], b[(k + 1) % 4], b[k], (2, 1))
    return m


def disc(radius=1, at=(0, 0)):
    m = Mesh()
    centre, ring = m.node(*at), circle(m, Q(radius), at)
    for k in range(4):
        m.triangle(centre, ring[k], ring[(k + 1) % 4], 2)
    return m


def polygon_strip(inner, outer, degree=(1, 1)):
    """Quadrilaterals between two rows of points, counter-clockwise; equal positions are different nodes."""
    m = Mesh()
    a, b = [m.node(*p) for p in inner], [m.node(*p) for p in outer]
    for k in range(len(a) - 1):
        m.quad(a[k], b[k], b[k + 1], a[k + 1], degree)
    return m


COMPASS = [(Q(1), Q(0)), (Q(7, 10), Q(7, 10)), (Q(0), Q(1)), (Q(-7, 10), Q(7, 10)), (Q(-1), Q(0)), (Q(-7, 10), Q(-7, 10)),
           (Q(0), Q(-1)), (Q(7, 10), Q(-7, 10))]


def spiral(steps, growth, start=2, thick=1, degree=(1, 1)):
    radius = [start + growth * k for k in range(steps + 1)]
    where = [COMPASS[k % 8] for k in range(steps + 1)]
    return polygon_strip([(r * x, r * y) for r, (x, y) in zip(radius, where)],
                         [((r + thick) * x, (r + thick) * y) for r, (x, y) in zip(radius, where)], degree)


def ring_with_end(first, last):
    """Seven quadrilaterals of a ring and one whose end edge is `last` (inner, outer); `first` is the start edge."""
    inner = [first[0]] + [(2 * x, 2 * y) for x, y in COMPASS[1:]] + [last[0]]
    outer = [first[1]] + [(3 * x, 3 * y) for x, y in COMPASS[1:]] + [last[1]]
    return polygon_strip(inner, outer)


def two_on_edge(first, second, degree=2, quads=False, node_positions=((0, 0), (4, 0))):
    """Two elements on the edge a b, below (first curve) and above (second curve), with inner edge nodes of their own.

    Curves are lists of homogeneous control points from a to b."""
    m = Mesh()
    a, b = (m.node(*p) for p in node_positions)
    n, k = len(first) - 1, len(second) - 1
    if quads:
        c, d, e, f = m.nodes("0,-4 4,-4 4,4 0,4")
        m.quad(c, d, b, a, (n, 1), {(a, b): tuple(first)}, 1)
        m.quad(a, b, e, f, (k, 1), {(a, b): tuple(second)}, 2)
        return m
    c, d = m.nodes("2,-4 2,4")
    m.triangle(b, a, c, n, {(b, a): curves.reverse(tuple(first))}, 1)
    m.triangle(a, b, d, k, {(a, b): tuple(second)}, 2)
    return m


def polynomial(*points):
    return curves.curve([pt(*p.split(",")) if isinstance(p, str) else pt(*p) for p in points])


def hang(curve, t, degree):
    """A big element above the curve a b, two below it on its pieces a m and m b, and others all around a and b."""
    left, right = curves.split(curve, Q(t))
    p = curves.net(left)[-1]
    m = Mesh()
    a, b = (m.node(*curves.net(curve)[k], curve[k][2]) for k in (0, -1))
    middle = m.node(*p, left[-1][2])
    top, low, side, other, left_end, right_end = m.nodes("2,4 2,-4 -1,-4 5,-4 -3,0 7,0")
    m.triangle(a, b, top, degree, {(a, b): curve})
    m.lay(a, middle, left)
    m.lay(middle, b, right)
    for p, q, r in ((middle, a, side), (middle, side, low), (middle, low, other), (b, middle, other),
                    (a, top, left_end), (a, left_end, side), (b, right_end, top), (b, other, right_end)):
        m.triangle(p, q, r, degree)
    return m


def slit(curve=None, degree=1, open_end=False, weight=1):
    """A rectangle with a crack: nodes a, m, b on it; m is doubled, and a where the crack reaches the boundary."""
    m = Mesh()
    L, a, b, R, TL, T, TR, BL, B, BR = m.nodes("0,0 1,0 3,0 4,0 0,2 2,3 4,2 0,-2 2,-3 4,-2")
    up, down = m.node(2, curve or 0), m.node(2, curve or 0)
    L2, a2 = (m.node(0, 0), m.node(1, 0)) if open_end else (L, a)
    if curve:
        for x in (up, down):
            m.bend(a if x == up else a2, x, ("5/4", Q(curve)), weights=[weight])
            m.bend(x, b, ("11/4", Q(curve)), weights=[weight])
    for p, q, r in ((L, a, TL), (a, T, TL), (a, up, T), (up, b, T), (b, TR, T), (b, R, TR),
                    (a2, L2, BL), (a2, BL, B), (down, a2, B), (b, down, B), (b, B, BR), (R, b, BR)):
        m.triangle(p, q, r, degree)
    return m


def around(points, closed=False, degree=1, bend=None, weights=None):
    """Triangles around the node at the origin; bend: {index: control point of the edge from the origin}."""
    m = Mesh()
    centre = m.node(0, 0)
    rim = [m.node(*p) for p in points]
    for k, p in (bend or {}).items():
        m.bend(centre, rim[k], p, weights=weights)
    for a, b in zip(rim, rim[1:] + (rim[:1] if closed else [])):
        m.triangle(centre, a, b, degree)
    return m


def around_quads(points, corners, closed=False):
    """The same with quadrilaterals: corners[k] lies outwards between points k and k + 1."""
    m = Mesh()
    centre = m.node(0, 0)
    rim, far = [m.node(*p) for p in points], [m.node(*p) for p in corners]
    n = len(rim)
    for k in range(n if closed else n - 1):
        m.quad(centre, rim[k], far[k], rim[(k + 1) % n], 2)
    return m
