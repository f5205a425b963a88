"""SIGN and ZERO: coefficients, trees, factors, columns; folded, degenerate, regular, reversed."""
from book import *
from evidence import column_factors, columns, sign, tree
from writing import *

linear = elements_file("linear.msh", msh22([("0", "0"), ("1", "0"), ("0", "1")], ["15 1", "1 1 2", "2 1 2 3"]))
linear41 = elements_file("linear41.msh", msh41([("0", "0"), ("1", "0"), ("0", "1")], ["2 1 2 3"]))
clockwise = elements_file("clockwise.msh", msh22([("0", "0"), ("0", "1"), ("1", "0")], ["2 1 2 3"]))
unit = elements_file("unit-square.msh", msh41([("0", "0"), ("1", "0"), ("1", "1"), ("0", "1")], ["3 1 2 3 4"]))
trap = elements_file("trap.msh", msh22([("0", "0"), ("1", "0"), ("0", "1"), ("0.5", "0.45"), ("0.5", "0.5"), ("0", "0.5")], ["9 1 2 3 4 5 6"]))
# det J at (1, 0) is 1 - 10 * 0.1: a double 0.1 is a little more than a tenth.
tenth = elements_file("tenth.msh", msh22([("0", "0"), ("0.3", "0"), ("0.1", "1")], ["2 1 2 3"]))
thirds = elements_file("collinear-decimal.msh", msh22([("0", "0"), ("0.1", "0.7"), ("0.3", "2.1")], ["2 1 2 3"]))


def jacobian(name, f, on_triangle=True):
    return elements_file(name + ".bez.json", bez_file(jacobian_element(f.terms, on_triangle)))


# -- coefficients --
good("coefficients-linear", linear, "regular coefficients")
good("coefficients-41", linear41, "regular coefficients")
good("coefficients-square", unit, "regular coefficients")
good("coefficients-decimal", tenth, "regular coefficients", numbers="decimal")
good("coefficients-bernstein", trap, "regular coefficients", basis="bernstein")
good("reversed-coefficients", clockwise, "reversed coefficients")
good("undecided", trap, "undecided")
good("undecided-nothing-claimed", clockwise, "undecided")
good("degenerate-decimal-collinear", thirds, "degenerate coefficients at 0 0", numbers="decimal")
bad("coefficients-folded-as-nodes", trap, "regular coefficients")
bad("coefficients-clockwise", clockwise, "regular coefficients")
bad("coefficients-reversed-of-regular", linear, "reversed coefficients")
bad("degenerate-doubles-not-collinear", thirds, "degenerate coefficients at 0 0")
collapsed = elements_file("collapsed-to-line.bez.json", bez_file(triangle([(0, 0), (1, 1), (2, 2)])))
good("degenerate-zero-jacobian", collapsed, "degenerate coefficients at 1/3 1/3")
bad("regular-zero-jacobian", collapsed, "regular coefficients")
bad("reversed-zero-jacobian", collapsed, "reversed coefficients")
bad("injective-zero-jacobian", collapsed, "injective coefficients midpoint")

# N = v: zero along edge 0. All coefficients are >= 0, two corners are not > 0.
edge = jacobian("zero-on-edge", V)
good("degenerate-edge", edge, "degenerate coefficients at 1/3 0")
bad("coefficients-corner-zero", edge, "regular coefficients")
bad("degenerate-at-not-zero", edge, "degenerate coefficients at 1/3 1/3")
bad("degenerate-at-outside", edge, "degenerate coefficients at 4/3 0")
bad("degenerate-at-outside-left", edge, "degenerate coefficients at -1/3 0")
edge_square = jacobian("zero-on-edge-square", V, False)
good("degenerate-edge-square", edge_square, "degenerate coefficients at 1 0")
bad("degenerate-at-outside-square", edge_square, "degenerate coefficients at 9/8 0")
beyond = jacobian("zero-beyond", U + V - 1)
bad("degenerate-at-beyond-hypotenuse", jacobian("zero-line-outside", 3 - U - V * 2 - U), "degenerate coefficients at 1 1/2")
bad("degenerate-negative", beyond, "degenerate coefficients at 1/2 1/2")

