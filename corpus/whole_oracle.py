"""Is a mesh of curved elements an embedding? Exact answers, independent of the C++ library.

The first obstacle in the order invalid_element, non_manifold, non_conforming, folded_vertex, overlapping_boundary. Angles are summed in
floating point, as a check of what is known by construction; every other step is exact.
"""
from fractions import Fraction as Q
from math import atan2, isqrt, pi

import curves
import exact
import zeros
from whole_build import edges_of, homogeneous


def on_curve(c, p, irrational=False):
    """Parameters in [0, 1] where the curve passes through a point; irrational ones are left out, or an error."""
    found = []
    x, y, w = curves.monomial(c)
    first, second = ([a - z * b for a, b in zip(f, w)] for f, z in ((x, p[0]), (y, p[1])))
    f = first if any(first) else second
    for low, high in zeros.roots(f):
        if low == high:
            if curves.point(c, low) == p:
                found.append(low)
        else:
            other = {(k, 0): v for k, v in enumerate(second if any(first) else first)}
            low, high = zeros.over(other, (low, high), (Q(0), Q(0)))
            assert irrational or low > 0 or high < 0, "a point on a curve at an irrational parameter"
    return found


class Judgement:
    def __init__(self, verdict, elements=(), nodes=()):
        self.verdict, self.elements, self.nodes = verdict, sorted(set(elements)), sorted(set(nodes))


def element_valid(mesh, entry):
    _, element = homogeneous(mesh, entry)
    status = exact.decide(exact.bernstein_rows(element.N, element.triangle), element.triangle)[0]
    assert status != "open"
    if status != "positive":
        return False
    assert curves.simple_loop([c for _, _, c in edges_of(mesh, entry)]), "a boundary not shown to be simple"
    return True


class Topology:
    """Edges grouped by the nodes at their ends, or by equal curves where elements have points of their own."""

    def __init__(self, mesh):
        self.mesh, self.sides = mesh, []  # sides: (element, local edge, start, end, curve)
        for k, entry in enumerate(mesh.elements):
            for r, (a, b, c) in enumerate(edges_of(mesh, entry)):
                self.sides.append((k, r, a, b, c))
        self.by_node = "nodes" in mesh.elements[0]
        self.groups = {}
        for side in self.sides:
            ends = frozenset(side[2:4])
            if self.by_node:
                self.groups.setdefault(ends, []).append(side)
                continue
            for number in range(99):  # the number tells unequal curves with the same ends apart
                group = self.groups.setdefault((ends, number), [])
                if not group or curves.equal(group[0][4], side[4]) or curves.equal(group[0][4], curves.reverse(side[4])):
                    group.append(side)
                    break
        self.boundary = [g[0] for g in self.groups.values() if len(g) == 1]
        self.glued = [g for g in self.groups.values() if len(g) == 2]

    def corners(self):
        """{vertex: [fans]}; a fan is a list of (element, local corner) joined by glued edges."""
        parent = {}

        def find(x):
            while parent.setdefault(x, x) != x:
                x = parent[x]
            return x

        count = {}
        for k, r, a, b, c in self.sides:
            count[k] = max(count.get(k, 0), r + 1)
        for k, r, *_ in self.sides:
            find((k, r))
        for one, two in self.glued:
            parent[find((one[0], one[1]))] = find((two[0], (two[1] + 1) % count[two[0]]))
            parent[find((one[0], (one[1] + 1) % count[one[0]]))] = find((two[0], two[1]))
        vertices = {}
        for k, r, a, b, c in self.sides:
            vertex = a if self.by_node else find((k, r))
            vertices.setdefault(vertex, {}).setdefault(find((k, r)), []).append((k, r))
        return {v: list(fans.values()) for v, fans in vertices.items()}

    def angle(self, k, r):
        mine = sorted(s for s in self.sides if s[0] == k)
        out, back = mine[r][4], curves.reverse(mine[r - 1][4])
        u, v = (curves.sub(curves.net(c)[1], curves.net(c)[0]) for c in (out, back))
        return atan2(float(curves.cross(u, v)), float(curves.dot(u, v)))

    def components(self):
        label = {k: k for k in range(len(self.mesh.elements))}
        changed = True
        while changed:
            changed = False
            for one, two in self.glued:
                low = min(label[one[0]], label[two[0]])
                for side in (one, two):
                    changed |= label[side[0]] != low
                    label[side[0]] = low
        return label

    def loops(self, vertices):
        """Boundary loops as lists of sides; needs one fan at every vertex."""
        at = {corner: v for v, fans in vertices.items() for fan in fans for corner in fan}
        size = {}
        for k, r, *_ in self.sides:
            size[k] = max(size.get(k, 0), r + 1)
        start = {at[s[0], s[1]]: s for s in self.boundary}
        assert len(start) == len(self.boundary)
        loops, left = [], set(start)
        while left:
            v = min(left, key=str)
            loop = []
            while v in left:
                left.remove(v)
                loop.append(start[v])
                v = at[start[v][0], (start[v][1] + 1) % size[start[v][0]]]
            loops.append(loop)
        return loops


