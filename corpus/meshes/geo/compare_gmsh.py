#!/usr/bin/env python3
"""Compare gmsh's floating-point Plugin(AnalyseMeshQuality) with mesh_oracle.py on every corpus mesh.

    compare_gmsh.py [FILE...]      (default: corpus/meshes/*.msh; needs gmsh 4.8.4)

For each file gmsh runs in batch mode on

    Merge "FILE";
    Plugin(AnalyseMeshQuality).JacobianDeterminant = 1;
    Plugin(AnalyseMeshQuality).DimensionOfElements = 2;
    Plugin(AnalyseMeshQuality).CreateView = 1;
    Plugin(AnalyseMeshQuality).Run;
    Save View[PostProcessing.NbViews - 1] "VIEW.pos";

Per 2D element the view holds min J / max J (elements are matched by their first corner, in file order), the log the
least J over all. gmsh judges an element up to orientation: for a clockwise one it shows min/max of -J, so `reversed` counts as valid here.
Printed: elements; how many gmsh calls invalid (min J / max J <= 0); how many the oracle calls folded or degenerate;
elements where the two differ; gmsh's least J (3 digits); the oracle's least det J in gmsh's scale (quadrilaterals on the
square [-1,1]^2: det / 4).
"""
import multiprocessing
import re
import subprocess
import sys
import tempfile
from pathlib import Path

here = Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(here.parent.parent))
import mesh_oracle as oracle

VALID = ("positive", "reversed")


def gmsh(path, work):
    script, view = Path(work) / "quality.geo", Path(work) / "view.pos"
    view.unlink(missing_ok=True)
    plugin = "Plugin(AnalyseMeshQuality)"
    script.write_text(f'Merge "{path}";\n{plugin}.JacobianDeterminant = 1;\n'
                      f'{plugin}.DimensionOfElements = 2;\n{plugin}.CreateView = 1;\n'
                      f'{plugin}.Run;\nSave View[PostProcessing.NbViews - 1] "{view}";\n')
    log = subprocess.run(["gmsh", str(script), "-", "-v", "4"], capture_output=True, text=True, stdin=subprocess.DEVNULL)
    text = log.stdout + log.stderr
    least = re.search(r"minJ +=\s*(\S+?),", text)
    if not view.exists():
        return None, text
    rows = []
    for kind, xyz, values in re.findall(r"^S([TQ])\(([^)]*)\)\{([^}]*)\}", view.read_text(), re.M):
        rows.append((tuple(float(f) for f in xyz.split(",")[:2]), float(values.split(",")[0])))
    return rows, least.group(1) if least else "-"


def main(names):
    print("file\telements\tgmsh_invalid\toracle_invalid\tdiffer\tgmsh_least\toracle_least")
    with multiprocessing.Pool() as pool, tempfile.TemporaryDirectory() as work:
        for path in [Path(n).resolve() for n in names] or sorted(here.parent.glob("*.msh")):
            _, results = oracle.judge_file(path, pool, True)
            rows, least = gmsh(path, work)
            if rows is None:
                print(path.name, len(results), "no view", sep="\t")
                continue
            nodes, elements = oracle.read_mesh(path)
            places = {e[0]: nodes[e[2][0]][:2] for e in elements}
            waiting = list(rows)
            notes = []
            for tag, kind, verdict, (low, *_) in results:
                at = next((k for k, (p, _) in enumerate(waiting)
                           if max(abs(a - b) for a, b in zip(p, places[tag])) < 1e-9), None)
                if at is None:
                    notes.append(f"{tag}: not in the view")
                    continue
                ratio = waiting.pop(at)[1]
                if (ratio > 0) != (verdict in VALID):
                    notes.append(f"{tag}: {verdict}, gmsh min/max {ratio:.3g}")
            scale = min(float(low) / (4 if kind in oracle.QUADRILATERALS else 1) for _, kind, _, (low, *_) in results)
            print(path.name, len(results), sum(r <= 0 for _, r in rows), sum(r[2] not in VALID for r in results),
                  len(notes), least, f"{scale:.3g}", "; ".join(notes), sep="\t")


if __name__ == "__main__":
    main(sys.argv[1:])
