#!/usr/bin/env python3
"""Writes mutants.tsv: of every mutant of every accepted example (oracle/mutants.py) those that oracle/check.py accepts all the same: the claim
is still true and the evidence still shows it. mutation_test holds the verifier against the list. Takes some minutes; --jobs N (default 2).
"""
import sys
from collections import Counter
from multiprocessing import Pool
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE / "oracle"))

from check import check  # noqa: E402
from mutants import mutants  # noqa: E402


def accepted_mutants(row):
    certificate, elements = row
    data, text = (HERE / "elements" / elements).read_bytes(), (HERE / certificate).read_text()
    counts, rows = Counter(), []
    for kind, line, token, new, mutant in mutants(text):
        counts[kind] += 1
        try:
            code = check(data, mutant.encode())[0]
        except (ValueError, KeyError):  # the elements file has no such reading: a weight <= 0, ...
            code = 2
        if code == 0:
            rows.append((certificate, line + 1, token + 1, "(dropped)" if new is None else new))
    return counts, rows


def main():
    jobs = int(sys.argv[sys.argv.index("--jobs") + 1]) if "--jobs" in sys.argv else 2
    table = [row.split("\t")[:2] for row in (HERE / "expected.tsv").read_text().splitlines() if row.startswith("accepted/")]
    total, lines = Counter(), []
    with Pool(jobs) as pool:
        for counts, rows in pool.imap(accepted_mutants, table):
            total += counts
            lines += ["\t".join(map(str, row)) for row in rows]
    head = "# mutants that are still valid: certificate, line, token (from 1), its replacement"
    counted = "# mutants in all: " + ", ".join(f"{kind} {n}" for kind, n in sorted(total.items()))
    (HERE / "mutants.tsv").write_text("\n".join([head, counted] + lines) + "\n")
    print(counted, "valid:", len(lines))


if __name__ == "__main__":
    main()
