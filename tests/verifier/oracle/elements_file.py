"""The elements file: .msh 2.x and 4.1 (ASCII) and .bez.json, exact. Only well-formed files: the tests of malformed ones need no oracle."""
import json
from fractions import Fraction as Q
from math import comb, factorial

import polynomials as P

TRIANGLES = [2, 9, 21, 23, 25, 42, 43, 44, 45, 46]
QUADS = [3, 10, 36, 37, 38, 47, 48, 49, 50, 51]


class Element:
    """points, weights: of the file, in its order and basis; cx, cy, cw: control points and weights."""

    def __init__(self, triangle, p, q, lagrange, points, weights, nodes):
        self.triangle, self.p, self.q, self.lagrange = triangle, p, q, lagrange
        self.points, self.weights, self.nodes = points, weights, nodes
        self.indices = ([(c, r) for r in range(p + 1) for c in range(p + 1 - r)] if triangle
                        else [(c, r) for r in range(q + 1) for c in range(p + 1)])
        assert len(points) == len(self.indices)
        h = [[w * x for (x, _), w in zip(points, weights)], [w * y for (_, y), w in zip(points, weights)], list(weights)]
        self.h = [self.control(row) if lagrange else dict(zip(self.indices, row)) for row in h]
        if any(w <= 0 for w in self.h[2].values()):
            raise ValueError("a weight is not positive")
        self.rational = len(set(self.h[2].values())) > 1
        if not self.rational:
            w = next(iter(self.h[2].values()))
            self.h = [{k: c / w for k, c in row.items()} for row in self.h]
        self.xyw = [self.power(row) for row in self.h]
        self.edges = 3 if triangle else 4
        X, Y, W = self.xyw
        d = P.diff2
        minor = lambda a, b: P.add2(P.mul2(d(a, 0), d(b, 1)), P.mul2(d(a, 1), d(b, 0)), -1)
        if self.rational:
            self.N = P.add2(P.add2(P.mul2(X, minor(Y, W)), P.mul2(Y, minor(X, W)), -1), P.mul2(W, minor(X, Y)))
        else:
            self.N = minor(X, Y)
        n = 3 if self.rational else 2
        self.N_degree = n * (p - 1) if triangle else (n * p - n + 1, n * q - n + 1)

    def control(self, values):
        """Lagrange nodes to control values: solved as a linear system, line by line for quadrilaterals."""
        if self.triangle:
            n = self.p
            matrix = [[multi(n, i, j) * power(Q(n - r - c, n), n - i - j) * power(Q(c, n), i) * power(Q(r, n), j)
                       for (i, j) in self.indices] for (c, r) in self.indices]
            return dict(zip(self.indices, solve(matrix, values)))
        grid = dict(zip(self.indices, values))
        for r in range(self.q + 1):
            line = line_control([grid[c, r] for c in range(self.p + 1)])
            grid.update({(c, r): line[c] for c in range(self.p + 1)})
        for c in range(self.p + 1):
            line = line_control([grid[c, r] for r in range(self.q + 1)])
            grid.update({(c, r): line[r] for r in range(self.q + 1)})
        return grid

    def power(self, net):
        u, v, one = {(1, 0): Q(1)}, {(0, 1): Q(1)}, {(0, 0): Q(1)}
        result = {}
        for (i, j), c in net.items():
            if self.triangle:
                term = P.mul2(P.power2(P.linear2(1, -1, -1), self.p - i - j), P.mul2(P.power2(u, i), P.power2(v, j)))
                c *= multi(self.p, i, j)
            else:
                term = P.mul2(P.mul2(P.power2(u, i), P.power2(P.linear2(1, -1, 0), self.p - i)),
                              P.mul2(P.power2(v, j), P.power2(P.linear2(1, 0, -1), self.q - j)))
                c *= comb(self.p, i) * comb(self.q, j)
            result = P.add2(result, term, c)
        return P.clean(result)

    def edge_indices(self, e):
        p, q = self.p, self.q
        if self.triangle:
            return [[(k, 0) for k in range(p + 1)], [(p - k, k) for k in range(p + 1)], [(0, p - k) for k in range(p + 1)]][e]
        return [[(k, 0) for k in range(p + 1)], [(p, k) for k in range(q + 1)], [(p - k, q) for k in range(p + 1)],
                [(0, q - k) for k in range(q + 1)]][e]

    def edge(self, e):
        """Homogeneous control points [(x, y, w)]."""
        return [tuple(row[k] for row in self.h) for k in self.edge_indices(e)]

    def edge_nodes(self, e):
        where = {k: n for k, n in zip(self.indices, self.nodes)}
        return [where[k] for k in self.edge_indices(e)]

    def corner_node(self, e):
        return self.edge_nodes(e)[0]

    def image(self, u, v):
        x, y, w = (P.value2(f, u, v) for f in self.xyw)
        return x / w, y / w

    def contains(self, u, v):
        return 0 <= u and 0 <= v and (u + v <= 1 if self.triangle else u <= 1 and v <= 1)


