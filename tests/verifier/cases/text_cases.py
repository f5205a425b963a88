"""The text of certificates, and elements files that are none: what is refused as malformed, in every place where a rule of the text applies."""
from book import *
from injective_cases import cross1, cross2, regular
from mesh_cases import bowtie, c2, cb, cc, cg, ck, crack, crossing, cx, hanging, other, p2, pg, two
from sign_cases import clockwise, edge, half, hole, isolated, isolated_rational, leading, linear, slabbed, third, trap, unit, weak, zero_curve
from writing import *

claim = "injective coefficients midpoint"
whole = text(linear, claim)
pairs = text(two, c2, "embedding", p2)


def edited(name, old, new, source=whole, elements=linear, folder="malformed", line=0):
    assert source.count(old) >= 1, (name, old)
    add(folder, name, elements, source.replace(old, new, 1), line)


# -- bytes and lines --
add("malformed", "empty-file", linear, b"")
add("malformed", "one-newline", linear, b"\n")
add("malformed", "binary-junk", linear, bytes((i * i * 7 + 13 * i + 5) % 256 for i in range(700)))
add("malformed", "only-nul", linear, b"\0" * 100)
add("malformed", "header-and-junk", linear, whole.encode()[:40] + bytes(range(128, 256)))
edited("nul-after-end", "end\n", "end\n\0")
edited("nul-in-word", "midpoint", "mid\0point")
edited("nul-before-newline", "midpoint\n", "midpoint\0\n")
edited("not-ascii", "midpoint", "midp\u00f6int")
edited("byte-order-mark", "bezcert", "\ufeffbezcert")
add("malformed", "carriage-returns", linear, whole.replace("\n", "\r\n"))
add("malformed", "old-mac-newlines", linear, whole.replace("\n", "\r"))
edited("one-carriage-return", "midpoint\n", "midpoint\r\n")
edited("tab", "injective coefficients", "injective\tcoefficients")
edited("vertical-tab", "injective coefficients", "injective\vcoefficients")
edited("no-break-space", "injective coefficients", "injective\u00a0coefficients")
edited("two-blanks", "injective coefficients", "injective  coefficients")
edited("blank-at-end", "midpoint\n", "midpoint \n")
edited("blank-at-begin", "1 injective", " 1 injective")
edited("blank-at-end-of-header", "count 1", "count 1 ")
edited("blank-after-end", "end\n", "end \n")
edited("blank-line", "mesh", "\nmesh")
edited("blank-line-first", "bezcert", "\nbezcert")
edited("no-last-newline", "end\n", "end")
edited("no-end", "end\n", "")
edited("end-twice", "end\n", "end\nend\n")
edited("newline-after-end", "end\n", "end\n\n")
edited("lines-after-end", "end\n", "end\nmesh undecided\n")
edited("end-upper-case", "end\n", "END\n")
edited("end-and-word", "end\n", "end now\n")
edited("end-too-early", "mesh", "end\nmesh")
edited("comment", "mesh", "# comment\nmesh")
edited("no-mesh", "mesh undecided\n", "")
edited("mesh-twice", "mesh undecided\n", "mesh undecided\nmesh undecided\n")
edited("mesh-undecided-and-lines", "end\n", "pair 1.0 1.1 s 1 0\nend\n")
edited("lines-after-refuted", "mesh undecided", "mesh refuted element 1\npair 1.0 1.1 s 1 0", text(clockwise, "reversed coefficients"), clockwise)
for cut in (30, 90, 130, 160, 180, 187):
    add("malformed", f"cut-at-{cut}", linear, whole.encode()[:cut])
add("malformed", "cut-after-each-line-1", linear, "".join(whole.splitlines(True)[:5]))
add("malformed", "cut-after-each-line-2", linear, "".join(whole.splitlines(True)[:6]))
add("malformed", "cut-after-each-line-3", two, "".join(pairs.splitlines(True)[:9]))

