"""The list of corpus/whole: every mesh with its verdict in words."""
from fractions import Fraction as Q

import curves
from whole_build import Mesh, pt
from whole_cases import (CASES, COMPASS, DOMAINS, TINY, annulus, around, around_quads, case, disc, fan, hang, plate,
                         polynomial, ring_with_end, slit, spiral, two_on_edge)

E, INVALID, FOLDED = "embedding", "invalid_element", "folded_vertex"
CROWDED, UNEQUAL, OVERLAP = "non_manifold", "non_conforming", "overlapping_boundary"
HOLES = {(1, 1), (3, 1), (5, 1)}

# ---- embeddings --------------------------------------------------------------------------------------------

case("good-disc-p1", E, "six straight triangles around a centre", fan())
case("good-disc-p2", E, "the same, quadratic with curved edges", fan(2, Q(1, 10)))
case("good-disc-p3", E, "the same, cubic with S-shaped edges", fan(3, Q(1, 20)))
case("good-disc-p4", E, "the same, quartic", fan(4, Q(1, 40)))
case("good-disc-q2", E, "three biquadratic quadrilaterals around a centre", fan(2, Q(1, 20), "quadrilateral"))
case("good-disc-q3", E, "the same, bicubic", fan(3, Q(1, 40), "quadrilateral"))
case("good-disc-conic", E, "the unit disc in four rational quadratic triangles", disc())
case("good-annulus-conic", E, "an annulus in four rational quadrilaterals of degree (2, 1)", annulus())
case("good-holes-q2", E, "a plate with three holes, curved biquadratic quadrilaterals", plate(HOLES, 7, 3, 2))
case("good-holes-p3", E, "the same in cubic triangles", plate(HOLES, 7, 3, 3, True, Q(1, 24)))
case("good-holes-p4", E, "the same in quartic triangles", plate(HOLES, 7, 3, 4, True, Q(1, 40)))
case("good-mixed", E, "quadrilaterals of degree (3, 2) and quartic triangles; shared edges are one quadratic curve, raised",
     plate(set(), 4, 3, 2, mixed=True))
case("good-mixed-holes", E, "the same with three holes", plate(HOLES, 7, 3, 2, mixed=True))
case("good-component-in-hole", E, "a disc in the hole of an annulus: two components", annulus().with_mesh(disc(Q(9, 10))))
case("good-component-close", E, "the same, the circles 1e-12 apart", annulus().with_mesh(disc(1 - TINY)))
case("good-spiral", E, "a spiral strip of 1.25 turns that stays clear of itself", spiral(10, Q(1, 5)))
case("good-spiral-q2", E, "the same in biquadratic quadrilaterals", spiral(10, Q(1, 5), degree=(2, 2)))

# ---- edges and vertices of a surface -----------------------------------------------------------------------


def straight(nodes, triangles, degree=1, bends=(), weights=None):
    m = Mesh()
    ids = m.nodes(nodes)
    for a, b, p in bends:
        m.bend(ids[a], ids[b], p, weights=weights)
    for t in triangles:
        (m.triangle if len(t) == 3 else m.quad)(*(ids[k] for k in t), degree)
    return m


case("edge-same-side", CROWDED, "two triangles that run along edge 0 1 in the same direction, as in a Moebius strip",
     straight("0,0 4,0 1,3 3,2", [(0, 1, 2), (0, 1, 3)]))
case("edge-same-side-p2", CROWDED, "the same, quadratic with a curved edge",
     straight("0,0 4,0 1,3 3,2", [(0, 1, 2), (0, 1, 3)], 2, [(0, 1, "2,-1")]))
case("edge-moebius", CROWDED, "a Moebius band of five triangles: the first and the last run along edge 0 1 in the same direction",
     straight("0,2 1,0 5,6 4,2 6,0", [(0, 1, 2), (2, 1, 3), (2, 3, 4), (4, 3, 0), (4, 0, 1)]))
case("edge-three", CROWDED, "three triangles on edge 0 1", straight("0,0 4,0 2,3 1,-3 3,-2", [(0, 1, 2), (1, 0, 3), (1, 0, 4)]))
case("edge-three-p2", CROWDED, "the same, quadratic with a curved edge",
     straight("0,0 4,0 2,3 1,-3 3,-2", [(0, 1, 2), (1, 0, 3), (1, 0, 4)], 2, [(0, 1, "2,1/2")]))
