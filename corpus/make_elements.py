#!/usr/bin/env python3
"""Write the corpus of single elements, after proving every expected verdict in exact arithmetic.

    make_elements.py           write elements/*.bez.json, criteria.tsv, zeros.tsv, beyond_subdivision.txt
    make_elements.py --check   make everything in memory and compare with the files, byte for byte

Python >= 3.9 and its standard library. Nothing here uses the C++ library: exact.py derives everything anew.
"""
import json
import re
import sys
from fractions import Fraction as Q
from itertools import combinations
from pathlib import Path

sys.dont_write_bytecode = True  # leave nothing beside the sources

import contact
import exact
import element_list  # each of the three lists adds its elements to ELEMENTS
import element_list_zeros
import element_list_contact
import zeros
from element_notation import ELEMENTS
from exact import CRITERIA, Element, bernstein_rows, decide

HERE = Path(__file__).resolve().parent
PROOF_WORDS = {
    "midpoint rule": "polynomial of degree at most 2 (or bilinear) with det J > 0",
    "orientation": "all triples of control points are oriented like their indices",
    "hull": "all mixed determinants of the Bernstein coefficients of W^2 J are >= 0 and their determinants > 0",
    "shear": "det J > 0 and the first coordinate is the first parameter up to a strictly increasing function",
    "simple boundary": "det J > 0, edges monotone along their chords, control polygons of the edges parted by lines"}


def element_of(entry):
    points = [tuple(Q(x) for x in p) for p in entry["points"]]
    weights = [Q(w) for w in entry["weights"]] if entry["weights"] else None
    return Element(entry["kind"], entry["degree"], points, weights, entry["basis"])


def at(parameter):
    return tuple(Q(x) for x in parameter)


def words_at(parameter):
    return "(" + ", ".join(str(Q(x)) for x in parameter) + ")"


def subdivide(element, budget):
    """Sign of N by bisection. On the triangle the three choices of the first edge must agree about zeros."""
    rows = bernstein_rows(element.N, element.triangle)
    status, witness = decide(rows, element.triangle, budget)
    if element.triangle and (status == "zero" or status == "open" and budget <= 1000):
        again = {decide(rows, True, budget)[0] for rows in (exact.rotated(rows), exact.rotated(exact.rotated(rows)))}
        assert again == {status}, "bisection settles this element only from some edges"
    if witness and not element.triangle:
        witness = (1 - witness[0], witness[0], 1 - witness[1], witness[1])
    return status, witness


def injectivity(element):
    """Names of the proofs that hold; det J > 0 is known."""
    proofs = [("midpoint rule", exact.midpoint_rule), ("orientation", lambda e: exact.orientation(e) == "proved"),
              ("hull", exact.hull), ("shear", exact.shear), ("simple boundary", exact.simple_boundary)]
    return [name for name, test in proofs if test(element)]


def simple_net(element):
    """The upright control triangles and those between them are counter-clockwise and do not overlap."""
    between = [[tuple(k + (r != s) for s, k in enumerate(m)) for r in range(3)]
               for m in exact.triangle_indices(element.degree - 2)]
    nets = [[element.point[e] for e in t] for t in exact.upright(element) + between]

    def apart(a, b):
        return any(all(exact.orient(p, q, x) <= 0 for x in b) for p, q in zip(a, a[1:] + a[:1]))

    return all(exact.orient(*t) > 0 for t in nets) and all(apart(a, b) or apart(b, a) for a, b in combinations(nets, 2))