def hanging(topology):
    """Boundary edges one of which is, backwards, a piece of another with which it shares one end."""
    for one in topology.boundary:
        for two in topology.boundary:
            for shared, other, end in ((two[3] == one[2], two[2], 0), (two[2] == one[3], two[3], 1)):
                if not shared or other in one[2:4] or one[0] == two[0]:
                    continue
                p = topology.mesh.points[other] if topology.by_node else other
                for t in on_curve(one[4], p):
                    piece = curves.part(one[4], 0, t) if end == 0 else curves.part(one[4], t, 1)
                    if 0 < t < 1 and curves.equal(piece, curves.reverse(two[4])):
                        yield one, two, other


def beyond_one_turn(out, back):
    """The corner between two edges from a vertex is one turn to nine digits: is it more, or do the edges bound a sliver?"""
    u, v = (curves.sub(curves.net(c)[1], curves.net(c)[0]) for c in (out, back))
    if curves.cross(u, v):
        return curves.cross(u, v) > 0
    return not curves.equal(out, back) and cusp_below(out, back)


def cusp_below(one, two):
    """Two quadratic edges (a t, b t^2) from their common start, tangent to the x axis: is the first strictly below?"""
    values = []
    for c in (one, two):
        (p, q, r) = [curves.sub(x, curves.net(c)[0]) for x in curves.net(c)]
        assert q[1] == 0 and r[0] == 2 * q[0] > 0 and len({w for _, _, w in c}) == 1
        values.append(r[1] / r[0] ** 2)
    assert values[0] != values[1]
    return values[0] < values[1]


def judge(mesh, touching=()):
    """touching: pairs of points of the plane at which boundaries are known to touch."""
    bad = [k for k, entry in enumerate(mesh.elements) if not element_valid(mesh, entry)]
    topology = Topology(mesh)
    if bad:
        return Judgement("invalid_element", bad), topology, None
    crowded = [g for g in topology.groups.values() if len(g) > 2 or len(g) == 2 and g[0][2] == g[1][2]]
    vertices = topology.corners()
    pinched = [] if crowded else [v for v, fans in vertices.items() if len(fans) > 1]
    if crowded or pinched:
        elements = {s[0] for g in crowded for s in g} | {k for v in pinched for fan in vertices[v] for k, _ in fan}
        nodes = {v for g in crowded for v in g[0][2:4]} | set(pinched)
        return Judgement("non_manifold", elements, nodes if topology.by_node else []), topology, None
    unequal = [g for g in topology.glued if not curves.equal(g[0][4], curves.reverse(g[1][4]))]
    if unequal:
        return Judgement("non_conforming", {s[0] for g in unequal for s in g}, {v for g in unequal for v in g[0][2:4]}
                         if topology.by_node else []), topology, None
    hang = list(hanging(topology))
    if hang:
        return Judgement("non_conforming", {s[0] for h in hang for s in h[:2]}, {h[2] for h in hang} if topology.by_node
                         else []), topology, None
    loops = topology.loops(vertices)
    check_euler(topology, vertices, loops)
    rim = {s[:2]: s for s in topology.boundary}
    folded = []
    for v, fans in vertices.items():
        total = sum(topology.angle(k, r) for k, r in fans[0]) / (2 * pi)
        inside = not any((k, r) in rim for k, r in fans[0])
        if inside and abs(total - 1) > 1e-9 or not inside and total > 1 + 1e-9:
            assert abs(total - round(total)) < 1e-9 or not inside
            folded.append(v)
        elif not inside and abs(total - 1) < 1e-9:
            out, back = rim_at(topology, loops, fans[0])
            if beyond_one_turn(out[4], curves.reverse(back[4])):
                folded.append(v)
    if folded:
        return Judgement("folded_vertex", {k for v in folded for k, _ in vertices[v][0]}, folded), topology, loops
    return meet(topology, loops, touching), topology, loops


def rim_at(topology, loops, fan):
    for loop in loops:
        for back, out in zip(loop[-1:] + loop[:-1], loop):
            if (out[0], out[1]) in fan:
                return out, back
    raise AssertionError


def check_euler(topology, vertices, loops):
    """V - E + F = 2 - loops for every component: an orientable surface of genus 0."""
    label = topology.components()
    of_loop = [label[loop[0][0]] for loop in loops]
    for part in set(label.values()):
        v = sum(label[fans[0][0][0]] == part for fans in vertices.values())
        e = sum(label[g[0][0]] == part for g in topology.groups.values())
        f = sum(value == part for value in label.values())
        assert v - e + f == 2 - of_loop.count(part), "not of genus 0"


