"""Says drawn plans of the small language in many words, so that a reader learns the forms before it learns people.

Every form has phrasings, every noun and place other words; sentences are joined, slips of the pen and talk are mixed in.
It is no substitute for texts of people: no text of it counts as an example of theirs.

    python3 -m latticeworld_training.say_plans {layout,environment} COUNT SEED > said.jsonl
"""

import json
import random
import re
import sys

from . import draw_plans, small_language

NOUNS = {
    "lake": "lake|mere|body of water|loch|lagoon|reservoir", "pond": "pond|pool|tarn|small lake|waterhole",
    "river": "river|waterway|watercourse|stream of water", "stream": "stream|brook|creek|beck|rivulet", "canal": "canal|ditch|channel",
    "water": "water|open water|water surface", "sea": "sea|ocean", "forest": "forest|woods|woodland|trees|jungle|pine forest|a wood|timber",
    "grassland": "grassland|grass|pasture|lawn|steppe|open grass|prairie", "farmland": "farmland|fields|cropland|crops|arable land|wheat fields|agricultural land|cultivated land",
    "barren land": "barren land|bare soil|bare ground|wasteland|bare earth|barren terrain", "sand": "sand|sandy ground|sandy soil",
    "rock": "rock|rocks|rocky land|stone|boulders|rocky terrain|scree|crags", "snow": "snow|snowfields|ice|snow cover|snow-capped land",
    "bushes": "bushes|scrub|shrubs|heath|low bushes|shrubland|moor", "village": "village|hamlet|settlement|small town|cluster of houses",
    "town": "town|township|built-up area", "house": "house|cottage|home|cabin|dwelling", "building": "building|structure|warehouse", "farm": "farm|farmstead|farmhouse|homestead",
    "grove": "grove|copse|thicket|clump of trees|small wood|stand of trees", "road": "road|highway|lane|route|motorway", "street": "street|avenue",
    "path": "path|trail|footpath|track", "park": "park|green", "meadow": "meadow|clearing of grass|pasture", "field": "field|crop field|wheat field|plot of farmland",
    "mountain": "mountain|massif", "hill": "hill|knoll|rise", "glacier": "glacier|ice field", "swamp": "swamp|marsh|bog|wetland", "tree": "tree|oak|pine", "boulder": "boulder|big rock",
}
SIDES = {
    "north": "north|top|upper part|northern part|north side|upper side", "south": "south|bottom|lower part|southern part|south side",
    "east": "east|right|right side|eastern part|right-hand side", "west": "west|left|left side|western part|left-hand side",
    "north-east": "north-east|upper right|top right|northeast", "north-west": "north-west|upper left|top left|northwest",
    "south-east": "south-east|lower right|bottom right|southeast", "south-west": "south-west|lower left|bottom left|southwest",
    "center": "center|middle|heart of the map|central part|centre", "northern half": "northern half|upper half|top half", "southern half": "southern half|lower half|bottom half",
    "eastern half": "eastern half|right half", "western half": "western half|left half", "northern third": "northern third|top third|upper third",
    "southern third": "southern third|bottom third|lower third", "eastern third": "eastern third|right third", "western third": "western third|left third",
    "northern edge": "northern edge|top edge|upper edge|northern border|north rim|top of the map", "southern edge": "southern edge|bottom edge|lower border|southern boundary|bottom of the map",
    "eastern edge": "eastern edge|right edge|right border|eastern margin", "western edge": "western edge|left edge|left-hand border|western boundary",
    "north-east corner": "north-east corner|top right corner|upper right corner", "north-west corner": "north-west corner|top left corner|upper left-hand corner",
    "south-east corner": "south-east corner|bottom right corner|lower right corner", "south-west corner": "south-west corner|bottom left corner|lower left corner",
    "corners": "four corners|corners", "edges": "edges|rim of the map|margins all around", "interior": "interior|inner part",
    "middle rows": "horizontal middle band|middle band from left to right", "middle columns": "vertical middle band|middle band from top to bottom",
    "north-eastern quarter": "north-eastern quarter|upper right quadrant|top right quarter", "north-western quarter": "north-western quarter|upper left quadrant|top left quarter",
    "south-eastern quarter": "south-eastern quarter|lower right quadrant|bottom right quarter", "south-western quarter": "south-western quarter|lower left quadrant|bottom left quarter",
}
NUMBERS = "zero one two three four five six seven eight nine ten eleven twelve".split()
SIZES = {"tiny": "tiny|minute|very small", "small": "small|little", "large": "large|big|sizeable|extensive", "huge": "huge|vast|enormous"}
SHAPES = {"round": "round|circular", "long": "long|elongated|stretched", "curved": "curved|bent|crescent-shaped", "ring-shaped": "ring-shaped|ring of a",
          "straight": "straight|dead straight", "winding": "winding|meandering|twisting|snaking"}