# -- header --
for name, old, new in (("version-2", "certificate 1", "certificate 2"), ("version-01", "certificate 1", "certificate 01"), ("version-1.0", "certificate 1", "certificate 1.0"),
                       ("no-version", "certificate 1", "certificate"), ("other-format", "bezcert-certificate", "bezcert-report"), ("basis-unknown", "lagrange", "hermite"),
                       ("basis-mixed-for-msh", "lagrange", "mixed"), ("basis-upper-case", "lagrange", "Lagrange"), ("no-basis", "basis lagrange\n", ""), ("two-bases", "basis lagrange", "basis lagrange bernstein"),
                       ("numbers-unknown", "binary64", "binary32"), ("no-numbers", "numbers binary64\n", ""), ("headers-exchanged", "basis lagrange\nnumbers binary64", "numbers binary64\nbasis lagrange"),
                       ("no-count", "count 1\n", ""), ("count-01", "count 1", "count 01"), ("count-word", "count 1", "count one"), ("count-rational", "count 1", "count 1/1"),
                       ("no-elements", "elements ", "element "), ("hash-missing", whole.split("\n")[1], "elements"), ("hash-upper-case", whole.split("\n")[1][9:], whole.split("\n")[1][9:].upper()),
                       ("hash-too-short", whole.split("\n")[1][:20], whole.split("\n")[1][:19]), ("hash-too-long", "\nbasis", "0\nbasis"), ("hash-not-hex", whole.split("\n")[1][9:13], "xyzw"), ("hash-0x", whole.split("\n")[1][9:11], "0x")):
    edited("header-" + name, old, new)
by_json = text(edge, "degenerate coefficients at 0 0")
edited("header-numbers-binary64-for-json", "decimal", "binary64", by_json, edge)
edited("header-basis-lagrange-for-json", "mixed", "lagrange", by_json, edge)
edited("header-basis-bernstein-for-json", "mixed", "bernstein", by_json, edge)
digits = whole.split("\n")[1][9:]
edited("hash-one-digit", digits, digits[:-1] + "0123456789abcdef"[("0123456789abcdef".index(digits[-1]) + 1) % 16], folder="rejected", line=2)
edited("hash-zero", digits, "0" * 64, folder="rejected", line=2)
add("rejected", "hash-of-another-file", clockwise, whole, 2)
add("rejected", "hash-of-another-file-same-claims", unit, whole, 2)
edited("count-less", "count 2", "count 1", pairs, two, "rejected", 5)
edited("count-more", "count 2", "count 3", pairs, two, "rejected", 5)
edited("count-minus", "count 1", "count -1", folder="rejected", line=5)
edited("count-zero", "count 1", "count 0", folder="rejected", line=5)
edited("count-huge", "count 1", "count 18446744073709551617", folder="rejected", line=5)

# -- positions --
lines = pairs.splitlines(True)
add("malformed", "positions-exchanged", two, "".join(lines[:5] + [lines[6], lines[5]] + lines[7:]))
for name, old, new in (("0", "1 injective", "0 injective"), ("2", "1 injective", "2 injective"), ("01", "1 injective", "01 injective"), ("missing", "1 injective", "injective"),
                       ("minus", "1 injective", "-1 injective"), ("plus", "1 injective", "+1 injective"), ("huge", "1 injective", "18446744073709551617 injective"), ("colon", "1 injective", "1: injective")):
    edited("position-" + name, old, new)
add("malformed", "element-twice", two, "".join(lines[:6] + [lines[5]] + lines[6:]))
add("malformed", "element-missing", two, "".join(lines[:6] + lines[7:]))

