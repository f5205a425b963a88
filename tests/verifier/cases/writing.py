"""Writes elements files."""
from fractions import Fraction as Q

import polynomials as P


def bez_element(kind, degree, points, weights=None, basis=None, nodes=None):
    def pair(p):
        return "[%s]" % ", ".join('"%s"' % Q(x) for x in p)
    words = [f'"kind": "{kind}"', f'"degree": {degree if kind == "triangle" else list(degree)}']
    if basis:
        words.append(f'"basis": "{basis}"')
    words.append(f'"nodes": {nodes}' if nodes is not None else '"points": [%s]' % ", ".join(map(pair, points)))
    if weights:
        words.append('"weights": [%s]' % ", ".join('"%s"' % Q(w) for w in weights))
    return "{ " + ", ".join(words) + " }"


def bez_file(*elements, points=None, weights=None):
    head = ""
    if points is not None:
        head = '"points": [%s],\n  ' % ", ".join('["%s", "%s"]' % (Q(x), Q(y)) for x, y in points)
        if weights:
            head += '"weights": [%s],\n  ' % ", ".join('"%s"' % Q(w) for w in weights)
    return '{ "bezcert": 1,\n  %s"elements": [\n    %s\n  ] }\n' % (head, ",\n    ".join(elements))


def triangle(points, n=1, **more):
    return bez_element("triangle", n, points, **more)


def quad(points, p=1, q=1, **more):
    return bez_element("quadrilateral", (p, q), points, **more)


def msh22(nodes, records):
    """nodes: [(x, y)] as texts; records: "type node node ..." without number and tags."""
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$Nodes", str(len(nodes))]
    lines += [f"{i} {x} {y} 0" for i, (x, y) in enumerate(nodes, 1)] + ["$EndNodes", "$Elements", str(len(records))]
    for i, record in enumerate(records, 1):
        kind, *rest = record.split()
        lines.append(f"{i} {kind} 2 0 1 {' '.join(rest)}")
    return "\n".join(lines + ["$EndElements", ""])


def msh41(nodes, records):
    lines = ["$MeshFormat", "4.1 0 8", "$EndMeshFormat", "$Nodes", f"1 {len(nodes)} 1 {len(nodes)}", f"2 1 0 {len(nodes)}"]
    lines += [str(i) for i in range(1, len(nodes) + 1)] + [f"{x} {y} 0" for x, y in nodes] + ["$EndNodes", "$Elements"]
    kinds = sorted({r.split()[0] for r in records}, key=[r.split()[0] for r in records].index)
    lines.append(f"{len(kinds)} {len(records)} 1 {len(records)}")
    number = 0
    for kind in kinds:
        rows = [r.split()[1:] for r in records if r.split()[0] == kind]
        lines.append(f"2 1 {kind} {len(rows)}")
        for row in rows:
            number += 1
            lines.append(" ".join([str(number)] + row))
    return "\n".join(lines + ["$EndElements", ""])


def control_triangle(f, n):
    """Control values of a polynomial of degree <= n."""
    b = P.triangle_bernstein(f, n)
    return [b[c, r] for r in range(n + 1) for c in range(n + 1 - r)]


def control_quad(f, p, q):
    b = P.square_bernstein(f, p, q)
    return [b[c, r] for r in range(q + 1) for c in range(p + 1)]


def integral_v(f):
    return {(i, j + 1): c / (j + 1) for (i, j), c in f.items()}


def jacobian_element(f, on_triangle):
    """x = u, y = the integral of f over v: N = f."""
    x, y = {(1, 0): Q(1)}, integral_v(f)
    if on_triangle:
        n = P.total2(f) + 1
        return triangle(list(zip(control_triangle(x, n), control_triangle(y, n))), n)
    p, q = max(1, P.degree2(f, 0)), P.degree2(f, 1) + 1
    return quad(list(zip(control_quad(x, p, q), control_quad(y, p, q))), p, q)