HEADINGS = {"north": "north of|above|to the north of", "south": "south of|below|to the south of", "east": "east of|to the right of|to the east of",
            "west": "west of|to the left of|to the west of"}
# By form; {x} {y} {z} things, {zone} {end}..., {in} "in the ...".
PHRASINGS = {
    "there": "{x} {in}.|There is {x} {in}.|{In}, there is {x}.|{In} lies {x}.|I want {x} {in}.|Put {x} {in}.|{x} can be found {in}.|{x} is located {in}.|We see {x} {in}.|{in}: {x}.|{x} occupies {zone}.|Place {x} {in}, please.|{x} predominantly {in}.|{zone} has {x}.",
    "absent": "No {noun} {in}.|There is no {noun} {in}.|Without any {noun} {in}.|Not a trace of {noun} {in}.|Leave out {noun} {in}.|{noun} is absent {in}.|I don't want {noun} {in}.|{in} there must not be any {noun}.",
    "only": "{noun} only {in}.|{noun} nowhere but {in}.|All the {noun} is {in} and nowhere else.|{noun} exclusively {in}.|Keep {noun} strictly to {zone}.",
    "most_in": "Most {noun} is {in}.|The bulk of the {noun} lies {in}.|{noun} is mainly found {in}.|The majority of {noun} is {in}.",
    "cover": "{x} covers {percent}.|{percent} is {x}.|{x}: {percent}.|{percent} {x}.|{x} takes up {percent}.|{x} makes up {percent}.|About {percent} of {x}.|{x} accounts for {percent}.",
    "cover_zone": "{x} covers {percent} of {zone}.|In {zone}, {percent} is {x}.|{percent} of {zone} should be {x}.",
    "mostly": "Mostly {noun} {in}.|The map is dominated by {noun} {in}.|{noun} is the predominant land cover {in}.|{in} it is mainly {noun}.|Largely {noun} {in}.|The land {in} is mostly {noun}.|{noun} prevails {in}.",
    "fill": "{x} fills {zone}.|The whole {bare_zone} is {x}.|{zone} is {x}.|{x} takes all of {zone}.|{zone} is entirely {x}.|{bare_zone}: {x}.|{x} occupies the entire {bare_zone}.",
    "rest": "The rest is {noun}.|Everything else is {noun}.|Otherwise {noun}.|{noun} everywhere else.|All that remains is {noun}.|The remaining area is {noun}.|Elsewhere just {noun}.|Fill what is left with {noun}.",
    "more": "More {noun} than {noun2}.|There is more {noun} than {noun2}.|{noun} outweighs {noun2}.|Less {noun2} than {noun}.",
    "touch": "{x} touches {y}.|{x} is right next to {y}.|{x} borders {y}.|{x} is adjacent to {y}.|{x} lies directly beside {y}.|{x} on the edge of {y}.",
    "near": "{x} is near {y}.|{x} is close to {y}.|{x} is not far from {y}.|{x} lies in the vicinity of {y}.|{x} by {y}.",
    "away": "{x} is away from {y}.|Keep {x} away from {y}.|{x} must not be close to {y}.|{x} keeps its distance from {y}.|{x} does not touch {y}.",
    "far": "{x} is far from {y}.|{x} is a long way from {y}.|{x} lies far away from {y}.",
    "away_cells": "{x} is at least {n} cells from {y}.|A gap of {n} cells or more between {x} and {y}.|Between {x} and {y} leave no fewer than {n} cells.",
    "surround": "{x} surrounds {y}.|{y} is surrounded by {x}.|{y} is encircled by {x}.|{x} all around {y}.|{y} ringed by {x}.|{x} encloses {y} on all sides.",
    "inside": "{x} is inside {y}.|{x} lies in the middle of {y}.|{y} contains {x}.|Within {y} there is {x}.|Hidden in {y} is {x}.",
    "both_sides": "{x} is on both sides of {y}.|{y} is flanked by {x}.|{y} has {x} on either side.|{x} to the left and right of {y}.|{y} is lined with {x} on both sides.",
    "between": "{x} is between {y} and {z}.|Between {y} and {z} lies {x}.|{x} separates {y} from {z}.|{x} sits in between {y} and {z}.",
    "heading": "{x} is {heading} {y}.|{heading} {y} there is {x}.|{x} {heading} {y}.|{heading} {y} lies {x}.",
    "order": "From {from} to {to}: {nouns}.|Going from {from} to {to} you meet {nouns}.|Bands from {from} to {to}: {nouns}.|{nouns}, in this order from {from} to {to}.",
    "course": "{x} from {end1} to {end2}{via}.|{x} runs from {end1} to {end2}{via}.|{x} goes from {end1} to {end2}{via}.|{x} leads from {end1}{via} to {end2}.|{x} starts at {end1} and ends at {end2}{via}.|{x} comes in at {end1} and leaves at {end2}{via}.|{x} stretches from {end1} to {end2}{via}.",
    "ends": "{x} ends at {end1}.|{x} leads to {end1}.|{x} runs to {end1}.|{x} goes as far as {end1}.|{x} reaches {end1}.",
    "through": "{x} runs through {end1}.|{x} passes through {end1}.|{x} cuts through {end1}.|{x} crosses {end1}.",
    "along": "{x} runs along {end1}.|{x} follows {end1}.|Along {end1} runs {x}.|{x} hugs {end1}.",
    "lined": "{x} is along {end1}.|{x} lines {end1}.|Along {end1} there is {x}.|{x} strung out along {end1}.",
    "cross": "{x} crosses {y}.|{x} intersects {y}.|{x} goes over {y}.",
    "parallel": "{x} is parallel to {y}.|{x} runs alongside {y}.|{x} and {y} run side by side.",
    "scattered": "{x} are scattered.|{x} are scattered all over.|{x} are dotted about.|{x} lie here and there.|{x} are spread around.",
    "together": "{x} are close together.|{x} are huddled together.|{x} form a tight cluster.",
    "apart": "{x} are apart.|{x} do not touch each other.|{x} stand apart from one another.", "far_apart": "{x} are far apart.|{x} are a long way from each other.",
}
TALK = ["Weather does not matter here.", "It is for a robot test.", "Thanks!", "Imagine a quiet autumn day.", "This is what I remember.", "please", "ok so", "Scene 4."]


