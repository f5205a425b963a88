"""The claim of the mesh: embeddings with gluing, pairs and loops; refutations."""
from book import *
from evidence import boundary, mesh_pairs, sign
from injective_cases import corners, cross1, cross2, disc, net, regular
from mesh_rules import Mesh, box
from sign_cases import edge, linear, trap, unit
from writing import *


def claims_of(name, **words):
    """Every element injective, by the first evidence that does."""
    result = []
    for x in read(name, **words).elements:
        midpoint = not x.rational and (x.p <= 2 if x.triangle else x.p == x.q == 1)
        result.append(f"injective {sign(x.N, x.triangle, x.N_degree)} {'midpoint' if midpoint else boundary(x)}")
    return result


def pairs_of(name, **words):
    return mesh_pairs(Mesh(read(name, **words)))


def embedding(label, name, **words):
    claims, pairs = claims_of(name, **words), pairs_of(name, **words)
    good("embedding-" + label, name, claims, "embedding", pairs, **words)
    return claims, pairs


def wrong_embedding(label, name, claims, lines, line=None, **words):
    """`line`: which of the lines after the mesh's is refused; None: the end."""
    at = 6 + len(claims) + (len(lines) if line is None else line) + 1
    bad("embedding-" + label, name, claims, "embedding", lines, line=at, **words)


def refuted(label, name, claims, claim, **words):
    good("refuted-" + label, name, claims, "refuted " + claim, **words)


def not_refuted(label, name, claims, claim, **words):
    bad("refuted-" + label, name, claims, "refuted " + claim, line=6 + len(claims), **words)


def points(text):
    return [tuple(p.split(",")) for p in text.split()]


# One element.
embedding("one-triangle", linear)
embedding("one-square", unit)
good("mesh-undecided", linear, "injective coefficients midpoint")
wrong_embedding("not-proved-injective", linear, ["regular coefficients"], [], -1)
wrong_embedding("undecided-element", linear, ["undecided"], [], -1)
wrong_embedding("degenerate-element", edge, ["degenerate coefficients at 0 0"], [], -1)

# Two triangles, by nodes; 4.1.
two = elements_file("two.msh", msh41(points("0,0 1,0 1,1 0,1"), ["2 1 2 3", "2 1 3 4"]))
c2, p2 = embedding("two", two)
for i, line in enumerate(p2):
    wrong_embedding(f"two-without-pair-{i}", two, c2, p2[:i] + p2[i + 1:])
