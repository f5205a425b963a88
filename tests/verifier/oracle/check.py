#!/usr/bin/env python3
"""check.py ELEMENTS CERTIFICATE: a second, independent checker of the same rules, for the tests' own examples (slow; no limits)."""
import hashlib
import re
import sys

from element_rules import check_element
from elements_file import File
from mesh_rules import Mesh, check_mesh
from tokens import Malformed, Rejected, Tokens, integer, require, well

sys.setrecursionlimit(20000)


def check(elements, certificate):
    """(exit code, line, why, rule words of all lines)."""
    number, rules = 0, []
    try:
        text = certificate.decode("ascii")
        number = text.count("\n") + 1
        well(text.endswith("\n"), "the last line is not ended")
        lines = text[:-1].split("\n")
        number = 0

        def next_tokens():
            nonlocal number
            number += 1
            well(number <= len(lines), "the file ends")
            rules.append(Tokens(lines[number - 1]))
            return rules[-1]

        def header(word):
            tokens = next_tokens()
            well(tokens.word() == word, word)
            value = tokens.word()
            tokens.end()
            return value

        well(header("bezcert-certificate") == "1", "version")
        digits = header("elements")
        well(re.fullmatch("[0-9a-f]{64}", digits), "SHA-256")
        require(digits == hashlib.sha256(elements).hexdigest(), "another elements file")
        bez = elements.lstrip(b" \t\r\n")[:1] == b"{"
        basis = header("basis")
        well(basis in (["mixed"] if bez else ["lagrange", "bernstein"]), "basis")
        numbers = header("numbers")
        well(numbers in (["decimal"] if bez else ["binary64", "decimal"]), "numbers")
        file = File(elements, basis, numbers)
        require(integer(header("count")) == len(file.elements), "count")
        claims = []
        for i, element in enumerate(file.elements):
            tokens = next_tokens()
            well(tokens.word() == str(i + 1), "position")
            claims.append(check_element(tokens, element))
        tokens = next_tokens()
        well(tokens.word() == "mesh", "mesh")
        check_mesh(Mesh(file), claims, tokens, next_tokens)
        well(number == len(lines), "lines after end")
        return 0, 0, "", [t.rules for t in rules]
    except UnicodeDecodeError:
        return 2, 0, "not ASCII", []
    except Malformed as error:
        return 2, number, str(error), [t.rules for t in rules]
    except Rejected as error:
        return 1, number, str(error), [t.rules for t in rules]


if __name__ == "__main__":
    data = [open(path, "rb").read() for path in sys.argv[1:3]]
    code, line, why, _ = check(*data)
    print(code, line, why)
    sys.exit(code)