# -- words of claims --
for name, words in {
        "unknown": "correct coefficients midpoint", "upper-case": "Injective coefficients midpoint", "none": "", "claim-only": "injective", "sign-only": "injective coefficients",
        "unknown-sign": "injective positive midpoint", "unknown-injective": "injective coefficients certainly", "too-much": claim + " midpoint", "hull-too-much": "injective hull midpoint", "hull-after-sign": "injective coefficients hull", "regular-hull": "regular hull", "regular-too-much": "regular coefficients midpoint",
        "undecided-too-much": "undecided coefficients", "regular-nothing": "regular", "boundary-nothing": "injective coefficients boundary",
        "boundary-short": "injective coefficients boundary m 1 0 m -1 1 m 0 -1 j 1 2 j -1 1", "boundary-long": "injective coefficients boundary m 1 0 m -1 1 m 0 -1 j 1 2 j -1 1 j -2 -1 j 1 1",
        "self-unknown": "injective coefficients boundary x 1 0 m -1 1 m 0 -1 j 1 2 j -1 1 j -2 -1", "self-s": "injective coefficients boundary s 1 0 m -1 1 m 0 -1 j 1 2 j -1 1 j -2 -1",
        "pair-unknown": "injective coefficients boundary m 1 0 m -1 1 m 0 -1 q 1 2 j -1 1 j -2 -1", "pair-m": "injective coefficients boundary m 1 0 m -1 1 m 0 -1 m 1 2 j -1 1 j -2 -1",
        "direction-rational": "injective coefficients boundary m 1/2 0 m -1 1 m 0 -1 j 1 2 j -1 1 j -2 -1", "direction-short": "injective coefficients boundary m 1 m -1 1 m 0 -1 j 1 2 j -1 1 j -2 -1",
        "direction-minus-zero": "injective coefficients boundary m 1 -0 m -1 1 m 0 -1 j 1 2 j -1 1 j -2 -1", "direction-decimal": "injective coefficients boundary m 1.0 0 m -1 1 m 0 -1 j 1 2 j -1 1 j -2 -1",
        "self-too-deep": "injective coefficients boundary " + "h " * 600 + "m 1 0 " * 601 + "j 1 0 " * 600 + "m -1 1 m 0 -1 j 1 2 j -1 1 j -2 -1",
        "pair-too-deep": "injective coefficients boundary m 1 0 m -1 1 m 0 -1 " + "a " * 600 + "s 1 1 " * 600 + "j 1 2 j -1 1 j -2 -1"}.items():
    broken("claim-" + name, linear, words)

# -- BITS --
for name, bits in {"one": "1", "short": "10", "long": "1000", "zero": "0", "two-trees": "00", "other-digit": "120", "letter": "1x0", "minus": "-100", "comma": "1,0,0", "blank": "1 0 0", "hexadecimal": "0x4",
                   "missing": "", "too-deep": "1" * 600 + "0" * 601, "too-deep-end": "1" * 600, "uncovered": "110100"}.items():
    broken("tree-" + name, linear, ("regular tree " + bits).rstrip())
broken("slab-bits", leading, "regular " + slabbed.replace("slab", "slab 0"))

# -- INT, RAT --
for name, number in {"not-lowest": "2/6", "denominator-1": "0/1", "denominator-0": "1/0", "denominator-minus": "-1/-3", "minus-below": "1/-3", "leading-zero": "01/3", "leading-zero-below": "1/03", "plus": "+1/3",
                     "minus-zero": "-0", "minus-zero-above": "-0/3", "decimal": "0.333", "exponent": "1e0", "empty-above": "/3", "empty-below": "1/", "two-slashes": "1/3/1", "blank": "1 /3", "hexadecimal": "0x1",
                     "infinite": "inf", "nan": "nan", "two-minus": "--1/3", "letter": "a", "zero-zero": "00", "comma": "1,3", "zero-above": "0/3"}.items():
    broken("rational-" + name, edge, f"degenerate coefficients at {number} 0")
broken("rational-missing", edge, "degenerate coefficients at 0")
broken("rational-too-many", edge, "degenerate coefficients at 1/3 0 0")
broken("zero-missing", edge, "degenerate coefficients")
broken("zero-unknown", edge, "degenerate coefficients near 1/3 0")
broken("folded-one-point", hole, "folded 3/8 3/8")
broken("folded-no-word", hole, "folded 3/8 3/8 0 0")
broken("folded-sign", hole, "folded coefficients 3/8 3/8 at 0 0")
broken("invalid-nothing", hole, "invalid")

# -- POLY, RATPOLY, POLY2 --
for name, zero in {"trailing-zero": "-1,0,2,0", "empty": ",", "comma-first": ",-1,0,2", "comma-last": "-1,0,2,", "two-commas": "-1,,2", "rational": "-1,0,2/1", "rational-inside": "-1/2,0,1", "minus-zero": "-1,-0,2",
                   "leading-zero": "-1,00,2", "plus": "-1,0,+2", "zeros": "0,0", "semicolon": "-1;0;2"}.items():
    broken("polynomial-" + name, isolated, f"degenerate {weak} root {zero} 1/2 3/4 0,1 1/4")
