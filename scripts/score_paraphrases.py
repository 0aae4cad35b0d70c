#!/usr/bin/env python3
"""What the embedded back end loses when instructions are written another way.

    scripts/score_paraphrases.py                      # all changes, some four minutes
    scripts/score_paraphrases.py lower digits --misses

Every instruction of the development part of benchmarks/fidelity is changed in ways that leave its meaning: case, marks,
digits for words, compass for picture words, synonyms, typing mistakes. A claim is lost by a change if no layout of two
seeds satisfies it any more, and the instruction as it was written had one that did for each of those seeds: chance is
thus mostly left out. What is lost was read by luck.
"""

import argparse
import copy
import json
import os
import random
import re
import subprocess
import sys
import tempfile
import zlib

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
KINDS = ("layout", "environment")
SEEDS = (1, 2)
MISS = re.compile(r'^  (\S+) (\w+): (".*")$')
NEW_SENTENCE = re.compile(r"\. (?!I )([A-Z])(?=[a-z ])")


def in_case_of(old, new):
    if len(old) > 3 and old.isupper():
        return new.upper()
    return new[:1].upper() + new[1:] if old[:1].isupper() else new


def words_for(**others):
    """A change of whole words; underscores stand for blanks, the longest match first."""
    return replaced({old.replace("_", " "): new for old, new in others.items()})


def replaced(table, before=r"(?<![\w-])", after=r"(?![\w-])"):
    wanted = "|".join(re.escape(old) for old in sorted(table, key=len, reverse=True))
    pattern = re.compile(f"{before}({wanted}){after}", re.IGNORECASE)
    return lambda text: pattern.sub(lambda found: in_case_of(found[0], table[found[0].lower()]), text)


def sentences_joined_by(mark):
    return lambda text: NEW_SENTENCE.sub(lambda found: mark + found[1].lower(), text)


def with_typing_mistakes(text):
    """Two letters within one long word of four have changed places."""
    draws = random.Random(zlib.crc32(text.encode()))

    def swapped(found):
        word = found[0]
        if draws.random() >= 0.25:
            return word
        at = draws.randrange(1, len(word) - 2)
        return word[:at] + word[at + 1] + word[at] + word[at + 2 :]

    return re.sub(r"[a-z]{6,}", swapped, text)


NUMBERS = dict(two="2", three="3", four="4", five="5", six="6", seven="7", eight="8", nine="9", ten="10", twelve="12")
SIDES = {"north": "top", "south": "bottom", "west": "left", "east": "right",
         "northern": "upper", "southern": "lower", "western": "left", "eastern": "right"}
CORNERS = {"north-west": "top left", "north-east": "top right", "south-west": "bottom left", "south-east": "bottom right",
           "northwest": "top left", "northeast": "top right", "southwest": "bottom left", "southeast": "bottom right",
           "northwestern": "upper left", "northeastern": "upper right",
           "southwestern": "lower left", "southeastern": "lower right"}
PICTURE = {f"{picture} {part}": f"{compass} {part}" for picture, compass in
           {"top": "northern", "upper": "northern", "bottom": "southern", "lower": "southern", "left": "western",
            "right": "eastern", "left-hand": "western", "right-hand": "eastern"}.items()
           for part in ("half", "third", "edge", "side", "border", "part")}
PICTURE |= {"on the left": "in the west", "on the right": "in the east", "at the top": "in the north",
            "at the bottom": "in the south", "topmost": "northernmost", "leftmost": "westernmost"}
PICTURE_CORNERS = {f"{up} {side}": compass for (up, side), compass in {
    ("top", "left"): "north-west", ("top", "right"): "north-east", ("upper", "left"): "north-west",
    ("upper", "right"): "north-east", ("bottom", "left"): "south-west", ("bottom", "right"): "south-east",
    ("lower", "left"): "south-west", ("lower", "right"): "south-east"}.items()}
SHORT_CORNERS = {f"{vertical}{hyphen}{side}": (vertical[0] + side[0]).upper()
                 for vertical in ("north", "south") for hyphen in ("", "-") for side in ("west", "east")}
