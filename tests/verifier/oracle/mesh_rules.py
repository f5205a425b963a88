"""The claim of the mesh, by the letter of certificate-format.md."""
from fractions import Fraction as Q
from math import comb

import polynomials as P
from curves import affine, check_meet, check_pair, cross, dot, halves, minus, point, read_meet
from tokens import Rejected, Tokens, require, well

DEEPEST = 64


class Unsure(Rejected):
    pass


def box(c):
    p = [affine(x) for x in c]
    return [(min(x[k] for x in p), max(x[k] for x in p)) for k in (0, 1)]


def outside(b, q):
    return any(x < low or x > high for x, (low, high) in zip(q, b))


def chords(c, q, depth=0):
    """A polygon that has q off it and the curve's winding; None if q may be on the curve."""
    if outside(box(c), q):
        return [affine(c[0]), affine(c[-1])]
    if depth == DEEPEST or affine(c[0]) == q or affine(c[-1]) == q:
        return None
    a, b = (chords(h, q, depth + 1) for h in halves(c))
    return None if a is None or b is None else a + b[1:]


def off(c, q):
    return chords(c, q) is not None


def winding(loop, q):
    total = 0
    for c in loop:
        polygon = chords(c, q)
        if polygon is None:
            raise Unsure("winding: the point is on the curve")
        for a, b in zip(polygon, polygon[1:]):
            turn = cross(minus(a, q), minus(b, q))
            if a[1] <= q[1] < b[1] and turn > 0:
                total += 1
            elif b[1] <= q[1] < a[1] and turn < 0:
                total -= 1
    return total


def area_sign(loop):
    """Polynomial curves: exact. Others: pieces, the area between chord and piece bounded by the hull of the control points."""
    for depth in range(14):
        pieces = loop
        for _ in range(depth):
            pieces = [h for c in pieces for h in halves(c)]
        low = high = Q(0)
        for c in pieces:
            p = [affine(x) for x in c]
            low += cross(p[0], p[-1]) / 2
            high += cross(p[0], p[-1]) / 2
            if len({x[2] for x in c}) == 1:
                share = polynomial_area(p) - cross(p[0], p[-1]) / 2
                low, high = low + share, high + share
                continue
            (x0, x1), (y0, y1) = box(c)
            size = sum((abs(cross(minus(b, a), minus(d, a))) for a, b, d in zip([p[0]] * len(p), p[1:], p[2:])), Q(0)) / 2
            size = max(size, max((abs(cross(minus(p[-1], p[0]), minus(x, p[0]))) for x in p), default=0) * len(p) + (x1 - x0) * (y1 - y0))
            low, high = low - size, high + size
        if low > 0 or high < 0:
            return 1 if low > 0 else -1
    raise Unsure("area")


def polynomial_area(p):
    x, y = (P.from_bernstein1([q[k] for q in p]) for k in (0, 1))
    f = P.add1(P.mul1(x, P.derivative1(y)), P.mul1(y, P.derivative1(x)), -1)
    return sum((c / (i + 1) for i, c in enumerate(f)), Q(0)) / 2


def reduced(c):
    """Coefficients of z^i, z = t / (1 - t), of (X, Y, W) without their common divisor."""
    rows = [P.trim([comb(len(c) - 1, i) * Q(p[k]) for i, p in enumerate(c)]) for k in range(3)]
    divisor = []
    for row in rows:
        divisor = P.gcd1(row, divisor) if row and divisor else (row or divisor)
    rows = [P.divmod1(row, divisor)[0] for row in rows]
    return [[row[i] if i < len(row) else Q(0) for row in rows] for i in range(max(map(len, rows)))]


