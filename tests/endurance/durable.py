"""What a loss of power leaves of a folder, by what power_loss.cc has kept of a program's syncs.

Two ends of what file systems do: the strict one loses every name whose folder was not synced after
it; the other has all names, and loses the content that was not synced.
"""

import os
import pathlib
import shutil
import uuid

ATTRIBUTE = "user.latticeworld_durable"
VARIANTS = ("names lost", "content lost")


def _tag(path):
    """The tag of a file or folder, as the preloaded library sets it; None: it was never synced."""
    try:
        return os.getxattr(path, ATTRIBUTE).decode()
    except OSError:
        return None


def _set_tag(path):
    tag = _tag(path)
    if tag is None:
        tag = uuid.uuid4().hex
        os.setxattr(path, ATTRIBUTE, tag.encode())
    return tag


def seal(root, kept):
    """Counts all that lies in root as synced; kept: folder of the synced state."""
    kept.mkdir(exist_ok=True)
    for folder, folders, files in os.walk(root):
        folder = pathlib.Path(folder)
        lines = [f"{_set_tag(folder / name)} {name}\n" for name in folders + files]
        (kept / (_set_tag(folder) + ".names")).write_text("".join(lines), encoding="utf-8")
        for name in files:
            shutil.copyfile(folder / name, kept / _tag(folder / name))


def environment(library, root, kept):
    """The variables under which a program's syncs are kept."""
    return {"LD_PRELOAD": str(library), "LATTICEWORLD_DURABLE_ROOT": str(root),
            "LATTICEWORLD_DURABLE_KEPT": str(kept)}


def rebuild(root, kept, target, variant):
    """Makes target what is left of root once the power is gone; variant: one of VARIANTS."""
    present = {}  # tag -> whether it is a folder, of all that root holds or held at a sync
    for folder, folders, files in os.walk(root):
        for name in folders + files:
            path = os.path.join(folder, name)
            tag = _tag(path)
            if tag is not None:
                present[tag] = os.path.isdir(path)
    _rebuild_folder(root, _tag(root), kept, target, variant, present)


def _rebuild_folder(live, tag, kept, target, variant, present):
    target.mkdir()
    for child, name in _entries(live, tag, kept, variant):
        path = None if live is None else live / name
        if path is not None and (not os.path.lexists(path) or _tag(path) != child):
            path = None
        is_folder = path.is_dir() if path is not None else _was_folder(child, kept, present)
        if is_folder:
            _rebuild_folder(path, child, kept, target / name, variant, present)
        else:
            content = kept / child if child else None
            synced = content is not None and content.exists()
            (target / name).write_bytes(content.read_bytes() if synced else b"")


def _entries(live, tag, kept, variant):
    if variant == "content lost":
        return [(_tag(path), path.name) for path in sorted(live.iterdir())] if live else []
    names = kept / f"{tag}.names"
    if tag is None or not names.exists():
        return []
    lines = names.read_text(encoding="utf-8").splitlines()
    return [tuple(line.split(" ", 1)) for line in lines]


def _was_folder(tag, kept, present):
    return present.get(tag, (kept / f"{tag}.names").exists())