for name, u in {"denominator-1": "0,1/1", "not-lowest": "0,2/2", "not-lowest-common": "2,4/6", "denominator-0": "0,1/0", "denominator-minus": "0,-1/-2", "trailing-zero": "0,1,0/3", "zero-over": "0/2", "two-slashes": "0,1/2/3",
                "each": "0/2,1/2", "empty": "/2"}.items():
    broken("rational-polynomial-" + name, isolated, f"degenerate {weak} root -1,0,2 1/2 3/4 {u} 1/4")
for name, h in {"trailing-zero": "-1;2;0", "trailing-zero-in-row": "-1,0;2", "zero": "0", "zeros": "0;0", "empty-row": "-1;;2", "semicolon-first": ";-1;2", "semicolon-last": "-1;2;", "rational": "-1;2/1", "blank": "-1; 2"}.items():
    broken("polynomial2-" + name, zero_curve, f"degenerate factors 1 2 {h} none at 1/2 1/2")
for name, words in {"k-zero": "factors 0", "k-minus": "factors -1 2 -1;2 none", "e-zero": "factors 1 0 -1;2 none", "e-minus": "factors 1 -2 -1;2 none", "k-too-large": "factors 2 2 -1;2 none", "k-too-small": "factors 1 2 -1;2 none 1 -1;2 none",
                    "proof-unknown": "factors 1 2 -1;2 perhaps", "proof-missing": "factors 1 2 -1;2", "nested": "factors 1 2 -1;2 + factors 1 1 -1;2 none", "plus-nothing": "factors 1 2 -1;2 +", "k-missing": "factors"}.items():
    broken("factors-" + name, zero_curve, f"degenerate {words} at 1/2 1/2")

# -- columns --
for name, words in {"variable": "columns w 0 - - - - 1 1/2 open open", "no-variable": "columns 0 - - - - 1 1/2 open open", "m-minus": "columns u -1 - - - - 1 1/2 open open", "exponents-missing": "columns u 0 - - - 1 1/2 open open",
                    "exponents-zero": "columns u 0 0 0 0 0 1 1/2 open open", "k-zero": "columns u 0 - - - - 0 open", "k-minus": "columns u 0 - - - - -1 open", "piece-missing": "columns u 0 - - - - 1 1/2 open",
                    "piece-too-many": "columns u 0 - - - - 1 1/2 open open open", "piece-unknown": "columns u 0 - - - - 1 1/2 open closed", "column-not-lowest": "columns u 0 - - - - 1 2/4 open open", "dash-too-many": "columns u 0 - - - - - 1 1/2 open open",
                    "m-too-large": "columns u 2 - - - - 1 1/2 open open"}.items():
    broken("columns-" + name, "near-curve.bez.json", "regular " + words)
t = third.split()
m = int(t[2])
for name, at, word in (("dash", 3 + m, "-"), ("exponents-too-few", 3 + m, "0"), ("exponents-too-many", 3 + m, ",".join("0" * (m + 1))), ("exponents-minus", 3 + m, ",".join(["-1"] + ["0"] * (m - 1))),
                       ("exponents-comma", 3 + m, ",".join("0" * m) + ","), ("exponents-rational", 3 + m, ",".join(["1/2"] + ["0"] * (m - 1))), ("factor-trailing-zero", 3, t[3] + ",0"), ("factor-zero", 3, "0")):
    broken("columns-" + name, isolated_rational, f"degenerate {' '.join(t[:at] + [word] + t[at + 1:])} at 1/3 1/3")

# -- MEET --
s1, s2 = regular(cross1), regular(cross2)
for name, meet in {"edge-4": "at 4 1/4 0 3/4", "edge-minus": "at -1 1/4 0 3/4", "edge-rational": "at 1/2 1/4 0 3/4", "edge-name": "at 1.0 1/4 1.0 3/4", "nothing": "at", "short": "at 0 1/4 0", "long": "at 0 1/4 0 3/4 0", "unknown": "near 0 1/4 0 3/4",
                   "cross-short": "cross 0 7/32 9/32 0 23/32", "cross-long": "cross 0 7/32 9/32 0 23/32 25/32 1", "root-short": "root -2,0,1 1 2 0 2,1/4 0", "missing": ""}.items():
    broken("meet-" + name, cross1, f"overlapping {s1} {meet}".rstrip())
