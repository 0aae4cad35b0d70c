"""The small language of the readers, as the two tables of forms say it (src/latticeworld/language/sentences/data).

A sentence is matched against the forms' patterns as regular expressions; what it means is the C++ code's to say.
"""

import functools
import pathlib
import re

DATA = pathlib.Path(__file__).resolve().parents[2] / "src/latticeworld/language/sentences/data"

NUMBER = r"-?\d+(?:\.\d+)?"
PERCENT = rf"(?:at least |at most |\d+ to )?\d+ %"
RANGE = rf"(?:at least |at most )?{NUMBER}(?: to {NUMBER})?"


def lines_of(name):
    """The lines of a table without comments and blank ones, as lists of fields."""
    text = (DATA / name).read_text(encoding="utf-8")
    return [line.split("\t") for line in text.splitlines() if line and not line.startswith("#")]


@functools.lru_cache(maxsize=None)
def words():
    """List name -> its words."""
    return {fields[0]: fields[1:] for fields in lines_of("words.txt")}


def plural(noun):
    """The regular English plural of a noun's last word."""
    if noun in ("sheep", "branches"):
        return noun
    if re.search(r"(s|sh|ch|x)$", noun):
        return noun + "es"
    if re.search(r"[^aeiou]y$", noun):
        return noun[:-1] + "ies"
    return noun + "s"


def one_of(names):
    """A regular expression for any of the words, the longest first."""
    return "(?:" + "|".join(sorted(map(re.escape, names), key=len, reverse=True)) + ")"


@functools.lru_cache(maxsize=None)
def slots():
    """Slot name -> regular expression."""
    w = words()
    singular = w["thing"] + w["relief"] + w["object"]
    nouns = one_of(w["mass"] + singular + [plural(noun) for noun in singular])
    adjectives = f"(?:{one_of(w['size'] + w['shape'])} )*"
    quantity = r"(?:an? |(?:at least |at most |\d+ to )?\d+ )"
    thing = rf"(?:(?:the (?:\d+ )?|{quantity})?{adjectives}{nouns}(?: [A-Z])?)"
    place = rf"(?:the )?{one_of(w['side'] + w['place'])}"
    zone = rf"{place}(?:, {place})*(?: and {place})?"
    who = one_of(w["who"] + [plural(noun) for noun in w["who"]])

    def some(name):
        return rf"{one_of(w[name])}(?: or {one_of(w[name])})*"

    return {
        "x": thing, "y": thing, "z": thing, "noun": rf"{nouns}(?: [A-Z])?",
        "nouns": rf"{nouns}(?:, {nouns})+", "zone": zone, "end": rf"(?:{zone}|{thing})",
        "percent": PERCENT, "heading": one_of(w["heading"]), "n": NUMBER,
        "shape": one_of(w["shape"]), "rugged": one_of(w["rugged"]), "pattern": one_of(w["pattern"]),
        "season": some("season"), "weather": some("weather"), "time": some("time"),
        "style": some("style"), "terrain": some("terrain"),
        "values": rf"(?:{one_of(w['season'])} )?{some('values')}", "asset": one_of(w["asset"]),
        "who": rf"{who}(?: or {who})*", "state": some("state"), "near": one_of(w["near"]),
        "feature": rf"{one_of(w['feature'] + [plural(noun) for noun in w['feature']])}",
        "part": one_of(w["part"]),
        "side": one_of(w["side"] + w["place"]), "amount": rf"(?:dense|sparse|none|{PERCENT})", "range": RANGE,
        "count": r"(?:(?:at least |at most |\d+ to )?\d+|some)",
    }


def expression(pattern):
    """The regular expression of a form's pattern."""
    # Each optional part takes the blank before it along.
    pattern = re.sub(r"^\[([^\]]*)\] ", r"(?:\1 )?", pattern)
    pattern = re.sub(r" \[([^\]]*)\]", r"(?: \1)?", pattern)

    def alternatives(match):
        return "(?:" + match.group(0) + ")"

    pattern = re.sub(r"(?<![\w{:?])[a-z]+(?:\|[a-z]+)+", alternatives, pattern)
    pattern = re.sub(r"(?<=\(\?: )[a-z]+(?:\|[a-z]+)+", alternatives, pattern)
    return re.sub(r"\{(\w+)\}", lambda match: "(?P<%s>%s)" % (match.group(1), slots()[match.group(1)])
                  if pattern.count(match.group(0)) == 1 else slots()[match.group(1)], pattern)


@functools.lru_cache(maxsize=None)
def forms(kind):
    """(name, compiled expression, example) of each form; kind: "layout" or "environment"."""
    return [(name, re.compile(expression(pattern)), example)
            for name, pattern, example in lines_of(f"{kind}_forms.txt")]


def split(text):
    """The sentences of a text: a stop ends one, but for the point in a number."""
    return [part.strip() for part in re.split(r"\.(?=\s|$)", text) if part.strip()]


def form_of(sentence, kind):
    """The name of the first form that a sentence (without its stop) has, or None."""
    sentence = sentence.strip()
    if sentence:
        sentence = sentence[0].lower() + sentence[1:]
    for name, compiled, _ in forms(kind):
        if compiled.fullmatch(sentence):
            return name
    return None
