"""Elements whose Jacobian determinant is prescribed, with zeros that dyadic subdivision never reaches.

Each is a sum of terms (factor, f, ...) that stand for factor * f^2 ..., divided by a multiplier; zeros.py checks that and
finds the zeros. The sign "+" makes the element with 1e-12 added (det J > 0), "-" the one with 1e-12 subtracted.
"""
from fractions import Fraction as Q

import zeros
from element_notation import S, T, add, jacobian, poly, prescribed, text
from exact import Element

ONE = {(0, 0): Q(1)}
SHIFT = Q(1, 10 ** 12)
NOTHING = {"triangle": (1, 1, 1), "quadrilateral": (1, 1, 1, 1)}
DETERMINANTS = {}  # name: (words, kind, g, multiplier, terms)


def less(c, f):
    return poly((1, f), (-Q(c),))


def third(f):
    return less("1/3", f)


def record(kind, multiplier, terms, shift=Q(0), scales=None, point=None):
    return {"multiplier": multiplier, "terms": terms, "shift": shift, "scales": scales or NOTHING[kind], "point": point}


def zero(name, words, kind, terms, shifts="0+-", multiplier=ONE, g=None, point=None):
    """zero-NAME and its shifted companions; g is the sum of the terms unless given."""
    if g is None:
        g = poly(*((term[0], *term[1:], *term[1:]) for term in terms))
    DETERMINANTS[name] = words, kind, g, multiplier, terms
    for sign in shifts:
        if sign == "0":
            jacobian(f"zero-{name}", "degenerate", words + ".", g, kind, record(kind, multiplier, terms))
        elif sign == "+":
            jacobian(f"zero-{name}-plus", "injective", words + ". Here 1e-12 is added, so g > 0.",
                     poly((1, g), (SHIFT,)), kind, record(kind, multiplier, terms, SHIFT))
        else:
            jacobian(f"zero-{name}-minus", "folded", words + ". Here 1e-12 is subtracted.", poly((1, g), (-SHIFT,)), kind,
                     record(kind, multiplier, terms, -SHIFT, None, point))


def rational(name, raised, scales):
    """zero-NAME-rational and its companions: raised in degree, weights multiplied by powers of `scales`."""
    words, kind, g, multiplier, terms = DETERMINANTS[name]
    scales = tuple(map(Q, scales))
    factors = " ".join(map(str, scales))
    done = f"raised in degree by {raised}, " if raised not in (0, (0, 0)) else ""
    for suffix, expect, shift, ending in (("", "degenerate", Q(0), ""), ("-plus", "injective", SHIFT, " with 1e-12 added"),
                                          ("-minus", "folded", -SHIFT, " with 1e-12 subtracted")):
        degree, points = prescribed(poly((1, g), (shift,)), kind)
        base = Element(kind, degree, [tuple(map(Q, p)) for p in points])
        degree, points, weights = zeros.elevate(base, raised, scales)
        add(f"zero-{name}-rational{suffix}", expect, f"The map of zero-{name} ({words}){ending}, {done}reparametrised "
            f"projectively: weights are products of powers of {factors}.", degree, text(points),
            [str(w) for w in weights], proof=record(kind, multiplier, terms, shift, scales))


TRIANGLE, QUAD = "triangle", "quadrilateral"
X3, Y3 = poly((3, S)), poly((3, T))
MOTZKIN = poly((1, X3, X3, X3, X3, Y3, Y3), (1, X3, X3, Y3, Y3, Y3, Y3), (-3, X3, X3, Y3, Y3), (1,))
SUM2 = poly((1, X3, X3), (1, Y3, Y3))
MOTZKIN_TERMS = [(poly((1, X3, X3, Y3, Y3, SUM2), (1, X3, X3, Y3, Y3)), poly((1, SUM2), (-2,))),
                 (ONE, poly((1, X3), (-1, Y3)), poly((1, X3), (1, Y3)))]
