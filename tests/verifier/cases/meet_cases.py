"""MEET of one element, claim `overlapping`."""
from book import *
from curves import check_meet, point, read_meet
from injective_cases import corners, cross1, cross2, cubic, disc, linear, net, regular, third, turn, unit
from sign_cases import trap
from tokens import Rejected, Tokens
from writing import *

s1, s2, s3, s4 = regular(cross1), regular(cross2), regular(corners), regular(third)
good("overlapping-at", cross1, f"overlapping {s1} at 0 1/4 0 3/4")
good("overlapping-at-exchanged", cross1, f"overlapping {s1} at 0 3/4 0 1/4")
good("overlapping-at-corners", corners, f"overlapping {s3} at 0 0 2 0")
good("overlapping-at-corner-other-names", corners, f"overlapping {s3} at 2 1 1 1")
good("overlapping-cross", cross1, f"overlapping {s1} cross 0 7/32 9/32 0 23/32 25/32")
good("overlapping-cross-exchanged", cross1, f"overlapping {s1} cross 0 23/32 25/32 0 7/32 9/32")
good("overlapping-root", cross2, f"overlapping {s2} root -2,0,1 1 2 0 2,1/4 0 2,-1/4")
good("overlapping-root-end", cross2, f"overlapping {s2} root -2,0,1 1 3/2 0 2,-1/4 0 2,1/4")
good("overlapping-cross-irrational", cross2, f"overlapping {s2} cross 0 9/64 10/64 0 54/64 55/64".replace("10/64", "5/32").replace("54/64", "27/32"))

for name, meet in {
        "at-same": "at 0 1/4 0 1/4", "at-other": "at 0 1/4 0 5/8", "at-near": "at 0 1/4 0 1025/1366", "at-outside": "at 0 1/4 0 7/4",
        "at-other-edge": "at 0 1/4 2 3/4", "at-one-corner": "at 0 1 1 0", "at-one-corner-last": "at 0 0 3 1", "cross-apart": "cross 0 7/32 9/32 0 5/8 11/16",
        "cross-one-interval": "cross 0 7/32 9/32 0 7/32 9/32", "cross-reversed-interval": "cross 0 9/32 7/32 0 23/32 25/32",
        "cross-reversed-second": "cross 0 7/32 9/32 0 25/32 23/32", "cross-empty-interval": "cross 0 1/4 1/4 0 23/32 25/32",
        "cross-too-wide": "cross 0 0 1/2 0 23/32 25/32", "cross-outside": "cross 0 -1 9/32 0 23/32 25/32",
        "root-other-m": "root -3,0,1 1 2 0 2,1/4 0 2,-1/4"}.items():
    bad("overlapping-" + name, cross1, f"overlapping {s1} {meet}")
# root: x = sqrt 2; the parameters of the node are 1/2 +- x / 4.
for name, meet in {
        "no-m": "root 1 2 0 2,1/4 0 2,-1/4", "one-place": "root -2,0,1 1 2 0 2,1/4 0 2,1/4", "other-parameter": "root -2,0,1 1 2 0 2,1/4 0 3,-1/4", "no-root": "root -2,0,1 3/2 2 0 2,1/4 0 2,-1/4",
        "wide": "root -2,0,1 1 5/2 0 2,1/4 0 2,-1/4", "wide-low": "root -2,0,1 -1 2 0 2,1/4 0 2,-1/4",
        "with-zero": "root -2,0,1 0 2 0 2,1/4 0 2,-1/4", "both-signs": "root -2,0,1 -1 3/2 0 2,1/4 0 2,-1/4",
        "other-edge": "root -2,0,1 1 2 0 2,1/4 2 2,-1/4", "degree-one": "root -3,2 1 2 0 2,1/4 0 2,-1/4"}.items():
    bad("overlapping-root-" + name, cross2, f"overlapping {s2} {meet}")
bad("overlapping-at-irrational", cross2, f"overlapping {s2} at 0 5/32 0 27/32")
bad("overlapping-undecided-sign", trap, "overlapping coefficients at 0 1/4 0 3/4")
# Injective elements: whatever is a point of both edges is their corner.
good_sign = "coefficients"
for name, where, meet in (
        ("common-corner-cross", linear, "cross 0 1/2 1 1 0 1/2"), ("common-corner-cross-whole", linear, "cross 0 0 1 1 0 1"),
        ("common-corner-cross-first", linear, "cross 0 0 1/2 2 1/2 1"), ("common-corner-at", linear, "at 0 1 1 0"), ("common-corner-at-last", linear, "at 2 1 0 0"),
        ("common-corner-root", linear, "root -2,0,1 1 3/2 0 -1,0,1 1 -2,0,1"), ("one-point-root", linear, "root -1,0,2 1/2 1 0 0,1 0 0,1"),
        ("one-point-root-other-text", linear, "root -1,0,2 1/2 1 0 0,1 0 -1,1,2"),
        ("one-edge-cross", linear, "cross 0 0 1 0 0 1"), ("one-edge-cross-common-end", linear, "cross 0 0 1/2 0 1/2 1"), ("one-point-at", unit, "at 2 1/3 2 1/3"),
        ("square-corner-cross", unit, "cross 3 1/2 1 0 0 1/2"), ("square-opposite", unit, "at 0 1/2 2 1/2"), ("cubic-corner-cross", cubic, "cross 0 1/2 1 1 0 1/2"),
        ("sickle-cross", turn, "cross 0 1/8 3/8 0 5/8 7/8"), ("sickle-at", turn, "at 0 1/4 0 3/4"), ("rational-corner", disc, "cross 0 1/2 1 1 0 1/2")):
    bad("overlapping-" + name, where, f"overlapping {regular(where) if where not in (linear, unit) else good_sign} {meet}")

# d = 0: every product is 0.
bad("overlapping-cross-d-zero", cross1, f"overlapping {s1} cross 0 1/4 3/4 2 1/8 7/8")
# The lines through two edges meet, the edges do not.
trapezoid = elements_file("trapezoid.bez.json", bez_file(quad(net("0,0 3,0 1,1 2,1"))))
bad("overlapping-at-beyond-edges", trapezoid, "overlapping coefficients at 1 3/2 3 -1/2")
bad("overlapping-root-beyond-edges", trapezoid, "overlapping coefficients root -2,0,1 1 2 1 3/2 3 -1/2")

# Two edges that cross beside their common corner: found on edges 0 and 2 of `third`.
x = element(third)
hits = []
for i in range(3):
    for j in range(3):
        for a in range(1, 54):
            for b in range(1, 54):
                if i < j and point(x.edge(i), Q(a, 54)) == point(x.edge(j), Q(b, 54)):
                    hits.append((i, Q(a, 54), j, Q(b, 54)))
i, a, j, b = next(h for h in hits if h[1] == Q(1, 9))
good("overlapping-at-thirds", third, f"overlapping {s4} at {i} {a} {j} {b}")
bad("overlapping-at-thirds-edges-exchanged", third, f"overlapping {s4} at {j} {a} {i} {b}")
for r, q in [(Q(k, 256), Q(l, 256)) for k in range(1, 24) for l in range(1, 24)]:
    words = f"cross {i} {a - r} {a + r} {j} {b - q} {b + q}"
    try:
        check_meet(read_meet(Tokens(words), False), x.edge(i), x.edge(j), False, {(0, 1)})
        break
    except Rejected:
        pass
good("overlapping-cross-thirds", third, f"overlapping {s4} {words}")
bad("overlapping-cross-thirds-beside", third, f"overlapping {s4} cross {i} {a + r} {a + 3 * r} {j} {b - q} {b + q}")