from injective_cases import corners  # noqa: E402
broken("meet-edge-3-of-triangle", corners, f"overlapping {regular(corners)} at 0 0 3 0")

# -- mesh --
for name, words in {"unknown": "valid", "nothing": "", "upper-case": "Embedding", "embedding-and-word": "embedding 1", "undecided-and-word": "undecided yet", "refuted-nothing": "refuted", "refuted-unknown": "refuted somehow",
                    "element-nothing": "refuted element", "element-0": "refuted element 0", "element-3": "refuted element 3", "element-01": "refuted element 01", "cover-short": "refuted cover 1 2 1/2",
                    "cover-0": "refuted cover 0 2 1/2 1/2", "cover-3": "refuted cover 1 3 1/2 1/2", "touch-number": "refuted touch at 0 1/2 1 1/2", "touch-3": "refuted touch at 1.0 1/2 3.0 1/2",
                    "touch-edge-3": "refuted touch at 1.0 1/2 2.3 1/2", "touch-position-0": "refuted touch at 1.0 1/2 0.1 1/2", "touch-01": "refuted touch at 1.0 1/2 02.1 1/2", "touch-edge-00": "refuted touch at 1.0 1/2 2.00 1/2",
                    "touch-edge-minus": "refuted touch at 1.0 1/2 2.-1 1/2", "touch-no-edge": "refuted touch at 1.0 1/2 2. 1/2", "touch-no-position": "refuted touch at 1.0 1/2 .1 1/2", "touch-two-dots": "refuted touch at 1.0 1/2 2.1.0 1/2",
                    "touch-comma": "refuted touch at 1.0 1/2 2,1 1/2", "touch-huge": "refuted touch at 1.0 1/2 4294967298.1 1/2", "touch-huge-64": "refuted touch at 1.0 1/2 18446744073709551618.1 1/2", "pinch-one": "refuted pinch 1.0", "gap-two": "refuted gap 1.2 2.0", "gap-numbers": "refuted gap 1 2 1/2", "touch-unknown": "refuted touch near 1.0 1/2 2.1 1/2"}.items():
    broken("mesh-" + name, two, c2, words)
broken("claim-reversed-too-much", clockwise, "reversed coefficients midpoint")
broken("mesh-element-too-much", clockwise, "reversed coefficients", "refuted element 1 1")
broken("mesh-cover-long", crossing, cc, "refuted cover 1 2 5/4 5/4 1")
broken("mesh-touch-long", crossing, cc, "refuted touch at 1.1 1/4 2.0 1/2 1")
broken("mesh-pinch-three", bowtie, cb, "refuted pinch 1.0 2.0 2.1")
broken("mesh-gap-long", crack, ck, "refuted gap 1.2 2.0 1/2 1/2")
broken("mesh-gap-hanging-long", hanging, cx, "refuted gap 1.0 2.0 3.0 1/2")
for name, more in {"unknown-line": ["seam 1.2 2.0"] + p2, "pair-nothing": ["pair"] + p2, "pair-one-edge": ["pair 1.0 s 1 0"] + p2, "pair-no-evidence": ["pair 1.0 2.1"] + p2, "pair-self": ["pair 1.0 2.1 m 1 0"] + p2, "pair-long": [p2[0] + " 0"] + p2[1:],
                   "pair-upper-case": [p2[0].replace("pair", "Pair")] + p2[1:], "pair-edge-3": ["pair 1.0 2.3 s 1 0"] + p2, "pair-position-3": ["pair 1.0 3.1 s 1 0"] + p2, "pair-position-0": ["pair 0.0 2.1 s 1 0"] + p2, "blank-line": [p2[0], ""] + p2[1:]}.items():
    broken("mesh-" + name, two, c2, "embedding", more)
far_off = elements_file("reparametrised-and-far.bez.json", ELEMENTS[other].decode().replace("\n  ] }", ",\n    " + triangle([(9, 9), (10, 9), (9, 10)]) + "\n  ] }"))
good("embedding-reparametrised-and-far", far_off, cg + [claim], "embedding", ["pair 1.0 3.0 s 0 1"] + pg)
broken("glue-after-pair", far_off, cg + [claim], "embedding", ["pair 1.0 3.0 s 0 1", "glue 1.1 2.0 1 2"] + pg)