class Speaker:
    """Says things in other words, as its random source has it."""

    def __init__(self, draws):
        self.draws = draws

    def one(self, words):
        return self.draws.choice(words.split("|"))

    def noun(self, noun):
        words = small_language.words()
        for name in ("countable", "relief", "object"):
            for singular in words[name]:
                if noun == small_language.plural(singular) and noun != singular:
                    return small_language.plural(self.one(NOUNS.get(singular, singular)).replace("a wood", "wood"))
        return self.one(NOUNS.get(noun, noun))

    def number(self, digits):
        value = int(digits)
        return NUMBERS[value] if value < len(NUMBERS) and self.draws.random() < 0.7 else digits

    def place(self, text):
        """A place or several; with its article."""
        def say(match):
            return "the " + self.one(SIDES.get(match.group(1), match.group(1)))
        words = small_language.words()
        names = sorted(words["side"] + words["exact"], key=len, reverse=True)
        return re.sub("the (" + "|".join(names) + ")(?![\\w-])", say, text)

    def thing(self, text):
        """A thing: article or number, sizes, shapes, noun."""
        words = small_language.words()
        label = re.search(" [A-Z]$", text)
        body = text[: label.start()] if label else text
        body = re.sub(r"^at least (\d+) ", lambda m: self.one(f"at least {m[1]}|{m[1]} or more|no fewer than {self.number(m[1])}") + " ", body)
        body = re.sub(r"^at most (\d+) ", lambda m: self.one(f"at most {m[1]}|no more than {self.number(m[1])}|up to {m[1]}") + " ", body)
        body = re.sub(r"^(\d+) to (\d+) ", lambda m: self.one(f"{m[1]} to {m[2]}|between {self.number(m[1])} and {self.number(m[2])}|{m[1]}-{m[2]}") + " ", body)
        body = re.sub(r"^1 ", lambda m: self.one("one|a single|exactly one|only one|1") + " ", body)
        body = re.sub(r"^(\d+) (?!to |or |and )", lambda m: self.number(m[1]) + " ", body)
        nouns = sorted(words["mass"] + [n for k in ("countable", "relief", "object", "countable_s", "relief_s", "object_s") for n in words[k]], key=len, reverse=True)
        match = re.search("(" + "|".join(map(re.escape, nouns)) + ")$", body)
        if not match:
            return text
        head = body[: match.start()]
        for table in (SIZES, SHAPES):
            for word, others in table.items():
                head = re.sub(rf"\b{word}\b", lambda m, o=others: self.one(o), head)
        noun = self.noun(match.group(1))
        said = head + noun
        said = re.sub(r"^a (?=[aeiou])", "an ", re.sub(r"\b(an?) a ", "a ", said))
        return said + (label.group(0) if label else "")

    def say(self, sentence, kind="layout"):
        """One sentence of the small language in other words."""
        lowered = sentence[0].lower() + sentence[1:]
        form = small_language.form_of(sentence, kind)
        phrasing = PHRASINGS.get(form)
        found = next((c.fullmatch(" " + lowered) for n, c, _ in small_language.forms(kind) if n == form), None)
        if phrasing is None or found is None:
            return sentence + "."
        slots = self.slots(form, lowered)
        choices = [each for each in phrasing.split("|") if slots.get("zone") or not re.search(r"\{(zone|bare_zone|In)\}", each)]
        text = self.draws.choice(choices or ["{plain}"])
        slots["plain"] = sentence + "."
        text = re.sub(r"\{(\w+)\}", lambda m: slots.get(m[1], ""), text)
        text = re.sub(r"\s+([.,:])", r"\1", re.sub(r"\s+", " ", text)).strip().lstrip(":,. ")
        return text[:1].upper() + text[1:]

    def slots(self, form, text):
        """What a sentence's slots become, found by the words between them."""
        s = {}
        zone = re.search(r" (?:in|at|on) (the .*)$", text)
        if form in ("there", "absent", "only", "most_in", "mostly", "more") and zone:
            s["zone"] = self.place(zone[1])
            s["in"] = self.one("in|in|at|towards") + " " + s["zone"] if "corner" not in s["zone"] and "edge" not in s["zone"] else "in " + s["zone"]
            s["In"] = s["in"]
            text = text[: zone.start()]
        if form == "there":
            s["x"] = self.thing(text)
        elif form == "absent":
            s["noun"] = self.noun(text[3:])
        elif form == "only":
            s["noun"] = self.noun(text[:-5])
        elif form == "most_in":
            s["noun"] = self.noun(re.sub("^most (.*) (is|are)$", r"\1", text))
        elif form in ("cover", "cover_zone"):
            match = re.match(r"(.*) covers? (.*) of (the .*)$", text)
            s["x"], s["percent"] = self.thing(match[1]), self.percent(match[2])
            if form == "cover":
                s["percent"] += self.one("|| of the map| of the area| of the land")
            else:
                s["zone"] = self.place(match[3])
        elif form == "mostly":
            s["noun"] = self.noun(text[7:])
        elif form == "fill":
            match = re.match(r"(.*) fills? (the .*)$", text)
            s["x"], s["zone"] = self.thing(match[1]), self.place(match[2])
            s["bare_zone"] = s["zone"][4:]
        elif form == "rest":
            s["noun"] = self.noun(text.rsplit(" is ", 1)[1])
        elif form == "more":
            match = re.match("more (.*) than (.*)$", text)
            s["noun"], s["noun2"] = self.noun(match[1]), self.noun(match[2])
        elif form == "order":
            match = re.match(r"from (\S+) to (\S+): (.*)$", text)
            s["from"], s["to"] = match[1], match[2]
            nouns = [self.noun(noun) for noun in match[3].split(", ")]
            s["nouns"] = self.one("|".join([", ".join(nouns), ", then ".join(nouns), ", ".join(nouns[:-1]) + " and " + nouns[-1]]))
        elif form == "course":
            match = re.match(r"(.*?) from (.*?) to (.*?)(?: through (.*))?$", text)
            s["x"], s["end1"], s["end2"] = self.thing(match[1]), self.end(match[2]), self.end(match[3])
            s["via"] = self.one(" through | via | by way of ") + self.end(match[4]) if match[4] else ""
        elif form in ("ends", "through", "along", "lined"):
            match = re.match(r"(.*?) (?:ends? at|runs? through|runs? along|(?:is|are) along) (.*)$", text)
            s["x"], s["end1"] = self.thing(match[1]), self.end(match[2])
        elif form in ("scattered", "together", "apart", "far_apart"):
            s["x"] = self.thing(re.sub(" (is|are) (scattered|close together|far apart|apart)$", "", text))
        else:
            self.relation_slots(form, text, s)
        return s

    def relation_slots(self, form, text, s):
        verbs = {"touch": r"touch(?:es)?", "near": "(?:is|are) near", "away": "(?:is|are) away from", "far": "(?:is|are) far from",
                 "away_cells": r"(?:is|are) at least (?P<n>\d+) cells from", "surround": "surrounds?", "inside": "(?:is|are) inside",
                 "both_sides": "(?:is|are) on both sides of", "between": "(?:is|are) between", "cross": "cross(?:es)?",
                 "parallel": "(?:is|are) parallel to", "heading": r"(?:is|are) (?P<h>[a-z-]+) of"}
        match = re.match(rf"(.*?) {verbs.get(form, 'zzz')} (.*)$", text)
        if not match:
            return
        s["x"] = self.thing(match[1])
        other = match[len(match.groups())]
        if form == "between" and " and " in other:
            first, second = other.split(" and ", 1)
            s["y"], s["z"] = self.thing(first), self.thing(second)
        else:
            s["y"] = self.thing(other)
        if form == "away_cells":
            s["n"] = self.number(match["n"])
        if form == "heading":
            s["heading"] = self.one(HEADINGS.get(match["h"], match["h"] + " of|to the " + match["h"] + " of"))

    def end(self, text):
        names = small_language.words()["side"] + small_language.words()["exact"]
        return self.place(text) if text[4:] in names else self.thing(text)

    def percent(self, text):
        bound = re.match(r"(at least |at most |)(?:(\d+) to )?(\d+) %", text)
        value = int(bound[3])
        names = {50: "half", 33: "a third", 25: "a quarter", 20: "a fifth", 67: "two thirds", 75: "three quarters", 10: "a tenth"}
        number = self.one(f"{value} %|{value}%|{value} percent|{value} per cent")
        if value in names and not bound[2] and self.draws.random() < 0.5:
            number = names[value]
        if bound[2]:
            return f"{bound[2]} to {number}"
        if bound[1] == "at least ":
            return self.one("at least |no less than |a minimum of ") + number
        if bound[1] == "at most ":
            return self.one("at most |no more than |up to ") + number
        return self.one("|about |roughly |") + number

    def manner(self, sentences):
        """Joins said sentences in some manner of writing."""
        draws = self.draws
        if draws.random() < 0.15:
            sentences.insert(draws.choice([0, len(sentences)]), draws.choice(TALK))
        roll = draws.random()
        if roll < 0.55:
            text = " ".join(sentences)
        elif roll < 0.7:
            text = "; ".join(s.rstrip(".") for s in sentences)
        elif roll < 0.8:
            text = "\n".join("- " + s.rstrip(".") for s in sentences)
        else:
            text = ", ".join([sentences[0].rstrip(".")] + [s[:1].lower() + s[1:].rstrip(".") for s in sentences[1:]]) + "."
        if draws.random() < 0.15:
            text = text.lower()
        if draws.random() < 0.1:
            at = draws.randrange(len(text))
            text = text[:at] + text[at + 1 :] if draws.random() < 0.5 else text[:at] + text[at : at + 2][::-1] + text[at + 2 :]
        return text


def main():
    """Prints examples."""
    kind, count, seed = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
    draws = random.Random(seed)
    for _ in range(count):
        line = draw_plans.draw_layout(draws) if kind == "layout" else draw_plans.draw_environment(draws)
        sentences = small_language.split(line[3:])
        speaker = Speaker(draws)
        text = speaker.manner([speaker.say(sentence, kind) for sentence in sentences])
        example = {"kind": kind, "author": "drawn", "voice": "said by rules", "text": text, "sentences": sentences}
        if kind == "layout":
            example["vocabulary"] = "wild" if line.startswith("W") else "suburb"
        print(json.dumps(example, ensure_ascii=False))


if __name__ == "__main__":
    main()
