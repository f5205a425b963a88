#!/usr/bin/env python3
"""Write the corpus of whole meshes, corpus/whole, after deriving every verdict in exact arithmetic.

    make_whole.py           write whole/*.bez.json, whole/expected.tsv, whole/domain.tsv, whole/README.md
    make_whole.py --check   make everything in memory and compare with the files, byte for byte

Python >= 3.9 and its standard library. Nothing here uses the C++ library.
"""
import json
import sys
from pathlib import Path

sys.dont_write_bytecode = True  # leave nothing beside the sources

import curves
import whole_list  # fills CASES and DOMAINS
import whole_oracle
from whole_cases import CASES, DOMAINS

HERE = Path(__file__).resolve().parent / "whole"
README = """# Whole meshes with their exact verdicts

Small meshes in .bez.json, made by `corpus/make_whole.py` (`--check` compares byte for byte; `whole_list.py` is the list,
`whole_oracle.py` the mathematics in exact arithmetic, nothing of the C++ library). Elements with `nodes` are glued by node number,
elements with `points` by equal edges.

- `expected.tsv`: the verdict, `embedding` or the first obstacle in the order invalid_element, non_manifold, non_conforming,
  folded_vertex, overlapping_boundary; components, boundary loops and holes where the edges glue to a surface; the exact area of
  polynomial embeddings (sum of the integrals of det J, equal to the sum over the boundary loops); the elements (from 1) and nodes
  (from 0) that the first obstacle is about, `;`-separated, empty where more than one answer is right.
- `domain.tsv`: a mesh, a file of curves, whether every curve is exactly a chain of whole edges, how many are, which (from 1) are not.

What the verdicts mean:

- Two edges with the same end nodes (or, for elements with points, equal edges) are one edge: more than two elements on it, or
  two in the same direction, or elements at a node that do not form one fan: `non_manifold`. Curves are equal up to degree, common
  factors and projective reparametrisation, else `non_conforming`; so is a boundary edge that is a piece of another one and shares
  one end with it (hanging node).
- `folded_vertex`: corner angles sum to more than one turn, or to two at an inner vertex, or to exactly one at a boundary
  vertex with the mesh on both sides of a sliver. Exactly one turn with two equal edges (the tip of a slit) is not that:
  the edges overlap, `overlapping_boundary`.
- `overlapping_boundary` also where one component lies in the region of another, boundaries apart.

Proofs: elements by subdivision of det J and a simple boundary; boundaries apart by separating lines of control points, meeting by an
exact common point, equal curves, or two pieces that certainly cross. Angles are summed in floating point.

| file | verdict | what |
|---|---|---|
"""


def number(x):
    return json.dumps(str(x))


def pairs(points):
    return ", ".join(f"[{number(x)}, {number(y)}]" for x, y in points)


def wrapped(items, indent, per_line):
    lines = [", ".join(items[k:k + per_line]) for k in range(0, len(items), per_line)]
    return (",\n" + " " * indent).join(lines)


def document(mesh):
    parts = []
    if mesh.points:
        parts.append('"points": [\n    ' + wrapped([pairs([p]) for p in mesh.points], 4, 6) + "]")
        if len(set(mesh.weights)) > 1:
            parts.append('"weights": [\n    ' + wrapped([number(w) for w in mesh.weights], 4, 16) + "]")
    elements = []
    for entry in mesh.elements:
        text = f'{{ "kind": "{entry["kind"]}", "degree": {json.dumps(entry["degree"])},'
        if "nodes" in entry:
            elements.append(f'{text} "nodes": {json.dumps(entry["nodes"])} }}')
            continue
        text += f'\n      "points": [{wrapped([pairs([p]) for p in entry["points"]], 8, 6)}]'
        if "weights" in entry:
            text += f',\n      "weights": [{", ".join(map(number, entry["weights"]))}]'
        elements.append(text + " }")
    parts.append('"elements": [\n    ' + ",\n    ".join(elements) + " ]")
    return '{ "bezcert": 1,\n  ' + ",\n  ".join(parts) + " }\n"


