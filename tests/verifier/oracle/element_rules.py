"""The claims of one element, by the letter of certificate-format.md."""
from fractions import Fraction as Q
from itertools import combinations

import polynomials as P
from curves import check_boundary, check_meet, check_root, cross, nonnegative, read_meet
from tokens import Rejected, integer, require, well

ONE = {(0, 0): Q(1)}



def restrict(f, piece, triangle):
    if triangle:
        (ax, ay), (bx, by), (cx, cy) = piece
        return P.substitute2(f, P.linear2(ax, bx - ax, cx - ax), P.linear2(ay, by - ay, cy - ay))
    (u0, u1), (v0, v1) = piece
    return P.substitute2(f, P.linear2(u0, u1 - u0, 0), P.linear2(v0, 0, v1 - v0))


def whole(triangle):
    return ((Q(0), Q(0)), (Q(1), Q(0)), (Q(0), Q(1))) if triangle else ((Q(0), Q(1)), (Q(0), Q(1)))


def cut(piece, triangle, depth):
    if triangle:
        a, b, c = piece
        m = ((a[0] + b[0]) / 2, (a[1] + b[1]) / 2)
        return (c, a, m), (b, c, m)
    (u0, u1), (v0, v1) = piece
    if depth % 2 == 0:
        return ((u0, (u0 + u1) / 2), (v0, v1)), (((u0 + u1) / 2, u1), (v0, v1))
    return ((u0, u1), (v0, (v0 + v1) / 2)), ((u0, u1), ((v0 + v1) / 2, v1))


def own_degree(f, triangle):
    return P.total2(f) if triangle else (P.degree2(f, 0), P.degree2(f, 1))


def coefficients_hold(f, piece, triangle, degree, strict):
    g = restrict(f, piece, triangle)
    if triangle:
        b, corners = P.triangle_bernstein(g, degree), [(0, 0), (degree, 0), (0, degree)]
    else:
        p, q = degree
        b, corners = P.square_bernstein(g, p, q), [(0, 0), (p, 0), (0, q), (p, q)]
    return all(c >= 0 for c in b.values()) and (not strict or all(b[k] > 0 for k in corners))


def check_tree(f, bits, triangle, degree, strict):
    at, failed = 0, False

    def walk(piece, depth):
        nonlocal at, failed
        well(at < len(bits), "BITS end early")
        well(depth <= 512, "too deep")
        bit = bits[at]
        at += 1
        if bit == "1":
            for half in cut(piece, triangle, depth):
                walk(half, depth + 1)
        elif not failed:
            failed = not coefficients_hold(f, piece, triangle, degree, strict)

    walk(whole(triangle), 0)
    well(at == len(bits), "more BITS than one tree")
    well(bits != "0", "a tree without a cut")
    require(not failed, "tree: a leaf fails")


def check_sign(tokens, f, triangle, degree, strict, nested=False):
    rule = tokens.rule(["coefficients", "tree", "columns"] + ([] if nested else ["factors"]))
    if rule == "coefficients":
        require(coefficients_hold(f, whole(triangle), triangle, degree, strict), "coefficients")
    elif rule == "tree":
        check_tree(f, tokens.bits(), triangle, degree, strict)
    elif rule == "factors":
        check_factors(tokens, f, triangle, strict)
    else:
        check_columns(tokens, f, triangle, strict)


def check_factors(tokens, f, triangle, strict):
    k = tokens.small(1, 4096)
    product, sign, wrong = ONE, 1, None
    for _ in range(k):
        e, h = tokens.small(1, 4096), tokens.polynomial2()
        proof = tokens.rule(["none", "+", "-"])
        try:
            if proof == "none":
                require(e % 2 == 0 and not strict, "none")
            else:
                check_sign(tokens, h if proof == "+" else P.scale2(h, -1), triangle, own_degree(h, triangle), strict, True)
        except Rejected as error:
            wrong = error
            raise
        if proof == "-" and e % 2:
            sign = -sign
        for _ in range(e):
            require(P.total2(product) <= P.total2(f), "factors: degree")
            product = P.mul2(product, h)
    key = next(iter(product))
    c = f.get(key, Q(0)) / product[key]
    require(c != 0 and P.scale2(product, c) == f, "factors: the product is not f")
    require(sign * c > 0, "factors: sign")


