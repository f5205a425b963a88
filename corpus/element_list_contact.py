"""Elements with det J > 0 whose boundary crosses, touches or follows itself, and companions moved apart by 1e-12.

All are powers of simpler maps D: z^2 is injective on {y > 0 or (y = 0 and x > 0)}, z^3 (in coordinates (1, w), w a third root
of unity, z = a + b w) on {a > 0, b >= 0}; contact.py derives the verdicts from that.
"""
from fractions import Fraction as Q

import zeros
from element_list import cube
from element_notation import S, T, add, form, poly, text
from exact import Element, multinomial, square_indices, triangle_indices

ONE = {(0, 0): Q(1)}
SHIFT = Q(1, 10 ** 12)
BACK = poly((1,), (-1, S))


def net(coordinates, degree):
    """Control points of polynomials (x, y) of the given degree."""
    kind = "triangle" if isinstance(degree, int) else "quadrilateral"
    order = triangle_indices(degree) if kind == "triangle" else square_indices(*degree)
    forms = [form(f, degree, kind) for f in coordinates]
    return [tuple(f.get(e, Q(0)) / multinomial(e) for f in forms) for e in order]


# ---- cubes of straight triangles ---------------------------------------------------------------------------

CUBED = ("z -> z^3 for z = a + b w, w a third root of unity, in coordinates (1, w), of the triangle {}, outside of which z = 0 "
         "lies: z and z w have the same image. ")


def cubed(tip):
    """The cube of the triangle (1/2, 0), (2, 0), tip."""
    a = poly((Q(1, 2),), (Q(3, 2), S), (tip[0] - Q(1, 2), T))
    b = poly((tip[1], T))
    return cube(a, b, 3)


add("overlapping-edge-third", "overlapping", CUBED.format("(1/2, 0), (2, 0), (-1/4, 1)") + "Two edges cross another, at "
    "non-dyadic parameters on all: edge 0 at 1/9 and 7/27.", 3, cubed((Q(-1, 4), Q(1))),
    proof=("overlap", ("8/9", "1/9", "0"), ("1/3", "0", "2/3")))
moved_net = cubed((Q(-1, 4), Q(1)))
moved_net[7] = text([(Q(moved_net[7][0]), Q(moved_net[7][1]) + Q(1, 100))])[0]
add("overlapping-edge-irrational", "overlapping", "The cubic of overlapping-edge-third with one control point of edge 2 moved by "
    "1/100: that edge crosses edge 0, which lies on y = 0, at irrational parameters of both.", 3, moved_net,
    proof={"contact": "line", "between": ("13/20", "67/100")})
TOUCH = CUBED.format("(1/2, 0), (2, 0), ({}, 1)")
CORNER = [("", "overlapping", Q(0), "Corner 2 touches the inside of edge 0 at the parameter 1/3, and nothing else meets."),
          ("-apart", "injective", SHIFT / 3, "Corner 2 is about 1e-12 away from edge 0."),
          ("-into", "overlapping", -SHIFT / 3, "Corner 2 lies about 1e-12 behind edge 0.")]
for suffix, expect, tip, words in CORNER:
    meet = Q(1, 2) / (Q(1, 2) - tip)
    proof = {"contact": "cube", "tip": tip} if expect == "injective" else \
        ("overlap", (1 - (meet - Q(1, 2)) / Q(3, 2), (meet - Q(1, 2)) / Q(3, 2), 0), (1 - meet, 0, meet))
    add(f"touching-corner{suffix}", expect, TOUCH.format(tip) + words, 3, cubed((tip, Q(1))), proof=proof)

# ---- squares of half a ring --------------------------------------------------------------------------------

L, M = poly((2,), (Q(-3, 2), T)), poly((Q(9, 4),), (Q(-7, 4), T))
RING = "The square z^2 of a biquadratic-like half ring D whose edges {} run along x > 0 and x < 0: z and -z have the same image. "


def ring(lift, height=Q(0)):
    """D: from (L, height) over (0, L + M) to (-M, lift - height)."""
    arch = poly((2, S, BACK, L), (2, S, BACK, M))
    x = poly((1, BACK, BACK, L), (-1, S, S, M))
    y = poly((1, arch), (height, BACK, BACK), (1, S, S, lift), (-height, S, S))
    return (x, y), arch