def prove(entry, element):
    """Check the expected verdict; return a sentence for `source` and why subdivision cannot settle it, if so."""
    expect, proof, kind = entry["expect"], entry["proof"], entry["kind"]
    terms = proof if isinstance(proof, dict) and "terms" in proof and "multiplier" in proof else None
    status, witness = subdivide(element, 6000 if not terms else 1000 if expect == "degenerate" else 2500)
    beyond_subdivision = "" if status != "open" else {
        "degenerate": "bisection never ends at its zeros", "folded": "the region of det J < 0 is very thin",
        "injective": "the region where det J is about 1e-12 is large"}[expect]
    if terms:
        zeros.check_sum(element, kind, terms)
        assert (terms["shift"] > 0) - (terms["shift"] < 0) == {"degenerate": 0, "injective": 1, "folded": -1}[expect]
        return prove_terms(entry, element, status, witness), beyond_subdivision
    if proof in ("simple", "simple net"):
        assert simple_net(element) and (proof == "simple net" or exact.simple_boundary(element))
    if isinstance(proof, dict):
        assert status == "positive", status
        return contact.check(element, proof, expect), ""
    if expect in ("injective", "reversed"):
        assert status == ("positive" if expect == "injective" else "negative"), status
        proofs = injectivity(element) if expect == "injective" else []
        if expect == "reversed":
            return "Subdivision proves -det J > 0.", beyond_subdivision
        assert proofs, "no proof of injectivity"
        return f"Injective: {PROOF_WORDS[proofs[0]]}.", beyond_subdivision
    if expect == "overlapping":
        assert status == "positive" and at(proof[1]) != at(proof[2])
        assert all(min(at(p)) >= 0 and sum(at(p)) == (1 if element.triangle else 2) for p in proof[1:])
        assert element.image(at(proof[1])) == element.image(at(proof[2]))
        return "", beyond_subdivision
    if expect == "degenerate":
        assert status == "zero", status
        return "Bisection ends with coefficients >= 0 on every piece.", ""
    assert expect == "folded" and status in ("mixed", "below"), status
    return negative(element, witness), beyond_subdivision


def prove_terms(entry, element, status, witness):
    """The same for an element whose det J is a sum of terms plus a shift, which zeros.check_sum has checked."""
    expect, proof, kind = entry["expect"], entry["proof"], entry["kind"]
    if expect == "degenerate":
        assert status == "open", status
        zero_set(entry, element)
        return ""
    if expect == "injective":
        assert status in ("positive", "open"), status
        if len(set(proof["scales"])) == 1:
            assert exact.shear(element)
            return f"Injective: {PROOF_WORDS['shear']}."
        assert exact.shear(zeros.unweighted(element, proof["scales"]))
        return f"Injective: before the reparametrisation {PROOF_WORDS['shear']}."
    assert status in ("mixed", "below", "open"), status
    places = [proof["point"]] if proof["point"] else zeros.near_zeros(proof["terms"], proof["multiplier"], kind)
    if witness and not any(max(x.denominator for x in p) < 1000 for p in places):
        return negative(element, witness)
    for s, t in [zeros.moved(p, kind, proof["scales"]) for p in places]:
        where = (1 - s - t, s, t) if element.triangle else (1 - s, s, 1 - t, t)
        if min(where) >= 0 and element.det(where) < 0:
            return negative(element, where)
    raise AssertionError("no negative value found")


def negative(element, witness):
    value = element.det(witness)
    assert value < 0
    shown = str(value) if len(str(value)) < 40 else f"about {float(value):.3g}"
    where = words_at(witness if element.triangle else (witness[1], witness[3]))
    return f"det J = {shown} at {where}."


def zero_set(entry, element):
    """A row of zeros.tsv: the dimension of the zero set of det J, and where the zeros are if there are finitely many."""
    proof, kind = entry["proof"], entry["kind"]
    if proof:
        dimension, boxes = zeros.zero_set(proof["terms"], proof["multiplier"], kind)
        points = []
        for s, t in boxes:
            point = zeros.moved((s[0], t[0]), kind, proof["scales"])
            u, v = point
            where = (1 - u - v, u, v) if element.triangle else (1 - u, u, 1 - v, v)
            exactly = s[0] == s[1] and t[0] == t[1]
            assert exactly or abs(exact.evaluate(element.N, where)) < Q(1, 10 ** 25)
            if not exactly or exact.evaluate(element.N, where) == 0:
                points.append(point)
        assert dimension or points, "no zero"
    else:
        dimension, points = zeros.zero_faces(bernstein_rows(element.N, element.triangle), element.triangle)
    shown = ";".join(",".join(twelve_decimals(x) for x in point) for point in sorted(points))
    return f"{entry['name']}\t{dimension}\t{len(points) if dimension == 0 else ''}\t{shown}"


