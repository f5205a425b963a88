#!/usr/bin/env python3
"""Deterministic rewriting of small Gmsh files, for what gmsh 4.8.4 does not write itself (see ../README.md).

    rewrite.py mirror|no_tags|extras IN OUT       2.2 ASCII in
    rewrite.py sparse|no_entities IN OUT          4.1 ASCII in
    rewrite.py crlf IN OUT                        any ASCII in
    rewrite.py mixed ORDER1 ORDER2 ORDER3 ORDER4 OUT   four orders of one triangulation, 2.2 ASCII in
    rewrite.py quarter_point|mixed_exact|classes OUT   written from scratch, all coordinates exact
"""
import sys

TRIANGLE = {1: 2, 2: 9, 3: 21, 4: 23}


def read_22(path):
    lines = open(path).read().split("\n")
    section = lambda name: lines[lines.index("$" + name) + 2:lines.index("$End" + name)]
    return [l.split() for l in section("Nodes")], [l.split() for l in section("Elements")]


def text_22(nodes, elements):
    rows = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$Nodes", str(len(nodes))]
    rows += [" ".join(map(str, n)) for n in nodes] + ["$EndNodes", "$Elements", str(len(elements))]
    rows += [" ".join(map(str, e)) for e in elements] + ["$EndElements", ""]
    return "\n".join(rows)


def mirror(source):
    """y -> -y, connectivity kept: positive elements become reversed."""
    nodes, elements = read_22(source)
    flip = lambda y: y[1:] if y.startswith("-") else "-" + y if float(y) else y
    return text_22([[t, x, flip(y), z] for t, x, y, z in nodes], elements)


def no_tags(source):
    """`number of tags` 0 for every element, as TriWild-like writers do."""
    nodes, elements = read_22(source)
    return text_22(nodes, [[e[0], e[1], 0] + e[3 + int(e[2]):] for e in elements])


def extras(source):
    """Sections a reader must step over, before and after the mesh."""
    nodes, elements = read_22(source)
    before = "$Comments\nNot a mesh: $Nodes\n3\n1 0 0 0\n$EndComments\n"
    data = '$NodeData\n1\n"height"\n1\n0\n3\n0\n1\n2\n1 0.5\n2 -0.5\n$EndNodeData\n'
    data += '$ElementData\n1\n"rank"\n1\n0\n3\n0\n1\n1\n%s 3\n$EndElementData\n' % elements[-1][0]
    return before + text_22(nodes, elements) + data


def blocks_41(lines, name):
    """The lines of a 4.1 section in blocks: [header fields, rows]."""
    at = lines.index("$" + name) + 2
    blocks = []
    while lines[at] != "$End" + name:
        head = lines[at].split()
        size = int(head[3]) * (2 if name == "Nodes" else 1)
        blocks.append([head, [l.split() for l in lines[at + 1:at + 1 + size]]])
        at += 1 + size
    return blocks


def sparse(source):
    """Node and element tags with gaps, out of order, some above 2^32; blocks of nodes in reverse."""
    lines = open(source).read().split("\n")
    tag = lambda t: str((int(t) * 7919) % 100003 + (5000000000 if int(t) % 5 == 0 else 11))
    out = lines[:lines.index("$Nodes")]
    nodes, elements = blocks_41(lines, "Nodes"), blocks_41(lines, "Elements")
    used = []
    for head, rows in nodes:
        half = len(rows) // 2
        for row in rows[:half]:
            row[0] = tag(row[0])
            used.append(int(row[0]))
    assert len(set(used)) == len(used)
    out += ["$Nodes", f"{len(nodes)} {len(used)} {min(used)} {max(used)}"]
    for head, rows in reversed(nodes):
        out += [" ".join(r) for r in [head] + rows]
    out += ["$EndNodes", "$Elements"]
    label = lambda t: str(int(t) * 3 + 1000)
    labels = [int(label(r[0])) for _, rows in elements for r in rows]
    out.append(f"{len(elements)} {len(labels)} {min(labels)} {max(labels)}")
    for head, rows in elements:
        out += [" ".join(head)] + [" ".join([label(r[0])] + [tag(t) for t in r[1:]]) for r in rows]
    return "\n".join(out + ["$EndElements", ""])