# -- tree: 1 - 3 u + 3 u^2 > 0, its middle coefficient is negative --
dip = jacobian("dip", 10 - 39 * U + 39 * U ** 2)
dip_square = jacobian("dip-square", 10 - 39 * V + 39 * V ** 2, False)
for name, where in (("triangle", dip), ("square", dip_square)):
    x = element(where)
    bits = tree(x.N, x.triangle, x.N_degree)
    good(f"tree-{name}", where, f"regular tree {bits}")
    bad(f"tree-coefficients-{name}", where, "regular coefficients")
    bad(f"tree-not-fine-enough-{name}", where, "regular tree " + "100")
# Negative only near (1/2, 1/2 - 1/64): a tree that would skip one leaf would pass.
hole = jacobian("small-fold", (8 * U - 3) ** 2 + (8 * V - 3) ** 2 - F.of(Q(1, 4)))
x = element(hole)
bad("tree-small-fold-as-regular", hole, "regular tree " + "1" * 6 + "0" * 7)
bad("tree-small-fold-as-regular-full", hole, "regular tree " + "111001001100100")
good("folded-at", hole, "folded 3/8 3/8 at 0 0")
good("folded-zero-at", hole, "folded 3/8 3/8 at 7/16 3/8")
bad("folded-not-negative", hole, "folded 7/16 3/8 at 0 0")
bad("folded-positive-first", hole, "folded 0 0 at 3/8 3/8")
bad("folded-second-negative", hole, "folded 3/8 3/8 at 25/64 3/8")
bad("folded-first-outside", hole, "folded 3/8 3/4 at 0 0")
bad("folded-second-outside", hole, "folded 3/8 3/8 at 1 1")
for name, point in (("negative", "3/8 3/8"), ("zero", "7/16 3/8")):
    good("invalid-at-" + name, hole, f"invalid at {point}")
good("invalid-degenerate", edge, "invalid at 1/3 0")
good("invalid-reversed", clockwise, "invalid at 1/3 1/3")
bad("invalid-positive", hole, "invalid at 0 0")
bad("invalid-outside", hole, "invalid at 1 1")
bad("invalid-of-regular", linear, "invalid at 0 0")
bad("invalid-of-regular-outside", jacobian("negative-outside", 2 - 3 * U * V), "invalid at 1 1")
bad("degenerate-folded", hole, "degenerate coefficients at 7/16 3/8")
bad("reversed-folded", hole, "reversed coefficients")
bad("injective-folded-hull", hole, "injective hull")
for evidence in ("midpoint", "orientation", "boundary m 1 0 m -1 1 m 0 -1 j 1 0 j -1 0 j 0 -1"):
    bad("injective-folded-" + evidence.split()[0], hole, "injective coefficients " + evidence)
bad("overlapping-folded", hole, "overlapping coefficients at 0 1/4 0 3/4")
outside_fold = jacobian("fold-outside", 2 - U - V * 2 + F.of(Q(1, 8)))
bad("folded-of-regular", outside_fold, "folded 1 1 at 0 0")
bad("folded-of-reversed", clockwise, "folded 1/3 1/3 at 1/3 1/3")
bad("folded-of-reversed-two-points", clockwise, "folded 1/3 1/3 at 0 0")

