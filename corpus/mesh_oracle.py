#!/usr/bin/env python3
"""An independent, exact judge of curved planar Gmsh meshes (standard library only).

It shares no code, no formula and no file reader with bezcert's C++ library, and serves as its oracle.

    mesh_oracle.py                     judge corpus/meshes/*.msh, write expected.tsv and expected_bad.tsv
    mesh_oracle.py --check             the same, but compare with the two committed tables (exit 1 if they differ)
    mesh_oracle.py --list FILE...      one line per 2D element on stdout, nothing written
    mesh_oracle.py --self-test         node order against node_order.tsv, det J against a direct evaluation

Method. Coordinates are the doubles nearest to the text (or the doubles of a binary file), scaled by one power
of two per element to integers. Node (i, j) of an element of order n sits at (s, t) = (i, j), s = n u, t = n v.
Newton's forward differences give x and y in the basis C(s,a) C(t,b); Stirling numbers turn this into powers
of s and t; det J = x_s y_t - x_t y_s is multiplied out in the power basis, and only then brought to Bernstein
form (degree 2n-2 on the triangle, bidegree (2n-1, 2n-1) on the square), in integers. Bisection at midpoints then
decides: a piece whose coefficients are all >= 0 with corners > 0 is positive, a corner coefficient is an exact
value at a dyadic point.

det J is the derivative with respect to (u, v) of the unit right triangle (corner 0 at (0,0), 1 at (1,0), 2 at (0,1)),
or of the unit square [0,1]^2. Classes of a 2D element:
    positive     det J > 0 on the closed element, proven
    reversed     det J < 0 on the closed element, proven
    folded       det J < 0 somewhere and >= 0 somewhere, with exact witnesses
    degenerate   det J >= 0 everywhere with an exact zero, proven
    unknown      the budget of pieces ran out
`positive` speaks of det J only: it does not say that the element is injective.
"""

import heapq
import multiprocessing
import struct
import sys
from fractions import Fraction
from functools import lru_cache
from math import comb, factorial
from pathlib import Path
from random import Random

MESHES = Path(__file__).resolve().parent / "meshes"

TRIANGLES = {t: n for n, t in enumerate((2, 9, 21, 23, 25, 42, 43, 44, 45, 46), 1)}
QUADRILATERALS = {t: n for n, t in enumerate((3, 10, 36, 37, 38, 47, 48, 49, 50, 51), 1)}
LINES = {t: n for n, t in enumerate((1, 8, 26, 27, 28, 62, 63, 64, 65, 66), 1)}
VOLUME_NODES = {4: 4, 11: 10, 29: 20, 30: 35, 31: 56, 5: 8, 12: 27, 92: 64, 93: 125, 6: 6, 13: 18, 7: 5, 14: 14}

MAX_PIECES = 20000      # budget of one element's decision
MIN_SPLITS = 300        # effort spent on locating the minimum of a bad element


class Refused(Exception):
    pass


def shape(kind):
    """(dimension, number of nodes) of a Gmsh element type."""
    if kind == 15:
        return 0, 1
    if kind in LINES:
        return 1, LINES[kind] + 1
    if kind in TRIANGLES:
        n = TRIANGLES[kind]
        return 2, (n + 1) * (n + 2) // 2
    if kind in QUADRILATERALS:
        return 2, (QUADRILATERALS[kind] + 1) ** 2
    if kind in VOLUME_NODES:
        return 3, VOLUME_NODES[kind]
    raise Refused(f"element type {kind} is not a complete Lagrange element")


# --- reading ---------------------------------------------------------------------------------------------------

class Cursor:
    """A position in the bytes of a file, for lines, tokens and packed numbers."""

    def __init__(self, data):
        self.data, self.at, self.order = data, 0, "<"

    def line(self):
        if self.at >= len(self.data):
            return None
        end = self.data.find(b"\n", self.at)
        end = len(self.data) if end < 0 else end
        text = self.data[self.at:end].decode("latin-1").strip()
        self.at = end + 1
        return text

    def fields(self):
        text = self.line()
        while text == "":
            text = self.line()
        if text is None:
            raise Refused("unexpected end of file")
        return text.split()

    def packed(self, form):
        form = self.order + form
        size = struct.calcsize(form)
        if self.at + size > len(self.data):
            raise Refused("unexpected end of file")
        values = struct.unpack_from(form, self.data, self.at)
        self.at += size
        return values


