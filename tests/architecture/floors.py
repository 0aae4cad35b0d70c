"""The rooms of src/ on their floors, and what they include. The tests of this folder and
scripts/draw_house.py read it."""

import pathlib
import re

# From the ground up. A file may include its own room and every floor below it: never a room
# above, never another room of its own floor.
FLOORS = [
    ["common"],
    ["geometry"],
    ["geomorphology", "catalogue", "reference_navigator"],
    ["layout", "environment", "relief", "meshes"],
    ["language", "terrain", "species"],
    ["scene"],
    ["mapping", "sensing"],
    ["rendering"],
    ["exporting", "simulation"],
    ["generation"],
    ["navigation", "episode", "learning", "viewer", "dataset"],
    ["campaign"],
    ["latticeworld_ros"],
    ["nodes", "tools"],
]
FLOOR_OF = {room: i for i, floor in enumerate(FLOORS) for room in floor}
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)


def room_of(path):
    """'latticeworld/terrain/x.h' -> 'terrain', 'nodes/x.cc' -> 'nodes'; None when it is no room.
    path: relative to src, as an #include has it."""
    parts = pathlib.PurePosixPath(path).parts
    if len(parts) >= 3 and parts[0] == "latticeworld":
        return parts[1]
    if len(parts) >= 2 and parts[0] in FLOOR_OF:
        return parts[0]
    return None


def folder_in_rooms(path):
    """'latticeworld/terrain/ways/x.h' -> 'terrain/ways', 'tools/x.cc' -> 'tools'."""
    parts = pathlib.PurePosixPath(path).parts[:-1]
    return "/".join(parts[1:] if parts[:1] == ("latticeworld",) else parts)


def sources_below(src):
    """(path relative to src, text) of every header and source, by path."""
    for file in sorted(src.rglob("*")):
        if file.suffix in (".h", ".cc"):
            yield file.relative_to(src).as_posix(), file.read_text(encoding="utf-8")