case("edge-three-conic", CROWDED, "the same, a conic edge",
     straight("0,0 4,0 2,3 1,-3 3,-2", [(0, 1, 2), (1, 0, 3), (1, 0, 4)], 2, [(0, 1, "2,1/2")], [2]))
case("edge-three-quads", CROWDED, "two quadrilaterals and a triangle on edge 0 1",
     straight("0,0 4,0 4,3 0,3 0,-3 4,-3 2,-2", [(0, 1, 2, 3), (4, 5, 1, 0), (1, 0, 6)]))
case("vertex-pinched", CROWDED, "two fans that share node 0 and no edge",
     straight("0,0 2,-1 2,1 -2,1 -2,-1 4,0 -4,0", [(0, 1, 2), (1, 5, 2), (0, 3, 4), (3, 6, 4)]))
case("vertex-pinched-q2", CROWDED, "two biquadratic quadrilaterals that share node 0 alone",
     straight("0,0 2,-1 4,0 2,1 -2,1 -4,0 -2,-1", [(0, 1, 2, 3), (0, 4, 5, 6)], 2))
case("element-twice", CROWDED, "one triangle listed twice", straight("0,0 4,0 0,4 4,4", [(0, 1, 2), (1, 3, 2), (0, 1, 2)]))

# ---- vertices ----------------------------------------------------------------------------------------------

TWICE = [(x * r, y * r) for (x, y), r in zip(COMPASS[::2] * 2, (2, 2, 2, 2, 3, 3, 3, 3))]
case("vertex-wound-twice", FOLDED, "eight triangles wind twice around the inner node 0", around(TWICE, True))
case("vertex-wound-twice-p2", FOLDED, "the same, quadratic with curved edges",
     around(TWICE, True, 2, {0: (1, Q(1, 5)), 3: (Q(1, 5), -1), 5: (Q(-1, 5), Q(3, 2))}))
case("vertex-wound-twice-conic", FOLDED, "the same with conic edges", around(TWICE, True, 2, {0: (1, Q(1, 5)), 5: (Q(-1, 5), 1)}, [3]))
case("vertex-wound-twice-q2", FOLDED, "eight biquadratic quadrilaterals wind twice around node 0",
     around_quads(TWICE, [(x + z, y + w) for (x, y), (z, w) in zip(TWICE, TWICE[1:] + TWICE[:1])], True))


def joukowski(degree=1):
    """w = z + 1/z on the ring 3/5 <= |z| <= 8/5: critical at z = 1 and -1, both boundary loops simple and counter-clockwise."""
    m = Mesh()
    rings = []
    for r in (Q(3, 5), Q(1), Q(8, 5)):
        rings.append([m.node((r + 1 / r) * x, (r - 1 / r) * y) for x, y in COMPASS])
    for inner, outer in zip(rings, rings[1:]):
        for k in range(8):
            a, b, c, d = inner[k], outer[k], outer[(k + 1) % 8], inner[(k + 1) % 8]
            whole = (m.points[a], m.points[b], m.points[c], m.points[d])
            area = lambda i, j, l: ((whole[j][0] - whole[i][0]) * (whole[l][1] - whole[i][1])
                                    - (whole[j][1] - whole[i][1]) * (whole[l][0] - whole[i][0]))
            first = min(area(0, 1, 2), area(0, 2, 3)) > 0
            for t in ((a, b, c), (a, c, d)) if first else ((a, b, d), (b, c, d)):
                m.triangle(*t, degree)
    return m


case("vertex-two-branch-points", FOLDED, "a ring, twice around two inner nodes; the boundary is two simple, disjoint loops", joukowski())
case("vertex-two-branch-points-p2", FOLDED, "the same, quadratic", joukowski(2))
case("vertex-boundary-over", FOLDED, "five triangles of a right angle each around the boundary node 0", around(TWICE[:6]))
case("vertex-boundary-just-over", FOLDED, "around the boundary node 0 the angles sum to one turn and about 1e-12",
     around([(2, 0), (0, 2), (-2, 0), (0, -2), (3, TINY)]))
