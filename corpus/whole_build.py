"""Build small meshes: nodes, curved edges, elements that share them."""
from fractions import Fraction as Q

import curves
import exact


def pt(x, y):
    return Q(x), Q(y)


class Mesh:
    """Nodes with positions and weights; elements hold indices of nodes, or points and weights of their own."""

    def __init__(self):
        self.points, self.weights, self.elements = [], [], []
        self.curve, self.inner = {}, {}  # (a, b): curve from a to b; ((a, b), degree, copy): its inner nodes

    def node(self, x, y, weight=1):
        self.points.append(pt(x, y))
        self.weights.append(Q(weight))
        return len(self.points) - 1

    def nodes(self, text):
        return [self.node(*p.split(",")) for p in text.split()]

    def home(self, a):
        return self.points[a][0] * self.weights[a], self.points[a][1] * self.weights[a], self.weights[a]

    def bend(self, a, b, *inner, weights=None):
        """The curve from a to b has these inner control points ("x,y" or pairs)."""
        pairs = [pt(*(p.split(",") if isinstance(p, str) else p)) for p in inner]
        weights = [Q(w) for w in weights or [1] * len(pairs)]
        self.lay(a, b, (self.home(a),) + curves.curve(pairs, weights) + (self.home(b),))

    def lay(self, a, b, curve):
        self.curve[a, b], self.curve[b, a] = curve, curves.reverse(curve)

    def along(self, a, b, degree, curve=None):
        """The homogeneous curve of an edge in the given degree."""
        c = curve or self.curve.get((a, b)) or (self.home(a), self.home(b))
        while len(c) <= degree:
            c = curves.elevate(c)
        assert len(c) == degree + 1, "the edge has a higher degree"
        return c

    def between(self, a, b, c, copy):
        """Nodes of the inner control points of curve c from a to b; the same call from the other side gives the same nodes."""
        key = (min(a, b), max(a, b), len(c), copy)
        if key not in self.inner:
            first = c if a < b else curves.reverse(c)
            self.inner[key] = [self.node(x / w, y / w, w) for x, y, w in first[1:-1]]
        return self.inner[key] if a < b else self.inner[key][::-1]

    def triangle(self, a, b, c, degree=1, own=None, copy=0):
        """own: {(a, b): curve} for edges of this element alone; copy: another set of inner edge nodes."""
        n, net, ids = degree, {}, {}
        corners = {(n, 0, 0): a, (0, n, 0): b, (0, 0, n): c}
        for p, q, path in ((a, b, lambda i: (n - i, i, 0)), (b, c, lambda i: (0, n - i, i)), (c, a, lambda i: (i, 0, n - i))):
            self.edge_nodes(p, q, n, path, own, copy, net, ids)
        ids.update(corners)
        for e in exact.triangle_indices(n):
            if min(e) == 0:
                continue
            i, j, k = e
            total = [Q(0)] * 3
            ends = [((i, n - i, 0), (i, 0, n - i), Q(k, n - i)), ((n - j, j, 0), (0, j, n - j), Q(k, n - j)),
                    ((n - k, 0, k), (0, n - k, k), Q(j, n - k))]
            for start, end, t in ends:
                total = [x + ((1 - t) * s + t * f) / 2 for x, s, f in zip(total, net[start], net[end])]
            for corner, weight in zip(((n, 0, 0), (0, n, 0), (0, 0, n)), e):
                total = [x - Q(weight, 2 * n) * y for x, y in zip(total, net[corner])]
            ids[e] = self.node(total[0] / total[2], total[1] / total[2], total[2])
        self.elements.append({"kind": "triangle", "degree": n, "nodes": [ids[e] for e in exact.triangle_indices(n)]})

    def edge_nodes(self, p, q, n, path, own, copy, net, ids):
        mine = (own or {}).get((p, q))
        curve = self.along(p, q, n, mine)
        inner = [self.node(x / w, y / w, w) for x, y, w in curve[1:-1]] if mine else self.between(p, q, curve, copy)
        for i in range(n + 1):
            net[path(i)] = curve[i]
            if 0 < i < n:
                ids[path(i)] = inner[i - 1]

    def quad(self, a, b, c, d, degree=1, own=None, copy=0):
        """Corners counter-clockwise; degree n or (p, q), p along a b."""
        p, q = (degree, degree) if isinstance(degree, int) else degree
        net, ids = {}, {(0, 0): a, (p, 0): b, (p, q): c, (0, q): d}
        for x, y, n, path in ((a, b, p, lambda i: (i, 0)), (b, c, q, lambda i: (p, i)),
                              (d, c, p, lambda i: (i, q)), (a, d, q, lambda i: (0, i))):
            self.edge_nodes(x, y, n, path, own, copy, net, ids)
        for j in range(1, q):
            for i in range(1, p):
                s, t = Q(i, p), Q(j, q)
                total = [(1 - t) * x + t * y + (1 - s) * z + s * w for x, y, z, w in
                         zip(net[i, 0], net[i, q], net[0, j], net[p, j])]
                for corner, w in (((0, 0), (1 - s) * (1 - t)), ((p, 0), s * (1 - t)), ((0, q), (1 - s) * t), ((p, q), s * t)):
                    total = [x - w * y for x, y in zip(total, net[corner])]
                ids[i, j] = self.node(total[0] / total[2], total[1] / total[2], total[2])
        self.elements.append({"kind": "quadrilateral", "degree": [p, q],
                              "nodes": [ids[i, j] for j in range(q + 1) for i in range(p + 1)]})

    def own_points(self):
        """The same mesh, each element with points of its own: glued by geometry."""
        mesh = Mesh()
        for e in self.elements:
            entry = {"kind": e["kind"], "degree": e["degree"], "points": [self.points[k] for k in e["nodes"]]}
            weights = [self.weights[k] for k in e["nodes"]]
            if len(set(weights)) > 1:
                entry["weights"] = weights
            mesh.elements.append(entry)
        return mesh

    def unmerged(self):
        """The same mesh, every element with nodes of its own."""
        mesh = Mesh()
        for e in self.elements:
            mesh.elements.append(dict(e, nodes=[mesh.node(*self.points[k], self.weights[k]) for k in e["nodes"]]))
        return mesh

    def moved(self, dx, dy):
        self.points = [(x + Q(dx), y + Q(dy)) for x, y in self.points]
        return self

    def with_mesh(self, other):
        """Both meshes in one file."""
        first = len(self.points)
        self.points += other.points
        self.weights += other.weights
        self.elements += [dict(e, nodes=[k + first for k in e["nodes"]]) for e in other.elements]
        return self