words = p2[0].split()
wrong_embedding("pair-wrong-direction", two, c2, [" ".join(words[:-2] + [str(-int(w)) for w in words[-2:]])] + p2[1:], 0)
wrong_embedding("pair-of-glued", two, c2, ["pair 1.2 2.0 s 1 0"] + p2, 0)
wrong_embedding("pair-of-itself", two, c2, ["pair 1.0 1.0 s 1 0"] + p2, 0)
wrong_embedding("pair-null", two, c2, [" ".join(words[:-2] + ["0", "0"])] + p2[1:], 0)
broken("embedding-glue", two, c2, "embedding", ["glue 1.2 2.0 1 1"] + p2, line=9)
good("embedding-pairs-in-other-order", two, c2, "embedding", p2[::-1])
# Four triangles around a vertex, 2.2; the tangent (1, 0) lies on an edge.
star = elements_file("star.msh", msh22(points("0,0 1,0 0,1 -1,0 0,-1"), ["2 1 2 3", "2 1 3 4", "2 1 4 5", "2 1 5 2"]))
cs, ps = embedding("star", star)
turned = elements_file("star-turned.msh", msh22(points("0,0 2,1 -1,2 -2,-1 1,-2"), ["2 2 3 1", "2 3 4 1", "2 1 4 5", "2 1 5 2"]))
embedding("star-turned", turned)
# Twice around a vertex: every corner spans 135 degrees of it, six elements, three nodes of the ring moved outwards.
ring = "8,0 -4,7 -4,-7 9,1 -5,8 -5,-8"
double = elements_file("double-star.msh", msh22(points("0,0 " + ring), [f"2 1 {2 + k} {2 + (k + 1) % 6}" for k in range(6)]))
cd = claims_of(double)
uses = [f"{k + 1}.1" for k in range(6)]
wrong_embedding("double-turn-no-pairs", double, cd, [])
wrong_embedding("double-turn", double, cd, [f"pair {a} {b} s 1 0" for i, a in enumerate(uses) for b in uses[i + 1:]], 0)
# Twice around a hole: nothing is branched, each loop has the winding number 2.
spokes = [("1", "2"), ("1.25", "2.25")]
rings = [tuple({0: "0", 1: r, -1: "-" + r}[c] for c in d) for radii in spokes for d in ((1, 0), (0, 1), (-1, 0), (0, -1)) for r in radii]
double_ring = elements_file("double-annulus.msh", msh22(rings, [f"3 {2 * k + 1} {2 * k + 2} {2 * ((k + 1) % 8) + 2} {2 * ((k + 1) % 8) + 1}" for k in range(8)]))
cr = claims_of(double_ring)
wrong_embedding("double-annulus-no-pairs", double_ring, cr, [])
rims = [f"{k + 1}.{e}" for k in range(8) for e in (1, 3)]
wrong_embedding("double-annulus", double_ring, cr, [f"pair {a} {b} r" for i, a in enumerate(rims) for b in rims[i + 1:] if a.split(".")[0] != b.split(".")[0]], 1)
# Eight squares around a hole.
grid = points(" ".join(f"{x},{y}" for y in range(4) for x in range(4)))
squares = [(x, y) for y in range(3) for x in range(3)]
holed = elements_file("hole.msh", msh22(grid, [f"3 {4 * y + x + 1} {4 * y + x + 2} {4 * y + x + 6} {4 * y + x + 5}" for x, y in squares if (x, y) != (1, 1)]))
ch, ph = embedding("hole", holed)
wrong_embedding("hole-without-pair", holed, ch, ph[:-1])
filled = elements_file("no-hole.msh", msh22(grid, [f"3 {4 * y + x + 1} {4 * y + x + 2} {4 * y + x + 6} {4 * y + x + 5}" for x, y in squares]))
embedding("no-hole", filled)
# Mixed, curved, quadratic, nodes and control points.
mixed_nodes = points("0,0 1,0 2,0 0,1 1,1 2,1 0,2 1,2 2,2 3.25,1 2.75,0.25 2.75,1.75")
mixed = elements_file("mixed-p2.msh", msh22(mixed_nodes, ["10 1 3 9 7 2 6 8 4 5", "9 3 10 9 11 12 6"]))
embedding("mixed-p2", mixed)
embedding("mixed-p2-control-points", mixed, basis="bernstein")
# .bez.json: glued by points; degrees (1, 1) and 1 mixed.
by_points = elements_file("by-points.bez.json", bez_file(quad(net("0,0 1,0 0,1 1,1")), triangle(net("1,0 2,1/2 1,1")), triangle(net("0,1 1,1 1/2,3/2"))))
embedding("by-points", by_points)
by_nodes = elements_file("by-nodes.bez.json", bez_file(triangle(None, nodes=[0, 1, 2]), triangle(None, nodes=[2, 1, 3]), points=net("0,0 1,0 0,1 1,1")))
embedding("by-nodes", by_nodes)
# Two components; one in the hole of another.
apart = elements_file("apart.msh", msh22(points("0,0 1,0 0,1 2,0 3,0 2,1"), ["2 1 2 3", "2 4 5 6"]))
embedding("apart", apart)
island_nodes = grid + points("1.25,1.25 1.75,1.25 1.5,1.75")
in_hole = elements_file("in-hole.msh", msh22(island_nodes, [f"3 {4 * y + x + 1} {4 * y + x + 2} {4 * y + x + 6} {4 * y + x + 5}" for x, y in squares if (x, y) != (1, 1)] + ["2 17 18 19"]))
embedding("in-hole", in_hole)
# Rational, nodes with weights; hole of two edges.
disc4 = elements_file("disc.bez.json", bez_file(*[triangle(None, 2, nodes=n) for n in ([0, 9, 1, 10, 5, 2], [0, 10, 2, 11, 6, 3], [0, 11, 3, 12, 7, 4], [0, 12, 4, 9, 8, 1])],
                      points=net("0,0 1,0 0,1 -1,0 0,-1 1,1 -1,1 -1,-1 1,-1 1/2,0 0,1/2 -1/2,0 0,-1/2"), weights=[1] * 5 + [Q(3, 4)] * 4 + [1] * 4))
