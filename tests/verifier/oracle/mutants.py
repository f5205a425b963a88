"""The mutants of a certificate: every token in turn replaced by wrong ones. mutants.hpp makes the same ones, in the same order."""
import re

CLASSES = ["injective regular overlapping degenerate folded reversed invalid undecided", "coefficients tree factors columns hull", "midpoint hull orientation boundary",
           "none + -", "m h s j a b r", "open root slab", "at root cross", "undecided embedding refuted", "element cover touch pinch gap", "glue pair end",
           "u v", "lagrange bernstein mixed", "binary64 decimal"]


def mutants_of_token(token, before):
    """(kind, new token); None: the token is dropped."""
    if before == "elements":
        return [("hash", format((int(token[0], 16) + 1) % 16, "x") + token[1:])]
    result = []
    if before == "tree":
        for i in range(min(len(token), 48)):
            result.append(("bits", token[:i] + ("1" if token[i] == "0" else "0") + token[i + 1:]))
        result += [("bits", token + "0"), ("bits", token + "1"), ("bits", token[:-1])]
    elif re.fullmatch(r"[-0-9/,;.]*[0-9][-0-9/,;.]*", token):
        for number in re.finditer(r"-?[0-9]+", token):
            text, value = number.group(), int(number.group())
            for new in (str(value + 1), str(-value) if value else "-1", text[:-1] + str((int(text[-1]) + 3) % 10)):
                result.append(("number", token[:number.start()] + new + token[number.end():]))
    else:
        others = []
        for words in CLASSES:
            words = words.split()
            if token in words:
                others += [w for w in words if w != token and w not in others]
        result += [("word", w) for w in others]
    return result + [("token", None), ("token", token + " " + token)]


def mutants(text):
    """(kind, line from 0, token from 0, new text of the whole certificate)."""
    lines = text.split("\n")[:-1]
    for i, line in enumerate(lines):
        tokens = line.split(" ")
        for k, token in enumerate(tokens):
            for kind, new in mutants_of_token(token, tokens[k - 1] if k else ""):
                changed = tokens[:k] + ([] if new is None else [new]) + tokens[k + 1:]
                yield kind, i, k, new, "\n".join(lines[:i] + [" ".join(changed)] + lines[i + 1:]) + "\n"