# -- ZERO root: N = 2 u^2 - 1 + ..., zero at u = 1/sqrt 2 --
half = jacobian("sqrt-half", 2 * U ** 2 - 1)
good("folded-root", half, "folded 0 0 root -1,0,2 1/2 3/4 0,1 1/4")
good("invalid-root", half, "invalid root -1,0,2 1/2 3/4 0,1 1/4")
bad("invalid-root-interval", half, "invalid root -1,0,2 3/4 1 0,1 0")
bad("invalid-root-outside", half, "invalid root -1,0,2 1/2 3/4 0,1 1/2")
isolated = jacobian("isolated-irrational", (2 * U ** 2 - 1) ** 2 + (4 * V - 1) ** 2, False)
isolated_rational = jacobian("isolated-third", (3 * U - 1) ** 2 + (3 * V - 1) ** 2)
x = element(isolated)
weak = columns(x.N, "u", False, ["1/2", "3/4"], False)
good("degenerate-root", isolated, f"degenerate {weak} root -1,0,2 1/2 3/4 0,1 1/4")
good("degenerate-root-more-in-x", isolated, f"degenerate {weak} root -2,0,1 1 3/2 0,1/2 1/4")
for name, zero in {
        "interval-without-root": "root -1,0,2 3/4 1 0,1 1/4", "interval-two-roots": "root -1,0,2 -1 1 0,1 1/4",
        "interval-reversed": "root -1,0,2 3/4 1/2 0,1 1/4", "no-real-root": "root 1,0,2 1/2 3/4 0,1 1/4",
        "other-m": "root -1,0,3 1/2 3/4 0,1 1/4", "other-v": "root -1,0,2 1/2 3/4 0,1 1/3", "other-u": "root -1,0,2 1/2 3/4 0,1/2 1/4",
        "negative-root": "root -1,0,2 -3/4 -1/2 0,1 1/4", "root-at-end": "root -1,2 1/4 3/4 1/2 1/4",
        "double-root": "root 1,0,-4,0,4 1/2 3/4 0,1 1/4", "interval-too-wide": "root -1,0,2 1/2 3/2 0,1 1/4",
        "interval-end-is-root": "root 0,-1,0,2 0 3/4 0,1 1/4"}.items():
    bad("degenerate-root-" + name, isolated, f"degenerate {weak} {zero}")
conjugate = jacobian("root-outside", (2 * U ** 2 - 1) ** 2 + (4 * V - 5) ** 2, False)
bad("degenerate-root-outside-above", conjugate, "degenerate " + sign(element(conjugate).N, False, element(conjugate).N_degree, False)
    + " root -1,0,2 1/2 3/4 0,1 5/4")
hyp = jacobian("root-beyond-hypotenuse", (2 * U ** 2 - 1) ** 2 + (2 * V - 1) ** 2)
hyp_sign = sign(element(hyp).N, True, element(hyp).N_degree, False)
bad("degenerate-root-beyond-hypotenuse", hyp, f"degenerate {hyp_sign} root -1,0,2 1/2 3/4 0,1 1/2")
on = jacobian("root-on-hypotenuse", (2 * U ** 2 - 1) ** 2 + (U + V - 1) ** 2)
x = element(on)
# f(u, 1 - u) = (2 u^2 - 1)^2, so the fourth of the columns' polynomials has the double root.
good("degenerate-root-on-hypotenuse", on, "degenerate " + columns(x.N, "u", True, ["1/2", "3/4"], False) + " root -1,0,2 1/2 3/4 0,1 1,-1")
bad("degenerate-root-off-hypotenuse", on, "degenerate " + columns(x.N, "u", True, ["1/2", "3/4"], False) + " root -1,0,2 1/2 3/4 0,1 0")
bad("degenerate-of-folded-root", half, "degenerate coefficients root -1,0,2 1/2 3/4 0,1 1/4")
bad("regular-isolated-zero", isolated, "regular " + weak)
bad("regular-isolated-zero-tree", isolated, "regular tree 1111000100100")

# -- columns --
x = element(isolated_rational)
third = columns(x.N, "u", True, ["1/4", "1/2"], False)
zero = "at 1/3 1/3"
good("columns-root", isolated_rational, f"degenerate {third} {zero}")
third_v = columns(x.N, "v", True, ["1/4", "1/2"], False)
good("columns-root-v", isolated_rational, f"degenerate {third_v} {zero}")
words = third.split()
m = int(words[2])


def changed(at, word, source=words):
    return " ".join(source[:at] + [word] + source[at + 1:])