embedding("disc-rational", disc4)

# -- overlapping meshes --
crossing = elements_file("crossing.msh", msh22(points("0,0 4,0 0,4 1,1 5,1 1,5"), ["2 1 2 3", "2 4 5 6"]))
cc = claims_of(crossing)
all_pairs = [f"pair 1.{i} 2.{j} s 1 1" for i in range(3) for j in range(3)]
wrong_embedding("crossing", crossing, cc, [], None)
wrong_embedding("crossing-pairs", crossing, cc, all_pairs, 0)
wrong_embedding("crossing-r", crossing, cc, ["pair 1.1 2.0 r"], 0)
nested = elements_file("nested.msh", msh22(points("0,0 8,0 0,8 1,1 2,1 1,2"), ["2 1 2 3", "2 4 5 6"]))
cn = claims_of(nested)
wrong_embedding("nested", nested, cn, pairs_of(nested))
good("embedding-pair-not-needed", apart, claims_of(apart), "embedding", ["pair 1.0 2.0 s 1 0"])
wrong_embedding("pair-of-glued-far", star, cs, ["pair 1.2 3.1 s -1 -1"] + ps, 0)
# A component in another's element, where the other has a hole elsewhere.
beside_hole = elements_file("beside-hole.msh", msh22(grid + points("0.25,0.25 0.75,0.25 0.5,0.75"), [
    f"3 {4 * y + x + 1} {4 * y + x + 2} {4 * y + x + 6} {4 * y + x + 5}" for x, y in squares if (x, y) != (1, 1)] + ["2 17 18 19"]))
wrong_embedding("in-element-beside-hole", beside_hole, claims_of(beside_hole), pairs_of(beside_hole))
twice = elements_file("twice.msh", msh22(points("0,0 1,0 0,1 0,0 1,0 0,1"), ["2 1 2 3", "2 4 5 6"]))
wrong_embedding("element-twice", twice, claims_of(twice), [])
same_nodes = elements_file("twice-same-nodes.msh", msh22(points("0,0 1,0 0,1"), ["2 1 2 3", "2 1 2 3"]))
wrong_embedding("element-twice-same-nodes", same_nodes, claims_of(same_nodes), [])
wrong_embedding("element-twice-same-nodes-pairs", same_nodes, claims_of(same_nodes), ["pair 1.0 2.1 j 1 2"], 0)
bowtie = elements_file("pinched.msh", msh22(points("0,0 1,0 1,1 -1,0 -1,-1"), ["2 1 2 3", "2 1 4 5"]))
cb = claims_of(bowtie)
wrong_embedding("pinched", bowtie, cb, ["pair 1.0 2.2 j -1 0"], 0)
wrong_embedding("pinched-other-pair", bowtie, cb, ["pair 1.2 2.0 j -1 0"], 0)
wrong_embedding("pinched-without-pairs", bowtie, cb, [])
slit_nodes = elements_file("slit.msh", msh22(points("0,0 1,0 1,1 0,1 0,0 1,1"), ["2 1 2 3", "2 5 6 4"]))
wrong_embedding("slit-nodes-not-merged", slit_nodes, claims_of(slit_nodes), ["pair 1.2 2.0 s 1 0"], 0)

# -- one curve in two parametrisations --
other = elements_file("reparametrised.bez.json", bez_file(
    triangle(net("0,0 1,0 2,0 0,1 2,2 0,2"), 2), triangle(net("0,2 2,2 2,0 3/2,5/2 5/2,3/2 3,3"), 2, weights=[4, 2, 1, 2, 2, 2])))
cg, pg = embedding("reparametrised", other)
wrong_embedding("pair-of-reparametrised", other, cg, ["pair 1.1 2.0 s 1 1"] + pg, 0)
raised = elements_file("raised.bez.json", bez_file(triangle(net("0,0 1,0 0,1")), triangle(net("1,0 1,1/2 1,1 1/2,1/2 1/2,1 0,1"), 2)))
embedding("raised", raised)
different = elements_file("different-curves.bez.json", bez_file(
    triangle(net("0,0 1,0 2,0 0,1 2,2 0,2"), 2), triangle(net("0,2 2,2 2,0 3/2,5/2 5/2,3/2 3,3"), 2, weights=[4, 3, 1, 2, 2, 2])))