def read_mesh(path):
    """({node tag: (x, y, z)}, [(element tag, type, [node tags])]) in file order."""
    cur = Cursor(Path(path).read_bytes())
    nodes, elements, version, binary = {}, [], None, False
    while (text := cur.line()) is not None:
        if not text:
            continue
        if text == "$MeshFormat":
            version, mode, size = cur.fields()
            binary = mode == "1"
            if version not in ("2.2", "4.1") or size != "8":
                raise Refused(f"format {version} with data size {size}")
            if binary:
                cur.order = "<" if cur.packed("i")[0] == 1 else ">"
        elif text == "$Nodes":
            (nodes_22 if version == "2.2" else nodes_41)(cur, binary, nodes)
        elif text == "$Elements":
            (elements_22 if version == "2.2" else elements_41)(cur, binary, elements)
        elif text == "$Entities" and binary:
            entities_41(cur)
        elif text == "$ParametricNodes":
            raise Refused("parametric nodes in format 2.2")
        elif text.startswith("$") and not text.startswith("$End"):
            end = cur.data.find(b"\n$End" + text[1:].encode(), cur.at - 1)
            if end < 0:
                raise Refused(f"{text} has no end")
            cur.at = end + 1
    return nodes, elements


def nodes_22(cur, binary, nodes):
    for _ in range(int(cur.fields()[0])):
        if binary:
            tag, *xyz = cur.packed("iddd")
        else:
            tag, *xyz = cur.fields()
        nodes[int(tag)] = tuple(float(c) for c in xyz)


def elements_22(cur, binary, elements):
    total = int(cur.fields()[0])
    while total > 0:
        if binary:
            kind, count, tags = cur.packed("iii")
            wide = shape(kind)[1]
            for _ in range(count):
                row = cur.packed(f"{1 + tags + wide}i")
                elements.append((row[0], kind, row[1 + tags:]))
            total -= count
        else:
            row = [int(f) for f in cur.fields()]
            elements.append((row[0], row[1], tuple(row[3 + row[2]:])))
            total -= 1


def nodes_41(cur, binary, nodes):
    blocks = (cur.packed("4Q") if binary else [int(f) for f in cur.fields()])[0]
    for _ in range(blocks):
        if binary:
            dim, _, parametric, count = cur.packed("iiiQ")
            wide = 3 + (dim if parametric else 0)
            tags = cur.packed(f"{count}Q")
            for tag in tags:
                nodes[tag] = cur.packed(f"{wide}d")[:3]
        else:
            dim, _, parametric, count = (int(f) for f in cur.fields())
            tags = [int(cur.fields()[0]) for _ in range(count)]
            for tag in tags:
                nodes[tag] = tuple(float(f) for f in cur.fields()[:3])


def elements_41(cur, binary, elements):
    blocks = (cur.packed("4Q") if binary else [int(f) for f in cur.fields()])[0]
    for _ in range(blocks):
        _, _, kind, count = cur.packed("iiiQ") if binary else [int(f) for f in cur.fields()]
        wide = shape(kind)[1]
        for _ in range(count):
            row = cur.packed(f"{1 + wide}Q") if binary else [int(f) for f in cur.fields()]
            elements.append((row[0], kind, tuple(row[1:])))


def entities_41(cur):
    counts = cur.packed("4Q")
    for dim, count in enumerate(counts):
        for _ in range(count):
            cur.packed("iddd" if dim == 0 else "i6d")
            cur.packed(f"{cur.packed('Q')[0]}i")
            if dim:
                cur.packed(f"{cur.packed('Q')[0]}i")