case("vertex-boundary-just-under", E, "around the boundary node 0 the angles sum to one turn less about 1e-12: a thin wedge is outside",
     around([(2, 0), (0, 2), (-2, 0), (0, -2), (3, -TINY)]))
SQUARE = [(0, 3), (-3, 0), (0, -3)]


def cusp(upper, lower):
    """Node 0 is the tip; the edges to nodes 1 and 5 are y = k x^2 / 4, above and below what should be outside."""
    return around([(2, Q(upper))] + SQUARE + [(2, Q(lower))], degree=2, bend={0: (1, 0), 4: (1, 0)})


case("cusp-outside", E, "the outside of a cusped aerofoil: at the boundary node 0 the angles sum to exactly one turn", cusp(1, -1))
case("cusp-outside-bent", E, "the same, both edges of the cusp curved to one side", cusp(1, Q(1, 2)))
case("cusp-outside-close", E, "the same, edges y = x^2/4 and y = (1 - 1e-12) x^2/4", cusp(1, 1 - TINY))
case("cusp-crossed", FOLDED, "the cusp with the edges exchanged: the mesh covers a sliver at node 0 twice", cusp(-1, 1))
case("cusp-crossed-bent", FOLDED, "the same, both edges curved to one side", cusp(Q(1, 2), 1))
case("cusp-crossed-close", FOLDED, "the same, edges y = (1 - 1e-12) x^2/4 and y = x^2/4", cusp(1 - TINY, 1))

# ---- components and boundaries that meet -------------------------------------------------------------------

case("overlap-crossing", OVERLAP, "two discs of cubic triangles whose boundaries cross",
     fan(3, Q(1, 20)).with_mesh(fan(3, Q(1, 20), at=(5, 1))))
case("overlap-crossing-conic", OVERLAP, "two circular discs whose boundaries cross", disc().with_mesh(disc(1, (Q(3, 2), Q(1, 3)))))
case("overlap-inside", OVERLAP, "a small disc inside another, boundaries apart", fan(2, Q(1, 10)).with_mesh(fan(1, scale=Q(1, 4))))
case("overlap-inside-annulus", OVERLAP, "a small disc inside the material of an annulus",
     annulus().with_mesh(disc(Q(1, 4), (Q(3, 2), Q(1, 20)))))
case("touch-vertex", OVERLAP, "two discs that touch in one point, a vertex of each with a node of its own", fan().with_mesh(fan(at=(8, 0))))
case("touch-vertex-edge", OVERLAP, "a vertex of one disc touches an edge of the other at its parameter 1/3",
     fan().with_mesh(fan(at=(Q(22, 3), 1))))
case("touch-circles", OVERLAP, "two circles touch in one point inside an edge of each", disc().with_mesh(disc(1, (0, 2))),
     [pt(0, 1)])
case("touch-circles-apart", E, "the same, 1e-12 apart: two components", disc().with_mesh(disc(1, (0, 2 + TINY))))
case("touch-circle-in-hole", OVERLAP, "a disc in the hole of an annulus touches it in one point",
     annulus().with_mesh(disc(Q(1, 2), (0, Q(1, 2)))), [pt(0, 1)])
case("spiral-overlap", OVERLAP, "a spiral strip of 1.25 turns that runs over itself", spiral(10, Q(1, 20)))
case("spiral-touch", OVERLAP, "a spiral strip of one turn whose end edge lies along the last 1e-12 of its start edge",
     spiral(8, Q(1, 8), thick=1 + TINY))
case("spiral-touch-vertex", OVERLAP, "the same, end and start edge share one end point, with two nodes", spiral(8, Q(1, 8)))
case("spiral-touch-apart", E, "the same, 1e-12 apart", spiral(8, Q(1, 8), thick=1 - TINY))
case("spiral-overlap-q2", OVERLAP, "the same in biquadratic quadrilaterals", spiral(10, Q(1, 20), degree=(2, 2)))
START = (pt(2, 0), pt(3, 0))
case("strip-touches-point", OVERLAP, "a ring cut open; one corner of its end touches the inside of its start edge",
     ring_with_end(START, (pt("5/2", 0), pt(4, -1))))