cf = claims_of(different)
wrong_embedding("different-curves-not-glued", different, cf, [])
wrong_embedding("different-curves-pair", different, cf, ["pair 1.1 2.0 s 1 1"], 0)

# Two arcs of one ellipse are a hole: rho = -1 takes one to the other.
small = [((Q(1, 2), Q(-1, 2)), Q(1)), ((Q(2), Q(0)), Q(1, 2)), ((Q(1, 2), Q(1, 2)), Q(1))]
rows = [P.mul1([Q(1), Q(3), Q(3), Q(1)], [w * (p + (1,))[k] for (p, _), w in zip(small, (1, -1, 1))]) for k in range(3)]
large = [tuple(row[i] / [1, 5, 10, 10, 5, 1][i] for row in rows) for i in range(6)]
large = [((x / w, y / w), w) for x, y, w in large[::-1]]
annulus = elements_file("two-arcs.bez.json", bez_file(*[
    quad([p for p, _ in arc] + [(2 * x, 2 * y) for (x, y), _ in arc], len(arc) - 1, 1, weights=[w for _, w in arc * 2]) for arc in (small[::-1], large[::-1])]))
ca, pa = embedding("two-arcs", annulus)
wrong_embedding("two-arcs-no-pair", annulus, ca, [line for line in pa if ".0" not in line])
not_refuted("pinch-two-arcs", annulus, ca, "pinch 1.0 2.1")
not_refuted("touch-two-arcs", annulus, ca, "touch at 1.0 1/2 2.0 1/2")

# -- refutations --
for label, name, claim in (("degenerate", edge, "degenerate coefficients at 0 0"), ("folded", trap, "folded 0 1 at 1 0"), ("overlapping", cross1, f"overlapping {regular(cross1)} at 0 1/4 0 3/4"),
                           ("reversed", "clockwise.msh", "reversed coefficients")):
    x = element(name)
    if label == "folded":
        claim = next(f"folded {u} {v} at 0 0" for u in (Q(0), Q(1, 2), Q(1)) for v in (Q(0), Q(1, 2), Q(1)) if u + v <= 1 and P.value2(x.N, u, v) < 0 <= P.value2(x.N, 0, 0))
    refuted("element-" + label, name, claim if isinstance(claim, list) else [claim], "element 1")
refuted("element-invalid", edge, ["invalid at 0 0"], "element 1")
not_refuted("element-injective", linear, ["injective coefficients midpoint"], "element 1")
not_refuted("element-regular", cross1, [f"regular {regular(cross1)}"], "element 1")
not_refuted("element-undecided", trap, ["undecided"], "element 1")
refuted("cover", crossing, cc, "cover 1 2 5/4 5/4")
refuted("cover-nested", nested, cn, "cover 2 1 5/4 5/4")
refuted("cover-beside-hole", beside_hole, claims_of(beside_hole), "cover 1 9 1/2 1/2")
for label, claim in (("outside-one", "cover 1 2 1/2 1/2"), ("outside-both", "cover 1 2 9 9"), ("same", "cover 1 1 1/2 1/2"), ("on-edge", "cover 1 2 2 2"),
                     ("at-corner", "cover 1 2 1 1")):
    not_refuted("cover-" + label, crossing, cc, claim)
not_refuted("cover-regular", crossing, [cc[0], "regular coefficients"], "cover 1 2 5/4 5/4")
not_refuted("cover-apart", apart, claims_of(apart), "cover 1 2 1/4 1/4")
not_refuted("cover-neighbours", two, c2, "cover 1 2 1/2 1/2")
not_refuted("cover-in-hole", in_hole, claims_of(in_hole), "cover 1 9 3/2 3/2")
refuted("touch-at", crossing, cc, "touch at 1.1 1/4 2.0 1/2")
refuted("touch-cross", elements_file("crossing-inside.msh", msh22(points("0,0 4,0 0,4 1,2 5,1 2,5"), ["2 1 2 3", "2 4 5 6"])),
        claims_of("crossing-inside.msh"), "touch cross 1.1 7/24 13/24 2.0 13/48 19/48")
