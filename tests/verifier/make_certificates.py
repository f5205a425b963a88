#!/usr/bin/env python3
"""Writes elements/, accepted/, rejected/, malformed/ and expected.tsv: the examples in cases/, each held against oracle/check.py first.

The oracle is a second checker of docs/certificate-format.md in exact fractions; it shares nothing with verifier/ or lib/.
--list tells what it says about every example, --check compares instead of writing. Needs Python 3.9, nothing else.
"""
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE / "cases"), str(HERE / "oracle")]

import book  # noqa: E402
from check import check  # noqa: E402

import importlib  # noqa: E402
for module in ("sign_cases", "injective_cases", "meet_cases", "mesh_cases", "text_cases"):
    if (HERE / "cases" / (module + ".py")).exists():
        importlib.import_module(module)


def main():
    wrong, rows = [], ["# certificate\telements\texit\tline (0: not told)"]
    for case in book.CASES:
        if case["elements"].startswith("spoiled-"):  # the oracle reads sound ones only
            rows.append(f"{case['folder']}/{case['name']}.cert\t{case['elements']}\t2\t0")
            continue
        code, line, why, _ = check(book.ELEMENTS.get(case["elements"], b""), case["data"])
        expected = book.CODES[case["folder"]]
        name = f"{case['folder']}/{case['name']}.cert"
        if "--list" in sys.argv:
            print(name, code, line, why, sep="\t")
        if code != expected or (code == 1 and line != case["line"]):
            wrong.append(f"{name}: expected {expected} in line {case['line']}, the oracle says {code} in line {line}: {why}")
        rows.append(f"{name}\t{case['elements']}\t{expected}\t{case['line'] if expected == 1 else 0}")
    print("\n".join(wrong) or f"{len(book.CASES)} examples, {len(book.ELEMENTS)} elements files", file=sys.stderr)
    if wrong:
        return 1
    if "--list" in sys.argv:
        return 0
    files = {f"elements/{name}": data for name, data in book.ELEMENTS.items()}
    files.update({f"{case['folder']}/{case['name']}.cert": case["data"] for case in book.CASES})
    files["expected.tsv"] = ("\n".join(sorted(rows)) + "\n").encode()
    folders = ("elements", "accepted", "rejected", "malformed")
    if "--check" in sys.argv:
        found = {str(p.relative_to(HERE)): p.read_bytes() for folder in folders for p in (HERE / folder).iterdir()}
        found["expected.tsv"] = (HERE / "expected.tsv").read_bytes()
        for name in sorted(files.keys() | found.keys()):
            if files.get(name) != found.get(name):
                print(name, "differs from what make_certificates.py gives", file=sys.stderr)
        return 0 if files == found else 1
    for folder in folders:
        (HERE / folder).mkdir(exist_ok=True)
        for old in (HERE / folder).iterdir():
            old.unlink()
    for name, data in files.items():
        (HERE / name).write_bytes(data)
    return 0


sys.exit(main())