def no_entities(source):
    lines = open(source).read().split("\n")
    a, b = lines.index("$Entities"), lines.index("$EndEntities")
    return "\n".join(lines[:a] + lines[b + 1:])


def crlf(source):
    return open(source).read().replace("\n", "\r\n")


def mixed(*sources):
    """Triangle k has order k mod 4 + 1, from the four orders of one triangulation; corners are shared."""
    meshes = [read_22(s) for s in sources]
    triangles = [[e for e in elements if int(e[1]) == TRIANGLE[n]] for n, (_, elements) in enumerate(meshes, 1)]
    places = [{r[0]: r[1:] for r in m[0]} for m in meshes]
    corners = [[[at[t] for t in e[3 + int(e[2]):][:3]] for e in t] for t, at in zip(triangles, places)]
    assert all(c == corners[0] for c in corners)
    nodes, elements, number = [], [], {}

    def node(order, tag, corner):
        place = places[order - 1][tag]
        key = tuple(place) if corner else (order, tag)
        if key not in number:
            number[key] = len(nodes) + 1
            nodes.append([number[key]] + place)
        return number[key]

    for k in range(len(corners[0])):
        order = k % 4 + 1
        tags = triangles[order - 1][k]
        tags = tags[3 + int(tags[2]):]
        row = [node(order, t, i < 3) for i, t in enumerate(tags)]
        elements.append([k + 1, TRIANGLE[order], 2, 0, 1] + row)
    return text_22(nodes, elements)


class Sheet:
    """Nodes shared by place, elements in order, exact binary fractions."""

    def __init__(self):
        self.nodes, self.elements = {}, []

    def node(self, p):
        return self.nodes.setdefault(tuple(p), len(self.nodes) + 1)

    def add(self, kind, points):
        self.elements.append([len(self.elements) + 1, kind, 2, 0, 1] + [self.node(p) for p in points])

    def text(self):
        return text_22([[t, repr(float(x)), repr(float(y)), 0] for (x, y), t in self.nodes.items()], self.elements)


def blend(a, b, k, n):
    return tuple((a[i] * (n - k) + b[i] * k) / n for i in (0, 1))


def quarter_point():
    """Eight quadratic crack-tip triangles about the origin: nodes at a quarter of the spokes, det J = 0 at the tip."""
    sheet = Sheet()
    rim = [(2, 0), (2, 2), (0, 2), (-2, 2), (-2, 0), (-2, -2), (0, -2), (2, -2)]
    tip = (0, 0)
    for a, b in zip(rim, rim[1:] + rim[:1]):
        sheet.add(9, [tip, a, b, blend(tip, a, 1, 4), blend(a, b, 1, 2), blend(tip, b, 1, 4)])
    return sheet.text()


