"""Finds evidence for the examples: trees, columns, directions. Simple searches; check.py holds the result against the rules."""
from fractions import Fraction as Q
from math import gcd

import polynomials as P
from curves import affine, contact_resultant, dot, halves, minus
from element_rules import coefficients_hold, columns_polynomials, cut, slab_holds, whole
from tokens import text_of_polynomial, text_of_rational_polynomial

DIRECTIONS = sorted(((x, y) for x in range(-12, 13) for y in range(-12, 13) if gcd(x, y) == 1), key=lambda n: (n[0] ** 2 + n[1] ** 2, n))


def primitive(f):
    d = 1
    for c in f:
        d = d * Q(c).denominator // gcd(d, Q(c).denominator)
    f = [int(c * d) for c in f]
    g = gcd(*f)
    return [c // g for c in f]


def tree(f, triangle, degree, strict=True, deepest=14):
    def walk(piece, depth):
        if coefficients_hold(f, piece, triangle, degree, strict):
            return "0"
        assert depth < deepest, "no tree found"
        return "1" + "".join(walk(half, depth + 1) for half in cut(piece, triangle, depth))
    return walk(whole(triangle), 0)


def sign(f, triangle, degree, strict=True):
    bits = tree(f, triangle, degree, strict)
    return "coefficients" if bits == "0" else "tree " + bits


def coprime_base(polynomials):
    base = []
    work = [primitive(f) for f in polynomials if len(f) > 1]
    while work:
        f = work.pop()
        if len(f) <= 1:
            continue
        for i, g in enumerate(base):
            h = P.gcd1(f, g)
            if len(h) > 1:
                del base[i]
                if primitive(f) != primitive(g) or len(h) < len(f):
                    work += [primitive(x) for x in (P.divmod1(f, h)[0], P.divmod1(g, h)[0], h)]
                else:
                    base.append(g)
                break
        else:
            h = P.gcd1(f, P.derivative1(f))
            if len(h) > 1:
                work += [primitive(P.divmod1(f, h)[0]), primitive(h)]
            else:
                base.append(f)
    return sorted(base, key=lambda f: (len(f), f))


def column_factors(f, variable, triangle):
    polynomials = columns_polynomials(P.swap2(f) if variable == "v" else f, triangle)
    assert all(polynomials), "one of the four is 0"
    base = coprime_base(polynomials)
    rows = []
    for g in polynomials:
        row = []
        for s in base:
            row.append(0)
            while P.divides(s, g):
                g, row[-1] = P.divmod1(g, s)[0], row[-1] + 1
        assert len(g) == 1
        rows.append(",".join(map(str, row)) or "-")
    return base, rows


def columns(f, variable, triangle, cs, strict):
    """`columns` with the given columns; a piece that is not open or root is a slab."""
    base, rows = column_factors(f, variable, triangle)
    if variable == "v":
        f = P.swap2(f)
    c = [Q(0)] + [Q(x) for x in cs] + [Q(1)]
    pieces = []
    for i in range(len(cs) + 1):
        var = sum(P.sign_changes(P.bernstein1(s, c[i], c[i + 1])) for s in base)
        end = i in (0, len(cs))
        if var == 0 and not (strict and end and any(P.value1(s, Q(0 if i == 0 else 1)) == 0 for s in base)):
            pieces.append("open")
        elif not strict and not end and var == 1:
            pieces.append("root")
        else:
            assert strict and slab_holds(f, triangle, c[i], c[i + 1]), f"piece {i}: {var} changes"
            pieces.append("slab")
    words = ["columns", variable, str(len(base))] + [text_of_polynomial(s) for s in base] + rows
    return " ".join(words + [str(len(cs))] + [str(x) for x in c[1:-1]] + pieces)


def self_evidence(c, depth=0):
    p = [affine(x) for x in c]
    for n in DIRECTIONS:
        z = [dot(n, x) for x in p]
        if all(a < b for a, b in zip(z, z[1:])):
            return "m %d %d" % n
    assert depth < 8, "no SELF found"
    a, b = halves(c)
    return " ".join(["h", self_evidence(a, depth + 1), self_evidence(b, depth + 1), pair_evidence(a, b, {"eb"})])


def direction(a, b, joints):
    pa, pb = [affine(x) for x in a], [affine(x) for x in b]
    for n in DIRECTIONS:
        if not joints:
            if max(dot(n, x) for x in pa) < min(dot(n, x) for x in pb):
                return "s %d %d" % n
        elif len(joints) == 1:
            eb = "eb" in joints
            q = pa[-1] if eb else pa[0]
            za, zb = [dot(n, minus(x, q)) for x in pa], [dot(n, minus(x, q)) for x in pb]
            if max(za) <= 0 <= min(zb) and za[0 if eb else -1] < 0 < zb[-1 if eb else 0]:
                return "j %d %d" % n
    return None


def pair_evidence(a, b, joints, depth=0):
    found = direction(a, b, joints)
    if found:
        return found
    assert depth < 12, "no PAIR found"
    size = lambda c: sum(abs(x) + abs(y) for x, y in (minus(affine(p), affine(c[0])) for p in c))
    if size(a) >= size(b):
        x, y = halves(a)
        return " ".join(["a", pair_evidence(x, b, joints - {"eb"}, depth + 1), pair_evidence(y, b, joints - {"be"}, depth + 1)])
    x, y = halves(b)
    return " ".join(["b", pair_evidence(a, x, joints - {"be"}, depth + 1), pair_evidence(a, y, joints - {"eb"}, depth + 1)])


def boundary(element):
    edges = [element.edge(e) for e in range(element.edges)]
    m = len(edges)
    words = ["boundary"] + [self_evidence(c) for c in edges]
    words += [pair_evidence(edges[i], edges[j], ({"eb"} if j == i + 1 else set()) | ({"be"} if (j + 1) % m == i else set()))
              for i in range(m) for j in range(i + 1, m)]
    return " ".join(words)


def mesh_pairs(mesh):
    """The `pair` lines that an embedding needs."""
    from mesh_rules import box
    uses = sorted(u for u in mesh.uses if u not in mesh.mate)
    boxes, lines = {u: box(mesh.curve[u]) for u in uses}, []
    for i, u in enumerate(uses):
        for w in uses[i + 1:]:
            if u[0] == w[0] or not all(a[0] <= b[1] and b[0] <= a[1] for a, b in zip(boxes[u], boxes[w])):
                continue
            joints = ({"eb"} if mesh.follower(u) == w else set()) | ({"be"} if mesh.follower(w) == u else set())
            lines.append(f"pair {u[0] + 1}.{u[1]} {w[0] + 1}.{w[1]} " + pair_evidence(mesh.curve[u], mesh.curve[w], joints))
    return lines


def tempting_self(c, depth):
    """SELF that lies only where it must: at the pieces of the given depth."""
    try:
        return self_evidence(c, 6)
    except AssertionError:
        pass
    if depth == 0:
        return "m 1 0"
    a, b = halves(c)
    return " ".join(["h", tempting_self(a, depth - 1), tempting_self(b, depth - 1), tempting_pair(a, b, {"eb"}, depth - 1)])


def tempting_pair(a, b, joints, depth, last=None):
    found = direction(a, b, joints)
    if found:
        return found
    if depth <= 0:
        return last or ("j 1 0" if joints else "s 1 0")
    size = lambda c: sum(abs(x) + abs(y) for x, y in (minus(affine(p), affine(c[0])) for p in c))
    if size(a) >= size(b):
        x, y = halves(a)
        return " ".join(["a", tempting_pair(x, b, joints - {"eb"}, depth - 1, last), tempting_pair(y, b, joints - {"be"}, depth - 1, last)])
    x, y = halves(b)
    return " ".join(["b", tempting_pair(a, x, joints - {"be"}, depth - 1, last), tempting_pair(a, y, joints - {"eb"}, depth - 1, last)])


def tempting_boundary(element, depth=6, last=None):
    edges = [element.edge(e) for e in range(element.edges)]
    m = len(edges)
    return " ".join(["boundary"] + [tempting_self(c, depth) for c in edges] + [
        tempting_pair(edges[i], edges[j], ({"eb"} if j == i + 1 else set()) | ({"be"} if (j + 1) % m == i else set()), depth, last)
        for i in range(m) for j in range(i + 1, m)])