APOSTROPHES = {"there's": "there is", "isn't": "is not", "don't": "do not", "it's": "it is", "doesn't": "does not",
               "that's": "that is", "i'd": "i would", "aren't": "are not", "can't": "cannot", "i'm": "i am", "let's": "let us"}

CHANGES = {
    "no full stop": lambda text: text.rstrip("."),
    "lower": str.lower,
    "upper": str.upper,
    "semicolons": lambda text: re.sub(r"\. (?=[A-Z])", "; ", text),
    "lines": lambda text: re.sub(r"\. (?=[A-Z])", ".\n", text),
    "dashes": lambda text: text.replace(": ", " - ").replace("; ", " - "),
    "commas for stops": sentences_joined_by(", "),
    "and for stops": sentences_joined_by(", and "),
    "greetings": lambda text: "Hi! For my thesis I need a map. " + text + " Thanks a lot in advance!",
    "thinking": lambda text: "So, I was thinking, " + text[:1].lower() + text[1:],
    "a robot": lambda text: text + " The robot starts somewhere and has to find its way.",
    "picture words": replaced({**SIDES, **CORNERS}),
    "compass": replaced({**PICTURE, **PICTURE_CORNERS}, after=r"(?![\w-])(?! (?:half|third|edge|side|border|part|corner))"),
    "abbreviations": replaced(SHORT_CORNERS),
    "hyphens in corners": replaced({corner.replace("-", ""): corner for corner in SHORT_CORNERS if "-" in corner}),
    "no hyphens": lambda text: re.sub(r"(?<=[a-z])-(?=[a-z])", " ", text),
    "middle": words_for(center="middle", centre="middle", middle="center"),
    "heart": words_for(in_the_center="at the heart", in_the_centre="at the heart", in_the_middle="in the very centre"),
    "waters": words_for(lake="tarn", lakes="tarns", pond="pool", ponds="pools", river="stream", rivers="streams"),
    "woods": words_for(forest="woodland", forests="woodlands", woods="forest", a_wood="a copse", the_wood="the copse"),
    "villages": words_for(village="hamlet", villages="hamlets", town="settlement", houses="cottages", house="cottage"),
    "roads": words_for(road="lane", roads="lanes", track="path", path="trail"),
    "fields": words_for(fields="farm fields", farmland="cropland", cropland="arable land"),
    "meadows": words_for(meadow="grassland", meadows="pastures", grass="turf", grassland="meadow"),
    "digits": replaced(NUMBERS),
    # Not those of lists, decimals, percentages and measures.
    "words for digits": replaced({digit: word for word, digit in NUMBERS.items() if int(digit) < 9},
                                 before=r"(?<![\w.,:/-])", after=r"(?= [a-z]{3})(?! (?:per|degrees|met|cell|square))"),
    "long forms": replaced(APOSTROPHES),
    "short forms": words_for(there_is="there's", is_not="isn't", do_not="don't", it_is="it's", does_not="doesn't",
                             are_not="aren't"),
    "no apostrophes": lambda text: text.replace("'", "").replace("\u2019", ""),
    "curly marks": lambda text: text.replace("'", "\u2019").replace(" - ", " \u2014 ").replace('"', "\u201c"),
    "beside": words_for(next_to="beside", beside="next to", near="close to", close_to="near", alongside="along",
                        along="alongside"),
    "around": words_for(surrounded_by="ringed by", around="all around", surrounds="encircles",
                        encircled_by="surrounded by", enclosed_by="surrounded by"),
    "runs": words_for(runs="goes", goes="runs", run="go", flows="runs", leads="goes", winds="meanders",
                      crosses="cuts across", cuts_through="runs through", passes="runs"),
    "covers": words_for(covers="takes up", takes_up="occupies", fills="covers", occupies="fills", covered_with="covered in",
                        covered_by="covered with"),
    "the rest": words_for(everywhere_else_is="the rest is", everything_else_is="the rest is", the_rest_is="everything else is",
                          elsewhere="everywhere else", all_the_rest="everything else"),
    "no": words_for(there_is_no="there isn't any", there_are_no="there aren't any", without_any="with no",
                    with_no="without any"),
    "wishes": words_for(i_want="I'd like", i_need="I want", please="could you", there_is="we have", there_are="we have",
                        there_should_be="I want"),
    "halves": words_for(western_half="left-hand half", eastern_half="right-hand side", northern_half="top half",
                        southern_half="bottom half", half_of_the_map="50 % of the map", a_third_of="33 % of",
                        a_quarter_of="25 percent of", one_third="a third"),
    "sizes": words_for(big="large", large="sizeable", small="little", little="small", tiny="very small", huge="enormous",
                       wide="broad", narrow="slim"),
    "sides": words_for(between="in between", both_sides="either side", either_side="both sides",
                       on_each_side="on both sides"),
    "typing mistakes": with_typing_mistakes,
}
# In an environment a robot more is another one.
OF_LAYOUTS = ("a robot",)


