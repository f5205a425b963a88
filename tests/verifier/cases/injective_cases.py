"""The claim `injective`: hull, and INJECTIVE: midpoint, orientation, boundary."""
from book import *
from evidence import boundary, pair_evidence, sign, tempting_boundary
from sign_cases import clockwise, dip, linear, linear41, trap, unit
from writing import *


def regular(name):
    x = element(name)
    return sign(x.N, x.triangle, x.N_degree)


def polynomial_quad(name, x, y, p, q):
    return elements_file(name, bez_file(quad(list(zip(control_quad(x.terms, p, q), control_quad(y.terms, p, q))), p, q)))


# Straight triangle: everything proves it.
good("midpoint-linear", linear, "injective coefficients midpoint")
good("hull-linear", linear, "injective hull")
good("orientation-linear", linear, "injective coefficients orientation")
edges = "m 1 0 m -1 1 m 0 -1"
j01, j02, j12 = "j 1 2", "j -1 1", "j -2 -1"
for name, evidence in {
        "m-j": f"{edges} {j01} {j02} {j12}", "h": f"h m 1 0 m 1 0 j 1 0 m -1 1 m 0 -1 {j01} {j02} {j12}",
        "h-h": f"h h m 1 0 m 1 0 j 1 0 m 2 1 j 3 0 m -1 1 m 0 -1 {j01} {j02} {j12}", "a": f"{edges} a s 1 1 {j01} {j02} {j12}",
        "b": f"{edges} b {j01} s 0 1 {j02} {j12}", "a-begin": f"{edges} {j01} a {j02} s -1 0 {j12}", "b-end": f"{edges} {j01} b s -1 1 {j02} {j12}",
        "a-b": f"{edges} {j01} {j02} a s -1 0 b {j12} s -1 -1", "r": f"{edges} r r r", "a-r":
        f"{edges} a r r {j02} b r s -1 -1"}.items():
    good("boundary-" + name, linear, "injective coefficients boundary " + evidence)
for name, evidence in {
        "m-backwards": f"m -1 0 m -1 1 m 0 -1 {j01} {j02} {j12}", "m-constant": f"m 0 1 m -1 1 m 0 -1 {j01} {j02} {j12}",
        "m-null": f"m 0 0 m -1 1 m 0 -1 {j01} {j02} {j12}", "m-last": f"m 1 0 m -1 1 m 0 1 {j01} {j02} {j12}",
        "h-pair": f"h m 1 0 m 1 0 j 0 1 m -1 1 m 0 -1 {j01} {j02} {j12}", "h-pair-s": f"h m 1 0 m 1 0 s 1 0 m -1 1 m 0 -1 {j01} {j02} {j12}",
        "h-pair-r": f"h m 1 0 m 1 0 r m -1 1 m 0 -1 {j01} {j02} {j12}", "h-second": f"h m 1 0 m 0 1 j 1 0 m -1 1 m 0 -1 {j01} {j02} {j12}",
        "j-wrong-sign": f"{edges} j -1 -2 {j02} {j12}", "j-swapped": f"{edges} {j01} j 1 -1 {j12}", "j-last": f"{edges} {j01} {j02} j 2 1",
        "j-end-not-strict": f"{edges} j 0 1 {j02} {j12}", "j-other-end-not-strict": f"{edges} j 1 1 {j02} {j12}", "j-null": f"{edges} j 0 0 {j02} {j12}",
        "s-at-joint": f"{edges} s 1 2 {j02} {j12}", "a-joint-in-other-half": f"{edges} a {j01} s 1 1 {j02} {j12}",
        "b-joint-in-other-half": f"{edges} b s 0 1 {j01} {j02} {j12}", "a-both-j": f"{edges} a {j01} {j01} {j02} {j12}",
        "a-begin-joint-in-other-half": f"{edges} {j01} a s -1 0 {j02} {j12}", "b-end-joint-in-other-half": f"{edges} {j01} b {j02} s -1 1 {j12}",
        "pairs-in-other-order": f"{edges} {j01} {j12} {j02}"}.items():
    bad("boundary-" + name, linear, "injective coefficients boundary " + evidence)
bad("boundary-clockwise", clockwise, "injective coefficients boundary m 0 1 m 1 -1 m -1 0 r r r")
bad("regular-midpoint", clockwise, "injective coefficients midpoint")
good("reversed-boundary-not-asked", clockwise, "reversed coefficients")

