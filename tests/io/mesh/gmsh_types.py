#!/usr/bin/env python3
"""Prints gmsh_types.tsv as gmsh 4.8 itself has it (libgmsh.so.4.8, Debian: libgmsh4.8): every element type with a
fixed number of nodes, its dimension, order, nodes and gmsh's name.

    python3 gmsh_types.py > gmsh_types.tsv
"""
import ctypes


def main():
    lib = ctypes.CDLL("libgmsh.so.4.8")
    error = ctypes.c_int(0)
    lib.gmshInitialize(0, None, 1, ctypes.byref(error))
    number = lib.gmshOptionSetNumber
    number.argtypes = [ctypes.c_char_p, ctypes.c_double, ctypes.POINTER(ctypes.c_int)]
    number(b"General.Terminal", 0, ctypes.byref(error))
    print("type\tdimension\torder\tnodes\tname")
    for kind in range(1, 160):
        name = ctypes.c_char_p()
        dimension, order, nodes, primary = (ctypes.c_int() for _ in range(4))
        places, count = ctypes.POINTER(ctypes.c_double)(), ctypes.c_size_t()
        lib.gmshModelMeshGetElementProperties(
            ctypes.c_int(kind), ctypes.byref(name), ctypes.byref(dimension), ctypes.byref(order),
            ctypes.byref(nodes), ctypes.byref(places), ctypes.byref(count), ctypes.byref(primary),
            ctypes.byref(error))
        if error.value == 0 and name.value and nodes.value > 0:
            print(kind, dimension.value, order.value, nodes.value, name.value.decode(), sep="\t")


if __name__ == "__main__":
    main()