def mixed_exact():
    """A fan of eight triangles of orders 1..4: straight or quadratic spokes, equal up to degree elevation; curved rim."""
    sheet = Sheet()
    rim = [(48, 0), (48, 48), (0, 48), (-48, 48), (-48, 0), (-48, -48), (0, -48), (48, -48)]
    orders = [1, 2, 4, 3, 1, 3, 4, 2]
    hub = (0, 0)
    bends = {2: (6, 24), 7: (18, -30)}     # middle node of a quadratic spoke between orders 2 and 4

    def spoke(index, n):
        """Interior nodes from the hub to rim[index] for order n."""
        end, mid = rim[index % 8], bends.get(index % 8)
        if mid is None or n == 1:
            return [blend(hub, end, k, n) for k in range(1, n)]
        assert n in (2, 4)
        quadratic = lambda t: tuple(4 * t * (1 - t) * m + t * (2 * t - 1) * e for m, e in zip(mid, end))
        return [quadratic(k / n) for k in range(1, n)]

    for k, n in enumerate(orders):
        a, b = rim[k], rim[(k + 1) % 8]
        out = ((b[1] - a[1]) / 8, (a[0] - b[0]) / 8)           # outward normal, 1/8 of the rim edge
        bulge = []
        for j in range(1, n):
            p, size = blend(a, b, j, n), j * (j + 1) * (n - j) / 16
            bulge.append((p[0] + size * out[0], p[1] + size * out[1]))
        inner = {1: [], 2: [], 3: [(1, 1)], 4: [(1, 1), (2, 1), (1, 2)]}[n]
        inside = []
        for u, v in inner:
            p = [(a[i] * u + b[i] * v) / n for i in (0, 1)]
            for index, end, weight in ((k, a, u), ((k + 1) % 8, b, v)):
                if index in bends:      # the spoke's bend fades linearly into the element
                    size = 4 * (n - u - v) * weight / n ** 2
                    p = [p[i] + size * (bends[index][i] - end[i] / 2) for i in (0, 1)]
            inside.append(tuple(p))
        sheet.add(TRIANGLE[n], [hub, a, b] + spoke(k, n) + bulge + spoke(k + 1, n)[::-1] + inside)
    return sheet.text()


def classes():
    """Separate small elements, with every class and exact zeros."""
    sheet = Sheet()

    def put(kind, points):
        x = 8 * len(sheet.elements)
        sheet.add(kind, [(p[0] + x, p[1]) for p in points])

    put(2, [(0, 0), (4, 0), (0, 4)])                                         # positive
    put(2, [(0, 0), (0, 4), (4, 0)])                                         # reversed
    put(2, [(0, 0), (2, 2), (4, 4)])                                         # degenerate: det J = 0 everywhere
    put(3, [(0, 0), (4, 0), (4, 4), (0, 4)])                                 # positive
    put(3, [(0, 0), (4, 0), (4, 4), (4, 0.5)])                               # folded at one corner
    put(3, [(0, 0), (4, 0), (2, 2), (0, 4)])                                 # degenerate: corner 2 on a diagonal
    put(3, [(0, 0), (4, 0), (0, 4), (4, 4)])                                 # folded: bow tie
    put(3, [(0, 0), (4, 0), (4, 0), (0, 4)])                                 # degenerate: edge 1-2 collapsed
    straight = [(0, 0), (4, 0), (0, 4), (2, 0), (2, 2), (0, 2)]
    put(9, straight[:4] + [(0.75, 0.75)] + straight[5:])                     # folded: mid-edge node pushed inwards
    put(9, straight[:4] + [(1, 1)] + straight[5:])                           # degenerate: zeros at corners 1 and 2
    tiny = 2.0 ** -45
    put(9, straight[:4] + [(1 - tiny, 1)] + straight[5:])                    # folded by a hair
    put(9, straight[:4] + [(1 + tiny, 1)] + straight[5:])                    # degenerate: zero at corner 1 only
    put(9, straight[:4] + [(1 + tiny, 1 + tiny)] + straight[5:])             # positive by a hair
    put(9, [(0, 0), (0, 4), (4, 0), (0, 2), (0.75, 0.75), (2, 0)])           # folded, otherwise clockwise
    put(9, [(0, 0), (0, 4), (4, 0), (0, 2), (1, 1), (2, 0)])                 # clockwise with zeros at corners: folded
    nine = [(0, 0), (4, 0), (4, 4), (0, 4), (2, 0), (4, 2), (2, 4), (0, 2), (2, 2)]
    put(10, nine[:8] + [(3.5, 3.5)])                                         # folded: centre node far off
    put(10, nine[:4] + [(1, 0)] + nine[5:6] + [(1, 4)] + nine[7:8] + [(1, 2)])   # degenerate along edge u = 0
    return sheet.text()


def main(task, *paths):
    text = globals()[task](*paths[:-1])
    with open(paths[-1], "w", newline="") as out:
        out.write(text)


if __name__ == "__main__":
    main(*sys.argv[1:])