# Straight quadrilateral: opposite edges without a joint.
good("midpoint-square", unit, "injective coefficients midpoint")
good("hull-square", unit, "injective hull")
sides = "boundary m 1 0 m 0 1 m -1 0 m 0 -1"
good("boundary-square", unit, f"injective coefficients {sides} j 1 1 s 0 1 j -1 1 j -1 1 s -1 0 j -1 -1")
good("boundary-square-r", unit, f"injective coefficients {sides} r a r r r r b r r r")
bad("boundary-square-j-without-joint", unit, f"injective coefficients {sides} j 1 1 j 0 1 j -1 1 j -1 1 s -1 0 j -1 -1")
bad("boundary-square-s-wrong", unit, f"injective coefficients {sides} j 1 1 s 1 0 j -1 1 j -1 1 s -1 0 j -1 -1")
bad("boundary-square-s-swapped", unit, f"injective coefficients {sides} j 1 1 s 0 -1 j -1 1 j -1 1 s -1 0 j -1 -1")
bad("boundary-square-s-null", unit, f"injective coefficients {sides} j 1 1 s 0 0 j -1 1 j -1 1 s -1 0 j -1 -1")
bad("orientation-square", unit, "injective coefficients orientation")
bad("boundary-square-other-corner", unit, f"injective coefficients {sides} j 1 1 s 0 1 j 1 1 j -1 1 s -1 0 j -1 -1")

# Curved triangles.
cubic = elements_file("cubic.bez.json", bez_file(triangle(
    [tuple(map(Q, p.split())) for p in ["0 0", "1 -1/2", "2 1/4", "3 0", "1/4 1", "1 1", "9/4 1", "-1/4 2", "1 9/4", "0 3"]], 3)))
s = regular(cubic)
good("hull-cubic", cubic, "injective hull")
good("boundary-cubic", cubic, f"injective {s} {boundary(element(cubic))}")
bad("midpoint-cubic", cubic, f"injective {s} midpoint")
lagrange = elements_file("cubic-nodes.bez.json", bez_file(triangle(
    [tuple(map(Q, p.split())) for p in ["0 0", "1 -1/8", "2 1/8", "3 0", "1/8 1", "1 1", "2 1", "-1/8 2", "1 2", "0 3"]], 3, basis="lagrange")))
good("hull-lagrange", lagrange, "injective hull")
good("boundary-lagrange", lagrange, f"injective {regular(lagrange)} {boundary(element(lagrange))}")
# Quadratic, far from straight.
bent = elements_file("bent.bez.json", bez_file(triangle([tuple(map(Q, p.split())) for p in ["0 0", "1 -1", "2 0", "1/8 1", "13/8 13/8", "0 2"]], 2)))
good("midpoint-bent", bent, f"injective {regular(bent)} midpoint")
good("boundary-bent", bent, f"injective {regular(bent)} {boundary(element(bent))}")
# A sickle: its edges turn by more than half a circle, so m alone does not do.
w = Q(1, 16)


def ribbon(name, node):
    """Along (t^2 - node, t (t^2 - node)), t = 4 u - 2, to the left of it: the curve meets itself at t = +- sqrt(node)."""
    t = 4 * U - 2
    x, y = t ** 2 - node, t ** 3 - node * t
    dx, dy = 2 * t, 3 * t ** 2 - node
    return polynomial_quad(name + ".bez.json", x - w * V * dy, y + w * V * dx, 3, 1)


def sickle(name, last):
    """Along (t^2, t^3 / 3 - last t), not closed."""
    t = 4 * U - 2
    x, y = 2 * t ** 2, t ** 3 * Q(1, 3) + last * t
    return polynomial_quad(name + ".bez.json", x - w * V * (t ** 2 + last), y + w * V * (4 * t), 3, 1)


turn = sickle("sickle", 1)
good("boundary-sickle", turn, f"injective {regular(turn)} {boundary(element(turn))}")
bad("hull-sickle", turn, "injective hull")
bad("midpoint-sickle", turn, f"injective {regular(turn)} midpoint")
bad("boundary-sickle-m", turn, f"injective {regular(turn)} boundary m 0 1 m -1 0 m 0 -1 m 1 0 " + boundary(element(turn)).split("m ", 4)[4].split(" ", 2)[2])

