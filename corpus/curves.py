"""Exact statements about rational Bezier curves: apart, simple, crossing, equal up to reparametrisation, winding.

A curve is a list of homogeneous control points (w x, w y, w), w > 0, as Fractions. Nothing of the C++ library is used.
"""
from fractions import Fraction as Q
from functools import lru_cache
from math import comb


def curve(points, weights=None):
    return tuple((w * p[0], w * p[1], w) for p, w in zip(points, weights or [Q(1)] * len(points)))


def reverse(c):
    return tuple(c[::-1])


@lru_cache(maxsize=200000)
def split(c, t=Q(1, 2)):
    left, right, level = [c[0]], [c[-1]], c
    while len(level) > 1:
        level = [tuple((1 - t) * x + t * y for x, y in zip(a, b)) for a, b in zip(level, level[1:])]
        left.append(level[0])
        right.append(level[-1])
    return tuple(left), tuple(right[::-1])


def part(c, a, b):
    """The piece of a curve between two parameters a < b."""
    c = split(c, Q(b))[0]
    return split(c, Q(a) / Q(b))[1] if a else c


@lru_cache(maxsize=200000)
def net(c):
    return tuple((x / w, y / w) for x, y, w in c)


def point(c, t):
    return net(split(c, Q(t))[0])[-1]


def elevate(c, factor=(Q(1), Q(1))):
    """The curve times the linear polynomial factor[0] (1-t) + factor[1] t > 0: one degree more, the same image."""
    n = len(c)
    result = []
    for i in range(n + 1):
        a = [factor[0] * (n - i) / Q(n) * x for x in c[i]] if i < n else [Q(0)] * 3
        b = [factor[1] * i / Q(n) * x for x in c[i - 1]] if i else [Q(0)] * 3
        result.append(tuple(x + y for x, y in zip(a, b)))
    return tuple(result)


def reparametrised(c, r, scale=Q(1)):
    """Control points times scale * r^i: a projective reparametrisation."""
    return tuple(tuple(scale * Q(r) ** i * x for x in p) for i, p in enumerate(c))


# ---- polynomials in one variable, for equality ---------------------------------------------------------------

def monomial(c):
    """The three coordinates as coefficients of powers of t, the constant first."""
    n = len(c) - 1
    return [[sum(comb(n, i) * comb(i, j) * (-1) ** (i - j) * c[j][k] for j in range(i + 1)) for i in range(n + 1)]
            for k in range(3)]


def trim(p):
    while p and p[-1] == 0:
        p = p[:-1]
    return p


def divide(p, q):
    p, result = list(p), []
    while len(p) >= len(q):
        factor = p[-1] / q[-1]
        result.append(factor)
        for i in range(len(q)):
            p[len(p) - len(q) + i] -= factor * q[i]
        p.pop()
    return result[::-1], trim(p)


def divisor(p, q):
    """A greatest common divisor."""
    while q:
        p, q = q, (divide(p, q)[1] if len(p) >= len(q) else p)
    return p


def reduced(c):
    """Primitive control points of the lowest degree: common polynomial factors of X, Y, W removed, first weight 1."""
    f = [trim(p) for p in monomial(c)]
    g = []
    for p in f:
        g = divisor(g, p)
    if len(g) > 1:
        f = [divide(p, g)[0] if p else [] for p in f]
    n = max(map(len, f)) - 1
    f = [p + [Q(0)] * (n + 1 - len(p)) for p in f]
    control = [tuple(sum(Q(comb(i, j), comb(n, j)) * p[j] for j in range(i + 1)) for p in f) for i in range(n + 1)]
    return tuple(tuple(x / control[0][2] for x in p) for p in control)


def equal(a, b):
    """Equal as curves from the first to the last point, up to degree, common factors and projective reparametrisation."""
    a, b = reduced(a), reduced(b)
    if len(a) != len(b):
        return False
    if len(a) == 1:
        return a == b
    r = next(y / x for x, y in zip(a[1], b[1]) if x)  # b_i = r^i a_i
    if r <= 0:
        return False
    return b == reparametrised(a, r)


# ---- separation ----------------------------------------------------------------------------------------------

def sub(a, b):
    return a[0] - b[0], a[1] - b[1]


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1]


def parted_along(a, b, d):
    x, y = [dot(p, d) for p in a], [dot(p, d) for p in b]
    return max(x) < min(y) or max(y) < min(x)


def nets_apart(a, b):
    ends = sub(a[-1], a[0]), sub(b[-1], b[0]), sub(b[0], a[0])
    return any(parted_along(a, b, d) for d in [(1, 0), (0, 1)] + [(-e[1], e[0]) for e in ends] + list(ends))


def apart(a, b, depth=40):
    """No common point; False if not shown."""
    if nets_apart(net(a), net(b)):
        return True
    if depth == 0:
        return False
    if size(a) < size(b):
        a, b = b, a
    return all(apart(half, b, depth - 1) for half in split(a))