case("strip-touches-vertex", OVERLAP, "the same, a corner touches a corner with another node", ring_with_end(START, (pt(3, 0), pt(4, -1))))
case("strip-touches-part", OVERLAP, "the same, the end edge lies along a part of the start edge",
     ring_with_end(START, (pt("5/2", 0), pt("7/2", 0))))
case("strip-touches-edge", OVERLAP, "the same, the end edge lies on the start edge, with other nodes", ring_with_end(START, START))
case("strip-apart", E, "the same, the end 1e-12 before the start", ring_with_end(START, (pt("5/2", -TINY), pt("7/2", -TINY))))
case("slit", OVERLAP, "a crack inside: its middle node is doubled, both ends are not", slit())
case("slit-p2", OVERLAP, "the same along quadratic curves", slit(Q(1, 4), 2))
case("slit-conic", OVERLAP, "the same along conics", slit(Q(1, 4), 2, weight=2))
case("slit-p3", OVERLAP, "the same, cubic triangles", slit(Q(1, 4), 3))
case("slit-open", OVERLAP, "a crack that reaches the boundary, its nodes doubled but for the tip", slit(open_end=True))
case("slit-open-p2", OVERLAP, "the same along quadratic curves", slit(Q(1, 4), 2, True))
case("unmerged", OVERLAP, "good-disc-p2 with nodes of their own for all elements", fan(2, Q(1, 10)).unmerged())
case("unmerged-conic", OVERLAP, "good-annulus-conic likewise", annulus().unmerged())
case("unmerged-q2", OVERLAP, "good-disc-q2 likewise", fan(2, Q(1, 20), "quadrilateral").unmerged())

# ---- edges that do not conform -----------------------------------------------------------------------------

for name, words, line, degree in [
        ("straight", "a straight edge", polynomial((0, 0), (4, 0)), 1),
        ("p2", "a quadratic edge", polynomial((0, 0), (2, 1), (4, 0)), 2),
        ("p3", "a cubic edge", polynomial((0, 0), (1, 1), (3, -1), (4, 0)), 3),
        ("conic", "a conic edge", curves.curve([pt(0, 0), pt(2, 1), pt(4, 0)], [Q(1), Q(2), Q(1)]), 2)]:
    case(f"hanging-{name}", UNEQUAL, f"a hanging node exactly on {words}, at its parameter 1/3", hang(line, Q(1, 3), degree))
case("hanging-middle", UNEQUAL, "a hanging node at the middle of a straight edge", hang(polynomial((0, 0), (4, 0)), Q(1, 2), 1))
ARCH, WAVE = polynomial((0, 0), (2, 1), (4, 0)), polynomial((0, 0), (1, 1), (3, -1), (4, 0))
CONIC = curves.curve([pt(0, 0), pt(2, 1), pt(4, 0)], [Q(1), Q(2), Q(1)])
for suffix, by, words in (("", Q(1, 10), "1/10"), ("-tiny", TINY, "1e-12")):
    case(f"edge-moved{suffix}", UNEQUAL, f"one edge, two quadratic curves: the inner control point moved by {words}",
         two_on_edge(ARCH, polynomial((0, 0), (2, 1 + by), (4, 0))))
    case(f"edge-moved{suffix}-q3", UNEQUAL, f"the same for a cubic edge of quadrilaterals, moved by {words}",
         two_on_edge(WAVE, polynomial((0, 0), (1, 1), (3, -1 + by), (4, 0)), quads=True))
    case(f"edge-weight{suffix}", UNEQUAL, f"one edge, two conics: the inner weight differs by {words}",
         two_on_edge(CONIC, curves.curve(curves.net(CONIC), [Q(1), 2 + by, Q(1)])))
    case(f"edge-slid{suffix}", UNEQUAL, f"a straight edge, one side parametrised unevenly: control point moved along it by {words}",
         two_on_edge(polynomial((0, 0), (2, 0), (4, 0)), polynomial((0, 0), (2 + by, 0), (4, 0))))
case("edge-other-nodes", E, "one edge, equal quadratic curves, inner edge nodes not shared", two_on_edge(ARCH, ARCH))
case("edge-raised", E, "a quadratic edge against the same curve raised to degree 4",
     two_on_edge(ARCH, curves.elevate(curves.elevate(ARCH))))
