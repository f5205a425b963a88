"""The list of examples: elements files by name, certificates with the expected exit code and line."""
import hashlib
import sys
from fractions import Fraction as Q
from pathlib import Path

HERE = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(HERE / "oracle"))

import polynomials as P  # noqa: E402
from elements_file import File  # noqa: E402

ELEMENTS, CASES = {}, []
CODES = {"accepted": 0, "rejected": 1, "malformed": 2}


class F:
    """Polynomials in (u, v) with operators."""

    def __init__(self, terms):
        self.terms = P.clean(terms)

    def of(x):
        return x if isinstance(x, F) else F({(0, 0): Q(x)})

    def __add__(self, other):
        return F(P.add2(self.terms, F.of(other).terms))

    def __sub__(self, other):
        return self + F.of(other) * -1

    def __rsub__(self, other):
        return F.of(other) - self

    def __mul__(self, other):
        return F(P.mul2(self.terms, F.of(other).terms))

    def __pow__(self, e):
        return F(P.power2(self.terms, e))

    __radd__, __rmul__ = __add__, __mul__


U, V = F({(1, 0): Q(1)}), F({(0, 1): Q(1)})


def elements_file(name, text):
    """name with its suffix, .msh or .bez.json."""
    assert name not in ELEMENTS, name
    ELEMENTS[name] = text if isinstance(text, bytes) else text.encode()
    return name


def read(name, basis=None, numbers=None):
    return File(ELEMENTS[name], *header_words(name, basis, numbers))


def element(name, i=0, **words):
    return read(name, **words).elements[i]


def header_words(name, basis, numbers):
    bez = name.endswith(".bez.json")
    return basis or ("mixed" if bez else "lagrange"), numbers or ("decimal" if bez else "binary64")


def text(name, claims, mesh="undecided", lines=(), basis=None, numbers=None):
    basis, numbers = header_words(name, basis, numbers)
    claims = [claims] if isinstance(claims, str) else claims
    head = ["bezcert-certificate 1", "elements " + hashlib.sha256(ELEMENTS[name]).hexdigest(), "basis " + basis, "numbers " + numbers,
            f"count {len(claims)}"]
    body = [f"{i} {c}" for i, c in enumerate(claims, 1)]
    return "\n".join(head + body + ["mesh " + mesh] + list(lines) + ["end", ""])


def add(folder, name, elements, certificate, line=0):
    data = certificate if isinstance(certificate, bytes) else certificate.encode()
    assert all(c["name"] != name or c["folder"] != folder for c in CASES), (folder, name)
    CASES.append({"folder": folder, "name": name, "elements": elements, "data": data, "line": line})


def good(name, elements, claims, *more, **words):
    add("accepted", name, elements, text(elements, claims, *more, **words))


def bad(name, elements, claims, *more, line=6, **words):
    """Rejected in the given line (6: the first element)."""
    add("rejected", name, elements, text(elements, claims, *more, **words), line)


def broken(name, elements, claims, *more, line=6, **words):
    add("malformed", name, elements, text(elements, claims, *more, **words), line)