class Mesh:
    def __init__(self, file):
        self.file, self.elements = file, file.elements
        self.uses = [(i, e) for i, x in enumerate(self.elements) for e in range(x.edges)]
        self.curve = {u: self.elements[u[0]].edge(u[1]) for u in self.uses}
        self.mate = {}
        by_ends = {}
        for u in self.uses:
            by_ends.setdefault(self.ends(u), []).append(u)
        for u in self.uses:
            a, b = self.ends(u)
            if a == b or u in self.mate:
                continue
            for w in by_ends.get((b, a), []):
                if w not in self.mate and (self.same(u, w) or self.one_edge(u, w)):
                    self.mate[u], self.mate[w] = w, u
                    break

    def vertex(self, u):
        x = self.elements[u[0]]
        return x.corner_node(u[1]) if self.file.by_nodes else affine(self.curve[u][0])

    def ends(self, u):
        return self.vertex(u), self.vertex(self.next(u))

    def next(self, u):
        return u[0], (u[1] + 1) % self.elements[u[0]].edges

    def before(self, u):
        return u[0], (u[1] - 1) % self.elements[u[0]].edges

    def same(self, u, w):
        """Opposite uses between the same vertices: the same curve by nodes or control points."""
        x, y = self.elements[u[0]], self.elements[w[0]]
        if self.file.by_nodes and x.lagrange == y.lagrange and x.edge_nodes(u[1]) == y.edge_nodes(w[1])[::-1]:
            return True
        c, d = self.curve[u], self.curve[w][::-1]
        return len(c) == len(d) and all(affine(p) == affine(q) for p, q in zip(c, d)) and len(
            {Q(p[2]) / q[2] for p, q in zip(c, d)}) == 1

    def one_edge(self, u, w):
        """Opposite uses that are one curve in different parameters (mesh.md, "Same curves")."""
        a, b = self.ends(u)
        if a == b or self.ends(w) != (b, a) or u == w:
            return False
        curves = self.curve[u], self.curve[w][::-1]
        if any(affine(c[0]) == affine(c[1]) for c in curves):  # not regular there: perhaps
            return True
        first, second = map(reduced, curves)
        ratios = []
        for p, q in zip(first, second):
            if any(p) != any(q):
                return False
            if any(p):
                k = next(k for k in range(3) if p[k])
                r = q[k] / p[k]
                if r == 0 or any(q[l] != r * p[l] for l in range(3)):
                    return False
                ratios.append(r)
            else:
                ratios.append(None)
        if len(first) != len(second) or any(r is not None and r * ratios[0] < 0 for r in ratios):
            return False
        r = [None if x is None else x / ratios[0] for x in ratios]
        j = next(i for i in range(1, len(r)) if r[i] is not None)
        return all(x is None or x ** j == r[j] ** i for i, x in enumerate(r))

    def use(self, tokens):
        position, e = tokens.edge()
        well(1 <= position <= len(self.elements) and 0 <= e < self.elements[position - 1].edges, "no such edge")
        return position - 1, e

    def follower(self, u):
        """The boundary use that leaves the vertex where the boundary use u ends."""
        u = self.next(u)
        for _ in range(len(self.uses)):
            if u not in self.mate:
                return u
            u = self.next(self.mate[u])
        raise Rejected("no boundary")

    def loops(self):
        rest, result = [u for u in self.uses if u not in self.mate], []
        while rest:
            loop = [rest[0]]
            while self.follower(loop[-1]) != loop[0]:
                loop.append(self.follower(loop[-1]))
            result.append(loop)
            rest = [u for u in rest if u not in loop]
        return result

    def reached(self, u, w):
        """Whether the corner where w begins is reached from that of u across edges that are or could be glued."""
        seen, work = {u}, [u]
        while work:
            x = work.pop()
            for y in self.uses:
                if y not in seen and self.vertex(y) == self.vertex(x) and (
                        self.neighbours(self.before(x), y) or self.neighbours(self.before(y), x)):
                    seen.add(y)
                    work.append(y)
        return w in seen

    def neighbours(self, u, w):
        return self.mate.get(u) == w or self.one_edge(u, w)

    def alone(self, u):
        return u not in self.mate and not any(self.one_edge(u, w) for w in self.uses)


def check_embedding(mesh, claims, next_tokens):
    require(all(c == "injective" for c in claims), "embedding: an element")
    tokens, pairs, loops = next_tokens(), {}, mesh.loops()
    while tokens.tokens[0] != "end":
        tokens.rule(["pair"])
        u, w = mesh.use(tokens), mesh.use(tokens)
        require(u[0] != w[0] and u not in mesh.mate and w not in mesh.mate, "pair: not boundary")
        joints = ({"eb"} if mesh.follower(u) == w else set()) | ({"be"} if mesh.follower(w) == u else set())
        check_pair(tokens, mesh.curve[u], mesh.curve[w], joints)
        pairs[frozenset((u, w))] = True
        tokens.end()
        tokens = next_tokens()
    boundary = [u for loop in loops for u in loop]
    boxes = {u: box(mesh.curve[u]) for u in boundary}
    for i, u in enumerate(boundary):
        for w in boundary[:i]:
            if u[0] != w[0] and frozenset((u, w)) not in pairs:
                meet = all(a[0] <= b[1] and b[0] <= a[1] for a, b in zip(boxes[u], boxes[w]))
                require(not meet, f"no pair {u} {w}")
    curves = [[mesh.curve[u] for u in loop] for loop in loops]
    for i, loop in enumerate(curves):
        q = affine(loop[0][0])
        o = sum(winding(other, q) for k, other in enumerate(curves) if k != i)
        require(o == (0 if area_sign(loop) > 0 else 1), "loops: winding")
    return tokens


