"""Where det J vanishes: proofs that det J >= 0 by sums of squares, and the exact set of zeros.

A proof gives `terms` (factor, f, g, ...), each standing for factor * (f g ...)^2 with a factor whose form has
coefficients >= 0, and a multiplier of the same kind: multiplier * (det J - shift) is the sum of the terms.
Polynomials in (s, t) are {(power of s, power of t): coefficient}. No floating point decides anything.
"""
from fractions import Fraction as Q
from itertools import product

import exact
from element_notation import S, T, form, poly
from exact import mul

FINE = Q(1, 10 ** 30)
COORDINATES = {"triangle": [poly((1,), (-1, S), (-1, T)), S, T],
               "quadrilateral": [poly((1,), (-1, S)), S, poly((1,), (-1, T)), T]}


def clean(f):
    return {e: c for e, c in f.items() if c}


def at(f, s, t):
    return sum((c * s ** a * t ** b for (a, b), c in f.items()), Q(0))


# ---- polynomials in one variable: lists of coefficients, the constant first --------------------------------

def value(p, x):
    total = Q(0)
    for c in reversed(p):
        total = total * x + c
    return total


def trim(p):
    while p and not p[-1]:
        p = p[:-1]
    return p


def remainder(p, q):
    p = list(p)
    while len(p := trim(p)) >= len(q):
        factor, shift = p[-1] / q[-1], len(p) - len(q)
        p = [c - factor * q[i - shift] if i >= shift else c for i, c in enumerate(p)]
    return p


def quotient(p, q):
    p, result = list(p), [Q(0)] * (len(p) - len(q) + 1)
    for shift in range(len(p) - len(q), -1, -1):
        result[shift] = p[shift + len(q) - 1] / q[-1]
        p = [c - result[shift] * q[i - shift] if 0 <= i - shift < len(q) else c for i, c in enumerate(p)]
    return result


def common(p, q):
    while q:
        p, q = q, remainder(p, q)
    return p


def roots(p):
    """All roots in [0, 1] as intervals narrower than FINE, of length 0 where rational with a small denominator."""
    p = trim([Q(c) for c in p])
    derivative = [i * c for i, c in enumerate(p)][1:]
    if not derivative:
        return []
    p = quotient(p, common(p, derivative))
    if len(p) == 2:
        root = -p[0] / p[1]
        return [(root, root)] if 0 <= root <= 1 else []
    chain = [p, trim([i * c for i, c in enumerate(p)][1:])]
    while chain[-1]:
        chain.append([-c for c in remainder(chain[-2], chain[-1])])
    chain.pop()

    def changes(x):
        signs = [v > 0 for v in (value(f, x) for f in chain) if v]
        return sum(a != b for a, b in zip(signs, signs[1:]))

    found, todo = [], [(Q(-1, 97), Q(98, 97))]
    while todo:
        lower, upper = todo.pop()
        inside = changes(lower) - changes(upper)  # roots in (lower, upper]
        if inside == 0:
            continue
        if inside == 1:
            found.append(narrow(p, lower, upper))
            continue
        middle = (lower + upper) / 2
        todo += [(lower, middle), (middle, upper)]
    return sorted(r for r in found if r[1] >= 0 and r[0] <= 1)


def narrow(p, lower, upper):
    """The one root of the square-free p in (lower, upper]."""
    rational = None
    if value(p, upper) == 0:
        return upper, upper
    while upper - lower > FINE:
        middle = (lower + upper) / 2
        if value(p, middle) == 0:
            return middle, middle
        if (value(p, middle) > 0) == (value(p, upper) > 0):
            upper = middle
        else:
            lower = middle
        if rational is None and upper - lower < Q(1, 10 ** 9):
            rational = middle.limit_denominator(10 ** 4)
            if value(p, rational) == 0 and lower <= rational <= upper:
                return rational, rational
    return lower, upper


# ---- intervals ---------------------------------------------------------------------------------------------