def squared(name, expect, source, lift, degree, proof, height=Q(0), scales=None, raised=(0, 0)):
    (x, y), arch = ring(lift, height)
    big = (2 * degree[0], 2 * degree[1])
    points = net((poly((1, x, x), (-1, y, y)), poly((2, x, y))), big)
    words = RING.format("u = 0 and u = 1") + source
    if isinstance(proof, dict):
        proof = dict(proof, inner=((x, y), degree), arch=arch)
    if scales is None:
        add(name, expect, words, big, text(points), proof=proof)
        return
    scales = tuple(map(Q, scales))
    big, points, weights = zeros.elevate(Element("quadrilateral", big, points), raised, scales)
    if isinstance(proof, dict):
        proof["scales"] = scales
    else:
        proof = ("overlap", *(bary(zeros.moved((p[1], p[3]), "quadrilateral", scales)) for p in proof[1:]))
    words += f" Raised by {raised} and reparametrised projectively: weights are products of powers of {' '.join(map(str, scales))}."
    add(name, expect, words, big, text(points), [str(w) for w in weights], proof=proof)


def bary(uv):
    return 1 - uv[0], uv[0], 1 - uv[1], uv[1]


def pair(v, u=Q(1)):
    """Parameters (0, v') and (u, v) with L(v') = -x(u, v)."""
    x = (1 - u) ** 2 * zeros.at(L, 0, v) - u ** 2 * zeros.at(M, 0, v)
    return "overlap", bary((Q(0), (2 + x) / Q(3, 2))), bary((u, v))


THIRD, ROOT2 = poly((1, T), (Q(-1, 3),)), poly((2, T, T), (-1,))
for scales, ending in ((None, ""), ((1, 2, 3, 1), "-rational")):
    for suffix, expect, shift in (("", "overlapping", Q(0)), ("-apart", "injective", SHIFT), ("-into", "overlapping", -SHIFT)):
        where = pair(Q(1, 3)) if not shift else pair(Q(1, 3) + Q(2, 10 ** 6))
        words = {"": "They touch in one point without crossing, at v = 2/9 of u = 0 and v = 1/3 of u = 1.",
                 "-apart": "They are 1e-12 apart (in D).", "-into": "They reach 1e-12 into each other (in D)."}[suffix]
        terms = [(poly((Q(1, 4), S, S)), THIRD), (poly((shift, S, S)), ONE)]
        squared(f"touching-third{ending}{suffix}", expect, words, poly((Q(1, 4), THIRD, THIRD), (shift,)), (2, 2),
                where if shift < 0 else {"contact": "ring", "terms": terms if shift else terms[:1],
                                         "same": None if shift else where}, scales=scales)
for suffix, expect, shift in (("", "overlapping", Q(0)), ("-apart", "injective", SHIFT), ("-into", "overlapping", -SHIFT)):
    words = {"": "They touch in one point without crossing, at v = 1/sqrt 2 of u = 1 and an irrational v of u = 0.",
             "-apart": "They are 1e-12 apart (in D).", "-into": "They reach 1e-12 into each other (in D)."}[suffix]
    lift, terms = poly((Q(1, 8), ROOT2, ROOT2), (shift,)), [(poly((Q(1, 8), S, S)), ROOT2), (poly((shift, S, S)), ONE)]
    proof = {"contact": "ring", "terms": terms if shift else terms[:1], "same": None}
    if shift < 0:
        proof = {"contact": "crossing", "lift": lift, "between": ("7/10", "70710678/100000000")}
    squared(f"touching-irrational{suffix}", expect, words, lift, (2, 4), proof)
for suffix, expect, shift in (("", "overlapping", Q(0)), ("-apart", "injective", SHIFT), ("-into", "overlapping", -SHIFT)):
    words = {"": "Both images lie on y = 0 and share a segment.", "-apart": "They are 1e-12 apart (in D).",
             "-into": "They reach 1e-12 into each other (in D)."}[suffix]
    high = 2 * (zeros.at(L, 0, Q(1, 2)) + zeros.at(M, 0, Q(1, 2))) / SHIFT
    proof = pair(Q(1, 2)) if shift == 0 else pair(Q(1, 2), high / (1 + high)) if shift < 0 else \
        {"contact": "ring", "terms": [(poly((shift, S, S)), ONE)], "same": None}
    squared(f"touching-segment{suffix}", expect, words, poly((shift,)), (2, 1), proof)
FOLLOW = "Here the two edges run along y = 1/4 and y = -1/4, and their images share a piece of a parabola."
squared("touching-parabola", "overlapping", FOLLOW, {}, (2, 1), pair(Q(1, 2)), Q(1, 4))
squared("touching-parabola-rational", "overlapping", FOLLOW, {}, (2, 1), pair(Q(1, 2)), Q(1, 4), (2, 1, 1, 3), (0, 1))