def curves_document(list_of_curves):
    lines = []
    for c in list_of_curves:
        text = f'{{ "degree": {len(c) - 1}, "points": [{pairs(curves.net(c))}]'
        if len({w for _, _, w in c}) > 1:
            text += f', "weights": [{", ".join(number(w) for _, _, w in c)}]'
        lines.append(text + " }")
    return '{ "bezcert": 1,\n  "curves": [\n    ' + ",\n    ".join(lines) + " ] }\n"


def expected_row(name, mesh, verdict, touching):
    found, topology, loops = whole_oracle.judge(mesh, touching)
    assert found.verdict == verdict, f"{found.verdict}, not {verdict} {[k + 1 for k in found.elements]}"
    surface = ["", "", ""]
    if loops is not None:
        components = len(set(topology.components().values()))
        surface = [str(components), str(len(loops)), str(len(loops) - components)]
    area = whole_oracle.area(mesh) if verdict == "embedding" else None
    if area is not None:
        assert area > 0 and area == sum(curves.area_under(s[4]) for loop in loops for s in loop), "areas differ"
    return "\t".join([name + ".bez.json", verdict, *surface, "" if area is None else str(area),
                      ";".join(str(k + 1) for k in found.elements), ";".join(str(v) for v in found.nodes)])


def make(only=()):
    files, table, words = {}, [], []
    for name, (mesh, verdict, text, touching) in CASES.items():
        if only and not any(o in name for o in only):
            continue
        try:
            table.append(expected_row(name, mesh, verdict, touching))
        except AssertionError as error:
            raise SystemExit(f"{name}: expected {verdict}: {error}")
        files[name + ".bez.json"] = document(mesh)
        words.append(f"| `{name}` | {verdict} | {text} |")
    rows = []
    words += ["", "| curves | mesh | what |", "|---|---|---|"]
    for mesh, name, list_of_curves, text in DOMAINS:
        answers = [whole_oracle.covered(CASES[mesh][0], c) for c, _ in list_of_curves]
        assert answers == [expect for _, expect in list_of_curves], f"{name}: {answers}"
        failing = ";".join(str(k + 1) for k, good in enumerate(answers) if not good)
        rows.append(f"{mesh}.bez.json\tcurves-{name}.bez.json\t{'not_' * (not all(answers))}conforming\t{sum(answers)}\t{failing}")
        files[f"curves-{name}.bez.json"] = curves_document([c for c, _ in list_of_curves])
        words.append(f"| `curves-{name}` | `{mesh}` | {text} |")
    files["expected.tsv"] = "\n".join(["file\tverdict\tcomponents\tloops\tholes\tarea\tobstacle_elements\tobstacle_nodes"]
                                      + table) + "\n"
    files["domain.tsv"] = "\n".join(["mesh\tcurves\tverdict\tcovered\tnot_covered"] + rows) + "\n"
    files["README.md"] = README + "\n".join(words) + "\n"
    return files


def main(arguments):
    if arguments not in ([], ["--check"]):
        raise SystemExit(__doc__)
    files = make()
    stale = {p.name for p in HERE.glob("*")} - set(files)
    if arguments:
        wrong = [n for n, body in files.items() if not (HERE / n).is_file() or (HERE / n).read_text(encoding="utf-8") != body]
        if wrong or stale:
            raise SystemExit("differs from make_whole.py: " + ", ".join(sorted(stale | set(wrong))))
    else:
        HERE.mkdir(exist_ok=True)
        if stale:
            print("no longer made here: " + ", ".join(sorted(stale)))
        for name, body in files.items():
            (HERE / name).write_text(body, encoding="utf-8")
    print(f"{len(CASES)} meshes, {len(DOMAINS)} files of curves")


if __name__ == "__main__":
    main(sys.argv[1:])
