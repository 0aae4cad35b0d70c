"""Draws plans in the small language, for people to say freely: one line a plan.

Usage: python3 -m latticeworld_training.draw_plans {layout,environment} COUNT SEED
"""

import random
import sys

from . import small_language

SUBURB_AREAS = ["forest", "grassland", "farmland", "barren land", "sand", "water"]
WILD_AREAS = ["forest", "grassland", "bushes", "rock", "snow", "water"]
SUBURB_THINGS = ["lake", "pond", "village", "house", "farm", "grove", "town", "park", "field", "meadow", "orchard",
                 "building", "quarry", "beach", "swamp", "hill"]
WILD_THINGS = ["lake", "pond", "glacier", "grove", "clearing", "mountain", "ridge", "valley", "hill", "gorge",
               "plateau", "crater", "peak", "cliff", "swamp", "basin", "saddle", "mesa"]
SUBURB_LINES = ["river", "stream", "road", "path", "street", "canal", "railway"]
WILD_LINES = ["river", "stream", "path"]
OBJECTS = ["tree", "bush", "boulder", "barn", "church", "tower", "hut", "tent", "ruin", "pier", "well", "bench",
           "lamp", "sign", "log", "crate", "post", "gate", "fence", "hedge", "wall"]
LINE_SHAPES = ["", "", "winding ", "straight ", "curved "]
THING_SHAPES = ["", "", "", "small ", "large ", "tiny ", "huge ", "round ", "long ", "curved ", "large round "]
EDGES = ["northern edge", "southern edge", "eastern edge", "western edge"]
OPPOSITE = {"northern edge": "southern edge", "southern edge": "northern edge", "eastern edge": "western edge",
            "western edge": "eastern edge"}