# --- Lagrange nodes to det J in Bernstein form -------------------------------------------------------------------

@lru_cache(None)
def node_order(square, n):
    """Grid places (i, j) of the nodes: corners, edges counter-clockwise, then the interior in the same way."""
    if n < 0:
        return ()
    if n == 0:
        return ((0, 0),)
    corners = ((0, 0), (n, 0), (n, n), (0, n)) if square else ((0, 0), (n, 0), (0, n))
    places = list(corners)
    for a, b in zip(corners, corners[1:] + corners[:1]):
        step = ((b[0] - a[0]) // n, (b[1] - a[1]) // n)
        places += [(a[0] + k * step[0], a[1] + k * step[1]) for k in range(1, n)]
    inner = node_order(square, n - (2 if square else 3))
    return tuple(places + [(i + 1, j + 1) for i, j in inner])


@lru_cache(None)
def falling(n):
    """Row a: coefficients of n! C(s, a) in the powers of s (signed Stirling numbers, scaled)."""
    rows, row = [], [1]
    for a in range(n + 1):
        rows.append([c * (factorial(n) // factorial(a)) for c in row])
        row = [(row[k - 1] if k else 0) - a * (row[k] if k < len(row) else 0) for k in range(len(row) + 1)]
    return rows


def powers(values, square, n):
    """Coefficients of (n!)^2 f in s^i t^j from integer values on the grid."""
    line = [[values.get((i, j), 0) for j in range(n + 1)] for i in range(n + 1)]
    newton = [[0] * (n + 1) for _ in range(n + 1)]
    # differences along s for every t, then along t; on the triangle only i + j <= n enters
    for j in range(n + 1):
        column = [line[i][j] for i in range((n if square else n - j) + 1)]
        for a in range(len(column)):
            newton[a][j] = column[0]
            column = [q - p for p, q in zip(column, column[1:])]
    for a in range(n + 1):
        column = newton[a][:(n if square else n - a) + 1]
        newton[a] = [0] * (n + 1)
        for b in range(len(column)):
            newton[a][b] = column[0]
            column = [q - p for p, q in zip(column, column[1:])]
    stirling, out = falling(n), [[0] * (n + 1) for _ in range(n + 1)]
    for a in range(n + 1):
        row = [0] * (n + 1)
        for b, c in enumerate(newton[a]):
            if c:
                for k, s in enumerate(stirling[b]):
                    row[k] += c * s
        for k, s in enumerate(stirling[a]):
            if s:
                for j in range(n + 1):
                    out[k][j] += s * row[j]
    return {(i, j): c for i, r in enumerate(out) for j, c in enumerate(r) if c}


def product(f, g, into, sign):
    for (a, b), p in f.items():
        for (c, d), q in g.items():
            key = (a + c, b + d)
            into[key] = into.get(key, 0) + sign * p * q


def det_powers(x, y):
    ds = lambda f: {(i - 1, j): i * c for (i, j), c in f.items() if i}
    dt = lambda f: {(i, j - 1): j * c for (i, j), c in f.items() if j}
    det = {}
    product(ds(x), dt(y), det, 1)
    product(dt(x), ds(y), det, -1)
    return det


def bernstein(det, square, n):
    """Rows of integer Bernstein coefficients and the positive factor they carry, from powers of s, t."""
    fall = lambda a, i: factorial(a) // factorial(a - i)
    if square:
        d = 2 * n - 1
        partial = [[0] * (d + 1) for _ in range(d + 1)]
        for (i, j), c in det.items():
            c *= n ** (i + j) * factorial(d - i) * factorial(d - j)
            for b in range(j, d + 1):
                partial[i][b] += c * fall(b, j)
        rows = [[sum(fall(a, i) * partial[i][b] for i in range(a + 1)) for b in range(d + 1)] for a in range(d + 1)]
        return rows, factorial(d) ** 2
    d = 2 * n - 2
    rows = [[0] * (d + 1 - a) for a in range(d + 1)]
    for (i, j), c in det.items():
        if not c:
            continue
        if i + j > d:
            raise AssertionError("degree of det J")
        c *= n ** (i + j) * factorial(d - i - j)
        for a in range(i, d + 1 - j):
            ca = c * fall(a, i)
            for b in range(j, d + 1 - a):
                rows[a][b] += ca * fall(b, j)
    return rows, factorial(d)


def jacobian(kind, points):
    """(square, rows of integer coefficients, factor): det J = Bernstein polynomial / factor."""
    square = kind in QUADRILATERALS
    n = QUADRILATERALS[kind] if square else TRIANGLES[kind]
    ratios = [[c.as_integer_ratio() for c in p] for p in points]
    common = max(q for p in ratios for _, q in p)
    fields = []
    for axis in (0, 1):
        grid = {place: r[axis][0] * (common // r[axis][1]) for place, r in zip(node_order(square, n), ratios)}
        fields.append(powers(grid, square, n))
    rows, factor = bernstein(det_powers(*fields), square, n)
    # d/du = n d/ds, likewise v; each field carries (n!)^2 and the common power of two
    return square, rows, Fraction(factor * factorial(n) ** 4 * common ** 2, n * n)


# --- bisection --------------------------------------------------------------------------------------------------

def halves(row):
    """The two halves of one Bernstein row, both multiplied by 2^degree."""
    d = len(row) - 1
    left, right, now = [row[0] << d], [row[-1] << d], row
    for r in range(1, d + 1):
        now = [p + q for p, q in zip(now, now[1:])]
        left.append(now[0] << (d - r))
        right.append(now[-1] << (d - r))
    return left, right[::-1]


class Piece:
    """A sub-triangle (three vertices) or sub-rectangle (lower left, upper right): value = coefficient / 2^shift."""
    __slots__ = ("square", "rows", "where", "shift", "turn")

    def __init__(self, square, rows, where, shift=0, turn=0):
        self.square, self.rows, self.where, self.shift, self.turn = square, rows, where, shift, turn

    def corners(self):
        """Pairs (coefficient, (u, v))."""
        rows = self.rows
        if self.square:
            (u0, v0), (u1, v1) = self.where
            return [(rows[0][0], (u0, v0)), (rows[-1][0], (u1, v0)), (rows[-1][-1], (u1, v1)), (rows[0][-1], (u0, v1))]
        return list(zip((rows[0][0], rows[-1][0], rows[0][-1]), self.where))

    def split(self):
        if self.square:
            (u0, v0), (u1, v1) = self.where
            rows = self.rows if self.turn else [list(r) for r in zip(*self.rows)]
            pairs = [halves(r) for r in rows]
            first, second = [p[0] for p in pairs], [p[1] for p in pairs]
            shift = self.shift + len(self.rows) - 1
            if self.turn:
                m = (v0 + v1) / 2
                spots = ((u0, v0), (u1, m)), ((u0, m), (u1, v1))
            else:
                first, second = [list(r) for r in zip(*first)], [list(r) for r in zip(*second)]
                m = (u0 + u1) / 2
                spots = ((u0, v0), (m, v1)), ((m, v0), (u1, v1))
            return [Piece(True, r, w, shift, 1 - self.turn) for r, w in zip((first, second), spots)]
        # Rows a run along the direction 0 -> 2 at fixed exponent a of corner 1: each row is halved on its own,
        # which bisects edge 0-2 at M. Row a is a polynomial of degree d - a, so it gets the missing factor 2^a.
        d = len(self.rows) - 1
        p0, p1, p2 = self.where
        m = ((p0[0] + p2[0]) / 2, (p0[1] + p2[1]) / 2)
        near, far = [], []
        for a, row in enumerate(self.rows):
            left, right = halves(row)
            near.append([c << a for c in left])
            far.append([c << a for c in right])
        # (p0, p1, m) and (m, p1, p2); re-label so that the next bisection cuts the edge opposite m
        # new corners (0, 1, 2): for `near` (p0, m, p1), for `far` (p1, m, p2), so the edge 0-2 never contains m
        one = [[near[c][b] for c in range(d + 1 - b)] for b in range(d + 1)]
        two = [[far[d - b - c][c] for c in range(d + 1 - b)] for b in range(d + 1)]
        return [Piece(False, one, (p0, m, p1), self.shift + d), Piece(False, two, (p1, m, p2), self.shift + d)]


def whole(square, rows):
    zero, one = Fraction(0), Fraction(1)
    return Piece(square, rows, ((zero, zero), (one, one)) if square else ((zero, zero), (one, zero), (zero, one)))


def classify(square, rows):
    waiting, done = [whole(square, rows)], 0
    negative = nonnegative = zero = False
    while waiting:
        following = []
        for piece in waiting:
            done += 1
            if done > MAX_PIECES:
                return "unknown"
            low, high = min(map(min, piece.rows)), max(map(max, piece.rows))
            ends = [c for c, _ in piece.corners()]
            negative |= min(ends) < 0
            nonnegative |= max(ends) >= 0
            zero |= 0 in ends
            if negative and nonnegative:
                return "folded"
            settled = low >= 0 or high < 0 or (high <= 0 and max(ends) < 0)
            if not settled:
                following += piece.split()
        waiting = following
    return "reversed" if negative else "degenerate" if zero else "positive"


def minimum(square, rows, factor):
    """(least exact sample, its (u, v), a lower bound), by bisecting where the bound is least."""
    value = lambda c, piece: Fraction(c, 1 << piece.shift) / factor
    first = whole(square, rows)
    best, place = None, None
    heap, count = [], 0

    def put(piece):
        nonlocal best, place, count
        for c, uv in piece.corners():
            sample = value(c, piece)
            if best is None or sample < best:
                best, place = sample, uv
        heapq.heappush(heap, (value(min(map(min, piece.rows)), piece), count, piece))
        count += 1

    put(first)
    for _ in range(MIN_SPLITS):
        bound = heap[0][0]
        if best - bound <= abs(best) / 10 ** 12:
            break
        for child in heapq.heappop(heap)[2].split():
            put(child)
    return best, place, heap[0][0]


# --- judging files --------------------------------------------------------------------------------------------

def judge_element(job):
    tag, kind, points, always = job
    square, rows, factor = jacobian(kind, points)
    verdict = classify(square, rows)
    if verdict != "positive" or always:
        return tag, kind, verdict, minimum(square, rows, factor)
    return tag, kind, verdict, None


def judge_file(path, pool, always=False):
    """(ignored counts by dimension, results per 2D element in file order)."""
    nodes, elements = read_mesh(path)
    ignored, jobs = [0, 0, 0, 0], []
    for tag, kind, tags in elements:
        dim, wide = shape(kind)
        if len(tags) != wide:
            raise Refused(f"element {tag} of type {kind} has {len(tags)} nodes instead of {wide}")
        if dim != 2:
            ignored[dim] += 1
            continue
        points = [nodes[t] for t in tags]
        if any(p[2] != 0 for p in points):
            raise Refused(f"element {tag} is not in the plane z = 0")
        jobs.append((tag, kind, [p[:2] for p in points], always))
    return ignored, pool.map(judge_element, jobs, chunksize=4)


def decimal(q):
    return repr(float(q))


def tables(pool):
    header = "file elements triangles quadrilaterals folded reversed degenerate positive ignored_points ignored_lines ignored_volumes"
    summary = [header.split()]
    bad = ["file element class det_min u v det_lower_bound".split()]
    unknown = 0
    for path in sorted(MESHES.glob("*.msh")):
        ignored, results = judge_file(path, pool)
        count = lambda verdict: sum(r[2] == verdict for r in results)
        unknown += count("unknown")
        squares = sum(r[1] in QUADRILATERALS for r in results)
        summary.append([path.name, len(results), len(results) - squares, squares, count("folded"), count("reversed"),
                        count("degenerate"), count("positive"), ignored[0], ignored[1], ignored[3]])
        for tag, _, verdict, least in results:
            if least:
                bad.append([path.name, tag, verdict, decimal(least[0]), *map(str, least[1]), decimal(least[2])])
    text = ["".join("\t".join(map(str, row)) + "\n" for row in table) for table in (summary, bad)]
    return text, unknown


def self_test():
    table = {}
    for line in (MESHES / "node_order.tsv").read_text().splitlines()[1:]:
        kind, index, i, j = map(int, line.split("\t"))
        table.setdefault(kind, {})[index] = (i, j)
    random = Random(1)
    for family, square in ((TRIANGLES, False), (QUADRILATERALS, True)):
        for kind, n in family.items():
            order = node_order(square, n)
            assert {k: p for k, p in enumerate(order)} == table[kind], kind
            points = [(i / n + random.uniform(-.2, .2) / n, j / n + random.uniform(-.2, .2) / n) for i, j in order]
            _, rows, factor = jacobian(kind, points)
            deep = whole(square, rows)
            for _ in range(5):
                deep = random.choice(deep.split())
                for c, (u, v) in deep.corners():
                    assert Fraction(c, 1 << deep.shift) / factor == direct(square, n, points, u, v), (kind, u, v)
            print(f"type {kind}, order {n}: node order and det J agree")


def direct(square, n, points, u, v):
    """det J by the Lagrange basis as products of linear factors, differentiated by the product rule."""
    s, t = n * u, n * v

    def factor(x, k):
        """product_{m<k} (x - m) / (k - m) and its derivative."""
        f, g = Fraction(1), Fraction(0)
        for m in range(k):
            g = (g * (x - m) + f) / (k - m)
            f = f * (x - m) / (k - m)
        return f, g

    def full(x, k):
        """The Lagrange polynomial of node k of 0..n and its derivative."""
        f, g = Fraction(1), Fraction(0)
        for m in range(n + 1):
            if m != k:
                g = (g * (x - m) + f) / (k - m)
                f = f * (x - m) / (k - m)
        return f, g

    sums = [[Fraction(0), Fraction(0)], [Fraction(0), Fraction(0)]]
    for (i, j), p in zip(node_order(square, n), points):
        if square:
            (a, da), (b, db) = full(s, i), full(t, j)
            gradient = (da * b, a * db)
        else:
            (a, da), (b, db), (c, dc) = factor(s, i), factor(t, j), factor(n - s - t, n - i - j)
            gradient = (da * b * c - a * b * dc, a * db * c - a * b * dc)
        for axis in (0, 1):
            for k in (0, 1):
                sums[axis][k] += Fraction(p[axis]) * gradient[k]
    return n * n * (sums[0][0] * sums[1][1] - sums[0][1] * sums[1][0])


def main(arguments):
    if arguments == ["--self-test"]:
        self_test()
        return 0
    with multiprocessing.Pool() as pool:
        if arguments[:1] == ["--list"]:
            print("file element type class det_min u v det_lower_bound".replace(" ", "\t"))
            for name in arguments[1:]:
                try:
                    _, results = judge_file(name, pool, True)
                except Refused as why:
                    print(f"{name}: {why}", file=sys.stderr)
                    return 2
                for tag, kind, verdict, least in results:
                    row = [Path(name).name, tag, kind, verdict, decimal(least[0]), *least[1], decimal(least[2])]
                    print(*row, sep="\t")
            return 0
        if arguments not in ([], ["--check"]):
            print(__doc__, file=sys.stderr)
            return 2
        text, unknown = tables(pool)
        names = ("expected.tsv", "expected_bad.tsv")
        if arguments:
            wrong = [n for n, t in zip(names, text) if (MESHES / n).read_text() != t]
            print(f"differs from the committed table: {', '.join(wrong)}" if wrong else "both tables agree")
            return 1 if wrong else 0
        for name, content in zip(names, text):
            (MESHES / name).write_text(content)
        if unknown:
            print(f"{unknown} elements are unknown", file=sys.stderr)
        return 3 if unknown else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