case("edge-raised-q3", E, "a conic edge against the same raised to degree 3, quadrilaterals",
     two_on_edge(CONIC, curves.elevate(CONIC), quads=True))


def factor(curve, r, times=(Q(1), None)):
    """Reparametrised by r, then times a linear polynomial that gives the last weight its old value."""
    c = curves.reparametrised(curve, r)
    return curves.elevate(c, (times[0], times[1] or curve[-1][2] / c[-1][2]))


LINE = polynomial((0, 0), (4, 0))
case("edge-factor", E, "a conic edge against the same, reparametrised projectively and times a common linear factor",
     two_on_edge(CONIC, factor(CONIC, Q(1, 2))))
case("edge-factor-q3", E, "the same, quadrilaterals", two_on_edge(CONIC, factor(CONIC, Q(3)), quads=True))
case("edge-line-projective", E, "a straight edge against one with weights 1, 5/4, 1: projective times a common factor",
     two_on_edge(curves.elevate(LINE), factor(LINE, Q(2))))
case("edge-line-not-projective", UNEQUAL, "a straight edge against one with weights 1, 2, 1: the same points, no reparametrisation",
     two_on_edge(curves.elevate(LINE), curves.curve([pt(0, 0), pt(2, 0), pt(4, 0)], [Q(1), Q(2), Q(1)])))

# ---- elements ----------------------------------------------------------------------------------------------


def spoiled(mesh, number, change):
    """One element changed; counted from 1."""
    entry = mesh.elements[number - 1]
    entry["nodes"] = change(mesh, list(entry["nodes"]))
    return mesh


def turned(mesh, nodes):
    return [nodes[k] for k in (0, 3, 5, 1, 4, 2)] if len(nodes) == 6 else [nodes[k] for k in (0, 3, 6, 1, 4, 7, 2, 5, 8)]


def centre_moved(mesh, nodes):
    mesh.points[nodes[4]] = pt(30, 30)
    return nodes


def heavy(mesh, weight):
    """The inner point of the curved edge of element 1 moved inwards, with another weight."""
    node = mesh.elements[0]["nodes"][4]
    mesh.points[node], mesh.weights[node] = pt(0, 0), weight
    return mesh


case("element-reversed", INVALID, "good-disc-p2 with element 4 clockwise", spoiled(fan(2, Q(1, 10)), 4, turned))
case("element-reversed-q2", INVALID, "good-disc-q2 with element 2 clockwise", spoiled(fan(2, Q(1, 20), "quadrilateral"), 2, turned))
case("element-folded-q2", INVALID, "good-disc-q2 with an inner control point of element 3 far outside",
     spoiled(fan(2, Q(1, 20), "quadrilateral"), 3, centre_moved))
case("element-folded-p2", INVALID, "good-disc-p2 with edges bent too far: elements folded", fan(2, Q(3, 4)))
case("element-folded-conic", INVALID, "good-disc-conic with the control point of an arc at the centre, weight 40: element 1 is folded",
     heavy(disc(), Q(40)))
case("element-degenerate", INVALID, "one of two triangles has collinear corners",
     straight("0,0 4,0 0,4 8,0", [(0, 1, 2), (1, 0, 3)]))

# ---- elements with points of their own ---------------------------------------------------------------------

case("points-good-disc-p3", E, "good-disc-p3, every element with points of its own: glued by equal edges", fan(3, Q(1, 20)).own_points())
case("points-good-annulus", E, "good-annulus-conic likewise", annulus().own_points())
case("points-good-mixed", E, "good-mixed likewise: edges of different degree", plate(set(), 4, 3, 2, mixed=True).own_points())
case("points-edge-three", CROWDED, "edge-three-p2 likewise",
     straight("0,0 4,0 2,3 1,-3 3,-2", [(0, 1, 2), (1, 0, 3), (1, 0, 4)], 2, [(0, 1, "2,1/2")]).own_points())
case("points-edge-same-side", CROWDED, "edge-same-side likewise", straight("0,0 4,0 1,3 3,2", [(0, 1, 2), (0, 1, 3)]).own_points())
case("points-hanging", UNEQUAL, "hanging-straight likewise", hang(LINE, Q(1, 3), 1).own_points())
case("points-hanging-conic", UNEQUAL, "hanging-conic likewise", hang(CONIC, Q(1, 3), 2).own_points())
case("points-crossing", OVERLAP, "overlap-crossing likewise", fan(3, Q(1, 20)).with_mesh(fan(3, Q(1, 20), at=(5, 1))).own_points())