# -- elements files that are none; the certificate names their bytes --
sound = ELEMENTS["linear.msh"].decode()
sound_json = bez_file(triangle([(0, 0), (1, 0), (0, 1)]))
lagrange_weights = bez_file(triangle([(0, 0), (1, 0), (2, 0), (0, 1), (1, 1), (0, 2)], 2, weights=[1, Q(1, 8), 1, 1, 1, 1], basis="lagrange"))
spoiled = {
    "empty.msh": "", "blank.msh": " \n", "other.msh": "hello\n", "no-elements.msh": sound.split("$Elements")[0], "only-lines.msh": sound.replace("3 2 2 0 1 1 2 3\n", "").replace("$Elements\n3", "$Elements\n2"),
    "undefined-node.msh": sound.replace("0 1 1 2 3", "0 1 1 2 4"), "node-twice.msh": sound.replace("3 0 1 0", "2 0 1 0"), "not-planar.msh": sound.replace("3 0 1 0", "3 0 1 1"), "nan.msh": sound.replace("3 0 1 0", "3 0 nan 0"),
    "infinite.msh": sound.replace("3 0 1 0", "3 0 inf 0"), "overflow.msh": sound.replace("3 0 1 0", "3 0 1e999 0"), "letter.msh": sound.replace("3 0 1 0", "3 0 1x 0"), "comma.msh": sound.replace("3 0 1 0", "3 0 1,0 0"),
    "too-few-nodes.msh": sound.replace("0 1 1 2 3", "0 1 1 2"), "too-many-nodes.msh": sound.replace("0 1 1 2 3", "0 1 1 2 3 3"), "serendipity.msh": sound.replace("3 2 2 0 1 1 2 3", "3 20 2 0 1 1 2 3 1 2 3 1 2 3"),
    "type-unknown.msh": sound.replace("3 2 2 0 1 1 2 3", "3 99999 2 0 1 1 2 3"), "version-3.msh": sound.replace("2.2 0 8", "3 0 8"), "version-4.0.msh": sound.replace("2.2 0 8", "4 0 8"), "binary.msh": sound.replace("2.2 0 8", "2.2 1 8"),
    "not-closed.msh": sound.replace("$EndElements\n", ""), "count-too-large.msh": sound.replace("$Elements\n3", "$Elements\n4"), "count-too-small.msh": sound.replace("$Elements\n3", "$Elements\n2"), "count-huge.msh": sound.replace("$Elements\n3", "$Elements\n99999999999999999999"),
    "nodes-huge.msh": sound.replace("$Nodes\n3", "$Nodes\n4294967295"), "hexadecimal.msh": sound.replace("3 0 1 0", "3 0 0x1 0"),
    "nul.msh": sound.replace("3 0 1 0", "3 0 1\0 0"),
    "not-closed.bez.json": sound_json[:-4], "version.bez.json": sound_json.replace('"bezcert": 1', '"bezcert": 2'), "no-version.bez.json": sound_json.replace('"bezcert": 1,', ""), "unknown-key.bez.json": sound_json.replace('"bezcert": 1', '"bezcert": 1, "colour": 3'),
    "repeated-key.bez.json": sound_json.replace('"degree": 1', '"degree": 1, "degree": 1'), "degree-0.bez.json": sound_json.replace('"degree": 1', '"degree": 0'), "degree-text.bez.json": sound_json.replace('"degree": 1', '"degree": "1"'),
    "degree-2.bez.json": sound_json.replace('"degree": 1', '"degree": 2'), "degree-65.bez.json": sound_json.replace('"degree": 1', '"degree": 65'), "degree-pair.bez.json": sound_json.replace('"degree": 1', '"degree": [1, 1]'),
    "kind.bez.json": sound_json.replace("triangle", "hexagon"), "point-of-three.bez.json": sound_json.replace('["0", "0"]', '["0", "0", "0"]'), "number.bez.json": sound_json.replace('["0", "0"]', '["0", "x"]'),
    "denominator-0.bez.json": sound_json.replace('["0", "0"]', '["0", "1/0"]'), "nan.bez.json": sound_json.replace('["0", "0"]', '["0", NaN]'), "null.bez.json": sound_json.replace('["0", "0"]', '["0", null]'),
    "no-elements.bez.json": '{ "bezcert": 1, "elements": [] }\n', "only-curves.bez.json": '{ "bezcert": 1, "curves": [ { "degree": 1, "points": [["0", "0"], ["1", "0"]] } ] }\n', "text-after.bez.json": sound_json + "{}",
    "comma-last.bez.json": sound_json.replace('["0", "1"]]', '["0", "1"],]'), "basis.bez.json": sound_json.replace('"degree"', '"basis": "hermite", "degree"'), "nodes-and-points.bez.json": sound_json.replace('"degree"', '"nodes": [0, 1, 2], "degree"'),
    "node-missing.bez.json": bez_file(triangle(None, nodes=[0, 1, 3]), points=[(0, 0), (1, 0), (0, 1)]), "node-minus.bez.json": bez_file(triangle(None, nodes=[0, 1, -1]), points=[(0, 0), (1, 0), (0, 1)]),
    "weight-zero.bez.json": bez_file(triangle([(0, 0), (1, 0), (0, 1)], weights=[1, 1, 0])), "weight-negative.bez.json": bez_file(triangle([(0, 0), (1, 0), (0, 1)], weights=[1, 1, -1])),
    "weights-too-few.bez.json": bez_file(triangle([(0, 0), (1, 0), (0, 1)], weights=[1, 1])), "weights-lagrange.bez.json": lagrange_weights, "array.bez.json": "[1, 2]\n", "deep.bez.json": '{ "bezcert": ' + "[" * 3000 + "]" * 3000 + " }\n"}
