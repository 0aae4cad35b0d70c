"""Says descriptions of environments in the same manner of other things.

    python3 -m latticeworld_training.vary_descriptions descriptions.json --times 20 --leave-out 5 --out varied.json

`descriptions.json` is a list of {"id", "vocabulary", "instruction", ...}, as benchmarks/fidelity/environment_development.json
is. In each description words are exchanged for others of their kind: numbers, species, seasons, months, times, weather,
directions, states and places, the same word for the same word throughout; every second one takes some of its sentences from
another. What comes out has the manners of those who wrote the descriptions, and says something else every time.
`latticeworld dataset --environment-instructions varied.json` answers it, and leaves out what says nothing or cannot be had,
as grazing goblins and two seasons at once.
"""

import argparse
import json
import random
import re

# Words of a kind by their forms: what stands in one place of each list is one thing.
KINDS = [
    [["two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve", "fifteen", "twenty"]],
    [
        ["sheep", "goblin", "horse", "eagle", "robotic dog", "robot dog", "humanoid robot", "ancient warrior", "warrior",
         "aerial robot", "drone", "wheeled robot", "rover"],
        ["sheep", "goblins", "horses", "eagles", "robotic dogs", "robot dogs", "humanoid robots", "ancient warriors",
         "warriors", "aerial robots", "drones", "wheeled robots", "rovers"],
    ],
    [["spring", "summer", "autumn", "winter"]],
    [["january", "february", "april", "june", "july", "august", "september", "october", "november", "december"]],
    [["dawn", "dusk", "noon", "midnight", "midday", "sunset", "sunrise"], ["morning", "afternoon", "evening", "night"]],
    [["rain", "fog", "snow", "sunshine"], ["rainy", "foggy", "snowy", "sunny"]],
    [["north", "south", "east", "west"], ["northern", "southern", "eastern", "western"]],
    [["upper", "lower"], ["top", "bottom"]],
    [["left", "right"]],
    [
        ["grazing", "patrolling", "attacking", "hunting", "resting", "waiting", "wandering"],
        ["graze", "patrol", "attack", "hunt", "rest", "wait", "wander"],
        ["grazes", "patrols", "attacks", "hunts", "rests", "waits", "wanders"],
    ],
    [["lake", "forest", "village", "road"]],
    [["cartoon", "cyberpunk"]],
]
# Numerals that count: no hours, shares, measures, parts of numbers or names.
COUNT = re.compile(
    r"(?<![\w.,:/-])[1-9]\d?(?![\w:/%-]|[.,]\d|\s*(?:%|°|per ?cent|percent|degrees|m/s|m\b|km|metres|meters|o'clock|am\b|pm\b|cells|squares))"
)
SENTENCE_END = re.compile(r"(?<=[.!?])\s+")
SHARE = 0.7  # of the kinds of a description whose words are exchanged
MOST_COUNT = 24


def _words(kind):
    """{word: (form, index)} of a kind; a word that is of several forms is of the first."""
    found = {}
    for form, words in enumerate(kind):
        for index, word in enumerate(words):
            found.setdefault(word, (form, index))
    return found


def _as(written, word):
    """A word in the case of another."""
    if len(written) > 1 and written.isupper():
        return word.upper()
    return word[0].upper() + word[1:] if written[0].isupper() else word


def varied(text, draws):
    """The text with words exchanged, by a random.Random."""
    for kind in KINDS:
        if draws.random() >= SHARE:
            continue
        words = _words(kind)
        exchanged = [draws.sample(range(len(form)), len(form)) for form in kind]
        if all(len(form) == len(kind[0]) for form in kind):  # the forms of one thing go together
            exchanged = [exchanged[0]] * len(kind)

        def other(match):
            form, index = words[match[0].lower()]
            return _as(match[0], kind[form][exchanged[form][index]])

        longest_first = sorted(words, key=len, reverse=True)
        text = re.sub(r"\b(?:" + "|".join(map(re.escape, longest_first)) + r")\b", other, text, flags=re.IGNORECASE)
    counts = {}
    if draws.random() < SHARE:
        text = COUNT.sub(lambda match: counts.setdefault(match[0], str(draws.randint(2, MOST_COUNT))), text)
    return text


def mixed(text, other, draws):
    """Some sentences of a text before some of another."""
    def some(sentences):
        return [sentence for sentence in sentences if draws.random() < 0.6] or sentences[:1]

    return " ".join(some(SENTENCE_END.split(text.strip())) + some(SENTENCE_END.split(other.strip())))


def variants(descriptions, times, leave_out, seed):
    """Descriptions that differ from all others, up to `times` of each but every leave_out-th [all: 0]. Ids are those of their
    originals with seed and number behind."""
    known = {given["instruction"] for given in descriptions}
    used = [given for at, given in enumerate(descriptions) if not leave_out or at % leave_out]
    made = []
    for given in used:
        for number in range(times):
            draws = random.Random(f"{seed} {given['id']} {number}")
            text = given["instruction"]
            if number % 2:
                text = mixed(text, draws.choice(used)["instruction"], draws)
            text = varied(text, draws)
            if text not in known:
                known.add(text)
                made.append({**given, "id": f"{given['id']}-{seed}-{number}", "instruction": text, "claims": []})
    return made


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("descriptions", help="JSON")
    parser.add_argument("--times", type=int, default=20, help="variants of each at most [20]")
    parser.add_argument("--leave-out", type=int, default=0, help="N: every N-th is left out, as `latticeworld dataset` does [0: none]")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--out", required=True, help="JSON")
    given = parser.parse_args(arguments)
    with open(given.descriptions, encoding="utf-8") as file:
        made = variants(json.load(file), given.times, given.leave_out, given.seed)
    with open(given.out, "w", encoding="utf-8") as file:
        json.dump(made, file, ensure_ascii=False)
    print(f"{len(made)} descriptions")


if __name__ == "__main__":
    main()