def homogeneous(mesh, entry):
    """Control points of an element as homogeneous triples, and its exact element."""
    if "nodes" in entry:
        points, weights = [mesh.points[k] for k in entry["nodes"]], [mesh.weights[k] for k in entry["nodes"]]
    else:
        points, weights = entry["points"], entry.get("weights") or [Q(1)] * len(entry["points"])
    degree = entry["degree"] if entry["kind"] == "triangle" else tuple(entry["degree"])
    return curves.curve(points, weights), exact.Element(entry["kind"], degree, points, weights)


def edges_of(mesh, entry):
    """[(node or point at the start, at the end, curve)] counter-clockwise."""
    control, _ = homogeneous(mesh, entry)
    names = entry.get("nodes") or entry["points"]
    if entry["kind"] == "triangle":
        place = {e: k for k, e in enumerate(exact.triangle_indices(entry["degree"]))}
        n = entry["degree"]
        paths = [[(n - i, i, 0) for i in range(n + 1)], [(0, n - i, i) for i in range(n + 1)],
                 [(i, 0, n - i) for i in range(n + 1)]]
    else:
        p, q = entry["degree"]
        place = {(i, j): j * (p + 1) + i for j in range(q + 1) for i in range(p + 1)}
        paths = [[(i, 0) for i in range(p + 1)], [(p, j) for j in range(q + 1)],
                 [(p - i, q) for i in range(p + 1)], [(0, q - j) for j in range(q + 1)]]
    return [(names[place[path[0]]], names[place[path[-1]]], tuple(control[place[e]] for e in path)) for path in paths]