# Regular, but not injective: every evidence fails.
cross1, cross2 = ribbon("ribbon", 1), ribbon("ribbon-irrational", 2)
for name, where in (("ribbon", cross1), ("ribbon-irrational", cross2)):
    s = regular(where)
    bad(f"midpoint-{name}", where, f"injective {s} midpoint")
    bad(f"hull-{name}", where, "injective hull")
    bad(f"boundary-{name}", where, f"injective {s} {tempting_boundary(element(where), 8)}")
    bad(f"boundary-{name}-r", where, f"injective {s} {tempting_boundary(element(where), 8, 'r')}")
    good(f"regular-{name}", where, f"regular {s}")


def net(text):
    return [tuple(map(Q, p.split(","))) for p in text.split()]


# z -> z^3 in coordinates (1, w), w a third root of unity (corpus/elements: overlapping-corners, -edge-third).
corners = elements_file("overlapping-corners.bez.json", bez_file(triangle(net("1,0 1,1 0,1 -1,0 0,1 -1,0 -1,-1 -1,-1 0,-1 1,0"), 3)))
third = elements_file("overlapping-third.bez.json", bez_file(triangle(net(
    "1/8,0 1/2,0 2,0 8,0 -1/16,1/4 -1/4,1 -1,4 -15/32,-3/4 -15/8,-3 111/64,15/16"), 3)))
for name, where in (("corners", corners), ("third", third)):
    s = regular(where)
    bad(f"hull-overlapping-{name}", where, "injective hull")
    for evidence in ("midpoint", "orientation", tempting_boundary(element(where), 8), tempting_boundary(element(where), 8, "r")):
        bad(f"{evidence.split()[0]}-overlapping-{name}" + ("-r" if " r" in evidence else ""), where, f"injective {s} {evidence}")
    good(f"regular-overlapping-{name}", where, f"regular {s}")

# Rational elements.
disc = elements_file("quarter-conic.bez.json", bez_file(triangle(net("0,0 1/2,0 1,0 0,1/2 1,1 0,1"), 2, weights=[1, 1, 1, 1, Q(3, 4), 1])))
s = regular(disc)
good("hull-rational-triangle", disc, "injective hull")
good("orientation-rational", disc, f"injective {s} orientation")
good("boundary-rational", disc, f"injective {s} {boundary(element(disc))}")
good("boundary-rational-r", disc, f"injective {s} boundary m 1 0 m -1 1 m 0 -1 r j -1 1 j -2 -1")
# Straight edges of degree 2: F and G have degree 1 in t there.
good("boundary-rational-r-all", disc, f"injective {s} boundary m 1 0 m -1 1 m 0 -1 r r r")
bad("midpoint-rational", disc, f"injective {s} midpoint")
flat = elements_file("orientation-flat.bez.json", bez_file(triangle(net("0,0 1,0 2,0 0,1 1,0 0,2"), 2, weights=[1, 2, 1, 2, 3, 1])))
bad("orientation-flat", flat, "injective coefficients orientation")
conic_quad = elements_file("rational-quad.bez.json", bez_file(quad(net("1,0 2,0 1,1 2,2 0,1 0,2"), 1, 2, weights=[1, 1, Q(3, 4), Q(3, 4), 1, 1])))
s = regular(conic_quad)
good("boundary-rational-quad", conic_quad, f"injective {s} {boundary(element(conic_quad))}")
good("hull-rational-quad", conic_quad, "injective hull")
equal = elements_file("equal-weights.bez.json", bez_file(triangle(net("0,0 1,-1/4 2,0 0,1 1,1 0,2"), 2, weights=[Q(5, 7)] * 6)))
good("midpoint-equal-weights", equal, f"injective {regular(equal)} midpoint")
fold_weights = elements_file("weights-fold.bez.json", bez_file(triangle(net("0,0 3/4,1/4 1,0 0,1/2 1/2,1/2 0,1"), 2, weights=[1, 16, 1, 1, 1, 1])))
bad("orientation-fails", fold_weights, "injective coefficients orientation")
bad("orientation-violated", trap, "injective coefficients orientation", basis="bernstein")
bad("orientation-folded", trap, "injective coefficients orientation")
bad("hull-fails", fold_weights, "injective hull")
bad("hull-folded", trap, "injective hull")
bad("hull-clockwise", clockwise, "injective hull")
good("hull-bent", bent, "injective hull")
good("midpoint-trap-control-points", trap, "injective coefficients midpoint", basis="bernstein")
bad("midpoint-trap-nodes", trap, "injective coefficients midpoint")
