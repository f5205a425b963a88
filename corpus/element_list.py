"""The elements of the corpus: points, expected verdict, and where each comes from.

`add` only records; make_elements.py proves every expected verdict before it writes a file.
"""
from fractions import Fraction as Q
from random import Random

from element_notation import (S, T, add, curve_top, doubles, form, grid, jacobian, poly, square, text)
from exact import multinomial, square_indices, triangle_indices

# ---- straight and simple ----------------------------------------------------------------------------------

add("affine", "injective", "The reference triangle itself.", 1, "0,0 1,0 0,1")
add("affine-clockwise", "reversed", "The reference triangle with two corners exchanged: det J = -1.", 1, "0,0 0,1 1,0")
add("collinear-corners", "degenerate", "Three collinear corners: N is the zero polynomial.", 1, "0,0 1,1 2,2")
add("sliver", "injective", "Straight triangle of height 1e-30; its area decides, not a tolerance.", 1,
    "0,0 1,0 1/2,1e-30")
add("affine-cubic", "injective", "Affine map written with degree 3.", 3,
    text([(2 * a + b, a + 3 * b) for _, a, b in triangle_indices(3)]))
add("affine-cubic-clockwise", "reversed", "Affine map of determinant < 0 written with degree 3.", 3,
    text([(a + 3 * b, 2 * a + b) for _, a, b in triangle_indices(3)]))
add("uneven-straight", "injective", "Straight sides with unevenly spaced control points; quadratic with det J > 0.", 2,
    "0,0 1/4,0 1,0 0,1/4 1/2,1/2 0,1")
add("past-the-end", "folded", "Straight edge whose middle control point lies beyond its end, so the edge runs back.", 2,
    "0,0 5/4,0 1,0 0,1/2 1/2,1/2 0,1")
add("single-point", "degenerate", "All control points coincide: N is the zero polynomial.", 2, "1,2 " * 6)
add("flattened-cubic", "degenerate", "All control points on one line: N is the zero polynomial.", 3,
    text([(a + 2 * b + a * b, 2 * a + 4 * b + 2 * a * b) for _, a, b in triangle_indices(3)]))
add("equal-weights", "injective", "Quadratic with all weights 3, which is polynomial.", 2,
    "0,0 2,-1 4,0 0,2 2,2 0,4", "3 " * 6)
add("clockwise-quadratic", "reversed", "Mirror image of a quadratic with det J > 0.", 2, "0,0 -2,-1 -4,0 0,2 -2,2 0,4")
add("clockwise-with-fold", "folded", "Mirror image of an element folded at one corner: clockwise, yet det J > 0 there.",
    2, "0,0 -5/4,0 -1,0 0,1/2 -1/2,1/2 0,1")
add("clockwise-flat-corner", "folded", "Clockwise with det J = 0 at corner 0: det J < 0 somewhere but not everywhere.",
    2, "0,0 -2,-1 -4,0 2,1 -2,2 0,4")
add("flat-corner", "degenerate", "The two edges leave corner 0 in opposite directions: det J = 0 there and nowhere else.",
    2, "0,0 2,-1 4,0 -2,1 2,2 0,4")
add("cusp-corner", "degenerate", "The control point next to corner 0 coincides with it: det J = 0 at that corner.", 2,
    "0,0 0,0 2,0 0,1 1,1 0,2")
add("three-flat-corners", "degenerate", "Cubic with collinear tangents at all three corners.", 3,
    "0,0 3,-2 7,-2 9,3 -3,2 4,3 10,6 -1,6 9,10 5,10")

# ---- published claims and their relations -----------------------------------------------------------------

XC15 = "XC15 Theorem 2.1 accepts it (all upright control triangles counter-clockwise), yet det J < 0. "
SIMPLE = "The whole control net is simple and so is the boundary (edges monotone, their control polygons parted)."
add("control-net-folded-quadratic", "folded", XC15 + SIMPLE, 2, "0,-3 9,-7 2,1 -7,2 1,2 -3,14", proof="simple")
add("control-net-folded-quadratic-b", "folded", XC15 + SIMPLE, 2, "2,2 2,4 15,4 -4,-2 4,7 -7,6", proof="simple")
add("control-net-folded-quadratic-c", "folded", XC15 + "The whole control net is simple.", 2,
    "2,4 0,-1 8,3 6,7 8,8 -4,8", proof="simple net")
