#!/usr/bin/env python3
"""Prints ../node_order.tsv as gmsh 4.8.4 itself has it: one straight element of orders 1..10 for each shape.

On the unit triangle or square a node's coordinates are its parameters. If libgmsh.so.4.8 can be loaded, the order is
also compared with the library's gmshModelMeshGetElementProperties (local node coordinates of its shape functions).
"""
import ctypes
import subprocess
import sys
import tempfile
from pathlib import Path

SHAPES = {
    "triangle": ([2, 9, 21, 23, 25, 42, 43, 44, 45, 46], [(0, 0), (1, 0), (0, 1)]),
    "quadrilateral": ([3, 10, 36, 37, 38, 47, 48, 49, 50, 51], [(0, 0), (1, 0), (1, 1), (0, 1)]),
}


def geo(corners):
    m = len(corners)
    text = "".join(f"Point({k}) = {{{x}, {y}, 0}};\n" for k, (x, y) in enumerate(corners, 1))
    text += "".join(f"Line({k}) = {{{k}, {k % m + 1}}};\n" for k in range(1, m + 1))
    text += f"Curve Loop(1) = {{1:{m}}};\nPlane Surface(1) = {{1}};\nTransfinite Curve{{1:{m}}} = 2;\n"
    return text + f"Transfinite Surface{{1}} = {{1:{m}}};\n" + ("Recombine Surface{1};\n" if m == 4 else "")


def grid(values, n):
    out = [(round(u * n), round(v * n)) for u, v in values]
    assert all(abs(u * n - i) < 1e-9 and abs(v * n - j) < 1e-9 for (u, v), (i, j) in zip(values, out))
    return out


def from_mesh(corners, kind, n, work):
    source, mesh = Path(work) / "one.geo", Path(work) / "one.msh"
    source.write_text(geo(corners))
    subprocess.run(["gmsh", str(source), "-2", "-order", str(n), "-format", "msh22", "-v", "0", "-o", str(mesh)],
                   check=True, stdin=subprocess.DEVNULL)
    lines = mesh.read_text().split("\n")
    at = lines.index("$Nodes") + 2
    places = {f[0]: (float(f[1]), float(f[2])) for f in (l.split() for l in lines[at:at + int(lines[at - 1])])}
    rows = [l.split() for l in lines[lines.index("$Elements") + 2:lines.index("$EndElements")]]
    (row,) = [r for r in rows if int(r[1]) == kind]
    return grid([places[t] for t in row[3 + int(row[2]):]], n)


def from_library(library, kind, n, square):
    name, error, count = ctypes.c_char_p(), ctypes.c_int(), ctypes.c_size_t()
    dim, order, nodes, primary = (ctypes.c_int() for _ in range(4))
    local = ctypes.POINTER(ctypes.c_double)()
    library.gmshModelMeshGetElementProperties(ctypes.c_int(kind), *map(ctypes.byref, (
        name, dim, order, nodes, local, count, primary, error)))
    assert error.value == 0 and order.value == n
    wide = count.value // nodes.value
    values = [(local[wide * k], local[wide * k + 1]) for k in range(nodes.value)]
    return grid([((u + 1) / 2, (v + 1) / 2) if square else (u, v) for u, v in values], n)


def main():
    try:
        library = ctypes.CDLL("libgmsh.so.4.8")
        library.gmshInitialize(0, None, 0, ctypes.byref(ctypes.c_int()))
    except OSError:
        library = None
        print("libgmsh.so.4.8 not found: meshes only", file=sys.stderr)
    print("type\tindex\ti\tj")
    with tempfile.TemporaryDirectory() as work:
        for name, (kinds, corners) in SHAPES.items():
            for n, kind in enumerate(kinds, 1):
                places = from_mesh(corners, kind, n, work)
                if library:
                    assert places == from_library(library, kind, n, len(corners) == 4), kind
                for index, (i, j) in enumerate(places):
                    print(kind, index, i, j, sep="\t")


if __name__ == "__main__":
    main()