refuted("touch-twice", twice, claims_of(twice), "touch at 1.0 0 2.0 0")
refuted("touch-slit", slit_nodes, claims_of(slit_nodes), "touch at 1.2 1/2 2.0 1/2")
refuted("touch-one-element", cross1, [f"regular {regular(cross1)}"], "touch at 1.0 1/4 1.0 3/4")
refuted("touch-one-element-root", cross2, [f"regular {regular(cross2)}"], "touch root -2,0,1 1 2 1.0 2,1/4 1.0 2,-1/4")
touching = elements_file("touching.msh", msh22(points("0,0 2,0 0,2 1,1 2,1 2,2"), ["2 1 2 3", "2 4 5 6"]))
ct = claims_of(touching)
refuted("touch-tip", touching, ct, "touch at 1.1 1/2 2.0 0")
refuted("touch-tip-vertex", touching, ct, "touch at 1.1 1/2 2.2 1")
# A parabola touches nothing of y = 1/2 but at (2 +- sqrt 2) / 4: the second element's edge 0 lies on y = 1/2.
parabola = elements_file("parabola.bez.json", bez_file(triangle(net("1,0 1/2,2 0,0 3/4,-1 1/4,-1 1/2,-2"), 2), triangle(net("0,1/2 1,1/2 1/2,2"))))
x = element(parabola)
assert P.value2(x.N, Q(1, 3), Q(1, 3)) != 0
cp = ["undecided", "injective coefficients midpoint"]
# edge 0 at s: (1 - s, 4 s (1 - s)); y = 1/2: s = (2 - r) / 4 with r^2 = 2; the second at t = 1 - s.
refuted("touch-root", parabola, cp, "touch root -2,0,1 1 2 1.0 2,-1/4 2.0 2,1/4")
for label, claim in (("other-m", "touch root -3,0,1 1 2 1.0 2,-1/4 2.0 2,1/4"), ("other-t", "touch root -2,0,1 1 2 1.0 2,-1/4 2.0 2,-1/4"),
                     ("other-edge", "touch root -2,0,1 1 2 1.0 2,-1/4 2.1 2,1/4"), ("at", "touch at 1.0 1/7 2.0 6/7"), ("outside", "touch root -2,0,1 1 3 1.0 2,-1/4 2.0 2,1/4")):
    not_refuted("touch-root-" + label, parabola, cp, claim)
for label, name, claim in (
        ("glued", two, "touch at 1.2 1/3 2.0 2/3"), ("glued-cross", two, "touch cross 1.2 1/4 3/4 2.0 1/4 3/4"), ("common-vertex", two, "touch at 1.0 0 2.2 1"),
        ("common-vertex-glued-begin", two, "touch at 1.2 1 2.2 1"), ("common-vertex-cross", two, "touch cross 1.0 0 1/2 2.2 1/2 1"), ("one-vertex-of-glued", two, "touch at 1.1 1 2.0 1"),
        ("apart", apart, "touch at 1.0 1/2 2.0 1/2"), ("one-element-corner", two, "touch at 1.0 1 1.1 0"), ("one-element-same", two, "touch at 1.0 1/2 1.0 1/2"),
        ("star-centre", star, "touch at 1.0 0 3.0 0"), ("star-corner-root", star, "touch root -2,0,1 1 3/2 1.0 -2,0,1 3.0 -2,0,1"),
        ("far-vertex", star, "touch at 1.1 0 4.1 1"), ("points-vertex", by_points, "touch at 1.1 0 2.2 1"), ("points-glued", by_points, "touch at 1.1 1/2 2.2 1/2")):
    not_refuted("touch-" + label, name, claims_of(name), claim)
refuted("pinch", bowtie, cb, "pinch 1.0 2.0")
for label, name, claim in (("one-fan", star, "pinch 1.0 3.0"), ("neighbours", two, "pinch 1.0 2.0"), ("neighbours-other-side", two, "pinch 1.2 2.1"), ("itself", two, "pinch 1.0 1.0"),
                           ("other-vertices", bowtie, "pinch 1.1 2.0"), ("other-nodes", slit_nodes, "pinch 1.0 2.0"), ("open-fan", holed, "pinch 1.2 2.3")):
    not_refuted("pinch-" + label, name, claims_of(name), claim)