def close(mesh, u, differences):
    x = mesh.elements[u[0]]
    c = mesh.curve[u]
    begin, end = affine(c[0]), affine(c[-1])
    a = minus(end, begin)
    points = x.points
    height = max(abs(cross(a, minus(p, begin))) for p in points)
    far = next(minus(p, begin) for p in points if abs(cross(a, minus(p, begin))) == height)
    return height != 0 and all(abs(cross(d, far)) <= height / 8 and abs(cross(a, d)) <= height / 8 for d in differences)


def check_gap(mesh, tokens):
    u, w = mesh.use(tokens), mesh.use(tokens)
    a, b = mesh.ends(u)
    well(tokens.at < len(tokens.tokens), "gap ends")
    if "." not in tokens.tokens[tokens.at]:
        t = tokens.rational()
        require(0 <= t <= 1, "gap: parameter")
        require(mesh.alone(u) and mesh.alone(w), "gap: glued")
        require(a != b and mesh.ends(w) == (b, a), "gap: ends")
        require(off(mesh.curve[w], point(mesh.curve[u], t)), "gap: on the curve")
        d = [minus(point(mesh.curve[u], Q(k, 16)), point(mesh.curve[w], 1 - Q(k, 16))) for k in range(1, 16)]
        require(close(mesh, u, d) or close(mesh, w, d), "gap: far")
        return
    x = mesh.use(tokens)
    c, d = mesh.ends(w)
    require(b == c and mesh.ends(x) == (d, a), "gap: ends")
    require(u[0] not in (w[0], x[0]), "gap: elements")
    require(all(map(mesh.alone, (u, w, x))), "gap: glued")
    node = affine(mesh.curve[x][0])
    require(off(mesh.curve[u], node), "gap: on the edge")
    places = [point(mesh.curve[u], Q(k, 32)) for k in range(33)]
    for q in (node, point(mesh.curve[w], Q(1, 2)), point(mesh.curve[x], Q(1, 2))):
        require(any(close(mesh, u, [minus(q, p)]) for p in places), "gap: far")


def check_refuted(mesh, claims, tokens):
    rule = tokens.rule(["element", "cover", "touch", "pinch", "gap"])
    position = lambda: tokens.small(1, len(claims)) - 1
    if rule == "element":
        require(claims[position()] in ("overlapping", "degenerate", "folded", "reversed", "invalid"), "refuted element")
    elif rule == "cover":
        i, k = position(), position()
        q = tokens.rational(), tokens.rational()
        require(i != k and claims[i] == claims[k] == "injective", "cover: elements")
        for n in (i, k):
            require(winding([mesh.curve[n, e] for e in range(mesh.elements[n].edges)], q) == 1, "cover: winding")
    elif rule == "touch":
        meet = read_meet(tokens, True)
        uses = []
        for p, e in (meet.first, meet.second):
            well(1 <= p <= len(claims) and 0 <= e < mesh.elements[p - 1].edges, "no such edge")
            uses.append((p - 1, e))
        u, w = uses
        same = u == w
        if u[0] == w[0]:
            common = {(i, j) for i, x in ((0, u), (1, mesh.next(u))) for j, y in ((0, w), (1, mesh.next(w))) if x == y and not same}
        else:
            require(mesh.mate.get(u) != w and not mesh.one_edge(u, w), "touch: glued")
            common = {(i, j) for i in (0, 1) for j in (0, 1) if mesh.ends(u)[i] == mesh.ends(w)[j]}
        check_meet(meet, mesh.curve[u], mesh.curve[w], same, common)
    elif rule == "pinch":
        u, w = mesh.use(tokens), mesh.use(tokens)
        require(mesh.vertex(u) == mesh.vertex(w), "pinch: vertices")
        require(not mesh.reached(u, w), "pinch: one fan")
    else:
        check_gap(mesh, tokens)


def check_mesh(mesh, claims, tokens, next_tokens):
    claim = tokens.rule(["undecided", "embedding", "refuted"])
    if claim == "refuted":
        check_refuted(mesh, claims, tokens)
    tokens.end()
    last = check_embedding(mesh, claims, next_tokens) if claim == "embedding" else next_tokens()
    well(last.tokens == ["end"], "end expected")
    return claim