def twelve_decimals(x):
    digits = str(int(x * 10 ** 12 + Q(1, 2))).rjust(13, "0")
    return f"{digits[:-12]}.{digits[-12:]}"


def document(entry, sentence):
    record = {"name": entry["name"], "expect": entry["expect"], "source": f"{entry['source'].strip()} {sentence}".strip(),
              "kind": entry["kind"], "degree": entry["degree"], "basis": entry["basis"]}
    head = ",\n      ".join(f"{json.dumps(k)}: {json.dumps(v)}" for k, v in record.items())
    n = entry["degree"]
    lengths = [n + 1 - r for r in range(n + 1)] if isinstance(n, int) else [n[0] + 1] * (n[1] + 1)

    def rows(values):
        lines, start = [], 0
        for length in lengths:
            lines.append(", ".join(json.dumps(v) for v in values[start:start + length]))
            start += length
        return ",\n        ".join(lines)

    body = f'"points": [\n        {rows(entry["points"])}]'
    if entry["weights"]:
        body += f',\n      "weights": [\n        {rows(entry["weights"])}]'
    return f'{{ "bezcert": 1,\n  "elements": [\n    {{ {head},\n      {body} }} ] }}\n'


def make():
    """All files as {relative path: text}, and the table of criteria."""
    files, table, beyond_subdivision, zero_rows = {}, {}, [], []
    for entry in ELEMENTS:
        name = entry["name"]
        assert name not in table, f"{name} twice"
        try:
            element = element_of(entry)
            sentence, no_subdivision = prove(entry, element)
        except AssertionError as error:
            raise SystemExit(f"{name}: expected {entry['expect']}: {error}")
        if no_subdivision:
            beyond_subdivision.append(f"{name} # {no_subdivision}")
        if entry["expect"] == "degenerate":
            zero_rows.append(zero_set(entry, element))
        table[name] = {criterion: test(element) for criterion, test in CRITERIA.items()}
        regular = entry["expect"] in ("injective", "overlapping")
        assert regular or table[name]["orientation"] != "proved" and table[name]["coefficients"] != "proved", name
        files[f"elements/{name}.bez.json"] = document(entry, sentence)
    rows = [f"{name}\t{criterion}\t{status}" for name, row in table.items() for criterion, status in row.items()]
    files["criteria.tsv"] = "\n".join(["element\tcriterion\tstatus"] + rows) + "\n"
    files["zeros.tsv"] = "\n".join(["element\tdimension\tnumber\tzeros"] + zero_rows) + "\n"
    files["beyond_subdivision.txt"] = "\n".join(
        ["# Dyadic subdivision of N cannot settle these; the true verdict is in the file."] + beyond_subdivision) + "\n"
    return files, table


def check_pairs(table):
    """Every row | A | B | element | of README.md: A proves that element regular and B does not."""
    expect = {entry["name"]: entry["expect"] for entry in ELEMENTS}
    rows = re.findall(r"^\| ([a-z-]+) \| ([a-z-]+) \| `([a-z0-9-]+)` \|$", (HERE / "README.md").read_text(), re.M)
    for a, b, name in rows:
        row = dict(table[name], subdivision="proved" if expect[name] in ("injective", "overlapping") else "no")
        if row[a] != "proved" or row[b] == "proved":
            raise SystemExit(f"README.md: {name} does not show {a} without {b}")
    return len(rows)


def main(arguments):
    if arguments not in ([], ["--check"]):
        raise SystemExit(__doc__)
    files, table = make()
    stale = {f"elements/{p.name}" for p in (HERE / "elements").glob("*")} - set(files)
    if arguments:
        wrong = [name for name, body in files.items()
                 if not (HERE / name).is_file() or (HERE / name).read_text(encoding="utf-8") != body]
        if wrong or stale:
            raise SystemExit("differs from make_elements.py: " + ", ".join(sorted(stale | set(wrong))))
    else:
        (HERE / "elements").mkdir(exist_ok=True)
        if stale:
            print("no longer made here: " + ", ".join(sorted(stale)))
        for name, body in files.items():
            (HERE / name).write_text(body, encoding="utf-8")
    print(f"{len(table)} elements, {check_pairs(table)} pairs of criteria in README.md")


if __name__ == "__main__":
    main(sys.argv[1:])
