"""Files that are there whole or as they were before, whatever ends the program that writes them."""

import contextlib
import os


def sync_folder(path):
    """The names in the folder of `path` outlast a loss of power from now on."""
    folder = os.open(os.path.dirname(os.path.abspath(path)), os.O_RDONLY)
    try:
        os.fsync(folder)
    finally:
        os.close(folder)


@contextlib.contextmanager
def whole_file(path, mode="w"):
    """A file to write, which takes the place of `path` once it is whole and on the disk; mode: w or wb."""
    unfinished = f"{path}.unfinished"
    try:
        with open(unfinished, mode, encoding=None if "b" in mode else "utf-8",
                  newline=None if "b" in mode else "") as file:
            yield file
            file.flush()
            os.fsync(file.fileno())
        os.replace(unfinished, path)
    except BaseException:
        with contextlib.suppress(OSError):
            os.remove(unfinished)
        raise
    sync_folder(path)