def quads_on(first, second):
    """Two quadrilaterals with points of their own below and above an edge, given as two homogeneous curves."""
    m = Mesh()
    for curve, y, below in ((first, -4, True), (second, 4, False)):
        n = len(curve) - 1
        far = [pt(Q(4 * i, n), y) for i in range(n + 1)]
        near, weights = list(curves.net(curve)), [w for _, _, w in curve]
        rows = (far + near, [Q(1)] * (n + 1) + weights) if below else (near + far, weights + [Q(1)] * (n + 1))
        m.elements.append({"kind": "quadrilateral", "degree": [n, 1], "points": rows[0], "weights": rows[1]})
    return m


case("points-edge-projective", E, "a conic edge against the same with weights times r^i, r = 3, and times 5",
     quads_on(CONIC, curves.reparametrised(CONIC, 3, Q(5))))
case("points-edge-factor", E, "a conic edge against the same times the common factor (1 - t) + 3 t",
     quads_on(CONIC, curves.elevate(CONIC, (Q(1), Q(3)))))
case("points-line-projective", E, "a straight edge against one with weights 1, 4: projective", quads_on(LINE, curves.reparametrised(LINE, 4)))

# ---- boundaries and feature curves -------------------------------------------------------------------------

CUBIC = polynomial((0, 0), (2, 2), (4, -2), (6, 0))
DROP = polynomial((0, 0), (4, -3), (4, 3), (0, 0))
BOW = curves.curve([pt(0, 0), pt(3, 2), pt(6, 0)], [Q(1), Q(3), Q(1)])


def on_pieces(curve, cuts, change=None, own=False):
    """Quadrilaterals in a row on the pieces of a curve; `change` is (piece, curve made of it)."""
    m, left, bounds = Mesh(), None, [Q(0), *cuts, Q(1)]
    pieces = [curves.part(curve, a, b) for a, b in zip(bounds, bounds[1:])]
    if change:
        pieces[change[0]] = change[1](pieces[change[0]])
    if own:
        for k, piece in enumerate(pieces):
            n, ends = len(piece) - 1, [6 * bounds[k], 6 * bounds[k + 1]]
            top = [(ends[0] + (ends[1] - ends[0]) * Q(i, n), Q(4)) for i in range(n + 1)]
            m.elements.append({"kind": "quadrilateral", "degree": [n, 1], "points": list(curves.net(piece)) + top,
                               "weights": [w for _, _, w in piece] + [Q(1)] * (n + 1)})
        return m
    low = [m.node(*curves.net(p)[0], p[0][2]) for p in pieces] + [m.node(*curves.net(curve)[-1], curve[-1][2])]
    high = [m.node(6 * t, 4) for t in bounds]
    for k, piece in enumerate(pieces):
        m.lay(low[k], low[k + 1], piece)
        m.quad(low[k], low[k + 1], high[k + 1], high[k], (len(piece) - 1, 1))
    return m


CUTS = [Q(1, 3), Q(5, 7)]


def teardrop():
    """Three cubic triangles around a centre, bounded by one closed cubic cut at 1/3 and 2/3."""
    m = Mesh()
    centre, bounds = m.node(2, 0), [Q(0), Q(1, 3), Q(2, 3), Q(1)]
    rim = [m.node(*curves.point(DROP, t)) for t in bounds[:3]]
    for k in range(3):
        m.lay(rim[k], rim[(k + 1) % 3], curves.part(DROP, bounds[k], bounds[k + 1]))
    for k in range(3):
        m.triangle(centre, rim[k], rim[(k + 1) % 3], 3)
    return m


def nudged(by):
    return lambda c: c[:1] + ((c[1][0], c[1][1] + by * c[1][2], c[1][2]),) + c[2:]


case("domain-cubic", E, "three quadrilaterals on pieces of one cubic, cut at 1/3 and 5/7", on_pieces(CUBIC, CUTS))
case("domain-conic", E, "the same on a conic", on_pieces(BOW, CUTS))
case("domain-conic-points", E, "the same, points of their own, pieces reparametrised projectively",
     on_pieces(BOW, CUTS, (1, lambda c: curves.reparametrised(c, 3, Q(7))), True))