add("control-net-folded-cubic", "folded", XC15 + SIMPLE, 3,
    "2,-5 7,-6 3,1 6,2 -2,-2 1,0 12,8 1,3 8,10 -3,12", proof="simple")
add("control-net-folded-cubic-b", "folded", XC15 + SIMPLE, 3,
    "1,3 2,-1 3,-4 12,-2 1,4 4,3 13,2 -3,6 8,14 -2,10", proof="simple")
KMC22 = ("Guardable curve edge and all five conditions of KMC22 Theorem 1 (o the midpoint of the edge's end points, d along "
         "the second row), yet det J < 0. ")
add("cone-folded-conic", "folded", KMC22 + "Found by random search.", 2, "0,0 4,0 8,1 1,17 2,17 4,68", "1 8 1 1 1 1")
add("cone-folded-conic-light", "folded", KMC22 + "Middle weight below 1; found by random search.", 2,
    "0,0 4,1 5,5 -7,3 3,3 -35/4,15/4", "1 1/8 1 1 1 1")
add("cone-folded-conic-scaled", "folded", KMC22 + "Straight curve edge, all weights multiplied by 5.", 2,
    "0,0 3,-2 6,-4 7,3 9,3 49,21", "5 40 5 5 5 5")
add("cone-folded-cubic", "folded", KMC22 + "Found by random search.", 3,
    "0,0 3,-3 4,-5 8,-8 14,1 15,1 16,1 28,2 29,2 42,3", "1 1/2 3 1 1 1 1 1 1 1")
add("cone-conic", "injective", "KMC22 Theorem 1 applies and happens to be right; one coefficient of N is negative, "
    "subdivision proves det J > 0.", 2, "0,0 4,-1 8,-3 13,20 14,20 26,40", "1 4 1 1 1 1")
add("cone-cubic", "injective", "KMC22 Theorem 1 applies and happens to be right; some coefficients of N are negative.", 3,
    "0,0 3,-1 4,-4 8,-8 14,13 15,13 16,13 49/2,91/4 51/2,91/4 77/2,143/4", "1 1/4 8 1 1 1 1 1 1 1")
add("cone-polynomial", "injective", "Polynomial Bezier guarding: derivatives by the two parameters stay in two "
    "complementary open cones, so every mixed determinant is positive.", 3,
    "0,0 1,1 2,-1 3,0 1/2,4 3/2,4 5/2,4 1,8 2,8 3/2,12")
add("cone-tip-boundary", "folded", "Polynomial; the second row lies in all cones of the control vectors but not in that of d "
    "itself, which must be among them: N < 0 at the tip.", 2, "0,0 1,-1 2,-2 3,-1 5,-1 6,-2")
FLAT = "YLC22 Theorem 1 applies, yet an upright control triangle has area zero, which XC15 excludes. "
add("orientation-flat-triangle", "injective", FLAT + "Two neighbouring control points of an edge coincide.", 3,
    "0,0 1,0 1,0 4,-1 0,1 1,1 2,1 0,2 1,3 1,4")
add("orientation-flat-triangle-b", "injective", FLAT + "Two neighbouring control points of an edge coincide.", 3,
    "0,1 2,0 4,0 5,0 -1,3 3,1 5,1 -1,3 1,5 0,6")
add("inverted-control-triangle", "injective", "An upright control triangle is inverted, yet all coefficients of N are "
    "positive. The boundary is simple: edges monotone, their control polygons parted by lines.", 3, "-3,-2 4,-2 7,2 12,3 2,7 3,4 9,7 0,9 3,9 1,12")
add("subdivision-only-cubic", "injective", "Upright control triangles counter-clockwise, a coefficient of N negative; "
    "subdivision proves det J > 0. The boundary is simple.", 3, "0,0 1,-2 6,0 15,3 2,3 4,7 10,3 -2,8 3,8 0,13")
add("subdivision-only-quadratic", "injective", "Quadratic with a negative coefficient of N and det J > 0 by subdivision, "
    "hence injective by the midpoint rule.", 2, "2,-2 4,0 7,3 -2,6 1,1 2,6")