def meet(topology, loops, touching):
    """Do boundaries meet or components cover each other? Either is proved."""
    sides = [(i, j, s) for i, loop in enumerate(loops) for j, s in enumerate(loop)]
    found, unknown = [], []
    for x, (i, j, one) in enumerate(sides):
        for k, m, two in sides[x + 1:]:
            n = len(loops[i])
            after, before = i == k and (j + 1) % n == m, i == k and (m + 1) % n == j
            if after and before:
                fine = curves.simple_loop([one[4], two[4]])
            elif after:
                fine = curves.apart_but_start(curves.reverse(one[4]), two[4], 12) or tangent_apart(one, two)
            elif before:
                fine = curves.apart_but_start(curves.reverse(two[4]), one[4], 12) or tangent_apart(two, one)
            else:
                fine = circles_apart(one[4], two[4]) or curves.apart(one[4], two[4], 24)
            if not fine:
                (found if proved_meeting(one, two, after or before, touching) else unknown).append((one, two))
    label = topology.components()
    inside = []
    if not found and not unknown:
        for part in set(label.values()):
            for loop in loops:
                if label[loop[0][0]] != part:
                    theirs = [l for l in loops if label[l[0][0]] == part]
                    total = sum(curves.winding([s[4] for s in l], curves.net(loop[0][4])[0]) for l in theirs)
                    assert total in (0, 1)
                    inside += [loop] * total
    if found:
        elements = {s[0] for pair in found + unknown for s in pair}
        return Judgement("overlapping_boundary", elements if len(elements) == 2 else [])
    assert not unknown, "two boundary edges neither apart nor shown to meet"
    return Judgement("overlapping_boundary" if inside else "embedding")


def circle_of(c):
    """(centre, radius) if the curve lies on a circle of rational radius, else None."""
    a, b, d = (curves.point(c, t) for t in (Q(0), Q(1, 2), Q(1)))
    (p, q), (r, s) = curves.sub(b, a), curves.sub(d, a)
    det = 2 * (p * s - q * r)
    if not det or len(c) != 3:
        return None
    e, f = p * p + q * q, r * r + s * s
    centre = a[0] + (e * s - f * q) / det, a[1] + (f * p - e * r) / det
    square = sum((x - y) ** 2 for x, y in zip(a, centre))
    radius = Q(isqrt(square.numerator), isqrt(square.denominator))
    points = [curves.point(c, Q(k, 4)) for k in range(5)]  # enough for an identity of degree 4
    return (centre, radius) if all(sum((x - y) ** 2 for x, y in zip(z, centre)) == radius ** 2 for z in points) else None


def circles_apart(a, b):
    one, two = circle_of(a), circle_of(b)
    if not one or not two:
        return False
    distance = sum((x - y) ** 2 for x, y in zip(one[0], two[0]))
    return distance > (one[1] + two[1]) ** 2 or distance < (one[1] - two[1]) ** 2


def tangent_apart(back, out):
    """Two quadratic edges tangent at their common corner: parabolas y = k x^2 with different k meet nowhere else."""
    if curves.equal(out[4], curves.reverse(back[4])):
        return False
    cusp_below(out[4], curves.reverse(back[4]))
    return True


def proved_meeting(one, two, neighbours, touching):
    a, b = one[4], two[4]
    if curves.equal(a, b) or curves.equal(a, curves.reverse(b)):
        return True
    ends = {curves.net(c)[0] for c in (a, b)} | {curves.net(c)[-1] for c in (a, b)} | set(touching)
    common = {p for p in ends if on_curve(a, p) and on_curve(b, p)}
    if len(common) > neighbours:
        return True
    return curves.crossing(a, b) is not None


def area(mesh):
    """The sum of the exact integrals of det J, or None with weights."""
    total = Q(0)
    for entry in mesh.elements:
        _, element = homogeneous(mesh, entry)
        if element.rational:
            return None
        values = [c for _, c in exact.bernstein(element.N, element.triangle)]
        scale = Q(element.degree ** 2, 2) if element.triangle else Q(element.degree[0] * element.degree[1])
        total += scale * sum(values) / len(values)
    return total


def covered(mesh, curve):
    """Does a chain of whole mesh edges cover the curve exactly?"""
    topology, pieces = Topology(mesh), []
    for group in topology.groups.values():
        edge = group[0][4]
        # Where the parametrisation is proper, the parameter of a rational point is rational.
        first, last = (on_curve(curve, p, True) for p in (curves.net(edge)[0], curves.net(edge)[-1]))
        for a in first:
            for b in last:
                low, high = min(a, b), max(a, b)
                if low < high and curves.equal(curves.part(curve, low, high), edge if a < b else curves.reverse(edge)):
                    pieces.append((low, high))
    reach = Q(0)
    for low, high in sorted(pieces):
        reach = high if low == reach else reach
    return reach == 1