class Land:
    """One layout plan in the making: what has been said to be there."""

    def __init__(self, random_source):
        self.random = random_source
        self.wild = random_source.random() < 0.4
        self.areas = list(WILD_AREAS if self.wild else SUBURB_AREAS)
        self.things = list(WILD_THINGS if self.wild else SUBURB_THINGS)
        self.lines = list(WILD_LINES if self.wild else SUBURB_LINES)
        for names in (self.areas, self.things, self.lines):
            random_source.shuffle(names)
        self.said = []  # nouns with whether they are many
        self.sentences = []

    def say(self, sentence):
        """Adds a sentence, its first letter upper case."""
        self.sentences.append(sentence[0].upper() + sentence[1:] + ".")

    def place(self):
        """A place: a side twice as often as an exact one."""
        words = small_language.words()
        pick = self.random.choice(words["side"] if self.random.random() < 0.6 else words["exact"])
        return f"the {pick}"

    def known(self):
        """A thing that has been said, as a later sentence refers to it, or None."""
        return f"the {self.random.choice(self.said)}" if self.said else None

    def new_thing(self):
        """Says of a new thing that it is there."""
        noun = self.things.pop()
        shape = self.random.choice(THING_SHAPES)
        roll = self.random.random()
        if roll < 0.45:
            phrase, noun_said = f"a {shape}{noun}", noun
        elif roll < 0.6:
            phrase, noun_said = f"{self.random.randint(2, 6)} {shape}{small_language.plural(noun)}", None
        elif roll < 0.75:
            low = self.random.randint(2, 5)
            bound = self.random.choice([f"at least {low}", f"at most {low}", f"{low} to {low + 2}"])
            phrase, noun_said = f"{bound} {small_language.plural(noun)}", None
        else:
            phrase, noun_said = f"1 {shape}{noun}", noun
        self.said.append(noun_said or small_language.plural(noun))
        self.say(phrase + (f" in {self.place()}" if self.random.random() < 0.7 else ""))

    def new_area(self):
        """Says where, or how much of, an area is."""
        noun = self.areas.pop()
        self.said.append(noun)
        choice = self.random.randint(0, 5)
        percent = self.random.choice([10, 15, 20, 25, 30, 33, 40, 50, 60, 67, 75])
        bound = self.random.choice(["", "", "at least ", "at most "])
        if choice <= 1:
            second = f" and {self.place()}" if self.random.random() < 0.25 else ""
            self.say(f"{noun} in {self.place()}{second}")
        elif choice == 2:
            self.say(f"{noun} covers {bound}{percent} % of the map")
        elif choice == 3:
            self.say(f"{noun} fills {self.place()}")
        elif choice == 4:
            self.say(f"mostly {noun}" + (f" in {self.place()}" if self.random.random() < 0.5 else ""))
        else:
            self.say(f"{noun} covers {bound}{percent} % of {self.place()}")

    def new_line(self):
        """Says how a new line runs."""
        noun = self.lines.pop()
        start = self.random.choice(EDGES)
        end = OPPOSITE[start] if self.random.random() < 0.5 else self.random.choice(EDGES + ["center"])
        if end == start:
            end = OPPOSITE[start]
        known = self.known()
        if known and self.random.random() < 0.35:
            end = known[4:]
        through = f" through {self.place()}" if self.random.random() < 0.2 else ""
        shape = self.random.choice(LINE_SHAPES)
        roll = self.random.random()
        if roll < 0.75:
            self.say(f"a {shape}{noun} from the {start} to the {end}{through}")
        elif roll < 0.85:
            self.say(f"a {shape}{noun} runs along the {self.random.choice(EDGES)}")
        else:
            self.say(f"a {shape}{noun} ends at the {end}")
        self.said.append(noun)

    def relation(self):
        """Relates two things that have been said."""
        if len(self.said) < 2:
            return self.new_thing()
        first, second = self.random.sample(self.said, 2)
        third = self.random.choice(self.said)
        be = "are" if first.endswith("s") and first != "grass" else "is"
        s = "" if be == "are" else "s"
        cells = self.random.randint(2, 9)
        lines = set(SUBURB_LINES + WILD_LINES)
        choices = [f"the {first} touch{'es' if s else ''} the {second}", f"the {first} {be} near the {second}",
                   f"the {first} {be} away from the {second}", f"the {first} {be} far from the {second}",
                   f"the {first} {be} {self.random.choice(small_language.words()['heading'])} of the {second}",
                   f"the {first} {be} at least {cells} cells from the {second}"]
        if first not in lines:
            choices += [f"the {first} {be} inside the {second}", f"the {first} surround{s} the {second}"]
        if second in lines:
            choices += [f"the {first} {be} on both sides of the {second}", f"the {first} {be} along the {second}"] * 2
        if first in lines and second in lines:
            choices = [f"the {first} cross{'es' if s else ''} the {second}", f"the {first} {be} parallel to the {second}"]
        elif first in lines:
            choices = [f"the {first} run{s} through the {second}", f"the {first} run{s} along the {second}",
                       f"the {first} end{s} at the {second}", f"the {first} {be} away from the {second}"]
        if third not in (first, second) and first not in lines:
            choices += [f"the {first} {be} between the {second} and the {third}"] * 2
        self.say(self.random.choice(choices))

    def other(self):
        """A sentence of the rarer forms."""
        roll = self.random.randint(0, 10)
        area = self.areas[-1] if self.areas else "water"
        if roll == 0:
            nouns = self.random.sample(WILD_AREAS if self.wild else SUBURB_AREAS, self.random.choice([3, 3, 4]))
            start = self.random.choice(["north", "south", "east", "west"])
            opposite = {"north": "south", "south": "north", "east": "west", "west": "east"}[start]
            self.say(f"from {start} to {opposite}: {', '.join(nouns)}")
        elif roll == 1 and len(self.said) > 1:
            self.say(f"no {area}" + (f" in {self.place()}" if self.random.random() < 0.4 else ""))
        elif roll == 2:
            self.say(f"the rest is {area}")
        elif roll == 3 and len(self.areas) > 1:
            self.say(f"more {self.areas[-1]} than {self.areas[-2]}")
        elif roll == 4:
            self.say(f"{area} only in {self.place()}")
        elif roll == 5:
            noun = small_language.plural(self.things[-1])
            self.say(f"the {noun} are {self.random.choice(['scattered', 'close together', 'apart', 'far apart'])}")
        elif roll == 6:
            self.say(f"the land is {self.random.choice(small_language.words()['rugged'])}"
                     + (f" in {self.place()}" if self.random.random() < 0.5 else ""))
        elif roll == 7 and self.wild:
            noun = self.random.choice(["hill", "mountain", "ridge", "cliff", "plateau"])
            self.say(f"a {noun} in {self.place()}")
            self.say(f"the {noun} is {self.random.choice([20, 35, 60, 80, 120, 150, 300])} m high")
        elif roll == 8:
            noun = self.random.choice(OBJECTS)
            count = self.random.randint(1, 12)
            phrase = f"{count} {small_language.plural(noun)}" if count > 1 else f"a {noun}"
            known = self.known()
            if known and self.random.random() < 0.5:
                self.say(f"{phrase} {'are' if count > 1 else 'is'} {self.random.choice(['near', 'in front of', 'north of', 'along'])} {known}")
            elif count > 2:
                self.say(f"{phrase} are in a {self.random.choice(['row', 'ring', 'grid', 'cluster'])}"
                         + (f" every {self.random.choice([2, 5, 10, 20])} m" if self.random.random() < 0.3 else ""))
            else:
                self.say(f"{phrase} in {self.place()}")
        elif roll == 9 and not self.wild:
            self.say(f"the roads {self.random.choice(['form a grid', 'cross each other', 'are parallel', 'meet in the center'])}")
        else:
            self.say(f"most {area} is in {self.place()}")