def times(x, y):
    products = [a * b for a in x for b in y]
    return min(products), max(products)


def over(f, s, t):
    """Bounds of a polynomial over a box."""
    total = (Q(0), Q(0))
    for (a, b), c in f.items():
        term = (c, c)
        for x, k in ((s, a), (t, b)):
            for _ in range(k):
                term = times(term, x)
        total = total[0] + min(term), total[1] + max(term)
    return total


# ---- systems of polynomials in (s, t) ----------------------------------------------------------------------

def swap(f):
    return {(b, a): c for (a, b), c in f.items()}


def in_one(f, axis):
    """Coefficients of a polynomial in one variable alone, or None."""
    if any(e[1 - axis] for e in f):
        return None
    return [f.get((k, 0) if axis == 0 else (0, k), Q(0)) for k in range(max(e[axis] for e in f) + 1)]


def solve(system):
    """Boxes of all common zeros with coordinates in [0, 1] of two polynomials, or None for a single one (a curve)."""
    unique = []
    for f in map(clean, system):
        lead = f[max(f)]
        if (f := {e: c / lead for e, c in f.items()}) not in unique:
            unique.append(f)
    if len(unique) == 1:
        return None
    first, second = ([p for f in unique if (p := in_one(f, axis))] for axis in (0, 1))
    boxes = None
    if first and second:
        boxes = list(product(roots(first[0]), roots(second[0])))
    for turned in (False, True):
        if boxes is None:
            boxes = eliminate([swap(f) for f in unique] if turned else unique)
            boxes = [box[::-1] for box in boxes] if turned and boxes is not None else boxes
    assert boxes is not None, "cannot solve this system"
    result = []
    for s, t in boxes:
        if s[0] == s[1] and t[0] == t[1]:
            if any(at(f, s[0], t[0]) for f in unique):
                continue
        else:
            assert len(unique) == 2, "three polynomials at an irrational point"
        result.append((s, t))
    return result


def eliminate(system):
    """Common zeros of f, linear in t, and g: t = -b(s)/a(s), or None if no f is linear in t."""
    for f in system:
        if max(b for _, b in f) != 1 or len(system) != 2:
            continue
        g = next(h for h in system if h is not f)
        a, b = ({(i, 0): c for (i, j), c in f.items() if j == k} for k in (1, 0))
        top, total = max(j for _, j in g), {}
        for (i, j), c in g.items():
            term = {(i, 0): c * (-1) ** j}
            for factor in [b] * j + [a] * (top - j):
                term = mul(term, factor)
            total = exact.add(total, term)
        p, a = trim(in_one(total, 0)), in_one(a, 0)
        assert p and len(common(p, trim(a))) == 1, "a common zero"
        boxes = []
        for s in roots(p):
            low, high = over({(k, 0): c for k, c in enumerate(a)}, s, (Q(0), Q(0)))
            assert low > 0 or high < 0
            lower, upper = over(b, s, (Q(0), Q(0)))
            boxes.append((s, times((-upper, -lower), (1 / high, 1 / low))))
        return boxes
    return None


def alternatives(term, kind):
    """The polynomials of which one vanishes where the term does."""
    factor = monomials(term[0], kind)
    found = [f for f in map(clean, term[1:]) if any(e != (0, 0) for e in f)]
    powers = [min(e[r] for e in factor) for r in range(len(COORDINATES[kind]))]
    rest = [tuple(k - m for k, m in zip(e, powers)) for e in factor]
    d = [max(e[r] for e in rest) for r in range(len(powers))]
    corners = {(d[0], 0, 0), (0, d[1], 0), (0, 0, d[2])} if kind == "triangle" else \
        {(a, d[1] - a, b, d[3] - b) for a in (0, d[1]) for b in (0, d[3])}
    assert corners <= set(rest), "a factor that vanishes at a corner"
    found += [f for f, m in zip(COORDINATES[kind], powers) if m]
    return found