def columns_polynomials(f, triangle):
    """l, b, t, r; None if f does not depend on v."""
    n = P.degree2(f, 1)
    if n == 0:
        return None
    l, b = P.coefficient_of_v(f, n), P.coefficient_of_v(f, 0)
    t = P.compose21(f, [Q(0), Q(1)], [Q(1), Q(-1)] if triangle else [Q(1)])
    r = l if n == 1 else P.resultant_v(f, n, P.diff2(f, 1), n - 1)
    return l, b, t, r


def positive_on_segment(g, low, high, limit):
    work, count = [(low, high)], 0
    while work:
        a, b = work.pop()
        c = P.bernstein1(g, a, b)
        if all(x >= 0 for x in c) and c[0] > 0 and c[-1] > 0:
            count += 1
            continue
        if c[0] <= 0 or c[-1] <= 0 or count + len(work) + 2 > limit:
            return False
        work += [((a + b) / 2, b), (a, (a + b) / 2)]
    return True


def check_columns(tokens, f, triangle, strict):
    if tokens.rule(["u", "v"]) == "v":
        f = P.swap2(f)
    m = tokens.small(0, 4096)
    factors = [tokens.polynomial() for _ in range(m)]
    well(all(len(s) >= 2 for s in factors), "columns: a constant factor")
    exponents = []
    for _ in range(4):
        word = tokens.word()
        if m == 0:
            well(word == "-", "exponents")
            exponents.append([])
        else:
            parts = word.split(",")
            exponents.append([integer(x) for x in parts])
            well(len(parts) == m and all(x >= 0 for x in exponents[-1]), "exponents")
    k = tokens.small(1, 65536)
    columns = [tokens.rational() for _ in range(k)]
    pieces = []
    for _ in range(k + 1):
        pieces.append(tokens.rule(["open", "root"] + (["slab"] if strict else [])))
    polynomials = columns_polynomials(f, triangle)
    require(polynomials is not None, "columns: degree 0")
    for g, e in zip(polynomials, exponents):
        require(g, "columns: zero")
        for s, count in zip(factors, e):
            for _ in range(count):
                g, rest = P.divmod1(g, s)
                require(not rest, "columns: exponents")
        require(len(g) == 1, "columns: a factor is missing")
    c = [Q(0)] + columns + [Q(1)]
    require(all(a < b for a, b in zip(c, c[1:])), "columns: order")
    top = lambda u: 1 - u if triangle else Q(1)
    for u in columns:
        require(all(P.value1(s, u) != 0 for s in factors), "columns: a root")
        require(positive_on_segment(P.compose21(f, [u], [Q(0), Q(1)]), Q(0), top(u), 4096), "columns: f on a column")
    for i, word in enumerate(pieces):
        var = sum(P.sign_changes(P.bernstein1(s, c[i], c[i + 1])) for s in factors)
        if word == "open":
            require(var == 0, "open: var")
            if strict and i in (0, k):
                require(all(P.value1(s, Q(0 if i == 0 else 1)) != 0 for s in factors), "open: end")
        elif word == "root":
            require(not strict and 1 <= i <= k - 1 and var <= 1, "root")
        else:
            require(slab_holds(f, triangle, c[i], c[i + 1]), "slab")


def slab_holds(f, triangle, low, high):
    u = P.linear2(low, high - low, 0)
    g = P.substitute2(f, u, P.mul2({(0, 1): Q(1)}, P.add2(ONE, u, -1) if triangle else ONE))
    degree, work, pieces = own_degree(g, False), [(Q(0), Q(1))], 0
    while work:
        t0, t1 = work.pop()
        pieces += 1
        if pieces > 200:  # the rule says 4096; none of the examples comes near
            return False
        if not coefficients_hold(g, ((Q(0), Q(1)), (t0, t1)), False, degree, True):
            work += [((t0 + t1) / 2, t1), (t0, (t0 + t1) / 2)]
    return True


def in_domain_values(u, v, triangle):
    one = [Q(1)]
    return [u, v, P.add1(P.add1(one, u, -1), v, -1)] if triangle else [u, v, P.add1(one, u, -1), P.add1(one, v, -1)]