# Cracks. Quadratic triangles that share the ends of an edge, not the node between.
crack = elements_file("crack.msh", msh22(points("0,0 4,0 4,4 0,4 2,0 4,2 2,2.125 2,4 0,2 2,2"), ["9 1 2 3 5 6 7", "9 1 3 4 10 8 9"]))
ck = claims_of(crack)
refuted("gap", crack, ck, "gap 1.2 2.0 1/2")
refuted("gap-exchanged", crack, ck, "gap 2.0 1.2 1/3")
good("embedding-crack-is-a-hole", crack, ck, "undecided")
for label, claim in (("at-end", "gap 1.2 2.0 0"), ("other-use", "gap 1.0 2.0 1/2"), ("outside", "gap 1.2 2.0 3/2"), ("same", "gap 1.2 1.2 1/2"), ("at-other-end", "gap 1.2 2.0 1")):
    not_refuted("gap-" + label, crack, ck, claim)
# An edge that is not regular at its begin, (4 - 4 t^2, 4 - 4 t^2): perhaps it is the one that runs along it.
irregular = elements_file("irregular-edge.msh", msh22(points("0,0 4,0 4,4 0,4 2,0 4,2 4,4 2,4 0,2 2,2"), ["9 1 2 3 5 6 7", "9 1 3 4 10 8 9"]))
ci = ["undecided", "injective coefficients midpoint"]
not_refuted("touch-irregular", irregular, ci, "touch at 1.2 1/2 2.0 3/4", basis="bernstein")
refuted("element-irregular", irregular, ["invalid at 0 1", ci[1]], "element 1", basis="bernstein")
wide = elements_file("lens-hole.msh", msh22(points("0,0 4,0 4,4 0,4 2,0 4,2 2.5,1.5 2,4 0,2 1.5,2.5"), ["9 1 2 3 5 6 7", "9 1 3 4 10 8 9"]))
not_refuted("gap-far", wide, claims_of(wide), "gap 1.2 2.0 1/2")


def quadratic(name, corners, triangles, curved):
    """A mesh of quadratic triangles; `curved`: the node between two corners, if not halfway. Edges listed twice (a, b, a, b) are two."""
    nodes, middles, records = list(corners), {}, []
    for t in triangles:
        record = list(t)
        for k in range(3):
            a, b = t[k], t[(k + 1) % 3]
            middle = curved.get((a, b)) or tuple((Q(x) + Q(y)) / 2 for x, y in zip(corners[a], corners[b]))
            key = (min(a, b), max(a, b), middle)
            if key not in middles:
                middles[key] = len(nodes)
                nodes.append(middle)
            record.append(middles[key])
        records.append("9 " + " ".join(str(n + 1) for n in record))
    return elements_file(name, msh22([tuple("%g" % float(Q(x)) for x in p) for p in nodes], records))


corners8 = points("-8,0 8,0 0,24 0,-24 -20,0 20,0")
around = [(1, 0, 3), (0, 1, 2), (0, 2, 4), (0, 4, 3), (1, 5, 2), (1, 3, 5)]
two_edges = quadratic("two-edge-hole.msh", corners8, around, {(1, 0): (Q(0), Q(-5)), (0, 1): (Q(0), Q(5))})
ct2, pe = embedding("two-edge-hole", two_edges)
k = next(i for i, line in enumerate(pe) if line.startswith("pair 1.0 2.0"))
for label, evidence in (("r", "r"), ("j", "j 0 1"), ("s", "s 0 1")):
    wrong_embedding("two-joints-" + label, two_edges, ct2, pe[:k] + ["pair 1.0 2.0 " + evidence] + pe[k + 1:], k)