for name, content in spoiled.items():
    elements_file("spoiled-" + name, content)
    broken("elements-" + name.replace(".", "-"), "spoiled-" + name, "undecided", line=0)

# -- elements files in their less common forms --
shaped = {
    "carriage-returns.msh": sound.replace("\n", "\r\n"), "comments.msh": "\n$Comments\nanything $Nodes\n$EndComments\n" + sound, "exponents.msh": sound.replace("2 1 0 0", "2 1.0e+0 0.0 0").replace("3 0 1 0", "3 0e5 10E-1 0"),
    "more-tags.msh": sound.replace("3 2 2 0 1 1 2 3", "3 2 4 0 1 1 7 1 2 3"), "sparse-tags.msh": sound.replace("2 1 0 0", "2000000000 1 0 0").replace("0 1 1 2 3", "0 1 1 2000000000 3").replace("2 1 2 0 1 1 2\n", "2 1 2 0 1 1 2000000000\n"),
    "unused-node.msh": sound.replace("$Nodes\n3", "$Nodes\n4").replace("3 0 1 0", "3 0 1 0\n4 9 9 9"), "z.msh": sound.replace(" 0\n2 ", " 1.5\n2 ").replace("2 1 0 0", "2 1 0 1.5").replace("3 0 1 0", "3 0 1 1.5"),
    "minus-zero.msh": sound.replace("3 0 1 0", "3 -0.0 1 0"), "names.bez.json": sound_json.replace('"degree"', '"name": "a \\u00e9 \\"b\\"", "expect": "injective", "source": "", "degree"'),
    "numbers.bez.json": sound_json.replace('["1", "0"]', '[1e-1, 0.0]').replace('["0", "1"]', '["-0", "1/3"]'), "curves.bez.json": sound_json.replace('"bezcert": 1,', '"bezcert": 1, "curves": [ { "degree": 1, "points": [["0", "0"], ["1", "0"]] } ],'),
    "elements-first.bez.json": '{ "elements": [ { "points": [[0, 0], [1, 0], [0, 1]], "degree": 1, "kind": "triangle" } ], "bezcert": 1 }', "large-exponent.bez.json": sound_json.replace('["1", "0"]', '["1e400", "0"]').replace('["0", "1"]', '["0", "1e400"]')}
for name, content in shaped.items():
    elements_file("shaped-" + name, content)
    good("elements-" + name.replace(".", "-"), "shaped-" + name, claim)