def degree_of(f, kind):
    if kind == "triangle":
        return max(map(sum, f))
    return max(a for a, _ in f), max(b for _, b in f)


def monomials(f, kind):
    return clean(form(f, degree_of(f, kind), kind))


def zero_set(terms, multiplier, kind):
    """(dimension, boxes of the zeros) of the sum of the terms in the closed domain, without those of the multiplier."""
    points = []
    for system in product(*(alternatives(term, kind) for term in terms)):
        boxes = solve(system)
        if boxes is None:
            if system[0] in COORDINATES[kind] or sign_change(system[0], kind):
                return 1, []
            raise AssertionError("a curve without two sides")
        for s, t in boxes:
            inside = True
            for f in COORDINATES[kind]:
                low, high = over(f, s, t)
                if clean(f) not in map(clean, system) and high < 0:
                    inside = False
                assert high < 0 or low >= 0 or f in system, "on the boundary or not"
            low, high = over(multiplier, s, t)
            if s[0] == s[1] and t[0] == t[1] and low == 0:
                continue  # the caller checks these
            assert low > 0 or high < 0
            if inside and all(max(abs(s[0] - x[0]), abs(t[0] - y[0])) > FINE * 10 ** 6 for x, y in points):
                points.append((s, t))
    return 0, sorted(points)


def sign_change(f, kind):
    """Two points inside the domain between which f changes its sign, or None."""
    grid = [(Q(i, 12), Q(j, 12)) for i in range(1, 12) for j in range(1, 12)]
    grid = [x for x in grid if kind != "triangle" or sum(x) < 1]
    plus, minus = ([x for x in grid if at(f, *x) * sign > 0] for sign in (1, -1))
    return (plus[0], minus[0]) if plus and minus else None


def near_zeros(terms, multiplier, kind):
    """Rational parameters close to zeros: the zero itself where it is rational, else to 11 digits."""
    dimension, points = zero_set(terms, multiplier, kind)
    if dimension == 0:
        return [(s[0], t[0]) if s[0] == s[1] and t[0] == t[1] else
                tuple(x[0] if x[0] == x[1] else Q(int(x[0] * 10 ** 11), 10 ** 11) for x in (s, t)) for s, t in points]
    found = []
    for system in product(*(alternatives(term, kind) for term in terms)):
        ends = sign_change(system[0], kind)
        if not ends or any(f != system[0] for f in system):
            continue
        a, b = ends
        while max(abs(x - y) for x, y in zip(a, b)) > Q(1, 10 ** 12):
            middle = exact.middle(a, b)
            a, b = (middle, b) if at(system[0], *middle) > 0 else (a, middle)
        found.append(tuple(Q(int(x * 10 ** 11), 10 ** 11) for x in a))
    return found


# ---- what bisection finds ----------------------------------------------------------------------------------

def zero_faces(rows, triangle):
    """(dimension, zeros) of a polynomial that bisection shows to be >= 0: where all coefficients of a face vanish."""
    if not any(c for row in rows for c in row):
        return 2, []
    corners = [(Q(0), Q(0)), (Q(1), Q(0)), (Q(0), Q(1))] + ([] if triangle else [(Q(1), Q(1))])
    level, points, dimension = [(rows, corners)], set(), 0
    while level:
        following = []
        for rows, places in level:
            values = [c for row in rows for c in row]
            if min(values) < 0:
                m = exact.middle(places[0], places[1])
                if triangle:
                    parts = [(places[2], places[0], m), (places[1], places[2], m)]
                else:
                    k = exact.middle(places[2], places[3])
                    parts = [(places[0], places[2], m, k), (m, k, places[1], places[3])]
                following += zip(exact.halves(rows, triangle), parts)
                continue
            sides = [rows[0], [row[0] for row in rows], [row[-1] for row in rows]] + ([] if triangle else [rows[-1]])
            dimension = max(dimension, int(any(not any(side) for side in sides)))
            ends = [rows[0][0], rows[0][-1], rows[-1][0]] + ([] if triangle else [rows[-1][-1]])
            points |= {place for place, end in zip(places, ends) if end == 0}
        level = following
    return dimension, [] if dimension else sorted(points)