def draw_layout(random_source):
    """One plan for land: "W: " or "T: " as the vocabulary is, then its sentences."""
    land = Land(random_source)
    for step in range(random_source.choice([1, 2, 3, 3, 4, 4, 5, 6, 8])):
        choices = [land.new_thing, land.new_area, land.new_line, land.relation, land.relation, land.other]
        action = random_source.choice(choices[:3] if step == 0 else choices)
        if (action == land.new_line and not land.lines) or (action == land.new_area and not land.areas):
            action = land.relation
        action()
    return ("W: " if land.wild else "T: ") + " ".join(land.sentences)


def draw_environment(random_source):
    """One plan for an environment."""
    w = small_language.words()
    sentences = []
    for name in ("season", "weather", "time"):
        if random_source.random() < 0.5:
            sentences.append(f"{name.capitalize()}: {random_source.choice(w[name])}.")
    for name, share in (("style", 0.12), ("terrain", 0.12)):
        if random_source.random() < share:
            sentences.append(f"{name.capitalize()}: {random_source.choice(w[name])}.")
    values = {"Grass": "lush dry snow-covered ryegrass fescue reed", "Flowers": "blooming withered poppy daisy lavender heather",
              "Branches": "oak pine birch driftwood", "Stones": "mossy granite limestone sandstone basalt snow-covered",
              "Buildings": "brick timber concrete", "Roads": "snow-covered asphalt gravel clear", "Lake": "frozen open clear silty",
              "Forest": "oak birch maple pine spruce bare", "Crops": "sown green ripe stubble wheat maize rapeseed vineyard"}
    for _ in range(random_source.choice([0, 0, 1, 1, 2, 3])):
        asset = random_source.choice(list(values))
        sentences.append(f"{asset}: {random_source.choice(values[asset].split())}.")
    if random_source.random() < 0.25:
        asset = random_source.choice(["Grass", "Flowers", "Branches", "Stones", "Forest"])
        sentences.append(f"{asset} density: {random_source.choice(['dense', 'sparse', 'none', '30 %', '70 %'])}.")
    if random_source.random() < 0.15:
        sentences.append(random_source.choice([f"Wind: {random_source.randint(0, 20)} m/s.", "Wind: at least 10 m/s.",
                                               f"Lake level: {random_source.choice(['1', '2', '-0.5', '-1'])} m.",
                                               f"Building scale: {random_source.choice(['0.5', '1.5', '2'])}.",
                                               f"Building heading: {random_source.choice([0, 45, 90, 180, 270])} degrees.",
                                               f"Snow slope: {random_source.choice([30, 40, 55])} degrees."]))
    states = {"goblin": "idle patrolling pursuing attacking", "humanoid robot": "idle patrolling", "robotic dog": "idle patrolling pursuing",
              "ancient warrior": "idle patrolling pursuing attacking", "sheep": "grazing idle", "horse": "grazing idle", "eagle": "flying idle",
              "aerial robot": "flying patrolling idle", "whale": "swimming", "wheeled robot": "idle patrolling"}
    places = ["in the forest", "by the lake", "in the village", "on the road", "in the field", "on the grassland", "by the river", "at the bridge",
              "on the rock", "in the snow", "on the hill", "by the house", "over the lake", "north of the village", "east of the lake",
              "away from the village", "at the shore", "in the valley", "at the crossroads", "in the northern forest"]
    for _ in range(random_source.choice([0, 1, 1, 2, 2, 3, 4])):
        who = random_source.choice(list(states))
        count = random_source.choice(["1", "1", "2", "3", "4", "5", "7", "8", "9", "12", "15", "20", "40", "some", "2 to 5",
                                      "at least 3", "at most 6", "30 to 39"])
        noun = who if count == "1" or who == "sheep" else small_language.plural(who)
        state = " " + random_source.choice(states[who].split()) if random_source.random() < 0.7 else ""
        roll = random_source.random()
        place = "" if roll < 0.25 else " in the " + random_source.choice(w["side"]) if roll < 0.6 else " " + random_source.choice(places)
        sentences.append(f"{count[0].upper() + count[1:]} {noun}{state}{place}.")
    if random_source.random() < 0.15:
        sentences.append(random_source.choice(["No animals.", "No robots.", "No goblins.", "No agents.", "No sheep.", "No whales.", "20 agents in all."]))
    return "T: " + (" ".join(sentences) or "Weather: cloudy.")


def main():
    """Prints the plans."""
    kind, count, seed = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
    random_source = random.Random(seed)
    for number in range(count):
        line = draw_layout(random_source) if kind == "layout" else draw_environment(random_source)
        for sentence in small_language.split(line[3:]):
            assert small_language.form_of(sentence, kind), sentence
        print(f"P{number + 1} {line}")


if __name__ == "__main__":
    main()