MOTZKIN_IS = "g = the Motzkin polynomial x^4 y^2 + x^2 y^4 - 3 x^2 y^2 + 1 at x = 3 {0}, y = 3 {1}, >= 0 and no sum of squares"
POINT = [(ONE, third(S)), (ONE, third(T))]
ROOT8, ROOT8_T, ROOT2 = poly((8, S, S), (-1,)), poly((8, T, T), (-1,)), poly((2, S, S), (-1,))
CIRCLE = poly((1, S, S), (1, T, T), (Q(-1, 2), S), (Q(-1, 2), T), (Q(3, 32),))
PARABOLA = poly((1, T), (-1, S, S), (Q(-1, 5),))
LINE = [(ONE, third(S))]

zero("third", "g = (s - 1/3)^2 + (t - 1/3)^2: one zero, rational and not dyadic", TRIANGLE, POINT)
zero("third-on-edge", "g = (s - 1/3)^2 + t: one zero, on an edge, not dyadic", TRIANGLE, [(ONE, third(S)), (T, ONE)])
zero("third-line", "g = (s - 1/3)^2: a line of zeros", TRIANGLE, LINE, "0-", point=(Q(1, 3), Q(0)))
zero("irrational", "g = (s - t)^2 + (8 s^2 - 1)^2: one zero, at s = t = 1/sqrt 8", TRIANGLE,
     [(ONE, poly((1, S), (-1, T))), (ONE, ROOT8)])
zero("irrational-on-edge", "g = (2 s^2 - 1)^2 + t: one zero, on an edge at s = 1/sqrt 2", TRIANGLE,
     [(ONE, ROOT2), (T, ONE)], "0")
zero("circle", "g = ((s - 1/4)^2 + (t - 1/4)^2 - 1/32)^2: zeros along a circle", TRIANGLE, [(ONE, CIRCLE)], "0-")
zero("parabola", "g = (t - s^2 - 1/5)^2: zeros along a parabola", TRIANGLE, [(ONE, PARABOLA)], "0")
zero("motzkin", MOTZKIN_IS.format("s", "t") + "; zero at s = t = 1/3; "
     "(x^2 + y^2)^2 g = x^2 y^2 (x^2 + y^2 + 1)(x^2 + y^2 - 2)^2 + (x^2 - y^2)^2", TRIANGLE, MOTZKIN_TERMS, "0+-",
     poly((1, SUM2, SUM2)), MOTZKIN)
zero("third-quad", "g = (u - 1/3)^2 + (v - 1/3)^2: one zero, not dyadic", QUAD, POINT)
zero("diagonal-quad", "g = (u - v)^2: zeros along a diagonal, which splitting by rows and columns never isolates", QUAD,
     [(ONE, poly((1, S), (-1, T)))], "0")
jacobian("dip-inside", "folded", "g = (s - 1/3)^2 + (t - 1/3)^2 - 1/10000: a small dip away from dyadic points.",
         poly((1, third(S), third(S)), (1, third(T), third(T)), (Q(-1, 10000),)))
jacobian("dip-on-edge", "folded", "g = (s - 1/3)^2 + t - 1/1000000: a small dip at an edge.",
         poly((1, third(S), third(S)), (1, T), (Q(-1, 10 ** 6),)))

# ---- the missing companions of those above -----------------------------------------------------------------

for name, shifts in [("third-line", "+"), ("irrational-on-edge", "+-"), ("circle", "+"), ("parabola", "+-"),
                     ("diagonal-quad", "+-")]:
    words, kind, g, multiplier, terms = DETERMINANTS[name]
    zero(name, words, kind, terms, shifts, multiplier, g)

# ---- isolated zeros ----------------------------------------------------------------------------------------

zero("conjugate", "g = (8 s^2 - 8 s + 1)^2 + (8 t - s)^2: two zeros, conjugate, at s = 1/2 -+ 1/sqrt 8", TRIANGLE,
     [(ONE, poly((8, S, S), (-8, S), (1,))), (ONE, poly((8, T), (-1, S)))])