at_e, at_k = 3 + m, 3 + m + 4
assert third.split()[at_k] == "2", third
bad("columns-strict-root", isolated_rational, f"regular {third}")
broken("columns-slab-weak", isolated_rational, f"degenerate {changed(at_k + 4, 'slab')} {zero}")
bad("columns-root-first", isolated_rational, f"degenerate {changed(at_k + 3, 'root')} {zero}")
bad("columns-root-last", isolated_rational, f"degenerate {changed(at_k + 5, 'root')} {zero}")
bad("columns-open-with-root", isolated_rational, f"degenerate {changed(at_k + 4, 'open')} {zero}")
bad("columns-at-a-root", isolated_rational, f"degenerate {changed(at_k + 1, '1/3')} {zero}")
bad("columns-order", isolated_rational, f"degenerate {changed(at_k + 2, '1/5')} {zero}")
bad("columns-equal", isolated_rational, f"degenerate {changed(at_k + 2, '1/4')} {zero}")
bad("columns-at-one", isolated_rational, f"degenerate {changed(at_k + 2, '1')} {zero}")
bad("columns-at-zero", isolated_rational, f"degenerate {changed(at_k + 1, '0')} {zero}")
bad("columns-beyond", isolated_rational, f"degenerate {changed(at_k + 2, '3/2')} {zero}")
for i, which in enumerate(("l", "b", "t", "r")):
    old = words[at_e + i].split(",")
    more = [str(int(old[0]) + 1)] + old[1:]
    bad(f"columns-exponents-{which}", isolated_rational, f"degenerate {changed(at_e + i, ','.join(more))} {zero}")
    k = next((j for j, e in enumerate(old) if e != "0"), None)
    if k is not None:
        less = old[:k] + [str(int(old[k]) - 1)] + old[k + 1:]
        bad(f"columns-exponents-less-{which}", isolated_rational, f"degenerate {changed(at_e + i, ','.join(less))} {zero}")
bad("columns-wrong-variable", jacobian("isolated-unequal", (3 * U - 1) ** 2 + (4 * V - 1) ** 2),
    f"degenerate {changed(1, 'v')} at 1/3 1/4")
s = [w for w in words[3:3 + m]]
bad("columns-wrong-factor", isolated_rational, f"degenerate {changed(3, '-1,4')} {zero}")
broken("columns-constant-factor", isolated_rational, "degenerate " + " ".join(
    ["columns", "u", str(m + 1)] + s + ["7"] + [w + ",0" for w in words[at_e:at_k]] + words[at_k:]) + f" {zero}")
good("columns-factor-not-needed", isolated_rational, "degenerate " + " ".join(
    ["columns", "u", str(m + 1)] + s + ["-7,1"] + [w + ",0" for w in words[at_e:at_k]] + words[at_k:]) + f" {zero}")
two = jacobian("two-isolated", ((3 * U - 1) * (7 * U - 3)) ** 2 + (5 * V - 1) ** 2, False)
x = element(two)
both = columns(x.N, "u", False, ["1/4", "3/8", "1/2"], False)
good("columns-two-roots", two, f"degenerate {both} at 1/3 1/5")
w = both.split()
k = w.index("3")
while not (w[k] == "3" and w[k + 1] == "1/4"):
    k += 1
bad("columns-two-roots-in-one-piece", two, "degenerate " + " ".join(w[:k] + ["2", "1/4", "1/2", "open", "root", "open"]) + " at 1/3 1/5")

curve = jacobian("near-curve", (2 * V - 1) ** 2 + F.of(Q(1, 64)), False)
x = element(curve)
good("columns-strict-no-factors", curve, "regular columns u 0 - - - - 1 1/2 open open")
bad("columns-folded-no-factors", jacobian("on-curve", (2 * V - 1) ** 2 - F.of(Q(1, 64)), False), "regular columns u 0 - - - - 1 1/2 open open")
zero_curve = jacobian("zero-curve", (2 * V - 1) ** 2, False)
bad("columns-zero-curve", zero_curve, "degenerate columns u 0 - - - - 1 1/2 open open at 1/2 1/2")
parabola = jacobian("near-parabola", (V - U ** 2) ** 2 + F.of(Q(1, 64)), False)
strict = columns(element(parabola).N, "u", False, ["1/2"], True)
good("columns-strict", parabola, "regular " + strict)
parabola_folded = jacobian("on-parabola", (V - U ** 2) ** 2 - F.of(Q(1, 64)), False)
base, rows = column_factors(element(parabola_folded).N, "u", False)
bad("columns-strict-folded", parabola_folded, "regular " + " ".join(
    ["columns", "u", str(len(base))] + [",".join(map(str, f)) for f in base] + rows + ["1", "1/32", "open", "open"]))