# ---- det J > 0 and yet two parameters meet ----------------------------------------------------------------

def cube(a, b, degree):
    """z^3 for z = a + b w, w^2 + w + 1 = 0, in the basis (1, w); a and b linear in the parameters."""
    kind = "triangle" if degree == 3 else "quadrilateral"
    X = form(poly((a, a, a), (-3, a, b, b), (b, b, b)), degree, kind)
    Y = form(poly((3, a, a, b), (-3, a, b, b)), degree, kind)
    order = triangle_indices(3) if degree == 3 else square_indices(*degree)
    return text([(X.get(e, Q(0)) / multinomial(e), Y.get(e, Q(0)) / multinomial(e)) for e in order])


CUBE = ("z -> z^3 for z = a + b w, w a third root of unity, in coordinates (1, w): det J is a positive multiple of "
        "(a^2 - a b + b^2)^2, positive because z = 0 lies outside, and z = 1, z = w have the same image. ")
add("overlapping-corners", "overlapping", CUBE + "Here they are corners 0 and 2.", 3,
    cube({(0, 0): Q(1), (0, 1): Q(-1)}, poly((1, S), (1, T)), 3), proof=("overlap", (1, 0, 0), (0, 0, 1)))
add("overlapping-interior", "overlapping", CUBE + "Parameters (80/117, 1/13, 28/117) and (28/117, 1/13, 80/117).", 3,
    cube({(0, 0): Q(3, 2), (1, 0): Q(1, 2), (0, 1): Q(-9, 4)}, {(0, 0): Q(-3, 4), (1, 0): Q(11, 4), (0, 1): Q(9, 4)}, 3),
    proof=("overlap", ("80/117", "1/13", "28/117"), ("28/117", "1/13", "80/117")))
add("overlapping-quad", "overlapping", CUBE + "Parameters (u, v) = (1/8, 5/18) and (1/8, 13/18).", (3, 3),
    cube({(0, 0): Q(3, 2), (1, 0): Q(1), (0, 1): Q(-9, 4)}, {(0, 0): Q(-3, 4), (1, 0): Q(1), (0, 1): Q(9, 4)}, (3, 3)),
    proof=("overlap", ("7/8", "1/8", "13/18", "5/18"), ("7/8", "1/8", "5/18", "13/18")))

# ---- Lagrange nodes ---------------------------------------------------------------------------------------

TRAP = "0,0 1/2,9/20 1,0 0,1/2 1/2,1/2 0,1"
add("trap-control-point", "injective", "The bezier-guarding trap: (0.5, 0.45) as a control point; quadratic with "
    "det J > 0.", 2, TRAP)
add("trap-node", "folded", "The bezier-guarding trap: the same six points as Lagrange nodes; the edge's control point is "
    "(0.5, 0.9) and min det J = -4/5, at corner 1.", 2, TRAP, basis="lagrange")
add("lagrange-cubic", "injective", "Cubic through slightly moved equispaced nodes.", 3, grid(3, Q(1, 3), 1, 4, Q(1, 60)),
    basis="lagrange")
add("lagrange-cubic-clockwise", "reversed", "Cubic Lagrange nodes in clockwise order.", 3,
    "0,0 0,1 0,2 0,3 1,0 1.1,1.1 1,2 2,0 2,1 3,0", basis="lagrange")
add("lagrange-quartic-folded", "folded", "Quartic with one edge node moved inwards too far.", 4,
    [("1", "5/4") if p == ("1", "0") else p for p in grid(4)], basis="lagrange")
add("quarter-point", "degenerate", "The quarter-point element of fracture mechanics: edge nodes at a quarter of the "
    "edges from corner 0, so two control points coincide with it and det J = 0 there.", 2,
    "0,0 1/4,0 1,0 0,1/4 1/2,1/2 0,1", basis="lagrange")
add("lagrange-quad", "injective", "Biquadratic through slightly moved equispaced nodes.", (2, 2),
    square(2, 2, 1, 1, Q(1, 20)), basis="lagrange")