# ---- projective reparametrisation --------------------------------------------------------------------------

def scaled_form(f, degree, kind, scales):
    """The form of f at (a xi_1, b xi_2, ...)."""
    return {e: c * exact.prod_powers(scales, e) for e, c in form(f, degree, kind).items()}


def moved(point, kind, scales):
    """The parameter that the reparametrisation takes to `point`."""
    bary = [at(f, *point) / a for f, a in zip(COORDINATES[kind], scales)]
    if kind == "triangle":
        return bary[1] / sum(bary), bary[2] / sum(bary)
    return bary[1] / (bary[0] + bary[1]), bary[3] / (bary[2] + bary[3])


def elevate(element, raised, scales):
    """(degree, points, weights) of a polynomial element raised in degree (by n, or (p, q)) and reparametrised."""
    ones = [{(1, 0, 0): Q(1), (0, 1, 0): Q(1), (0, 0, 1): Q(1)}] * raised if element.triangle else \
        [{(1, 0, 0, 0): Q(1), (0, 1, 0, 0): Q(1)}] * raised[0] + [{(0, 0, 1, 0): Q(1), (0, 0, 0, 1): Q(1)}] * raised[1]
    X, Y = element.X, element.Y
    for one in ones:
        X, Y = mul(X, one), mul(Y, one)
    if element.triangle:
        degree = element.degree + raised
        order = exact.triangle_indices(degree)
    else:
        degree = element.degree[0] + raised[0], element.degree[1] + raised[1]
        order = exact.square_indices(*degree)
    points = [tuple(f.get(e, Q(0)) / exact.multinomial(e) for f in (X, Y)) for e in order]
    return degree, points, [exact.prod_powers(scales, e) for e in order]


def check_sum(element, kind, proof):
    """N is, up to a positive factor and after the reparametrisation, the polynomial the terms stand for."""
    multiplier, terms, shift, scales = proof["multiplier"], proof["terms"], proof["shift"], proof["scales"]
    assert all(c >= 0 for f in [multiplier] + [term[0] for term in terms] for c in monomials(f, kind).values())
    total = {e: c * shift for e, c in multiplier.items()}
    for factor, *roots_of in terms:
        for f in roots_of:
            factor = mul(factor, mul(f, f))
        total = exact.add(total, factor)
    total = clean(total)
    some = next(iter(element.N))
    d, m = degree_of(total, kind), degree_of(multiplier, kind)
    right = scaled_form(total, d, kind, scales)
    left = mul(element.N, scaled_form(multiplier, m, kind, scales))
    if kind == "triangle":
        lines = [({(1, 0, 0): scales[0], (0, 1, 0): scales[1], (0, 0, 1): scales[2]}, sum(some) + m - d)]
    else:
        lines = [({(1, 0, 0, 0): scales[0], (0, 1, 0, 0): scales[1]}, sum(some[:2]) + m[0] - d[0]),
                 ({(0, 0, 1, 0): scales[2], (0, 0, 0, 1): scales[3]}, sum(some[2:]) + m[1] - d[1])]
    for line, count in lines:
        for _ in range(abs(count)):
            left, right = (left, mul(right, line)) if count > 0 else (mul(left, line), right)
    lead = next(e for e, c in right.items() if c)
    ratio = left.get(lead, 0) / right[lead]
    assert ratio > 0 and not any(exact.add(left, right, -ratio).values()), "not that sum of squares"


def unweighted(element, scales):
    """The polynomial element behind a reparametrised one."""
    weights = {e: w / exact.prod_powers(scales, e) for e, w in element.weight.items()}
    assert len(set(weights.values())) == 1, "no reparametrisation"
    kind = "triangle" if element.triangle else "quadrilateral"
    return exact.Element(kind, element.degree, [element.point[e] for e in element.indices])