not_refuted("gap-two-edge-hole", two_edges, ct2, "gap 1.0 2.0 1/2")
not_refuted("pinch-two-edge-hole", two_edges, ct2, "pinch 1.1 2.0")
narrow = quadratic("narrow-hole.msh", corners8, around, {(1, 0): (Q(0), Q(-1)), (0, 1): (Q(0), Q(1))})
refuted("gap-narrow-hole", narrow, claims_of(narrow), "gap 1.0 2.0 1/2")
not_refuted("gap-none", two, c2, "gap 1.2 2.0 1/2")
not_refuted("gap-reparametrised", other, cg, "gap 1.1 2.0 1/3")
not_refuted("gap-raised", raised, claims_of(raised), "gap 1.1 2.2 1/3")
hanging = elements_file("hanging.msh", msh22(points("0,0 8,0 4,8 4,-0.5 4,-8"), ["2 1 2 3", "2 2 4 5", "2 4 1 5"]))
cx = ["injective coefficients midpoint"] * 3
cx = [c if P.value2(x.N, 0, 0) > 0 else "undecided" for c, x in zip(["injective coefficients midpoint"] * 3, read(hanging).elements)]
refuted("gap-hanging", hanging, cx, "gap 1.0 2.0 3.0")
on_edge = elements_file("hanging-on-edge.msh", msh22(points("0,0 8,0 4,8 4,0 4,-8"), ["2 1 2 3", "2 2 4 5", "2 4 1 5"]))
far = elements_file("hanging-far.msh", msh22(points("0,0 8,0 4,8 4,-2 4,-8"), ["2 1 2 3", "2 2 4 5", "2 4 1 5"]))
ce = ["injective coefficients midpoint"] * 3
for label, name, claim in (("hanging-on-edge", on_edge, "gap 1.0 2.0 3.0"), ("hanging-far", far, "gap 1.0 2.0 3.0"), ("hanging-other-order", hanging, "gap 1.0 3.0 2.0"),
                           ("hanging-not-closed", hanging, "gap 1.0 2.0 3.1"), ("hanging-one-element", hanging, "gap 1.0 1.1 1.2")):
    not_refuted("gap-" + label, name, ce if name != hanging else cx, claim)
chain = elements_file("hanging-two.msh", msh22(points("0,0 8,0 4,8 6,-0.5 2,-0.5 4,-8"), ["2 1 2 3", "2 2 4 6", "2 4 5 6", "2 5 1 6"]))
cy = ["injective coefficients midpoint" if P.value2(x.N, 0, 0) > 0 else "undecided" for x in read(chain).elements]
not_refuted("gap-hanging-two-nodes", chain, cy, "gap 1.0 2.0 4.0")
refuted("touch-hanging-on-edge", on_edge, ce, "touch at 1.0 1/2 2.0 1")

# -- meshes that are embeddings: no refutation may be accepted --
# The neighbours of a thin triangle are no hanging node.
thin = elements_file("thin-triangle.msh", msh22(points("0,0 8,0 4,8 4,-0.5 0,-4 8,-4"), ["2 1 2 3", "2 1 4 2", "2 4 1 5", "2 2 4 6", "2 5 6 4"]))
embedding("thin-triangle", thin)
not_refuted("gap-hanging-thin-triangle", thin, claims_of(thin), "gap 1.0 4.0 3.0")
# Neighbours of a lens of four elements that has two vertices are no crack.
lens = elements_file("lens.msh", msh22(points("-8,0 8,0 0,-0.25 0,0.25 0,-24 0,24 0,-2 0,2 -4,-0.5 4,-0.5 -4,0.5 4,0.5 0,0 -4,-12 4,-12 -4,12 4,12"), [
    "9 1 2 3 7 10 9", "9 2 1 4 8 11 12", "9 1 3 4 9 13 11", "9 3 2 4 10 12 13", "9 2 1 5 7 14 15", "9 1 2 6 8 17 16"]))
embedding("lens", lens, basis="bernstein")
not_refuted("gap-lens", lens, claims_of(lens, basis="bernstein"), "gap 5.0 6.0 1/2", basis="bernstein")
# Elements glued by a change of the parameter are no pinch, and touch nowhere.
not_refuted("pinch-reparametrised", other, cg, "pinch 1.1 2.1")
not_refuted("pinch-raised", raised, claims_of(raised), "pinch 1.1 2.0")
not_refuted("touch-reparametrised", other, cg, "touch at 1.1 1/2 2.0 2/3")
not_refuted("touch-raised", raised, claims_of(raised), "touch at 1.1 1/3 2.2 2/3")