def missed(program, benchmark, items, seed):
    """The claims, (instruction's id, kind, words), that the embedded back end's answers to `items` ({kind: instructions})
    do not satisfy. Ends this program where there is no score."""
    with tempfile.TemporaryDirectory() as directory:
        os.symlink(os.path.join(benchmark, "layouts"), os.path.join(directory, "layouts"))
        for kind in KINDS:
            with open(os.path.join(directory, f"{kind}_development.json"), "w", encoding="utf-8") as file:
                json.dump(items[kind], file)
        command = [program, "score", "--benchmark", directory, "--generator", "grounded", "--misses", "--seed", str(seed)]
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{' '.join(command)}\nended with {done.returncode}:\n{done.stderr.strip()}")
    known = {item["id"] for kind in KINDS for item in items[kind]}
    misses = (MISS.match(line) for line in done.stdout.splitlines())
    return {miss.groups() for miss in misses if miss and miss[1] in known}


def changed_items(items, name):
    """The instructions that a change makes others. A benchmark wants one of each kind: where none is changed, the
    first stands for all."""
    result = {}
    for kind in KINDS:
        change = str if kind == "environment" and name in OF_LAYOUTS else CHANGES[name]
        after = copy.deepcopy(items[kind])
        for item in after:
            item["instruction"] = change(item["instruction"])
        differ = [new for new, old in zip(after, items[kind]) if new["instruction"] != old["instruction"]]
        result[kind] = differ or after[:1]
    return result


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("changes", nargs="*", metavar="CHANGE", help=f"some of: {', '.join(CHANGES)} [all]")
    parser.add_argument("--program", default="latticeworld", help="[latticeworld]")
    parser.add_argument("--benchmark", default=os.path.join(ROOT, "benchmarks", "fidelity"), help="[benchmarks/fidelity]")
    parser.add_argument("--misses", action="store_true", help="also lists the lost claims with what was asked")
    given = parser.parse_args()
    unknown = [name for name in given.changes if name not in CHANGES]
    if unknown:
        parser.error(f"'{unknown[0]}' is no change; legal are {', '.join(CHANGES)}")

    items = {}
    for kind in KINDS:
        with open(os.path.join(given.benchmark, f"{kind}_development.json"), encoding="utf-8") as file:
            items[kind] = json.load(file)
    missed_before = set.union(*(missed(given.program, given.benchmark, items, seed) for seed in SEEDS))
    print(f"{'change':<20}{'instructions':>14}{'claims':>8}{'lost':>6}")
    for name in given.changes or CHANGES:
        changed = changed_items(items, name)
        missed_now = set.intersection(*(missed(given.program, given.benchmark, changed, seed) for seed in SEEDS))
        lost = sorted(missed_now - missed_before)
        some = changed["layout"] + changed["environment"]
        claims = sum(len(item["claims"]) for item in some)
        print(f"{name:<20}{len(some):>14}{claims:>8}{len(lost):>6}", flush=True)
        if given.misses:
            texts = {item["id"]: item["instruction"] for item in some}
            for item, kind, words in lost:
                print(f"  {item} {kind}: {words}\n      {texts[item]}")


if __name__ == "__main__":
    main()
