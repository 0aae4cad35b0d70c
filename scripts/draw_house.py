#!/usr/bin/env python3
"""Draws docs/images/house.svg: the rooms of src/ on their floors, with sizes and shelves, and who
includes whom. Everything in it is read from the sources; the floors are those that
tests/architecture holds the includes against. The same sources give the same bytes.

Usage: draw_house.py [FILE.svg]
"""

import collections
import dataclasses
import pathlib
import sys
import textwrap
from xml.sax.saxutils import escape

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tests/architecture"))
from floors import (FLOOR_OF, FLOORS, INCLUDE, folder_in_rooms, room_of,  # noqa: E402
                    sources_below)

WIDTH = 1000
LEFT = 44        # of the boxes: the floor's number stands before them
GAP = 8          # between boxes and between floors
PADDING = 8      # in a box
LEAST_WIDTH = 112
LINE_HEIGHT = 15
LETTER = 5.4     # mean width of a letter of 11 px of Helvetica or Arial, and a little more
CELL = (26, 17)  # of the table of includes, width and height
LABELS = 130     # room for the table's names of rows
HEADING = 96     # room for its names of columns
# Most includes, radius of their dot.
DOTS = [(9, 2.5), (99, 4.5), (float("inf"), 6.5)]
# Fill and border of boxes: of the core, of what speaks ROS, of programs.
COLOURS = {"core": ("#eef4fb", "#5b84b1"), "ros": ("#fdf1e3", "#c98a3c"),
           "program": ("#eef7ee", "#6a9a6a")}


@dataclasses.dataclass
class Room:
    name: str
    files: int = 0
    lines: int = 0
    shelves: collections.Counter = dataclasses.field(default_factory=collections.Counter)  # files
    includes: collections.Counter = dataclasses.field(default_factory=collections.Counter)

    @property
    def thousands(self):
        """Lines in thousands; rounded, so that the picture changes when the house does."""
        return (self.lines + 500) // 1000

    @property
    def size(self):
        lines = f"{self.thousands}k lines" if self.thousands else "under 1k lines"
        return f"{self.files} files, {lines}"

    @property
    def colours(self):
        kind = {"latticeworld_ros": "ros", "nodes": "program", "tools": "program"}
        return COLOURS[kind.get(self.name, "core")]


def rooms_below(src):
    """Name -> Room, of all rooms that have a floor."""
    rooms = {name: Room(name) for floor in FLOORS for name in floor}
    for path, text in sources_below(src):
        room = rooms[room_of(path)]
        room.files += 1
        room.lines += text.count("\n")
        folders = folder_in_rooms(path).split("/")
        if len(folders) > 1:
            room.shelves[folders[1]] += 1
        for included in INCLUDE.findall(text):
            other = room_of(included)
            if other in rooms and other != room.name:
                room.includes[other] += 1
    return rooms


def text_at(x, y, words, size=11, **attributes):
    """An SVG text; attributes: as SVG has them, `_` for `-`."""
    more = "".join(f' {name.replace("_", "-")}="{value}"' for name, value in attributes.items())
    return f'<text x="{x:g}" y="{y:g}" font-size="{size}"{more}>{escape(words)}</text>'


def widths_of(rooms):
    """Name -> width of the room's box: the least width and what grows with the root of its lines,
    so that the widest floor fills the picture."""
    grown = {room.name: max(room.thousands, 0.5) ** 0.5 for room in rooms.values()}
    scale = min((WIDTH - LEFT - GAP * len(floor) - LEAST_WIDTH * len(floor))
                / sum(grown[name] for name in floor) for floor in FLOORS)
    return {name: round(LEAST_WIDTH + scale * root) for name, root in grown.items()}


def shelf_lines(room, width):
    """The room's shelves with their files, in lines that fit into its box."""
    shelves = [f"{name}\u00a0{count}" for name, count in sorted(room.shelves.items())]
    return textwrap.wrap(", ".join(shelves), int((width - 2 * PADDING) / LETTER)) if shelves else []


def draw_box(room, x, y, width, height):
    fill, border = room.colours
    yield (f'<rect x="{x}" y="{y}" width="{width}" height="{height}" rx="3" fill="{fill}" '
           f'stroke="{border}"/>')
    x += PADDING
    yield text_at(x, y + 17, room.name, 13, font_weight="bold")
    yield text_at(x, y + 17 + LINE_HEIGHT, room.size, fill="#444444")
    for i, line in enumerate(shelf_lines(room, width)):
        yield text_at(x, y + 17 + (i + 2) * LINE_HEIGHT, line, fill="#2d5078")