add("lagrange-quad-folded", "folded", "Biquadratic whose centre node lies close to a corner.", (2, 2),
    "0,0 1,0 2,0 0,1 0.2,0.2 2,1 0,2 1,2 2,2", basis="lagrange")

# ---- quadrilaterals ---------------------------------------------------------------------------------------

add("quad-square", "injective", "The unit square.", (1, 1), "0,0 1,0 0,1 1,1")
add("quad-trapezoid", "injective", "Bilinear, convex: the four corner values of N are positive.", (1, 1), "0,0 4,0 1,2 2,3")
add("quad-clockwise", "reversed", "Bilinear, convex and clockwise.", (1, 1), "0,0 1,2 4,0 3,3")
add("quad-arrow", "folded", "Bilinear with a reflex corner: N < 0 at that corner.", (1, 1), "0,0 4,0 0,4 1,1")
add("quad-bowtie", "folded", "Two corners exchanged.", (1, 1), "0,0 1,0 1,1 0,1")
add("quad-flat-corner", "degenerate", "Three consecutive corners collinear: det J = 0 at the middle one.", (1, 1),
    "0,0 2,0 0,2 1,1")
add("quad-collapsed-edge", "degenerate", "One edge is a point: det J = 0 along it.", (1, 1), "0,0 1,0 1/2,1 1/2,1")
add("quad-collapsed", "degenerate", "All control points on a line: N is the zero polynomial.", (2, 1),
    "0,0 1,2 2,4 1,2 3,6 5,10")
add("quad-1x3", "injective", "Degrees 1 and 3, gently curved.", (1, 3), "0,0 3,0 1/4,1 13/4,1 -1/4,2 11/4,2 0,3 3,3")
add("quad-2x5", "injective", "Degrees 2 and 5, moved by at most 1/10.", (2, 5), square(2, 5, 1, 2, Q(1, 10)))
add("quad-5x2-folded", "folded", "Degrees 5 and 2 with widely moved control points.", (5, 2), square(5, 2, 3, 5, Q(1, 2)))
add("quad-curved-top", "injective", "x = u and y = v times a quartic that dips but stays positive.", (4, 1),
    curve_top(4, 1, ["1", "-1/4", "1/2", "-1/4", "1"]))
add("quad-crossing-top", "folded", "x = u and y = v times a quartic that is negative at u = 1/2.", (4, 1),
    curve_top(4, 1, ["1", "0", "-1", "0", "1"]))
add("quad-3x3-inner-point", "folded", "Bicubic: one inner control point far outside.", (3, 3),
    [("12", "12") if p == ("1", "1") else p for p in square(3, 3)])
add("quad-3x3-clockwise", "reversed", "Bicubic, mirrored.", (3, 3), [(y, x) for x, y in square(3, 3, 1, 8, Q(1, 8))])

# ---- rational elements ------------------------------------------------------------------------------------

add("quarter-disc", "injective", "Quarter of the unit disc with its centre as corner 2; arc with weights 1, 1, 2.", 2,
    "1,0 1,1 0,1 1/2,0 0,1/2 0,0", "1 1 2 1 1 1")
add("quarter-disc-clockwise", "reversed", "The quarter disc mirrored.", 2, "0,1 1,1 1,0 0,1/2 1/2,0 0,0", "2 1 1 1 1 1")


def whole_disc():
    """The circle through a 13-14-15 triangle: poles of the sides, weights the cosines of the opposite angles."""
    corners, centre, weights = [(Q(0), Q(0)), (Q(14), Q(0)), (Q(5), Q(12))], (Q(7), Q(33, 8)), ["33/65", "5/13", "3/5"]
    poles = []
    for a, b in zip(corners, corners[1:] + corners[:1]):
        m = [(a[k] + b[k]) / 2 - centre[k] for k in (0, 1)]
        factor = Q(65, 8) ** 2 / (m[0] ** 2 + m[1] ** 2)
        poles.append(tuple(centre[k] + factor * m[k] for k in (0, 1)))
    points = [corners[0], poles[0], corners[1], poles[2], poles[1], corners[2]]
    return text(points), ["1", weights[0], "1", weights[2], weights[1], "1"]


add("whole-disc", "degenerate", "A whole disc as one conic triangle on a 13-14-15 triangle: the circle is smooth at the "
    "corners, where det J = 0.", 2, *whole_disc())
