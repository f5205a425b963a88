"""Exact polynomials. In x: a list of coefficients of 1, x, ...; in (u, v): {(i, j): coefficient of u^i v^j}. No zeros are kept."""
from fractions import Fraction as Q
from math import comb, factorial


def trim(f):
    f = list(f)
    while f and f[-1] == 0:
        f.pop()
    return f


def add1(f, g, s=1):
    n = max(len(f), len(g))
    return trim([(f[i] if i < len(f) else 0) + s * (g[i] if i < len(g) else 0) for i in range(n)])


def mul1(f, g):
    h = [Q(0)] * (len(f) + len(g))
    for i, a in enumerate(f):
        for j, b in enumerate(g):
            h[i + j] += a * b
    return trim(h)


def divmod1(f, g):
    f, g, quotient = trim(f), trim(g), []
    while len(f) >= len(g):
        c = Q(f[-1]) / g[-1]
        quotient.append(c)
        shift = len(f) - len(g)
        f = [f[i] - c * g[i - shift] if i >= shift else f[i] for i in range(len(f) - 1)]
    return trim(quotient[::-1]), trim(f)


def divides(m, f):
    return not divmod1(f, m)[1]


def gcd1(f, g):
    while g:
        f, g = g, divmod1(f, g)[1]
    return [Q(c) / f[-1] for c in f]


def value1(f, x):
    result = Q(0)
    for c in reversed(f):
        result = result * x + c
    return result


def derivative1(f):
    return trim([i * c for i, c in enumerate(f)][1:])


def affine1(f, a, b):
    """f(a + b x)."""
    result = []
    for c in reversed(f):
        result = add1(mul1(result, trim([Q(a), Q(b)])), trim([Q(c)]))
    return result


def bernstein1(f, low=0, high=1, degree=None):
    f = affine1(f, low, Q(high) - low)
    n = max(len(f) - 1, 0) if degree is None else degree
    f = f + [Q(0)] * (n + 1 - len(f))
    return [sum(Q(comb(i, k), comb(n, k)) * f[k] for k in range(i + 1)) for i in range(n + 1)]


def from_bernstein1(b):
    n, f = len(b) - 1, []
    for i, c in enumerate(b):
        term = [Q(c) * comb(n, i)]
        term = mul1(term, [Q(0)] * i + [Q(1)])
        for _ in range(n - i):
            term = mul1(term, [Q(1), Q(-1)])
        f = add1(f, term)
    return f


def sign_changes(values):
    signs = [v > 0 for v in values if v != 0]
    return sum(a != b for a, b in zip(signs, signs[1:]))


# Two variables.

def clean(f):
    return {k: c for k, c in f.items() if c != 0}


def add2(f, g, s=1):
    h = dict(f)
    for k, c in g.items():
        h[k] = h.get(k, 0) + s * c
    return clean(h)


def mul2(f, g):
    h = {}
    for (i, j), a in f.items():
        for (k, l), b in g.items():
            h[i + k, j + l] = h.get((i + k, j + l), 0) + a * b
    return clean(h)


def scale2(f, c):
    return clean({k: c * a for k, a in f.items()})


def power2(f, e):
    result = {(0, 0): Q(1)}
    for _ in range(e):
        result = mul2(result, f)
    return result


def diff2(f, variable):
    if variable == 0:
        return clean({(i - 1, j): i * c for (i, j), c in f.items() if i})
    return clean({(i, j - 1): j * c for (i, j), c in f.items() if j})


def degree2(f, variable):
    return max((k[variable] for k in f), default=0)


def total2(f):
    return max((sum(k) for k in f), default=0)


def swap2(f):
    return {(j, i): c for (i, j), c in f.items()}


def value2(f, u, v):
    return sum((c * Q(u) ** i * Q(v) ** j for (i, j), c in f.items()), Q(0))


def substitute2(f, a, b):
    """f(a, b) for polynomials a, b in two variables."""
    powers_a, powers_b, result = [{(0, 0): Q(1)}], [{(0, 0): Q(1)}], {}
    for _ in range(degree2(f, 0)):
        powers_a.append(mul2(powers_a[-1], a))
    for _ in range(degree2(f, 1)):
        powers_b.append(mul2(powers_b[-1], b))
    for (i, j), c in f.items():
        result = add2(result, mul2(powers_a[i], powers_b[j]), c)
    return result


def compose21(f, u, v):
    """f(u(x), v(x))."""
    result = []
    for (i, j), c in f.items():
        term = [c]
        for _ in range(i):
            term = mul1(term, u)
        for _ in range(j):
            term = mul1(term, v)
        result = add1(result, term)
    return result


def linear2(constant, s, t):
    return clean({(0, 0): Q(constant), (1, 0): Q(s), (0, 1): Q(t)})


def coefficient_of_v(f, j):
    return trim([f.get((i, j), Q(0)) for i in range(degree2(f, 0) + 1)])


def determinant(matrix):
    m, result = [list(map(Q, row)) for row in matrix], Q(1)
    for k in range(len(m)):
        pivot = next((r for r in range(k, len(m)) if m[r][k] != 0), None)
        if pivot is None:
            return Q(0)
        if pivot != k:
            m[k], m[pivot], result = m[pivot], m[k], -result
        result *= m[k][k]
        for r in range(k + 1, len(m)):
            factor = m[r][k] / m[k][k]
            if factor:
                m[r] = [a - factor * b for a, b in zip(m[r], m[k])]
    return result


def resultant_v(f, n, g, m):
    """The determinant of the Sylvester matrix in v, formal degrees n and m, as a polynomial in u: by values and interpolation."""
    rows_f = [coefficient_of_v(f, j) for j in range(n + 1)]
    rows_g = [coefficient_of_v(g, j) for j in range(m + 1)]
    bound = m * max(len(r) for r in rows_f) + n * max(len(r) for r in rows_g) + 1
    points, values = list(range(bound + 1)), []
    for x in points:
        a = [value1(r, Q(x)) for r in reversed(rows_f)]
        b = [value1(r, Q(x)) for r in reversed(rows_g)]
        size = n + m
        matrix = [[0] * i + a + [0] * (size - n - 1 - i) for i in range(m)]
        matrix += [[0] * i + b + [0] * (size - m - 1 - i) for i in range(n)]
        values.append(determinant(matrix))
    return interpolate(points, values)


def interpolate(points, values):
    """Newton's divided differences."""
    c = [Q(v) for v in values]
    for k in range(1, len(c)):
        for i in range(len(c) - 1, k - 1, -1):
            c[i] = (c[i] - c[i - 1]) / (points[i] - points[i - k])
    result = []
    for x, a in zip(reversed(points), reversed(c)):
        result = add1(mul1(result, [Q(-x), Q(1)]), trim([a]))
    return result


def triangle_bernstein(f, d):
    """{(i, j): coefficient} for i + j <= d; i belongs to u, j to v."""
    weight = {(k, l): c * Q(factorial(k) * factorial(l) * factorial(d - k - l), factorial(d)) for (k, l), c in f.items()}
    return {(i, j): sum((c * comb(i, k) * comb(j, l) for (k, l), c in weight.items() if k <= i and l <= j), Q(0))
            for j in range(d + 1) for i in range(d + 1 - j)}


def square_bernstein(f, p, q):
    return {(i, j): sum((c * Q(comb(i, k) * comb(j, l), comb(p, k) * comb(q, l))
                         for (k, l), c in f.items() if k <= i and l <= j), Q(0))
            for j in range(q + 1) for i in range(p + 1)}