case("domain-cubic-nudged", E, "domain-cubic with a control point of the middle piece moved by 1/10", on_pieces(CUBIC, CUTS, (1, nudged(Q(1, 10)))))
case("domain-cubic-nudged-tiny", E, "the same, by 1e-12", on_pieces(CUBIC, CUTS, (1, nudged(TINY))))
case("domain-conic-nudged-tiny", E, "domain-conic, the same by 1e-12", on_pieces(BOW, CUTS, (1, nudged(TINY))))


def frame(bottom):
    return [bottom, polynomial((6, 0), (6, 4)), polynomial((6, 4), (0, 4)), polynomial((0, 4), (0, 0))]


def domain(mesh, name, words, *pairs):
    assert mesh in CASES
    DOMAINS.append((mesh, name, list(pairs), words))


case("domain-teardrop", E, "three cubic triangles bounded by one closed cubic with a corner", teardrop())


def all_covered(*list_of_curves):
    return [(c, True) for c in list_of_curves]


UPRIGHT = polynomial(curves.point(CUBIC, Q(1, 3)), (2, 4))
domain("domain-cubic", "cubic", "four boundary curves, the bottom and the top covered by three edges each; one inner edge as a feature",
       *all_covered(*frame(CUBIC), UPRIGHT))
domain("domain-cubic", "cubic-reversed", "the bottom curve reversed and raised to degree 5",
       *all_covered(curves.reverse(curves.elevate(curves.elevate(CUBIC)))))
domain("domain-cubic", "cubic-end", "the top curve starts beside a node; the feature curve ends beside one",
       (CUBIC, True), (polynomial((6, 4), ("1/10", 4)), False), (polynomial(curves.point(CUBIC, Q(1, 3)), (2, 3)), False))
domain("domain-cubic", "cubic-longer", "the cubic goes on beyond the mesh: covered in part only",
       (polynomial((6, 4), (0, 4)), True), (tuple(curves.split(CUBIC, Q(6, 5))[0]), False))
domain("domain-cubic", "cubic-uneven", "the top line with an uneven parametrisation that no projective map gives",
       (CUBIC, True), (polynomial((6, 4), (2, 4), (0, 4)), False))
domain("domain-teardrop", "teardrop", "one closed curve", (DROP, True))
domain("domain-teardrop", "teardrop-other", "closed curves through the same corner: the same reversed; another", (curves.reverse(DROP), True),
       (polynomial((0, 0), (4, -3), (4, Q(3) + TINY), (0, 0)), False))
domain("domain-conic", "conic", "bottom conic covered by three edges", *all_covered(*frame(BOW)))
domain("domain-conic", "conic-reweighted", "the conic with weights times 2^i, reversed, and raised in degree",
       *all_covered(curves.reverse(curves.reparametrised(BOW, 2)), curves.elevate(BOW, (Q(1), Q(4)))))
domain("domain-conic", "conic-other-weight", "the inner weight of the conic differs by 1e-12",
       (curves.curve(curves.net(BOW), [Q(1), 3 + TINY, Q(1)]), False), (polynomial((6, 4), (0, 4)), True))
domain("domain-conic-points", "conic-points", "bottom conic covered by reweighted pieces", *all_covered(*frame(BOW)))
for mesh, curve in (("domain-cubic-nudged", CUBIC), ("domain-cubic-nudged-tiny", CUBIC), ("domain-conic-nudged-tiny", BOW)):
    domain(mesh, mesh[7:], "the middle edge of the bottom differs", (curve, False), *all_covered(*frame(curve)[1:]))
HALF = curves.curve([pt(1, 0), pt(1, Q(4, 3)), pt("-7/25", "24/25")], [Q(1), Q(3, 5), Q(1)])
domain("good-annulus-conic", "arc", "an arc of the inner circle and one of the outer circle, reversed",
       (HALF, True), (curves.reverse(tuple((2 * x, 2 * y, w) for x, y, w in HALF)), True))
domain("good-disc-conic", "arc-part", "an arc of the circle that ends between nodes", (curves.split(HALF)[0], False), (HALF, True))