add("annulus-sector", "injective", "Quarter annulus between radii 1 and 2.", (2, 1), "2,0 2,2 0,2 1,0 1,1 0,1", "1 1 2 1 1 2")
add("annulus-sector-clockwise", "reversed", "Quarter annulus with the radius running outwards.", (2, 1),
    "1,0 1,1 0,1 2,0 2,2 0,2", "1 1 2 1 1 2")
add("quarter-disc-collapsed", "degenerate", "Quarter disc as an annulus of inner radius 0: det J = 0 along that edge.", (2, 1),
    "2,0 2,2 0,2 0,0 0,0 0,0", "1 1 2 1 1 2")
add("disc-biquadratic", "degenerate", "The unit disc as one biquadratic patch: smooth at its four corners, where det J = 0.",
    (2, 2), "1,0 1,1 0,1 1,-1 0,0 -1,1 0,-1 -1,-1 -1,0", "1 1 2 1 2 1 2 1 1")
add("quad-rational-bilinear", "injective", "Square with weights 1, 2, 3, 1/2.", (1, 1),
    "0,0 1,0 0,1 1,1", "1 2 3 1/2")
add("quad-rational-folded", "folded", "Biquadratic with an inner point of weight 50 outside.", (2, 2),
    "0,0 1,0 2,0 0,1 3,1 2,1 0,2 1,2 2,2", "1 1 1 1 50 1 1 1 1")
add("projective", "injective", "The identity reparametrised projectively: weights a^i b^j c^k, points evenly spaced; "
    "YLC22 Theorem 1 holds.", 2, grid(2), "1 2 4 5 10 25")
add("cubic-any-weights", "injective", "Curved cubic that satisfies YLC22 Theorem 1, hence injective for all weights; "
    "weights from 1e-3 to 1e3.", 3, "2,1 10,1 15,0 23,2 1,8 8,9 18,9 0,17 9,16 -2,22", "0.001 1000 1 0.5 1000 0.001 20 0.03 1000 0.001")
add("conic-any-weights", "injective", "Curved quadratic that satisfies YLC22 Theorem 1; weights from 1e-3 to 1e3.", 2,
    "-1,1 6,0 11,-1 1,7 4,7 2,9", "1000 0.001 1 0.001 1000 0.1")
add("weights-fold", "folded", "The net of weights-fold-equal, which folds with weights from 1e-3 to 1e3.", 2,
    "-1,0 6,-1 8,2 1,6 4,4 2,11", "0.001 30 30 0.001 30 1000")
add("weights-fold-equal", "injective", "The net of weights-fold with equal weights; quadratic with det J > 0.", 2,
    "-1,0 6,-1 8,2 1,6 4,4 2,11")
add("rational-cubic-folded", "folded", "Cubic with an edge point beyond the opposite edge.", 3,
    [("1", "4") if p == ("1", "0") else p for p in grid(3)], "1 2 1 1 1 1 1 1 1 1")
add("rational-cubic-subdivision", "injective", "A coefficient of N is negative; subdivision proves det J > 0, and the "
    "boundary is simple.", 3, "-1,-1 7,-1 17,2 22,2 -2,10 8,9 15,6 0,16 6,14 -1,24", "4 1 4 1 1/4 1/2 1/4 1/4 2 1/4")

# ---- decimal numbers and their nearest doubles ------------------------------------------------------------

PAIR = "Pair decimal / nearest doubles (exact values written as fractions). "
for name, points, decimal, binary, degree, why in [
        ("thin-a", "0.0,0.1 0.3,0.5 0.6,0.9", "degenerate", "injective", 1, "Collinear as decimals."),
        ("thin-b", "0.2,0.0 0.5,0.4 0.8,0.8", "degenerate", "reversed", 1, "Collinear as decimals."),
        ("thin-c", "0,0 0.5,0.5 1,1.00000000000000000000001", "injective", "degenerate", 1, "Collinear as doubles."),
        ("corner-a", "0.5,0.4 0.8,0.8 0.7,1.4 0.2,0.0 0.2,0.9 -0.4,0.4", "degenerate", "folded", 2,
         "Corner 0 is flat as decimals, beyond flat as doubles."),
        ("corner-b", "0.3,0.5 0.6000000000000000000000001,0.9 0.5,1.5 0.0,0.1 0.0,1.0 -0.6,0.5", "folded", "injective", 2,
         "Corner 0 is beyond flat by 4e-26 as decimals, below flat as doubles.")]:
    add(f"{name}-decimal", decimal, PAIR + why, degree, points)
    add(f"{name}-doubles", binary, PAIR + why, degree, doubles(points))

