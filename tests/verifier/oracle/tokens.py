"""Tokens of one line (certificate-format.md, "Text")."""
import re
from fractions import Fraction as Q
from math import gcd

import polynomials as P


class Malformed(Exception):
    pass


class Rejected(Exception):
    pass


def require(holds, why):
    if not holds:
        raise Rejected(why)


def well(holds, why):
    if not holds:
        raise Malformed(why)


INT = re.compile(r"0|-?[1-9][0-9]*")


def integer(text):
    well(INT.fullmatch(text), "INT: " + text[:40])
    return int(text)


def rational(text):
    n, slash, d = text.partition("/")
    if not slash:
        return Q(integer(n))
    n, d = integer(n), integer(d)
    well(d > 1 and gcd(n, d) == 1, "RAT: " + text[:40])
    return Q(n, d)


def polynomial(text):
    f = [integer(t) for t in text.split(",")]
    if f == [0]:
        return []
    well(f[-1] != 0, "POLY: " + text[:40])
    return f


def rational_polynomial(text):
    n, slash, d = text.partition("/")
    f = polynomial(n)
    if not slash:
        return [Q(c) for c in f]
    d = integer(d)
    well(d > 1 and gcd(d, *f) == 1, "RATPOLY: " + text[:40])
    return [Q(c, d) for c in f]


def polynomial2(text):
    rows = [polynomial(t) for t in text.split(";")]
    well(rows[-1], "POLY2: " + text[:40])
    return {(i, j): Q(c) for j, row in enumerate(rows) for i, c in enumerate(row) if c}


def text_of(x):
    return str(Q(x))


def text_of_polynomial(f):
    """The primitive integer polynomial with the same roots and sign; f itself if it is integer."""
    f = P.trim(f)
    assert all(Q(c).denominator == 1 for c in f), f
    return ",".join(str(int(c)) for c in f) or "0"


def text_of_rational_polynomial(f):
    d = 1
    for c in f:
        d = d * Q(c).denominator // gcd(d, Q(c).denominator)
    return text_of_polynomial([c * d for c in f]) + (f"/{d}" if d > 1 else "")


def text_of_polynomial2(f):
    return ";".join(text_of_polynomial(P.coefficient_of_v(f, j)) for j in range(P.degree2(f, 1) + 1))


class Tokens:
    def __init__(self, line):
        well(re.fullmatch(r"[\x21-\x7e]+( [\x21-\x7e]+)*", line), "blanks")
        self.tokens, self.at, self.rules = line.split(" "), 0, []

    def word(self):
        well(self.at < len(self.tokens), "line ends")
        self.at += 1
        return self.tokens[self.at - 1]

    def rule(self, known):
        word = self.word()
        well(word in known, "unknown word " + word[:40])
        self.rules.append(word)
        return word

    def integer(self):
        return integer(self.word())

    def small(self, low, high):
        n = self.integer()
        well(low <= n <= high, "out of range")
        return n

    def rational(self):
        return rational(self.word())

    def polynomial(self):
        return polynomial(self.word())

    def rational_polynomial(self):
        return rational_polynomial(self.word())

    def polynomial2(self):
        return polynomial2(self.word())

    def bits(self):
        word = self.word()
        well(re.fullmatch("[01]+", word), "BITS")
        return word

    def edge(self):
        position, dot, edge = self.word().partition(".")
        well(dot, "EDGE")
        return integer(position), integer(edge)

    def end(self):
        well(self.at == len(self.tokens), "more on the line")