near_v = jacobian("near-curve-v", (2 * U - 1) ** 2 + F.of(Q(1, 64)), False)
good("columns-v", near_v, "regular columns v 0 - - - - 1 1/2 open open")
bad("columns-u-without-v", near_v, "regular columns u 0 - - - - 1 1/2 open open")
# l = u is 0 at 0: there the number of zeros may change, so the piece needs a slab.
leading = jacobian("leading-zero-at-0", U * V ** 2 + V + 1, False)
slabbed = columns(element(leading).N, "u", False, ["1/5"], True)
assert "slab" in slabbed
good("columns-slab", leading, "regular " + slabbed)
bad("columns-open-at-zero", leading, "regular " + slabbed.replace("slab", "open", 1))
# From infinity: u v^2 - 3 v + 2 + ... at u = 0 the zero is inside, for u > 1/2 there is none.
# On the triangle, one at the corner u = 1.
slab_cut = jacobian("slab-cut", (2 * V - 1) ** 2 + F.of(Q(1, 16)) + U * V ** 3)
words = columns(element(slab_cut).N, "u", True, ["1/16", "1/8", "1/4", "1/2", "3/4"], True).split()
good("columns-slab-all", slab_cut, f"regular {' '.join(words[:-6])} slab slab slab slab slab slab")
slab_fold = jacobian("slab-fold", (2 * V - 1) ** 2 - F.of(Q(1, 16)) + 2 * U)
base, rows = column_factors(element(slab_fold).N, "u", True)
bad("columns-slab-fold", slab_fold, "regular " + " ".join(
    ["columns", "u", str(len(base))] + [",".join(map(str, f)) for f in base] + rows + ["1", "1/2", "slab", "open"]))
# f < 0 between u = 1/4 and 3/4 near v = 1/2: every column claimed lies beside.
island = jacobian("island", (4 * U - 2) ** 2 + (4 * V - 2) ** 2 - 1, False)
base, rows = column_factors(element(island).N, "u", False)
listed = " ".join(["columns", "u", str(len(base))] + [",".join(map(str, f)) for f in base] + rows)
bad("columns-fold-between", island, f"degenerate {listed} 2 1/5 4/5 open root open at 1/2 1/4")
bad("columns-fold-between-open", island, f"degenerate {listed} 2 1/5 4/5 open open open at 1/2 1/4")
bad("columns-fold-on-column", island, f"degenerate {listed} 3 1/5 1/2 4/5 open root root open at 1/2 1/4")
bad("columns-fold-strict", island, f"regular {listed} 2 1/5 4/5 open slab open")
# A zero curve through all columns: f(c, .) > 0 fails.
bad("columns-through-zero", jacobian("zero-curve-across", (2 * V - 1) ** 2 - F.of(Q(1, 9)), False),
    "regular columns u 0 - - - - 1 1/2 open open")
# r = 0: f = (v + 1)^2, a square.
square = jacobian("square", (V + 1) ** 2, False)
bad("columns-r-zero", square, "regular columns u 0 - - - - 1 1/2 open open")
bad("columns-b-zero", edge_square, "degenerate columns u 0 - - - - 1 1/2 open open at 0 0")

# The column lies over a root of l, which r has as well: f is positive there, and everything else holds.
over = jacobian("column-over-root", ((4 * U - 1) * V) ** 2 + V + 1, False)
base, rows = column_factors(element(over).N, "u", False)
listed = " ".join(["columns", "u", str(len(base))] + [",".join(map(str, f)) for f in base] + rows)
good("columns-beside-root", over, f"regular {listed} 1 1/5 slab slab")
bad("columns-over-root", over, f"regular {listed} 1 1/4 slab slab")