# ---- size of numbers and degrees --------------------------------------------------------------------------

CURVED = [(0, 0), (10, -2), (20, -2), (30, 0), (-1, 10), (10, 11), (21, 9), (1, 20), (11, 21), (0, 30)]
FOLDED = [(0, 0), (10, 25), (20, 25)] + CURVED[3:]
SIZES = [("huge", "of size 1e150", "{}e149"), ("tiny", "of size 1e-150", "{}e-151"), ("offset", "offset by 1e8", None)]
for name, size, template in SIZES:
    for shape, verdict, net in [("curved", "injective", CURVED), ("folded", "folded", FOLDED)]:
        add(f"{name}-{shape}", verdict, f"Cubic with coordinates {size}.", 3,
            [tuple(template.format(x) if template else f"{1e8 + x / 8:.3f}" for x in p) for p in net])

TEN = grid(10, 1, 1, 10, Q(1, 20))
WEIGHTS = [str(Q(Random(e[1] * 100 + e[2]).randint(50, 60), 50)) for e in triangle_indices(10)]
add("degree-10", "injective", "Evenly spaced net of degree 10, each point moved by at most 1/20.", 10, TEN)
add("degree-10-clockwise", "reversed", "The same, mirrored.", 10, [(y, x) for x, y in TEN])
add("degree-10-folded", "folded", "The same with one edge point moved to height 12, beyond the opposite edge.", 10,
    [(p[0], "12") if k == 5 else p for k, p in enumerate(TEN)])
add("degree-10-rational", "injective", "The same net with weights between 1 and 6/5.", 10, TEN, WEIGHTS)
add("degree-10-rational-even", "injective", "Evenly spaced net with weights from 1e-3 to 1e3: YLC22 Theorem 1 holds.", 10,
    grid(10), [["0.001", "1", "1000", "3"][(3 * e[1] + e[2] * e[2]) % 4] for e in triangle_indices(10)])
add("degree-10x10", "injective", "Evenly spaced net of degrees 10 and 10, each point moved by at most 1/20.", (10, 10),
    square(10, 10, 1, 11, Q(1, 20)))
add("degree-10x10-folded", "folded", "The same with one inner point moved to height 400.", (10, 10),
    [(p[0], "400") if k == 60 else p for k, p in enumerate(square(10, 10, 1, 11, Q(1, 20)))])

# ---- prescribed Jacobian determinants: zeros that dyadic subdivision finds ---------------------------------

jacobian("zero-edge", "degenerate", "g = t: zero along an edge that is mapped one to one.", poly((1, T)))
jacobian("zero-edge-collapsed", "degenerate", "g = s: zero along an edge mapped to one point.", poly((1, S)))
jacobian("zero-two-edges", "degenerate", "g = s t: zero along two edges.", poly((1, S, T)))
jacobian("zero-corner", "degenerate", "g = s^2 + t^2: zero at corner 0 alone.", poly((1, S, S), (1, T, T)))
jacobian("zero-edge-midpoint", "degenerate", "g = (s - 1/2)^2 + t: zero at the midpoint of an edge alone.",
         poly((1, S, S), (-1, S), (Q(1, 4),), (1, T)))
jacobian("zero-line-quad", "degenerate", "g = (u - 1/4)^2: zero along a dyadic line.",
         poly((1, S, S), (Q(-1, 2), S), (Q(1, 16),)), "quadrilateral")
jacobian("zero-inside-quad", "degenerate", "g = (u - 1/2)^2 + (v - 1/4)^2: one dyadic zero inside.",
         poly((1, S, S), (-1, S), (1, T, T), (Q(-1, 2), T), (Q(5, 16),)), "quadrilateral")