zero("two-fields", "g = (8 s^2 - 1)^2 + (64 t^3 - 3)^2: one zero, s in Q(sqrt 2) and t in Q(cbrt 3); degree 7", TRIANGLE,
     [(ONE, ROOT8), (ONE, poly((64, T, T, T), (-3,)))])
zero("sqrt-s", "g = (8 s^2 - 1)^2 + (t - 1/3)^2: one zero, s irrational, t rational", TRIANGLE, [(ONE, ROOT8), (ONE, third(T))])
zero("sqrt-t", "g = (s - 1/3)^2 + (8 t^2 - 1)^2: one zero, s rational, t irrational", TRIANGLE, [(ONE, third(S)), (ONE, ROOT8_T)])
zero("same-s", "g = (8 s^2 - 1)^2 + (5 t - 1)^2 (2 t - 1)^2: two zeros over one irrational s", TRIANGLE,
     [(ONE, ROOT8), (ONE, less(1, poly((5, T))), less(1, poly((2, T))))])
zero("quartic-field", "g = (s^2 + t^2 - 1/4)^2 + (16 s t - 1)^2: two zeros with coordinates in a field of degree 4", TRIANGLE,
     [(ONE, poly((1, S, S), (1, T, T), (Q(-1, 4),))), (ONE, poly((16, S, T), (-1,)))])
zero("irrational-on-hypotenuse", "g = (2 s^2 - 1)^2 + (1 - s - t): one zero, on an edge at s = 1/sqrt 2", TRIANGLE,
     [(ONE, ROOT2), (poly((1,), (-1, S), (-1, T)), ONE)])
zero("order-four", "g = (s - 1/3)^4 + (t - 1/3)^2: one zero, of order 4 in s", TRIANGLE,
     [(ONE, third(S), third(S)), (ONE, third(T))])
zero("squared-point", "g = ((s - 1/3)^2 + (t - 1/3)^2)^2: one zero, of order 4", TRIANGLE,
     [(ONE, third(S), third(S)), (poly((2,)), third(S), third(T)), (ONE, third(T), third(T))])
zero("linear-factor", "g = (1 + s) ((s - 1/3)^2 + (t - 1/5)^2): one zero; a factor that never vanishes here", TRIANGLE,
     [(poly((1,), (1, S)), third(S)), (poly((1,), (1, S)), less("1/5", T))])
zero("acnode", "g = (s + 2/3) (s - 1/3)^2 + (t - 1/3)^2: one zero, an isolated point of an irreducible cubic", TRIANGLE,
     [(poly((1, S), (Q(2, 3),)), third(S)), (ONE, third(T))])
zero("circle-outside", "g = (s - 1/3)^2 + (t + 1/4)^2 - 1/16: a circle outside that touches an edge at s = 1/3", TRIANGLE,
     [(ONE, third(S)), (ONE, T), (poly((Q(1, 2), T)), ONE)])

# ---- curves of zeros ---------------------------------------------------------------------------------------

zero("circle-inside", "g = ((s - 1/3)^2 + (t - 1/4)^2 - 1/27)^2: zeros along a circle of irrational radius inside", TRIANGLE,
     [(ONE, poly((1, third(S), third(S)), (1, less("1/4", T), less("1/4", T)), (Q(-1, 27),)))])
zero("ellipse", "g = (2 (s - 1/3)^2 + 3 (t - 1/4)^2 - 1/20)^2: zeros along an ellipse, semi-axes 1/sqrt 40 and 1/sqrt 60",
     TRIANGLE, [(ONE, poly((2, third(S), third(S)), (3, less("1/4", T), less("1/4", T)), (Q(-1, 20),)))])
zero("cusp", "g = ((t - 1/3)^2 - (s - 1/3)^3)^2: zeros along a cubic with a cusp at (1/3, 1/3); degree 7", TRIANGLE,
     [(ONE, poly((1, third(T), third(T)), (-1, third(S), third(S), third(S))))])
zero("cross", "g = (s - 1/3)^2 (t - 1/5)^2: zeros along two lines", TRIANGLE, [(ONE, third(S), less("1/5", T))])
zero("line-times-positive", "g = (s - 1/3)^2 (t + 1): zeros along a line, a simple factor that never vanishes here", TRIANGLE,
     [(poly((1, T), (1,)), third(S))])
