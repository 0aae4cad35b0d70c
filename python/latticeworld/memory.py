"""Whether so many worlds fit into memory, before they are made."""

import pathlib

from .errors import OutOfMemory

# A world's own grids alone: heights, water, surface, weights of classes.
LEAST_BYTES_OF_A_CELL = 12


def available():
    """Bytes that this process could still have; None: nobody knows."""
    found = []
    try:
        for line in pathlib.Path("/proc/meminfo").read_text().splitlines():
            if line.startswith("MemAvailable:"):
                found.append(1024 * int(line.split()[1]))
    except (OSError, ValueError):
        pass
    try:  # a container's own limit
        group = pathlib.Path("/sys/fs/cgroup")
        found.append(int((group / "memory.max").read_text())
                     - int((group / "memory.current").read_text()))
    except (OSError, ValueError):
        pass
    return min(found) if found else None


def used():
    """Bytes of this process."""
    try:
        return 4096 * int(pathlib.Path("/proc/self/statm").read_text().split()[1])
    except (OSError, ValueError):
        return 0


def demand(count, bytes_each, what):
    """Raises OutOfMemory where so many more of that size do not fit."""
    free = available()
    if free is None or count * bytes_each <= free:
        return
    raise OutOfMemory(
        f"{count} {what} of {bytes_each / 1e6:.0f} MB each need {count * bytes_each / 1e9:.1f} GB, "
        f"and {max(0, free) / 1e9:.1f} GB are available; legal are at most "
        f"{max(0, int(free // max(1, bytes_each)))} of that size: make fewer, smaller ones "
        "(size_m), or ones of larger cells (resolution_m)")