def check_zero(tokens, element, wanted=lambda n: n == 0):
    rule = tokens.rule(["at", "root"])
    if rule == "at":
        u, v = tokens.rational(), tokens.rational()
        require(element.contains(u, v), "at: outside")
        require(wanted(P.value2(element.N, u, v)), "at: N")
        return
    m, low, high = tokens.polynomial(), tokens.rational(), tokens.rational()
    check_root(m, low, high)
    u, v = tokens.rational_polynomial(), tokens.rational_polynomial()
    require(P.divides(m, P.compose21(element.N, u, v)), "root: N")
    for f in in_domain_values(u, v, element.triangle):
        require(nonnegative(f, m, low, high), "root: outside")



def hull_holds(element):
    X, Y, W = element.xyw
    d, t = P.diff2, element.triangle
    if element.rational:
        degree = 2 * element.p - 1 if t else (2 * element.p, 2 * element.q)
        column = lambda k: [P.add2(P.mul2(d(F, k), W), P.mul2(F, d(W, k)), -1) for F in (X, Y)]
    else:
        degree = element.p - 1 if t else (element.p, element.q)
        column = lambda k: [d(X, k), d(Y, k)]
    net = lambda f: P.triangle_bernstein(f, degree) if t else P.square_bernstein(f, *degree)
    a, b = [[net(f) for f in column(k)] for k in (0, 1)]
    keys = list(a[0])
    A, B = [(a[0][k], a[1][k]) for k in keys], [(b[0][k], b[1][k]) for k in keys]
    return all(cross(x, y) > 0 for x, y in zip(A, B)) and all(
        cross(A[i], B[j]) + cross(A[j], B[i]) >= 0 for i, j in combinations(range(len(A)), 2))


def orientation_holds(element):
    n = element.p
    point = {k: (element.h[0][k] / element.h[2][k], element.h[1][k] / element.h[2][k]) for k in element.indices}
    corners = [{(0, 0), (1, 0), (0, 1)}, {(n, 0), (n - 1, 1), (n - 1, 0)}, {(0, n), (0, n - 1), (1, n - 1)}]
    for a, b, c in combinations(element.indices, 3):
        index = cross((b[0] - a[0], b[1] - a[1]), (c[0] - a[0], c[1] - a[1]))
        if index == 0:
            continue
        p, q, r = point[a], point[b], point[c]
        image = cross((q[0] - p[0], q[1] - p[1]), (r[0] - p[0], r[1] - p[1]))
        if image * index < 0 or (image == 0 and {a, b, c} in corners):
            return False
    return True


def check_injective(tokens, element):
    rule = tokens.rule(["midpoint", "orientation", "boundary"])
    if rule == "orientation":
        return require(element.triangle and orientation_holds(element), "orientation")
    if rule == "midpoint":
        require(not element.rational and (element.p <= 2 if element.triangle else element.p == element.q == 1), "midpoint")
    else:
        check_boundary(tokens, [element.edge(e) for e in range(element.edges)])


CLAIMS = ["injective", "regular", "overlapping", "degenerate", "folded", "reversed", "invalid", "undecided"]


def check_element(tokens, element):
    claim = tokens.rule(CLAIMS)
    sign = lambda f, strict: check_sign(tokens, f, element.triangle, element.N_degree, strict)
    if claim == "injective" and tokens.tokens[tokens.at:tokens.at + 1] == ["hull"]:
        tokens.rule(["hull"])
        require(hull_holds(element), "hull")
        tokens.end()
        return claim
    if claim in ("injective", "regular", "overlapping"):
        sign(element.N, True)
    if claim == "injective":
        check_injective(tokens, element)
    elif claim == "overlapping":
        meet = read_meet(tokens, False, element.edges)
        m = element.edges
        first, second = meet.first[1], meet.second[1]
        common = set()
        if (first + 1) % m == second:
            common.add((1, 0))
        if (second + 1) % m == first:
            common.add((0, 1))
        check_meet(meet, element.edge(first), element.edge(second), first == second, common)
    elif claim == "degenerate":
        sign(element.N, False)
        check_zero(tokens, element)
    elif claim == "folded":
        u, v = tokens.rational(), tokens.rational()
        require(element.contains(u, v), "folded: outside")
        require(P.value2(element.N, u, v) < 0, "folded: not negative")
        check_zero(tokens, element, lambda n: n >= 0)
    elif claim == "invalid":
        check_zero(tokens, element, lambda n: n <= 0)
    elif claim == "reversed":
        sign(P.scale2(element.N, -1), True)
    tokens.end()
    return claim