# -- factors --
line = jacobian("line-squared", (3 * U - 1) ** 2 * (V + 1))
good("factors-none", line, "degenerate factors 2 2 -1,3 none 1 1;1 + coefficients at 1/3 1/3")
good("factors-minus", line, "degenerate factors 2 2 -1,3 none 1 -1;-1 - coefficients at 1/3 1/3")
good("factors-columns", jacobian("line-times-near", (3 * U - 1) ** 2 * ((2 * V - 1) ** 2 + F.of(Q(1, 64))), False),
     "degenerate factors 2 2 -1,3 none 1 65;-256;256 + columns u 0 - - - - 1 1/2 open open at 1/3 1/3")
good("factors-tree", jacobian("line-times-dip", (3 * V - 1) ** 2 * (1 - 3 * U + 3 * U ** 2), False),
     "degenerate factors 2 2 -1;3 none 1 1,-3,3 + tree 100 at 0 1/3")
good("factors-strict", square, "regular factors 1 2 1;1 + coefficients")
good("factors-two-minus", square, "regular factors 2 1 -1;-1 - coefficients 1 1;1 + coefficients")
good("factors-minus-even", square, "regular factors 1 2 -1;-1 - coefficients")
good("factors-reversed", jacobian("reversed-square", (V + 1) ** 2 * -1, False), "reversed factors 1 2 1;1 + coefficients")
good("factors-weak", zero_curve, "degenerate factors 1 2 -1;2 none at 1/2 1/2")
good("factors-three", jacobian("three-factors", (3 * U - 1) ** 2 * (V + 1) * (U + V + 2)),
     "degenerate factors 3 2 -1,3 none 1 -1;-1 - coefficients 1 -2,-1;-1 - coefficients at 1/3 1/2")
bad("factors-none-strict", line, "regular factors 2 2 -1,3 none 1 1;1 + coefficients")
bad("factors-none-odd", jacobian("line-once", (3 * U - 1) * (V + 1)), "degenerate factors 2 1 -1,3 none 1 1;1 + coefficients at 1/3 1/3")
bad("factors-none-cubed", jacobian("line-cubed", (3 * U - 1) ** 3, False), "degenerate factors 1 3 -1,3 none at 1/3 1/3")
bad("factors-c-negative", jacobian("line-squared-minus", (3 * U - 1) ** 2 * (V + 1) * -1),
    "degenerate factors 2 2 -1,3 none 1 1;1 + coefficients at 1/3 1/3")
bad("factors-sign-of-minus", jacobian("line-squared-minus-b", (3 * U - 1) ** 2 * (V + 2) * -1),
    "degenerate factors 2 2 -1,3 none 1 -2;-1 - coefficients at 1/3 1/3")
bad("factors-wrong-exponent", line, "degenerate factors 2 4 -1,3 none 1 1;1 + coefficients at 1/3 1/3")
bad("factors-missing", line, "degenerate factors 1 2 -1,3 none at 1/3 1/3")
bad("factors-other-factor", line, "degenerate factors 2 2 -1,4 none 1 1;1 + coefficients at 1/3 1/3")
bad("factors-one-coefficient-off", line, "degenerate factors 2 2 -1,3 none 1 2;1 + coefficients at 1/3 1/3")
bad("factors-proof-wrong-sign", line, "degenerate factors 2 2 -1,3 none 1 1;1 - coefficients at 1/3 1/3")
bad("factors-proof-fails", line, "degenerate factors 2 2 -1,3 + coefficients 1 1;1 + coefficients at 1/3 1/3")
bad("factors-of-zero", collapsed, "degenerate factors 1 2 -1,3 none at 1/3 1/3")
bad("factors-huge-exponent", line, "degenerate factors 1 4096 -1,3 none at 1/3 1/3")
saddle = jacobian("saddle", (2 * U - 1) * (2 * V - 1), False)
bad("factors-saddle", saddle, "degenerate factors 2 1 -1,2 + coefficients 1 -1;2 + coefficients at 1/2 0")
good("folded-saddle", saddle, "folded 0 1 at 1/2 0")