def power(x, n):
    return x ** n if n else Q(1)


def multi(n, i, j):
    return factorial(n) // (factorial(i) * factorial(j) * factorial(n - i - j))


def solve(matrix, values):
    m = [list(map(Q, row)) + [Q(v)] for row, v in zip(matrix, values)]
    for k in range(len(m)):
        pivot = next(r for r in range(k, len(m)) if m[r][k] != 0)
        m[k], m[pivot] = m[pivot], m[k]
        m[k] = [a / m[k][k] for a in m[k]]
        for r in range(len(m)):
            if r != k and m[r][k] != 0:
                m[r] = [a - m[r][k] * b for a, b in zip(m[r], m[k])]
    return [row[-1] for row in m]


def line_control(values):
    n = len(values) - 1
    return solve([[comb(n, i) * power(1 - Q(c, n), n - i) * power(Q(c, n), i) for i in range(n + 1)] for c in range(n + 1)], values)


class File:
    def __init__(self, data, basis, numbers):
        text = data.decode("utf-8")
        self.by_nodes = True
        self.elements = self.msh(text, basis, numbers) if text.lstrip()[0] == "$" else self.bez(text)

    def msh(self, text, basis, numbers):
        exact = (lambda t: Q(float(t))) if numbers == "binary64" else Q
        lines = iter([line.split() for line in text.splitlines() if line.split()])
        nodes, raw, version = {}, [], None
        for line in lines:
            if line[0] == "$MeshFormat":
                version = next(lines)[0]
            elif line[0] == "$Nodes" and version[0] == "2":
                for _ in range(int(next(lines)[0])):
                    tag, x, y, _ = next(lines)
                    nodes[int(tag)] = (exact(x), exact(y))
            elif line[0] == "$Nodes":
                for _ in range(int(next(lines)[0])):
                    tags = [int(next(lines)[0]) for _ in range(int(next(lines)[3]))]
                    for tag in tags:
                        x, y = next(lines)[:2]
                        nodes[tag] = (exact(x), exact(y))
            elif line[0] == "$Elements" and version[0] == "2":
                for _ in range(int(next(lines)[0])):
                    record = list(map(int, next(lines)))
                    raw.append((record[1], record[3 + record[2]:]))
            elif line[0] == "$Elements":
                for _ in range(int(next(lines)[0])):
                    _, _, kind, count = map(int, next(lines))
                    raw += [(kind, list(map(int, next(lines)))[1:]) for _ in range(count)]
        result = []
        for kind, tags in raw:
            if kind not in TRIANGLES + QUADS:
                continue
            triangle = kind in TRIANGLES
            n = (TRIANGLES if triangle else QUADS).index(kind) + 1
            order = [None] * len(tags)
            keys = [(c, r) for r in range(n + 1) for c in range(n + 1 - r)] if triangle else [(c, r) for r in range(n + 1) for c in range(n + 1)]
            for tag, key in zip(tags, ring(triangle, n)):
                order[keys.index(key)] = tag
            result.append(Element(triangle, n, n, basis == "lagrange", [nodes[t] for t in order], [Q(1)] * len(order), order))
        return result

    def bez(self, text):
        data = json.loads(text, parse_float=Q, parse_int=Q)
        shared = [tuple(map(Q, p)) for p in data.get("points", [])]
        shared_weights = list(map(Q, data.get("weights", [1] * len(shared))))
        self.by_nodes = all("nodes" in e for e in data["elements"])
        result, places = [], len(shared)
        for e in data["elements"]:
            triangle = e["kind"] == "triangle"
            p, q = (int(e["degree"]),) * 2 if triangle else map(int, e["degree"])
            if "nodes" in e:
                nodes = list(map(int, e["nodes"]))
                points, weights = [shared[i] for i in nodes], [shared_weights[i] for i in nodes]
            else:
                points = [tuple(map(Q, x)) for x in e["points"]]
                weights = list(map(Q, e.get("weights", [1] * len(points))))
                nodes = list(range(places, places + len(points)))
                places += len(points)
            result.append(Element(triangle, p, q, e.get("basis", "bernstein") == "lagrange", points, weights, nodes))
        return result


def ring(triangle, n, o=0):
    """Gmsh's order as (column, row): corners, edges counter-clockwise, then the inside."""
    if n < 0:
        return []
    if n == 0:
        return [(o, o)]
    if triangle:
        r = [(0, 0), (n, 0), (0, n)] + [(k, 0) for k in range(1, n)] + [(n - k, k) for k in range(1, n)] + [(0, n - k) for k in range(1, n)]
        return [(o + a, o + b) for a, b in r] + ring(triangle, n - 3, o + 1)
    r = [(0, 0), (n, 0), (n, n), (0, n)] + [(k, 0) for k in range(1, n)] + [(n, k) for k in range(1, n)]
    r += [(n - k, n) for k in range(1, n)] + [(0, n - k) for k in range(1, n)]
    return [(o + a, o + b) for a, b in r] + ring(triangle, n - 2, o + 1)