def draw_floors(rooms, y):
    """The floors from the roof down. Returns lines of SVG and where the picture goes on."""
    widths, lines = widths_of(rooms), []
    for number in range(len(FLOORS) - 1, -1, -1):
        floor = [rooms[name] for name in FLOORS[number]]
        most = max(len(shelf_lines(room, widths[room.name])) for room in floor)
        height = 40 + most * LINE_HEIGHT
        lines.append(text_at(LEFT - 12, y + 17, str(number + 1), 13, text_anchor="end",
                             fill="#777777"))
        x = LEFT
        for room in floor:
            lines += draw_box(room, x, y, widths[room.name], height)
            x += widths[room.name] + GAP
        y += height + GAP
    return lines, y


def draw_includes(rooms, y):
    """The table of who includes whom: rows from the roof down, columns from the ground up."""
    columns = [name for floor in FLOORS for name in floor]
    rows = [name for floor in reversed(FLOORS) for name in floor]
    (across, down), left, top = CELL, LEFT + LABELS, y + HEADING
    lines = []
    for i, name in enumerate(columns):  # a column reaches down to where no row may include it
        x = left + across * i
        turn = f"rotate(-45 {x + across / 2:g} {top - 6})"
        lines.append(text_at(x + across / 2, top - 6, name, transform=turn))
        above = sum(len(floor) for floor in FLOORS[FLOOR_OF[name] + 1:])
        if above:
            lines.append(f'<rect x="{x}" y="{top}" width="{across}" height="{down * above}" '
                         f'fill="{"#f4f7fb" if i % 2 else "#e9eff7"}"/>')
    for i, name in enumerate(rows):
        y = top + down * i
        lines.append(text_at(left - 8, y + 12, name, text_anchor="end"))
        below = sum(len(floor) for floor in FLOORS[:FLOOR_OF[name]])
        if name == FLOORS[FLOOR_OF[name]][0]:  # a line above each floor
            lines.append(f'<line x1="{LEFT}" x2="{left + across * below}" y1="{y}" y2="{y}" '
                         'stroke="#b8c4d4"/>')
        for j, other in enumerate(columns):
            count = rooms[name].includes[other]
            if count:
                radius = next(radius for most, radius in DOTS if count <= most)
                lines.append(f'<circle cx="{left + across * j + across / 2:g}" '
                             f'cy="{y + down / 2:g}" r="{radius}" '
                             f'fill="{rooms[name].colours[1]}"/>')
    bottom = top + down * len(rows)
    return lines + [*draw_key_of_dots(WIDTH - 150, bottom - 60)], bottom


def draw_key_of_colours(x, y):
    for kind, words, width in [("core", "the core", 86), ("ros", "what speaks ROS", 134),
                               ("program", "programs", 0)]:
        fill, border = COLOURS[kind]
        yield (f'<rect x="{x}" y="{y - 10}" width="16" height="12" rx="2" fill="{fill}" '
               f'stroke="{border}"/>')
        yield text_at(x + 22, y, words)
        x += width


def draw_key_of_dots(x, y):
    for i, words in enumerate(["1 to 9 includes", "10 to 99", "100 and more"]):
        yield (f'<circle cx="{x + 8}" cy="{y + 20 * i}" r="{DOTS[i][1]}" '
               f'fill="{COLOURS["core"][1]}"/>')
        yield text_at(x + 24, y + 4 + 20 * i, words)


def draw(src):
    """The picture of the sources below `src`, as SVG."""
    rooms = rooms_below(src)
    body = [text_at(LEFT, 28, "The house: rooms by floor, each with its shelves and their files",
                    17, font_weight="bold"),
            text_at(LEFT, 48, "A room includes rooms of floors below its own, and no others. The "
                    "more lines, the wider.", 12, fill="#444444"),
            *draw_key_of_colours(WIDTH - 308, 48)]
    floors, y = draw_floors(rooms, 62)
    body += floors
    body += [text_at(LEFT, y + 32, "Who includes whom", 17, font_weight="bold"),
             text_at(LEFT, y + 52, "A dot: files of the row's room include files of the column's.",
                     12, fill="#444444")]
    table, y = draw_includes(rooms, y + 58)
    body += table
    height = y + 20
    return "\n".join([
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height:g}" '
        f'width="{WIDTH}" height="{height:g}" '
        'font-family="Helvetica, Arial, sans-serif" fill="#1c1c1c">',
        "<title>Rooms of LatticeWorld by floor, and who includes whom</title>",
        '<rect width="100%" height="100%" fill="#ffffff"/>', *body, "</svg>", ""])


def main():
    picture = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "docs/images/house.svg"
    picture.write_text(draw(ROOT / "src"), encoding="utf-8")


if __name__ == "__main__":
    main()