def size(c):
    xs, ys = zip(*net(c))
    return max(max(xs) - min(xs), max(ys) - min(ys))


def cone(points):
    """The extreme vectors (right, left) of a cone narrower than half a turn, or None."""
    vectors = [v for v in (sub(p, points[0]) for p in points) if v != (0, 0)]
    for right in vectors:
        if all(cross(right, v) > 0 or cross(right, v) == 0 and dot(right, v) > 0 for v in vectors):
            left = right
            for v in vectors:
                left = v if cross(left, v) > 0 else left
            return right, left
    return None


def apart_but_start(a, b, depth=40):
    """Two curves from one point meet nowhere else; False if not shown (so for tangent curves)."""
    p, q = cone(net(a)), cone(net(b))
    if p and q:
        def inside(v, c):
            return cross(c[0], v) >= 0 and cross(v, c[1]) >= 0 and (dot(c[0], v) > 0 or dot(c[1], v) > 0)
        if not (inside(p[0], q) or inside(p[1], q) or inside(q[0], p) or inside(q[1], p)):
            return True
    if depth == 0:
        return False
    (near_a, far_a), (near_b, far_b) = split(a), split(b)
    return apart_but_start(near_a, near_b, depth - 1) and apart(far_a, far_b) and apart(far_a, near_b) and \
        apart(near_a, far_b)


def simple(c, depth=20):
    """A curve without double points; False if not shown."""
    p = net(c)
    chord = sub(p[-1], p[0])
    if all(dot(chord, sub(y, x)) > 0 for x, y in zip(p, p[1:])):
        return True
    if depth == 0:
        return False
    left, right = split(c)
    return simple(left, depth - 1) and simple(right, depth - 1) and apart_but_start(reverse(left), right)


def simple_loop(curves):
    """Consecutive curves form a simple closed curve; False if not shown."""
    n = len(curves)
    if not all(simple(c) for c in curves):
        return False
    for i in range(n):
        for j in range(i + 1, n):
            a, b = curves[i], curves[j]
            after, before = j == i + 1, (j + 1) % n == i
            if after and before:
                (a0, a1), (b0, b1) = split(a), split(b)
                good = (apart_but_start(reverse(a1), b0) and apart_but_start(a0, reverse(b1)) and apart(a0, b0)
                        and apart(a1, b1))
            elif after:
                good = apart_but_start(reverse(a), b)
            elif before:
                good = apart_but_start(a, reverse(b))
            else:
                good = apart(a, b)
            if not good:
                return False
    return True


def crossing(a, b, depth=24):
    """Parameter ranges of two pieces that certainly cross (Poincare-Miranda), or None."""
    def certain(x, y):
        d = sub(y[-1], y[0])  # y runs from side to side along d, x across it
        n = (-d[1], d[0])
        ys, xs = [dot(p, n) for p in y], [dot(p, d) for p in x]
        return (dot(y[0], d) < min(xs) and max(xs) < dot(y[-1], d)
                and (dot(x[0], n) < min(ys) and max(ys) < dot(x[-1], n) or
                     dot(x[-1], n) < min(ys) and max(ys) < dot(x[0], n)))

    level = [(a, (Q(0), Q(1)), b, (Q(0), Q(1)))]
    for _ in range(depth):
        following = []
        for c, s, d, t in level:
            if nets_apart(net(c), net(d)):
                continue
            if certain(net(c), net(d)) or certain(net(d), net(c)):
                return s, t
            if size(c) >= size(d):
                m = (s[0] + s[1]) / 2
                following += [(h, r, d, t) for h, r in zip(split(c), ((s[0], m), (m, s[1])))]
            else:
                m = (t[0] + t[1]) / 2
                following += [(c, s, h, r) for h, r in zip(split(d), ((t[0], m), (m, t[1])))]
        level = following[:400]
    return None


def winding(loop, p):
    """How often a closed loop of curves winds around a point off it."""
    polygon, todo = [], list(loop)
    while todo:
        c = todo.pop(0)
        if any(parted_along(net(c), [p], d) for d in ((1, 0), (0, 1), (1, 1), (1, -1))):
            polygon.append(net(c)[0])
        else:
            todo = list(split(c)) + todo
    total = 0
    for a, b in zip(polygon, polygon[1:] + polygon[:1]):
        if (a[1] <= p[1]) != (b[1] <= p[1]):
            side = cross(sub(b, a), sub(p, a))
            total += 1 if a[1] <= p[1] and side > 0 else -1 if a[1] > p[1] and side < 0 else 0
    return total


def area_under(c):
    """The integral of (x dy - y dx) / 2 along a polynomial curve."""
    x, y = monomial(c)[:2]
    total = Q(0)
    for i, a in enumerate(x):
        for j, b in enumerate(y):
            if i + j:
                total += a * b * Q(j - i, i + j) / 2
    return total