zero("line-and-edge", "g = (s - 1/3)^2 t: zeros along a line (even) and along an edge (odd)", TRIANGLE, [(T, third(S))])
zero("line-and-point", "g = (s - 1/3)^2 ((s - 2/3)^2 + (t - 1/7)^2): zeros along a line and at a point beside it", TRIANGLE,
     [(ONE, third(S), less("2/3", S)), (ONE, third(S), less("1/7", T))])

# ---- quadrilaterals ----------------------------------------------------------------------------------------

zero("irrational-quad", "g = (8 u^2 - 1)^2 + (3 v^2 - 1)^2: one zero, at u = 1/sqrt 8, v = 1/sqrt 3", QUAD,
     [(ONE, ROOT8), (ONE, poly((3, T, T), (-1,)))])
zero("irrational-on-edge-quad", "g = (2 u^2 - 1)^2 + v: one zero, on an edge at u = 1/sqrt 2", QUAD, [(ONE, ROOT2), (T, ONE)])
zero("conjugate-quad", "g = (8 u^2 - 8 u + 1)^2 + (v - u^2)^2: two zeros, conjugate", QUAD,
     [(ONE, poly((8, S, S), (-8, S), (1,))), (ONE, poly((1, T), (-1, S, S)))])
zero("two-fields-quad", "g = (8 u^2 - 1)^2 + (64 v^3 - 3)^2: one zero, u in Q(sqrt 2), v in Q(cbrt 3); degree 7 in v", QUAD,
     [(ONE, ROOT8), (ONE, poly((64, T, T, T), (-3,)))])
zero("circle-quad", "g = ((u - 1/3)^2 + (v - 1/2)^2 - 1/20)^2: zeros along a circle inside", QUAD,
     [(ONE, poly((1, third(S), third(S)), (1, less("1/2", T), less("1/2", T)), (Q(-1, 20),)))])
zero("ellipse-quad", "g = (2 (u - 1/3)^2 + 3 (v - 1/2)^2 - 1/10)^2: zeros along an ellipse inside", QUAD,
     [(ONE, poly((2, third(S), third(S)), (3, less("1/2", T), less("1/2", T)), (Q(-1, 10),)))])
zero("motzkin-quad", MOTZKIN_IS.format("u", "v") + "; zero at u = v = 1/3", QUAD, MOTZKIN_TERMS, "0+-",
     poly((1, SUM2, SUM2)), MOTZKIN)
zero("circle-outside-quad", "g = (u - 1/3)^2 + (v + 1/4)^2 - 1/16: a circle outside that touches an edge at u = 1/3", QUAD,
     [(ONE, third(S)), (ONE, T), (poly((Q(1, 2), T)), ONE)])
zero("line-times-positive-quad", "g = (u - 1/3)^2 (v + 1): zeros along a line, a simple factor that never vanishes here", QUAD,
     [(poly((1, T), (1,)), third(S))])
zero("third-row-quad", "g = (v - 1/3)^2: a line of zeros along the other parameter", QUAD, [(ONE, third(T))])

# ---- the same as rational elements -------------------------------------------------------------------------

for name, raised, scales in [
        ("third", 0, (1, 2, 3)), ("third-on-edge", 1, (3, 1, 2)), ("third-line", 1, (1, 2, "1/2")),
        ("irrational", 0, (2, 3, 1)), ("parabola", 0, (1, 3, 2)), ("motzkin", 0, (2, 1, 1)),
        ("circle-outside", 1, (1, "1/3", 2)), ("sqrt-t", 0, (1, 1, 3)),
        ("third-quad", (1, 0), (1, 2, 3, 1)), ("irrational-quad", (0, 0), (1, 3, 2, 1)),
        ("circle-quad", (0, 0), (2, 1, 1, 3)), ("circle-outside-quad", (1, 1), (1, 2, 1, 3))]:
    rational(name, raised, scales)
