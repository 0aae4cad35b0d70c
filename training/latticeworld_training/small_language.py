"""The small language of the readers, as its tables say it (src/latticeworld/language/sentences/data).

A sentence is matched against the forms' patterns as regular expressions; what it means is the C++ code's to say.
"""

import functools
import pathlib
import re

DATA = pathlib.Path(__file__).resolve().parents[2] / "src/latticeworld/language/sentences/data"
BUILT_IN = {"n": r"-?\d+(?:\.\d+)?", "label": "[A-Z]"}


def lines_of(name):
    """The lines of a table without comments and blank ones, as lists of fields."""
    text = (DATA / name).read_text(encoding="utf-8")
    return [line.split("\t") for line in text.splitlines() if line and not line.startswith("#")]


def plural(noun):
    """The English plural of a noun's last word."""
    if noun in ("sheep",):
        return noun
    if noun.endswith("sis"):
        return noun[:-2] + "es"
    if re.search(r"(s|sh|ch|x)$", noun):
        return noun + "es"
    if re.search(r"[^aeiou]y$", noun):
        return noun[:-1] + "ies"
    return noun + "s"


@functools.lru_cache(maxsize=None)
def words():
    """List name -> its words; NAME_s has the plurals of NAME."""
    lists = {fields[0]: fields[1:] for fields in lines_of("words.txt")}
    for name in ("countable", "relief", "object", "who", "feature"):
        lists[f"{name}_s"] = [plural(noun) for noun in lists[name]]
    return lists


@functools.lru_cache(maxsize=None)
def slot(name):
    """The regular expression of a slot."""
    if name in BUILT_IN:
        return BUILT_IN[name]
    patterns = dict(lines_of("slots.txt"))
    if name in patterns:
        return expression(patterns[name])
    return "(?:" + "|".join(sorted(map(re.escape, words()[name]), key=len, reverse=True)) + ")"


def expression(pattern):
    """The regular expression of a pattern; every word and slot takes one blank before it, but for stops' kin."""
    tokens = re.findall(r"\{\w+\}|[\[\]()*]|[^\s\[\](){}*]+", pattern)
    out = []
    for token in tokens:
        if token in "[(":
            out.append("(?:")
        elif token == "]":
            out.append(")?")
        elif token in ")*":
            out.append(token)
        elif token == "/":
            out.append("|")
        elif token.startswith("{"):
            out.append("(?: " + slot(token[1:-1]) + ")" if token[1:-1] in BUILT_IN or token[1:-1] in words()
                       else slot(token[1:-1]))
        else:
            end = "".join(re.findall(r"[:,]$", token))
            choices = [re.escape(word) for word in token[: len(token) - len(end)].split("|") if word]
            out.append(("(?: (?:" + "|".join(choices) + "))" if choices else "") + end)
    return "(?:" + "".join(out) + ")"


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
    if not sentence:
        return None
    sentence = " " + sentence[0].lower() + sentence[1:]
    for name, compiled, _ in forms(kind):
        if compiled.fullmatch(sentence):
            return name
    return None


def page():
    """The tables of docs/small_language.md, in Markdown, as the tables of forms and words say them."""
    parts = []
    for kind, title in (("layout", "Land"), ("environment", "What happens on it")):
        parts += [f"## {title}", "", "| form | an example |", "|---|---|"]
        for _, pattern, example in lines_of(f"{kind}_forms.txt"):
            parts.append(f"| `{pattern.replace('|', '&#124;')}` | {example} |")
        parts.append("")
    parts += ["## Words", "", "| list | words |", "|---|---|"]
    parts += [f"| {fields[0]} | {', '.join(fields[1:])} |" for fields in lines_of("words.txt")]
    return "\n".join(parts) + "\n"


if __name__ == "__main__":
    print(page(), end="")
