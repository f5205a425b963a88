#!/usr/bin/env python3
"""Writes the binary .msh files of this folder; the ASCII ones are made by hand.

    python3 make.py            write them
    python3 make.py --check    compare with what is there, byte for byte
"""
import struct
import sys
from pathlib import Path

NODES = [(0.0, 0.0), (1.5, 0.25), (1.25, 1.0), (-0.5, 0.75)]


def i32(*values):
    return struct.pack(f"<{len(values)}i", *values)


def u64(*values):
    return struct.pack(f"<{len(values)}Q", *values)


def f64(*values):
    return struct.pack(f"<{len(values)}d", *values)


def start(version, one=1):
    return b"$MeshFormat\n" + version + b" 1 8\n" + i32(one) + b"\n$EndMeshFormat\n"


def nodes2(points=NODES, tags=(1, 2, 3, 4), count=b"4", end=b"$EndNodes"):
    body = b"".join(i32(tag) + f64(*(tuple(p) + (0.0,))[:3]) for tag, p in zip(tags, points))
    return b"$Nodes\n" + count + b"\n" + body + b"\n" + end + b"\n"


def elements2(count, *numbers):
    return b"$Elements\n" + count + b"\n" + i32(*numbers) + b"\n$EndElements\n"


def nodes4(blocks=1, count=4, in_block=4, dimension=2):
    body = u64(1, 2, 3, 4) + b"".join(f64(x, y, 0.0) for x, y in NODES)
    return b"$Nodes\n" + u64(blocks, count, 1, 4) + i32(dimension, 1, 0) + u64(in_block) + body + b"\n$EndNodes\n"


def elements4(header, *blocks):
    body = b"".join(i32(dimension, 1, kind) + u64(count, *numbers) for dimension, kind, count, numbers in blocks)
    return b"$Elements\n" + u64(*header) + body + b"\n$EndElements\n"


def files():
    two, four = start(b"2.2"), start(b"4.1")
    triangle = (2, 1, 0, 11, 1, 2, 3)
    one = (11, 1, 2, 3)
    good4 = elements4((1, 1, 11, 11), (2, 2, 1, one))
    bent = [(0.0, 0.0), (1.5, float("nan")), (1.25, 1.0), (-0.5, 0.75)]
    infinite = [(0.0, 0.0), (1.5, 0.25), (1.25, 1.0), (float("-inf"), 0.75)]
    lifted = [(0.0, 0.0, 0.0), (1.5, 0.25, 0.0), (1.25, 1.0, 7.5), (-0.5, 0.75, 0.0)]
    return {
        "b_byte_order_7.msh": start(b"2.2", 7),
        "b_byte_order_cut.msh": b"$MeshFormat\n2.2 1 8\n\x01\x00",
        "b_format_not_closed.msh": b"$MeshFormat\n2.2 1 8\n" + i32(1) + b"\n" + nodes2(),
        "b_2_node_nan.msh": two + nodes2(bent) + elements2(b"1", *triangle),
        "b_2_node_infinite.msh": two + nodes2(infinite) + elements2(b"1", *triangle),
        "b_2_node_negative.msh": two + nodes2(tags=(1, 2, -3, 4)),
        "b_2_node_twice.msh": two + nodes2(tags=(1, 2, 3, 3)) + elements2(b"1", *triangle),
        "b_2_not_planar.msh": two + nodes2(lifted) + elements2(b"1", *triangle),
        "b_2_nodes_cut.msh": two + nodes2()[:70],
        "b_2_nodes_not_closed.msh": two + nodes2(end=b"$EndNode5") + elements2(b"1", *triangle),
        "b_2_nodes_huge.msh": two + nodes2(count=b"2147483646"),
        "b_2_elements_huge.msh": two + nodes2() + elements2(b"9223372036854775807", *triangle),
        "b_2_block_huge.msh": two + nodes2() + elements2(b"2147483640", 2, 2147483640, 0, 11, 1, 2, 3),
        "b_2_block_empty.msh": two + nodes2() + elements2(b"1", 2, 0, 0, 11, 1, 2, 3),
        "b_2_block_long.msh": two + nodes2() + elements2(b"2", 2, 3, 0, *one, *one, *one),
        "b_2_block_negative.msh": two + nodes2() + elements2(b"1", 2, -1, 0, *one),
        "b_2_tags_negative.msh": two + nodes2() + elements2(b"1", 2, 1, -1, *one),
        "b_2_tags_huge.msh": two + nodes2() + elements2(b"1", 2, 1, 2000000000, *one),
        "b_2_element_negative.msh": two + nodes2() + elements2(b"1", 2, 1, 0, -11, 1, 2, 3),
        "b_2_type_1000.msh": two + nodes2() + elements2(b"1", 1000, 1, 0, *one),
        "b_2_type_serendipity.msh": two + nodes2() + elements2(b"1", 39, 1, 0, *one),
        "b_2_node_undefined.msh": two + nodes2() + elements2(b"1", 2, 1, 0, 11, 1, 2, 44),
        "b_2_only_lines.msh": two + nodes2() + elements2(b"1", 1, 1, 0, 5, 1, 2),
        "b_4_nodes_missing.msh": four + nodes4(count=6) + good4,
        "b_4_nodes_too_many.msh": four + nodes4(count=3) + good4,
        "b_4_nodes_huge.msh": four + nodes4(count=2**63, in_block=2**63) + good4,
        "b_4_dimension_9.msh": four + nodes4(dimension=9) + good4,
        "b_4_elements_missing.msh": four + nodes4() + elements4((1, 9, 1, 9), (2, 2, 1, one)),
        "b_4_elements_too_many.msh": four + nodes4() + elements4((1, 1, 1, 9), (2, 2, 2, one + one)),
        "b_4_elements_huge.msh": four + nodes4() + elements4((1, 2**64 - 1, 1, 9), (2, 2, 2**64 - 1, one)),
        "b_4_type_polygon.msh": four + nodes4() + elements4((1, 1, 1, 9), (2, 34, 1, one)),
        "b_4_node_undefined.msh": four + nodes4() + elements4((1, 1, 1, 9), (2, 2, 1, (11, 1, 2, 2**64 - 1))),
        "b_4_cut_in_block.msh": (four + nodes4() + good4)[:-40],
        "b_4_section_open.msh": four + nodes4() + good4 + b"$Periodic\n" + u64(1),
    }


def main():
    folder = Path(__file__).resolve().parent
    wrong = 0
    for name, data in files().items():
        path = folder / name
        if "--check" not in sys.argv[1:]:
            path.write_bytes(data)
        elif not path.exists() or path.read_bytes() != data:
            print(f"{name}: not what make.py makes")
            wrong += 1
    listed = set(files())
    for path in sorted(folder.glob("b_*.msh")):
        if path.name not in listed:
            print(f"{path.name}: make.py does not make it")
            wrong += 1
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
